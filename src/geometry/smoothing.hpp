/// Smoothing of measured profile points, at model init only.
#pragma once

#include <cstdint>

namespace wrc {

/// Doubles of scratch per point.
inline constexpr std::int32_t smoothing_scratch = 4;

/// Heights of the curve g that minimises  Int (z - g)^2 dy + lambda Int g''^2 dy : a natural cubic spline
/// with its knots at the points. A wave of length L keeps the share 1 / (1 + (wavelength / L)^4) of its
/// height, lambda = (wavelength / (2 pi))^4: half of it remains at L = wavelength, a sixteenth at half of
/// that, and straight lines are kept exactly. Each point weighs as the width it stands for, so that the
/// result does not depend on how densely a curve was measured.
///
/// Reinsch, Numerische Mathematik 10 (1967) 177-183: five bands, solved by elimination. At least three
/// points, y strictly increasing; `scratch` holds smoothing_scratch * count doubles. Returns the largest
/// distance between a point and the curve [m].
double smooth_points(std::int32_t count, const double* y, const double* z, double wavelength, double* scratch,
                     double* smoothed);

}  // namespace wrc
