// FASTSIM and FaStrip of strips with slips and coefficients of their own.
//
// A strip of FASTSIM that sticks carries 2 l^2 / L11 per slip and width where linear theory has
// 2 G C11 l / pi; so its flexibilities are
//     L11 = pi l / (G C11),  L22 = pi l / (G C22),  L23 = 8 l / (9 G C23'),   C23' = C23 sqrt(b/a),
// with which every strip, not only the patch, has the forces of linear theory.

#include <algorithm>
#include <cmath>

#include "kernels/kernels.hpp"
#include "patch/material.hpp"
#include "surface/rolling/layered_strips.hpp"
#include "surface/rolling/rolling_arrays.hpp"
#include "tangential/methods/fastrip_strip.hpp"
#include "tangential/methods/flexibility_form.hpp"

namespace wrc::surface {
namespace {

/// Slips that make tractions: along x the part that neighbours share, plus the local part times gain.
tangential::Creepage slips_of(const SurfaceRollingInput& in, const RollingArrays& a, std::int32_t j) {
  return {a.mean[RollingArrays::slip][j] + a.own[j], in.slip_y[j], in.spin[j]};
}

/// Flexibilities [m/Pa] of a strip as above. l13 plays no part: slip along x has the spin of each strip in
/// it.
theory::Flexibility flexibility_of(double G, double l, const RollingArrays& a, std::int32_t j) {
  theory::Flexibility L{pi * l / (G * a.c11[j]), 0.0, pi * l / (G * a.c22[j]),
                        8.0 * l / (9.0 * G * a.c23[j])};
  L.l13 = L.l11;
  return L;
}

/// Bound at a strip's middle over mu p: parabola and semi-ellipse of one area.
constexpr double of_peak(bool parabolic) { return parabolic ? 3.0 * pi / 8.0 : 1.0; }

/// A strip of FASTSIM with a layer, whose flexibility adds to each.
tangential::LayeredStripAt<double> layered_strip_of_springs(const SurfaceRollingInput& in,
                                                            const RollingArrays& a, std::int32_t j) {
  using Of = tangential::LayeredNumbers;
  const tangential::Layer layer = layer_of(in, j);
  const double l = std::max(in.half_length[j], least_strip_length), F = layer.flexibility;
  const tangential::Creepage slips = slips_of(in, a, j);
  const theory::Flexibility L = flexibility_of(in.shear_modulus, l, a, j);
  tangential::LayeredStripAt<double> strip{};
  strip.bound = a.load[j] > 0.0 ? of_peak(in.parabolic) * in.friction[j] * in.peak[j] : 0.0;
  auto& n = strip.numbers.of;
  n[Of::stick_x] = n[Of::slip_x] = slips.longitudinal;
  n[Of::stick_y] = n[Of::slip_y] = slips.lateral;
  n[Of::stick_turn] = n[Of::slip_turn] = slips.spin * l * (L.l22 + F) / (L.l23 + F);
  n[Of::spring_x] = (L.l11 + F) * strip.bound / l;
  n[Of::spring_y] = (L.l22 + F) * strip.bound / l;
  set_yield(layer, 1.0, l, strip);
  return strip;
}

/// FASTSIM over all strips; `joint`: with the common flexibility in place of the separate ones.
SurfaceRollingTotals march(const SurfaceRollingInput& in, const RollingArrays& a, bool joint,
                           const tangential::TangentialFields& fields, const SurfaceRollingForces& forces) {
  const double G = in.shear_modulus;
  const bool parabolic = in.parabolic && !joint;
  for (std::int32_t j = 0; j < in.count; ++j) {
    const double l = std::max(in.half_length[j], least_strip_length);
    const tangential::Creepage slips = slips_of(in, a, j);
    theory::Flexibility L = flexibility_of(G, l, a, j);
    if (joint) {
      const double common = tangential::common_flexibility(L, l, l, 0.0, slips);
      L = {common, common, common, common};
    }
    // Growth of adhesion tractions (nu_x / L11, nu_y / L22 + phi x / L23) over bound / l, at the leading edge
    // x = l, and its fall along the strip; flexibilities as slip per traction of the size of the bound.
    const double bound = a.load[j] > 0.0 ? of_peak(parabolic) * in.friction[j] * in.peak[j] : 0.0;
    const double scale = bound > 0.0 ? l / bound : 0.0, turn = slips.spin * l / L.l23;
    a.bound[j] = bound;
    a.growth_x[j] = slips.longitudinal / L.l11 * scale;
    a.growth_y[j] = (slips.lateral / L.l22 + turn) * scale;
    a.curvature[j] = turn * scale;
    a.turn_x[j] = L.l11 * bound / l;
    a.turn_y[j] = L.l22 * bound / l;
  }
  auto task = surface_task<simd::SurfaceMarchTask>(in, a, fields, forces);
  task.parabolic = parabolic;
  if (parabolic) task.shape = &in.grid->parabolic;
  task.rate = a.curvature;
  task.soft_x = a.turn_x;
  task.soft_y = a.turn_y;
  const Kernels& kernels = *in.grid->kernels;
  return run(fields.any() ? kernels.tangential.surface_march_fields : kernels.tangential.surface_march, task);
}

}  // namespace

SurfaceRollingTotals roll_by_fastsim(const SurfaceRollingInput& in, const RollingArrays& a,
                                     const tangential::TangentialFields& fields,
                                     const SurfaceRollingForces& forces) {
  if (!in.layered()) return march(in, a, false, fields, forces);
  return roll_layered(in, in.parabolic, fields, forces,
                      [&](std::int32_t j) { return layered_strip_of_springs(in, a, j); });
}

SurfaceRollingTotals roll_by_fastrip(const SurfaceRollingInput& in, const RollingArrays& a,
                                     const tangential::TangentialFields& fields,
                                     const SurfaceRollingForces& forces) {
  constexpr double least_stress = 1e-6;  // [Pa]: strips without friction or pressure slip
  // FASTSIM's tractions with the common flexibility: directions of slip, of strips that slip in part or as a
  // whole alike. roll_strip() reads them cell by cell where it then writes its own.
  march(in, a, true, {fields.traction_x, fields.traction_y, nullptr, nullptr}, forces);
  const tangential::SlipDirections directions{fields.traction_x, fields.traction_y, fields.traction_x,
                                              fields.traction_y};
  const double G = in.shear_modulus;
  tangential::RolledStrip total;
  double balance = 0.0;  // power of the forces over the rolling speed [N]
  for (std::int32_t j = 0; j < in.count; ++j) {
    // closed form of the strip, about its own middle: growth of strip theory [Pa] against t' = mu p / l
    // [Pa/m]
    const double l = std::max(in.half_length[j], least_strip_length);
    const tangential::Creepage slips = slips_of(in, a, j);
    const tangential::StripGrowth growth{2.0 * G * a.c11[j] / (pi * pi) * slips.longitudinal, 0.0,
                                         2.0 * G * a.c22[j] / (pi * pi) * slips.lateral,
                                         3.0 * G * a.c23[j] / (2.0 * pi) * slips.spin, 1.0};
    const tangential::StripSolution strip =
        tangential::solve_strip(growth, std::max(a.bound[j], least_stress) / l, 0.0, 0.0, l);
    const tangential::Creepage rigid{in.slip_x[j], in.slip_y[j], in.spin[j]};
    const tangential::RolledStrip rolled = tangential::roll_strip(
        {l, in.width[j], 0.0, 0.0, a.bound[j], rigid}, strip, *in.grid, directions, in.count, j, fields);
    forces.fx[j] = rolled.fx;
    forces.fy[j] = rolled.fy;
    forces.mz[j] = rolled.mz;
    balance -= rolled.fx * rigid.longitudinal + rolled.fy * rigid.lateral + rolled.mz * rigid.spin;
    total += rolled;
  }
  // Carter's form of slip, scaled to dissipate the power of forces and rigid slips
  balance = std::max(0.0, balance);
  const std::ptrdiff_t cells = static_cast<std::ptrdiff_t>(in.count) * in.grid->cells;
  tangential::scale_slips(total.power > 0.0 ? balance / total.power : 0.0, cells, fields);
  return {balance, total.adhesion_fraction()};
}

}  // namespace wrc::surface
