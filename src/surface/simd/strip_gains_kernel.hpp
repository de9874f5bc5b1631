/// The most that overlaps of strips grow along a rail that varies, one strip per lane
/// (surface/geometry/strip_gain.hpp).
#pragma once

#include "surface/geometry/strip_gain.hpp"
#include "surface/simd/strips_in_sections.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// SurfaceKernels::strip_gains.
inline void strip_gains_kernel(const StripGainsTask& task, surface::StripGains& gains) {
  const surface::PlacedRail& placed = *task.placed;
  // growth is counted from below the axle, or from the nearer end of a face that is not there
  const double low = placed.low[task.face], high = placed.high[task.face];
  const double nearest = wrc::smaller(wrc::larger(0.0, low), high);
  for (std::int32_t base = 0; base < gains.count; base += lanes) {
    const std::int32_t count = gains.count - base < lanes ? gains.count - base : lanes;
    std::int32_t strip[lanes];
    for (std::int32_t i = 0; i < lanes; ++i) strip[i] = gains.strip[base + (i < count ? i : count - 1)];
    StripsInSections sections{*task.rail, strip};
    const surface::StripBelowAxle<Pack> below{sections.read(placed.y), sections.read(placed.z),
                                              sections.read(placed.ty), sections.read(placed.tz)};
    Pack most = nearest == 0.0 ? 0.0 : -1e300, at = nearest;
    const auto look = [&](const surface::PlaceWeights& place) {
      sections.go_to(place);
      const Pack here = surface::gain_at<Pack>(below, place.x, sections.at(place, 0), sections.at(place, 1),
                                               task.wheel_radius);
      const Mask more = here > most;
      most = select(more, here, most);
      at = select(more, place.x, at);
    };
    for (const surface::PlaceWeights& place : placed.place[task.face])
      if (place.x >= low && place.x <= high) look(place);
    for (const surface::PlaceWeights& place : placed.end[task.face])
      if (wrc::magnitude(place.x) < surface::farthest_along) look(place);
    store(most, gains.gain + base, count);
    store(at, gains.at + base, count);
  }
}

}  // namespace
}  // namespace wrc::simd
