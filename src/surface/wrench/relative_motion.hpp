/// Place and motion of a wheel relative to a rail, in rail axes: of plain numbers and of numbers that carry
/// derivatives.
///
/// Rail axes: origin of the rail's displaced profile, x along the rail, turned by its roll about x. With T
/// the rotation from the rail's direction into the track's (rail_direction.hpp) and R the roll,
///
///     r_rail = R^T T^T r_track.
///
/// Bodies are those of a right-hand wheel on a right-hand rail.
#pragma once

#include <type_traits>

#include "base/elementary.hpp"
#include "surface/geometry/overlap.hpp"
#include "surface/geometry/rail_direction.hpp"
#include "surface/geometry/varying_rail.hpp"
#include "surface/surface_model.hpp"

namespace wrc::surface {

/// A wheel as a rigid body. The reference point is where the plane of the tape circle meets the axle.
template <class Number>
struct WheelMotionOf {
  Number position[3] =
      {};  ///< reference point, track axes [m]; x from the place at which the rail's displacement is given
  Number rotation[3][3] = {
      {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  ///< track = rotation * wheel axes; y along the axle
  Number velocity[3] = {};               ///< reference point against the ground, track axes [m/s]
  Number angular_velocity[3] = {};       ///< track axes, the turning about the axle included [rad/s]
};
using WheelMotion = WheelMotionOf<double>;

/// A rail: displacement of the origin of its profile, at x = 0, from its place in the model, and rotation
/// about that origin: by roll about its own direction, which the slopes give (rail_direction.hpp).
template <class Number>
struct RailMotionOf {
  Number y = 0.0, z = 0.0, roll = 0.0;  ///< [m], [rad]
  Number slope_y = 0.0, slope_z = 0.0;  ///< derivatives of its place along the track [-]
  Number velocity_y = 0.0, velocity_z = 0.0, velocity_roll = 0.0;  ///< [m/s], [rad/s]
  Number turning = 0.0;  ///< angular velocity of a roller about its axle, right-hand rule about its y [rad/s]
};
using RailMotion = RailMotionOf<double>;

/// Velocities of a wheel relative to rail material, rail axes.
template <class Number>
struct RelativeVelocityOf {
  Number linear[3];   ///< at the wheel's reference point [m/s]
  Number angular[3];  ///< [rad/s]
  Number roller;      ///< turning of a rail that is a roller, about its axle [rad/s]
  bool on_roller;
};

template <class Number>
struct RelativeMotionOf {
  RelativePoseOf<Number> pose;
  RelativeVelocityOf<Number> velocity;
  Number cosine, sine;  ///< those of the rail's roll
  bool aslant;          ///< the rail runs at an angle to the track, or its slopes carry derivatives
  RailDirection<Number> direction;
};
using RelativeMotion = RelativeMotionOf<double>;

/// A vector in track axes, turned into rail axes.
template <class Number>
void into_rail(const RelativeMotionOf<Number>& m, Number (&v)[3]) {
  if (m.aslant) turn_along_rail(m.direction, v);
  const Number y = v[1], z = v[2];
  v[1] = m.cosine * y + m.sine * z;
  v[2] = m.cosine * z - m.sine * y;
}

/// A vector in rail axes, turned into track axes.
template <class Number>
void into_track(const RelativeMotionOf<Number>& m, Number (&v)[3]) {
  const Number y = v[1], z = v[2];
  v[1] = m.cosine * y - m.sine * z;
  v[2] = m.sine * y + m.cosine * z;
  if (m.aslant) turn_into_track(m.direction, v);
}

/// Down in track axes: component of the unit vector (0, ny, nz) of rail axes, where the rail runs straight.
inline double downwards(const RelativeMotion& m, double ny, double nz) { return m.cosine * nz + m.sine * ny; }

/// `distance`: of the reference point from above a roller's axle [m].
template <class Number>
RelativeMotionOf<Number> relative_motion(const SurfaceModel& model, const WheelMotionOf<Number>& wheel,
                                         const RailMotionOf<Number>& rail, double distance) {
  RelativeMotionOf<Number> m;
  const SineCosine roll = sine_cosine(value_of(rail.roll));
  m.cosine = with_slope(rail.roll, roll.cosine, -roll.sine);
  m.sine = with_slope(rail.roll, roll.sine, roll.cosine);
  m.aslant =
      !std::is_same_v<Number, double> || value_of(rail.slope_y) != 0.0 || value_of(rail.slope_z) != 0.0;
  if (m.aslant) m.direction = direction_of(rail.slope_y, rail.slope_z);

  // attitude: each axis of the wheel in rail axes
  for (int k = 0; k < 3; ++k) {
    Number axis[3] = {wheel.rotation[0][k], wheel.rotation[1][k], wheel.rotation[2][k]};
    into_rail(m, axis);
    for (int i = 0; i < 3; ++i) m.pose.rotation[i][k] = axis[i];
  }

  // place: from the displaced origin of the rail's profile to the wheel's reference point; (dy, dz) before
  // the rail's roll is the arm of the roll's velocity
  Number place[3] = {wheel.position[0], wheel.position[1] - model.rail_origin_y - rail.y,
                     wheel.position[2] - model.rail_origin_z - rail.z};
  if (m.aslant) turn_along_rail(m.direction, place);
  const Number dy = place[1], dz = place[2];
  m.pose.y = m.cosine * dy + m.sine * dz;
  m.pose.z = m.cosine * dz - m.sine * dy;

  // velocities less those of rail material, which moves with the rail, not along the track: v - omega_rail x
  // r
  RelativeVelocityOf<Number>& v = m.velocity;
  Number linear[3] = {wheel.velocity[0], wheel.velocity[1] - rail.velocity_y,
                      wheel.velocity[2] - rail.velocity_z};
  Number angular[3] = {wheel.angular_velocity[0], wheel.angular_velocity[1], wheel.angular_velocity[2]};
  if (m.aslant) {
    turn_along_rail(m.direction, linear);
    turn_along_rail(m.direction, angular);
  }
  linear[1] += rail.velocity_roll * dz;
  linear[2] = linear[2] - rail.velocity_roll * dy;
  angular[0] = angular[0] - rail.velocity_roll;
  const auto roll_into = [&m](const Number(&from)[3], Number(&to)[3]) {
    to[0] = from[0];
    to[1] = m.cosine * from[1] + m.sine * from[2];
    to[2] = m.cosine * from[2] - m.sine * from[1];
  };
  roll_into(linear, v.linear);
  roll_into(angular, v.angular);

  // a roller turns about its axle, from which the reference point is at x = distance, z = pose.z - 1 /
  // curvature
  v.on_roller = model.roller_curvature != 0.0;
  v.roller = 0.0;
  if (v.on_roller) {
    v.roller = rail.turning;
    v.linear[0] = v.linear[0] - rail.turning * (m.pose.z - 1.0 / model.roller_curvature);
    v.linear[2] += rail.turning * distance;
    v.angular[1] = v.angular[1] - rail.turning;
  }
  return m;
}

}  // namespace wrc::surface
