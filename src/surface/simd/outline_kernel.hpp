/// The outline of a posed wheel at its knots, and where the rays of a rail's strips meet it.
#pragma once

#include "base/pack.hpp"
#include "surface/geometry/outline.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// SurfaceKernels::outline.
inline void outline_kernel(const OutlineTask& task) {
  const surface::WheelCurve& wheel = *task.wheel;
  for (std::int32_t k = 0; k < wheel.knots; k += lanes) {
    const Pack slope = load_pack(wheel.knot_slope + k);
    const surface::OutlinePlace<Pack> o = surface::outline_place(
        *task.pose, task.attitude, load_pack(wheel.knot_y + k), load_pack(wheel.knot_radius + k), slope);
    store_pack(task.scratch->y + k, o.y + task.pose->y);
    store_pack(task.scratch->z + k, o.z + task.pose->z);
    // theta exists where |e2 r' / Y'| stays well below 1, and the face does not turn back
    const Mask seen = (magnitude(task.attitude.e2 * slope) < surface::steepest_sine) & (slope < 1e200);
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
inline void cross_rays_kernel(const OutlineTask& task, const double* margin, std::int32_t& begin,
                              std::int32_t& end) {
  constexpr double nowhere = -1.0;     // [m]
  constexpr double rounding = 1e-9;    // [m]
  constexpr double pressed_in = 4e-3;  // [m]: deeper than any overlap that is solved, and a piece's length
  const surface::RailStrips& rail = *task.rail;
  const surface::OverlapScratch scratch = *task.scratch;
  const std::int32_t knots = task.wheel->knots;
  for (std::int32_t j = 0; j < rail.count; j += lanes)
    store(nowhere, scratch.overlap + j, rail.count - j < lanes ? rail.count - j : lanes);
  // Each range is walked on its own. Knots near it lie below its top and between its sides, by the margin.
  std::int32_t lowest = rail.count, highest = -1;
  for (std::int32_t r = 0; r < rail.ranges; ++r) {
    const surface::FaceStrips& range = rail.range[r];
    const double least = -margin[r] - surface::chord_sagitta - rounding;
    const double top = range.top + least, beside = -least > pressed_in ? -least : pressed_in;
    const double left = range.leftmost - beside, right = range.rightmost + beside;
    RayWalk walk{rail.y, rail.z, rail.ty, rail.tz, range.first, range.first + range.count, range.first - 1};
    // Packs of knots that are all far from the range are passed over; the walk jumps to where they end.
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
        // Behind knots that were passed over, or where the outline does not exist, nothing is crossed.
        if (passed_over) walk.jump_to(scratch.y[k - 1], scratch.z[k - 1]);
        passed_over = false;
        if (k == 0 || !(scratch.seen[k] > 0.0 && scratch.seen[k - 1] > 0.0)) {
          walk.jump_to(y, z);
          continue;
        }
        const std::int32_t before = walk.last;
        walk.go_to(y, z);
        if (walk.last == before) continue;
        // Rays between the chord's ends: the crossing divides it by the distances of both ends from the ray.
        const double y_before = scratch.y[k - 1], z_before = scratch.z[k - 1];
        std::int32_t j = before < walk.last ? before : walk.last;
        const std::int32_t last = before < walk.last ? walk.last : before;
        while (++j <= last) {
          // a chord that lies above the margin at both ends lies above it at the crossing
          if (walk.below(j, y_before, z_before) < least && walk.below(j, y, z) < least) continue;
          const double from = walk.ahead(j, y_before, z_before), to = walk.ahead(j, y, z);
          const double share = from == to ? 0.5 : from / (from - to);
          const double t = share > 0.0 ? (share < 1.0 ? share : 1.0) : 0.0;
          const double py = y_before + t * (y - y_before) - rail.y[j],
                       pz = z_before + t * (z - z_before) - rail.z[j];
          // a ray that meets the outline twice keeps the deeper crossing
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

/// Pieces of the wheel's curve, one per lane.
struct Pieces : surface::PieceOf<Pack> {
  Pack length;  ///< [m]
};

inline Pieces pieces_of(const surface::Curve& curve, const std::int32_t (&piece)[lanes]) {
  // rays of neighbouring strips may end on different pieces: gathered one by one
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

/// SurfaceKernels::follow_rays. Newton's method within the piece whose chord the ray crosses.
inline void follow_rays_kernel(const OutlineTask& task, const surface::Overlaps& overlaps) {
  constexpr int steps = 2;  // three give forces of eight wheels within 5e-13 of this
  const surface::RailStrips& rail = *task.rail;
  for (std::int32_t first = 0; first < overlaps.count; first += lanes) {
    const std::int32_t count = overlaps.count - first < lanes ? overlaps.count - first : lanes;
    std::int32_t piece[lanes];
    double part[lanes], y[lanes], z[lanes], ty[lanes], tz[lanes];
    for (std::int32_t i = 0; i < lanes; ++i) {  // lanes too many repeat the last strip
      const std::int32_t at = first + (i < count ? i : count - 1), j = overlaps.strip[at];
      piece[i] = overlaps.piece[at];
      part[i] = overlaps.u[at];
      y[i] = rail.y[j];
      z[i] = rail.z[j];
      ty[i] = rail.ty[j];
      tz[i] = rail.tz[j];
    }
    const Pieces c = pieces_of(task.wheel->curve, piece);
    // the rays, from the wheel's reference point
    const surface::StripRay<Pack> ray{load_pack(y) - task.pose->y, load_pack(z) - task.pose->z, load_pack(ty),
                                      load_pack(tz)};

    // Newton's step miss / (d miss / du), held within the piece; none where the outline runs along the ray.
    Pack u = load_pack(part) * c.length;
    for (int n = 0; n < steps; ++n) {
      const surface::OnProfile<Pack> p = surface::on_profile(c, u);
      const surface::OutlinePlace<Pack> o =
          surface::outline_place(*task.pose, task.attitude, p.y, p.radius, p.slope);
      const surface::OutlineSlope<Pack> by_u = surface::outline_slope(*task.pose, task.attitude, p, o);
      const Pack slope = by_u.y * ray.ty + by_u.z * ray.tz;
      const Mask steep = magnitude(slope) > 0.02;
      const Pack step = select(steep, surface::ray_miss(ray, o) / select(steep, slope, 1.0), 0.0);
      u = smaller(larger(u - step, 0.0), c.length);
    }

    const surface::OnProfile<Pack> p = surface::on_profile(c, u);
    const surface::OutlinePlace<Pack> place =
        surface::outline_place(*task.pose, task.attitude, p.y, p.radius, p.slope);
    const surface::RayOverlap<Pack> found = surface::ray_overlap(*task.pose, ray, p, place);
    const surface::StripOverlap<Pack>& o = found.strip;
    // A wheel that looks away from the rail, or is hollow along x, has no overlap.
    const Mask faces = (found.facing > 0.2) & (o.curvature > 0.01);
    store(select(faces, o.depth, -1.0), overlaps.depth + first, count);
    store(o.centre, overlaps.centre + first, count);
    store(o.curvature, overlaps.curvature + first, count);
    store(o.ny, overlaps.ny + first, count);
    store(o.nz, overlaps.nz + first, count);
    store(o.wy, overlaps.wy + first, count);
    store(o.wz, overlaps.wz + first, count);
    store(u, overlaps.u + first, count);
  }
}

}  // namespace
}  // namespace wrc::simd
