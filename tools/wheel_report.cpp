/// wheel_report - how wrc_contact_wrench() fares on random poses, and what a call takes.
///
///     wheel_report poses [COUNT [SEED]]   statuses, iterations and numbers that are not finite
///     wheel_report lines                  forces over the height, and over yaw at the flange, in steps of 10 nm and 1 urad;
///                                         flanges at random poses
///     wheel_report branches Y YAW LOW HIGH
///                                         forces over the height between two vertical loads [mm, mrad, kN]: cold, from the last
///                                         solution downwards and upwards, and exact; for tools/draw_branches.py
///     wheel_report loads [COUNT [SEED]]   vertical loads given: what calls take of those at the height found
///     wheel_report times [STEPS]          from marked solutions and cold: one wheel, and eight of one model in a batch; at each
///                                         resolution. The last line is a JSON object
///     wheel_report layers [STEPS]         times with each layer of WRC_FRICTION_LIST over those without, call by call in turn; at each
///                                         resolution
///
/// `--setting NAME` in front of all: a resolution of WRC_RESOLUTION_LIST, for all but times and layers.
///
/// Poses: five pairs of new and worn profiles, both sides, lateral +-15 mm, roll and yaw +-40 mrad, heights
/// from lifted to 150 kN, ten to a pose; creepages up to full slip; half of them from the last solution,
/// which is then that of another pose. The sum at the end is of all forces: equal on every machine.
///
/// Times are of this machine in this minute, of the processor: compare those of one run. S1002 on the
/// benchmark UIC60 in steps of 1 ms: a wheelset that runs nearly straight (1 mm over 9 m, 20 m/s, 80 kN), and
/// one that weaves by 6 mm at 40 m/s under a load that changes. Strips are those in contact: calls take by
/// their square.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "csv.hpp"
#include "realtime/proof/processor_time.hpp"
#include "test_config.hpp"
#include "wheel_cases.hpp"
#include "wrc/wrc_offline.h"

namespace {

using namespace compare;

constexpr struct {
  const char *wheel, *rail;
} pairs_of_profiles[] = {{"s1002_benchmark", "uic60_benchmark"},
                         {"wheel_hollow15", "uic60_benchmark"},
                         {"wheel_flange30", "rail_conform"},
                         {"wheel_flange20_hollow10", "rail_flat"},
                         {"s1002_benchmark", "rail_sideworn"}};

/// The number at a share of the way through the sorted ones.
double at_share(std::vector<double> all, double share) {
  if (all.empty()) return 0.0;
  const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(all.size() - 1));
  std::nth_element(all.begin(), all.begin() + k, all.end());
  return all[static_cast<std::size_t>(k)];
}

class Random {
 public:
  explicit Random(unsigned long seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  bool one_in(int n) { return engine_() % static_cast<unsigned>(n) == 0; }
  std::size_t below(std::size_t n) { return engine_() % n; }

 private:
  std::mt19937_64 engine_;
};

/// Height at which a load is carried without friction, or 0 where there is none.
double height_for(wrc_contact* contact, wrc_wheel_input input, double load) {
  wrc_wrench wrench = sized<wrc_wrench>();
  input.friction.coefficient = 0.0;
  input.damping = 0.0;
  input.wheel.z = 0.0;
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = load;
  return wrc_contact_wrench(contact, &input, &wrench) < 0 ? 0.0 : wrench.z;
}

bool finite(const wrc_wrench& wrench) {
  double sum = wrench.z + wrench.normal_force + wrench.area + wrench.peak_pressure + wrench.power;
  for (int i = 0; i < 3; ++i) sum += wrench.force[i] + wrench.moment[i] + wrench.rail_moment[i];
  return std::isfinite(sum);
}

/// Time of the processor [us].
double microseconds_of(auto&& work) {
  const double begin = processor_time();
  work();
  return processor_time() - begin;
}

/// Strips in contact of the last solution.
double strips_in_contact(wrc_contact* contact, const wrc_wrench& wrench) {
  double strips = 0.0;
  for (int32_t i = 0; i < wrench.region_count; ++i) {
    wrc_region region = sized<wrc_region>();
    wrc_contact_region(contact, i, &region);
    strips += region.strip_count;
  }
  return strips;
}

/// Ten heights at one random pose, drawn from the group's own numbers: a group is repeated by itself.
class PoseGroup {
 public:
  static constexpr long heights = 10;

  PoseGroup(Pairs& pairs, unsigned long seed, long group)
      : random_(seed + (static_cast<unsigned long>(group) << 20)) {
    PairOptions options;
    const auto& profiles = pairs_of_profiles[random_.below(std::size(pairs_of_profiles))];
    options.wheel = profiles.wheel;
    options.rail = profiles.rail;
    options.side = random_.one_in(2) ? WRC_SIDE_LEFT : WRC_SIDE_RIGHT;
    contact_ = pairs.of(options).contact();
    input_.wheel.y = random_.between(-15e-3, 15e-3);
    input_.wheel.roll = random_.between(-40e-3, 40e-3);
    input_.wheel.yaw = random_.between(-40e-3, 40e-3);
    deepest_ = height_for(contact_, input_, 150e3);
    overloaded_ = group % 10 == 9;
  }

  wrc_contact* contact() const { return contact_; }
  bool carries() const { return deepest_ != 0.0; }

  /// The input of the k-th call, called in order: the first is cold, half of the others from the one before.
  const wrc_wheel_input& next(long k) {
    const double speed = random_.between(1.0, 100.0), slip = std::pow(10.0, random_.between(-4.0, -2.0));
    input_.wheel.z = deepest_ + (overloaded_ ? random_.between(0.0, 1.5e-3) : random_.between(-0.6e-3, 0.0));
    input_.wheel.velocity[0] = speed;
    input_.wheel.velocity[1] = random_.between(-slip, slip) * speed;
    input_.wheel.angular_axes = WRC_AXES_TRACK;
    input_.wheel.angular_velocity[1] = -speed / 0.46 * (1.0 + random_.between(-slip, slip));
    input_.friction.coefficient = random_.between(0.1, 0.6);
    const bool warm = random_.one_in(2);
    input_.start = k > 0 && warm ? WRC_START_WARM : WRC_START_COLD;
    return input_;
  }

 private:
  Random random_;
  wrc_contact* contact_ = nullptr;
  wrc_wheel_input input_ = wrc_wheel_input_default();
  double deepest_ = 0.0;     ///< height that carries 150 kN [m]
  bool overloaded_ = false;  ///< heights are below that
};

/// Calls of one class of poses: by normal force and start.
struct PoseClass {
  std::vector<double> iterations, work, time;
  long capped = 0, slowest = 0;  ///< number flagged; group of the most work

  void take(const wrc_wrench& wrench, double took, bool cap, long group) {
    if (work.empty() || wrench.work > most_) {
      most_ = wrench.work;
      slowest = group;
    }
    iterations.push_back(wrench.iterations);
    work.push_back(wrench.work);
    time.push_back(took);
    capped += cap ? 1 : 0;
  }

 private:
  double most_ = 0.0;
};

/// Work of calls by the number of strips in contact, within a fifth, and start: the classes that the most
/// work is compared in.
using WorkByStrips = std::map<std::pair<int32_t, long>, std::vector<double>>;

/// Says by how much the most work exceeds the median of its class, and how many calls exceed it four times.
void print_most_work(const WorkByStrips& classes) {
  constexpr std::size_t enough = 200;  ///< calls of a class
  double worst = 0.0;
  long beyond = 0, calls = 0, strips = 0;
  for (const auto& [key, work] : classes) {
    if (work.size() < enough) continue;
    const double median = at_share(work, 0.5), most = at_share(work, 1.0) / median;
    calls += static_cast<long>(work.size());
    beyond += std::count_if(work.begin(), work.end(), [&](double each) { return each > 4.0 * median; });
    if (most <= worst) continue;
    worst = most;
    strips = std::lround(std::pow(1.2, key.second));
  }
  std::printf(
      "by strips in contact: most work %.1f of the median of its class (%ld strips); %ld of %ld calls beyond "
      "4\n",
      worst, strips, beyond, calls);
}

constexpr double class_borders[] = {5e3, 20e3, 50e3, 150e3, 1e6};  // normal force [N]
constexpr std::size_t load_classes = std::size(class_borders) + 1;

/// Says what a capped call was.
void print_call(const char* what, long group, long k, const wrc_wheel_input& input,
                const wrc_wrench& wrench) {
  std::printf(
      "  %s: group %ld, call %ld, %s: y %.3f mm, roll %.2f, yaw %.2f mrad, %.1f kN, %d iterations, work "
      "%.0f, residual %.1e\n",
      what, group, k, input.start == WRC_START_COLD ? "cold" : "from the one before", 1e3 * input.wheel.y,
      1e3 * input.wheel.roll, 1e3 * input.wheel.yaw, 1e-3 * wrench.normal_force, wrench.iterations,
      wrench.work, wrench.residual);
}

/// The least normal force of those that press more strips than a number.
struct PressedBy {
  double strips;
  double load = 1e9;  ///< [N]
};

int poses(Pairs& pairs, long count, unsigned seed, long only) {
  std::map<std::string, long> statuses;
  PoseClass classes[2][load_classes];
  WorkByStrips by_strips;
  PressedBy pressed_by[] = {{56.0}, {76.0}};  // room of the derivatives at "real time" and at the default
  long in_contact = 0, not_finite = 0, without_height = 0, most_regions = 0, calls = 0;
  double sum = 0.0;
  const long first = only < 0 ? 0 : only, last = only < 0 ? count / PoseGroup::heights : only + 1;
  for (long group = first; group < last; ++group) {
    PoseGroup poses(pairs, seed, group);
    if (!poses.carries()) {
      ++without_height;
      continue;
    }
    for (long k = 0; k < PoseGroup::heights; ++k, ++calls) {
      const wrc_wheel_input& input = poses.next(k);
      wrc_wrench wrench = sized<wrc_wrench>();
      int32_t status = 0;
      const double took =
          microseconds_of([&] { status = wrc_contact_wrench(poses.contact(), &input, &wrench); });
      ++statuses[wrc_status_name(status)];
      const bool capped = status == WRC_FLAG_ITERATION_CAP;
      if (capped || only >= 0) print_call(capped ? "capped" : "call", group, k, input, wrench);
      not_finite += finite(wrench) ? 0 : 1;
      most_regions = std::max<long>(most_regions, wrench.region_count);
      sum += wrench.force[0] + wrench.force[1] + wrench.force[2];
      if (!(wrench.normal_force > 0.0)) continue;
      ++in_contact;
      const auto load =
          std::lower_bound(std::begin(class_borders), std::end(class_borders), wrench.normal_force) -
          std::begin(class_borders);
      classes[input.start == WRC_START_COLD ? 0 : 1][load].take(wrench, took, capped, group);
      const double strips = strips_in_contact(poses.contact(), wrench);
      by_strips[{input.start, std::lround(std::log(strips) / std::log(1.2))}].push_back(wrench.work);
      for (PressedBy& each : pressed_by)
        if (strips > each.strips) each.load = std::min(each.load, wrench.normal_force);
    }
    if (group % 1000 == 0) std::fprintf(stderr, "\r%ld of %ld", group, last);
  }
  std::fprintf(stderr, "\r%40s\r", "");
  std::printf(
      "%ld calls, %ld in contact, %ld not finite, at most %ld regions; %ld poses carry 150 kN nowhere\n",
      calls, in_contact, not_finite, most_regions, without_height);
  for (const auto& [name, times] : statuses) std::printf("  %-28s %ld\n", name.c_str(), times);
  for (const PressedBy& each : pressed_by)
    std::printf("  more than %.0f strips are pressed by %.0f kN at least\n", each.strips, 1e-3 * each.load);
  for (const int warm : {0, 1})
    for (std::size_t load = 0; load < load_classes; ++load) {
      const PoseClass& c = classes[warm][load];
      if (c.work.empty()) continue;
      const double median = at_share(c.work, 0.5), most = at_share(c.work, 1.0);
      std::printf(
          "%-10s %s %6.0f kN: %7zu calls, %ld capped; iterations 50 %% %g  99.9 %% %g  most %g; work 50 %% "
          "%.0f  99.9 %% %.1f  "
          "most %.1f of it (group %ld); 50 %% %.1f us  99.9 %% %.1f of it\n",
          warm ? "from last" : "cold", load < std::size(class_borders) ? "to" : "above",
          1e-3 * class_borders[std::min(load, std::size(class_borders) - 1)], c.work.size(), c.capped,
          at_share(c.iterations, 0.5), at_share(c.iterations, 0.999), at_share(c.iterations, 1.0), median,
          at_share(c.work, 0.999) / median, most / median, c.slowest, at_share(c.time, 0.5),
          at_share(c.time, 0.999) / at_share(c.time, 0.5));
    }
  print_most_work(by_strips);
  std::printf("sum of forces %.9e N\n", sum);
  return not_finite == 0 && statuses.count(wrc_status_name(WRC_FLAG_ITERATION_CAP)) == 0 ? 0 : 1;
}

/// Iterations and times of a way to call.
struct Taken {
  std::vector<double> iterations, work, time;
  int32_t take(wrc_contact* contact, const wrc_wheel_input& input, wrc_wrench& wrench) {
    int32_t status = 0;
    const double took = microseconds_of([&] { status = wrc_contact_wrench(contact, &input, &wrench); });
    time.push_back(took);
    iterations.push_back(wrench.iterations);
    work.push_back(wrench.work);
    return status;
  }

  /// Ratios of the work of its calls to that of the others'.
  std::vector<double> work_over(const Taken& others) const {
    std::vector<double> ratio(work.size());
    std::transform(work.begin(), work.end(), others.work.begin(), ratio.begin(), std::divides<>());
    return ratio;
  }
};

/// Random poses with a load given, 20 to 120 kN, and 1 ms later: y, yaw and load a little different. Beside
/// them the same poses at the height found.
int loads(Pairs& pairs, long count, unsigned seed) {
  Random random(seed);
  enum { load_anew, height_anew, load_later, height_later, ways };
  constexpr const char* names[ways] = {"load, cold", "height, cold", "load, 1 ms later",
                                       "height, 1 ms later"};
  Taken taken[ways];
  std::map<std::string, long> statuses;
  double off = 0.0;
  for (long done = 0; done < count; ++done) {
    PairOptions options;
    const auto& profiles = pairs_of_profiles[random.below(std::size(pairs_of_profiles))];
    options.wheel = profiles.wheel;
    options.rail = profiles.rail;
    wrc_contact* const contact = pairs.of(options).contact();
    wrc_wheel_input input = wrc_wheel_input_default();
    input.wheel.y = random.between(-8e-3, 8e-3);
    input.wheel.roll = random.between(-10e-3, 10e-3);
    input.wheel.yaw = random.between(-15e-3, 15e-3);
    const double speed = random.between(5.0, 60.0), slip = std::pow(10.0, random.between(-4.0, -2.0));
    input.wheel.velocity[0] = speed;
    input.wheel.velocity[1] = random.between(-slip, slip) * speed;
    input.wheel.angular_axes = WRC_AXES_TRACK;
    input.wheel.angular_velocity[1] = -speed / 0.46 * (1.0 + random.between(-slip, slip));
    input.friction.coefficient = random.between(0.1, 0.5);
    input.vertical_load = random.between(20e3, 120e3);
    const auto call = [&](int way, int32_t prescribed, int32_t start, double height) {
      wrc_wrench wrench = sized<wrc_wrench>();
      const double load = input.vertical_load;
      input.prescribed = prescribed;
      input.start = start;
      input.wheel.z = height;
      if (prescribed == WRC_PRESCRIBE_HEIGHT) input.vertical_load = 0.0;
      const int32_t status = taken[way].take(contact, input, wrench);
      if (prescribed == WRC_PRESCRIBE_VERTICAL_LOAD) ++statuses[wrc_status_name(status)];
      if (prescribed == WRC_PRESCRIBE_VERTICAL_LOAD && status == WRC_OK)
        off = std::max(off, std::fabs(-wrench.force[2] / load - 1.0));
      input.vertical_load = load;
      return wrench.z;
    };
    const wrc_wheel_input first = input;
    const double height = call(load_anew, WRC_PRESCRIBE_VERTICAL_LOAD, WRC_START_COLD, 0.0);
    call(height_anew, WRC_PRESCRIBE_HEIGHT, WRC_START_COLD, height);
    input.wheel.y += random.between(-20e-6, 20e-6);
    input.wheel.yaw += random.between(-50e-6, 50e-6);
    input.wheel.velocity[1] += random.between(-1e-2, 1e-2) * slip * speed;
    input.vertical_load *= 1.0 + random.between(-0.02, 0.02);
    const wrc_wheel_input second = input;
    const double later = call(load_later, WRC_PRESCRIBE_VERTICAL_LOAD, WRC_START_WARM, 0.0);
    input = first;
    wrc_wrench wrench = sized<wrc_wrench>();
    input.vertical_load = 0.0;
    input.wheel.z = height;
    wrc_contact_wrench(contact, &input, &wrench);
    input = second;
    call(height_later, WRC_PRESCRIBE_HEIGHT, WRC_START_WARM, later);
  }
  for (const auto& [name, times] : statuses) std::printf("  %-28s %ld\n", name.c_str(), times);
  for (int way = 0; way < ways; ++way)
    std::printf("%-20s iterations 50 %% %g  99 %% %g  most %g   50 %% %.1f us  99 %% %.1f us\n", names[way],
                at_share(taken[way].iterations, 0.5), at_share(taken[way].iterations, 0.99),
                at_share(taken[way].iterations, 1.0), at_share(taken[way].time, 0.5),
                at_share(taken[way].time, 0.99));
  for (const auto& [load, height] :
       {std::pair{load_anew, height_anew}, std::pair{load_later, height_later}}) {
    const std::vector<double> ratio = taken[load].work_over(taken[height]);
    std::printf("work of %s, over that of its height: 50 %% %.2f  75 %% %.2f  95 %% %.1f\n", names[load],
                at_share(ratio, 0.5), at_share(ratio, 0.75), at_share(ratio, 0.95));
  }
  std::printf("loads met to %.1e\n", off);
  return statuses.count(wrc_status_name(WRC_FLAG_ITERATION_CAP)) == 0 ? 0 : 1;
}

/// What a scan of poses saw.
struct Line {
  long steps = 0, flagged = 0, falls = 0;
  double jump = 0.0;  ///< largest half second difference of a force over the larger of normal force and 20 kN
  double fall = 0.0;  ///< largest fall of the vertical force from one step to the next [N]
  double force[3][3] = {};  ///< of the last three steps

  void take(int32_t status, const wrc_wrench& wrench) {
    for (int i = 0; i < 3; ++i) {
      double* const f = force[i];
      f[0] = f[1], f[1] = f[2], f[2] = wrench.force[i];
      if (steps >= 2)
        jump = std::max(
            jump, std::fabs(f[0] - 2.0 * f[1] + f[2]) / 2.0 / std::max(wrench.normal_force, least_force));
    }
    const double before = load;
    load = -wrench.force[2];
    if (steps > 0 && load < before) {
      ++falls;
      fall = std::max(fall, before - load);
    }
    flagged += status == WRC_OK || status == WRC_FLAG_NO_CONTACT ? 0 : 1;
    ++steps;
  }
  double load = 0.0;  ///< vertical force [N]
};

/// Heights in 10 nm from just above first touch to 150 kN, and yaw in 1 urad under a flange contact.
int lines(Pairs& pairs) {
  PairOptions options;
  options.wheel = pairs_of_profiles[0].wheel;
  options.rail = pairs_of_profiles[0].rail;
  wrc_contact* const contact = pairs.of(options).contact();
  wrc_wrench wrench = sized<wrc_wrench>();
  wrc_wheel_input input = wrc_wheel_input_default();
  input.friction.coefficient = 0.0;
  struct {
    double y, yaw;
  } constexpr poses[] = {{0.0, 0.0},    {2e-3, 3e-3},    {-5e-3, 0.0},    {5.02e-3, 0.0}, {5.5e-3, 5e-3},
                         {6.6e-3, 0.0}, {6.6e-3, 15e-3}, {6.6e-3, 17e-3}, {6.6e-3, 19e-3}};
  long spoilt = 0;
  for (const auto& pose : poses) {
    input.wheel.y = pose.y;
    input.wheel.yaw = pose.yaw;
    const double touch = height_for(contact, input, 100.0), deepest = height_for(contact, input, 150e3);
    Line line;
    for (long n = 0; n < std::lround((deepest - touch + 5e-6) / 10e-9); ++n) {
      input.wheel.z = touch - 5e-6 + 10e-9 * static_cast<double>(n);
      line.take(wrc_contact_wrench(contact, &input, &wrench), wrench);
    }
    std::printf(
        "y %5.2f mm, yaw %4.1f mrad: %6ld heights, %ld falls of the vertical force (largest %.1e N), jump "
        "%.1e, %ld flagged\n",
        1e3 * pose.y, 1e3 * pose.yaw, line.steps, line.falls, line.fall, line.jump, line.flagged);
    spoilt += line.flagged + line.falls;
  }
  input.wheel.y = 6.6e-3;
  input.wheel.yaw = 17e-3;
  for (const double load : {20e3, 80e3}) {
    input.wheel.z = height_for(contact, input, load);
    Line line;
    for (int n = 0; n < 4000; ++n) {
      input.wheel.yaw = 15e-3 + 1e-6 * n;
      line.take(wrc_contact_wrench(contact, &input, &wrench), wrench);
    }
    std::printf("y 6.60 mm, yaw 15 .. 19 mrad at the height of %.0f kN: %ld yaws, jump %.1e, %ld flagged\n",
                1e-3 * load, line.steps, line.jump, line.flagged);
    spoilt += line.flagged;
  }
  constexpr int flanges = 150, heights = 500;  // a few hundred nanometres apart: a jump is a bend, too
  Random random(3);
  long several = 0, flagged = 0, sharp = 0;
  double jump = 0.0;
  for (int n = 0; n < flanges; ++n) {
    input.wheel.y = random.between(6.0e-3, 7.2e-3);
    input.wheel.yaw = random.between(-26e-3, 26e-3);
    input.wheel.roll = random.between(-2e-3, 2e-3);
    const double top = height_for(contact, input, 5e3), bottom = height_for(contact, input, 60e3);
    Line line;
    for (int k = 0; k <= heights; ++k) {
      input.wheel.z = top + (bottom - top) * k / heights;
      line.take(wrc_contact_wrench(contact, &input, &wrench), wrench);
    }
    several += line.flagged > 0;
    flagged += line.flagged;
    sharp += line.jump > 1e-3;
    jump = std::max(jump, line.jump);
  }
  std::printf(
      "%d flanges, y 6.0 .. 7.2 mm, yaw to 26, roll to 2 mrad, 5 to 60 kN, %d heights each: %ld flagged on "
      "%ld of them, jumps above 1e-3 on %ld, largest %.1e\n",
      flanges, heights, flagged, several, sharp, jump);
  spoilt += flagged;
  return spoilt == 0 ? 0 : 1;
}

/// The flange under a yaw, between the heights of two vertical loads: rows of forces. Two solutions at one
/// height show where going down and going up from the last solution differ.
int branches(Pairs& pairs, double y, double yaw, double low, double high) {
  constexpr int steps = 400, exact_heights = 25;
  PairOptions options;
  options.wheel = pairs_of_profiles[0].wheel;
  options.rail = pairs_of_profiles[0].rail;
  wrc_contact* const contact = pairs.of(options).contact();
  wrc_wheel_input input = wrc_wheel_input_default();
  input.friction.coefficient = 0.0;
  input.wheel.y = y;
  input.wheel.yaw = yaw;
  const double top = height_for(contact, input, low), bottom = height_for(contact, input, high);
  std::printf("way,z_um,lateral_N,vertical_N,status\n");
  const auto row = [&](const char* way, double share, auto&& solve) {
    input.wheel.z = top + share * (bottom - top);
    wrc_wrench wrench = sized<wrc_wrench>();
    const int32_t status = solve(&wrench);
    std::printf("%s,%.4f,%.4f,%.4f,%s\n", way, 1e6 * input.wheel.z, wrench.force[1], -wrench.force[2],
                wrc_status_name(status));
    std::fflush(stdout);
  };
  const auto in_real_time = [&](wrc_wrench* wrench) { return wrc_contact_wrench(contact, &input, wrench); };
  for (int n = 0; n <= steps; ++n) row("cold", 1.0 * n / steps, in_real_time);
  input.start = WRC_START_WARM;
  for (int n = 0; n <= steps; ++n) row("down", 1.0 * n / steps, in_real_time);
  for (int n = steps; n >= 0; --n) row("up", 1.0 * n / steps, in_real_time);
  wrc_exact_wrench_options cells = wrc_exact_wrench_options_default();
  cells.cell_x = 0.4e-3;
  cells.cell_s = 0.125e-3;
  for (int n = 0; n < exact_heights; ++n)
    row("exact", 1.0 * n / (exact_heights - 1),
        [&](wrc_wrench* wrench) { return wrc_exact_wrench(contact, &input, &cells, wrench); });
  return 0;
}

/// How a wheelset runs; heights are those of its loads.
struct Run {
  const char* name;
  double amplitude, wavelength, speed;  ///< [m], [m], [m/s]
  double shaken;                        ///< share of load, creepages and roll that changes beside that
  double middle = 0.0;                  ///< [m]

  wrc_wheel_input at(wrc_contact* contact, long step) const {
    const double time = 1e-3 * static_cast<double>(step);
    const double phase = 2.0 * std::numbers::pi * speed * time / wavelength;
    wrc_wheel_input input = wrc_wheel_input_default();
    input.wheel.y = middle + amplitude * std::sin(phase);
    input.wheel.yaw = 2.0 * std::numbers::pi * amplitude / wavelength * std::cos(phase);
    input.wheel.roll = shaken * 0.5e-3 * std::sin(3.1 * phase);
    input.wheel.velocity[0] = speed;
    input.wheel.velocity[1] = speed * input.wheel.yaw + shaken * 0.02 * std::sin(7.0 * phase);
    input.wheel.angular_axes = WRC_AXES_TRACK;
    input.wheel.angular_velocity[1] = -speed / 0.46 * (1.0 + shaken * 1e-3 * std::sin(5.0 * phase));
    input.wheel.z = height_for(contact, input, 80e3 * (1.0 + shaken * 0.3 * std::sin(11.0 * phase)));
    return input;
  }
};

/// Klingel's motion on the tread, and a wheelset that touches with its flange.
constexpr Run straight{"straight", 1e-3, 9.0, 20.0, 0.0}, weaving{"weaving", 5.8e-3, 12.0, 40.0, 1.0};

/// Contacts of one model, as a vehicle has them.
class Contacts {
 public:
  Contacts(const Solver& solver, std::size_t count) : all_(count) {
    for (wrc_contact*& contact : all_)
      wrc_contact_create(solver.model(), WRC_SIDE_RIGHT, nullptr, &contact, nullptr, 0);
  }
  ~Contacts() {
    for (wrc_contact* const contact : all_) wrc_contact_destroy(contact);
  }
  Contacts(const Contacts&) = delete;
  Contacts& operator=(const Contacts&) = delete;
  wrc_contact* const* data() const { return all_.data(); }
  wrc_contact* operator[](std::size_t k) const { return all_[k]; }

 private:
  std::vector<wrc_contact*> all_;
};

/// Ways to start a solution.
struct Start {
  const char* name;
  int32_t start;
};
constexpr Start starts[] = {{"marked", WRC_START_MARK}, {"anew", WRC_START_COLD}};

/// Times of a case from a start: its name in the JSON object, and the numbers there [us].
struct Timed {
  std::string name;
  double median, slow;
};

/// One wheel along a run; each solution is marked.
Timed time_one(const Solver& solver, const Run& run, const Start& start, long steps) {
  wrc_contact* const scout = solver.contact();
  const Contacts one(solver, 1);
  std::vector<double> time[2], strips[2], iterations, all;
  for (long step = 0; step < steps; ++step) {
    wrc_wheel_input input = run.at(scout, step);
    input.start = start.start;
    wrc_wrench wrench = sized<wrc_wrench>();
    const double took = microseconds_of([&] {
      wrc_contact_wrench(one[0], &input, &wrench);
      if (start.start == WRC_START_MARK) wrc_contact_mark(one[0]);
    });
    if (step < 10) continue;
    const int two = wrench.region_count > 1;
    time[two].push_back(took);
    all.push_back(took);
    strips[two].push_back(strips_in_contact(one[0], wrench));
    iterations.push_back(wrench.iterations);
  }
  for (const int two : {0, 1})
    if (!time[two].empty())
      std::printf("%-9s %-7s %-11s %6zu calls, %2g strips, 50 %% %6.1f us  99 %% %6.1f us\n", run.name,
                  start.name, two ? "two regions" : "one region", time[two].size(),
                  at_share(strips[two], 0.5), at_share(time[two], 0.5), at_share(time[two], 0.99));
  std::printf("%-9s %-7s iterations 50 %% %g  99 %% %g\n", run.name, start.name, at_share(iterations, 0.5),
              at_share(iterations, 0.99));
  return {std::string(run.name) + "_" + start.name, at_share(all, 0.5), at_share(all, 0.999)};
}

/// Eight wheels of one model in a batch; half of them near the flange, where there are two regions.
Timed time_eight(const Solver& solver, const Start& start, long steps) {
  constexpr std::size_t wheels = 8;
  wrc_contact* const scout = solver.contact();
  const Contacts contacts(solver, wheels);
  std::vector<wrc_wheel_input> inputs(wheels);
  std::vector<wrc_wrench> wrenches(wheels, sized<wrc_wrench>());
  std::vector<double> time;
  double with_two = 0.0, strips = 0.0;
  for (long step = 0; step < steps; ++step) {
    for (std::size_t k = 0; k < wheels; ++k) {
      Run run = weaving;
      run.amplitude *= 0.02;
      run.middle = k % 2 == 0 ? 1e-3 : 5.2e-3;
      inputs[k] = run.at(scout, step);
      inputs[k].start = start.start;
    }
    const double took = microseconds_of([&] {
      wrc_contact_wrench_batch(contacts.data(), wheels, inputs.data(), sizeof inputs[0], wrenches.data(),
                               sizeof wrenches[0], nullptr);
      for (std::size_t k = 0; k < wheels && start.start == WRC_START_MARK; ++k) wrc_contact_mark(contacts[k]);
    });
    if (step < 10) continue;
    time.push_back(took);
    for (std::size_t k = 0; k < wheels; ++k) {
      with_two += wrenches[k].region_count > 1 ? 1.0 : 0.0;
      strips += strips_in_contact(contacts[k], wrenches[k]) / static_cast<double>(wheels);
    }
  }
  const auto calls = static_cast<double>(time.size());
  Timed timed{std::string("eight_wheels_") + start.name, at_share(time, 0.5), at_share(time, 0.999)};
  std::printf("eight wheels %-7s %.1f with two regions, %.0f strips each, 50 %% %.1f us  99.9 %% %.1f us\n",
              start.name, with_two / calls, strips / calls, timed.median, timed.slow);
  return timed;
}

/// Median of the times with a layer over that without, along a run with a height or a load given. Both calls
/// have the same input but for the layer, one after the other, which of them first in turn.
double layer_ratio(const Solver& solver, const Run& run, const wrc_friction& layered, bool load_given,
                   long steps) {
  wrc_contact* const scout = solver.contact();
  const Contacts two(solver, 2);
  wrc_friction clean = layered;
  clean.layer_thickness = clean.layer_modulus = clean.layer_yield = clean.layer_hardening = 0.0;
  std::vector<double> time[2];
  for (long step = 0; step < steps; ++step) {
    wrc_wheel_input input = run.at(scout, step);
    input.wheel.angular_velocity[1] *= 1.003;  // slips enough to make a layer yield
    input.start = WRC_START_MARK;
    if (load_given) {
      input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
      input.vertical_load = 80e3;
    }
    for (int turn = 0; turn < 2; ++turn) {
      const std::size_t which = static_cast<std::size_t>((turn + step) % 2);
      input.friction = which == 0 ? clean : layered;
      wrc_wrench wrench = sized<wrc_wrench>();
      time[which].push_back(microseconds_of([&] {
        wrc_contact_wrench(two[which], &input, &wrench);
        wrc_contact_mark(two[which]);
      }));
    }
  }
  return at_share(time[1], 0.5) / at_share(time[0], 0.5);
}

/// Cost of layers: all ratios, and the largest of each resolution.
int layers(const Csv& file, long steps) {
#define WRC_RESOLUTION(identifier, name, ...) name,
  for (const char* const setting : {WRC_RESOLUTION_LIST(WRC_RESOLUTION)}) {
#undef WRC_RESOLUTION
    Pairs pairs(file, setting);
    PairOptions options;
    options.wheel = pairs_of_profiles[0].wheel;
    options.rail = pairs_of_profiles[0].rail;
    const Solver& solver = pairs.of(options);
    double largest = 0.0;
#define WRC_FRICTION(identifier, name, ...) name,
    for (const char* const name : {WRC_FRICTION_LIST(WRC_FRICTION)}) {
#undef WRC_FRICTION
      wrc_friction friction = wrc_friction_default();
      wrc_friction_use(&friction, name, nullptr, 0);
      if (friction.layer_thickness == 0.0 && friction.layer_yield == 0.0) continue;
      std::printf("%-10s %-11s", setting, name);
      for (const Run& run : {straight, weaving})
        for (const bool load_given : {false, true}) {
          const double ratio = layer_ratio(solver, run, friction, load_given, steps);
          largest = std::max(largest, ratio);
          std::printf("  %s, %s given %.3f", run.name, load_given ? "load" : "height", ratio);
        }
      std::printf("\n");
    }
    std::printf("%-10s largest ratio %.3f\n", setting, largest);
  }
  return 0;
}

/// Times at each resolution, as a table and as one JSON object.
int times(const Csv& file, long steps) {
  std::string json;
#define WRC_RESOLUTION(identifier, name, ...) name,
  for (const char* const setting : {WRC_RESOLUTION_LIST(WRC_RESOLUTION)}) {
#undef WRC_RESOLUTION
    std::printf("%s\n", setting);
    Pairs pairs(file, setting);
    PairOptions options;
    options.wheel = pairs_of_profiles[0].wheel;
    options.rail = pairs_of_profiles[0].rail;
    const Solver& solver = pairs.of(options);
    std::vector<Timed> all;
    for (const Run& run : {straight, weaving})
      for (const Start& start : starts) all.push_back(time_one(solver, run, start, steps));
    for (const Start& start : starts) all.push_back(time_eight(solver, start, steps / 4));
    json += (json.empty() ? "\"" : ", \"") + std::string(setting) + "\": {";
    for (const Timed& timed : all) {
      char numbers[100];
      std::snprintf(numbers, sizeof numbers, ": {\"p50\": %.2f, \"p99.9\": %.2f}", timed.median, timed.slow);
      json += (&timed == all.data() ? "\"" : ", \"") + timed.name + "\"" + numbers;
    }
    json += "}";
  }
  std::printf("{\"settings\": {%s}}\n", json.c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::string setting = "default";
  if (argc > 2 && std::strcmp(argv[1], "--setting") == 0) {
    setting = argv[2];
    argc -= 2;
    argv += 2;
  }
  const std::string what = argc > 1 ? argv[1] : "";
  try {
    const Csv file(WRC_DATA "/scan_cases.csv");  // beside the profiles
    Pairs pairs(file, setting);
    if (what == "poses")
      return poses(pairs, argc > 2 ? std::atol(argv[2]) : 20000,
                   argc > 3 ? static_cast<unsigned>(std::atol(argv[3])) : 1U,
                   argc > 4 ? std::atol(argv[4]) : -1);
    if (what == "lines") return lines(pairs);
    if (what == "branches" && argc > 5)
      return branches(pairs, 1e-3 * std::atof(argv[2]), 1e-3 * std::atof(argv[3]), 1e3 * std::atof(argv[4]),
                      1e3 * std::atof(argv[5]));
    if (what == "loads")
      return loads(pairs, argc > 2 ? std::atol(argv[2]) : 2000,
                   argc > 3 ? static_cast<unsigned>(std::atol(argv[3])) : 1U);
    if (what == "times") return times(file, argc > 2 ? std::atol(argv[2]) : 4000);
    if (what == "layers") return layers(file, argc > 2 ? std::atol(argv[2]) : 400);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  std::fprintf(
      stderr,
      "usage: wheel_report [--setting NAME] poses [COUNT [SEED]] | lines | branches Y YAW LOW HIGH | "
      "loads [COUNT [SEED]] | times [STEPS] | layers [STEPS]\n");
  return 2;
}
