/// Coefficients of friction of the strips of a patch.
#pragma once

#include <cstdint>

namespace wrc::tangential {

/// Result of the friction law (friction.hpp): the mean over the load, of which Coulomb's limit of the whole
/// patch is made, and each strip's share of it. One number serves as friction everywhere.
struct StripFriction {
  double mean = 0.0;               ///< sum of mu_j N_j over N [-]
  const double* shares = nullptr;  ///< mu_j / mean of every strip; nullptr: 1

  StripFriction() = default;
  StripFriction(double everywhere, const double* strip_shares = nullptr)  // NOLINT: a number is a friction
      : mean(everywhere), shares(strip_shares) {}

  double share(std::int32_t j) const { return shares ? shares[j] : 1.0; }
  double operator[](std::int32_t j) const { return mean * share(j); }
};

}  // namespace wrc::tangential
