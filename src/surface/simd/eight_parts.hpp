/// Sums along the lanes.
#pragma once

#include "base/pack.hpp"

namespace wrc::simd {
namespace {

/// A sum over strips in eight parts, whatever the width of a vector.
struct EightParts {
  static constexpr std::int32_t vectors = 8 / native_lanes;
  Native of[vectors];

  /// Halves are added until one number is left.
  double sum() {
    for (std::int32_t half = vectors / 2; half > 0; half /= 2)
      for (std::int32_t k = 0; k < half; ++k) of[k] = of[k] + of[k + half];
    double part[native_lanes];
    store_lanes(part, of[0]);
    for (std::int32_t half = native_lanes / 2; half > 0; half /= 2)
      for (std::int32_t k = 0; k < half; ++k) part[k] += part[k + half];
    return part[0];
  }
};

inline EightParts no_parts() {
  EightParts none;
  for (Native& part : none.of) part = broadcast(0.0);
  return none;
}

}  // namespace
}  // namespace wrc::simd
