#include "tangential/fastrip.hpp"

#include <algorithm>
#include <cmath>

#include "patch/material.hpp"
#include "tangential/fastrip_strip.hpp"
#include "tangential/flexibility_form.hpp"
#include "tangential/march.hpp"

namespace wrc {
namespace {

StripGrowth growth_on_ellipse(const RollingContact& contact, Fault& fault) {
  const KalkerCoefficients k = contact.linear_theory->ellipse().at(contact.a / contact.b, fault);
  const Creepage& creep = contact.creepage;
  const double G = contact.shear_modulus, c = std::sqrt(contact.a * contact.b);
  const double spin = 3.0 * G * c * k.c23 / (2.0 * pi * contact.a) * creep.spin;
  const double weight = 1.0 - contact.linear_theory->poisson();
  return {2.0 * G * k.c11 / (pi * pi) * creep.longitudinal, spin / weight,
          2.0 * G * k.c22 / (pi * pi) * creep.lateral, spin, weight};
}

StripGrowth growth_on_sdec(const RollingContact& contact, Fault& fault) {
  const double a = contact.a, b = contact.b;
  const SdecCoefficients s = contact.linear_theory->at(a / b, contact.shape_number, fault);
  const Creepage& creep = contact.creepage;
  const double G = contact.shear_modulus, c = std::sqrt(a * b);
  return {2.0 * G * s.c11 / (pi * pi) * creep.longitudinal,
          3.0 * G * c * c * c * s.k13 / (4.0 * pi * a * b * b) * creep.spin,
          2.0 * G * s.c22 / (pi * pi) * creep.lateral, 3.0 * G * c * s.c23 / (2.0 * pi * a) * creep.spin,
          1.0};
}

/// FASTSIM's part: traction bound and flexibilities.
struct Directions {
  Flexibility separate;
  double common = 0.0;  ///< where a strip slips as a whole
  TractionBound bound = TractionBound::elliptic;
  double load_factor = 1.0;
};

TangentialForces solve(const RollingContact& contact, const StripGrowth& growth, const Directions& directions,
                       const TangentialFields& fields) {
  const StripFriction friction{contact.friction.mean * directions.load_factor, contact.friction.shares};
  TangentialProblem problem{contact.region, contact.creepage, directions.separate, friction,
                            directions.bound};
  march(problem, *contact.grid, {fields.traction_x, fields.traction_y, nullptr, nullptr});
  const double l = directions.common;
  problem.flexibility = {l, l, l, l};
  march(problem, *contact.grid, {fields.slip_x, fields.slip_y, nullptr, nullptr});

  constexpr double least_stress = 1e-6;  // [Pa]: strips without friction or pressure slip
  const Strips& strips = contact.region;
  RolledStrip total;
  for (std::int32_t j = 0; j < strips.count; ++j) {
    const double bound = contact.friction[j] * strips.peak[j];
    const double steepness = std::max(bound, least_stress) / strips.half_length[j];
    const StripSolution strip =
        solve_strip(growth, steepness, strips.y[j], strips.centre[j], strips.half_length[j]);
    const SlidingStrip sliding{strips.half_length[j], strips.width[j], strips.centre[j],
                               strips.y[j],           bound,           contact.creepage};
    total += roll_strip(sliding, strip, *contact.grid, strips.count, j, fields);
  }
  const Creepage& c = contact.creepage;
  const double balance =
      std::max(0.0, -(total.fx * c.longitudinal + total.fy * c.lateral + total.mz * c.spin));
  const double scale = total.power > 0.0 ? balance / total.power : 0.0;
  const std::ptrdiff_t cells = static_cast<std::ptrdiff_t>(strips.count) * contact.grid->cells;
  for (double* slip : {fields.slip_x, fields.slip_y}) {
    std::transform(slip, slip + cells, slip, [scale](double s) { return s * scale; });
  }
  return {total.fx, total.fy, total.mz, balance, total.adhesion_fraction()};
}

Directions on_ellipse(const RollingContact& contact, Fault& fault) {
  const Flexibility separate = ellipse_flexibility(contact.a, contact.b, contact.shear_modulus,
                                                   contact.linear_theory->ellipse(), fault);
  return {separate, common_flexibility(separate, contact.a, contact.b, 0.0, contact.creepage),
          TractionBound::elliptic, 1.0};
}

}  // namespace

TangentialForces fastrip(const RollingContact& contact, const TangentialFields& fields, Fault& fault) {
  Directions directions = on_ellipse(contact, fault);
  directions.bound = TractionBound::parabolic;
  const double slender = std::max(0.0, 1.0 - contact.a / contact.b);
  directions.load_factor = 1.0 + slender * slender * slender * slender;
  return solve(contact, growth_on_ellipse(contact, fault), directions, fields);
}

TangentialForces fastrip_modified(const RollingContact& contact, const TangentialFields& fields,
                                  Fault& fault) {
  return solve(contact, growth_on_ellipse(contact, fault), on_ellipse(contact, fault), fields);
}

TangentialForces fastrip_sdec(const RollingContact& contact, const TangentialFields& fields, Fault& fault) {
  const Flexibility separate = sdec_flexibility(contact.a, contact.b, contact.shape_number,
                                                contact.shear_modulus, *contact.linear_theory, fault);
  const double common =
      common_flexibility(separate, contact.a, contact.b, contact.shape_number, contact.creepage);
  return solve(contact, growth_on_sdec(contact, fault), {separate, common, TractionBound::elliptic, 1.0},
               fields);
}

}  // namespace wrc
