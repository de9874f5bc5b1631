/// Strips of a rail that varies, one per lane, at places along the track (surface/geometry/varying_rail.hpp).
#pragma once

#include "base/pack.hpp"
#include "surface/geometry/varying_rail.hpp"

namespace wrc::simd {
namespace {

/// Middles of the strips of all lanes in two sections, and their slopes along the track: read anew where a
/// place lies between others.
struct StripsInSections {
  const surface::VaryingRail& rail;
  const std::int32_t* strip;
  bool in_a_row = true;
  std::int32_t left = -1, right = -1;
  Pack list[2][4] = {};  ///< y and z, each in the order of PlaceWeights::weight

  StripsInSections(const surface::VaryingRail& of, const std::int32_t* strips) : rail(of), strip(strips) {
    for (std::int32_t i = 1; i < lanes; ++i) in_a_row = in_a_row && strip[i] == strip[0] + i;
  }

  /// Numbers of the strips in a list of the rail's; neighbours are read in a row, others one by one.
  Pack read(const double* of) const {
    if (in_a_row) return load_pack(of + strip[0]);
    double each[lanes];
    for (std::int32_t i = 0; i < lanes; ++i) each[i] = of[strip[i]];
    return load_pack(each);
  }
  /// Returns whether the sections are others than those of the place before.
  bool go_to(const surface::PlaceWeights& place) {
    if (place.left == left && place.right == right) return false;
    left = place.left;
    right = place.right;
    for (std::int32_t k = 0; k < 4; ++k) {
      const std::int64_t section = k % 2 == 0 ? left : right, slope = k < 2 ? 0 : 4;
      for (std::int32_t q = 0; q < 2; ++q)
        list[q][k] = read(rail.outline + (section * 8 + slope + q) * rail.stride);
    }
    return true;
  }
  Pack at(const surface::PlaceWeights& place, std::int32_t q) const {
    return place.weight[0] * list[q][0] + place.weight[1] * list[q][1] + place.weight[2] * list[q][2] +
           place.weight[3] * list[q][3];
  }
};

}  // namespace
}  // namespace wrc::simd
