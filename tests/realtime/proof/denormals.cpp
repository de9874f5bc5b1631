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

struct Case {
  const char* name;
  void (*set)(Wheel&, Gap&);
};

constexpr Case cases[] = {
    {"usual numbers", [](Wheel&, Gap&) {}},
    {"creepages of 1e-9",
     [](Wheel& wheel, Gap&) {
       wheel.creepage.longitudinal = 1e-9;
       wheel.creepage.lateral = -3e-10;
       wheel.creepage.spin = 2e-7;
     }},
    {"creepages of 1e-310",
     [](Wheel& wheel, Gap&) {
       wheel.creepage.longitudinal = 1e-310;
       wheel.creepage.lateral = -3e-311;
       wheel.creepage.spin = 2e-310;
     }},
    {"creepages of 1e-160",
     [](Wheel& wheel, Gap&) {  // their squares are denormal
       wheel.creepage.longitudinal = 1e-160;
       wheel.creepage.lateral = -3e-160;
       wheel.creepage.spin = 2e-157;
     }},
    {"centres of the gap at 1e-310",
     [](Wheel&, Gap& gap) {
       for (std::size_t j = 0; j < gap.centre.size(); ++j)
         gap.centre[j] = 1e-310 * static_cast<double>(j % 7);
     }},
    {"a speed of 1e-310", [](Wheel& wheel, Gap&) { wheel.creepage.speed = 1e-310; }},
};

}  // namespace

bool prove_no_denormal_creepages() {
  int compared = 0, different = 0;
  for (const Methods& methods : all_methods()) {
    Wheel wheel(methods);
    const auto hash_with = [&](double size) {
      wheel.vary(7);
      wheel.creepage.longitudinal = size;
      wheel.creepage.lateral = -0.3 * size;
      wheel.creepage.spin = 0.7 * size;
      wheel.restore();
      Hash hash;
      const int32_t status = wheel.step();
      hash_step(wheel.contact, status, wheel.point, wheel.patch, wheel.forces, wheel.damage, hash);
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
  std::printf("%d steps with creepages too small to count, against none at all: %d differ\n", compared,
              different);
  return different == 0;
}

void print_denormals() {
  std::printf("%-30s %26s\n", "median time of a step", "to that of usual numbers");
  for (int32_t tangential : {WRC_TANGENTIAL_FASTSIM_SDEC, WRC_TANGENTIAL_STRIP_FASTSIM}) {
    Wheel wheel({WRC_NORMAL_STRIP_HALFSPACE, tangential, WRC_SIDE_RIGHT, 60, 50});
    const Gap usual = wheel.gap_of_pose();
    std::vector<double> times[std::size(cases)];
    for (int i = 0; i < 300; ++i) {
      for (std::size_t k = 0; k < std::size(cases); ++k) {  // interleaved: the machine is the same for all
        wheel.vary(7);
        wheel.load.prescribed = WRC_PRESCRIBE_LOAD;
        wheel.creepage.speed = 1.0;
        Gap gap = usual;
        cases[k].set(wheel, gap);
        const double start = processor_time();
        wheel.step_with(gap);
        times[k].push_back(processor_time() - start);
      }
    }
    const double unit = median(times[0]);
    for (std::size_t k = 0; k < std::size(cases); ++k)
      std::printf("%-30s %-14s %10.2f\n", cases[k].name, tangential_names[tangential],
                  median(times[k]) / unit);
  }
}
