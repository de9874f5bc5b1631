/// How the overlap of a strip changes with the wheel's place and attitude: the formulas of overlap.hpp in
/// numbers that carry their derivatives.
#pragma once

#include "base/dual.hpp"
#include "surface/geometry/outline.hpp"

namespace wrc {

/// What moves a wheel as a rail sees it: along rail y and z [m], about the x and z axes through its reference
/// point [rad]. The turning about y follows from the axle's unit length, and about the axle nothing changes.
enum PlaceInput : std::int32_t { place_y, place_z, turn_x, turn_z, place_inputs };

using PlaceDual = Dual<place_inputs>;

/// The overlap of one strip with its derivatives; `lean` is 0 where the rail is the same everywhere.
struct OverlapSlopes : StripOverlap<PlaceDual> {
  PlaceDual y_wheel;  ///< on the wheel's profile [m]
};

/// A strip's middle and tangent, which move with a rail that is not the same everywhere.
struct StripPlace {
  PlaceDual y, z, ty, tz;
};

/// Of candidate i of the last find_overlaps() with the same pose, whose scratch is as that left it.
OverlapSlopes overlap_slopes(const StripPlace& place, const WheelCurve& wheel,
                             const RelativePoseOf<PlaceDual>& pose,
                             const OutlineAttitudeOf<PlaceDual>& attitude, const OverlapScratch& scratch,
                             std::int32_t strip);

/// A pose that carries the derivatives with respect to what moves it.
RelativePoseOf<PlaceDual> moving_pose(const RelativePose& pose);

}  // namespace wrc
