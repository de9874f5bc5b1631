/// The outline of a posed wheel, seen along the track: one point for each place on its profile (overlap.hpp).
#pragma once

#include "base/in_loop.hpp"
#include "base/number.hpp"
#include "surface/geometry/overlap.hpp"

namespace wrc {

/// e = R^T x_track over sqrt(e1^2 + e3^2).
template <class Number>
struct OutlineAttitudeOf {
  Number e1, e2, e3;
};
using OutlineAttitude = OutlineAttitudeOf<double>;

template <class Number>
OutlineAttitudeOf<Number> attitude_of(const RelativePoseOf<Number>& pose) {
  const Number e1 = pose.rotation[0][0], e2 = pose.rotation[0][1], e3 = pose.rotation[0][2];
  const Number inverse = Number(1.0) / root(e1 * e1 + e3 * e3);
  return {e1 * inverse, e2 * inverse, e3 * inverse};
}

/// Steep faces of a yawed wheel have no outline: sin(theta + alpha) would pass one. Faces that turn back have
/// none.
inline constexpr double steepest_sine = 0.98, least_advance = 1e-3;

/// A chord of the outline between two knots lies at most this far from it [m].
inline constexpr double chord_sagitta = 30e-6;

/// From the wheel's reference point, rail axes. Number is double, or a pack of them.
template <class Number>
struct OutlinePlace {
  Number x, y, z;  ///< [m]
  Number sine, cosine, sin_theta, cos_theta;
};

/// The outline at the profile's point (y, radius) with the slope dr/dy.
template <class Number, class OfPose>
WRC_IN_LOOP OutlinePlace<Number> outline_place(const RelativePoseOf<OfPose>& pose,
                                               const OutlineAttitudeOf<OfPose>& a, const Number& y,
                                               const Number& radius, const Number& slope) {
  const auto& R = pose.rotation;
  OutlinePlace<Number> o;
  o.sine = smaller(larger(a.e2 * slope, Number(-steepest_sine)), Number(steepest_sine));
  o.cosine = root(1.0 - o.sine * o.sine);
  o.sin_theta = o.sine * a.e1 - o.cosine * a.e3;
  o.cos_theta = o.cosine * a.e1 + o.sine * a.e3;
  const Number px = radius * o.sin_theta, pz = radius * o.cos_theta;
  o.x = R[0][0] * px + R[0][1] * y + R[0][2] * pz;
  o.y = R[1][0] * px + R[1][1] * y + R[1][2] * pz;
  o.z = R[2][0] * px + R[2][1] * y + R[2][2] * pz;
  return o;
}

}  // namespace wrc
