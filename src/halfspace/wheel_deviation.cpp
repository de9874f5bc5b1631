#include "halfspace/wheel_deviation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace wrc::halfspace {
namespace {

constexpr double step = 2.0 * pi / surface::OutOfRound::nodes;  // [rad]: the step at which the reach is known
constexpr int to_either_side = surface::OutOfRound::nodes / 24;  // 0.26 rad
constexpr int nodes = 2 * to_either_side + 1;

// tau, where the slope D'(tau) + r (tau - theta) passes zero: by halving.
WheelDeviation::Value least_surface(const surface::OutOfRound& wheel, int row, double theta) {
  constexpr double furthest = 0.25;  // [rad]: chords of 0.2 m
  // the slope D' + r tau grows with tau: 40 halvings of 0.5 rad leave rounding
  double low = -furthest, high = furthest;
  const auto reach = [&](double from) {
    return surface::out_of_round::spline_at(wheel.value, wheel.second, row, theta + from);
  };
  for (int k = 0; k < 40; ++k) {
    const double middle = 0.5 * (low + high);
    (reach(middle).slope + wheel.radius * middle < 0.0 ? low : high) = middle;
  }
  const double tau = 0.5 * (low + high);
  return {.depth = reach(tau).depth + 0.5 * wheel.radius * tau * tau, .slope = -wheel.radius * tau};
}

}  // namespace

WheelDeviation::WheelDeviation(const surface::OutOfRound& wheel, double angle) : wheel_(wheel) {
  for (int row = 0; row < wheel.rows; ++row) {
    for (int k = 0; k < nodes; ++k)
      nodes_.push_back(least_surface(wheel, row, step * (k - to_either_side) - angle));
  }
}

// Cubic Hermite between nodes.
WheelDeviation::Value WheelDeviation::row_at(int row, double place) const {
  // piece and place t within it, 0..1
  const double at = std::clamp(place / step + to_either_side, 0.0, nodes - 1.0);
  const int k = std::min(static_cast<int>(at), nodes - 2);
  const auto first = static_cast<std::size_t>(row) * nodes + static_cast<std::size_t>(k);
  const Value &a = nodes_[first], &b = nodes_[first + 1];
  const double t = at - k, rise = b.depth - a.depth, from = step * a.slope - rise, to = rise - step * b.slope;
  return {
      .depth = a.depth + t * rise + t * (1.0 - t) * ((1.0 - t) * from + t * to),
      .slope = (rise + (1.0 - 2.0 * t) * ((1.0 - t) * from + t * to) + t * (1.0 - t) * (to - from)) / step};
}

// Between rows as the reach is (reach_at).
WheelDeviation::Value WheelDeviation::at(double y, double place) const {
  return surface::out_of_round::across_rows(wheel_, y, [&](int row) { return row_at(row, place); });
}

}  // namespace wrc::halfspace
