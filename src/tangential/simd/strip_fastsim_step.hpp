/// A march step of strip FASTSIM (strip_fastsim_kernel.hpp), before and behind the turn of the traction's
/// direction (turning.hpp).
#pragma once

#include "base/pack.hpp"
#include "tangential/simd/strip_fastsim_start.hpp"
#include "tangential/simd/strip_fastsim_stick.hpp"
#include "tangential/simd/turning.hpp"

namespace wrc::simd {
namespace {

namespace strip {

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

}  // namespace strip

}  // namespace
}  // namespace wrc::simd
