#include "geometry/surface_gap.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace wrc::geometry {
namespace {

/// A point of a plane section and its derivatives by the curve's own parameter.
struct SectionPoint {
  double y = 0.0, z = 0.0;  ///< [m]
  double dy = 1.0, dz = 0.0;
};

/// From track axes to the contact frame.
SectionPoint turned(const SectionPoint& track, const ContactPoint& contact) {
  const double c = contact.cosine, s = contact.sine;
  const double y = track.y - contact.y, z = track.z - contact.z;
  return {c * y + s * z, c * z - s * y, c * track.dy + s * track.dz, c * track.dz - s * track.dy};
}

/// The wheel cut at x of the track, at profile coordinate s.
SectionPoint wheel_section(const PosedWheel& wheel, double x, double s, std::int32_t& piece) {
  constexpr double least_depth = 1e-3;  // depth of the point below the axle [m]: the root stays real
  const Attitude& a = wheel.attitude;
  const ProfilePoint profile = evaluate(wheel.wheel->profile, s, piece);
  const double r = wheel.wheel->nominal_radius + profile.z;
  const double in_plane = std::sqrt(a.r[0][0] * a.r[0][0] + a.r[0][2] * a.r[0][2]);
  const double q = (x - a.r[0][1] * s) / in_plane;
  const double w = std::sqrt(std::max(r * r - q * q, least_depth * least_depth));
  const double dq = -a.e2_ratio;
  const double dw = (r * profile.slope - q * dq) / w;
  // Wheelset axes: (q, w) turned back by alpha.
  const double px = q * a.e1_unit - w * a.e3_unit, pz = q * a.e3_unit + w * a.e1_unit;
  const double dx = dq * a.e1_unit - dw * a.e3_unit, dz = dq * a.e3_unit + dw * a.e1_unit;
  return {a.r[1][0] * px + a.r[1][1] * s + a.r[1][2] * pz + wheel.centre_y,
          a.r[2][0] * px + a.r[2][1] * s + a.r[2][2] * pz + wheel.centre_z,
          a.r[1][0] * dx + a.r[1][1] + a.r[1][2] * dz, a.r[2][0] * dx + a.r[2][1] + a.r[2][2] * dz};
}

/// Height of a curve at y of the contact frame, walking there from its parameter t: Newton's method in steps
/// short enough to stay on the part of the curve that faces the contact plane.
template <class Curve>
double height_at(const Curve& curve, double t, double y) {
  constexpr int cap = 200;
  constexpr double longest_step = 1e-3;        // [m]
  constexpr double tolerance = 1e-9;           // last step [m]; the tangent leaves less than 1e-14 m
  constexpr double least_cotangent = 0.17633;  // 80 degrees
  SectionPoint p;
  for (int i = 0; i < cap; ++i) {
    p = curve(t);
    if (p.dy < least_cotangent * std::abs(p.dz)) break;
    const double step = (y - p.y) / p.dy;
    if (std::abs(step) <= tolerance) break;
    t += std::clamp(step, -longest_step, longest_step);
  }
  return p.z + p.dz / std::max(p.dy, least_cotangent * std::abs(p.dz)) * (y - p.y);
}

}  // namespace

double SurfaceGap::at(double x, double y) const {
  const double quarter = 0.25 * wheel.wheel->nominal_radius;
  const double inside = std::clamp(x, -quarter, quarter);
  std::int32_t rail_piece = piece_at(rail.profile, contact.y);
  std::int32_t wheel_piece = piece_at(wheel.wheel->profile, contact.wheel_s);
  const auto rail_at = [&](double t) {
    const ProfilePoint p = evaluate(rail.profile, t, rail_piece);
    return turned({t, p.z, 1.0, p.slope}, contact);
  };
  const auto wheel_at = [&](double s) {
    SectionPoint p = wheel_section(wheel, contact.x + inside, s, wheel_piece);
    p.z += contact.vertical_gap;  // brought into touch
    return turned(p, contact);
  };
  return height_at(rail_at, contact.y, y) - height_at(wheel_at, contact.wheel_s, y) +
         0.25 * std::abs(x - inside);
}

}  // namespace wrc::geometry
