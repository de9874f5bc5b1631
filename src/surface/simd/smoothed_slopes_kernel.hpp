/// Means and lines through values of neighbouring strips, with their derivatives
/// (surface/pressure/pressure_jacobian.hpp): one strip per lane.
#pragma once

#include "base/eight_parts.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// SurfaceKernels::smoothed_slopes.
inline double smoothed_slopes_kernel(const SmoothedSlopesTask& task) {
  const Native zero = broadcast(0.0), one = broadcast(1.0);
  const Native place = broadcast(task.place), inverse = broadcast(task.inverse_reach);
  // Moments of the strips; weight (1 - y^2)^3 width q.
  EightParts weights = no_parts(), v = no_parts(), y1 = no_parts(), y2 = no_parts(), yv = no_parts();
  for_eight_parts(task.count, [&](std::int32_t k, std::int32_t at, auto some) {
    const Native y = (some.load(task.source_place + at, place) - place) * inverse, t = one - y * y;
    const Native near = t * t * t * some.load(task.width + at, zero);
    const Native weight = near * some.load(task.line_load + at, zero);
    const Native value = some.load(task.value + at, zero);
    some.store(task.by_load + at, near);
    some.store(task.by_value + at, weight);
    weights.of[k] = weights.of[k] + weight;
    v.of[k] = v.of[k] + weight * value;
    if (!task.line) return;
    const Native of_y = weight * y;
    y1.of[k] = y1.of[k] + of_y;
    y2.of[k] = y2.of[k] + of_y * y;
    yv.of[k] = yv.of[k] + of_y * value;
  });
  // nothing presses: no value depends on anything
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
  for_eight_parts(task.count, [&](std::int32_t, std::int32_t at, auto some) {
    const Native y = (some.load(task.source_place + at, place) - place) * inverse;
    const Native aside = y - broadcast(mean_y), lever = one - broadcast(pull) * aside;
    const Native off = some.load(task.value + at, zero) - broadcast(mean) - broadcast(slope) * aside;
    const Native near = some.load(task.by_load + at, zero) * broadcast(per),
                 share = some.load(task.by_value + at, zero) * broadcast(per);
    some.store(task.by_value + at, share * lever);
    some.store(task.by_load + at, near * (off * lever + broadcast(held)));
  });
  return mean - mean_y * slope;
}

}  // namespace
}  // namespace wrc::simd
