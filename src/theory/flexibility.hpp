/// Flexibility parameters of the simplified theory, from the coefficients of linear theory.
#pragma once

#include "base/fault.hpp"
#include "theory/sdec.hpp"

namespace wrc::theory {

/// Flexibility parameters [m/Pa]. Tractions of full adhesion are
///     p_x = (nu_x / l11 - phi y / l13) (x - x_l),
///     p_y = nu_y (x - x_l) / l22 + phi (x^2 - x_l^2) / (2 l23),
/// x_l the leading edge (Liu, Bruni 2024, eq. 6). Kalker's FASTSIM is l11 = L1, l22 = L2, l13 = l23 = L3.
struct Flexibility {
  double l11 = 0.0, l13 = 0.0, l22 = 0.0, l23 = 0.0;
};

/// Kalker's L1 = 8a/(3 G C11), L2 = 8a/(3 G C22), L3 = pi a sqrt(a/b)/(4 G C23) of an ellipse with semi-axes
/// a (rolling direction) and b [m], shear modulus G [Pa].
Flexibility ellipse_flexibility(double a, double b, double shear_modulus, const KalkerTable& table,
                                Fault& fault);

/// L11 = 8a/(3 G C11s), L13 = 2c/(G K13), L22 = 8a/(3 G C22s), L23 = pi a^2/(4 G c C23s) of a single
/// double-elliptical contact (Liu, Bruni 2024, eq. 8, with C13s = -K13 psi). psi = 0 does not give Kalker's
/// three parameters back: l13 and l23 stay different.
Flexibility sdec_flexibility(double a, double b, double shape_number, double shear_modulus,
                             const SdecTable& table, Fault& fault);

}  // namespace wrc::theory
