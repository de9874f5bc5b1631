/// The coefficients of linear theory as the exact solvers give them.
#pragma once

namespace wrc::halfspace {

/// F_x = -G c^2 c11 nu_x - G c^3 c13 phi,  F_y = -G c^2 c22 nu_y - G c^3 c23 phi,
/// M_z = -G c^3 (c31 nu_x + c32 nu_y) - G c^4 c33 phi,  c = sqrt(a b), about the joint of the half ellipses.
struct LinearCoefficients {
  double c11 = 0.0, c22 = 0.0, c13 = 0.0, c23 = 0.0, c31 = 0.0, c32 = 0.0, c33 = 0.0;
};

}  // namespace wrc::halfspace
