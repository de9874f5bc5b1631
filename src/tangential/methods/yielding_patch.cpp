#include "tangential/methods/yielding_patch.hpp"

#include <algorithm>

#include "kernels/kernels.hpp"

namespace wrc::tangential {
namespace {

constexpr std::int32_t cells = memory_cells;

/// 1 - the square of the cells' places over the half length, up to the middle.
struct Parabola {
  double of[half_cells];
};
constexpr Parabola parabola = [] {
  Parabola p{};
  for (std::int32_t i = 0; i < half_cells; ++i) {
    const double at = 1.0 - (2.0 * i + 1.0) / cells;
    p.of[i] = 1.0 - at * at;
  }
  return p;
}();

/// Bins of the cells' pressures, and the roots of their numbers.
constexpr std::int32_t bins = 64;
struct Roots {
  double of[bins + 1];
};
constexpr Roots roots = [] {
  Roots r{};
  for (std::int32_t i = 1; i <= bins; ++i) {
    double root = 1.0 + i / 4.0;
    for (int step = 0; step < 8; ++step) root = 0.5 * (root + i / root);
    r.of[i] = root;
  }
  return r;
}();

/// Cells of a patch by their pressure: the share of the area where it is larger.
struct PressureRanks {
  double per_load;          ///< bins over the largest peak times half length
  double larger[bins + 1];  ///< at pressures whose square over the largest one's is bin / bins
  double cone;              ///< part of a cone in the pressures' form
};

PressureRanks rank_pressures(const patch::Strips& region, double largest_load) {
  // Area of the cells by the square of their pressure: cells between two bins are of both.
  PressureRanks ranks;
  ranks.per_load = (bins - 1e-9) / std::max(largest_load, least_divisor);
  double area[bins + 1] = {}, whole = 0.0;
  for (std::int32_t j = 0; j < region.count; ++j) {
    const double load = ranks.per_load * (region.peak[j] * region.half_length[j]);
    const double of_cell = region.width[j] * region.half_length[j];
    for (std::int32_t i = 0; i < half_cells; ++i) {
      const double square = load * parabola.of[i];
      const std::int32_t bin = static_cast<std::int32_t>(square);
      const double next = (square - bin) * of_cell;
      area[bin] += of_cell - next;
      area[bin + 1] += next;
    }
    whole += half_cells * of_cell;
  }
  // Mean share under the pressure: 0.4 under Hertz's, 1/3 under a cone's, as displacements d of cells that
  // begin to slide are 1 - x^2 and 1 - x. Between them it is linear in the parts of both.
  constexpr double more_by_cells = 0.0023;  // mean share of an ellipse on 8 to 60 strips, less 0.4
  const double per_area = 1.0 / std::max(whole, least_divisor);
  double sum = 0.0, pressed = 0.0, mean = 0.0;
  for (std::int32_t bin = 0; bin <= bins; ++bin) {
    sum += area[bin];
    ranks.larger[bin] = std::max(0.0, 1.0 - (sum - 0.5 * area[bin]) * per_area);
    const double own = area[bin] * roots.of[bin];
    pressed += own;
    mean += own * ranks.larger[bin];
  }
  mean = mean / std::max(pressed, least_divisor) - more_by_cells;
  ranks.cone = std::clamp(4.0 * (0.4 - mean) / (0.6 - mean), -0.5, 1.0);
  return ranks;
}

}  // namespace

void clear_strip(RememberingStrip& strip) {
  std::fill_n(strip.bound, half_cells, 0.0);
  strip.bounds = strip.growth_x = strip.growth_y = strip.turns = strip.arm = 0.0;
  strip.own_x = strip.own_y = strip.own_turn = 0.0;
}

void complete_bounds(RememberingStrip& strip) {
  for (std::int32_t i = 0; i < half_cells; ++i) strip.bound[cells - 1 - i] = strip.bound[i];
}

void add_to_strips(const RollingContact& contact, const YieldingPatch& patch, const MemoryFactors& factors,
                   RememberingStrip* strips) {
  // Bounds over that of the middle: 1 - x^2 - (2/3) q (1 - x^3) of an ellipse, 1 - x - (1/2) q (1 - x^2) of a
  // cone, both over 1 - x.
  const patch::Strips& r = contact.region;
  const PatchNumbers& numbers = patch.numbers;
  const double share = numbers.share;
  const PressureRanks ranks = rank_pressures(r, numbers.largest_load);
  const double curved = (2.0 / 3.0) * share, round = 1.0 - ranks.cone;
  const double at_middle = round * (1.0 - curved) + ranks.cone * (1.0 - 0.5 * share);
  const double by_x = round * (1.0 - curved) - ranks.cone * (0.5 * share), by_x2 = -(round * curved);
  const simd::MemoryBoundsTask task{parabola.of, ranks.larger, share, at_middle, by_x, by_x2};
  double whole = 0.0;
  for (std::int32_t j = 0; j < r.count; ++j) {
    const double load = ranks.per_load * (r.peak[j] * r.half_length[j]);
    const double sum =
        contact.grid->kernels->tangential.memory_bounds(task, load, contact.friction.share(j), strips[j]);
    whole += sum * (r.width[j] * r.half_length[j] * (2.0 / cells));
  }
  // Then [Pa]: the whole is the friction limit. Cells turn the faster, the less of the patch slides.
  const double per = numbers.limit / std::max(whole, least_divisor);
  const double before2 = patch.before[0] * patch.before[0] + patch.before[1] * patch.before[1];
  const double used2 = before2 / std::max(numbers.limit * numbers.limit, least_divisor);
  const double turns = factors.turns * std::max(0.0, 1.0 - used2 * used2 * used2);
  for (std::int32_t j = 0; j < r.count; ++j) {
    RememberingStrip& strip = strips[j];
    const double weight = patch.share * patch.inside(patch.first + j), times = weight * per;
    for (std::int32_t i = 0; i < half_cells; ++i) strip.bound[i] += times * strip.had[i];
    strip.bounds += times * strip.had[half_cells];
    strip.growth_x += weight * numbers.growth_x;
    strip.growth_y += weight * numbers.growth_y;
    strip.turns += weight * turns;
    strip.arm += weight * numbers.arm;
  }
}

}  // namespace wrc::tangential
