#include "normal/strip_halfspace/strip_system.hpp"

#include <algorithm>
#include <initializer_list>

#include "base/cutter.hpp"

namespace wrc {
namespace {

/// Sizes of the blocks of doubles for so many strips.
struct Sizes {
  std::int64_t strips;   ///< an array over the strips, or over the columns of their equations
  std::int64_t sources;  ///< one over sources, with the empty ones on both sides
  std::int64_t influence, matrix;

  explicit Sizes(std::int32_t capacity) {
    const std::int32_t rows = elimination_size(capacity);
    const std::int64_t columns = simd::elimination_stride(rows);
    strips = simd::whole_packs(columns);
    sources = strips + 2 * simd::beyond_sources;
    influence = strips * capacity;
    matrix = rows * columns;
  }
};

constexpr std::int64_t arrays_over_strips = 19;
constexpr std::int64_t arrays_over_sources = 8;
constexpr std::int64_t arrays_of_indices = 4;

}  // namespace

StripSystem lay_out_strips(void* memory, std::int32_t capacity) noexcept {
  const Sizes sizes(capacity);
  Cutter take{static_cast<double*>(memory)};
  StripSystem s;
  for (double** field : {&s.grid.y, &s.grid.width, &s.cell_y, &s.cell_width, &s.height, &s.curvature,
                         &s.gap_centre, &s.half_length, &s.inverse_length, &s.centre, &s.peak, &s.by_approach,
                         &s.by_height, &s.level, &s.shift, &s.half_width, &s.edge, &s.leading, &s.trailing})
    *field = take(sizes.strips);
  // Kernels read whole packs, and edges reach beyond the sources: nothing stands there.
  for (double* field : {s.grid.y, s.grid.width, s.inverse_length, s.centre, s.half_width, s.edge})
    std::fill_n(field, sizes.strips, 0.0);
  for (simd::Sources* sources : {&s.sources, &s.pairs})
    for (double** field : {&sources->y, &sources->centre, &sources->inverse_length, &sources->strength}) {
      *field = take(sizes.sources);
      std::fill_n(*field, sizes.sources, 0.0);
      *field += simd::beyond_sources;
    }
  s.influence_stride = sizes.strips;
  s.influence = take(sizes.influence);
  s.matrix = take(sizes.matrix);
  // behind the doubles, in memory that holds no objects yet
  auto* const indices = reinterpret_cast<std::int32_t*>(take.at);
  s.grid.region = indices;
  s.active = indices + capacity;
  s.next_active = indices + 2 * capacity;
  s.row_known = indices + 3 * capacity;
  return s;
}

std::int64_t strip_system_bytes(std::int32_t capacity) noexcept {
  const Sizes sizes(capacity);
  const std::int64_t doubles = arrays_over_strips * sizes.strips + arrays_over_sources * sizes.sources +
                               sizes.influence + sizes.matrix;
  return doubles * static_cast<std::int64_t>(sizeof(double)) +
         arrays_of_indices * capacity * static_cast<std::int64_t>(sizeof(std::int32_t));
}

}  // namespace wrc
