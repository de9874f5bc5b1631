/// A wheel on a rail, exactly: wrc_exact_wrench against the reference program, and beside wrc_contact_wrench.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "offline_helpers.hpp"
#include "reference_contact.hpp"
#include "test_config.hpp"
#include "wheel_on_rail.hpp"
#include "wrc/wrc_offline.h"

namespace {

/// S1002 on the benchmark UIC60 as the reference results have them: frictionless, 80 kN.
class ExactWheel : public testing::Test, protected PlacedWheel {
 protected:
  wrc_exact_wrench_options options = wrc_exact_wrench_options_default();
  wrc_wrench fast = sized<wrc_wrench>();

  ExactWheel() {
    take_reference_bodies();
    friction.coefficient = 0.0;
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = 80e3;
    options.cell_x = options.cell_s = 4e-4;
  }
  void SetUp() override { create(); }
  int32_t solve() { return wrc_exact_wrench(contact, &input, &options, &wrench); }
  /// The height of the load, undamped, as real time has it.
  void prescribe_height() {
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = 80e3;
    input.damping = 0.0;
    ASSERT_GE(wrc_contact_wrench(contact, &input, &fast), 0) << error();
    input.prescribed = WRC_PRESCRIBE_HEIGHT;
    input.vertical_load = 0.0;
    wheel.z = fast.z;
  }
  /// Both ways, and that they agree within that share of friction times load, 0.3 * 80 kN.
  void expect_as_real_time(double share, int32_t status = WRC_OK) {
    ASSERT_EQ(solve(), status) << error();
    ASSERT_EQ(wrc_contact_wrench(contact, &input, &fast), status) << error();
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(wrench.force[i], fast.force[i], share * 24e3) << i;
  }
};

// CONTACT 25.2, conformal with turned coefficients, 0.2 mm, without friction: lateral force at 80 kN.
TEST_F(ExactWheel, LateralForcesAreThoseOfConformalTheory) {
  const struct {
    double y, yaw, force;
  } cases[] = {{2e-3, 0.0, 6157.0}, {5.3e-3, 0.0, 20368.0}, {6e-3, 0.0, 30866.0}, {5.3e-3, 0.01, 19854.0}};
  for (const auto& each : cases) {
    wheel.y = each.y;
    wheel.yaw = each.yaw;
    ASSERT_EQ(solve(), WRC_OK) << error();
    EXPECT_NEAR(std::abs(wrench.force[1]) / each.force, 1.0, 4e-3) << each.y;
    EXPECT_NEAR(wrench.force[2], -80e3, 10.0);
    EXPECT_EQ(wrench.power, 0.0);
  }
}

TEST_F(ExactWheel, IsNearTheRealTimeSolutionOfTheSamePose) {
  friction = wrc_friction_default();
  wheel.y = 3e-3;
  wheel.yaw = 2e-3;
  for (const int32_t which : {WRC_SIDE_RIGHT, WRC_SIDE_LEFT}) {
    take(which);
    ASSERT_EQ(solve(), WRC_OK) << error();
    ASSERT_EQ(wrc_contact_wrench(contact, &input, &fast), WRC_OK) << error();
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(wrench.force[i], fast.force[i], 0.01 * 80e3) << i;
      EXPECT_NEAR(wrench.moment[i], fast.moment[i], 0.01 * 80e3 * 0.75) << i;
      EXPECT_NEAR(wrench.rail_moment[i], fast.rail_moment[i], 0.01 * 80e3 * 0.75) << i;
    }
    EXPECT_NEAR(wrench.z, fast.z, 1e-6);
    EXPECT_NEAR(wrench.peak_pressure / fast.peak_pressure, 1.0, 0.02);
    EXPECT_NEAR(wrench.normal_force / fast.normal_force, 1.0, 0.01);
    EXPECT_NEAR(wrench.power / fast.power, 1.0, 0.1);
    EXPECT_EQ(wrench.region_count, fast.region_count);
  }
}

// The mirror image of a pose has the mirror image of the wrench; the height found gives the load it came of.
TEST_F(ExactWheel, SidesAreMirrorImagesAndHeightGivesTheLoadBack) {
  friction = wrc_friction_default();
  wheel.y = 5e-3;
  wheel.yaw = 3e-3;
  wheel.angular_velocity[2] = 0.02;
  ASSERT_EQ(solve(), WRC_OK) << error();
  const wrc_wrench right = wrench;
  take(WRC_SIDE_LEFT);
  wheel.y = -5e-3;
  wheel.yaw = -3e-3;
  wheel.angular_velocity[2] = -0.02;
  ASSERT_EQ(solve(), WRC_OK) << error();
  for (int i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(wrench.force[i], i == 1 ? -right.force[i] : right.force[i]);
    EXPECT_DOUBLE_EQ(wrench.moment[i], i == 1 ? right.moment[i] : -right.moment[i]);
  }
  input.prescribed = WRC_PRESCRIBE_HEIGHT;
  input.vertical_load = 0.0;
  wheel.z = wrench.z;
  ASSERT_EQ(solve(), WRC_OK) << error();
  EXPECT_NEAR(wrench.force[2] / -80e3, 1.0, 1e-4);
  EXPECT_EQ(wrench.z, wheel.z);
}

TEST_F(ExactWheel, ZonesOfEqualFrictionAreNoZonesAndOthersLieOnTheRail) {
  friction = wrc_friction_default();
  wheel.y = 1e-3;
  wheel.yaw = 4e-3;
  wheel.velocity[1] = 0.03;
  prescribe_height();
  ASSERT_EQ(solve(), WRC_OK) << error();
  const wrc_wrench plain = wrench;
  const double y[] = {-0.01, 0.004}, alike[] = {0.3, 0.3}, greased[] = {0.08, 0.4};
  friction.zone_count = 2;
  friction.zone_y = y;
  friction.zone_coefficients = alike;
  friction.zone_frame = WRC_ZONES_RAIL_PROFILE;
  ASSERT_EQ(solve(), WRC_OK) << error();
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(wrench.force[i], plain.force[i], 1e-6 * 80e3) << i;
  friction.zone_coefficients = greased;
  for (const int32_t which : {WRC_SIDE_RIGHT, WRC_SIDE_LEFT}) {
    const double outward = which == WRC_SIDE_RIGHT ? 1.0 : -1.0;
    take(which);
    wheel.y = outward * 1e-3;
    wheel.yaw = outward * 4e-3;
    wheel.velocity[1] = outward * 0.03;
    expect_as_real_time(0.02);
    EXPECT_GT(
        std::abs(wrench.force[0] - plain.force[0]) + std::abs(wrench.force[1] - outward * plain.force[1]),
        0.1 * 24e3);
  }
  // those on the wheel are those on the rail that lie under them
  wrc_region region = sized<wrc_region>();
  ASSERT_EQ(wrc_contact_region(contact, 0, &region), WRC_OK);
  const wrc_wrench on_rail = wrench;
  const double apart = region.y_wheel - region.y_rail, wheel_y[] = {y[0] + apart, y[1] + apart};
  ASSERT_GT(std::abs(apart), 0.5e-3);
  friction.zone_y = wheel_y;
  friction.zone_frame = WRC_ZONES_WHEEL_PROFILE;
  expect_as_real_time(0.02);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(wrench.force[i], on_rail.force[i], 2e-3 * 24e3) << i;
}

/// A wheel that slides as a whole by a fifth of its speed: Polach's law at the speed of sliding.
TEST_F(ExactWheel, FrictionFallsWithTheSlidingSpeed) {
  friction = wrc_friction_default();
  friction.speed_law = WRC_SPEED_LAW_EXPONENTIAL;
  const double sliding = 4.0, A = friction.kinetic_ratio, B = friction.fall_rate;
  wheel.angular_velocity[1] *= 0.8;
  prescribe_height();
  ASSERT_EQ(solve(), WRC_OK) << error();
  const double coefficient = friction.coefficient * ((1.0 - A) * std::exp(-B * sliding) + A);
  EXPECT_NEAR(wrench.force[0] / wrench.normal_force, -coefficient, 2e-3 * coefficient);
  EXPECT_NEAR(wrench.power, -wrench.force[0] * sliding, 5e-3 * wrench.power);
  wheel.angular_velocity[1] *= 0.998 / 0.8;
  expect_as_real_time(0.015);
}

/// x, yaw and the turning about y and z change sign in a mirror across the axle.
TEST_F(ExactWheel, BackwardsIsTheMirrorImageOfForwards) {
  friction = wrc_friction_default();
  friction.speed_law = WRC_SPEED_LAW_EXPONENTIAL;
  wheel.y = 5e-3;
  wheel.yaw = 4e-3;
  wheel.velocity[1] = 0.02;
  prescribe_height();
  ASSERT_EQ(solve(), WRC_OK) << error();
  const wrc_wrench forwards = wrench;
  wheel.yaw *= -1.0;
  wheel.velocity[0] *= -1.0;
  wheel.angular_velocity[1] *= -1.0;
  expect_as_real_time(0.03);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(wrench.force[i], i == 0 ? -forwards.force[i] : forwards.force[i], 1e-4 * 24e3) << i;
    EXPECT_NEAR(wrench.moment[i], i == 0 ? forwards.moment[i] : -forwards.moment[i], 1e-4 * 24e3) << i;
  }
  EXPECT_NEAR(wrench.power, forwards.power, 1e-3 * wrench.power);
  EXPECT_GT(wrench.power, 0.0);
}

/// Below 0.1 m/s both ways are blended; at rest what changes sign with the way is gone.
TEST_F(ExactWheel, GoesThroughStandstillAsRealTimeDoes) {
  friction = wrc_friction_default();
  const double rolling = 1.0 / 0.46;
  const auto move = [&](double speed) {
    wheel.velocity[0] = speed;
    wheel.velocity[1] = 2e-5;
    wheel.angular_velocity[1] = -rolling * (speed + 4e-5);
  };
  move(0.2);
  prescribe_height();
  for (const double speed : {0.0, -0.03}) {
    move(speed);
    expect_as_real_time(0.015, WRC_FLAG_CREEPAGES_LIMITED);
  }
  move(0.1 - 2e-4);
  ASSERT_EQ(solve(), WRC_FLAG_CREEPAGES_LIMITED);
  const wrc_wrench below = wrench;
  move(0.1 + 2e-4);
  ASSERT_EQ(solve(), WRC_OK) << error();
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(wrench.force[i], below.force[i], 4e-3 * 24e3) << i;
}

/// A wheel that rolls freely and comes down at 0.2 m/s: its whole wrench grows by 1 + 1.5 * 0.5 * 0.2. One
/// that lifts at 2 m/s is let go.
TEST_F(ExactWheel, DampingIsHuntAndCrossleysAndRealTimes) {
  prescribe_height();
  ASSERT_EQ(solve(), WRC_OK) << error();
  const wrc_wrench still = wrench;
  input.damping = 0.5;
  ASSERT_EQ(solve(), WRC_OK) << error();
  EXPECT_NEAR(wrench.force[2], still.force[2], 2e-4 * 80e3);  // pressure is not in the very middle
  const double undamped = wrench.force[2];
  wheel.velocity[2] = 0.2;
  ASSERT_EQ(solve(), WRC_OK) << error();
  EXPECT_NEAR(wrench.force[2] / undamped, 1.0 + 1.5 * 0.5 * 0.2, 2e-3);
  EXPECT_NEAR(wrench.peak_pressure / still.peak_pressure, 1.15, 2e-3);
  EXPECT_EQ(wrench.area, still.area);
  friction = wrc_friction_default();
  wheel.velocity[2] = 0.0;
  wheel.y = 5e-3;  // up to 22 degrees, each row with its own speed
  wheel.velocity[1] = 0.1;
  prescribe_height();
  input.damping = 0.5;
  wheel.velocity[2] = 0.2;
  expect_as_real_time(0.015);
  EXPECT_GT(wrench.normal_force, 1.1 * 80e3);
  wheel.velocity[2] = -2.0;
  ASSERT_EQ(solve(), WRC_OK) << error();
  for (const double force : wrench.force) EXPECT_EQ(force, 0.0);
  EXPECT_EQ(wrench.power, 0.0);
}

TEST_F(ExactWheel, TellsItsProgressAndIsCancelled) {
  friction = wrc_friction_default();
  options.cell_x = options.cell_s = 8e-4;
  offline_helpers::Listener listener;
  options.progress = offline_helpers::Listener::hear;
  options.user = &listener;
  ASSERT_EQ(solve(), WRC_OK) << error();
  ASSERT_GT(listener.fractions.size(), 20U);
  for (std::size_t k = 1; k < listener.fractions.size(); ++k)
    EXPECT_GE(listener.fractions[k], listener.fractions[k - 1]);
  EXPECT_LT(listener.fractions.front(), 0.05);
  EXPECT_GT(listener.fractions.back(), 0.5);
  EXPECT_LE(listener.fractions.back(), 1.0);
  const std::size_t all = listener.fractions.size();
  for (const std::size_t allowed : {std::size_t{0}, all / 2, all - 1}) {
    listener = {};
    listener.allowed = static_cast<int>(allowed);
    wrench.force[2] = 1.0;
    EXPECT_EQ(solve(), WRC_ERROR_CANCELLED);
    EXPECT_EQ(wrench.force[2], 0.0);
    EXPECT_EQ(listener.fractions.size(), allowed + 1);
  }
}

/// Parameters of laws and slopes that are not chosen, or of methods that it is not.
TEST_F(ExactWheel, WhatItDoesNotReadChangesNoBit) {
  friction = wrc_friction_default();
  options.cell_x = options.cell_s = 8e-4;
  ASSERT_EQ(solve(), WRC_OK) << error();
  const wrc_wrench plain = wrench;
  friction.slope_fall = 0.5;
  friction.slope_limit = 0.1;
  friction.kinetic_ratio = 0.7;
  friction.hot_ratio = 0.2;
  ASSERT_EQ(solve(), WRC_OK) << error();
  EXPECT_EQ(std::memcmp(&wrench, &plain, sizeof plain), 0);
  friction.speed_law = WRC_SPEED_LAW_EXPONENTIAL;
  ASSERT_EQ(solve(), WRC_OK) << error();
  EXPECT_NE(wrench.force[0], plain.force[0]);
}

TEST_F(ExactWheel, RefusesWhatItCannotSolve) {
  const auto expect = [&](int32_t status, const std::vector<std::string>& words) {
    wrench.force[2] = 1.0;
    EXPECT_EQ(solve(), status) << error();
    EXPECT_EQ(wrench.force[2], 0.0);
    ReferenceWheel::expect_words(error(), words);
  };
  options.cell_s = 0.4;
  expect(WRC_ERROR_RANGE, {"options.cell_s", "0.4", "mm"});
  options.cell_s = std::numeric_limits<double>::quiet_NaN();
  expect(WRC_ERROR_NOT_FINITE, {"options.cell_s"});
  options.cell_s = 4e-4;
  options.influence = 2;
  expect(WRC_ERROR_UNSUPPORTED, {"options.influence = 2", "WRC_INFLUENCE_TURNED (0), _PLAIN (1)"});
  options.influence = WRC_INFLUENCE_TURNED;
  friction = wrc_friction_default();
  friction.temperature_law = WRC_TEMPERATURE_LAW_LINEAR;
  expect(WRC_ERROR_UNSUPPORTED, {"input.friction.temperature_law = 1", "no temperatures"});
  friction.temperature_law = WRC_TEMPERATURE_LAW_NONE;
  wheel.y = 0.2;
  expect(WRC_ERROR_LOAD, {"input.vertical_load", "80000 N", "no rail"});
  wheel.y = 0.0;
  input.prescribed = WRC_PRESCRIBE_HEIGHT;
  input.vertical_load = 0.0;
  wheel.z = 0.02;
  options.cell_x = 2e-5;
  expect(WRC_ERROR_RANGE, {"cells"});
  wheel.z = -0.02;
  EXPECT_EQ(solve(), WRC_FLAG_NO_CONTACT);
  EXPECT_EQ(wrench.force[2], 0.0);
  EXPECT_EQ(wrc_exact_wrench(contact, nullptr, nullptr, &wrench), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_exact_wrench(nullptr, &input, nullptr, &wrench), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_exact_wrench(contact, &input, nullptr, nullptr), WRC_ERROR_NULL);
}

}  // namespace
