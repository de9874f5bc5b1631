#include "tangential/friction/friction.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "base/flush_subnormals.hpp"

namespace wrc::tangential {
namespace {

/// Integral of a straight line through (y0, c0) and (y1, c1) over the part of [from, to] within [y0, y1].
double integral_between(double y0, double c0, double y1, double c1, double from, double to) {
  const double low = std::max(y0, from), high = std::min(y1, to);
  if (high <= low) return 0.0;
  const double middle = 0.5 * (low + high);
  return (high - low) * (c0 + (c1 - c0) * (middle - y0) / (y1 - y0));
}

}  // namespace

StripFriction shared_out(const patch::Strips& strips, double* coefficients) {
  // mean = sum of mu_j N_j over N; loads without their common factor pi / 2
  double limit = 0.0, load = 0.0;
  for (std::int32_t j = 0; j < strips.count; ++j) {
    const double carried = strips.half_length[j] * strips.peak[j] * strips.width[j];
    limit += coefficients[j] * carried;
    load += carried;
  }
  constexpr double least_friction = 1e-9;  // below, nothing to share out
  if (limit <= least_friction * load) {
    std::fill_n(coefficients, strips.count, 1.0);
    return 0.0;
  }
  const double mean = limit / load;
  for (std::int32_t j = 0; j < strips.count; ++j) coefficients[j] /= mean;
  return {mean, coefficients};
}

double speed_factor(const FrictionLaw& law, double sliding_speed) {
  constexpr double endless = 690.0;  // e^-690 is nothing, and within the range of natural_exp()
  const double A = law.kinetic_ratio;
  switch (law.speed_law) {
    case SpeedLaw::none:
      break;
    case SpeedLaw::exponential:
      return (1.0 - A) * natural_exp(-std::min(law.fall_rate * sliding_speed, endless)) + A;
    case SpeedLaw::hyperbolic:
      return A + (1.0 - A) / (1.0 + sliding_speed / law.half_speed);
  }
  return 1.0;
}

double speed_factor_slope(const FrictionLaw& law, double sliding_speed) {
  const double A = law.kinetic_ratio;
  switch (law.speed_law) {
    case SpeedLaw::none:
      break;
    case SpeedLaw::exponential:
      return -law.fall_rate * (speed_factor(law, sliding_speed) - A);
    case SpeedLaw::hyperbolic: {
      const double falls = 1.0 + sliding_speed / law.half_speed;
      return -(1.0 - A) / (law.half_speed * falls * falls);
    }
  }
  return 0.0;
}

double temperature_factor(const FrictionLaw& law, double temperature, double* slope) {
  const double range = law.hot_temperature - law.cold_temperature, loss = 1.0 - law.hot_ratio;
  const bool falling = temperature > law.cold_temperature && temperature < law.hot_temperature;
  if (slope) *slope = falling ? -loss / range : 0.0;
  return 1.0 - loss * std::clamp((temperature - law.cold_temperature) / range, 0.0, 1.0);
}

double mean_friction(const FrictionZones& zones, double from, double to) {
  // constant beyond the first and the last breakpoint, linear between
  const double* y = zones.y;
  const double* c = zones.coefficient;
  const std::int64_t last = zones.count - 1;
  double integral =
      c[0] * std::max(0.0, std::min(to, y[0]) - from) + c[last] * std::max(0.0, to - std::max(from, y[last]));
  for (std::int64_t k = 0; k < last; ++k)
    integral += integral_between(y[k], c[k], y[k + 1], c[k + 1], from, to);
  return integral / (to - from);
}

double zone_friction(const FrictionZones& zones, double y) {
  // the first breakpoint beyond y; of two at y, a step, the second has been passed
  std::int64_t behind = 0;
  while (behind < zones.count && zones.y[behind] <= y) ++behind;
  if (behind == 0) return zones.coefficient[0];
  if (behind == zones.count) return zones.coefficient[zones.count - 1];
  const double from = zones.y[behind - 1], to = zones.y[behind];
  const double t = (y - from) / (to - from);
  return zones.coefficient[behind - 1] + t * (zones.coefficient[behind] - zones.coefficient[behind - 1]);
}

StripFriction evaluate(const FrictionLaw& law, const patch::Strips& strips, const FrictionFrame& frame,
                       const Creepage& creepage, double speed, SlidingSpeed sliding, double* shares) {
  const double patch_x = creepage.longitudinal - creepage.spin * frame.origin;
  const double patch_slip = std::sqrt(patch_x * patch_x + creepage.lateral * creepage.lateral);
  for (std::int32_t j = 0; j < strips.count; ++j) {
    // mu_0: one number, or the mean of the zones over the strip's width in their coordinate
    const double y = frame.origin + strips.y[j];
    double mu = law.coefficient;
    if (law.zones.count > 0) {
      const double middle = frame.zone_origin + frame.zone_slope * y;
      const double half = 0.5 * std::fabs(frame.zone_slope) * strips.width[j];
      mu = mean_friction(law.zones, middle - half, middle + half);
    }
    // f at the root mean square of the rigid slip along the strip, or at that of the patch
    double slip = patch_slip;
    if (sliding == SlidingSpeed::of_strip) {
      const double x = creepage.longitudinal - creepage.spin * y;
      const double lateral = creepage.lateral + creepage.spin * strips.centre[j];
      const double turn = creepage.spin * strips.half_length[j];
      slip = std::sqrt(x * x + lateral * lateral + turn * turn / 3.0);
    }
    shares[j] =
        flush_subnormals(mu * speed_factor(law, speed * slip));  // an exponential law falls without end
  }
  // one number stays that number: the mean over strips would only round it
  if (law.is_one_number()) {
    std::fill_n(shares, strips.count, 1.0);
    return law.coefficient;
  }
  return shared_out(strips, shares);
}

}  // namespace wrc::tangential
