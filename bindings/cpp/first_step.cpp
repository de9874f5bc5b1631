// The smallest complete use of wrc from C++17: a wheelset, S1002 on 60E1, 80 kN on each wheel. First the
// height at which it stands, then the wrench on both wheels while it rolls with a yaw of 2 mrad.
//
//   c++ -std=c++17 first_step.cpp -lwrc -o first_step && ./first_step
#include <cstdio>

#include "wrc/wrc.hpp"

int main() try {
  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_60E1;
  config.track.rail_inclination = 1.0 / 40.0;
  const wrc::model model(config);  // serves both sides
  wrc::contact wheels[] = {wrc::contact(model, WRC_SIDE_RIGHT), wrc::contact(model, WRC_SIDE_LEFT)};

  wrc_wheel_input input = wrc_wheel_input_default();
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 80e3;  // N
  const double standing = wheels[0].wrench(input).z;
  std::printf("stands %.1f um below its nominal height\n", 1e6 * standing);

  const double speed = 20.0;  // m/s
  input.prescribed = WRC_PRESCRIBE_HEIGHT;
  input.vertical_load = 0.0;
  input.wheel.z = standing;  // m
  input.wheel.yaw = 2e-3;    // rad
  input.wheel.velocity[0] = speed;
  input.wheel.pitch_rate = -speed / config.wheelset.wheel_radius;  // rad/s, about the axle
  double force[3] = {}, moment[3] = {};
  for (int side = 0; side < 2; ++side) {
    const auto wrench = wheels[side].wrench(input);  // allocates nothing
    std::printf(
        "%-6s Fx %6.0f N, Fy %6.0f N, Fz %6.0f N, peak pressure %.0f MPa, frictional power %.0f W, %s\n",
        side == WRC_SIDE_RIGHT ? "right" : "left", wrench.force[0], wrench.force[1], wrench.force[2],
        1e-6 * wrench.peak_pressure, wrench.power, wrench.flag.name());
    for (int i = 0; i < 3; ++i) {
      force[i] += wrench.force[i];
      moment[i] += wrench.moment[i];
    }
  }
  std::printf("both   Fx %6.0f N, Fy %6.0f N, Fz %6.0f N, moment about z %.0f N m\n", force[0], force[1],
              force[2], moment[2]);
} catch (const wrc::error& error) {
  std::fprintf(stderr, "%s: %s\n", error.why().name(), error.what());
  return 1;
}
