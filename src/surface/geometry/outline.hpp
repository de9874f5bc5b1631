/// The outline of a posed wheel, seen along the track: one point for each place on its profile, and the
/// overlap of a strip whose ray ends there (overlap.hpp).
///
/// Number is a pack of strips in the kernels (simd/outline_kernel.hpp, whose units may not share functions of
/// plain numbers with others), a double, or a number that carries derivatives.
#pragma once

#include "base/in_loop.hpp"
#include "base/number.hpp"
#include "surface/geometry/overlap.hpp"

namespace wrc::surface {

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

/// From the wheel's reference point, rail axes.
template <class Number>
struct OutlinePlace {
  Number x, y, z;  ///< [m]
  Number sine, cosine, sin_theta, cos_theta;
};

/// The outline at the profile's point (y, radius) with the slope dr/dy.
template <class OfPose, class OfProfile, class Number = decltype(OfPose() * OfProfile())>
WRC_IN_LOOP OutlinePlace<Number> outline_place(const RelativePoseOf<OfPose>& pose,
                                               const OutlineAttitudeOf<OfPose>& a, const OfProfile& y,
                                               const OfProfile& radius, const OfProfile& slope) {
  const auto& R = pose.rotation;
  OutlinePlace<Number> o;
  // theta from e1 sin(theta) + e3 cos(theta) = e2 r' / Y', whose right side is sine
  o.sine = smaller(larger(a.e2 * slope, Number(-steepest_sine)), Number(steepest_sine));
  o.cosine = root(1.0 - o.sine * o.sine);
  o.sin_theta = o.sine * a.e1 - o.cosine * a.e3;
  o.cos_theta = o.cosine * a.e1 + o.sine * a.e3;
  // R p(theta)
  const Number px = radius * o.sin_theta, pz = radius * o.cos_theta;
  o.x = R[0][0] * px + R[0][1] * y + R[0][2] * pz;
  o.y = R[1][0] * px + R[1][1] * y + R[1][2] * pz;
  o.z = R[2][0] * px + R[2][1] * y + R[2][2] * pz;
  return o;
}

/// A piece of the wheel's curve, by its coefficients: plain numbers, or one piece per lane of a pack.
/// The identifier that clang-tidy 14 finds is its own, of the loop by which arrays are copied.
template <class Coefficient>
struct PieceOf {  // NOLINT(bugprone-reserved-identifier)
  Coefficient y[4], z[4];
};

/// The wheel's profile at a length u [m] on one of its pieces.
template <class Number>
struct OnProfile {
  Number y, radius;         ///< [m]
  Number dy, dz, ddy, ddz;  ///< derivatives by the curve's parameter
  Number uy, uz;            ///< unit tangent
  Number per_speed, slope;  ///< 1 / |(dy, dz)|; dr/dy
};

template <class Number, class Coefficient>
WRC_IN_LOOP OnProfile<Number> on_profile(const PieceOf<Coefficient>& c, const Number& u) {
  OnProfile<Number> p;
  p.y = c.y[0] + u * (c.y[1] + u * (c.y[2] + u * c.y[3]));
  p.radius = c.z[0] + u * (c.z[1] + u * (c.z[2] + u * c.z[3]));
  p.dy = c.y[1] + u * (2.0 * c.y[2] + 3.0 * u * c.y[3]);
  p.dz = c.z[1] + u * (2.0 * c.z[2] + 3.0 * u * c.z[3]);
  p.ddy = 2.0 * c.y[2] + 6.0 * u * c.y[3];
  p.ddz = 2.0 * c.z[2] + 6.0 * u * c.z[3];
  p.per_speed = Number(1.0) / root(p.dy * p.dy + p.dz * p.dz);
  p.uy = p.dy * p.per_speed;
  p.uz = p.dz * p.per_speed;
  p.slope = p.uz / larger(p.uy, Number(least_advance));
  return p;
}

/// Derivatives (dy, dz) of the outline by the curve's parameter, rail axes.
template <class Number>
struct OutlineSlope {
  Number y, z;
};

template <class Number, class OfPose>
WRC_IN_LOOP OutlineSlope<Number> outline_slope(const RelativePoseOf<OfPose>& pose,
                                               const OutlineAttitudeOf<OfPose>& a, const OnProfile<Number>& p,
                                               const OutlinePlace<Number>& o) {
  const auto& R = pose.rotation;
  // d theta / d u: cosine theta' = e2 (r' / Y')', and (r' / Y')' = (Y' r'' - r' Y'') / Y'^2
  const Number bent = p.dy * p.ddz - p.dz * p.ddy;
  const Number turned = a.e2 * bent / (larger(p.dy * p.dy, Number(1e-8)) * o.cosine);
  // R p', p = (r sin(theta), Y, r cos(theta))
  const Number tx = p.dz * o.sin_theta + p.radius * o.cos_theta * turned;
  const Number tz = p.dz * o.cos_theta - p.radius * o.sin_theta * turned;
  return {R[1][0] * tx + R[1][1] * p.dy + R[1][2] * tz, R[2][0] * tx + R[2][1] * p.dy + R[2][2] * tz};
}

/// The ray of a strip: the strip's middle from the wheel's reference point [m], and its unit tangent; rail
/// axes.
template <class Number, class Tangent = Number>
struct StripRay {
  Number y, z;
  Tangent ty, tz;
};

/// Distance along the strip's tangent from its ray to a point of the outline [m].
template <class Number, class Tangent>
WRC_IN_LOOP Number ray_miss(const StripRay<Number, Tangent>& ray, const OutlinePlace<Number>& o) {
  return (o.y - ray.y) * ray.ty + (o.z - ray.z) * ray.tz;
}

/// The overlap of a strip whose ray ends at a place of the outline; `facing`: cosine between both surfaces'
/// normals. Its grade is left alone.
template <class Number>
struct RayOverlap {
  StripOverlap<Number> strip;
  Number facing;
};

template <class Number, class Tangent, class OfPose>
WRC_IN_LOOP RayOverlap<Number> ray_overlap(const RelativePoseOf<OfPose>& pose,
                                           const StripRay<Number, Tangent>& ray, const OnProfile<Number>& p,
                                           const OutlinePlace<Number>& o) {
  const auto& R = pose.rotation;
  // normal of the wheel, R (Y' sin(theta), -r', Y' cos(theta)), whose x is zero on the outline
  const Number nx = p.uy * o.sin_theta, nz = p.uy * o.cos_theta;
  const Number wheel_ny = R[1][0] * nx - R[1][1] * p.uz + R[1][2] * nz;
  const Number wheel_nz = R[2][0] * nx - R[2][1] * p.uz + R[2][2] * nz;
  // overlap along the rail's normal (-tz, ty), taken over to the mean of both normals, which lies half the
  // angle between them from either; both unit normals add up to 2 half times the mean one
  const Number overlap = (o.z - ray.z) * ray.ty - (o.y - ray.y) * ray.tz;
  const Number cosine = wheel_nz * ray.ty - wheel_ny * ray.tz;
  const Number half = root(larger(0.5 * (1.0 + cosine), Number(0.1)));
  // Euler's formula: the track's direction lies at chi to the wheel's circle, of curvature uy / r, and at
  // 90 degrees - chi to its profile
  const Number bent = p.dy * p.ddz - p.dz * p.ddy;
  const Number meridian = bent * p.per_speed * p.per_speed * p.per_speed;
  const Number cos_chi = R[0][0] * o.cos_theta - R[0][2] * o.sin_theta, cos2 = cos_chi * cos_chi;
  RayOverlap<Number> r;
  r.strip.curvature = (cos2 * p.uy / p.radius - (1.0 - cos2) * meridian) / half;
  r.strip.depth = overlap * cosine / (half * half);
  r.strip.centre = o.x;
  r.strip.ny = 0.5 * (wheel_ny - ray.tz) / half;
  r.strip.nz = 0.5 * (wheel_nz + ray.ty) / half;
  r.strip.wy = o.y;
  r.strip.wz = o.z;
  r.facing = cosine;
  return r;
}

}  // namespace wrc::surface
