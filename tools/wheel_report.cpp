/// wheel_report - how wrc_contact_wrench() fares on random poses, and what a call takes.
///
///     wheel_report poses [COUNT [SEED]]   statuses, sweeps and numbers that are not finite
///     wheel_report lines                  forces over the height, and over yaw at the flange, in steps of 10 nm and 1 urad
///     wheel_report loads [COUNT [SEED]]   vertical loads given: what calls take of those at the height found
///     wheel_report times [STEPS]          from the last solution and anew, by regions; eight wheels in a batch
///
/// Poses: five pairs of new and worn profiles, both sides, lateral +-15 mm, roll and yaw +-40 mrad, heights
/// from lifted to 150 kN, ten to a pose; creepages up to full slip; half of them from the last solution,
/// which is then that of another pose. The sum at the end is of all forces: equal on every machine.
///
/// Times are of this machine in this minute: compare those of one run. S1002 on the benchmark UIC60, a
/// wheelset that weaves by 6 mm at 40 m/s in steps of 1 ms.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "csv.hpp"
#include "wheel_cases.hpp"

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
  explicit Random(unsigned seed) : engine_(seed) {}
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
  wrc_wrench wrench = wrc_wrench_default();
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

int poses(const Csv& file, long count, unsigned seed) {
  Pairs pairs(file);
  constexpr long heights = 10;  ///< to a pose
  Random random(seed);
  std::map<std::string, long> statuses;
  std::vector<double> sweeps[2];
  long in_contact = 0, not_finite = 0, without_height = 0, most_regions = 0;
  double sum = 0.0;
  for (long done = 0; done < count; done += heights) {
    PairOptions options;
    const auto& profiles = pairs_of_profiles[random.below(std::size(pairs_of_profiles))];
    options.wheel = profiles.wheel;
    options.rail = profiles.rail;
    options.side = random.one_in(2) ? WRC_SIDE_LEFT : WRC_SIDE_RIGHT;
    wrc_contact* const contact = pairs.of(options).contact();
    wrc_wheel_input input = wrc_wheel_input_default();
    input.wheel.y = random.between(-15e-3, 15e-3);
    input.wheel.roll = random.between(-40e-3, 40e-3);
    input.wheel.yaw = random.between(-40e-3, 40e-3);
    const double deepest = height_for(contact, input, 150e3);
    if (deepest == 0.0) {
      ++without_height;
      continue;
    }
    for (long k = 0; k < heights; ++k) {
      const double speed = random.between(1.0, 100.0), slip = std::pow(10.0, random.between(-4.0, -2.0));
      input.wheel.z = deepest + random.between(-0.6e-3, 0.0);
      input.wheel.velocity[0] = speed;
      input.wheel.velocity[1] = random.between(-slip, slip) * speed;
      input.wheel.angular_velocity[1] = -speed / 0.46 * (1.0 + random.between(-slip, slip));
      input.friction.coefficient = random.between(0.1, 0.6);
      input.start = random.one_in(2) ? WRC_START_ANEW : WRC_START_FROM_LAST;
      wrc_wrench wrench = wrc_wrench_default();
      const int32_t status = wrc_contact_wrench(contact, &input, &wrench);
      ++statuses[wrc_status_name(status)];
      not_finite += finite(wrench) ? 0 : 1;
      most_regions = std::max<long>(most_regions, wrench.regions);
      sum += wrench.force[0] + wrench.force[1] + wrench.force[2];
      if (wrench.normal_force > 0.0) {
        ++in_contact;
        sweeps[input.start].push_back(wrench.iterations);
      }
    }
    if (done / heights % 1000 == 0) std::fprintf(stderr, "\r%ld of %ld", done, count);
  }
  std::fprintf(stderr, "\r%40s\r", "");
  std::printf(
      "%ld calls, %ld in contact, %ld not finite, at most %ld regions; %ld poses carry 150 kN nowhere\n",
      count - heights * without_height, in_contact, not_finite, most_regions, without_height);
  for (const auto& [name, times] : statuses) std::printf("  %-28s %ld\n", name.c_str(), times);
  for (const int32_t start : {WRC_START_FROM_LAST, WRC_START_ANEW})
    std::printf("sweeps, %-22s 50 %% %g  99 %% %g  99.9 %% %g  most %g\n",
                start == WRC_START_ANEW ? "anew" : "from another pose's", at_share(sweeps[start], 0.5),
                at_share(sweeps[start], 0.99), at_share(sweeps[start], 0.999), at_share(sweeps[start], 1.0));
  std::printf("sum of forces %.9e N\n", sum);
  return not_finite == 0 && statuses.count(wrc_status_name(WRC_FLAG_ITERATION_CAP)) == 0 ? 0 : 1;
}

double microseconds_of(auto&& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();
}

/// Sweeps and times of a way to call.
struct Taken {
  std::vector<double> sweeps, time;
  int32_t take(wrc_contact* contact, const wrc_wheel_input& input, wrc_wrench& wrench) {
    int32_t status = 0;
    const double took = microseconds_of([&] { status = wrc_contact_wrench(contact, &input, &wrench); });
    time.push_back(took);
    sweeps.push_back(wrench.iterations);
    return status;
  }
};

/// Random poses with a load given, 20 to 120 kN, and 1 ms later: y, yaw and load a little different. Beside
/// them the same poses at the height found.
int loads(const Csv& file, long count, unsigned seed) {
  Pairs pairs(file);
  Random random(seed);
  enum { load_anew, height_anew, load_later, height_later, ways };
  constexpr const char* names[ways] = {"load, anew", "height, anew", "load, 1 ms later",
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
    input.wheel.angular_velocity[1] = -speed / 0.46 * (1.0 + random.between(-slip, slip));
    input.friction.coefficient = random.between(0.1, 0.5);
    input.vertical_load = random.between(20e3, 120e3);
    const auto call = [&](int way, int32_t prescribed, int32_t start, double height) {
      wrc_wrench wrench = wrc_wrench_default();
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
    const double height = call(load_anew, WRC_PRESCRIBE_VERTICAL_LOAD, WRC_START_ANEW, 0.0);
    call(height_anew, WRC_PRESCRIBE_HEIGHT, WRC_START_ANEW, height);
    input.wheel.y += random.between(-20e-6, 20e-6);
    input.wheel.yaw += random.between(-50e-6, 50e-6);
    input.wheel.velocity[1] += random.between(-1e-2, 1e-2) * slip * speed;
    input.vertical_load *= 1.0 + random.between(-0.02, 0.02);
    const wrc_wheel_input second = input;
    const double later = call(load_later, WRC_PRESCRIBE_VERTICAL_LOAD, WRC_START_FROM_LAST, 0.0);
    input = first;
    wrc_wrench wrench = wrc_wrench_default();
    input.vertical_load = 0.0;
    input.wheel.z = height;
    wrc_contact_wrench(contact, &input, &wrench);
    input = second;
    call(height_later, WRC_PRESCRIBE_HEIGHT, WRC_START_FROM_LAST, later);
  }
  for (const auto& [name, times] : statuses) std::printf("  %-28s %ld\n", name.c_str(), times);
  for (int way = 0; way < ways; ++way)
    std::printf("%-20s sweeps 50 %% %g  99 %% %g  most %g   50 %% %.1f us  99 %% %.1f us\n", names[way],
                at_share(taken[way].sweeps, 0.5), at_share(taken[way].sweeps, 0.99),
                at_share(taken[way].sweeps, 1.0), at_share(taken[way].time, 0.5),
                at_share(taken[way].time, 0.99));
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
int lines(const Csv& file) {
  Pairs pairs(file);
  PairOptions options;
  options.wheel = pairs_of_profiles[0].wheel;
  options.rail = pairs_of_profiles[0].rail;
  wrc_contact* const contact = pairs.of(options).contact();
  wrc_wrench wrench = wrc_wrench_default();
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
    for (double z = touch - 5e-6; z < deepest; z += 10e-9) {
      input.wheel.z = z;
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
    for (double yaw = 15e-3; yaw < 19e-3; yaw += 1e-6) {
      input.wheel.yaw = yaw;
      line.take(wrc_contact_wrench(contact, &input, &wrench), wrench);
    }
    std::printf("y 6.60 mm, yaw 15 .. 19 mrad at the height of %.0f kN: %ld yaws, jump %.1e, %ld flagged\n",
                1e-3 * load, line.steps, line.jump, line.flagged);
    spoilt += line.flagged;
  }
  return spoilt == 0 ? 0 : 1;
}

/// A wheelset that weaves; heights are those of its load.
struct Weaving {
  wrc_wheel_input at(wrc_contact* contact, long step) const {
    const double time = 1e-3 * static_cast<double>(step), speed = 40.0;
    const double phase = 2.0 * std::numbers::pi * speed * time / 12.0;
    wrc_wheel_input input = wrc_wheel_input_default();
    input.wheel.y = offset + 5.8e-3 * std::sin(phase);
    input.wheel.yaw = 3e-3 * std::cos(phase);
    input.wheel.roll = 0.5e-3 * std::sin(3.1 * phase);
    input.wheel.velocity[0] = speed;
    input.wheel.velocity[1] = speed * input.wheel.yaw + 0.02 * std::sin(7.0 * phase);
    input.wheel.angular_velocity[1] = -speed / 0.46 * (1.0 + 1e-3 * std::sin(5.0 * phase));
    input.wheel.z = height_for(contact, input, 80e3 * (1.0 + 0.3 * std::sin(11.0 * phase)));
    return input;
  }
  double offset = 0.0;
};

int times(const Csv& file, long steps) {
  Pairs pairs(file);
  PairOptions options;
  options.wheel = pairs_of_profiles[0].wheel;
  options.rail = pairs_of_profiles[0].rail;
  wrc_contact* const scout = pairs.of(options).contact();
  for (const int32_t start : {WRC_START_FROM_LAST, WRC_START_ANEW}) {
    Pairs own(file);
    wrc_contact* const contact = own.of(options).contact();
    std::vector<double> time[2], sweeps;
    for (long step = 0; step < steps; ++step) {
      wrc_wheel_input input = Weaving{}.at(scout, step);
      input.start = start;
      wrc_wrench wrench = wrc_wrench_default();
      const double took = microseconds_of([&] { wrc_contact_wrench(contact, &input, &wrench); });
      if (step < 10) continue;
      time[wrench.regions > 1].push_back(took);
      sweeps.push_back(wrench.iterations);
    }
    for (const int two : {0, 1})
      std::printf("%-22s %-12s %6zu calls, 50 %% %6.1f us  99 %% %6.1f us\n",
                  start == WRC_START_ANEW ? "anew" : "from the last solution",
                  two ? "two regions" : "one region", time[two].size(), at_share(time[two], 0.5),
                  at_share(time[two], 0.99));
    std::printf("%-22s sweeps 50 %% %g  99 %% %g\n", "", at_share(sweeps, 0.5), at_share(sweeps, 0.99));
  }

  constexpr std::size_t wheels = 8;  ///< half of them near the flange, where there are two regions
  std::vector<Pairs> bodies;
  for (std::size_t k = 0; k < wheels; ++k) bodies.emplace_back(file);
  std::vector<wrc_contact*> contacts;
  for (std::size_t k = 0; k < wheels; ++k) {
    contacts.push_back(bodies[k].of(options).contact());
  }
  std::vector<wrc_wheel_input> inputs(wheels);
  std::vector<wrc_wrench> wrenches(wheels, wrc_wrench_default());
  std::vector<double> time;
  double with_two = 0.0;
  for (long step = 0; step < steps / 4; ++step) {
    for (std::size_t k = 0; k < wheels; ++k) {
      inputs[k] = Weaving{}.at(scout, step);
      inputs[k].wheel.y = (k % 2 == 0 ? 1e-3 : 5.2e-3) + 0.02 * inputs[k].wheel.y;
      inputs[k].wheel.z = height_for(scout, inputs[k], 80e3);
    }
    const double took = microseconds_of([&] {
      wrc_contact_wrench_batch(contacts.data(), wheels, inputs.data(), sizeof inputs[0], wrenches.data(),
                               sizeof wrenches[0], nullptr);
    });
    if (step < 10) continue;
    time.push_back(took);
    for (const wrc_wrench& wrench : wrenches) with_two += wrench.regions > 1 ? 1.0 : 0.0;
  }
  std::printf("eight wheels, from the last solutions, %.1f with two regions: 50 %% %.1f us  99 %% %.1f us\n",
              with_two / static_cast<double>(time.size()), at_share(time, 0.5), at_share(time, 0.99));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  try {
    const Csv file(WRC_DATA "/scan_cases.csv");  // beside the profiles
    if (what == "poses")
      return poses(file, argc > 2 ? std::atol(argv[2]) : 20000,
                   argc > 3 ? static_cast<unsigned>(std::atol(argv[3])) : 1U);
    if (what == "lines") return lines(file);
    if (what == "loads")
      return loads(file, argc > 2 ? std::atol(argv[2]) : 2000,
                   argc > 3 ? static_cast<unsigned>(std::atol(argv[3])) : 1U);
    if (what == "times") return times(file, argc > 2 ? std::atol(argv[2]) : 4000);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  std::fprintf(stderr,
               "usage: wheel_report poses [COUNT [SEED]] | lines | loads [COUNT [SEED]] | times [STEPS]\n");
  return 2;
}
