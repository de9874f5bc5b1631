#include "surface/wrench/strip_friction.hpp"

#include <cmath>

#include "base/number.hpp"

namespace wrc::surface {

FrictionAtRest friction_at_rest(const WheelProblem& problem, const Overlaps& overlaps, std::int32_t i) {
  constexpr double rounding = 1e-9;  // [m]: of widths
  const WheelOnRail& in = problem.in;
  const RailStrips& rail = problem.rail;
  const std::int32_t strip = overlaps.strip[i];
  const tangential::FrictionZones& zones = in.law->zones;
  if (zones.count == 0) return {in.law->coefficient, 0.0};

  // zones over the rail's y: the strip's width seen along y; nothing moves with the wheel
  if (!in.zones_on_wheel) {
    const double half = 0.5 * rail.width[strip] * magnitude(rail.ty[strip]) + rounding;
    return {tangential::mean_friction(zones, rail.y[strip] - half, rail.y[strip] + half), 0.0};
  }

  // zones over the wheel's y: the same width about the end of the strip's ray
  const CurvePoint p = evaluate(problem.model.wheel.curve, overlaps.piece[i], overlaps.u[i]);
  const double speed = std::sqrt(p.dy * p.dy + p.dz * p.dz), advance = p.dy / speed;
  const double half = 0.5 * rail.width[strip] * magnitude(advance) + rounding;
  const double from = p.y - half, to = p.y + half;
  const double mean = tangential::mean_friction(zones, from, to);
  if (!(advance > least_advance)) return {mean, 0.0};

  // d/dy of the mean over [y - h, y + h]: (f(to) - f(from)) / 2h, and with h, as the profile turns,
  // h' ((f(to) + f(from)) / 2 - mean) / h
  const double first = tangential::zone_friction(zones, from), last = tangential::zone_friction(zones, to);
  const double turning = (p.ddy * p.dz - p.dy * p.ddz) * p.dz / (speed * speed * speed);
  const double half_by_y = 0.5 * rail.width[strip] * turning / p.dy;
  return {mean, ((last - first) * 0.5 + (0.5 * (first + last) - mean) * half_by_y) / half};
}

double strip_speed_factor(const tangential::FrictionLaw& law, const ContactArrays& strips, std::int32_t k,
                          double speed) {
  // the mean of |(xi_x, xi_y + phi x)|^2 over -l <= x <= l is xi_x^2 + xi_y^2 + (phi l)^2 / 3
  const double turning = strips.spin[k] * strips.half_length[k];
  const double slip2 =
      strips.slip_x[k] * strips.slip_x[k] + strips.slip_y[k] * strips.slip_y[k] + turning * turning / 3.0;
  return tangential::speed_factor(law, speed * std::sqrt(slip2));
}

void set_cold_friction(const WheelProblem& problem, const Overlaps& overlaps, double speed,
                       const ContactStrips& strips) {
  for (std::int32_t k = 0; k < strips.count; ++k) {
    const double at_rest = friction_at_rest(problem, overlaps, strips.candidate[k]).value;
    strips.friction[k] = at_rest * strip_speed_factor(*problem.in.law, strips, k, speed);
  }
}

}  // namespace wrc::surface
