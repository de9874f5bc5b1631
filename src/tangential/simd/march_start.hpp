/// Start of a group of strips in the march (march_kernel.hpp): the strips' numbers from either task,
/// relative, the onset of slip, the first stick zone in closed form; and the derivatives of these.
#pragma once

#include "base/pack.hpp"
#include "tangential/march/march_grid.hpp"
#include "tangential/march/stick_zone.hpp"
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

}  // namespace
}  // namespace wrc::simd
