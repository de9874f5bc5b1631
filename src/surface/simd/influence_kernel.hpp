/// Displacement of a curved surface by strips of semi-elliptic pressure.
#pragma once

#include "normal/simd/line_tables.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// Cosine between the point's direction and those of the sources.
inline Pack cosine_to(const SurfaceSources& sources, std::int32_t first, const SurfacePoint& point) {
  return point.ny * load_pack(sources.ny + first) + point.nz * load_pack(sources.nz + first);
}

/// Kernels::surface_influence_row. The formulas are those of normal/simd/influence_kernel.hpp.
inline void surface_influence_row(const SurfaceTables& tables, const SurfaceSources& sources,
                                  const SurfacePoint& point, bool skewed, double* row) {
  // Half widths away from a strip: beyond, what its width adds to its middle's value is below 1e-3 of it.
  constexpr double near = 17.0;
  const Pack place = point.place, x = point.x;
  for (std::int32_t first = 0; first < sources.count; first += lanes) {
    const Pack inverse = load_pack(sources.inverse_length + first);
    const Pack half_width = load_pack(sources.half_width + first);
    const Pack distance = magnitude(load_pack(sources.place + first) - place) * inverse;
    const Mask apart = distance > 0.0;
    const Pack tau = select(apart, distance, 1.0);
    const Pack tau2 = tau * tau;
    Pack seen = read(tables.line.on_middle_plane, tau);
    const Pack to_end = root(1.0 + tau2);
    const Pack inverse_cube = 1.0 / (tau2 * to_end);
    if (skewed) {
      const Pack xi = magnitude(load_pack(sources.centre + first) - x) * inverse;
      const Pack xi2 = xi * xi;
      const Pack inverse_to_end = inverse_cube * tau2;
      // Both forms hold where one goes over into the other: they are blended there.
      const Pack beyond = smaller(larger((xi2 - (0.06 + 0.02 * tau2)) / (0.06 + 0.02 * tau2), 0.0), 1.0);
      const Pack close = seen * (1.0 - 0.5 * xi2 * (inverse_to_end * inverse_to_end));
      if (any(beyond > 0.0)) {
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
      const Pack correction =
          2.0 * square * inverse_cube * (1.0 / 6.0 + t2 * (1.0 / 20.0 + t2 * (1.0 / 42.0)));
      seen += select(is_near & apart, correction, 0.0);
      if (any(!apart)) seen = select(apart, seen, read(tables.own_middle, half_width));
    }
    store_pack(row + first, load_pack(sources.factor + first) * seen * cosine_to(sources, first, point));
  }
}

/// Kernels::surface_edge_displacement. The sum runs in sixteen parts, whatever the width of a pack.
inline double surface_edge_displacement(const SurfaceTables& tables, const SurfaceSources& sources,
                                        const SurfacePoint& point) {
  constexpr std::int32_t packs = most_lanes / lanes;
  const Pack place = point.place, x = point.x;
  Pack sum[packs];
  for (std::int32_t k = 0; k < packs; ++k) sum[k] = 0.0;
  for (std::int32_t base = 0; base < sources.count; base += most_lanes)
    for (std::int32_t k = 0; k < packs; ++k) {
      const std::int32_t first = base + k * lanes;
      const Pack inverse = load_pack(sources.inverse_length + first);
      const Pack tau = magnitude(load_pack(sources.place + first) - place) * inverse;
      const Pack xi = magnitude(x - load_pack(sources.centre + first)) * inverse;
      Pack seen = line_potential_at(tables.line, tau, xi);
      const Mask own = tau <= 0.0;
      if (any(own))
        seen = select(own, read(tables.line.edge_under, load_pack(sources.half_width + first)), seen);
      sum[k] += load_pack(sources.factor + first) * seen * cosine_to(sources, first, point);
    }
  double part[most_lanes];
  for (std::int32_t k = 0; k < packs; ++k) store_pack(part + k * lanes, sum[k]);
  for (std::int32_t half = most_lanes / 2; half > 0; half /= 2)
    for (std::int32_t k = 0; k < half; ++k) part[k] += part[k + half];
  return part[0];
}

}  // namespace
}  // namespace wrc::simd
