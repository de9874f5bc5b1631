/// Polach's force law and friction by name through the C interface. Links the shared library and nothing of
/// its inside.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "field_values.hpp"
#include "presets.hpp"
#include "reference_contact.hpp"
#include "wheel_on_rail.hpp"

namespace {

class PolachWheel : public ReferenceWheel {
 public:
  PolachWheel() {
    config.normal.method = WRC_NORMAL_EKP;
    choose_tangential(config, preset_polach);
    creepage.speed = 20.0;
  }
  void refused(int32_t status, const std::string& words) {
    const wrc_friction before = friction;
    expect_refused(status, {words});
    friction = wrc_friction_default();
    EXPECT_EQ(step(), WRC_OK) << error();
    friction = before;
  }
};

TEST(PolachInterface, FrictionFallsWithTheSlidingOfThePatch) {
  PolachWheel wheel;
  wheel.creepage.spin = 0.0;
  wheel.creepage.longitudinal = -0.3;
  wheel.creepage.lateral = 0.4;
  ASSERT_EQ(wheel.step(), WRC_OK) << wheel.error();
  const double whole = std::hypot(wheel.forces.fx, wheel.forces.fy);
  EXPECT_NEAR(whole, 0.35 * wheel.forces.fn, 2e-3 * wheel.forces.fn);
  const wrc_ellipse& ellipse = wheel.normal.ellipse;
  EXPECT_NEAR(wheel.forces.mz, -(ellipse.y + 0.75 * ellipse.psi * ellipse.b) * wheel.forces.fx, 1e-2);
  wheel.friction.speed_law = WRC_SPEED_LAW_EXPONENTIAL;
  wheel.friction.fall_rate = 0.1;
  ASSERT_EQ(wheel.step(), WRC_OK) << wheel.error();
  EXPECT_NEAR(std::hypot(wheel.forces.fx, wheel.forces.fy), whole * (0.4 + 0.6 * std::exp(-0.1 * 20.0 * 0.5)),
              2e-3 * whole);
}

TEST(PolachInterface, GivesForcesAndNoFields) {
  PolachWheel wheel;
  ASSERT_EQ(wheel.step(), WRC_OK) << wheel.error();
  EXPECT_EQ(wheel.forces.available & WRC_AVAILABLE_TRACTIONS, 0U);
  EXPECT_EQ(field_values(wheel.contact, 0, WRC_FIELD_TRACTION_X).status, WRC_ERROR_UNSUPPORTED);
  EXPECT_EQ(field_values(wheel.contact, 0, WRC_FIELD_PRESSURE).status, WRC_OK);
  EXPECT_GT(wheel.damage.t_gamma, 0.0);
  EXPECT_EQ(wheel.damage.peak_power_density, 0.0);

  // derivatives are differences
  const wrc_planar_forces before = wheel.forces;
  wrc_planar_derivatives slopes = sized<wrc_planar_derivatives>();
  ASSERT_EQ(wrc_planar_tangential_derivatives(wheel.contact, &slopes), WRC_OK);
  const double step = 1e-7;
  wheel.creepage.longitudinal += step;
  ASSERT_EQ(wheel.step(), WRC_OK);
  EXPECT_NEAR(slopes.forces[0][0], (wheel.forces.fx - before.fx) / step,
              1e-3 * std::fabs(slopes.forces[0][0]));
}

TEST(PolachInterface, WantsBothOfItsFactorsAndNoLayer) {
  PolachWheel wheel;
  wheel.friction.slip_reduction = 0.0;
  wheel.refused(WRC_ERROR_RANGE, "friction.slip_reduction = 0");
  wheel.friction.adhesion_reduction = 0.5;
  wheel.friction.slip_reduction = 0.6;
  wheel.refused(WRC_ERROR_RANGE, "k_S is at most his k_A");
  wheel.friction.adhesion_reduction = 40.0;
  wheel.refused(WRC_ERROR_RANGE, "friction.adhesion_reduction = 40");
  wheel.friction = wrc_friction_default();
  wheel.friction.temperature_law = WRC_TEMPERATURE_LAW_LINEAR;
  wheel.refused(WRC_ERROR_UNSUPPORTED, "no tractions that heat");
  wheel.friction = wrc_friction_default();
  wheel.friction.layer_yield = 1e8;
  wheel.refused(WRC_ERROR_UNSUPPORTED, "could carry a layer");
}

/// A wheel on a rail, in whose regions the law is applied.
class PolachOnRail : public testing::Test, protected PlacedWheel {
 protected:
  void SetUp() override {
    choose_tangential(config, preset_polach);
    roll_with_a_little_of_everything();
    ASSERT_EQ(wrc_friction_use(&friction, "Polach wet", nullptr, 0), WRC_OK);
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = 80e3;
    create();
  }
};

TEST_F(PolachOnRail, IsContinuousAndNearExactForcesWhereThereIsNoSlip) {
  constexpr int points = 300;
  std::vector<double> force;
  for (int i = 0; i < points; ++i) {
    wheel.angular_velocity[1] = -20.0 / 0.46 * (1.0 + 2e-2 * (2.0 * i / (points - 1) - 1.0));
    ASSERT_EQ(step(), WRC_OK) << error();
    force.push_back(wrench.force[0]);
    const double before = force[i > 0 ? force.size() - 2 : 0];
    ASSERT_LT(std::fabs(force.back() - before), 0.02 * 0.3 * wrench.normal_force) << i;
  }
  EXPECT_LT(force.front() * force.back(), 0.0);
  EXPECT_GT(std::fabs(force.back()), 0.1 * wrench.normal_force);

  // factors of 1, a wheelset that only pulls, next to no saturation: Kalker's force, as the default method
  // has it
  friction = wrc_friction_default();
  friction.coefficient = 2.0;
  wheel = wrc_wheel_input_default().wheel;
  rail = wrc_wheel_input_default().rail;
  wheel.velocity[0] = 20.0;
  wheel.pitch_rate = -20.0 / 0.46 * (1.0 + 1e-3);
  ASSERT_EQ(step(), WRC_OK);
  const double polach = wrench.force[0];
  choose_tangential(config, preset_table);
  create();
  ASSERT_EQ(step(), WRC_OK);
  EXPECT_NEAR(polach, wrench.force[0], 0.05 * std::fabs(wrench.force[0]));
}

TEST(FrictionByName, SetsTheLawAndTheLayerAndNothingElse) {
  const struct {
    const char* name;
    double coefficient, kinetic_ratio;
  } rows[] = {
#define WRC_FRICTION(identifier, name, coefficient, law, ratio, ...) {name, coefficient, ratio},
      WRC_FRICTION_LIST(WRC_FRICTION)
#undef WRC_FRICTION
  };
  for (const auto& row : rows) {
    wrc_friction friction = wrc_friction_default();
    friction.slope_reduction = 0.3;  // of a law set before
    friction.slope_fall = 0.6;
    friction.layer_yield = 1e6;
    friction.bulk.rail = 40.0;
    ASSERT_EQ(wrc_friction_use(&friction, row.name, nullptr, 0), WRC_OK);
    EXPECT_EQ(friction.coefficient, row.coefficient);
    EXPECT_EQ(friction.kinetic_ratio, row.kinetic_ratio);
    EXPECT_EQ(friction.slope_reduction, 1.0);
    EXPECT_EQ(friction.bulk.rail, 40.0);
    // rolled by the default method, and where there is no layer by Polach's
    ReferenceWheel wheel;
    wheel.creepage.speed = 10.0;
    wheel.friction = friction;
    EXPECT_EQ(wheel.step(), WRC_OK) << row.name << wheel.error();
    PolachWheel polach;
    polach.friction = friction;
    const bool layer = friction.layer_thickness > 0.0 || friction.layer_yield > 0.0;
    EXPECT_EQ(polach.step(), layer ? WRC_ERROR_UNSUPPORTED : WRC_OK) << row.name << polach.error();
  }
  char text[600];
  wrc_friction friction = wrc_friction_default();
  const wrc_friction before = friction;
  EXPECT_EQ(wrc_friction_use(&friction, "polach dry", text, sizeof text), WRC_ERROR_UNSUPPORTED);
  for (const auto& row : rows) ReferenceWheel::expect_words(text, {"\"" + std::string(row.name) + "\""});
  EXPECT_EQ(std::memcmp(&friction, &before, sizeof friction), 0);
  EXPECT_EQ(wrc_friction_use(nullptr, "sand", text, sizeof text), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_friction_use(&friction, nullptr, text, sizeof text), WRC_ERROR_NULL);
}

// The locomotive's curve as CONTACT's example has it: 0.312 at 1.6 % slip, 0.188 at 25 %, at 10 m/s.
TEST(FrictionByName, TheLocomotivesCurveHasItsPeakAndItsEnd) {
  ReferenceWheel wheel;
  ASSERT_EQ(wrc_friction_use(&wheel.friction, "locomotive", nullptr, 0), WRC_OK);
  wheel.create();
  wrc_ellipse ellipse = sized<wrc_ellipse>();
  ellipse.a = 6.3e-3;
  ellipse.b = 12.6e-3;
  ellipse.normal_force = 106.7e3;
  const auto adhesion = [&](double slip) {
    wheel.creepage = wrc_creepage_default();
    wheel.creepage.longitudinal = slip;
    wheel.creepage.speed = 10.0;
    EXPECT_EQ(wrc_planar_tangential(wheel.contact, &ellipse, &wheel.creepage, &wheel.friction, &wheel.forces),
              WRC_OK);
    return -wheel.forces.fx / wheel.forces.fn;
  };
  EXPECT_NEAR(adhesion(0.25), 0.188, 2e-3);
  double peak = 0.0, place = 0.0;
  for (double slip = 2e-3; slip < 0.1; slip *= 1.02) {
    if (adhesion(slip) <= peak) continue;
    peak = adhesion(slip);
    place = slip;
  }
  EXPECT_NEAR(peak, 0.312, 5e-3);
  EXPECT_NEAR(place, 0.016, 4e-3);
}

}  // namespace
