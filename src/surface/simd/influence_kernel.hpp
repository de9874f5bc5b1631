/// Displacement of a curved surface by strips of semi-elliptic pressure: C w / l J(tau, xi) cos by unit q,
/// with tau, xi the distances along the rail and along x over l (normal/elasticity/influence_tables.hpp).
/// Constants of a pair of strips are found once (SurfacePairs). Middles are seen a vector of sources at a
/// time from two points, edges a vector of edges at a time from one source: their sums need not be collected
/// from lanes.
#pragma once

#include "normal/simd/line_tables.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// Half widths from a strip beyond which its width adds less than 1e-3 to the displacement by its middle
/// line.
constexpr double near_strip = 17.0;

/// Packs whose places in a table are found before any is read.
constexpr std::int32_t found_ahead = most_lanes;

/// The same elements for both vectors.
inline Pack for_both(const double* of, std::int32_t first) {
  const Native a = load_lanes(of + first);
  return {a, a};
}

/// Calls take(a, b) for the numbers from .. end - 1 two by two; of an odd count the last comes twice.
template <class Take>
WRC_IN_LOOP void two_by_two(std::int32_t from, std::int32_t end, const Take& take) {
  for (std::int32_t a = from; a < end; a += 2) take(a, a + 1 < end ? a + 1 : a);
}

/// SurfaceKernels::pairs.
inline void surface_pairs(const SurfaceStrips& rows, const SurfaceStrips& columns,
                          const SurfacePairs& pairs) {
  constexpr double origin = normal::InfluenceTables::line_rows.origin();
  // A vector may begin at any column: behind the last a vector of zeros, pairs without effect.
  for (std::int32_t first = 0; first < columns.count + native_lanes - 1; first += native_lanes) {
    if (first >= columns.count) {
      double* const arrays[] = {pairs.axis_place, pairs.cosine, pairs.correction};
      for (double* const to : arrays)
        for (std::int32_t a = 0; a < rows.count; ++a)
          store_lanes(to + a * pairs.stride + first, broadcast(0.0));
      break;
    }
    const Pack place = for_both(columns.place, first), half = 0.5 * for_both(columns.width, first);
    const Pack ny = for_both(columns.ny, first), nz = for_both(columns.nz, first);
    two_by_two(0, rows.count, [&](std::int32_t a, std::int32_t b) {
      const auto both = [&](const double* of) { return Pack(broadcast(of[a]), broadcast(of[b])); };
      const auto keep = [&](Pack x, double* to) {
        store_lanes(to + a * pairs.stride + first, x.a);
        store_lanes(to + b * pairs.stride + first, x.b);
      };
      // Distance on the axis of the table; a strip with itself gets cosine 0, and its own influence
      // elsewhere.
      const Pack distance = magnitude(place - both(rows.place));
      const Mask apart = distance > 0.0;
      const Mask near = apart & (distance < near_strip * half);
      keep(place_from_one(distance) + origin, pairs.axis_place);
      keep(select(apart, both(rows.ny) * ny + both(rows.nz) * nz, 0.0), pairs.cosine);
      // Width correction of near pairs at unit inverse_to_end; the sources' lengths enter in
      // influence_rows().
      Pack correction = 0.0;
      if (any(near))
        correction = select(near, width_correction(half / select(near, distance, 1.0), Pack(1.0)), 0.0);
      keep(correction, pairs.correction);
    });
  }
}

/// Rows of C w / l J cos, a source per lane, two points at a time.
template <bool skewed>
void influence_rows(const SurfaceTables& tables, const SurfaceSources& sources, const SurfacePairs& pairs,
                    const SurfacePoints& points, double* rows, std::int64_t stride) {
  for (std::int32_t first = 0; first < sources.count; first += native_lanes) {
    const Native inverse = load_lanes(sources.inverse_length + first);
    const Native place = load_lanes(sources.place + first), centre = load_lanes(sources.centre + first);
    const Native factor = load_lanes(sources.factor + first);
    const Native inverse_place = skewed ? place_from_one({inverse, inverse}).a : inverse;
    const auto twice = [](Native x) { return Pack(x, x); };
    for (std::int32_t base = 0; base < points.count; base += 2 * found_ahead) {
      const std::int32_t end = base + 2 * found_ahead < points.count ? base + 2 * found_ahead : points.count;
      MiddlePlaneCells cells[found_ahead];
      // Cells of the table of J(tau, 0) first, for many points, so that no load waits for its index.
      two_by_two(base, end, [&](std::int32_t a, std::int32_t b) {
        const Pack at(broadcast(points.place[a]), broadcast(points.place[b]));
        find_cells(magnitude(twice(place) - at) * twice(inverse), cells[(a - base) / 2]);
      });
      two_by_two(base, end, [&](std::int32_t a, std::int32_t b) {
        const std::int64_t row_a = points.row[a] * pairs.stride + first;
        const std::int64_t row_b = points.row[b] * pairs.stride + first;
        const auto of_pairs = [&](const double* of) {
          return Pack(load_lanes(of + row_a), load_lanes(of + row_b));
        };
        // J on the middle plane; beside it, where centres differ, J(tau, xi). Then width, factor and cosine.
        const MiddlePlane<Pack> middle = read_middle_plane(tables.line, cells[(a - base) / 2]);
        Pack seen = middle.potential;
        if constexpr (skewed) {
          const Pack x(broadcast(points.x[a]), broadcast(points.x[b]));
          seen = line_potential_near(tables.line, middle, magnitude(twice(centre) - x) * twice(inverse), [&] {
            return line_rows_at(of_pairs(pairs.axis_place) + twice(inverse_place));
          });
        }
        seen += of_pairs(pairs.correction) * middle.inverse_to_end;
        const Pack on = twice(factor) * of_pairs(pairs.cosine) * seen;
        store_lanes(rows + a * stride + first, on.a);
        store_lanes(rows + b * stride + first, on.b);
      });
    }
  }
}

/// SurfaceKernels::influence.
inline void surface_influence(const SurfaceTables& tables, const SurfaceSources& sources,
                              const SurfacePairs& pairs, const SurfacePoints& points, bool skewed,
                              double* rows, std::int64_t stride) {
  (skewed ? influence_rows<true> : influence_rows<false>)(tables, sources, pairs, points, rows, stride);
}

/// SurfaceKernels::own_influence.
inline void surface_own_influence(const SurfaceTables& tables, const SurfaceSources& sources, double* rows,
                                  std::int64_t stride) {
  // Mean of J(tau, 0) over half the width, of a source per lane; then one by one to the diagonal.
  for (std::int32_t first = 0; first < sources.count; first += lanes) {
    double own[lanes];
    store_pack(own, load_pack(sources.factor + first) *
                        read(tables.own_middle, load_pack(sources.half_width + first)));
    for (std::int32_t k = 0; k < lanes && first + k < sources.count; ++k)
      rows[(first + k) * (stride + 1)] = own[k];
  }
}

/// Cells of J(tau, xi) of source j at edges at x, of strips whose pairs with it begin at `pair`.
WRC_IN_LOOP void find_source(const SurfaceSources& sources, std::int32_t j, double inverse_place,
                             const SurfacePairs& pairs, std::int64_t pair, Pack x, LineCells& cells) {
  const Native axis_place = load_lanes(pairs.axis_place + pair);
  const LineRows rows = line_rows_at(Pack(axis_place, axis_place) + inverse_place);
  const Pack xi = magnitude(x - sources.centre[j]) * sources.inverse_length[j];
  find_cells(rows, xi - 1.0, cells);
}

/// Displacement of these edges by source j, from the cells found.
WRC_IN_LOOP Pack displaced_by(const SurfaceTables& tables, const SurfaceSources& sources, std::int32_t j,
                              const SurfacePairs& pairs, std::int64_t pair, const LineCells& cells) {
  const Native cosine = load_lanes(pairs.cosine + pair);
  const BetweenColumns between = between_columns(tables.line, cells);
  return Pack(cosine, cosine) * sources.factor[j] * (between.here + between.fraction * between.rise);
}

/// SurfaceKernels::edges. Both edges of as many strips as a vector holds.
inline void surface_edges(const SurfaceTables& tables, const SurfaceSources& sources,
                          const SurfacePairs& pairs, const SurfaceEdges& edges) {
  // Displacement of a strip's own edges first: alike at both, the mean of J(tau, 1) over half the width.
  for (std::int32_t a = 0; a < sources.count; a += lanes)
    store_pack(edges.leading + a, load_pack(sources.factor + a) *
                                      read(tables.line.edge_under, load_pack(sources.half_width + a)));
  if (edges.trailing)
    for (std::int32_t a = 0; a < sources.count; a += lanes)
      store_pack(edges.trailing + a, load_pack(edges.leading + a));
  // Then by groups of sources: cells of a whole group before any is read, and sums in the order of the
  // sources, so that all instruction sets add alike.
  for (std::int32_t base = 0; base < sources.count; base += found_ahead) {
    double inverse_place[most_lanes];
    for (std::int32_t k = 0; k < found_ahead; k += lanes)
      store_pack(inverse_place + k, place_from_one(load_pack(sources.inverse_length + base + k)));
    const std::int32_t end = base + found_ahead < sources.count ? base + found_ahead : sources.count;
    for (std::int32_t first = 0; first < sources.count; first += native_lanes) {
      // Leading edges in one half of a pack, trailing ones in the other.
      const Native centre = load_lanes(sources.centre + first), l = load_lanes(edges.half_length + first);
      const Pack x(centre + l, edges.trailing ? centre - l : centre + l);
      LineCells cells[found_ahead];
      const auto pair = [&](std::int32_t j) { return edges.row[j] * pairs.stride + first; };
      for (std::int32_t j = base; j < end; ++j)
        find_source(sources, j, inverse_place[j - base], pairs, pair(j), x, cells[j - base]);
      if (edges.trailing) {
        Pack sum(load_lanes(edges.leading + first), load_lanes(edges.trailing + first));
        for (std::int32_t j = base; j < end; ++j)
          sum += displaced_by(tables, sources, j, pairs, pair(j), cells[j - base]);
        store_lanes(edges.leading + first, sum.a);
        store_lanes(edges.trailing + first, sum.b);
      } else {
        Native sum = load_lanes(edges.leading + first);
        for (std::int32_t j = base; j < end; ++j)
          sum = sum + displaced_by(tables, sources, j, pairs, pair(j), cells[j - base]).a;
        store_lanes(edges.leading + first, sum);
      }
    }
  }
}

}  // namespace
}  // namespace wrc::simd
