#include "surface/rolling/strip_coefficients.hpp"

#include <algorithm>
#include <cmath>

#include "normal/elasticity/elliptic_integrals.hpp"

namespace wrc::surface {
namespace {

constexpr double narrowest = 0.05, widest = 60.0;  // a/b

/// a/b of the ellipse with the given m, between the ends of the table.
double ratio_of(double m) {
  // bisection over the logarithm: m falls with a/b
  double low = narrowest, high = widest;
  for (int n = 0; n < 60; ++n) {
    const double middle = std::sqrt(low * high);
    (hertz_relative_curvature(middle) > m ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

}  // namespace

double hertz_relative_curvature(double ratio) {
  if (ratio > 1.0) return 2.0 / ratio * normal::complete_elliptic(1.0 / ratio).d;
  const normal::CompleteElliptic e = normal::complete_elliptic(ratio);
  return 2.0 * (e.k - e.d);
}

StripCoefficientTable::StripCoefficientTable(const theory::KalkerTable& ellipse)
    : poisson_(ellipse.poisson()) {
  // Products with m, which hardly depend on it, and the slenderness, at the a/b that m stands for. Beyond the
  // ellipse's own tables its coefficients are asymptotes: no fault here.
  constexpr int steps = StripCoefficientNodes::steps, quantities = StripCoefficientNodes::quantities;
  nodes_.low = hertz_relative_curvature(widest);
  nodes_.step = (hertz_relative_curvature(narrowest) - nodes_.low) / steps;
  for (int i = 0; i <= steps; ++i) {
    const double m = nodes_.low + i * nodes_.step, ratio = ratio_of(m);
    Fault beyond_the_tables;
    const theory::KalkerCoefficients c = ellipse.at(ratio, beyond_the_tables);
    auto& node = nodes_.node[i];
    node[0][0] = m * c.c11;
    node[1][0] = m * c.c22;
    node[2][0] = m * c.c23 / std::sqrt(ratio);
    node[3][0] = ::wrc::theory::slenderness(ratio);
  }
  // Slope at a node [per step]: that of the parabola through it and its neighbours, at an end of the table
  // through the last three nodes.
  for (int i = 0; i <= steps; ++i) {
    const int m = std::clamp(i, 1, steps - 1);
    for (int k = 0; k < quantities; ++k) {
      const double before = nodes_.node[m - 1][k][0], here = nodes_.node[m][k][0],
                   behind = nodes_.node[m + 1][k][0];
      nodes_.node[i][k][1] = 0.5 * (behind - before) + (behind - 2.0 * here + before) * (i - m);
    }
  }
}

}  // namespace wrc::surface
