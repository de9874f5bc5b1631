#include "damage/subsurface.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "base/golden_section.hpp"
#include "damage/simd/tasks.hpp"

namespace wrc::damage {
namespace {

/// So many sizes of a cell away points stand for cells; so many distances of theirs away, few points serve.
constexpr double near_cell = 2.3, deep_steps = 1.8;
/// So many widths deep points serve all lanes, beside each other at even distances.
constexpr double deep_widths = 1.4;

double square(double a) { return a * a; }

/// A place of the search: lane and cell, the latter from -beyond to cells + beyond - 1.
struct Place {
  std::int32_t lane = 0, cell = 0;
};

}  // namespace

/// Corners of cells that wait for the kernel.
struct LoadLanes::Corners {
  static constexpr std::int32_t of_a_lane = 2 * (cells + 1), most = 160;
  static_assert(of_a_lane + simd::stress_parts <= most && most % simd::stress_parts == 0);
  std::int32_t count = 0;
  double x[most], y[most], pressure[most], along[most], across[most];
};

/// Tractions of a strip as shares of the pressure, at any place between the middles of the patch's cells.
///
/// Straight lines between cells would flatten the peak where adhesion ends, which is where a partly sliding
/// surface is stressed most. The theory of rolling has a root of the distance there (Carter 1926: the sliding
/// strip's semi-ellipse less a smaller one): (1 - share / bound)^2 falls linearly to nothing at the border,
/// which so follows from the last two cells that adhere.
struct LoadLanes::Shares {
  const double* pressure;  ///< over the peak
  double peak;
  const double *traction_x, *traction_y;  ///< at the strip's first cell
  std::int32_t strips, own_cells;
  double sign;
  bool slips = false;     ///< behind adhesion that begins at the leading edge
  std::int32_t last = 0;  ///< cell that adheres
  double border = 0.0;    ///< where adhesion ends, in cells behind that one's middle
  double bound = 0.0;     ///< share where it slips: that of the second cell behind the last
  double lacks = 0.0;     ///< 1 - share / bound in the last cell

  Shares(const patch::Strips& region, const double* pressure_, const tangential::TangentialFields& fields,
         std::int32_t cells_, std::int32_t strip, double sign_)
      : pressure(pressure_),
        peak(region.peak[strip]),
        traction_x(fields.traction_x + strip),
        traction_y(fields.traction_y + strip),
        strips(region.count),
        own_cells(cells_),
        sign(sign_) {
    if (!(fields.slip_x && fields.slip_y)) return;
    std::int32_t first = 0;  // that slips
    for (; first < own_cells; ++first) {
      const std::int32_t at = first * strips + strip;
      if (fields.slip_x[at] != 0.0 || fields.slip_y[at] != 0.0) break;
    }
    if (first < 3 || first > own_cells - 3) return;
    last = first - 1;
    bound = size(last + 2);
    if (!(bound > 0.0)) return;
    lacks = 1.0 - size(last) / bound;
    const double before = 1.0 - size(last - 1) / bound;
    if (!(lacks > 0.0 && before > lacks)) return;
    border = std::min(square(lacks) / (square(before) - square(lacks)), 1.0);
    slips = border > 0.0;
  }

  void in_cell(std::int32_t i, double& x, double& y) const {
    const std::int32_t at = i * strips;
    const double p = peak * pressure[i];
    x = p > 0.0 ? sign * traction_x[at] / p : 0.0;
    y = p > 0.0 ? sign * traction_y[at] / p : 0.0;
  }
  double size(std::int32_t i) const {
    double x, y;
    in_cell(i, x, y);
    return std::sqrt(x * x + y * y);
  }
  /// In half lengths, as the place that follows.
  double border_place() const { return 1.0 - 2.0 * (last + border + 0.5) / own_cells; }
  void at(double place, double& x, double& y) const {
    const double cell = std::clamp(0.5 * own_cells * (1.0 - place) - 0.5, 0.0, own_cells - 1.0);
    const std::int32_t i = std::min(static_cast<std::int32_t>(cell), own_cells - 2);
    double x0, y0, x1, y1;
    in_cell(i, x0, y0);
    in_cell(i + 1, x1, y1);
    x = x0 + (cell - i) * (x1 - x0);
    y = y0 + (cell - i) * (y1 - y0);
    const double behind = cell - last, adheres = border - behind;
    if (!slips || behind < 0.0 || behind > 2.0) return;
    const double straight = std::sqrt(x * x + y * y);
    const double share = adheres > 0.0 ? bound * (1.0 - lacks * std::sqrt(adheres / border)) : bound;
    const double factor = straight > 0.0 ? share / straight : 1.0;
    x *= factor;
    y *= factor;
  }
};

void LoadLanes::fill(std::int32_t count, Rule& rule) {
  for (std::int32_t k = 0; k < count / 2; ++k) {
    const SineCosine here = sine_cosine(pi * (k + 0.5) / count);
    rule.place[k] = here.cosine;
    rule.place[count - 1 - k] = -here.cosine;
    rule.weight[k] = rule.weight[count - 1 - k] = pi / count * (here.sine * here.sine);
  }
}

LoadLanes::LoadLanes(double poisson, const Kernels& kernels) : poisson_(poisson), kernels_(kernels) {
  // Both halves alike: xi = cos(angle), Int sqrt(1 - xi^2) dxi = (angle - sin(angle) cos(angle)) / 2.
  SineCosine before = sine_cosine(0.0);
  double angle_before = 0.0;
  border_[0] = 1.0;
  border_[cells] = -1.0;
  for (std::int32_t k = 0; k < cells / 2; ++k) {
    const double angle = pi * (k + 1.0) / cells;
    const SineCosine here = sine_cosine(angle);
    const double area =
        0.5 * ((angle - here.sine * here.cosine) - (angle_before - before.sine * before.cosine));
    const std::int32_t other = cells - 1 - k;
    border_[k + 1] = here.cosine;
    border_[other] = -here.cosine;
    middle_[k] = 0.5 * (before.cosine + here.cosine);
    middle_[other] = -middle_[k];
    mean_[k] = mean_[other] = area / (before.cosine - here.cosine);
    before = here;
    angle_before = angle;
  }
  border_[cells / 2] = 0.0;
  fill(cells, of_cells_);
  fill(deep, of_depths_);
}

double LoadLanes::x_of(const Lane& lane, std::int32_t cell) const {
  double xi = 0.0;
  if (cell < 0) {
    xi = 2.0 - border_[-cell];
  } else if (cell >= cells) {
    xi = -2.0 - border_[2 * cells - 1 - cell];
  } else {
    xi = middle_of(lane, cell);
  }
  return lane.centre + lane.half_length * xi;
}

double LoadLanes::middle_of(const Lane& lane, std::int32_t cell) const {
  if (cell == lane.slips_from) return 0.5 * (lane.slips_at + border_[cell + 1]);
  if (cell == lane.slips_from - 1) return 0.5 * (border_[cell] + lane.slips_at);
  return middle_[cell];
}

void LoadLanes::move_border(Lane& lane, double place) const {
  std::int32_t k = 1;
  while (k < cells && border_[k] > place) ++k;
  if (border_[k - 1] - place < place - border_[k]) --k;
  if (k < 2 || k > cells - 2) return;  // an end's own cells stay
  lane.slips_from = k;
  lane.slips_at = place;
  const auto height = [](double xi) { return std::sqrt(1.0 - xi * xi); };
  const auto mean = [&](double low, double high) {  // Simpson's rule
    return (height(low) + 4.0 * height(0.5 * (low + high)) + height(high)) / 6.0;
  };
  lane.mean_before = mean(place, border_[k - 1]);
  lane.mean_behind = mean(border_[k + 1], place);
}

void LoadLanes::add_patch(const patch::Strips& region, const double* pressure,
                          const tangential::TangentialFields& fields, std::int32_t own_cells,
                          std::int32_t strips_of_all, double way, double sign) {
  const std::int32_t strips = region.count;
  const std::int32_t together = (strips_of_all + wanted_lanes - 1) / wanted_lanes;
  for (std::int32_t first = 0; first < strips && lanes_ < most_lanes; first += together) {
    const std::int32_t end = std::min(first + together, strips);
    double width = 0.0, area = 0.0, centre = 0.0, moment = 0.0, peak = 0.0;
    for (std::int32_t j = first; j < end; ++j) {
      const double share = region.width[j] * region.half_length[j];
      width += region.width[j];
      area += share;
      centre += share * region.centre[j];
      moment += share * region.y[j];
      peak += share * region.peak[j];
    }
    if (!(area > 0.0)) continue;
    lane_[lanes_] = {moment / area, width, centre / area, way * area / width, peak / area};
    deep_from_ = std::max(deep_from_, deep_steps * std::max(pi / deep * (area / width), width));
    // Shares are those of the one or two strips in the middle: adhesion ends elsewhere in those beside them,
    // and a mean over all would have no peak there.
    const std::int32_t middle = first + (end - first - 1) / 2, other = first + (end - first) / 2;
    const Shares one(region, pressure, fields, own_cells, middle, sign);
    const Shares two(region, pressure, fields, own_cells, other, sign);
    const auto share_at = [&](double place, double& x, double& y) {
      double x1, y1, x2, y2;
      one.at(place, x1, y1);
      two.at(place, x2, y2);
      x = 0.5 * (x1 + x2);
      y = 0.5 * (y1 + y2);
    };
    if (one.slips && two.slips) move_border(lane_[lanes_], 0.5 * (one.border_place() + two.border_place()));
    for (std::int32_t k = 0; k < cells; ++k)
      share_at(middle_of(lane_[lanes_], k), along_[lanes_][k], across_[lanes_][k]);
    for (std::int32_t k = 0; k < deep; ++k)
      share_at(of_depths_.place[k], deep_along_[lanes_][k], deep_across_[lanes_][k]);
    ++lanes_;
  }
}

void LoadLanes::add_cells(std::int32_t which, std::int32_t first, std::int32_t last, double x, double y,
                          Corners& corners) const {
  // A border has the difference of the loads of its two cells.
  constexpr double least = 1e-9;  // [m]: nearer to a corner stresses are infinite
  const auto away = [](double from) { return std::abs(from) < least ? std::copysign(least, from) : from; };
  const Lane& lane = lane_[which];
  const double way = lane.half_length > 0.0 ? 1.0 : -1.0;
  // The moved border only with the cells on both its sides: a point stands for a cell of the usual length.
  const std::int32_t moved = lane.slips_from > first && lane.slips_from < last ? lane.slips_from : -1;
  double p_before = 0.0, x_before = 0.0, y_before = 0.0;
  for (std::int32_t k = first; k <= last; ++k) {
    const bool inside = k < last;
    const double at_border = k == moved ? lane.slips_at : border_[k];
    double mean = inside ? mean_[k] : 0.0;
    if (moved >= 0 && k == moved - 1) mean = lane.mean_before;
    if (moved >= 0 && k == moved) mean = lane.mean_behind;
    const double p = way * lane.pressure * mean;
    const double qx = inside ? p * along_[which][k] : 0.0, qy = inside ? p * across_[which][k] : 0.0;
    for (const double side : {0.5, -0.5}) {
      const std::int32_t at = corners.count++;
      const double weight = side > 0.0 ? 1.0 : -1.0;
      corners.x[at] = away(x - lane.centre - lane.half_length * at_border);
      corners.y[at] = away(y - lane.y + side * lane.width);
      corners.pressure[at] = weight * (p_before - p);
      corners.along[at] = weight * (x_before - qx);
      corners.across[at] = weight * (y_before - qy);
    }
    p_before = p;
    x_before = qx;
    y_before = qy;
  }
}

void LoadLanes::flush(double z, Corners& corners, simd::StressParts& sum) const {
  std::int32_t count = corners.count;
  for (; count % simd::stress_parts != 0; ++count) {
    corners.x[count] = corners.y[count] = 1.0;
    corners.pressure[count] = corners.along[count] = corners.across[count] = 0.0;
  }
  kernels_.damage.stress_of_corners(
      {poisson_, z, count, corners.x, corners.y, corners.pressure, corners.along, corners.across}, sum);
  corners.count = 0;
}

Stress LoadLanes::at(double x, double y, double z) const {
  simd::StressParts sum{};
  Corners corners;
  for (std::int32_t k = 0; k < lanes_; ++k) {
    const Lane& lane = lane_[k];
    // Adds the stresses by `count` points of the lane with these tractions over pressure; loads nearer than
    // `near_limit` [m] are left to add_cells().
    const auto add_points = [&](const Rule& rule, std::int32_t count, const double* along,
                                const double* across, double near_limit) {
      kernels_.damage.stress_of_points({poisson_, x - lane.centre, y - lane.y, z, lane.half_length,
                                        lane.pressure * lane.width * std::abs(lane.half_length), count,
                                        rule.place, rule.weight, along, across, near_limit},
                                       sum);
    };
    const double away2 = square(y - lane.y) + square(z);
    const double along = deep_steps * (pi / deep) * std::abs(lane.half_length);
    if (z >= std::max(along, deep_widths * lane.width) ||
        away2 >= square(std::max(along, near_cell * lane.width))) {
      add_points(of_depths_, deep, deep_along_[k], deep_across_[k], 0.0);
      continue;
    }
    const double size2 = square(pi / cells * lane.half_length) + square(lane.width);
    const double left = square(near_cell) * size2 - away2;
    const double near = left > 0.0 ? std::sqrt(left) : 0.0;
    add_points(of_cells_, cells, along_[k], across_[k], near);
    if (!(near > 0.0)) continue;
    std::int32_t first = 0, last = cells;
    const auto is_near = [&](std::int32_t cell) {  // as the kernel has it
      return std::abs((x - lane.centre) - lane.half_length * of_cells_.place[cell]) < near;
    };
    while (first < last && !is_near(first)) ++first;
    while (last > first && !is_near(last - 1)) --last;
    if (first == last) continue;
    if (corners.count + Corners::of_a_lane + simd::stress_parts > Corners::most) flush(z, corners, sum);
    add_cells(k, first, last, x, y, corners);
  }
  if (corners.count > 0) flush(z, corners, sum);
  double total[6];
  for (int c = 0; c < 6; ++c) {
    total[c] = 0.0;
    for (const double part : sum.part[c]) total[c] += part;
  }
  return {total[0], total[1], total[2], total[3], total[4], total[5]};
}

StressPeaks LoadLanes::peaks(double z) const {
  StressPeaks found;
  // Followed each on its own: the three numbers, and the first two away from the ends of the lanes, where
  // there is often another maximum.
  constexpr int followed = 5;
  constexpr StressPeak StressPeaks::*of[followed] = {&StressPeaks::von_mises, &StressPeaks::shear,
                                                     &StressPeaks::tension, &StressPeaks::von_mises,
                                                     &StressPeaks::shear};
  Place best[followed];
  double largest[followed] = {};
  bool any[followed] = {};
  const auto look_at = [&](const Place& place) {
    const std::int32_t from_end = std::min(place.cell, cells - 1 - place.cell);
    if (from_end >= 1 - spared && from_end < spared) return;
    const double x = x_of(lane_[place.lane], place.cell), y = lane_[place.lane].y;
    StressPeaks here;
    here.take(numbers_of(at(x, y, z)), x, y, z);
    found.take(here);
    for (int k = 0; k < followed; ++k) {
      const double value = (here.*of[k]).value;
      if ((k > 2 && from_end < cells / 8) || (any[k] && !(value > largest[k]))) continue;
      any[k] = true;
      largest[k] = value;
      best[k] = place;
    }
  };
  struct Stride {
    std::int32_t lanes, cells;
  };
  // From one place of the first round to the next; the ends of a lane, where tension is, and where adhesion
  // ends at the surface, always.
  const bool smooth = z >= deep_from_;
  const Stride first = smooth ? Stride{4, 8} : z > 0.0 ? Stride{2, 6} : Stride{2, 4};
  for (std::int32_t k = std::min(first.lanes / 2, lanes_ / 2); k < lanes_; k += first.lanes) {
    look_at({k, -spared});
    for (std::int32_t i = 2; i < cells - 1; i += first.cells) look_at({k, i});
    look_at({k, cells - 1 + spared});
    if (!(z > 0.0) && lane_[k].slips_from > 0) look_at({k, lane_[k].slips_from});
  }
  // Then to both sides of the best, along and across, nearer and nearer.
  const Stride rounds[] = {
      smooth ? Stride{2, 4} : Stride{1, 2}, smooth ? Stride{1, 2} : Stride{1, 1}, {1, 1}};
  for (const Stride step : rounds) {
    for (int number = 0; number < followed; ++number) {
      bool seen = false;  // by a number before, around the same place
      for (int other = 0; other < number; ++other)
        seen = seen || (best[other].lane == best[number].lane && best[other].cell == best[number].cell);
      if (seen) continue;
      const Place middle = best[number];
      for (const Stride to : {Stride{-1, 0}, Stride{1, 0}, Stride{0, -1}, Stride{0, 1}}) {
        const Place place{middle.lane + step.lanes * to.lanes, middle.cell + step.cells * to.cells};
        if (place.lane < 0 || place.lane >= lanes_) continue;
        if (place.cell < -beyond || place.cell >= cells + beyond) continue;
        look_at(place);
      }
    }
  }
  return found;
}

void LoadLanes::refine(const StressPeak& from, StressPeak StressPeaks::*which, double low, double high,
                       StressPeaks& below) const {
  const auto value_at = [&](double z) {
    StressPeaks here;
    here.take(numbers_of(at(from.x, from.y, z)), from.x, from.y, z);
    below.take(here);
    return (here.*which).value;
  };
  narrow_to_largest(low, high, 6, value_at);
}

}  // namespace wrc::damage
