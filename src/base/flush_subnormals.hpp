/// Numbers whose products would be subnormal, taken for zero.
#pragma once

#include <cmath>

namespace wrc {

/// A number of the host's, or zero where it is so small that it moves nothing but its products would be
/// subnormal: some processors need a hundred cycles for each of those. Hosts do pass such numbers: signals
/// that fade out exponentially.
inline double flush_subnormals(double number) noexcept { return std::fabs(number) < 1e-100 ? 0.0 : number; }

}  // namespace wrc
