/// The most that overlaps of strips grow along a rail that varies, one strip per lane
/// (surface/geometry/strip_gain.hpp).
#pragma once

#include "base/pack.hpp"
#include "surface/geometry/strip_gain.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// Middles of the strips of all lanes in two sections, and their slopes along the track: read anew where a
/// place lies between others.
struct StripsInSections {
  const surface::VaryingRail& rail;
  const std::int32_t* strip;
  std::int32_t left = -1, right = -1;
  Pack list[2][4] = {};  ///< y and z, each in the order of PlaceWeights::weight

  Pack read(const double* of) const {
    double each[lanes];
    for (std::int32_t i = 0; i < lanes; ++i) each[i] = of[strip[i]];
    return load_pack(each);
  }
  void go_to(const surface::PlaceWeights& place) {
    if (place.left == left && place.right == right) return;
    left = place.left;
    right = place.right;
    for (std::int32_t k = 0; k < 4; ++k) {
      const std::int64_t section = k % 2 == 0 ? left : right, slope = k < 2 ? 0 : 4;
      for (std::int32_t q = 0; q < 2; ++q)
        list[q][k] = read(rail.outline + (section * 8 + slope + q) * rail.stride);
    }
  }
  Pack at(const surface::PlaceWeights& place, std::int32_t q) const {
    return place.weight[0] * list[q][0] + place.weight[1] * list[q][1] + place.weight[2] * list[q][2] +
           place.weight[3] * list[q][3];
  }
};

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
