/// A layer between the bodies through the C interface: forces with other factors of friction, both ways of
/// rolling, and refusals. Links the shared library and nothing of its inside.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "field_values.hpp"
#include "presets.hpp"
#include "reference_contact.hpp"
#include "wheel_on_rail.hpp"
#include "wrc/wrc_offline.h"

namespace {

/// The default methods, a layer as of a contaminant.
class Layered : public ReferenceWheel {
 public:
  Layered() {
    config.normal.method = WRC_NORMAL_EKP;
    friction.layer_thickness = 20e-6;
    friction.layer_modulus = 177e6;
    friction.layer_yield = 90e6;
    friction.layer_hardening = 2e11;
    creepage.speed = 20.0;
  }
  void refused(int32_t status, const std::string& words) {
    const wrc_friction before = friction;
    expect_refused(status, {words});
    friction = before;
  }
};

TEST(LayerInterface, LowersForcesAsItGivesWayAndYields) {
  Layered wheel;
  const wrc_friction layer = wheel.friction;
  wheel.creepage.longitudinal = -3e-3;
  const auto force = [&](double thickness, double yield) {
    wheel.friction = layer;
    wheel.friction.layer_thickness = thickness;
    wheel.friction.layer_modulus = thickness > 0.0 ? 177e6 : 0.0;
    wheel.friction.layer_yield = yield;
    wheel.friction.layer_hardening = 0.0;
    EXPECT_EQ(wheel.step(), WRC_OK) << wheel.error();
    return wheel.forces.fx;
  };
  const double clean = force(0.0, 0.0), elastic = force(20e-6, 0.0), strong = force(20e-6, 120e6),
               weak = force(20e-6, 40e6), plastic = force(0.0, 40e6);
  EXPECT_GT(clean, 1.05 * elastic);
  EXPECT_GT(elastic, strong);
  EXPECT_GT(strong, 1.5 * weak);
  EXPECT_GT(plastic, weak);
}

TEST(LayerInterface, CombinesWithFallingAndHeatedFriction) {
  Layered wheel;
  wheel.friction.layer_hardening = 0.0;
  wheel.friction.layer_yield = 0.0;
  wheel.creepage.longitudinal = -0.05;  // slides: the force is the factors' product times that at rest
  const auto force = [&](int32_t speed, int32_t temperature) {
    wheel.friction.speed_law = speed;
    wheel.friction.temperature_law = temperature;
    EXPECT_EQ(wheel.step(), WRC_OK) << wheel.error();
    return wheel.forces.fx;
  };
  const double whole = force(WRC_SPEED_LAW_NONE, WRC_TEMPERATURE_LAW_NONE);
  const double fallen = force(WRC_SPEED_LAW_EXPONENTIAL, WRC_TEMPERATURE_LAW_NONE);
  const double hot = force(WRC_SPEED_LAW_NONE, WRC_TEMPERATURE_LAW_LINEAR);
  const double both = force(WRC_SPEED_LAW_EXPONENTIAL, WRC_TEMPERATURE_LAW_LINEAR);
  EXPECT_NEAR(fallen, whole * (0.4 + 0.6 * std::exp(-0.6 * 20.0 * 0.05)), 0.01 * whole);
  EXPECT_LT(hot, 0.95 * whole);
  EXPECT_LT(both, fallen);
  EXPECT_GT(both, fallen * hot / whole);  // slower heating than at full friction
}

TEST(LayerInterface, IsAsTheExactSolverHasIt) {
  Layered wheel;
  wrc_exact_check_options options = wrc_exact_check_options_default();
  options.nx = options.ny = 40;
  wrc_exact_check_result result = sized<wrc_exact_check_result>();
  for (const double longitudinal : {-0.4e-3, -2e-3, -6e-3}) {
    wheel.creepage.longitudinal = longitudinal;
    for (const double hardening : {2e11, 0.0, -5e11}) {
      wheel.friction.layer_hardening = hardening;
      ASSERT_EQ(wheel.step(), WRC_OK) << wheel.error();
      ASSERT_EQ(wrc_exact_check(wheel.contact, &options, &result), WRC_OK) << wheel.error();
      EXPECT_LT(result.force_error, 0.035) << longitudinal << " " << hardening;
      EXPECT_NEAR(result.power_error, 0.0, 0.08);
    }
  }
}

TEST(LayerInterface, ExactlyAFoundationOfSpringsAndYieldAreClosedForms) {
  // an ellipse of springs far softer than the bodies: 8 a^2 b nu / (3 F) while all sticks
  wrc_exact_rolling_problem problem = wrc_exact_rolling_problem_default();
  constexpr uint32_t n = 60;
  constexpr double a = 5e-3, b = 4e-3, peak = 1e9, F = 1e-10, pi = 3.14159265358979323846;
  problem.grid = sized<wrc_grid>();
  problem.grid.nx = problem.grid.ny = n;
  problem.grid.dx = 2.0 * a / n;
  problem.grid.dy = 2.0 * b / n;
  problem.grid.x0 = -a + 0.5 * problem.grid.dx;
  problem.grid.y0 = -b + 0.5 * problem.grid.dy;
  std::vector<double> pressure;
  for (uint32_t j = 0; j < n; ++j) {
    for (uint32_t i = 0; i < n; ++i) {
      const double x = (problem.grid.x0 + i * problem.grid.dx) / a,
                   y = (problem.grid.y0 + j * problem.grid.dy) / b;
      pressure.push_back(peak * std::sqrt(std::fmax(0.0, 1.0 - x * x - y * y)));
    }
  }
  problem.pressure = pressure.data();
  problem.coefficient = 0.3;
  problem.layer_thickness = 1e-3;
  problem.layer_modulus = 1e-3 / F;
  problem.creepage.longitudinal = 1e-4;
  wrc_exact_rolling_solution s = sized<wrc_exact_rolling_solution>();
  char text[256];
  ASSERT_EQ(wrc_exact_rolling(&problem, &s, text, sizeof text), WRC_OK) << text;
  EXPECT_NEAR(s.fx, -8.0 * a * a * b * 1e-4 / (3.0 * F), 0.01 * std::fabs(s.fx));

  // full slip under the yield tau: Int min(mu p, tau) dA = mu N (3 t - t^3) / 2
  problem.creepage.longitudinal = 0.5;
  problem.layer_thickness = problem.layer_modulus = 0.0;
  problem.layer_yield = 0.5 * 0.3 * peak;
  ASSERT_EQ(wrc_exact_rolling(&problem, &s, text, sizeof text), WRC_OK) << text;
  const double limit = 0.3 * 2.0 / 3.0 * pi * a * b * peak;
  EXPECT_NEAR(s.fx, -limit * (1.5 * 0.5 - 0.5 * 0.125), 0.01 * limit);

  // refused where nothing could flow
  problem.adhesion = WRC_ADHESION_FULL;
  EXPECT_EQ(wrc_exact_rolling(&problem, &s, text, sizeof text), WRC_ERROR_UNSUPPORTED);
  ReferenceWheel::expect_words(text, {"nothing slides or flows"});
  problem.adhesion = WRC_ADHESION_COULOMB;
  problem.layer_thickness = 1e-3;
  EXPECT_EQ(wrc_exact_rolling(&problem, &s, text, sizeof text), WRC_ERROR_RANGE);
  EXPECT_EQ(s.fx, 0.0);
}

/// A wheel on a rail.
class LayeredWheel : public testing::Test, protected PlacedWheel {
 protected:
  void SetUp() override {
    roll_with_a_little_of_everything();
    friction.coefficient = 0.4;
    friction.layer_thickness = 20e-6;
    friction.layer_modulus = 177e6;
    friction.layer_yield = 150e6;
    create();
  }
};

TEST_F(LayeredWheel, IsAsTheExactSolverHasIt) {
  wrc_exact_wrench_options options = wrc_exact_wrench_options_default();
  options.cell_x = options.cell_s = 4e-4;
  for (const double slip : {5e-4, 3e-3, 1e-2}) {
    wheel.angular_velocity[1] = -20.0 / 0.46 * (1.0 + slip);
    for (const double hardening : {2e11, 0.0, -5e11}) {
      friction.layer_hardening = hardening;
      ASSERT_EQ(step(), WRC_OK) << error();
      wrc_wrench exact = sized<wrc_wrench>();
      ASSERT_EQ(wrc_exact_wrench(contact, &input, &options, &exact), WRC_OK) << error();
      const double limit = friction.coefficient * exact.normal_force;
      for (int k = 0; k < 2; ++k)
        EXPECT_NEAR(wrench.force[k], exact.force[k], 0.03 * limit) << slip << " " << hardening << " " << k;
      EXPECT_NEAR(wrench.power, exact.power, 0.08 * exact.power) << slip << " " << hardening;
    }
  }
}

TEST_F(LayeredWheel, HasFieldsThatDissipateItsPower) {
  ASSERT_EQ(step(), WRC_OK) << error();
  double power = 0.0;
  for (int32_t region = 0; region < wrench.region_count; ++region) {
    const FieldValues density = field_values(contact, region, WRC_FIELD_POWER_DENSITY);
    ASSERT_EQ(density.status, WRC_OK);
    for (const double each : density.values) power += each;
  }
  EXPECT_GT(power, 0.0);
  EXPECT_GT(wrench.power, 0.0);
}

TEST_F(LayeredWheel, DoesNotJumpAsSlipGrows) {
  constexpr int points = 400;
  std::vector<double> force;
  for (int i = 0; i < points; ++i) {
    wheel.angular_velocity[1] = -20.0 / 0.46 * (1.0 + 1e-2 * (2.0 * i / (points - 1) - 1.0));
    ASSERT_EQ(step(), WRC_OK) << error();
    force.push_back(wrench.force[0]);
  }
  for (std::size_t i = 2; i < force.size(); ++i)
    EXPECT_LT(std::fabs(force[i] - 2.0 * force[i - 1] + force[i - 2]), 1.5e-3 * 0.4 * wrench.normal_force)
        << i;
}

TEST_F(LayeredWheel, IsRolledByEveryMethodThatMarches) {
  for (int32_t preset = 0; preset < tangential_methods; ++preset) {
    choose_tangential(config, preset);
    create();
    friction.slope_fall = 0.0;
    const bool marches = presets[preset].method == WRC_TANGENTIAL_FASTSIM ||
                         presets[preset].method == WRC_TANGENTIAL_STRIP_FASTSIM;
    const wrc_friction layer = friction;
    if (!marches) {
      EXPECT_EQ(step(), WRC_ERROR_UNSUPPORTED) << presets[preset].name;
      continue;
    }
    ASSERT_EQ(step(), WRC_OK) << presets[preset].name << error();
    const double layered = wrench.force[0];
    friction = wrc_friction_default();
    friction.coefficient = 0.4;
    friction.slope_fall = 0.0;
    ASSERT_EQ(step(), WRC_OK) << presets[preset].name << error();
    EXPECT_GT(std::fabs(wrench.force[0]), 1.05 * std::fabs(layered)) << presets[preset].name;
    friction = layer;
  }
}

TEST(LayerInterface, RollsBackwardsAsInAMirror) {
  Layered wheel;
  ASSERT_EQ(wheel.step(), WRC_OK);
  const wrc_planar_forces forwards = wheel.forces;
  wheel.creepage.speed = -wheel.creepage.speed;
  wheel.creepage.longitudinal = -wheel.creepage.longitudinal;
  wheel.creepage.spin = -wheel.creepage.spin;
  ASSERT_EQ(wheel.step(), WRC_OK);
  EXPECT_EQ(wheel.forces.fx, -forwards.fx);
  EXPECT_EQ(wheel.forces.fy, forwards.fy);
  EXPECT_EQ(wheel.forces.mz, -forwards.mz);
}

TEST(LayerInterface, IsWholeOrRefused) {
  Layered wheel;
  ASSERT_EQ(wheel.step(), WRC_OK) << wheel.error();
  const wrc_friction layer = wheel.friction;
  const auto refused = [&](double wrc_friction::*member, double value, const char* words) {
    wheel.friction = layer;
    wheel.friction.*member = value;
    EXPECT_LT(wheel.step(), 0) << words;
    ReferenceWheel::expect_words(wheel.error(), {words});
    wheel.expect_zeros();
  };
  refused(&wrc_friction::layer_thickness, 20.0, "friction.layer_thickness = 20 m");
  refused(&wrc_friction::layer_thickness, 0.0, "a layer that does not shear has no shear modulus");
  refused(&wrc_friction::layer_modulus, 0.0, "needs a shear modulus");
  refused(&wrc_friction::layer_yield, -1.0, "friction.layer_yield = -1 Pa");
  refused(&wrc_friction::layer_yield, nan_value, "friction.layer_yield");
  refused(&wrc_friction::layer_yield, 0.0, "cannot harden");
  refused(&wrc_friction::layer_hardening, -8e12, "softens faster");
  refused(&wrc_friction::slope_reduction, 0.5, "slope_reduction be 1");
  wheel.friction = layer;
  EXPECT_EQ(wheel.step(), WRC_OK) << wheel.error();
}

TEST(LayerInterface, IsRefusedWhereNothingCarriesIt) {
  for (int32_t preset = 0; preset < tangential_methods; ++preset) {
    Layered wheel;
    choose_tangential(wheel.config, preset);
    const bool marches = presets[preset].method == WRC_TANGENTIAL_FASTSIM ||
                         presets[preset].method == WRC_TANGENTIAL_STRIP_FASTSIM;
    if (marches) {
      EXPECT_EQ(wheel.step(), WRC_OK) << presets[preset].name << wheel.error();
    } else {
      wheel.refused(WRC_ERROR_UNSUPPORTED, "could carry a layer");
    }
  }
  Layered remembering;
  remembering.config.planar.non_steady = 1;
  remembering.refused(WRC_ERROR_UNSUPPORTED, "not how far a layer has flowed");
}

}  // namespace
