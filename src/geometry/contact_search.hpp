/// Contact search: where a wheel in a given pose first touches its rail when it is lowered (or lifted)
/// vertically.
#pragma once

#include <cstdint>

#include "base/fault.hpp"
#include "geometry/placement.hpp"
#include "geometry/silhouette.hpp"

namespace wrc::geometry {

/// A point of closest vertical approach: common tangent of wheel outline and rail.
struct ContactPoint {
  double x = 0.0, y = 0.0, z = 0.0;  ///< on the rail, track frame; x is that of the wheel's point [m]
  double vertical_gap = 0.0;         ///< rail z - wheel z; negative: the undeformed bodies overlap [m]
  double angle = 0.0;                ///< contact angle, atan of the common tangent's dz/dy [rad]
  double cosine = 1.0, sine = 0.0;   ///< contact angle
  double y_rail = 0.0;               ///< in the coordinates of the rail's profile, field side positive [m]
  double y_wheel = 0.0;              ///< in the coordinates of the wheel's profile, field side positive [m]
  double wheel_s = 0.0;              ///< wheelset-frame lateral position of the wheel's point [m]
  double rolling_radius = 0.0;       ///< [m]
};

/// The contact frame of a contact point: x along the track, y along the common tangent, z along the contact
/// normal into the rail. cosine and sine of its angle take track components to contact components:
///     y_c = cosine y + sine z,   z_c = cosine z - sine y.

/// Finds the local minima of the vertical gap, sorted by increasing gap; points[0] is the contact point.
///
/// The outline is scanned at fixed positions of the wheel's profile (scan_spacing apart), every change from
/// approaching to departing is refined by a bracketed secant (regula falsi, Illinois variant) to 1e-11 m in
/// s. `capacity` >= 1 points are kept, `count` of them are filled. Fails with WRC_ERROR_GAP if wheel and rail
/// do not overlap laterally or are closest at the end of a profile, where they have no common tangent.
Fault find_contact(const Rail& rail, const PosedWheel& wheel, std::int32_t capacity, ContactPoint* points,
                   std::int32_t& count);

/// Spacing of the scan along the wheel's profile [m]: two minima closer than this count as one. The global
/// minimum cannot be lost between two stations: the gap of a missed pair of minimum and maximum falls on
/// beyond it.
inline constexpr double scan_spacing = 1e-3;

}  // namespace wrc::geometry
