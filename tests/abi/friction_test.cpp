/// Friction laws and the tangential variants through the C interface. Links the shared library and nothing of
/// its inside.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "field_values.hpp"
#include "presets.hpp"
#include "reference_contact.hpp"
#include "test_config.hpp"
#include "wrc/wrc_offline.h"

namespace {

/// Does the published method read config.tangential.bound and config.tangential.flexibility?
bool marches(int32_t preset) { return presets[preset].method == WRC_TANGENTIAL_FASTSIM; }

/// Rolling at 30 m/s, solved by a method that is quick; one model per test.
class Wheel : public ReferenceWheel {
 public:
  Wheel() {
    config.normal.method = WRC_NORMAL_EKP;
    creepage.speed = 30.0;
  }
  /// With the bound friction * pressure.
  void choose(int32_t preset) {
    choose_tangential(config, preset);
    if (marches(preset)) config.tangential.bound = WRC_BOUND_ELLIPTIC;
  }
  /// Refused by name; the law of the defaults works afterwards.
  void expect_law_refused(int32_t status, const char* words) {
    expect_refused(status, {words});
    friction = wrc_friction_default();
    EXPECT_EQ(step(), WRC_OK);
  }
  void set_zones(const std::vector<double>& y, const std::vector<double>& mu, int32_t frame) {
    friction.zone_count = static_cast<uint32_t>(y.size());
    friction.zone_y = y.data();
    friction.zone_coefficients = mu.data();
    friction.zone_frame = frame;
  }
  FieldValues all_of(int32_t id) {
    FieldValues found = field_values(contact, 0, id);
    EXPECT_EQ(found.status, WRC_OK);
    return found;
  }
  std::vector<double> field(int32_t id) { return all_of(id).values; }
};

TEST(FrictionInterface, ZeroMeansZero) {
  Wheel wheel;
  ASSERT_EQ(wheel.step(), WRC_OK);
  wheel.friction.slope_reduction = 0.0;
  EXPECT_EQ(wheel.step(), WRC_ERROR_RANGE);
  wheel.friction = wrc_friction{};
  wheel.friction.coefficient = 0.35;
  wheel.friction.slope_reduction = 1.0;
  EXPECT_EQ(wheel.step(), WRC_ERROR_RANGE);  // of a law that is not chosen: checked all the same
  EXPECT_NE(wheel.error().find("friction.half_speed = 0"), std::string::npos) << wheel.error();
}

TEST(FrictionInterface, BadLawsAreNamed) {
  Wheel wheel;
  wheel.friction.speed_law = 9;
  wheel.expect_law_refused(WRC_ERROR_UNSUPPORTED, "friction.speed_law = 9");
  wheel.friction.zone_frame = -1;
  wheel.expect_law_refused(WRC_ERROR_UNSUPPORTED, "friction.zone_frame = -1");
  wheel.friction.kinetic_ratio = 1.5;
  wheel.expect_law_refused(WRC_ERROR_RANGE, "friction.kinetic_ratio = 1.5");
  wheel.friction.fall_rate = -0.7;
  wheel.expect_law_refused(WRC_ERROR_RANGE, "friction.fall_rate = -0.7 s/m");
  wheel.friction.speed_law = WRC_SPEED_LAW_HYPERBOLIC;
  wheel.friction.half_speed = 0.0;
  wheel.expect_law_refused(WRC_ERROR_RANGE, "friction.half_speed = 0 m/s");
  wheel.friction.half_speed = 0.0;
  wheel.expect_law_refused(WRC_ERROR_RANGE, "friction.half_speed = 0 m/s");
  wheel.friction.hot_ratio = 1.5;
  wheel.expect_law_refused(WRC_ERROR_RANGE, "friction.hot_ratio = 1.5");
  wheel.friction.bulk.rail = 4000.0;
  wheel.expect_law_refused(WRC_ERROR_RANGE, "friction.bulk.rail = 4000 degC");
  wheel.friction.slope_reduction = 54.0;
  wheel.expect_law_refused(WRC_ERROR_RANGE, "per cent");
  wheel.friction.slope_limit = nan_value;
  wheel.expect_law_refused(WRC_ERROR_NOT_FINITE, "friction.slope_limit");
  wheel.friction.slope_fall = -1.0;
  wheel.expect_law_refused(WRC_ERROR_RANGE, "friction.slope_fall");

  const std::vector<double> millimetres{-10.0, 10.0}, mu{0.1, 0.4}, backwards{0.01, -0.01}, y{-0.01, 0.01},
      negative{0.1, -0.4}, poisoned{nan_value, 0.4};
  wheel.friction.zone_count = 2;
  wheel.expect_law_refused(WRC_ERROR_NULL, "friction.zone_y");
  wheel.set_zones(y, mu, WRC_ZONES_CONTACT_FRAME);
  wheel.friction.zone_coefficients = nullptr;
  wheel.expect_law_refused(WRC_ERROR_NULL, "friction.zone_coefficients");
  wheel.set_zones(millimetres, mu, WRC_ZONES_CONTACT_FRAME);
  wheel.expect_law_refused(WRC_ERROR_RANGE, "did you pass mm?");
  wheel.set_zones(backwards, mu, WRC_ZONES_CONTACT_FRAME);
  wheel.expect_law_refused(WRC_ERROR_RANGE, "friction.zone_y[1] = -0.01 m");
  wheel.set_zones(y, negative, WRC_ZONES_CONTACT_FRAME);
  wheel.expect_law_refused(WRC_ERROR_RANGE, "friction.zone_coefficients[1] = -0.4");
  wheel.set_zones(y, poisoned, WRC_ZONES_CONTACT_FRAME);
  wheel.expect_law_refused(WRC_ERROR_NOT_FINITE, "friction.zone_coefficients[0]");
  const std::vector<double> many(65, 0.0);
  wheel.set_zones(many, many, WRC_ZONES_CONTACT_FRAME);
  wheel.expect_law_refused(WRC_ERROR_RANGE, "friction.zone_count = 65");
}

// A program may keep the parameters of all laws, and of modified FASTSIM, whatever it has chosen.
TEST(FrictionInterface, MembersOfOtherLawsAreNotUsed) {
  for (int32_t method = 0; method < tangential_methods; ++method) {
    for (int32_t law : {WRC_SPEED_LAW_NONE, WRC_SPEED_LAW_EXPONENTIAL, WRC_SPEED_LAW_HYPERBOLIC}) {
      Wheel wheel;
      wheel.choose(method);
      wheel.friction.speed_law = law;
      wheel.friction.slope_fall = slope_fall_for(method);
      ASSERT_EQ(wheel.step(), WRC_OK);
      const wrc_planar_forces forces = wheel.forces;
      if (law == WRC_SPEED_LAW_NONE) wheel.friction.kinetic_ratio = 0.7;
      if (law != WRC_SPEED_LAW_EXPONENTIAL) wheel.friction.fall_rate = 0.9;
      if (law != WRC_SPEED_LAW_HYPERBOLIC) wheel.friction.half_speed = 0.01;
      wheel.friction.hot_ratio = 0.1;
      wheel.friction.cold_temperature = 300.0;  // hot surfaces are colder, were it read
      wheel.friction.hot_temperature = 10.0;
      wheel.friction.bulk.wheel = wheel.friction.bulk.rail = 250.0;
      if (!marches(method)) {
        wheel.friction.slope_fall = 0.6;
        wheel.friction.slope_limit = 0.1;
      }
      if (presets[method].method != WRC_TANGENTIAL_POLACH)
        wheel.friction.adhesion_reduction = wheel.friction.slip_reduction = 0.1;
      ASSERT_EQ(wheel.step(), WRC_OK) << wheel.error();
      EXPECT_EQ(std::memcmp(&wheel.forces, &forces, sizeof forces), 0) << method << ' ' << law;
    }
  }
}

TEST(FrictionInterface, ZonesOverTheRailNeedAPoseAndStayOnTheRail) {
  // Greased gauge face, dry crown: a step at y_rail = -10 mm.
  const std::vector<double> y{-10e-3, -10e-3}, mu{0.08, 0.4};
  Wheel right, left;
  left.side = WRC_SIDE_LEFT;
  for (double lateral : {0.0, 0.5e-3, -1e-3}) {
    right.set_zones(y, mu, WRC_ZONES_RAIL_PROFILE);
    left.set_zones(y, mu, WRC_ZONES_RAIL_PROFILE);
    right.pose.lateral = lateral;
    left.pose.lateral = -lateral;
    left.creepage.longitudinal = right.creepage.longitudinal;
    left.creepage.lateral = -right.creepage.lateral;
    left.creepage.spin = -right.creepage.spin;
    ASSERT_EQ(right.step(), WRC_OK);
    ASSERT_EQ(left.step(), WRC_OK);
    EXPECT_NEAR(right.forces.fx, left.forces.fx, 1e-6 * 80e3);
    EXPECT_NEAR(right.forces.fy, -left.forces.fy, 1e-6 * 80e3);
    const std::vector<double> strip_y = right.field(WRC_FIELD_STRIP_Y),
                              width = right.field(WRC_FIELD_STRIP_WIDTH),
                              each = right.field(WRC_FIELD_STRIP_FRICTION);
    bool wet = false, dry = false;
    for (std::size_t j = 0; j < each.size(); ++j) {
      const double on_rail = right.point.y_rail + strip_y[j] * std::cos(right.point.angle);
      if (std::fabs(on_rail + 10e-3) > width[j]) {
        EXPECT_NEAR(each[j], on_rail < -10e-3 ? 0.08 : 0.4, 1e-12);
      }
      wet = wet || each[j] < 0.1;
      dry = dry || each[j] > 0.39;
    }
    EXPECT_TRUE(wet && dry) << lateral;
  }

  // over the wheel they are the same where its profile's coordinates differ by as much as the point's
  const double apart = right.point.y_wheel - right.point.y_rail, fx = right.forces.fx, fy = right.forces.fy;
  const std::vector<double> on_wheel{y[0] + apart, y[1] + apart};
  right.set_zones(on_wheel, mu, WRC_ZONES_WHEEL_PROFILE);
  left.set_zones(on_wheel, mu, WRC_ZONES_WHEEL_PROFILE);
  ASSERT_EQ(right.step(), WRC_OK);
  ASSERT_EQ(left.step(), WRC_OK);
  EXPECT_NEAR(right.forces.fx, fx, 1e-9 * 80e3);
  EXPECT_NEAR(right.forces.fy, fy, 1e-9 * 80e3);
  EXPECT_NEAR(left.forces.fx, fx, 1e-6 * 80e3);

  wrc_ellipse own = sized<wrc_ellipse>();
  own.a = 5e-3;
  own.b = 6e-3;
  own.normal_force = 80e3;
  for (const int32_t profile : {WRC_ZONES_RAIL_PROFILE, WRC_ZONES_WHEEL_PROFILE}) {
    right.friction.zone_frame = profile;
    EXPECT_EQ(wrc_planar_tangential(right.contact, &own, &right.creepage, &right.friction, &right.forces),
              WRC_ERROR_SEQUENCE);
    EXPECT_NE(right.error().find("friction.zone_frame"), std::string::npos) << right.error();
  }
  EXPECT_EQ(right.forces.fx, 0.0);
  right.friction.zone_frame = WRC_ZONES_CONTACT_FRAME;
  EXPECT_EQ(wrc_planar_tangential(right.contact, &own, &right.creepage, &right.friction, &right.forces),
            WRC_OK);
}

// Tractions within each strip's own bound, power of the forces that of the field, whatever law and method.
TEST(FrictionInterface, EveryMethodObeysEveryLaw) {
  const std::vector<double> y{-4e-3, -1e-3, -1e-3, 3e-3}, mu{0.1, 0.3, 0.0, 0.5};
  for (int32_t method = 0; method < tangential_methods; ++method) {
    for (int32_t form : {WRC_FLEXIBILITY_SEPARATE, WRC_FLEXIBILITY_SINGLE, WRC_FLEXIBILITY_BLENDED}) {
      if (form != WRC_FLEXIBILITY_SEPARATE && !marches(method)) continue;
      Wheel wheel;
      wheel.choose(method);
      wheel.config.tangential.flexibility = form;
      for (int32_t law : {WRC_SPEED_LAW_NONE, WRC_SPEED_LAW_EXPONENTIAL, WRC_SPEED_LAW_HYPERBOLIC}) {
        for (bool zoned : {false, true}) {
          for (double size : {0.3, 1.0, 30.0}) {
            wheel.friction = wrc_friction_default();
            wheel.friction.coefficient = 0.35;
            wheel.friction.speed_law = law;
            wheel.friction.half_speed = 0.05;
            wheel.friction.slope_reduction = 0.6;
            wheel.friction.slope_fall = slope_fall_for(method);
            if (zoned) wheel.set_zones(y, mu, WRC_ZONES_CONTACT_FRAME);
            wheel.creepage.longitudinal = -0.49e-3 * size;
            wheel.creepage.lateral = -0.22e-3 * size;
            wheel.creepage.spin = 0.29 * size;
            ASSERT_EQ(wheel.step(), WRC_OK);
            EXPECT_NEAR(wheel.damage.power, wheel.forces.power, 1e-6 * wheel.forces.power) << method;
            EXPECT_GT(wheel.forces.power, 0.0);
            if (!gives_tractions(wheel.contact)) continue;
            const std::vector<double> each = wheel.field(WRC_FIELD_STRIP_FRICTION);
            for (double value : each) {
              ASSERT_GE(value, 0.0);
              ASSERT_LE(value, zoned ? 0.5 : 0.35);
            }
            const FieldValues px = wheel.all_of(WRC_FIELD_TRACTION_X),
                              py = wheel.all_of(WRC_FIELD_TRACTION_Y),
                              pressure = wheel.all_of(WRC_FIELD_PRESSURE);
            ASSERT_EQ(px.strips, each.size());
            for (std::size_t j = 0; j < px.strips; ++j) {
              for (std::size_t i = 0; i < px.cells; ++i) {
                ASSERT_LE(std::hypot(px.at(i, j), py.at(i, j)),
                          each[j] * pressure.at(i, j) * (1.0 + 1e-3) + 1e-3)
                    << method << " " << law << " " << zoned;
              }
            }
          }
        }
      }
    }
  }
}

TEST(FrictionInterface, FrictionFallsWithTheSpeedOfTheWheel) {
  for (int32_t method = 0; method < tangential_methods; ++method) {
    Wheel wheel;
    wheel.choose(method);
    wheel.creepage.longitudinal = 0.05;  // slides
    wheel.creepage.lateral = wheel.creepage.spin = 0.0;
    double before = 1e9;
    for (double speed : {0.0, 2.0, 20.0, 200.0}) {
      wheel.creepage.speed = speed;
      wheel.friction.coefficient = 0.36;
      wheel.friction.speed_law = WRC_SPEED_LAW_EXPONENTIAL;
      wheel.friction.kinetic_ratio = 0.38;
      wheel.friction.fall_rate = 0.7;
      ASSERT_EQ(wheel.step(), WRC_OK);
      const double expected = 0.36 * (0.62 * std::exp(-0.7 * 0.05 * speed) + 0.38) * wheel.forces.fn;
      EXPECT_NEAR(-wheel.forces.fx, expected, 1e-3 * expected) << method;
      EXPECT_LT(-wheel.forces.fx, before);
      before = -wheel.forces.fx;
    }
  }
}

TEST(FrictionInterface, SlopeReductionScalesSmallForcesAndNotTheLimit) {
  for (int32_t method = 0; method < tangential_methods; ++method) {
    Wheel wheel;
    wheel.choose(method);
    wheel.creepage.lateral = wheel.creepage.spin = 0.0;
    const auto force = [&](double nu, double reduction) {
      wheel.creepage.longitudinal = nu;
      wheel.friction.slope_reduction = reduction;
      EXPECT_EQ(wheel.step(), WRC_OK);
      return wheel.forces.fx;
    };
    EXPECT_NEAR(force(1e-6, 0.54) / force(1e-6, 1.0), 0.54, 5e-3) << method;
    EXPECT_NEAR(force(0.2, 0.54) / force(0.2, 1.0), 1.0, 1e-3) << method;
  }
}

TEST(FrictionInterface, SavedStateRollsBackBitForBit) {
  const std::vector<double> y{-4e-3, 3e-3}, mu{0.1, 0.5};
  Wheel wheel;
  wheel.choose(preset_fastrip_sdec);
  wheel.set_zones(y, mu, WRC_ZONES_CONTACT_FRAME);
  ASSERT_EQ(wheel.step(), WRC_OK);
  const std::vector<double> before = wheel.field(WRC_FIELD_STRIP_FRICTION);
  constexpr uint64_t bytes = 1U << 22U;  // plenty
  std::vector<char> saved(bytes);
  ASSERT_EQ(wrc_contact_save(wheel.contact, saved.data(), bytes), WRC_OK);
  wheel.friction.zone_count = 0;
  ASSERT_EQ(wheel.step(), WRC_OK);
  EXPECT_NE(wheel.field(WRC_FIELD_STRIP_FRICTION), before);
  ASSERT_EQ(wrc_contact_restore(wheel.contact, saved.data(), bytes), WRC_OK);
  EXPECT_EQ(wheel.field(WRC_FIELD_STRIP_FRICTION), before);
}

TEST(FrictionInterface, ExactCheckUsesTheStripsFriction) {
  const std::vector<double> y{-4e-3, 3e-3}, mu{0.1, 0.5};
  Wheel wheel;
  wheel.choose(preset_strip_fastsim);
  wheel.creepage.longitudinal = -2e-3;
  wheel.set_zones(y, mu, WRC_ZONES_CONTACT_FRAME);
  ASSERT_EQ(wheel.step(), WRC_OK);
  wrc_exact_check_result result = sized<wrc_exact_check_result>();
  wrc_exact_check_options options = wrc_exact_check_options_default();
  options.nx = 32;
  options.ny = 40;
  ASSERT_EQ(wrc_exact_check(wheel.contact, &options, &result), WRC_OK) << wheel.error();
  EXPECT_LT(result.force_error, 0.04);  // constant 0.35 would be 0.2 off
}

}  // namespace
