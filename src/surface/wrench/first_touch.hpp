/// Heights that follow from the overlaps alone: first touch, clearance, and the border of deep overlaps.
#pragma once

#include "surface/wrench/wheel_solution.hpp"

namespace wrc::surface {

/// Overlaps are solved up to this deep [m]: several meganewtons, beyond any steel.
inline constexpr double deepest_overlap = 2e-3;

/// The height [m] at which the wheel first touches: lowered from the one given, or from above the rail where
/// a face is overlapped there already, until it does.
double first_touch(const WheelProblem& problem, Arena scratch);

/// Margin of tops that a height is predicted by [m].
inline constexpr double tops_apart = 0.2e-3;

/// On a rail that changes along the track: a height within 0.1 mm of that so far below first touch [m].
/// Leaves the motion there, and the tops of overlaps deeper than -tops_apart.
double tops_below_touch(const WheelProblem& problem, double below, RelativeMotion& motion,
                        WheelOverlaps& overlaps);

/// By how much a wheel that is apart must be lowered until the first strip of the rail overlaps it [m], 0 to
/// farthest_touch, which stands for anything beyond: Newton's method on the nearest strip.
double clearance(const WheelProblem& problem, Arena scratch);

/// The greatest height, no greater than `height`, at which no overlap is deeper than `deepest_overlap` [m].
/// Leaves the motion and the overlaps at `height` where it is the one.
double height_at_border(const WheelProblem& problem, double height, RelativeMotion& motion,
                        WheelOverlaps& overlaps);

}  // namespace wrc::surface
