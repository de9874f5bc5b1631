/// Derivatives of strip FASTSIM where every strip has numbers of its own: by each of those numbers
/// (SurfaceStripInput), strip by strip.
///
/// The steps and their derivatives are those of strip_fastsim_step.hpp and strip_fastsim_slopes.hpp. The
/// place where an input enters a step is known at compile time: parts that are zero cost nothing.
#pragma once

#include "tangential/simd/strip_fastsim_kernel.hpp"
#include "tangential/simd/strip_fastsim_slopes.hpp"

namespace wrc::simd {
namespace {

namespace strip {

/// Derivatives by an input: of the onset of slip, of the state, of the sums.
struct InputChanges {
  Pack slip_end, kappa, lambda, psi, form;
  Pack angle, ratio, ahead;
  ForceSums force;
};

template <std::int32_t input>
struct InputNumber {
  static constexpr std::int32_t number = input;
};

/// Calls act(InputNumber<k>) for every input.
template <std::int32_t first = 0, class Act>
WRC_IN_LOOP void for_inputs(const Act& act) {
  if constexpr (first < strip_inputs) {
    act(InputNumber<first>{});
    for_inputs<first + 1>(act);
  }
}

/// Derivatives of the numbers that prepare() sets.
inline void differentiate(const SurfaceStripsTask& task, const Group& g,
                          InputChanges (&changes)[strip_inputs]) {
  const Pack zero = 0.0, one = 1.0;
  const Onset onset(g);
  const EdgeDirection edge(g);
  // start_against_slip(): share = t^2 (3 - 2 t), d(share) / d(u_s) = 6 t (1 - t) cells / 2; the chord from
  // the direction of growth to that of the edge
  const Pack share = start_against_slip(task, g.slip_end);
  const Pack t = larger(zero, one - (0.5 * task.cells) * (2.0 - g.slip_end));
  const Pack share_by_end = select(t > zero, (3.0 * task.cells) * (t * (one - t)), zero);
  const Pack inverse = one / (root(g.gx * g.gx + onset.c * onset.c) + 1e-100);
  const Pack grown_x = -(g.gx * inverse), grown_y = -(onset.c * inverse);
  const Pack edge_x = -edge.x[EdgeDirection::substitutions - 1],
             edge_y = -edge.y[EdgeDirection::substitutions - 1];
  const Angle between(grown_x + share * (edge_x - grown_x), grown_y + share * (edge_y - grown_y));
  for_inputs([&](auto which) {
    constexpr std::int32_t k = decltype(which)::number;
    InputChanges& d = changes[k];
    d = {};
    if constexpr (k <= strip_curvature) {
      onset.differentiate(g, k == strip_growth_x ? 1.0 : 0.0, k == strip_growth_y ? 1.0 : 0.0,
                          k == strip_curvature ? 1.0 : 0.0, d);
    }
    // angle at the edge by the slips; then of the point on the chord, whose ends turn and which moves along
    // it
    Pack at_edge = zero;
    if constexpr (k == strip_slip_x) at_edge = edge.change(g, 1.0, 0.0, 0.0);
    if constexpr (k == strip_slip_y || k == strip_spin) at_edge = edge.change(g, 0.0, 1.0, 0.0);
    if constexpr (k == strip_elastic) at_edge = edge.change(g, 0.0, 0.0, 1.0);
    const Pack turned = share_by_end * d.slip_end;
    const Pack of_growth = (one - share) * d.angle, of_edge = share * at_edge;
    const Pack x = turned * (edge_x - grown_x) - (of_growth * grown_y + of_edge * edge_y);
    const Pack y = turned * (edge_y - grown_y) + (of_growth * grown_x + of_edge * edge_x);
    d.angle = select(share > zero, between.change(x, y), d.angle);
  });
}

/// A step for the derivatives; `before`: the state it began with.
template <bool entering>
WRC_IN_LOOP void differentiate(const Group& g, const Cell& cell, Mask moving, const State& before,
                               const State& after, const MarchStep& step,
                               InputChanges (&changes)[strip_inputs]) {
  const StepSlopes s = step_slopes<entering>(g, cell, before, step);
  const CellMeans means = cell_means<entering>(g, cell, moving, after, step);
  const double h = cell.h;
  for_inputs([&](auto which) {
    constexpr std::int32_t k = decltype(which)::number;
    InputChanges& d = changes[k];
    // chain rule over the turn: by the state before, then by the input's own part in slip and flexibility
    const Pack bent = s.bend * d.ahead;
    Pack angle = s.kept * d.angle + s.by_y * bent;
    Pack ahead = s.ahead_by_angle * d.angle + s.ahead_by_y * bent;
    Pack x = 0.0, y = 0.0;  // change of the slip over a whole cell
    if constexpr (k == strip_slip_x) x = h;
    if constexpr (k == strip_slip_y) y = h;
    if constexpr (k == strip_spin) y = h * cell.x + (h * h) * s.ahead_before;
    if constexpr (k == strip_elastic) {
      x = (h * cell.x) * step.rho_x;
      y = (-h * cell.x) * step.rho_y;
    }
    if constexpr (k == strip_slip_x || k == strip_elastic) {
      angle += s.by_x * x;
      ahead += s.ahead_by_x * x;
    }
    if constexpr (k == strip_slip_y || k == strip_spin || k == strip_elastic) {
      angle += s.by_y * y;
      ahead += s.ahead_by_y * y;
    }
    if constexpr (k == strip_turn_x) {
      angle += s.by_t11;
      ahead += s.ahead_by_t11;
    }
    if constexpr (k == strip_turn_y) {
      angle += s.by_t22;
      ahead += s.ahead_by_t22;
    }
    // only growths move the onset; the traction before counts where it was below the bound
    constexpr bool onset = entering && k <= strip_curvature;
    if constexpr (onset) {
      angle += s.by_onset * d.slip_end;
      ahead += s.ahead_by_onset * d.slip_end;
    }
    if (before.stuck) {
      angle += s.by_ratio * d.ratio;
      ahead += s.ahead_by_ratio * d.ratio;
    }
    // lanes that stick: the traction by its growth over the cell
    Pack ratio = 0.0;
    if (step.any_sticks) {
      const Growth over_cell{k == strip_growth_x ? h : 0.0, k == strip_growth_y ? h : 0.0,
                             k == strip_curvature ? h : 0.0};
      stick_derivative<onset>(g, s, cell, before, after, step, over_cell, d, ratio, angle);
    }
    end_derivative<entering, onset>(g, moving, before, after, step, means, ratio, angle, ahead, d);
  });
}

/// The part of a cell behind the turn: settle() of strip_fastsim_kernel.hpp for these derivatives.
template <bool entering, Output output>
WRC_IN_LOOP void settle(const StripFastsimMarch&, const Cell& cell, Mask moves, MarchStep& step, Marching& m,
                        InputChanges (&changes)[strip_inputs]) {
  const State before = m.state;
  if constexpr (entering) step.shape = stick_shape<true>(m.group, cell, m.stick);
  end_step<entering>(m.group, cell, moves, step, m.state, m.sums);
  differentiate<entering>(m.group, cell, moves, before, m.state, step, changes);
  if constexpr (entering)
    stick<true, true>(m.group, cell, moves, step.shape, false, m.stick, m.sums, changes);
}

/// See march_groups().
struct SlopesMarch {
  using Marching = strip::Marching;
  using Derivative = InputChanges;
  static constexpr std::int32_t inputs = strip_inputs, in_flight = 1;  // the inputs' work fills the waiting
  static constexpr bool stays = true;

  const SurfaceStripsSlopesTask& task;

  void prepare(std::int32_t at, std::int32_t count, Marching& m, InputChanges (&changes)[inputs]) const {
    const SurfaceStripsTask& strips = task;
    strip::prepare(strips, at, count, m.group, m.state);
    m.stick = first_stick_sums(task, m.group);
    m.sums = {};
    differentiate(strips, m.group, changes);
  }
  Cell cell(std::int32_t i) const { return cell_of(task, i); }
  void stay(const Cell& cell, Marching& m, InputChanges (&changes)[inputs]) const {
    const Mask none = Pack(0.0) < Pack(0.0);
    const StickShape shape = stick_shape<true>(m.group, cell, m.stick);
    stick<false, true>(m.group, cell, none, shape, false, m.stick, m.sums, changes);
  }
  void finish(Marching& m, InputChanges (&changes)[inputs]) const {
    // rows of `slopes`: fx, fy, mz by each input
    add_stick(m.group, m.stick, m.sums);
    store_forces(m.group, task.cells, m.sums.force, task.fx, task.fy, task.mz);
    for (std::int32_t k = 0; k < inputs; ++k) {
      add_stick_derivative(m.group, m.stick, changes[k]);
      double* const row = task.slopes + 3 * k * task.strips;
      store_forces(m.group, task.cells, changes[k].force, row, row + task.strips, row + 2 * task.strips);
    }
  }
};

}  // namespace strip

/// TangentialKernels::surface_strips_slopes.
void surface_strips_slopes_kernel(const SurfaceStripsSlopesTask& task) {
  march_groups<Output::sensitivities>(task, strip::SlopesMarch{task});
}

}  // namespace
}  // namespace wrc::simd
