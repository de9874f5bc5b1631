/// The wrench of strips in contact: sums over them, region by region, turned into track axes.
#pragma once

#include "surface/wrench/wheel_solution.hpp"

namespace wrc::surface {

/// Sums the strips in contact up: fills the wrench and its regions but for height and iterations. A region is
/// strips side by side; the last of those listed takes all that follow.
Fault sum_regions(const WheelOnRail& in, const WheelSolution& solution, Wrench& out);

}  // namespace wrc::surface
