/// Search for the approach under which a method's patch carries a prescribed load.
#pragma once

#include <algorithm>
#include <cmath>

#include "normal/penetration/penetration.hpp"
#include "normal/problem.hpp"

namespace wrc::normal {

/// First guess of the approach for a load: the sphere of curvature 2 A [1/m] in x, Hertz's
/// delta^3 = (3 pi c N / 4)^2 2 A with the pair's compliance c; wheel and rail lie within a factor of two of
/// it [m].
double first_guess(const NormalProblem& problem, double coefficient_x) noexcept;

/// Fills peak pressure and area of the strips and the place of first touch, and flags a patch at the edge.
void complete_solution(const patch::Strips& strips, const patch::GapMinimum& lowest, bool at_edge,
                       NormalSolution& solution, Fault& fault) noexcept;

/// Goes on from the solution at the deepest approach the rows describe to the load or approach prescribed
/// beyond it: linearly, with its stiffness there, every pressure in proportion to the load. Takes approach,
/// normal_force and stiffness of the solution, and the strips; returns WRC_FLAG_BEYOND_GAP.
Fault continue_beyond(const NormalProblem& problem, patch::Strips& strips, NormalSolution& solution) noexcept;

/// A straightened measure of the load: N grows like approach^1.5 on elliptic gaps and like approach^1.4 on
/// worn ones, so N^{11/16} grows almost like the approach itself and the secant rule on it needs four
/// evaluations.
inline double straightened(double normal_force) noexcept {
  const double half = std::sqrt(normal_force);
  const double eighth = std::sqrt(std::sqrt(half));
  return half * eighth * std::sqrt(eighth);
}

/// Makes the strips of the patch after a jump of the load carry a load between those before and after it. The
/// load jumps as the approach grows where a second region joins the patch. The strips beyond the patch
/// before the jump come in gradually, so that patch and pressure move with the load instead of jumping.
/// False if there are none, and the jump is of another kind.
struct BeforeJump {
  Span span;                  ///< span of the patch
  double normal_force = 0.0;  ///< [N]
};
bool join_gradually(const BeforeJump& before, double target, patch::Strips& strips) noexcept;

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
  const patch::GapRows& rows = overlap.rows;
  const auto rows_below = [&](double y) {
    return static_cast<std::int32_t>(std::lower_bound(rows.y, rows.y + rows.count, y) - rows.y);
  };
  RowRange barrier;
  double highest = 0.0;
  // Inwards from the border of the patch after the jump.
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
  // On both sides; the higher barrier counts.
  walk(rows_below(after.y_from), rows_below(before.y_from) - 1, 1);
  walk(rows_below(after.y_to) - 1, rows_below(before.y_to), -1);
  return barrier;
}

/// Narrows a jump of the patch's extent between low and high. The side of it on which an approach lies
/// follows from the overlap at the barrier between the regions, which vanishes where they join; without a
/// barrier, from the extents. The next approach is that of a secant on that overlap, or of bisection where
/// the secant does not converge.
template <class ScaleAt>
void narrow_jump(const patch::GapRows& rows, const patch::GapMinimum& lowest, ScaleAt&& scale_at, Trial& low,
                 Trial& high) noexcept {
  constexpr int secants = 6;  // 3 to 5 are used
  constexpr int cap = 40;
  const double width = 1e-5 * high.approach;
  const auto overlap_at = [&](double approach) {
    return Overlap<decltype(scale_at(approach))>{rows, lowest, scale_at(approach), approach};
  };
  auto at_high = overlap_at(high.approach), at_low = overlap_at(low.approach);
  const RowRange barrier = barrier_between(at_high, low.span, high.span);
  // Function whose root is sought: least overlap over the barrier, above 0 once the regions have joined [m].
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
    // Without a barrier the extents tell on which side of the jump this approach lies.
    bool joined = g_last > 0.0;
    if (barrier.last < barrier.first) {
      const Span span = penetration_span(rows, lowest, overlap.scale, next);
      joined = apart(span, high.span) <= apart(span, low.span);
    }
    (joined ? high : low).approach = next;
  }
}

/// Power p in N ~ approach^p beyond which the load jumps; 1.5 is Hertz's, 1 that of a patch which cannot
/// grow.
inline constexpr double steepest_power = 6.0;

/// The load jumps between two states of a search, low below high.
inline bool jumps_between(const Trial& low, const Trial& high) noexcept {
  return low.normal_force > 0.0 && (high.normal_force - low.normal_force) * low.approach >
                                       steepest_power * low.normal_force * (high.approach - low.approach);
}

/// The search of search_approach(), step by step; see there.
template <class ScaleAt, class Force>
class LoadSearch {
 public:
  LoadSearch(const NormalProblem& problem, const patch::GapMinimum& lowest, ScaleAt& scale_at, Force& force,
             patch::Strips& strips, NormalSolution& solution) noexcept
      : problem_(problem),
        lowest_(lowest),
        scale_at_(scale_at),
        force_(force),
        strips_(strips),
        solution_(solution),
        ceiling_(std::min(deepest_approach(problem.gap, lowest), problem.deepest)) {}

  /// The patch at the prescribed approach.
  Fault at_approach() noexcept {
    settle(std::min(problem_.approach, ceiling_));
    return problem_.approach > ceiling_ ? continue_beyond(problem_, strips_, solution_) : Fault{};
  }

  /// The approach of the prescribed load.
  Fault for_load(double start) noexcept {
    const double tolerance = std::max(problem_.force_tolerance, rounding);
    high_.approach = ceiling_;
    double approach = std::min(start, ceiling_);
    for (std::int32_t i = 0; i < problem_.max_iterations; ++i) {
      // A trial; the load straightened, for the secant.
      const Trial trial = evaluate(approach);
      const double x = straightened(trial.normal_force);
      take_slope(approach, x);
      if (std::abs(trial.normal_force / target_ - 1.0) <= tolerance && i > 0) return arrive(trial, x);
      // Too little load: the lower end of the bracket, or the ceiling, where the rows end. Too much: the
      // upper end.
      if (trial.normal_force < target_) {
        if (approach >= ceiling_) {
          settle(ceiling_);
          return continue_beyond(problem_, strips_, solution_);
        }
        low_ = trial;
      } else {
        high_ = trial;
        bracketed_ = true;
        if (high_.approach < least_share * ceiling_) break;  // a needle of a gap: any approach carries more
      }
      // The load may jump inside the bracket: the jump is narrowed, a few times at most; then bisection.
      const bool steep = bracketed_ && jumps_between(low_, high_);
      if (steep && jumps_ < most_jumps) {
        ++jumps_;
        const Fault jump = look_into_jump();
        if (jump.status != WRC_OK) return jump;
        approach = go_on_from_jump();
        continue;
      }
      previous_ = approach;
      x_previous_ = x;
      approach = steep ? 0.5 * (low_.approach + high_.approach) : next_approach(approach, x);
    }
    // The cap: the patch of the last bracket, scaled to the load.
    settle(bracketed_ ? high_.approach : approach);
    scale_to_target(solution_.normal_force);
    return Fault::iteration_cap("config.normal.max_iterations", {problem_.max_iterations, "steps"});
  }

 private:
  static constexpr double probe = 1e-4;         // relative step of a stiffness that no two iterates give
  static constexpr double least_share = 1e-12;  // share of the ceiling: halving could reach denormals below
  static constexpr double least_step = 1e-7;    // relative: over less, rounding is felt in a secant's slope
  static constexpr double rounding = 1e-12;     // share of a load, from where the borders' root search ends
  static constexpr int most_jumps = 4;          // looked into

  Trial evaluate(double approach) noexcept {
    ++solution_.iterations;
    const auto scale = scale_at_(approach);
    const Span span = penetration_span(problem_.gap, lowest_, scale, approach);
    return Trial{approach, force_(approach, scale, span), span};
  }

  /// The solution at an approach, its stiffness by a difference.
  void settle(double approach) noexcept {
    const double beside = evaluate(approach * (1.0 - probe)).normal_force;
    solution_.approach = approach;
    solution_.normal_force = evaluate(approach).normal_force;
    solution_.stiffness = (solution_.normal_force - beside) / (approach * probe);
  }

  void scale_to_target(double from) noexcept {
    for (std::int32_t j = 0; j < strips_.count; ++j) strips_.peak[j] *= target_ / from;
    solution_.normal_force = target_;
  }

  /// The secant through the trial before.
  void take_slope(double approach, double x) noexcept {
    if (std::abs(approach - previous_) > least_step * approach)
      slope_ = (x - x_previous_) / (approach - previous_);
    // A step across a merging patch may have misled the secant.
    if (!(slope_ > 0.0) && approach > 0.0) slope_ = x / approach;
  }

  /// The last secant step, taken without another evaluation.
  Fault arrive(const Trial& trial, double x) noexcept {
    solution_.approach = trial.approach + (x_target_ - x) / slope_;
    // dN/d(approach) = (16/11) (N / x) dx/d(approach)
    solution_.stiffness = 16.0 / 11.0 * target_ / x_target_ * slope_;
    scale_to_target(trial.normal_force);
    return {};
  }

  /// The next approach [m]: by the secant, kept inside the bracket.
  double next_approach(double approach, double x) const noexcept {
    // Not bracketed yet: upwards, ten times at most. Bracketed: bisection where the secant leaves the
    // bracket.
    double next = approach + (x_target_ - x) / slope_;
    if (!bracketed_) next = std::min(std::max(next, 1.001 * approach), 10.0 * approach);
    if (!bracketed_ && next >= ceiling_) next = ceiling_;
    if (bracketed_ && !(next > low_.approach && next < high_.approach))
      next = 0.5 * (low_.approach + high_.approach);
    return next;
  }

  /// Narrows the jump between the ends of the bracket. If the load lies in it, that is the solution, with
  /// WRC_FLAG_LOAD_JUMPS; if not, the bracket shrinks to the load's side of the jump.
  Fault look_into_jump() noexcept {
    // Stiffness [N/m] for want of a better one.
    const double chord = high_.normal_force / high_.approach;
    Trial before = low_, after = high_;
    narrow_jump(problem_.gap, lowest_, scale_at_, before, after);
    before = evaluate(before.approach);
    after = evaluate(after.approach);
    reached_before_ = before.normal_force >= target_;
    const bool reached_after = after.normal_force >= target_;
    if (!reached_before_ && reached_after && jumps_between(before, after)) {
      // The load lies in the jump: stiffness of the patch after it, by the chord beyond.
      const double rise = high_.normal_force - after.normal_force;
      const double run = high_.approach - after.approach;
      solution_.approach = after.approach;
      solution_.stiffness = run > probe * high_.approach && rise > 0.0 ? rise / run : chord;
      if (join_gradually({before.span, before.normal_force}, target_, strips_))
        solution_.normal_force = target_;
      else
        scale_to_target(after.normal_force);
      return Fault::load_jumps(
          "load.normal_force", {target_, "N"},
          "as the approach grows a second region joins the patch, or its curvature changes, at once; "
          "the patch after that carries the load, and more iterations do not help");
    }
    // The load lies beside the jump.
    if (reached_before_) {
      high_ = before;
    } else if (reached_after) {
      low_ = before;
      high_ = after;
    } else {
      low_ = after;
    }
    return {};
  }

  /// Goes on from the end of the jump: by the chord of the new bracket, and then by secants through that end,
  /// which is near.
  double go_on_from_jump() noexcept {
    const double x_low = straightened(low_.normal_force), x_high = straightened(high_.normal_force);
    previous_ = reached_before_ ? high_.approach : low_.approach;
    x_previous_ = reached_before_ ? x_high : x_low;
    return low_.approach + (x_target_ - x_low) / (x_high - x_low) * (high_.approach - low_.approach);
  }

  const NormalProblem& problem_;
  const patch::GapMinimum& lowest_;
  ScaleAt& scale_at_;
  Force& force_;
  patch::Strips& strips_;
  NormalSolution& solution_;
  const double ceiling_;  ///< the deepest approach that is solved [m]
  const double target_ = problem_.normal_force, x_target_ = straightened(target_);
  Trial low_, high_;  ///< the bracket: low carries less than the target, high more once `bracketed_`
  bool bracketed_ = false, reached_before_ = false;
  int jumps_ = 0;
  double previous_ = 0.0,
         x_previous_ = 0.0;  ///< the trial before; the unloaded state is a point of the curve
  double slope_ = 0.0;       ///< slope of the straightened load over the approach
};

/// Finds the patch at the prescribed approach, or searches the approach for the prescribed load: secant steps
/// kept inside the bracket, bisection where they leave it. A method is two functions:
/// `scale_at` gives the scale of the penetration at an approach [m], and `force` (approach, scale, extent of
/// the patch) the patch's load [N], filling `strips`. Fills approach, normal_force, stiffness and iterations
/// (calls of `force`) of the solution. `start` > 0: first guess of the approach.
///
/// The search ends at a load within problem.force_tolerance of the one prescribed. The last secant step is
/// taken without another evaluation: the approach moves by it and the pressures are scaled to the load.
///
/// WRC_FLAG_BEYOND_GAP past the ceiling, continue_beyond(). WRC_FLAG_LOAD_JUMPS where the load jumps past the
/// target: join_gradually(), or where that is not possible the patch after the jump, scaled to the load.
/// WRC_FLAG_ITERATION_CAP if the cap ended the search: the patch is then that of the last trial, scaled.
template <class ScaleAt, class Force>
Fault search_approach(const NormalProblem& problem, const patch::GapMinimum& lowest, double start,
                      ScaleAt&& scale_at, Force&& force, patch::Strips& strips,
                      NormalSolution& solution) noexcept {
  LoadSearch search(problem, lowest, scale_at, force, strips, solution);
  return problem.prescribed == Prescribed::approach ? search.at_approach() : search.for_load(start);
}

/// A method as a whole whose `force` fills the strips: the search, started from the sphere of curvature
/// 2 coefficient_x [1/m], and complete_solution(). `at_edge`: `force` came to the end of the rows.
template <class ScaleAt, class Force>
Fault solve_by_search(const NormalProblem& problem, const patch::GapMinimum& lowest, double coefficient_x,
                      ScaleAt&& scale_at, Force&& force, const bool& at_edge, patch::Strips& strips,
                      NormalSolution& solution) noexcept {
  Fault fault = search_approach(problem, lowest, first_guess(problem, coefficient_x), scale_at, force, strips,
                                solution);
  if (fault.failed()) {
    strips.count = 0;
    return fault;
  }
  complete_solution(strips, lowest, at_edge, solution, fault);
  return fault;
}

}  // namespace wrc::normal
