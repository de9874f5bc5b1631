#include "surface/pressure/pressure.hpp"

#include <algorithm>
#include <iterator>

#include "base/number.hpp"
#include "surface/pressure/iteration.hpp"
#include "surface/pressure/newton.hpp"
#include "surface/pressure/pressure_scratch.hpp"
#include "surface/pressure/start.hpp"

namespace wrc::surface {
namespace {

/// Part of the area that the first iteration from an earlier solution may move; beyond, the solve starts from
/// the overlaps.
constexpr double farthest_start = 0.3;

/// Part of the area by which an earlier solution may be moved to be a start; from one farther away the
/// overlaps are nearer, and lead to another solution less often where there are two. The second is for marks
/// on a rail that changes along the track, where contact moves over the strips from step to step.
constexpr double farthest_followed = 0.5, farthest_along_track = 0.1;

/// A way to a solution: by that at overlaps so many times as deep, which is found roughly first.
struct Way {
  double by;
  bool accelerated = true;
};

/// Ways that are taken until one finds the solution. Where two solutions have just vanished, acceleration and
/// Newton's method end in the minimum that the residual has there; the preconditioned map leads past it.
/// Beside a pose with two solutions most detours lead past the place that holds up the first.
constexpr Way ways[] = {{1.0}, {0.7}, {1.0, false}, {1.4}, {0.5},  {2.0},  {0.85}, {1.15},
                        {0.6}, {1.7}, {0.4},        {2.5}, {0.92}, {1.08}, {0.77}, {1.27}};
constexpr std::int32_t plain_iterations = 100;  ///< steps of the way without acceleration
constexpr double found_roughly = 1e-3;          ///< tolerance at those overlaps

/// Strips of the candidates, with the lengths and shifts of the start. Returns whether any has a length.
bool load_strips(const RailStrips& rail, const Overlaps& o, const PressureStart& start, StartFrom from,
                 PressureScratch& w) {
  StripSet& s = w.fine;
  bool started = false;
  s.count = o.count;
  s.behind = 0;
  for (std::int32_t i = 0; i < o.count; ++i) {
    const std::int32_t j = on_rail(o.strip[i]);
    s.behind += o.strip[i] < second_places ? 1 : 0;
    s.place[i] = place_on_rail(rail, o.strip[i]);
    s.width[i] = rail.width[j];
    s.depth[i] = o.depth[i];
    s.curvature[i] = o.curvature[i];
    s.deepest_x[i] = o.centre[i];
    s.ny[i] = o.ny[i];
    s.nz[i] = o.nz[i];
    // Candidates that were not in contact then have L = 0 and may enter.
    s.L[i] = s.shift[i] = w.depth_before[i] = 0.0;
  }
  if (from == StartFrom::overlaps) return false;
  for_shared_strips(o.count, o.strip, start.count, start.strip, [&](std::int32_t i, std::int32_t b) {
    s.L[i] = larger(start.length_squared[b], 0.0);
    s.shift[i] = start.shift[b];
    w.depth_before[i] = start.depth[b];
    started = started || s.L[i] > 0.0;
  });
  return started;
}

/// The solution over the candidates, and where the next solve may start.
void store(const Overlaps& o, const PressureScratch& w, PressureStart& start, const StripPressure& p) {
  const StripSet& s = w.fine;
  start.count = s.count;
  for (std::int32_t i = 0; i < s.count; ++i) {
    start.strip[i] = o.strip[i];
    start.length_squared[i] = s.L[i] > 0.0 ? s.L[i] : w.continued[i];
    start.shift[i] = s.shift[i];
    start.depth[i] = s.depth[i];
    p.length_squared[i] = s.L[i];
    p.peak_per_length[i] = s.L[i] > 0.0 ? s.q[i] / s.L[i] : 0.0;
    p.centre[i] = s.deepest_x[i] + s.shift[i];
    p.line_load[i] = s.q[i];
  }
}

/// Takes the best of the attempts that failed.
void return_to_best(const StripSet& s, const PressureScratch& w) {
  std::copy_n(w.best.x, s.count, s.L);
  std::copy_n(w.best.x + s.count, s.count, s.shift);
  std::copy_n(w.best.q, s.count, s.q);
}

/// Strips that a limit counts at least: small contacts may take more iterations than others.
constexpr std::int32_t fewest_budgeted = 10;

/// The options with the work that a solve of these overlaps may take.
PressureOptions limited_by_overlaps(const Overlaps& o, PressureOptions options) {
  std::int32_t overlapping = 0;
  for (std::int32_t i = 0; i < o.count; ++i) overlapping += o.depth[i] > 0.0;
  overlapping = std::max(overlapping, fewest_budgeted);
  options.max_work = smaller(options.max_work, options.max_iterations * 2.0 * work_of_pass(overlapping));
  return options;
}

/// Iterations over the strips in contact that a solve may take: many may overlap where few are in contact.
double most_in_contact(const PressureOptions& options) { return 1.9 * options.max_iterations; }

/// Work that a solve may take whose best iterate has so many strips in contact.
double allowed_work(const PressureOptions& options, std::int32_t strips) {
  return smaller(options.max_work, work_in_contact(strips, most_in_contact(options)));
}

/// Is too little work left for another attempt, which takes several iterations?
bool is_used_up(const PressureOptions& options, const PressureResult& best, const PressureScratch& w) {
  const double several = 8.0 * work_of_pass(w.active.count);
  return w.work + several > allowed_work(options, best.strips);
}

/// Keeps the outcome of an attempt that failed, if it is better than those before: if its strips, and not
/// those of the best, are as many as the work was allowed for, or else if the map moves it less.
void keep_best(const StripSet& s, const PressureOptions& options, const PressureResult& result,
               PressureScratch& w) {
  const auto allowed = [&](std::int32_t strips) { return w.work <= allowed_work(options, strips); };
  // Attempts on as many strips as the work allows come before all others.
  const bool enough = allowed(result.strips);
  const bool better = w.best.moved == any_change || enough == allowed(strips_of(w.best, s))
                          ? result.residual < w.best.moved
                          : enough;
  if (!better) return;
  w.best.moved = result.residual;
  std::copy_n(s.L, s.count, w.best.x);
  std::copy_n(s.shift, s.count, w.best.x + s.count);
  std::copy_n(s.q, s.count, w.best.q);
}

/// Solves from the overlaps, in one way after the other until one finds the solution.
PressureResult solve_from_overlaps(const PressureProblem& problem, const Overlaps& o,
                                   const PressureOptions& options, PressureScratch& w) {
  StripSet& s = w.fine;
  PressureResult result;
  std::int32_t spent = 0;
  for (const auto& [by, accelerated] : ways) {
    for (std::int32_t i = 0; i < s.count; ++i) s.depth[i] *= by;
    spent += start_from_overlaps(problem, o, options.max_work, w);
    if (by != 1.0) {
      // The solution at those overlaps; lengths L in proportion to them begin here.
      spent += iterate(problem, s, {found_roughly, any_change, options.max_work, most_in_contact(options)}, w)
                   .iterations;
      for (std::int32_t i = 0; i < s.count; ++i) {
        s.depth[i] = o.depth[i];
        s.L[i] /= by;
      }
    }
    IterationLimits limits{options.tolerance, any_change, options.max_work, most_in_contact(options)};
    // Without acceleration steps are small, and many of them lead out of a minimum.
    limits.accelerated = accelerated;
    if (!accelerated) limits.most = plain_iterations;
    result = iterate(problem, s, limits, w);
    result.iterations = spent += result.iterations;
    if (result.converged) return result;
    keep_best(s, options, result, w);
    if (is_used_up(options, result, w)) break;
    // Newton's method from the iterate that the map moves least.
    limits.max_work = allowed_work(options, result.strips);
    result = solve_by_newton(problem, s, limits, w);
    result.iterations = spent += result.iterations;
    if (result.converged) return result;
    keep_best(s, options, result, w);
    if (is_used_up(options, result, w)) break;
  }
  return_to_best(s, w);
  result.residual = w.best.moved;
  return result;
}

}  // namespace

std::int64_t pressure_doubles(std::int32_t most) {
  Arena counted;
  cut_pressure_scratch(counted, most);
  return counted.doubles();
}

PressureResult solve_pressure(const PressureModel& model, const RailStrips& rail, const Overlaps& o,
                              const PressureOptions& given, double* workspace, PressureStart& start,
                              StartFrom from, const StripPressure& p) noexcept {
  Arena arena(workspace);
  PressureScratch w = cut_pressure_scratch(arena, o.capacity);
  StripSet& s = w.fine;
  const PressureProblem problem{model.kernels,
                                {model.influence.tables(), model.influence.mean_under.data()},
                                model.compliance,
                                model.lambda_length,
                                model.along_track};
  PressureResult result;
  // how far the last solution, or a marked one, may be moved to be a start
  const double farthest = model.along_track && start.change.depth ? farthest_along_track : farthest_followed;
  if (from == StartFrom::solution) extrapolate_start(rail, o, start);
  bool started = load_strips(rail, o, start, from, w);
  if (o.count == 0) {
    result.converged = true;
    store(o, w, start, p);
    return result;
  }
  const PressureOptions options = limited_by_overlaps(o, given);
  // From an earlier solution, if there is one that is near enough and leads to the end.
  if (started && from == StartFrom::solution) started = follow_overlaps(farthest, w);
  w.best.moved = any_change;
  if (started) {
    result = iterate(problem, s,
                     {options.tolerance, farthest_start, options.max_work, most_in_contact(options)}, w);
    started = result.converged || is_used_up(options, result, w);
    if (!result.converged && result.residual > 0.0) keep_best(s, options, result, w);
  }
  // Else from the overlaps, which is the only way of a call without a past.
  if (!started) {
    const std::int32_t spent = result.iterations;
    result = solve_from_overlaps(problem, o, options, w);
    result.iterations += spent;
  }
  result.work = w.work;
  store(o, w, start, p);
  return result;
}

}  // namespace wrc::surface
