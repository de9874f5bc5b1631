/// Hertz's elliptic contact: pure theory, for all normal methods.
#pragma once

namespace wrc::normal {

/// Contact of two bodies whose undeformed gap is h = A x^2 + B y^2; all members follow from A / B.
///
/// With the approach delta, A a^2 = eps_x delta and B b^2 = eps_y delta, and exactly eps_x + eps_y = 1: the
/// gap's own section at the approach (eps = 1) is larger than the contact, and no single eps gives its shape.
struct HertzShape {
  double axis_ratio = 1.0;  ///< a / b [-]
  double eps_x = 0.5;       ///< A a^2 / delta [-]
  double eps_y = 0.5;       ///< B b^2 / delta [-]
  double centre = 0.0;  ///< u_z(centre) / (normal_compliance p0 sqrt(a b)), = pi sqrt(minor / major) K [-]
};

/// Solves Hertz's transcendental equation for the axis ratio. `curvature_ratio` = A / B, clamped to
/// 1e-8..1e8. Johnson, Contact Mechanics (1985), 4.2.
HertzShape hertz_shape(double curvature_ratio) noexcept;

/// The same from a table, to a millionth, at a tenth of the cost: for methods that need a shape per strip.
HertzShape tabulated_hertz_shape(double curvature_ratio) noexcept;

/// The ellipse under an approach.
struct HertzEllipse {
  double a = 0.0;             ///< semi-axis along x [m]
  double b = 0.0;             ///< semi-axis along y [m]
  double peak = 0.0;          ///< p0 [Pa]
  double normal_force = 0.0;  ///< (2/3) pi a b p0 [N]
};

/// Hertz contact for gap coefficients A, B [1/m], approach [m] >= 0 and the pair's normal compliance [1/Pa]
/// (patch/material.hpp); `shape` is that of A / B, if known already.
HertzEllipse hertz_ellipse(const HertzShape& shape, double coefficient_x, double approach,
                           double normal_compliance) noexcept;
HertzEllipse hertz_ellipse(double coefficient_x, double coefficient_y, double approach,
                           double normal_compliance) noexcept;

}  // namespace wrc::normal
