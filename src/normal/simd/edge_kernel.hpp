/// Displacements at the edges of strips.
#pragma once

#include "normal/simd/line_tables.hpp"

namespace wrc::simd {
namespace {

/// As many edges as the processor's vector holds, twice: a pack sees two sources of each edge at a time.
struct Edges {
  Pack x, y;
};

/// Displacements by sources number first, second of the first edge, first + 1, second + 1 of the next, ...
/// [m Pa]
inline Pack displacements(const StripTables& tables, const Sources& sources, std::int32_t first,
                          std::int32_t second, const Edges& edges) {
  const auto both = [&](const double* of) { return Pack(load_lanes(of + first), load_lanes(of + second)); };
  const Pack inverse = both(sources.inverse_length);
  const LineRows rows = line_rows(magnitude(both(sources.y) - edges.y) * inverse);
  return both(sources.line_load) *
         line_potential_at(tables, rows, magnitude(edges.x - both(sources.centre)) * inverse);
}

/// NormalKernels::edge_displacements. Each edge sums outwards, on both sides by themselves: a mirrored patch
/// has the mirrored sums.
void edge_displacements_kernel(const EdgeTask& task) {
  constexpr std::int32_t near = 4;  // strips to each side that are taken one by one
  static_assert(near < beyond_sources - most_lanes);
  for (std::int32_t a = 0; a < task.count; a += native_lanes) {
    // As many edges as a vector holds, each twice: a pack sees two sources of each edge at a time.
    const Native x = load_lanes(task.x + a), y = load_lanes(task.y + a);
    const Edges edges{{x, x}, {y, y}};
    Native below = broadcast(0.0), above = below;
    // The nearest strips to both sides one by one.
    for (std::int32_t d = 1; d <= near; ++d) {
      const Pack by = displacements(task.tables, task.strips, a - d, a + d, edges);
      below = below + by.a;
      above = above + by.b;
    }
    // Those farther away by pairs: k, k - 2 below; k, k + 2 above. Past the ends are zeros.
    for (std::int32_t k = a - near - 2; k + native_lanes > -1; k -= 4) {
      const Pack by = displacements(task.tables, task.pairs, k, k - 2, edges);
      below = below + by.a + by.b;
    }
    for (std::int32_t k = a + near + 1; k < task.count; k += 4) {
      const Pack by = displacements(task.tables, task.pairs, k, k + 2, edges);
      above = above + by.a + by.b;
    }
    // The strip itself, from the table of means at the edge.
    const Native half_width = load_lanes(task.half_width + a);
    const Native own =
        load_lanes(task.strips.line_load + a) * read(task.tables.edge_under, Pack(half_width, half_width)).a;
    store_lanes(task.displacement + a, own + (below + above));
  }
}

}  // namespace
}  // namespace wrc::simd
