/// The march with a layer for packs of strips: layer/layer_march.hpp over all cells.
#pragma once

#include "base/pack.hpp"
#include "tangential/layer/layer_march.hpp"
#include "tangential/march/march_grid.hpp"
#include "tangential/simd/strip_group.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// Strips first .. first + count - 1 from the leading edge to the trailing one.
template <Output output>
WRC_IN_LOOP void march_layered(const LayeredMarchTask& task, std::int32_t first, std::int32_t count,
                               Sums& total) {
  const Pack zero = 0.0, one = 1.0;
  StripGroup g;
  place(task.width, task.half_length, task.cells, first, count, g);
  g.bound = load(task.bound, first, count, 0.0);
  g.stick_cells = zero;  // counted cell by cell below
  tangential::LayeredStrip<Pack> strip;
  for (int n = 0; n < tangential::LayeredNumbers::numbers; ++n)
    strip.of[n] = load(task.numbers[n], first, count, 0.0);
  tangential::LayerState<Pack> state = tangential::fresh_state(strip);

  // cell by cell: tractions over the bound, power of sliding and flow over a cell against it
  ForceSums sums = {};
  Pack power = 0.0, stuck = 0.0;
  for (std::int32_t i = 0; i < task.cells; ++i) {
    Pack slip_x, slip_y;
    const Mask sticks = tangential::step_layer(
        strip, tangential::layer_cell(*task.shape, *task.elastic, task.cells, i), state, slip_x, slip_y);
    const Pack px = state.size * state.ex, py = state.size * state.ey;
    add_cell(px, py, sums);
    power += zero - (slip_x * px + slip_y * py);
    stuck += select(sticks, one, zero);
    if constexpr (output == Output::fields)
      store_cell(*task.fields, g, i, task.stride, g.bound * px, g.bound * py, slip_x, slip_y);
  }
  store_forces(g, task.cells, sums, task.fx, task.fy, task.mz);
  add_power(g, task.cells, stuck, g.bound * g.cell * power, total);
}

/// TangentialKernels::layered_march.
template <Output output>
void layered_march_kernel(const LayeredMarchTask& task, Sums& total) {
  total = {};
  for (std::int32_t first = 0; first < task.strips; first += lanes)
    march_layered<output>(task, first, task.strips - first < lanes ? task.strips - first : lanes, total);
}

}  // namespace
}  // namespace wrc::simd
