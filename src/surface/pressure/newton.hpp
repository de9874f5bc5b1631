/// Newton's method on the fixed-point residual, for the few solves that the iteration does not end: beside a
/// strip whose overlap is nearly flat along x the map leads away from the solution.
#pragma once

#include "surface/pressure/iteration.hpp"

namespace wrc::surface {

/// Goes on from the lengths and shifts in `s`, within the limits of work. Without a solution `s` has the last
/// iterate, with its loads: the best but for jumps.
PressureResult solve_by_newton(const PressureProblem& problem, StripSet& s, const IterationLimits& limits,
                               PressureScratch& w);

}  // namespace wrc::surface
