/// Creepages at a contact point from the rigid motion of the wheelset.
#pragma once

#include "base/dual.hpp"
#include "geometry/contact_search.hpp"
#include "geometry/silhouette.hpp"

namespace wrc::geometry {

/// Velocity of the wheelset relative to the track.
struct WheelsetMotion {
  double speed = 0.0;              ///< velocity of its middle along the track [m/s]
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
  double rolling_speed = 0.0;  ///< divisor of the velocities, with the sign of V [m/s]
  double reverse_share = 0.0;  ///< share of the forces that is of rolling against that sign, 0 to 1/2
  bool limited = false;        ///< is |rolling_speed| something else than |V|?
  double normal_velocity =
      0.0;  ///< velocity of the wheel's point along the contact normal, into the rail positive [m/s]
};

/// Largest creepage that the tangential stage takes, and creepage() therefore gives.
inline constexpr double largest_creepage = 10.0;  // longitudinal, lateral [-]
inline constexpr double largest_spin = 1e3;       // [1/m]
inline constexpr double fastest_rolling = 200.0;  // [m/s]
inline constexpr double largest_share_of_other_way = 0.5;

/// Below it creepages saturate and the forces of both rolling directions are blended [m/s]. Small, since
/// numbers depend on it; but a wheel at rest answers to sliding like a damper of G a b C / (3/8 floor), which
/// sets the step of an explicit integrator.
inline constexpr double floor_speed = 0.1;

/// Divisor of sliding velocities, and the share of rolling against the direction of the speed.
/// With u = |V| / floor_speed < 1 the divisor is
///     floor_speed (3 + 6 u^2 - u^4) / 8,
/// and the share (1 - (15 u - 10 u^3 + 3 u^5) / 8) / 2: of V both are C2, also at the floor, above which they
/// are |V| and 0.
template <class Number>
struct RollingReferenceOf {
  Number divisor = 0.0;        ///< [m/s]
  Number reverse_share = 0.0;  ///< 0..1/2
};
using RollingReference = RollingReferenceOf<double>;

template <class Number>
RollingReferenceOf<Number> rolling_reference(const Number& rolling_speed) {
  const Number amount = magnitude(rolling_speed);
  if (value_of(amount) >= floor_speed) return {amount, 0.0};
  const Number u = amount / floor_speed, u2 = u * u;
  return {floor_speed * (0.375 + u2 * (0.75 - 0.125 * u2)),
          larger(0.5 - u * (15.0 - u2 * (10.0 - 3.0 * u2)) / 16.0, Number(0.0))};  // rounding
}

/// Velocity of the wheel's material point at the contact, resolved in the contact frame and divided by the
/// amount of the rolling speed V: the mean of the speeds at which rail and wheel material pass through the
/// contact,
///     V = ((speed) + (speed - v_x)) / 2,   v_x the longitudinal velocity of the wheel's point,
/// negative when rolling backwards. The plain wheelset speed differs from it by half the longitudinal
/// creepage (0.1 % of the creepages in normal running). A locked wheel has v_x = speed, V = speed / 2 and
/// creepage 2; one that spins at standstill creepage -2; V = 0 where the materials pass in opposite
/// directions alike.
///
/// Near standstill the divisor is that of rolling_reference().
/// Where creepages would still be larger than the tangential stage takes, all of them are divided by more, so
/// that the slip keeps its direction. Divisor times creepage is the velocity always.
RigidCreepage creepage(const PosedWheel& wheel, const ContactPoint& contact, const WheelsetMotion& motion);

}  // namespace wrc::geometry
