/// The height at which a wheel carries the load given, and the wrench there.
#pragma once

#include "surface/wrench/at_height.hpp"

namespace wrc::surface {

/// Approach at which a wheel usually carries a load [m], [N]: the middle of random poses of several pairs of
/// profiles.
double usual_approach(double load);

/// Height at which the load given is expected [m], without an earlier solution: the usual approach below
/// first touch, along the track where hills of overlaps carry it by Hertz's theory.
double first_height(const HeightSolver& solver);

/// Height at which the load given is expected [m]: from that of the solution that the solver starts from, as
/// far as its overlaps have grown since, and its load [N] is another. Along the track by hills of overlaps.
double predicted_height(const HeightSolver& solver, double height, double load);

/// The wrench at the height that carries the load given, searched from `guess` [m].
///
/// Where friction on a steep face can outweigh its slope, the vertical force may fall as the wheel goes down,
/// and the load be carried at no height or at several. Then the descent from first touch is sampled, so that
/// it does not matter where the search begins: taken is the highest that carries the load with a force that
/// grows downwards, and where none does, the first at which the force ceases to grow: the end of the branch
/// that begins at first touch, in which the former goes over without a jump as the load grows.
Fault solve_given_load(const HeightSolver& solver, double guess);

}  // namespace wrc::surface
