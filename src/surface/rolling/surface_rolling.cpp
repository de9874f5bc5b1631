#include "surface/rolling/surface_rolling.hpp"

#include "kernels/kernels.hpp"
#include "surface/rolling/layered_strips.hpp"
#include "surface/rolling/rolling_arrays.hpp"
#include "surface/rolling/strip_numbers.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::surface {
namespace {

/// Access to the numbers of one strip in the arrays (strip_numbers.hpp).
struct EachStrip {
  using Number = double;
  using Still = double;
  using OneStrip = EachStrip;
  std::int32_t strip;

  double get(const double* of) const { return of[strip]; }
  double still(const double* of) const { return of[strip]; }
  void put(double* of, double x) const { of[strip] = x; }
};

/// Spread of the slip over the strips, for fields: the factor of methods/slip_across.hpp in place of one over
/// the size of forces. The march has the distance from the contact's middle by means over neighbours, which
/// at the sides lie near the strip itself: 0.73 for 0.9 of a circle's half width. By means of means it is
/// 0.86. Unlike means over all strips they do not jump where two contacts meet.
void spread_slip(const SurfaceRollingInput& in, const RollingArrays& a) {
  using Mean = RollingMeans;
  constexpr int times = 2;
  double *const middle = a.mean[Mean::location], *const variance = a.mean[Mean::variance];
  for (int n = 1; n < times; ++n) {
    for (std::int32_t j = 0; j < in.count; ++j) middle[j] *= a.load[j];
    strip_numbers::take_means<EachStrip, Mean::location, Mean::location, Mean::location + 1>(in.count, a);
  }
  for (std::int32_t j = 0; j < in.count; ++j) {
    const double off = in.place[j] - middle[j];
    variance[j] = off * off;
  }
  for (int n = 0; n < times; ++n) {
    for (std::int32_t j = 0; j < in.count; ++j) variance[j] *= a.load[j];
    strip_numbers::take_means<EachStrip, Mean::variance, Mean::variance, Mean::variance + 1>(in.count, a);
  }
  // 1 at the border of an ellipse, whose load has a fifth of its squared half width as variance
  for (std::int32_t j = 0; j < in.count; ++j) {
    const double across =
        (in.place[j] - middle[j]) / root(5.0 * larger(variance[j], strip_numbers::least_variance));
    const double u = strip_numbers::held_slenderness(a.mean[Mean::slender][j]), size = a.across[j];
    const tangential::SlipAcross<double> spread(u, a.mean[Mean::longitudinal][j] * size,
                                                a.mean[Mean::lateral][j] * size,
                                                a.mean[Mean::spin][j] * size);
    a.across[j] = spread.at(across);
  }
}

SurfaceRollingTotals roll_by_strip_fastsim(const SurfaceRollingInput& in, const RollingArrays& a,
                                           const tangential::TangentialFields& fields,
                                           const SurfaceRollingForces& forces) {
  auto task = surface_task<simd::SurfaceStripsTask>(in, a, fields, forces);
  task.inverse_weight = in.grid->inverse_weight;
  // slips that drive the march: rigid ones plus torsion and twist; and how they turn the traction
  task.curvature = a.curvature;
  task.slip_x = a.slip_x;
  task.slip_y = a.slip_y;
  task.spin = in.spin;
  task.elastic = a.elastic;
  task.turn_x = a.turn_x;
  task.turn_y = a.turn_y;
  task.edge_x = a.edge_x;
  task.edge_y = a.edge_y;
  task.across = a.across;
  task.beside = a.beside;
  // power is force times rigid slip: elastic slip from the tractions beside takes none
  task.rigid_x = in.slip_x;
  task.rigid_y = in.slip_y;
  const Kernels& kernels = *in.grid->kernels;
  if (fields.any()) spread_slip(in, a);
  return run(fields.any() ? kernels.tangential.surface_strips_fields : kernels.tangential.surface_strips,
             task);
}

}  // namespace

std::size_t surface_rolling_workspace(std::int32_t capacity) {
  return static_cast<std::size_t>(rolling_doubles<double>(capacity));
}

SurfaceRollingTotals roll_on_surface(const SurfaceRollingInput& in, void* workspace,
                                     const tangential::TangentialFields& fields,
                                     const SurfaceRollingForces& forces) {
  Arena arena(workspace);
  const RollingArrays a = cut_rolling_arrays<double>(arena, in.count, in.count);
  const strip_numbers::Shared shared = strip_numbers::shared(in);
  // Loads, coefficients and means serve all methods; the rest of the arrays strip FASTSIM alone.
  in.grid->kernels->surface.strip_numbers(
      {&in, &shared, &a, in.method == SurfaceRollingMethod::strip_fastsim});
  switch (in.method) {
    case SurfaceRollingMethod::strip_fastsim:
      break;
    case SurfaceRollingMethod::fastsim:
      return roll_by_fastsim(in, a, fields, forces);
    case SurfaceRollingMethod::fastrip:
      return roll_by_fastrip(in, a, fields, forces);
  }
  if (in.layered())
    return roll_layered(in, false, fields, forces,
                        [&](std::int32_t j) { return layered_strip(in, a, layer_of(in, j), j); });
  return roll_by_strip_fastsim(in, a, fields, forces);
}

}  // namespace wrc::surface
