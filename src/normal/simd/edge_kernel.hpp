/// Displacements at the edges of strips.
#pragma once

#include "normal/simd/line_tables.hpp"

namespace wrc::simd {
namespace {

/// Displacements by source number first of the first lane's edge, first + 1 of the next, ... [m Pa]
inline Pack displacement_by(const StripTables& tables, const Sources& sources, std::int32_t first, Pack x,
                            Pack y) {
  const Pack inverse = load_pack(sources.inverse_length + first);
  return load_pack(sources.strength + first) *
         line_potential_at(tables, magnitude(load_pack(sources.y + first) - y) * inverse,
                           magnitude(x - load_pack(sources.centre + first)) * inverse);
}

/// NormalKernels::edge_displacements. Each edge sums outwards, on both sides by themselves: a mirrored patch
/// has the mirrored sums.
void edge_displacements_kernel(const EdgeTask& task) {
  constexpr std::int32_t near = 4;  // strips to each side that are taken one by one
  static_assert(near < beyond_sources - most_lanes);
  for (std::int32_t a = 0; a < task.count; a += lanes) {
    const Pack x = load_pack(task.x + a), y = load_pack(task.y + a);
    Pack below = 0.0, above = 0.0;
    for (std::int32_t d = 1; d <= near; ++d) {
      below += displacement_by(task.tables, task.strips, a - d, x, y);
      above += displacement_by(task.tables, task.strips, a + d, x, y);
    }
    for (std::int32_t k = a - near - 2; k + lanes > -1; k -= 2)
      below += displacement_by(task.tables, task.pairs, k, x, y);
    for (std::int32_t k = a + near + 1; k < task.count; k += 2)
      above += displacement_by(task.tables, task.pairs, k, x, y);
    const Pack own =
        load_pack(task.strips.strength + a) * read(task.tables.edge_under, load_pack(task.half_width + a));
    store_pack(task.displacement + a, own + (below + above));
  }
}

}  // namespace
}  // namespace wrc::simd
