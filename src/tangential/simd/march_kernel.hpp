/// The march of march.hpp for packs of strips, and its derivatives with respect to the creepages.
///
/// Along a strip everything is relative: distances t from the leading edge to the half length (0 .. 2, cells
/// h = 2 / cells), tractions to the bound at the strip's middle. Then cells and the shape of the bound are
/// the same for all strips, and a strip is three numbers, the growth (gx, gy - rate t) of its adhesion
/// tractions.
///
/// The state is the direction e of the traction, the traction, and where in a step the slip is seen; a step
/// takes one root and two divides (turning.hpp). Only a cell in which some lane sticks again takes more of
/// them, and those from which on all lanes have left their first stick zones do without selecting lanes.
///
/// Derivatives: in slip the state is one angle, whose change is carried for each input, and `ahead`.
///
///     symbol (theory.md)    here                          unit
///     v                     t                             half lengths, 0 at the leading edge
///     g, phi / L23          (gx, gy), rate                bound / half length
///     p / tau, e            size (ex, ey) over bound      -
///     lambda                lambda                        excess of growth over a cell, bound
#pragma once

#include "base/pack.hpp"
#include "tangential/simd/march_groups.hpp"
#include "tangential/simd/march_start.hpp"
#include "tangential/simd/strip_group.hpp"
#include "tangential/simd/tasks.hpp"
#include "tangential/simd/turning.hpp"

namespace wrc::simd {
namespace {

/// A march step: its numbers up to the turn, and its results for fields and derivatives.
struct MarchStep {
  Pack share;                     ///< part of the cell that is slip
  Pack whole_y, bend;             ///< growth along y over a whole cell; its fall along the step
  Pack size_before, size;         ///< traction before and after
  Pack trial_x, trial_y, trial2;  ///< traction if the cell sticks, and its square
  Mask stick;
  bool any_sticks;
  Pack inverse_trial;  ///< one over the traction of lanes that stick
  Pack lambda;         ///< excess of growth over that of the bound, over a whole cell, in slip
  Turn turn;
};

/// One march step of a group, up to the turn of its direction. With `entering`, lanes may still be in their
/// first stick zone or just leave it; the others are `moving`. No lane's numbers depend on the other lanes.
template <bool entering>
WRC_IN_LOOP MarchStep begin_step(const Group& g, const Cell& cell, Mask moving, const State& s) {
  // growth over the step, and the tractions it starts from; at the onset only part of a cell is stepped over
  MarchStep step;
  Pack x = g.over_cell.x, bound_before = cell.bound_before;
  step.whole_y = g.over_cell.y - g.over_cell.rate * cell.t;
  Pack y = step.whole_y;
  step.bend = g.over_cell.bend;
  step.size_before = s.stuck ? s.size : bound_before;
  if constexpr (entering) {
    step.share = share_of_cell(g, cell.index + 0.5);
    x = step.share * x;
    y = step.share * y;
    step.bend = (step.share * step.share) * step.bend;
    const Mask begins = Pack(cell.index - 0.5) < g.stick_cells;
    bound_before = select(begins, g.onset_bound, bound_before);
    step.size_before = select(begins, g.onset_bound, step.size_before);
  }
  // Kalker's criterion: a cell sticks if the traction p - growth is within the bound. The growth is its mean
  // over the step, half the bend ahead of the cell.
  step.trial_x = step.size_before * s.ex - x;
  step.trial_y = step.size_before * s.ey - (y + 0.5 * step.bend);
  step.trial2 = step.trial_x * step.trial_x + step.trial_y * step.trial_y;
  step.stick = step.trial2 <= cell.bound * cell.bound;
  if constexpr (entering) step.stick = step.stick & moving;
  step.any_sticks = any(step.stick);
  // otherwise the traction turns against the growth, resisted by the mean bound (twice it: turning.hpp)
  step.turn = begin_turn(x, y + step.bend * s.ahead, bound_before + cell.bound, s.ex, s.ey);
  return step;
}

/// Flexibility along a traction of the direction ex; of strips that each have their own, relative.
WRC_IN_LOOP Pack softness(const MarchTask& task, const Group&, Pack ex) {
  return task.l22 + (task.l11 - task.l22) * (ex * ex);
}
WRC_IN_LOOP Pack softness(const SurfaceMarchTask&, const Group& g, Pack ex) {
  return g.soft_y + (g.soft_x - g.soft_y) * (ex * ex);
}

/// The rest of a step: state, traction and power of the cell.
template <bool entering, class Task>
WRC_IN_LOOP void end_step(const Task& task, const Group& g, const Cell& cell, Mask moving, MarchStep& step,
                          State& s, GroupSums& sums) {
  const Pack zero = 0.0, one = 1.0;
  const Pack bound = entering ? select(moving, Pack(cell.bound), zero) : Pack(cell.bound);  // zero: no part
  // In slip the traction is the bound, and the excess lambda of growth along e over the rise of the bound is
  // slip: -rise - g.e, at least 0.
  Pack ex = step.turn.ex, ey = step.turn.ey;
  step.size = bound;
  step.lambda = larger(zero, -cell.rise - (g.over_cell.x * ex + step.whole_y * ey));
  if constexpr (entering) step.lambda = onset_part(step.share) * step.lambda;
  // Lanes that stick: the trial traction itself, without slip. A traction that vanishes keeps the direction.
  s.stuck = step.any_sticks;
  if (step.any_sticks) {
    s.size = step.size = select(step.stick, root(step.trial2), bound);
    const Mask turns = step.stick & (step.size > 1e-150);
    step.inverse_trial = one / select(turns, step.size, one);
    ex = select(turns, step.trial_x * step.inverse_trial, ex);
    ey = select(turns, step.trial_y * step.inverse_trial, ey);
    step.lambda = select(step.stick, zero, step.lambda);
    sums.unslid += select(step.stick, entering ? onset_part(step.share) : one, zero);
  }
  // state of the lanes that moved; lanes without bound add nothing to the sums
  s.ex = entering ? select(moving, ex, s.ex) : ex;
  s.ey = entering ? select(moving, ey, s.ey) : ey;
  s.ahead = entering ? select(moving, step.turn.ahead, s.ahead) : step.turn.ahead;
  add_cell(step.size * ex, step.size * ey, sums.force);
  sums.power += (step.lambda * bound) * softness(task, g, ex);
}

/// The same step for the derivatives; `before`: the state it began with.
template <bool entering>
WRC_IN_LOOP void differentiate(const Group& g, const Cell& cell, Mask moving, const State& before,
                               const State& after, const MarchStep& step,
                               GroupDerivative (&derivative)[inputs]) {
  const Pack zero = 0.0;
  // as far as the inputs share it: how the turn changes with the growth over it, and the traction
  const TurnSlopes slope = slopes(step.turn, before.ex, before.ey);
  const Pack px = step.size * after.ex, py = step.size * after.ey;
  [[maybe_unused]] const Mask begins = Pack(cell.index - 0.5) < g.stick_cells;
  for (std::int32_t k = 0; k < inputs; ++k) {
    // change of the growth over the step, of the bound and of the traction before it; at the onset also by
    // the share of the cell that is slip
    GroupDerivative& d = derivative[k];
    Pack x = d.over_cell.x, y = d.over_cell.y, bend = d.over_cell.bend;
    if (k == 2) y += -(d.over_cell.rate * cell.t);  // only spin changes the growth along a strip
    Pack bound_before = zero, size_before = before.stuck ? d.size : zero;
    if constexpr (entering) {
      const Pack share = select((step.share > zero) & (step.share < 1.0), -(d.onset * cell.per_h), zero);
      x = step.share * x + share * g.over_cell.x;
      y = step.share * y + share * (g.over_cell.y - g.over_cell.rate * cell.t);
      bend = step.share * (step.share * bend + 2.0 * share * g.over_cell.bend);
      bound_before = select(begins, d.onset_bound, zero);
      size_before = select(begins, d.onset_bound, size_before);
    }
    // the turned angle, and `ahead`, by the chain rule over turn()
    Pack Vy = y + step.bend * d.ahead;
    if (entering || k == 2) Vy += bend * before.ahead;
    Pack angle = slope.kept * d.angle + slope.by_y * Vy;
    Pack ahead = slope.ahead_by_y * Vy;
    if (entering || k != 1) {  // the lateral creepage has no part in the growth along x
      angle += slope.by_x * x;
      ahead += slope.ahead_by_x * x;
    }
    if constexpr (entering) {
      angle += slope.by_d * bound_before;
      ahead += slope.ahead_by_d * bound_before;
    }
    // Lanes that stick: the trial traction p - growth changes in size along e and in angle across it.
    if (before.stuck) d.size = zero;
    if (step.any_sticks) {
      const Pack turned = step.size_before * d.angle;
      const Pack trial_x = size_before * before.ex - turned * before.ey - x;
      const Pack trial_y = size_before * before.ey + turned * before.ex - (y + 0.5 * bend);
      d.size = select(step.stick, after.ex * trial_x + after.ey * trial_y, zero);
      angle = select(step.stick, (after.ex * trial_y - after.ey * trial_x) * step.inverse_trial, angle);
    }
    // the cell's traction: p d(angle) across e, and where it sticks d(size) along it
    d.angle = entering ? select(moving, angle, d.angle) : angle;
    d.ahead = entering ? select(moving, ahead, d.ahead) : ahead;
    Pack dpx = -(py * angle), dpy = px * angle;
    if (step.any_sticks) {
      dpx += d.size * after.ex;
      dpy += d.size * after.ey;
    }
    add_cell(dpx, dpy, d.force);
  }
}

/// Tractions of full adhesion in a cell.
inline void first_stick(const Group& g, const Cell& cell, Pack& px, Pack& py) {
  adhesion(g.gx, g.gy, g.rate, cell.t, cell.h, px, py);
  const Pack share = select(Pack(cell.index + 1.5) < g.stick_cells, 1.0, g.last_share);
  px = share * px;
  py = share * py;
}

/// A group of strips during the march.
struct Marching {
  Group group;
  State state;
  GroupSums sums;
  Pack slip_x, slip_y;  ///< slip [-] over the excess of growth and the direction of the traction; for fields
};

/// The part of a cell behind the turn: rest of the step, derivatives, fields.
template <bool entering, Output output, class Task>
WRC_IN_LOOP void settle(const Task& task, const Cell& cell, Mask moving, MarchStep& step, Marching& m,
                        GroupDerivative (&derivative)[inputs]) {
  constexpr bool sensitivities = output == Output::sensitivities;
  [[maybe_unused]] State before;
  if constexpr (sensitivities) before = m.state;
  end_step<entering>(task, m.group, cell, moving, step, m.state, m.sums);
  if constexpr (sensitivities)
    differentiate<entering>(m.group, cell, moving, before, m.state, step, derivative);
  if constexpr (output != Output::fields) return;
  // fields: tractions, and the slip lambda e times flexibility, against the traction; strips still in their
  // first stick zone have its tractions
  const State& s = m.state;
  Pack px = step.size * s.ex, py = step.size * s.ey, excess = step.lambda;
  if constexpr (entering) {
    Pack stick_x, stick_y;
    first_stick(m.group, cell, stick_x, stick_y);
    px = select(moving, px, stick_x);
    py = select(moving, py, stick_y);
    excess = select(moving, excess, 0.0);
  }
  store_cell(*task.fields, m.group, cell.index, task.strips, m.group.bound * px, m.group.bound * py,
             0.0 - excess * s.ex * m.slip_x, 0.0 - excess * s.ey * m.slip_y);
}

/// The fields of the cells that lie in the first stick zones of all strips of a group.
inline void store_first_stick(const MarchCells& task, const Group& g) {
  const double h = 2.0 / task.cells, per_h = 0.5 * task.cells;
  for (std::int32_t i = 0; i < g.all_stick; ++i) {
    const Cell cell{i, (i + 0.5) * h, 0.0, 0.0, 0.0, h, per_h};
    Pack px, py;
    first_stick(g, cell, px, py);
    store_cell(*task.fields, g, i, task.strips, g.bound * px, g.bound * py, 0.0, 0.0);
  }
}

/// Slip over the excess of growth, for fields: a cell's growth divided by its length, times flexibility [-].
inline void set_slip(const MarchTask& task, double per_h, Marching& m) {
  m.slip_x = per_h * task.l11 * m.group.stiffness;
  m.slip_y = per_h * task.l22 * m.group.stiffness;
}
inline void set_slip(const SurfaceMarchTask&, double per_h, Marching& m) {
  m.slip_x = per_h * m.group.soft_x;
  m.slip_y = per_h * m.group.soft_y;
}

/// Adds a group's strips to the sums; power: lambda tau (L11 e_x^2 + L22 e_y^2) over the area [N].
inline void finish(const MarchTask& task, double per_h, const Marching& m, Sums& total) {
  const Pack power = m.group.bound * m.group.cell * (per_h * m.group.stiffness) * m.sums.power;
  add_forces(m.group, task.cells, m.sums.force, total);
  add_power(m.group, task.cells, m.sums.unslid, power, total);
}
inline void finish(const SurfaceMarchTask& task, double per_h, const Marching& m, Sums& total) {
  const Pack power = m.group.bound * m.group.cell * per_h * m.sums.power;
  store_forces(m.group, task.cells, m.sums.force, task.fx, task.fy, task.mz);
  add_power(m.group, task.cells, m.sums.unslid, power, total);
}

/// The parts of march_groups() that are this march's own.
template <Output output, class Task>
struct March {
  using Marching = simd::Marching;
  using Derivative = GroupDerivative;
  static constexpr std::int32_t inputs = simd::inputs, in_flight = simd::in_flight;
  static constexpr bool stays = false;  // first stick zones in closed form
  static constexpr bool sensitivities = output == Output::sensitivities;

  const Task& task;
  Sums& total;
  double h, per_h;

  void prepare(std::int32_t at, std::int32_t count, Marching& m, Derivative (&derivative)[inputs]) const {
    simd::prepare(task, at, count, m.group, m.state, m.sums);
    if constexpr (output == Output::fields) {
      set_slip(task, per_h, m);
      store_first_stick(task, m.group);
    }
    if constexpr (sensitivities) {
      for (std::int32_t k = 0; k < inputs; ++k) differentiate(task, k, m.group, derivative[k]);
    }
  }
  Cell cell(std::int32_t i) const {
    const double* const mean = task.shape->mean;
    return {i, (i + 0.5) * h, i > 0 ? mean[i - 1] : 0.0, mean[i], task.shape->rise[i], h, per_h};
  }
  void finish(const Marching& m, const Derivative (&derivative)[inputs]) const {
    simd::finish(task, per_h, m, total);
    if constexpr (sensitivities) {
      for (std::int32_t n = 0; n < inputs; ++n)
        add_derivative(m.group, task.cells, derivative[n].force, n, total);
    }
  }
};

template <Output output, class Task>
void march_kernel(const Task& task, Sums& total) {
  total = {};
  march_groups<output>(task, March<output, Task>{task, total, 2.0 / task.cells, 0.5 * task.cells});
}

}  // namespace
}  // namespace wrc::simd
