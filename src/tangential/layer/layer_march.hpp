/// One cell of a march with a layer (layer.hpp), for plain numbers, packs of them, and numbers that carry
/// derivatives.
///
/// The bodies alone have the tractions of strip theory (strip_fastsim.hpp): with q the traction of FASTSIM,
/// under the parabolic bound B, and p that of the strip, under the bound E,
///     q / B = psi + (p / E - psi) (2 - t),
/// psi along y the traction of spin over E, and t the share of the way from psi to the circle of radius 1
/// that p / E has gone. Read as a spring, displacement over traction, this takes the layer's spring in
/// series:
///     u = b q E / B + f p,                              b, f: displacements by the bound.
/// Under a lower bound tau the circle shrinks to `reach` times tau: Carter's form would let the traction rise
/// only until it slips under E, yet material that yields behind pushes forwards that which sticks in front. A
/// strip whose bound is tau all along carries tanh f of full slip, f the force of linear theory over that of
/// full slip; `reach` = 1.25 keeps that within 0.05.
///
/// The end of the step is found as in plasticity: a trial that sticks; if that exceeds the bound, the excess
/// displacement flows (and hardens) or slides, and turns the traction against the slip.
#pragma once

#include <cstdint>

#include "base/number.hpp"
#include "tangential/layer/layer.hpp"

namespace wrc::tangential {

/// A cell, the same for all strips; tractions over the bound at the strip's middle.
struct LayerCell {
  double step;          ///< from the middle of the cell before, in half lengths
  double place;         ///< x of the step's middle over the half length
  double bound;         ///< mean of E over the cell
  double bound_before;  ///< that of the cell before, 0 ahead of the contact
  double elastic;       ///< mean of B over that of E
  double grows;         ///< bound over that of the cell before
  double per_rise;      ///< one over the bound's change, amount
  double per_step;      ///< one over the step
};

/// Cell i of a strip of so many, under a bound of that shape; `elastic`: B.
template <class Shape>
static LayerCell layer_cell(const Shape& shape, const Shape& elastic, std::int32_t cells, std::int32_t i) {
  // from the leading edge to the middle of the first cell, then from middle to middle
  const double h = 2.0 / cells;
  LayerCell cell;
  cell.step = i > 0 ? h : 0.5 * h;
  cell.place = i > 0 ? 1.0 - h * i : 1.0 - 0.25 * h;
  cell.bound = shape.mean[i];
  cell.bound_before = i > 0 ? shape.mean[i - 1] : 0.0;
  cell.elastic = elastic.mean[i] / cell.bound;
  cell.grows = i > 0 ? cell.bound / cell.bound_before : 1.0;
  const double rise = cell.bound - cell.bound_before, change = rise < 0.0 ? -rise : rise;
  cell.per_rise = 1.0 / (change > 1e-9 ? change : 1e-9);
  cell.per_step = 1.0 / cell.step;
  return cell;
}

/// Particles carry this from cell to cell.
template <class Number>
struct LayerState {
  Number ux, uy;  ///< displacement over the half length
  Number ex, ey;  ///< direction of the traction
  Number size;    ///< traction over the bound at the strip's middle
  Number yield;   ///< tau over that bound
  Number motion;  ///< size of the slip that moves particles, the same all along the strip [-]
};

/// Fresh particles at the leading edge.
template <class Number>
LayerState<Number> fresh_state(const LayeredStrip<Number>& strip) {
  using Of = LayeredNumbers;
  const Number none = 0.0, x = strip.of[Of::stick_x], y = strip.of[Of::stick_y],
               turn = strip.of[Of::stick_turn];
  return {none, none, none, none, none, strip.of[Of::yield], root(x * x + y * y + turn * turn + 1e-30)};
}

/// A cell of a strip: the spring, displacements over tractions, and the bound that holds.
template <class Number>
struct LayerSpring {
  static constexpr double tiny = 1e-30, reach = 1.25, inside = 0.95;

  Number limit;               ///< bound: the lower of E and tau
  Number bodies_x, bodies_y;  ///< displacement of the bodies per traction at the circle
  Number stiff_x, stiff_y;    ///< displacement of bodies and layer per traction there
  Number per_x, per_y;        ///< one over these
  Number square;              ///< squared radius of the circle less that of the centre
  Number centre;              ///< traction of spin, along y

  LayerSpring(const LayeredStrip<Number>& strip, const LayerCell& cell, const Number& yield) {
    using Of = LayeredNumbers;
    limit = smaller(Number(cell.bound), yield);
    bodies_x = cell.elastic * strip.of[Of::bodies_x];
    bodies_y = cell.elastic * strip.of[Of::bodies_y];
    stiff_x = bodies_x + strip.of[Of::spring_x] + tiny;
    stiff_y = bodies_y + strip.of[Of::spring_y] + tiny;
    const Number per_both = 1.0 / (stiff_x * stiff_y);
    per_x = stiff_y * per_both;
    per_y = stiff_x * per_both;
    // spin alone displaces by half its growth times u v, the parabola
    const Number radius = limit * (reach - ((reach - 1.0) / cell.bound) * limit), most = inside * radius;
    const Number of_spin = (-0.5 * cell.elastic * cell.bound) * (strip.of[Of::stick_turn] * per_y);
    centre = smaller(larger(of_spin, -most), most);
    square = radius * radius - centre * centre;
  }

  /// From the centre to the circle in the direction of a vector, times the vector's size; y: its part along
  /// y.
  Number ray(const Number& y, const Number& size_squared) const {
    const Number along = centre * y;
    return root(along * along + square * size_squared) - along;
  }

  /// Displacement by a traction on the bound.
  void displace(const LayerCell& cell, const Number& px, const Number& py, Number& ux, Number& uy) const {
    ux = px * stiff_x;
    uy = py * stiff_y;
    // below E that is within the circle, where the bodies give way further
    const auto within = value_of(limit) < cell.bound;
    if (!any(within)) return;
    const Number one = 1.0, off = py - centre, size_squared = px * px + off * off + tiny;
    const Number more = one - smaller(one, size_squared / ray(off, size_squared));
    ux = select(within, px * (stiff_x + bodies_x * more), ux);
    uy = select(within, centre * stiff_y + off * (stiff_y + bodies_y * more), uy);
  }
};

/// Traction of full adhesion for a displacement: on the way from the centre to the circle, or on it.
template <class Number>
struct LayerTrial {
  Number px, py, size, per_size;
  Number reached;  ///< displacement over that of the circle; from 1 on the traction stays there

  LayerTrial(const LayerSpring<Number>& spring, const Number& ux, const Number& uy) {
    // direction and size of the displacement beyond that of spin, over that per traction at the bound
    const Number one = 1.0, zero = 0.0;
    const Number dx = ux * spring.per_x, dy = uy * spring.per_y - spring.centre;
    const Number xx = dx * dx, yy = dy * dy + spring.tiny, square = xx + yy;
    reached = square / spring.ray(dy, square);  // size over ray
    // both sides times the size squared
    const Number bodies = spring.bodies_x * xx + spring.bodies_y * yy;
    const Number all = spring.stiff_x * xx + spring.stiff_y * yy;
    // size all = t ray (bodies (2 - t) + spring): the smaller root t
    const Number b = all + bodies;
    const Number under = root(larger(zero, b * b - 4.0 * (bodies * all) * smaller(one, reached)));
    const auto short_of_end = value_of(reached) < 1.0;
    const Number part = select(short_of_end, 2.0 * all, one) / select(short_of_end, b + under, reached);
    px = dx * part;
    py = spring.centre + dy * part;
    size = root(px * px + py * py + spring.tiny);
    per_size = one / size;
  }
};

/// Particles that slide or flow: from the trial to the state at the end of the step, in all lanes.
template <class Number>
void slide(const LayeredStrip<Number>& strip, const LayerCell& cell, const LayerSpring<Number>& spring,
           const LayerTrial<Number>& trial, const Number& ux, const Number& uy, LayerState<Number>& s) {
  using Of = LayeredNumbers;
  constexpr double tiny = LayerSpring<Number>::tiny;
  const Number zero = 0.0, one = 1.0, bound = cell.bound;
  // Excess of displacement over that of the bound in the trial's direction. As much flows as lets the bound
  // rise to meet it; where tau has just fallen below mu p within the cell, in part of the cell.
  const Number nx = trial.px * trial.per_size, ny = trial.py * trial.per_size;
  Number held_x, held_y;
  spring.displace(cell, spring.limit * nx, spring.limit * ny, held_x, held_y);
  const Number over_x = ux - held_x, over_y = uy - held_y;
  const Number over = root(over_x * over_x + over_y * over_y + tiny);
  const Number give = spring.stiff_x * (nx * nx) + spring.stiff_y * (ny * ny) + tiny;
  const auto yields = value_of(s.yield) < cell.bound;
  if (any(yields)) {
    const Number share = smaller(one, larger(zero, bound - s.yield) * cell.per_rise);
    const Number rise = larger(strip.of[Of::hardening] * give, Number(-0.5));
    const Number risen = s.yield + share * rise * over / ((one + rise) * give);
    s.yield = select(yields, larger(least_yield * strip.of[Of::yield], smaller(bound, risen)), s.yield);
  }
  const Number end = smaller(bound, s.yield);

  // Direction: that of the trial where slip sets in within the step, that before it where there was slip; it
  // turns against the slip over the rest of the step.
  const Number gap = give * larger(zero, smaller(spring.limit - s.size, spring.limit - cell.grows * s.size));
  const Number all = over + gap, fresh = gap + (0.05 * cell.step) * s.motion, per_both = one / (all * fresh);
  const Number part = over * fresh * per_both, anew = gap * all * per_both;
  const Number across = (cell.elastic * strip.of[Of::turn_x] + strip.of[Of::spring_x]) * (one - nx * nx) +
                        (cell.elastic * strip.of[Of::turn_y] + strip.of[Of::spring_y]) * (one - ny * ny);
  const Number resists = across * end, ahead = part * cell.step;
  const Number hx = (s.ex + anew * (nx - s.ex)) * resists - ahead * strip.of[Of::slip_x];
  const Number hy = (s.ey + anew * (ny - s.ey)) * resists -
                    ahead * (strip.of[Of::slip_y] + strip.of[Of::slip_turn] * cell.place);
  const Number per_h = one / root(hx * hx + hy * hy + tiny);
  s.ex = hx * per_h;
  s.ey = hy * per_h;
  s.size = end;
  spring.displace(cell, end * s.ex, end * s.ey, s.ux, s.uy);
}

/// Takes the particles of a strip to the next cell. Slip: of the wheel's surface along the rail's, sliding
/// and flow of the layer together, over the speed of rolling [-]. Returns whether there was neither.
template <class Number>
auto step_layer(const LayeredStrip<Number>& strip, const LayerCell& cell, LayerState<Number>& s,
                Number& slip_x, Number& slip_y) {
  using Of = LayeredNumbers;
  const Number zero = 0.0;
  // the trial: particles stick and move by the slip
  const LayerSpring<Number> spring(strip, cell, s.yield);
  const Number ux = s.ux - cell.step * strip.of[Of::stick_x];
  const Number uy = s.uy - cell.step * (strip.of[Of::stick_y] + strip.of[Of::stick_turn] * cell.place);
  const LayerTrial<Number> trial(spring, ux, uy);
  const auto below = value_of(trial.size) < value_of(spring.limit),
             short_of_end = value_of(trial.reached) < 1.0;
  const auto sticks = below & short_of_end;
  // those that do not stick end where slip or flow leaves them
  LayerState<Number> slid = s;
  slip_x = slip_y = zero;
  if (any(!sticks)) {
    slide(strip, cell, spring, trial, ux, uy, slid);
    slip_x = select(sticks, zero, cell.per_step * (slid.ux - ux));
    slip_y = select(sticks, zero, cell.per_step * (slid.uy - uy));
  }
  s.ex = select(sticks, trial.px * trial.per_size, slid.ex);
  s.ey = select(sticks, trial.py * trial.per_size, slid.ey);
  s.size = select(sticks, trial.size, slid.size);
  s.ux = select(sticks, ux, slid.ux);
  s.uy = select(sticks, uy, slid.uy);
  s.yield = select(sticks, s.yield, slid.yield);
  return sticks;
}

}  // namespace wrc::tangential
