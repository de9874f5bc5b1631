/// The approach under which a method's patch carries a prescribed load.
#pragma once

#include <algorithm>
#include <cmath>

#include "normal/penetration.hpp"
#include "normal/problem.hpp"

namespace wrc {

/// First guess of the approach for a load: the sphere of curvature 2 A [1/m] in x, Hertz's
/// delta^3 = (3 pi c N / 4)^2 2 A with the pair's compliance c; wheel and rail lie within a factor of two of
/// it [m].
double first_guess(const NormalProblem& problem, double coefficient_x) noexcept;

/// Fills what follows from the strips (peak, area), notes where the gap was lowest, and flags a patch at the
/// edge.
void complete_solution(const Strips& strips, const GapMinimum& lowest, bool at_edge, NormalSolution& solution,
                       Fault& fault) noexcept;

/// Goes on from the solution at the deepest approach the rows describe to the load or approach prescribed
/// beyond it: linearly, with its stiffness there, every pressure in proportion to the load. Takes approach,
/// normal_force and stiffness of the solution, and the strips; returns WRC_FLAG_BEYOND_GAP.
Fault continue_beyond(const NormalProblem& problem, Strips& strips, NormalSolution& solution) noexcept;

/// A straightened measure of the load: N grows like approach^1.5 on elliptic gaps and like approach^1.4 on
/// worn ones, so N^{11/16} grows almost like the approach itself and the secant rule on it needs four
/// evaluations.
inline double straightened(double normal_force) noexcept {
  const double half = std::sqrt(normal_force);
  const double eighth = std::sqrt(std::sqrt(half));
  return half * eighth * std::sqrt(eighth);
}

/// Where the load leaps as the approach grows, because a second region joins the patch: the strips of the
/// patch after the leap, made to carry a load between those before and after. The strips beyond the patch
/// before the leap come in gradually, so that patch and pressure move with the load instead of leaping.
/// False if there are none, and the leap is of another kind.
struct BeforeLeap {
  Span span;                  ///< of the patch
  double normal_force = 0.0;  ///< [N]
};
bool join_gradually(const BeforeLeap& before, double target, Strips& strips) noexcept;

/// A state of the search.
struct Trial {
  double approach = 0.0, normal_force = 0.0;
  Span span;
};

/// Rows first .. last, none if last < first.
struct RowRange {
  std::int32_t first = 0, last = -1;
};

/// The rows that keep a second region from the patch `before`, from its border to where the region is
/// deepest, on the side where the overlap, that of the patch `after`, falls and rises most.
template <class Scale>
RowRange barrier_between(Overlap<Scale>& overlap, const Span& before, const Span& after) noexcept {
  const GapRows& rows = overlap.rows;
  const auto rows_below = [&](double y) {
    return static_cast<std::int32_t>(std::lower_bound(rows.y, rows.y + rows.count, y) - rows.y);
  };
  RowRange barrier;
  double highest = 0.0;
  // Inwards from the border of the patch after the leap.
  const auto walk = [&](std::int32_t from, std::int32_t to, std::int32_t step) {
    double deepest = 0.0;
    std::int32_t deepest_row = from;
    for (std::int32_t j = from; (to - j) * step >= 0; j += step) {
      const double g = overlap.at_row(j);
      if (g > deepest) {
        deepest = g;
        deepest_row = j;
      }
      if (deepest - g > highest) {
        highest = deepest - g;
        barrier = {std::min(deepest_row, to), std::max(deepest_row, to)};
      }
    }
  };
  walk(rows_below(after.y_from), rows_below(before.y_from) - 1, 1);
  walk(rows_below(after.y_to) - 1, rows_below(before.y_to), -1);
  return barrier;
}

/// Narrows a leap of the patch's extent between low and high. On which side of it an approach lies, tells the
/// overlap at the barrier that parts the regions, which vanishes where they join; without a barrier, the
/// extents do. Where to look next, a secant on that overlap, or bisection where that does not get there.
template <class ScaleAt>
void narrow_leap(const GapRows& rows, const GapMinimum& lowest, ScaleAt&& scale_at, Trial& low,
                 Trial& high) noexcept {
  constexpr int secants = 6;  // 3 to 5 are used
  constexpr int cap = 40;
  const double width = 1e-5 * high.approach;
  const auto overlap_at = [&](double approach) {
    return Overlap<decltype(scale_at(approach))>{rows, lowest, scale_at(approach), approach};
  };
  auto at_high = overlap_at(high.approach), at_low = overlap_at(low.approach);
  const RowRange barrier = barrier_between(at_high, low.span, high.span);
  const auto least = [&](auto& overlap) {
    double g = high.approach;
    for (std::int32_t j = barrier.first; j <= barrier.last; ++j) g = std::min(g, overlap.at_row(j));
    return g;
  };
  const auto apart = [](const Span& a, const Span& b) {
    return std::abs(a.y_from - b.y_from) + std::abs(a.y_to - b.y_to);
  };
  double before = high.approach, g_before = least(at_high), last = low.approach, g_last = least(at_low);
  for (int i = 0; i < cap && high.approach - low.approach > width; ++i) {
    double next = 0.5 * (low.approach + high.approach);
    // Half the width wanted beyond an end that is next to the root: the other end then follows.
    if (i < secants && g_last != g_before)
      next = std::clamp(last - g_last * (last - before) / (g_last - g_before), low.approach + 0.5 * width,
                        high.approach - 0.5 * width);
    auto overlap = overlap_at(next);
    before = last;
    g_before = g_last;
    last = next;
    g_last = least(overlap);
    bool joined = g_last > 0.0;
    if (barrier.last < barrier.first) {
      const Span span = penetration_span(rows, lowest, overlap.scale, next);
      joined = apart(span, high.span) <= apart(span, low.span);
    }
    (joined ? high : low).approach = next;
  }
}

/// Power p in N ~ approach^p beyond which the load leaps; 1.5 is Hertz's, 1 that of a patch which cannot
/// grow.
inline constexpr double steepest_power = 6.0;

/// The load leaps between two states of a search, low below high.
inline bool leaps_between(const Trial& low, const Trial& high) noexcept {
  return low.normal_force > 0.0 && (high.normal_force - low.normal_force) * low.approach >
                                       steepest_power * low.normal_force * (high.approach - low.approach);
}

/// Finds the patch at the prescribed approach, or searches the approach for the prescribed load: secant steps
/// kept inside the bracket of what is known, bisection where they leave it. A method is two functions:
/// `scale_at` gives the scale of the penetration at an approach [m], and `force` (approach, scale, extent of
/// the patch) the patch's load [N], filling `strips`. Fills approach, normal_force, stiffness and iterations
/// (calls of `force`) of the solution. `start` > 0: first guess of the approach.
///
/// The search ends at a load within problem.force_tolerance of the one prescribed. The last secant step is
/// taken without another evaluation: the approach moves by it and the pressures are scaled to the load.
///
/// WRC_FLAG_BEYOND_GAP past the ceiling, continue_beyond(). WRC_FLAG_LOAD_LEAPS where the load leaps past the
/// target: join_gradually(), or where that is not possible the patch after the leap, scaled to the load.
/// WRC_FLAG_ITERATION_CAP if the cap ended the search: the patch is then that of the last trial, scaled.
template <class ScaleAt, class Force>
Fault search_approach(const NormalProblem& problem, const GapMinimum& lowest, double start,
                      ScaleAt&& scale_at, Force&& force, Strips& strips, NormalSolution& solution) noexcept {
  constexpr double probe = 1e-4;         // relative step of a stiffness that no two iterates give
  constexpr double least_share = 1e-12;  // of the ceiling: below, halving would go on to denormal approaches
  constexpr double least_step = 1e-7;    // relative: over less, rounding is felt in a secant's slope
  constexpr double rounding = 1e-12;     // of a load, from where the borders' root search ends
  constexpr int most_leaps = 4;          // looked into
  const GapRows& rows = problem.gap;
  const double ceiling = std::min(deepest_approach(rows, lowest), problem.deepest);
  const auto evaluate = [&](double approach) {
    ++solution.iterations;
    const auto scale = scale_at(approach);
    const Span span = penetration_span(rows, lowest, scale, approach);
    return Trial{approach, force(approach, scale, span), span};
  };
  const auto settle = [&](double approach) {
    const double beside = evaluate(approach * (1.0 - probe)).normal_force;
    solution.approach = approach;
    solution.normal_force = evaluate(approach).normal_force;
    solution.stiffness = (solution.normal_force - beside) / (approach * probe);
  };

  if (problem.prescribed == Prescribed::approach) {
    settle(std::min(problem.approach, ceiling));
    return problem.approach > ceiling ? continue_beyond(problem, strips, solution) : Fault{};
  }

  const double target = problem.normal_force;
  const double x_target = straightened(target);
  const double tolerance = std::max(problem.force_tolerance, rounding);
  const auto scale_to_target = [&](double from) {
    for (std::int32_t j = 0; j < strips.count; ++j) strips.peak[j] *= target / from;
    solution.normal_force = target;
  };
  Trial low, high;
  high.approach = ceiling;
  bool bracketed = false;
  int leaps = 0;
  double approach = std::min(start, ceiling);
  double previous = 0.0, x_previous = 0.0;  // the unloaded state is a point of the curve
  double slope = 0.0;
  for (std::int32_t i = 0; i < problem.max_iterations; ++i) {
    const Trial trial = evaluate(approach);
    const double x = straightened(trial.normal_force);
    if (std::abs(approach - previous) > least_step * approach)
      slope = (x - x_previous) / (approach - previous);
    // A step across a merging patch may have misled the secant.
    if (!(slope > 0.0) && approach > 0.0) slope = x / approach;
    const double error = trial.normal_force / target - 1.0;
    if (std::abs(error) <= tolerance && i > 0) {
      solution.approach = approach + (x_target - x) / slope;
      // dN/d(approach) = (16/11) (N / x) dx/d(approach)
      solution.stiffness = 16.0 / 11.0 * target / x_target * slope;
      scale_to_target(trial.normal_force);
      return {};
    }
    if (trial.normal_force < target) {
      if (approach >= ceiling) {
        settle(ceiling);
        return continue_beyond(problem, strips, solution);
      }
      low = trial;
    } else {
      high = trial;
      bracketed = true;
      if (high.approach < least_share * ceiling) break;  // a needle of a gap: any approach carries more
    }
    double next = approach + (x_target - x) / slope;
    if (!bracketed) next = std::min(std::max(next, 1.001 * approach), 10.0 * approach);
    if (!bracketed && next >= ceiling) next = ceiling;
    if (bracketed && !(next > low.approach && next < high.approach))
      next = 0.5 * (low.approach + high.approach);
    const bool steep = bracketed && leaps_between(low, high);
    if (steep) next = 0.5 * (low.approach + high.approach);
    if (steep && leaps < most_leaps) {
      ++leaps;
      // The slope of the larger patch, as far as one is known.
      const double chord = high.normal_force / high.approach;
      Trial before = low, after = high;
      narrow_leap(rows, lowest, scale_at, before, after);
      before = evaluate(before.approach);
      after = evaluate(after.approach);
      const bool reached_before = before.normal_force >= target, reached_after = after.normal_force >= target;
      if (!reached_before && reached_after && leaps_between(before, after)) {
        const double rise = high.normal_force - after.normal_force;
        const double run = high.approach - after.approach;
        solution.approach = after.approach;
        solution.stiffness = run > probe * high.approach && rise > 0.0 ? rise / run : chord;
        if (join_gradually({before.span, before.normal_force}, target, strips))
          solution.normal_force = target;
        else
          scale_to_target(after.normal_force);
        return {
            .status = WRC_FLAG_LOAD_LEAPS,
            .field = "load.normal_force",
            .value = target,
            .unit = "N",
            .cause =
                "as the approach grows a second region joins the patch, or its curvature changes, at once; "
                "the patch after that carries the load, and more iterations do not help"};
      }
      // The load is reached on one side of the leap, where the search goes on from that side's end: by the
      // chord of what is left, and then by secants through the end, which is near.
      if (reached_before) {
        high = before;
      } else if (reached_after) {
        low = before;
        high = after;
      } else {
        low = after;
      }
      const double x_low = straightened(low.normal_force), x_high = straightened(high.normal_force);
      previous = reached_before ? high.approach : low.approach;
      x_previous = reached_before ? x_high : x_low;
      approach = low.approach + (x_target - x_low) / (x_high - x_low) * (high.approach - low.approach);
      continue;
    }
    previous = approach;
    x_previous = x;
    approach = next;
  }
  settle(bracketed ? high.approach : approach);
  scale_to_target(solution.normal_force);
  return {.status = WRC_FLAG_ITERATION_CAP,
          .field = "config.max_iterations",
          .value = static_cast<double>(problem.max_iterations),
          .unit = "steps"};
}

}  // namespace wrc
