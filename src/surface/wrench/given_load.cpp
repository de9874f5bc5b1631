#include "surface/wrench/given_load.hpp"

#include <algorithm>
#include <cmath>

#include "base/golden_section.hpp"
#include "base/number.hpp"
#include "surface/wrench/first_touch.hpp"
#include "surface/wrench/height_search.hpp"
#include "surface/wrench/strip_friction.hpp"

namespace wrc::surface {
namespace {

/// Prescribed loads are met to this part: as well as loads are known, a tenth of the normal problem's
/// tolerance.
double load_tolerance(double tolerance) { return larger(0.1 * tolerance, 1e-8); }

constexpr std::int32_t most_load_steps = 30;

/// Has the call taken the work that the model allows?
bool exhausted(const HeightSolver& solver) {
  return solver.out.work >= solver.problem.model.pressure.max_work;
}

/// Approach of the overlaps of the last solve: their largest depth, vertically [m]. Negative where the wheel
/// is apart from strips that are near; `least` where there are none.
double approach_of(const WheelSolution& s, double least = 0.0) {
  const Overlaps& o = s.overlaps;
  constexpr double least_down = 0.1;
  double most = least;
  for (std::int32_t i = 0; i < o.count; ++i) {
    const double down = downwards(s.motion, o.ny[i], o.nz[i]);
    if (down > least_down) most = larger(most, o.depth[i] / down);
  }
  return most;
}

/// Load of overlaps as of hills, in proportion to V / sqrt(A), V the volume of a hill and A its outline's
/// area. Hertz's contact has that law.
class HillLoad {
 public:
  /// Adds the next strip: its place along the arc and its width [m], its overlap, and the downward share of
  /// its normal.
  void add(double place, double width, double depth, double curvature, double down) {
    constexpr double flattest = 0.05;  // [1/m]
    if (!(depth > 0.0) || place - last_ > 1.5 * width) close();
    last_ = place;
    if (!(depth > 0.0)) return;
    // half of the strip's outline, but for a factor of all
    const double area = width * root(depth / larger(curvature, flattest));
    area_ += area;
    volume_ += area * depth * down;
  }
  double load() {
    close();
    return load_;
  }

 private:
  void close() {
    if (area_ > 0.0) load_ += volume_ / root(area_);
    area_ = volume_ = 0.0;
  }

  double load_ = 0.0, area_ = 0.0, volume_ = 0.0, last_ = -1e300;
};

/// HillLoad of overlaps, with the wheel further down by `lowered` [m].
double hill_load(const WheelProblem& problem, const WheelSolution& s, double lowered) {
  const Overlaps& o = s.overlaps;
  HillLoad hills;
  for (std::int32_t i = 0; i < o.count; ++i) {
    const double down = downwards(s.motion, o.ny[i], o.nz[i]);
    hills.add(row_place(problem.rail, o.strip[i]), problem.rail.width[on_rail(o.strip[i])],
              o.depth[i] + down * lowered, o.curvature[i], down);
  }
  return hills.load();
}

/// Is the strip one of a face that is there? Other strips have no place or width.
bool is_there(const RailStrips& rail, std::int32_t strip) {
  for (std::int32_t r = 0; r < rail.ranges; ++r)
    if (rail.range[r].has(strip)) return true;
  return false;
}

/// HillLoad of an earlier solution, its overlaps as curved and as steep as those of `s`; 0 where it pressed a
/// face that is not there any more.
double earlier_hill_load(const WheelProblem& problem, const WheelSolution& s, const PressureStart& earlier) {
  const Overlaps& o = s.overlaps;
  const RailStrips& rail = problem.rail;
  HillLoad hills;
  std::int32_t i = 0;
  for (std::int32_t b = 0; b < earlier.count; ++b) {
    const auto strip = static_cast<std::int32_t>(earlier.strip[b]), j = on_rail(strip);
    if (!is_there(rail, j)) return 0.0;
    // strips that the wheel has left lie as the rail does
    while (i < o.count && o.strip[i] < strip) ++i;
    const bool shared = i < o.count && o.strip[i] == strip;
    const double down =
        shared ? downwards(s.motion, o.ny[i], o.nz[i]) : downwards(s.motion, -rail.tz[j], rail.ty[j]);
    hills.add(row_place(rail, strip), rail.width[j], earlier.depth[b],
              shared ? o.curvature[i] : 1.0 / problem.model.wheel_radius, down);
  }
  return hills.load();
}

/// HillLoad at which hills carry the load asked for: that of the earlier solution in proportion to its
/// `load`, where both are known, else by Hertz's contact of a sphere [N].
double asked_of_hills(const WheelProblem& problem, const WheelSolution& s, const PressureStart* earlier,
                      double load) {
  // F = 4/3 E* root(R) d^(3/2), the sphere's hill having 2^(3/4) 3/8 root(pi) root(R) d^(3/2)
  constexpr double per_hill = 1.192780;
  const double asked = problem.in.vertical_load,
               before = earlier ? earlier_hill_load(problem, s, *earlier) : 0.0;
  if (load > 0.0 && before > 0.0) return before * asked / load;
  const double modulus = 1.0 / (pi * pressure_model(problem.model).compliance);  // E* = G / (1 - nu) [Pa]
  return asked / (per_hill * modulus);
}

/// Height at which the hills of overlaps along the track carry the load asked for, from those of `s` at
/// `height` [m]: between light touch and twice the usual approach.
double height_by_hills(const WheelProblem& problem, const WheelSolution& s, double asked, double height) {
  // the straightened load is nearly straight: few secants find it
  constexpr int most_steps = 5;
  constexpr double close = 1e-9, farthest = 1e-3;  // [m]
  const double usual = usual_approach(problem.in.vertical_load), touch = -approach_of(s, -farthest);
  // secants of the straightened load, the first from the height of first touch
  const double target = straightened(asked);
  double last = touch, last_value = -target, change = last + usual;
  for (int n = 0; n < most_steps && magnitude(change - last) > close; ++n) {
    const double value = straightened(hill_load(problem, s, change)) - target;
    const double slope = (value - last_value) / (change - last);
    if (!(slope > 0.0)) break;
    last = change;
    last_value = value;
    change -= value / slope;
  }
  change = smaller(larger(change, -farthest), farthest);
  return height + smaller(larger(change, touch + 0.3 * usual), touch + 2.0 * usual);
}

/// Hertz's F = c d^(3/2) has dF/dd = 1.5 F / d, d the approach [N/m]; 0 where nothing overlaps.
double hertz_stiffness(const WheelSolution& s, double load) {
  const double approach = approach_of(s);
  return approach > 0.0 ? 1.5 * load / approach : 0.0;
}

/// The strips' squared lengths at a height.
struct Lengths {
  double height = 0.0;
  std::int32_t count = 0;
  std::int32_t strip[most_overlapping_strips];
  double squared[most_overlapping_strips];

  void keep(double at, const WheelSolution& s) {
    height = at;
    count = s.overlaps.count;
    std::copy_n(s.overlaps.strip, count, strip);
    std::copy_n(s.pressure.length_squared, count, squared);
  }
};

/// Predicts the squared lengths at `height` for the start of its solve: along the line through those at
/// `last`, of the solution, and those `before`.
void predict_lengths(const Lengths& before, double last, double height, const WheelSolution& s,
                     HeightStart& start) {
  const Overlaps& o = s.overlaps;
  const double* const squared = s.pressure.length_squared;
  if (start.from == StartFrom::overlaps || before.count == 0 || before.height == last) return;
  start.from = StartFrom::extrapolation;
  const double share = smaller(larger((height - last) / (last - before.height), -1.0), 1.0);
  for_shared_strips(o.count, o.strip, before.count, before.strip, [&](std::int32_t i, std::int32_t b) {
    // strips that were not in contact at both heights keep their lengths
    if (!(squared[i] > 0.0) || !(before.squared[b] > 0.0)) return;
    start.solution.length_squared[i] =
        larger(squared[i] + share * (squared[i] - before.squared[b]), 0.5 * squared[i]);
  });
}

/// The wrench at the height that carries the load given, searched from `height`, between those that `search`
/// knows. `found`: it is that height already, as far as is known.
///
/// Heights on the way are solved only so far as their loads are of use: those are known about as well as the
/// lengths of the strips are.
Fault search_height(const HeightSolver& solver, HeightSearch search, bool found, double height) {
  constexpr double coarse = 2e-3;  // where nothing is known yet
  const double asked = solver.problem.in.vertical_load;
  const double exact = solver.problem.model.pressure.tolerance;
  const double met = load_tolerance(exact);
  double tolerance = found ? exact : coarse;
  Lengths before;
  double miss_before = 0.5;
  Fault fault;
  for (std::int32_t step = 0; step < most_load_steps; ++step) {
    const Fault here = solve_at_height(solver, height, tolerance);
    const double load = -solver.out.force[2], miss = smaller(magnitude(load - asked) / asked, 1.0);
    fault = here.status == WRC_FLAG_NO_CONTACT ? Fault{} : here;
    // a load met at a coarse tolerance is solved once more at the same height
    if (miss <= met) {
      if (tolerance <= exact) return fault;
      tolerance = exact;
      continue;
    }
    search.take(height, load, tolerance);
    if (search.exhausted() || exhausted(solver)) break;

    // the stiffness by Hertz's theory, corrected by the part that earlier searches found
    const double last = height, hertz = hertz_stiffness(solver.solution, load);
    height = search.next(step, solver.start.stiffness * hertz);
    if (const double part = search.part_of(hertz); part > 0.0) solver.start.stiffness = part;
    predict_lengths(before, last, height, solver.solution, solver.start);
    before.keep(last, solver.solution);

    // a secant leaves about this of the last two misses; the load is known to a fifth of its residual, and a
    // finer tolerance than that does not improve the next secant
    const double expected = 0.2 * miss * miss_before, known = 0.2 * solver.out.residual;
    tolerance = larger(smaller(larger(0.2 * miss * expected, known), coarse), exact);
    if (expected < met) tolerance = exact;
    miss_before = miss;
  }
  keep_worst(fault, Fault::iteration_cap("input.vertical_load", {asked, "N"}));
  return fault;
}

/// Is a face that changes along the track far from holding the wheel by friction, as its strips' rays know?
/// `margin`: of the strips looked at [m].
bool candidates_are_flat(const WheelProblem& problem, const RelativeMotion& motion, double margin) {
  constexpr double far = 0.6;  // share of the balance: normals differ by less from those of the contact
  const CandidatesAlong& c = problem.rail.candidates;
  const VaryingRail& varying = problem.model.varying;
  for (std::int32_t r = 0; r < problem.rail.ranges; ++r)
    if (!varying.face[face_of(varying, problem.rail.range[r].first)].changes) return false;
  if (problem.in.law || !candidates_hold(c, motion.pose, margin)) return false;
  bool flat = true;
  for (std::int32_t k = 0; k < c.count && flat; ++k) {
    const double ny = c.top[k].ny, nz = c.top[k].nz, aside = motion.cosine * ny - motion.sine * nz;
    flat = problem.in.friction * magnitude(aside) < far * downwards(motion, ny, nz);
  }
  return flat;
}

/// Can friction exceed the vertical share of the normal force on any strip that presses at that height, or
/// would a fifth of a millimetre further?
bool friction_outweighs_slope(const WheelProblem& problem, double height, Arena scratch) {
  constexpr double beyond = 0.2e-3, safe = 0.9;  // [m], share of the balance
  const RelativeMotion motion = motion_at_height(problem.model, problem.in, height);
  if (changes(problem.model.varying) && candidates_are_flat(problem, motion, beyond)) return false;
  WheelOverlaps o = cut_wheel_overlaps(scratch, work_sizes(problem.model));
  find_wheel_overlaps(problem, motion, beyond, o);
  bool outweighs = false;
  for (std::int32_t i = 0; i < o.count && !outweighs; ++i) {
    const double friction = problem.in.law ? friction_at_rest(problem, o, i).value : problem.in.friction;
    // vertical: N (down - mu aside) at the worst direction of friction
    const double down = downwards(motion, o.ny[i], o.nz[i]);
    const double aside = motion.cosine * o.ny[i] - motion.sine * o.nz[i];
    outweighs = friction * magnitude(aside) > safe * down;
  }
  return outweighs;
}

/// Samples of the vertical force as a wheel is lowered from first touch on.
struct Descent {
  static constexpr std::int32_t most = 13;
  std::int32_t count = 0;
  double height[most] = {}, load[most] = {};  ///< [m], [N]; the first is first touch
  std::int32_t reaches = 0;                   ///< the first that carries the load; 0: none
  std::int32_t summit = 0;                    ///< where it is largest before it falls; 0: it does not fall
  bool falls = false;                         ///< before the load is reached: behind the summit
  bool falls_again = false;                   ///< below the load, after it was reached
};

/// Tolerance of the samples, which tell falls of 1e-3 of the load asked for.
constexpr double descent_tolerance = 1e-4;

/// Samples heights each twice as far below first touch as the one before, down to the deepest overlap that
/// is solved, or until many times the load presses.
Descent sample_descent(const HeightSolver& solver) {
  constexpr double first_step = 4e-6;  // [m]
  constexpr double counts = 1e-3;      // part of the load: smaller falls are rounding
  constexpr double enough = 20.0;      // loads: where a wheel is wedged rather than carried
  // heights double their distance from first touch, so that both stiff and soft faces get several
  const WheelProblem& problem = solver.problem;
  const double asked = problem.in.vertical_load;
  const auto step_of = [](std::int32_t k) { return first_step * static_cast<double>(1 << (k - 1)); };
  Descent d;
  const double touch = first_touch(problem, solver.scratch);
  d.height[d.count++] = touch;
  const double border = height_at_border(problem, touch + step_of(Descent::most - 1), solver.solution.motion,
                                         solver.solution.overlaps);
  std::int32_t highest = 0;
  double pressed = 0.0;  // [N]
  for (std::int32_t k = 1; k < Descent::most && !d.falls_again && !exhausted(solver); ++k) {
    const double height = smaller(touch + step_of(k), border);
    if (!(height > d.height[k - 1]) || pressed > enough * asked) break;
    solve_at_height(solver, height, descent_tolerance);
    const double load = -solver.out.force[2];
    pressed = solver.out.normal_force;
    d.height[k] = height;
    d.load[k] = load;
    d.count = k + 1;

    // before the load is reached: reached, or a first fall; after: a fall below it
    if (d.reaches > 0) {
      d.falls_again = load < asked;
    } else if (load >= asked) {
      d.reaches = k;
    } else if (d.summit == 0 && load < d.load[highest] - counts * asked) {
      d.falls = true;
      d.summit = highest;
    }
    if (load > d.load[highest]) highest = k;
  }
  return d;
}

/// The wrench where the vertical force is largest between two heights.
Fault solve_at_summit(const HeightSolver& solver, double low, double high) {
  constexpr int steps = 20;
  const double tolerance = solver.problem.model.pressure.tolerance;
  const auto load_at = [&](double at) {
    solve_at_height(solver, at, tolerance);
    return -solver.out.force[2];
  };
  narrow_to_largest(low, high, steps, load_at);
  return solve_at_height(solver, 0.5 * (low + high), tolerance);
}

Fault climbing(double load, const char* cause, const Fault& beside) {
  Fault fault = Fault::climbing("input.vertical_load", {load, "N"}, cause);
  keep_worst(fault, beside);
  return fault;
}

/// The wrench on the branch that begins at first touch, by samples of the descent. `searched`: a height that
/// carries the load, found by a search that knew nothing of branches; `found`: its fault.
Fault solve_on_first_branch(const HeightSolver& solver, const Descent& d, double searched,
                            const Fault& found) {
  const double asked = solver.problem.in.vertical_load;
  const double exact = solver.problem.model.pressure.tolerance;
  const bool capped = found.has(WRC_FLAG_ITERATION_CAP);
  // the height that carries the load between two that carry less and more: the one searched, where it lies
  // there
  const auto between = [&](double low, double load_at_low, double high, double load_at_high) {
    HeightSearch search(asked);
    search.take(low, load_at_low, descent_tolerance);
    search.take(high, load_at_high, descent_tolerance);
    const bool known = !capped && searched > low && searched <= high;
    return search_height(solver, search, known, known ? searched : search.next(0, 0.0));
  };

  // a summit between samples may carry the load that none of them does
  if (d.summit > 0) {
    const std::int32_t k = d.summit;
    const Fault fault = solve_at_summit(solver, d.height[k - 1], d.height[k + 1]);
    const double height = solver.out.height, most_carried = -solver.out.force[2];
    if (most_carried >= asked)
      return climbing(asked, "the highest of the heights that do is returned",
                      between(d.height[k - 1], d.load[k - 1], height, most_carried));
    if (d.reaches == 0)
      return climbing(asked, "none does; returned is where the force first ceases to grow on the way down",
                      fault);
  }
  if (d.reaches > 0) {
    const std::int32_t k = d.reaches;
    const Fault fault = between(d.height[k - 1], d.load[k - 1], d.height[k], d.load[k]);
    if (d.falls)
      return climbing(asked, "one does, but the force fell on the way down to it: it began on another branch",
                      fault);
    return d.falls_again ? climbing(asked, "the highest of the heights that do is returned", fault) : fault;
  }
  if (d.falls) {
    solve_at_height(solver, d.height[0], exact);
    return climbing(asked, "none does; returned is first touch: from there on the force does not grow", {});
  }
  const Fault fault = solve_at_height(solver, searched, exact);
  return found.status == WRC_OK ? fault : found;
}

}  // namespace

double first_height(const HeightSolver& solver) {
  const WheelProblem& problem = solver.problem;
  const double usual = usual_approach(problem.in.vertical_load);
  if (!changes(problem.model.varying)) return first_touch(problem, solver.scratch) + usual;
  WheelSolution& s = solver.solution;
  const double height = tops_below_touch(problem, usual, s.motion, s.overlaps);
  return height_by_hills(problem, s, asked_of_hills(problem, s, nullptr, 0.0), height);
}

double predicted_height(const HeightSolver& solver, double height, double load) {
  const WheelProblem& problem = solver.problem;
  const PressureStart& earlier = solver.start.solution;
  WheelSolution& s = solver.solution;
  s.motion = motion_at_height(problem.model, problem.in, height);
  // a rail that changes may have fallen away from the wheel, or risen into it
  if (changes(problem.model.varying)) {
    find_wheel_overlaps(problem, s.motion, tops_apart, s.overlaps, true);
    // where other strips touch now, the height is as without an earlier solution
    if (s.overlaps.count == 0) return first_height(solver);
    return height_by_hills(problem, s, asked_of_hills(problem, s, &earlier, load), height);
  }
  constexpr double farthest = 0.1e-3;  // [m]
  find_wheel_overlaps(problem, s.motion, 0.0, s.overlaps);
  // Strips as springs of stiffness w L along their directions: the height at which they carry the same load.
  const Overlaps& o = s.overlaps;
  double grown = 0.0, stiffness = 0.0;
  for_shared_strips(o.count, o.strip, earlier.count, earlier.strip, [&](std::int32_t i, std::int32_t b) {
    const double down = downwards(s.motion, o.ny[i], o.nz[i]);
    const double spring =
        problem.rail.width[on_rail(o.strip[i])] * larger(earlier.length_squared[b], 0.0) * down;
    grown += spring * (o.depth[i] - earlier.depth[b]);
    stiffness += spring * down;
  });
  double change = stiffness > 0.0 ? -grown / stiffness : 0.0;
  // And the change of the load, straightened as the search has it.
  const double asked = straightened(problem.in.vertical_load);
  const double slope = solver.start.stiffness * hertz_stiffness(s, load) / (1.5 * root(asked));
  if (slope > 0.0) change += (asked - straightened(load)) / slope;
  return height + smaller(larger(change, -farthest), farthest);
}

double usual_approach(double load) { return 105e-6 * straightened(1e-5 * load); }

Fault solve_given_load(const HeightSolver& solver, double guess) {
  const WheelProblem& problem = solver.problem;
  const Fault found = search_height(solver, HeightSearch(problem.in.vertical_load), false, guess);
  if (!(problem.in.friction > 0.0) || exhausted(solver)) return found;

  // One branch alone, unless friction can hold the wheel up against a face: without a height to judge that
  // at, at first touch.
  const double searched = solver.out.height;
  const double judged = found.has(WRC_FLAG_ITERATION_CAP) ? first_touch(problem, solver.scratch) : searched;
  if (!friction_outweighs_slope(problem, judged, solver.scratch)) return found;
  return solve_on_first_branch(solver, sample_descent(solver), searched, found);
}

}  // namespace wrc::surface
