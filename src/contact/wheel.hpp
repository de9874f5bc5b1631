/// A wheel on a rail, from the pose to the wrench in one call: from the axes, sides and reference points of
/// the host to those of src/surface and back. The stages' results in the contact are not touched.
#pragma once

#include <cstdint>

#include "contact/state.hpp"

namespace wrc::contact {

/// A wheel on a rail as a host has them, track axes; displacements count from the places that wrc.h names.
struct HostWheel {
  bool of_wheelset = true;  ///< the reference point is the middle of the axle; otherwise that of the wheel
  double y = 0.0, z = 0.0;  ///< displacement of the reference point [m]
  double rotation[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  ///< track = rotation * body, without pitch
  double velocity[3] = {};                                    ///< velocity of the reference point [m/s]
  double angular_velocity[3] = {};                            ///< [rad/s]
  /// Columns along which the host gives the angular velocity: axes of the track or of the body, or x, the
  /// axle and the rolled z, about which roll, the wheel and yaw turn.
  double axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  double turning_with_body[3] = {};  ///< its part along columns that turn with roll and yaw [rad/s]
  double frame_speed = 0.0;      ///< speed of the frame that velocities are given in, along its own x [m/s]
  double frame_turning[3] = {};  ///< its angular velocity about its own axes [rad/s]
  surface::RailMotion rail;
  bool load_prescribed = false;
  double vertical_load = 0.0;  ///< [N]
  surface::SolutionStart from = surface::SolutionStart::anew;
  bool frictionless = true;
  Friction friction;           ///< zones over the rail's y, in the caller's arrays
  tangential::FilmRows films;  ///< in rows, on that friction; cells are the caller's, or there are none
  double damping = 0.0;        ///< alpha of normal/damping.hpp [s/m]
  double distance = 0.0;       ///< reference point along the track, or from above a roller's axle [m]
  double angle = 0.0;          ///< about the axle [rad]
  double time = 0.0;           ///< since the committed step [s]
};

/// Inputs that a wrench is differentiated by, as enum wrc_wrench_input. Roll and yaw are those of the axle.
enum HostInput : std::int32_t {
  by_y,
  by_z,
  by_roll,
  by_yaw,
  by_velocity,
  by_angular_velocity = by_velocity + 3,
  by_rail_y = by_angular_velocity + 3,
  by_rail_z,
  by_rail_roll,
  by_rail_velocity_y,
  by_rail_velocity_z,
  by_rail_velocity_roll,
  by_load,
  by_distance,
  by_angle,
  by_rail_slope_y,
  by_rail_slope_z,
  by_roller_velocity,
  by_friction,
  by_time,
  hosted_inputs
};

/// Derivatives of a wrench: rows force x, y, z, moment x, y, z, on the wheel about its reference point.
struct HostJacobian {
  double wrench[6][hosted_inputs] = {};
  double z[hosted_inputs] = {};  ///< displacement z, given or found
};

/// A hosted wheel as the right-hand one of src/surface, with the numbers that lead back.
struct PlacedWheel {
  surface::WheelOnRail problem;
  bool left = false;         ///< `problem` is its mirror image
  double arm[3] = {};        ///< from the reference point to that of the wheel, host's track axes [m]
  double reference[3] = {};  ///< the reference point, its height as given [m]
  double rail[2] = {};       ///< y and z of the displaced origin of the rail's profile [m]
};

/// WRC_ERROR_UNSUPPORTED where the model has no surfaces: no profiles, or such as cannot be cut into strips.
/// The problem points to `hosted` where friction has a law.
Fault place_wheel(const Contact& contact, const HostWheel& hosted, PlacedWheel& placed);

/// Takes a wrench of `placed.problem` to the host's side and reference point and adds the rail's moment.
void hand_back_wrench(const Model& model, const PlacedWheel& placed, HostWrench& result);

/// Takes derivatives by motions in the rail's frame to those by the host's inputs (wheel_jacobian.cpp).
/// `height`: of the right-hand wheel in the solution [m].
void hand_back_jacobian(const Model& model, const HostWheel& hosted, const PlacedWheel& placed, double height,
                        const surface::RailFrameJacobian& found, const surface::RailFrameJacobian& by_track,
                        HostJacobian& jacobian);

/// Marks the last solution, for later ones to start from.
Fault mark_wheel(Contact& contact);

/// Makes the last solution the step that later ones begin with, its tractions included.
Fault commit_wheel(Contact& contact);

/// Solves for the wrench, kept in the contact. `slopes`: nullptr, not wanted.
Fault solve_wheel(Contact& contact, const HostWheel& hosted, HostJacobian* slopes = nullptr);

}  // namespace wrc::contact
