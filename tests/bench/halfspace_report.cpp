// Accuracy and speed of the exact half-space solver, printed:
//     halfspace_report sdec FILE.csv   against reference cases with prescribed SDEC pressure (columns by name
//     order of
//                                      sdec_cases.csv:
//                                      a_mm,b_mm,psi,nu,G_MPa,mu,N_kN,p0_MPa,cx,cy,phi_per_m,Fx_N,Fy_N,
//                                      Mz_Nm,P_W_at_1mps,adh_frac,nx,ny)
//     halfspace_report kalker          computed against printed Kalker coefficients
//     halfspace_report speed           cost against grid size

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "halfspace/linear_theory.hpp"
#include "halfspace/pressure.hpp"
#include "halfspace/tangential.hpp"

namespace {

using namespace wrc;
using namespace wrc::halfspace;

double seconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const auto last = static_cast<double>(values.size() - 1);
  return values[static_cast<std::size_t>(std::lround(share * last))];
}

void print_quantiles(const char* what, const std::vector<double>& errors) {
  std::printf("%-56s n %3zu  median %9.5f %%  p95 %9.5f %%  max %9.5f %%\n", what, errors.size(),
              100.0 * quantile(errors, 0.5), 100.0 * quantile(errors, 0.95), 100.0 * quantile(errors, 1.0));
}

int report_sdec(const char* path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) {
    std::fprintf(stderr, "cannot read %s\n", path);
    return 2;
  }
  std::vector<double> force, power, fine_force, balance;
  double total = 0.0;
  int row = 0, unconverged = 0;
  while (std::getline(file, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream in(line);
    double v[18];
    for (double& x : v) in >> x;
    if (!in) continue;
    ++row;
    const SdecPatch patch{.a = v[0] * 1e-3, .b = v[1] * 1e-3, .psi = v[2]};
    const Material material{.shear_modulus = v[4] * 1e6, .poisson = v[3]};
    const double bound = v[5] * v[6] * 1e3, peak = v[7] * 1e6;
    const auto run = [&](int factor, CellPressure rule, Collocation collocation) {
      const Grid grid = grid_over(patch, factor * static_cast<int>(v[16]), factor * static_cast<int>(v[17]));
      RollingProblem problem;
      problem.pressure = sdec_pressure(patch, peak, grid, rule);
      problem.friction = {v[5]};
      problem.creepage = {.longitudinal = v[8], .lateral = v[9], .spin = v[10]};
      problem.collocation = collocation;
      RollingSolution solution = RollingSolver(grid, material).solve(problem);
      if (solution.fault.status != WRC_OK) {
        ++unconverged;
        std::printf("row %3d: residual %.1e after %d iterations\n", row, solution.residual,
                    solution.iterations);
      }
      return solution;
    };
    RollingSolution same;
    total += seconds_of([&] { same = run(1, CellPressure::centre, Collocation::reference_program); });
    force.push_back(std::hypot(same.forces.fx - v[11], same.forces.fy - v[12]) / bound);
    if (v[15] < 0.9) power.push_back(std::abs(same.forces.power_per_speed / v[14] - 1.0));
    // Converged: first-order terms of grids h and h/2 removed.
    const RollingSolution one = run(1, CellPressure::mean, Collocation::quarter_point);
    const RollingSolution two = run(2, CellPressure::mean, Collocation::quarter_point);
    const double fx = 2.0 * two.forces.fx - one.forces.fx, fy = 2.0 * two.forces.fy - one.forces.fy;
    fine_force.push_back(std::hypot(fx - v[11], fy - v[12]) / bound);
    if (v[15] < 0.9)
      balance.push_back(2.0 * two.power_by_balance / v[14] - one.power_by_balance / v[14] - 1.0);
  }
  print_quantiles("force vector / (mu N), reference's grid", force);
  print_quantiles("power, reference's grid, adhesion < 0.9", power);
  print_quantiles("force vector / (mu N), extrapolated in the grid", fine_force);
  print_quantiles("converged power above the reference's, adhesion < 0.9", balance);
  std::printf("%d rows in %.2f s on the reference's grids (set-up included), %d solutions not converged\n",
              row, total, unconverged);
  return 0;
}

int report_kalker() {
  struct Row {
    double ratio, nu, c11, c22, c23;
  };
  // Kalker's printed table, three digits (theory manual, Kalker coefficients).
  const Row rows[] = {
      {0.1, 0.0, 2.51, 2.51, .334},  {0.1, .25, 3.31, 2.52, .473}, {0.1, 0.5, 4.85, 2.53, .731},
      {0.2, 0.0, 2.59, 2.59, .483},  {0.2, .25, 3.37, 2.63, .603}, {0.2, 0.5, 4.81, 2.66, .809},
      {0.5, 0.0, 2.88, 2.88, .827},  {0.5, .25, 3.62, 3.01, .929}, {0.5, 0.5, 4.83, 3.14, 1.07},
      {1.0, 0.0, 3.40, 3.40, 1.33},  {1.0, .25, 4.12, 3.67, 1.47}, {1.0, 0.5, 5.20, 3.98, 1.63},
      {2.0, 0.0, 4.37, 4.37, 2.35},  {2.0, .25, 5.10, 4.90, 2.62}, {2.0, 0.5, 6.11, 5.56, 2.96},
      {5.0, 0.0, 6.96, 6.96, 5.72},  {5.0, .25, 7.78, 8.14, 6.63}, {5.0, 0.5, 8.82, 9.79, 7.89},
      {10.0, 0.0, 10.7, 10.7, 12.2}, {10., .25, 11.7, 12.8, 14.6}, {10., 0.5, 12.9, 16.0, 18.0}};
  std::printf(
      "  a/b    nu |    C11  print   diff |    C22  print   diff |    C23  print   diff |    C33  (+- "
      "estimate)\n");
  for (const Row& r : rows) {
    const ExtrapolatedCoefficients c = extrapolated_coefficients(r.ratio, 0.0, r.nu, 32);
    std::printf(
        "%6.2f  %.2f | %6.3f %6.3f %+5.2f%% | %6.3f %6.3f %+5.2f%% | %6.3f %6.3f %+5.2f%% | %6.3f +- %.3f\n",
        r.ratio, r.nu, c.value.c11, r.c11, 100 * (c.value.c11 / r.c11 - 1), c.value.c22, r.c22,
        100 * (c.value.c22 / r.c22 - 1), c.value.c23, r.c23, 100 * (c.value.c23 / r.c23 - 1), c.value.c33,
        c.error.c33);
  }
  return 0;
}

int report_speed() {
  const SdecPatch patch{.a = 4e-3, .b = 6e-3, .psi = 0.3};
  const Creepage cases[] = {{.longitudinal = 2e-4},
                            {.longitudinal = 1e-3, .lateral = -5e-4, .spin = 0.3},
                            {.spin = 0.6},
                            {.longitudinal = 1e-2, .lateral = 5e-3}};
  std::printf("cells      set-up | per solution: time, iterations, products on the finest grid\n");
  for (const int n : {16, 32, 64, 128, 256}) {
    const Grid grid = grid_over(patch, n, n);
    const Material steel{.shear_modulus = 82e9, .poisson = 0.28};
    std::vector<RollingSolver> solver;
    const double setup = seconds_of([&] { solver.emplace_back(grid, steel); });
    std::printf("%3d x %3d %6.1f ms |", n, n, 1e3 * setup);
    for (const Creepage& creepage : cases) {
      RollingProblem problem;
      problem.pressure = sdec_pressure(patch, 1e9, grid, CellPressure::mean);
      problem.friction = {0.3};
      problem.creepage = creepage;
      RollingSolution s;
      const double time = seconds_of([&] { s = solver[0].solve(problem); });
      std::printf("  %8.1f ms %2d %3d", 1e3 * time, s.iterations, s.products);
    }
    std::printf("\n");
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  if (what == "sdec" && argc > 2) return report_sdec(argv[2]);
  if (what == "kalker") return report_kalker();
  if (what == "speed") return report_speed();
  std::fprintf(stderr, "usage: halfspace_report sdec FILE.csv | kalker | speed\n");
  return 2;
}
