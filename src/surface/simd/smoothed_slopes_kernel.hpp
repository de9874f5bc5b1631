/// Means and lines through values of neighbouring strips, with their derivatives
/// (surface/pressure/pressure_jacobian.hpp): one strip per lane.
#pragma once

#include "surface/simd/eight_parts.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// SurfaceKernels::smoothed_slopes.
inline double smoothed_slopes_kernel(const SmoothedSlopesTask& task) {
  const Native zero = broadcast(0.0), one = broadcast(1.0);
  const Native place = broadcast(task.place), inverse = broadcast(task.inverse_reach);
  // Calls take(vector of the eight parts, first strip, strips left).
  const auto each = [&](const auto& take) {
    for (std::int32_t first = 0; first < task.count; first += 8)
      for (std::int32_t k = 0; k < EightParts::vectors; ++k)
        take(k, first + k * native_lanes, task.count - first - k * native_lanes);
  };
  const auto distance = [&](std::int32_t at, std::int32_t left) {
    return (load_first(left, task.source_place + at, place) - place) * inverse;
  };

  // Moments of the strips; weight (1 - y^2)^3 width q.
  EightParts weights = no_parts(), v = no_parts(), y1 = no_parts(), y2 = no_parts(), yv = no_parts();
  each([&](std::int32_t k, std::int32_t at, std::int32_t left) {
    const Native y = distance(at, left), t = one - y * y;
    const Native near = t * t * t * load_first(left, task.width + at, zero);
    const Native weight = near * load_first(left, task.line_load + at, zero);
    const Native value = load_first(left, task.value + at, zero);
    store_first(left, task.by_load + at, near);
    store_first(left, task.by_value + at, weight);
    weights.of[k] = weights.of[k] + weight;
    v.of[k] = v.of[k] + weight * value;
    if (!task.line) return;
    const Native of_y = weight * y;
    y1.of[k] = y1.of[k] + of_y;
    y2.of[k] = y2.of[k] + of_y * y;
    yv.of[k] = yv.of[k] + of_y * value;
  });
  const double all = weights.sum();
  if (!(all > 0.0)) {
    for (std::int32_t i = 0; i < task.count; ++i) task.by_value[i] = task.by_load[i] = 0.0;
    return 0.0;
  }

  // Derivatives: by a value its share of the weights times its lever, by a load how far its value is off the
  // mean or line; the least spread, which does not grow with the weights, adds a term.
  const double per = 1.0 / all, mean = v.sum() * per;
  double mean_y = 0.0, slope = 0.0, pull = 0.0;
  if (task.line) {
    mean_y = y1.sum() * per;
    const double spread = y2.sum() * per - mean_y * mean_y + task.least_spread;
    slope = (yv.sum() * per - mean_y * mean) / spread;
    pull = mean_y / spread;
  }
  const double held = pull * slope * task.least_spread;
  each([&](std::int32_t, std::int32_t at, std::int32_t left) {
    const Native aside = distance(at, left) - broadcast(mean_y);
    const Native lever = one - broadcast(pull) * aside;
    const Native off = load_first(left, task.value + at, zero) - broadcast(mean) - broadcast(slope) * aside;
    const Native near = load_first(left, task.by_load + at, zero) * broadcast(per),
                 share = load_first(left, task.by_value + at, zero) * broadcast(per);
    store_first(left, task.by_value + at, share * lever);
    store_first(left, task.by_load + at, near * (off * lever + broadcast(held)));
  });
  return mean - mean_y * slope;
}

}  // namespace
}  // namespace wrc::simd
