/// Linear theory (full adhesion) of SDEC patches: Kalker's creepage coefficients and their shape-number
/// dependence, computed from the half-space equations, extrapolated in the grid, with an error estimate for
/// each.
///
/// Each half of the patch is divided into equally many equal strips along x and each strip into equally many cells of its own length,
/// so that leading and trailing edges are met exactly and the discretisation error is a smooth function of
/// the number of cells (on a common rectangular grid the staircase border makes it jump). Collocation as in
/// tangential.hpp, quarter_point; a dense system, unknowns 2 strips cells.
#pragma once

#include "halfspace/pressure.hpp"

namespace wrc::halfspace {

/// F_x = -G c^2 c11 nu_x - G c^3 c13 phi,  F_y = -G c^2 c22 nu_y - G c^3 c23 phi,
/// M_z = -G c^3 (c31 nu_x + c32 nu_y) - G c^4 c33 phi,  c = sqrt(a b), about the joint of the half ellipses.
struct LinearCoefficients {
  double c11 = 0.0, c22 = 0.0, c13 = 0.0, c23 = 0.0, c31 = 0.0, c32 = 0.0, c33 = 0.0;
};

/// Of the patch with a/b = axis_ratio on `strips` (even) strips of `cells` cells each. Memory: 32 (strips cells)^2
/// bytes, 34 MB for 32 x 32.
LinearCoefficients linear_coefficients(double axis_ratio, double psi, double poisson, int strips, int cells);

struct ExtrapolatedCoefficients {
  LinearCoefficients value;
  LinearCoefficients error;  ///< estimate, from linear extrapolations of two of the three divisions
};

/// Extrapolated from n = finest/2, 3/4 finest and finest with error terms 1/n and 1/n^2; finest divisible
/// by 4.
ExtrapolatedCoefficients extrapolated_coefficients(double axis_ratio, double psi, double poisson, int finest);

}  // namespace wrc::halfspace
