/// Derivatives of a wheel on a rail by the host's inputs: chain rule from the inputs of the rail frame
/// (RailFrameInput), and derivatives of the wrench's own axes and reference point.
#include "base/dual.hpp"
#include "base/elementary.hpp"
#include "contact/wheel_placement.hpp"

namespace wrc::contact {
namespace {

/// Inputs whose derivatives are carried from the host to the rail frame: those before the load, and these.
enum Carried : std::size_t { slope_y = by_load, slope_z, roller_turning, friction, time, carried };
constexpr std::size_t column_of(std::size_t k) {
  constexpr std::size_t behind[] = {by_rail_slope_y, by_rail_slope_z, by_roller_velocity, by_friction,
                                    by_time};
  return k < by_load ? k : behind[k - by_load];
}

using Number = Dual<carried>;

/// Adds to v the derivative axis x at by an angle about `axis`: `at` is the part of v that turns.
void turn(Number (&v)[3], std::size_t input, const double (&axis)[3], const double (&at)[3]) {
  v[0].d[input] += axis[1] * at[2] - axis[2] * at[1];
  v[1].d[input] += axis[2] * at[0] - axis[0] * at[2];
  v[2].d[input] += axis[0] * at[1] - axis[1] * at[0];
}

/// The host's numbers, each with its derivative by the inputs.
HostMotion<Number> differentiated_motion(const HostWheel& hosted) {
  HostMotion<Number> m;
  const auto input = [](double value, std::size_t k) { return Number::input(value, k); };
  m.y = input(hosted.y, by_y);
  m.z = input(hosted.z, by_z);

  // roll turns about the track's x, yaw about the body's z: all axes of the body, and the part of the angular
  // velocity that is given along them
  const auto& R = hosted.rotation;
  const double roll_axis[3] = {1.0, 0.0, 0.0}, yaw_axis[3] = {R[0][2], R[1][2], R[2][2]};
  for (int k = 0; k < 3; ++k) {
    Number axis[3] = {R[0][k], R[1][k], R[2][k]};
    const double at[3] = {R[0][k], R[1][k], R[2][k]};
    turn(axis, by_roll, roll_axis, at);
    turn(axis, by_yaw, yaw_axis, at);
    for (int i = 0; i < 3; ++i) m.rotation[i][k] = axis[i];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    m.velocity[i] = input(hosted.velocity[i], by_velocity + i);
    m.angular_velocity[i] = hosted.angular_velocity[i];
    for (std::size_t k = 0; k < 3; ++k) m.angular_velocity[i].d[by_angular_velocity + k] = hosted.axes[i][k];
  }
  turn(m.angular_velocity, by_roll, roll_axis, hosted.turning_with_body);
  turn(m.angular_velocity, by_yaw, yaw_axis, hosted.turning_with_body);

  const surface::RailMotion& rail = hosted.rail;
  m.rail.y = input(rail.y, by_rail_y);
  m.rail.z = input(rail.z, by_rail_z);
  m.rail.roll = input(rail.roll, by_rail_roll);
  m.rail.slope_y = input(rail.slope_y, slope_y);
  m.rail.slope_z = input(rail.slope_z, slope_z);
  m.rail.velocity_y = input(rail.velocity_y, by_rail_velocity_y);
  m.rail.velocity_z = input(rail.velocity_z, by_rail_velocity_z);
  m.rail.velocity_roll = input(rail.velocity_roll, by_rail_velocity_roll);
  m.rail.turning = input(rail.turning, roller_turning);
  return m;
}

/// Derivatives of the inputs of the rail frame: values do not count.
void differentiate_inputs(const surface::RelativeMotionOf<Number>& m,
                          Number (&inputs)[surface::frame_inputs]) {
  // place and attitude, then velocities, which are inputs as they are
  inputs[surface::place_y] = m.pose.y;
  inputs[surface::place_z] = m.pose.z;
  // the turning that has no part about rail y and moves the axle e like that: d e = d theta x e, so that
  // d theta_x = d e_z / e_y and d theta_z = -d e_x / e_y
  const auto& R = m.pose.rotation;
  const double per_axle = 1.0 / R[1][1].value;
  inputs[surface::turn_x] = R[2][1].chain(0.0, per_axle);
  inputs[surface::turn_z] = R[0][1].chain(0.0, -per_axle);
  for (int i = 0; i < 3; ++i) {
    inputs[surface::frame_velocity + i] = m.velocity.linear[i];
    inputs[surface::frame_turning + i] = m.velocity.angular[i];
  }
  inputs[surface::frame_roller] = m.velocity.roller;
  inputs[surface::frame_friction] = Number::input(1.0, friction);
}

/// Adds the columns of the distance along the track and of the wheel's angle; turning moves the wheel along
/// it.
void add_track(const surface::RelativeMotion& motion, const Number (&arm)[3], bool left,
               const surface::RailFrameJacobian& found, HostJacobian& jacobian) {
  const std::size_t columns[] = {by_distance, by_angle};
  for (std::size_t c = 0; c < 2; ++c) {
    double force[3], moment[3];
    for (int i = 0; i < 3; ++i) {
      force[i] = found.force[i].d[c];
      moment[i] = found.moment[i].d[c];
    }
    // neither axes nor arm depend on these inputs: plain vectors
    surface::into_track(motion, force);
    surface::into_track(motion, moment);
    if (left) {
      mirror_vector(force);
      mirror_rotation(moment);
    }
    add_cross(moment, {arm[0].value, arm[1].value, arm[2].value}, force);
    for (std::size_t i = 0; i < 3; ++i) {
      jacobian.wrench[i][columns[c]] = force[i];
      jacobian.wrench[3 + i][columns[c]] = moment[i];
    }
  }
  // the arm turns with the wheelset: its x is distance along the track
  for (auto& row : jacobian.wrench)
    for (std::size_t k = 0; k < by_load; ++k) row[k] += row[by_distance] * arm[0].d[k];
}

/// With a load that is given the height follows the other inputs, so that the vertical force stays the load.
/// dz/dx = (dF_z/dx) / k with the stiffness k = -dF_z/dz, dz/dload = 1 / k, and d/dx += d/dz dz/dx.
void follow_load(HostJacobian& jacobian) {
  constexpr std::size_t vertical = 2;
  const double stiffness = -jacobian.wrench[vertical][by_z];
  const double per_stiffness = stiffness != 0.0 ? 1.0 / stiffness : 0.0;
  for (std::size_t k = 0; k < hosted_inputs; ++k)
    jacobian.z[k] = jacobian.wrench[vertical][k] * per_stiffness;
  jacobian.z[by_z] = 0.0;
  jacobian.z[by_load] = per_stiffness;
  for (auto& row : jacobian.wrench) {
    const double by_height = row[by_z];
    row[by_z] = 0.0;
    for (std::size_t k = 0; k < hosted_inputs; ++k) row[k] += by_height * jacobian.z[k];
  }
}

}  // namespace

void hand_back_jacobian(const Model& model, const HostWheel& hosted, const PlacedWheel& placed, double height,
                        const surface::RailFrameJacobian& found, const surface::RailFrameJacobian& by_track,
                        HostJacobian& jacobian) {
  const surface::SurfaceModel& surface = *model.surface;
  const surface::WheelOnRail& problem = placed.problem;
  // the motion in the rail frame by the host's inputs, at the height that was solved
  PlacedMotion<Number> motion =
      place_motion(right_bodies(model), hosted, placed.left, differentiated_motion(hosted));
  if (placed.left) mirror_motion(motion);
  motion.wheel.position[2].value = height;
  const surface::RelativeMotionOf<Number> relative =
      surface::relative_motion(surface, motion.wheel, motion.rail, problem.distance);
  Number inputs[surface::frame_inputs];
  differentiate_inputs(relative, inputs);

  // chain rule in the rail's axes; then the axes, the mirror and the reference point move with the inputs as
  // well
  Number force[3], moment[3];
  const auto chained = [&inputs](const surface::RailFrameDual& in_rail, double by_time) {
    Number n = in_rail.value;
    n.d[time] = by_time;
    for (std::size_t j = 0; j < surface::frame_inputs; ++j)
      for (std::size_t k = 0; k < carried; ++k) n.d[k] += in_rail.d[j] * inputs[j].d[k];
    return n;
  };
  for (int i = 0; i < 3; ++i) {
    force[i] = chained(found.force[i], found.force_by_time[i]);
    moment[i] = chained(found.moment[i], found.moment_by_time[i]);
  }
  surface::into_track(relative, force);
  surface::into_track(relative, moment);
  if (placed.left) {
    mirror_vector(force);
    mirror_rotation(moment);
  }
  add_cross(moment, motion.arm, force);

  // columns in the order of the host, then those along the track
  jacobian = {};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t k = 0; k < carried; ++k) {
      jacobian.wrench[row][column_of(k)] = force[row].d[k];
      jacobian.wrench[3 + row][column_of(k)] = moment[row].d[k];
    }
  surface::WheelMotion wheel = problem.wheel;
  wheel.position[2] = height;
  add_track(surface::relative_motion(surface, wheel, problem.rail, problem.distance), motion.arm, placed.left,
            by_track, jacobian);
  jacobian.z[by_z] = 1.0;
  if (problem.load_prescribed) follow_load(jacobian);
}

}  // namespace wrc::contact
