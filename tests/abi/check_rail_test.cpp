/// A check rail beside the rail, against the back of the flange.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "../check_rail_points.hpp"
#include "test_config.hpp"
#include "wheel_on_rail.hpp"
#include "wrc/wrc_offline.h"

namespace {

class CheckRail : public testing::Test, protected PlacedWheel {
 protected:
  static constexpr double apart = -0.0813, above = -0.020, rail_origin = 0.7535;

  CheckRail() {
    config.rail.kind = WRC_PROFILE_60E1;
    config.track.placement = WRC_PLACEMENT_ORIGIN;
    config.track.rail_origin = rail_origin;
    config.check_rail.y = apart;
    config.check_rail.z = above;
    config.check_rail.profile = points_.profile();
    wheel.z = 0.18e-3;
    wheel.velocity[1] = -0.05;
  }
  CheckRailPoints points_;
  std::vector<double> wheel_y_, wheel_z_;

  /// S1002 whose flange's back goes on to 86 degrees: it ends before it meets a face of 84 in its middle.
  /// `create()` first.
  void give_longer_back() {
    wrc_view nodes_y, nodes_z;
    ASSERT_EQ(wrc_model_profile(model, WRC_SIDE_RIGHT, WRC_BODY_WHEEL, &nodes_y, &nodes_z, nullptr), WRC_OK);
    const auto at = [](const wrc_view& view, uint32_t i) {
      return *(static_cast<const double*>(view.data) + i);
    };
    constexpr int behind = 60;
    constexpr double middle = 0.75, back = 20.5e-3, step_along = 0.2e-3;
    std::vector<double>&y = wheel_y_, &z = wheel_z_;
    double last_y = at(nodes_y, 0) - middle, last_z = at(nodes_z, 0);
    double angle = std::atan2(at(nodes_z, 1) - last_z, at(nodes_y, 1) - middle - last_y);
    for (int i = 0; i < behind; ++i) {
      if (std::tan(angle) < 15.0) angle += step_along / back;
      last_y -= step_along * std::cos(angle);
      last_z -= step_along * std::sin(angle);
      y.insert(y.begin(), last_y);
      z.insert(z.begin(), last_z);
    }
    for (uint32_t i = 0; i < nodes_y.count; ++i) {
      y.push_back(at(nodes_y, i) - middle);
      z.push_back(at(nodes_z, i));
    }
    config.wheel.kind = WRC_PROFILE_POINTS;
    config.wheel.count = static_cast<uint32_t>(y.size());
    config.wheel.y = y.data();
    config.wheel.z = z.data();
  }

  wrc_region region(int32_t index) {
    wrc_region shown = sized<wrc_region>();
    EXPECT_EQ(wrc_contact_region(contact, index, &shown), WRC_OK);
    return shown;
  }
  /// The lateral place at which the check rail carries about 30 kN, at most `deepest` from the middle.
  void lean_on_check_rail(double outward, double deepest = 12e-3) {
    double low = -deepest, high = 0.0;
    for (int n = 0; n < 30; ++n) {
      const double y = 0.5 * (low + high);
      wheel.y = outward * y;
      ASSERT_GE(step(), 0) << error();
      double carried = 0.0;
      for (int32_t i = 0; i < wrench.region_count; ++i)
        if (region(i).surface == 0) carried += region(i).normal_force;
      (carried > 30e3 ? low : high) = y;
    }
    ASSERT_LT(low - high, 1e-9);
  }
};

/// Faces do not press on each other: the rail alone and the check rail alone, as the rail of another model,
/// add up.
TEST_F(CheckRail, BothRailsAddUp) {
  const wrc_config both = config;
  for (const int32_t which : {WRC_SIDE_RIGHT, WRC_SIDE_LEFT}) {
    const double outward = which == WRC_SIDE_LEFT ? -1.0 : 1.0;
    for (double* each : {&wheel.velocity[1], &wheel.yaw}) *each = std::copysign(*each, -outward);
    config = both;
    create(which);
    lean_on_check_rail(outward);
    const wrc_wrench together = wrench;
    ASSERT_EQ(wrench.region_count, 2);
    const wrc_region check = region(0), tread = region(1);
    EXPECT_EQ(check.surface, 0);
    EXPECT_EQ(tread.surface, 1);
    EXPECT_NEAR(check.normal_force, 30e3, 10.0);
    EXPECT_GT(outward * check.force[1], 0.9 * 30e3);  // away from the check rail, outwards
    EXPECT_LT(check.y_wheel, -0.058);                 // on the flange's back
    EXPECT_NEAR(check.y_rail, apart + 0.0043, 1e-3);
    EXPECT_GT(outward * check.angle, 1.0);
    EXPECT_NEAR(tread.y_rail, 0.0, 0.03);

    config.check_rail = test_config().check_rail;
    create(which);
    ASSERT_EQ(step(), WRC_OK) << error();
    const wrc_wrench rail_alone = wrench;
    EXPECT_EQ(region(0).surface, 0);
    const double size = together.normal_force;
    const double lever[3] = {check.point[0], check.point[1] - wheel.y, check.point[2] - wheel.z + 0.46};
    for (int k = 0; k < 3; ++k) {
      const int a = (k + 1) % 3, b = (k + 2) % 3;
      EXPECT_NEAR(together.force[k], rail_alone.force[k] + check.force[k], 2e-3 * size) << k;
      EXPECT_NEAR(
          together.moment[k],
          rail_alone.moment[k] + check.moment[k] + lever[a] * check.force[b] - lever[b] * check.force[a],
          2e-3 * size)
          << k;
    }
    EXPECT_NEAR(together.normal_force, rail_alone.normal_force + check.normal_force, 2e-3 * size);
    EXPECT_NEAR(together.power, rail_alone.power + check.power, 0.01 * together.power);
  }
}

TEST_F(CheckRail, ItComesInSmoothlyAsTheWheelsetMoves) {
  create();
  lean_on_check_rail(1.0);
  const double there = wheel.y;
  double before[3] = {}, step_before[3] = {};
  for (int i = 0; i <= 300; ++i) {
    wheel.y = there + 0.6e-3 - 2e-6 * i;
    ASSERT_GE(step(), 0) << error();
    for (int k = 0; k < 3; ++k) {
      const double now = wrench.force[k] - before[k];
      if (i > 1) {
        EXPECT_LT(std::abs(now - step_before[k]), 400.0) << i << ' ' << k;
      }
      step_before[k] = now;
      before[k] = wrench.force[k];
    }
  }
}

TEST_F(CheckRail, FarFromItNothingChanges) {
  wheel.y = 1e-3;
  create();
  ASSERT_EQ(step(), WRC_OK) << error();
  const wrc_wrench with = wrench;
  ASSERT_EQ(wrench.region_count, 1);
  EXPECT_EQ(region(0).surface, 1);
  config.check_rail = test_config().check_rail;
  create();
  ASSERT_EQ(step(), WRC_OK);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(wrench.force[k], with.force[k], 2e-3 * with.normal_force) << k;
}

TEST_F(CheckRail, DerivativesSeeIt) {
  create();
  lean_on_check_rail(1.0);
  auto found = sized<wrc_wrench_derivatives>();
  ASSERT_GE(wrc_contact_wrench_derivatives(contact, &input, &wrench, &found), 0) << error();
  const double h = 1e-8, at = wheel.y;
  double ends[2];
  for (const int end : {0, 1}) {
    wheel.y = end == 0 ? at - h : at + h;
    ASSERT_GE(step(), 0);
    ends[end] = wrench.force[1];
  }
  const double slope = (ends[1] - ends[0]) / (2.0 * h);
  EXPECT_LT(slope, -1e8);
  EXPECT_NEAR(found.wrench[1][WRC_BY_Y], slope, 2e-3 * std::abs(slope));
}

/// Normal contact of two bodies of 12 and 0.0002 1/m is stiff: a micrometre is a kilonewton.
TEST_F(CheckRail, ExactlyTheFlangesBackIsPressedAsInRealTime) {
  wrc_exact_wrench_options options = wrc_exact_wrench_options_default();
  options.cell_x = options.cell_s = 4e-4;
  wrc_wrench exact = sized<wrc_wrench>(), rail_alone = exact;
  create();
  lean_on_check_rail(1.0);
  wheel.y -= 0.1e-3;
  EXPECT_EQ(wrc_exact_wrench(contact, &input, &options, &exact), WRC_FLAG_PATCH_AT_EDGE) << error();
  give_longer_back();
  const wrc_config both = config;
  // At 24 mrad the face is met 0.1 m behind the axle or ahead of it, where strips are 2.5 mm apart along the
  // track; above the axle the profile has ended.
  const struct {
    int32_t which;
    double yaw, deepest, within;
  } poses[] = {{WRC_SIDE_RIGHT, 5e-3, 12e-3, 0.01},
               {WRC_SIDE_LEFT, 5e-3, 12e-3, 0.01},
               {WRC_SIDE_RIGHT, -24e-3, 4e-3, 0.015},
               {WRC_SIDE_LEFT, 24e-3, 4e-3, 0.015}};
  for (const auto& [which, yaw, deepest, within] : poses) {
    SCOPED_TRACE(yaw);
    const double outward = which == WRC_SIDE_LEFT ? -1.0 : 1.0;
    wheel.velocity[1] = -0.05 * outward;
    wheel.yaw = yaw * outward;
    config = both;
    create(which);
    lean_on_check_rail(outward, deepest);
    ASSERT_EQ(step(), WRC_OK) << error();
    ASSERT_EQ(wrc_exact_wrench(contact, &input, &options, &exact), WRC_OK) << error();
    EXPECT_EQ(exact.region_count, 2);
    const double size = within * wrench.normal_force;
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(exact.force[k], wrench.force[k], size) << k;
      EXPECT_NEAR(exact.moment[k], wrench.moment[k], 0.75 * size) << k;
      EXPECT_NEAR(exact.rail_moment[k], wrench.rail_moment[k], 0.75 * size) << k;
    }
    EXPECT_NEAR(exact.normal_force, wrench.normal_force, size);
    EXPECT_NEAR(exact.power, wrench.power, 3.0 * within * wrench.power);
    // without it: the rest is what its region has
    const wrc_region check = region(0);
    config.check_rail = test_config().check_rail;
    create(which);
    ASSERT_EQ(wrc_exact_wrench(contact, &input, &options, &rail_alone), WRC_OK) << error();
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(exact.force[k] - rail_alone.force[k], check.force[k], 3.0 * within * check.normal_force)
          << k;
  }
}

/// The wheel held above the rail, so that the check rail alone is pressed. With strips of 0.5 mm the peak
/// pressures of these poses were off by up to 52 %.
TEST_F(CheckRail, PeakPressuresOnItsSteepFaceAreNearExactOnes) {
  wrc_exact_wrench_options options = wrc_exact_wrench_options_default();
  options.cell_x = options.cell_s = 3.5e-4;
  create();
  give_longer_back();
  wheel.z = -4e-3;
  const struct { double yaw, load; } poses[] = {{3e-3, 12e3}, {-12e-3, 60e3}, {24e-3, 20e3}};
  create();
  for (const auto& [yaw, load] : poses) {
    SCOPED_TRACE(yaw);
    wheel.yaw = yaw;
    double low = -7e-3, high = 0.0;
    for (int n = 0; n < 30; ++n) {
      wheel.y = 0.5 * (low + high);
      ASSERT_GE(step(), 0) << error();
      (wrench.normal_force > load ? low : high) = wheel.y;
    }
    wrc_wrench exact = sized<wrc_wrench>();
    ASSERT_EQ(wrc_exact_wrench(contact, &input, &options, &exact), WRC_OK) << error();
    EXPECT_NEAR(wrench.normal_force, load, 10.0);
    EXPECT_NEAR(wrench.normal_force, exact.normal_force, 0.02 * exact.normal_force);
    std::printf("yaw %.0f mrad: peak %.0f, exactly %.0f MPa\n", 1e3 * yaw, 1e-6 * wrench.peak_pressure,
                1e-6 * exact.peak_pressure);
    EXPECT_NEAR(wrench.peak_pressure, exact.peak_pressure, 0.1 * exact.peak_pressure);
  }
}

TEST_F(CheckRail, WhatIsWrongIsNamed) {
  const auto refused = [&](int32_t status, const std::vector<std::string>& words) {
    char text[300] = "";
    EXPECT_EQ(wrc_config_check(&config, text, sizeof text), status) << text;
    for (const std::string& word : words) EXPECT_NE(std::string(text).find(word), std::string::npos) << text;
  };
  const wrc_config good = config;
  refused(WRC_OK, {});
  config.check_rail.profile = sized<wrc_profile>();
  config.check_rail.profile.kind = WRC_PROFILE_S1002;
  refused(WRC_ERROR_PROFILE, {"config.check_rail.profile", "wheel profile"});
  config.check_rail.profile = sized<wrc_profile>();
  refused(WRC_ERROR_UNSUPPORTED, {"config.check_rail.y = -0.0813 m", "no check rail"});
  config = good;
  config.check_rail.y = -81.3;
  refused(WRC_ERROR_RANGE, {"config.check_rail.y", "mm"});
  config = good;
  config.roller_curvature = 2.0;
  refused(WRC_ERROR_UNSUPPORTED, {"config.check_rail", "roller"});
  config = good;
  config.normal.method = WRC_NORMAL_EKP;
  refused(WRC_ERROR_UNSUPPORTED, {"config.check_rail", "wrc_contact_wrench"});
  config = good;
  // a wheel whose points end at the flange's tip
  std::vector<double> y, z;
  for (int i = -55; i <= 60; ++i) {
    y.push_back(1e-3 * i);
    z.push_back(i < -30 ? -0.9e-3 * (i + 30) : 0.0);
  }
  config.wheel.kind = WRC_PROFILE_POINTS;
  config.wheel.count = static_cast<uint32_t>(y.size());
  config.wheel.y = y.data();
  config.wheel.z = z.data();
  refused(WRC_ERROR_PROFILE, {"config.wheel", "flange's back"});
  config = good;
  create();
  input.distance = 1.0;
  EXPECT_EQ(step(), WRC_ERROR_UNSUPPORTED);
  EXPECT_NE(error().find("input.distance"), std::string::npos) << error();
}

}  // namespace
