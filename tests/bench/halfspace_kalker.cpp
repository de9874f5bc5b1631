// The linear theory computed from the half-space equations against Kalker's printed coefficients.
#include <algorithm>

#include "bench/halfspace_report.hpp"
#include "halfspace/linear_theory.hpp"

namespace wrc::halfspace::report {

Json kalker() {
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
  Json json;
  std::vector<Json> list;
  double worst = 0.0;
  for (const Row& r : rows) {
    const ExtrapolatedCoefficients c = extrapolated_coefficients(r.ratio, 0.0, r.nu, 32);
    std::printf(
        "%6.2f  %.2f | %6.3f %6.3f %+5.2f%% | %6.3f %6.3f %+5.2f%% | %6.3f %6.3f %+5.2f%% | %6.3f +- %.3f\n",
        r.ratio, r.nu, c.value.c11, r.c11, 100 * (c.value.c11 / r.c11 - 1), c.value.c22, r.c22,
        100 * (c.value.c22 / r.c22 - 1), c.value.c23, r.c23, 100 * (c.value.c23 / r.c23 - 1), c.value.c33,
        c.error.c33);
    const double differences[] = {c.value.c11 / r.c11 - 1.0, c.value.c22 / r.c22 - 1.0,
                                  c.value.c23 / r.c23 - 1.0};
    for (const double each : differences) worst = std::max(worst, std::abs(each));
    Json row;
    row.add("a_over_b", r.ratio);
    row.add("poisson", r.nu);
    row.add("c11_difference", differences[0]);
    row.add("c22_difference", differences[1]);
    row.add("c23_difference", differences[2]);
    row.add("c33", c.value.c33);
    row.add("c33_error_estimate", c.error.c33);
    list.push_back(row);
  }
  json.add("worst_difference", worst);
  json.add("rows", list);
  return json;
}

}  // namespace wrc::halfspace::report
