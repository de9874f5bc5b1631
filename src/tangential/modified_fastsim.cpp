#include "tangential/modified_fastsim.hpp"

#include <algorithm>
#include <cmath>

#include "patch/material.hpp"
#include "tangential/fastsim_eql.hpp"

namespace wrc {

TangentialForces modified_fastsim(const RollingContact& contact, const TangentialFields& fields,
                                  Fault& fault) {
  constexpr double least_force = 1e-9;  // [N]: where nothing resists, the slope does not matter
  Fault reported;                       // the same fault comes from the flexibilities below
  const double c11 = contact.linear_theory->ellipse().at(contact.a / contact.b, reported).c11;
  const Creepage& c = contact.creepage;
  const double with_spin = c.lateral + c.spin * contact.a;
  const double lateral = std::max(std::fabs(with_spin), std::fabs(c.lateral));
  const double slip = std::sqrt(c.longitudinal * c.longitudinal + lateral * lateral);
  const double limit = contact.friction.mean * normal_force(contact.region);
  const double eps =
      contact.shear_modulus * pi * contact.a * contact.b * c11 * slip / (4.0 * std::max(limit, least_force));
  RollingContact softened = contact;
  const double fallen = contact.slope.limit + (1.0 - contact.slope.limit) / (1.0 + contact.slope.rate * eps);
  softened.shear_modulus *= fallen;
  softened.slope_reduction *= fallen;
  return fastsim_eql(softened, fields, fault);
}

}  // namespace wrc
