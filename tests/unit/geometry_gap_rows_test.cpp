#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/gap_rows.hpp"
#include "geometry_test_bodies.hpp"
#include "kernels/kernels.hpp"
#include "overlap_weighted_point.hpp"

namespace wrc::geometry {
namespace {

constexpr double mm = 1e-3;

/// A pose with its contact, window and rows.
struct Gap {
  static constexpr std::int32_t capacity = 400;
  std::array<double, capacity> y, height, centre, curvature;
  PosedWheel wheel;
  ContactPoint contact;
  GapWindow window;
  patch::GapRows rows;
  Fault fault;

  Gap(const ReferenceBodies& bodies, const Pose& pose, std::int32_t count = 200, const GapLimits& limits = {})
      : wheel(posed(bodies.wheel, pose)) {
    std::int32_t found = 0;
    fault = find_contact(bodies.rail, wheel, 1, &contact, found);
    if (fault.failed()) return;
    window = gap_window(bodies.rail, wheel, contact, limits);
    fault = fill_gap_rows(bodies.rail, wheel, contact, window, count,
                          {capacity, y.data(), height.data(), centre.data(), curvature.data()},
                          kernels_for(InstructionSet::baseline), rows);
  }
};

double separation(const ReferenceBodies& bodies, const Gap& gap, double x, double y) {
  return separation(bodies, gap.wheel, gap.contact, x, y);
}

TEST(GapRows, AreTheRotatedSurfaceOfRevolutionItself) {
  const ReferenceBodies bodies;
  const std::array<Pose, 5> poses{{{.lateral = 0.0},
                                   {.lateral = 1.0 * mm, .roll = 0.003, .yaw = 0.02},
                                   {.lateral = 5.0 * mm, .yaw = -0.01},
                                   {.lateral = 6.2 * mm, .roll = -0.002, .yaw = 0.02},
                                   {.lateral = 7.2 * mm, .yaw = 0.01}}};
  for (const Pose& pose : poses) {
    const Gap gap(bodies, pose);
    ASSERT_EQ(gap.fault.status, WRC_OK) << pose.lateral;
    for (std::int32_t j = 0; j < gap.rows.count; j += 7) {
      const double y = gap.rows.y[j], centre = gap.rows.centre[j], d = 0.5 * mm;
      const double middle = separation(bodies, gap, centre, y);
      const double ahead = separation(bodies, gap, centre + d, y),
                   behind = separation(bodies, gap, centre - d, y);
      EXPECT_NEAR(gap.rows.height[j], middle, 1e-12) << pose.lateral << " " << y;
      // lowest there: the slope in x, in units of the curvature, is a distance
      const double slope = (ahead - behind) / (2.0 * d);
      EXPECT_NEAR(slope / gap.rows.curvature[j], 0.0, 2e-6) << pose.lateral << " " << y;
      const double second = (ahead - 2.0 * middle + behind) / (d * d);
      EXPECT_NEAR(gap.rows.curvature[j], second, 2e-3 * second) << pose.lateral << " " << y;
    }
  }
}

TEST(GapRows, AParabolaDescribesARowOverAPatch) {
  // The claim of patch/gap.hpp: 1e-4 relative over |x| <= 7 mm on the tread.
  const ReferenceBodies bodies;
  const Gap gap(bodies, Pose{.lateral = 1.0 * mm, .yaw = 0.01});
  for (std::int32_t j = 0; j < gap.rows.count; ++j) {
    if (gap.rows.height[j] > 0.15 * mm) continue;
    for (const double x : {-7.0 * mm, 7.0 * mm}) {
      const double u = x - gap.rows.centre[j];
      const double parabola = 0.5 * gap.rows.curvature[j] * u * u;
      EXPECT_NEAR(separation(bodies, gap, x, gap.rows.y[j]) - gap.rows.height[j], parabola, 1e-3 * parabola);
    }
  }
}

TEST(GapRows, TouchAtTheOriginAndNowhereElse) {
  const ReferenceBodies bodies;
  for (double lateral = -6.0 * mm; lateral < 8.5 * mm; lateral += 0.29 * mm) {
    const Gap gap(bodies, Pose{.lateral = lateral, .yaw = 0.005});
    ASSERT_EQ(gap.fault.status, WRC_OK) << lateral;
    for (std::int32_t j = 0; j < gap.rows.count; ++j) {
      EXPECT_GE(gap.rows.height[j], -1e-12) << lateral << " " << gap.rows.y[j];
      EXPECT_GT(gap.rows.curvature[j], 0.0);
      if (j > 0) {
        EXPECT_GT(gap.rows.y[j], gap.rows.y[j - 1]);
      }
    }
    EXPECT_NEAR(patch::interpolate(gap.rows, 0.0).height, 0.0, 2e-8) << lateral;  // between the rows
    EXPECT_NEAR(patch::interpolate(gap.rows, 0.0).centre, 0.0, 2e-7) << lateral;
  }
}

TEST(GapRows, InTheOverlapWeightedFrameTouchTheSamePoint) {
  const ReferenceBodies bodies;
  Gap gap(bodies, Pose{.lateral = 0.3 * mm, .yaw = 0.004});
  const ContactPoint first = gap.contact;
  gap.contact = test::overlap_weighted_point(bodies.rail, gap.wheel, first, 0.07 * mm);
  ASSERT_GT(std::abs(gap.contact.y - first.y), 2.0 * mm);
  gap.window = gap_window(bodies.rail, gap.wheel, gap.contact, {});
  const Fault fault =
      fill_gap_rows(bodies.rail, gap.wheel, gap.contact, gap.window, 200,
                    {Gap::capacity, gap.y.data(), gap.height.data(), gap.centre.data(), gap.curvature.data()},
                    kernels_for(InstructionSet::baseline), gap.rows);
  ASSERT_EQ(fault.status, WRC_OK);
  const patch::GapMinimum touch = patch::minimum(gap.rows);
  EXPECT_NEAR(touch.height, 0.0, 2e-8);
  const double y_first =
      gap.contact.cosine * (first.y - gap.contact.y) + gap.contact.sine * (first.z - gap.contact.z);
  EXPECT_NEAR(touch.y, y_first, 0.02 * mm);
  for (std::int32_t j = 0; j < gap.rows.count; j += 11) {
    EXPECT_NEAR(gap.rows.height[j], separation(bodies, gap, gap.rows.centre[j], gap.rows.y[j]), 1e-12);
  }
}

TEST(GapRows, CurvatureAtTheContactIsCosineOverRollingRadius) {
  const ReferenceBodies bodies;  // Meusnier, no yaw
  for (const double lateral : {-3.0, 0.0, 3.0, 6.0}) {
    const Gap gap(bodies, Pose{.lateral = lateral * mm}, 400);
    const double expected = gap.contact.cosine / gap.contact.rolling_radius;
    EXPECT_NEAR(patch::interpolate(gap.rows, 0.0).curvature, expected, 1e-5 * expected) << lateral;
    EXPECT_NEAR(patch::interpolate(gap.rows, 0.0).centre, 0.0, 1e-15) << lateral;
  }
}

TEST(GapRows, EndWhereTheGapReachesItsLimit) {
  const ReferenceBodies bodies;
  const Gap gap(bodies, Pose{}, 200, {.height = 0.3 * mm});
  EXPECT_EQ(gap.window.low_end, RowsEnd::gap);
  EXPECT_EQ(gap.window.high_end, RowsEnd::gap);
  EXPECT_NEAR(gap.rows.height[0], 0.3 * mm, 0.01 * mm);
  EXPECT_NEAR(gap.rows.height[199], 0.3 * mm, 0.01 * mm);
}

TEST(GapRows, IncludeASecondZoneThatNearlyTouches) {
  // At 5.2 mm the tread still touches while the flange root comes within 0.1 mm of the gauge corner, 11 mm
  // away.
  const ReferenceBodies bodies;
  const Gap gap(bodies, Pose{.lateral = 5.0 * mm}, 200, {.height = 0.03 * mm});
  EXPECT_LT(gap.window.low, -10.0 * mm);
  double hollow = 0.0;
  for (std::int32_t j = 0; j < 200; ++j) {
    if (gap.rows.y[j] > -9.0 * mm && gap.rows.y[j] < -2.0 * mm) hollow = std::max(hollow, gap.rows.height[j]);
  }
  EXPECT_GT(hollow, 0.03 * mm);
}

TEST(GapRows, SayWhenTheProfileEndsBeforeTheGapOpens) {
  const ReferenceBodies bodies;
  ProfileStore cut;
  Profile profile;
  sample_uic60_benchmark(cut.memory(), profile);
  // Keep the head only up to 3 mm outside the centred contact point (y_rail = -7.28 mm).
  while (profile.y[profile.count - 2] > -4.3 * mm) --profile.count;
  ReferenceBodies shortened;
  place(profile, Placement{.y = bodies.rail.origin_y}, shortened.rail_placed.memory(),
        shortened.rail.profile);
  const Gap gap(shortened, Pose{});
  ASSERT_EQ(gap.fault.status, WRC_OK);
  EXPECT_EQ(gap.window.low_end, RowsEnd::gap);
  EXPECT_EQ(gap.window.high_end, RowsEnd::profile_end);
  EXPECT_NEAR(gap.window.high, profile.y[profile.count - 1] + 7.28 * mm, 0.02 * mm);
}

TEST(GapRows, EndBeforeTheOutlineFolds) {
  // Flange contact at 45 mrad: r r'' yaw^2 = 0.475 m * 1900 1/m * 0.045^2 = 1.8 at the top of the flange
  // root.
  const ReferenceBodies bodies;
  const Gap gap(bodies, Pose{.lateral = 7.5 * mm, .yaw = 0.045});
  ASSERT_EQ(gap.fault.status, WRC_OK);
  ASSERT_LT(gap.contact.angle, -1.1);
  EXPECT_EQ(gap.window.high_end, RowsEnd::fold);
  for (std::int32_t j = 0; j < gap.rows.count; ++j) {
    EXPECT_GE(gap.rows.height[j], -1e-12);
    EXPECT_GT(gap.rows.curvature[j], 0.0);
  }
}

TEST(GapRows, HalfWidthLimitsTheWindow) {
  const ReferenceBodies bodies;
  const Gap gap(bodies, Pose{}, 200, {.max_half_width = 8.0 * mm});
  EXPECT_EQ(gap.window.low_end, RowsEnd::half_width);
  EXPECT_EQ(gap.window.low, -8.0 * mm);
  EXPECT_EQ(gap.window.high, 8.0 * mm);
}

TEST(GapRows, DoNotJitterAsTheWheelsetMoves) {
  // Second differences over equal steps of the pose: a smooth dependence leaves only its curvature.
  const ReferenceBodies bodies;
  const double step = 0.01 * mm;
  for (const double y : {-9.0 * mm, -4.0 * mm, 5.0 * mm}) {
    std::array<double, 3> height{}, low{};
    for (int k = 0; k < 120; ++k) {
      const Gap gap(bodies, Pose{.lateral = -2.0 * mm + k * step});
      height = {height[1], height[2], patch::interpolate(gap.rows, y).height};
      low = {low[1], low[2], gap.window.low};
      if (k < 2) continue;
      EXPECT_LT(std::abs(height[2] - 2.0 * height[1] + height[0]), 1e-8) << y << " " << k;
      EXPECT_LT(std::abs(low[2] - 2.0 * low[1] + low[0]), 20e-6) << k;
    }
  }
}

TEST(GapRows, ConvergeWithTheirNumber) {
  const ReferenceBodies bodies;
  const Gap fine(bodies, Pose{.lateral = 2.0 * mm}, 400);
  double worst_coarse = 0.0, worst_medium = 0.0;
  const Gap coarse(bodies, Pose{.lateral = 2.0 * mm}, 50), medium(bodies, Pose{.lateral = 2.0 * mm}, 200);
  for (double y = -8.0 * mm; y < 8.0 * mm; y += 0.1 * mm) {
    const double h = patch::interpolate(fine.rows, y).height;
    worst_coarse = std::max(worst_coarse, std::abs(patch::interpolate(coarse.rows, y).height - h));
    worst_medium = std::max(worst_medium, std::abs(patch::interpolate(medium.rows, y).height - h));
  }
  // The profiles' steps of curvature limit the order to two.
  EXPECT_LT(worst_medium, 0.5 * worst_coarse);
  EXPECT_LT(worst_medium, 0.05e-6);
}

TEST(GapRows, RefuseTooFewOrTooManyRows) {
  const ReferenceBodies bodies;
  EXPECT_EQ(Gap(bodies, Pose{}, 3).fault.status, WRC_ERROR_BUFFER);
  EXPECT_EQ(Gap(bodies, Pose{}, 4).fault.status, WRC_OK);
  EXPECT_EQ(Gap(bodies, Pose{}, Gap::capacity).fault.status, WRC_OK);
  EXPECT_EQ(Gap(bodies, Pose{}, Gap::capacity + 1).fault.status, WRC_ERROR_BUFFER);
}

}  // namespace
}  // namespace wrc::geometry
