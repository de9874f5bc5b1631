#include "surface/strip_coefficients.hpp"

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
  low_ = hertz_level(widest);
  step_ = (hertz_level(narrowest) - low_) / steps;
  for (int i = 0; i <= steps; ++i) {
    const double m = low_ + i * step_, ratio = ratio_of(m);
    Fault beyond_the_tables;
    const KalkerCoefficients c = ellipse.at(ratio, beyond_the_tables);
    auto& node = nodes_[static_cast<std::size_t>(i)];
    node[0].value = m * c.c11;
    node[1].value = m * c.c22;
    node[2].value = m * c.c23 / std::sqrt(ratio);
    node[3].value = ::wrc::slenderness(ratio);
  }
  for (std::size_t i = 0; i <= steps; ++i) {
    const std::size_t m = std::clamp<std::size_t>(i, 1, steps - 1);  // at an end: the last three nodes
    for (std::size_t k = 0; k < quantities; ++k) {
      const double before = nodes_[m - 1][k].value, here = nodes_[m][k].value,
                   behind = nodes_[m + 1][k].value;
      nodes_[i][k].slope = 0.5 * (behind - before) +
                           (behind - 2.0 * here + before) * (static_cast<double>(i) - static_cast<double>(m));
    }
  }
}

}  // namespace wrc
