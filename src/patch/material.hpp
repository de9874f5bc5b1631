/// Elastic constants of the pair of bodies, as the half-space theory needs them.
#pragma once

#include "base/elementary.hpp"

namespace wrc::patch {

/// Two bodies as if of one material (quasi-identical: normal and tangential problems do not couple).
struct Material {
  double shear_modulus = 0.0;  ///< G [Pa]
  double poisson = 0.0;        ///< nu [-], 0..0.5

  /// Normal compliance of the PAIR: u_z(x) = normal_compliance * IInt p / r dA, i.e. (1 - nu) / (pi G)
  /// [1/Pa].
  double normal_compliance() const { return (1.0 - poisson) / (pi * shear_modulus); }
};

/// Combined constants: 1/G and nu/G are the means of the bodies'.
inline Material combined(const Material& wheel, const Material& rail) {
  const double inverse = 0.5 * (1.0 / wheel.shear_modulus + 1.0 / rail.shear_modulus);
  const double poisson =
      0.5 * (wheel.poisson / wheel.shear_modulus + rail.poisson / rail.shear_modulus) / inverse;
  return {1.0 / inverse, poisson};
}

/// Kalker's K, by which normal and tangential problem of two bodies couple: 0 of equal ones, within 0.5 [-].
inline double coupling(const Material& wheel, const Material& rail) {
  return 0.25 * combined(wheel, rail).shear_modulus *
         ((1.0 - 2.0 * wheel.poisson) / wheel.shear_modulus -
          (1.0 - 2.0 * rail.poisson) / rail.shear_modulus);
}

}  // namespace wrc::patch
