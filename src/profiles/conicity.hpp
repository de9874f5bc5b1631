/// Equivalent conicity of a rolling radius difference (UIC 519, EN 15302).
///
/// A wheelset without mass or stiffness, displaced by y, follows y'' + dr(y) / (e r0) = 0 over the distance
/// rolled. Cones with the angle gamma have dr = 2 y tan(gamma) and the wavelength 2 pi sqrt(e r0 / (2 tan
/// gamma)) (Klingel); the equivalent conicity of any other dr is that of the cones with its wavelength.
#pragma once

#include <cstdint>

namespace wrc::profiles {

/// A rolling radius difference, straight between its points; its integral is `potential`, as long.
struct RadiusDifference {
  std::uint32_t count = 0;
  const double* y = nullptr;    ///< increasing [m]
  const double* dr = nullptr;   ///< right less left [m]
  double* potential = nullptr;  ///< integral of dr from the first point on [m^2]
};

/// Fills `potential`.
void integrate(const RadiusDifference& of);

struct Conicity {
  double conicity = 0.0;    ///< tan gamma [-]
  double wavelength = 0.0;  ///< [m]; 0: none
  double centre = 0.0;      ///< middle of the motion [m]
};

/// By the wavelength of the motion with this amplitude, whose two ends lie 2 amplitude apart on one level of
/// the potential. All zero where there is no such motion between the ends of `of`, or no swing. Exact but for
/// rounding: in each piece the motion is a harmonic, or its hyperbolic or parabolic limit.
Conicity conicity_by_wavelength(const RadiusDifference& of, double amplitude, double contact_distance,
                                double radius);

/// Half the slope of the straight line that leaves the least squares over the same way, all of it weighing
/// alike.
Conicity conicity_by_regression(const RadiusDifference& of, double amplitude, double contact_distance,
                                double radius);

}  // namespace wrc::profiles
