/// A wheel on a rail, exactly: wrc_exact_wrench against the reference program, and beside wrc_contact_wrench.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "reference_contact.hpp"
#include "wheel_on_rail.hpp"
#include "wrc/wrc_offline.h"

namespace {

/// S1002 on the benchmark UIC60 as the reference results have them: frictionless, 80 kN.
class ExactWheel : public testing::Test, protected PlacedWheel {
 protected:
  wrc_exact_wrench_options options = wrc_exact_wrench_options_default();
  wrc_wrench fast = wrc_wrench_default();

  ExactWheel() {
    take_reference_bodies();
    friction.coefficient = 0.0;
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = 80e3;
    options.cell_x = options.cell_s = 4e-4;
  }
  void SetUp() override { create(); }
  int32_t solve() { return wrc_exact_wrench(contact, &input, &options, &wrench); }
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
    EXPECT_EQ(wrench.regions, fast.regions);
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
  wheel.velocity[0] = -20.0;
  expect(WRC_ERROR_RANGE, {"forwards"});
  wheel.velocity[0] = 20.0;
  wheel.y = 0.2;
  expect(WRC_ERROR_LOAD, {"input.vertical_load", "80000 N", "no rail"});
  wheel.y = 0.0;
  input.prescribed = WRC_PRESCRIBE_HEIGHT;
  input.vertical_load = 0.0;
  input.damping = 0.1;
  expect(WRC_ERROR_UNSUPPORTED, {"input.damping"});
  input.damping = 0.0;
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
