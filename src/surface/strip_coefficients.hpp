/// Linear theory of a strip on its own: Kalker's coefficients as functions of the strip's own numbers.
///
/// In Hertz's contact every strip along x has the same level lambda (peak pressure over half length), and
///
///     m = kappa / (pi C lambda),   C = (1 - nu) / (pi G),
///
/// kappa the curvature of the undeformed gap along x, depends on a/b alone: 2 for a / b -> 0, pi/2 for a
/// circle, 0.82 for 5. So m of a strip stands for the a/b of the ellipse whose strips are held by their
/// neighbours as this one is. Products of the coefficients with m hardly depend on it: adhesion tractions go
/// with lambda.
#pragma once

#include <algorithm>
#include <array>

#include "base/dual.hpp"
#include "theory/kalker.hpp"

namespace wrc {

/// m of Hertz's ellipse of the axis ratio a/b > 0: 2 Int_0^{pi/2} cos^2 t / sqrt(cos^2 t + (a/b)^2 sin^2 t)
/// dt.
double hertz_level(double ratio);

template <class Number>
struct StripCoefficientsOf {
  Number c11 = 0.0, c22 = 0.0;  ///< Kalker's C11, C22 [-]
  Number c23 = 0.0;             ///< Kalker's C23 sqrt(b/a) [-]
  Number slenderness = 0.0;     ///< (a - b) / (a + b)
};
using StripCoefficients = StripCoefficientsOf<double>;

/// The coefficients over m for one Poisson ratio, C1 in m.
///
/// Tabulated over m of a/b = 0.05 to 60 (beyond 20 Kalker's asymptotes): products with m, on equal steps. For
/// larger or smaller m their slope at the table's end fades out: any m > 0 gives finite, positive numbers.
class StripCoefficientTable {
 public:
  StripCoefficientTable() = default;
  explicit StripCoefficientTable(const KalkerTable& ellipse);

  template <class Number>
  StripCoefficientsOf<Number> at(const Number& m) const {
    const Number place = (m - low_) / step_;
    const Number inside = smaller(larger(place, Number(0.0)), Number(static_cast<double>(steps)));
    const Number beyond = (place - inside) / (1.0 + magnitude(place - inside));
    const int i = std::min(static_cast<int>(value_of(inside)), steps - 1);
    const Number t = inside - static_cast<double>(i);
    const auto& first = nodes_[static_cast<std::size_t>(i)];
    const auto& second = nodes_[static_cast<std::size_t>(i) + 1];
    std::array<Number, quantities> product{};
    for (std::size_t k = 0; k < quantities; ++k) {
      const double rise = second[k].value - first[k].value, m0 = first[k].slope, m1 = second[k].slope;
      const double c2 = 3.0 * rise - 2.0 * m0 - m1, c3 = m0 + m1 - 2.0 * rise;
      product[k] =
          first[k].value + t * (m0 + t * (c2 + t * c3)) + beyond * (value_of(beyond) < 0.0 ? m0 : m1);
    }
    const Number inverse = Number(1.0) / m;
    return {product[0] * inverse, product[1] * inverse, product[2] * inverse,
            smaller(larger(product[3], Number(-1.0)), Number(1.0))};
  }
  /// By m alone first.
  template <std::size_t n>
  requires(n > 1) StripCoefficientsOf<Dual<n>> at(const Dual<n>& m)
  const {
    const StripCoefficientsOf<Dual<1>> c = at(Dual<1>::input(m.value, 0));
    const auto by_inputs = [&](const Dual<1>& a) { return m.chain(a.value, a.d[0]); };
    return {by_inputs(c.c11), by_inputs(c.c22), by_inputs(c.c23), by_inputs(c.slenderness)};
  }
  double poisson() const { return poisson_; }

 private:
  static constexpr int steps = 128, quantities = 4;
  struct Node {
    double value, slope;  ///< slope per step
  };
  double poisson_ = 0.0, low_ = 0.0, step_ = 1.0;
  std::array<std::array<Node, quantities>, steps + 1> nodes_{};
};

}  // namespace wrc
