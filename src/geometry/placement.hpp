/// Where profiles sit: rails in the track frame by gauge and inclination, wheels in the wheelset frame by
/// flange-back distance. Init only.
///
/// Track frame: origin on the track centre line in the plane through the tops of the rails, x forward
/// (rolling direction), y right, z down; right-handed. Wheelset frame: the same axes fixed to the wheelset
/// (not turning with the axle), origin in the middle of the axle. Left-hand bodies are mirrored here, once,
/// so that everything downstream works in these true frames, the same for both sides.
#pragma once

#include <cstdint>

#include "geometry/profile.hpp"

namespace wrc::geometry {

enum class Side : std::int32_t { right, left };

/// A rotation towards the track centre and then a shift, in the coordinates of a right-hand profile.
struct Placement {
  double inclination = 0.0;  ///< tangent of the cant angle (1/40: the top leans towards negative y) [-]
  double y = 0.0, z = 0.0;   ///< shift after the rotation [m]
};

/// Places `profile` into `memory`. The nodes are rotated exactly, value and slope; ends that the rotation
/// turns vertical or beyond are cut off. WRC_ERROR_PROFILE if the profile's middle would fold back or hardly
/// anything is left.
Fault place(const Profile& profile, const Placement& placement, const ProfileMemory& memory, Profile& placed);

/// y -> -y of a profile in `memory`, node order reversed so that y still increases.
void mirror(const ProfileMemory& memory, const Profile& profile);

struct TrackDimensions {
  double gauge = 0.0;             ///< between the gauge faces [m]
  double gauge_depth = 0.0;       ///< the gauge is measured here, below the top of the rail [m]
  double rail_inclination = 0.0;  ///< cant of the given profile; 0 if its points are canted already [-]
  bool by_origin = false;    ///< the origin of the profile lies at rail_origin and z = 0, whatever the gauge
  double rail_origin = 0.0;  ///< distance of that origin from the track's centre line [m]
};

struct WheelsetDimensions {
  double tape_circle_distance = 0.0;  ///< between the origins of both wheels' profiles [m]
  double nominal_radius = 0.0;        ///< at the origin of the wheel profile (tape circle) [m]
};

/// A rail in the track frame.
struct Rail {
  Profile profile;  ///< track frame
  double origin_y =
      0.0;  ///< y of the origin of its profile coordinates (after canting) in the track frame [m]
  double origin_z = 0.0;  ///< z of that origin [m]
  double outward = 1.0;   ///< +1 right rail, -1 left: direction of the field side along y
};

/// A wheel in the wheelset frame. Its radius at wheelset y is nominal_radius + profile z.
struct Wheel {
  Profile profile;              ///< y in the wheelset frame, z from the tape circle, down
  double origin_y = 0.0;        ///< y of the tape circle in the wheelset frame [m]
  double nominal_radius = 0.0;  ///< [m]
  double outward = 1.0;         ///< +1 right wheel, -1 left
};

/// Canted about its origin, then top at z = 0 and gauge face at half the gauge, or the origin where `track`
/// puts it. The gauge face is the innermost point of the profile that lies no deeper than the gauge depth
/// below the top; WRC_ERROR_PROFILE where the profile ends above.
Fault place_rail(const Profile& profile, const TrackDimensions& track, Side side, const ProfileMemory& memory,
                 Rail& rail);

/// Tape circle at half their distance.
Fault place_wheel(const Profile& profile, const WheelsetDimensions& wheelset, Side side,
                  const ProfileMemory& memory, Wheel& wheel);

}  // namespace wrc::geometry
