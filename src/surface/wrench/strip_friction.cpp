#include "surface/wrench/strip_friction.hpp"

#include <cmath>

#include "base/number.hpp"

namespace wrc::surface {

namespace {

constexpr double rounding = 1e-9;  // keeps half widths above 0 [m]

/// Stretch of the wheel's profile that a strip covers: middle, half width [m], and d half / dy [-].
struct OnWheel {
  double y, half, half_by_y;
  bool steep;  ///< the profile turns back: places have no derivative
};

OnWheel on_wheel(const WheelProblem& problem, const Overlaps& overlaps, std::int32_t i) {
  // the strip's width about the end of its ray, seen along y
  const double width = problem.rail.width[on_rail(overlaps.strip[i])];
  const CurvePoint p = evaluate(problem.model.wheel.curve, overlaps.piece[i], overlaps.u[i]);
  const double speed = std::sqrt(p.dy * p.dy + p.dz * p.dz), advance = p.dy / speed;
  const double turning = (p.ddy * p.dz - p.dy * p.ddz) * p.dz / (speed * speed * speed);
  return {p.y, 0.5 * width * magnitude(advance) + rounding, 0.5 * width * turning / p.dy,
          !(advance > least_advance)};
}

/// Adds films to the friction of clean bodies, with derivatives.
void add_films(const WheelProblem& problem, const OnWheel& wheel, std::int32_t strip, double half,
               FrictionAtRest& at_rest) {
  const tangential::FilmRows& films = *problem.in.films;
  const tangential::FilmOfStrip film = tangential::film_of_strip(
      films, tangential::row_shares(films.rail, problem.rail.y[strip], half),
      tangential::row_shares(films.wheel, wheel.y, wheel.half, wheel.steep ? 0.0 : wheel.half_by_y));
  const double moves = wheel.steep ? 0.0 : 1.0, clean = at_rest.value;
  at_rest.value = film.mean.share * clean + film.mean.addition;
  at_rest.by_wheel_y = film.mean.share * at_rest.by_wheel_y +
                       moves * (film.by_wheel_y.share * clean + film.by_wheel_y.addition);
  if (!problem.in.layer_of_strips) return;
  tangential::layer_of_strip(film, at_rest.layer, at_rest.layer_by_wheel_y);
  if (wheel.steep) at_rest.layer_by_wheel_y = {};
}

/// Friction of clean bodies at a strip at rest.
FrictionAtRest clean_at_rest(const WheelOnRail& in, const OnWheel& wheel, double rail_y, double half) {
  const tangential::FrictionZones& zones = in.law->zones;
  if (zones.count == 0) return {in.law->coefficient, 0.0};
  // zones over the rail's y: nothing moves with the wheel
  if (!in.zones_on_wheel) return {tangential::mean_friction(zones, rail_y - half, rail_y + half), 0.0};
  const double from = wheel.y - wheel.half, to = wheel.y + wheel.half;
  const double mean = tangential::mean_friction(zones, from, to);
  if (wheel.steep) return {mean, 0.0};
  // d/dy of the mean over [y - h, y + h]: (f(to) - f(from)) / 2h, and with h, as the profile turns,
  // h' ((f(to) + f(from)) / 2 - mean) / h
  const double first = tangential::zone_friction(zones, from), last = tangential::zone_friction(zones, to);
  return {mean, ((last - first) * 0.5 + (0.5 * (first + last) - mean) * wheel.half_by_y) / wheel.half};
}

}  // namespace

FrictionAtRest friction_at_rest(const WheelProblem& problem, const Overlaps& overlaps, std::int32_t i) {
  const WheelOnRail& in = problem.in;
  const RailStrips& rail = problem.rail;
  const std::int32_t strip = on_rail(overlaps.strip[i]);
  const double half = 0.5 * rail.width[strip] * magnitude(rail.ty[strip]) + rounding;
  const OnWheel wheel = moves_with_wheel(in) ? on_wheel(problem, overlaps, i) : OnWheel{0.0, half, 0.0, true};
  FrictionAtRest at_rest = clean_at_rest(in, wheel, rail.y[strip], half);
  if (in.films != nullptr) add_films(problem, wheel, strip, half, at_rest);
  return at_rest;
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
    const FrictionAtRest at_rest = friction_at_rest(problem, overlaps, strips.candidate[k]);
    strips.friction[k] = at_rest.value * strip_speed_factor(*problem.in.law, strips, k, speed);
    strips.flexibility[k] = at_rest.layer.flexibility;
    strips.yield[k] = at_rest.layer.yield;
    strips.hardening[k] = at_rest.layer.hardening;
  }
}

}  // namespace wrc::surface
