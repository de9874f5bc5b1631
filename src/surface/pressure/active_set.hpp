/// The contact condition at given lengths and centres: which strips press, and how much.
///
///     sum_b M_ab q_b = d_a - kappa_a/2 shift_a^2    strips in contact, q_a >= 0
///     sum_b M_ib q_b >= the same of strip i         all others
///
/// Strips that would pull are deactivated, those that would overlap are activated, until neither happens.
#pragma once

#include "surface/pressure/pressure_scratch.hpp"

namespace wrc::surface {

/// Strips outside contact that are asked whether they enter: none, those next to contact, or all.
enum class Asked { none, beside, all };

/// Solves the contact condition; starts from w.in_contact, leaves the strips in contact in w.active and their
/// line loads in w.solution. No strip is active where none overlaps.
void solve_contact(const PressureProblem& problem, const StripSet& s, Asked asked, PressureScratch& w);

/// Activates strips that would overlap under the loads in w.solution. Returns whether there are any. The
/// others that were asked get a negative L, which goes on steadily where they enter: w.continued.
bool activate(const PressureProblem& problem, const StripSet& s, Asked asked, PressureScratch& w);

/// The active strips, or some of them, for kernels.
simd::SurfaceSources sources_of(const ActiveStrips& active);
simd::SurfaceSources sources_of(const ActiveStrips& active, std::int32_t first, std::int32_t count);
simd::SurfaceFaces faces_of(const ActiveStrips& active);

}  // namespace wrc::surface
