/// Stage geometry: the pose of a wheel -> its overlaps with the strips of a rail.
///
/// Both cross sections by arc length and the strips of the rail do not change while a wheel rolls. A distance
/// along the track places the strips; a pose of the wheel gives their overlaps (overlap.hpp), to which the
/// rail's changes along the track and the wheel's round it are added (along_track.hpp).
#pragma once

#include "surface/geometry/along_track.hpp"

namespace wrc::surface {

/// The surfaces of a wheel and a rail.
struct SurfaceGeometry {
  Curve rail_curve;
  RailStrips rail;
  WheelCurve wheel;
  VaryingRail varying;
  OutOfRound out_of_round;
  double wheel_radius = 0.0;         ///< nominal [m]
  double roller_curvature = 0.0;     ///< 1 / radius of a roller at its profile's origin; 0: a rail [1/m]
  const Kernels* kernels = nullptr;  ///< that search them
};

/// Is there anything that changes along the track or round the wheel?
inline bool varies(const SurfaceGeometry& surfaces) {
  return surfaces.varying.faces > 0 || surfaces.out_of_round.rows > 0 || surfaces.roller_curvature != 0.0;
}

/// The rail where the wheel is, in `arrays` if it varies: at `distance` [m] or, flagged, at the nearest
/// section; the side of a check rail that guides.
Fault place_rail(const SurfaceGeometry& surfaces, double distance, const StripArrays& arrays,
                 PlacedRail& rail);

/// The rail's strips without those of faces behind the flange that look away from the wheel.
RailStrips strips_before(const SurfaceGeometry& surfaces, const RelativePose& pose, const RailStrips& strips);

/// Looks for the candidates of a rail that changes along the track, in a pose: strips whose overlap is deeper
/// than -reach anywhere along the track. `scratch` has gains of the strips, `memory` is scratch, too.
void look_for_candidates(const SurfaceGeometry& surfaces, const PlacedRail& rail, const RelativePose& pose,
                         double reach, const OverlapScratch& scratch, const Overlaps& memory) noexcept;

/// Are all strips with depth > -margin in a pose among the candidates known?
bool candidates_hold(const CandidatesAlong& candidates, const RelativePose& pose, double margin);

/// All overlaps with depth > -margin, in the arrays of `memory`. `angle`: of the wheel about its axle [rad].
/// On a rail that changes along the track candidates are looked for again, unless those known hold.
Overlaps overlap_surfaces(const SurfaceGeometry& surfaces, const PlacedRail& rail, const RelativePose& pose,
                          double angle, double margin, const OverlapScratch& scratch, const Overlaps& memory,
                          bool tops_alone = false) noexcept;

/// The overlaps of strips of one face, which changes along the track. Those that are not `deep_enough` are of
/// tops alone [m].
void follow_rail(const SurfaceGeometry& surfaces, const PlacedRail& rail, const RelativePose& pose,
                 FollowedStrips& strips, double deep_enough = -1.0);

/// Does the surface of a strip change along the track?
inline bool changes_along(const SurfaceGeometry& surfaces, std::int32_t strip) {
  const VaryingRail& rail = surfaces.varying;
  return rail.faces > 0 && rail.face[face_of(rail, strip)].changes;
}

/// Adds a roller's fall and the wheel's deviation from round to the overlap of one strip. `y`: on the wheel's
/// profile [m]; `distance`, `angle`: of the wheel.
template <class Number>
void follow_others(const SurfaceGeometry& surfaces, const PlacedRail& rail,
                   const RelativePoseOf<Number>& pose, std::int32_t strip, const Number& y,
                   const Number& distance, const Number& angle, StripOverlap<Number>& o) {
  if (surfaces.roller_curvature != 0.0) follow_roller(surfaces.roller_curvature, rail.z[strip], distance, o);
  if (surfaces.out_of_round.rows > 0) follow_wheel(surfaces.out_of_round, pose, y, angle, o);
}

}  // namespace wrc::surface
