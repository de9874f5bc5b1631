#include "geometry/creepages.hpp"

namespace wrc {

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
  const double rolling_speed = motion.speed - 0.5 * vx;
  if (!(rolling_speed > 0.0)) return result;
  result.rolling_speed = rolling_speed;
  result.longitudinal = vx / rolling_speed;
  result.lateral = (contact.cosine * vy + contact.sine * vz) / rolling_speed;
  result.spin = (contact.cosine * wz - contact.sine * wy) / rolling_speed;
  return result;
}

}  // namespace wrc
