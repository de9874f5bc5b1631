#include <cmath>
#include <string>
#include <vector>

#include "kinds.hpp"
#include "library.hpp"
#include "test_config.hpp"

namespace compare {
namespace {

/// The patch of one row on a grid of strips x cells, by the standard variant.
wrc_planar_forces solve(const Csv& file, std::size_t row, int32_t strips, int32_t cells, Report& report,
                        const std::string& name) {
  wrc_config config = test_config();
  config.wheel_material.shear_modulus = config.rail_material.shear_modulus = 1e6 * file(row, "G_MPa");
  config.wheel_material.poisson = config.rail_material.poisson = file(row, "nu");
  config.planar.strips = strips;
  config.planar.cells = cells;
  const Solver solver(config);
  const Rolling rolling = rolling_of(file, row);
  wrc_planar_forces forces{};
  const int32_t status = wrc_planar_tangential(solver.contact(), &rolling.ellipse, &rolling.creepage,
                                               &rolling.friction, &forces);
  if (status < 0) report.fail(row, name, solver.reason(status));
  return forces;
}

}  // namespace

Report compare_grid(const Csv& file, const Names& only) {
  constexpr int32_t finest = 512;
  constexpr int32_t sizes[] = {16, 24, 32, 48, 64, 96, 128};
  const wrc_config standard = test_config();
  Report report;
  report.kind = "grid";
  report.rows = file.rows();
  report.measures = {"force", "power"};
  struct Grid {
    std::string name;
    int32_t strips, cells;
  };
  std::vector<Grid> grids;
  for (int32_t size : sizes) grids.push_back({std::to_string(size) + "x" + std::to_string(size), size, size});
  report.default_variant =
      std::to_string(standard.planar.strips) + "x" + std::to_string(standard.planar.cells);
  grids.push_back({report.default_variant, standard.planar.strips, standard.planar.cells});
  grids = chosen(grids, only);
  for (const Grid& grid : grids) report.variants.push_back(grid.name);

  for (std::size_t row = 0; row < file.rows(); ++row) {
    const wrc_planar_forces exact = solve(file, row, finest, finest, report, report.default_variant);
    const double limit = file(row, "mu") * 1e3 * file(row, "N_kN");
    for (const Grid& grid : grids) {
      const wrc_planar_forces forces = solve(file, row, grid.strips, grid.cells, report, grid.name);
      auto& errors = report.errors[grid.name];
      errors["force"].add(row, std::hypot(forces.fx - exact.fx, forces.fy - exact.fy) / limit);
      errors["power"];
      if (file(row, "adh_frac") < 0.9) errors["power"].add(row, forces.power / exact.power - 1.0);
    }
  }
  return report;
}

}  // namespace compare
