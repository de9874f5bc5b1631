// The linear theory of ellipses, computed without a grid, against Kalker's printed coefficients.
#include <algorithm>
#include <cmath>

#include "halfspace_report/report.hpp"
#include "linear_theory/ellipse_linear_theory.hpp"
#include "unit/kalker_printed_table.hpp"

namespace wrc::halfspace::report {

Json kalker() {
  std::printf("Lines with a difference of more than 0.7 %% are marked *.\n");
  std::printf("   a/b    nu |    C11  print   diff |    C22  print   diff |    C23  print   diff |    C33\n");
  Json json;
  std::vector<Json> list;
  double worst = 0.0;
  int outside = 0;
  for (const test::PrintedRow& printed : test::kalker_printed_table) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double nu = 0.25 * static_cast<double>(k);
      const LinearCoefficients c = ellipse_linear_coefficients(printed.ratio, nu, 60);
      const double computed[] = {c.c11, c.c22, c.c23};
      const double print[] = {printed.c11[k], printed.c22[k], printed.c23[k]};
      double difference[3];
      double largest = 0.0;
      for (int i = 0; i < 3; ++i) {
        difference[i] = computed[i] / print[i] - 1.0;
        largest = std::max(largest, std::fabs(difference[i]));
        outside += std::fabs(difference[i]) > 7e-3;
      }
      worst = std::max(worst, largest);
      std::printf("%c%6.3f  %.2f |", largest > 7e-3 ? '*' : ' ', printed.ratio, nu);
      for (int i = 0; i < 3; ++i) {
        std::printf(" %6.3f %6.3f %+5.2f%% |", computed[i], print[i], 100.0 * difference[i]);
      }
      std::printf(" %6.3f\n", c.c33);
      Json row;
      row.add("a_over_b", printed.ratio);
      row.add("poisson", nu);
      row.add("c11_difference", difference[0]);
      row.add("c22_difference", difference[1]);
      row.add("c23_difference", difference[2]);
      row.add("c33", c.c33);
      list.push_back(row);
    }
  }
  std::printf("%d of 171 numbers differ by more than 0.7 %%, the worst by %.2f %%\n", outside, 100.0 * worst);
  json.add("worst_difference", worst);
  json.add("outside", outside);
  json.add("rows", list);
  return json;
}

}  // namespace wrc::halfspace::report
