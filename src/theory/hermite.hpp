/// C1 interpolation of tables with few, unevenly spaced nodes.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace wrc::theory {

/// A value and its derivative with respect to the table's variable.
struct Interpolated {
  double value = 0.0;
  double slope = 0.0;
};

/// Cubic Hermite interpolation; the slope at a node is that of the parabola through it and its neighbours.
template <std::size_t n>
struct HermiteTable {
  static_assert(n >= 3);
  std::array<double, n> x{}, y{}, slope{};  ///< nodes with increasing x, values, slopes

  HermiteTable() = default;
  HermiteTable(const std::array<double, n>& nodes, const std::array<double, n>& values)
      : x(nodes), y(values) {
    for (std::size_t i = 0; i < n; ++i) {
      // the parabola through three nodes: weighted slope at the middle one, plus its bending at an end
      const std::size_t m = std::clamp<std::size_t>(i, 1, n - 2);  // at an end: the last three nodes
      const double left = x[m] - x[m - 1], right = x[m + 1] - x[m];
      const double slope_left = (y[m] - y[m - 1]) / left, slope_right = (y[m + 1] - y[m]) / right;
      slope[i] = (slope_left * right + slope_right * left) / (left + right) +
                 2.0 * (slope_right - slope_left) / (left + right) * (x[i] - x[m]);
    }
  }

  /// Value and slope at `at`, which must lie within [x[0], x[n - 1]].
  Interpolated operator()(double at) const {
    // the interval, and y = y_i + t (m0 + t (c2 + t c3)) in it, m0, m1 the slopes at its ends per interval
    std::size_t i = 0;
    while (i + 2 < n && at > x[i + 1]) ++i;
    const double dx = x[i + 1] - x[i];
    const double t = (at - x[i]) / dx;
    const double rise = y[i + 1] - y[i];
    const double m0 = slope[i] * dx, m1 = slope[i + 1] * dx;
    const double c2 = 3.0 * rise - 2.0 * m0 - m1, c3 = m0 + m1 - 2.0 * rise;
    return {y[i] + t * (m0 + t * (c2 + t * c3)), (m0 + t * (2.0 * c2 + 3.0 * t * c3)) / dx};
  }
};

/// (a - b) / (a + b), the variable of every table over the axis ratio a/b: it is tanh(log(a/b) / 2), so
/// smooth in the logarithm of the ratio, bounded, and free of transcendental functions.
constexpr double slenderness(double ratio) { return (ratio - 1.0) / (ratio + 1.0); }

}  // namespace wrc::theory
