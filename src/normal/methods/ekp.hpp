/// The extended Kik-Piotrowski method (EKP): virtual penetration of the three-dimensional gap, yaw included,
/// with the penetration scale taken from Hertz's theory for the patch's own curvatures.
///
/// Liu, Bruni, Vollebregt, Vehicle System Dynamics 54 (2016) 1226-1246, extends Kik-Piotrowski by the effect
/// of yaw on the patch and by the variation of the lateral curvature across it. [unconfirmed] Its text was
/// not available: this is a working definition, checked against the one EKP patch published with its
/// dimensions (S1002 on UIC60, 80 kN: a = 5.8 mm, b = 10.3 mm, psi = -0.3).
///
///   outline    strips where the gap h(x, y), whose rows have their own centre (yaw) and curvature, lies
///              below eps(y) delta
///   eps        from Hertz's eps_x + eps_y = 1 for A (contact point) and B (chord over the patch)
///   pressure   p = p0 sqrt(x_l^2 - (x - x_c)^2) / x_l,max
///   condition  delta = (1 - nu) / (pi G) IInt p / r dA  at the contact point
///
/// Limits: the pressure has one peak, of a height proportional to the strip's length; where the lateral
/// curvature varies, peak pressures are off by 28 to 55 % against the exact theory. Outline and approach are
/// good to 5 %.
#pragma once

#include "normal/problem.hpp"

namespace wrc::normal {

/// Rule by which eps follows from eps_x and eps_y.
enum class EkpScale {
  /// One eps = sqrt(eps_x eps_y): the overlap of an elliptic gap then has exactly the area of Hertz's
  /// ellipse. The reading that comes closest to the published patch.
  area,
  /// eps(y) parabolic from eps_x at mid-width to eps_y at Hertz's b: the outline of an elliptic gap is then
  /// exactly Hertz's ellipse. Every region of overlap counts (overlap_regions.hpp). This is the method
  /// CONTACT calls KPEC, confirmed against it: approach and peak to 0.02 %, area to 0.1 % on the same rows.
  ellipse,
};

struct EkpOptions {
  EkpScale scale = EkpScale::area;
};

/// Real-time: no allocation; at most problem.max_iterations + 10 evaluations.
Fault solve_ekp(const NormalProblem& problem, const EkpOptions& options, patch::Strips& strips,
                NormalSolution& solution) noexcept;

}  // namespace wrc::normal
