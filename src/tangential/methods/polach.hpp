/// Polach's force law (VSD 33 supplement (1999) 728-739, the code "ADH"; Wear 258 (2005) 992-1000): total
/// creep forces on an ellipse.
///
/// Traction grows along the patch by a gradient eps until it meets the bound. With c = sqrt(a b),
///
///     s_yc = s_y + phi a, or s_y where that is larger in magnitude,   s_c = sqrt(s_x^2 + s_yc^2),
///     C = sqrt((C11 s_x)^2 + (C22 s_y)^2) / sqrt(s_x^2 + s_y^2),   eps = G pi a b C s_c / (4 mu N),
///     F = (2 mu N / pi) (k_A eps / (1 + (k_A eps)^2) + atan(k_S eps)),          k_S <= k_A <= 1,
///     F_x = -F s_x / s_c,   F_y = -(F s_y + F_spin) / s_c.
///
/// Spin: K = 1 + 6.3 (1 - exp(-a/b)), eps_s = (8/3) G b c C23 |s_yc| / (K mu N), and with
/// delta = (eps_s^2 - 1) / (eps_s^2 + 1)
///
///     F_spin = phi (9/16) a mu N K (eps_s (-delta^3/3 + delta^2/2 - 1/6) + (1 - delta^2)^(3/2) / 3).
///
/// The bracket is computed as (2/3) eps_s / (1 + eps_s^2)^2, which loses no digits. At small creepages
/// without spin the forces are Kalker's times (k_A + k_S) / 2. The force of spin is not reduced. The part
/// that sticks is 1 / (1 + (k_A eps)^2) of each line along x. Friction falls with one sliding speed of the
/// patch.
///
/// Own: M_z = F_spin s_y / (phi s_c), which tends to Kalker's moment of lateral creepage; Polach gives no
/// moment. Without it F_spin against lateral slip would add power. With it the power is
/// F (s_x^2 + s_y^2) / s_c >= 0. With reduced factors, and spin against lateral slip, the force would pass
/// mu N by up to 28 %. Force, moment and power are then multiplied by one ratio. Theory manual, section 5.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "tangential/force_table/force_table.hpp"
#include "tangential/rolling_contact.hpp"

namespace wrc::tangential {

/// Forces of the equivalent ellipse. Slips are those at the centre of its load, where the forces act; where
/// psi = 0 that is the contact point. Friction of strips is their mean over the load.
inline TangentialForces polach(const RollingContact& contact, Fault& fault) {
  const theory::KalkerCoefficients k = contact.linear_theory->ellipse().at(contact.a / contact.b, fault);
  const double centre = pressure_centre({contact.a, contact.b, contact.shape_number});
  const Creepage slip = seen_from(centre, contact.creepage);
  const double a = contact.a, b = contact.b, G = contact.shear_modulus;
  const double limit = contact.friction.mean * contact.normal_force;
  if (!(limit > 0.0)) return {};

  // slips s_yc, s_c and s [-]
  const double lateral = std::max(std::abs(slip.lateral), std::abs(slip.lateral + slip.spin * a));
  const double combined = std::sqrt(slip.longitudinal * slip.longitudinal + lateral * lateral);
  const double translation = std::sqrt(slip.longitudinal * slip.longitudinal + slip.lateral * slip.lateral);
  if (!(combined > 0.0)) return {.adhesion_fraction = 1.0};

  // force of both translations, from the gradient of traction over its bound [N]
  double gradient = 0.0;
  if (translation > 0.0) {
    const double x = k.c11 * slip.longitudinal / translation, y = k.c22 * slip.lateral / translation;
    gradient = G * pi * a * b * std::sqrt(x * x + y * y) * combined / (4.0 * limit);
  }
  const double sticks = contact.reduction.adhesion * gradient, slides = contact.reduction.slip * gradient;
  const double force = 2.0 * limit / pi * (sticks / (1.0 + sticks * sticks) + arctangent(slides));

  // lateral force of spin times s_c, over phi [N m]; exp(-690) is negligible
  constexpr double most_slender = 690.0;
  const double K = 1.0 + 6.3 * (1.0 - natural_exp(-std::min(a / b, most_slender)));
  const double spinning = 8.0 / 3.0 * G * b * std::sqrt(a * b) * k.c23 * lateral / (K * limit);
  const double falls = 1.0 + spinning * spinning;
  const double per_spin = 3.0 / 8.0 * a * limit * K * (spinning / falls / falls);

  // both forces against the slips, limited to mu N [N]
  const double x = force * slip.longitudinal / combined;
  const double y = (force * slip.lateral + per_spin * slip.spin) / combined;
  const double size = std::sqrt(x * x + y * y), cut = size > limit ? limit / size : 1.0;
  TangentialForces forces{.fx = -cut * x,
                          .fy = -cut * y,
                          .mz = cut * per_spin * slip.lateral / combined,
                          .power_per_speed = cut * force * translation * (translation / combined),
                          .adhesion_fraction = 1.0 / (1.0 + sticks * sticks)};
  refer_back(centre, forces, nullptr);
  return forces;
}

}  // namespace wrc::tangential
