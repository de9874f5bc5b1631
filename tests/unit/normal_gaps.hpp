// Gaps the tests of the normal room share.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "kernels/kernels.hpp"
#include "normal/problem.hpp"

namespace wrc::test {

/// Rows with the memory under them.
struct OwnedGap {
  std::vector<double> y, height, centre, curvature;

  void add(double y_row, double height_row, double curvature_row, double centre_row = 0.0) {
    y.push_back(y_row);
    height.push_back(height_row);
    centre.push_back(centre_row);
    curvature.push_back(curvature_row);
  }
  patch::GapRows rows() const {
    return {static_cast<std::int32_t>(y.size()), y.data(), height.data(), centre.data(), curvature.data()};
  }
};

/// h = A x^2 + B y^2 over |y| < half_width.
inline OwnedGap elliptic_gap(double coefficient_x, double coefficient_y, double half_width, int count = 101) {
  OwnedGap gap;
  for (int j = 0; j < count; ++j) {
    const double y = half_width * (2.0 * j / (count - 1) - 1.0);
    gap.add(y, coefficient_y * y * y, 2.0 * coefficient_x);
  }
  return gap;
}

/// y -> -y.
inline OwnedGap mirrored(const OwnedGap& gap) {
  OwnedGap mirror;
  for (std::size_t j = gap.y.size(); j-- > 0;)
    mirror.add(-gap.y[j], gap.height[j], gap.curvature[j], gap.centre[j]);
  return mirror;
}

/// S1002 (EN 13715) on the Manchester benchmark's UIC60 canted 1:40, wheelset centred, no yaw: heights along
/// the contact normal in nm, every 0.5 mm from y = -20 mm, computed once from the analytic definitions of
/// both profiles by a script outside this tree. Radius 460 mm, flange-back distance 1360 mm, gauge 1435 mm.
inline OwnedGap s1002_on_uic60() {
  static constexpr double nanometres[] = {
      299821, 270552, 242539, 215848, 190539, 166670, 144295, 123465, 104226, 86623, 70699, 56493,
      44043,  33385,  24553,  17580,  12498,  9336,   8124,   8678,   9353,   9766,  9944,  9914,
      9700,   9327,   8820,   8202,   7495,   6723,   5906,   5067,   4228,   3408,  2630,  1914,
      1281,   752,    348,    90,     -1,     97,     405,    946,    1743,   2819,  4197,  5901,
      7958,   10391,  13229,  16499,  20229,  24448,  29187,  34478,  40353,  46846, 53993, 61829,
      70393,  79936,  92173,  107558, 126135, 147954, 173062, 201510, 233351};
  OwnedGap gap;
  double y = -20e-3;
  for (const double height : nanometres) {
    gap.add(y, height * 1e-9, 1.0 / 0.46);
    y += 0.5e-3;
  }
  return gap;
}

/// Strips with the memory under them.
struct StripMemory {
  explicit StripMemory(std::int32_t capacity) : memory(static_cast<std::size_t>(5 * capacity)) {
    strips.capacity = capacity;
    double* block = memory.data();
    for (double** field : {&strips.y, &strips.width, &strips.centre, &strips.half_length, &strips.peak}) {
      *field = block;
      block += capacity;
    }
  }
  StripMemory(const StripMemory&) = delete;
  StripMemory& operator=(const StripMemory&) = delete;
  std::vector<double> memory;
  patch::Strips strips;
};

/// G = 80 GPa, nu = 0.25: the material of every reference case.
inline constexpr patch::Material steel{80e9, 0.25};

inline normal::NormalProblem under_load(const OwnedGap& gap, double normal_force, std::int32_t strips = 60) {
  normal::NormalProblem problem;
  problem.gap = gap.rows();
  problem.material = steel;
  problem.normal_force = normal_force;
  problem.strips = strips;
  problem.max_iterations = 40;
  problem.force_tolerance = 1e-9;
  problem.kernels = &kernels_for(InstructionSet::baseline);
  return problem;
}

inline normal::NormalProblem under_approach(const OwnedGap& gap, double approach, std::int32_t strips = 60) {
  normal::NormalProblem problem = under_load(gap, 0.0, strips);
  problem.prescribed = normal::Prescribed::approach;
  problem.approach = approach;
  return problem;
}

}  // namespace wrc::test
