/// Strip FASTSIM for packs of strips, and its derivatives with respect to the creepages.
///
/// As in march_kernel.hpp all is relative: t and u = 2 - t to the half length, x = 1 - t; tractions of the
/// march to the parabolic bound at the strip's middle, which makes that bound u t in every strip. rho is the
/// traction over the bound, of the march and of the result alike.
///
/// The first stick zone needs no march, but per cell the mean of a root: with t_s = u_s / u,
///     rho = (kappa, lambda) (1 - s) + (0, psi) s,
/// s the mean of sqrt(1 - t_s) and a little of its square,
/// so that its sums, and their derivatives, are made of sums of s and of its slope.
#pragma once

#include "base/pack.hpp"
#include "tangential/march/march_grid.hpp"
#include "tangential/simd/march_groups.hpp"
#include "tangential/simd/strip_fastsim_start.hpp"
#include "tangential/simd/strip_group.hpp"
#include "tangential/simd/tasks.hpp"
#include "tangential/simd/turning.hpp"

namespace wrc::simd {
namespace {

namespace strip {

/// What the first stick zone makes of a cell: tractions over the bound are (1 - s) times the direction in
/// which slip sets in, and s (0, psi). Beyond its end s is zero; the cell in which it ends has its part.
struct StickShape {
  Pack s, by_end, by_form;  ///< slopes of s by u_s and by the form, for derivatives
};

template <bool sensitivities>
WRC_IN_LOOP StickShape stick_shape(const Group& g, const Cell& cell, StickSums& sums) {
  const Pack zero = 0.0, form = g.form;
  // The mean of sqrt(1 - t_s) = sqrt((u - u_s) / u) over the cell, weighted by the bound's sqrt(u): small
  // creepages leave a traction 1 / sqrt(u) at the trailing edge, of which the middle of a cell sees too
  // little.
  const Pack far = larger(zero, cell.behind - g.slip_end * cell.per_h);
  const Pack root_far = root(far), power_far = far * root_far;
  const Pack whole = (sums.power_near - power_far) * cell.inverse_weight;
  StickShape shape;
  shape.s = whole * (1.0 - form + form * whole);
  if constexpr (sensitivities) {
    shape.by_end = -1.5 * cell.per_h * cell.inverse_weight * (sums.root_near - root_far) *
                   (1.0 - form + 2.0 * form * whole);
    shape.by_form = whole * whole - whole;
    sums.root_near = root_far;
  }
  sums.power_near = power_far;
  return shape;
}

/// What keeps tractions at the bound, which |psi| > 1 could exceed.
inline Pack share_within_bound(const Group& g, Pack s, Pack x, Pack y) {
  return select(g.strong & (s > 0.0), 1.0 / root(larger(1.0, x * x + y * y)), 1.0);
}

/// The derivative (dx, dy) of a traction over the bound that is cut to (x, y): it may turn, not grow.
inline void cut_derivative(const Group& g, Pack share, Pack x, Pack y, Pack& dx, Pack& dy) {
  const Mask cut = g.strong & (share < 1.0);
  const Pack along = x * dx + y * dy;
  dx = select(cut, share * (dx - x * along), dx);
  dy = select(cut, share * (dy - y * along), dy);
}

/// Traction over bound.
struct StickCell {
  Pack x, y;
};

/// Adds a cell of the first stick zone; returns the traction if it is wanted. With `entering`, only some
/// strips are still in it.
template <bool entering, bool sensitivities, class Changes, std::int32_t count>
WRC_IN_LOOP StickCell stick(const Group& g, const Cell& cell, Mask moving, const StickShape& shape,
                            bool wanted, StickSums& sums, Sums& strong, Changes (&derivative)[count]) {
  const Pack one = 1.0, zero = 0.0;
  const Pack s = shape.s, mean = entering ? select(moving, zero, Pack(cell.mean)) : Pack(cell.mean);
  const Pack straight = mean * s;
  sums.mean += mean;
  sums.t_mean += cell.t * mean;
  sums.straight += straight;
  sums.t_straight += cell.t * straight;
  if constexpr (sensitivities) {
    const Pack slope = mean * shape.by_end, of_form = mean * shape.by_form;
    sums.slope += slope;
    sums.t_slope += cell.t * slope;
    sums.form += of_form;
    sums.t_form += cell.t * of_form;
  }
  if (!wanted && !g.any_strong) return {};

  const Pack x = g.kappa * (one - s), y = g.lambda * (one - s) + g.psi * s;
  if (!g.any_strong) return {x, y};
  const Pack share = share_within_bound(g, s, x, y), less = mean * (share - one);
  strong.force.stick_px += less * x;
  strong.force.stick_py += less * y;
  strong.force.stick_t_py += cell.t * (less * y);
  if constexpr (sensitivities) {
    for (std::int32_t k = 0; k < count; ++k) {
      Changes& d = derivative[k];
      const Pack ds = shape.by_end * d.slip_end + shape.by_form * d.form;
      const Pack dx = d.kappa * (one - s) - g.kappa * ds;
      const Pack dy = d.lambda * (one - s) + d.psi * s + (g.psi - g.lambda) * ds;
      Pack cut_x = dx, cut_y = dy;
      cut_derivative(g, share, share * x, share * y, cut_x, cut_y);
      d.force.stick_px += mean * (cut_x - dx);
      d.force.stick_py += mean * (cut_y - dy);
      d.force.stick_t_py += cell.t * (mean * (cut_y - dy));
    }
  }
  return {share * x, share * y};
}

/// A step on its way, and what it did, for fields and derivatives.
struct MarchStep {
  Mask stick, slips;
  bool any_sticks;
  Pack dv, part;                  ///< length of the step; of a cell that has slid since the last cell
  Advance advance;                ///< over it
  Pack rho_x, rho_y;              ///< traction over bound before
  Pack trial_x, trial_y, trial2;  ///< traction of the march if the cell sticks, and its square
  Pack bound_before, flexibility;
  Pack inverse_trial;  ///< one over the traction of lanes that stick
  StickShape shape;    ///< of a cell where strips enter slip
  Pack x, y;           ///< traction over bound after it
  Pack share;          ///< of it that is within the bound, where strips enter slip
  Turn turn;
};

/// One march step of a group through slip, up to the turn of its direction; see march_kernel.hpp.
template <bool entering>
WRC_IN_LOOP MarchStep begin_step(const Group& g, const Cell& cell, Mask moving, const State& s) {
  const Pack zero = 0.0, one = 1.0;
  MarchStep moved;
  moved.rho_x = s.x();
  moved.rho_y = s.y();
  moved.dv = cell.h;
  moved.advance = g.over_cell;
  moved.bound_before = cell.shape_before;
  if constexpr (entering) {
    moved.dv = larger(zero, smaller(cell.h, g.slip_end - (2.0 - cell.t)));
    moved.advance = advance_over(g, g.elastic, moved.dv);
    moved.bound_before = select(Pack(cell.index - 0.5) < g.stick_cells, g.end_bound, moved.bound_before);
  }
  const Advance& a = moved.advance;
  moved.trial_x = moved.bound_before * moved.rho_x - a.gx;
  moved.trial_y = moved.bound_before * moved.rho_y - (a.gy + a.curvature * (2.0 * cell.x + moved.dv));
  moved.trial2 = moved.trial_x * moved.trial_x + moved.trial_y * moved.trial_y;
  moved.stick = moved.trial2 <= cell.shape * cell.shape;
  if constexpr (entering) moved.stick = moved.stick & moving;
  moved.any_sticks = any(moved.stick);

  moved.flexibility = g.t11 * (one - moved.rho_x * moved.rho_x) + g.t22 * (one - moved.rho_y * moved.rho_y);
  const Pack elastic = a.elastic * cell.x;
  const Pack Vx = a.wx + elastic * moved.rho_x;
  const Pack Vy = (a.wy + a.spin * cell.x) - elastic * moved.rho_y + a.bend * s.ahead;
  moved.turn = begin_turn(Vx, Vy, (moved.bound_before + cell.shape) * moved.flexibility, s.ex, s.ey);
  return moved;
}

/// The rest of it.
template <bool entering>
WRC_IN_LOOP void end_step(const Group& g, const Cell& cell, Mask moving, MarchStep& moved, State& s,
                          Sums& sums) {
  const Pack zero = 0.0, one = 1.0;
  Pack ex = moved.turn.ex, ey = moved.turn.ey, ahead = moved.turn.ahead;
  moved.part = one;
  moved.slips = !moved.stick;
  if constexpr (entering) {
    moved.part = select(moved.dv < cell.h, 0.5 + moved.dv * cell.per_h, one);
    moved.slips = moving & moved.slips;
    sums.unslid += select(moving, one - moved.part, zero);
    ex = select(moving, ex, s.ex);
    ey = select(moving, ey, s.ey);
    ahead = select(moving, ahead, s.ahead);
  }
  s.stuck = moved.any_sticks;
  if (moved.any_sticks) {
    const Pack size = root(moved.trial2), per_shape = 1.0 / cell.shape;
    const Mask turns = moved.stick & (size > 1e-150);
    moved.inverse_trial = one / select(turns, size, one);
    ex = select(turns, moved.trial_x * moved.inverse_trial, ex);
    ey = select(turns, moved.trial_y * moved.inverse_trial, ey);
    s.rho_x = select(moved.stick, moved.trial_x * per_shape, ex);
    s.rho_y = select(moved.stick, moved.trial_y * per_shape, ey);
    sums.unslid += select(moved.stick, moved.part, zero);
  }
  s.ex = ex;
  s.ey = ey;
  s.ahead = ahead;
  moved.x = s.x();
  moved.y = s.y();
  if constexpr (entering) {  // the first stick zone's part of the cell in which it ends
    const Pack near = one - moved.shape.s;
    moved.x = near * moved.x;
    moved.y = near * moved.y + g.psi * moved.shape.s;
    if (g.any_strong) {
      moved.share = share_within_bound(g, moved.shape.s, moved.x, moved.y);
      moved.x = moved.share * moved.x;
      moved.y = moved.share * moved.y;
    }
  }
  const Pack mean = entering ? select(moving, Pack(cell.mean), zero) : Pack(cell.mean);
  add_cell(mean * moved.x, mean * moved.y, sums.force);
}

/// How the angle of the traction after a step, and `ahead`, change with what goes into the step.
struct StepSlopes {
  Pack kept, ahead_by_angle;          ///< with the angle before
  Pack by_ratio, ahead_by_ratio;      ///< with the traction before, where that was below the bound
  Pack by_turning, ahead_by_turning;  ///< with the flexibility, relative
  Pack by_t11, by_t22;                ///< with its two parts
  Pack ahead_by_t11, ahead_by_t22;
  Pack by_x, by_y, ahead_by_x, ahead_by_y;  ///< with the slip over a whole cell
  Pack bend, ahead_before;                  ///< by which spin and `ahead` change the slip along the step
  Pack share;                               ///< of a cell that the step is, where strips enter slip;
  Mask partial;                             ///< then: it is less than a whole one
  Pack by_onset, ahead_by_onset;            ///< and with the end of the stick zone,
  Pack bound_by_onset;                      ///< with which the bound before the step changes, too
};

/// Of a step that is part of a cell, the inputs' changes over a whole one are that part; and the part itself
/// changes with the onset of slip, as does the bound there.
WRC_IN_LOOP void take_part_of_cell(const Group& g, const Cell& cell, const State& before,
                                   const MarchStep& moved, const TurnSlopes& slope, StepSlopes& s) {
  const Pack zero = 0.0;
  const Pack wx = g.wx + (g.elastic * cell.x) * moved.rho_x;
  const Pack wy =
      g.wy + g.spin * cell.x - (g.elastic * cell.x) * moved.rho_y + (2.0 * moved.advance.spin) * before.ahead;
  s.partial = (moved.dv > zero) & (moved.dv < cell.h);
  s.bound_by_onset = select(Pack(cell.index - 0.5) < g.stick_cells, 2.0 * (1.0 - g.slip_end), zero);
  const Pack d_by_onset = s.bound_by_onset * moved.flexibility;
  s.by_onset = select(s.partial, s.by_x * wx + s.by_y * wy, zero) + slope.by_d * d_by_onset;
  s.ahead_by_onset =
      select(s.partial, s.ahead_by_x * wx + s.ahead_by_y * wy, zero) + slope.ahead_by_d * d_by_onset;
  s.share = select(moved.dv < cell.h, moved.dv * cell.per_h, 1.0);
  s.by_x = s.share * s.by_x;
  s.by_y = s.share * s.by_y;
  s.ahead_by_x = s.share * s.ahead_by_x;
  s.ahead_by_y = s.share * s.ahead_by_y;
  s.bend = s.share * s.bend;
  s.ahead_before = s.share * s.ahead_before;
}

template <bool entering>
WRC_IN_LOOP StepSlopes step_slopes(const Group& g, const Cell& cell, const State& before,
                                   const MarchStep& moved) {
  const Pack zero = 0.0;
  const TurnSlopes slope = slopes(moved.turn, before.ex, before.ey);
  StepSlopes s;
  // A change of rho changes the elastic slip and the flexibility: where it turns, and where it grows.
  const Pack elastic = moved.advance.elastic * cell.x;
  const Pack elastic_x = elastic * moved.rho_x, elastic_y = elastic * moved.rho_y;
  const Pack bounds = 2.0 * (moved.bound_before + cell.shape);
  const Pack d_by_angle = bounds * ((g.t11 - g.t22) * (moved.rho_x * moved.rho_y));
  s.kept = slope.kept - (slope.by_x * elastic_y + slope.by_y * elastic_x) + slope.by_d * d_by_angle;
  s.ahead_by_angle =
      slope.ahead_by_d * d_by_angle - (slope.ahead_by_x * elastic_y + slope.ahead_by_y * elastic_x);
  s.by_ratio = s.ahead_by_ratio = zero;
  if (before.stuck) {
    const Pack x = elastic * before.ex, y = elastic * before.ey;
    const Pack d = bounds * (g.t11 * (moved.rho_x * before.ex) + g.t22 * (moved.rho_y * before.ey));
    s.by_ratio = slope.by_x * x - slope.by_y * y - slope.by_d * d;
    s.ahead_by_ratio = slope.ahead_by_x * x - slope.ahead_by_y * y - slope.ahead_by_d * d;
  }
  s.by_turning = slope.by_d * moved.turn.d;
  s.ahead_by_turning = slope.ahead_by_d * moved.turn.d;
  const Pack half_bounds = moved.bound_before + cell.shape;
  const Pack d_by_t11 = half_bounds * (1.0 - moved.rho_x * moved.rho_x);
  const Pack d_by_t22 = half_bounds * (1.0 - moved.rho_y * moved.rho_y);
  s.by_t11 = slope.by_d * d_by_t11;
  s.by_t22 = slope.by_d * d_by_t22;
  s.ahead_by_t11 = slope.ahead_by_d * d_by_t11;
  s.ahead_by_t22 = slope.ahead_by_d * d_by_t22;
  s.by_x = slope.by_x;
  s.by_y = slope.by_y;
  s.ahead_by_x = slope.ahead_by_x;
  s.ahead_by_y = slope.ahead_by_y;
  s.bend = g.over_cell.bend;
  s.ahead_before = before.ahead;
  if constexpr (entering) take_part_of_cell(g, cell, before, moved, slope, s);
  return s;
}

/// How the angle and `ahead` after the step change with input k.
template <bool entering>
WRC_IN_LOOP void turn_derivative(const StepSlopes& s, const Cell& cell, bool stuck, std::int32_t k,
                                 const Derivative& d, Pack& angle, Pack& ahead) {
  const Advance& a = d.over_cell;
  Pack wy = a.wy + s.bend * d.ahead;
  if (k == 2) wy += a.spin * cell.x + a.bend * s.ahead_before;  // only spin turns the slip
  angle = s.kept * d.angle + s.by_y * wy + s.by_turning * d.turning;
  ahead = s.ahead_by_angle * d.angle + s.ahead_by_y * wy + s.ahead_by_turning * d.turning;
  if (k != 1) {  // the lateral creepage has no part in the slip along x
    angle += s.by_x * a.wx;
    ahead += s.ahead_by_x * a.wx;
  }
  if constexpr (entering) {
    angle += s.by_onset * d.slip_end;
    ahead += s.ahead_by_onset * d.slip_end;
  }
  if (stuck) {
    angle += s.by_ratio * d.ratio;
    ahead += s.ahead_by_ratio * d.ratio;
  }
}

/// Change of the growth of adhesion tractions over a whole cell.
struct Growth {
  Pack gx, gy, curvature;
};

/// How the traction of lanes that stick changes: its ratio to the bound, and its angle.
template <bool entering, class Changes>
WRC_IN_LOOP void stick_derivative(const Group& g, const StepSlopes& s, const Cell& cell, const State& before,
                                  const State& after, const MarchStep& moved, const Growth& over_cell,
                                  const Changes& d, Pack& ratio, Pack& angle) {
  const Pack zero = 0.0;
  const Pack middle = 2.0 * cell.x + moved.dv;
  Pack gx = over_cell.gx, gy = over_cell.gy, curvature = over_cell.curvature, bound = zero;
  if constexpr (entering) {
    const Pack dv = select(s.partial, d.slip_end, zero);
    gx = s.share * gx + g.gx * dv;
    curvature = s.share * curvature + g.curvature * dv;
    gy = s.share * gy + (g.gy + moved.advance.curvature) * dv;
    bound = s.bound_by_onset * d.slip_end;
  }
  const Pack dx = d.ratio * before.ex - moved.rho_y * d.angle;
  const Pack dy = d.ratio * before.ey + moved.rho_x * d.angle;
  const Pack x = dx * moved.bound_before + moved.rho_x * bound - gx;
  const Pack y = dy * moved.bound_before + moved.rho_y * bound - (gy + curvature * middle);
  ratio = select(moved.stick, (after.ex * x + after.ey * y) * (1.0 / cell.shape), zero);
  angle = select(moved.stick, (after.ex * y - after.ey * x) * moved.inverse_trial, angle);
}

/// What a cell's tractions are weighted by in the sums.
struct CellMeans {
  Pack mean;          ///< of the bound, as far as tractions have the march's direction
  Pack rho_x, rho_y;  ///< the same times the traction over the bound
  Pack x_by_s, y_by_s, y_by_psi;
};

template <bool entering>
WRC_IN_LOOP CellMeans cell_means(const Group& g, const Cell& cell, Mask moving, const State& after,
                                 const MarchStep& moved) {
  const Pack zero = 0.0;
  CellMeans m;
  m.mean = cell.mean;
  if constexpr (entering) {
    const Pack mean = select(moving, m.mean, zero);
    m.x_by_s = zero - mean * after.x();
    m.y_by_s = mean * (g.psi - after.y());
    m.y_by_psi = mean * moved.shape.s;
    m.mean = mean * (1.0 - moved.shape.s);
  }
  m.rho_x = m.mean * after.x();
  m.rho_y = m.mean * after.y();
  return m;
}

/// Takes over how the state changes with an input, and adds how the cell's tractions do.
template <bool entering, class Changes>
WRC_IN_LOOP void end_derivative(const Group& g, Mask moving, const State& before, const State& after,
                                const MarchStep& moved, const CellMeans& m, Pack ratio, Pack angle,
                                Pack ahead, Changes& d) {
  if (before.stuck || moved.any_sticks) d.ratio = ratio;
  d.angle = entering ? select(moving, angle, d.angle) : angle;
  d.ahead = entering ? select(moving, ahead, d.ahead) : ahead;
  Pack x = -(m.rho_y * d.angle), y = m.rho_x * d.angle;
  if (moved.any_sticks) {
    x += m.mean * ratio * after.ex;
    y += m.mean * ratio * after.ey;
  }
  if constexpr (entering) {
    const Pack ds = moved.shape.by_end * d.slip_end + moved.shape.by_form * d.form;
    x += m.x_by_s * ds;
    y += m.y_by_s * ds + m.y_by_psi * d.psi;
    if (g.any_strong) cut_derivative(g, moved.share, moved.x, moved.y, x, y);
  }
  add_cell(x, y, d.force);
}

/// The same step for the derivatives; `before`: the state it began with.
template <bool entering>
WRC_IN_LOOP void differentiate(const Group& g, const Cell& cell, Mask moving, const State& before,
                               const State& after, const MarchStep& moved, Derivative (&derivative)[inputs]) {
  const Pack zero = 0.0;
  const StepSlopes s = step_slopes<entering>(g, cell, before, moved);
  const CellMeans means = cell_means<entering>(g, cell, moving, after, moved);
  for (std::int32_t k = 0; k < inputs; ++k) {
    Derivative& d = derivative[k];
    Pack angle, ahead, ratio = zero;
    turn_derivative<entering>(s, cell, before.stuck, k, d, angle, ahead);
    if (moved.any_sticks)
      stick_derivative<entering>(g, s, cell, before, after, moved,
                                 Growth{d.over_cell.gx, d.over_cell.gy, d.over_cell.curvature}, d, ratio,
                                 angle);
    end_derivative<entering>(g, moving, before, after, moved, means, ratio, angle, ahead, d);
  }
}

/// What the slip of a group's strips is made of, for the fields.
struct SlipShape {
  Pack stick;                 ///< 2 - u_s, the length of the first stick zone
  Pack two;                   ///< 2; 0 without friction, where nothing holds the slip's direction
  Pack elastic_x, elastic_y;  ///< elastic slip at the leading edge along x and y
  Pack per_even, per_odd;     ///< 2 / (v + u_s - u) in a pair of cells, the first of even index
};

inline void set_elastic(const StripFastsimTask& task, const Group& g, SlipShape& shape) {
  shape.elastic_x = (2.0 * task.l11) * g.slope;
  shape.elastic_y = (2.0 * task.l22) * g.slope;
}
inline void set_elastic(const SurfaceStripsTask& task, const Group& g, SlipShape& shape) {
  shape.elastic_x = load(task.edge_x, g.first, g.count, 0.0);
  shape.elastic_y = load(task.edge_y, g.first, g.count, 0.0);
}

template <class Task>
inline SlipShape slip_shape(const Task& task, const Group& g) {
  SlipShape shape;
  shape.stick = 2.0 - g.slip_end;
  shape.two = select(g.bound > 0.0, 2.0, 0.0);
  set_elastic(task, g, shape);
  return shape;
}

/// Sets what the pair of cells needs in which `cell` lies: one divide makes two inverses.
inline void enter_pair(const Cell& cell, SlipShape& shape) {
  const std::int32_t even = cell.index - (cell.index & 1);
  const double t_even = (even + 0.5) * cell.h, t_odd = (even + 1.5) * cell.h;
  const Pack of_even = t_even + larger(0.0, t_even - shape.stick);
  const Pack of_odd = t_odd + larger(0.0, t_odd - shape.stick);
  const Pack twice = shape.two / (of_even * of_odd);
  shape.per_even = of_odd * twice;
  shape.per_odd = of_even * twice;
}

/// Magnitude of the slip in a slipping cell, before the scaling to the balance of power: rigid slip along the
/// traction plus the elastic slip 2 B L x of a strip that slips as a whole, times what Carter's solution, in
/// which s is proportional to sqrt(v (u_s - u)), makes of it when only u < u_s slips.
inline Pack slip_size(const Group& g, const SlipShape& shape, const Cell& cell, Pack rho_x, Pack rho_y) {
  const Pack zero = 0.0;
  const Pack along = g.wx * rho_x + (g.wy + g.spin * cell.x) * rho_y;
  const Pack elastic = cell.x * (shape.elastic_y + (shape.elastic_x - shape.elastic_y) * (rho_x * rho_x));
  const Pack behind = larger(zero, cell.t - shape.stick);
  const Pack per_sum = (cell.index & 1) != 0 ? shape.per_odd : shape.per_even;
  return larger(zero, zero - (along + elastic)) * (root(behind * cell.t) * per_sum);
}

/// The first stick zone's share of a group's sums, from the sums over s.
inline void add_stick(const Group& g, const StickSums& s, Sums& sums) {
  const Pack bent = s.mean - s.straight, t_bent = s.t_mean - s.t_straight;
  sums.force.stick_px += g.kappa * bent;
  sums.force.stick_py += g.lambda * bent + g.psi * s.straight;
  sums.force.stick_t_py += g.lambda * t_bent + g.psi * s.t_straight;
}

template <class Changes>
inline void add_stick_derivative(const Group& g, const StickSums& s, Changes& d) {
  const Pack bent = s.mean - s.straight, t_bent = s.t_mean - s.t_straight;
  const Pack change = d.slip_end * s.slope + d.form * s.form;  // of the sum of s
  const Pack t_change = d.slip_end * s.t_slope + d.form * s.t_form;
  d.force.stick_px += d.kappa * bent - g.kappa * change;
  d.force.stick_py += d.lambda * bent + d.psi * s.straight + (g.psi - g.lambda) * change;
  d.force.stick_t_py += d.lambda * t_bent + d.psi * s.t_straight + (g.psi - g.lambda) * t_change;
}

/// A cell's tractions over the bound and its slip, not yet scaled, for the fields; `power` is their product.
struct CellFields {
  Pack rho_x, rho_y, slip_x, slip_y, power;
};

/// Stores them and adds to the power of the slip.
inline void store_cell(const StripFastsimMarch& task, const Group& g, const Cell& cell, const CellFields& f,
                       Sums& sums) {
  const Pack bound = cell.mean * g.bound;
  sums.power += f.power * bound;
  simd::store_cell(*task.fields, g, cell.index, task.strips, bound * f.rho_x, bound * f.rho_y, f.slip_x,
                   f.slip_y);
}

/// One group of strips on its way.
struct Marching {
  Group group;
  State state;
  StickSums stick;
  Sums sums;
  SlipShape slip;  ///< for fields
};

/// What follows the turn in a cell: the rest of the step, its derivatives, the fields.
template <bool entering, Output output>
WRC_IN_LOOP void settle(const StripFastsimMarch& task, const Cell& cell, Mask moves, MarchStep& moved,
                        Marching& m, Derivative (&derivative)[inputs]) {
  constexpr bool sensitivities = output == Output::sensitivities;
  [[maybe_unused]] State before;
  if constexpr (sensitivities) before = m.state;
  if constexpr (entering) moved.shape = stick_shape<sensitivities>(m.group, cell, m.stick);
  end_step<entering>(m.group, cell, moves, moved, m.state, m.sums);
  if constexpr (sensitivities)
    differentiate<entering>(m.group, cell, moves, before, m.state, moved, derivative);
  [[maybe_unused]] StickCell stuck;
  if constexpr (entering)
    stuck = stick<true, sensitivities>(m.group, cell, moves, moved.shape, output == Output::fields, m.stick,
                                       m.sums, derivative);
  if constexpr (output == Output::fields) {
    const Pack x = m.state.x(), y = m.state.y();
    if ((cell.index & 1) == 0 || cell.index == m.group.all_stick) enter_pair(cell, m.slip);
    Pack slip = slip_size(m.group, m.slip, cell, x, y);
    if constexpr (entering) slip = moved.part * slip;
    if (entering || moved.any_sticks) slip = select(moved.slips, slip, 0.0);
    CellFields f{moved.x, moved.y, 0.0 - slip * x, 0.0 - slip * y, slip};
    if constexpr (entering) {
      f.power = select(moved.shape.s > 0.0, slip * (moved.x * x + moved.y * y), slip);
      f.rho_x = select(moves, moved.x, stuck.x);
      f.rho_y = select(moves, moved.y, stuck.y);
    }
    store_cell(task, m.group, cell, f, m.sums);
  }
}

/// A cell in the first stick zones of all strips of a group.
template <Output output>
WRC_IN_LOOP void stay(const StripFastsimMarch& task, const Cell& cell, Marching& m,
                      Derivative (&derivative)[inputs]) {
  constexpr bool fields = output == Output::fields, sensitivities = output == Output::sensitivities;
  const Mask none = Pack(0.0) < Pack(0.0);
  const StickShape shape = stick_shape<sensitivities>(m.group, cell, m.stick);
  const StickCell stuck =
      stick<false, sensitivities>(m.group, cell, none, shape, fields, m.stick, m.sums, derivative);
  if constexpr (fields) store_cell(task, m.group, cell, {stuck.x, stuck.y, 0.0, 0.0, 0.0}, m.sums);
}

/// Power by the balance -(Fx nu_x + Fy nu_y + Mz phi) [N].
inline double balance_of_power(const StripFastsimTask& task, const simd::Sums& total) {
  const double balance = -(total.fx * task.nu_x + total.fy * task.nu_y + total.mz * task.phi);
  return balance > 0.0 ? balance : 0.0;
}

/// Adds a group's strips to the sums.
inline void finish(const StripFastsimTask& task, const Marching& m, simd::Sums& total) {
  add_forces(m.group, task.cells, m.sums.force, total);
  add_power(m.group, task.cells, m.sums.unslid, m.group.cell * m.sums.power, total);
}

/// The same where strips have axes of their own: their forces are stored, and the balance of power is summed.
inline void finish(const SurfaceStripsTask& task, const Marching& m, simd::Sums& total) {
  store_forces(m.group, task.cells, m.sums.force, task.fx, task.fy, task.mz);
  add_power(m.group, task.cells, m.sums.unslid, m.group.cell * m.sums.power, total);
}

/// Its balance of power.
inline double balance_of_power(const SurfaceStripsTask& task, const simd::Sums&) {
  double balance = 0.0;
  for (std::int32_t j = 0; j < task.strips; ++j)
    balance -= task.fx[j] * task.rigid_x[j] + task.fy[j] * task.rigid_y[j] + task.mz[j] * task.spin[j];
  return balance > 0.0 ? balance : 0.0;
}

/// The fields of slip, whose power is known as that of their distribution only, are scaled; all cells before
/// the cell `first` stick.
inline void scale_slip(const StripFastsimMarch& task, std::int32_t first, double scale) {
  const std::int32_t cells = task.strips * task.cells;
  double* const fields[] = {task.fields->slip_x, task.fields->slip_y};
  for (double* field : fields) {
    for (std::int32_t at = first * task.strips; field != nullptr && at < cells; at += lanes) {
      const std::int32_t count = cells - at < lanes ? cells - at : lanes;
      store(scale * load(field, at, count, 0.0), field + at, count);
    }
  }
}

/// Cell i of all strips.
inline Cell cell_of(const StripFastsimMarch& task, std::int32_t i) {
  const double h = 2.0 / task.cells, per_h = 0.5 * task.cells;
  const double t = (i + 0.5) * h, behind = task.cells - i - 1.0, shape = t * (2.0 - t);
  const double t_before =
      (i - 0.5) * h;  // as it was then: a strip's bits do not depend on the others of its group
  return {i, t,     1.0 - t, t_before * (2.0 - t_before), shape, task.shape->mean[i],
          h, per_h, behind,  task.inverse_weight[i]};
}

/// Sums over the first stick zone that begin with its cells.
inline StickSums first_stick_sums(const StripFastsimMarch& task, const Group& g) {
  StickSums sums = {};
  const Pack near = larger(0.0, task.cells - g.slip_end * (0.5 * task.cells));
  sums.root_near = root(near);
  sums.power_near = near * sums.root_near;
  return sums;
}

/// What is particular to strip FASTSIM: see march_groups().
template <Output output, class Task>
struct March {
  using Marching = strip::Marching;
  using Derivative = strip::Derivative;
  static constexpr std::int32_t inputs = simd::inputs, in_flight = simd::in_flight;
  static constexpr bool stays = true;
  static constexpr bool sensitivities = output == Output::sensitivities;

  const Task& task;
  simd::Sums& total;

  void prepare(std::int32_t at, std::int32_t count, Marching& m, Derivative (&derivative)[inputs]) const {
    strip::prepare(task, at, count, m.group, m.state);
    m.stick = first_stick_sums(task, m.group);
    m.sums = {};
    if constexpr (output == Output::fields) m.slip = slip_shape(task, m.group);
    if constexpr (sensitivities) differentiate(task, m.group, derivative);
  }
  Cell cell(std::int32_t i) const { return cell_of(task, i); }
  void stay(const Cell& cell, Marching& m, Derivative (&derivative)[inputs]) const {
    strip::stay<output>(task, cell, m, derivative);
  }
  void finish(Marching& m, Derivative (&derivative)[inputs]) const {
    add_stick(m.group, m.stick, m.sums);
    strip::finish(task, m, total);
    if constexpr (sensitivities) {
      for (std::int32_t n = 0; n < inputs; ++n) {
        add_stick_derivative(m.group, m.stick, derivative[n]);
        add_derivative(m.group, task.cells, derivative[n].force, n, total);
      }
    }
  }
};

}  // namespace strip

template <Output output, class Task>
void strip_fastsim_kernel(const Task& task, Sums& total) {
  total = {};
  const std::int32_t slips = march_groups<output>(task, strip::March<output, Task>{task, total});
  const double power = strip::balance_of_power(task, total);
  if constexpr (output == Output::fields)
    strip::scale_slip(task, slips, total.power_per_speed > 0.0 ? power / total.power_per_speed : 0.0);
  total.power_per_speed = power;
}

}  // namespace
}  // namespace wrc::simd
