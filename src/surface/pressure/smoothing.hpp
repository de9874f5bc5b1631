/// Limits of the edge condition and the means over neighbouring strips, for the pressures
/// (edge_condition.hpp) and for their derivatives (pressure_jacobian.hpp).
#pragma once

#include "base/number.hpp"

namespace wrc::surface {

/// Least half length over a strip's width: a strip that enters has a place and no length.
inline constexpr double least_half_length = 0.02;

/// Limits of the displacement's fall over a half length, drop / (kappa/2 l^2).
inline constexpr double least_edge_ratio = 0.2, most_edge_ratio = 5.0;

inline constexpr double longest_shift = 10e-3;  ///< [m]

/// lambda is a mean over the strips nearer than a length or 1.9 widths. That is this length [m]; on a rail
/// that changes along the track, where overlaps differ more from strip to strip, the shorter one.
inline constexpr double usual_lambda_length = 0.75e-3, lambda_length_along_track = 0.5e-3;

inline double lambda_reach(double width, double length) {
  constexpr double widths = 1.9;
  return larger(length, widths * width);
}

/// Shifts lie on the line of least squares through the strips nearer than this [m]: in Hertz's contact,
/// however it lies to the strips, they lie on one. Over shorter reaches shifts follow their neighbours to
/// other solutions where places of the largest overlap are far apart from strip to strip
/// (docs/accuracy_method.md).
inline double shift_reach(double width) { return 7.0 * lambda_reach(width, usual_lambda_length); }

/// Least variance of the strips' places over the squared reach, for a line: one strip has no slope.
inline constexpr double least_line_spread = 2e-3;

/// Weight at a distance t < 1 of the reach, beside width and line load: (1 - t^2)^3.
inline double smoothing_weight(double t) {
  const double near = 1.0 - t * t;
  return near * near * near;
}

}  // namespace wrc::surface
