/// Derivatives of a march step of strip FASTSIM (strip_fastsim_step.hpp): of its numbers, which all inputs
/// share, and by the creepages. surface_strips_slopes_kernel.hpp has those by the numbers of each strip.
#pragma once

#include "base/pack.hpp"
#include "tangential/simd/strip_fastsim_start.hpp"
#include "tangential/simd/strip_fastsim_step.hpp"
#include "tangential/simd/strip_fastsim_stick.hpp"
#include "tangential/simd/turning.hpp"

namespace wrc::simd {
namespace {

namespace strip {

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

/// Derivatives by an input: those of the state are taken over, those of the cell's tractions added. `onset`:
/// does the input move the end of the stick zone, or the tractions in it?
template <bool entering, bool onset, class Changes>
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
    if constexpr (onset) {
      const Pack ds = step.shape.by_end * d.slip_end + step.shape.by_form * d.form;
      x += m.x_by_s * ds;
      y += m.y_by_s * ds + m.y_by_psi * d.psi;
    }
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
    end_derivative<entering, entering>(g, moving, before, after, step, means, ratio, angle, ahead, d);
  }
}

}  // namespace strip

}  // namespace
}  // namespace wrc::simd
