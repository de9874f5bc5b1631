/// What the normal problem on the surface and its derivatives share: limits, and means over neighbours.
#pragma once

#include "base/number.hpp"

namespace wrc {

/// Half lengths below this part of a strip's width count as it: a strip that enters has a place and no
/// length.
inline constexpr double least_half_length = 0.02;

/// Displacement falls over a half length by kappa/2 l^2 times a ratio within these limits.
inline constexpr double least_edge_ratio = 0.2, most_edge_ratio = 5.0;

inline constexpr double longest_shift = 10e-3;  ///< [m]

/// Levels and shifts are means over the strips nearer than this to one of a width [m].
inline double smoothing_reach(double width) {
  constexpr double length = 0.75e-3, widths = 1.9;
  return larger(length, widths * width);
}

/// Weight at a distance t < 1 of the reach, beside width and strength: (1 - t^2)^3.
inline double smoothing_weight(double t) {
  const double near = 1.0 - t * t;
  return near * near * near;
}

}  // namespace wrc
