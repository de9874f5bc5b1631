/// The overlap of a strip of a rail that is the same everywhere, in numbers that carry derivatives by the
/// wheel's pose.
#pragma once

#include "base/pack_dual.hpp"
#include "surface/geometry/outline.hpp"
#include "surface/geometry/overlap_slopes.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::simd {
namespace {

using PoseNumber = PackDual<surface::place_inputs>;

inline PoseNumber pose_number(const surface::PlaceDual& a) {
  static_assert(sizeof a == (1 + PoseNumber::inputs) * sizeof(double), "value and derivatives");
  return PoseNumber::load(reinterpret_cast<const double*>(&a));
}

/// SurfaceKernels::overlap_slopes. A ray that ended at a border of its piece was held there: its end does not
/// move. Others move along the outline, as from miss(u) = 0 by the derivatives of `miss` at a fixed u over
/// its slope by u.
inline void overlap_slopes_kernel(const OverlapSlopesTask& task, surface::OverlapSlopes& to) {
  // pose and attitude, and the same at rest
  surface::RelativePoseOf<PoseNumber> pose;
  surface::RelativePose rest;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      pose.rotation[i][k] = pose_number(task.pose->rotation[i][k]);
      rest.rotation[i][k] = task.pose->rotation[i][k].value;
    }
  pose.y = pose_number(task.pose->y);
  pose.z = pose_number(task.pose->z);
  const surface::OutlineAttitudeOf<PoseNumber> attitude{
      pose_number(task.attitude->e1), pose_number(task.attitude->e2), pose_number(task.attitude->e3)};
  const surface::OutlineAttitude rests{attitude.e1.value, attitude.e2.value, attitude.e3.value};
  // the piece of the wheel's profile, and the ray from the wheel's reference point
  const surface::Curve& wheel = *task.wheel;
  surface::PieceOf<double> piece;
  for (int d = 0; d < 4; ++d) {
    piece.y[d] = wheel.y[d][task.piece];
    piece.z[d] = wheel.z[d][task.piece];
  }
  const surface::StripRay<PoseNumber, double> ray{task.y - pose.y, task.z - pose.z, task.ty, task.tz};

  // the profile's point rests first: only pose and ray carry derivatives
  PoseNumber u = task.u;
  if (task.u > 0.0 && task.u < wheel.s[task.piece + 1] - wheel.s[task.piece]) {
    const surface::OnProfile<double> at = surface::on_profile(piece, task.u);
    const surface::OutlinePlace<PoseNumber> o =
        surface::outline_place(pose, attitude, at.y, at.radius, at.slope);
    const surface::OutlinePlace<double> resting{
        o.x.value, o.y.value, o.z.value, o.sine.value, o.cosine.value, o.sin_theta.value, o.cos_theta.value};
    const surface::OutlineSlope<double> by_u = surface::outline_slope(rest, rests, at, resting);
    const PoseNumber miss = surface::ray_miss(ray, o);
    u = miss.chain(task.u, -1.0 / (by_u.y * ray.ty + by_u.z * ray.tz));
  }

  // the overlap at the ray's end, which moves
  const surface::OnProfile<PoseNumber> p = surface::on_profile(piece, u);
  const surface::OutlinePlace<PoseNumber> o = surface::outline_place(pose, attitude, p.y, p.radius, p.slope);
  const surface::RayOverlap<PoseNumber> found = surface::ray_overlap(pose, ray, p, o);
  const surface::StripOverlap<PoseNumber>& s = found.strip;
  const auto put = [](const PoseNumber& x, surface::PlaceDual& at) {
    x.store(reinterpret_cast<double*>(&at));
  };
  put(s.depth, to.depth);
  put(s.centre, to.centre);
  put(s.curvature, to.curvature);
  put(s.ny, to.ny);
  put(s.nz, to.nz);
  put(s.wy, to.wy);
  put(s.wz, to.wz);
  put(0.0, to.grade);
  put(p.y, to.y_wheel);
}

}  // namespace
}  // namespace wrc::simd
