/// Displacement of a curved surface by strips of semi-elliptic pressure. A pack sees as many sources as the
/// processor's vector holds, from two points at a time.
#pragma once

#include "normal/simd/line_tables.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// Elements of the sources from `first` on, for both points.
inline Pack for_both(const double* of, std::int32_t first) {
  const Native a = load_lanes(of + first);
  return {a, a};
}

/// Two points of the surface.
struct TwoPoints {
  Pack place, x, ny, nz;
};

inline TwoPoints two_points(const SurfacePoints& points, std::int32_t a, std::int32_t b) {
  const auto both = [&](const double* of) { return Pack(broadcast(of[a]), broadcast(of[b])); };
  return {both(points.place), both(points.x), both(points.ny), both(points.nz)};
}

/// Cosine between the points' directions and those of the sources.
inline Pack cosine_to(const SurfaceSources& sources, std::int32_t first, const TwoPoints& points) {
  return points.ny * for_both(sources.ny, first) + points.nz * for_both(sources.nz, first);
}

/// What the sources from `first` on do to points that are the middles of strips.
template <bool skewed>
WRC_IN_LOOP Pack influence_on(const SurfaceTables& tables, const SurfaceSources& sources, std::int32_t first,
                              const TwoPoints& points) {
  // Half widths away from a strip: beyond, what its width adds to its middle's value is below 1e-3 of it.
  constexpr double near = 17.0;
  const Pack inverse = for_both(sources.inverse_length, first);
  const Pack half_width = for_both(sources.half_width, first);
  const Pack distance = magnitude(for_both(sources.place, first) - points.place) * inverse;
  const Mask apart = distance > 0.0;
  const Pack tau = select(apart, distance, 1.0);
  const MiddlePlane<Pack> middle = read_middle_plane(tables.line, tau);
  Pack seen = middle.potential;
  if constexpr (skewed)
    seen = line_potential_near(tables.line, middle, tau,
                               magnitude(for_both(sources.centre, first) - points.x) * inverse);
  const Mask is_near = distance < near * half_width;
  if (any(is_near)) {
    seen += select(is_near & apart, width_correction(half_width / tau, middle.inverse_to_end), 0.0);
    if (any(!apart)) seen = select(apart, seen, read(tables.own_middle, half_width));
  }
  return for_both(sources.factor, first) * seen * cosine_to(sources, first, points);
}

template <bool skewed>
void influence_rows(const SurfaceTables& tables, const SurfaceSources& sources, const SurfacePoints& points,
                    double* rows, std::int64_t stride) {
  for (std::int32_t a = 0; a < points.count; a += 2) {
    const std::int32_t b = a + 1 < points.count ? a + 1 : a;  // an odd one is seen twice
    const TwoPoints two = two_points(points, a, b);
    double *const row_a = rows + a * stride, *const row_b = rows + b * stride;
    for (std::int32_t first = 0; first < sources.count; first += native_lanes) {
      const Pack on = influence_on<skewed>(tables, sources, first, two);
      store_lanes(row_a + first, on.a);
      store_lanes(row_b + first, on.b);
    }
  }
}

/// Kernels::surface_influence.
inline void surface_influence(const SurfaceTables& tables, const SurfaceSources& sources,
                              const SurfacePoints& points, bool skewed, double* rows, std::int64_t stride) {
  (skewed ? influence_rows<true> : influence_rows<false>)(tables, sources, points, rows, stride);
}

/// What the sources do to two points, in most_lanes parts whatever the width of a vector.
struct Parts {
  static constexpr std::int32_t vectors = most_lanes / native_lanes;
  Pack of[vectors];
};

/// Adds up the parts.
inline void sum_up(const Parts& sum, double& on_a, double& on_b) {
  double part_a[most_lanes], part_b[most_lanes];
  for (std::int32_t k = 0; k < Parts::vectors; ++k) {
    store_lanes(part_a + k * native_lanes, sum.of[k].a);
    store_lanes(part_b + k * native_lanes, sum.of[k].b);
  }
  for (std::int32_t half = most_lanes / 2; half > 0; half /= 2)
    for (std::int32_t k = 0; k < half; ++k) {
      part_a[k] += part_a[k + half];
      part_b[k] += part_b[k + half];
    }
  on_a = part_a[0];
  on_b = part_b[0];
}

/// What the other sources do to the edges of two strips. Both ends of a strip are equally far from a source
/// but along x.
template <bool both_ends>
WRC_IN_LOOP void displace_edges(const SurfaceTables& tables, const SurfaceSources& sources,
                                const TwoPoints& middles, const Pack& half_length, Parts& leading,
                                Parts& trailing) {
  for (std::int32_t k = 0; k < Parts::vectors; ++k) leading.of[k] = trailing.of[k] = 0.0;
  for (std::int32_t base = 0; base < sources.count; base += most_lanes)
    for (std::int32_t k = 0; k < Parts::vectors; ++k) {
      const std::int32_t first = base + k * native_lanes;
      if (first >= sources.count) break;
      const Pack inverse = for_both(sources.inverse_length, first);
      const Pack tau = magnitude(for_both(sources.place, first) - middles.place) * inverse;
      const LineRows rows = line_rows(tau);
      const Pack by_unit = for_both(sources.factor, first) * cosine_to(sources, first, middles);
      const Pack factor = select(tau > 0.0, by_unit, 0.0);
      const Pack offset = middles.x - for_both(sources.centre, first);
      const auto by = [&](const Pack& x) {
        return factor * line_potential_at(tables.line, rows, magnitude(x) * inverse);
      };
      leading.of[k] += by(offset + half_length);
      if constexpr (both_ends) trailing.of[k] += by(offset - half_length);
    }
}

template <bool both_ends>
void displace_all_edges(const SurfaceTables& tables, const SurfaceSources& sources,
                        const SurfaceEdges& edges) {
  // What a strip does to its own edges first.
  for (std::int32_t a = 0; a < sources.count; a += lanes) {
    const Pack own =
        load_pack(sources.factor + a) * read(tables.line.edge_under, load_pack(sources.half_width + a));
    store_pack(edges.leading + a, own);
    if constexpr (both_ends) store_pack(edges.trailing + a, own);
  }
  const SurfacePoints middles{sources.count, sources.place, sources.centre, sources.ny, sources.nz};
  for (std::int32_t a = 0; a < sources.count; a += 2) {
    const std::int32_t b = a + 1 < sources.count ? a + 1 : a;  // an odd one is seen twice
    const Pack half_length(broadcast(edges.half_length[a]), broadcast(edges.half_length[b]));
    Parts leading, trailing;
    displace_edges<both_ends>(tables, sources, two_points(middles, a, b), half_length, leading, trailing);
    const auto add = [a, b](const Parts& parts, double* to) {
      double on_a, on_b;
      sum_up(parts, on_a, on_b);
      to[a] += on_a;
      if (b != a) to[b] += on_b;
    };
    add(leading, edges.leading);
    if constexpr (both_ends) add(trailing, edges.trailing);
  }
}

/// Kernels::surface_edges.
inline void surface_edges(const SurfaceTables& tables, const SurfaceSources& sources,
                          const SurfaceEdges& edges) {
  (edges.trailing ? displace_all_edges<true> : displace_all_edges<false>)(tables, sources, edges);
}

}  // namespace
}  // namespace wrc::simd
