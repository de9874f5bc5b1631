#include <cmath>
#include <vector>

#include "cases.hpp"
#include "halfspace_cases.hpp"
#include "kinds.hpp"
#include "library.hpp"
#include "test_config.hpp"
#include "wrc/wrc_offline.h"

namespace compare {
wrc_grid grid_over(const wrc_ellipse& ellipse, uint32_t nx, uint32_t ny) {
  wrc_grid grid = sized<wrc_grid>();
  grid.nx = nx;
  grid.ny = ny;
  grid.dx = 2.0 * ellipse.a / nx;
  grid.dy = 2.0 * ellipse.b / ny;
  grid.x0 = -ellipse.a + 0.5 * grid.dx;
  grid.y0 = -ellipse.b * (1.0 - ellipse.psi) + 0.5 * grid.dy;
  return grid;
}

std::vector<double> pressure_at_centres(const wrc_ellipse& ellipse, const wrc_grid& grid) {
  const double pi = 3.14159265358979323846;
  const double peak = 1.5 * ellipse.normal_force / (pi * ellipse.a * ellipse.b);
  std::vector<double> pressure;
  for (uint32_t j = 0; j < grid.ny; ++j) {
    const double y = grid.y0 + j * grid.dy;
    const double eta = y / (ellipse.b * (1.0 + (y > 0.0 ? ellipse.psi : -ellipse.psi)));
    for (uint32_t i = 0; i < grid.nx; ++i) {
      const double xi = (grid.x0 + i * grid.dx) / ellipse.a;
      pressure.push_back(peak * std::sqrt(std::fmax(0.0, 1.0 - xi * xi - eta * eta)));
    }
  }
  return pressure;
}

wrc_material material_of(double shear_modulus, double poisson) {
  wrc_material material = wrc_material_default();
  material.shear_modulus = shear_modulus;
  material.poisson = poisson;
  return material;
}

namespace {

struct Variant {
  const char* name;
  int32_t collocation;
  double refinement;  ///< cells per cell of the reference
};
const std::vector<Variant> every_variant = {
    {"exact/reference grid", WRC_COLLOCATION_REFERENCE, 1.0},
    {"exact/quarter point", WRC_COLLOCATION_QUARTER_POINT, 1.0},
    {"exact/quarter point/twice as fine", WRC_COLLOCATION_QUARTER_POINT, 2.0},
};

}  // namespace

Report compare_halfspace_sdec(const Csv& file, const Names& only) {
  Report report;
  report.kind = "halfspace-sdec";
  report.rows = file.rows();
  report.measures = {"force", "power", "power_by_balance"};
  report.default_variant = every_variant[0].name;
  for (const Variant& variant : chosen(every_variant, only)) {
    report.variants.emplace_back(variant.name);
    for (std::size_t row = 0; row < file.rows(); ++row) {
      const Rolling rolling = rolling_of(file, row);
      const wrc_ellipse& ellipse = rolling.ellipse;
      const wrc_grid grid = grid_over(ellipse, static_cast<uint32_t>(variant.refinement * file(row, "nx")),
                                      static_cast<uint32_t>(variant.refinement * file(row, "ny")));
      const std::vector<double> pressure = pressure_at_centres(ellipse, grid);
      wrc_exact_rolling_problem problem = wrc_exact_rolling_problem_default();
      problem.collocation = variant.collocation;
      problem.wheel_material = problem.rail_material = material_of(1e6 * file(row, "G_MPa"), file(row, "nu"));
      problem.grid = grid;
      problem.pressure = pressure.data();
      problem.coefficient = rolling.friction.coefficient;
      problem.creepage = rolling.creepage;
      wrc_exact_rolling_solution solution = sized<wrc_exact_rolling_solution>();
      char text[256];
      const int32_t status = wrc_exact_rolling(&problem, &solution, text, sizeof text);
      if (status < 0) {
        report.fail(row, variant.name, text);
        continue;
      }
      const double limit = rolling.friction.coefficient * ellipse.normal_force;
      auto& errors = report.errors[variant.name];
      errors["force"].add(
          row, std::hypot(solution.fx - file(row, "Fx_N"), solution.fy - file(row, "Fy_N")) / limit);
      errors["power"];
      errors["power_by_balance"];
      if (file(row, "adh_frac") < 0.9) {
        errors["power"].add(row, solution.power / file(row, "P_W_at_1mps") - 1.0);
        errors["power_by_balance"].add(row, solution.power_by_balance / file(row, "P_W_at_1mps") - 1.0);
      }
    }
  }
  return report;
}

Report compare_halfspace_normal(const Csv& file, const Names& only) {
  wrc_config config = test_config();
  config.planar.gap_rows = 1024;
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  const Solver solver(config);

  Report report;
  report.kind = "halfspace-normal";
  const std::vector<Case> cases = find_cases(file);
  report.rows = cases.size();
  report.measures = {"peak_pressure", "area", "approach", "line_load"};
  struct Single {
    const char* name;
  };
  for (const Single& variant : chosen<Single>({{"exact"}}, only)) report.variants.emplace_back(variant.name);
  report.default_variant = "exact";
  auto& errors = report.errors["exact"];
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::size_t head = cases[i].first;
    wrc_planar_pose pose = sized<wrc_planar_pose>();
    pose.lateral = 1e-3 * file(head, "y_ws_mm");
    pose.yaw = file(head, "yaw_rad");
    wrc_planar_point point{};
    int32_t status = wrc_planar_geometry(solver.contact(), &pose, &point);
    if (status < 0) {
      report.fail(i, "exact", solver.reason(status));
      continue;
    }
    // The reference's 0.2 mm cells over its patch and a margin, on its rows.
    const double shift = reference_shift(file, cases[i], point);
    const double size = 0.2e-3;
    wrc_grid grid = sized<wrc_grid>();
    const double low = 1e-3 * file(head, "row_y_mm"), high = 1e-3 * file(cases[i].last - 1, "row_y_mm");
    grid.nx = 100;
    grid.ny = static_cast<uint32_t>(std::lround((high - low) / size)) + 21;
    grid.dx = grid.dy = size;
    grid.x0 = -0.5 * size * (grid.nx - 1);
    grid.y0 = low + shift - 10.0 * size;
    std::vector<double> gap(std::size_t{grid.nx} * grid.ny), pressure(gap.size());
    status = wrc_exact_gap(solver.contact(), &grid, gap.data());
    if (status < 0) {
      report.fail(i, "exact", solver.reason(status));
      continue;
    }
    wrc_exact_normal_problem problem = of_the_papers_steel(wrc_exact_normal_problem_default());
    problem.normal_force = file(head, "Fn_N");
    problem.grid = grid;
    problem.gap = gap.data();
    wrc_exact_normal_solution solution = sized<wrc_exact_normal_solution>();
    solution.pressure = pressure.data();
    char text[256];
    status = wrc_exact_normal(&problem, &solution, text, sizeof text);
    if (status < 0) {
      report.fail(i, "exact", text);
      continue;
    }
    LineLoad load;
    for (uint32_t j = 0; j < grid.ny; ++j) {
      double sum = 0.0;
      for (uint32_t k = 0; k < grid.nx; ++k) sum += pressure[j * grid.nx + k] * size;
      load.add(grid.y0 + (j - 0.5) * size, grid.y0 + (j + 0.5) * size, sum);
    }
    errors["peak_pressure"].add(i, solution.peak_pressure / (1e6 * file(head, "pmax_MPa")) - 1.0);
    errors["area"].add(i, solution.area / (1e-6 * file(head, "area_mm2")) - 1.0);
    errors["approach"].add(i, solution.approach / (1e-3 * file(head, "pen_mm")) - 1.0);
    errors["line_load"].add(i, line_load_error(file, cases[i], load, shift));
  }
  return report;
}

}  // namespace compare
