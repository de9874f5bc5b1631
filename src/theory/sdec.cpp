#include "theory/sdec.hpp"

#include <cmath>

#include "theory/node_values.hpp"

namespace wrc::theory {
namespace {

using tables::ratio_count;
using tables::shape_count;
using Nodes = std::array<double, ratio_count + 2>;

/// The table's nodes between the limits -1 (a/b = 0) and 1 (infinity).
Nodes with_limits(const tables::OverRatio& inside, double lowest, double highest) {
  Nodes out{};
  out.front() = lowest;
  for (std::size_t i = 0; i < ratio_count; ++i) out[i + 1] = inside[i];
  out.back() = highest;
  return out;
}

HermiteTable<ratio_count + 2> fading(const tables::OverRatio& values) {
  return {with_limits(tables::slenderness_nodes(), -1.0, 1.0), with_limits(values, 0.0, 0.0)};
}

/// Continued to the limits along the straight lines through the last two nodes.
HermiteTable<ratio_count + 2> extended(const tables::OverRatio& values) {
  const tables::OverRatio u = tables::slenderness_nodes();
  const auto line = [&](std::size_t first, std::size_t second, double at) {
    return values[first] + (values[second] - values[first]) / (u[second] - u[first]) * (at - u[first]);
  };
  return {with_limits(u, -1.0, 1.0),
          with_limits(values, line(0, 1, -1.0), line(ratio_count - 1, ratio_count - 2, 1.0))};
}

/// Weighted least-squares coefficients p, q of  p f_k + q g_k = y_k.
std::array<double, 2> least_squares(const std::array<double, shape_count>& f,
                                    const std::array<double, shape_count>& g,
                                    const std::array<double, shape_count>& y,
                                    const std::array<double, shape_count>& weight) {
  double ff = 0.0, fg = 0.0, gg = 0.0, fy = 0.0, gy = 0.0;
  for (std::size_t k = 1; k < shape_count; ++k) {  // k = 0 is psi = 0, without influence
    ff += weight[k] * f[k] * f[k];
    fg += weight[k] * f[k] * g[k];
    gg += weight[k] * g[k] * g[k];
    fy += weight[k] * f[k] * y[k];
    gy += weight[k] * g[k] * y[k];
  }
  // normal equations of two unknowns
  const double determinant = ff * gg - fg * fg;
  return {(fy * gg - gy * fg) / determinant, (gy * ff - fy * fg) / determinant};
}

/// -C13s / (0.75 C11 sqrt(b/a) psi) of one entry.
double relative_k13(const tables::LinearTheoryEntry& entry, double c11) {
  return -entry.value[tables::c13s] * std::sqrt(entry.ratio) / (0.75 * c11 * entry.psi);
}

void check_range(const char* field, double value, double low, double high, Fault& fault) {
  if (value >= low && value <= high) return;
  keep_worst(fault,
             Fault::table_range(field, {value, "1", low, high}, "the shape's influence is extrapolated"));
}

}  // namespace

SdecTable::Influence SdecTable::influence(std::size_t coefficient, double poisson) {
  const auto c = static_cast<tables::Coefficient>(coefficient);
  tables::OverRatio second{}, fourth{};
  for (std::size_t i = 0; i < ratio_count; ++i) {
    // Cs / C - 1 at the nodes psi of one a/b, fitted by b psi^2 + d psi^4
    std::array<double, shape_count> psi2{}, psi4{}, change{}, weight{};
    for (std::size_t k = 0; k < shape_count; ++k) {
      psi2[k] = tables::shape_node(k) * tables::shape_node(k);
      weight[k] = tables::weight(c, i, k);
      psi4[k] = psi2[k] * psi2[k];
      change[k] = tables::reciprocal(c, i, 0, poisson) / tables::reciprocal(c, i, k, poisson) - 1.0;
    }
    const auto [b, d] = least_squares(psi2, psi4, change, weight);
    second[i] = b;
    fourth[i] = d;
  }
  return {fading(second), fading(fourth)};
}

SdecTable::SdecTable(double poisson)
    : poisson_(poisson),
      ellipse_(poisson),
      c11_(influence(tables::c11s, poisson)),
      c22_(influence(tables::c22s, poisson)),
      c23_(influence(tables::c23s, poisson)) {
  tables::OverRatio constant{}, second{};
  for (std::size_t i = 0; i < ratio_count; ++i) {
    // K13 / (0.75 C11 sqrt(b/a)) at the nodes psi > 0 of one a/b, fitted by k + m psi^2
    std::array<double, shape_count> one{}, psi2{}, k13{}, weight{};
    for (std::size_t k = 1; k < shape_count; ++k) {
      one[k] = 1.0;
      weight[k] = tables::weight(tables::c13s, i, k);
      psi2[k] = tables::shape_node(k) * tables::shape_node(k);
      std::array<double, 3> at_node{};
      for (std::size_t n = 0; n < 3; ++n) {
        at_node[n] = relative_k13(tables::entry(n, i, k), tables::entry(n, i, 0).value[tables::c11s]);
      }
      k13[k] = tables::at_poisson(at_node, poisson);
    }
    const auto [k, m] = least_squares(one, psi2, k13, weight);
    constant[i] = k;
    second[i] = m;
  }
  k13_ = extended(constant);
  k13_second_ = extended(second);
}

SdecCoefficients SdecTable::at(double ratio, double shape_number, Fault& fault) const {
  const KalkerCoefficients ellipse = ellipse_.at(ratio, fault);  // flags the axis ratio
  check_range("shape number psi", shape_number, -tables::highest_shape, tables::highest_shape, fault);
  // the ellipse's coefficients times 1 + b psi^2 + d psi^4; K13 = 0.75 C11 sqrt(b/a) (k + m psi^2)
  const double u = slenderness(ratio);
  const double psi2 = shape_number * shape_number;
  const auto factor = [&](const Influence& influence) {
    return 1.0 + psi2 * (influence.second(u).value + psi2 * influence.fourth(u).value);
  };
  SdecCoefficients c;
  c.c11 = ellipse.c11 * factor(c11_);
  c.c22 = ellipse.c22 * factor(c22_);
  c.c23 = ellipse.c23 * factor(c23_);
  c.k13 = (k13_(u).value + k13_second_(u).value * psi2) * 0.75 * ellipse.c11 / std::sqrt(ratio);
  c.c13 = -c.k13 * shape_number;
  return c;
}

}  // namespace wrc::theory
