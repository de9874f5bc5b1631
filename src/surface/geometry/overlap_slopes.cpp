#include "surface/geometry/overlap_slopes.hpp"

namespace wrc::surface {
namespace {

/// How far the end of a ray moves along the outline as the ray and the outline move: from miss(u) = 0, the
/// derivatives of `miss` at a fixed u over its slope by u, which is of plain numbers.
PlaceDual ray_end(const PieceOf<double>& piece, const RelativePoseOf<PlaceDual>& pose,
                  const OutlineAttitudeOf<PlaceDual>& attitude, const StripRay<PlaceDual>& ray, double u) {
  // the profile's point rests: only pose and ray carry derivatives
  const OnProfile<double> at = on_profile(piece, u);
  const PlaceDual y = at.y, r = at.radius, steepness = at.slope;
  const PlaceDual miss = ray_miss(ray, outline_place(pose, attitude, y, r, steepness));

  // slope d miss / du of the outline at rest
  RelativePose rest;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) rest.rotation[i][k] = pose.rotation[i][k].value;
  const OutlineAttitude rests{attitude.e1.value, attitude.e2.value, attitude.e3.value};
  const OutlineSlope<double> by_u =
      outline_slope(rest, rests, at, outline_place(rest, rests, at.y, at.radius, at.slope));
  const double slope = by_u.y * ray.ty.value + by_u.z * ray.tz.value;
  PlaceDual end = u;
  for (std::size_t d = 0; d < place_inputs; ++d) end.d[d] = -miss.d[d] / slope;
  return end;
}

}  // namespace

RelativePoseOf<PlaceDual> moving_pose(const RelativePose& pose) {
  RelativePoseOf<PlaceDual> moving;
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) moving.rotation[i][k] = pose.rotation[i][k];
    // a turn by dw changes a column c of the rotation by dw x c
    moving.rotation[1][k].d[turn_x] = -pose.rotation[2][k];
    moving.rotation[2][k].d[turn_x] = pose.rotation[1][k];
    moving.rotation[0][k].d[turn_z] = -pose.rotation[1][k];
    moving.rotation[1][k].d[turn_z] = pose.rotation[0][k];
  }
  moving.y = PlaceDual::input(pose.y, place_y);
  moving.z = PlaceDual::input(pose.z, place_z);
  return moving;
}

OverlapSlopes overlap_slopes(const StripPlace& place, const Curve& wheel,
                             const RelativePoseOf<PlaceDual>& pose,
                             const OutlineAttitudeOf<PlaceDual>& attitude, std::int32_t k, double at) {
  PieceOf<double> piece;
  for (int d = 0; d < 4; ++d) {
    piece.y[d] = wheel.y[d][k];
    piece.z[d] = wheel.z[d][k];
  }
  const StripRay<PlaceDual> ray{place.y - pose.y, place.z - pose.z, place.ty, place.tz};
  // A ray that ended at a border of its piece was held there: it does not move.
  const bool inside = at > 0.0 && at < wheel.s[k + 1] - wheel.s[k];
  const PlaceDual u = inside ? ray_end(piece, pose, attitude, ray, at) : PlaceDual(at);

  const OnProfile<PlaceDual> p = on_profile(piece, u);
  const OutlinePlace<PlaceDual> o = outline_place(pose, attitude, p.y, p.radius, p.slope);
  OverlapSlopes s{ray_overlap(pose, ray, p, o).strip, p.y};
  s.grade = 0.0;
  return s;
}

}  // namespace wrc::surface
