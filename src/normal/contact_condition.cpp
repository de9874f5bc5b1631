#include "normal/contact_condition.hpp"

#include <algorithm>
#include <cmath>

#include "elementary.hpp"
#include "normal/elliptic_integrals.hpp"

namespace wrc {
namespace {

/// Int_0^t ln(s) ds for the signed t: odd in t.
double integral_of_log(double t) { return t == 0.0 ? 0.0 : t * (natural_log(std::abs(t)) - 1.0); }

}  // namespace

double line_displacement(double half_length, double y) noexcept {
  const double r = std::sqrt(half_length * half_length + y * y);
  return 2.0 * half_length * complete_elliptic(std::abs(y) / r).d / r;
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
  const double rest = line_displacement(l, y) + 2.0 * natural_log(y / l);
  return width * rest - 2.0 * l * (integral_of_log(y_to / l) - integral_of_log(y_from / l));
}

double impose_approach(double approach, const Material& material, double x, double y,
                       Strips& strips) noexcept {
  double displacement = 0.0;  // per unit of peak / half length and of the compliance [m^2]
  double load = 0.0;          // per unit of peak / half length [m^3]
  for (std::int32_t j = 0; j < strips.count; ++j) {
    const double shift = strips.centre[j] - x;
    const double dy = strips.y[j] - y;
    const double half_width = 0.5 * strips.width[j];
    const double l = strips.half_length[j];
    double seen = strip_displacement(l, dy - half_width, dy + half_width);
    if (shift != 0.0) seen *= std::sqrt((l * l + dy * dy) / (l * l + dy * dy + shift * shift));
    displacement += l * seen;
    load += 0.5 * pi * l * l * strips.width[j];
  }
  const double level = approach / (material.normal_compliance() * displacement);
  for (std::int32_t j = 0; j < strips.count; ++j) strips.peak[j] = level * strips.half_length[j];
  return level * load;
}

}  // namespace wrc
