// The source paper's two cases, S1002 on UIC60, from the profiles to the power, on finer and finer grids.
#include <algorithm>
#include <stdexcept>

#include "halfspace_report/report.hpp"
#include "test_config.hpp"
#include "wrc/wrc_offline.h"

namespace wrc::halfspace::report {
namespace {

void demand(bool holds, const char* what) {
  if (!holds) throw std::runtime_error(what);
}

constexpr double load = 80e3, friction = 0.35;

struct Case {
  const char* name;
  double longitudinal, lateral, spin;
  double reference;  // CONTACT 25.2 on 0.3 mm cells, the paper's reading of it to one digit less [W]
};
constexpr Case cases[] = {{"case 1, pure spin", 0.0, 0.0, -0.5, 68.68},
                          {"case 2, combined", -0.49e-3, -0.22e-3, 0.29, 30.60}};

// The profiles' contact, its gap kept in a wrc_contact.
class Profiles {
 public:
  Profiles() {
    wrc_config config = test_config();
    config.planar.gap_rows = 1024;
    config.wheel.kind = WRC_PROFILE_S1002;
    config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
    demand(wrc_model_create(&config, nullptr, &model_, nullptr, 0) == WRC_OK, "no model");
    demand(wrc_contact_create(model_, WRC_SIDE_RIGHT, nullptr, &contact_, nullptr, 0) == WRC_OK,
           "no contact");
    const wrc_planar_pose pose = sized<wrc_planar_pose>();
    wrc_planar_point point{};
    demand(wrc_planar_geometry(contact_, &pose, &point) == WRC_OK, "no geometry");
  }
  Profiles(const Profiles&) = delete;
  Profiles& operator=(const Profiles&) = delete;
  ~Profiles() {
    wrc_contact_destroy(contact_);
    wrc_model_destroy(model_);
  }

  // Exact pressure on square cells over the patch.
  std::vector<double> pressure(double cell, wrc_grid& grid, wrc_exact_normal_solution& solution) const {
    grid = sized<wrc_grid>();
    grid.nx = static_cast<uint32_t>(std::lround(15e-3 / cell));
    grid.ny = static_cast<uint32_t>(std::lround(27e-3 / cell));
    grid.dx = grid.dy = cell;
    grid.x0 = -0.5 * cell * (grid.nx - 1);
    grid.y0 = -16.15e-3 + 0.5 * cell;
    std::vector<double> gap(std::size_t{grid.nx} * grid.ny), found(gap.size());
    demand(wrc_exact_gap(contact_, &grid, gap.data()) == WRC_OK, "no gap");
    wrc_exact_normal_problem problem = of_the_papers_steel(wrc_exact_normal_problem_default());
    problem.normal_force = load;
    problem.grid = grid;
    problem.gap = gap.data();
    solution = sized<wrc_exact_normal_solution>();
    solution.pressure = found.data();
    char text[256];
    demand(wrc_exact_normal(&problem, &solution, text, sizeof text) == WRC_OK, text);
    return found;
  }

 private:
  wrc_model* model_ = nullptr;
  wrc_contact* contact_ = nullptr;
};

// Mid-width of the contact [m].
double middle(const wrc_grid& grid, const std::vector<double>& pressure) {
  uint32_t first = grid.ny, last = 0;
  for (uint32_t j = 0; j < grid.ny; ++j) {
    for (uint32_t i = 0; i < grid.nx; ++i) {
      if (pressure[std::size_t{j} * grid.nx + i] <= 0.0) continue;
      first = std::min(first, j);
      last = std::max(last, j);
    }
  }
  return grid.y0 + 0.5 * grid.dy * (first + last);
}

}  // namespace

Json paper() {
  const Profiles profiles;
  constexpr double cells[] = {0.3e-3, 0.2e-3, 0.15e-3, 0.1e-3, 0.075e-3};
  constexpr int grids = 5;
  std::vector<double> pressure[grids];
  wrc_grid grid[grids];
  std::printf(
      "S1002 / UIC60, 80 kN, friction 0.35, V = 1 m/s\ncells [mm] | approach [um]  area [mm^2]  peak "
      "[MPa]\n");
  for (int n = 0; n < grids; ++n) {
    wrc_exact_normal_solution normal;
    pressure[n] = profiles.pressure(cells[n], grid[n], normal);
    std::printf("%10.3f | %13.3f %12.2f %11.2f\n", 1e3 * cells[n], 1e6 * normal.approach, 1e6 * normal.area,
                1e-6 * normal.peak_pressure);
  }
  // The reference takes its creepages at the paper's initial contact point, 3.1 mm from mid-width; that of
  // the profiles lies 2.9 mm from it. The creepages are moved to our origin.
  const double origin = middle(grid[grids - 1], pressure[grids - 1]) + 3.1e-3;
  std::printf("the reference's origin lies at y = %.3f mm of ours\n", 1e3 * origin);
  Json json;
  json.add("origin_mm", 1e3 * origin);
  for (const Case& each : cases) {
    std::printf(
        "%s: CONTACT on 0.3 mm cells %.2f W\n"
        "           | collocation of CONTACT              | quarter point\n"
        "cells [mm] | sum [W]  balance [W]  Fx [N]  Fy [N] | sum [W]  balance [W]  Fx [N]  Fy [N]\n",
        each.name, each.reference);
    wrc_creepage creepage = wrc_creepage_default();
    creepage.longitudinal = each.longitudinal + each.spin * origin;
    creepage.lateral = each.lateral;
    creepage.spin = each.spin;
    std::vector<Json> list;
    double sum[grids][2], balance[grids][2];
    for (int n = 0; n < grids; ++n) {
      std::printf("%10.3f |", 1e3 * cells[n]);
      Json row;
      row.add("cell_mm", 1e3 * cells[n]);
      for (const int32_t collocation : {WRC_COLLOCATION_REFERENCE, WRC_COLLOCATION_QUARTER_POINT}) {
        wrc_exact_rolling_problem problem = of_the_papers_steel(wrc_exact_rolling_problem_default());
        problem.collocation = collocation;
        problem.grid = grid[n];
        problem.pressure = pressure[n].data();
        problem.coefficient = friction;
        problem.creepage = creepage;
        wrc_exact_rolling_solution s = sized<wrc_exact_rolling_solution>();
        char text[256];
        demand(wrc_exact_rolling(&problem, &s, text, sizeof text) == WRC_OK, text);
        const bool quarter = collocation == WRC_COLLOCATION_QUARTER_POINT;
        sum[n][quarter] = s.power;
        balance[n][quarter] = s.power_by_balance;
        std::printf(" %7.3f %12.3f %7.0f %7.0f |", s.power, s.power_by_balance, s.fx, s.fy);
        row.add(quarter ? "sum_quarter_W" : "sum_W", s.power);
        row.add(quarter ? "balance_quarter_W" : "balance_W", s.power_by_balance);
      }
      std::printf("\n");
      list.push_back(row);
    }
    // Straight lines through the cell size: least squares over all grids.
    const auto limit = [&](const double(*power)[2], int which) {
      double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
      for (int n = 0; n < grids; ++n) {
        sx += cells[n];
        sy += power[n][which];
        sxx += cells[n] * cells[n];
        sxy += cells[n] * power[n][which];
      }
      return (sy * sxx - sx * sxy) / (grids * sxx - sx * sx);
    };
    std::printf("     limit | %7.2f %12.2f %15s | %7.2f %12.2f\n", limit(sum, 0), limit(balance, 0), "",
                limit(sum, 1), limit(balance, 1));
    Json result;
    result.add("reference_W", each.reference);
    result.add("sum_limit_W", limit(sum, 0));
    result.add("balance_limit_W", limit(balance, 0));
    result.add("sum_quarter_limit_W", limit(sum, 1));
    result.add("balance_quarter_limit_W", limit(balance, 1));
    result.add("grids", list);
    json.add(each.name, result);
  }
  return json;
}

}  // namespace wrc::halfspace::report
