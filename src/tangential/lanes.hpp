/// Strips are marched in groups, so that a group's state stays in registers and a compiler (or a later build
/// for wider vectors) works on several strips at once. Sums run per strip, then over the strips in order:
/// their bits do not depend on the grouping.
#pragma once

#include <algorithm>
#include <cstdint>

namespace wrc {

inline constexpr std::int32_t lanes = 8;

/// One value per strip of a group.
template <class T>
struct Lane {
  T values[lanes] = {};

  T& operator[](std::int32_t k) { return values[k]; }
  const T& operator[](std::int32_t k) const { return values[k]; }
  const T* data() const { return values; }
  void fill(const T& value) { std::fill_n(values, lanes, value); }
};

}  // namespace wrc
