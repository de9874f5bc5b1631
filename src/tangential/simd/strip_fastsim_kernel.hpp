/// Strip FASTSIM for packs of strips, and its derivatives with respect to the creepages.
///
/// As in march_kernel.hpp all is relative: t and u = 2 - t to the half length, x = 1 - t; tractions of the
/// march to the parabolic bound at the strip's middle, which makes that bound u t in every strip. rho is the
/// traction over the bound, of the march and of the result alike.
///
///     symbol (theory.md)         here                        unit
///     v, u, u_s                  t, u, slip_end              half lengths
///     (kappa, lambda), psi_k     kappa, lambda, psi          -
///     p / tau                    rho_x, rho_y                -
///     sqrt(1 - u_s / u)          StickShape::s               -
///     w                          wx, wy + spin x             -
///
/// The first stick zone needs no march, but per cell the mean of a root: with t_s = u_s / u,
///     rho = (kappa, lambda) (1 - s) + (0, psi) s,
/// s the mean of sqrt(1 - t_s) and a little of its square,
/// so that its sums, and their derivatives, are made of sums of s and of its slope.
#pragma once

#include "base/pack.hpp"
#include "tangential/march/march_grid.hpp"
#include "tangential/methods/slip_across.hpp"
#include "tangential/simd/march_groups.hpp"
#include "tangential/simd/strip_fastsim_start.hpp"
#include "tangential/simd/strip_group.hpp"
#include "tangential/simd/tasks.hpp"
#include "tangential/simd/turning.hpp"

namespace wrc::simd {
namespace {

namespace strip {

/// A cell of the first stick zone: tractions over the bound are (1 - s) times the direction in which slip
/// sets in, and s (0, psi). Beyond its end s is zero; the cell in which it ends has its part.
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
  // from sqrt(1 - t_s) of strip theory to its square 1 - t_s of FASTSIM by the share `form`; the border
  // between two cells is read once: far here is near of the next
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

/// Factor that cuts tractions to the bound, which they could exceed where |psi| > 1.
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
  // Sums of s times bound, of which the forces are made at the end (add_stick), without the cut.
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

  // The traction itself: for fields, and where |psi| > 1 for the part beyond the bound, whose forces come
  // off.
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

/// A march step: its numbers up to the turn, and its results for fields and derivatives.
struct MarchStep {
  Mask stick;
  bool any_sticks;
  Pack dv, part;                  ///< length of the step; cells of slip that the cell stands for
  Advance advance;                ///< the step
  Pack rho_x, rho_y;              ///< traction over bound before
  Pack trial_x, trial_y, trial2;  ///< traction of the march if the cell sticks, and its square
  Pack bound_before;              ///< the march's
  Pack flexibility;               ///< that turns the traction, by its direction [-]
  Pack inverse_trial;             ///< one over the traction of lanes that stick
  StickShape shape;               ///< where strips enter slip: the first stick zone's part of the cell
  Pack x, y;                      ///< traction over bound after it
  Pack share;                     ///< share of it within the bound, where strips enter slip
  Turn turn;
};

/// One march step of a group through slip, up to the turn of its direction; see march_kernel.hpp.
template <bool entering>
WRC_IN_LOOP MarchStep begin_step(const Group& g, const Cell& cell, Mask moving, const State& s) {
  // a whole cell from the traction at the cell before, or the part of it behind the onset from the traction
  // there
  const Pack zero = 0.0, one = 1.0;
  MarchStep step;
  step.rho_x = s.x();
  step.rho_y = s.y();
  step.dv = cell.h;
  step.advance = g.over_cell;
  step.bound_before = cell.shape_before;
  if constexpr (entering) {
    step.dv = larger(zero, smaller(cell.h, g.slip_end - (2.0 - cell.t)));
    step.advance = advance_over(g, g.elastic, step.dv);
    step.bound_before = select(Pack(cell.index - 0.5) < g.stick_cells, g.end_bound, step.bound_before);
  }
  // Kalker's criterion: the cell sticks if the march's traction less its growth is within the bound.
  const Advance& a = step.advance;
  step.trial_x = step.bound_before * step.rho_x - a.gx;
  step.trial_y = step.bound_before * step.rho_y - (a.gy + a.curvature * (2.0 * cell.x + step.dv));
  step.trial2 = step.trial_x * step.trial_x + step.trial_y * step.trial_y;
  step.stick = step.trial2 <= cell.shape * cell.shape;
  if constexpr (entering) step.stick = step.stick & moving;
  step.any_sticks = any(step.stick);

  // Otherwise it turns against rigid plus elastic slip; the flexibility is that across the traction,
  // t11 (1 - rho_x^2) + t22 (1 - rho_y^2).
  step.flexibility = g.t11 * (one - step.rho_x * step.rho_x) + g.t22 * (one - step.rho_y * step.rho_y);
  const Pack elastic = a.elastic * cell.x;
  const Pack Vx = a.wx + elastic * step.rho_x;
  const Pack Vy = (a.wy + a.spin * cell.x) - elastic * step.rho_y + a.bend * s.ahead;
  step.turn = begin_turn(Vx, Vy, (step.bound_before + cell.shape) * step.flexibility, s.ex, s.ey);
  return step;
}

/// The rest of a step: state, traction and slip of the cell.
template <bool entering>
WRC_IN_LOOP void end_step(const Group& g, const Cell& cell, Mask moving, MarchStep& step, State& s,
                          Sums& sums) {
  const Pack zero = 0.0, one = 1.0;
  // Lanes that have not left their first stick zones keep their state. The cell behind the onset stands for
  // half a cell to one and a half of slip.
  Pack ex = step.turn.ex, ey = step.turn.ey, ahead = step.turn.ahead;
  step.part = one;
  if constexpr (entering) {
    step.part = select(step.dv < cell.h, 0.5 + step.dv * cell.per_h, one);
    sums.unslid += select(moving, one - step.part, zero);
    ex = select(moving, ex, s.ex);
    ey = select(moving, ey, s.ey);
    ahead = select(moving, ahead, s.ahead);
  }
  // Lanes that stick: the trial traction, and rho as its ratio to the bound.
  s.stuck = step.any_sticks;
  if (step.any_sticks) {
    const Pack size = root(step.trial2), per_shape = 1.0 / cell.shape;
    const Mask turns = step.stick & (size > 1e-150);
    step.inverse_trial = one / select(turns, size, one);
    ex = select(turns, step.trial_x * step.inverse_trial, ex);
    ey = select(turns, step.trial_y * step.inverse_trial, ey);
    s.rho_x = select(step.stick, step.trial_x * per_shape, ex);
    s.rho_y = select(step.stick, step.trial_y * per_shape, ey);
    sums.unslid += select(step.stick, step.part, zero);
  }
  s.ex = ex;
  s.ey = ey;
  s.ahead = ahead;
  // traction of the cell over mu p, and the sums
  step.x = s.x();
  step.y = s.y();
  if constexpr (entering) {  // the first stick zone's part of the cell in which it ends
    const Pack near = one - step.shape.s;
    step.x = near * step.x;
    step.y = near * step.y + g.psi * step.shape.s;
    if (g.any_strong) {
      step.share = share_within_bound(g, step.shape.s, step.x, step.y);
      step.x = step.share * step.x;
      step.y = step.share * step.y;
    }
  }
  const Pack mean = entering ? select(moving, Pack(cell.mean), zero) : Pack(cell.mean);
  add_cell(mean * step.x, mean * step.y, sums.force);
}

/// Derivatives of the angle of the traction after a step, and of `ahead`, by the numbers of the step.
struct StepSlopes {
  Pack kept, ahead_by_angle;          ///< by the angle before
  Pack by_ratio, ahead_by_ratio;      ///< by the traction before, where that was below the bound
  Pack by_turning, ahead_by_turning;  ///< by the flexibility, relative
  Pack by_t11, by_t22;                ///< by its two parts
  Pack ahead_by_t11, ahead_by_t22;
  Pack by_x, by_y, ahead_by_x, ahead_by_y;  ///< by the slip over a whole cell
  Pack bend, ahead_before;                  ///< fall of the slip along the step by spin; `ahead` before
  Pack share;                               ///< part of a cell that is stepped over;
  Mask partial;                             ///< where that is less than a whole one
  Pack by_onset, ahead_by_onset;            ///< by the end of the stick zone,
  Pack bound_by_onset;                      ///< by which the bound before the step changes, too
};

/// A step over part of a cell: the inputs' changes over a whole cell count by that part; and the part itself
/// changes with the onset of slip, as does the bound there.
WRC_IN_LOOP void take_part_of_cell(const Group& g, const Cell& cell, const State& before,
                                   const MarchStep& step, const TurnSlopes& slope, StepSlopes& s) {
  // slip per length of the step, d(V) / d(dv); the bound at the onset is u_s (2 - u_s)
  const Pack zero = 0.0;
  const Pack wx = g.wx + (g.elastic * cell.x) * step.rho_x;
  const Pack wy =
      g.wy + g.spin * cell.x - (g.elastic * cell.x) * step.rho_y + (2.0 * step.advance.spin) * before.ahead;
  s.partial = (step.dv > zero) & (step.dv < cell.h);
  s.bound_by_onset = select(Pack(cell.index - 0.5) < g.stick_cells, 2.0 * (1.0 - g.slip_end), zero);
  const Pack d_by_onset = s.bound_by_onset * step.flexibility;
  s.by_onset = select(s.partial, s.by_x * wx + s.by_y * wy, zero) + slope.by_d * d_by_onset;
  s.ahead_by_onset =
      select(s.partial, s.ahead_by_x * wx + s.ahead_by_y * wy, zero) + slope.ahead_by_d * d_by_onset;
  s.share = select(step.dv < cell.h, step.dv * cell.per_h, 1.0);
  s.by_x = s.share * s.by_x;
  s.by_y = s.share * s.by_y;
  s.ahead_by_x = s.share * s.ahead_by_x;
  s.ahead_by_y = s.share * s.ahead_by_y;
  s.bend = s.share * s.bend;
  s.ahead_before = s.share * s.ahead_before;
}

template <bool entering>
WRC_IN_LOOP StepSlopes step_slopes(const Group& g, const Cell& cell, const State& before,
                                   const MarchStep& step) {
  const Pack zero = 0.0;
  const TurnSlopes slope = slopes(step.turn, before.ex, before.ey);
  StepSlopes s;
  // A change of rho changes the elastic slip and the flexibility: where it turns, and where it grows.
  const Pack elastic = step.advance.elastic * cell.x;
  const Pack elastic_x = elastic * step.rho_x, elastic_y = elastic * step.rho_y;
  const Pack bounds = 2.0 * (step.bound_before + cell.shape);
  const Pack d_by_angle = bounds * ((g.t11 - g.t22) * (step.rho_x * step.rho_y));
  s.kept = slope.kept - (slope.by_x * elastic_y + slope.by_y * elastic_x) + slope.by_d * d_by_angle;
  s.ahead_by_angle =
      slope.ahead_by_d * d_by_angle - (slope.ahead_by_x * elastic_y + slope.ahead_by_y * elastic_x);
  // the same where the traction grows along itself, which only one below the bound does
  s.by_ratio = s.ahead_by_ratio = zero;
  if (before.stuck) {
    const Pack x = elastic * before.ex, y = elastic * before.ey;
    const Pack d = bounds * (g.t11 * (step.rho_x * before.ex) + g.t22 * (step.rho_y * before.ey));
    s.by_ratio = slope.by_x * x - slope.by_y * y - slope.by_d * d;
    s.ahead_by_ratio = slope.ahead_by_x * x - slope.ahead_by_y * y - slope.ahead_by_d * d;
  }
  // resistance d = (sum of the bounds) times flexibility: relative, and by each of t11 and t22
  s.by_turning = slope.by_d * step.turn.d;
  s.ahead_by_turning = slope.ahead_by_d * step.turn.d;
  const Pack half_bounds = step.bound_before + cell.shape;
  const Pack d_by_t11 = half_bounds * (1.0 - step.rho_x * step.rho_x);
  const Pack d_by_t22 = half_bounds * (1.0 - step.rho_y * step.rho_y);
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
  if constexpr (entering) take_part_of_cell(g, cell, before, step, slope, s);
  return s;
}

/// Derivatives of the angle and of `ahead` after the step by input k: chain rule over turn().
template <bool entering>
WRC_IN_LOOP void turn_derivative(const StepSlopes& s, const Cell& cell, bool stuck, std::int32_t k,
                                 const Derivative& d, Pack& angle, Pack& ahead) {
  // zero parts are left out: spin alone changes the slip along the strip, lateral creepage none along x
  const Advance& a = d.over_cell;
  Pack wy = a.wy + s.bend * d.ahead;
  if (k == 2) wy += a.spin * cell.x + a.bend * s.ahead_before;
  angle = s.kept * d.angle + s.by_y * wy + s.by_turning * d.turning;
  ahead = s.ahead_by_angle * d.angle + s.ahead_by_y * wy + s.ahead_by_turning * d.turning;
  if (k != 1) {
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

/// Derivatives of the traction of lanes that stick: of its ratio to the bound, and of its angle.
template <bool entering, class Changes>
WRC_IN_LOOP void stick_derivative(const Group& g, const StepSlopes& s, const Cell& cell, const State& before,
                                  const State& after, const MarchStep& step, const Growth& over_cell,
                                  const Changes& d, Pack& ratio, Pack& angle) {
  // change of the growth over the step, at the onset also by the step's length dv
  const Pack zero = 0.0;
  const Pack middle = 2.0 * cell.x + step.dv;
  Pack gx = over_cell.gx, gy = over_cell.gy, curvature = over_cell.curvature, bound = zero;
  if constexpr (entering) {
    const Pack dv = select(s.partial, d.slip_end, zero);
    gx = s.share * gx + g.gx * dv;
    curvature = s.share * curvature + g.curvature * dv;
    gy = s.share * gy + (g.gy + step.advance.curvature) * dv;
    bound = s.bound_by_onset * d.slip_end;
  }
  // change of the trial traction: of rho before times the bound there, less growth; along e and across it
  const Pack dx = d.ratio * before.ex - step.rho_y * d.angle;
  const Pack dy = d.ratio * before.ey + step.rho_x * d.angle;
  const Pack x = dx * step.bound_before + step.rho_x * bound - gx;
  const Pack y = dy * step.bound_before + step.rho_y * bound - (gy + curvature * middle);
  ratio = select(step.stick, (after.ex * x + after.ey * y) * (1.0 / cell.shape), zero);
  angle = select(step.stick, (after.ex * y - after.ey * x) * step.inverse_trial, angle);
}

/// Weights of a cell's tractions in the sums.
struct CellMeans {
  Pack mean;                      ///< mean of the bound, as far as tractions have the march's direction
  Pack rho_x, rho_y;              ///< the same times the traction over the bound
  Pack x_by_s, y_by_s, y_by_psi;  ///< derivatives of the cell's force by s and psi
};

template <bool entering>
WRC_IN_LOOP CellMeans cell_means(const Group& g, const Cell& cell, Mask moving, const State& after,
                                 const MarchStep& step) {
  const Pack zero = 0.0;
  CellMeans m;
  m.mean = cell.mean;
  if constexpr (entering) {
    // force over mu p: mean ((1 - s) rho + s (0, psi))
    const Pack mean = select(moving, m.mean, zero);
    m.x_by_s = zero - mean * after.x();
    m.y_by_s = mean * (g.psi - after.y());
    m.y_by_psi = mean * step.shape.s;
    m.mean = mean * (1.0 - step.shape.s);
  }
  m.rho_x = m.mean * after.x();
  m.rho_y = m.mean * after.y();
  return m;
}

/// Derivatives by an input: those of the state are taken over, those of the cell's tractions added.
template <bool entering, class Changes>
WRC_IN_LOOP void end_derivative(const Group& g, Mask moving, const State& before, const State& after,
                                const MarchStep& step, const CellMeans& m, Pack ratio, Pack angle, Pack ahead,
                                Changes& d) {
  if (before.stuck || step.any_sticks) d.ratio = ratio;
  d.angle = entering ? select(moving, angle, d.angle) : angle;
  d.ahead = entering ? select(moving, ahead, d.ahead) : ahead;
  // rho turns by d.angle, and grows by ratio where it sticks
  Pack x = -(m.rho_y * d.angle), y = m.rho_x * d.angle;
  if (step.any_sticks) {
    x += m.mean * ratio * after.ex;
    y += m.mean * ratio * after.ey;
  }
  if constexpr (entering) {
    const Pack ds = step.shape.by_end * d.slip_end + step.shape.by_form * d.form;
    x += m.x_by_s * ds;
    y += m.y_by_s * ds + m.y_by_psi * d.psi;
    if (g.any_strong) cut_derivative(g, step.share, step.x, step.y, x, y);
  }
  add_cell(x, y, d.force);
}

/// The same step for the derivatives; `before`: the state it began with.
template <bool entering>
WRC_IN_LOOP void differentiate(const Group& g, const Cell& cell, Mask moving, const State& before,
                               const State& after, const MarchStep& step, Derivative (&derivative)[inputs]) {
  const Pack zero = 0.0;
  const StepSlopes s = step_slopes<entering>(g, cell, before, step);
  const CellMeans means = cell_means<entering>(g, cell, moving, after, step);
  for (std::int32_t k = 0; k < inputs; ++k) {
    Derivative& d = derivative[k];
    Pack angle, ahead, ratio = zero;
    turn_derivative<entering>(s, cell, before.stuck, k, d, angle, ahead);
    if (step.any_sticks)
      stick_derivative<entering>(g, s, cell, before, after, step,
                                 Growth{d.over_cell.gx, d.over_cell.gy, d.over_cell.curvature}, d, ratio,
                                 angle);
    end_derivative<entering>(g, moving, before, after, step, means, ratio, angle, ahead, d);
  }
}

/// Constants of the slip of a group's strips, for the fields.
struct SlipShape {
  Pack stick;                 ///< distance t at which slip begins
  Pack kappa, lambda;         ///< direction of the traction there
  Pack twice;                 ///< twice the factor across the patch (methods/slip_across.hpp); 0 without
                              ///< friction, where the slip has no direction
  Pack elastic_x, elastic_y;  ///< elastic slip at the leading edge along x and y
  Pack beside;                ///< lateral elastic slip at the middle by strips beside
  Pack per_even, per_odd;     ///< twice / (v + u_s - u) in a pair of cells, the first of even index
};

/// Sets the numbers that a task has of its strips; returns b k of methods/slip_across.hpp.
inline Pack set_slip(const StripFastsimTask& task, const Group& g, SlipShape& shape) {
  shape.elastic_x = (2.0 * task.l11) * g.slope;
  shape.elastic_y = (2.0 * task.l22) * g.slope;
  const Pack t = (g.y - task.middle) * task.per_width;
  shape.twice = 2.0 * tangential::slip_factor<Pack>(task.across_even, task.across_odd, t);
  return task.across_beside * g.curvature;
}
inline Pack set_slip(const SurfaceStripsTask& task, const Group& g, SlipShape& shape) {
  shape.elastic_x = load(task.edge_x, g.first, g.count, 0.0);
  shape.elastic_y = load(task.edge_y, g.first, g.count, 0.0);
  shape.twice = 2.0 * load(task.across, g.first, g.count, 0.0);
  return load(task.beside, g.first, g.count, 0.0);
}

template <class Task>
inline SlipShape slip_shape(const Task& task, const Group& g) {
  SlipShape shape;
  // growth (gx, gy + 2 k x) with the share b of k moved from 2 k x to the strip as a whole: gy + b k, k - b k
  const Pack moved = set_slip(task, g, shape), one = 1.0;
  const Pack curvature = g.curvature - moved;
  const tangential::AdhesionGrowth<Pack> growth{g.gx, g.gy + 2.0 * g.curvature - moved, curvature};
  const Pack end = tangential::slip_end_parabolic<Pack>(growth, one, one), per_end = one / (end + 1e-14);
  shape.stick = 2.0 - end;
  shape.kappa = -(g.gx * per_end);
  shape.lambda = -((g.gy + moved + curvature * end) * per_end);
  shape.beside = 0.5 * (moved * shape.elastic_y);
  shape.twice = select(g.bound > 0.0, shape.twice, 0.0);
  shape.per_even = shape.per_odd = 0.0;
  return shape;
}

/// Sets the inverses 2 / (v + u_s - u), times the factor across, of a pair of cells, of which `even` is the
/// first: one divide makes both.
inline void enter_pair(const Cell& even, SlipShape& shape) {
  // v + (u_s - u) with v = t and u_s - u = t - (2 - u_s), at the middles of both cells
  const double t_odd = even.t + even.h;
  const Pack of_even = even.t + larger(0.0, even.t - shape.stick);
  const Pack of_odd = t_odd + larger(0.0, t_odd - shape.stick);
  const Pack inverse = shape.twice / (of_even * of_odd);
  shape.per_even = of_odd * inverse;
  shape.per_odd = of_even * inverse;
}

/// Magnitude of the slip in a cell, before the scaling to the balance of power: rigid slip along the traction
/// plus the elastic slip, 2 B L x of a strip that slips as a whole and that by strips beside, times the form
/// of Carter's solution where only u < u_s slips, 2 sqrt(v (u_s - u)) / (v + u_s - u), and the factor by the
/// place across.
inline Pack slip_size(const Group& g, SlipShape& shape, const Cell& cell, Pack rho_x, Pack rho_y) {
  if ((cell.index & 1) == 0) enter_pair(cell, shape);
  const Pack zero = 0.0;
  const Pack along = g.wx * rho_x + ((g.wy + g.spin * cell.x) + shape.beside * (1.0 - 2.0 * cell.x)) * rho_y;
  const Pack elastic = cell.x * (shape.elastic_y + (shape.elastic_x - shape.elastic_y) * (rho_x * rho_x));
  // the first cell whose middle slips stands for half a cell to one and a half
  const Pack behind = larger(zero, cell.t - shape.stick);
  const Pack cells = select(behind < cell.h, 0.5 + cell.per_h * behind, Pack(1.0));
  const Pack per_sum = (cell.index & 1) != 0 ? shape.per_odd : shape.per_even;
  return larger(zero, zero - (along + elastic)) * cells * (root(behind * cell.t) * per_sum);
}

/// The first stick zone's share of a group's sums, from the sums over s.
inline void add_stick(const Group& g, const StickSums& s, Sums& sums) {
  // sums of rho = (kappa, lambda) (1 - s) + (0, psi) s times bound
  const Pack bent = s.mean - s.straight, t_bent = s.t_mean - s.t_straight;
  sums.force.stick_px += g.kappa * bent;
  sums.force.stick_py += g.lambda * bent + g.psi * s.straight;
  sums.force.stick_t_py += g.lambda * t_bent + g.psi * s.t_straight;
}

template <class Changes>
inline void add_stick_derivative(const Group& g, const StickSums& s, Changes& d) {
  const Pack bent = s.mean - s.straight, t_bent = s.t_mean - s.t_straight;
  // change of the sum of s times bound, and the same times t
  const Pack change = d.slip_end * s.slope + d.form * s.form;
  const Pack t_change = d.slip_end * s.t_slope + d.form * s.t_form;
  d.force.stick_px += d.kappa * bent - g.kappa * change;
  d.force.stick_py += d.lambda * bent + d.psi * s.straight + (g.psi - g.lambda) * change;
  d.force.stick_t_py += d.lambda * t_bent + d.psi * s.t_straight + (g.psi - g.lambda) * t_change;
}

/// A cell's traction, rho over the bound, and its slip against the unit vector (x, y), not yet scaled.
struct CellFields {
  Pack rho_x, rho_y, x, y, slip;
};

/// Stores them and adds to the power of the slip. A cell does not slip where its traction would aid that.
inline void store_cell(const StripFastsimMarch& task, const Group& g, const Cell& cell, const CellFields& f,
                       Sums& sums) {
  const Pack bound = cell.mean * g.bound, against = f.rho_x * f.x + f.rho_y * f.y;
  const Pack slip = select(against > 0.0, f.slip, 0.0);
  sums.power += (slip * against) * bound;
  simd::store_cell(*task.fields, g, cell.index, task.strips, bound * f.rho_x, bound * f.rho_y,
                   0.0 - slip * f.x, 0.0 - slip * f.y);
}

/// A group of strips during the march.
struct Marching {
  Group group;
  State state;
  StickSums stick;
  Sums sums;
  SlipShape slip;  ///< for fields
};

/// The part of a cell behind the turn: rest of the step, derivatives, fields.
template <bool entering, Output output>
WRC_IN_LOOP void settle(const StripFastsimMarch& task, const Cell& cell, Mask moves, MarchStep& step,
                        Marching& m, Derivative (&derivative)[inputs]) {
  constexpr bool sensitivities = output == Output::sensitivities;
  [[maybe_unused]] State before;
  if constexpr (sensitivities) before = m.state;
  // the march's step; strips whose first stick zone reaches into the cell have that part of the closed form
  if constexpr (entering) step.shape = stick_shape<sensitivities>(m.group, cell, m.stick);
  end_step<entering>(m.group, cell, moves, step, m.state, m.sums);
  if constexpr (sensitivities)
    differentiate<entering>(m.group, cell, moves, before, m.state, step, derivative);
  [[maybe_unused]] StickCell stuck;
  if constexpr (entering)
    stuck = stick<true, sensitivities>(m.group, cell, moves, step.shape, output == Output::fields, m.stick,
                                       m.sums, derivative);
  if constexpr (output == Output::fields) {
    // Slip against the traction of the march, or where a strip has not left its first stick zone, against
    // that at which its slip begins.
    CellFields f{step.x, step.y, m.state.x(), m.state.y(), {}};
    if constexpr (entering)
      f = {select(moves, f.rho_x, stuck.x),
           select(moves, f.rho_y, stuck.y),
           select(moves, f.x, m.slip.kappa),
           select(moves, f.y, m.slip.lambda),
           {}};
    f.slip = slip_size(m.group, m.slip, cell, f.x, f.y);
    if (step.any_sticks) f.slip = select(step.stick, 0.0, f.slip);
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
  if constexpr (fields) {
    CellFields f{stuck.x, stuck.y, m.slip.kappa, m.slip.lambda, 0.0};
    // no slip before the pair of cells in which a strip's slip begins
    const double end_of_pair = (cell.index & 1) == 0 ? cell.t + cell.h : cell.t;
    if (any(m.slip.stick < end_of_pair)) f.slip = slip_size(m.group, m.slip, cell, f.x, f.y);
    store_cell(task, m.group, cell, f, m.sums);
  }
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

/// The fields of slip, whose power is known as that of their distribution only, are scaled.
inline void scale_slip(const StripFastsimMarch& task, double scale) {
  const std::int32_t cells = task.strips * task.cells;
  double* const fields[] = {task.fields->slip_x, task.fields->slip_y};
  for (double* field : fields) {
    for (std::int32_t at = 0; field != nullptr && at < cells; at += lanes) {
      const std::int32_t count = cells - at < lanes ? cells - at : lanes;
      store(scale * load(field, at, count, 0.0), field + at, count);
    }
  }
}

/// Cell i of all strips.
inline Cell cell_of(const StripFastsimMarch& task, std::int32_t i) {
  // The bound of the cell before is computed again: a strip's bits must not depend on the cell at which the
  // march of its group began.
  const double h = 2.0 / task.cells, per_h = 0.5 * task.cells;
  const double t = (i + 0.5) * h, behind = task.cells - i - 1.0, shape = t * (2.0 - t);
  const double t_before = (i - 0.5) * h;
  return {i, t,     1.0 - t, t_before * (2.0 - t_before), shape, task.shape->mean[i],
          h, per_h, behind,  task.inverse_weight[i]};
}

/// Sums over the first stick zone that begin with its cells.
inline StickSums first_stick_sums(const StripFastsimMarch& task, const Group& g) {
  // (u / h - u_s / h) at the leading edge, u = 2
  StickSums sums = {};
  const Pack near = larger(0.0, task.cells - g.slip_end * (0.5 * task.cells));
  sums.root_near = root(near);
  sums.power_near = near * sums.root_near;
  return sums;
}

/// The parts of march_groups() that are strip FASTSIM's own.
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
  // fields have the distribution of slip; the balance of forces and creepages gives its size
  march_groups<output>(task, strip::March<output, Task>{task, total});
  const double power = strip::balance_of_power(task, total);
  if constexpr (output == Output::fields)
    strip::scale_slip(task, total.power_per_speed > 0.0 ? power / total.power_per_speed : 0.0);
  total.power_per_speed = power;
}

}  // namespace
}  // namespace wrc::simd
