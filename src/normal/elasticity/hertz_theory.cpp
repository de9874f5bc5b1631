#include "normal/elasticity/hertz_theory.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "normal/elasticity/elliptic_integrals.hpp"
#include "normal/elasticity/octave_axis.hpp"
#include "patch/material.hpp"

namespace wrc::normal {
namespace {

constexpr double least_ratio = 1e-8;

/// The tabulated quantities, with derivatives by the curvature ratio q = k'^2 D / (K - D) <= 1 of the major
/// to the minor axis.
struct ShapeSlopes {
  Slope complement;  ///< k', the axis ratio minor / major
  Slope eps_major;   ///< D / K
  Slope centre;      ///< pi sqrt(k') K
};

/// Values and derivatives by q at q; `parameter` is a guess of k'^2, and becomes it.
constexpr ShapeSlopes shape_slopes(double q, double& parameter) {
  CompleteElliptic at;
  EllipticDerivatives by_m;
  double q_by_m = 0.0;
  // Newton's rule for m = k^2 in k'^2 D / (K - D) = q.
  constexpr int newton_steps = 6;  // from a guess a tenth off 4 are enough
  for (int i = 0; i <= newton_steps; ++i) {
    const double complement = RootInTables{}(parameter);
    at = complete_elliptic<RootInTables>(complement);
    by_m = by_parameter(at, complement);
    const double b = at.k - at.d;
    q_by_m = (parameter * (by_m.d * b - at.d * (by_m.k - by_m.d)) / b - at.d) / b;
    if (i == newton_steps) break;
    // k'^2 falls as m grows.
    const double step = (parameter * at.d / b - q) / q_by_m;
    parameter = std::min(1.0, parameter + step);
  }
  const double complement = RootInTables{}(parameter);
  // Chain rule: d / dq = (d / dm) / (dq / dm), with dk'/dm = -1 / (2 k').
  const double root = RootInTables{}(complement);
  return {{complement, -0.5 / (complement * q_by_m)},
          {at.d / at.k, (by_m.d - at.d / at.k * by_m.k) / (at.k * q_by_m)},
          {pi * root * at.k, pi * root * (by_m.k - 0.25 * at.k / parameter) / q_by_m}};
}

constexpr OctaveAxis ratio_axis{-27, 27, 3};  // 7e-9 .. 1

struct ShapeCubics {
  Cubic complement, eps_major, centre;
};

constexpr auto shape_table = [] {
  std::array<ShapeCubics, ratio_axis.intervals()> table{};
  // Downwards from the circle, q = 1, where k' = 1: each node starts at the solution of the last.
  double parameter = 1.0;
  ShapeSlopes to = shape_slopes(1.0, parameter);
  for (int i = ratio_axis.intervals() - 1; i >= 0; --i) {
    const double q = ratio_axis.node(i), length = ratio_axis.node(i + 1) - q;
    parameter *= q / ratio_axis.node(i + 1);
    const ShapeSlopes from = shape_slopes(q, parameter);
    table[static_cast<std::size_t>(i)] = {hermite_cubic(from.complement, to.complement, length),
                                          hermite_cubic(from.eps_major, to.eps_major, length),
                                          hermite_cubic(from.centre, to.centre, length)};
    to = from;
  }
  return table;
}();

}  // namespace

HertzShape tabulated_hertz_shape(double curvature_ratio) noexcept {
  const bool long_in_x = curvature_ratio < 1.0;
  const double ratio = std::max(long_in_x ? curvature_ratio : 1.0 / curvature_ratio, least_ratio);
  // The table is for ratios up to 1; the other half is the same with x and y exchanged.
  const auto [index, t] = ratio_axis.locate(ratio);
  const ShapeCubics& cubics = shape_table[static_cast<std::size_t>(index)];
  const double complement = cubics.complement.at(t), eps_major = cubics.eps_major.at(t);
  return {.axis_ratio = long_in_x ? 1.0 / complement : complement,
          .eps_x = long_in_x ? eps_major : 1.0 - eps_major,
          .eps_y = long_in_x ? 1.0 - eps_major : eps_major,
          .centre = cubics.centre.at(t)};
}

HertzShape hertz_shape(double curvature_ratio) noexcept {
  // Under p0 sqrt(1 - (x_M/M)^2 - (x_m/m)^2), M the major and m the minor semi-axis, k' = m / M,
  //   u / (c pi p0 m) = K - D (x_M/M)^2 - (K - D) (x_m/m)^2,
  // so that the gap coefficients obey C_M / C_m = k'^2 D / (K - D).
  curvature_ratio = std::clamp(curvature_ratio, least_ratio, 1.0 / least_ratio);
  const bool long_in_x = curvature_ratio < 1.0;
  const double target = long_in_x ? curvature_ratio : 1.0 / curvature_ratio;

  // The map k' -> sqrt(target (K - D) / D) has slope 0 to 0.25 everywhere; the secant rule on its fixed point
  // needs no bracket.
  CompleteElliptic integrals;
  const auto map = [&](double complement) {
    integrals = complete_elliptic(complement);
    return std::min(1.0, std::sqrt(target * (integrals.k - integrals.d) / integrals.d));
  };
  // The tabulated ratio is right to a millionth: the secant rule has two steps to go.
  double previous = long_in_x ? 1.0 / tabulated_hertz_shape(target).axis_ratio
                              : tabulated_hertz_shape(1.0 / target).axis_ratio;
  double defect = previous - map(previous);
  double complement = previous - defect;
  constexpr int cap = 20;  // 2 are used
  for (int i = 0; i < cap; ++i) {
    const double next_defect = complement - map(complement);
    const double slope = next_defect - defect;
    if (std::abs(next_defect) <= 1e-15 * complement || slope == 0.0) break;
    const double step = next_defect * (complement - previous) / slope;
    previous = complement;
    defect = next_defect;
    complement = std::clamp(complement - step, 0.25 * complement, 1.0);
  }

  HertzShape shape;
  // eps_major = D / K along the major axis; the other is its complement to 1.
  const double eps_major = integrals.d / integrals.k;
  shape.axis_ratio = long_in_x ? 1.0 / complement : complement;
  shape.eps_x = long_in_x ? eps_major : 1.0 - eps_major;
  shape.eps_y = 1.0 - shape.eps_x;
  shape.centre = pi * std::sqrt(complement) * integrals.k;
  return shape;
}

HertzEllipse hertz_ellipse(double coefficient_x, double coefficient_y, double approach,
                           double normal_compliance) noexcept {
  return hertz_ellipse(hertz_shape(coefficient_x / coefficient_y), coefficient_x, approach,
                       normal_compliance);
}

HertzEllipse hertz_ellipse(const HertzShape& shape, double coefficient_x, double approach,
                           double normal_compliance) noexcept {
  HertzEllipse ellipse;
  // A a^2 = eps_x delta.
  ellipse.a = std::sqrt(shape.eps_x * approach / coefficient_x);
  ellipse.b = ellipse.a / shape.axis_ratio;
  const double c = std::sqrt(ellipse.a * ellipse.b);
  if (c == 0.0) return ellipse;
  // delta = c p0 sqrt(a b) centre, and N = (2/3) pi a b p0.
  ellipse.peak = approach / (normal_compliance * shape.centre * c);
  ellipse.normal_force = 2.0 / 3.0 * pi * ellipse.a * ellipse.b * ellipse.peak;
  return ellipse;
}

}  // namespace wrc::normal
