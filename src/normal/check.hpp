/// Checks of the input that all normal methods share, and their common beginning.
#pragma once

#include "normal/problem.hpp"

namespace wrc::normal {

/// Gap rows usable (at least four, finite, y increasing, curvature > 0), material, load or approach in order,
/// memory for the strips. WRC_FLAG_NO_CONTACT for a load or an approach of zero: `output.count` is then zero
/// and there is nothing to solve.
Fault check_normal_problem(const NormalProblem& problem, patch::Strips& output) noexcept;

/// First touch of the undeformed bodies.
struct FirstTouch {
  patch::GapMinimum lowest;
  patch::GapRow row;  ///< row of the gap at lowest.y
};

/// Beginning of most methods: the solution cleared, the problem checked, first touch found.
Fault begin_solution(const NormalProblem& problem, patch::Strips& output, NormalSolution& solution,
                     FirstTouch& touch) noexcept;

}  // namespace wrc::normal
