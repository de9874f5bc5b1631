#include "geometry/silhouette.hpp"

#include <algorithm>
#include <cmath>

#include "elementary.hpp"

namespace wrc {
namespace {

Fault check_bound(const char* field, double value, const char* unit, double bound, const char* cause) {
  if (std::abs(value) <= bound) return {};
  Fault fault{.field = field, .value = value, .unit = unit, .low = -bound, .high = bound, .cause = cause};
  fault.status = std::isfinite(value) ? WRC_ERROR_RANGE : WRC_ERROR_NOT_FINITE;
  return fault;
}

}  // namespace

Fault check(const Pose& pose) {
  Fault fault;
  worsen(fault, check_bound("pose.lateral", pose.lateral, "m", 0.2, "did you pass millimetres?"));
  worsen(fault, check_bound("pose.vertical", pose.vertical, "m", 0.2, "did you pass millimetres?"));
  worsen(fault, check_bound("pose.roll", pose.roll, "rad", 0.3, "did you pass degrees?"));
  worsen(fault, check_bound("pose.yaw", pose.yaw, "rad", 0.3, "did you pass degrees?"));
  return fault;
}

Attitude attitude(const Pose& pose) {
  const auto [sy, cy] = sine_cosine(pose.yaw);
  const auto [sr, cr] = sine_cosine(pose.roll);
  Attitude a{{{cy, -sy * cr, sy * sr}, {sy, cy * cr, -cy * sr}, {0.0, sr, cr}}};
  // e = R^T x_track is the first row of R.
  const double in_plane = std::sqrt(a.r[0][0] * a.r[0][0] + a.r[0][2] * a.r[0][2]);
  a.e1_unit = a.r[0][0] / in_plane;
  a.e3_unit = a.r[0][2] / in_plane;
  a.e2_ratio = a.r[0][1] / in_plane;
  return a;
}

PosedWheel posed(const Wheel& wheel, const Pose& pose) {
  return {&wheel, attitude(pose), pose.lateral, pose.vertical - wheel.nominal_radius};
}

OutlinePoint outline(const PosedWheel& posed_wheel, double s, std::int32_t& piece) {
  const Attitude& a = posed_wheel.attitude;
  const ProfilePoint profile = evaluate(posed_wheel.wheel->profile, s, piece);
  OutlinePoint p;
  p.radius = posed_wheel.wheel->nominal_radius + profile.z;
  p.slope = profile.slope;
  p.second = profile.second;

  // sin(theta + alpha) = e2_ratio r', (cos(alpha), sin(alpha)) = (e1_unit, e3_unit). An outline exists while
  // the tangent stays below 1 / yaw; steeper (no contact there) the cosine is held off zero.
  const double sine = std::clamp(a.e2_ratio * profile.slope, -0.999, 0.999);
  const double cosine = std::sqrt(1.0 - sine * sine);
  p.sin_theta = sine * a.e1_unit - cosine * a.e3_unit;
  p.cos_theta = cosine * a.e1_unit + sine * a.e3_unit;

  const double px = p.radius * p.sin_theta, pz = p.radius * p.cos_theta;
  p.x = a.r[0][0] * px + a.r[0][1] * s + a.r[0][2] * pz;
  p.y = a.r[1][0] * px + a.r[1][1] * s + a.r[1][2] * pz + posed_wheel.centre_y;
  p.z = a.r[2][0] * px + a.r[2][1] * s + a.r[2][2] * pz + posed_wheel.centre_z;
  p.normal_y = a.r[1][0] * p.sin_theta - a.r[1][1] * profile.slope + a.r[1][2] * p.cos_theta;
  p.normal_z = a.r[2][0] * p.sin_theta - a.r[2][1] * profile.slope + a.r[2][2] * p.cos_theta;

  const double theta_s = a.e2_ratio * profile.second / cosine;
  const double tx = profile.slope * p.sin_theta + p.radius * p.cos_theta * theta_s;
  const double tz = profile.slope * p.cos_theta - p.radius * p.sin_theta * theta_s;
  p.dy_ds = a.r[1][0] * tx + a.r[1][1] + a.r[1][2] * tz;
  return p;
}

double longitudinal_curvature(const PosedWheel& posed_wheel, const OutlinePoint& point, double cosine,
                              double sine) {
  const Attitude& a = posed_wheel.attitude;
  const double cos_chi = a.r[0][0] * point.cos_theta - a.r[0][2] * point.sin_theta;
  const double cos2 = cos_chi * cos_chi;
  const double normal = cosine * point.normal_z - sine * point.normal_y;
  return (cos2 / point.radius - (1.0 - cos2) * point.second / (1.0 + point.slope * point.slope)) / normal;
}

}  // namespace wrc
