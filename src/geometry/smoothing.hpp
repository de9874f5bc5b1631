/// Smoothing of measured profile points, at model init only.
#pragma once

#include <cstdint>

namespace wrc::geometry {

/// Doubles of scratch per point.
inline constexpr std::int32_t smoothing_scratch = 7;

struct SmoothedPoints {
  const double* y = nullptr;  ///< in the scratch [m]
  const double* z = nullptr;
  double deviation = 0.0;  ///< largest distance between a point and the curve [m]
};

/// Points of the smooth curve that runs along the given ones: y(s) and z(s), each the function g of the arc
/// length s that minimises Int (given - g)^2 ds + lambda Int g''^2 ds . A wave of length L along the curve
/// keeps the share 1 / (1 + (wavelength / L)^4) of its height, lambda = (wavelength / (2 pi))^4: half of it
/// remains at L = wavelength, a seventeenth at half of that, and straight lines are kept exactly. Over the
/// arc length, not over y, a steep flange is treated as a tread is; an arc of radius R shrinks by
/// lambda / R^3 (0.2 um for R = 13 mm and wavelength = 5 mm). Each point weighs as the length it stands for,
/// so that the result does not depend on how densely a curve was measured.
///
/// Reinsch, Numerische Mathematik 10 (1967) 177-183: five bands, solved by elimination. At least three
/// points, no two of them in one place; `scratch` holds smoothing_scratch * count doubles. The y of the
/// result may not increase where a steep part is shorter than the wavelength.
SmoothedPoints smooth_points(std::int32_t count, const double* y, const double* z, double wavelength,
                             double* scratch);

}  // namespace wrc::geometry
