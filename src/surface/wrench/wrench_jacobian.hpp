/// The wrench of a wheel on a rail with its derivatives: the formulas of at_height.cpp in numbers that carry
/// them, at the solution of the normal problem.
#pragma once

#include <cstdint>

#include "base/arena.hpp"
#include "base/dual.hpp"
#include "base/fault.hpp"
#include "surface/geometry/overlap_slopes.hpp"

namespace wrc::surface {

struct WheelProblem;
struct WheelSolution;
struct WorkSizes;

/// Inputs of a wrench in rail axes: first the wheel's place and attitude relative to the rail (PlaceInput).
/// Then its velocities less those of rail material, along and about rail axes [m/s], [rad/s]; the turning of
/// a roller where that acts at a strip's own depth [rad/s]; a factor on all friction, which is 1 [-].
enum RailFrameInput : std::int32_t {
  frame_velocity = place_inputs,
  frame_turning = frame_velocity + 3,
  frame_roller = frame_turning + 3,
  frame_friction,
  frame_inputs
};

using RailFrameDual = Dual<frame_inputs>;

/// On the wheel, about its reference point, rail axes.
struct RailFrameJacobian {
  RailFrameDual force[3], moment[3];
  double force_by_time[3], moment_by_time[3];  ///< by the time since the committed step [N/s], [N m/s]
};

/// Inputs that a wrench is differentiated by: all RailFrameInput, or, of a model that varies(), the distance
/// along the track in place of the first and the wheel's angle in place of the second, and nothing else.
enum class JacobianBy { place, track };
inline constexpr std::int32_t track_distance = 0, track_angle = 1;

/// Counts the scratch of differentiate_wrench().
void count_wrench_jacobian(Arena& arena, const WorkSizes& sizes);

/// Differentiates a solution. WRC_FLAG_MORE_PATCHES, and no derivatives, with more strips in contact than
/// fit.
Fault differentiate_wrench(const WheelProblem& problem, const WheelSolution& solved, JacobianBy by,
                           Arena arena, RailFrameJacobian& wrench) noexcept;

}  // namespace wrc::surface
