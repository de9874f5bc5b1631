#include "exact_forces.hpp"

#include <cmath>

#include "halfspace/pressure.hpp"
#include "halfspace/tangential.hpp"
#include "sdec_pressure.hpp"

namespace wrc::calibration {
namespace {

/// The patch's strips as the library's view of them; memory of five arrays.
patch::Strips view(const Patch& patch, std::vector<double>& memory) {
  const std::size_t count = patch.strips.size();
  memory.resize(5 * count);
  double* const p = memory.data();
  const patch::Strips strips{static_cast<std::int32_t>(count),
                             static_cast<std::int32_t>(count),
                             p,
                             p + count,
                             p + 2 * count,
                             p + 3 * count,
                             p + 4 * count};
  for (std::size_t j = 0; j < count; ++j) {
    const Strip& s = patch.strips[j];
    strips.y[j] = s.y;
    strips.width[j] = s.width;
    strips.centre[j] = s.centre;
    strips.half_length[j] = s.half_length;
    strips.peak[j] = s.peak;
  }
  return strips;
}

halfspace::RollingSolution solve(const Patch& patch, int cells) {
  const halfspace::SdecPatch sdec{patch.a, patch.b, patch.psi};
  std::vector<double> memory;
  const patch::Strips strips = view(patch, memory);
  const bool is_sdec = patch.strips.empty();
  const halfspace::Grid grid =
      is_sdec ? halfspace::grid_over(sdec, cells, cells) : halfspace::grid_over(strips, cells, cells);
  halfspace::RollingSolver solver(grid, {patch.shear_modulus, patch.poisson});
  halfspace::RollingProblem problem;
  problem.pressure = is_sdec ? halfspace::sdec_pressure(sdec, patch.p0, grid, halfspace::CellPressure::mean)
                             : halfspace::strip_pressure(strips, grid);
  problem.friction = {patch.friction};
  problem.creepage = patch.creepage;
  return solver.solve(problem);
}

double extrapolated(double coarse, double fine) {
  return fine + (fine - coarse) * coarse_cells / (fine_cells - coarse_cells);
}

}  // namespace

ExactForces exact_forces(const Patch& patch) {
  const halfspace::RollingSolution coarse = solve(patch, coarse_cells), fine = solve(patch, fine_cells);
  const tangential::Creepage& c = patch.creepage;
  ExactForces f{};
  f.fx = extrapolated(coarse.forces.fx, fine.forces.fx);
  f.fy = extrapolated(coarse.forces.fy, fine.forces.fy);
  f.mz = extrapolated(coarse.forces.mz, fine.forces.mz);
  f.power = -(f.fx * c.longitudinal + f.fy * c.lateral + f.mz * c.spin);
  f.adhesion = fine.forces.adhesion_fraction;
  f.force_shift =
      std::hypot(f.fx - fine.forces.fx, f.fy - fine.forces.fy) / (patch.friction * patch.normal_force);
  f.power_shift = std::fabs(fine.power_by_balance / f.power - 1.0);
  f.converged = coarse.fault.status == WRC_OK && fine.fault.status == WRC_OK;
  return f;
}

}  // namespace wrc::calibration
