/// Place and pressure of the cells for the instruction set of the unit: one strip per lane.
#pragma once

#include "base/pack.hpp"
#include "tangential/march/march_grid.hpp"
#include "tangential/problem.hpp"

namespace wrc::simd {
namespace {

inline void place_cells_kernel(const Strips& region, const MarchGrid& grid, double* x, double* pressure) {
  for (std::int32_t first = 0; first < region.count; first += lanes) {
    const std::int32_t count = region.count - first < lanes ? region.count - first : lanes;
    const Pack centre = load(region.centre, first, count, 0.0);
    const Pack half_length = load(region.half_length, first, count, 0.0);
    const Pack peak = load(region.peak, first, count, 0.0);
    for (std::int32_t i = 0; i < grid.cells; ++i) {
      const std::int32_t at = i * region.count + first;
      store(centre + Pack(grid.middles.place[i]) * half_length, x + at, count);
      store(Pack(grid.middles.pressure[i]) * peak, pressure + at, count);
    }
  }
}

}  // namespace
}  // namespace wrc::simd
