/// Creepages at a contact point from the rigid motion of the wheelset.
#pragma once

#include "geometry/contact_search.hpp"
#include "geometry/silhouette.hpp"

namespace wrc {

/// Velocity of the wheelset relative to the track.
struct WheelsetMotion {
  double speed = 0.0;              ///< of its middle, along the track [m/s]
  double lateral_velocity = 0.0;   ///< along y [m/s]
  double vertical_velocity = 0.0;  ///< along z, down [m/s]
  double roll_rate = 0.0;          ///< about the x axis turned by yaw [rad/s]
  double yaw_rate = 0.0;           ///< about z [rad/s]
  double pitch_rate =
      0.0;  ///< about the axle, right-hand rule about y: negative when rolling forward [rad/s]
};

/// Rigid slip of the wheel over the rail at the origin of the contact frame, per unit rolled length, in the
/// contact frame: nu_x, nu_y, phi of the slip field (nu_x - phi y, nu_y + phi x).
struct RigidCreepage {
  double longitudinal = 0.0;   ///< nu_x [-]
  double lateral = 0.0;        ///< nu_y [-]
  double spin = 0.0;           ///< phi [1/m]
  double rolling_speed = 0.0;  ///< V, what the velocities are divided by [m/s]
  double normal_velocity =
      0.0;  ///< of the wheel's point along the contact normal, into the rail positive [m/s]
};

/// Velocity of the wheel's material point at the contact, resolved in the contact frame and divided by the
/// rolling speed V: the mean of the speeds at which rail and wheel material pass through the contact,
///     V = ((speed) + (speed - v_x)) / 2,   v_x the longitudinal velocity of the wheel's point.
/// The plain wheelset speed differs from it by half the longitudinal creepage (0.1 % of the creepages in
/// normal running). V <= 0 (standstill, or a wheel locked in reverse) gives zero creepages.
RigidCreepage creepage(const PosedWheel& wheel, const ContactPoint& contact, const WheelsetMotion& motion);

}  // namespace wrc
