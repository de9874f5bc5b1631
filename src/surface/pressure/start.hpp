/// Lengths and shifts that a pressure solve starts from.
#pragma once

#include "surface/pressure/iteration.hpp"

namespace wrc::surface {

/// Start from the overlaps w.fine has, into its L and shift: of a solution on pairs of strips, which is half
/// the resolution and a quarter of the work per iteration. On a rail that changes along the track, where
/// at most most_by_hills overlap, by Hertz's theory of their hills. Returns the iterations spent, at most
/// `most`.
std::int32_t start_from_overlaps(const PressureProblem& problem, const Overlaps& overlaps, double max_work,
                                 PressureScratch& w, std::int32_t most = usual_iterations);

/// Extrapolates an earlier solution by a share of the change that led to it: the overlaps' growth since,
/// projected on their growth in that change. follow_overlaps() takes the rest of their growth.
void extrapolate_start(const RailStrips& rail, const Overlaps& overlaps, PressureStart& start);

/// Moves the lengths of an earlier solution in w.fine as its overlaps have moved from w.depth_before. Returns
/// whether that moved at most the part `farthest` of the area.
bool follow_overlaps(double farthest, PressureScratch& w);

}  // namespace wrc::surface
