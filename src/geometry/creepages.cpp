#include "geometry/creepages.hpp"

#include <algorithm>
#include <cmath>

namespace wrc::geometry {

RigidCreepage creepage(const PosedWheel& wheel, const ContactPoint& contact, const WheelsetMotion& motion) {
  const auto& r = wheel.attitude.r;
  // Angular velocity in track axes: yaw about z, roll about the first axis of the wheelset (roll does not
  // turn it), pitch about the axle, the second axis.
  const double wx = motion.roll_rate * r[0][0] + motion.pitch_rate * r[0][1];
  const double wy = motion.roll_rate * r[1][0] + motion.pitch_rate * r[1][1];
  const double wz = motion.roll_rate * r[2][0] + motion.pitch_rate * r[2][1] + motion.yaw_rate;
  // From the wheelset's middle to the wheel's point.
  const double px = contact.x;
  const double py = contact.y - wheel.centre_y;
  const double pz = contact.z - contact.vertical_gap - wheel.centre_z;

  const double vx = motion.speed + wy * pz - wz * py;
  const double vy = motion.lateral_velocity + wz * px - wx * pz;
  const double vz = motion.vertical_velocity + wx * py - wy * px;

  RigidCreepage result;
  result.normal_velocity = contact.cosine * vz - contact.sine * vy;
  const double lateral = contact.cosine * vy + contact.sine * vz;
  const double spin = contact.cosine * wz - contact.sine * wy;
  const double rolling_speed = motion.speed - 0.5 * vx, amount = std::fabs(rolling_speed);
  const RollingReference reference = rolling_reference(rolling_speed);
  result.reverse_share = reference.reverse_share;
  const double divisor = std::max({reference.divisor, std::fabs(vx) / largest_creepage,
                                   std::fabs(lateral) / largest_creepage, std::fabs(spin) / largest_spin});
  const auto over_divisor = [&](double velocity, double most) {
    return std::clamp(velocity / divisor, -most, most);  // rounding
  };
  result.longitudinal = over_divisor(vx, largest_creepage);
  result.lateral = over_divisor(lateral, largest_creepage);
  result.spin = over_divisor(spin, largest_spin);
  const double shown = std::min(divisor, fastest_rolling);
  result.rolling_speed = rolling_speed < 0.0 ? -shown : shown;
  result.limited = shown != amount;
  return result;
}

}  // namespace wrc::geometry
