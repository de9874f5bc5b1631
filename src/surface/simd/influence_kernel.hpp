/// Displacement of a curved surface by strips of semi-elliptic pressure: C w / l J(tau, xi) cos by unit q,
/// with tau, xi the distances along the rail and along x over l (normal/elasticity/influence_tables.hpp).
/// Middles are seen a vector of sources at a time from two points, edges a vector of edges at a time from one
/// source: their sums need not be collected from lanes.
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

/// Place of a distance over 1 m on the table's axis of rows: that of distance / l is the difference to the
/// place of l.
inline Pack axis_place(Pack distance) {
  constexpr double origin = normal::InfluenceTables::line_rows.origin();
  return place_from_one(distance) + origin;
}

/// J on the middle plane of near sources with the effect of their width, on `seen` of the middle lines.
WRC_IN_LOOP Pack with_widths(Pack seen, Pack distance, Pack half_width, Pack inverse_to_end) {
  constexpr double least = 1e-9;  // [m]: a source on itself is left to own_influence
  const Mask near = distance < near_strip * half_width;
  if (!any(near)) return seen;
  const Pack correction = width_correction(half_width / larger(distance, least), inverse_to_end);
  return seen + select(near, correction, 0.0);
}

/// Rows of C w / l J cos, a source per lane, two points at a time.
template <bool skewed>
void influence_rows(const SurfaceTables& tables, const SurfaceSources& sources, const SurfaceFaces& faces,
                    const SurfacePoints& points, double* rows, std::int64_t stride) {
  const auto twice = [](Native x) { return Pack(x, x); };
  const std::int32_t pairs = (points.count + 1) / 2;
  for (std::int32_t first = 0; first < sources.count; first += native_lanes) {
    const Native inverse = load_lanes(sources.inverse_length + first);
    const Native place = load_lanes(sources.place + first), centre = load_lanes(sources.centre + first);
    const Native factor = load_lanes(sources.factor + first);
    const Native half_width = broadcast(0.5) * load_lanes(faces.width + first);
    const Native ny = factor * load_lanes(faces.ny + first), nz = factor * load_lanes(faces.nz + first);
    const Native inverse_place = skewed ? place_from_one({inverse, inverse}).a : inverse;
    for (std::int32_t base = 0; base < pairs; base += found_ahead) {
      const std::int32_t count = pairs - base < found_ahead ? pairs - base : found_ahead;
      const auto both = [&](const double* of, std::int32_t k) {
        return Pack(broadcast(of[2 * (base + k)]), broadcast(of[2 * (base + k) + 1]));
      };
      MiddlePlaneCells cells[found_ahead];
      // Cells of the table of J(tau, 0) first, for many points, so that no load waits for its index.
      for (std::int32_t k = 0; k < count; ++k)
        find_cells(magnitude(twice(place) - both(points.place, k)) * twice(inverse), cells[k]);
      double* row = rows + 2 * base * stride + first;
      for (std::int32_t k = 0; k < count; ++k, row += 2 * stride) {
        const auto distance = [&] { return magnitude(twice(place) - both(points.place, k)); };
        // J on the middle plane; beside it, where centres differ, J(tau, xi). Then width, factor and cosine.
        const MiddlePlane<Pack> middle = read_middle_plane(tables.line, cells[k]);
        Pack seen = middle.potential;
        if constexpr (skewed) {
          const Pack xi = magnitude(twice(centre) - both(points.x, k)) * twice(inverse);
          seen = line_potential_near(tables.line, middle, xi, [&] {
            return line_rows_at(axis_place(distance()) + twice(inverse_place));
          });
        }
        seen = with_widths(seen, distance(), twice(half_width), middle.inverse_to_end);
        const Pack on = (both(points.ny, k) * twice(ny) + both(points.nz, k) * twice(nz)) * seen;
        store_lanes(row, on.a);
        store_lanes(row + stride, on.b);
      }
    }
  }
}

/// SurfaceKernels::influence.
inline void surface_influence(const SurfaceTables& tables, const SurfaceSources& sources,
                              const SurfaceFaces& faces, const SurfacePoints& points, bool skewed,
                              double* rows, std::int64_t stride) {
  (skewed ? influence_rows<true> : influence_rows<false>)(tables, sources, faces, points, rows, stride);
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

/// As many edges as a vector holds, or both edges of half as many strips; their strips, twice each.
struct EdgePack {
  Pack x, place, ny, nz;
};

/// Cells of J(tau, xi) of source j at edges.
WRC_IN_LOOP void find_source(const SurfaceSources& sources, std::int32_t j, double inverse_place,
                             const EdgePack& edges, LineCells& cells) {
  const Pack distance = magnitude(edges.place - sources.place[j]);
  const LineRows rows = line_rows_at(axis_place(distance) + inverse_place);
  const Pack xi = magnitude(edges.x - sources.centre[j]) * sources.inverse_length[j];
  find_cells(rows, xi - 1.0, cells);
}

/// Displacement of these edges by source j, from the cells found; none of its own.
WRC_IN_LOOP Pack displaced_by(const SurfaceTables& tables, const SurfaceSources& sources,
                              const SurfaceFaces& faces, std::int32_t j, const EdgePack& edges,
                              const LineCells& cells) {
  const Mask apart = magnitude(edges.place - sources.place[j]) > 0.0;
  const Pack cosine = select(apart, faces.ny[j] * edges.ny + faces.nz[j] * edges.nz, 0.0);
  const BetweenColumns between = between_columns(tables.line, cells);
  return cosine * sources.factor[j] * (between.here + between.fraction * between.rise);
}

/// SurfaceKernels::edges. Both edges of as many strips as a vector holds.
inline void surface_edges(const SurfaceTables& tables, const SurfaceSources& sources,
                          const SurfaceFaces& faces, const SurfaceEdges& edges) {
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
      const EdgePack at{Pack(centre + l, edges.trailing ? centre - l : centre + l),
                        for_both(sources.place, first), for_both(faces.ny, first), for_both(faces.nz, first)};
      LineCells cells[found_ahead];
      for (std::int32_t j = base; j < end; ++j)
        find_source(sources, j, inverse_place[j - base], at, cells[j - base]);
      if (edges.trailing) {
        Pack sum(load_lanes(edges.leading + first), load_lanes(edges.trailing + first));
        for (std::int32_t j = base; j < end; ++j)
          sum += displaced_by(tables, sources, faces, j, at, cells[j - base]);
        store_lanes(edges.leading + first, sum.a);
        store_lanes(edges.trailing + first, sum.b);
      } else {
        Native sum = load_lanes(edges.leading + first);
        for (std::int32_t j = base; j < end; ++j)
          sum = sum + displaced_by(tables, sources, faces, j, at, cells[j - base]).a;
        store_lanes(edges.leading + first, sum);
      }
    }
  }
}

}  // namespace
}  // namespace wrc::simd
