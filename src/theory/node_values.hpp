/// Columns of the generated tables at one Poisson ratio.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "theory/generated_tables.hpp"
#include "theory/hermite.hpp"

namespace wrc::theory::tables {

/// Columns of LinearTheoryEntry::value.
enum Coefficient : std::size_t { c11s, c22s, c23s, c13s };

using OverRatio = std::array<double, ratio_count>;

constexpr const LinearTheoryEntry& entry(std::size_t poisson, std::size_t ratio, std::size_t shape) {
  return linear_theory[(poisson * ratio_count + ratio) * shape_count + shape];
}
constexpr double ratio_node(std::size_t i) { return entry(0, i, 0).ratio; }
constexpr double shape_node(std::size_t i) { return entry(0, 0, i).psi; }
constexpr double lowest_ratio = ratio_node(0), highest_ratio = ratio_node(ratio_count - 1);
constexpr double highest_shape = shape_node(shape_count - 1);

/// The parabola in the Poisson ratio through values at its nodes 0, 0.25, 0.5.
constexpr double at_poisson(const std::array<double, 3>& value, double poisson) {
  const double t = poisson / poisson_nodes[1];  // 0, 1, 2 at the nodes
  return 0.5 * (t - 1.0) * (t - 2.0) * value[0] - t * (t - 2.0) * value[1] + 0.5 * t * (t - 1.0) * value[2];
}

/// Reciprocal of one of C11s, C22s, C23s. Reciprocals, because 1/C11 and 1/C22 are nearly linear in the
/// Poisson ratio (for C11 of a narrow patch exactly so): the parabola is good to 0.03 %. That through
/// (1 + nu) / C23 is good to 0.2 %, and to 0.1 % for nu from 0.2 to 0.32; through 1/C23 itself, to 0.8 %.
inline double reciprocal(Coefficient c, std::size_t ratio, std::size_t shape, double poisson) {
  // factor / C is interpolated, factor 1 + nu for C23
  const auto factor = [c](double nu) { return c == c23s ? 1.0 + nu : 1.0; };
  std::array<double, 3> value{};
  for (std::size_t k = 0; k < 3; ++k) value[k] = factor(poisson_nodes[k]) / entry(k, ratio, shape).value[c];
  return at_poisson(value, poisson) / factor(poisson);
}

/// Weight of an entry in fits over psi: the inverse square of its relative error estimate, the worst over the
/// Poisson ratios, with 0.1 % added so that none counts as exact.
inline double weight(Coefficient c, std::size_t ratio, std::size_t shape) {
  double error = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const LinearTheoryEntry& e = entry(k, ratio, shape);
    error = std::max(error, e.error[c] / std::abs(e.value[c]));
  }
  return 1.0 / ((error + 1e-3) * (error + 1e-3));
}

inline OverRatio slenderness_nodes() {
  OverRatio u{};
  for (std::size_t i = 0; i < ratio_count; ++i) u[i] = slenderness(ratio_node(i));
  return u;
}

}  // namespace wrc::theory::tables
