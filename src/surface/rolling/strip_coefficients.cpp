#include "surface/rolling/strip_coefficients.hpp"

#include <algorithm>
#include <cmath>

#include "normal/elasticity/elliptic_integrals.hpp"

namespace wrc {
namespace {

constexpr double narrowest = 0.05, widest = 60.0;  // a/b

/// a/b of the ellipse with the given m, between the ends of the table.
double ratio_of(double m) {
  double low = narrowest, high = widest;
  for (int n = 0; n < 60; ++n) {
    const double middle = std::sqrt(low * high);
    (hertz_level(middle) > m ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

}  // namespace

double hertz_level(double ratio) {
  if (ratio > 1.0) return 2.0 / ratio * complete_elliptic(1.0 / ratio).d;
  const CompleteElliptic e = complete_elliptic(ratio);
  return 2.0 * (e.k - e.d);
}

StripCoefficientTable::StripCoefficientTable(const KalkerTable& ellipse) : poisson_(ellipse.poisson()) {
  constexpr int steps = StripCoefficientNodes::steps, quantities = StripCoefficientNodes::quantities;
  nodes_.low = hertz_level(widest);
  nodes_.step = (hertz_level(narrowest) - nodes_.low) / steps;
  for (int i = 0; i <= steps; ++i) {
    const double m = nodes_.low + i * nodes_.step, ratio = ratio_of(m);
    Fault beyond_the_tables;
    const KalkerCoefficients c = ellipse.at(ratio, beyond_the_tables);
    auto& node = nodes_.node[i];
    node[0][0] = m * c.c11;
    node[1][0] = m * c.c22;
    node[2][0] = m * c.c23 / std::sqrt(ratio);
    node[3][0] = ::wrc::slenderness(ratio);
  }
  for (int i = 0; i <= steps; ++i) {
    const int m = std::clamp(i, 1, steps - 1);  // at an end: the last three nodes
    for (int k = 0; k < quantities; ++k) {
      const double before = nodes_.node[m - 1][k][0], here = nodes_.node[m][k][0],
                   behind = nodes_.node[m + 1][k][0];
      nodes_.node[i][k][1] = 0.5 * (behind - before) + (behind - 2.0 * here + before) * (i - m);
    }
  }
}

}  // namespace wrc
