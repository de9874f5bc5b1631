/// Numbers too small for full precision cost some processors a hundred cycles each: do they cost a step
/// anything?
#include <algorithm>
#include <cstdio>
#include <vector>

#include "golden/plan.hpp"
#include "proof/processor_time.hpp"
#include "proof/proofs.hpp"
#include "proof/wheel.hpp"

namespace {

double median(std::vector<double>& values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// A number of the host's that may be tiny.
struct Case {
  const char* name;
  bool posed;  ///< the step is from the pose, not from a gap
  void (*set)(Wheel&, Gap&, double tiny);
};

constexpr Case cases[] = {
    {"creepages", false,
     [](Wheel& wheel, Gap&, double tiny) {
       wheel.creepage.longitudinal = tiny;
       wheel.creepage.lateral = -0.3 * tiny;
       wheel.creepage.spin = 0.7 * tiny;
     }},
    {"one creepage of three", false, [](Wheel& wheel, Gap&, double tiny) { wheel.creepage.lateral = tiny; }},
    {"speed", false, [](Wheel& wheel, Gap&, double tiny) { wheel.creepage.speed = tiny; }},
    {"centres of the gap", false,
     [](Wheel&, Gap& gap, double tiny) {
       for (std::size_t j = 0; j < gap.centre.size(); ++j) gap.centre[j] = tiny * static_cast<double>(j % 7);
     }},
    {"yaw", true, [](Wheel& wheel, Gap&, double tiny) { wheel.pose.yaw = tiny; }},
    {"friction of a zone", false,
     [](Wheel& wheel, Gap&, double tiny) {
       static const double zone_y[] = {-1e-3, 1e-3};
       static double zone_coefficient[] = {0.3, 0.0};
       zone_coefficient[1] = tiny;
       wheel.friction.zone_count = 2;
       wheel.friction.zone_y = zone_y;
       wheel.friction.zone_coefficients = zone_coefficient;
     }},
    {"damping", false,
     [](Wheel& wheel, Gap&, double tiny) {
       wheel.load.prescribed = WRC_PRESCRIBE_APPROACH;
       wheel.load.approach = 80e-6;
       wheel.load.approach_velocity = 1.0;
       wheel.load.damping = tiny;
     }},
};
constexpr double sizes[] = {1e-310, 1e-160};

}  // namespace

bool prove_no_denormal_creepages() {
  int compared = 0, different = 0;
  for (const Methods& methods : all_methods()) {
    Wheel wheel(methods);
    const auto hash_with = [&](double size) {
      wheel.vary(7);
      wheel.pose.roll = wheel.pose.yaw = size;
      wheel.creepage.longitudinal = size;
      wheel.creepage.lateral = -0.3 * size;
      wheel.creepage.spin = 0.7 * size;
      wheel.restore();
      Hash hash;
      const int32_t status = wheel.step();
      hash_step(wheel.contact, status, wheel.output, gives_tractions(wheel.methods.tangential), hash);
      return hash.value();
    };
    wheel.save();
    const std::uint64_t none = hash_with(0.0);
    for (double size : {5e-324, 1e-310, 1e-160, 9e-101}) {
      ++compared;
      different += hash_with(size) != none;
    }
    ++compared;
    different += hash_with(1e-30) == none;  // those that do count are not lost
  }
  std::printf("%d steps with creepages and angles too small to count, against none at all: %d differ\n",
              compared, different);
  return different == 0;
}

void print_denormals() {
  std::printf("%-26s %-18s %14s %14s\n", "median time of a step with", "", "1e-310 / none", "1e-160 / none");
  for (int32_t tangential = 0; tangential < tangential_methods; ++tangential) {
    Wheel wheel({WRC_NORMAL_STRIP_HALFSPACE, tangential, WRC_SIDE_RIGHT, 60, 50});
    const wrc_friction friction = wheel.friction;
    const Gap usual = wheel.gap_of_pose();
    constexpr int rounds = 300;
    for (const Case& each : cases) {
      std::vector<double> none, tiny[std::size(sizes)];
      const auto time_with = [&](double size) {
        wheel.vary(7);
        wheel.load.prescribed = WRC_PRESCRIBE_NORMAL_FORCE;
        wheel.creepage.speed = 1.0;
        wheel.friction = friction;
        Gap gap = usual;
        each.set(wheel, gap, size);
        const double start = processor_time();
        each.posed ? wheel.step() : wheel.step_with(gap);
        return processor_time() - start;
      };
      for (int i = 0; i < rounds; ++i) {  // interleaved: the machine is the same for all
        none.push_back(time_with(0.0));
        for (std::size_t k = 0; k < std::size(sizes); ++k) tiny[k].push_back(time_with(sizes[k]));
      }
      const double unit = median(none);
      std::printf("%-26s %-18s %14.2f %14.2f\n", each.name, presets[tangential].identifier,
                  median(tiny[0]) / unit, median(tiny[1]) / unit);
    }
  }
}
