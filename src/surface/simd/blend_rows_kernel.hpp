/// Sums of rows of a matrix (surface/pressure/pressure_jacobian.hpp).
#pragma once

#include "base/pack.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// Vectors of a sum of rows, each in a register.
template <int vectors>
struct RowSum {
  Native first;
  RowSum<vectors - 1> others;

  void clear() {
    first = broadcast(0.0);
    others.clear();
  }
  void add(Native share, const double* row) {
    first = first + share * load_lanes(row);
    others.add(share, row + native_lanes);
  }
  void put(double* to) const {
    store_lanes(to, first);
    others.put(to + native_lanes);
  }
};
template <>
struct RowSum<0> {
  void clear() {}
  void add(Native, const double*) {}
  void put(double*) const {}
};

/// The next `vectors` vectors of the sum, in the order of the rows.
template <int vectors>
void blend_group(const BlendRowsTask& task, std::int64_t first) {
  RowSum<vectors> sum;
  sum.clear();
  for (std::int32_t i = 0; i < task.count; ++i) {
    const double* row = task.row[i] + first;
    __asm__("" : "+r"(row));  // one register: gcc takes one for each vector otherwise, and runs out of them
    sum.add(broadcast(task.share[i]), row);
  }
  sum.put(task.to + first);
}

/// Groups of so many vectors from `first` on, which is moved behind them.
template <int vectors>
void blend_groups(const BlendRowsTask& task, std::int64_t& first) {
  for (; first + vectors * native_lanes <= task.columns; first += vectors * native_lanes)
    blend_group<vectors>(task, first);
}

/// SurfaceKernels::blend_rows.
inline void blend_rows_kernel(const BlendRowsTask& task) {
  // As many vectors as stay in 16 registers over all rows, then fewer.
  std::int64_t first = 0;
  blend_groups<14>(task, first);
  blend_groups<10>(task, first);
  blend_groups<6>(task, first);
  blend_groups<4>(task, first);
  blend_groups<2>(task, first);
  blend_groups<1>(task, first);
}

/// SurfaceKernels::take_known.
inline void take_known_kernel(const double* row, std::int32_t first, std::int32_t end, const double* x,
                              double* right) {
  constexpr std::int32_t vectors = 4 / abreast;
  Columns left[vectors];
  for (std::int32_t k = 0; k < vectors; ++k) left[k] = load_columns(right + k * abreast);
  const auto take = [&](std::int32_t c) {
    const Columns share = in_all_columns(row[c]);
    for (std::int32_t k = 0; k < vectors; ++k)
      left[k] = left[k] - share * load_columns(x + 4 * c + k * abreast);
  };
  // four at a time: one by one, counting takes as many instructions
  std::int32_t c = first;
  for (; c + 4 <= end; c += 4)
    for (std::int32_t k = 0; k < 4; ++k) take(c + k);
  for (; c < end; ++c) take(c);
  for (std::int32_t k = 0; k < vectors; ++k) store_columns(right + k * abreast, left[k]);
}

}  // namespace
}  // namespace wrc::simd
