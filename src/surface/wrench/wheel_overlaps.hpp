/// The rail below a wheel, and the overlaps of its strips with the wheel at a height.
#pragma once

#include "surface/wrench/wheel_solution.hpp"

namespace wrc {

/// Overlaps are solved up to this deep [m]: several meganewtons, beyond any steel.
inline constexpr double deepest_overlap = 2e-3;

/// The strips of the rail where the wheel is, in `memory` of rail_strip_doubles() where they are not the
/// model's; flagged where there is no section.
Fault place_rail(const SurfaceModel& model, const WheelOnRail& in, double* memory, RailBelow& rail);

/// The motion with the reference point at this height [m].
RelativeMotion motion_at_height(const SurfaceModel& model, const WheelOnRail& in, double height);

/// The rail's strips but those of faces behind the flange that look away from the wheel.
RailStrips strips_before_wheel(const SurfaceModel& model, const RelativeMotion& motion,
                               const RailStrips& strips);

/// Finds all strips with depth > -margin [m].
void find_wheel_overlaps(const WheelProblem& problem, const RelativeMotion& motion, double margin,
                         WheelOverlaps& overlaps);

/// Strips nearer than this to the wheel are candidates of the normal problem [m].
double candidate_margin(const SurfaceModel& model);

/// The wheel's knot of the largest radius: the tip of its flange.
std::int32_t flange_tip(const WheelCurve& wheel);

}  // namespace wrc
