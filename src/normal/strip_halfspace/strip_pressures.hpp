/// The first half of a sweep of the half-space solver (strip_halfspace.hpp): pressures for given lengths.
#pragma once

#include "normal/elasticity/influence_tables.hpp"
#include "normal/problem.hpp"
#include "normal/strip_halfspace/strip_system.hpp"

namespace wrc {

/// Where strips are looked for that overlap: a patch grows at its borders, other regions appear rarely.
enum class Search { everywhere, beside_contact };

/// Pressures of the active strips, from the contact condition at their middles, for the present lengths;
/// returns the approach [m], and in `stiffness` the growth of the load with it at these lengths [N/m]. Strips
/// that pull leave and strips that overlap enter, a few times at most: what is left over is settled in the
/// next sweep.
double solve_pressures(const NormalProblem& problem, const InfluenceTables& influence, Search search,
                       StripSystem& s, double& stiffness) noexcept;

}  // namespace wrc
