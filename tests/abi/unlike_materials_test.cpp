/// Wheel and rail of different materials: the combined constants, the slip by pressure, and the flag.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "test_config.hpp"
#include "wheel_on_rail.hpp"
#include "wrc/wrc_offline.h"

namespace {

class UnlikeMaterials : public testing::Test, protected PlacedWheel {
 protected:
  void create_flagged() {
    wrc_contact_destroy(contact);
    wrc_model_destroy(model);
    contact = nullptr;
    ASSERT_EQ(wrc_model_create(&config, nullptr, &model, nullptr, 0), WRC_FLAG_DISSIMILAR_MATERIALS);
    take(WRC_SIDE_RIGHT);
  }
};

TEST_F(UnlikeMaterials, AreTheCombinedMaterial) {
  wheel.y = 3e-3;
  wheel.z = 100e-6;
  wheel.velocity[1] = 0.02;
  config.wheel_material.shear_modulus = 90e9;
  config.wheel_material.poisson = 0.30;
  config.rail_material.shear_modulus = 60e9;
  config.rail_material.poisson = 0.24;
  char text[256];
  EXPECT_EQ(wrc_config_check(&config, text, sizeof text), WRC_FLAG_DISSIMILAR_MATERIALS);
  const double combined = 72e9;
  const double coupling = 0.25 * combined * (0.4 / 90e9 - 0.52 / 60e9);  // -0.076
  const std::string sentence(text);
  ASSERT_NE(sentence.find("K = "), std::string::npos) << sentence;
  EXPECT_NEAR(std::stod(sentence.substr(sentence.find("K = ") + 4)), coupling, 1e-4) << sentence;
  create_flagged();
  ASSERT_EQ(step(), WRC_OK);
  const wrc_wrench unlike = wrench;
  config.wheel_material.shear_modulus = config.rail_material.shear_modulus = combined;
  config.wheel_material.poisson = config.rail_material.poisson = 0.5 * combined * (0.30 / 90e9 + 0.24 / 60e9);
  create();
  ASSERT_EQ(step(), WRC_OK);
  EXPECT_NEAR(unlike.normal_force, wrench.normal_force, 1e-9 * wrench.normal_force);
  // K drives the stiffer wheel forwards
  EXPECT_GT(unlike.force[0], wrench.force[0] + 0.02 * wrench.normal_force);
}

/// K < 0: free rolling without slip would creep by -4 K p0 / (pi G) > 0 in line contact; at less than that
/// the wheel is driven forwards. Exchanged bodies do the opposite.
TEST_F(UnlikeMaterials, TheWheelCreepsWhereTheyCouple) {
  friction.coefficient = 1.0;
  wheel.y = 1e-3;
  wheel.z = 150e-6;
  double force[3] = {}, strips[3] = {};
  wrc_exact_wrench_options options = wrc_exact_wrench_options_default();
  options.cell_x = options.cell_s = 2e-4;
  const struct {
    double shear, poisson, rail_shear, rail_poisson;
  } bodies[3] = {{90e9, 0.30, 60e9, 0.24}, {60e9, 0.24, 90e9, 0.30}, {72e9, 0.264, 72e9, 0.264}};
  for (int k = 0; k < 3; ++k) {
    config.wheel_material.shear_modulus = bodies[k].shear;
    config.wheel_material.poisson = bodies[k].poisson;
    config.rail_material.shear_modulus = bodies[k].rail_shear;
    config.rail_material.poisson = bodies[k].rail_poisson;
    if (k < 2) {
      create_flagged();
    } else {
      create();
    }
    ASSERT_EQ(step(), WRC_OK);
    strips[k] = wrench.force[0];
    ASSERT_EQ(wrc_exact_wrench(contact, &input, &options, &wrench), WRC_OK);
    force[k] = wrench.force[0];
  }
  EXPECT_GT(force[0], force[2] + 200.0);
  EXPECT_NEAR(force[0] - force[2], force[2] - force[1], 0.12 * std::abs(force[0] - force[2]));
  for (int k = 0; k < 2; ++k)
    EXPECT_NEAR(strips[k] - strips[2], force[k] - force[2], 0.2 * std::abs(force[k] - force[2]));
}

/// Derivatives by height and by the wheel's turning beside central differences.
TEST_F(UnlikeMaterials, DerivativesIncludeTheirSlip) {
  config.wheel_material.shear_modulus = 90e9;
  config.rail_material.shear_modulus = 60e9;
  wheel.y = 1e-3;
  wheel.z = 150e-6;
  wheel.velocity[1] = 0.01;
  create_flagged();
  wrc_wrench_derivatives found = sized<wrc_wrench_derivatives>();
  ASSERT_EQ(wrc_contact_wrench_derivatives(contact, &input, &wrench, &found), WRC_OK);
  const auto difference = [&](double& of, double step_of, int row) {
    const double at = of;
    double force[2];
    for (int k = 0; k < 2; ++k) {
      of = at + (k ? step_of : -step_of);
      EXPECT_EQ(step(), WRC_OK);
      force[k] = wrench.force[row];
    }
    of = at;
    return (force[1] - force[0]) / (2.0 * step_of);
  };
  for (int row = 0; row < 2; ++row) {
    const double by_z = difference(wheel.z, 1e-9, row);
    const double by_turning = difference(wheel.angular_velocity[1], 1e-5, row);
    EXPECT_NEAR(found.wrench[row][WRC_BY_Z], by_z, 1e-3 * std::abs(by_z));
    EXPECT_NEAR(found.wrench[row][WRC_BY_ANGULAR_VELOCITY_Y], by_turning, 1e-3 * std::abs(by_turning));
  }
}

TEST_F(UnlikeMaterials, EqualBodiesAreNot) {
  config.wheel_material.shear_modulus = config.rail_material.shear_modulus = 90e9;
  EXPECT_EQ(wrc_config_check(&config, nullptr, 0), WRC_OK);
}

TEST_F(UnlikeMaterials, EachBodysNumbersAreChecked) {
  char text[256];
  config.rail_material.shear_modulus = 80.0;
  EXPECT_EQ(wrc_config_check(&config, text, sizeof text), WRC_ERROR_RANGE);
  EXPECT_NE(std::string(text).find("rail_material.shear_modulus = 80 Pa"), std::string::npos) << text;
}

}  // namespace
