#include "surface/geometry/overlap_slopes.hpp"

namespace wrc {
namespace {

using Number = PlaceDual;

/// The wheel's profile at a place on one of its pieces.
struct OnProfile {
  Number y, radius;
  Number dy, dz, ddy, ddz;
  Number uy, uz, per_speed, slope;
};

OnProfile on_profile(const Curve& curve, std::int32_t k, const Number& u) {
  const auto value = [&](const double* const(&c)[4]) {
    return c[0][k] + u * (c[1][k] + u * (c[2][k] + u * c[3][k]));
  };
  const auto first = [&](const double* const(&c)[4]) {
    return c[1][k] + u * (2.0 * c[2][k] + u * (3.0 * c[3][k]));
  };
  const auto second = [&](const double* const(&c)[4]) { return 2.0 * c[2][k] + u * (6.0 * c[3][k]); };
  OnProfile p;
  p.y = value(curve.y);
  p.radius = value(curve.z);
  p.dy = first(curve.y);
  p.dz = first(curve.z);
  p.ddy = second(curve.y);
  p.ddz = second(curve.z);
  p.per_speed = Number(1.0) / root(p.dy * p.dy + p.dz * p.dz);
  p.uy = p.dy * p.per_speed;
  p.uz = p.dz * p.per_speed;
  p.slope = p.uz / larger(p.uy, Number(least_advance));
  return p;
}

}  // namespace

RelativePoseOf<PlaceDual> moving_pose(const RelativePose& pose) {
  RelativePoseOf<PlaceDual> moving;
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) moving.rotation[i][k] = pose.rotation[i][k];
    moving.rotation[1][k].d[turn_x] = -pose.rotation[2][k];
    moving.rotation[2][k].d[turn_x] = pose.rotation[1][k];
    moving.rotation[0][k].d[turn_z] = -pose.rotation[1][k];
    moving.rotation[1][k].d[turn_z] = pose.rotation[0][k];
  }
  moving.y = PlaceDual::input(pose.y, place_y);
  moving.z = PlaceDual::input(pose.z, place_z);
  return moving;
}

OverlapSlopes overlap_slopes(const StripPlace& place, const WheelCurve& wheel,
                             const RelativePoseOf<PlaceDual>& pose,
                             const OutlineAttitudeOf<PlaceDual>& attitude, const OverlapScratch& scratch,
                             std::int32_t j) {
  const Curve& curve = wheel.curve;
  const std::int32_t k = scratch.piece[j];
  const double length = curve.s[k + 1] - curve.s[k];
  const Number &along_y = place.ty, &along_z = place.tz;
  const Number rail_y = place.y - pose.y, rail_z = place.z - pose.z;
  const auto& R = pose.rotation;

  // Where the ray ends, from what it would miss by there: the outline's derivative is carried in a number of
  // its own.
  const double at = scratch.along[j];
  Number u = at;
  if (at > 0.0 && at < length) {
    const OnProfile p = on_profile(curve, k, at);
    const OutlinePlace<Number> o = outline_place<Number>(pose, attitude, p.y, p.radius, p.slope);
    const Number miss = (o.y - rail_y) * along_y + (o.z - rail_z) * along_z;
    const double bent = p.dy.value * p.ddz.value - p.dz.value * p.ddy.value;
    const double theta = attitude.e2.value * bent / (p.dy.value * p.dy.value * o.cosine.value);
    const double st = o.sin_theta.value, ct = o.cos_theta.value;
    const double tx = p.dz.value * st + p.radius.value * ct * theta,
                 tz = p.dz.value * ct - p.radius.value * st * theta;
    const auto advance = [&](int i) {
      return R[i][0].value * tx + R[i][1].value * p.dy.value + R[i][2].value * tz;
    };
    const double slope = advance(1) * along_y.value + advance(2) * along_z.value;
    for (std::size_t d = 0; d < place_inputs; ++d) u.d[d] = -miss.d[d] / slope;
  }

  const OnProfile p = on_profile(curve, k, u);
  const OutlinePlace<Number> o = outline_place<Number>(pose, attitude, p.y, p.radius, p.slope);
  const Number bent = p.dy * p.ddz - p.dz * p.ddy;
  const Number meridian = bent * p.per_speed * p.per_speed * p.per_speed;
  const Number &st = o.sin_theta, &ct = o.cos_theta;
  const Number nx = p.uy * st, nz = p.uy * ct;
  const Number wheel_ny = R[1][0] * nx - R[1][1] * p.uz + R[1][2] * nz;
  const Number wheel_nz = R[2][0] * nx - R[2][1] * p.uz + R[2][2] * nz;
  const Number overlap = (o.z - rail_z) * along_y - (o.y - rail_y) * along_z;
  const Number cosine = wheel_nz * along_y - wheel_ny * along_z;
  const Number half = root(larger(0.5 * (1.0 + cosine), Number(0.1)));
  const Number cos_chi = R[0][0] * ct - R[0][2] * st, cos2 = cos_chi * cos_chi;
  OverlapSlopes s;
  s.curvature = (cos2 * p.uy / p.radius - (1.0 - cos2) * meridian) / half;
  s.depth = overlap * cosine / (half * half);
  s.centre = o.x;
  s.ny = 0.5 * (wheel_ny - along_z) / half;
  s.nz = 0.5 * (wheel_nz + along_y) / half;
  s.wy = o.y;
  s.wz = o.z;
  s.y_wheel = p.y;
  return s;
}

}  // namespace wrc
