// Cost of steady rolling against the size of the grid, and what it is spent on.
#include <algorithm>
#include <ctime>

#include "halfspace/tangential.hpp"
#include "halfspace_report/report.hpp"
#include "sdec_pressure.hpp"

namespace wrc::halfspace::report {
namespace {

constexpr patch::Material steel{.shear_modulus = 82e9, .poisson = 0.28};
constexpr SdecPatch patch{.a = 4e-3, .b = 6e-3, .psi = 0.3};
struct Case {
  const char* name;
  tangential::Creepage creepage;
};
constexpr Case cases[] = {
    {"mostly adhesion", {.longitudinal = 2e-4, .lateral = 0.0, .spin = 0.0}},
    {"all three creepages", {.longitudinal = 1e-3, .lateral = -5e-4, .spin = 0.3}},
    {"pure spin", {.longitudinal = 0.0, .lateral = 0.0, .spin = 0.6}},
    {"full slip", {.longitudinal = 1e-2, .lateral = 5e-3, .spin = 0.0}},
};

// Processor time, not the clock's: other work on the machine counts only through the caches it takes.
double processor_seconds_of(const auto& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

// The fastest of as many runs as fit into about a second, three at least.
double fastest(const auto& work) {
  double best = 1e9, total = 0.0;
  for (int run = 0; run < 3 || (run < 1000 && total < 1.0); ++run) {
    const double time = processor_seconds_of(work);
    best = std::min(best, time);
    total += time;
  }
  return best;
}

}  // namespace

Json speed() {
  constexpr int sizes[] = {32, 64, 128, 256};
  std::printf(
      "Milliseconds of processor time per solution, one core; Newton iterations and FFT products on the "
      "finest grid; "
      "products: "
      "their share\nof the time. Set-up (influence coefficients and spectra) once per grid, product: one "
      "convolution.\n"
      "cells       set-up  product");
  for (const Case& each : cases) std::printf(" | %-30s", each.name);
  std::printf("\n");
  std::vector<Json> list;
  double median[4];  // over the cases
  for (int n = 0; n < 4; ++n) {
    const int cells = sizes[n];
    const Grid grid = grid_over(patch, cells, cells);
    std::vector<RollingSolver> solver;
    const double setup = processor_seconds_of([&] { solver.emplace_back(grid, steel); });
    Convolution convolution(grid, steel, Convolution::Kernel::tangential);
    Field x(grid.cells(), 1.0), y(grid.cells(), 1.0);
    const double product = fastest([&] { convolution.apply(x.data(), y.data(), x.data(), y.data()); });
    std::printf("%3d x %3d %8.1f %8.3f", cells, cells, 1e3 * setup, 1e3 * product);
    Json row;
    row.add("cells", cells);
    row.add("set_up_ms", 1e3 * setup);
    row.add("product_ms", 1e3 * product);
    std::vector<double> times;
    std::vector<Json> results;
    for (const Case& each : cases) {
      RollingProblem problem;
      problem.pressure = sdec_pressure(patch, 1e9, grid, CellPressure::mean);
      problem.friction = {0.3};
      problem.creepage = each.creepage;
      RollingSolution s;
      const double time = fastest([&] { s = solver[0].solve(problem); });
      const double share = s.products * product / time;
      std::printf(" | %8.1f ms %2d %3d, %3.0f %%      ", 1e3 * time, s.iterations, s.products, 100.0 * share);
      times.push_back(time);
      Json result;
      result.add("case", each.name);
      result.add("ms", 1e3 * time);
      result.add("iterations", s.iterations);
      result.add("products", s.products);
      result.add("share_of_products", share);
      results.push_back(result);
    }
    std::printf("\n");
    std::sort(times.begin(), times.end());
    median[n] = 0.5 * (times[1] + times[2]);
    row.add("median_ms", 1e3 * median[n]);
    row.add("cases", results);
    list.push_back(row);
  }
  // Least squares of log time over log cells.
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (int n = 0; n < 4; ++n) {
    const double lx = std::log(static_cast<double>(sizes[n]) * sizes[n]), ly = std::log(median[n]);
    sx += lx;
    sy += ly;
    sxx += lx * lx;
    sxy += lx * ly;
  }
  const double exponent = (4.0 * sxy - sx * sy) / (4.0 * sxx - sx * sx);
  std::printf("median time: 64/32 %.2f, 128/64 %.2f, 256/128 %.2f; time ~ cells^%.2f\n",
              median[1] / median[0], median[2] / median[1], median[3] / median[2], exponent);
  Json json;
  json.add("exponent", exponent);
  json.add("ratio_64_to_32", median[1] / median[0]);
  json.add("ratio_128_to_64", median[2] / median[1]);
  json.add("ratio_256_to_128", median[3] / median[2]);
  json.add("grids", list);
  return json;
}

}  // namespace wrc::halfspace::report
