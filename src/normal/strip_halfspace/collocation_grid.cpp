#include "normal/strip_halfspace/collocation_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "normal/penetration/penetration.hpp"

namespace wrc::normal {
namespace {

/// The gap's section below a level.
struct Volume {
  double area = 0.0;   ///< Int (level - height)+ dy [m^2]
  double width = 0.0;  ///< d area / d level [m]
};

Volume volume_below(const patch::GapRows& rows, double level) {
  Volume volume;
  for (std::int32_t j = 0; j + 1 < rows.count; ++j) {
    // A trapezium between two rows, cut where the height crosses the level.
    const double left = level - rows.height[j];
    const double right = level - rows.height[j + 1];
    if (left <= 0.0 && right <= 0.0) continue;
    const double dy = rows.y[j + 1] - rows.y[j];
    const double share = left > 0.0 && right > 0.0 ? 1.0 : std::max(left, right) / std::abs(left - right);
    volume.width += share * dy;
    volume.area += 0.5 * share * dy * (std::max(left, 0.0) + std::max(right, 0.0));
  }
  return volume;
}

constexpr int samples = 100;        // over the extent of all stretches
constexpr int curvature_reach = 4;  // samples to each side
constexpr int most_stretches = most_regions;

/// Extent of everything below a level [m].
struct Extent {
  double y_from = 0.0, y_to = 0.0;
  bool at_edge = false;  ///< it goes on beyond the first or the last row
};

Extent extent_below(const patch::GapRows& rows, const patch::GapMinimum& lowest, double depth) {
  const double level = lowest.height + depth;
  // The stretch around the minimum, which may lie between two rows that are both above the level.
  const Span around = penetration_span(rows, lowest, PenetrationScale{.at_centre = 1.0}, depth);
  Extent extent{around.y_from, around.y_to,
                around.at_edge || rows.height[0] < level || rows.height[rows.count - 1] < level};

  // Out to the first and the last row below the level, and on to where straight lines between rows cross it.
  const auto crossing = [&](std::int32_t inside, std::int32_t outside) {
    const double share = (level - rows.height[inside]) / (rows.height[outside] - rows.height[inside]);
    return rows.y[inside] + share * (rows.y[outside] - rows.y[inside]);
  };
  std::int32_t first = 0, last = rows.count - 1;
  while (first < rows.count && rows.height[first] >= level) ++first;
  while (last >= 0 && rows.height[last] >= level) --last;
  if (first < rows.count)
    extent.y_from = std::min(extent.y_from, first == 0 ? rows.y[0] : crossing(first, first - 1));
  if (last >= 0)
    extent.y_to = std::max(extent.y_to, last == rows.count - 1 ? rows.y[last] : crossing(last, last + 1));
  return extent;
}

/// The extent sampled at equal steps.
struct Samples {
  double y_from, step;  ///< [m]
  std::array<double, samples + 1 + 2 * curvature_reach>
      height;                               ///< [m], from y_from - curvature_reach steps on
  std::array<double, samples + 1> density;  ///< strips per length, up to a factor
};

void sample(const patch::GapRows& rows, const Extent& extent, double depth, Samples& s) {
  const double length = extent.y_to - extent.y_from;
  s.y_from = extent.y_from;
  s.step = length / samples;
  patch::GapReader gap(rows);
  for (int i = 0; i < static_cast<int>(s.height.size()); ++i)
    s.height[static_cast<std::size_t>(i)] = gap.height(s.y_from + (i - curvature_reach) * s.step);

  // Width of a contact ~ root of its radius: density ~ sqrt(|h''|), h'' a second difference over the reach
  // [1/m]. The floor, h'' of a parabola that rises by `depth` over the extent, keeps strips in flats.
  const double reach = curvature_reach * s.step;
  const double floor_curvature = 2.0 * depth / (length * length);
  std::array<double, samples + 1> local;
  for (int i = 0; i <= samples; ++i) {
    const double* const h = s.height.data() + i;
    const double second =
        std::abs(h[0] - 2.0 * h[curvature_reach] + h[2 * curvature_reach]) / (reach * reach);
    local[static_cast<std::size_t>(i)] = std::sqrt(second + floor_curvature);
  }
  // Summed over the reach, so that neighbouring strips are of similar width.
  for (int i = 0; i <= samples; ++i) {
    double sum = 0.0;
    for (int k = i - curvature_reach; k <= i + curvature_reach; ++k)
      sum += local[static_cast<std::size_t>(std::clamp(k, 0, samples))];
    s.density[static_cast<std::size_t>(i)] = sum;
  }
}

/// The density integrated along the stretches, as a broken line over y.
struct WeightLine {
  struct Point {
    double y = 0.0, weight = 0.0;
  };
  std::array<Point, samples + 1 + 2 * most_stretches> points;
  int count = 0;
  std::array<int, most_stretches> first;  ///< first point of each stretch
  int stretches = 0;

  void open(double y) {
    first[static_cast<std::size_t>(stretches++)] = count;
    add(y, 0.0);
  }
  void add(double y, double weight_gained) {
    const double before = count == 0 ? 0.0 : at(count - 1).weight;
    points[static_cast<std::size_t>(count++)] = {y, before + weight_gained};
  }
  const Point& at(int i) const { return points[static_cast<std::size_t>(i)]; }
  int first_of(int stretch) const {
    return stretch == stretches ? count : first[static_cast<std::size_t>(stretch)];
  }
};

/// Integrates the density over each stretch below the level. Weight does not grow between stretches.
WeightLine weigh(const Samples& s, double level) {
  WeightLine line;
  bool inside = false;
  for (int i = 0; i < samples; ++i) {
    // Depth below the level at both ends of the step [m].
    const double* const height = s.height.data() + curvature_reach + i;
    const double left = level - height[0], right = level - height[1];
    const double y = s.y_from + i * s.step;
    // Parts of the step at which the stretch begins and ends [-].
    double start = 0.0;
    double end = 1.0;
    if (!inside && (left > 0.0 || right > 0.0)) {
      if (line.stretches == most_stretches) break;
      if (left <= 0.0) start = left / (left - right);
      line.open(y + start * s.step);
      inside = true;
    }
    if (inside) {
      if (right <= 0.0) end = left > 0.0 ? left / (left - right) : start;
      const double* const density = s.density.data() + i;
      line.add(y + end * s.step, (end - start) * s.step * 0.5 * (density[0] + density[1]));
    }
    if (right <= 0.0) inside = false;
  }
  return line;
}

/// Cuts each stretch into strips of equal weight, `count` over all of them.
void cut_stretches(const WeightLine& line, std::int32_t count, CollocationGrid& grid) {
  grid.count = 0;
  if (line.count == 0) return;
  const double total = line.at(line.count - 1).weight;
  // Rounded from the sum so far: the stretches' strips add up to `count`.
  const auto strips_below = [&](double weight) {
    return static_cast<std::int32_t>(std::floor(count * (weight / total) + 0.5));
  };
  for (int k = 0; k < line.stretches; ++k) {
    int i = line.first_of(k);
    const int last_point = line.first_of(k + 1) - 1;
    const double weight_from = line.at(i).weight;
    const double weight_to = line.at(last_point).weight;
    const std::int32_t strips = strips_below(weight_to) - strips_below(weight_from);
    double border = line.at(i).y;
    for (std::int32_t j = 1; j <= strips; ++j) {
      // The next border [m]: y at the weight wanted, by the line's inverse.
      const double weight = weight_from + (weight_to - weight_from) * j / strips;
      while (i + 1 < last_point && line.at(i + 1).weight < weight) ++i;
      const WeightLine::Point a = line.at(i), b = line.at(i + 1);
      const double next = j == strips ? line.at(last_point).y
                                      : a.y + (b.y - a.y) * ((weight - a.weight) / (b.weight - a.weight));
      grid.y[grid.count] = 0.5 * (border + next);
      grid.width[grid.count] = next - border;
      grid.region[grid.count] = k;
      ++grid.count;
      border = next;
    }
  }
}

}  // namespace

double foundation_approach(const patch::GapRows& rows, double lowest_height, double normal_compliance,
                           double normal_force, double guess) noexcept {
  // Load of the foundation: N = area(level) / (2 c), level = 0.6 approach. The area grows like level^1.4 to
  // 1.5; for Newton's rule area^(3/4) is almost a straight line.
  const double target = 2.0 * normal_compliance * normal_force;
  const double target_root = std::sqrt(std::sqrt(target));
  const double target_power = target_root * target_root * target_root;
  double level = 0.6 * guess;
  for (int i = 0; i < 30; ++i) {
    const Volume volume = volume_below(rows, lowest_height + level);
    if (!(volume.width > 0.0)) {  // the level lies below every row, between two of them
      level *= 4.0;
      continue;
    }
    const double step =
        (volume.area - target_power * std::sqrt(std::sqrt(volume.area))) / (0.75 * volume.width);
    // At most five times deeper, at most to a tenth of the depth.
    level -= std::clamp(step, -4.0 * level, 0.9 * level);
    if (std::abs(step) <= 1e-3 * level) break;
  }
  return level / 0.6;
}

void build_collocation_grid(const patch::GapRows& rows, const patch::GapMinimum& lowest, double depth,
                            std::int32_t count, CollocationGrid& grid) noexcept {
  const Extent extent = extent_below(rows, lowest, depth);
  grid.at_edge = extent.at_edge;
  Samples s;
  sample(rows, extent, depth, s);
  cut_stretches(weigh(s, lowest.height + depth), count, grid);
}

}  // namespace wrc::normal
