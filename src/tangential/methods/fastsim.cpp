#include "tangential/methods/fastsim.hpp"

#include <algorithm>
#include <cmath>

#include "patch/material.hpp"
#include "tangential/march/march.hpp"
#include "tangential/methods/flexibility_form.hpp"

namespace wrc::tangential {
namespace {

/// C11 of the patch model's linear theory.
double longitudinal_coefficient(const RollingContact& contact, Fault& fault) {
  const double ratio = contact.a / contact.b;
  return contact.model.of_sdec ? contact.linear_theory->at(ratio, contact.shape_number, fault).c11
                               : contact.linear_theory->ellipse().at(ratio, fault).c11;
}

/// k / k0: factor on the slope of the creep curve by slip [-].
double slope_factor(const RollingContact& contact) {
  constexpr double least_force = 1e-9;  // [N]: where nothing resists, the slope does not matter
  Fault reported;                       // the same fault comes from the flexibilities
  // eps = G pi a b k0 C11 s / (4 mu N), s with the larger of nu_y and nu_y + phi a
  const double c11 = longitudinal_coefficient(contact, reported);
  const Creepage& c = contact.creepage;
  const double with_spin = c.lateral + c.spin * contact.a;
  const double lateral = std::max(std::fabs(with_spin), std::fabs(c.lateral));
  const double slip = std::sqrt(c.longitudinal * c.longitudinal + lateral * lateral);
  const double limit = contact.friction.mean * patch::normal_force(contact.region);
  const double eps =
      contact.shear_modulus * pi * contact.a * contact.b * c11 * slip / (4.0 * std::max(limit, least_force));
  return contact.slope.limit + (1.0 - contact.slope.limit) / (1.0 + contact.slope.rate * eps);
}

TangentialForces roll(const RollingContact& contact, const TangentialFields& fields, Fault& fault,
                      TangentialSensitivities* sensitivities) {
  const theory::Flexibility flexibility = in_form(linear_flexibility(contact, fault), contact);
  return march(
      {contact.region, contact.creepage, flexibility, contact.friction, contact.bound, contact.layer},
      *contact.grid, fields, sensitivities);
}

}  // namespace

TangentialForces fastsim(const RollingContact& contact, const TangentialFields& fields, Fault& fault,
                         TangentialSensitivities* sensitivities) {
  if (!contact.slope.falls()) return roll(contact, fields, fault, sensitivities);
  // every flexibility over k: all go with 1 / G
  RollingContact softened = contact;
  const double factor = slope_factor(contact);
  softened.shear_modulus *= factor;
  softened.slope_reduction *= factor;
  return roll(softened, fields, fault, sensitivities);
}

}  // namespace wrc::tangential
