// The smallest complete use of wrc from C++17: S1002 wheel on a UIC60 rail, 80 kN, a little creepage.
//
//   c++ -std=c++17 first_step.cpp -lwrc -o first_step && ./first_step
#include <cstdio>

#include "wrc/wrc.hpp"

int main() try {
  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  const wrc::model model(config);
  wrc::contact contact(model, WRC_SIDE_RIGHT);

  wrc_planar_input input = wrc_planar_input_default();
  input.load.normal_force = 80e3;  // N
  input.creepage.longitudinal = 0.5e-3;
  input.creepage.speed = 40.0;  // m/s
  input.friction.coefficient = 0.35;
  const auto output = contact.step(input);  // allocates nothing
  std::printf("patch   %.1f x %.1f mm, approach %.1f um, peak pressure %.0f MPa\n",
              1e3 * output.normal.length, 1e3 * output.normal.width, 1e6 * output.normal.approach,
              1e-6 * output.normal.peak_pressure);
  std::printf("forces  Fx %.0f N, Fy %.0f N, Mz %.1f N m, frictional power %.0f W\n", output.forces.fx,
              output.forces.fy, output.forces.mz, output.forces.power);
} catch (const wrc::error& error) {
  std::fprintf(stderr, "%s: %s\n", error.why().name(), error.what());
  return 1;
}
