/// How the overlap of a strip changes with the wheel's place and attitude: the formulas of outline.hpp in
/// numbers that carry their derivatives.
#pragma once

#include "base/dual.hpp"
#include "surface/geometry/surface_geometry.hpp"

namespace wrc::surface {

/// Motions of a wheel as a rail sees it: along rail y and z [m], about the x and z axes through its reference
/// point [rad]. The turning about y follows from the axle's unit length, and about the axle nothing changes.
enum PlaceInput : std::int32_t { place_y, place_z, turn_x, turn_z, place_inputs };

using PlaceDual = Dual<place_inputs>;

/// The overlap of one strip with its derivatives; `grade` is 0 where the rail is the same everywhere.
struct OverlapSlopes : StripOverlap<PlaceDual> {
  PlaceDual y_wheel;  ///< on the wheel's profile [m]
};

/// The overlap of a strip on a rail that changes along the track, of the wheel's reference point at
/// `distance` [m]. `near`: the strip near the top of its overlap, and a second time near its other top, if it
/// has two.
OverlapSlopes overlap_slopes(const SurfaceGeometry& surfaces, const PlacedRail& rail,
                             const RelativePoseOf<PlaceDual>& pose, const PlaceDual& distance,
                             FollowedStrips& near);

/// A pose that carries its derivatives by all PlaceInput.
RelativePoseOf<PlaceDual> moving_pose(const RelativePose& pose);

}  // namespace wrc::surface
