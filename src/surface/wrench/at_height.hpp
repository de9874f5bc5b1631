/// The wrench of a wheel at a height: overlaps, pressures, slips, tractions, sums.
#pragma once

#include "surface/wrench/wheel_solution.hpp"

namespace wrc::surface {

/// Where the normal problem at the next height starts: a solve leaves its solution there.
struct HeightStart {
  PressureStart solution;
  StartFrom from;
  double stiffness;  ///< growth of the load with the height, as a part of Hertz's (KeptStart)
};

/// Solves at heights: the problem, where the normal problem starts, and where results go. A solve replaces
/// the solution and the wrench as a whole, but for iterations and work, which add up.
struct HeightSolver {
  const WheelProblem& problem;
  HeightStart& start;
  Arena scratch;
  WheelSolution& solution;
  Wrench& out;
};

/// `tolerance`: PressureOptions.
Fault solve_at_height(const HeightSolver& solver, double height, double tolerance);

/// The wrench at the height of the problem. Beyond the deepest overlap that is solved the load goes on with
/// the stiffness it had, in the directions it had.
Fault solve_given_height(const HeightSolver& solver);

/// Does a fault of a solve say that the bodies are apart, and not that the wheel is inside the rail?
bool is_apart(const Fault& fault);

}  // namespace wrc::surface
