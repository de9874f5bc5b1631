// Several regions of overlap: the outline and the chord of EKP_ELLIPSE.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/kernels.hpp"
#include "normal/methods/ekp.hpp"
#include "normal/penetration/overlap_regions.hpp"
#include "normal_gaps.hpp"
#include "patch/split.hpp"

namespace wrc::normal {
namespace {

using test::OwnedGap;
using test::StripMemory;

/// A contact at y = 0 and a valley of height `valley` at 10 mm, parted by a ridge of 40 um above that.
OwnedGap with_valley(double valley) {
  OwnedGap gap;
  for (int j = 0; j <= 240; ++j) {
    const double y = -6e-3 + 0.1e-3 * j;
    const double u = y / 5e-3 - 1.0;  // wells at -1 and 1
    gap.add(y, 40e-6 * (u * u - 1.0) * (u * u - 1.0) + 0.5 * valley * (u + 1.0), 2.0);
  }
  return gap;
}

TEST(OverlapRegions, ChordOfOneRegionIsThatOfThePatch) {
  const OwnedGap gap = test::elliptic_gap(1.0, 0.5, 20e-3, 201);
  for (const double approach : {1e-6, 20e-6, 100e-6}) {
    const patch::GapMinimum lowest = patch::minimum(gap.rows());
    const LateralCurvature all = curvature_of_all_regions(gap.rows(), lowest, approach);
    const LateralCurvature one = lateral_curvature(gap.rows(), lowest, approach);
    EXPECT_NEAR(all.coefficient, one.coefficient, 1e-9 * one.coefficient);
    EXPECT_NEAR(all.coefficient, 0.5, 1e-6);
    EXPECT_NEAR(all.middle, 0.0, 1e-9);
  }
}

TEST(OverlapRegions, ChordTakesAValleyInGraduallyAndThenWhole) {
  const OwnedGap gap = with_valley(10e-6);
  const patch::GapRows rows = gap.rows();
  const patch::GapMinimum lowest = patch::minimum(rows);
  double before = 0.0, widest = 0.0;
  for (double approach = 10e-6; approach < 70e-6; approach *= 1.001) {
    const LateralCurvature lateral = curvature_of_all_regions(rows, lowest, approach);
    const double half_width = std::sqrt(0.5 * approach / lateral.coefficient);
    if (before > 0.0) {
      EXPECT_GE(half_width, before * (1.0 - 1e-9)) << approach;
      EXPECT_LE(half_width, 1.02 * before) << approach;
    }
    before = half_width;
    widest = std::max(widest, half_width);
  }
  EXPECT_GT(widest, 5e-3);
  // Half depth 60 % of itself above the valley: from the first border to the last, as the reference program.
  const double approach = 2.0 * 10e-6 / 0.4 * 1.02;
  const LateralCurvature lateral = curvature_of_all_regions(rows, lowest, approach);
  double first = 0.0, last = 0.0;
  for (std::int32_t j = 0; j < rows.count; ++j)
    if (rows.height[j] - lowest.height < 0.5 * approach) {
      if (first == 0.0) first = rows.y[j];
      last = rows.y[j];
    }
  EXPECT_NEAR(std::sqrt(0.5 * approach / lateral.coefficient), 0.5 * (last - first), 0.1e-3);
  EXPECT_NEAR(lateral.middle, 0.5 * (first + last), 0.1e-3);
}

TEST(OverlapRegions, AreDividedIntoStripsThatFillThem) {
  const OwnedGap gap = with_valley(10e-6);
  const patch::GapRows rows = gap.rows();
  const patch::GapMinimum lowest = patch::minimum(rows);
  const PenetrationScale scale{.at_centre = 0.5};
  const Kernels& kernels = kernels_for(InstructionSet::baseline);
  for (const int count : {4, 5, 28, 60, 61})
    for (double approach = 15e-6; approach < 120e-6; approach *= 1.01) {
      StripMemory owned(count);
      patch::Strips& strips = owned.strips;
      const Span main = penetration_span(rows, lowest, scale, approach);
      const OverlapRegions regions = overlap_regions(rows, lowest, scale, approach, main, count / 2);
      divide_regions(kernels, rows, lowest, scale, approach, regions, count, strips);
      ASSERT_LE(strips.count, count);
      ASSERT_GE(strips.count, count - 1);
      std::int32_t first = 0;
      for (std::int32_t r = 0; r < regions.count; ++r) {
        const Span& region = regions.of[static_cast<std::size_t>(r)];
        const std::int32_t end = patch::patch_end(strips, first);
        EXPECT_NEAR(strips.y[first] - 0.5 * strips.width[first], region.y_from, 1e-8);
        EXPECT_NEAR(strips.y[end - 1] + 0.5 * strips.width[end - 1], region.y_to, 1e-8);
        first = end;
      }
      EXPECT_EQ(first, strips.count);
    }
}

TEST(EkpEllipse, LoadRisesSteadilyOverAValley) {
  const OwnedGap gap = with_valley(10e-6);
  for (const int count : {28, 60}) {
    SCOPED_TRACE(count);
    StripMemory owned(count);
    NormalSolution solution;
    double before = 0.0;
    std::int32_t most = 0;
    for (double approach = 2e-6; approach < 120e-6; approach *= 1.001) {
      ASSERT_EQ(
          solve_ekp(test::under_approach(gap, approach, count), {EkpScale::ellipse}, owned.strips, solution)
              .status,
          WRC_OK);
      if (before > 0.0) {
        EXPECT_GT(solution.normal_force, before) << approach;
        EXPECT_LT(solution.normal_force, 1.02 * before) << approach;
      }
      before = solution.normal_force;
      most = std::max(most, owned.strips.count - patch::patch_end(owned.strips, 0));
    }
    EXPECT_GT(most, 0);  // there were two regions
  }
}

}  // namespace
}  // namespace wrc::normal
