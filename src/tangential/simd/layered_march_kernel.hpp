/// The march with a layer for packs of strips: layer/layer_march.hpp over all cells.
#pragma once

#include "base/pack.hpp"
#include "tangential/layer/layer_march.hpp"
#include "tangential/march/march_grid.hpp"
#include "tangential/simd/strip_group.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// The first vector of a pack alone, for the last strips. A march spends its time in roots and divides, which
/// cost as much in lanes without a strip.
struct HalfPack {
  Native a;

  HalfPack() = default;
  HalfPack(Native first) : a(first) {}                       // NOLINT: numbers mix freely, as with packs
  HalfPack(double everywhere) : a(broadcast(everywhere)) {}  // NOLINT
  explicit HalfPack(Pack x) : a(x.a) {}
  explicit operator Pack() const { return {a, broadcast(0.0)}; }

  friend HalfPack operator+(HalfPack x, HalfPack y) { return x.a + y.a; }
  friend HalfPack operator-(HalfPack x, HalfPack y) { return x.a - y.a; }
  friend HalfPack operator*(HalfPack x, HalfPack y) { return x.a * y.a; }
  friend HalfPack operator/(HalfPack x, HalfPack y) { return x.a / y.a; }
  friend HalfPack operator-(HalfPack x) { return -x.a; }
};
struct HalfMask {
  NativeMask a;

  friend HalfMask operator&(HalfMask x, HalfMask y) { return {both(x.a, y.a)}; }
  friend HalfMask operator!(HalfMask x) { return {negated(x.a)}; }
};
inline HalfMask operator<(HalfPack x, HalfPack y) { return {less(x.a, y.a)}; }
inline bool any(HalfMask x) { return any_lane(x.a); }
inline HalfPack value_of(HalfPack x) { return x; }
inline HalfPack select(HalfMask m, HalfPack yes, HalfPack no) { return choose(m.a, yes.a, no.a); }
inline HalfPack root(HalfPack x) { return root_of(x.a); }
inline HalfPack larger(HalfPack x, HalfPack y) { return larger_of(x.a, y.a); }
inline HalfPack smaller(HalfPack x, HalfPack y) { return smaller_of(x.a, y.a); }

/// Strips first .. first + count - 1 from the leading edge to the trailing one, in packs or halves of them.
template <Output output, class Number>
WRC_IN_LOOP void march_layered(const LayeredMarchTask& task, std::int32_t first, std::int32_t count,
                               Sums& total) {
  const Number none = 0.0, one = 1.0;
  const Pack zero = 0.0;
  StripGroup g;
  place(task.width, task.half_length, task.cells, first, count, g);
  g.bound = load(task.bound, first, count, 0.0);
  g.stick_cells = zero;  // counted cell by cell below
  tangential::LayeredStrip<Number> strip;
  for (int n = 0; n < tangential::LayeredNumbers::numbers; ++n)
    strip.of[n] = Number(load(task.numbers[n], first, count, 0.0));
  tangential::LayerState<Number> state = tangential::fresh_state(strip);

  // cell by cell: tractions over the bound, power of sliding and flow over a cell against it
  ForceSums sums = {};
  Pack power = 0.0, stuck = 0.0;
  for (std::int32_t i = 0; i < task.cells; ++i) {
    Number along, across;
    const auto sticks = tangential::step_layer(
        strip, tangential::layer_cell(*task.shape, *task.elastic, task.cells, i), state, along, across);
    const Pack px(state.size * state.ex), py(state.size * state.ey), slip_x(along), slip_y(across);
    add_cell(px, py, sums);
    power += zero - (slip_x * px + slip_y * py);
    stuck += Pack(select(sticks, one, none));
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
  for (std::int32_t first = 0; first < task.strips; first += lanes) {
    const std::int32_t left = task.strips - first;
    if (left <= native_lanes)
      march_layered<output, HalfPack>(task, first, left, total);
    else
      march_layered<output, Pack>(task, first, left < lanes ? left : lanes, total);
  }
}

}  // namespace
}  // namespace wrc::simd
