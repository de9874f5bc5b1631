/// Place and motion of a host's wheel and rail, as the right-hand bodies of src/surface: of plain numbers and
/// of numbers that carry derivatives.
///
/// With the host's reference point at p, moving with v and turning with omega in a frame of speed V e_x and
/// turning Omega, and the arm a from it to the wheel's own reference point along the axle,
///
///     position  p + a,    turning  omega + Omega,    velocity  v + V e_x + Omega x p + (omega + Omega) x a.
#pragma once

#include "base/dual.hpp"
#include "base/vec3.hpp"
#include "contact/model.hpp"
#include "contact/wheel.hpp"

namespace wrc::contact {

/// The bodies of src/surface are right-hand ones.
inline const Bodies& right_bodies(const Model& model) {
  return model.bodies[static_cast<int>(geometry::Side::right)];
}

/// Place and motion by the host: the members of HostWheel with these names.
template <class Number>
struct HostMotion {
  Number y, z;
  Number rotation[3][3], velocity[3], angular_velocity[3];
  surface::RailMotionOf<Number> rail;
};

inline HostMotion<double> host_motion(const HostWheel& hosted) {
  HostMotion<double> m{hosted.y, hosted.z, {}, {}, {}, hosted.rail};
  for (int i = 0; i < 3; ++i) {
    m.velocity[i] = hosted.velocity[i];
    m.angular_velocity[i] = hosted.angular_velocity[i];
    for (int k = 0; k < 3; ++k) m.rotation[i][k] = hosted.rotation[i][k];
  }
  return m;
}

/// Track axes.
template <class Number>
struct PlacedMotion {
  Number reference[3] = {};  ///< the host's reference point [m]
  Number arm[3] = {};        ///< from there to that of the wheel [m]
  surface::WheelMotionOf<Number> wheel;
  surface::RailMotionOf<Number> rail;
};

/// Not mirrored yet: in the axes of the host.
template <class Number>
PlacedMotion<Number> place_motion(const Bodies& right, const HostWheel& hosted, bool left,
                                  const HostMotion<Number>& m) {
  // a wheelset's reference point is the middle of its axle, a single wheel's lies on its tape circle
  PlacedMotion<Number> placed;
  const double half_base = (left ? -1.0 : 1.0) * right.wheel.origin_y;
  if (hosted.of_wheelset) {
    for (int i = 0; i < 3; ++i) placed.arm[i] = m.rotation[i][1] * half_base;
  }
  placed.reference[1] = m.y + (hosted.of_wheelset ? 0.0 : half_base);
  placed.reference[2] = m.z - right.wheel.nominal_radius;
  surface::WheelMotionOf<Number>& wheel = placed.wheel;
  for (int i = 0; i < 3; ++i) {
    wheel.position[i] = placed.reference[i] + placed.arm[i];
    wheel.velocity[i] = m.velocity[i];
    wheel.angular_velocity[i] = m.angular_velocity[i];
    for (int k = 0; k < 3; ++k) wheel.rotation[i][k] = m.rotation[i][k];
  }

  // From velocities in the frame that follows the track to those against the ground; nothing at all where it
  // does not move: bits stay. With a load given the height is a result, and the frame's velocity is taken at
  // the nominal height.
  if (hosted.frame_speed != 0.0) {
    Number point[3] = {placed.reference[0], placed.reference[1], placed.reference[2]}, frame[3];
    if (hosted.load_prescribed) point[2] = value_of(point[2]);
    for (int i = 0; i < 3; ++i) frame[i] = hosted.frame_turning[i];
    wheel.velocity[0] += hosted.frame_speed;
    add_cross(wheel.velocity, frame, point);
    for (int i = 0; i < 3; ++i) wheel.angular_velocity[i] += frame[i];
  }
  add_cross(wheel.velocity, wheel.angular_velocity, placed.arm);
  placed.rail = m.rail;
  return placed;
}

/// Vectors change the sign of y in the mirror image of the track, rotations those of x and z.
template <class Number>
void mirror_vector(Number (&v)[3]) {
  v[1] = -v[1];
}
template <class Number>
void mirror_rotation(Number (&w)[3]) {
  w[0] = -w[0];
  w[2] = -w[2];
}

/// A left-hand wheel and rail as their mirror image. The arm and the host's reference point stay.
template <class Number>
void mirror_motion(PlacedMotion<Number>& placed) {
  surface::WheelMotionOf<Number>& wheel = placed.wheel;
  mirror_vector(wheel.position);
  mirror_vector(wheel.velocity);
  mirror_rotation(wheel.angular_velocity);
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      if ((i == 1) != (k == 1)) wheel.rotation[i][k] = -wheel.rotation[i][k];
    }
  }
  surface::RailMotionOf<Number>& rail = placed.rail;
  for (Number* const n : {&rail.y, &rail.velocity_y, &rail.roll, &rail.slope_y, &rail.velocity_roll})
    *n = -*n;
}

}  // namespace wrc::contact
