/// What a wrench is differentiated by, where a caller writes it.
#pragma once

#include <cstdint>

#include "wrc/wrc.h"

/// The number of a column of wrc_wrench_derivatives, but for that of the load.
inline double& wrench_input(wrc_wheel_input& input, std::int32_t column) {
  wrc_wheel_state& wheel = input.wheel;
  wrc_rail_state& rail = input.rail;
  double* const numbers[WRC_BY_VERTICAL_LOAD] = {&wheel.y,
                                                 &wheel.z,
                                                 &wheel.roll,
                                                 &wheel.yaw,
                                                 &wheel.velocity[0],
                                                 &wheel.velocity[1],
                                                 &wheel.velocity[2],
                                                 &wheel.angular_velocity[0],
                                                 &wheel.angular_velocity[1],
                                                 &wheel.angular_velocity[2],
                                                 &rail.y,
                                                 &rail.z,
                                                 &rail.roll,
                                                 &rail.y_velocity,
                                                 &rail.z_velocity,
                                                 &rail.roll_rate};
  return *numbers[column];
}
