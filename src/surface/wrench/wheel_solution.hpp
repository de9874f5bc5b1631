/// A wheel on a rail on its way to the wrench: the problem, and the results of the stages at one height.
///
/// Memory: one block, of which the rail's strips and the stages' results come first. Behind them lies the
/// list of candidates along the track, which heights share and derivatives do not read. The rest is scratch,
/// handed to each stage as an Arena by value, so that a stage cuts where the one before has: derivatives cut
/// from the list on.
#pragma once

#include <algorithm>
#include <cstdint>

#include "base/arena.hpp"
#include "surface/geometry/overlap.hpp"
#include "surface/pressure/pressure.hpp"
#include "surface/rolling/surface_rolling.hpp"
#include "surface/surface_model.hpp"
#include "surface/wrench/strip_results.hpp"
#include "surface/wrench/wheel_on_rail.hpp"

namespace wrc::surface {

/// Numbers that the size of the memory follows from.
struct WorkSizes {
  std::int32_t wheel_pieces, cells;
  std::int32_t strips;  ///< that may overlap at a time
  bool varying;         ///< the rail or the wheel is not the same everywhere
  const SurfaceMethods& methods;
  std::int32_t rail_strips = most_strips_of_a_rail;  ///< most of the rail
  std::int32_t placed = 0;                           ///< those placed anew at each distance
  std::int32_t candidates = 0;                       ///< tops along the track
};
WorkSizes work_sizes(const SurfaceModel& model);

struct WheelProblem {
  const SurfaceModel& model;
  const WheelOnRail& in;
  PlacedRail rail;                       ///< where the wheel is
  tangential::Memory* memory = nullptr;  ///< the tractions, where the model remembers
};

/// Overlaps at a height, and scratch for the outline of the wheel that they are found by.
struct WheelOverlaps : Overlaps {
  OverlapScratch outline;
  /// Margin that whole contacts along the track were found with; negative: others, or none [m].
  double margin = -1.0;
  double found_y = 0.0, found_z = 0.0;  ///< the wheel's reference point then [m]
  double moved_y = 0.0, moved_z = 0.0;  ///< where they have been moved to since [m]
};

/// The strips in contact, by increasing arc length.
struct ContactStrips : ContactArrays {
  std::int32_t count = 0;
  std::int32_t* candidate = nullptr;  ///< number among the overlaps
  double* x = nullptr;                ///< x of the pressure, from the wheel's reference point, rail axes [m]
};

/// Results of the stages at one height, which belong together: find_wheel_overlaps(), the normal problem, and
/// the strips in contact with their tractions.
struct WheelSolution {
  RelativeMotion motion;
  WheelOverlaps overlaps;
  StripPressure pressure;
  ContactStrips strips;
  StripResultsHead sums;  ///< count apart
};

/// Scratch of the tangential problem.
struct RollingScratch {
  tangential::TangentialFields fields;     ///< over the cells
  double* rolling;                         ///< surface_rolling_workspace()
  double *slip_x, *spin;                   ///< mirrored, of rolling backwards
  double *other_fx, *other_fy, *other_mz;  ///< forces of rolling the other way
  double *cold_friction,
      *heat_share;     ///< shares of friction over temperature (tangential/friction/heated_friction.hpp)
  double *x, *region;  ///< methods that roll whole patches: x along the direction of rolling [m]
};

WheelOverlaps cut_wheel_overlaps(Arena& arena, const WorkSizes& sizes);
/// The columns of its strips are those of `results`. The outline is cut in the scratch of heights.
WheelSolution cut_solution(Arena& arena, const WorkSizes& sizes, const ContactArrays& results);
RollingScratch cut_rolling(Arena& arena, const WorkSizes& sizes);

/// Bytes of a solve: results, and behind them the scratch of each stage in the same memory, of those at
/// heights with the candidates.
struct WheelWorkBytes {
  std::int64_t results, overlaps, pressure, rolling, derivatives;

  std::int64_t all() const { return results + std::max({overlaps, pressure, rolling, derivatives}); }
};
WheelWorkBytes wheel_work_bytes(const WorkSizes& sizes);

/// Strips nearer than this to the wheel are candidates of the normal problem [m].
inline double candidate_margin(const SurfaceModel& model) {
  return model.methods.planar.solve ? planar_margin : 0.0;
}

/// Finds all strips with depth > -margin [m]. `tops_alone`: along the track by the tops of overlaps, without
/// contacts' chords.
inline void find_wheel_overlaps(const WheelProblem& problem, const RelativeMotion& motion, double margin,
                                WheelOverlaps& o, bool tops_alone = false) {
  static_cast<Overlaps&>(o) = overlap_surfaces(problem.model, problem.rail, motion.pose, problem.in.angle,
                                               margin, o.outline, o, tops_alone);
  o.margin = tops_alone || !changes(problem.model.varying) ? -1.0 : margin;
  o.found_y = o.moved_y = motion.pose.y;
  o.found_z = o.moved_z = motion.pose.z;
}

/// Moves overlaps along the track to a pose very near the one that they were found at, as their tangents say.
/// Returns whether it is that near: the last heights of a search lie nanometres apart.
bool move_wheel_overlaps(const WheelProblem& problem, const RelativeMotion& motion, double margin,
                         WheelOverlaps& o);

}  // namespace wrc::surface
