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
inline BetweenCells between_cells(Pack at, Mask inside) {
  const Pack last = memory_cells - 1.0, none = 0.0;
  BetweenCells b;
  b.first = whole_part(smaller(larger(at, none), last - 1.0));
  const Mask before = at<none, behind = at> last;
  const Pack second = select(behind, Pack(1.0) - Pack(2.0) * (at - last), at - b.first);
  const Pack one =
      select(behind, none, select(before, Pack(1.0) + Pack(2.0) * at, Pack(1.0) - (at - b.first)));
  b.weight = select(inside, one, none);
  b.weight_behind = select(inside & !before, second, none);
  return b;
}

inline void memory_bring_kernel(const MemoryBringTask& t, RememberingStrip& to) {
  const double lead = to.centre + to.half_length, closing = t.h + lead - t.old_lead;
  const double length = 2.0 * t.half_length, per_length = memory_cells / length;
  const Pack weight = t.weight, none = 0.0, one = 1.0;
  for (std::int32_t i = 0; i < memory_cells; i += lanes) {
    // Behind the old leading edge it was in contact all the time. Ahead of it since it met the edge, which
    // closes the distance -behind at the rate `closing`.
    const Pack at = Pack(to.centre) + Pack(to.half_length) * load_pack(t.place + i);
    const Pack behind = Pack(t.old_lead) - (at + Pack(t.h));
    const Mask was = behind > none;
    const BetweenCells b =
        between_cells(behind * Pack(per_length) - Pack(0.5), was & (behind < Pack(length)));
    const Indices cell = indices(b.first);
    const Neighbours px = pick(t.px, cell), py = pick(t.py, cell);
    const auto add = [&](double* cells, Pack brought) {
      store_pack(cells + i, (t.adds ? load_pack(cells + i) : none) + weight * brought);
    };
    add(to.px, b.weight * px.at + b.weight_behind * px.behind);
    add(to.py, b.weight * py.at + b.weight_behind * py.behind);
    Pack share = one;
    if (t.h > 0.0) {
      const Pack met = closing > 0.0 ? one - smaller(larger(-behind / Pack(closing), none), one) : none;
      share = select(was, one, met);
    }
    add(to.share, share);
  }
}

/// A pack of cells: tractions, and the numbers that their slopes are made of.
struct PassedCells {
  Pack px, py;
  Pack at, on_way;  ///< arms of the cell now, and of the middle of its way
  Mask slides;
  Pack size, bound;  ///< size of the traction before it slides, and bound [Pa]
  Pack faster;       ///< turned_by()
};

/// Factor on the displacement for the direction in which a cell slides: 1 as it begins to slide, and where
/// the patch rolls further in half lengths, times `rolling`, than the cell is displaced in times its bound.
/// It grows as 2 c - c^2, c the part of the displacement that goes beyond the bound: a cell displaced across
/// its traction needs more than one displaced nearly along it.
constexpr double turned_by_rolling = 5.0;
inline Pack turned_by(Pack turns, Pack rolled, Pack sticks, Pack bound, Pack vx, Pack vy) {
  const Pack v2 = vx * vx + vy * vy, v = root(v2), still = Pack(turned_by_rolling) * rolled * bound;
  const Pack beyond = smaller(larger(sticks - bound, Pack(0.0)), v);
  return Pack(1.0) + turns * beyond * (Pack(2.0) * v - beyond) / larger(v2 + still * still, Pack(1e-290));
}

inline PassedCells pass_cells(const MemoryPassTask& t, const RememberingStrip& s, std::int32_t i) {
  PassedCells c;
  const Pack share = load_pack(s.share + i);
  c.at = Pack(s.x) + Pack(s.reach) * load_pack(t.place + i);
  c.on_way = c.at + Pack(t.half_way) * share;
  // traction if it sticks
  const Pack by_x = (t.local[0] - t.local[2] * s.y) + s.own_x,
             by_y = (t.local[1] + s.own_y) - s.own_turn * s.x, turn = t.local[2] + s.own_turn;
  const Pack vx = Pack(s.growth_x) * share * by_x, vy = Pack(s.growth_y) * share * (by_y + turn * c.on_way);
  c.px = load_pack(s.px + i) - vx;
  c.py = load_pack(s.py + i) - vy;
  // onto the disk, whose bound goes from that of before to that of the end in proportion to the step
  const Pack bound = load_pack(s.bound + i);
  c.bound = bound + Pack(t.to_come) * (load_pack(s.had + i) - bound);
  const Pack sticks = root(c.px * c.px + c.py * c.py);
  c.slides = sticks > c.bound;
  c.faster = turned_by(s.turns, t.h / s.half_length, sticks, c.bound, vx, vy);
  c.px = c.px - (c.faster - Pack(1.0)) * vx;
  c.py = c.py - (c.faster - Pack(1.0)) * vy;
  c.size = root(c.px * c.px + c.py * c.py);
  return c;
}

inline void memory_pass_kernel(const MemoryPassTask& t) {
  for (std::int32_t j = 0; j < t.strips; ++j)
    for (std::int32_t i = 0; i < memory_cells; i += lanes) {
      const PassedCells c = pass_cells(t, t.from[j], i);
      const Pack ratio = select(c.slides, c.bound / select(c.slides, c.size, 1.0), 1.0);
      double* const to = t.px + j * t.stride + i;
      store_pack(to, c.px * ratio);
      store_pack(to + memory_cells, c.py * ratio);
    }
}

constexpr double turning = 0.1;  ///< part of a bound over which the slopes of a cell turn to sliding

/// Sums over the cells of a place and all strips, then over places in their order: the same with any lanes.
inline void memory_pass_sums_kernel(const MemoryPassTask& t, MemoryPassSums& sums) {
  constexpr std::int32_t numbers = 12;
  double of[numbers][memory_cells];
  for (std::int32_t i = 0; i < memory_cells; i += lanes) {
    Pack sum[numbers];
    for (Pack& one : sum) one = 0.0;
    for (std::int32_t j = 0; j < t.strips; ++j) {
      const RememberingStrip& s = t.from[j];
      const PassedCells c = pass_cells(t, s, i);
      const Pack none = 0.0, one = 1.0, area = s.area, y = s.y;
      const Pack inverse = one / select(c.slides, c.size, one);
      const Pack ratio = select(c.slides, c.bound * inverse, one);
      const Pack ex = select(c.slides, c.px * inverse, none), ey = select(c.slides, c.py * inverse, none);
      // Slopes turn from those of a cell that sticks to those of one that slides over a part of its bound:
      // forces after a fixed number of Newton's steps jump wherever the slopes do.
      const Pack beyond = larger(c.size - c.bound, none) / larger(Pack(turning) * c.bound, Pack(1e-290));
      const Pack slid = select(c.slides, smaller(beyond, one), none);
      const Pack px = c.px * ratio * area, py = c.py * ratio * area;
      sum[0] += px;
      sum[1] += py;
      sum[2] += c.at * py - y * px;
      // -d(force)/d(local): slopes of the point on the disk, ratio (1 - e e)
      const Pack part = load_pack(s.share + i) * area * ratio * c.faster;
      const Pack gx = Pack(s.growth_x) * part, gy = Pack(s.growth_y) * part;
      const Pack xx = one - slid * (ex * ex), yy = one - slid * (ey * ey), xy = -(slid * (ex * ey));
      const Pack x_x = gx * xx, x_y = gy * xy, y_x = gx * xy, y_y = gy * yy;
      const Pack x_turn = x_y * c.on_way - x_x * y, y_turn = y_y * c.on_way - y_x * y;
      sum[3] += x_x;
      sum[4] += x_y;
      sum[5] += x_turn;
      sum[6] += y_x;
      sum[7] += y_y;
      sum[8] += y_turn;
      sum[9] += c.at * y_x - y * x_x;
      sum[10] += c.at * y_y - y * x_y;
      sum[11] += c.at * y_turn - y * x_turn;
    }
    for (std::int32_t n = 0; n < numbers; ++n) store_pack(of[n] + i, sum[n]);
  }
  double* const to[numbers] = {&sums.force[0],    &sums.force[1],    &sums.force[2],    &sums.slope[0][0],
                               &sums.slope[0][1], &sums.slope[0][2], &sums.slope[1][0], &sums.slope[1][1],
                               &sums.slope[1][2], &sums.slope[2][0], &sums.slope[2][1], &sums.slope[2][2]};
  for (std::int32_t n = 0; n < numbers; ++n) {
    double sum = 0.0;
    for (const double one : of[n]) sum += one;
    *to[n] = sum;
  }
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

/// From the leading edge on, brought as in a part of a step. Over less than a cell a cell's own share w is
/// solved for: p nearest to q + w p in the disk is p nearest to q / (1 - w), that of a whole cell with the
/// part's arms.
inline void memory_march_kernel(const MemoryMarchTask& t) {
  for (std::int32_t first = 0; first < t.strips; first += lanes) {
    const std::int32_t count = t.strips - first < lanes ? t.strips - first : lanes;
    const Pack half = of_strips(t, first, &RememberingStrip::half_length);
    const Pack cell = half * Pack(2.0 / memory_cells), path = larger(Pack(t.h), cell);
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
      const BetweenCells b = between_cells(behind / cell - Pack(0.5), behind > Pack(0.0));
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
      const Pack faster = turned_by(turns, path / half, sticks, most, vx, vy) - Pack(1.0);
      sticks_x = sticks_x - faster * vx;
      sticks_y = sticks_y - faster * vy;
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
