/// Derivatives of tractions by differences of their solution, where they have no chain rule: under friction
/// over temperature, and of strips that remember.
#pragma once

#include "surface/wrench/differentiation.hpp"

namespace wrc::surface {

/// Cuts the arrays for so many strips of work_sizes().
DifferencesScratch cut_differences(Arena& arena, const WorkSizes& sizes);

/// Tractions under friction over temperature, by one difference of their solution along the change of the
/// strips with each input. `speed`: that by which slips were divided [m/s].
void differentiate_heated(const Differentiation& d, const RailFrameDual& speed, bool backwards,
                          const DualForces& forces);

/// Tractions of strips that remember, by one difference of their step along the change of the strips with
/// each input, and along the time into the scratch. `divisor`: that by which slips were divided [m/s].
void differentiate_remembered(const Differentiation& d, const RailFrameDual& rolling_speed,
                              const RailFrameDual& divisor, const DualForces& forces);

}  // namespace wrc::surface
