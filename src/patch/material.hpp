/// Elastic constants of the pair of bodies, as the half-space theory needs them.
#pragma once

#include "base/elementary.hpp"

namespace wrc {

/// Two bodies of the same material (quasi-identical: normal and tangential problems do not couple).
struct Material {
  double shear_modulus = 0.0;  ///< G [Pa]
  double poisson = 0.0;        ///< nu [-], 0..0.5

  /// Normal compliance of the PAIR: u_z(x) = normal_compliance * IInt p / r dA, i.e. (1 - nu) / (pi G)
  /// [1/Pa].
  double normal_compliance() const { return (1.0 - poisson) / (pi * shear_modulus); }
};

}  // namespace wrc
