/// Hertz contact of a general gap: the elliptic baseline.
///
/// Limits: constant curvatures. A comes from the row at the contact point, B from the chord of the gap at
/// half the approach (penetration.hpp), so that the ellipse sees the gap over its own width and moves
/// smoothly; it therefore depends on the load, unlike the textbook's local second derivative, which on
/// S1002/UIC60 jumps by a factor of three within a millimetre. The ellipse is centred on the initial contact
/// point.
///
/// Hertz 1881; Johnson, Contact Mechanics (1985), chapter 4.
#pragma once

#include "normal/problem.hpp"

namespace wrc::normal {

/// Solves the problem and cuts the ellipse into strips (patch/sdec.hpp: their load is the ellipse's,
/// exactly). Real-time: no allocation; at most problem.max_iterations + 10 evaluations.
Fault solve_hertz(const NormalProblem& problem, patch::Strips& strips, NormalSolution& solution) noexcept;

}  // namespace wrc::normal
