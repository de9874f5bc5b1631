// The exact solver against closed solutions: Hertz and Carter.
#include <algorithm>

#include "halfspace/normal.hpp"
#include "halfspace/tangential.hpp"
#include "halfspace_report/report.hpp"
#include "sdec_pressure.hpp"
#include "unit/halfspace_closed_forms.hpp"

namespace wrc::halfspace::report {
namespace {

constexpr patch::Material steel{.shear_modulus = 82e9, .poisson = 0.28};
constexpr double peak = 1e9;

}  // namespace

Json hertz() {
  std::printf(
      "Load prescribed, cells over 1.25 times the ellipse, errors in %%; order: of the root mean square over "
      "grids shifted\nagainst the ellipse, as a single grid's error depends on where the border cuts its "
      "cells\n  b/a  cells |   peak      a      b  approach | iterations\n");
  std::vector<Json> list, orders;
  double worst_at_64 = 0.0;
  for (const double ratio : {1.0, 2.0, 5.0}) {
    const double a = 4e-3, b = a * ratio;
    const closed_forms::Hertz exact = closed_forms::hertz(steel, a, b, peak);
    constexpr int sizes[] = {16, 32, 64, 128};
    double mean_error[4][4];  // by grid: peak, a, b, approach
    for (int n = 0; n < 4; ++n) {
      const int cells = sizes[n];
      constexpr int shifts = 4;
      double square[4] = {};
      for (int shift = 0; shift < shifts; ++shift) {
        // The first grid is centred; the others are shifted by fractions of a cell.
        const double dx = 2.5 * a / cells, dy = 2.5 * b / cells;
        const double sx = 0.13 * shift * dx, sy = 0.29 * shift * dy;
        const Grid grid =
            grid_over_box(-1.25 * a + sx, 1.25 * a + sx, -1.25 * b + sy, 1.25 * b + sy, cells, cells);
        GapProblem problem{.gap = Field(grid.cells()), .normal_force = exact.load, .progress = {}};
        for (int j = 0; j < cells; ++j) {
          for (int i = 0; i < cells; ++i) {
            problem.gap[grid.index(i, j)] =
                0.5 * (exact.curvature_x * grid.x(i) * grid.x(i) + exact.curvature_y * grid.y(j) * grid.y(j));
          }
        }
        const GapSolution s = NormalSolver(grid, steel).solve(problem);
        const closed_forms::Axes found = closed_forms::axes(grid, s.pressure);
        const double error[4] = {s.peak_pressure / peak - 1.0, found.a / a - 1.0, found.b / b - 1.0,
                                 s.approach / exact.approach - 1.0};
        for (int k = 0; k < 4; ++k) {
          square[k] += error[k] * error[k] / shifts;
          if (cells == 64) worst_at_64 = std::max(worst_at_64, std::abs(error[k]));
        }
        if (shift > 0) continue;
        std::printf("%5.1f  %5d | %+6.3f %+6.3f %+6.3f %+9.4f | %d\n", ratio, cells, 100.0 * error[0],
                    100.0 * error[1], 100.0 * error[2], 100.0 * error[3], s.iterations);
        Json row;
        row.add("b_over_a", ratio);
        row.add("cells", cells);
        row.add("peak_error", error[0]);
        row.add("a_error", error[1]);
        row.add("b_error", error[2]);
        row.add("approach_error", error[3]);
        row.add("iterations", s.iterations);
        list.push_back(row);
      }
      for (int k = 0; k < 4; ++k) mean_error[n][k] = std::sqrt(square[k]);
    }
    double order[4];  // from the coarsest to the finest grid
    for (int k = 0; k < 4; ++k) order[k] = std::log2(mean_error[0][k] / mean_error[3][k]) / 3.0;
    std::printf("%5.1f  order | %6.2f %6.2f %6.2f %9.2f\n", ratio, order[0], order[1], order[2], order[3]);
    Json row;
    row.add("b_over_a", ratio);
    row.add("peak", order[0]);
    row.add("a", order[1]);
    row.add("b", order[2]);
    row.add("approach", order[3]);
    orders.push_back(row);
  }
  std::printf("worst error at 64 x 64 cells, shifted grids included: %.3f %%\n", 100.0 * worst_at_64);
  Json json;
  json.add("worst_error_at_64", worst_at_64);
  json.add("orders", orders);
  json.add("grids", list);
  return json;
}

Json carter() {
  std::printf(
      "Middle section of a contact 40 times as wide as long against Carter: |F|/(mu N); traction: largest "
      "difference\nover mu p0, but for the two cells at either end\n"
      "creepage/saturation cells |  long. exact   Carter   error  traction | lateral exact   Carter   error  "
      "traction\n");
  constexpr double friction = 0.3, a = 4e-3, b = 40.0 * a;
  std::vector<Json> list;
  for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    for (const int cells : {32, 64, 128}) {
      constexpr int rows = 25;
      const Grid grid = grid_over_box(-a, a, -b, b, cells, rows);
      RollingSolver solver(grid, steel);
      RollingProblem problem;
      // The section does not change over the grid's width.
      problem.pressure = sdec_pressure({.a = a, .b = 1e3 * b, .psi = 0.0}, peak, grid, CellPressure::mean);
      problem.friction = {friction};
      Json row;
      row.add("share", share);
      row.add("cells", cells);
      std::printf("%19.2f %5d |", share, cells);
      for (const bool lateral : {false, true}) {
        const double compliance = (lateral ? 1.0 : 1.0 - steel.poisson) / steel.shear_modulus;
        const double creepage = share * 2.0 * friction * peak * compliance;
        const closed_forms::Carter exact(a, friction * peak, compliance, creepage);
        problem.creepage = {};
        (lateral ? problem.creepage.lateral : problem.creepage.longitudinal) = creepage;
        const RollingSolution s = solver.solve(problem);
        const Field& traction = lateral ? s.traction_y : s.traction_x;
        double force = 0.0, full = 0.0, worst = 0.0;
        for (int i = 0; i < cells; ++i) {
          const std::size_t at = grid.index(i, rows / 2);
          force -= traction[at];
          full += friction * problem.pressure[at];
          if (i < 2 || i >= cells - 2) continue;
          worst = std::max(worst, std::abs(-traction[at] - exact.traction(grid.x(i) - 0.25 * grid.dx)));
        }
        const double error = force / full - exact.force();
        std::printf(" %12.4f %8.4f %+7.4f %9.4f |", force / full, exact.force(), error,
                    worst / (friction * peak));
        row.add(lateral ? "lateral_force_error" : "longitudinal_force_error", error);
        row.add(lateral ? "lateral_traction_error" : "longitudinal_traction_error",
                worst / (friction * peak));
      }
      std::printf("\n");
      list.push_back(row);
    }
  }
  Json json;
  json.add("rows", list);
  return json;
}

}  // namespace wrc::halfspace::report
