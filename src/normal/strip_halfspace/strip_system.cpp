#include "normal/strip_halfspace/strip_system.hpp"

#include <algorithm>

#include "base/arena.hpp"

namespace wrc::normal {
namespace {

/// Cuts the arrays for `capacity` strips, or counts them. Those of the sources begin with their empty strips.
StripSystem cut(Arena& arena, std::int32_t capacity) {
  const std::int32_t rows = elimination_size(capacity);
  const std::int64_t columns = simd::elimination_stride(rows);
  StripSystem s;
  s.stride = simd::whole_packs(columns);
  arena.each(s.stride, s.grid.y, s.grid.width, s.cell_y, s.cell_width, s.height, s.curvature, s.gap_centre,
             s.half_length, s.inverse_length, s.centre, s.peak, s.by_approach, s.by_height, s.peak_per_length,
             s.shift, s.half_width, s.edge, s.leading, s.trailing);
  for (simd::Sources* sources : {&s.sources, &s.pairs})
    arena.each(s.stride + 2 * simd::beyond_sources, sources->y, sources->centre, sources->inverse_length,
               sources->line_load);
  s.influence = arena.take(s.stride * capacity);
  s.matrix = arena.take(rows * columns);
  arena.each(capacity, s.grid.region, s.active, s.next_active, s.row_known);
  return s;
}

}  // namespace

StripSystem lay_out_strips(void* memory, std::int32_t capacity) noexcept {
  Arena arena(memory);
  StripSystem s = cut(arena, capacity);
  // Kernels read whole packs, and edges reach beyond the sources: strips there must have no effect.
  for (double* field : {s.grid.y, s.grid.width, s.inverse_length, s.centre, s.half_width, s.edge})
    std::fill_n(field, s.stride, 0.0);
  for (simd::Sources* sources : {&s.sources, &s.pairs})
    for (double** field : {&sources->y, &sources->centre, &sources->inverse_length, &sources->line_load}) {
      std::fill_n(*field, s.stride + 2 * simd::beyond_sources, 0.0);
      *field += simd::beyond_sources;
    }
  return s;
}

std::int64_t strip_system_bytes(std::int32_t capacity) noexcept {
  Arena count;
  cut(count, capacity);
  return count.bytes();
}

}  // namespace wrc::normal
