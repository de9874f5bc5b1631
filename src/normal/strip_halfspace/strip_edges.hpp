/// The second half of an iteration of the half-space solver (strip_halfspace.hpp): lengths for given
/// pressures.
#pragma once

#include "normal/elasticity/influence_tables.hpp"
#include "normal/problem.hpp"
#include "normal/strip_halfspace/strip_system.hpp"

namespace wrc::normal {

/// Moves lengths and centres towards the edge conditions; returns the part of the area that moved [-].
///
/// In a long contact the centre condition fixes q = (pi/2) p l, and l^2 = 4 c q / curvature: the
/// displacement drop from centre to edge therefore asks for a p / l that is smaller by
/// drop / (curvature l^2 / 2), at constant q. A single thin strip hardly feels its own length, only that of
/// its neighbourhood: a sawtooth of lengths meets every condition. p / l is smooth along y, also at the ends
/// of a patch where p and l vanish together, so it is p / l that is averaged over three strips.
double move_edges(const NormalProblem& problem, const InfluenceTables& influence, double approach,
                  StripSystem& s) noexcept;

/// Fits the outermost strips of every patch of three or more to its border, where l^2, linear through the
/// last two strips, vanishes. The outermost strip may stretch to one and a half of its cell: beyond, the next
/// one is in contact. Without it a strip the border runs through counts as wholly in contact, and area jumps
/// by cells.
void fit_ends(const patch::GapRows& rows, double lowest_height, StripSystem& s) noexcept;

}  // namespace wrc::normal
