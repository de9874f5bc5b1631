/// Temperatures across the boundary.
#pragma once

#include <cmath>

#include "wrc/wrc.h"

namespace wrc::abi {

/// sqrt(lambda rho c) of numbers that have been checked [W s^(1/2) / (m^2 K)].
inline double effusivity_of(const wrc_heat_properties& checked) {
  return std::sqrt(checked.conductivity * checked.density * checked.specific_heat);
}

}  // namespace wrc::abi
