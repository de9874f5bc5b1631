#include "tangential/methods/fastrip.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/arena.hpp"
#include "patch/material.hpp"
#include "tangential/march/march.hpp"
#include "tangential/methods/fastrip_strip.hpp"
#include "tangential/methods/flexibility_form.hpp"

namespace wrc::tangential {
namespace {

StripGrowth growth_on_ellipse(const RollingContact& contact, Fault& fault) {
  // strip theory with Kalker's coefficients; k13 = 3 G c C23 / (2 pi a (1 - nu)), w = 1 - nu
  const theory::KalkerCoefficients k = contact.linear_theory->ellipse().at(contact.a / contact.b, fault);
  const Creepage& creep = contact.creepage;
  const double G = contact.shear_modulus, c = std::sqrt(contact.a * contact.b);
  const double spin = 3.0 * G * c * k.c23 / (2.0 * pi * contact.a) * creep.spin;
  const double weight = 1.0 - contact.linear_theory->poisson();
  return {2.0 * G * k.c11 / (pi * pi) * creep.longitudinal, spin / weight,
          2.0 * G * k.c22 / (pi * pi) * creep.lateral, spin, weight};
}

StripGrowth growth_on_sdec(const RollingContact& contact, Fault& fault) {
  // the double ellipse's: k13 = 3 G c^3 K13 / (4 pi a b^2), w = 1
  const double a = contact.a, b = contact.b;
  const theory::SdecCoefficients s = contact.linear_theory->at(a / b, contact.shape_number, fault);
  const Creepage& creep = contact.creepage;
  const double G = contact.shear_modulus, c = std::sqrt(a * b);
  return {2.0 * G * s.c11 / (pi * pi) * creep.longitudinal,
          3.0 * G * c * c * c * s.k13 / (4.0 * pi * a * b * b) * creep.spin,
          2.0 * G * s.c22 / (pi * pi) * creep.lateral, 3.0 * G * c * s.c23 / (2.0 * pi * a) * creep.spin,
          1.0};
}

/// Arrays of FASTSIM's tractions over cells.
std::array<double*, 4> cut(Arena& arena, std::int64_t cells) {
  std::array<double*, 4> arrays{};
  for (double*& array : arrays) array = arena.take(cells);
  return arrays;
}

/// FASTSIM's tractions with separate flexibilities, and with the common one, in the contact's workspace.
SlipDirections directions_of(const RollingContact& contact, Fault& fault) {
  const theory::Flexibility separate = linear_flexibility(contact, fault);
  const double common =
      common_flexibility(separate, contact.a, contact.b, contact.elastic_shape_number(), contact.creepage);
  TangentialProblem problem{contact.region, contact.creepage, separate, contact.friction,
                            TractionBound::elliptic};
  // on the equivalent ellipse, as published: the parabolic bound, of a load larger by 1 + (1 - a/b)^4 for a <
  // b
  if (contact.model.on_ellipse) {
    const double slender = std::max(0.0, 1.0 - contact.a / contact.b);
    problem.bound = TractionBound::parabolic;
    problem.friction.mean *= 1.0 + slender * slender * slender * slender;
  }
  Arena arena(contact.workspace);
  const auto [x, y, common_x, common_y] =
      cut(arena, static_cast<std::int64_t>(contact.region.count) * contact.grid->cells);
  march(problem, *contact.grid, {x, y, nullptr, nullptr});
  problem.flexibility = {common, common, common, common};
  march(problem, *contact.grid, {common_x, common_y, nullptr, nullptr});
  return {x, y, common_x, common_y};
}

TangentialForces solve(const RollingContact& contact, const StripGrowth& growth,
                       const SlipDirections& directions, const TangentialFields& fields) {
  // each strip in closed form where it sticks, along FASTSIM's direction where it slips
  constexpr double least_stress = 1e-6;  // [Pa]: strips without friction or pressure slip
  const patch::Strips& strips = contact.region;
  RolledStrip total;
  for (std::int32_t j = 0; j < strips.count; ++j) {
    const double bound = contact.friction[j] * strips.peak[j];
    const double steepness = std::max(bound, least_stress) / strips.half_length[j];
    const StripSolution strip =
        solve_strip(growth, steepness, strips.y[j], strips.centre[j], strips.half_length[j]);
    const SlidingStrip sliding{strips.half_length[j], strips.width[j], strips.centre[j],
                               strips.y[j],           bound,           contact.creepage};
    total += roll_strip(sliding, strip, *contact.grid, directions, strips.count, j, fields);
  }
  // power by the balance -(Fx nu_x + Fy nu_y + Mz phi), and slips scaled to dissipate it
  const Creepage& c = contact.creepage;
  const double balance =
      std::max(0.0, -(total.fx * c.longitudinal + total.fy * c.lateral + total.mz * c.spin));
  const double scale = total.power > 0.0 ? balance / total.power : 0.0;
  const std::ptrdiff_t cells = static_cast<std::ptrdiff_t>(strips.count) * contact.grid->cells;
  scale_slips(scale, cells, fields);
  return {total.fx, total.fy, total.mz, balance, total.adhesion_fraction()};
}

}  // namespace

std::int64_t fastrip_workspace(std::int32_t strips, std::int32_t cells) {
  Arena arena;
  cut(arena, static_cast<std::int64_t>(strips) * cells);
  return arena.bytes();
}

TangentialForces fastrip(const RollingContact& contact, const TangentialFields& fields, Fault& fault) {
  const SlipDirections directions = directions_of(contact, fault);
  const StripGrowth growth =
      contact.model.of_sdec ? growth_on_sdec(contact, fault) : growth_on_ellipse(contact, fault);
  return solve(contact, growth, directions, fields);
}

}  // namespace wrc::tangential
