/// Linear theory (full adhesion) of elliptic patches without a grid.
///
/// Galin's theorem: tractions P / sqrt(1 - (x/a)^2 - (y/b)^2) with a polynomial P displace the ellipse by
/// polynomials of the same degree. Steady rolling without slip prescribes du/dx, so leaves one function of y
/// open for each of u_x, u_y; their Legendre coefficients are found from Kalker's condition (1967): no
/// traction where particles enter, i.e. P = 0 on the leading half of the border. All integrals are in closed
/// form but one over the directions of the plane.
#pragma once

#include "linear_theory/linear_coefficients.hpp"

namespace wrc::halfspace {

/// Of the ellipse with a/b = axis_ratio, the two open functions being polynomials of this degree. Degree 40
/// is good to 5e-5 for a/b from 0.05 to 20; c23 = -c32 holds only for the exact solution, so their sum shows
/// the error.
LinearCoefficients ellipse_linear_coefficients(double axis_ratio, double poisson, int degree);

}  // namespace wrc::halfspace
