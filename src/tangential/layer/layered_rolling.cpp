#include "tangential/layer/layered_rolling.hpp"

#include <algorithm>

#include "kernels/kernels.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc::tangential {

void march_block(const LayeredRun& run, std::int32_t first, std::int32_t count, LayeredBlock& block,
                 LayeredTotals& totals) {
  // the fields from the first strip on
  TangentialFields fields = run.fields;
  for (double** const field : {&fields.traction_x, &fields.traction_y, &fields.slip_x, &fields.slip_y})
    if (*field) *field += first;
  simd::LayeredMarchTask task{};
  task.strips = count;
  task.stride = run.strips;
  task.cells = run.grid.cells;
  task.shape = &run.shape;
  task.elastic = &run.grid.parabolic;
  task.fields = &fields;
  task.width = run.width + first;
  task.half_length = run.half_length + first;
  task.bound = block.bound;
  for (int n = 0; n < LayeredNumbers::numbers; ++n) task.numbers[n] = block.number[n];
  task.fx = block.fx;
  task.fy = block.fy;
  task.mz = block.mz;
  simd::Sums sums;
  const Kernels& kernels = *run.grid.kernels;
  (fields.any() ? kernels.tangential.layered_march_fields : kernels.tangential.layered_march)(task, sums);
  totals.power_per_speed += sums.power_per_speed;
  totals.area += sums.area;
  totals.slid_area += sums.slid_area;
}

double balanced_power(const LayeredRun& run, const LayeredTotals& totals, double work) {
  const double power = std::max(0.0, work), marched = totals.power_per_speed;
  scale_slips(marched > 0.0 ? power / marched : 0.0, static_cast<std::ptrdiff_t>(run.strips) * run.grid.cells,
              run.fields);
  return power;
}

void add_sensitivities(const LayeredPatch& patch, const LayeredStripAt<LayeredDual>& strip, std::int32_t j,
                       TangentialSensitivities& sums) {
  const patch::Strips& strips = patch.region;
  const LayeredSum<LayeredDual> sum = march_strip(strip.numbers, patch.shape, patch.grid);
  const double l = strips.half_length[j];
  const LayeredDual force = (l * strips.width[j]) * strip.bound, fx = force * sum.x, fy = force * sum.y;
  const LayeredDual mz = l * (force * sum.turn) + strips.centre[j] * fy - strips.y[j] * fx;
  const LayeredDual* const rows[] = {&fx, &fy, &mz};
  for (int r = 0; r < 3; ++r)
    for (int k = 0; k < 4; ++k) sums.d[r][k < 3 ? k : 4] += rows[r]->d[static_cast<std::size_t>(k)];
}

void finish(const LayeredPatch& patch, const TangentialForces& forces, TangentialSensitivities& sums) {
  // Euler: F = nu . dF/dnu + mu dF/dmu + tau_0 dF/dtau_0, and mu dF/dmu = N
  // dF/dN
  const double load = patch::normal_force(patch.region), force[3] = {forces.fx, forces.fy, forces.mz};
  const Creepage& c = patch.creepage;
  for (int r = 0; r < 3; ++r) {
    double* const d = sums.d[r];
    const double by_friction = force[r] - (d[0] * c.longitudinal + d[1] * c.lateral + d[2] * c.spin) - d[4];
    d[3] = load > 0.0 ? by_friction / load : 0.0;
    d[4] = patch.friction > 0.0 ? by_friction / patch.friction : 0.0;
  }
}

}  // namespace wrc::tangential
