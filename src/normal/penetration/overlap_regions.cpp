#include "normal/penetration/overlap_regions.hpp"

#include <cmath>

#include "patch/split.hpp"

namespace wrc::normal {
namespace {

/// The chord may grow like this power of the depth at once. An elliptic gap has 1/2; the load, which grows
/// like depth^1.5, would fall where it is several times as much as here.
constexpr double quickest = 2.0;

/// Growth beyond that counts fully only for a gap that lies this part of the depth lower: the load rises
/// by more over that than the longest chord costs.
constexpr double entry = 0.6;

/// Distance of the outermost border of all regions below `depth` above the lowest point, in one direction (+1
/// or -1) from the contact point, less the lengths that do not count yet [m]; `least` if no row lies below.
double reach_of_all_regions(const patch::GapRows& rows, const patch::GapMinimum& lowest, double depth,
                            int direction, double least) {
  const PenetrationScale whole{.at_centre = 1.0};
  const auto height = [&](std::int32_t j) { return rows.height[j] - lowest.height; };
  const auto distance = [&](double y) { return (y - lowest.y) * direction; };
  const auto crossing = [&](std::int32_t in, std::int32_t out, double level) {
    Overlap<PenetrationScale> overlap{rows, lowest, whole, level};
    return distance(
        border_between(overlap, rows.y[in], level - height(in), rows.y[out], level - height(out)));
  };
  // Inwards from the border: the least height so far, `level`, and where it was passed, `outer`.
  double reach = least, outer = 0.0, level = depth;
  std::int32_t bottom = -1;  // row of the least height
  std::int32_t j = direction > 0 ? rows.count - 1 : 0;
  for (; j >= 0 && j < rows.count && distance(rows.y[j]) > 0.0; j -= direction) {
    const double h = height(j), here = distance(rows.y[j]);
    if (h >= level) continue;
    const std::int32_t beyond = j + direction;
    // The reach less an excess [m] that came in at a depth; it counts more the deeper the gap lies below.
    const auto leave_out = [&](double excess, double at) {
      if (excess > 0.0) reach -= excess * std::max(1.0 - (depth - at) / (entry * depth), 0.0);
    };
    if (bottom < 0) {
      outer = beyond < 0 || beyond >= rows.count ? here : crossing(j, beyond, depth);
      reach = outer;
    } else if (beyond != bottom) {
      // A valley outside: the chord jumps across it at once.
      const double inner = crossing(j, beyond, level);
      leave_out(outer - inner, level);
      outer = inner;
    }
    // Growth of the chord in excess of quickest * outer * d ln(depth).
    const double rise = 2.0 * (level - h) / (level + h);  // about the logarithm of the ratio
    leave_out(outer - here - quickest * outer * rise, 0.5 * (level + h));
    outer = here;
    level = h;
    bottom = j;
    if (h < (1.0 - entry) * depth) break;
  }
  return reach;
}

}  // namespace

LateralCurvature curvature_of_all_regions(const patch::GapRows& rows, const patch::GapMinimum& lowest,
                                          double approach) noexcept {
  // The chord at half the approach, its ends moved out to all regions.
  const PenetrationScale half;
  Span chord = penetration_span(rows, lowest, half, approach);
  const double depth = half.at_centre * approach;
  chord.y_from = lowest.y - reach_of_all_regions(rows, lowest, depth, -1, lowest.y - chord.y_from);
  chord.y_to = lowest.y + reach_of_all_regions(rows, lowest, depth, +1, chord.y_to - lowest.y);
  return lateral_curvature(chord, approach);
}

OverlapRegions overlap_regions(const patch::GapRows& rows, const patch::GapMinimum& lowest,
                               const PenetrationScale& scale, double approach, const Span& main,
                               std::int32_t most) noexcept {
  OverlapRegions regions;
  regions.of[0] = main;
  regions.count = 1;
  regions.at_edge = main.at_edge;
  most = std::min(most, OverlapRegions::capacity);
  Overlap<PenetrationScale> overlap{rows, lowest, scale, approach};
  const auto add = [&](const Span& region) {
    if (regions.count == most) return;
    regions.of[static_cast<std::size_t>(regions.count++)] = region;
    regions.at_edge = regions.at_edge || region.at_edge;
  };
  // Downwards from the main region, then upwards: in order of y after the reversal.
  regions_beyond(overlap, main.y_from, -1, add);
  std::reverse(regions.of.begin(), regions.of.begin() + regions.count);
  regions_beyond(overlap, main.y_to, +1, add);
  return regions;
}

void divide_regions(const Kernels& kernels, const patch::GapRows& rows, const patch::GapMinimum& lowest,
                    const PenetrationScale& scale, double approach, const OverlapRegions& regions,
                    std::int32_t count, patch::Strips& strips) noexcept {
  if (regions.count == 1)
    return divide_span(kernels, rows, lowest, scale, approach, regions.of[0], count, strips);
  constexpr double least = 1e-6;  // share of a width: no strip is made of less
  // One width for all regions [m]; each further region may cost a strip cut in two.
  double total = 0.0;
  for (std::int32_t r = 0; r < regions.count; ++r) total += regions.of[static_cast<std::size_t>(r)].width();
  const double width = total / (count - (regions.count - 1));
  strips.count = 0;
  const auto fill = [&](double from, double to, std::int32_t parts) {
    parts = std::min(parts, count - strips.count);
    if (parts <= 0) return;
    patch::Strips part = patch::slice(strips, strips.count, strips.count + parts);
    divide_span(kernels, rows, lowest, scale, approach, {from, to, false}, parts, part);
    strips.count += parts;
  };
  double owed = 0.0;  // width of the strip that began in the region before
  for (std::int32_t r = 0; r < regions.count; ++r) {
    const Span& region = regions.of[static_cast<std::size_t>(r)];
    // First the rest of the strip that the region before began, then whole strips, then a part of the next.
    double from = region.y_from;
    const double first = std::min(owed, region.width());
    owed -= first;
    if (first > least * width) {
      fill(from, from + first, 1);
      from += first;
    }
    const auto whole = static_cast<std::int32_t>(std::floor((region.y_to - from) / width + least));
    if (whole > 0) fill(from, from + whole * width, whole);
    const double rest = region.y_to - (from + whole * width);
    if (rest > least * width) {
      fill(region.y_to - rest, region.y_to, 1);
      owed = width - rest;
    }
  }
}

}  // namespace wrc::normal
