// The neutral line of spin that C33 and K13 of linear theory ask for, against the formula of
// strip_fastsim.cpp:
//     neutral_line
// Linear theory by the exact solver on 16 x 16 and 24 x 24 cells, extrapolated: half a minute.

#include <cmath>
#include <cstdio>

#include "linear_theory/linear_theory.hpp"
#include "patch/material.hpp"
#include "tangential/methods/strip_fastsim.hpp"

namespace {

using namespace wrc;

struct Spin {
  double c33, k13;
};

/// K13 = -C13 / psi; at psi = 0 that of psi = 0.2, on which it hardly depends.
Spin spin_coefficients(double ratio, double psi, double poisson) {
  const halfspace::LinearTheory theory(ratio, poisson, 32);
  const double shape = psi > 0.0 ? psi : 0.2;
  return {theory.at(psi).value.c33, -theory.at(shape).value.c13 / shape};
}

}  // namespace

int main() {
  double largest = 0.0;
  std::printf("   nu    a/b   psi     C33     K13     chi  formula\n");
  for (double poisson : {0.25, 0.30}) {
    for (double ratio : {0.2, 1.0 / 3.0, 0.5, 0.7, 1.0, 1.4, 2.0, 3.0, 5.0}) {
      for (double psi : {0.0, 0.35, 0.7}) {
        const Spin spin = spin_coefficients(ratio, psi, poisson);
        // C33 / K13 (c / b) = (pi/8 (1 + 3 psi^2) - 4/3 chi psi^2) / (4/3 - chi pi/2), with
        // c / b = sqrt(a / b)
        const double q = spin.c33 / spin.k13 * std::sqrt(ratio);
        const double chi =
            (q * 4.0 / 3.0 - pi / 8.0 * (1.0 + 3.0 * psi * psi)) / (q * pi / 2.0 - 4.0 / 3.0 * psi * psi);
        const double formula = tangential::neutral_line((ratio - 1.0) / (ratio + 1.0), poisson, psi);
        largest = std::fmax(largest, std::fabs(chi - formula));
        std::printf("%5.2f %6.3f %5.2f %7.4f %7.4f %7.4f %8.4f\n", poisson, ratio, psi, spin.c33, spin.k13,
                    chi, formula);
      }
    }
  }
  std::printf("largest difference %.4f\n", largest);
  return 0;
}
