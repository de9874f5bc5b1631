/// The wheelset's pose and the silhouette of its wheels along the track. With it wheel/rail contact
/// geometry is a problem between two plane curves, exactly.
///
/// The rail is a cylinder along the track's x axis, so only the outline of the wheel seen along x matters:
/// the points of the wheel whose surface normal is perpendicular to x. The wheel is the surface of revolution
///     p(s, theta) = (r(s) sin(theta), s, r(s) cos(theta)),   r = nominal radius + profile z,
/// in the wheelset frame (s lateral, theta = 0 at the bottom), with normal n ~ (sin(theta), -r', cos(theta)).
/// With e = R^T x_track the condition e . n = 0 reads
///     e1 sin(theta) + e3 cos(theta) = e2 r'(s),
/// solved in closed form: one outline point per lateral position s. For zero yaw it is theta = 0, the wheel's
/// profile; with yaw psi the contact locus leaves it by x ~ -r r' psi.
///
/// Two consequences used downstream, both exact:
///   - the tangent of the projected outline is perpendicular to the projected normal: dz/dy = -N_y / N_z,
///     N = R n;
///   - the separation at fixed contact-frame y is least on the outline, and its curvature there is the
///     wheel's normal curvature in direction x divided by the cosine between the surface normal and the
///     contact normal (Meusnier), see longitudinal_curvature().
#pragma once

#include <cstdint>

#include "base/fault.hpp"
#include "base/number.hpp"
#include "geometry/placement.hpp"
#include "geometry/profile.hpp"

namespace wrc::geometry {

/// Position of the wheelset in the track frame. Only the position relative to the rail counts: an
/// irregularity of one rail is entered by subtracting its displacement from `lateral` and `vertical` for that
/// wheel.
struct Pose {
  double lateral = 0.0;   ///< y of the wheelset's middle [m]
  double vertical = 0.0;  ///< downwards, 0: tape circle level with the top of the rail [m]
  double roll = 0.0;      ///< about the x axis turned by yaw, right wheel down positive [rad]
  double yaw = 0.0;       ///< about z (down), right-hand rule: right wheel back, left wheel forward [rad]
};

/// The rotation R = R_z(yaw) R_x(roll) from wheelset to track axes, worked out once per pose.
struct Attitude {
  double r[3][3];         ///< track = r * wheelset
  double e1_unit = 1.0;   ///< e1 / sqrt(e1^2 + e3^2)
  double e3_unit = 0.0;   ///< e3 / sqrt(e1^2 + e3^2)
  double e2_ratio = 0.0;  ///< e2 / sqrt(e1^2 + e3^2)
};
Attitude attitude(const Pose& pose);

/// One wheel of a wheelset in a pose.
struct PosedWheel {
  const Wheel* wheel = nullptr;
  Attitude attitude;
  double centre_y = 0.0, centre_z = 0.0;  ///< the wheelset's middle in the track frame [m]
};
PosedWheel posed(const Wheel& wheel, const Pose& pose);

/// A point of the outline, in the track frame.
template <class Number>
struct OutlinePointOf {
  Number x = 0.0, y = 0.0, z = 0.0;       ///< [m]
  Number normal_y = 0.0, normal_z = 1.0;  ///< normal N (not of unit length), out of the wheel; N_x = 0
  Number dy_ds = 1.0;  ///< derivative of y along the outline by the profile coordinate s [-]
  Number sin_theta = 0.0, cos_theta = 1.0;
  Number radius = 0.0;               ///< r(s) [m]
  Number slope = 0.0, second = 0.0;  ///< r'(s) [-], r''(s) [1/m]

  Number dz_dy() const { return -normal_y / normal_z; }
};
using OutlinePoint = OutlinePointOf<double>;

/// Outline point at wheelset-frame lateral position s; `piece` as in evaluate(). Where the wheel is hollow
/// (flange root) and the yaw so strong that r r'' yaw^2 > 1 (33 mrad for the S1002 at its steepest), the
/// outline folds back on itself: dy_ds < 0 there, and that part is hidden behind the rest of the wheel.
OutlinePoint outline(const PosedWheel& posed_wheel, double s, std::int32_t& piece);

/// The same from the point of the wheel's profile at s. Number is double, or a pack of them.
template <class Number>
OutlinePointOf<Number> outline_at(const PosedWheel& posed_wheel, const Number& s,
                                  const ProfilePointOf<Number>& profile) {
  const Attitude& a = posed_wheel.attitude;
  OutlinePointOf<Number> p;
  p.radius = posed_wheel.wheel->nominal_radius + profile.z;
  p.slope = profile.slope;
  p.second = profile.second;

  // sin(theta + alpha) = e2_ratio r', (cos(alpha), sin(alpha)) = (e1_unit, e3_unit). An outline exists while
  // the tangent stays below 1 / yaw; steeper (no contact there) the cosine is held off zero.
  const Number steepest = 0.999;
  const Number sine = larger(smaller(a.e2_ratio * profile.slope, steepest), -steepest);
  const Number cosine = root(1.0 - sine * sine);
  p.sin_theta = sine * a.e1_unit - cosine * a.e3_unit;
  p.cos_theta = cosine * a.e1_unit + sine * a.e3_unit;

  const Number px = p.radius * p.sin_theta, pz = p.radius * p.cos_theta;
  p.x = a.r[0][0] * px + a.r[0][1] * s + a.r[0][2] * pz;
  p.y = a.r[1][0] * px + a.r[1][1] * s + a.r[1][2] * pz + posed_wheel.centre_y;
  p.z = a.r[2][0] * px + a.r[2][1] * s + a.r[2][2] * pz + posed_wheel.centre_z;
  p.normal_y = a.r[1][0] * p.sin_theta - a.r[1][1] * profile.slope + a.r[1][2] * p.cos_theta;
  p.normal_z = a.r[2][0] * p.sin_theta - a.r[2][1] * profile.slope + a.r[2][2] * p.cos_theta;

  const Number theta_s = a.e2_ratio * profile.second / cosine;
  const Number tx = profile.slope * p.sin_theta + p.radius * p.cos_theta * theta_s;
  const Number tz = profile.slope * p.cos_theta - p.radius * p.sin_theta * theta_s;
  p.dy_ds = a.r[1][0] * tx + a.r[1][1] + a.r[1][2] * tz;
  return p;
}

/// d2h/dx2 [1/m] of the separation h measured along the contact normal of a frame inclined by (cosine, sine),
/// at fixed lateral position of that frame.
///     [ cos^2(chi) / r - sin^2(chi) r'' / (1 + r'^2) ] / (n_c . N)
/// with chi the angle between x and the wheel's parallel circle: the parallel's normal curvature cos(delta)/r
/// and the meridian's -r'' / (1 + r'^2)^(3/2) in Euler's formula; |N| = sqrt(1 + r'^2) cancels one cosine.
template <class Number>
Number longitudinal_curvature(const PosedWheel& posed_wheel, const OutlinePointOf<Number>& point,
                              double cosine, double sine) {
  const Attitude& a = posed_wheel.attitude;
  const Number cos_chi = a.r[0][0] * point.cos_theta - a.r[0][2] * point.sin_theta;
  const Number cos2 = cos_chi * cos_chi;
  const Number normal = cosine * point.normal_z - sine * point.normal_y;
  return (cos2 / point.radius - (1.0 - cos2) * point.second / (1.0 + point.slope * point.slope)) / normal;
}

}  // namespace wrc::geometry
