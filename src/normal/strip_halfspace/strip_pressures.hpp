/// The first half of an iteration of the half-space solver (strip_halfspace.hpp): pressures for given
/// lengths.
#pragma once

#include "normal/elasticity/influence_tables.hpp"
#include "normal/problem.hpp"
#include "normal/strip_halfspace/strip_system.hpp"

namespace wrc::normal {

/// Extent of the search for strips that overlap: a patch grows at its borders; other regions appear rarely,
/// and are looked for when iterations begin and when they are about to end.
enum class Search { everywhere, beside_contact };

/// Pressures of the active strips, from the contact condition at their middles, for the present lengths;
/// returns the approach [m], and in `stiffness` the growth of the load with it at these lengths [N/m]. Strips
/// that pull leave and strips that overlap enter, a few times at most: the next iteration settles
/// the rest.
double solve_pressures(const NormalProblem& problem, const InfluenceTables& influence, Search search,
                       StripSystem& s, double& stiffness) noexcept;

/// True if the bodies would overlap at the lowest strip of a spot that is not in contact, with the pressures
/// last solved.
bool overlap_elsewhere(const NormalProblem& problem, const InfluenceTables& influence, double approach,
                       const StripSystem& s) noexcept;

}  // namespace wrc::normal
