#include "damage/subsurface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/elementary.hpp"
#include "base/golden_section.hpp"

namespace wrc {
namespace {

/// The share of a cell's border across, X ahead of it: the difference of its corners.
CellStress border_stress(double poisson, double X, double y, double z, double width) {
  CellStress share;
  add(corner_stress(poisson, X, y + 0.5 * width, z), 1.0, share);
  add(corner_stress(poisson, X, y - 0.5 * width, z), -1.0, share);
  return share;
}

/// A place of the search: lane and cell, the latter from -beyond to cells + beyond - 1.
struct Place {
  std::int32_t lane = 0, cell = 0;
};

}  // namespace

LoadLanes::LoadLanes(double poisson) : poisson_(poisson) {
  // Both halves alike: xi = cos(angle), Int sqrt(1 - xi^2) dxi = (angle - sin(angle) cos(angle)) / 2.
  SineCosine before = sine_cosine(0.0);
  double angle_before = 0.0;
  for (std::int32_t k = 0; k < cells / 2; ++k) {
    const double angle = pi * (k + 1.0) / cells;
    const SineCosine here = sine_cosine(angle);
    const double area =
        0.5 * ((angle - here.sine * here.cosine) - (angle_before - before.sine * before.cosine));
    const std::int32_t other = cells - 1 - k;
    half_[k] = half_[other] = 0.5 * (before.cosine - here.cosine);
    middle_[k] = 0.5 * (before.cosine + here.cosine);
    middle_[other] = -middle_[k];
    mean_[k] = mean_[other] = 0.5 * area / half_[k];
    before = here;
    angle_before = angle;
  }
}

double LoadLanes::x_of(const Lane& lane, std::int32_t cell) const {
  double xi = 0.0;
  if (cell < 0) {
    xi = 2.0 - middle_[-1 - cell];
  } else if (cell >= cells) {
    xi = -2.0 - middle_[2 * cells - 1 - cell];
  } else {
    xi = middle_[cell];
  }
  return lane.centre + lane.half_length * xi;
}

void LoadLanes::add_patch(const Strips& region, const double* pressure, const TangentialFields& fields,
                          std::int32_t own_cells, std::int32_t strips_of_all, double way, double sign) {
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
    lane_[lanes_] = {moment / area, width, centre / area, way * area / width};
    // What part of the pressure the tractions are in the patch's own cell.
    const auto shares_in = [&](std::int32_t i, double& x, double& y) {
      double p = 0.0;
      x = y = 0.0;
      for (std::int32_t j = first; j < end; ++j) {
        const double share = region.width[j] * region.half_length[j];
        const std::int32_t at = i * strips + j;
        p += share * pressure[at];
        x += share * fields.traction_x[at];
        y += share * fields.traction_y[at];
      }
      x = p > 0.0 ? sign * x / p : 0.0;
      y = p > 0.0 ? sign * y / p : 0.0;
    };
    for (std::int32_t k = 0; k < cells; ++k) {
      const double at = std::clamp(0.5 * own_cells * (1.0 - middle_[k]) - 0.5, 0.0, own_cells - 1.0);
      const std::int32_t i = std::min(static_cast<std::int32_t>(at), own_cells - 2);
      double x0, y0, x1, y1;
      shares_in(i, x0, y0);
      shares_in(i + 1, x1, y1);
      const double p = peak / area * mean_[k], along = at - i;
      pressure_[lanes_][k] = p;
      along_[lanes_][k] = p * (x0 + along * (x1 - x0));
      across_[lanes_][k] = p * (y0 + along * (y1 - y0));
    }
    ++lanes_;
  }
}

Stress LoadLanes::at(double x, double y, double z) const {
  constexpr double near = 2.5;  // sizes of a cell: from there on it is a point
  Stress sum;
  for (std::int32_t k = 0; k < lanes_; ++k) {
    const Lane& lane = lane_[k];
    const double dy = y - lane.y, away = dy * dy + z * z, width2 = lane.width * lane.width;
    CellStress border;  // of two near cells: its corners serve both
    bool has_border = false;
    for (std::int32_t i = 0; i < cells; ++i) {
      const double dx = x - (lane.centre + lane.half_length * middle_[i]), half = lane.half_length * half_[i];
      const double p = pressure_[k][i], qx = along_[k][i], qy = across_[k][i];
      if (dx * dx + away >= near * near * (4.0 * half * half + width2)) {
        const double area = 2.0 * std::abs(half) * lane.width;
        add(point_force_stress(poisson_, dx, dy, z, p * area, qx * area, qy * area), 1.0, sum);
        has_border = false;
        continue;
      }
      const CellStress ahead = has_border ? border : border_stress(poisson_, dx - half, dy, z, lane.width);
      border = border_stress(poisson_, dx + half, dy, z, lane.width);
      has_border = true;
      const double way = half > 0.0 ? 1.0 : -1.0;
      for (const auto& [of_load, load] :
           {std::pair{&CellStress::of_pressure, way * p}, std::pair{&CellStress::of_traction_x, way * qx},
            std::pair{&CellStress::of_traction_y, way * qy}}) {
        add(border.*of_load, load, sum);
        add(ahead.*of_load, -load, sum);
      }
    }
  }
  return sum;
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
    if (from_end >= -spared && from_end < spared) return;
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
  // From one place of the first round to the next; the ends of a lane, where tension is, always.
  constexpr Stride coarse{2, 4};
  for (std::int32_t k = std::min(coarse.lanes / 2, lanes_ / 2); k < lanes_; k += coarse.lanes) {
    look_at({k, -1 - spared});
    for (std::int32_t i = spared; i < cells - spared; i += coarse.cells) look_at({k, i});
    look_at({k, cells + spared});
  }
  for (const Stride step : {Stride{1, 2}, Stride{1, 1}}) {
    for (int number = 0; number < followed; ++number) {
      bool seen = false;  // by a number before, around the same place
      for (int other = 0; other < number; ++other)
        seen = seen || (best[other].lane == best[number].lane && best[other].cell == best[number].cell);
      if (seen) continue;
      const Place middle = best[number];
      for (std::int32_t lane = -1; lane <= 1; ++lane) {
        for (std::int32_t cell = -1; cell <= 1; ++cell) {
          const Place place{middle.lane + step.lanes * lane, middle.cell + step.cells * cell};
          if ((lane == 0 && cell == 0) || place.lane < 0 || place.lane >= lanes_) continue;
          if (place.cell < -beyond || place.cell >= cells + beyond) continue;
          look_at(place);
        }
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

}  // namespace wrc
