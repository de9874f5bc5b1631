#include "normal/elasticity/contact_condition.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/elementary.hpp"
#include "normal/elasticity/elliptic_integrals.hpp"
#include "normal/elasticity/octave_axis.hpp"
#include "normal/simd/tasks.hpp"

namespace wrc::normal {
namespace {

/// Int_0^t ln(s) ds for the signed t: odd in t.
double integral_of_log(double t) { return t == 0.0 ? 0.0 : t * (natural_log(std::abs(t)) - 1.0); }

/// J(tau) = 2 D / r, k' = tau / r, r = sqrt(1 + tau^2): the displacement of a line of half length 1, and its
/// slope.
constexpr Slope line_slope(double tau) {
  // k^2 = 1 / (1 + tau^2), dk^2 / dtau = -2 tau k^4.
  const double m = 1.0 / (1.0 + tau * tau);
  const double inverse_r = RootInTables{}(m);
  const double complement = tau * inverse_r;
  const CompleteElliptic integrals = complete_elliptic<RootInTables>(complement);
  const double d_slope = -2.0 * tau * m * m * by_parameter(integrals, complement).d;
  return {2.0 * integrals.d * inverse_r, 2.0 * inverse_r * (d_slope - integrals.d * tau * m)};
}

/// J between the nodes by cubics, to a millionth; written by the compiler, so that its bits are the same
/// everywhere.
constexpr auto line_table = [] {
  std::array<Cubic, line_axis.intervals()> table{};
  Slope from = line_slope(line_axis.node(0));
  for (int i = 0; i < line_axis.intervals(); ++i) {
    const double length = line_axis.node(i + 1) - line_axis.node(i);
    const Slope to = line_slope(line_axis.node(i + 1));
    table[static_cast<std::size_t>(i)] = hermite_cubic(from, to, length);
    from = to;
  }
  return table;
}();

}  // namespace

double line_displacement(double half_length, double y) noexcept {
  const double tau = std::abs(y) / half_length;
  // A line far away: pi / (2 tau), bent by its second moment.
  if (tau >= line_axis.node(line_axis.intervals())) return 0.5 * pi / tau * (1.0 - 0.125 / (tau * tau));
  // Between: the tabulated cubic.
  const auto [index, t] = line_axis.locate(tau);
  return line_table[static_cast<std::size_t>(index)].at(t);
}

double strip_displacement(double half_length, double y_from, double y_to) noexcept {
  const double l = half_length;
  const double width = y_to - y_from;
  const double middle = 0.5 * (y_from + y_to);

  if (std::abs(middle) >= width) {
    // Away from the origin the logarithm's mean exceeds its midpoint value by a series in
    // t = width / (2 |middle|):  -mean(ln|y|) + ln|middle| = sum t^{2n} / (2n (2n + 1)),  t <= 1/2.
    const double t2 = width * width / (4.0 * middle * middle);
    double series = 0.0;
    for (int n = 8; n >= 1; --n) series = t2 * (series + 1.0 / (2 * n * (2 * n + 1)));
    // l / r carries the correction over to the far field, pi l / (2 |y|), which bends that much less.
    const double r = std::sqrt(l * l + middle * middle);
    return width * (line_displacement(l, middle) + 2.0 * series * l / r);
  }
  const double y = std::max(std::abs(middle), 1e-6 * l);  // the rest is flat there: y^2 ln y
  // The smooth rest, J + 2 ln(y / l), at the middle; its logarithm integrated over the width exactly.
  const double rest = line_displacement(l, y) + 2.0 * natural_log(y / l);
  return width * rest - 2.0 * l * (integral_of_log(y_to / l) - integral_of_log(y_from / l));
}

double impose_approach(const Kernels& kernels, double approach, const patch::Material& material, double x,
                       double y, patch::Strips& strips) noexcept {
  // Displacement at the point by each strip. The array of the pressures, found last, holds it until then.
  kernels.normal.displacements_at({&line_table[0].c0, x, y, strips.count},
                                  {strips.y, strips.width, strips.centre, strips.half_length}, strips.peak);

  double displacement = 0.0;  // per unit of peak / half length and of the compliance [m^2]
  double load = 0.0;          // per unit of peak / half length [m^3]
  for (std::int32_t j = 0; j < strips.count; ++j) {
    const double dy = strips.y[j] - y;
    const double l = strips.half_length[j];
    double by_strip = strips.peak[j];
    // Strips at the point: the logarithm integrated. The factor is that of a middle shifted in x (header).
    if (std::abs(dy) < 1.001 * strips.width[j]) {
      const double shift = strips.centre[j] - x, half_width = 0.5 * strips.width[j];
      by_strip = l * strip_displacement(l, dy - half_width, dy + half_width) *
                 std::sqrt((l * l + dy * dy) / (l * l + dy * dy + shift * shift));
    }
    displacement += by_strip;
    load += 0.5 * pi * l * l * strips.width[j];
  }
  // One factor to all pressures makes the displacement at (x, y) the approach; the load follows from it.
  const double peak_per_length = approach / (material.normal_compliance() * displacement);
  for (std::int32_t j = 0; j < strips.count; ++j) strips.peak[j] = peak_per_length * strips.half_length[j];
  return peak_per_length * load;
}

}  // namespace wrc::normal
