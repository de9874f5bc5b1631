/// Sums of rows of a matrix (surface/pressure/pressure_jacobian.hpp).
#pragma once

#include "base/pack.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// The next `vectors` vectors of the sum, in the order of the rows.
template <int vectors>
void blend_group(const BlendRowsTask& task, std::int64_t first) {
  Native sum[vectors];
  for (int k = 0; k < vectors; ++k) sum[k] = broadcast(0.0);
  for (std::int32_t i = 0; i < task.count; ++i) {
    const Native share = broadcast(task.share[i]);
    const double* const row = task.row[i] + first;
    for (int k = 0; k < vectors; ++k) sum[k] = sum[k] + share * load_lanes(row + k * native_lanes);
  }
  for (int k = 0; k < vectors; ++k) store_lanes(task.to + first + k * native_lanes, sum[k]);
}

/// Groups of so many vectors from `first` on, which is moved behind them.
template <int vectors>
void blend_groups(const BlendRowsTask& task, std::int64_t& first) {
  for (; first + vectors * native_lanes <= task.columns; first += vectors * native_lanes)
    blend_group<vectors>(task, first);
}

/// SurfaceKernels::blend_rows.
inline void blend_rows_kernel(const BlendRowsTask& task) {
  // As many vectors as stay in registers over all rows, then fewer.
  std::int64_t first = 0;
  blend_groups<8>(task, first);
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
  for (std::int32_t c = first; c < end; ++c) {
    const Columns share = in_all_columns(row[c]);
    for (std::int32_t k = 0; k < vectors; ++k)
      left[k] = left[k] - share * load_columns(x + 4 * c + k * abreast);
  }
  for (std::int32_t k = 0; k < vectors; ++k) store_columns(right + k * abreast, left[k]);
}

}  // namespace
}  // namespace wrc::simd
