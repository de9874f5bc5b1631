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

/// What the sources from `first` on do to points that are the middles of strips. The formulas are those of
/// normal/simd/influence_kernel.hpp.
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
  const Pack tau2 = tau * tau;
  Pack seen = read(tables.line.on_middle_plane, tau);
  const Pack to_end = root(1.0 + tau2);
  const Pack inverse_cube = 1.0 / (tau2 * to_end);
  if constexpr (skewed) {
    const Pack xi = magnitude(for_both(sources.centre, first) - points.x) * inverse;
    const Pack xi2 = xi * xi;
    const Pack inverse_to_end = inverse_cube * tau2;
    const Pack border = 0.06 + 0.02 * tau2;
    const Pack close = seen * (1.0 - 0.5 * xi2 * (inverse_to_end * inverse_to_end));
    if (any(xi2 > border)) {
      // Both forms hold where one goes over into the other: they are blended there.
      const Pack beyond = smaller(larger((xi2 - border) / border, 0.0), 1.0);
      const Pack far = line_potential_at(tables.line, tau, xi);
      seen = close + beyond * (far - close);
    } else {
      seen = close;
    }
  }
  const Mask is_near = distance < near * half_width;
  if (any(is_near)) {
    const Pack square = half_width * half_width;
    const Pack t2 = square * (inverse_cube * to_end);
    const Pack correction = 2.0 * square * inverse_cube * (1.0 / 6.0 + t2 * (1.0 / 20.0 + t2 * (1.0 / 42.0)));
    seen += select(is_near & apart, correction, 0.0);
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

/// What all sources do to two edges of strips. The sums run in sixteen parts, whatever the width of a vector.
WRC_IN_LOOP void displace_edges(const SurfaceTables& tables, const SurfaceSources& sources,
                                const TwoPoints& edges, double& on_a, double& on_b) {
  constexpr std::int32_t vectors = most_lanes / native_lanes;
  Pack sum[vectors];
  for (std::int32_t k = 0; k < vectors; ++k) sum[k] = 0.0;
  for (std::int32_t base = 0; base < sources.count; base += most_lanes)
    for (std::int32_t k = 0; k < vectors; ++k) {
      const std::int32_t first = base + k * native_lanes;
      if (first >= sources.count) break;
      const Pack inverse = for_both(sources.inverse_length, first);
      const Pack tau = magnitude(for_both(sources.place, first) - edges.place) * inverse;
      const Pack xi = magnitude(edges.x - for_both(sources.centre, first)) * inverse;
      Pack seen = line_potential_at(tables.line, tau, xi);
      const Mask own = tau <= 0.0;
      if (any(own))
        seen = select(own, read(tables.line.edge_under, for_both(sources.half_width, first)), seen);
      sum[k] += for_both(sources.factor, first) * seen * cosine_to(sources, first, edges);
    }
  double part_a[most_lanes], part_b[most_lanes];
  for (std::int32_t k = 0; k < vectors; ++k) {
    store_lanes(part_a + k * native_lanes, sum[k].a);
    store_lanes(part_b + k * native_lanes, sum[k].b);
  }
  for (std::int32_t half = most_lanes / 2; half > 0; half /= 2)
    for (std::int32_t k = 0; k < half; ++k) {
      part_a[k] += part_a[k + half];
      part_b[k] += part_b[k + half];
    }
  on_a = part_a[0];
  on_b = part_b[0];
}

/// Kernels::surface_edges.
inline void surface_edges(const SurfaceTables& tables, const SurfaceSources& sources,
                          const SurfaceEdges& edges) {
  const SurfacePoints middles{sources.count, sources.place, sources.centre, sources.ny, sources.nz};
  const double* const l = edges.half_length;
  if (edges.trailing) {
    for (std::int32_t a = 0; a < sources.count; ++a) {
      TwoPoints ends = two_points(middles, a, a);
      ends.x = Pack(broadcast(middles.x[a] + l[a]), broadcast(middles.x[a] - l[a]));
      displace_edges(tables, sources, ends, edges.leading[a], edges.trailing[a]);
    }
    return;
  }
  for (std::int32_t a = 0; a < sources.count; a += 2) {
    const std::int32_t b = a + 1 < sources.count ? a + 1 : a;
    TwoPoints ends = two_points(middles, a, b);
    ends.x = ends.x + Pack(broadcast(l[a]), broadcast(l[b]));
    displace_edges(tables, sources, ends, edges.leading[a], edges.leading[b]);
  }
}

}  // namespace
}  // namespace wrc::simd
