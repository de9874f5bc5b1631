/// Contact problems with closed solutions: Hertz (elliptic contact without friction) and Carter (rolling of
/// long cylinders). Independent of the solvers they check.
#pragma once

#include <algorithm>
#include <cmath>

#include "halfspace/grid.hpp"
#include "patch/material.hpp"

namespace wrc::halfspace::closed_forms {

/// Complete elliptic integrals by the arithmetic-geometric mean (Abramowitz & Stegun 17.6), m = k^2.
struct EllipticIntegrals {
  double k, e;
};
inline EllipticIntegrals elliptic(double m) {
  double a = 1.0, b = std::sqrt(1.0 - m), c = std::sqrt(m), sum = 0.5 * c * c, power = 1.0;
  while (std::abs(c) > 1e-15) {
    c = 0.5 * (a - b);
    const double next = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = next;
    sum += power * c * c;
    power *= 2.0;
  }
  const double k = pi / (2.0 * a);
  return {k, k * (1.0 - sum)};
}

/// Hertz for given semi-axes a <= b and peak pressure (Johnson 3.36 to 3.41 for two bodies): under the
/// ellipse
///     u_z = p0 (1-nu)/G [a K - a (K-E)/(m b^2) y^2 - a (b^2/a^2 E - K)/(m b^2) x^2],  m = 1 - a^2/b^2.
struct Hertz {
  double curvature_x, curvature_y;  // h = (curvature_x x^2 + curvature_y y^2) / 2
  double approach, load;
};
inline Hertz hertz(const patch::Material& material, double a, double b, double p0) {
  const double m = 1.0 - a * a / (b * b);
  const auto [k, e] = elliptic(m);
  const double flexibility = p0 * (1.0 - material.poisson) / material.shear_modulus;
  const double along_long = m > 0.0 ? a / (b * b) * (k - e) / m : 0.25 * pi / a;
  const double along_short = m > 0.0 ? (e * b * b / (a * a) - k) * a / (b * b) / m : 0.25 * pi / a;
  return {.curvature_x = 2.0 * flexibility * along_short,
          .curvature_y = 2.0 * flexibility * along_long,
          .approach = flexibility * a * k,
          .load = 2.0 / 3.0 * pi * a * b * p0};
}

/// Semi-axes from the second moments of a pressure field centred at the origin: for the half ellipsoid of
/// Hertz the mean of x^2 under the pressure is a^2 / 5. Finer than the cells, where counting them is not.
struct Axes {
  double a, b;
};
inline Axes axes(const Grid& grid, const Field& pressure) {
  double load = 0.0, xx = 0.0, yy = 0.0;
  for (int j = 0; j < grid.ny; ++j) {
    for (int i = 0; i < grid.nx; ++i) {
      const double p = pressure[grid.index(i, j)];
      load += p;
      xx += p * grid.x(i) * grid.x(i);
      yy += p * grid.y(j) * grid.y(j);
    }
  }
  return {std::sqrt(5.0 * xx / load), std::sqrt(5.0 * yy / load)};
}

/// Carter 1926 (Johnson 8.2): long cylinders of half contact length a under p0 sqrt(1 - (x/a)^2), rolling
/// with slip. `compliance` is (1-nu)/G for longitudinal creepage, in plane strain, and 1/G for lateral
/// creepage, out of plane:
///     |nu| = 2 mu p0 compliance (1 - c/a),   |F|/(mu N) = 1 - (c/a)^2,
/// with adhesion over a length 2c from the leading edge.
struct Carter {
  double a, bound;  // bound = mu p0
  double c;         // half length of the adhesion zone

  Carter(double half_length, double mu_p0, double compliance, double creepage)
      : a(half_length),
        bound(mu_p0),
        c(half_length * std::max(0.0, 1.0 - std::abs(creepage) / (2.0 * mu_p0 * compliance))) {}

  /// |F| / (mu N)
  double force() const { return 1.0 - c * c / (a * a); }

  /// |traction| at x, the leading edge at +a [Pa].
  double traction(double x) const {
    const double full = bound * std::sqrt(std::max(0.0, 1.0 - x * x / (a * a)));
    const double d = x - (a - c);
    return full - bound / a * std::sqrt(std::max(0.0, c * c - d * d));
  }
};

}  // namespace wrc::halfspace::closed_forms
