/// Largest stresses on their way out.
#pragma once

#include <cstdint>

#include "base/fault.hpp"
#include "damage/stress.hpp"
#include "wrc/wrc_damage.h"

namespace wrc::abi {

/// Most depths of one call.
inline constexpr double most_stress_depths = 64.0;

/// A body, and depths in order; `count` of them.
Fault check_stress_depths(std::int32_t body, const double* depths, std::uint32_t count);

inline wrc_stress_peaks peaks_of(const damage::StressPeaks& found) {
  const auto one = [](const damage::StressPeak& peak) {
    return wrc_stress_peak{peak.value, peak.x, peak.y, peak.z, {}};
  };
  return {one(found.von_mises), one(found.shear), one(found.tension), {}};
}

/// `body`: enum wrc_body.
inline void fill(const damage::StressPeaks& surface, const damage::StressPeaks& below, std::int32_t body,
                 wrc_stresses& result) {
  damage::StressPeaks largest = surface;
  largest.take(below);
  result.body = body;
  result.largest = peaks_of(largest);
  result.surface = peaks_of(surface);
  result.below = peaks_of(below);
}

}  // namespace wrc::abi
