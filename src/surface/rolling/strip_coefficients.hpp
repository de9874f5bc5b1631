/// Linear theory of a strip on its own: Kalker's coefficients as functions of the strip's own numbers.
///
/// In Hertz's contact every strip along x has the same peak per length lambda (peak pressure over half
/// length), and
///
///     m = kappa / (pi C lambda),   C = (1 - nu) / (pi G),
///
/// kappa the curvature of the undeformed gap along x, depends on a/b alone: 2 for a / b -> 0, pi/2 for a
/// circle, 0.82 for 5. So m of a strip stands for the a/b of the ellipse whose strips are held by their
/// neighbours as this one is. Products of the coefficients with m hardly depend on it: adhesion tractions go
/// with lambda.
#pragma once

#include "base/dual.hpp"
#include "theory/kalker.hpp"

namespace wrc::surface {

/// m of Hertz's ellipse of the axis ratio a/b > 0:
///     m = 2 Int_0^{pi/2} cos^2 t / sqrt(cos^2 t + (a/b)^2 sin^2 t) dt.
double hertz_relative_curvature(double ratio);

template <class Number>
struct StripCoefficientsOf {
  Number c11 = 0.0, c22 = 0.0;  ///< Kalker's C11, C22 [-]
  Number c23 = 0.0;             ///< Kalker's C23 sqrt(b/a) [-]
  Number slenderness = 0.0;     ///< (a - b) / (a + b)
};
using StripCoefficients = StripCoefficientsOf<double>;

/// Nodes of a table of products of the coefficients with m, and of the slenderness, on equal steps.
struct StripCoefficientNodes {
  static constexpr int steps = 128, quantities = 4;
  double low, step;                       ///< m of the first node, and from one to the next
  double node[steps + 1][quantities][2];  ///< value, slope per step
};

/// A quantity at the share `t` of a step behind its first node (cubic Hermite), or `beyond` the table's end
/// [steps], negative before its begin, where it goes on along the end's slope.
template <class Number, class Plain>
Number between_nodes(const Plain& first, const Plain& first_slope, const Plain& second,
                     const Plain& second_slope, const Number& t, const Number& beyond) {
  const Plain rise = second - first;
  const Plain c2 = 3.0 * rise - 2.0 * first_slope - second_slope;
  const Plain c3 = first_slope + second_slope - 2.0 * rise;
  return first + t * (first_slope + t * (c2 + t * c3)) +
         beyond * select(value_of(beyond) < 0.0, first_slope, second_slope);
}

/// Place of m in the table [steps]: the part within it, and the part beyond it, which tends to one step.
template <class Number>
struct PlaceInTable {
  Number inside, beyond;

  PlaceInTable(const StripCoefficientNodes& table, const Number& m) {
    const Number place = (m - table.low) / table.step;
    inside = smaller(larger(place, Number(0.0)), Number(static_cast<double>(StripCoefficientNodes::steps)));
    beyond = (place - inside) / (1.0 + magnitude(place - inside));
  }
};

/// The coefficients from the four quantities of the table.
template <class Number>
StripCoefficientsOf<Number> coefficients_of(const Number (&product)[StripCoefficientNodes::quantities],
                                            const Number& m) {
  const Number inverse = Number(1.0) / m;
  return {product[0] * inverse, product[1] * inverse, product[2] * inverse,
          smaller(larger(product[3], Number(-1.0)), Number(1.0))};
}

/// The coefficients over m for one Poisson ratio, C1 in m.
///
/// Tabulated over m of a/b = 0.05 to 60 (beyond 20 Kalker's asymptotes): products with m, on equal steps. For
/// larger or smaller m their slope at the table's end fades out: any m > 0 gives finite, positive numbers.
class StripCoefficientTable {
 public:
  StripCoefficientTable() = default;
  explicit StripCoefficientTable(const theory::KalkerTable& ellipse);

  double poisson() const { return poisson_; }
  const StripCoefficientNodes& nodes() const { return nodes_; }

 private:
  double poisson_ = 0.0;
  StripCoefficientNodes nodes_{.low = 0.0, .step = 1.0, .node = {}};
};

/// The coefficients of a strip; for packs of strips: surface/simd/strip_numbers_kernel.hpp. Numbers with more
/// inputs than m take the derivative by m, then the chain rule to all inputs.
template <class Number>
StripCoefficientsOf<Number> coefficients_at(const StripCoefficientNodes& table, const Number& m) {
  if constexpr (has_more_inputs<1, Number>) {
    using One = typename Number::template Few<1>;
    const StripCoefficientsOf<One> c = coefficients_at(table, One::input(m.value, 0));
    const auto by_inputs = [&](const One& a) { return m.chain(a.value, a.derivative(0)); };
    return {by_inputs(c.c11), by_inputs(c.c22), by_inputs(c.c23), by_inputs(c.slenderness)};
  } else {
    // the step of the table in which m lies, its end in the last one; t: share of the step [-]
    constexpr int quantities = StripCoefficientNodes::quantities, last = StripCoefficientNodes::steps - 1;
    const PlaceInTable<Number> place(table, m);
    const int whole = static_cast<int>(value_of(place.inside)), i = whole < last ? whole : last;
    const Number t = place.inside - static_cast<double>(i);
    const auto &first = table.node[i], &second = table.node[i + 1];
    Number product[quantities];
    for (int k = 0; k < quantities; ++k)
      product[k] = between_nodes(first[k][0], first[k][1], second[k][0], second[k][1], t, place.beyond);
    return coefficients_of(product, m);
  }
}

}  // namespace wrc::surface
