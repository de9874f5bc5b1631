/// An optional damping law for the normal force.
///
/// Steel on steel dissipates next to nothing normally; a simulation adds damping so that impacts (flange
/// strikes, wheel flats) settle. Hunt and Crossley's form grows with the elastic force, so that it vanishes
/// with it: no jump when contact is made, no pull when it is lost.
///
/// Hunt, Crossley, Journal of Applied Mechanics 42 (1975) 440-445.
#pragma once

#include <algorithm>

namespace wrc::normal {

/// Factor to the elastic force of any normal method, its pressure and its stiffness:
/// 1 + (3/2) alpha d(approach)/dt, never below zero [-]. `approach_rate` positive while the bodies near each
/// other [m/s], `alpha` >= 0 [s/m]: for small alpha v the coefficient of restitution at the impact speed v is
/// 1 - alpha v.
inline double damping_factor(double approach_rate, double alpha) noexcept {
  return std::max(0.0, 1.0 + 1.5 * alpha * approach_rate);
}

}  // namespace wrc::normal
