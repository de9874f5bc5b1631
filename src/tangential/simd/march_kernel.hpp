/// The march of march.hpp for packs of strips, and its derivatives with respect to the creepages.
///
/// Along a strip everything is relative: distances t from the leading edge to the half length (0 .. 2, cells
/// h = 2 / cells), tractions to the bound at the strip's middle. Then cells and the shape of the bound are
/// the same for all strips, and a strip is three numbers, the growth (gx, gy - rate t) of its adhesion
/// tractions.
///
/// The state is the unit direction e of the traction and its size. With z = n / d, d the sum of two bounds,
/// all that the turning needs is homogeneous in n and d, and a rotation's length is known: a step takes two
/// roots (|g| at mid-step and as seen; a strip that sticks again needs the second one for |p|) and one
/// divide.
///
/// Derivatives: in slip the state is one angle, whose change dθ is carried for each input; see Turn.
#pragma once

#include "tangential/march_grid.hpp"
#include "tangential/simd/kernels.hpp"
#include "tangential/simd/pack.hpp"
#include "tangential/stick_zone.hpp"

namespace wrc::simd {
namespace {

/// Groups of strips that are marched side by side, so that one computes while another waits for a root.
constexpr std::int32_t in_flight = 4;

/// What does not change along the strips of a group.
struct Group {
  std::int32_t first, count;        ///< strips
  std::int32_t all_stick;           ///< cells before this one lie in the first stick zones of all strips
  Pack gx, gy, rate;                ///< growth of adhesion tractions: (gx, gy - rate t)
  Pack onset;                       ///< t at which the first stick zone ends
  Pack stick_cells;                 ///< whose middle lies before the onset
  Pack last_share;                  ///< of the last of these cells' tractions that is within the bound
  Pack lead, y, half_length, cell;  ///< x of the leading edge, y, half length [m], area of a cell [m^2]
  Pack bound;                       ///< traction bound at the strip's middle [Pa]
  Pack stiffness;                   ///< bound / half length: unit of growth [Pa/m]
};

/// What the march carries from cell to cell: the traction, and the bound where the last step ended.
struct State {
  Pack ex, ey, size, bound;
};

struct GroupSums {
  Pack px, py, t_py, power, slid;
};

/// Derivatives with respect to one input.
struct GroupDerivative {
  Pack gx, gy, rate, onset;
  Pack angle, size, bound;  ///< of the state
  Pack px, py, t_py;        ///< of the sums
};

/// A cell, the same for all strips.
struct Cell {
  double index, t;  ///< t at its middle
  double bound;     ///< mean over the cell
  double rise;      ///< of the bound along the cell, over h
};

/// Bound at t.
inline Pack bound_at(const MarchTask& task, Pack t) {
  const Pack shape = t * (2.0 - t);
  return task.parabolic ? shape : root(larger(0.0, shape));
}

/// Mean over a cell around t of the tractions of full adhesion.
inline void adhesion(Pack gx, Pack gy, Pack rate, Pack t, double h, Pack& px, Pack& py) {
  px = -(gx * t);
  py = -(gy * t - 0.5 * rate * (t * t + h * h / 12.0));
}

/// Sums of the tractions of full adhesion over the first n cells.
inline void adhesion_sums(Pack gx, Pack gy, Pack rate, Pack n, double h, Pack& px, Pack& py, Pack& t_py) {
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
inline void last_stick_cell(const MarchTask& task, const Group& g, double h, Pack& t, Pack& bound) {
  double cells[lanes], bounds[lanes];
  store_lanes(cells, g.stick_cells.v);
  for (std::int32_t k = 0; k < lanes; ++k) {
    const auto last = static_cast<std::int32_t>(cells[k]) - 1;
    bounds[k] = task.shape->mean[last < 0 ? 0 : last];
  }
  bound = load_lanes(bounds);
  t = (g.stick_cells - 0.5) * h;
}

inline void prepare(const MarchTask& task, std::int32_t first, std::int32_t count, Group& g, State& state,
                    GroupSums& sums) {
  constexpr double tiny_stress = 1e-6;  // [Pa]: frictionless strips slip at once without a division by zero
  const Strips& strips = *task.region;
  const double h = 2.0 / task.cells;
  g.first = first;
  g.count = count;
  // lanes without a strip: no pressure, no width, but a length to divide by
  g.half_length = load(strips.half_length, first, count, 1.0);
  g.lead = load(strips.centre, first, count, 0.0) + g.half_length;
  g.y = load(strips.y, first, count, 0.0);
  g.cell = g.half_length * h * load(strips.width, first, count, 0.0);
  const Pack share = task.shares ? load(task.shares, first, count, 0.0) : Pack(1.0);
  g.bound = (task.per_pressure * load(strips.peak, first, count, 0.0) +
             task.per_length_square * g.half_length * g.half_length) *
            share;
  g.stiffness = g.bound / g.half_length;
  const Pack scale = g.half_length / (g.bound + tiny_stress);
  g.gx = (task.gx_constant.value - task.gx_by_y.value * g.y) * scale;
  g.gy = (task.gy_constant.value + task.gy_by_x.value * g.lead) * scale;
  g.rate = task.gy_by_x.value * g.half_length * scale;
  const AdhesionGrowth<Pack> growth{g.gx, g.gy, 0.5 * g.rate};
  g.onset = task.parabolic ? onset_parabolic<Pack>(growth, 1.0, 1.0) : onset_elliptic<Pack>(growth, 1.0, 1.0);

  // The first stick zone, summed without marching. Where slip sets in just behind the middle of a cell, the
  // mean of the adhesion tractions over the cell may exceed that of the bound: it is cut.
  g.stick_cells = nearest_integer(g.onset * (0.5 * task.cells));
  adhesion_sums(g.gx, g.gy, g.rate, g.stick_cells, h, sums.px, sums.py, sums.t_py);
  Pack t, bound, px, py;
  last_stick_cell(task, g, h, t, bound);
  adhesion(g.gx, g.gy, g.rate, t, h, px, py);
  const Pack size = root(px * px + py * py);
  const Mask cut = (size > bound) & (g.stick_cells > 0.0);
  g.last_share = select(cut, bound / select(cut, size, 1.0), 1.0);
  const Pack excess = 1.0 - g.last_share;
  sums.px += -(excess * px);
  sums.py += -(excess * py);
  sums.t_py += -(excess * t * py);
  sums.power = 0.0;
  sums.slid = 0.0;

  double cells[lanes];
  store_lanes(cells, g.stick_cells.v);
  g.all_stick = task.cells;
  for (std::int32_t k = 0; k < count; ++k) {
    const auto own = static_cast<std::int32_t>(cells[k]);
    g.all_stick = own < g.all_stick ? own : g.all_stick;
  }

  // Traction at the onset of slip. Where a strip slips from its leading edge on, only the direction of the
  // (vanishing) traction matters, which is that of the adhesion tractions there.
  const Pack gy = g.gy - 0.5 * g.rate * g.onset;
  const Pack growth_size = root(g.gx * g.gx + gy * gy);
  const Mask grows = growth_size > 1e-150;
  const Pack inverse = 1.0 / select(grows, growth_size, 1.0);
  state.ex = select(grows, -(g.gx * inverse), 1.0);
  state.ey = select(grows, -(gy * inverse), 0.0);
  state.bound = bound_at(task, g.onset);
  state.size = state.bound;
}

/// Derivatives of what prepare() sets, for input k.
inline void differentiate(const MarchTask& task, std::int32_t k, const Group& g, GroupDerivative& d) {
  const double h = 2.0 / task.cells;
  const Pack zero = 0.0;
  const Pack unit = 1.0 / (g.stiffness + 1e-6 / g.half_length);
  d.gx = (task.gx_constant.d[k] - task.gx_by_y.d[k] * g.y) * unit;
  d.gy = (task.gy_constant.d[k] + task.gy_by_x.d[k] * g.lead) * unit;
  d.rate = task.gy_by_x.d[k] * g.half_length * unit;

  // onset: |p|^2 = bound^2, p = -v (gx, c)
  const Pack v = g.onset, c = g.gy - 0.5 * g.rate * v, c_input = d.gy - 0.5 * d.rate * v;
  const Pack by_input = 2.0 * v * (g.gx * d.gx + c * c_input);
  const Pack by_v = 2.0 * (g.gx * g.gx + c * c) - c * g.rate * v -
                    (task.parabolic ? 4.0 * (2.0 - v) * (1.0 - v) : 2.0 * (1.0 - v) / larger(v, 1e-300));
  const Mask inside = (v > zero) & (v < 2.0) & (magnitude(by_v) > 1e-280);
  d.onset = select(inside, -(by_input / select(inside, by_v, 1.0)), zero);

  // the state at the onset
  const Pack c_change = c_input - 0.5 * g.rate * d.onset;
  const Pack square = g.gx * g.gx + c * c;
  const Mask grows = square > 1e-280;
  d.angle = select(grows, (g.gx * c_change - c * d.gx) / select(grows, square, 1.0), zero);
  const Pack bound = bound_at(task, v);
  const Pack slope =
      task.parabolic ? 2.0 * (1.0 - v) : select(inside, (1.0 - v) / select(inside, bound, 1.0), zero);
  d.bound = slope * d.onset;
  d.size = d.bound;

  // the first stick zone, and its last cell where that is cut: the direction may turn, not the size grow
  adhesion_sums(d.gx, d.gy, d.rate, g.stick_cells, h, d.px, d.py, d.t_py);
  Pack t, cell_bound, px, py, dpx, dpy;
  last_stick_cell(task, g, h, t, cell_bound);
  adhesion(g.gx, g.gy, g.rate, t, h, px, py);
  adhesion(d.gx, d.gy, d.rate, t, h, dpx, dpy);
  const Mask cut = g.last_share < 1.0;
  const Pack along = (px * dpx + py * dpy) / select(cut, px * px + py * py, 1.0);
  const Pack cut_x = g.last_share * (dpx - px * along), cut_y = g.last_share * (dpy - py * along);
  d.px += select(cut, cut_x - dpx, zero);
  d.py += select(cut, cut_y - dpy, zero);
  d.t_py += select(cut, t * (cut_y - dpy), zero);
}

/// What a step computes on its way, for its derivatives. In slip e turns towards u = -G / |G|, G being g as a
/// direction that decays like 1 / q sees it, times w: the angle from u to e, delta, becomes
/// 2 atan(tan(delta/2) / q) with q = 1 + z + z^2/2 = Q / d^2.
struct Turn {
  Pack dv, gy_mid, g_mid;  ///< length of the step, g at its middle and the size of that
  Pack n, d, Q, w;         ///< z = n / d, w = 2 d + n
  Pack Gx, Gy, R, across;  ///< R = |G|, across = R sin(delta); where it sticks R = |p|
  Pack inverse;            ///< one over the length of the turned direction, T R; over |p| where it sticks
  Mask stick, moves;       ///< sticks again; has a new direction
};

/// A step's result beside the state.
struct Moved {
  Mask first_stick, slips;
  Pack size;    ///< of the traction; 0 in the first stick zone
  Pack lambda;  ///< excess of growth over what the bound allows, in slip
};

/// One march step of a group. Written without branches; a lane computes stick and slip and selects.
inline Moved step(const Group& g, const Cell& cell, double h, State& s, Turn& turn) {
  constexpr double largest_turn = 1e8;  // z beyond which the direction has long reached -g
  const Pack zero = 0.0;
  const Mask first_stick = Pack(cell.index + 0.5) < g.stick_cells;
  const Pack gy = g.gy - g.rate * cell.t;

  // from where the last step ended (or slip set in) to this cell
  const Pack dv = larger(zero, smaller(h, cell.t - g.onset));
  const Pack gy_mid = gy + 0.5 * g.rate * dv;
  const Pack trial_x = s.size * s.ex - dv * g.gx, trial_y = s.size * s.ey - dv * gy_mid;
  const Pack trial2 = trial_x * trial_x + trial_y * trial_y;
  const Mask stick = trial2 <= cell.bound * cell.bound;

  // slip: turn e towards -g. g, which itself turns under spin, is taken where a direction that decays like
  // 1 / q would see it: mid-step for small z, the cell itself for large z.
  const Pack g_mid = root(g.gx * g.gx + gy_mid * gy_mid);
  const Pack d = s.bound + cell.bound;
  const Pack n = smaller(2.0 * dv * g_mid, largest_turn * d);
  const Pack d2 = d * d, Q = d2 + d * n + 0.5 * (n * n), w = 2.0 * d + n;
  const Pack Gx = g.gx * w, Gy = gy * w + g.rate * dv * d;
  const Pack R = root(select(stick, trial2, Gx * Gx + Gy * Gy));
  const Pack along = -(s.ex * Gx + s.ey * Gy), across = Gy * s.ex - Gx * s.ey;
  const Pack ahead = larger(zero, R + along) * (Q * Q), behind = larger(zero, R - along) * (d2 * d2);
  const Pack towards = ahead - behind, aside = 2.0 * across * (Q * d2);
  const Pack T = larger(ahead + behind, magnitude(aside));
  const Pack length = select(stick, R, T * R);
  const Mask has_direction = length > 1e-280;  // not so where g vanishes: then the direction stays
  const Pack inverse = 1.0 / select(has_direction, length, 1.0);
  const Pack x = select(stick, trial_x, aside * Gy - towards * Gx) * inverse;
  const Pack y = select(stick, trial_y, -(towards * Gy) - aside * Gx) * inverse;
  // Unit length up to rounding, except where e is against u to the last digit; one step of Newton's method
  // for 1 / |e| keeps it from drifting, and never leaves it longer than one.
  const Pack unit = 1.5 - 0.5 * (x * x + y * y);
  const Mask moves = has_direction & !first_stick;
  s.ex = select(moves, x * unit, s.ex);
  s.ey = select(moves, y * unit, s.ey);
  const Pack size = select(stick, R, cell.bound);
  s.size = select(first_stick, s.size, size);
  s.bound = select(first_stick, s.bound, cell.bound);
  turn = {dv, gy_mid, g_mid, n, d, Q, w, Gx, Gy, R, across, inverse, stick, moves};

  const Mask slips = !(first_stick | stick);
  const Pack excess = larger(zero, -(g.gx * s.ex + gy * s.ey) - cell.rise);
  return {first_stick, slips, select(first_stick, zero, size), select(slips, excess, zero)};
}

/// The same step for the derivatives; `before`: the state it began with. In slip, chi the angle of -G,
///     d angle' = d chi + 2 Q d^2 R / T (d angle - d chi) - 2 across d^3 (d + n) / T dz.
inline void differentiate(const Group& g, const Cell& cell, double h, const State& before, const State& after,
                          const Turn& turn, const Moved& moved, GroupDerivative (&derivative)[inputs]) {
  const Pack zero = 0.0;
  const Mask entering = (turn.dv > zero) & (turn.dv < h);  // the step from the onset, which moves
  const Mask grows = turn.g_mid > 1e-150;
  const Pack by_g = 1.0 / select(grows, turn.g_mid, 1.0);
  const Pack by_d = 1.0 / turn.d, d_by_w = turn.d / turn.w;
  const Pack free = select(grows & (turn.n < 1e8 * turn.d), by_d, zero);  // z is capped elsewhere
  const Pack z_by_gx = 2.0 * turn.dv * free * by_g * g.gx,
             z_by_gy = 2.0 * turn.dv * free * by_g * turn.gy_mid;
  const Pack z_by_dv = 2.0 * turn.g_mid * free, z_by_bound = -(turn.n * by_d * free);
  const Pack ahead = turn.dv * d_by_w;  // of the cell, where g is taken
  const Pack seen_by_dv = g.rate * d_by_w, seen_by_z = -(g.rate * ahead * d_by_w);
  const Pack R_inverse = turn.R * turn.inverse, d2 = turn.d * turn.d;  // 1 / T
  const Pack kept = 2.0 * turn.Q * d2 * turn.R * R_inverse;
  const Pack by_z = 2.0 * turn.across * d2 * turn.d * (turn.d + turn.n) * R_inverse;
  const Pack square = turn.R * turn.R;
  const Pack to_chi = turn.w / select(square > 1e-280, square, 1.0);
  const Pack chi_by_x = -(to_chi * turn.Gy), chi_by_y = to_chi * turn.Gx;
  const Mask sticks = turn.stick & !moved.first_stick;
  const bool any_sticks = any(sticks);

  for (std::int32_t k = 0; k < inputs; ++k) {
    GroupDerivative& d = derivative[k];
    const Pack dv = select(entering, -d.onset, zero);
    const Pack gy = d.gy - d.rate * cell.t;
    const Pack gy_mid = gy + 0.5 * (d.rate * turn.dv + g.rate * dv);
    const Pack z = z_by_gx * d.gx + z_by_gy * gy_mid + z_by_dv * dv + z_by_bound * d.bound;
    const Pack gy_seen = gy + d.rate * ahead + seen_by_dv * dv + seen_by_z * z;
    const Pack chi = chi_by_x * d.gx + chi_by_y * gy_seen;
    Pack angle = chi + kept * (d.angle - chi) - by_z * z;
    Pack size = zero;
    if (any_sticks) {
      const Pack x = d.size * before.ex - before.size * before.ey * d.angle - turn.dv * d.gx - dv * g.gx;
      const Pack y =
          d.size * before.ey + before.size * before.ex * d.angle - turn.dv * gy_mid - dv * turn.gy_mid;
      size = select(sticks, after.ex * x + after.ey * y, zero);
      angle = select(sticks, (after.ex * y - after.ey * x) * turn.inverse, angle);
    }
    d.angle = select(turn.moves, angle, d.angle);
    d.size = select(moved.first_stick, d.size, size);
    d.bound = select(moved.first_stick, d.bound, zero);
    const Pack turned = moved.size * d.angle;
    const Pack x = size * after.ex - turned * after.ey, y = size * after.ey + turned * after.ex;
    d.px += x;
    d.py += y;
    d.t_py += cell.t * y;
  }
}

/// Adds a cell to the sums. The slip of the cell after the onset stands for everything slid since then.
inline void add(const MarchTask& task, const Cell& cell, const State& s, const Turn& turn, Moved& moved,
                GroupSums& sums) {
  const double h = 2.0 / task.cells, per_h = 0.5 * task.cells;
  const Pack part = select(turn.dv < h, 0.5 + per_h * turn.dv, 1.0);
  moved.lambda = moved.lambda * part;
  const Pack y = moved.size * s.ey;
  sums.px += moved.size * s.ex;
  sums.py += y;
  sums.t_py += cell.t * y;
  sums.power += moved.lambda * cell.bound * (task.l11 * (s.ex * s.ex) + task.l22 * (s.ey * s.ey));
  sums.slid += select(moved.slips, part, 0.0);
}

inline void store_field(Pack a, double* field, std::ptrdiff_t at, std::int32_t count) {
  if (field != nullptr) store(a, field + at, count);
}

/// Tractions and slip of a cell in lanes that have left the first stick zone, tractions of full adhesion in
/// the others.
inline void store_cell(const MarchTask& task, const Group& g, const Cell& cell, const State& s,
                       const Moved& moved) {
  const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(cell.index) * task.region->count + g.first;
  Pack px, py;
  adhesion(g.gx, g.gy, g.rate, cell.t, 2.0 / task.cells, px, py);
  const Pack share = select(Pack(cell.index + 1.5) < g.stick_cells, 1.0, g.last_share);
  const Pack slip = -(moved.lambda * g.stiffness);
  store_field(g.bound * select(moved.first_stick, share * px, moved.size * s.ex), task.fields->traction_x, at,
              g.count);
  store_field(g.bound * select(moved.first_stick, share * py, moved.size * s.ey), task.fields->traction_y, at,
              g.count);
  store_field(slip * task.l11 * s.ex, task.fields->slip_x, at, g.count);
  store_field(slip * task.l22 * s.ey, task.fields->slip_y, at, g.count);
}

/// The sums of a group, scaled to what they stand for and added strip by strip.
inline void add(const Group& g, const GroupSums& s, double cells, Sums& total) {
  const Pack force = g.bound * g.cell;
  double fx[lanes], fy[lanes], mz[lanes], power[lanes], cell[lanes], slid[lanes];
  store_lanes(fx, (force * s.px).v);
  store_lanes(fy, (force * s.py).v);
  store_lanes(mz, (force * (g.lead * s.py - g.half_length * s.t_py - g.y * s.px)).v);
  store_lanes(power, (force * g.stiffness * s.power).v);
  store_lanes(cell, g.cell.v);
  store_lanes(slid, (g.cell * s.slid).v);
  for (std::int32_t k = 0; k < g.count; ++k) {
    total.fx += fx[k];
    total.fy += fy[k];
    total.mz += mz[k];
    total.power_per_speed += power[k];
    total.area += cells * cell[k];
    total.slid_area += slid[k];
  }
}

inline void add(const Group& g, const GroupDerivative (&derivative)[inputs], Sums& total) {
  const Pack force = g.bound * g.cell;
  for (std::int32_t i = 0; i < inputs; ++i) {
    const GroupDerivative& d = derivative[i];
    double fx[lanes], fy[lanes], mz[lanes];
    store_lanes(fx, (force * d.px).v);
    store_lanes(fy, (force * d.py).v);
    store_lanes(mz, (force * (g.lead * d.py - g.half_length * d.t_py - g.y * d.px)).v);
    for (std::int32_t k = 0; k < g.count; ++k) {
      total.d[0][i] += fx[k];
      total.d[1][i] += fy[k];
      total.d[2][i] += mz[k];
    }
  }
}

/// One group of strips on its way.
struct Marching {
  Group group;
  State state;
  GroupSums sums;
};

template <bool sensitivities>
void march_kernel(const MarchTask& task, Sums& total) {
  total = {};
  const double h = 2.0 / task.cells, per_h = 0.5 * task.cells;
  const std::int32_t strips = task.region->count;
  const bool fields =
      task.fields->traction_x || task.fields->traction_y || task.fields->slip_x || task.fields->slip_y;
  for (std::int32_t first = 0; first < strips; first += in_flight * lanes) {
    Marching marching[in_flight];
    GroupDerivative derivative[sensitivities ? in_flight : 1][inputs];
    std::int32_t groups = 0;
    std::int32_t start = task.cells;  // no strip slips before
    for (std::int32_t at = first; at < strips && groups < in_flight; at += lanes, ++groups) {
      Marching& m = marching[groups];
      prepare(task, at, strips - at < lanes ? strips - at : lanes, m.group, m.state, m.sums);
      start = m.group.all_stick < start ? m.group.all_stick : start;
      if constexpr (sensitivities) {
        for (std::int32_t k = 0; k < inputs; ++k) differentiate(task, k, m.group, derivative[groups][k]);
      }
    }
    for (std::int32_t i = fields ? 0 : start; i < task.cells; ++i) {
      const Cell cell{static_cast<double>(i), (i + 0.5) * h, task.shape->mean[i],
                      per_h * task.shape->rise[i]};
      for (std::int32_t k = 0; k < groups; ++k) {
        Marching& m = marching[k];
        Moved moved{};
        if (i < m.group.all_stick) {
          if (!fields) continue;
          moved.first_stick = Pack(0.0) < 1.0;
          moved.size = moved.lambda = 0.0;
        } else {
          Turn turn;
          const State before = m.state;
          moved = step(m.group, cell, h, m.state, turn);
          add(task, cell, m.state, turn, moved, m.sums);
          if constexpr (sensitivities)
            differentiate(m.group, cell, h, before, m.state, turn, moved, derivative[k]);
        }
        if (fields) store_cell(task, m.group, cell, m.state, moved);
      }
    }
    for (std::int32_t k = 0; k < groups; ++k) {
      add(marching[k].group, marching[k].sums, task.cells, total);
      if constexpr (sensitivities) add(marching[k].group, derivative[k], total);
    }
  }
}

}  // namespace
}  // namespace wrc::simd
