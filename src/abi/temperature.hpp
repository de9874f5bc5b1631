/// Temperatures across the boundary.
#pragma once

#include <cmath>

#include "abi/structs.hpp"
#include "contact/assessments.hpp"
#include "wrc/wrc_damage.h"

namespace wrc::abi {

/// sqrt(lambda rho c) of numbers that have been checked [W s^(1/2) / (m^2 K)].
inline double effusivity_of(const wrc_heat_properties& checked) {
  return std::sqrt(checked.conductivity * checked.density * checked.specific_heat);
}

inline wrc_temperature temperature_of(const contact::TemperatureNumbers& numbers) {
  wrc_temperature ours = empty<wrc_temperature>();
  ours.at_entry = numbers.at_entry;
  ours.rise = numbers.rise;
  ours.x = numbers.x;
  ours.y = numbers.y;
  ours.largest = numbers.at_entry + numbers.rise;
  ours.mean_rise = numbers.mean_rise;
  ours.wheel_heat = numbers.wheel_heat;
  ours.rail_heat = numbers.rail_heat;
  return ours;
}

}  // namespace wrc::abi
