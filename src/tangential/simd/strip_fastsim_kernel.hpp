/// Strip FASTSIM for packs of strips, and its derivatives with respect to the creepages.
///
/// As in march_kernel.hpp all is relative: t and u = 2 - t to the half length, x = 1 - t; tractions of the
/// march to the parabolic bound at the strip's middle, which makes that bound u t in every strip. rho is the
/// traction over the bound, of the march and of the result alike.
///
/// The first stick zone needs no march, but per cell the mean of a root: with t_s = u_s / u,
///     rho = (kappa, lambda) (1 - s) + (0, psi) s,   s the mean of sqrt(1 - t_s) (and a little of its
///     square),
/// so that its sums, and their derivatives, are made of sums of s and of its slope.
#pragma once

#include "tangential/march_grid.hpp"
#include "tangential/simd/kernels.hpp"
#include "tangential/simd/march_kernel.hpp"
#include "simd/pack.hpp"
#include "tangential/simd/turning.hpp"
#include "tangential/stick_zone.hpp"

namespace wrc::simd {
namespace {

namespace strip {

constexpr double tiny_stress = 1e-6;  // [Pa]: keeps divisions finite, far below any stress of interest

/// What does not change along the strips of a group.
struct Group {
  std::int32_t first, count;
  std::int32_t all_stick, all_move, last_stick;  ///< cells, as in the march; last_stick: of any strip
  bool any_strong;                               ///< the stick zone of a strip may reach the bound
  Pack gx, gy, curvature;                        ///< growth of adhesion tractions (gx, gy + 2 curvature x)
  Pack slip_end, stick_cells;                    ///< u_s; cells whose middle lies before it
  Pack kappa, lambda, psi;
  Mask strong;        ///< |psi| > 1
  Pack wx, wy, spin;  ///< rigid slip (wx, wy + spin x)
  Pack elastic;       ///< that part of the elastic slip which differs between x and y, at the leading edge
  Pack slope;         ///< B l [Pa/m]
  Pack near_edge;     ///< tractions of adhesion over the bound at the leading edge, squared; at most 1
  Pack form;          ///< share of FASTSIM's form 1 - t in strip theory's sqrt(1 - t)
  Pack t11, t22;      ///< flexibilities for the turning of slip, relative
  Pack centre, y, half_length, cell, bound;
  Pack scale;  ///< of growth, to be relative [m/Pa]
};

struct State {
  Pack ex, ey;         ///< direction of the traction
  Pack rho_x, rho_y;   ///< traction over bound
  Pack px, py, bound;  ///< the traction of the march and its bound
};

/// Sums over the first stick zone; those of slopes are for the derivatives.
struct StickSums {
  Pack bent, t_bent;           ///< of (1 - s)
  Pack straight, t_straight;   ///< of s
  Pack slope, t_slope;         ///< of ds / du_s
  Pack form, t_form;           ///< of ds / d(stick form)
  Pack power_near, root_near;  ///< (u / h - u_s / h)^(3/2) and ^(1/2) at the next cell's leading border
};

struct Sums {
  Pack px, py, t_py, slid, power;
};

struct Derivative {
  Pack gx, gy, curvature, slip_end, kappa, lambda, psi, wx, wy, spin;
  double turning;  ///< relative
  Pack form;
  Pack angle, ratio, bound;  ///< of the state; ratio = |rho|
  Pack px, py, t_py;         ///< of the sums
};

/// A cell, the same for all strips.
struct Cell {
  std::int32_t index;
  double t, x;                 ///< at its middle
  double shape_before, shape;  ///< of the march's bound, at the middle of the cell before and of this one
  double per_shape;
  double mean;  ///< of the bound mu p
  double h, per_h;
  double behind, inverse_weight;  ///< u / h at its trailing border; of the mean of sqrt(1 - t_s)
};

inline void prepare(const StripFastsimTask& task, std::int32_t first, std::int32_t count, Group& g,
                    State& state) {
  const Strips& strips = *task.region;
  const double h = 2.0 / task.cells;
  const Pack zero = 0.0, one = 1.0;
  g.first = first;
  g.count = count;
  g.half_length = load(strips.half_length, first, count, 1.0);
  g.centre = load(strips.centre, first, count, 0.0);
  g.y = load(strips.y, first, count, 0.0);
  g.cell = g.half_length * h * load(strips.width, first, count, 0.0);
  const Pack share = task.shares ? load(task.shares, first, count, 0.0) : one;
  g.bound = task.friction * (share * load(strips.peak, first, count, 0.0));
  g.slope = task.B * share * g.half_length;
  const Pack middle = g.slope * g.half_length + tiny_stress;
  g.scale = g.half_length / middle;
  g.gx = (task.gx_constant.value - task.gx_by_y.value * g.y) * g.scale;
  g.gy = (task.gy_constant.value + task.gy_by_x.value * g.centre) * g.scale;
  g.curvature = 0.5 * task.gy_by_x.value * g.half_length * g.scale;
  g.wx = task.nu_x - task.phi * g.y;
  g.wy = task.nu_y + task.phi * g.centre + task.torsion.value;
  g.spin = task.phi * g.half_length;
  g.elastic = task.elastic * share * g.half_length;
  g.t11 = task.turning.value * task.t11 / g.scale;
  g.t22 = task.turning.value * task.t22 / g.scale;

  // A strip about to slip at the leading edge may, with |psi| > 1, have sticking material behind it, to which
  // the march gives FASTSIM's form: the closed form must arrive there too, or forces jump strip by strip.
  const Pack lead = g.gy + 2.0 * g.curvature;
  g.near_edge = smaller(one, 0.25 * (g.gx * g.gx + lead * lead));
  const Pack near2 = g.near_edge * g.near_edge;
  g.form = near2 * near2;

  const AdhesionGrowth<Pack> growth{g.gx, lead, g.curvature};
  g.slip_end = slip_end_parabolic<Pack>(growth, one, one);
  g.stick_cells = nearest_integer((2.0 - g.slip_end) * (0.5 * task.cells));
  double cells[lanes];
  store_pack(cells, g.stick_cells);
  g.all_stick = task.cells;
  g.last_stick = 0;
  for (std::int32_t k = 0; k < count; ++k) {
    const auto own = static_cast<std::int32_t>(cells[k]);
    g.all_stick = own < g.all_stick ? own : g.all_stick;
    g.last_stick = own > g.last_stick ? own : g.last_stick;
  }
  g.all_move = g.last_stick + 1;

  const Pack per_end = one / (g.slip_end + tiny_stress / middle);
  const Pack gy_end = g.gy + g.curvature * g.slip_end;
  g.kappa = -(g.gx * per_end);
  g.lambda = -(gy_end * per_end);
  g.psi = -g.curvature;
  g.strong = (magnitude(g.psi) > one) & (g.stick_cells > zero);
  g.any_strong = any(g.strong);

  // A strip that slips from its leading edge on starts against the slip there, whose elastic part depends on
  // the direction itself: three substitutions settle it.
  const Mask at_edge = g.slip_end >= 2.0;
  Pack ex = g.kappa, ey = g.lambda;
  for (int n = 0; n < 4; ++n) {
    Pack wx = g.gx, wy = gy_end;  // n == 0: against the growth at u_s
    if (n > 0) {
      wx = select(at_edge, n == 1 ? g.wx : g.wx + g.elastic * ex, g.gx);
      wy = select(at_edge, n == 1 ? g.wy + g.spin : g.wy + g.spin - g.elastic * ey, gy_end);
    }
    const Pack inverse = one / (root(wx * wx + wy * wy) + 1e-100);
    ex = -(wx * inverse);
    ey = -(wy * inverse);
  }
  const Pack bound = g.slip_end * (2.0 - g.slip_end);
  state = {ex, ey, ex, ey, bound * ex, bound * ey, bound};
}

/// Change of the angle of -(x, y).
inline Pack angle_of(Pack x, Pack y, Pack dx, Pack dy) {
  const Pack square = x * x + y * y;
  const Mask turns = square > 1e-280;
  return select(turns, (x * dy - y * dx) / select(turns, square, 1.0), 0.0);
}

/// Derivatives of what prepare() sets, for input k.
inline void differentiate(const StripFastsimTask& task, std::int32_t k, const Group& g, Derivative& d) {
  const Pack zero = 0.0;
  d = {};
  d.gx = (task.gx_constant.d[k] - task.gx_by_y.d[k] * g.y) * g.scale;
  d.gy = (task.gy_constant.d[k] + task.gy_by_x.d[k] * g.centre) * g.scale;
  d.curvature = 0.5 * task.gy_by_x.d[k] * g.half_length * g.scale;
  if (k == 0) d.wx = 1.0;
  if (k == 1) d.wy = 1.0;
  if (k == 2) {
    d.wx = -g.y;
    d.wy = g.centre;
    d.spin = g.half_length;
  }
  d.wy += task.torsion.d[k];
  d.turning = task.turning.d[k] / task.turning.value;
  const Pack lead = g.gy + 2.0 * g.curvature, d_lead = d.gy + 2.0 * d.curvature;
  const Pack d_near = select(g.near_edge < 1.0, 0.5 * (g.gx * d.gx + lead * d_lead), zero);
  d.form = 4.0 * (g.near_edge * g.near_edge * g.near_edge) * d_near;

  // u_s: gx^2 + c^2 = u^2, c = gy + curvature u
  const Pack u = g.slip_end, c = g.gy + g.curvature * u;
  const Pack by_u = u - c * g.curvature;
  const Mask inside = (u > zero) & (u < 2.0) & (magnitude(by_u) > 1e-280);
  const Pack c_input = d.gy + d.curvature * u;
  d.slip_end = select(inside, (g.gx * d.gx + c * c_input) / select(inside, by_u, 1.0), zero);
  const Pack c_change = c_input + g.curvature * d.slip_end;
  const Pack per_end = 1.0 / (u + 1e-14);
  d.kappa = -((d.gx + g.kappa * d.slip_end) * per_end);
  d.lambda = -((c_change + g.lambda * d.slip_end) * per_end);
  d.psi = -d.curvature;

  d.angle = angle_of(g.gx, c, d.gx, c_change);
  const Mask at_edge = u >= 2.0;
  if (any(at_edge)) {
    Pack wx = g.wx, wy = g.wy + g.spin, dwx = d.wx, dwy = d.wy + d.spin, angle = zero;
    for (int n = 0; n < 3; ++n) {
      angle = angle_of(wx, wy, dwx, dwy);
      const Pack inverse = 1.0 / (root(wx * wx + wy * wy) + 1e-100);
      const Pack ex = -(wx * inverse), ey = -(wy * inverse);
      wx = g.wx + g.elastic * ex;
      wy = g.wy + g.spin - g.elastic * ey;
      dwx = d.wx - g.elastic * ey * angle;
      dwy = d.wy + d.spin - g.elastic * ex * angle;
    }
    d.angle = select(at_edge, angle, d.angle);
  }
  d.bound = 2.0 * (1.0 - u) * d.slip_end;
}

/// Traction over bound in the first stick zone; at most one, which |psi| > 1 could exceed.
struct StickCell {
  Pack s, x, y, share;  ///< rho = share (x, y)
};

/// Adds a cell of the first stick zone.
template <bool sensitivities>
inline void stick(const Group& g, const Cell& cell, bool wanted, StickSums& sums, Sums& strong,
                  Derivative* derivative, StickCell& result) {
  const Pack zero = 0.0, one = 1.0;
  const Pack form = g.form;
  // The mean of sqrt(1 - t_s) = sqrt((u - u_s) / u) over the cell, weighted by the bound's sqrt(u): small
  // creepages leave a traction 1 / sqrt(u) at the trailing edge, of which the middle of a cell sees too
  // little.
  const Pack far = larger(zero, cell.behind - g.slip_end * cell.per_h);
  const Pack root_far = root(far), power_far = far * root_far;
  const Pack whole = (sums.power_near - power_far) * cell.inverse_weight;
  const Pack s = whole * (1.0 - form + form * whole);
  const Mask here = Pack(cell.index + 0.5) < g.stick_cells;
  const Pack bent = select(here, cell.mean * (one - s), zero), straight = select(here, cell.mean * s, zero);
  sums.bent += bent;
  sums.t_bent += cell.t * bent;
  sums.straight += straight;
  sums.t_straight += cell.t * straight;
  [[maybe_unused]] Pack by_end, by_form;
  if constexpr (sensitivities) {
    by_end = -1.5 * cell.per_h * cell.inverse_weight * (sums.root_near - root_far) *
             (1.0 - form + 2.0 * form * whole);
    by_form = whole * whole - whole;
    const Pack slope = select(here, cell.mean * by_end, zero),
               of_form = select(here, cell.mean * by_form, zero);
    sums.slope += slope;
    sums.t_slope += cell.t * slope;
    sums.form += of_form;
    sums.t_form += cell.t * of_form;
    sums.root_near = root_far;
  }
  sums.power_near = power_far;
  if (!wanted && !g.any_strong) return;

  const Pack x = g.kappa * (one - s), y = g.lambda * (one - s) + g.psi * s;
  const Pack size = root(larger(one, x * x + y * y));
  const Pack share = select(g.strong, one / size, one);
  result = {s, x, y, share};
  if (!g.any_strong) return;
  const Pack less = select(here, cell.mean * (share - one), zero);
  strong.px += less * x;
  strong.py += less * y;
  strong.t_py += cell.t * (less * y);
  if constexpr (sensitivities) {
    const Mask cut = here & g.strong & (size > one);
    for (std::int32_t k = 0; k < inputs; ++k) {
      Derivative& d = derivative[k];
      const Pack ds = by_end * d.slip_end + by_form * d.form;
      const Pack dx = d.kappa * (one - s) - g.kappa * ds;
      const Pack dy = d.lambda * (one - s) + d.psi * s + (g.psi - g.lambda) * ds;
      const Pack along = (x * dx + y * dy) * share * share;
      const Pack more_x = select(cut, cell.mean * (share * (dx - x * along) - dx), zero);
      const Pack more_y = select(cut, cell.mean * (share * (dy - y * along) - dy), zero);
      d.px += more_x;
      d.py += more_y;
      d.t_py += cell.t * more_y;
    }
  }
}

struct Moved {
  Mask stick, slips;
  Pack dv, part;  ///< length of the step; of a cell that has slid since the last cell
  Pack flexibility;
};

/// One march step of a group through slip; see march_kernel.hpp.
template <bool entering>
inline Moved step(const Group& g, const Cell& cell, Mask moving, State& s, Sums& sums, Slip& slip,
                  Turn& turning) {
  const Pack zero = 0.0, one = 1.0;
  Moved moved;
  moved.dv = entering ? larger(zero, smaller(cell.h, g.slip_end - (2.0 - cell.t))) : Pack(cell.h);
  moved.flexibility = g.t11 * (one - s.rho_x * s.rho_x) + g.t22 * (one - s.rho_y * s.rho_y);
  const Pack elastic = g.elastic * cell.x;
  const Pack wx = g.wx + elastic * s.rho_x, wy = g.wy + g.spin * cell.x - elastic * s.rho_y;
  const Pack bounds = (entering ? s.bound : Pack(cell.shape_before)) + cell.shape;
  slip = {moved.dv, wx, wy, g.spin * moved.dv, bounds * moved.flexibility};
  const Pack trial_x = s.px - moved.dv * g.gx;
  const Pack trial_y = s.py - moved.dv * (g.gy + g.curvature * (2.0 * cell.x + moved.dv));
  const Pack trial2 = trial_x * trial_x + trial_y * trial_y;
  moved.stick = trial2 <= cell.shape * cell.shape;
  Pack ex = s.ex, ey = s.ey;
  turning = turn(slip, wy + 0.5 * slip.rate_dv, moved.stick, trial_x, trial_y, trial2, ex, ey);

  const Pack ratio = select(moved.stick, turning.R * cell.per_shape, one);
  const State after{
      ex, ey, ratio * ex, ratio * ey, cell.shape * (ratio * ex), cell.shape * (ratio * ey), cell.shape};
  moved.part = entering ? select(moved.dv < cell.h, 0.5 + moved.dv * cell.per_h, one) : one;
  moved.slips = entering ? moving & !moved.stick : !moved.stick;
  if constexpr (entering) {
    s.ex = select(moving, after.ex, s.ex);
    s.ey = select(moving, after.ey, s.ey);
    s.rho_x = select(moving, after.rho_x, s.rho_x);
    s.rho_y = select(moving, after.rho_y, s.rho_y);
    s.px = select(moving, after.px, s.px);
    s.py = select(moving, after.py, s.py);
    s.bound = select(moving, cell.shape, s.bound);
  } else {
    s = after;
  }
  const Pack x = cell.mean * after.rho_x, y = cell.mean * after.rho_y;
  sums.px += entering ? select(moving, x, zero) : x;
  sums.py += entering ? select(moving, y, zero) : y;
  sums.t_py += cell.t * (entering ? select(moving, y, zero) : y);
  sums.slid += select(moved.slips, moved.part, zero);
  return moved;
}

/// The same step for the derivatives; `before`: the state it began with.
inline void differentiate(const Group& g, const Cell& cell, Mask moving, const State& before,
                          const State& after, const Slip& slip, const Turn& turning, const Moved& moved,
                          Derivative (&derivative)[inputs]) {
  const Pack zero = 0.0;
  const Mask end_moves = (moved.dv > zero) & (moved.dv < cell.h);
  const Mask turns = moving & turning.moves, sticks = moving & moved.stick;
  const TurnSlopes slope = slopes(slip, g.spin, turning);
  const bool any_sticks = any(sticks);
  const Pack bounds = before.bound + cell.shape;
  const Pack d_by_x = -2.0 * bounds * g.t11 * before.rho_x, d_by_y = -2.0 * bounds * g.t22 * before.rho_y;
  const Pack elastic = g.elastic * cell.x;
  for (std::int32_t k = 0; k < inputs; ++k) {
    Derivative& d = derivative[k];
    const Pack rho_x = d.ratio * before.ex - before.rho_y * d.angle;
    const Pack rho_y = d.ratio * before.ey + before.rho_x * d.angle;
    const SlipChange change{
        select(end_moves, d.slip_end, zero), d.wx + elastic * rho_x, d.wy + d.spin * cell.x - elastic * rho_y,
        d.spin, d.bound * moved.flexibility + slip.d * d.turning + d_by_x * rho_x + d_by_y * rho_y};
    Pack angle = turned(slope, d.angle, change), ratio = zero;
    if (any_sticks) {
      const Pack middle = 2.0 * cell.x + moved.dv;
      const Pack x = rho_x * before.bound + before.rho_x * d.bound - moved.dv * d.gx - change.dv * g.gx;
      const Pack y = rho_y * before.bound + before.rho_y * d.bound -
                     moved.dv * (d.gy + d.curvature * middle + g.curvature * change.dv) -
                     change.dv * (g.gy + g.curvature * middle);
      ratio = select(sticks, (after.ex * x + after.ey * y) * cell.per_shape, zero);
      angle = select(sticks, (after.ex * y - after.ey * x) * turning.inverse, angle);
    }
    d.angle = select(turns, angle, d.angle);
    d.ratio = select(moving, ratio, d.ratio);
    d.bound = select(moving, zero, d.bound);
    const Pack x = cell.mean * (d.ratio * after.ex - after.rho_y * d.angle);
    const Pack y = cell.mean * (d.ratio * after.ey + after.rho_x * d.angle);
    d.px += select(moving, x, zero);
    d.py += select(moving, y, zero);
    d.t_py += cell.t * select(moving, y, zero);
  }
}

/// Magnitude of the slip in a slipping cell, before the scaling to the balance of power: rigid slip along the
/// traction plus the elastic slip 2 B L x of a strip that slips as a whole, times what Carter's solution, in
/// which s is proportional to sqrt(v (u_s - u)), makes of it when only u < u_s slips.
inline Pack slip_size(const StripFastsimTask& task, const Group& g, const Cell& cell, const State& s) {
  const Pack zero = 0.0;
  const Pack rigid = -(g.wx * s.rho_x + (g.wy + g.spin * cell.x) * s.rho_y);
  const Pack elastic =
      2.0 * cell.x * g.slope * (task.l11 * (s.rho_x * s.rho_x) + task.l22 * (s.rho_y * s.rho_y));
  const Pack behind = larger(zero, g.slip_end - (2.0 - cell.t));
  const Pack partial = select(g.slip_end < 2.0, 2.0 * root(behind * cell.t) / (behind + cell.t), 1.0);
  return larger(zero, rigid - elastic) * partial;
}

/// One group of strips on its way.
struct Marching {
  Group group;
  State state;
  StickSums stick;
  Sums sums;
};

/// The first stick zone's share of a group's sums, from the sums over s.
inline void add_stick(const Group& g, const StickSums& s, Sums& sums) {
  sums.px += g.kappa * s.bent;
  sums.py += g.lambda * s.bent + g.psi * s.straight;
  sums.t_py += g.lambda * s.t_bent + g.psi * s.t_straight;
}

inline void add_stick(const Group& g, const StickSums& s, Derivative& d) {
  const Pack change = d.slip_end * s.slope + d.form * s.form;  // of the sum of s
  const Pack t_change = d.slip_end * s.t_slope + d.form * s.t_form;
  d.px += d.kappa * s.bent - g.kappa * change;
  d.py += d.lambda * s.bent + d.psi * s.straight + (g.psi - g.lambda) * change;
  d.t_py += d.lambda * s.t_bent + d.psi * s.t_straight + (g.psi - g.lambda) * t_change;
}

/// The sums of a group, scaled to what they stand for and added strip by strip; fx, fy, mz of each lane.
inline void lane_forces(const Group& g, Pack px, Pack py, Pack t_py, double* fx, double* fy, double* mz) {
  const Pack force = g.bound * g.cell;
  store_pack(fx, force * px);
  store_pack(fy, force * py);
  store_pack(mz, force * ((g.centre + g.half_length) * py - g.half_length * t_py - g.y * px));
}

inline void add(const StripFastsimTask& task, const Group& g, const Sums& s, simd::Sums& total) {
  double fx[lanes], fy[lanes], mz[lanes], power[lanes], cell[lanes], slid[lanes];
  lane_forces(g, s.px, s.py, s.t_py, fx, fy, mz);
  store_pack(power, g.cell * s.power);
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

inline void add(const Group& g, const Derivative (&derivative)[inputs], simd::Sums& total) {
  for (std::int32_t i = 0; i < inputs; ++i) {
    const Derivative& d = derivative[i];
    double fx[lanes], fy[lanes], mz[lanes];
    lane_forces(g, d.px, d.py, d.t_py, fx, fy, mz);
    for (std::int32_t k = 0; k < g.count; ++k) {
      total.d[0][i] += fx[k];
      total.d[1][i] += fy[k];
      total.d[2][i] += mz[k];
    }
  }
}

/// Tractions of a cell, and the slip not yet scaled; adds to the power it stands for.
inline void store_cell(const StripFastsimTask& task, const Group& g, const Cell& cell, Mask moving,
                       Mask slips, Pack part, const State& s, const StickCell& stuck, Sums& sums) {
  const Pack zero = 0.0, bound = cell.mean * g.bound;
  const Pack rho_x = select(moving, s.rho_x, stuck.share * stuck.x),
             rho_y = select(moving, s.rho_y, stuck.share * stuck.y);
  const Pack size = select(slips & (bound > zero), part * slip_size(task, g, cell, s), zero);
  sums.power += size * bound;
  const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(cell.index) * task.region->count + g.first;
  store_field(bound * rho_x, task.fields->traction_x, at, g.count);
  store_field(bound * rho_y, task.fields->traction_y, at, g.count);
  store_field(zero - size * s.rho_x, task.fields->slip_x, at, g.count);
  store_field(zero - size * s.rho_y, task.fields->slip_y, at, g.count);
}

}  // namespace strip

template <bool sensitivities>
void strip_fastsim_kernel(const StripFastsimTask& task, Sums& total) {
  total = {};
  const double h = 2.0 / task.cells, per_h = 0.5 * task.cells;
  const std::int32_t strips = task.region->count;
  const double* mean = task.shape->mean;
  const bool fields =
      task.fields->traction_x || task.fields->traction_y || task.fields->slip_x || task.fields->slip_y;
  for (std::int32_t first = 0; first < strips; first += in_flight * lanes) {
    strip::Marching marching[in_flight];
    strip::Derivative derivative[sensitivities ? in_flight : 1][inputs];
    std::int32_t groups = 0;
    for (std::int32_t at = first; at < strips && groups < in_flight; at += lanes, ++groups) {
      strip::Marching& m = marching[groups];
      strip::prepare(task, at, strips - at < lanes ? strips - at : lanes, m.group, m.state);
      m.stick = {};
      m.sums = {};
      const Pack near = larger(0.0, task.cells - m.group.slip_end * per_h);
      m.stick.root_near = root(near);
      m.stick.power_near = near * m.stick.root_near;
      if constexpr (sensitivities) {
        for (std::int32_t k = 0; k < inputs; ++k)
          strip::differentiate(task, k, m.group, derivative[groups][k]);
      }
    }
    for (std::int32_t i = 0; i < task.cells; ++i) {
      const double t = (i + 0.5) * h, ahead = task.cells - i, behind = ahead - 1.0, shape = t * (2.0 - t);
      const double t_before =
          (i - 0.5) * h;  // as it was then, so that a group's strips do not tell on each other
      const double inverse_weight = 1.0 / (ahead * __builtin_sqrt(ahead) - behind * __builtin_sqrt(behind));
      const strip::Cell cell{i,     t,           1.0 - t,       t_before * (2.0 - t_before),
                             shape, 1.0 / shape, mean[i],       h,
                             per_h, behind,      inverse_weight};
      for (std::int32_t k = 0; k < groups; ++k) {
        strip::Marching& m = marching[k];
        strip::StickCell stuck{};
        strip::Moved moved{};
        const Mask moving = m.group.stick_cells <= Pack(i);
        if (i < m.group.last_stick)
          strip::stick<sensitivities>(m.group, cell, fields, m.stick, m.sums,
                                      derivative[sensitivities ? k : 0], stuck);
        if (i >= m.group.all_stick) {
          Slip slip;
          Turn turning;
          const strip::State before = m.state;
          moved = i < m.group.all_move
                      ? strip::step<true>(m.group, cell, moving, m.state, m.sums, slip, turning)
                      : strip::step<false>(m.group, cell, moving, m.state, m.sums, slip, turning);
          if constexpr (sensitivities)
            strip::differentiate(m.group, cell, moving, before, m.state, slip, turning, moved, derivative[k]);
        }
        if (fields)
          strip::store_cell(task, m.group, cell, moving, moved.slips, moved.part, m.state, stuck, m.sums);
      }
    }
    for (std::int32_t k = 0; k < groups; ++k) {
      strip::Marching& m = marching[k];
      strip::add_stick(m.group, m.stick, m.sums);
      strip::add(task, m.group, m.sums, total);
      if constexpr (sensitivities) {
        for (std::int32_t n = 0; n < inputs; ++n) strip::add_stick(m.group, m.stick, derivative[k][n]);
        strip::add(m.group, derivative[k], total);
      }
    }
  }
}

}  // namespace
}  // namespace wrc::simd
