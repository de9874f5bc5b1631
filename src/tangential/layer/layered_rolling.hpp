/// Patches of strips with a layer: the march over all of them, their forces and
/// derivatives.
#pragma once

#include "base/dual.hpp"
#include "patch/strips.hpp"
#include "tangential/layer/layer_march.hpp"
#include "tangential/march/march_grid.hpp"
#include "tangential/problem.hpp"

namespace wrc::tangential {

/// Creepages, and a factor on tau_0. With derivatives by all four those by load
/// and friction follow: tractions, slips and tau_0 multiplied by one number
/// stay a solution.
template <class Number>
struct LayeredInputs {
  Number longitudinal, lateral, spin, yield;
};
using LayeredDual = Dual<4>;

inline LayeredInputs<double> layered_inputs(const Creepage& c) {
  return {c.longitudinal, c.lateral, c.spin, 1.0};
}

inline LayeredInputs<LayeredDual> layered_inputs_varied(const Creepage& c) {
  return {LayeredDual::input(c.longitudinal, 0), LayeredDual::input(c.lateral, 1),
          LayeredDual::input(c.spin, 2), LayeredDual::input(1.0, 3)};
}

/// A strip, with the bound mu p at its middle [Pa].
template <class Number>
struct LayeredStripAt {
  LayeredStrip<Number> numbers;
  Number bound;
};

/// The slip that bodies and the layer's spring, one after the other, take from
/// particles that stick: the mean by their flexibilities.
template <class Number>
Number slip_in_series(const Number& bodies, const Number& of_bodies, const Number& spring,
                      const Number& rigid) {
  constexpr double least = 1e-100;  // neither gives way
  return (bodies * of_bodies + spring * rigid) / (bodies + (spring + least));
}

/// Sets yield and hardening of a strip of half length l; `factor` on tau_0.
template <class Number, class Length, class OfLayer>
void set_yield(const LayerOf<OfLayer>& layer, const Number& factor, const Length& l,
               LayeredStripAt<Number>& strip) {
  constexpr double never = 1e30, least_bound = 1e-6;  // [-], [Pa]
  const Number per_bound = Number(1.0) / larger(strip.bound, Number(least_bound));
  strip.numbers.of[LayeredNumbers::yield] =
      value_of(layer.yield) > 0.0 ? Number(layer.yield * per_bound * factor) : Number(never);
  strip.numbers.of[LayeredNumbers::hardening] = layer.hardening * per_bound * l;
}

/// Sums of tractions over a strip: force = bound * half length * width * (x,
/// y), and the moment about its middle the same times half length * turn.
template <class Number>
struct LayeredSum {
  Number x, y, turn;
};

/// Marches over one strip.
template <class Number>
LayeredSum<Number> march_strip(const LayeredStrip<Number>& strip, const BoundShape& shape,
                               const MarchGrid& grid) {
  LayerState<Number> state = fresh_state(strip);
  LayeredSum<Number> sum{0.0, 0.0, 0.0};
  Number slip_x, slip_y;
  for (std::int32_t i = 0; i < grid.cells; ++i) {
    step_layer(strip, layer_cell(shape, grid.parabolic, grid.cells, i), state, slip_x, slip_y);
    sum.x += state.size * state.ex;
    sum.y += state.size * state.ey;
    sum.turn += grid.middles.place[i] * (state.size * state.ey);
  }
  const double h = 2.0 / grid.cells;
  return {h * sum.x, h * sum.y, h * sum.turn};
}

/// As many strips as a kernel takes at a time at most.
inline constexpr std::int32_t layered_block = 16;

/// Numbers of some strips, side by side, and their forces about their own
/// middles.
struct LayeredBlock {
  double number[LayeredNumbers::numbers][layered_block];
  double bound[layered_block];
  double fx[layered_block], fy[layered_block], mz[layered_block];

  void put(std::int32_t k, const LayeredStripAt<double>& strip) {
    for (int n = 0; n < LayeredNumbers::numbers; ++n) number[n][k] = strip.numbers.of[n];
    bound[k] = strip.bound;
  }
};

/// All strips; fields are theirs.
struct LayeredRun {
  std::int32_t strips;
  const double *width, *half_length;  ///< [m]
  const BoundShape& shape;
  const MarchGrid& grid;
  const TangentialFields& fields;
};

/// Areas and the power of the march over the strips so far.
struct LayeredTotals {
  double power_per_speed = 0.0;        ///< [N]
  double area = 0.0, slid_area = 0.0;  ///< [m^2]

  double adhesion_fraction() const { return area > 0.0 ? 1.0 - slid_area / area : 0.0; }
};

/// Marches over the strips first .. first + count - 1.
void march_block(const LayeredRun& run, std::int32_t first, std::int32_t count, LayeredBlock& block,
                 LayeredTotals& totals);

/// Marches over all strips: strip_of(j) gives each, and take(j, fx, fy, mz) its
/// forces.
template <class StripOf, class Take>
LayeredTotals march_all(const LayeredRun& run, const StripOf& strip_of, const Take& take) {
  LayeredTotals totals;
  for (std::int32_t first = 0; first < run.strips; first += layered_block) {
    const std::int32_t some = run.strips - first < layered_block ? run.strips - first : layered_block;
    LayeredBlock block;
    for (std::int32_t k = 0; k < some; ++k) block.put(k, strip_of(first + k));
    march_block(run, first, some, block, totals);
    for (std::int32_t k = 0; k < some; ++k) take(first + k, block.fx[k], block.fy[k], block.mz[k]);
  }
  return totals;
}

/// Power of forces that work by the rigid slips. In steady rolling all of it is
/// dissipated: springs give back at the trailing edge as much as they took. The
/// fields' slips are scaled to it.
double balanced_power(const LayeredRun& run, const LayeredTotals& totals, double work);

/// The patch, apart from its strips' numbers.
struct LayeredPatch {
  const patch::Strips& region;
  const Creepage& creepage;
  double friction;          ///< mean over the load [-]
  const BoundShape& shape;  ///< form of the bound along a strip
  const MarchGrid& grid;
};

/// Adds a strip's derivatives.
void add_sensitivities(const LayeredPatch& patch, const LayeredStripAt<LayeredDual>& strip, std::int32_t j,
                       TangentialSensitivities& sums);

/// The columns of load and friction, from those of the creepages and of tau_0,
/// which stands in the last.
void finish(const LayeredPatch& patch, const TangentialForces& forces, TangentialSensitivities& sums);

/// Rolls a patch: `strip_of(inputs, j)` gives the strips, for inputs with
/// derivatives or without.
template <class StripOf>
TangentialForces roll_layered(const LayeredPatch& patch, const TangentialFields& fields,
                              TangentialSensitivities* sensitivities, const StripOf& strip_of) {
  const patch::Strips& region = patch.region;
  const Creepage& c = patch.creepage;
  const LayeredRun run{region.count, region.width, region.half_length, patch.shape, patch.grid, fields};
  const LayeredInputs<double> inputs = layered_inputs(c);
  // moments about the origin of the patch: M = M_j + x_j F_y - y_j F_x
  TangentialForces forces;
  const LayeredTotals totals = march_all(
      run, [&](std::int32_t j) { return strip_of(inputs, j); },
      [&](std::int32_t j, double fx, double fy, double mz) {
        forces.fx += fx;
        forces.fy += fy;
        forces.mz += mz + region.centre[j] * fy - region.y[j] * fx;
      });
  forces.power_per_speed = balanced_power(
      run, totals, 0.0 - (forces.fx * c.longitudinal + forces.fy * c.lateral + forces.mz * c.spin));
  forces.adhesion_fraction = totals.adhesion_fraction();
  if (sensitivities == nullptr) return forces;

  // derivatives, strip by strip
  const LayeredInputs<LayeredDual> varied = layered_inputs_varied(c);
  *sensitivities = {};
  for (std::int32_t j = 0; j < region.count; ++j)
    add_sensitivities(patch, strip_of(varied, j), j, *sensitivities);
  finish(patch, forces, *sensitivities);
  return forces;
}

}  // namespace wrc::tangential
