#include "tangential/march/march.hpp"

#include "base/elementary.hpp"
#include "kernels/kernels.hpp"
#include "patch/strips.hpp"
#include "tangential/simd/sensitivities.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc {
namespace {

/// Bound at the middle of each strip, as the factors of a common part and of what differs between strips.
struct BoundScale {
  double per_pressure = 0.0;       ///< elliptic: mu
  double per_length = 0.0;         ///< ellipsoidal: mu N / IInt sqrt(x_l^2 - x^2) dA
  double per_length_square = 0.0;  ///< parabolic: mu N / IInt (x_l^2 - x^2) dA
};

BoundScale bound_scale(const TangentialProblem& problem) {
  if (problem.bound == TractionBound::elliptic) return {.per_pressure = problem.friction.mean};
  const bool parabolic = problem.bound == TractionBound::parabolic;
  double integral = 0.0;
  const Strips& strips = problem.region;
  for (std::int32_t j = 0; j < strips.count; ++j) {
    const double l = strips.half_length[j];
    integral += parabolic ? 4.0 / 3.0 * l * l * l * strips.width[j] : 0.5 * pi * l * l * strips.width[j];
  }
  const double scale = integral > 0.0 ? problem.friction.mean * normal_force(strips) / integral : 0.0;
  return parabolic ? BoundScale{.per_length_square = scale} : BoundScale{.per_length = scale};
}

/// The problem for the kernels; it points into its arguments.
simd::MarchTask task_of(const TangentialProblem& problem, const MarchGrid& grid,
                        const TangentialFields& fields) {
  const Creepage& c = problem.creepage;
  const Flexibility& L = problem.flexibility;
  const BoundScale scale = bound_scale(problem);
  simd::MarchTask task{};
  task.strips = problem.region.count;
  task.cells = grid.cells;
  task.parabolic = problem.bound == TractionBound::parabolic;
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
  task.per_pressure = scale.per_pressure;
  task.per_length = scale.per_length;
  task.per_length_square = scale.per_length_square;
  return task;
}

TangentialForces forces_of(const simd::Sums& sums) {
  return {sums.fx, sums.fy, sums.mz, sums.power_per_speed,
          sums.area > 0.0 ? 1.0 - sums.slid_area / sums.area : 0.0};
}

}  // namespace

TangentialForces march(const TangentialProblem& problem, const MarchGrid& grid,
                       const TangentialFields& fields, TangentialSensitivities* sensitivities) {
  simd::Sums sums;
  const simd::MarchTask task = task_of(problem, grid, fields);
  const Kernels& kernels = *grid.kernels;
  const auto kernel = sensitivities  ? kernels.tangential.march_sensitivities
                      : fields.any() ? kernels.tangential.march_fields
                                     : kernels.tangential.march;
  kernel(task, sums);
  if (sensitivities)
    *sensitivities =
        sensitivities_of(sums, problem.creepage, problem.friction.mean, normal_force(problem.region));
  return forces_of(sums);
}

}  // namespace wrc
