/// The simple double-elliptic contact region (SDEC): two half ellipses of the same length joined along the
/// rolling direction.
///
///   x_l(y) = a sqrt(1 - (y / b_side)^2),   b_side = b (1 + psi) for y > 0 and b (1 - psi) for y < 0,
///
/// y from the joint, which lies at the initial contact point. psi = 0 is the ellipse. Source paper, eq. 1
/// to 3.
#pragma once

#include "patch/strips.hpp"

namespace wrc::patch {

struct Sdec {
  double a = 0.0;    ///< half length [m]
  double b = 0.0;    ///< half width [m]
  double psi = 0.0;  ///< shape number, |psi| < 1: mid-width is at y = psi b [-]
};

/// Peak pressure of the semi-elliptic pressure that carries `normal_force`: 1.5 N / (pi a b) [Pa].
double peak_pressure(const Sdec& sdec, double normal_force) noexcept;

/// Cuts the region with its joint at (x_joint, y_joint) into `count` strips (even, at most strips.capacity)
/// that carry p = p0 sqrt(x_l^2 - x^2) / a.
///
/// Each half ellipse gets half of them, of equal width: the joint is a strip border, so that no strip mixes
/// the two halves, and nothing jumps when psi moves. A strip's half length is the root mean square of x_l
/// over its width: the strips then carry `normal_force` to rounding, for any count. Area converges like
/// count^{-3/2}. An odd count gives the additional strip to the wider half.
void sdec_strips(const Sdec& sdec, double x_joint, double y_joint, double normal_force, std::int32_t count,
                 Strips& strips) noexcept;

}  // namespace wrc::patch
