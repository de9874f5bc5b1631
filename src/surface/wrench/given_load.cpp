#include "surface/wrench/given_load.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "base/golden_section.hpp"
#include "base/number.hpp"
#include "surface/wrench/wrench_at_height.hpp"

namespace wrc {
namespace {

constexpr double load_tolerance = 1e-8;  ///< prescribed loads are met to this part
constexpr std::int32_t most_load_steps = 30;

/// In Hertz's contact in proportion to the approach.
double straightened(double load) { return load > 0.0 ? natural_exp(natural_log(load) * (2.0 / 3.0)) : 0.0; }

/// Search of the height for a load: by secants of the load's power 2/3, which is nearly straight, between a
/// height that carries too little and one that carries too much where both are known.
class HeightSearch {
 public:
  explicit HeightSearch(double load) : load_(load), target_(straightened(load)) {}

  /// Notes that `height` carries `load`, which is known to the part `doubt` of the one asked for.
  void take(double height, double load, double doubt) {
    const Place earlier = last_;
    last_ = {height, straightened(load) - target_, doubt};
    if (magnitude(load - load_) > doubt * load_) (last_.value < 0.0 ? low_ : high_) = last_;
    if (!earlier.known() || height == earlier.height) return;
    const double risen = last_.value - earlier.value, known_to = (doubt + earlier.doubt) * target_;
    const double secant = risen / (height - earlier.height);
    if (magnitude(risen) > known_to && secant > 0.0) slope_ = secant;
    slow_ = magnitude(last_.value) > 0.5 * magnitude(earlier.value) ? slow_ + 1 : 0;
  }

  /// Nothing is left between the heights.
  bool exhausted() const {
    return low_.known() && high_.known() && std::abs(high_.height - low_.height) < 1e-16;
  }

  /// Where to look after the last height, in the search's step `step`, counted from 0. `stiffness`: about how
  /// fast the load grows with the height, read where that was not seen yet [N/m]; 0: not known.
  double next(std::int32_t step, double stiffness) const {
    const double slope = slope_ > 0.0 ? slope_ : stiffness / (1.5 * root(target_));
    const double far = 60e-6 * static_cast<double>(1 << std::min(step, 10));
    const double asked_for = slope > 0.0 ? -last_.value / slope : last_.value < 0.0 ? far : -far;
    const double height = last_.height + smaller(larger(asked_for, -far), far);
    if (!(low_.known() && high_.known())) return height;
    const double low = smaller(low_.height, high_.height), high = larger(low_.height, high_.height);
    const bool slow = slow_ > 1 && magnitude(last_.value) > worth_halving * target_;
    return slow || !(height > low && height < high) ? 0.5 * (low + high) : height;
  }

 private:
  static constexpr double worth_halving = 1e-5;  ///< of the straightened load: slower than that is rounding

  struct Place {
    double height = 0.0, value = 0.0;  ///< [m], of the straightened load less the target
    double doubt = -1.0;
    bool known() const { return doubt >= 0.0; }
  };

  double load_, target_;
  double slope_ = 0.0;  ///< of the straightened load
  Place low_, high_;    ///< too little and too much beyond doubt
  Place last_;
  std::int32_t slow_ = 0;  ///< steps in a row that brought little
};

/// How far the wheel is below first touch, as the overlaps of the last solve have it [m].
double approach_of(const WheelWork& w) {
  const Overlaps& o = w.overlaps;
  double most = 0.0;
  for (std::int32_t i = 0; i < o.count; ++i) {
    const double down = w.seen.cosine * o.nz[i] + w.seen.sine * o.ny[i];
    if (down > 0.1) most = larger(most, o.depth[i] / down);
  }
  return most;
}

/// The strips' squared lengths at a height.
struct Lengths {
  double height = 0.0;
  std::int32_t count = 0;
  std::int32_t strip[most_overlapping_strips];
  double squared[most_overlapping_strips];
};

/// Moves the start of a solve at `height` to where the lengths of the last one, at `last`, lead: along the
/// line through those of the one before.
void lead_on(const Lengths& before, double last, double height, const WheelWork& w, PressureStart& start) {
  const Overlaps& o = w.overlaps;
  const double* const squared = w.pressure.length_squared;
  start.extrapolated = start.set && before.count > 0 && before.height != last;
  if (!start.extrapolated) return;
  const double share = smaller(larger((height - last) / (last - before.height), -1.0), 1.0);
  for (std::int32_t i = 0, b = 0; i < o.count; ++i) {
    const std::int32_t j = o.strip[i];
    while (b < before.count && before.strip[b] < j) ++b;
    if (b == before.count) break;
    if (before.strip[b] != j || !(squared[i] > 0.0) || !(before.squared[b] > 0.0)) continue;
    start.length_squared[j] = larger(squared[i] + share * (squared[i] - before.squared[b]), 0.5 * squared[i]);
  }
}

/// The wrench at the height that carries the load given, searched from `height`, which becomes it. `search`:
/// between what it knows. `found`: it is that height already, as far as is known.
///
/// Heights on the way are solved only so far as their loads are of use: those are known about as well as the
/// lengths of the strips are.
Fault search_height(const SurfaceModel& model, const WheelOnRail& in, HeightSearch search, bool found,
                    WheelWork& w, PressureStart& start, double& height, Wrench& out) {
  constexpr double coarse = 2e-3;  // where nothing is known yet
  const double asked = in.vertical_load;
  const PressureOptions exact;
  PressureOptions options;
  if (!found) options.tolerance = coarse;
  Lengths before;
  double miss_before = 0.5;
  Fault fault;
  for (std::int32_t step = 0; step < most_load_steps; ++step) {
    const Fault here = solve_at(model, in, height, false, w, start, options, out);
    const double load = -out.force[2], miss = smaller(magnitude(load - asked) / asked, 1.0);
    fault = here.status == WRC_FLAG_NO_CONTACT ? Fault{} : here;
    if (miss <= load_tolerance) {
      if (options.tolerance <= exact.tolerance) return fault;
      options = exact;
      continue;
    }
    search.take(height, load, options.tolerance);
    if (search.exhausted()) break;
    const double last = height, approach = approach_of(w);
    height = search.next(step, approach > 0.0 ? 1.5 * load / approach : 0.0);
    lead_on(before, last, height, w, start);
    before.height = last;
    before.count = w.overlaps.count;
    std::copy_n(w.overlaps.strip, before.count, before.strip);
    std::copy_n(w.pressure.length_squared, before.count, before.squared);
    // a secant leaves about this of the last two; and the one after that should be as good
    const double expected = 0.2 * miss * miss_before;
    options.tolerance = larger(smaller(0.2 * miss * expected, coarse), exact.tolerance);
    if (expected < load_tolerance) options = exact;
    miss_before = miss;
  }
  keep_worst(fault, Fault::iteration_cap("input.vertical_load", {asked, "N"}));
  return fault;
}

/// Could friction take more from the vertical force of a strip than its pressure gives it? Of the strips that
/// press at that height, and of those that would a fifth of a millimetre further. What the last solve left in
/// `w` stays, but for where rays end, which is of this height, and the scratch of rolling.
bool friction_outweighs_slope(const SurfaceModel& model, const WheelOnRail& in, double height, WheelWork& w) {
  constexpr double beyond = 0.2e-3, safe = 0.9;  // [m], share of what holds the balance
  const RelativeMotion seen = see(model, in, height);
  const Overlaps solved = w.overlaps;
  Overlaps& o = w.overlaps;
  double* at = w.rolling;
  for (double** a : {&o.depth, &o.centre, &o.curvature, &o.ny, &o.nz, &o.wy, &o.wz, &o.lean}) {
    if (*a) *a = at;
    at += o.capacity;
  }
  o.strip = reinterpret_cast<std::int32_t*>(at);
  find(model, in, seen, beyond, w);
  bool outweighs = false;
  for (std::int32_t i = 0; i < o.count && !outweighs; ++i) {
    const double friction = in.law ? friction_at_rest(model, in, w, o.strip[i]).value : in.friction;
    const double down = seen.cosine * o.nz[i] + seen.sine * o.ny[i];
    const double aside = seen.cosine * o.ny[i] - seen.sine * o.nz[i];
    outweighs = friction * magnitude(aside) > safe * down;
  }
  w.overlaps = solved;
  return outweighs;
}

/// What the vertical force does as a wheel is lowered from first touch on.
struct WayDown {
  static constexpr std::int32_t most = 13;
  std::int32_t count = 0;
  double height[most] = {}, load[most] = {};  ///< [m], [N]; the first is first touch
  std::int32_t reaches = 0;                   ///< the first that carries the load; 0: none
  std::int32_t summit = 0;                    ///< where it is largest before it falls
  bool falls = false;                         ///< before the load is reached: behind the summit
  bool falls_again = false;                   ///< below the load, after it was reached
};

/// Loads on the way down tell falls of 1e-3 of the load asked for.
constexpr double way_tolerance = 1e-4;

/// Looks at heights each twice as far below first touch as the one before, down to the deepest overlap that
/// is solved, or until many times the load presses.
WayDown look_down(const SurfaceModel& model, const WheelOnRail& in, WheelWork& w, PressureStart& start,
                  Wrench& out) {
  constexpr double first_step = 4e-6;  // [m]
  constexpr double counts = 1e-3;      // of the load: what a fall is told from rounding by
  constexpr double enough = 20.0;      // loads: where a wheel is wedged rather than carried
  const double asked = in.vertical_load;
  WayDown way;
  way.height[way.count++] = first_touch(model, in, w);
  const double touch = way.height[0];
  const double deepest = first_step * static_cast<double>(1 << (WayDown::most - 2));
  const double border = height_at_border(model, in, touch + deepest, w);
  std::int32_t highest = 0;
  double pressed = 0.0;  // [N]
  for (std::int32_t k = 1; k < WayDown::most && !way.falls_again; ++k) {
    const double height = smaller(touch + first_step * static_cast<double>(1 << (k - 1)), border);
    if (!(height > way.height[k - 1]) || pressed > enough * asked) break;
    PressureOptions options;
    options.tolerance = way_tolerance;
    solve_at(model, in, height, false, w, start, options, out);
    const double load = -out.force[2];
    pressed = out.normal_force;
    way.height[k] = height;
    way.load[k] = load;
    way.count = k + 1;
    if (way.reaches > 0) {
      way.falls_again = load < asked;
    } else if (load >= asked) {
      way.reaches = k;
    } else if (way.summit == 0 && load < way.load[highest] - counts * asked) {
      way.falls = true;
      way.summit = highest;
    }
    if (load > way.load[highest]) highest = k;
  }
  return way;
}

/// The wrench where the vertical force is largest between two heights.
Fault solve_at_summit(const SurfaceModel& model, const WheelOnRail& in, double low, double high, WheelWork& w,
                      PressureStart& start, double& height, Wrench& out) {
  constexpr int steps = 20;
  const auto load_at = [&](double at) {
    solve_at(model, in, at, false, w, start, {}, out);
    return -out.force[2];
  };
  narrow_to_largest(low, high, steps, load_at);
  height = 0.5 * (low + high);
  return solve_at(model, in, height, false, w, start, {}, out);
}

}  // namespace

double usual_approach(double load) { return 105e-6 * straightened(1e-5 * load); }

Fault solve_given_load(const SurfaceModel& model, const WheelOnRail& in, WheelWork& w, PressureStart& start,
                       double& height, Wrench& out) {
  const double asked = in.vertical_load;
  const Fault found = search_height(model, in, HeightSearch(asked), false, w, start, height, out);
  if (!(in.friction > 0.0)) return found;
  const bool capped = found.has(WRC_FLAG_ITERATION_CAP);
  const double searched = out.height;
  if (!friction_outweighs_slope(model, in, capped ? first_touch(model, in, w) : searched, w)) {
    if (capped) find(model, in, w.seen, margin_of(model), w);  // derivatives are made of where rays end
    return found;
  }

  const WayDown way = look_down(model, in, w, start, out);
  const auto climbing = [&](const char* cause, const Fault& beside) {
    Fault fault = Fault::climbing("input.vertical_load", {asked, "N"}, cause);
    keep_worst(fault, beside);
    return fault;
  };
  const auto between = [&](double low, double load_at_low, double high, double load_at_high) {
    HeightSearch search(asked);
    search.take(low, load_at_low, way_tolerance);
    search.take(high, load_at_high, way_tolerance);
    const bool known = !capped && searched > low && searched <= high;
    height = known ? searched : search.next(0, 0.0);
    return search_height(model, in, search, known, w, start, height, out);
  };
  if (way.summit > 0) {
    const std::int32_t k = way.summit;
    const Fault fault =
        solve_at_summit(model, in, way.height[k - 1], way.height[k + 1], w, start, height, out);
    const double most_carried = -out.force[2];
    if (most_carried >= asked)
      return climbing("the highest of the heights that do is returned",
                      between(way.height[k - 1], way.load[k - 1], height, most_carried));
    if (way.reaches == 0)
      return climbing("none does; returned is where the force first ceases to grow on the way down", fault);
  }
  if (way.reaches > 0) {
    const std::int32_t k = way.reaches;
    const Fault fault = between(way.height[k - 1], way.load[k - 1], way.height[k], way.load[k]);
    if (way.falls)
      return climbing("one does, but the force fell on the way down to it: it began on another branch",
                      fault);
    return way.falls_again ? climbing("the highest of the heights that do is returned", fault) : fault;
  }
  if (way.falls) {
    solve_at(model, in, height = way.height[0], false, w, start, {}, out);
    return climbing("none does; returned is first touch: from there on the force does not grow", {});
  }
  const Fault fault = solve_at(model, in, height = searched, false, w, start, {}, out);
  return found.status == WRC_OK ? fault : found;
}

}  // namespace wrc
