/// The Kik-Piotrowski method: outline by virtual penetration, pressure level from the contact point alone.
///
///   outline    x_f(y) = sqrt(2 R g(y)),  g = eps delta - f(y)  where positive,  R at the contact point
///   pressure   p = p00 sqrt(x_f^2 - x^2) / x_f(0)
///   condition  delta = (1 - nu) / (pi G) IInt p / r dA  at the geometrical contact point
///
/// Kik and Piotrowski 1996; Piotrowski and Kik, Vehicle System Dynamics 46 (2008) 27-48.
///
/// Limits: the outline ignores yaw (centre line at the contact point's x) and the change of the rolling
/// radius; eps = 0.55 makes Hertzian patches 10 to 24 % too large in area; where the lateral curvature
/// varies, peak pressures are off by 28 to 55 % against the exact theory.
#pragma once

#include "normal/problem.hpp"

namespace wrc::normal {

struct KikPiotrowskiOptions {
  double penetration_scale = 0.55;  ///< eps [-], above 0, at most 1
};

/// Real-time: no allocation; at most problem.max_iterations + 10 evaluations.
Fault solve_kik_piotrowski(const NormalProblem& problem, const KikPiotrowskiOptions& options,
                           patch::Strips& strips, NormalSolution& solution) noexcept;

}  // namespace wrc::normal
