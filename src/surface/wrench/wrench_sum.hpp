/// The wrench of strips in contact: sums over them, region by region, turned into track axes.
#pragma once

#include "surface/wrench/wheel_work.hpp"

namespace wrc {

/// Back into track axes.
void into_track(const RelativeMotion& s, double (&v)[3]);

/// Frictional power of the k-th strip in contact [W].
double power_of(const WheelWork& w, std::int32_t k, double speed);

/// The wrench: sums over the strips in contact, region by region. A region is strips side by side; the last
/// of those listed takes what follows.
Fault sum_up(const WheelOnRail& in, const RelativeMotion& seen, std::int32_t count, double speed,
             const WheelWork& w, Wrench& out);

}  // namespace wrc
