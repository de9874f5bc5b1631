#include "geometry/silhouette.hpp"

#include <cmath>

#include "base/elementary.hpp"

namespace wrc::geometry {

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
  return outline_at(posed_wheel, s, evaluate(posed_wheel.wheel->profile, s, piece));
}

}  // namespace wrc::geometry
