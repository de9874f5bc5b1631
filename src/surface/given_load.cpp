#include "surface/given_load.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "base/golden_section.hpp"
#include "base/number.hpp"
#include "surface/wrench_at_height.hpp"

namespace wrc {
namespace {

constexpr double load_tolerance = 1e-8;  ///< prescribed loads are met to this part
constexpr std::int32_t most_load_steps = 30;

/// Search of the height for a load: between one that carries too little and one that carries too much, by
/// secants of the load's power 2/3, which is nearly straight.
class HeightSearch {
 public:
  explicit HeightSearch(double load) : target_(straightened(load)) {}

  /// Notes that `height` carries `load`.
  void take(double height, double load) {
    const double value = straightened(load) - target_;
    (value < 0.0 ? low_ : high_) = {height, value, true};
  }

  /// Nothing is left between the heights.
  bool exhausted() const { return low_.known && high_.known && std::abs(high_.height - low_.height) < 1e-16; }

  /// Where to look after `height` in the search's step `step`, counted from 0.
  double next(double height, std::int32_t step) const {
    if (!(low_.known && high_.known)) {
      // one side only: by the slope of a sphere, F ~ depth^(3/2), with twice the step
      const double depth_step = 20e-6 * static_cast<double>(1 << std::min(step, 12));
      return low_.known ? height + depth_step : height - depth_step;
    }
    const double low = low_.height, high = high_.height;
    const double inside = 1e-3 * (high - low);
    const double between =
        step % 6 == 5 ? 0.5 * (low + high) : low - low_.value * (high - low) / (high_.value - low_.value);
    return smaller(larger(between, smaller(low, high) + inside), larger(low, high) - inside);
  }

 private:
  struct End {
    double height = 0.0, value = 0.0;  ///< [m], of the straightened load less the target
    bool known = false;
  };

  static double straightened(double load) {
    return load > 0.0 ? natural_exp(natural_log(load) * (2.0 / 3.0)) : 0.0;
  }

  double target_;
  End low_, high_;
};

/// The wrench at the height that carries the load given, searched from `height`, which becomes it. `search`:
/// between what it knows.
Fault search_height(const SurfaceModel& model, const WheelOnRail& in, HeightSearch search, WheelWork& w,
                    SurfaceStart& start, double& height, Wrench& out) {
  const double asked = in.vertical_load;
  Fault fault;
  for (std::int32_t step = 0; step < most_load_steps; ++step) {
    const Fault here = solve_at(model, in, height, false, w, start, {}, out);
    const double load = -out.force[2];
    fault = here.status == WRC_FLAG_NO_CONTACT ? Fault{} : here;
    if (std::abs(load - asked) <= load_tolerance * asked) return fault;
    search.take(height, load);
    if (search.exhausted()) break;
    height = search.next(height, step);
  }
  keep_worst(fault,
             {.status = WRC_FLAG_ITERATION_CAP, .field = "input.vertical_load", .value = asked, .unit = "N"});
  return fault;
}

/// Could friction take more from the vertical force of a strip than its pressure gives it? Of the strips that
/// press at that height, and of those that would a fifth of a millimetre further. What the last solve left in
/// `w` but for overlaps and pressures stays, these are of `height` afterwards.
bool friction_outweighs_slope(const SurfaceModel& model, const WheelOnRail& in, double height, WheelWork& w) {
  constexpr double beyond = 0.2e-3, safe = 0.9;  // [m], share of what holds the balance
  const Seen seen = see(model, in, height);
  Overlaps& o = w.overlaps;
  find(model, in, seen, beyond, w);
  for (std::int32_t i = 0; i < o.count; ++i) {
    const double friction = in.law ? friction_at_rest(w.rail, *in.law, o.strip[i]) : in.friction;
    const double down = seen.cosine * o.nz[i] + seen.sine * o.ny[i];
    const double aside = seen.cosine * o.ny[i] - seen.sine * o.nz[i];
    if (friction * magnitude(aside) > safe * down) return true;
  }
  return false;
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

/// Looks at heights each twice as far below first touch as the one before, down to the deepest overlap that
/// is solved, or until many times the load presses.
WayDown look_down(const SurfaceModel& model, const WheelOnRail& in, WheelWork& w, SurfaceStart& start,
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
    solve_at(model, in, height, false, w, start, {}, out);
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
                      SurfaceStart& start, double& height, Wrench& out) {
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

Fault solve_given_load(const SurfaceModel& model, const WheelOnRail& in, WheelWork& w, SurfaceStart& start,
                       double& height, Wrench& out) {
  const double asked = in.vertical_load;
  const Fault found = search_height(model, in, HeightSearch(asked), w, start, height, out);
  if (!(in.friction > 0.0)) return found;
  const bool capped = found.status == WRC_FLAG_ITERATION_CAP;
  const double searched = out.height;
  if (!friction_outweighs_slope(model, in, capped ? first_touch(model, in, w) : searched, w)) {
    // overlaps are those of the solution again: derivatives are made of them
    find(model, in, w.seen, margin_of(model), w);
    return found;
  }

  const WayDown way = look_down(model, in, w, start, out);
  const auto climbing = [&](const char* cause, const Fault& beside) {
    Fault fault{.status = WRC_FLAG_CLIMBING,
                .field = "input.vertical_load",
                .value = asked,
                .unit = "N",
                .cause = cause};
    keep_worst(fault, beside);
    return fault;
  };
  const auto between = [&](double low, double load_at_low, double high, double load_at_high) {
    HeightSearch search(asked);
    search.take(low, load_at_low);
    search.take(high, load_at_high);
    height = !capped && searched > low && searched <= high ? searched : search.next(high, 0);
    return search_height(model, in, search, w, start, height, out);
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
