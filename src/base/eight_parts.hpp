/// Sums along the lanes, with the same bits whatever the width of a vector. Included by src/*/simd only, as
/// pack.hpp.
#pragma once

#include "base/pack.hpp"

namespace wrc::simd {
namespace {

/// A sum in eight parts, of which those half of them apart are added up, again and again.
struct EightParts {
  static constexpr std::int32_t parts = 8, vectors = parts / native_lanes;
  Native of[vectors];

  double sum() {
    // halves of the vectors, then of the lanes of the one that is left
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

/// Some elements of an array for each vector, all of them or fewer: the others are `rest`, and not written.
struct WholeVector {
  static Native load(const double* from, Native) { return load_lanes(from); }
  static void store(double* to, Native a) { store_lanes(to, a); }
};
struct PartOfVector {
  std::int32_t count;
  Native load(const double* from, Native rest) const { return load_first(count, from, rest); }
  void store(double* to, Native a) const { store_first(count, to, a); }
};

/// Calls take(vector of the eight parts, first element, elements) for vectors of `count` elements.
template <class Take>
void for_eight_parts(std::int32_t count, const Take& take) {
  // whole groups, whose part is known at compile time, then the rest
  std::int32_t first = 0;
  for (; first + EightParts::parts <= count; first += EightParts::parts)
    for (std::int32_t k = 0; k < EightParts::vectors; ++k) take(k, first + k * native_lanes, WholeVector{});
  for (std::int32_t k = 0; k < EightParts::vectors; ++k) {
    const std::int32_t at = first + k * native_lanes;
    if (at < count) take(k, at, PartOfVector{count - at});
  }
}

}  // namespace
}  // namespace wrc::simd
