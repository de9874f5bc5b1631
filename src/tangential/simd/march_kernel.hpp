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
#include "tangential/march/march_grid.hpp"
#include "tangential/march/stick_zone.hpp"
#include "tangential/simd/march_groups.hpp"
#include "tangential/simd/strip_group.hpp"
#include "tangential/simd/tasks.hpp"
#include "tangential/simd/turning.hpp"

namespace wrc::simd {
namespace {

/// Growth of the tractions of full adhesion over a cell at t: (x, y - rate t); `bend` is its fall along y
/// from the cell's leading border to its trailing one.
struct Growth {
  Pack x, y, rate, bend;
};

/// Constants of the strips of a group.
struct Group : StripGroup {
  Pack gx, gy, rate;  ///< growth of adhesion tractions: (gx, gy - rate t)
  Growth over_cell;
  Pack onset;           ///< t at which the first stick zone ends
  Pack onset_cells;     ///< the same in cells
  Pack onset_bound;     ///< bound there
  Pack last_share;      ///< share of the last stick cell's tractions that is within the bound
  Pack stiffness;       ///< bound / half length: unit of growth [Pa/m]
  Pack soft_x, soft_y;  ///< flexibility times that, of strips that each have their own [-]
};

/// State that the march carries from cell to cell.
struct State {
  Pack ex, ey;  ///< direction of the traction
  Pack ahead;   ///< part of a step ahead of the cell where the slip is seen (turning.hpp)
  bool stuck;   ///< in some lane the traction is below the bound:
  Pack size;    ///< then the size of it in each lane, else not set
};

struct GroupSums {
  ForceSums force;
  Pack power;   ///< power of the slip over a cell against the bound
  Pack unslid;  ///< cells behind the first stick zone that have not slid
};

/// Derivatives with respect to one input.
struct GroupDerivative {
  Pack gx, gy, rate, onset, onset_bound;
  Growth over_cell;
  Pack angle, size, ahead;  ///< state: angle of e, traction (zero where it is the bound), ahead
  ForceSums force;
};

/// A cell, the same for all strips.
struct Cell {
  std::int32_t index;
  double t;             ///< at its middle
  double bound_before;  ///< bound of the cell before
  double bound;         ///< mean over the cell
  double rise;          ///< growth of the bound along the cell
  double h, per_h;      ///< length, and one over it
};

/// Bound at t.
inline Pack bound_at(const MarchCells& task, Pack t) {
  const Pack shape = t * (2.0 - t);
  return task.parabolic ? shape : root(larger(0.0, shape));
}

inline Growth growth_over(Pack gx, Pack gy, Pack rate, double h) {
  return {h * gx, h * gy, h * rate, (h * h) * rate};
}

/// Mean over a cell around t of the tractions of full adhesion.
inline void adhesion(Pack gx, Pack gy, Pack rate, Pack t, double h, Pack& px, Pack& py) {
  px = -(gx * t);
  py = -(gy * t - 0.5 * rate * (t * t + h * h / 12.0));
}

/// Sums of the tractions of full adhesion over the first n cells.
inline void adhesion_sums(Pack gx, Pack gy, Pack rate, Pack n, double h, Pack& px, Pack& py, Pack& t_py) {
  // Sums over the cells i < n, at t = (i + 1/2) h, of adhesion()'s powers of t: each a polynomial in n.
  const Pack n2 = n * n;
  const Pack of_t = 0.5 * h * n2;                                  // sum of t
  const Pack of_t2 = (h * h / 3.0) * (n2 * n);                     // sum of t^2 + h^2/12
  const Pack of_t_t = of_t2 - (h * h / 12.0) * n;                  // sum of t t
  const Pack of_t_t2 = (h * h * h / 12.0) * (3.0 * n2 * n2 - n2);  // sum of t (t^2 + h^2/12)
  px = -(gx * of_t);
  py = -(gy * of_t - 0.5 * rate * of_t2);
  t_py = -(gy * of_t_t - 0.5 * rate * of_t_t2);
}

/// The cell of each lane that is its last in the first stick zone: t at its middle, its bound.
inline void last_stick_cell(const MarchCells& task, const Group& g, double h, Pack& t, Pack& bound) {
  double cells[lanes], bounds[lanes];
  store_pack(cells, g.stick_cells);
  for (std::int32_t k = 0; k < lanes; ++k) {
    const auto last = static_cast<std::int32_t>(cells[k]) - 1;
    bounds[k] = task.shape->mean[last < 0 ? 0 : last];
  }
  bound = load_pack(bounds);
  t = (g.stick_cells - 0.5) * h;
}

/// Part that is slip of the step to the cell whose middle lies `middle` cells from the leading edge.
inline Pack share_of_cell(const Group& g, Pack middle) {
  return larger(0.0, smaller(1.0, middle - g.onset_cells));
}

/// Cells for which the slip of a cell stands: behind the onset everything slid since then, half a cell to one
/// and a half; elsewhere one.
inline Pack onset_part(Pack share) { return select(share < 1.0, 0.5 + share, 1.0); }

/// Reads the numbers of a group's strips from the task.
inline void read_strips(const MarchTask& task, std::int32_t first, std::int32_t count, Group& g) {
  constexpr double tiny_stress = 1e-6;  // [Pa]: frictionless strips slip at once without a division by zero
  // Bound at the middle of the strips [Pa], by one of its three forms; growth [Pa/m] over bound / half
  // length.
  const patch::Strips& strips = *task.region;
  place(strips, task.cells, first, count, g);
  const Pack share = task.shares ? load(task.shares, first, count, 0.0) : Pack(1.0);
  g.bound = (task.per_pressure * load(strips.peak, first, count, 0.0) + task.per_length * g.half_length +
             task.per_length_square * g.half_length * g.half_length) *
            share;
  g.stiffness = g.bound / g.half_length;
  const Pack scale = g.half_length / (g.bound + tiny_stress);
  g.gx = (task.gx_constant.value - task.gx_by_y.value * g.y) * scale;
  g.gy = (task.gy_constant.value + task.gy_by_x.value * g.lead) * scale;
  g.rate = task.gy_by_x.value * g.half_length * scale;
}

/// The same of strips with numbers of their own, each about its own middle.
inline void read_strips(const SurfaceMarchTask& task, std::int32_t first, std::int32_t count, Group& g) {
  const auto of = [&](const double* values) { return load(values, first, count, 0.0); };
  place(task.width, task.half_length, task.cells, first, count, g);
  g.bound = of(task.bound);
  g.gx = of(task.growth_x);
  g.gy = of(task.growth_y);
  g.rate = of(task.rate);
  g.soft_x = of(task.soft_x);
  g.soft_y = of(task.soft_y);
}

template <class Task>
inline void prepare(const Task& task, std::int32_t first, std::int32_t count, Group& g, State& state,
                    GroupSums& sums) {
  // Growth over a cell, and the onset of slip in closed form, of a bound and a half length of 1.
  const double h = 2.0 / task.cells;
  read_strips(task, first, count, g);
  g.over_cell = growth_over(g.gx, g.gy, g.rate, h);
  const tangential::AdhesionGrowth<Pack> growth{g.gx, g.gy, 0.5 * g.rate};
  g.onset = task.parabolic ? tangential::onset_parabolic<Pack>(growth, 1.0, 1.0)
                           : tangential::onset_elliptic<Pack>(growth, 1.0, 1.0);

  // The first stick zone, summed without marching. Where slip sets in just behind the middle of a cell, the
  // mean of the adhesion tractions over the cell may exceed that of the bound: it is cut.
  g.onset_cells = g.onset * (0.5 * task.cells);
  g.onset_bound = bound_at(task, g.onset);
  set_stick_zone(g.onset_cells, task.cells, g);
  sums = {};
  adhesion_sums(g.gx, g.gy, g.rate, g.stick_cells, h, sums.force.stick_px, sums.force.stick_py,
                sums.force.stick_t_py);
  // the excess of the last cell, taken off the sums again
  Pack t, bound, px, py;
  last_stick_cell(task, g, h, t, bound);
  adhesion(g.gx, g.gy, g.rate, t, h, px, py);
  const Pack size = root(px * px + py * py);
  const Mask cut = (size > bound) & (g.stick_cells > 0.0);
  g.last_share = select(cut, bound / select(cut, size, 1.0), 1.0);
  const Pack excess = 1.0 - g.last_share;
  sums.force.stick_px += -(excess * px);
  sums.force.stick_py += -(excess * py);
  sums.force.stick_t_py += -(excess * t * py);
  // the cell of the onset stands for onset_part() cells of slip, so that between -1/2 and 1/2 has not slid
  sums.unslid =
      select(g.stick_cells < Pack(task.cells), 1.0 - onset_part(share_of_cell(g, g.stick_cells + 0.5)), 0.0);

  // Traction at the onset of slip. Where a strip slips from its leading edge on, only the direction of the
  // (vanishing) traction matters, which is that of the adhesion tractions there.
  const Pack gy = g.gy - 0.5 * g.rate * g.onset;
  const Pack growth_size = root(g.gx * g.gx + gy * gy);
  const Mask grows = growth_size > 1e-150;
  const Pack inverse = 1.0 / select(grows, growth_size, 1.0);
  state.ex = select(grows, -(g.gx * inverse), 1.0);
  state.ey = select(grows, -(gy * inverse), 0.0);
  state.ahead = first_ahead;
  state.stuck = false;
}

/// Derivatives by input k of the numbers that prepare() sets.
inline void differentiate(const MarchTask& task, std::int32_t k, const Group& g, GroupDerivative& d) {
  const double h = 2.0 / task.cells;
  // growth, as read_strips() makes it
  const Pack zero = 0.0;
  d = {};
  const Pack unit = 1.0 / (g.stiffness + 1e-6 / g.half_length);
  d.gx = (task.gx_constant.d[k] - task.gx_by_y.d[k] * g.y) * unit;
  d.gy = (task.gy_constant.d[k] + task.gy_by_x.d[k] * g.lead) * unit;
  d.rate = task.gy_by_x.d[k] * g.half_length * unit;
  d.over_cell = growth_over(d.gx, d.gy, d.rate, h);

  // onset v: F = |p|^2 - bound^2 = 0 with p = -v (gx, c), c = gy - rate v / 2, bound v (2 - v) or its root;
  // dv = -(dF by the input) / (dF by v), both over v
  const Pack v = g.onset, c = g.gy - 0.5 * g.rate * v, c_input = d.gy - 0.5 * d.rate * v;
  const Pack by_input = 2.0 * v * (g.gx * d.gx + c * c_input);
  const Pack by_v = 2.0 * (g.gx * g.gx + c * c) - c * g.rate * v -
                    (task.parabolic ? 4.0 * (2.0 - v) * (1.0 - v) : 2.0 * (1.0 - v) / larger(v, 1e-300));
  const Mask inside = (v > zero) & (v < 2.0) & (magnitude(by_v) > 1e-280);
  d.onset = select(inside, -(by_input / select(inside, by_v, 1.0)), zero);

  // state at the onset: angle of -(gx, c), and bound
  const Pack c_change = c_input - 0.5 * g.rate * d.onset;
  const Pack square = g.gx * g.gx + c * c;
  const Mask grows = square > 1e-280;
  d.angle = select(grows, (g.gx * c_change - c * d.gx) / select(grows, square, 1.0), zero);
  const Pack slope =
      task.parabolic ? 2.0 * (1.0 - v) : select(inside, (1.0 - v) / select(inside, g.onset_bound, 1.0), zero);
  d.onset_bound = slope * d.onset;

  // the first stick zone, and its last cell where that is cut: the direction may turn, not the size grow
  adhesion_sums(d.gx, d.gy, d.rate, g.stick_cells, h, d.force.stick_px, d.force.stick_py, d.force.stick_t_py);
  Pack t, cell_bound, px, py, dpx, dpy;
  last_stick_cell(task, g, h, t, cell_bound);
  adhesion(g.gx, g.gy, g.rate, t, h, px, py);
  adhesion(d.gx, d.gy, d.rate, t, h, dpx, dpy);
  const Mask cut = g.last_share < 1.0;
  const Pack along = (px * dpx + py * dpy) / select(cut, px * px + py * py, 1.0);
  const Pack cut_x = g.last_share * (dpx - px * along), cut_y = g.last_share * (dpy - py * along);
  d.force.stick_px += select(cut, cut_x - dpx, zero);
  d.force.stick_py += select(cut, cut_y - dpy, zero);
  d.force.stick_t_py += select(cut, t * (cut_y - dpy), zero);
}

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
