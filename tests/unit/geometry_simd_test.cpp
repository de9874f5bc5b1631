#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "geometry/gap_rows.hpp"
#include "geometry_test_bodies.hpp"
#include "kernels/kernels.hpp"

namespace wrc::geometry {
namespace {

/// The rows of the reference bodies in a pose, all four arrays in one.
std::vector<double> gap_rows(const ReferenceBodies& bodies, const Pose& pose, std::int32_t count,
                             InstructionSet set) {
  const PosedWheel wheel = posed(bodies.wheel, pose);
  ContactPoint contact;
  std::int32_t found = 0;
  EXPECT_FALSE(find_contact(bodies.rail, wheel, 1, &contact, found).failed());
  const GapWindow window = gap_window(bodies.rail, wheel, contact, {});
  const auto n = static_cast<std::size_t>(count);
  std::vector<double> all(4 * n);
  double* const a = all.data();
  patch::GapRows rows;
  const Fault fault = fill_gap_rows(bodies.rail, wheel, contact, window, count,
                                    {count, a, a + n, a + 2 * n, a + 3 * n}, kernels_for(set), rows);
  EXPECT_EQ(fault.status, WRC_OK) << pose.lateral << " " << pose.yaw << " " << count;
  return all;
}

TEST(GeometryInstructionSets, GiveTheSameBits) {
  const ReferenceBodies bodies;
  for (int n = 0; n < 300; ++n) {  // from the field side to the flange, blocks of rows filled and not
    const Pose pose{-5e-3 + 12.2e-3 * n / 299, 0.0, 4e-3 * std::sin(3.0 * n), 24e-3 * std::sin(1.7 * n)};
    const std::int32_t count = 4 + (37 * n) % 260;
    const std::vector<double> baseline = gap_rows(bodies, pose, count, InstructionSet::baseline);
    for (InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
      if (set > best_instruction_set()) continue;
      const std::vector<double> wide = gap_rows(bodies, pose, count, set);
      ASSERT_EQ(std::memcmp(baseline.data(), wide.data(), baseline.size() * sizeof(double)), 0)
          << "pose " << n << ", set " << static_cast<int>(set);
    }
  }
}

// Blocks of rows start each other: a gap of few rows must hold what a gap of many has at the same places.
TEST(GapRows, DoNotDependOnTheirNumber) {
  const ReferenceBodies bodies;
  for (int n = 0; n < 60; ++n) {
    const Pose pose{-5e-3 + 12.2e-3 * n / 59, 0.0, 0.0, 20e-3 * std::sin(1.7 * n)};
    const std::int32_t few = 5, many = 257, apart = (many - 1) / (few - 1);
    const std::vector<double> coarse = gap_rows(bodies, pose, few, InstructionSet::baseline);
    const std::vector<double> fine = gap_rows(bodies, pose, many, InstructionSet::baseline);
    for (std::int32_t j = 0; j < few; ++j) {
      const auto at = static_cast<std::size_t>(few + j), there = static_cast<std::size_t>(many + j * apart);
      EXPECT_NEAR(coarse[at], fine[there], 2e-12) << pose.lateral << " row " << j;
    }
  }
}

TEST(GeometryInstructionSets, AreTheOnesAskedFor) {
  for (InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (set > best_instruction_set()) continue;
    EXPECT_EQ(kernels_for(set).set, set);
  }
}

}  // namespace
}  // namespace wrc::geometry
