/// What a wrench is differentiated by, where a caller writes it.
#pragma once

#include <cstdint>

#include "wrc/wrc.h"

/// The number of a column of wrc_wrench_derivatives, but for those of the load and of friction, which
/// scales.
inline double& wrench_input(wrc_wheel_input& input, std::int32_t column) {
  wrc_wheel_state& wheel = input.wheel;
  wrc_rail_state& rail = input.rail;
  const bool by_rates = wheel.angular_axes == WRC_AXES_NONE;
  double* const numbers[WRC_BY_FRICTION] = {&wheel.y,
                                            &wheel.z,
                                            &wheel.roll,
                                            &wheel.yaw,
                                            &wheel.velocity[0],
                                            &wheel.velocity[1],
                                            &wheel.velocity[2],
                                            by_rates ? &wheel.roll_rate : &wheel.angular_velocity[0],
                                            by_rates ? &wheel.pitch_rate : &wheel.angular_velocity[1],
                                            by_rates ? &wheel.yaw_rate : &wheel.angular_velocity[2],
                                            &rail.y,
                                            &rail.z,
                                            &rail.roll,
                                            &rail.y_velocity,
                                            &rail.z_velocity,
                                            &rail.roll_rate,
                                            &input.vertical_load,
                                            &input.distance,
                                            &input.angle,
                                            &rail.y_slope,
                                            &rail.z_slope,
                                            &input.roller_rate};
  return *numbers[column];
}
