/// Derivatives of the tangential stage, found on a copy of the contact's state.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "contact/stages.hpp"

namespace wrc::contact {
namespace {

/// A copy of the contact in the memory behind it, over its cells: a contact holds no pointer into itself.
Contact& copy_of(Contact& contact) {
  const std::size_t bytes = state_bytes(*contact.model);
  void* const behind = reinterpret_cast<char*>(&contact) + bytes;
  std::memcpy(behind, static_cast<const void*>(&contact), bytes);
  return *static_cast<Contact*>(behind);
}

/// A law whose coefficients are all larger by a factor.
void scale(Friction& friction, Contact& contact, double factor) {
  friction.law.coefficient *= factor;
  for (std::int32_t k = 0; k < friction.law.zones.count; ++k) contact.zone_coefficient[k] *= factor;
}

/// Refuses contacts that remember their tractions: their derivatives would be those of a history.
Fault check_steady(const Contact& contact) {
  if (!contact.model->options.non_steady) return {};
  return Fault::unsupported("config.planar.non_steady",
                            "derivatives are those of steady rolling: use a model without it");
}

/// Central differences of the tangential stage. Steps are a thousandth of the creepages, or of those that
/// saturate friction by linear theory (C about 4) where these are larger. Load and friction act through
/// their product, so that one difference serves both.
Fault difference_tangential(Contact& contact, tangential::TangentialSensitivities& sensitivities) {
  // Size of the creepages [-]: the largest component, spin times c = sqrt(a b), or mu N / (C G c^2).
  constexpr double relative_step = 1e-3, linear_coefficient = 4.0;
  const Patch& main = contact.patch[contact.main_patch];
  const double c2 = main.sdec.a * main.sdec.b, c = std::sqrt(c2);
  const double saturating = contact.friction * contact.extent.normal_force /
                            (linear_coefficient * contact.model->options.material.shear_modulus * c2);
  const tangential::Creepage& creep = contact.creepage;
  const double size =
      std::max({std::abs(creep.longitudinal), std::abs(creep.lateral), std::abs(creep.spin) * c, saturating});
  const double h = relative_step * size;
  // mu by which the derivative counts: the caller's coefficient, which scales the whole law, or the mean of
  // zones.
  const double coefficient = contact.law.law.zones.count > 0 ? contact.friction : contact.law.law.coefficient;

  // Inputs: longitudinal, lateral, spin, and mu N by a common factor.
  Fault fault;
  for (int input = 0; input < 4; ++input) {
    const double step = input == 2 ? h / c : input == 3 ? relative_step : h;
    double ends[2][3];
    for (int end = 0; end < 2; ++end) {
      const double change = end == 0 ? -step : step;
      Contact& copy = copy_of(contact);
      tangential::Creepage creepage = creep;
      Friction friction = friction_of(copy);
      if (input == 0) creepage.longitudinal += change;
      if (input == 1) creepage.lateral += change;
      if (input == 2) creepage.spin += change;
      if (input == 3) scale(friction, copy, 1.0 + change);
      keep_worst(fault, solve_tangential(copy, creepage, friction, contact.rolling));
      ends[end][0] = copy.forces.fx;
      ends[end][1] = copy.forces.fy;
      ends[end][2] = copy.forces.mz;
    }
    // dF/dnu; of the factor k on mu N: dF/dN = (dF/dk) / N and dF/dmu = (dF/dk) / mu.
    for (int r = 0; r < 3; ++r) {
      const double slope = (ends[1][r] - ends[0][r]) / (2.0 * step);
      if (input < 3) {
        sensitivities.d[r][input] = slope;
      } else {
        sensitivities.d[r][3] = slope / contact.extent.normal_force;
        sensitivities.d[r][4] = coefficient > 0.0 ? slope / coefficient : 0.0;
      }
    }
  }
  return fault;
}

}  // namespace

Fault find_sensitivities(Contact& contact, tangential::TangentialSensitivities& sensitivities) {
  sensitivities = {};
  if (const Fault fault = check_steady(contact); fault.failed()) return fault;
  if (contact.reached < Stage::tangential) {
    return Fault::sequence("forces", "call wrc_planar_tangential first");
  }
  if (!contact.touching) return Fault::no_contact();
  Fault fault;
  if (differentiates(contact)) {
    Contact& copy = copy_of(contact);
    fault = solve_tangential(copy, contact.creepage, friction_of(copy), contact.rolling, &sensitivities);
  } else {
    fault = difference_tangential(contact, sensitivities);
  }
  cells_known(contact) = 0.0;
  return fault;
}

}  // namespace wrc::contact
