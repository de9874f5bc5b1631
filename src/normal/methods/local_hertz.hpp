/// The method behind ANALYN and STRIPES: every strip is a Hertz contact of its own curvatures.
///
/// At strip y, with the gap's A (along x) and B (along y) there, Hertz gives eps_x + eps_y = 1 for A / B, and
///   outline      overlap g = eps_y delta - height(y) > 0
///   local depth  d = g / eps_y
///   half length  l^2 = (eps_x / eps_y) g / A
///   peak         of Hertz's contact of A, B under the approach d
/// Exact for elliptic gaps. No integral, no contact condition: no strip depends on its neighbours.
#pragma once

#include "normal/problem.hpp"

namespace wrc::normal {

/// Solves the problem with B taken as half the second difference of the gap over +-reach(approach, lateral
/// half width at half the approach) [m]; B is floored at 0.1 1/m, below which a wheel counts as flat.
using CurvatureReach = double (*)(double half_width);
Fault solve_local_hertz(const NormalProblem& problem, CurvatureReach reach, patch::Strips& strips,
                        NormalSolution& solution) noexcept;

}  // namespace wrc::normal
