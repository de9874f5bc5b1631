/// A profile that wears: depth taken off along its normal, smoothed, in steps, with new points; and a wheel's
/// flange as gauges measure it. Offline: it allocates.
#pragma once

#include <cstdint>
#include <vector>

#include "base/fault.hpp"
#include "geometry/profile_points.hpp"

namespace wrc::profiles {

/// Wear over the arc length of a profile, from its origin (y = 0).
struct WearStep {
  geometry::ProfileBody body = geometry::ProfileBody::wheel;
  std::uint32_t bins = 0;
  double first = 0.0, width = 0.0;  ///< start and width of the bins [m]
  const double* depth = nullptr;    ///< depth of each bin for one passage, >= 0 [m]
  double passages = 1.0;            ///< wanted
  double largest_depth = 0.0;       ///< most that is taken off in one step [m]
  double smoothing = 0.0;           ///< waves of the depth of this length keep half their height [m]; 0: none
  double spacing = 0.0;             ///< distance of the new points along the curve [m]
};

/// Result of a step.
struct WornProfile {
  std::vector<double> y, z;  ///< [m]
  double passages = 0.0;     ///< that were taken off
  double depth = 0.0;        ///< largest [m]
  double area = 0.0;         ///< taken off the section [m^2]
};

/// Wears the profile through the points by as many passages as are wanted, or as `largest_depth` allows.
/// WRC_ERROR_PROFILE where the points are no profile, or the worn one crosses itself.
Fault wear_profile(std::uint32_t count, const double* y, const double* z, const WearStep& step,
                   WornProfile& worn);

/// Flange dimensions (EN 15313): gauge datum on the tread at y = 0, flange back at y = -0.070 m.
struct FlangeDimensions {
  double height = 0.0;     ///< Sh: tip below the datum [m]
  double thickness = 0.0;  ///< Sd: flange back to its face, 10 mm below the datum [m]
  double slope = 0.0;      ///< qR: along y, from that point of the face to the one 2 mm above the tip [m]
};

/// WRC_ERROR_PROFILE where the points are no wheel with a flange.
Fault measure_flange(std::uint32_t count, const double* y, const double* z, double back,
                     FlangeDimensions& dimensions);

}  // namespace wrc::profiles
