#include <gtest/gtest.h>

#include <cmath>

#include "normal_gaps.hpp"
#include "patch/material.hpp"
#include "patch/regularise.hpp"
#include "patch/sdec.hpp"

namespace wrc::patch {
namespace {

using test::StripMemory;

TEST(SdecStrips, CarryTheLoadToRoundingForAnyCount) {
  for (const double psi : {-0.7, 0.0, 0.4})
    for (const int count : {4, 5, 20, 64}) {
      StripMemory owned(64);
      sdec_strips({4e-3, 6e-3, psi}, 0.0, 0.0, 17e3, count, owned.strips);
      EXPECT_NEAR(totals(owned.strips).normal_force, 17e3, 1e-9) << psi << " " << count;
    }
}

TEST(SdecStrips, ConvergeToTheRegion) {
  const Sdec sdec{4.25e-3, 6.375e-3, 0.4};
  const double area = pi * sdec.a * sdec.b;
  StripMemory owned(256);
  double previous = 1.0;
  for (const int count : {16, 32, 64, 128, 256}) {
    sdec_strips(sdec, 0.0, 0.0, 17e3, count, owned.strips);
    const StripTotals sum = totals(owned.strips);
    const double error = std::abs(sum.area - area) / area;
    EXPECT_LT(error, 0.4 * previous);
    previous = error;
    EXPECT_NEAR(sum.y_max, sdec.b * 1.4, 1e-15);
    EXPECT_NEAR(sum.y_min, -sdec.b * 0.6, 1e-15);
  }
  EXPECT_LT(previous, 1e-4);
  EXPECT_NEAR(totals(owned.strips).peak_pressure, peak_pressure(sdec, 17e3),
              1e-4 * peak_pressure(sdec, 17e3));
  EXPECT_EQ(owned.strips.y[127] + 0.5 * owned.strips.width[127], 0.0);
}

TEST(SdecStrips, MirrorWithTheShapeNumber) {
  StripMemory right(20), left(20);
  sdec_strips({4e-3, 6e-3, 0.3}, 0.0, 0.0, 17e3, 20, right.strips);
  sdec_strips({4e-3, 6e-3, -0.3}, 0.0, 0.0, 17e3, 20, left.strips);
  for (int j = 0; j < 20; ++j) {
    EXPECT_EQ(right.strips.y[j], -left.strips.y[19 - j]);
    EXPECT_EQ(right.strips.half_length[j], left.strips.half_length[19 - j]);
    EXPECT_EQ(right.strips.peak[j], left.strips.peak[19 - j]);
  }
}

TEST(Regularise, AnExactRegionIsItsOwnRegularisation) {
  const Sdec exact{4.25e-3, 6.375e-3, -0.4};
  StripMemory owned(256);
  sdec_strips(exact, 0.0, 1e-3, 17e3, 256, owned.strips);
  for (const SecondCriterion criterion : {SecondCriterion::aspect_ratio, SecondCriterion::width}) {
    Sdec sdec;
    ASSERT_EQ(regularise(totals(owned.strips), 1e-3, criterion, sdec).status, WRC_OK);
    EXPECT_NEAR(sdec.a, exact.a, 2e-4 * exact.a);
    EXPECT_NEAR(sdec.b, exact.b, 2e-4 * exact.b);
    EXPECT_NEAR(sdec.psi, exact.psi, 2e-4);
  }
}

TEST(Regularise, CriteriaKeepWhatTheyNameOnARectangle) {
  // 4 mm long, 10 mm wide: area 40 mm^2.
  const StripTotals patch{.area = 40e-6,
                          .normal_force = 1.0,
                          .peak_pressure = 1.0,
                          .length = 4e-3,
                          .y_min = -7e-3,
                          .y_max = 3e-3};
  Sdec ratio, width;
  ASSERT_EQ(regularise(patch, 0.0, SecondCriterion::aspect_ratio, ratio).status, WRC_OK);
  ASSERT_EQ(regularise(patch, 0.0, SecondCriterion::width, width).status, WRC_OK);
  EXPECT_NEAR(pi * ratio.a * ratio.b, 40e-6, 1e-18);
  EXPECT_NEAR(ratio.a / ratio.b, 0.4, 1e-14);
  EXPECT_NEAR(ratio.psi, -2e-3 / ratio.b, 1e-14);
  EXPECT_NEAR(pi * width.a * width.b, 40e-6, 1e-18);
  EXPECT_NEAR(width.b, 5e-3, 1e-17);
  EXPECT_NEAR(width.psi, -0.4, 1e-14);
}

TEST(Regularise, FlagsAContactPointOutsideThePatchAndNoPatch) {
  const StripTotals patch{
      .area = 40e-6, .normal_force = 1.0, .peak_pressure = 1.0, .length = 4e-3, .y_min = 1e-3, .y_max = 3e-3};
  Sdec sdec;
  EXPECT_EQ(regularise(patch, 0.0, SecondCriterion::width, sdec).status, WRC_FLAG_TABLE_RANGE);
  EXPECT_EQ(sdec.psi, largest_psi);
  EXPECT_EQ(regularise({}, 0.0, SecondCriterion::width, sdec).status, WRC_FLAG_NO_CONTACT);
  EXPECT_EQ(sdec.a, 0.0);
}

}  // namespace
}  // namespace wrc::patch
