/// Contact functions of a wheelset on its track (EN 15302): where both wheels touch over the lateral
/// displacement, and from that roll, rolling radii, contact angles. Offline: it allocates.
#pragma once

#include <cstdint>

#include "base/fault.hpp"
#include "contact/model.hpp"

namespace wrc::profiles {

/// Where one wheel of the wheelset rolls.
struct RollingPlace {
  double radius = 0.0;  ///< rolling radius [m]
  double angle = 0.0;   ///< contact angle, positive where the surface rises towards the flange [rad]
  double y_wheel = 0.0, y_rail = 0.0;  ///< in the coordinates of the profiles, as the caller has them [m]
};

/// A wheelset without yaw that touches on both sides.
struct SettledWheelset {
  double vertical = 0.0;  ///< displacement of its middle, down [m]
  double roll = 0.0;      ///< right wheel down positive [rad]
  RollingPlace side[2];   ///< by Side
};

/// Settles the wheelset at every displacement: roll and height for which both wheels touch (load 0) or carry
/// `load` each, without friction [N]. Under load radius, angle and places are means weighted by the
/// regions' normal forces. The displacement a failure is about is the fault's index.
Fault settle_wheelset(const contact::Model& model, double load, std::uint32_t count, const double* lateral,
                      SettledWheelset* settled);

}  // namespace wrc::profiles
