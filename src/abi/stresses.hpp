/// Largest stresses on their way out.
#pragma once

#include <cstdint>

#include "damage/stress.hpp"
#include "wrc/wrc_damage.h"

namespace wrc::abi {

inline wrc_stress_peaks peaks_of(const StressPeaks& found) {
  const auto one = [](const StressPeak& peak) { return wrc_stress_peak{peak.value, peak.x, peak.y, peak.z, {}}; };
  return {one(found.von_mises), one(found.shear), one(found.tension), {}};
}

/// `body`: enum wrc_body.
inline void fill(const StressPeaks& surface, const StressPeaks& below, std::int32_t body,
                 wrc_stresses& result) {
  StressPeaks largest = surface;
  largest.take(below);
  result.body = body;
  result.largest = peaks_of(largest);
  result.surface = peaks_of(surface);
  result.below = peaks_of(below);
}

}  // namespace wrc::abi
