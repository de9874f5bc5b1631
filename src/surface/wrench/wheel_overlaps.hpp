/// Overlaps of a wheel at a height with the rail below it.
#pragma once

#include "surface/wrench/wheel_solution.hpp"

namespace wrc {

/// Overlaps are solved up to this deep [m]: several meganewtons, beyond any steel.
inline constexpr double deepest_overlap = 2e-3;

/// The motion with the reference point at this height [m].
RelativeMotion motion_at_height(const SurfaceModel& model, const WheelOnRail& in, double height);

/// Finds all strips with depth > -margin [m].
void find_wheel_overlaps(const WheelProblem& problem, const RelativeMotion& motion, double margin,
                         WheelOverlaps& overlaps);

/// Strips nearer than this to the wheel are candidates of the normal problem [m].
double candidate_margin(const SurfaceModel& model);

}  // namespace wrc
