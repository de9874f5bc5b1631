/// The wrench of a wheel on a rail with its derivatives: the formulas of wheel_on_rail.cpp in numbers that
/// carry them, at the solution the normal problem has come to.
#pragma once

#include <cstdint>

#include "base/dual.hpp"
#include "base/fault.hpp"
#include "surface/geometry/overlap_slopes.hpp"

namespace wrc {

struct SurfaceModel;
struct WheelOnRail;
struct WheelWork;

/// What a wrench in rail axes depends on: the wheel's place and attitude as the rail sees it, its velocities
/// less those of rail material, along and about rail axes [m/s], [rad/s], the turning of a roller [rad/s],
/// where it acts at a strip's own depth, and a factor on all friction, which is 1 [-].
enum SeenInput : std::int32_t {
  seen_velocity = place_inputs,
  seen_turning = seen_velocity + 3,
  seen_roller = seen_turning + 3,
  seen_friction,
  seen_inputs
};

using SeenDual = Dual<seen_inputs>;

/// On the wheel, about its reference point, rail axes.
struct RailFrameJacobian {
  SeenDual force[3], moment[3];
};

/// Doubles of working memory.
std::int64_t wrench_slopes_doubles(std::int32_t most_strips);

/// What a wrench is differentiated by: all SeenInput, or, of a model that varies(), the distance along the
/// track in place of the first and the wheel's angle in place of the second, and nothing else.
enum class SlopesBy { place, track };
inline constexpr std::int32_t track_distance = 0, track_angle = 1;

/// Differentiates what stands in `work` after a solve. WRC_FLAG_MORE_PATCHES, and no derivatives, with more
/// strips in contact than there is room for.
Fault differentiate_wrench(const SurfaceModel& model, const WheelOnRail& in, const WheelWork& work,
                           SlopesBy by, RailFrameJacobian& wrench) noexcept;

}  // namespace wrc
