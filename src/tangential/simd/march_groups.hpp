/// The loop over a patch that the march and strip FASTSIM share: groups of strips from the leading edge to
/// the trailing one, two groups in flight where all their strips move. Each has steps of its own:
/// begin_step() up to the turn of the traction's direction, settle() behind it.
#pragma once

#include "tangential/simd/strip_group.hpp"
#include "tangential/simd/turning.hpp"

namespace wrc::simd {
namespace {

/// Those of each kernel are found by their arguments; C++17 asks for some template of the name before.
template <bool entering>
void begin_step() = delete;
template <bool entering, Output output>
void settle() = delete;

/// A cell of a group in which strips move. entering: some may still be in their first stick zones.
template <bool entering, Output output, class Task, class Cell, class Marching, class Derivative,
          std::int32_t inputs>
WRC_IN_LOOP void move(const Task& task, const Cell& cell, Marching& m, Derivative (&derivative)[inputs]) {
  const Mask moves = m.group.stick_cells <= Pack(cell.index);
  auto step = begin_step<entering>(m.group, cell, moves, m.state);
  turn(step.turn);
  settle<entering, output>(task, cell, moves, step, m, derivative);
}

/// A cell of two groups all of whose strips move.
template <Output output, class Task, class Cell, class Marching, class Derivative, std::int32_t inputs>
WRC_IN_LOOP void move_both(const Task& task, const Cell& cell, Marching (&m)[in_flight],
                           Derivative (&derivative)[in_flight][inputs]) {
  const Mask all = Pack(0.0) <= Pack(0.0);
  // the turns of both at once hide the time of their roots and divides (TwoPacks of turning.hpp)
  auto first = begin_step<false>(m[0].group, cell, all, m[0].state);
  auto second = begin_step<false>(m[1].group, cell, all, m[1].state);
  turn(first.turn, second.turn);
  settle<false, output>(task, cell, all, first, m[0], derivative[0]);
  settle<false, output>(task, cell, all, second, m[1], derivative[1]);
}

/// Takes all strips of a task over their cells. A kernel's own parts are those of March: Marching, a group
/// during the march, in_flight of them at a time; prepare() a group and its derivatives; cell() number i;
/// stay(), a cell in the first stick zones of all strips of a group, where March::stays, otherwise such cells
/// are left out; finish(), a group's part of the results.
template <Output output, class March, class Task>
WRC_IN_LOOP void march_groups(const Task& task, const March& march) {
  constexpr std::int32_t together = March::in_flight;
  for (std::int32_t first = 0; first < task.strips; first += together * lanes) {
    // as many groups as are marched side by side; the last ones may be fewer
    typename March::Marching marching[together];
    typename March::Derivative derivative[together][March::inputs];  // not touched without sensitivities
    std::int32_t groups = 0;
    std::int32_t start = task.cells;  // no strip moves before
    std::int32_t both_move = 0;       // cells from this one on are those of move_both()
    for (std::int32_t at = first; at < task.strips && groups < together; at += lanes, ++groups) {
      typename March::Marching& m = marching[groups];
      march.prepare(at, task.strips - at < lanes ? task.strips - at : lanes, m, derivative[groups]);
      start = m.group.all_stick < start ? m.group.all_stick : start;
      both_move = m.group.all_move > both_move ? m.group.all_move : both_move;
    }
    // Cells from the leading edge on. Behind the last strip's first stick zone both groups step at once;
    // before it each by itself, with or without lanes that still stick.
    for (std::int32_t i = March::stays ? 0 : start; i < task.cells; ++i) {
      const auto cell = march.cell(i);
      if constexpr (together == 2) {
        if (groups == together && i >= both_move) {
          move_both<output>(task, cell, marching, derivative);
          continue;
        }
      }
      for (std::int32_t k = 0; k < groups; ++k) {
        typename March::Marching& m = marching[k];
        if (i >= m.group.all_move) {
          move<false, output>(task, cell, m, derivative[k]);
        } else if (i >= m.group.all_stick) {
          move<true, output>(task, cell, m, derivative[k]);
        } else if constexpr (March::stays) {
          march.stay(cell, m, derivative[k]);
        }
      }
    }
    // in the order of the strips, which is part of the sums' bits
    for (std::int32_t k = 0; k < groups; ++k) march.finish(marching[k], derivative[k]);
  }
}

}  // namespace
}  // namespace wrc::simd
