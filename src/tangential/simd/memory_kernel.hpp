/// Cells of strips that remember (methods/patch_memory.hpp) for the instruction set of the unit: one cell per
/// lane, and one strip per lane where a cell needs those before it.
#pragma once

#include "base/pack.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc::simd {
namespace {

constexpr std::int32_t memory_cells = tangential::memory_cells;
static_assert(memory_cells % lanes == 0, "packs are whole");

/// The first of two cells, and the weights of both in the traction at a place: straight lines from cell to
/// cell and to the edges; none outside.
struct BetweenCells {
  Pack first, weight, weight_behind;
};

/// `at`: cells behind the middle of the first.
inline BetweenCells between_cells(Pack at) {
  const Pack none = 0.0, one = 1.0;
  BetweenCells b;
  b.first = whole_part(smaller(larger(at, none), memory_cells - 2.0));
  // half a cell leads from the middle of the first, and of the last, to the edge
  const Pack beyond = at - b.first, twice = beyond + beyond;
  b.weight = larger(smaller(one - beyond, one + twice), none);
  b.weight_behind = larger(smaller(beyond, Pack(3.0) - twice), none);
  return b;
}

/// TangentialKernels::memory_bring: brings the tractions of a past strip to the cells of a strip that rolls
/// on by h. The share of the part for which a cell is in contact is added, too.
inline void memory_bring_kernel(const MemoryBringTask& t, RememberingStrip& to) {
  // A cell ahead of the old leading edge was in contact since it met the edge, which closes the distance at
  // the rate `closing` over the part; where nothing closes, not at all.
  const double lead = to.centre + to.half_length, closing = t.h + lead - t.old_lead;
  const Pack per_closing = closing > 0.0 ? 1.0 / closing : 1e300, ahead = t.h - t.old_lead;
  const Pack centre = to.centre, half = to.half_length, per_cell = memory_cells / (2.0 * t.half_length);
  const Pack weight = t.weight, none = 0.0, one = 1.0;
  for (std::int32_t i = 0; i < memory_cells; i += lanes) {
    const Pack before = (centre + half * load_pack(t.place + i)) + ahead;
    const BetweenCells b = between_cells(Pack(-0.5) - before * per_cell);
    const Indices cell = indices(b.first);
    const Neighbours px = pick(t.px, cell), py = pick(t.py, cell);
    const auto add = [&](double* cells, Pack brought) {
      store_pack(cells + i, (t.adds ? load_pack(cells + i) : none) + weight * brought);
    };
    add(to.px, b.weight * px.at + b.weight_behind * px.behind);
    add(to.py, b.weight * py.at + b.weight_behind * py.behind);
    const Pack met = smaller(larger(before * per_closing, none), one);
    add(to.share, t.h > 0.0 ? one - met : one);
  }
}

/// By how much further a sliding cell is displaced for its direction, over its displacement v [-]. It is 0 as
/// the cell begins to slide, and grows as 2 c - c^2, c the part of the displacement that goes beyond the
/// bound. So a cell displaced across its traction has more than one displaced nearly along it. It vanishes
/// where v is far below `still`: the bound times the length rolled in half lengths, times `turned_by_rolling`
/// [Pa].
constexpr double turned_by_rolling = 5.0;
inline Native turns_further(Native turns, Native still, Native sticks, Native bound, Native vx, Native vy) {
  const Native v2 = vx * vx + vy * vy, v = root_of(v2);
  const Native beyond = smaller_of(larger_of(sticks, bound) - bound, v);
  return turns * beyond * (v + (v - beyond)) / larger_of(v2 + still * still, broadcast(1e-290));
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

/// Numbers that cells of a strip share: displacements over the flexibility [Pa], their change along x over
/// arms, and the length rolled in half lengths, times `turned_by_rolling`.
struct PassedStrip {
  Native vx, vy, turn, rolled, x, reach, turns, half_way, to_come;
};
inline PassedStrip pass_strip(const MemoryPassTask& t, const RememberingStrip& s) {
  PassedStrip p;
  p.vx = broadcast(s.growth_x * ((t.local[0] - t.local[2] * s.y) + s.own_x));
  p.vy = broadcast(s.growth_y * ((t.local[1] + s.own_y) - s.own_turn * s.x));
  p.turn = broadcast(s.growth_y * (t.local[2] + s.own_turn));
  p.rolled = broadcast(turned_by_rolling * (t.h / s.half_length));
  p.x = broadcast(s.x);
  p.reach = broadcast(s.reach);
  p.turns = broadcast(s.turns);
  p.half_way = broadcast(t.half_way);
  p.to_come = broadcast(t.to_come);
  return p;
}

/// A vector of cells: tractions, and the numbers that their slopes are made of.
struct PassedCells {
  Native px, py;          ///< before they slide [Pa]
  Native at, on_way;      ///< arms of the cell now, and of the middle of its way
  Native inverse, ratio;  ///< one over the size of the traction [1/Pa], and the share that is left of it
  Native further;         ///< turns_further()
};

inline PassedCells pass_cells(const MemoryPassTask& t, const RememberingStrip& s, const PassedStrip& p,
                              std::int32_t i) {
  PassedCells c;
  const Native share = load_lanes(s.share + i), one = broadcast(1.0);
  c.at = p.x + p.reach * load_lanes(t.place + i);
  c.on_way = c.at + p.half_way * share;
  // traction if it sticks
  const Native vx = share * p.vx, vy = share * (p.vy + p.turn * c.on_way);
  c.px = load_lanes(s.px + i) - vx;
  c.py = load_lanes(s.py + i) - vy;
  // onto the disk, whose bound goes from that of before to that of the end in proportion to the step
  const Native end = load_lanes(s.bound + i), bound = end + p.to_come * (load_lanes(s.had + i) - end);
  const Native sticks = root_of(c.px * c.px + c.py * c.py);
  const NativeMask slides = less(bound, sticks);
  c.further = turns_further(p.turns, p.rolled * bound, sticks, bound, vx, vy);
  c.px = c.px - c.further * vx;
  c.py = c.py - c.further * vy;
  c.inverse = one / choose(slides, root_of(c.px * c.px + c.py * c.py), one);
  c.ratio = choose(slides, bound * c.inverse, one);
  return c;
}

/// TangentialKernels::memory_pass: the tractions of the cells in a part of a step, and the forces of the
/// strips.
inline void memory_pass_kernel(const MemoryPassTask& t) {
  for (std::int32_t j = 0; j < t.strips; ++j) {
    const RememberingStrip& s = t.from[j];
    double* const to = t.px + j * t.stride;
    const PassedStrip strip = pass_strip(t, s);
    const Native y = broadcast(s.y);
    StripCells fx, fy, mz;
    for (std::int32_t k = 0; k < vectors; ++k) {
      const std::int32_t i = k * native_lanes;
      const PassedCells c = pass_cells(t, s, strip, i);
      const Native px = c.px * c.ratio, py = c.py * c.ratio;
      store_lanes(to + i, px);
      store_lanes(to + memory_cells + i, py);
      fx.of[k] = px;
      fy.of[k] = py;
      mz.of[k] = c.at * py - y * px;
    }
    double* const force = t.force + j * t.stride;
    force[0] = sum_of_cells(fx) * s.area;
    force[1] = sum_of_cells(fy) * s.area;
    force[2] = sum_of_cells(mz) * s.area;
  }
}

/// Part of a traction that slides, over which the slopes of a cell turn to sliding.
constexpr double turning = 1.0 / 11.0;

/// Sums over the cells of a place and all strips, then over places: the same with any lanes.
inline void memory_pass_sums_kernel(const MemoryPassTask& t, MemoryPassSums& sums) {
  constexpr std::int32_t numbers = 12;
  StripCells sum[numbers];
  const Native none = broadcast(0.0), one = broadcast(1.0), whole = broadcast(1.0 / turning);
  for (StripCells& number : sum)
    for (Native& each : number.of) each = none;
  for (std::int32_t j = 0; j < t.strips; ++j) {
    const RememberingStrip& s = t.from[j];
    const PassedStrip strip = pass_strip(t, s);
    const Native y = broadcast(s.y), area = broadcast(s.area), growth_x = broadcast(s.growth_x),
                 growth_y = broadcast(s.growth_y);
    for (std::int32_t k = 0; k < vectors; ++k) {
      const PassedCells c = pass_cells(t, s, strip, k * native_lanes);
      const Native ex = c.px * c.inverse, ey = c.py * c.inverse;
      const Native part = c.ratio * area, px = c.px * part, py = c.py * part;
      sum[0].of[k] += px;
      sum[1].of[k] += py;
      sum[2].of[k] += c.at * py - y * px;
      // -d(force)/d(local): slopes of the point on the disk, ratio (1 - e e). They turn from those of a cell
      // that sticks to those of one that slides over a part of its bound: forces after a fixed number of
      // Newton's steps jump wherever the slopes do.
      const Native slid = smaller_of(larger_of(one - c.ratio, none) * whole, one);
      const Native way = load_lanes(s.share + k * native_lanes), moves = (way + way * c.further) * part;
      const Native slides = moves * slid, along_x = slides * ex, along_y = slides * ey;
      const Native across = along_x * ey;
      const Native x_x = growth_x * (moves - along_x * ex), y_y = growth_y * (moves - along_y * ey);
      // x_y, y_x and x_turn without their minus sign
      const Native x_y = growth_y * across, y_x = growth_x * across, of_x = x_x * y;
      const Native x_turn = x_y * c.on_way + of_x, y_turn = y_y * c.on_way + y_x * y;
      sum[3].of[k] += x_x;
      sum[4].of[k] += x_y;
      sum[5].of[k] += x_turn;
      sum[6].of[k] += y_x;
      sum[7].of[k] += y_y;
      sum[8].of[k] += y_turn;
      sum[9].of[k] += c.at * y_x + of_x;
      sum[10].of[k] += c.at * y_y + y * x_y;
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

/// A number of each lane's strip; lanes without a strip have that of the first.
inline Pack of_strips(const MemoryMarchTask& t, std::int32_t first, const double RememberingStrip::*number) {
  double of[lanes];
  for (std::int32_t k = 0; k < lanes; ++k) of[k] = t.from[first + k < t.strips ? first + k : first].*number;
  return load_pack(of);
}

/// Bounds of a cell of each lane's strip [Pa].
inline Pack bounds_of_strips(const MemoryMarchTask& t, std::int32_t first, std::int32_t cell) {
  double of[lanes];
  for (std::int32_t k = 0; k < lanes; ++k)
    of[k] = t.from[first + k < t.strips ? first + k : first].bound[cell];
  return load_pack(of);
}

/// Steady rolling, cell by cell from the leading edge on: each cell's traction begins with that of the cells
/// ahead, a length h before. Where h is less than a cell, a cell's traction p depends on itself with a weight
/// w. The p in the disk nearest to q + w p is that nearest to q / (1 - w): that of a length of a whole cell,
/// with the arms of h.
inline void memory_march_kernel(const MemoryMarchTask& t) {
  for (std::int32_t first = 0; first < t.strips; first += lanes) {
    const std::int32_t count = t.strips - first < lanes ? t.strips - first : lanes;
    const Pack half = of_strips(t, first, &RememberingStrip::half_length);
    const Pack cell = half * Pack(2.0 / memory_cells), path = larger(Pack(t.h), cell);
    const Pack rolled = Pack(turned_by_rolling) * (path / half), per_cell = Pack(1.0) / cell;
    const Pack y = of_strips(t, first, &RememberingStrip::y), x = of_strips(t, first, &RememberingStrip::x);
    const Pack reach = of_strips(t, first, &RememberingStrip::reach);
    const Pack growth_x = of_strips(t, first, &RememberingStrip::growth_x),
               growth_y = of_strips(t, first, &RememberingStrip::growth_y);
    const Pack half_arm = Pack(0.5) * of_strips(t, first, &RememberingStrip::arm);
    const Pack area = of_strips(t, first, &RememberingStrip::area),
               turns = of_strips(t, first, &RememberingStrip::turns);
    const Pack own_turn = of_strips(t, first, &RememberingStrip::own_turn);
    const Pack by_x = (Pack(t.per[0]) - Pack(t.per[2]) * y) + of_strips(t, first, &RememberingStrip::own_x);
    const Pack by_y = (Pack(t.per[1]) + of_strips(t, first, &RememberingStrip::own_y)) - own_turn * x;
    const Pack turn = Pack(t.per[2]) + own_turn;
    // tractions so far, strip by strip
    double px[lanes * memory_cells] = {}, py[lanes * memory_cells] = {}, lane[lanes];
    for (std::int32_t k = 0; k < lanes; ++k) lane[k] = k * memory_cells;
    const Pack row = load_pack(lane);
    Pack fx = 0.0, fy = 0.0, mz = 0.0;
    for (std::int32_t i = 0; i < memory_cells; ++i) {
      const Pack from_lead = cell * Pack(i + 0.5), behind = from_lead - path, way = smaller(path, from_lead);
      const BetweenCells b = between_cells(behind * per_cell - Pack(0.5));
      const Indices at_cell = indices(row + b.first);
      const Neighbours was_x = pick(px, at_cell), was_y = pick(py, at_cell);
      const Pack at = x + reach * Pack(t.place[i]);
      const Pack on_way = at + half_arm * smaller(Pack(t.h), way);
      const Pack vx = growth_x * way * by_x, vy = growth_y * way * (by_y + turn * on_way);
      Pack sticks_x = b.weight * was_x.at + b.weight_behind * was_x.behind - vx;
      Pack sticks_y = b.weight * was_y.at + b.weight_behind * was_y.behind - vy;
      const Pack most = bounds_of_strips(t, first, i),
                 sticks = root(sticks_x * sticks_x + sticks_y * sticks_y);
      const Mask slides = sticks > most;
      const Pack still = rolled * most;
      const Pack further{turns_further(turns.a, still.a, sticks.a, most.a, vx.a, vy.a),
                         turns_further(turns.b, still.b, sticks.b, most.b, vx.b, vy.b)};
      sticks_x = sticks_x - further * vx;
      sticks_y = sticks_y - further * vy;
      const Pack size = root(sticks_x * sticks_x + sticks_y * sticks_y);
      const Pack ratio = select(slides, most / select(slides, size, 1.0), 1.0);
      const Pack now_x = sticks_x * ratio, now_y = sticks_y * ratio;
      fx += now_x;
      fy += now_y;
      mz += at * now_y - y * now_x;
      double of[2][lanes];
      store_pack(of[0], now_x);
      store_pack(of[1], now_y);
      for (std::int32_t k = 0; k < lanes; ++k) {
        px[k * memory_cells + i] = of[0][k];
        py[k * memory_cells + i] = of[1][k];
      }
    }
    double force[3][lanes];
    store_pack(force[0], fx * area);
    store_pack(force[1], fy * area);
    store_pack(force[2], mz * area);
    for (std::int32_t k = 0; k < count; ++k) {
      double* const to = t.px + (first + k) * t.stride;
      for (std::int32_t i = 0; i < memory_cells; ++i) {
        to[i] = px[k * memory_cells + i];
        to[memory_cells + i] = py[k * memory_cells + i];
      }
      for (std::int32_t n = 0; n < 3; ++n) t.force[(first + k) * t.stride + n] = force[n][k];
    }
  }
}

}  // namespace
}  // namespace wrc::simd
