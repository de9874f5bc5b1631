/// Several patches in one set of strips.
#pragma once

#include <cmath>
#include <cstdint>

#include "patch/strips.hpp"

namespace wrc::patch {

/// Strips j and j + 1 belong to one patch if they share a border; between patches there is a gap in y.
/// Returns the index one past the last strip of the patch that strip `first` opens.
inline std::int32_t patch_end(const Strips& strips, std::int32_t first) noexcept {
  std::int32_t j = first + 1;
  while (j < strips.count) {
    // Distance of the middles of strips that share a border [m].
    const double reach = 0.5 * (strips.width[j - 1] + strips.width[j]);
    if (std::abs(strips.y[j] - strips.y[j - 1] - reach) > 1e-6 * reach) break;
    ++j;
  }
  return j;
}

/// Strips first .. end - 1 as a set of their own, in the same memory.
inline Strips slice(const Strips& strips, std::int32_t first, std::int32_t end) noexcept {
  return {end - first,          end - first,           strips.y + first,
          strips.width + first, strips.centre + first, strips.half_length + first,
          strips.peak + first};
}

}  // namespace wrc::patch
