/// The height at which a wheel carries the load given, and the wrench there.
#pragma once

#include "surface/wrench/wheel_work.hpp"

namespace wrc {

/// How far below first touch a wheel carries a load [m], [N]: about the middle of what random poses of
/// several pairs of profiles take.
double usual_approach(double load);

/// The wrench at the height that carries the load given, searched from `height`, which becomes it.
///
/// Where friction on a steep face can outweigh its slope, the vertical force may fall as the wheel goes down,
/// and the load be carried at no height or at several. Then the way down from first touch is looked at, so
/// that it does not matter where the search begins: taken is the highest that carries the load with a force
/// that grows downwards, and where none does, the first at which the force ceases to grow: the end of the
/// branch that begins at first touch, in which the former goes over without a jump as the load grows.
Fault solve_given_load(const SurfaceModel& model, const WheelOnRail& in, WheelWork& w, PressureStart& start,
                       double& height, Wrench& out);

}  // namespace wrc
