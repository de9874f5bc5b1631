#include "normal/hertz_theory.hpp"

#include <algorithm>
#include <cmath>

#include "normal/elliptic_integrals.hpp"
#include "patch/material.hpp"

namespace wrc {

HertzShape hertz_shape(double curvature_ratio) noexcept {
  // Under p0 sqrt(1 - (x_M/M)^2 - (x_m/m)^2), M the major and m the minor semi-axis, k' = m / M,
  //   u / (c pi p0 m) = K - D (x_M/M)^2 - (K - D) (x_m/m)^2,
  // so that the gap coefficients obey C_M / C_m = k'^2 D / (K - D).
  curvature_ratio = std::clamp(curvature_ratio, 1e-8, 1e8);
  const bool long_in_x = curvature_ratio < 1.0;
  const double target = long_in_x ? curvature_ratio : 1.0 / curvature_ratio;

  // The map k' -> sqrt(target (K - D) / D) has slope 0 to 0.25 everywhere; the secant rule on its fixed point
  // needs no bracket.
  CompleteElliptic integrals;
  const auto map = [&](double complement) {
    integrals = complete_elliptic(complement);
    return std::min(1.0, std::sqrt(target * (integrals.k - integrals.d) / integrals.d));
  };
  double previous = std::sqrt(target);
  double defect = previous - map(previous);
  double complement = previous - defect;
  constexpr int cap = 20;  // 4 to 6 are used
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
  const double eps_major = integrals.d / integrals.k;
  shape.axis_ratio = long_in_x ? 1.0 / complement : complement;
  shape.eps_x = long_in_x ? eps_major : 1.0 - eps_major;
  shape.eps_y = 1.0 - shape.eps_x;
  shape.centre = pi * std::sqrt(complement) * integrals.k;
  return shape;
}

HertzEllipse hertz_ellipse(double coefficient_x, double coefficient_y, double approach,
                           double normal_compliance) noexcept {
  const HertzShape shape = hertz_shape(coefficient_x / coefficient_y);
  HertzEllipse ellipse;
  ellipse.a = std::sqrt(shape.eps_x * approach / coefficient_x);
  ellipse.b = ellipse.a / shape.axis_ratio;
  const double c = std::sqrt(ellipse.a * ellipse.b);
  if (c == 0.0) return ellipse;
  ellipse.peak = approach / (normal_compliance * shape.centre * c);
  ellipse.normal_force = 2.0 / 3.0 * pi * ellipse.a * ellipse.b * ellipse.peak;
  return ellipse;
}

}  // namespace wrc
