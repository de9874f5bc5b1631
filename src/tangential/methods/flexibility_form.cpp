#include "tangential/methods/flexibility_form.hpp"

#include <algorithm>
#include <cmath>

#include "patch/material.hpp"

namespace wrc::tangential {
namespace {

/// The creepages nu_y and nu_x [-] that make, in full adhesion and with the same flexibilities, the forces
/// spin phi = 1 makes: from IInt (x - x_l) = -(8/3) a^2 b, IInt y (x - x_l) = -2 a^2 b^2 psi,
/// IInt (x^2 - x_l^2) / 2 = -(pi/4) a^3 b over a double ellipse.
double lateral_of_spin(double a) { return 3.0 * pi * a / 32.0; }
double longitudinal_of_spin(double b, double shape_number) { return 0.75 * b * shape_number; }

double square(double value) { return value * value; }

}  // namespace

double single_flexibility(const theory::Flexibility& separate, double a, double b, double shape_number,
                          const Creepage& creepage) {
  const double x = std::fabs(creepage.longitudinal), y = std::fabs(creepage.lateral);
  const double s = std::sqrt(a * b) * std::fabs(creepage.spin);
  const double size = std::sqrt(x * x + y * y + s * s);
  if (size == 0.0) return separate.l11;
  // L3: mean of L23 and L13, weighted as spin makes F_y and F_x through them
  const double across = lateral_of_spin(a), along = std::fabs(longitudinal_of_spin(b, shape_number));
  const double l3 = (across * separate.l23 + along * separate.l13) / (across + along);
  return (x * separate.l11 + y * separate.l22 + s * l3) / size;
}

double common_flexibility(const theory::Flexibility& separate, double a, double b, double shape_number,
                          const Creepage& creepage) {
  // L_c = sum n^2 / sum (n^2 / L), n = nu_x, nu_y, (3 pi a / 32) phi with L23, (3 b psi / 4) phi with L13
  const double x2 = square(creepage.longitudinal), y2 = square(creepage.lateral);
  const double across2 = square(lateral_of_spin(a) * creepage.spin);
  const double along2 = square(longitudinal_of_spin(b, shape_number) * creepage.spin);
  const double stiffness =
      x2 / separate.l11 + y2 / separate.l22 + across2 / separate.l23 + along2 / separate.l13;
  return stiffness > 0.0 ? (x2 + y2 + across2 + along2) / stiffness : separate.l11;
}

theory::Flexibility blended_flexibility(const theory::Flexibility& separate, double a, double b,
                                        double shape_number, const Creepage& creepage, double limit) {
  const double x2 = square(creepage.longitudinal), y2 = square(creepage.lateral);
  const double common = common_flexibility(separate, a, b, shape_number, creepage);
  // nu_i* = 3 mu N L_ii / (8 a^2 b) saturates the patch; w = min(1, f / 3)
  const double per_flexibility = 3.0 * limit / (8.0 * a * a * b);
  const double saturation2 = square(per_flexibility) * (square(separate.l11) + square(separate.l22));
  const double w = x2 + y2 < 9.0 * saturation2 ? std::sqrt((x2 + y2) / saturation2) / 3.0 : 1.0;
  const auto blend = [&](double own) { return (1.0 - w) * own + w * common; };
  return {blend(separate.l11), blend(separate.l13), blend(separate.l22), blend(separate.l23)};
}

theory::Flexibility linear_flexibility(const RollingContact& contact, Fault& fault) {
  return contact.model.of_sdec
             ? theory::sdec_flexibility(contact.a, contact.b, contact.shape_number, contact.shear_modulus,
                                        *contact.linear_theory, fault)
             : theory::ellipse_flexibility(contact.a, contact.b, contact.shear_modulus,
                                           contact.linear_theory->ellipse(), fault);
}

theory::Flexibility in_form(const theory::Flexibility& separate, const RollingContact& contact) {
  const double shape_number = contact.elastic_shape_number();
  switch (contact.form) {
    case FlexibilityForm::separate:
      break;
    case FlexibilityForm::single: {
      const double l = single_flexibility(separate, contact.a, contact.b, shape_number, contact.creepage);
      return {l, l, l, l};
    }
    case FlexibilityForm::blended:
      return blended_flexibility(
          separate, contact.a, contact.b, shape_number, contact.creepage,
          contact.slope_reduction * contact.friction.mean * patch::normal_force(contact.region));
  }
  return separate;
}

}  // namespace wrc::tangential
