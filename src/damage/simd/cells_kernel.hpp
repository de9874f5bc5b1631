/// The assessment of the cells (damage/cells.hpp) for the instruction set of the unit: one strip per lane,
/// the cells of a strip in their order.
#pragma once

#include "base/pack.hpp"
#include "damage/fatigue.hpp"
#include "damage/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// The largest lane. All lanes are numbers, and zeros are positive: the order does not matter.
inline double largest_lane(Pack a) {
  double lane[lanes];
  store_pack(lane, a);
  double largest = lane[0];
  for (std::int32_t k = 1; k < lanes; ++k) largest = lane[k] > largest ? lane[k] : largest;
  return largest;
}

inline void assess_cells_kernel(const CellTask& task, CellExtremes& extremes) {
  const patch::Strips& region = *task.region;
  const tangential::TangentialFields& fields = *task.fields;
  const Pack against_slip = -task.speed, shear_yield = task.shear_yield, none = damage::no_fatigue_index;
  Pack densest = 0.0, worst = none;
  for (std::int32_t first = 0; first < region.count; first += lanes) {
    const std::int32_t count = region.count - first < lanes ? region.count - first : lanes;
    const Pack peak = load(region.peak, first, count, 0.0);
    const Mask pressed = peak > Pack(0.0);
    const Pack inverse_peak = Pack(1.0) / select(pressed, peak, 1.0);
    Pack sum = 0.0;
    for (std::int32_t i = 0; i < task.cells; ++i) {
      const std::int32_t at = i * region.count + first;
      const Pack px = load(fields.traction_x, at, count, 0.0), py = load(fields.traction_y, at, count, 0.0);
      const Pack sx = load(fields.slip_x, at, count, 0.0), sy = load(fields.slip_y, at, count, 0.0);
      const Pack density = against_slip * (sx * px + sy * py);
      sum += density;
      densest = larger(density, densest);
      store(density, task.power_density + at, count);

      const Pack excess = root(px * px + py * py) - shear_yield;
      const Pack index = (excess * inverse_peak) * Pack(task.middles->inverse_pressure[i]);
      const Pack shown = select(pressed, larger(index, none), none);
      worst = larger(shown, worst);
      store(shown, task.fatigue_index + at, count);
    }
    const Pack length = Pack(2.0) * load(region.half_length, first, count, 0.0);
    store(sum * (length / Pack(task.cells)), task.strip_power + first, count);
  }
  extremes.power_density = largest_lane(densest);
  extremes.fatigue_index = largest_lane(worst);
}

}  // namespace
}  // namespace wrc::simd
