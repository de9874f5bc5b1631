// Against reference cases with prescribed SDEC pressure, a file with the columns of sdec_cases.csv:
//     a_mm,b_mm,psi,nu,G_MPa,mu,N_kN,p0_MPa,cx,cy,phi_per_m,Fx_N,Fy_N,Mz_Nm,P_W_at_1mps,adh_frac,nx,ny
#include <algorithm>
#include <fstream>
#include <initializer_list>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "halfspace/tangential.hpp"
#include "halfspace_report/report.hpp"
#include "sdec_pressure.hpp"

namespace wrc::halfspace::report {
namespace {

struct Row {
  int number = 0;
  SdecPatch patch;
  patch::Material material;
  double friction = 0.0, load = 0.0, peak = 0.0;
  tangential::Creepage creepage;
  double fx = 0.0, fy = 0.0, power = 0.0, adhesion = 0.0;
  int nx = 0, ny = 0;
};

std::vector<Row> read_rows(const char* path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) throw std::runtime_error(std::string("cannot read ") + path);
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream in(line);
    double v[18];
    for (double& x : v) in >> x;
    if (!in) continue;
    rows.push_back({.number = static_cast<int>(rows.size()) + 1,
                    .patch = {.a = v[0] * 1e-3, .b = v[1] * 1e-3, .psi = v[2]},
                    .material = {.shear_modulus = v[4] * 1e6, .poisson = v[3]},
                    .friction = v[5],
                    .load = v[6] * 1e3,
                    .peak = v[7] * 1e6,
                    .creepage = {.longitudinal = v[8], .lateral = v[9], .spin = v[10]},
                    .fx = v[11],
                    .fy = v[12],
                    .power = v[14],
                    .adhesion = v[15],
                    .nx = static_cast<int>(v[16]),
                    .ny = static_cast<int>(v[17])});
  }
  return rows;
}

RollingSolution solve(const Row& row, int factor, CellPressure rule, Collocation collocation) {
  const Grid grid = grid_over(row.patch, factor * row.nx, factor * row.ny);
  RollingProblem problem;
  problem.pressure = sdec_pressure(row.patch, row.peak, grid, rule);
  problem.friction = {row.friction};
  problem.creepage = row.creepage;
  problem.collocation = collocation;
  return RollingSolver(grid, row.material).solve(problem);
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const auto last = static_cast<double>(values.size() - 1);
  return values[static_cast<std::size_t>(std::lround(share * last))];
}

Json print_quantiles(const char* what, const std::vector<double>& errors) {
  std::printf("%-56s n %3zu  median %9.5f %%  p95 %9.5f %%  max %9.5f %%\n", what, errors.size(),
              100.0 * quantile(errors, 0.5), 100.0 * quantile(errors, 0.95), 100.0 * quantile(errors, 1.0));
  Json json;
  json.add("rows", static_cast<double>(errors.size()));
  json.add("median", quantile(errors, 0.5));
  json.add("p95", quantile(errors, 0.95));
  json.add("max", quantile(errors, 1.0));
  return json;
}

constexpr double mostly_sticking = 0.9;  // above it the reference's power is mostly its grid's error

}  // namespace

Json sdec(const char* path) {
  const std::vector<Row> rows = read_rows(path);
  std::vector<double> force, power, fine_force, converged;
  double total = 0.0;
  int unconverged = 0;
  for (const Row& row : rows) {
    const double bound = row.friction * row.load;
    RollingSolution same;
    total += seconds_of([&] { same = solve(row, 1, CellPressure::centre, Collocation::reference_program); });
    // Converged: first-order terms of grids h and h/2 removed.
    const RollingSolution one = solve(row, 1, CellPressure::mean, Collocation::quarter_point);
    const RollingSolution two = solve(row, 2, CellPressure::mean, Collocation::quarter_point);
    for (const RollingSolution* each : {&std::as_const(same), &one, &two}) {
      if (each->fault.status == WRC_OK) continue;
      ++unconverged;
      std::printf("row %3d: residual %.1e after %d iterations\n", row.number, each->residual,
                  each->iterations);
    }
    force.push_back(std::hypot(same.forces.fx - row.fx, same.forces.fy - row.fy) / bound);
    const double fx = 2.0 * two.forces.fx - one.forces.fx, fy = 2.0 * two.forces.fy - one.forces.fy;
    fine_force.push_back(std::hypot(fx - row.fx, fy - row.fy) / bound);
    if (row.adhesion < mostly_sticking) {
      power.push_back(std::abs(same.forces.power_per_speed / row.power - 1.0));
      converged.push_back((2.0 * two.power_by_balance - one.power_by_balance) / row.power - 1.0);
    }
  }
  Json json;
  json.add("force_reference_grid", print_quantiles("force vector / (mu N), reference's grid", force));
  json.add("power_reference_grid", print_quantiles("power, reference's grid, adhesion < 0.9", power));
  json.add("force_converged", print_quantiles("force vector / (mu N), extrapolated in the grid", fine_force));
  json.add("power_converged_above_reference",
           print_quantiles("converged power above the reference's, adhesion < 0.9", converged));
  std::printf("%zu rows in %.2f s on the reference's grids (set-up included), %d solutions not converged\n",
              rows.size(), total, unconverged);
  json.add("rows", static_cast<double>(rows.size()));
  json.add("seconds", total);
  json.add("not_converged", unconverged);
  return json;
}

Json balance(const char* path) {
  std::vector<Row> rows;
  for (const Row& row : read_rows(path)) {
    if (row.adhesion < mostly_sticking && row.power > 0.0) rows.push_back(row);
  }
  // Ten rows from all over the range of adhesion.
  std::sort(rows.begin(), rows.end(), [](const Row& l, const Row& r) { return l.adhesion < r.adhesion; });
  constexpr std::size_t chosen = 10;
  constexpr int factors[] = {1, 2, 4};
  std::printf(
      "Power summed over the cells, as the reference does it, on its grid and on finer ones; limits are "
      "those of a grid\nof no size (2 P(4x) - P(2x)); all over the limit of the energy balance.\n"
      " row adhesion | reference |  sum 1x  sum 2x  sum 4x   limit  order | balance 1x  2x      4x     "
      "[W]\n");
  std::vector<Json> list;
  std::vector<double> above, meeting;
  for (std::size_t k = 0; k < std::min(chosen, rows.size()); ++k) {
    const Row& row = rows[(k * (rows.size() - 1)) / (chosen - 1)];
    double sum[3], by_balance[3];
    for (int f = 0; f < 3; ++f) {
      const RollingSolution s = solve(row, factors[f], CellPressure::centre, Collocation::reference_program);
      sum[f] = s.forces.power_per_speed;
      by_balance[f] = s.power_by_balance;
    }
    const double limit = 2.0 * by_balance[2] - by_balance[1];
    const double sum_limit = 2.0 * sum[2] - sum[1];
    const double order = std::log2((sum[1] - sum[0]) / (sum[2] - sum[1]));
    std::printf("%4d  %7.3f | %9.4f | %7.4f %7.4f %7.4f %7.4f  %5.2f | %9.4f %7.4f %7.4f  %7.3f\n",
                row.number, row.adhesion, row.power / limit, sum[0] / limit, sum[1] / limit, sum[2] / limit,
                sum_limit / limit, order, by_balance[0] / limit, by_balance[1] / limit, by_balance[2] / limit,
                limit);
    above.push_back(limit / row.power - 1.0);
    meeting.push_back(std::abs(sum_limit / limit - 1.0));
    Json json;
    json.add("row", row.number);
    json.add("adhesion", row.adhesion);
    json.add("reference", row.power / limit);
    json.add("sum_1x", sum[0] / limit);
    json.add("sum_2x", sum[1] / limit);
    json.add("sum_4x", sum[2] / limit);
    json.add("sum_limit", sum_limit / limit);
    json.add("order", order);
    json.add("balance_limit_W", limit);
    list.push_back(json);
  }
  Json json;
  json.add("balance_above_reference", print_quantiles("limit of the balance above the reference", above));
  json.add("sum_against_balance", print_quantiles("limit of the sum against that of the balance", meeting));
  json.add("rows", list);
  return json;
}

}  // namespace wrc::halfspace::report
