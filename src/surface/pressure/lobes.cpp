#include "surface/pressure/lobes.hpp"

#include "base/number.hpp"

namespace wrc::surface {
namespace {

constexpr double hardly_a_hump = 0.9;  // valley over the lower hump above which this is only a shoulder

/// Largest value next to strip j in one direction before it falls below that of j: the hump on that side of
/// the valley.
double hump(const double* value, std::int32_t j, std::int32_t end, std::int32_t step) {
  double most = value[j];
  for (std::int32_t k = j + step; k != end && value[k] >= value[j]; k += step) most = larger(most, value[k]);
  return most;
}

/// The lowest point of the parabola through three strips. As one strip hands over to the next it lies midway
/// between the two.
void place_cut(const double* place, const double* value, std::int32_t j, LobeCut& cut) {
  // Newton's form through j - 1, j, j + 1: slopes of both intervals, and their difference over the distance.
  const double before = (value[j] - value[j - 1]) / (place[j] - place[j - 1]);
  const double behind = (value[j + 1] - value[j]) / (place[j + 1] - place[j]);
  const double bend = (behind - before) / (place[j + 1] - place[j - 1]);
  const double from = place[j - 1];
  cut.place = 0.5 * (from + place[j]) - 0.5 * before / bend;
  // The parabola may fall below zero where the strips do not: a quantity that is nowhere negative stays so.
  const double least = value[j - 1] + (cut.place - from) * (before + bend * (cut.place - place[j]));
  cut.value = larger(least, smaller(value[j], 0.0));
}

}  // namespace

LobeCuts find_lobes(const double* place, const double* value, std::int32_t first, std::int32_t end,
                    const LobeLimits& limits) noexcept {
  LobeCuts cuts;
  for (std::int32_t j = first + 1; j + 1 < end; ++j) {
    // Valleys between two humps; of equal strips the last one stands for the valley.
    if (!(value[j] <= value[j - 1] && value[j] < value[j + 1])) continue;
    const double left = hump(value, j, first - 1, -1), right = hump(value, j, end, 1);
    const double lower = smaller(left, right), higher = larger(left, right);
    if (!(lower > 0.0)) continue;
    // Share of the joint patch: the valley against both humps, smoothly from 0 to 1.
    LobeCut cut;
    place_cut(place, value, j, cut);
    const double filled = (cut.value / higher - limits.parted) / (limits.united - limits.parted),
                 shoulder = ((limits.by_strip ? value[j] : cut.value) / lower - hardly_a_hump) /
                            (1.0 - hardly_a_hump);
    cut.joined = smooth_step(larger(filled, shoulder));
    if (!(cut.joined < 1.0)) continue;
    // More borders than can be told apart: the caller is told, and later valleys are none.
    if (cuts.count == LobeCuts::capacity) {
      cuts.more = true;
      break;
    }
    cuts.of[static_cast<std::size_t>(cuts.count++)] = cut;
  }
  return cuts;
}

}  // namespace wrc::surface
