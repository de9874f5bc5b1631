/// A wheel on a rail: where both are and how they move in, the wrench between them out.
///
/// Nothing here chooses a contact point. The rail's cross section is cut once into strips at fixed arc
/// lengths (rail_strips.hpp); a pose gives every strip its own overlap with the wheel (overlap.hpp), the
/// half-space solver their pressures (pressure.hpp), rigid-body kinematics of the wheel their slips
/// (surface_rolling.hpp). Forces are summed strip by strip in the rail's axes and turned into track axes
/// once.
///
/// Bodies here are those of a right-hand wheel on a right-hand rail; a left-hand contact is the mirror image,
/// made by the caller of this room: y, roll, yaw, their rates and M_x, M_z change sign.
///
/// Track axes: x rolling direction, y to the right, z down, origin on the track's centre line level with the
/// tops of the undisplaced rails.
#pragma once

#include <cstdint>

#include "base/fault.hpp"
#include "tangential/friction/friction.hpp"
#include "tangential/rolling_contact.hpp"

namespace wrc {

/// A wheel as a rigid body. The reference point is where the plane of the tape circle meets the axle.
struct WheelMotion {
  double position[3] =
      {};  ///< of the reference point, track axes [m]; x from where the rail's place is given
  double rotation[3][3] = {
      {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  ///< track = rotation * wheel axes; y along the axle
  double velocity[3] = {};               ///< of the reference point against the ground, track axes [m/s]
  double angular_velocity[3] = {};       ///< track axes, the turning about the axle included [rad/s]
};

/// A rail: displacement of the origin of its profile, at x = 0, from its place in the model, and rotation
/// about that origin: by roll about its own direction, which the slopes give (rail_direction.hpp).
struct RailMotion {
  double y = 0.0, z = 0.0, roll = 0.0;                             ///< [m], [rad]
  double slope_y = 0.0, slope_z = 0.0;                             ///< of its place along the track [-]
  double velocity_y = 0.0, velocity_z = 0.0, velocity_roll = 0.0;  ///< [m/s], [rad/s]
  double turning = 0.0;  ///< of a roller about its axle, right-hand rule about its y [rad/s]
};

/// What is solved.
struct WheelOnRail {
  WheelMotion wheel;
  RailMotion rail;
  bool load_prescribed = false;  ///< then position[2] is a result, and `vertical_load` is given
  double vertical_load = 0.0;    ///< the whole vertical force on the wheel, upwards positive [N]
  double friction = 0.3;         ///< coefficient; 0: frictionless
  const FrictionLaw* law =
      nullptr;                  ///< in place of the coefficient: over a profile's y and the sliding speed
  bool zones_on_wheel = false;  ///< its zones lie on the wheel's profile, not on the rail's
  double distance =
      0.0;             ///< of the wheel's reference point along the track, or from above a roller's axle [m]
  double angle = 0.0;  ///< of the wheel about its axle, right-hand rule [rad]
  double slope_reduction = 1.0;  ///< of the creep curve by a layer between the bodies, 0..1
  SlopeFall slope;               ///< what it does as slip grows
  double damping = 0.0;          ///< Hunt and Crossley [s/m]
};

/// A run of strips in contact.
struct SurfaceRegion {
  std::int32_t first = 0, count = 0;  ///< strips of the rail
  double point[3] = {};               ///< load-weighted mean of its strips' pressure centres, track axes [m]
  double angle = 0.0;          ///< of its resultant normal force, about x from track z to the normal [rad]
  double normal_force = 0.0;   ///< resultant of the pressure [N]
  double force[3] = {};        ///< on the wheel, track axes [N]
  double moment[3] = {};       ///< about `point`, on the wheel, track axes [N m]
  double area = 0.0;           ///< [m^2]
  double peak_pressure = 0.0;  ///< [Pa]
  double power = 0.0;          ///< frictional power [W]
  double creepage[3] = {};     ///< load-weighted means of its strips' slips: x, lateral [-], spin [1/m]
};

constexpr std::int32_t most_surface_regions = 16;

/// First touch is looked for up to this far above the rail [m].
inline constexpr double farthest_touch = 50e-3;

struct Wrench {
  double force[3] = {};       ///< on the wheel, track axes [N]
  double moment[3] = {};      ///< about the wheel's reference point, track axes [N m]
  double height = 0.0;        ///< position[2] of the wheel, as given or as found [m]
  double normal_force = 0.0;  ///< sum of the regions' resultants [N]
  double area = 0.0, peak_pressure = 0.0, power = 0.0;
  double steepest_angle = 0.0;  ///< largest angle of a strip in contact, the rail's roll included [rad]
  /// By how much a wheel that is apart must be lowered to touch: at most farthest_touch, which says that it
  /// is that or more; 0 in contact, and inside the rail [m].
  double clearance = 0.0;
  std::int32_t regions = 0;
  std::int32_t sweeps = 0;  ///< of the normal problem, all of the call
  SurfaceRegion region[most_surface_regions];
};

}  // namespace wrc
