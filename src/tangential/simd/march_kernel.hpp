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
#include "simd/pack.hpp"
#include "tangential/simd/turning.hpp"
#include "tangential/stick_zone.hpp"

namespace wrc::simd {
namespace {

/// Groups of strips that are marched side by side, so that one computes while another waits for a root.
constexpr std::int32_t in_flight = 4;

/// What does not change along the strips of a group.
struct Group {
  std::int32_t first, count;        ///< strips
  std::int32_t all_stick;           ///< cells before this one lie in the first stick zones of all strips
  std::int32_t all_move;            ///< cells from this one on begin where all strips have left theirs
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
  Pack ex, ey;  ///< direction of the traction
  Pack px, py;  ///< traction
  Pack bound;
};

struct GroupSums {
  Pack px, py, t_py, slid;
  Pack power, power_x;  ///< of slip against the bound, and the part of it along x
};

/// Derivatives with respect to one input.
struct GroupDerivative {
  Pack gx, gy, rate, onset;
  Pack angle, size, bound;  ///< of the state
  Pack px, py, t_py;        ///< of the sums
};

/// A cell, the same for all strips.
struct Cell {
  std::int32_t index;
  double t;             ///< at its middle
  double bound_before;  ///< of the cell before
  double bound;         ///< mean over the cell
  double rise;          ///< of the bound along the cell, over h
  double h, per_h;      ///< length, and one over it
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
  store_pack(cells, g.stick_cells);
  for (std::int32_t k = 0; k < lanes; ++k) {
    const auto last = static_cast<std::int32_t>(cells[k]) - 1;
    bounds[k] = task.shape->mean[last < 0 ? 0 : last];
  }
  bound = load_pack(bounds);
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
  g.bound = (task.per_pressure * load(strips.peak, first, count, 0.0) + task.per_length * g.half_length +
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
  sums.power_x = 0.0;
  sums.slid = 0.0;

  double cells[lanes];
  store_pack(cells, g.stick_cells);
  g.all_stick = task.cells;
  g.all_move = 0;
  for (std::int32_t k = 0; k < count; ++k) {
    const auto own = static_cast<std::int32_t>(cells[k]);
    g.all_stick = own < g.all_stick ? own : g.all_stick;
    g.all_move = own + 1 > g.all_move ? own + 1 : g.all_move;
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
  state.px = state.bound * state.ex;
  state.py = state.bound * state.ey;
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

/// A step's result beside the state.
struct Moved {
  Mask stick;
  Pack dv;      ///< length of the step
  Pack lambda;  ///< excess of growth over what the bound allows, in slip
};

/// One march step of a group. Written without branches; a lane computes stick and slip and selects. With
/// `entering`, lanes may still be in their first stick zone or just leave it; the others are `moving`.
template <bool entering>
inline Moved step(const Group& g, const Cell& cell, Mask moving, State& s, GroupSums& sums, Slip& slip,
                  Turn& turning) {
  const Pack zero = 0.0;
  Moved moved;
  moved.dv = entering ? larger(zero, smaller(cell.h, cell.t - g.onset)) : Pack(cell.h);
  const Pack gy = g.gy - g.rate * cell.t;
  slip = {moved.dv, g.gx, gy, g.rate * moved.dv, (entering ? s.bound : Pack(cell.bound_before)) + cell.bound};
  const Pack gy_mid = gy + 0.5 * slip.rate_dv;
  const Pack trial_x = s.px - moved.dv * g.gx, trial_y = s.py - moved.dv * gy_mid;
  const Pack trial2 = trial_x * trial_x + trial_y * trial_y;
  moved.stick = trial2 <= cell.bound * cell.bound;
  Pack ex = s.ex, ey = s.ey;
  turning = turn(slip, gy_mid, moved.stick, trial_x, trial_y, trial2, ex, ey);

  const Pack size = select(moved.stick, turning.R, cell.bound);
  const Pack px = size * ex, py = size * ey;
  const Pack excess = larger(zero, -cell.rise - (g.gx * ex + gy * ey));
  // the slip of the cell after the onset stands for everything slid since then
  const Pack part = entering ? select(moved.dv < cell.h, 0.5 + moved.dv * cell.per_h, 1.0) : Pack(1.0);
  const Mask slips = entering ? moving & !moved.stick : !moved.stick;
  moved.lambda = select(slips, part * excess, zero);
  const Pack lost = moved.lambda * cell.bound;

  if constexpr (entering) {
    s.ex = select(moving, ex, s.ex);
    s.ey = select(moving, ey, s.ey);
    s.px = select(moving, px, s.px);
    s.py = select(moving, py, s.py);
    s.bound = select(moving, cell.bound, s.bound);
  } else {
    s = {ex, ey, px, py, cell.bound};
  }
  sums.px += entering ? select(moving, px, zero) : px;
  sums.py += entering ? select(moving, py, zero) : py;
  sums.t_py += cell.t * (entering ? select(moving, py, zero) : py);
  sums.power += lost;
  sums.power_x += lost * (ex * ex);
  sums.slid += select(slips, part, zero);
  return moved;
}

/// The same step for the derivatives; `before`: the state it began with.
inline void differentiate(const Group& g, const Cell& cell, Mask moving, const State& before,
                          const State& after, const Slip& slip, const Turn& turning, const Moved& moved,
                          GroupDerivative (&derivative)[inputs]) {
  const Pack zero = 0.0;
  const Mask onset_moves = (moved.dv > zero) & (moved.dv < cell.h);
  const Mask turns = moving & turning.moves, sticks = moving & moved.stick;
  const TurnSlopes slope = slopes(slip, g.rate, turning);
  const bool any_sticks = any(sticks);
  for (std::int32_t k = 0; k < inputs; ++k) {
    GroupDerivative& d = derivative[k];
    const SlipChange change{select(onset_moves, -d.onset, zero), d.gx, d.gy - d.rate * cell.t, d.rate,
                            d.bound};
    Pack angle = turned(slope, d.angle, change), size = zero;
    if (any_sticks) {
      const Pack gy_mid = change.wy + 0.5 * (d.rate * moved.dv + g.rate * change.dv);
      const Pack x = d.size * before.ex - before.py * d.angle - moved.dv * d.gx - change.dv * g.gx;
      const Pack y =
          d.size * before.ey + before.px * d.angle - moved.dv * gy_mid - change.dv * turning.wy_mid;
      size = select(sticks, after.ex * x + after.ey * y, zero);
      angle = select(sticks, (after.ex * y - after.ey * x) * turning.inverse, angle);
    }
    d.angle = select(turns, angle, d.angle);
    d.size = select(moving, size, d.size);
    d.bound = select(moving, zero, d.bound);
    const Pack x = size * after.ex - after.py * d.angle, y = size * after.ey + after.px * d.angle;
    d.px += select(moving, x, zero);
    d.py += select(moving, y, zero);
    d.t_py += cell.t * select(moving, y, zero);
  }
}

inline void store_field(Pack a, double* field, std::ptrdiff_t at, std::int32_t count) {
  if (field != nullptr) store(a, field + at, count);
}

/// Tractions of full adhesion in a cell.
inline void first_stick(const Group& g, const Cell& cell, Pack& px, Pack& py) {
  adhesion(g.gx, g.gy, g.rate, cell.t, cell.h, px, py);
  const Pack share = select(Pack(cell.index + 1.5) < g.stick_cells, 1.0, g.last_share);
  px = share * px;
  py = share * py;
}

inline void store_cell(const MarchTask& task, const Group& g, const Cell& cell, Pack px, Pack py, Pack sx,
                       Pack sy) {
  const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(cell.index) * task.region->count + g.first;
  store_field(g.bound * px, task.fields->traction_x, at, g.count);
  store_field(g.bound * py, task.fields->traction_y, at, g.count);
  store_field(g.stiffness * sx, task.fields->slip_x, at, g.count);
  store_field(g.stiffness * sy, task.fields->slip_y, at, g.count);
}

/// The sums of a group, scaled to what they stand for and added strip by strip.
inline void add(const MarchTask& task, const Group& g, const GroupSums& s, Sums& total) {
  const Pack force = g.bound * g.cell;
  double fx[lanes], fy[lanes], mz[lanes], power[lanes], cell[lanes], slid[lanes];
  store_pack(fx, force * s.px);
  store_pack(fy, force * s.py);
  store_pack(mz, force * (g.lead * s.py - g.half_length * s.t_py - g.y * s.px));
  store_pack(power, force * g.stiffness * (task.l22 * s.power + (task.l11 - task.l22) * s.power_x));
  store_pack(cell, g.cell);
  store_pack(slid, g.cell * s.slid);
  for (std::int32_t k = 0; k < g.count; ++k) {
    total.fx += fx[k];
    total.fy += fy[k];
    total.mz += mz[k];
    total.power_per_speed += power[k];
    total.area += task.cells * cell[k];
    total.slid_area += slid[k];
  }
}

inline void add(const Group& g, const GroupDerivative (&derivative)[inputs], Sums& total) {
  const Pack force = g.bound * g.cell;
  for (std::int32_t i = 0; i < inputs; ++i) {
    const GroupDerivative& d = derivative[i];
    double fx[lanes], fy[lanes], mz[lanes];
    store_pack(fx, force * d.px);
    store_pack(fy, force * d.py);
    store_pack(mz, force * (g.lead * d.py - g.half_length * d.t_py - g.y * d.px));
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
  const double* mean = task.shape->mean;
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
      const Cell cell{i, (i + 0.5) * h, i > 0 ? mean[i - 1] : 0.0, mean[i], per_h * task.shape->rise[i],
                      h, per_h};
      for (std::int32_t k = 0; k < groups; ++k) {
        Marching& m = marching[k];
        if (i < m.group.all_stick) {
          if (!fields) continue;
          Pack px, py;
          first_stick(m.group, cell, px, py);
          store_cell(task, m.group, cell, px, py, 0.0, 0.0);
          continue;
        }
        Slip slip;
        Turn turning;
        const State before = m.state;
        const bool entering = i < m.group.all_move;
        const Mask moving = m.group.stick_cells <= Pack(i);
        const Moved moved = entering ? step<true>(m.group, cell, moving, m.state, m.sums, slip, turning)
                                     : step<false>(m.group, cell, moving, m.state, m.sums, slip, turning);
        if constexpr (sensitivities)
          differentiate(m.group, cell, moving, before, m.state, slip, turning, moved, derivative[k]);
        if (fields) {
          const State& s = m.state;
          Pack px = s.px, py = s.py;
          if (entering) {
            Pack stick_x, stick_y;
            first_stick(m.group, cell, stick_x, stick_y);
            px = select(moving, px, stick_x);
            py = select(moving, py, stick_y);
          }
          store_cell(task, m.group, cell, px, py, 0.0 - moved.lambda * task.l11 * s.ex,
                     0.0 - moved.lambda * task.l22 * s.ey);
        }
      }
    }
    for (std::int32_t k = 0; k < groups; ++k) {
      add(task, marching[k].group, marching[k].sums, total);
      if constexpr (sensitivities) add(marching[k].group, derivative[k], total);
    }
  }
}

}  // namespace
}  // namespace wrc::simd
