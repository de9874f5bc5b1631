/// First tries of someone who gives a wheel its motion from the header alone: the right force, or a sentence.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "reference_contact.hpp"
#include "test_config.hpp"
#include "vectors.hpp"
#include "wheel_on_rail.hpp"
#include "wrc/wrc_offline.h"

namespace {

/// S1002 on 60E1 at 1:40, 80 kN, 20 m/s, nose 5 mrad to the right, mu 0.35.
class NaturalMotion : public testing::Test, protected PlacedWheel {
 protected:
  static constexpr double rolling = -20.0 / 0.46;
  /// With the turning about its own axle: N and W (wrc_contact_wrench with WRC_AXES_BODY as it was in 0.2).
  static constexpr double lateral = 24.84e3, power = 2779.0;

  NaturalMotion() {
    config.rail.kind = WRC_PROFILE_60E1;
    config.track.rail_inclination = 1.0 / 40.0;
    friction.coefficient = 0.35;
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = 80e3;
    wheel = sized<wrc_wheel_state>();
    wheel.velocity[0] = 20.0;
    wheel.yaw = 5e-3;
  }
  void SetUp() override { create(); }
  void expect_the_force() {
    ASSERT_EQ(step(), WRC_OK) << error();
    EXPECT_NEAR(wrench.force[1], lateral, 10.0);
    EXPECT_NEAR(wrench.power, power, 1.0);
  }
  void expect_refused(const std::vector<std::string>& words) {
    EXPECT_LT(step(), 0);
    ReferenceWheel::expect_words(error(), words);
    EXPECT_EQ(wrench.force[1], 0.0);
  }
  void give(const Matrix& matrix, int32_t orientation) {
    wheel.orientation = orientation;
    put_matrix(matrix, wheel.rotation);
    wheel.roll = wheel.yaw = 0.0;
  }
  static void put_matrix(const Matrix& matrix, double* to) { std::copy(matrix.begin(), matrix.end(), to); }
};

TEST_F(NaturalMotion, AVectorOfNoAxesIsRefused) {
  wheel.angular_velocity[1] = rolling;
  expect_refused({"input.wheel.angular_velocity[1] = -43.4783 rad/s",
                  "WRC_AXES_TRACK (components along x, y, z of the track)",
                  "WRC_AXES_BODY (y along the axle)", "pitch_rate = -v / r0"});
  wheel.angular_axes = WRC_AXES_BODY;
  expect_the_force();
  wheel.angular_axes = WRC_AXES_TRACK;
  put(about_z(5e-3) * Vector{0.0, rolling, 0.0}, wheel.angular_velocity);
  expect_the_force();
}

TEST_F(NaturalMotion, ThePitchRateIsAboutTheAxle) {
  wheel.pitch_rate = rolling;
  expect_the_force();
  wheel.angular_velocity[2] = 0.01;
  expect_refused({"angular_velocity[2]", "pitch_rate"});
  wheel.angular_axes = WRC_AXES_TRACK;
  expect_refused({"input.wheel.pitch_rate", "not both", "WRC_AXES_NONE"});
}

/// Rates against the vector that they make, which a host that differentiates its own R would have.
TEST_F(NaturalMotion, RatesAreThoseOfRollPitchAndYaw) {
  friction.coefficient = 0.3;
  for (const int32_t which : {WRC_SIDE_RIGHT, WRC_SIDE_LEFT}) {
    take(which);
    wheel = sized<wrc_wheel_state>();
    wheel.velocity[0] = 20.0;
    wheel.roll = 0.02;
    wheel.yaw = -0.03;
    wheel.roll_rate = 0.4;
    wheel.pitch_rate = rolling;
    wheel.yaw_rate = -0.7;
    ASSERT_EQ(step(), WRC_OK) << error();
    const wrc_wrench by_rates = wrench;
    constexpr double h = 1e-6;
    const auto rotation = [&](double t) {
      return about_x(wheel.roll + wheel.roll_rate * t) * about_z(wheel.yaw + wheel.yaw_rate * t) *
             about_y(wheel.pitch_rate * t);
    };
    const Matrix ahead = rotation(h), behind = rotation(-h), back = transposed(rotation(0.0));
    Matrix change{};
    for (std::size_t i = 0; i < 9; ++i) change[i] = (ahead[i] - behind[i]) / (2.0 * h);
    const Matrix turning = change * back;  // of omega x
    wheel.roll_rate = wheel.pitch_rate = wheel.yaw_rate = 0.0;
    wheel.angular_axes = WRC_AXES_TRACK;
    put({turning[7], turning[2], turning[3]}, wheel.angular_velocity);
    ASSERT_EQ(step(), WRC_OK) << error();
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(wrench.force[i], by_rates.force[i], 1e-6 * by_rates.normal_force);
      EXPECT_NEAR(wrench.moment[i], by_rates.moment[i], 1e-6 * by_rates.normal_force);
    }
    wheel.angular_axes =
        WRC_AXES_BODY;  // not the same: the axes of roll and yaw are not square to each other
    put({0.4, rolling, -0.7}, wheel.angular_velocity);
    ASSERT_EQ(step(), WRC_OK) << error();
    EXPECT_GT(std::fabs(wrench.force[0] - by_rates.force[0]), 1e-3);
  }
}

TEST_F(NaturalMotion, ARotationOfNoOrderIsRefused) {
  wheel.pitch_rate = rolling;
  wheel.yaw = 0.0;
  const Matrix rotation = about_z(5e-3);
  put_matrix(rotation, wheel.rotation);
  expect_refused({"input.wheel.rotation[0]", "WRC_ORIENTATION_ROWS", "WRC_ORIENTATION_COLUMNS"});
  give(rotation, WRC_ORIENTATION_ROWS);
  expect_the_force();
  give(transposed(rotation), WRC_ORIENTATION_COLUMNS);
  expect_the_force();
  wheel.yaw = 5e-3;
  expect_refused({"input.wheel.yaw", "not both"});
  wheel = sized<wrc_wheel_state>();
  wheel.orientation = WRC_ORIENTATION_ROWS;  // and no matrix
  expect_refused({"no rotation"});
}

TEST_F(NaturalMotion, ATransposeIsFlagged) {
  const Matrix rotation = about_x(1e-3) * about_z(5e-3);
  wheel.angular_axes = WRC_AXES_TRACK;
  put(rotation * Vector{0.0, rolling, 0.0}, wheel.angular_velocity);
  give(rotation, WRC_ORIENTATION_ROWS);
  EXPECT_EQ(step(), WRC_OK) << error();
  give(transposed(rotation), WRC_ORIENTATION_ROWS);
  EXPECT_EQ(step(), WRC_FLAG_ROTATION_TRANSPOSED);
  ReferenceWheel::expect_words(
      error(), {"along the axle of the transpose of input.wheel.rotation", "did you pass its columns?"});
  EXPECT_GT(wrench.normal_force, 0.0);  // a flag: a wheel may move like that
  auto found = sized<wrc_wrench_derivatives>();
  EXPECT_EQ(wrc_contact_wrench_derivatives(contact, &input, &wrench, &found), WRC_FLAG_ROTATION_TRANSPOSED);
  wrc_exact_wrench_options options = wrc_exact_wrench_options_default();
  options.cell_x = options.cell_s = 1e-3;
  EXPECT_EQ(wrc_exact_wrench(contact, &input, &options, &wrench), WRC_FLAG_ROTATION_TRANSPOSED);
  give(rotation, WRC_ORIENTATION_COLUMNS);
  EXPECT_EQ(step(), WRC_FLAG_ROTATION_TRANSPOSED);
  ReferenceWheel::expect_words(error(), {"did you pass its rows?"});
  // any other flag is graver
  input.prescribed = WRC_PRESCRIBE_HEIGHT;
  input.vertical_load = 0.0;
  wheel.z = -0.01;
  EXPECT_EQ(step(), WRC_FLAG_NO_CONTACT);
}

TEST_F(NaturalMotion, ATurnAgainstTheTravelIsFlagged) {
  for (const double y : {0.0, 3e-3, 6.5e-3}) {
    wheel.y = y;
    wheel.pitch_rate = rolling;
    EXPECT_EQ(step(), WRC_OK) << error();
    wheel.pitch_rate = -rolling;
    EXPECT_EQ(step(), WRC_FLAG_CREEPAGES_LIMITED) << y;
    ReferenceWheel::expect_words(error(), {"turns against its travel", "pitch_rate is -v / r0"});
    EXPECT_GT(wrench.normal_force, 0.0);
    // locked, spinning and creeping wheels turn as they may
    for (const double turning : {0.0, 0.5 * rolling, 3.0 * rolling}) {
      wheel.pitch_rate = turning;
      EXPECT_EQ(step(), WRC_OK) << error();
    }
  }
}

/// What wheels do is not taken for a transpose: yawing, sliding with the nose aside, creeping, standing.
TEST_F(NaturalMotion, RealMotionsAreNoTransposes) {
  wheel.angular_axes = WRC_AXES_TRACK;
  for (const double yaw : {0.0, 1e-4, 5e-3, -0.03}) {
    const Matrix rotation = about_x(-2e-3) * about_z(yaw);
    for (const double yaw_rate : {0.0, 0.02, -0.5})
      for (const double turning : {rolling, 0.5 * rolling, 0.0}) {
        give(rotation, WRC_ORIENTATION_ROWS);
        put(rotation * Vector{0.01, turning, yaw_rate}, wheel.angular_velocity);
        EXPECT_EQ(step(), WRC_OK) << yaw << ' ' << yaw_rate << ' ' << turning << ' ' << error();
      }
  }
}

/// A rail 1 mrad aslant, at rest: a wheel that rolls straight on has no lateral creepage on it, and one that
/// follows it has the force it has on a straight rail. Speed times slope as the material's velocity has 11
/// kN.
TEST_F(NaturalMotion, SpeedTimesSlopeIsNoVelocityOfTheRail) {
  wheel.yaw = 0.0;
  wheel.pitch_rate = rolling;
  ASSERT_EQ(step(), WRC_OK) << error();
  const wrc_wrench straight = wrench;
  constexpr double slope = 1e-3;
  rail.y_slope = slope;
  ASSERT_EQ(step(), WRC_OK) << error();
  EXPECT_NEAR(wrench.force[1], straight.force[1], 50.0);
  wheel.yaw = slope;
  wheel.velocity[1] = 20.0 * slope;
  ASSERT_EQ(step(), WRC_OK) << error();
  EXPECT_NEAR(wrench.force[1], straight.force[1] + slope * straight.force[0], 0.3);
  EXPECT_NEAR(wrench.force[0], straight.force[0], 10.0);  // its way is longer than 20 m/s by half a millionth
  wheel.yaw = wheel.velocity[1] = rail.y_slope = 0.0;
  rail.y_velocity = 20.0 * slope;
  ASSERT_EQ(step(), WRC_OK) << error();
  EXPECT_GT(wrench.force[1], straight.force[1] + 10e3);
  rail.y_velocity = 0.0;
  rail.y_slope = 0.5;
  expect_refused({"input.rail.y_slope = 0.5", "velocity"});
}

}  // namespace
