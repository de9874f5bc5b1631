/// ANALYN in the modified form CONTACT carries: local Hertz contacts with local curvatures.
///
/// Sichani, Enblom, Berg, Vehicle System Dynamics 52 (2014); the modified form as found in CONTACT's public
/// source, and confirmed against its results (0.2 % on the same rows, p0 1.2 % at steps of the curvature).
/// [unconfirmed] against the paper, whose text was not available.
///
/// Limits: sensitive to the local lateral curvature B(y), a second derivative: on profiles with curvature
/// steps the outline has steps too, and load and area may jump as the pose moves. CONTACT takes B over the
/// neighbouring rows of its grid, 0.2 mm in its example; 0.3 mm here stands in for grids up to that.
#pragma once

#include "normal/methods/local_hertz.hpp"

namespace wrc::normal {

/// Real-time: no allocation; at most problem.max_iterations + 10 evaluations.
inline Fault solve_analyn(const NormalProblem& problem, patch::Strips& strips,
                          NormalSolution& solution) noexcept {
  return solve_local_hertz(
      problem, [](double) { return 0.3e-3; }, strips, solution);
}

}  // namespace wrc::normal
