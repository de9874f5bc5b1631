/// The separation of the true surfaces of wheel and rail over the contact plane. The parabolas of
/// gap_rows.hpp expand it. Not real-time code.
///
/// Contact frame of gap_rows.hpp; the separation is measured along the contact normal, at fixed x and y. The
/// plane x = const cuts the wheel, the surface of revolution p of silhouette.hpp, in a curve with the profile
/// coordinate s as its parameter: with e = R^T x_track and (e1, e3) = sqrt(e1^2 + e3^2) (cos(alpha),
/// sin(alpha))
///     x = e . p   =>   q = r sin(theta + alpha) = (x - e2 s) / sqrt(e1^2 + e3^2),
///                      w = r cos(theta + alpha) = sqrt(r^2 - q^2),
/// so that Newton's method looks for s alone. Without roll y is linear in s on that curve: a section does not
/// fold where the outline does, and no second derivative of the profile comes in.
///
/// Rows leave this out: under yaw psi the surface at distance x from the outline belongs to s - psi x of the
/// profile. Where the curvature of the profile steps (ends of arcs), that of the surface steps along a line
/// y - psi x = const, but centre and curvature of the rows step at one y for all x: far ahead or behind their
/// parabolas leave a ridge there that no wheel has.
#pragma once

#include "geometry/contact_search.hpp"
#include "geometry/placement.hpp"
#include "geometry/silhouette.hpp"

namespace wrc::geometry {

/// Wheel and rail as seen from a contact point.
struct SurfaceGap {
  Rail rail;
  PosedWheel wheel;
  ContactPoint contact;

  /// Separation at (x, y) of the contact frame [m]. Beyond the end of a profile its end tangent continues; so
  /// does the tangent of a surface from where it is inclined to the contact plane by 80 degrees. Beyond a
  /// quarter of the wheel's radius along x, centimetres above the rail, the separation grows linearly.
  double at(double x, double y) const;
};

}  // namespace wrc::geometry
