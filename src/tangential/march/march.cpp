#include "tangential/march/march.hpp"

#include "base/elementary.hpp"
#include "kernels/kernels.hpp"
#include "patch/strips.hpp"
#include "tangential/layer/layered_rolling.hpp"
#include "tangential/simd/sums.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc::tangential {
namespace {

/// Sets the bound at the middle of a strip, mu times its peak pressure, or a scale times its half length or
/// the square of that: mu N over the integral of the bound's form over all strips, 4/3 l^3 or pi/2 l^2 per
/// width.
void set_bound(const TangentialProblem& problem, simd::MarchTask& task) {
  task.parabolic = problem.bound == TractionBound::parabolic;
  if (problem.bound == TractionBound::elliptic) {
    task.per_pressure = problem.friction.mean;
    return;
  }
  double integral = 0.0;
  const patch::Strips& strips = problem.region;
  for (std::int32_t j = 0; j < strips.count; ++j) {
    const double l = strips.half_length[j];
    integral += task.parabolic ? 4.0 / 3.0 * l * l * l * strips.width[j] : 0.5 * pi * l * l * strips.width[j];
  }
  const double scale = integral > 0.0 ? problem.friction.mean * patch::normal_force(strips) / integral : 0.0;
  (task.parabolic ? task.per_length_square : task.per_length) = scale;
}

/// The problem for the kernels; it points into its arguments.
simd::MarchTask task_of(const TangentialProblem& problem, const MarchGrid& grid,
                        const TangentialFields& fields) {
  // growths g_x = nu_x / L11 - phi y / L13 and g_y = nu_y / L22 + phi x / L23 [Pa/m], with their derivatives
  // by nu_x, nu_y, phi
  const Creepage& c = problem.creepage;
  const theory::Flexibility& L = problem.flexibility;
  simd::MarchTask task{};
  task.strips = problem.region.count;
  task.cells = grid.cells;
  task.shape = &grid.shape(problem.bound);
  task.fields = &fields;
  task.region = &problem.region;
  task.shares = problem.friction.shares;
  task.gx_constant = {c.longitudinal / L.l11, {1.0 / L.l11, 0.0, 0.0}};
  task.gx_by_y = {c.spin / L.l13, {0.0, 0.0, 1.0 / L.l13}};
  task.gy_constant = {c.lateral / L.l22, {0.0, 1.0 / L.l22, 0.0}};
  task.gy_by_x = {c.spin / L.l23, {0.0, 0.0, 1.0 / L.l23}};
  task.l11 = L.l11;
  task.l22 = L.l22;
  set_bound(problem, task);
  return task;
}

/// The strips of a problem with a layer, from creepages and a factor on tau_0 that may carry derivatives.
/// Flexibilities of bodies and layer add; all are springs, each creepage over its own.
template <class Number>
LayeredStripAt<Number> layered_strip(const TangentialProblem& problem, const simd::MarchTask& task,
                                     const LayeredInputs<Number>& in, std::int32_t j) {
  const patch::Strips& strips = problem.region;
  const theory::Flexibility& L = problem.flexibility;
  const double l = strips.half_length[j], F = problem.layer.flexibility, l11 = L.l11 + F, l22 = L.l22 + F;
  LayeredStripAt<Number> strip;
  const double bound = problem.friction.share(j) * (task.per_pressure * strips.peak[j] +
                                                    (task.per_length + task.per_length_square * l) * l);
  strip.bound = bound;
  using Of = LayeredNumbers;
  auto& n = strip.numbers.of;
  const double lateral = l22 / (L.l23 + F), per_length = bound / l;
  n[Of::stick_x] = in.longitudinal - (strips.y[j] * l11 / (L.l13 + F)) * in.spin;
  n[Of::stick_y] = in.lateral + (strips.centre[j] * lateral) * in.spin;
  n[Of::stick_turn] = (l * lateral) * in.spin;
  n[Of::slip_x] = n[Of::stick_x];
  n[Of::slip_y] = n[Of::stick_y];
  n[Of::slip_turn] = n[Of::stick_turn];
  n[Of::bodies_x] = n[Of::bodies_y] = n[Of::turn_x] = n[Of::turn_y] = 0.0;
  n[Of::spring_x] = l11 * per_length;
  n[Of::spring_y] = l22 * per_length;
  set_yield(problem.layer, in.yield, l, strip);
  return strip;
}

/// The march with a layer.
TangentialForces march_layered(const TangentialProblem& problem, const simd::MarchTask& task,
                               const MarchGrid& grid, const TangentialFields& fields,
                               TangentialSensitivities* sensitivities) {
  return roll_layered(
      {problem.region, problem.creepage, problem.friction.mean, *task.shape, grid}, fields, sensitivities,
      [&](const auto& inputs, std::int32_t j) { return layered_strip(problem, task, inputs, j); });
}

}  // namespace

TangentialForces march(const TangentialProblem& problem, const MarchGrid& grid,
                       const TangentialFields& fields, TangentialSensitivities* sensitivities) {
  simd::Sums sums;
  const simd::MarchTask task = task_of(problem, grid, fields);
  if (problem.layer.present()) return march_layered(problem, task, grid, fields, sensitivities);
  const Kernels& kernels = *grid.kernels;
  // a kernel of its own for each kind of result: no field or derivative costs calls that do not ask for it
  const auto kernel = sensitivities  ? kernels.tangential.march_sensitivities
                      : fields.any() ? kernels.tangential.march_fields
                                     : kernels.tangential.march;
  kernel(task, sums);
  if (sensitivities)
    *sensitivities =
        sensitivities_of(sums, problem.creepage, problem.friction.mean, patch::normal_force(problem.region));
  return forces_of(sums);
}

}  // namespace wrc::tangential
