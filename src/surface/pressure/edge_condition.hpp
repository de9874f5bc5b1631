/// The edge condition: pressure ends where the surfaces part. Over a half length the displacement falls as
/// the overlap does, by kappa/2 l^2, which sets the peak per length lambda; a difference between the two
/// edges sets the shift of the centre. Both are smoothed over neighbouring strips (smoothing.hpp).
#pragma once

#include "surface/pressure/pressure_scratch.hpp"

namespace wrc::surface {

/// From the loads of solve_contact(): q of the strips, and in w.residual the moves that the fixed-point map
/// asks for, q / lambda - L and (smoothed shift) - shift.
void edge_residual(const PressureProblem& problem, const StripSet& s, PressureScratch& w);

}  // namespace wrc::surface
