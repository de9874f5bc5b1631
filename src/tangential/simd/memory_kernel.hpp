/// Cells of strips that remember (methods/patch_memory.hpp) for the instruction set of the unit: one cell per
/// lane, and one strip per lane where a cell needs those before it.
#pragma once

#include "base/pack.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc::simd {
namespace {

constexpr std::int32_t memory_cells = tangential::memory_cells;
static_assert(memory_cells % lanes == 0, "packs are whole");

/// TangentialKernels::memory_bounds: bounds of a strip's cells up to its middle, in `had`, with twice their
/// sum behind, which it returns. `load`: square of the pressure in its middle, as the table counts it.
inline double memory_bounds_kernel(const MemoryBoundsTask& t, double load, double friction,
                                   RememberingStrip& to) {
  constexpr std::int32_t half = memory_cells / 2;
  const Native square_of_middle = broadcast(load), one = broadcast(1.0), share = broadcast(t.share),
               rest = broadcast(1.0 - t.share), middle = broadcast(t.middle), by_x = broadcast(t.by_x),
               by_x2 = broadcast(t.by_x2), mu = broadcast(friction);
  for (std::int32_t i = 0; i < half; i += native_lanes) {
    const Native square = square_of_middle * load_lanes(t.parabola + i), bin = whole_part(square);
    Native at, behind;
    pick_lanes(t.larger, indices(bin).at, at, behind);
    const Native rank = at + (square - bin) * (behind - at), x = rank / (rest + share * rank);
    store_lanes(to.had + i, mu * ((one - x) * (middle + x * (by_x + x * by_x2))));
  }
  static_assert(half == 8, "the sum below has four numbers");
  double sum[half / 2];
  for (std::int32_t i = 0; i < half / 2; ++i) sum[i] = to.had[i] + to.had[i + half / 2];
  return to.had[half] = 2.0 * ((sum[0] + sum[2]) + (sum[1] + sum[3]));
}

/// The first of two cells, and the weights of both in the traction at a place: straight lines from cell to
/// cell and to the edges; none outside.
struct BetweenCells {
  Native first, weight, weight_behind;
};

/// `at`: cells behind the middle of the first.
inline BetweenCells between_cells(Native at) {
  const Native none = broadcast(0.0), one = broadcast(1.0);
  BetweenCells b;
  b.first = whole_part(smaller_of(larger_of(at, none), broadcast(memory_cells - 2.0)));
  // half a cell leads from the middle of the first, and of the last, to the edge
  const Native beyond = at - b.first, twice = beyond + beyond;
  b.weight = larger_of(smaller_of(one - beyond, one + twice), none);
  b.weight_behind = larger_of(smaller_of(beyond, broadcast(3.0) - twice), none);
  return b;
}

/// Tractions along x and y there.
inline void take_between(const BetweenCells& b, const NativeIndices& cell, const double* px, const double* py,
                         Native& x, Native& y) {
  Native at, behind;
  pick_lanes(px, cell.at, at, behind);
  x = b.weight * at + b.weight_behind * behind;
  pick_lanes(py, cell.at, at, behind);
  y = b.weight * at + b.weight_behind * behind;
}

/// TangentialKernels::memory_bring: brings the tractions of a past strip to the cells of a strip that rolls
/// on by h. The share of the part for which a cell is in contact is added, too.
template <bool adds>
inline void bring_cells(const MemoryBringTask& t, RememberingStrip& to) {
  // A cell ahead of the old leading edge was in contact since it met the edge, which closes the distance at
  // the rate `closing` over the part; where nothing closes, not at all; at rest, always.
  const double lead = to.centre + to.half_length, closing = t.h + lead - t.old_lead;
  const Native per_closing = broadcast(!(t.h > 0.0) ? 0.0 : closing > 0.0 ? 1.0 / closing : 1e300);
  const Native ahead = broadcast(t.h - t.old_lead), centre = broadcast(to.centre),
               half = broadcast(to.half_length), weight = broadcast(t.weight);
  const Native per_cell = broadcast(memory_cells / (2.0 * t.half_length));
  const Native none = broadcast(0.0), one = broadcast(1.0);
  for (std::int32_t i = 0; i < memory_cells; i += native_lanes) {
    const Native before = (centre + half * load_lanes(t.place + i)) + ahead;
    const BetweenCells b = between_cells(broadcast(-0.5) - before * per_cell);
    Native px, py;
    take_between(b, indices(b.first), t.px, t.py, px, py);
    const auto add = [&](double* cells, Native brought) {
      store_lanes(cells + i, adds ? load_lanes(cells + i) + weight * brought : weight * brought);
    };
    add(to.px, px);
    add(to.py, py);
    add(to.share, one - smaller_of(larger_of(before * per_closing, none), one));
  }
}
inline void memory_bring_kernel(const MemoryBringTask& t, RememberingStrip& to) {
  if (t.adds)
    bring_cells<true>(t, to);
  else
    bring_cells<false>(t, to);
}

/// By how much further a sliding cell is displaced for its direction, over its displacement v: two numbers,
/// of which the first over the second is meant. It is 0 as the cell begins to slide, and grows as 2 c - c^2,
/// c the part of the displacement that goes beyond the bound. So a cell displaced across its traction has
/// more than one displaced nearly along it. It vanishes where v is far below the bound times the length
/// rolled in half lengths, times `turned_by_rolling` [Pa].
constexpr double turned_by_rolling = 5.0;
struct Further {
  Native by, over;
};
inline Further turns_further(Native turns, Native still2, Native beyond_bound, Native vx, Native vy) {
  const Native v2 = vx * vx + vy * vy, v = root_of(v2), beyond = smaller_of(beyond_bound, v);
  return {turns * beyond * (v + (v - beyond)), larger_of(v2 + still2, broadcast(1e-100))};
}

/// Tractions of sliding cells: their directions, one over the size of those, and the bound over it.
struct Slid {
  Native x, y, inverse, ratio;
};
inline Slid slide(Native px, Native py, Native vx, Native vy, Native bound, const Further& further) {
  Slid s;
  s.x = further.over * px - further.by * vx;
  s.y = further.over * py - further.by * vy;
  s.inverse = broadcast(1.0) / root_of(larger_of(s.x * s.x + s.y * s.y, broadcast(1e-290)));
  s.ratio = bound * s.inverse;
  return s;
}

/// Cells of a strip. They do not wait for one another, so one vector at a time leaves numbers in registers.
constexpr std::int32_t vectors = memory_cells / native_lanes;
struct StripCells {
  Native of[vectors];
};

/// Sum over the cells of a strip: halves are added until one number is left, the same with any lanes.
inline double sum_of_cells(StripCells& cells) {
  for (std::int32_t half = vectors / 2; half > 0; half /= 2)
    for (std::int32_t k = 0; k < half; ++k) cells.of[k] += cells.of[k + half];
  double of[native_lanes];
  store_lanes(of, cells.of[0]);
  for (std::int32_t half = native_lanes / 2; half > 0; half /= 2)
    for (std::int32_t k = 0; k < half; ++k) of[k] += of[k + half];
  return of[0];
}

/// Numbers that cells of a strip share: displacements over the flexibility [Pa], their change along x, and
/// the square of the length rolled in half lengths, times `turned_by_rolling`.
struct PassedStrip {
  Native vx, vy, turn, rolled2, x, reach, turns, half_way, to_come;
};
inline PassedStrip pass_strip(const MemoryPassTask& t, const RememberingStrip& s) {
  PassedStrip p;
  const double rolled = turned_by_rolling * (t.h / s.half_length);
  const double own_turn = t.travel * s.own_turn;
  p.vx = broadcast(s.growth_x * ((t.local[0] - t.local[2] * s.y) + t.travel * s.own_x));
  p.vy = broadcast(s.growth_y * ((t.local[1] + t.travel * s.own_y) - own_turn * s.x));
  p.turn = broadcast(s.growth_y * (t.local[2] + own_turn));
  p.rolled2 = broadcast(rolled * rolled);
  p.x = broadcast(s.x);
  p.reach = broadcast(s.half_length);
  p.turns = broadcast(s.turns);
  p.half_way = broadcast(0.5 * t.h);
  p.to_come = broadcast(t.to_come);
  return p;
}

/// A vector of cells.
struct PassedCells {
  Native px, py;        ///< tractions [Pa]
  Native share;         ///< share of the part for which they were in contact
  Native at, on_way;    ///< arms of the cell now, and of the middle of its way
  bool slides;          ///< any of them; if not, the rest is not set
  Native ex, ey;        ///< direction of the traction
  Native ratio, moves;  ///< share of the traction that is left, and that by which it moves with the bodies
};

template <bool slopes, bool early>
inline PassedCells pass_cells(const MemoryPassTask& t, const RememberingStrip& s, const PassedStrip& p,
                              std::int32_t i) {
  PassedCells c;
  c.share = load_lanes(s.share + i);
  c.at = p.x + p.reach * load_lanes(t.place + i);
  c.on_way = c.at + p.half_way * c.share;
  // traction if it sticks
  const Native vx = c.share * p.vx, vy = c.share * (p.vy + p.turn * c.on_way);
  c.px = load_lanes(s.px + i) - vx;
  c.py = load_lanes(s.py + i) - vy;
  // onto the disk, whose bound goes from that of before to that of the end in proportion to the step
  Native bound = load_lanes(s.bound + i);
  if constexpr (early) bound = bound + p.to_come * (load_lanes(s.had + i) - bound);
  const Native sticks2 = c.px * c.px + c.py * c.py, bound2 = bound * bound;
  const NativeMask slides = less(bound2, sticks2);
  c.slides = any_lane(slides);
  if (!c.slides) return c;
  const Further further = turns_further(p.turns, p.rolled2 * bound2, root_of(sticks2) - bound, vx, vy);
  const Slid slid = slide(c.px, c.py, vx, vy, bound, further);
  c.px = choose(slides, slid.x * slid.ratio, c.px);
  c.py = choose(slides, slid.y * slid.ratio, c.py);
  if constexpr (slopes) {
    const Native one = broadcast(1.0);
    c.ex = slid.x * slid.inverse;
    c.ey = slid.y * slid.inverse;
    c.ratio = choose(slides, further.over * slid.ratio, one);
    c.moves = choose(slides, (further.over + further.by) * slid.ratio, one);
  }
  return c;
}

/// TangentialKernels::memory_pass: the tractions of the cells in a part of a step, and the forces of the
/// strips.
template <bool early>
inline void pass_strips(const MemoryPassTask& t) {
  for (std::int32_t j = 0; j < t.strips; ++j) {
    const RememberingStrip& s = t.from[j];
    double* const to = t.px + j * t.stride;
    const PassedStrip strip = pass_strip(t, s);
    const Native y = broadcast(s.y);
    StripCells fx, fy, mz;
    for (std::int32_t k = 0; k < vectors; ++k) {
      const std::int32_t i = k * native_lanes;
      const PassedCells c = pass_cells<false, early>(t, s, strip, i);
      store_lanes(to + i, c.px);
      store_lanes(to + memory_cells + i, c.py);
      fx.of[k] = c.px;
      fy.of[k] = c.py;
      mz.of[k] = c.at * c.py - y * c.px;
    }
    double* const force = t.force + j * t.stride;
    force[0] = sum_of_cells(fx) * s.area;
    force[1] = sum_of_cells(fy) * s.area;
    force[2] = sum_of_cells(mz) * s.area;
  }
}

inline void memory_pass_kernel(const MemoryPassTask& t) {
  if (t.to_come > 0.0)
    pass_strips<true>(t);
  else
    pass_strips<false>(t);
}

/// Part of a traction that slides, over which the slopes of a cell turn to sliding.
constexpr double turning = 1.0 / 11.0;

/// Sums over the cells of a place and all strips, then over places: the same with any lanes.
template <bool early>
inline void sum_passed_strips(const MemoryPassTask& t, MemoryPassSums& sums) {
  constexpr std::int32_t numbers = 12;
  StripCells sum[numbers];
  const Native none = broadcast(0.0), one = broadcast(1.0), whole = broadcast(1.0 / turning);
  for (StripCells& number : sum)
    for (Native& each : number.of) each = none;
  for (std::int32_t j = 0; j < t.strips; ++j) {
    const RememberingStrip& s = t.from[j];
    const PassedStrip strip = pass_strip(t, s);
    const Native y = broadcast(s.y), area = broadcast(s.area), growth_x = broadcast(s.area * s.growth_x),
                 growth_y = broadcast(s.area * s.growth_y);
    for (std::int32_t k = 0; k < vectors; ++k) {
      const PassedCells c = pass_cells<true, early>(t, s, strip, k * native_lanes);
      const Native px = c.px * area, py = c.py * area;
      sum[0].of[k] += px;
      sum[1].of[k] += py;
      sum[2].of[k] += c.at * py - y * px;
      // -d(force)/d(local): slopes of the point on the disk, ratio (1 - e e). They turn from those of a cell
      // that sticks to those of one that slides over a part of its bound: forces after a fixed number of
      // Newton's steps jump wherever the slopes do.
      Native x_x, y_y, x_turn, y_turn, turn_x, turn_y;
      if (c.slides) {
        const Native slid = smaller_of(larger_of(one - c.ratio, none) * whole, one);
        const Native moves = c.share * c.moves;
        const Native slides = moves * slid, along_x = slides * c.ex, along_y = slides * c.ey;
        const Native across = along_x * c.ey;
        x_x = growth_x * (moves - along_x * c.ex);
        y_y = growth_y * (moves - along_y * c.ey);
        // x_y, y_x and x_turn without their minus sign
        const Native x_y = growth_y * across, y_x = growth_x * across, of_x = x_x * y;
        x_turn = x_y * c.on_way + of_x;
        y_turn = y_y * c.on_way + y_x * y;
        turn_x = c.at * y_x + of_x;
        turn_y = c.at * y_y + y * x_y;
        sum[4].of[k] += x_y;
        sum[6].of[k] += y_x;
      } else {
        x_x = growth_x * c.share;
        y_y = growth_y * c.share;
        x_turn = turn_x = x_x * y;
        y_turn = y_y * c.on_way;
        turn_y = c.at * y_y;
      }
      sum[3].of[k] += x_x;
      sum[5].of[k] += x_turn;
      sum[7].of[k] += y_y;
      sum[8].of[k] += y_turn;
      sum[9].of[k] += turn_x;
      sum[10].of[k] += turn_y;
      sum[11].of[k] += c.at * y_turn + y * x_turn;
    }
  }
  double total[numbers];
  for (std::int32_t n = 0; n < numbers; ++n) total[n] = sum_of_cells(sum[n]);
  for (int n = 0; n < 3; ++n) sums.force[n] = total[n];
  const double slope[3][3] = {
      {total[3], -total[4], -total[5]}, {-total[6], total[7], total[8]}, {-total[9], total[10], total[11]}};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) sums.slope[i][k] = slope[i][k];
}
inline void memory_pass_sums_kernel(const MemoryPassTask& t, MemoryPassSums& sums) {
  if (t.to_come > 0.0)
    sum_passed_strips<true>(t, sums);
  else
    sum_passed_strips<false>(t, sums);
}

/// TangentialKernels::memory_tend: gives the tractions of a strip's cells, along x and then y, a share of
/// others.
inline void memory_tend_kernel(const double* others, double share, double* to) {
  const Native of_others = broadcast(share), own = broadcast(1.0 - share);
  for (std::int32_t i = 0; i < 2 * memory_cells; i += native_lanes)
    store_lanes(to + i, own * load_lanes(to + i) + of_others * load_lanes(others + i));
}

/// TangentialKernels::memory_squares: sum of the squares of these tractions.
inline void memory_squares_kernel(const double* tractions, double& along_x, double& along_y) {
  StripCells x, y;
  for (std::int32_t k = 0; k < vectors; ++k) {
    const Native px = load_lanes(tractions + k * native_lanes),
                 py = load_lanes(tractions + memory_cells + k * native_lanes);
    x.of[k] = px * px;
    y.of[k] = py * py;
  }
  along_x = sum_of_cells(x);
  along_y = sum_of_cells(y);
}

/// Strips of the lanes of a vector; lanes without a strip have the first.
struct StripsOfLanes {
  const RememberingStrip* at[native_lanes];
};
inline StripsOfLanes strips_of_lanes(const MemoryMarchTask& t, std::int32_t first) {
  StripsOfLanes strips;
  for (std::int32_t k = 0; k < native_lanes; ++k)
    strips.at[k] = t.from + (first + k < t.strips ? first + k : first);
  return strips;
}
inline Native of_strips(const StripsOfLanes& strips, const double RememberingStrip::*number) {
  double of[native_lanes];
  for (std::int32_t k = 0; k < native_lanes; ++k) of[k] = strips.at[k]->*number;
  return load_lanes(of);
}

/// Writes the tractions of a vector's strips, strip by strip, and their forces.
inline void store_marched(const MemoryMarchTask& t, std::int32_t first, const double* px, const double* py,
                          const double (&force)[3][native_lanes]) {
  for (std::int32_t k = 0; k < native_lanes && first + k < t.strips; ++k) {
    double* const to = t.px + (first + k) * t.stride;
    for (std::int32_t i = 0; i < memory_cells; ++i) {
      to[i] = px[k * memory_cells + i];
      to[memory_cells + i] = py[k * memory_cells + i];
    }
    for (std::int32_t n = 0; n < 3; ++n) t.force[(first + k) * t.stride + n] = force[n][k];
  }
}

/// Steady rolling, cell by cell from the leading edge on: each cell's traction begins with that of the cells
/// ahead, a length h before. Where h is less than a cell, a cell's traction p depends on itself with a weight
/// w. The p in the disk nearest to q + w p is that nearest to q / (1 - w): that of a length of a whole cell,
/// with the arms of h.
inline void memory_march_kernel(const MemoryMarchTask& t) {
  for (std::int32_t first = 0; first < t.strips; first += native_lanes) {
    const StripsOfLanes strips = strips_of_lanes(t, first);
    const Native h = broadcast(t.h), half = of_strips(strips, &RememberingStrip::half_length);
    const Native cell = half * broadcast(2.0 / memory_cells), path = larger_of(h, cell);
    const Native rolled = broadcast(turned_by_rolling) * (path / half), rolled2 = rolled * rolled,
                 per_cell = broadcast(1.0) / cell;
    const Native y = of_strips(strips, &RememberingStrip::y), x = of_strips(strips, &RememberingStrip::x);
    const Native turns = of_strips(strips, &RememberingStrip::turns);
    const Native own_turn = of_strips(strips, &RememberingStrip::own_turn);
    // displacements over the flexibility, per length
    const Native growth_x = of_strips(strips, &RememberingStrip::growth_x),
                 growth_y = of_strips(strips, &RememberingStrip::growth_y);
    const Native by_x = (broadcast(t.per[0]) - broadcast(t.per[2]) * y) +
                        of_strips(strips, &RememberingStrip::own_x),
                 by_y = (broadcast(t.per[1]) + of_strips(strips, &RememberingStrip::own_y)) - own_turn * x,
                 turn = broadcast(t.per[2]) + own_turn;
    double bound[memory_cells * native_lanes];
    for (std::int32_t k = 0; k < native_lanes; ++k)
      for (std::int32_t i = 0; i < memory_cells; ++i) bound[i * native_lanes + k] = strips.at[k]->bound[i];
    // tractions so far, strip by strip
    double px[native_lanes * memory_cells] = {}, py[native_lanes * memory_cells] = {}, lane[native_lanes];
    for (std::int32_t k = 0; k < native_lanes; ++k) lane[k] = k * memory_cells;
    const Native row = load_lanes(lane);
    Native fx = broadcast(0.0), fy = fx, mz = fx;
    for (std::int32_t i = 0; i < memory_cells; ++i) {
      const Native from_lead = cell * broadcast(i + 0.5), way = smaller_of(path, from_lead);
      const BetweenCells b = between_cells((from_lead - path) * per_cell - broadcast(0.5));
      Native now_x, now_y;
      take_between(b, indices(row + b.first), px, py, now_x, now_y);
      const Native at = x + half * broadcast(t.place[i]);
      const Native on_way = at + broadcast(0.5) * smaller_of(h, way);
      const Native vx = growth_x * way * by_x, vy = growth_y * way * (by_y + turn * on_way);
      now_x = now_x - vx;
      now_y = now_y - vy;
      const Native most = load_lanes(bound + i * native_lanes), most2 = most * most,
                   sticks2 = now_x * now_x + now_y * now_y;
      const NativeMask slides = less(most2, sticks2);
      if (any_lane(slides)) {
        const Further further = turns_further(turns, rolled2 * most2, root_of(sticks2) - most, vx, vy);
        const Slid slid = slide(now_x, now_y, vx, vy, most, further);
        now_x = choose(slides, slid.x * slid.ratio, now_x);
        now_y = choose(slides, slid.y * slid.ratio, now_y);
      }
      fx = fx + now_x;
      fy = fy + now_y;
      mz = mz + (at * now_y - y * now_x);
      double of[2][native_lanes];
      store_lanes(of[0], now_x);
      store_lanes(of[1], now_y);
      for (std::int32_t k = 0; k < native_lanes; ++k) {
        px[k * memory_cells + i] = of[0][k];
        py[k * memory_cells + i] = of[1][k];
      }
    }
    const Native area = of_strips(strips, &RememberingStrip::area);
    double force[3][native_lanes];
    store_lanes(force[0], fx * area);
    store_lanes(force[1], fy * area);
    store_lanes(force[2], mz * area);
    store_marched(t, first, px, py, force);
  }
}

}  // namespace
}  // namespace wrc::simd
