/// Lobes of a quantity over strips side by side, and how far they stand for themselves.
///
/// Methods that know patches only need to have them told apart: two humps with a valley between them are two
/// patches where the valley is deep and one where it is shallow. Here a run of strips is both at once, in
/// shares that go over smoothly as the valley fills: with r the quantity in the valley over that on the
/// higher hump beside it, the share of the joint patch is
///
///     w = t^2 (3 - 2 t),   t = (r - parted) / (united - parted) within 0 .. 1.
///
/// Runs that meet, or part, do so at r = 0, where they are two patches on either side of the event.
#pragma once

#include <array>
#include <cstdint>

namespace wrc::surface {

/// A valley.
struct LobeCut {
  double place = 0.0;   ///< where the quantity is least [m]
  double value = 0.0;   ///< the quantity there
  double joined = 0.0;  ///< w; 1: not a border
};

/// The valleys of a run with w < 1, by increasing place.
struct LobeCuts {
  static constexpr std::int32_t capacity = 7;
  std::array<LobeCut, capacity> of{};
  std::int32_t count = 0;
  bool more = false;  ///< there are more, which are not counted as borders
};

/// Valley over the higher hump below which two humps are apart, and above which they are one.
struct LobeLimits {
  double parted = 0.5, united = 0.9;
  /// A shoulder by the lowest strip, not by the parabola through it: then it comes into being without a jump.
  bool by_strip = false;
};

/// Finds the valleys of `value` over the strips `first` .. `end` - 1, whose middles lie at `place`.
LobeCuts find_lobes(const double* place, const double* value, std::int32_t first, std::int32_t end,
                    const LobeLimits& limits = {}) noexcept;

/// Calls take(share, low, high) for every part of the run with a share: strips between the cuts low and high,
/// nullptr where the run itself ends. The shares of the parts a strip belongs to add up to 1.
template <class Take>
void for_each_part(const LobeCuts& cuts, Take&& take) {
  const auto cut = [&](std::int32_t i) {
    return i == 0 || i > cuts.count ? nullptr : &cuts.of[static_cast<std::size_t>(i) - 1];
  };
  // A part from cut a to cut b: both are borders, and all between them are joined.
  for (std::int32_t a = 0; a <= cuts.count; ++a) {
    double share = cut(a) ? 1.0 - cut(a)->joined : 1.0;
    for (std::int32_t b = a + 1; b <= cuts.count + 1 && share > 0.0; ++b) {
      const double joined = cut(b) ? cut(b)->joined : 0.0;
      if (joined < 1.0) take(share * (1.0 - joined), cut(a), cut(b));
      share *= joined;
    }
  }
}

}  // namespace wrc::surface
