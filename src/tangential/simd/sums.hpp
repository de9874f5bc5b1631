/// Results of a method from the sums of a kernel.
#pragma once

#include "tangential/simd/tasks.hpp"

namespace wrc {

inline tangential::TangentialForces forces_of(const simd::Sums& sums) {
  return {sums.fx, sums.fy, sums.mz, sums.power_per_speed,
          sums.area > 0.0 ? 1.0 - sums.slid_area / sums.area : 0.0};
}

/// The forces are homogeneous of degree one in creepages and friction together, and load and friction act
/// through their product: three derivatives give five.
inline tangential::TangentialSensitivities sensitivities_of(const simd::Sums& sums,
                                                            const tangential::Creepage& c, double friction,
                                                            double load) {
  const double forces[3] = {sums.fx, sums.fy, sums.mz};
  tangential::TangentialSensitivities s;
  for (int r = 0; r < 3; ++r) {
    // Euler: F = nu_x dF/dnu_x + nu_y dF/dnu_y + phi dF/dphi + mu dF/dmu, and mu dF/dmu = N dF/dN
    const double* d = sums.d[r];
    const double by_creepages = d[0] * c.longitudinal + d[1] * c.lateral + d[2] * c.spin;
    const double by_friction = forces[r] - by_creepages;  // times friction
    s.d[r][0] = d[0];
    s.d[r][1] = d[1];
    s.d[r][2] = d[2];
    s.d[r][3] = load > 0.0 ? by_friction / load : 0.0;
    s.d[r][4] = friction > 0.0 ? by_friction / friction : 0.0;
  }
  return s;
}

}  // namespace wrc
