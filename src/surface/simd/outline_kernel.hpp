/// The outline of a posed wheel at its knots, and where the rays of a rail's strips meet it.
#pragma once

#include "base/pack.hpp"
#include "surface/geometry/outline.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// SurfaceKernels::outline.
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

/// The outline on its way across the rays of a range's strips.
struct RayWalk {
  const double *y, *z, *ty, *tz;  ///< as RailStrips
  std::int32_t first, end;        ///< strips of the range
  std::int32_t last;              ///< strips up to this one have their rays behind the outline

  /// How far a point is ahead of a strip's ray, and how far below its tangent.
  double ahead(std::int32_t j, double at_y, double at_z) const {
    return (at_y - y[j]) * ty[j] + (at_z - z[j]) * tz[j];
  }
  double below(std::int32_t j, double at_y, double at_z) const {
    return (at_z - z[j]) * ty[j] - (at_y - y[j]) * tz[j];
  }

  /// Moves on to a point.
  void go_to(double at_y, double at_z) {
    while (last + 1 < end && ahead(last + 1, at_y, at_z) > 0.0) ++last;
    while (last >= first && ahead(last, at_y, at_z) <= 0.0) --last;
  }

  /// The same to one that may be far ahead.
  void jump_to(double at_y, double at_z) {
    for (; last + lanes < end; last += lanes) {
      const std::int32_t j = last + 1;
      const Pack to =
          (at_y - load_pack(y + j)) * load_pack(ty + j) + (at_z - load_pack(z + j)) * load_pack(tz + j);
      if (any(!(to > 0.0))) break;
    }
    go_to(at_y, at_z);
  }
};

/// SurfaceKernels::cross_rays. Follows the outline from knot to knot; the deepest crossing of a ray counts.
/// Stretches of the outline further above the rail's top or beside it than the margin, and than wheels are
/// pressed into rails, are passed over.
inline void cross_rays_kernel(const OutlineTask& task, double margin, std::int32_t& begin,
                              std::int32_t& end) {
  constexpr double nowhere = -1.0;     // [m]
  constexpr double rounding = 1e-9;    // [m]
  constexpr double pressed_in = 4e-3;  // [m]: deeper than any overlap that is solved, and a piece's length
  const RailStrips& rail = *task.rail;
  const OverlapScratch scratch = *task.scratch;
  const std::int32_t knots = task.wheel->knots;
  for (std::int32_t j = 0; j < rail.count; j += lanes)
    store(nowhere, scratch.overlap + j, rail.count - j < lanes ? rail.count - j : lanes);
  std::int32_t lowest = rail.count, highest = -1;
  const double least = -margin - chord_sagitta - rounding;
  for (std::int32_t r = 0; r < rail.ranges; ++r) {
    const FaceStrips& range = rail.range[r];
    const double top = range.top + least, beside = -least > pressed_in ? -least : pressed_in;
    const double left = range.leftmost - beside, right = range.rightmost + beside;
    RayWalk walk{rail.y, rail.z, rail.ty, rail.tz, range.first, range.first + range.count, range.first - 1};
    bool near_before = false, passed_over = false;
    for (std::int32_t pack = 0; pack < knots; pack += lanes) {
      const Pack ys = load_pack(scratch.y + pack), zs = load_pack(scratch.z + pack);
      if (!near_before && !any((zs >= top) & (ys >= left) & (ys <= right))) {
        passed_over = true;
        continue;
      }
      const std::int32_t behind = pack + lanes < knots ? pack + lanes : knots;
      for (std::int32_t k = pack; k < behind; ++k) {
        const double y = scratch.y[k], z = scratch.z[k];
        const bool near = z >= top && y >= left && y <= right;
        if (!near && !near_before) {
          passed_over = true;
          continue;
        }
        near_before = near;
        if (passed_over) walk.jump_to(scratch.y[k - 1], scratch.z[k - 1]);
        passed_over = false;
        if (k == 0 || !(scratch.seen[k] > 0.0 && scratch.seen[k - 1] > 0.0)) {
          walk.jump_to(y, z);
          continue;
        }
        const std::int32_t before = walk.last;
        walk.go_to(y, z);
        if (walk.last == before) continue;
        const double y_before = scratch.y[k - 1], z_before = scratch.z[k - 1];
        std::int32_t j = before < walk.last ? before : walk.last;
        const std::int32_t last = before < walk.last ? walk.last : before;
        while (++j <= last) {
          if (walk.below(j, y_before, z_before) < least && walk.below(j, y, z) < least) continue;
          const double from = walk.ahead(j, y_before, z_before), to = walk.ahead(j, y, z);
          const double way = from == to ? 0.5 : from / (from - to);
          const double t = way > 0.0 ? (way < 1.0 ? way : 1.0) : 0.0;
          const double py = y_before + t * (y - y_before) - rail.y[j],
                       pz = z_before + t * (z - z_before) - rail.z[j];
          const double overlap = pz * rail.ty[j] - py * rail.tz[j];
          if (overlap <= scratch.overlap[j]) continue;
          scratch.overlap[j] = overlap;
          scratch.piece[j] = k - 1;
          scratch.part[j] = t;
          lowest = j < lowest ? j : lowest;
          highest = j > highest ? j : highest;
        }
      }
    }
  }
  begin = lowest;
  end = highest + 1;
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

WRC_IN_LOOP OnOutline on_outline(const OutlineTask& task, const Pieces& c, Pack u) {
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

/// SurfaceKernels::follow_rays. Newton's method within the piece that a chord was seen to cross in.
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
