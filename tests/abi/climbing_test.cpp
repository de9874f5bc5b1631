/// A vertical load on a wheel whose flange climbs: friction that leaves one height that carries it, several
/// or none; and the other flags of a wheel on a rail.
#include <algorithm>
#include <cmath>
#include <vector>

#include "test_config.hpp"
#include "wheel_on_rail.hpp"

namespace {

/// A sharp crown that carries little beside a flange of 70 degrees that lies flat on the rail's face, where
/// the wheel slides downhill against high friction: the vertical force grows, falls and grows again.
class ClimbingFlange : public testing::Test, protected PlacedWheel {
 protected:
  ClimbingFlange() {
    constexpr double flange = 2.7475, crown = 0.15, flank = 2.0 / 3.0;
    shape({-31e-3, -29e-3, -22e-3, -18e-3}, {0.0, -flange, -flange, 0.0}, -40e-3, 40e-3, wheel_y_, wheel_z_);
    shape({-24e-3, -20e-3, -0.9e-3, 0.9e-3, 20e-3}, {-flange, -flank, -crown, crown, flank}, -33e-3, 30e-3,
          rail_y_, rail_z_);
    give(wheel_y_, wheel_z_, config.wheel);
    give(rail_y_, rail_z_, config.rail);
    config.track.placement = WRC_PLACEMENT_ORIGIN;
    config.track.rail_origin = 0.75;
    wheel.y = 1.342e-3;
    wheel.velocity[2] = -5.0;
    friction.coefficient = 2.0;
  }

  /// Heights with this slope over y, linear between the places given, 0 at y = 0.
  static void shape(const std::vector<double>& at, const std::vector<double>& slope, double from, double to,
                    std::vector<double>& y, std::vector<double>& z) {
    const auto slope_at = [&](double x) {
      if (x <= at[0]) return slope[0];
      for (std::size_t i = 1; i < at.size(); ++i)
        if (x <= at[i])
          return slope[i - 1] + (slope[i] - slope[i - 1]) * (x - at[i - 1]) / (at[i] - at[i - 1]);
      return slope.back();
    };
    constexpr double step = 0.1e-3;
    double height = 0.0, middle = 0.0;
    for (int i = 0; from + step * i < to; ++i) {
      const double x = from + step * i;
      y.push_back(x);
      z.push_back(height);
      if (std::abs(x) < 0.5 * step) middle = height;
      height += 0.5 * step * (slope_at(x) + slope_at(x + step));
    }
    for (double& each : z) each -= middle;
  }
  static void give(const std::vector<double>& y, const std::vector<double>& z, wrc_profile& profile) {
    profile.kind = WRC_PROFILE_POINTS;
    profile.count = static_cast<uint32_t>(y.size());
    profile.y = y.data();
    profile.z = z.data();
  }
  double force_at(double z) {
    input.prescribed = WRC_PRESCRIBE_HEIGHT;
    input.vertical_load = 0.0;
    wheel.z = z;
    EXPECT_GE(step(), 0) << error();
    return -wrench.force[2];
  }
  int32_t carry(double load) {
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = load;
    wheel.z = 0.0;
    return step();
  }

  std::vector<double> wheel_y_, wheel_z_, rail_y_, rail_z_;
};

TEST_F(ClimbingFlange, TheHighestOfSeveralHeightsIsReturnedWhateverCameBefore) {
  for (const int32_t warm : {0, 1}) {
    config.planar.start = warm;
    create();
    // what the force does on the way down: over 3.3 kN, below 0, over 20 kN
    double summit = 0.0, valley = 1e9, first = 1.0;
    for (double z = 0.0; z < 150e-6; z += 1e-6) {
      const double force = force_at(z);
      if (first > 0.5 && force >= 2000.0) first = z;
      if (z < 40e-6) summit = std::max(summit, force);
      if (z > 40e-6) valley = std::min(valley, force);
    }
    ASSERT_GT(summit, 3300.0);
    ASSERT_LT(valley, 0.0);
    ASSERT_GT(force_at(500e-6), 20e3);
    double z = 0.0;
    for (const double before : {200e3, 500.0, 3000.0}) {
      ASSERT_GE(carry(before), 0) << error();
      ASSERT_EQ(carry(2000.0), WRC_FLAG_CLIMBING);
      EXPECT_NE(error().find("input.vertical_load = 2000 N"), std::string::npos) << error();
      EXPECT_NE(error().find("the highest of the heights"), std::string::npos) << error();
      EXPECT_NEAR(wrench.force[2], -2000.0, 0.01);
      EXPECT_GT(wrench.z, first - 1.1e-6);
      EXPECT_LT(wrench.z, first + 0.1e-6);
      if (z != 0.0) {
        EXPECT_NEAR(wrench.z, z, 1e-11);
      }
      z = wrench.z;
    }
  }
}

TEST_F(ClimbingFlange, TheBranchGoesOverIntoItsEndWithoutAJump) {
  create();
  double z = 0.0, normal_force = 0.0, carried = 0.0, largest = 0.0;
  for (double load = 3545.0; load < 3620.0; load += 1.0) {
    ASSERT_EQ(carry(load), WRC_FLAG_CLIMBING) << load;
    const double now = -wrench.force[2];
    if (z != 0.0) {
      EXPECT_GE(now, carried - 0.01);
      // beside the end the height goes like the root of the load's distance from it
      EXPECT_LT(std::abs(wrench.z - z), 0.6e-6) << load;
      EXPECT_LT(std::abs(wrench.normal_force - normal_force), 0.05 * normal_force) << load;
    }
    largest = std::max(largest, now);
    z = wrench.z;
    normal_force = wrench.normal_force;
    carried = now;
  }
  EXPECT_LT(carried, 3615.0);
  EXPECT_NEAR(carried, largest, 0.01);
  EXPECT_NE(error().find("none does"), std::string::npos) << error();
  EXPECT_GT(carried, force_at(z - 1e-6));
  EXPECT_GT(carried, force_at(z + 1e-6));
}

TEST_F(ClimbingFlange, WithLittleFrictionNothingIsFlagged) {
  friction.coefficient = 0.2;
  create();
  for (double load = 200.0; load < 2e5; load *= 3.0) {
    EXPECT_EQ(carry(load), WRC_OK) << error();
    EXPECT_NEAR(wrench.force[2], -load, 1e-6 * load);
  }
}

/// Of S1002: slid down its flange with friction far above the slope, no height carries anything.
TEST_F(ClimbingFlange, WhereTheForceNeverGrowsItIsZeroAtFirstTouch) {
  config.wheel = config.rail = sized<wrc_profile>();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  config.track = test_config().track;
  wheel.y = 7.2e-3;
  friction.coefficient = 1.6;
  create();
  ASSERT_EQ(carry(10e3), WRC_FLAG_CLIMBING) << error();
  EXPECT_NE(error().find("first touch"), std::string::npos) << error();
  EXPECT_EQ(wrench.region_count, 0);
  EXPECT_EQ(wrench.force[2], 0.0);
  const double touch = wrench.z;
  EXPECT_LT(force_at(touch + 5e-6), -1.0);
  EXPECT_EQ(force_at(touch - 1e-6), 0.0);
  // the other way friction carries
  wheel.velocity[2] = 5.0;
  EXPECT_EQ(carry(10e3), WRC_OK) << error();
}

TEST_F(ClimbingFlange, WhatIsExtrapolatedIsFlagged) {
  create();
  friction.coefficient = 0.3;
  wheel = sized<wrc_wheel_state>();
  wheel.velocity[0] = 0.0999;
  force_at(0.1e-3);
  ASSERT_EQ(step(), WRC_FLAG_CREEPAGES_LIMITED);
  EXPECT_NE(error().find("rolling speed"), std::string::npos);
  wheel.velocity[0] = 0.2;
  wheel.pitch_rate = -0.2 / 0.46;
  EXPECT_EQ(step(), WRC_OK) << error();
  // the outer end of the wheel's tread on the rail
  wheel.y = -40e-3;
  ASSERT_EQ(carry(50e3), WRC_FLAG_PATCH_AT_EDGE) << error();
  EXPECT_NE(error().find("config.wheel"), std::string::npos) << error();
}

}  // namespace
