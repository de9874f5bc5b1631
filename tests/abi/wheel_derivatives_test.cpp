/// Derivatives of the wrench of a wheel on a rail, against central differences.
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "test_config.hpp"
#include "wheel_on_rail.hpp"
#include "wrench_inputs.hpp"

namespace {

/// Pressures are solved until a sweep moves a millionth of the area, and tables have intervals: differences
/// see that, most of them 1e-5 of the largest of a row. tools/wrench_derivatives prints how many see more.
constexpr double differences_see = 1e-3;

constexpr int rows = 6, columns = WRC_BY_VERTICAL_LOAD;

/// Those of any rail and wheel; the slopes' are compared with their own largest, as places' are meganewtons.
constexpr int slopes[] = {WRC_BY_RAIL_Y_SLOPE, WRC_BY_RAIL_Z_SLOPE};

/// S1002 on the benchmark UIC60 with a little of everything.
class WheelDerivatives : public testing::TestWithParam<int32_t>, protected PlacedWheel {
 protected:
  wrc_wrench_derivatives found = sized<wrc_wrench_derivatives>();

  WheelDerivatives() {
    friction.coefficient = 0.0;
    wheel.roll = -0.7e-3;
    wheel.yaw = 3e-3;
    wheel.velocity[1] = 0.03;
    wheel.velocity[2] = 0.02;
    wheel.angular_velocity[0] = 0.01;
    wheel.angular_velocity[1] = -20.0 / 0.46 * 1.001;
    wheel.angular_velocity[2] = 0.02;
    rail.y = 0.4e-3;
    rail.z = 0.3e-3;
    rail.roll = 2e-3;
    rail.y_velocity = 0.01;
    rail.z_velocity = -0.01;
    rail.roll_rate = 0.02;
  }
  void SetUp() override { create(GetParam()); }
  double* number(int column) { return &wrench_input(input, column); }
  static bool is_place(int column) { return column < 4 || (column >= 10 && column < 13); }

  /// At the lateral position, pressed by a load: the height is found, then given.
  void press(double y, double load) {
    wheel.y = y;
    const double coefficient = std::exchange(input.friction.coefficient, 0.0);
    input.damping = 0.0;
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = load;
    ASSERT_EQ(wrc_contact_wrench(contact, &input, &wrench), WRC_OK);
    wheel.z = wrench.z;
    input.prescribed = WRC_PRESCRIBE_HEIGHT;
    input.vertical_load = 0.0;
    input.friction.coefficient = coefficient;
  }

  /// The derivative of row r by a number, as a central difference with the step h.
  void differ(double& number, double h, int32_t status, double (&differences)[rows]) {
    const double value = number;
    wrc_wrench ends[2] = {wrench, wrench};
    for (int end = 0; end < 2; ++end) {
      number = value + (end == 0 ? -h : h);
      ASSERT_EQ(wrc_contact_wrench(contact, &input, &ends[end]), status);
    }
    number = value;
    const double width = (value + h) - (value - h);
    for (int r = 0; r < rows; ++r) {
      const auto of = [&](const wrc_wrench& w) { return r < 3 ? w.force[r] : w.moment[r - 3]; };
      differences[r] = (of(ends[1]) - of(ends[0])) / width;
    }
  }

  /// A column, against differences: over their largest among forces, or among moments, or a tenth of the
  /// normal force [N], [N m], by a radian or a whole factor.
  void expect_column(int column, const double (&differences)[rows], double tolerance) {
    for (int r = 0; r < rows; ++r) {
      double largest = 0.1 * wrench.normal_force;
      for (int i = r / 3 * 3; i < r / 3 * 3 + 3; ++i) largest = std::max(largest, std::fabs(differences[i]));
      EXPECT_NEAR(found.wrench[r][column], differences[r], tolerance * largest)
          << "row " << r << " column " << column;
    }
  }

  /// Errors of a column over the largest entries of their rows among columns of places, or of velocities.
  void expect_differences(double tolerance, int32_t status = WRC_OK) {
    ASSERT_EQ(wrc_contact_wrench_derivatives(contact, &input, &wrench, &found), status);
    double differences[rows][columns];
    for (int k = 0; k < columns; ++k) {
      if (k == WRC_BY_Z && input.prescribed == WRC_PRESCRIBE_VERTICAL_LOAD) continue;
      double column[rows];
      differ(*number(k), is_place(k) ? 1e-9 : 1e-7, status, column);
      for (int r = 0; r < rows; ++r) differences[r][k] = column[r];
    }
    for (const int k : slopes) {
      double column[rows];
      differ(*number(k), 1e-8, status, column);
      expect_column(k, column, tolerance);
    }
    for (int r = 0; r < rows; ++r)
      for (int k = 0; k < columns; ++k) {
        double largest = 1e-6;  // [N/m], ...: a row of zeros
        for (int c = 0; c < columns; ++c)
          if (is_place(c) == is_place(k)) largest = std::max(largest, std::fabs(differences[r][c]));
        EXPECT_NEAR(found.wrench[r][k], differences[r][k], tolerance * largest)
            << "row " << r << " column " << k;
      }
  }
};

TEST_P(WheelDerivatives, PressureFollowsThePose) {
  for (const double y : {-4e-3, 0.0, 5e-3, 6.5e-3}) {
    SCOPED_TRACE(y);
    const double outward = GetParam() == WRC_SIDE_RIGHT ? 1.0 : -1.0;
    press(outward * y, 60e3);
    input.damping = 0.1;
    expect_differences(differences_see);
  }
}

TEST_P(WheelDerivatives, CreepForcesFollowPoseAndMotion) {
  input.friction.coefficient = 0.3;
  for (const double y : {-4e-3, 0.0, 5e-3, 6.5e-3}) {
    SCOPED_TRACE(y);
    const double outward = GetParam() == WRC_SIDE_RIGHT ? 1.0 : -1.0;
    press(outward * y, 60e3);
    expect_differences(differences_see);
  }
}

TEST_P(WheelDerivatives, FrictionThatFallsAndALayer) {
  input.friction.coefficient = 0.3;
  input.friction.speed_law = WRC_SPEED_LAW_EXPONENTIAL;
  input.friction.slope_reduction = 0.5;
  wheel.velocity[1] = 0.1;
  press(0.0, 60e3);
  expect_differences(differences_see);
}

TEST_P(WheelDerivatives, ALayerThatShearsAndYields) {
  config.surface.tolerance = 1e-9;  // strips with a layer feel more of the pressures' last sweep
  create(GetParam());
  input.friction.coefficient = 0.3;
  input.friction.layer_thickness = 20e-6;
  input.friction.layer_modulus = 177e6;
  wheel.velocity[1] = 0.1;
  const double outward = GetParam() == WRC_SIDE_RIGHT ? 1.0 : -1.0;
  for (const double hardening : {0.0, 2e11, -5e11}) {
    input.friction.layer_yield = 120e6;
    input.friction.layer_hardening = hardening;
    for (const double at : {0.0, 6.5e-3}) {
      SCOPED_TRACE(testing::Message() << hardening << " " << at);
      press(outward * at, 60e3);
      expect_differences(1e-4);
    }
  }
}

TEST_P(WheelDerivatives, ZonesOnTheWheel) {
  const double y[] = {-0.06, -0.03, 0.0, 0.02}, coefficient[] = {0.1, 0.25, 0.4, 0.3};
  input.friction.zone_count = 4;
  input.friction.zone_y = y;
  input.friction.zone_coefficients = coefficient;
  input.friction.zone_frame = WRC_ZONES_WHEEL_PROFILE;
  wheel.velocity[1] = 0.1;
  const double outward = GetParam() == WRC_SIDE_RIGHT ? 1.0 : -1.0;
  for (const double at : {-4e-3, 6.5e-3}) {
    press(outward * at, 60e3);
    expect_differences(differences_see);
  }
}

TEST_P(WheelDerivatives, FrictionOverTemperature) {
  input.friction.coefficient = 0.4;
  input.friction.temperature_law = WRC_TEMPERATURE_LAW_LINEAR;
  const double outward = GetParam() == WRC_SIDE_RIGHT ? 1.0 : -1.0;
  for (const double way : {1.0, -1.0}) {
    wheel.velocity[0] = way * 40.0;
    for (const double slip : {0.003, 0.02}) {
      for (const double y : {0.0, 5e-3, 6.5e-3}) {
        SCOPED_TRACE(testing::Message() << way << ' ' << slip << ' ' << y);
        wheel.angular_velocity[1] = -wheel.velocity[0] / 0.46 * (1.0 + slip);
        press(outward * y, 60e3);
        expect_differences(differences_see);
      }
    }
  }
}

TEST_P(WheelDerivatives, FactorsOfSpeedAndTemperature) {
  const double y[] = {-0.06, -0.03, 0.0, 0.02}, coefficient[] = {0.1, 0.25, 0.4, 0.3};
  input.friction.coefficient = 0.4;
  input.friction.temperature_law = WRC_TEMPERATURE_LAW_LINEAR;
  input.friction.zone_y = y;
  input.friction.zone_coefficients = coefficient;
  input.friction.zone_frame = WRC_ZONES_WHEEL_PROFILE;
  const double outward = GetParam() == WRC_SIDE_RIGHT ? 1.0 : -1.0;
  for (const int32_t law : {WRC_SPEED_LAW_EXPONENTIAL, WRC_SPEED_LAW_HYPERBOLIC}) {
    for (const uint32_t zones : {0U, 4U}) {
      for (const double at : {0.0, 6.5e-3}) {
        SCOPED_TRACE(testing::Message() << law << ' ' << zones << ' ' << at);
        input.friction.speed_law = law;
        input.friction.zone_count = zones;
        wheel.angular_velocity[1] = -wheel.velocity[0] / 0.46 * 1.02;
        press(outward * at, 60e3);
        expect_differences(differences_see);
      }
    }
  }
}

TEST_P(WheelDerivatives, Backwards) {
  input.friction.coefficient = 0.3;
  wheel.velocity[0] = -20.0;
  wheel.angular_velocity[1] = 20.0 / 0.46 * 1.001;
  press(0.0, 60e3);
  expect_differences(differences_see);
}

TEST_P(WheelDerivatives, NearStandstillBothWaysHaveAShare) {
  input.friction.coefficient = 0.3;
  wheel.velocity[0] = 0.03;
  wheel.velocity[1] = 1e-4;
  wheel.angular_velocity[1] = -0.03 / 0.46 * 1.001;
  rail.y_velocity = rail.z_velocity = rail.roll_rate = 1e-4;
  wheel.velocity[2] = wheel.angular_velocity[0] = wheel.angular_velocity[2] = 1e-4;
  press(0.0, 60e3);
  expect_differences(differences_see, WRC_FLAG_CREEPAGES_LIMITED);
  input.friction.temperature_law = WRC_TEMPERATURE_LAW_LINEAR;
  expect_differences(differences_see, WRC_FLAG_CREEPAGES_LIMITED);
}

TEST_P(WheelDerivatives, StraightAhead) {
  input.friction.coefficient = 0.3;
  wheel.roll = wheel.yaw = rail.roll = 0.0;
  press(0.0, 60e3);
  expect_differences(differences_see);
}

TEST_P(WheelDerivatives, FiniteAtAnyPose) {
  input.friction.coefficient = 0.3;
  std::mt19937_64 random(3);
  const auto between = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  wrc_wrench alone = sized<wrc_wrench>();
  for (int i = 0; i < 300; ++i) {
    wheel.y = between(-15e-3, 15e-3);
    wheel.z = between(-3e-3, 3e-3);
    wheel.roll = between(-0.04, 0.04);
    wheel.yaw = between(-0.04, 0.04);
    wheel.velocity[0] = i % 10 == 0 ? 0.0 : between(-60.0, 60.0);
    wheel.angular_velocity[1] = i % 10 == 5 ? 0.0 : -wheel.velocity[0] / 0.46;
    input.damping = between(0.0, 1.0);
    const int32_t status = wrc_contact_wrench_derivatives(contact, &input, &wrench, &found);
    ASSERT_GE(status, WRC_OK);
    for (const auto& row : found.wrench)
      for (const double entry : row) ASSERT_TRUE(std::isfinite(entry)) << i;
    // what was differentiated is the wrench of the step, flag for flag
    const int32_t of_step = wrc_contact_wrench(contact, &input, &alone);
    if (status != WRC_FLAG_MORE_PATCHES) {
      ASSERT_EQ(status, of_step);
    }
    for (int k = 0; k < 3; ++k) ASSERT_EQ(wrench.moment[k], alone.moment[k]);
  }
}

TEST_P(WheelDerivatives, AxesAndReferenceOfTheHost) {
  wheel.reference = WRC_REFERENCE_WHEEL;
  wheel.angular_axes = WRC_AXES_BODY;
  press(2.2e-3, 80e3);
  input.damping = 0.1;
  expect_differences(differences_see);
}

/// Also where the wheelset turns and yaws much: rates are about axes that are not square to each other.
TEST_P(WheelDerivatives, ByRates) {
  input.friction.coefficient = 0.3;
  wheel.angular_axes = WRC_AXES_NONE;
  for (double& part : wheel.angular_velocity) part = 0.0;
  wheel.roll = 0.02;
  for (const double yaw : {2e-3, -0.03}) {
    wheel.yaw = yaw;
    wheel.roll_rate = 0.3;
    wheel.pitch_rate = -20.0 / 0.46 * 1.001;
    wheel.yaw_rate = -0.4;
    press(1e-3, 60e3);
    expect_differences(differences_see);
  }
}

TEST_P(WheelDerivatives, OnARailThatRunsAslant) {
  input.friction.coefficient = 0.3;
  input.damping = 0.1;
  for (const double way : {1.0, -1.0}) {
    wheel.reference = way > 0.0 ? WRC_REFERENCE_WHEELSET : WRC_REFERENCE_WHEEL;
    rail.y_slope = way * 0.02;
    rail.z_slope = 0.015;
    for (const double y : {-3e-3, 1e-3, 6e-3}) {
      SCOPED_TRACE(testing::Message() << way << ' ' << y);
      const double outward = GetParam() == WRC_SIDE_RIGHT ? 1.0 : -1.0;
      press(outward * y, 60e3);
      input.damping = 0.1;
      expect_differences(differences_see);
    }
  }
}

TEST_P(WheelDerivatives, ByAFactorOnFriction) {
  const double y[] = {-0.06, -0.03, 0.0, 0.02};
  double coefficient[4] = {};  // outlives the loop: input.friction points to it
  wheel.velocity[1] = 0.06;
  const double outward = GetParam() == WRC_SIDE_RIGHT ? 1.0 : -1.0;
  for (const int kind : {0, 1, 2})  // constant, falling with speed, with temperature
    for (const bool zones : {false, true})
      for (const double at : {0.0, 6.5e-3}) {
        SCOPED_TRACE(testing::Message() << kind << ' ' << zones << ' ' << at);
        press(outward * at, 60e3);
        wrc_wrench ends[2] = {wrench, wrench};
        constexpr double h = 1e-6;
        for (const double factor : {1.0 - h, 1.0 + h, 1.0}) {
          input.friction = wrc_friction_default();
          if (kind == 1) input.friction.speed_law = WRC_SPEED_LAW_EXPONENTIAL;
          if (kind == 2) input.friction.temperature_law = WRC_TEMPERATURE_LAW_LINEAR;
          input.friction.coefficient = 0.35 * factor;
          if (zones) {
            const double at_zones[] = {0.1, 0.25, 0.4, 0.3};
            for (int k = 0; k < 4; ++k) coefficient[k] = at_zones[k] * factor;
            input.friction.zone_count = 4;
            input.friction.zone_y = y;
            input.friction.zone_coefficients = coefficient;
            input.friction.zone_frame = WRC_ZONES_WHEEL_PROFILE;
          }
          if (factor != 1.0) {
            ASSERT_EQ(wrc_contact_wrench(contact, &input, &ends[factor > 1.0]), WRC_OK) << error();
          }
        }
        ASSERT_EQ(wrc_contact_wrench_derivatives(contact, &input, &wrench, &found), WRC_OK);
        double differences[rows];
        for (int r = 0; r < rows; ++r) {
          const auto of = [&](const wrc_wrench& w) { return r < 3 ? w.force[r] : w.moment[r - 3]; };
          differences[r] = (of(ends[1]) - of(ends[0])) / (2.0 * h);
        }
        EXPECT_GT(std::fabs(differences[1]), 100.0);  // [N]
        expect_column(WRC_BY_FRICTION, differences, differences_see);
      }
}

TEST_P(WheelDerivatives, OnlyByTheAxleOfARotation) {
  press(1e-3, 80e3);
  ASSERT_EQ(wrc_contact_wrench_derivatives(contact, &input, &wrench, &found), WRC_OK);
  const wrc_wrench_derivatives by_angles = found;
  const double cr = std::cos(wheel.roll), sr = std::sin(wheel.roll), cy = std::cos(wheel.yaw),
               sy = std::sin(wheel.yaw);
  const double rotation[9] = {cy, -sy, 0.0, cr * sy, cr * cy, -sr, sr * sy, sr * cy, cr};
  std::copy(rotation, rotation + 9, wheel.rotation);
  wheel.orientation = WRC_ORIENTATION_ROWS;
  wheel.roll = wheel.yaw = 0.0;
  ASSERT_EQ(wrc_contact_wrench_derivatives(contact, &input, &wrench, &found), WRC_OK);
  for (int r = 0; r < rows; ++r)
    for (int k = 0; k < columns; ++k)
      EXPECT_NEAR(found.wrench[r][k], by_angles.wrench[r][k],
                  1e-5 * std::fabs(by_angles.wrench[2][WRC_BY_Z]));
}

TEST_P(WheelDerivatives, TheHeightFollowsThePrescribedLoad) {
  press(1e-3, 80e3);
  ASSERT_EQ(wrc_contact_wrench_derivatives(contact, &input, &wrench, &found), WRC_OK);
  EXPECT_EQ(found.z[WRC_BY_Z], 1.0);
  EXPECT_EQ(found.wrench[2][WRC_BY_VERTICAL_LOAD], 0.0);
  const double stiffness = -found.wrench[2][WRC_BY_Z];
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 80e3;
  ASSERT_EQ(wrc_contact_wrench_derivatives(contact, &input, &wrench, &found), WRC_OK);
  EXPECT_NEAR(found.z[WRC_BY_VERTICAL_LOAD], 1.0 / stiffness, 1e-3 / stiffness);
  EXPECT_NEAR(found.wrench[2][WRC_BY_VERTICAL_LOAD], -1.0, 1e-12);
  EXPECT_NEAR(found.z[WRC_BY_RAIL_Z], 1.0, 1e-9);
  for (int r = 0; r < rows; ++r) EXPECT_EQ(found.wrench[r][WRC_BY_Z], 0.0);
  for (int k = 0; k < columns; ++k) EXPECT_NEAR(found.wrench[2][k], 0.0, 1e-9 * stiffness);
  // Loads are met to 1e-8, which at a stiffness of 1e9 N/m is 1e-12 m.
  const wrc_wrench_derivatives at_load = found;
  for (const int k : {WRC_BY_Y, WRC_BY_ROLL, WRC_BY_YAW, WRC_BY_RAIL_Y}) {
    const double value = *number(k), h = 1e-7;
    wrc_wrench ends[2] = {wrench, wrench};
    for (int end = 0; end < 2; ++end) {
      *number(k) = value + (end == 0 ? -h : h);
      ASSERT_EQ(wrc_contact_wrench(contact, &input, &ends[end]), WRC_OK);
    }
    *number(k) = value;
    EXPECT_NEAR(at_load.z[k], (ends[1].z - ends[0].z) / (2.0 * h), 2e-3 * std::fabs(at_load.z[WRC_BY_ROLL]))
        << k;
    EXPECT_NEAR(at_load.wrench[1][k], (ends[1].force[1] - ends[0].force[1]) / (2.0 * h), 2e-3 * stiffness)
        << k;
  }
}

TEST_P(WheelDerivatives, TheWrenchIsThatOfTheStep) {
  press(1e-3, 80e3);
  wrc_wrench alone = sized<wrc_wrench>();
  ASSERT_EQ(wrc_contact_wrench(contact, &input, &alone), WRC_OK);
  ASSERT_EQ(wrc_contact_wrench_derivatives(contact, &input, &wrench, nullptr), WRC_OK);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(wrench.force[i], alone.force[i]);
    EXPECT_EQ(wrench.moment[i], alone.moment[i]);
  }
  wheel.z = -0.05;
  EXPECT_EQ(wrc_contact_wrench_derivatives(contact, &input, nullptr, &found), WRC_FLAG_NO_CONTACT);
  for (const auto& row : found.wrench)
    for (const double entry : row) EXPECT_EQ(entry, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Sides, WheelDerivatives, testing::Values(WRC_SIDE_RIGHT, WRC_SIDE_LEFT));

}  // namespace
