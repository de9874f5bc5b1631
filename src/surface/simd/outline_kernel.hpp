/// The outline of a posed wheel at its knots, and where the rays of a rail's strips meet it.
#pragma once

#include "base/pack.hpp"
#include "surface/outline.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// Kernels::outline.
inline void outline_kernel(const OutlineTask& task) {
  const WheelCurve& wheel = *task.wheel;
  for (std::int32_t k = 0; k < wheel.knots; k += lanes) {
    const Pack slope = load_pack(wheel.knot_slope + k);
    const OutlinePlace<Pack> o = outline_place<Pack>(*task.pose, task.attitude, load_pack(wheel.knot_y + k),
                                                     load_pack(wheel.knot_radius + k), slope);
    store_pack(task.scratch->y + k, o.y + task.pose->y);
    store_pack(task.scratch->z + k, o.z + task.pose->z);
    const Mask seen = (magnitude(task.attitude.e2 * slope) < steepest_sine) & (slope < 1e200);
    store_pack(task.scratch->seen + k, select(seen, 1.0, 0.0));
  }
}

/// Coefficients of the wheel's curve, one piece per lane.
struct Pieces {
  Pack y[4], z[4], length;
};

inline Pieces pieces_of(const Curve& curve, const std::int32_t (&piece)[lanes]) {
  double y[4][lanes], z[4][lanes], length[lanes];
  for (std::int32_t i = 0; i < lanes; ++i) {
    const std::int32_t k = piece[i];
    for (int d = 0; d < 4; ++d) {
      y[d][i] = curve.y[d][k];
      z[d][i] = curve.z[d][k];
    }
    length[i] = curve.s[k + 1] - curve.s[k];
  }
  Pieces p;
  for (int d = 0; d < 4; ++d) {
    p.y[d] = load_pack(y[d]);
    p.z[d] = load_pack(z[d]);
  }
  p.length = load_pack(length);
  return p;
}

/// The outline at one place, as far as a ray needs it.
struct OnOutline {
  OutlinePlace<Pack> place;
  Pack uy, uz;    ///< unit tangent of the profile
  Pack dy, dz;    ///< of the outline, along the profile's parameter, rail axes
  Pack meridian;  ///< curvature of the profile [1/m]
  Pack radius;
};

inline OnOutline on_outline(const OutlineTask& task, const Pieces& c, Pack u) {
  const auto& R = task.pose->rotation;
  const Pack py = c.y[0] + u * (c.y[1] + u * (c.y[2] + u * c.y[3]));
  const Pack pz = c.z[0] + u * (c.z[1] + u * (c.z[2] + u * c.z[3]));
  const Pack dy = c.y[1] + u * (2.0 * c.y[2] + 3.0 * u * c.y[3]);
  const Pack dz = c.z[1] + u * (2.0 * c.z[2] + 3.0 * u * c.z[3]);
  const Pack ddy = 2.0 * c.y[2] + 6.0 * u * c.y[3], ddz = 2.0 * c.z[2] + 6.0 * u * c.z[3];
  OnOutline o;
  const Pack per_speed = 1.0 / root(dy * dy + dz * dz);
  o.uy = dy * per_speed;
  o.uz = dz * per_speed;
  const Pack advance = larger(o.uy, least_advance);
  const Pack slope = o.uz / advance;
  o.place = outline_place<Pack>(*task.pose, task.attitude, py, pz, slope);
  o.radius = pz;
  const Pack bent = dy * ddz - dz * ddy;
  o.meridian = bent * per_speed * per_speed * per_speed;
  const Pack theta_s = task.attitude.e2 * bent / (larger(dy * dy, 1e-8) * o.place.cosine);
  const Pack st = o.place.sin_theta, ct = o.place.cos_theta;
  const Pack tx = dz * st + pz * ct * theta_s, tz = dz * ct - pz * st * theta_s;
  o.dy = R[1][0] * tx + R[1][1] * dy + R[1][2] * tz;
  o.dz = R[2][0] * tx + R[2][1] * dy + R[2][2] * tz;
  return o;
}

/// Kernels::follow_rays. Newton's method within the piece that a chord was seen to cross in.
inline void follow_rays_kernel(const OutlineTask& task, Overlaps& overlaps) {
  constexpr int steps = 4;
  const RailStrips& rail = *task.rail;
  const auto& R = task.pose->rotation;
  const OverlapScratch& scratch = *task.scratch;
  for (std::int32_t first = 0; first < overlaps.count; first += lanes) {
    std::int32_t piece[lanes];
    double part[lanes], y[lanes], z[lanes], ty[lanes], tz[lanes];
    for (std::int32_t i = 0; i < lanes; ++i) {  // lanes too many repeat the last strip
      const std::int32_t at = first + i < overlaps.count ? first + i : overlaps.count - 1;
      const std::int32_t j = scratch.strip[at];
      piece[i] = scratch.piece[j];
      part[i] = scratch.part[j];
      y[i] = rail.y[j];
      z[i] = rail.z[j];
      ty[i] = rail.ty[j];
      tz[i] = rail.tz[j];
    }
    const Pieces c = pieces_of(task.wheel->curve, piece);
    const Pack rail_y = load_pack(y) - task.pose->y, rail_z = load_pack(z) - task.pose->z;
    const Pack along_y = load_pack(ty), along_z = load_pack(tz);
    Pack u = load_pack(part) * c.length;
    for (int n = 0; n < steps; ++n) {
      const OnOutline o = on_outline(task, c, u);
      const Pack miss = (o.place.y - rail_y) * along_y + (o.place.z - rail_z) * along_z;
      const Pack slope = o.dy * along_y + o.dz * along_z;
      const Mask steep = magnitude(slope) > 0.02;
      const Pack step = select(steep, miss / select(steep, slope, 1.0), 0.0);
      u = smaller(larger(u - step, 0.0), c.length);
    }
    const OnOutline o = on_outline(task, c, u);
    const Pack st = o.place.sin_theta, ct = o.place.cos_theta;
    const Pack nx = o.uy * st, nz = o.uy * ct;
    const Pack wheel_ny = R[1][0] * nx - R[1][1] * o.uz + R[1][2] * nz;
    const Pack wheel_nz = R[2][0] * nx - R[2][1] * o.uz + R[2][2] * nz;
    const Pack overlap = (o.place.z - rail_z) * along_y - (o.place.y - rail_y) * along_z;
    const Pack cosine = wheel_nz * along_y - wheel_ny * along_z;
    const Pack half = root(larger(0.5 * (1.0 + cosine), 0.1));
    const Pack cos_chi = R[0][0] * ct - R[0][2] * st, cos2 = cos_chi * cos_chi;
    const Pack curvature = (cos2 * o.uy / o.radius - (1.0 - cos2) * o.meridian) / half;
    const Mask faces = (cosine > 0.2) & (curvature > 0.01);
    const Pack depth = select(faces, overlap * cosine / (half * half), -1.0);
    const std::int32_t count = overlaps.count - first < lanes ? overlaps.count - first : lanes;
    store_pack(part, u);
    for (std::int32_t i = 0; i < count; ++i) scratch.along[scratch.strip[first + i]] = part[i];
    store(depth, overlaps.depth + first, count);
    store(o.place.x, overlaps.centre + first, count);
    store(curvature, overlaps.curvature + first, count);
    store(0.5 * (wheel_ny - along_z) / half, overlaps.ny + first, count);
    store(0.5 * (wheel_nz + along_y) / half, overlaps.nz + first, count);
    store(o.place.y, overlaps.wy + first, count);
    store(o.place.z, overlaps.wz + first, count);
  }
}

}  // namespace
}  // namespace wrc::simd
