/// A rail that is a roller: Hertz's and Kalker's numbers, axles one above the other and beside each other.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../wrench_inputs.hpp"
#include "test_config.hpp"
#include "wheel_on_rail.hpp"
#include "wrc/wrc_offline.h"

namespace {

/// A flat tread on a crown, both about the rail's origin at y = 0.75 m.
class Roller : public testing::Test, protected PlacedWheel {
 protected:
  static constexpr double crown = 0.23, radius = 0.46;

  Roller() {
    for (int i = -300; i <= 300; ++i) {
      y_.push_back(1e-4 * i);
      z_.push_back(crown - std::sqrt(crown * crown - y_.back() * y_.back()));
      level_.push_back(0.0);
    }
    config.wheel.kind = config.rail.kind = WRC_PROFILE_POINTS;
    for (wrc_profile* profile : {&config.wheel, &config.rail}) {
      profile->count = static_cast<uint32_t>(y_.size());
      profile->y = y_.data();
      profile->z = profile == &config.rail ? z_.data() : level_.data();
    }
    config.track.placement = WRC_PLACEMENT_ORIGIN;
    config.track.rail_origin = 0.75;
    config.roller_curvature = 1.0 / radius;
    config.planar.start = WRC_START_COLD;
    wheel.reference = WRC_REFERENCE_WHEEL;
    wheel.velocity[0] = 0.0;
    roll_at(20.0);
  }
  /// A wheel at rest rolling on the roller.
  void roll_at(double speed) {
    wheel.angular_axes = WRC_AXES_TRACK;
    wheel.angular_velocity[1] = -speed / config.wheelset.wheel_radius;
    input.roller_rate = speed * config.roller_curvature;
  }
  void carry(double load) {
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = load;
    wheel.z = 0.0;
    ASSERT_EQ(step(), WRC_OK) << error();
  }
  void press(double z) {
    input.prescribed = WRC_PRESCRIBE_HEIGHT;
    input.vertical_load = 0.0;
    wheel.z = z;
    ASSERT_EQ(step(), WRC_OK) << error();
  }
  /// The same input exactly.
  wrc_wrench exactly(double cell) {
    wrc_exact_wrench_options options = wrc_exact_wrench_options_default();
    options.cell_x = options.cell_s = cell;
    wrc_wrench exact = sized<wrc_wrench>();
    EXPECT_EQ(wrc_exact_wrench(contact, &input, &options, &exact), WRC_OK) << error();
    return exact;
  }
  double hertz_radius(double load) const {
    const double nu = config.wheel_material.poisson,
                 E = 2.0 * config.wheel_material.shear_modulus * (1.0 + nu);
    return std::cbrt(1.5 * load * crown * (1.0 - nu * nu) / E);
  }

  std::vector<double> y_, z_, level_;
};

/// Two cylinders of 0.46 m are curved against each other as the crown is: a circle, with
/// a^3 = 3 N R (1 - nu^2) / (2 E) and an approach of a^2 / R, R = 0.23 m.
TEST_F(Roller, EqualCylindersAndACrownAreHertzsCircle) {
  create();
  for (const double load : {20e3, 80e3}) {
    carry(load);
    const double a = hertz_radius(load);
    EXPECT_NEAR(wrench.area, 3.14159265358979 * a * a, 0.02 * wrench.area);
    EXPECT_NEAR(wrench.peak_pressure, 1.5 * load / (3.14159265358979 * a * a), 0.01 * wrench.peak_pressure);
    EXPECT_NEAR(wrench.z, a * a / crown, 0.01 * wrench.z);
    wrc_region region = sized<wrc_region>();
    ASSERT_EQ(wrc_contact_region(contact, 0, &region), WRC_OK);
    EXPECT_NEAR(region.ellipse.a / region.ellipse.b, 1.0, 0.12);  // half strips of 0.25 mm
    EXPECT_NEAR(region.z_rail, 0.0, 2e-6 + wrench.z);
  }
}

/// Forces of linear theory: F = G a^2 C creepage, C11 = 4.12, C22 = 3.67 of a circle (Kalker's table).
TEST_F(Roller, CreepForcesAreKalkers) {
  create();
  const double load = 80e3, a = hertz_radius(load), stiffness = config.wheel_material.shear_modulus * a * a;
  carry(load);
  // pure rolling, but for what the crown's radius falls to its sides
  const double rolling = wrench.force[0];
  EXPECT_LT(std::abs(rolling), 0.012 * 0.3 * load);
  EXPECT_NEAR(wrench.force[1], 0.0, 1e-6 * load);
  const double creepage = 2e-5;
  input.roller_rate *= 1.0 - creepage;  // the wheel's surface is the faster: it is driven forwards
  carry(load);
  EXPECT_NEAR(wrench.force[0] - rolling, 4.12 * stiffness * creepage, 0.04 * 4.12 * stiffness * creepage);
  input.roller_rate /= 1.0 - creepage;
  wheel.velocity[1] = -20.0 * creepage;
  carry(load);
  EXPECT_NEAR(wrench.force[1], 3.67 * stiffness * creepage, 0.04 * wrench.force[1]);
  wheel.velocity[1] = 0.0;
  input.roller_rate *= 0.9;
  carry(load);
  EXPECT_NEAR(wrench.force[0], 0.3 * load, 1e-3 * load);
  EXPECT_NEAR(wrench.power, 0.3 * load * 2.0, 0.01 * wrench.power);
}

/// Half the wheel's radius on a straight rail is the same contact: the same forces from adhesion to
/// saturation, but for the crown's sides, which a roller moves slower than its middle (as in the test
/// before).
TEST_F(Roller, TheSameContactOnAStraightRailHasTheSameForces) {
  const double slip[] = {1e-4, 1e-3, 5e-3};
  std::vector<wrc_wrench> of_roller;
  create();
  for (const double creepage : slip) {
    roll_at(20.0);
    input.roller_rate *= 1.0 - creepage;
    wheel.velocity[1] = 0.5 * creepage * 20.0;
    carry(80e3);
    of_roller.push_back(wrench);
  }
  config.roller_curvature = 0.0;
  config.wheelset.wheel_radius = 0.5 * radius;
  create();
  input.roller_rate = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    wheel.velocity[0] = 20.0 * (1.0 - slip[i]);
    wheel.angular_velocity[1] = -20.0 / (0.5 * radius);
    wheel.velocity[1] = 0.5 * slip[i] * 20.0;
    carry(80e3);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(wrench.force[k], of_roller[i].force[k], 0.012 * 24e3) << i << k;
    EXPECT_NEAR(wrench.z, of_roller[i].z, 1e-9);
    if (i > 0) {
      EXPECT_NEAR(wrench.power, of_roller[i].power, 0.05 * wrench.power);
    }
  }
}

TEST_F(Roller, AGiantRollerIsARail) {
  config.wheel = config.rail = sized<wrc_profile>();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  config.track = test_config().track;
  wheel.reference = WRC_REFERENCE_WHEELSET;
  wheel.y = 5.5e-3;
  wheel.yaw = 0.01;
  wheel.velocity[0] = 20.0;
  wheel.velocity[1] = 0.02;
  input.roller_rate = 0.0;
  for (const int32_t which : {WRC_SIDE_RIGHT, WRC_SIDE_LEFT}) {
    wheel.y = std::copysign(wheel.y, which == WRC_SIDE_RIGHT ? 1.0 : -1.0);
    config.roller_curvature = 0.0;
    create(which);
    press(-0.2e-3);
    const wrc_wrench rail_only = wrench;
    config.roller_curvature = 1e-12;
    create(which);
    press(-0.2e-3);
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(wrench.force[k], rail_only.force[k], 1e-9 * rail_only.normal_force) << k;
      EXPECT_NEAR(wrench.moment[k], rail_only.moment[k], 1e-9 * rail_only.normal_force) << k;
    }
    // it turns beneath a wheel that stays
    config.roller_curvature = 1e-6;
    create(which);
    wheel.velocity[0] = 0.0;
    input.roller_rate = 20.0 * 1e-6;
    press(-0.2e-3);
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(wrench.force[k], rail_only.force[k], 1e-4 * rail_only.normal_force) << k;
    wheel.velocity[0] = 20.0;
    input.roller_rate = 0.0;
  }
}

/// Axles d apart along x: the line of centres leans by d / (r + R), and is longer by d^2 / (2 (r + R)).
TEST_F(Roller, BesideTheAxleTheForceLeans) {
  friction.coefficient = 0.0;
  create();
  const double d = 6e-3, centres = 2.0 * radius, z = 150e-6;
  press(z - d * d / (2.0 * centres));
  const wrc_wrench above = wrench;
  input.distance = d;
  press(z);
  EXPECT_NEAR(wrench.normal_force, above.normal_force, 1e-3 * above.normal_force);
  EXPECT_NEAR(wrench.force[0], -d / centres * wrench.force[2], 1e-3 * wrench.force[0]);
  EXPECT_GT(wrench.force[0], 0.0);                                      // away from the axle
  EXPECT_NEAR(wrench.moment[1], 0.0, 2e-3 * wrench.force[0] * radius);  // through the wheel's axle
  wrc_region region = sized<wrc_region>();
  ASSERT_EQ(wrc_contact_region(contact, 0, &region), WRC_OK);
  EXPECT_NEAR(region.point[0], -d * radius / centres, 1e-6);
}

/// Of a yawed wheelset, whose wheels stand before and behind the roller's axle.
TEST_F(Roller, DerivativesAreThoseOfDifferences) {
  config.wheel = config.rail = sized<wrc_profile>();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  config.track = test_config().track;
  wheel.reference = WRC_REFERENCE_WHEELSET;
  wheel.y = 1e-3;
  wheel.z = 0.2e-3;
  wheel.yaw = 4e-3;
  wheel.velocity[1] = 0.02;
  wheel.angular_velocity[2] = 0.01;
  input.distance = 1e-3;
  input.damping = 0.1;
  input.frame.speed = 10.0;  // both at once
  input.frame.curvature = 2e-3;
  input.frame.twist = 1e-2;
  wheel.velocity[0] = -10.0;
  for (const int32_t which : {WRC_SIDE_RIGHT, WRC_SIDE_LEFT}) {
    create(which);
    auto found = sized<wrc_wrench_derivatives>();
    ASSERT_EQ(wrc_contact_wrench_derivatives(contact, &input, &wrench, &found), WRC_OK) << error();
    double number[6][18] = {}, largest[6][2] = {};
    const auto column = [](int k) { return k < 16 ? k : k == 16 ? WRC_BY_DISTANCE : WRC_BY_ROLLER_RATE; };
    for (int k = 0; k < 18; ++k) {
      double& value = wrench_input(input, column(k));
      const bool place = k < 4 || (k >= 10 && k < 13) || k == 16;
      // so short that no interval of a table ends within it, where derivatives leap by parts of a thousand
      const double at = value, h = place ? 2e-9 : 1e-5;
      wrc_wrench ends[2] = {wrench, wrench};
      for (const int end : {0, 1}) {
        value = end == 0 ? at - h : at + h;
        ASSERT_EQ(wrc_contact_wrench(contact, &input, &ends[end]), WRC_OK);
      }
      value = at;
      for (int r = 0; r < 6; ++r) {
        const auto of = [&](const wrc_wrench& w) { return r < 3 ? w.force[r] : w.moment[r - 3]; };
        number[r][k] = (of(ends[1]) - of(ends[0])) / (2.0 * h);
        largest[r][place] = std::max(largest[r][place], std::abs(number[r][k]));
      }
    }
    for (int k = 0; k < 18; ++k) {
      const bool place = k < 4 || (k >= 10 && k < 13) || k == 16;
      for (int r = 0; r < 6; ++r)
        EXPECT_NEAR(found.wrench[r][column(k)], number[r][k], 1e-3 * largest[r][place]) << r << ' ' << k;
    }
    wheel.y = -wheel.y;
  }
}

/// Axles one above the other and, with the line of centres leaning, beside each other.
TEST_F(Roller, ExactlyTooItIsHertzsCircle) {
  friction.coefficient = 0.0;
  create();
  const double load = 80e3, a = hertz_radius(load), centres = 2.0 * radius, d = 0.05;
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = load;
  const wrc_wrench above = exactly(2e-4);
  EXPECT_NEAR(above.area, 3.14159265358979 * a * a, 0.01 * above.area);
  EXPECT_NEAR(above.peak_pressure, 1.5 * load / (3.14159265358979 * a * a), 2e-3 * above.peak_pressure);
  EXPECT_NEAR(above.z, a * a / crown, 2e-3 * above.z);
  EXPECT_NEAR(above.force[0], 0.0, 1e-6 * load);
  const double sine = d / (centres - above.z), cosine = std::sqrt(1.0 - sine * sine);
  input.prescribed = WRC_PRESCRIBE_HEIGHT;
  input.vertical_load = 0.0;
  input.distance = d;
  wheel.z = centres - (centres - above.z) * cosine;
  const wrc_wrench beside = exactly(2e-4);
  EXPECT_NEAR(beside.normal_force, load, 1e-3 * load);
  EXPECT_NEAR(beside.force[0] / load, sine, 1e-3 * sine);
  EXPECT_NEAR(-beside.force[2] / load, cosine, 1e-3);
  EXPECT_NEAR(beside.moment[1], 0.0, 1e-5 * load * radius);
}

TEST_F(Roller, ExactlyAndInRealTimeItRollsAlike) {
  create();
  input.roller_rate *= 1.0 - 1e-3;
  wheel.velocity[1] = -0.01;
  carry(80e3);
  const wrc_wrench exact = exactly(4e-4);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(wrench.force[k], exact.force[k], 0.02 * 24e3) << k;
  EXPECT_NEAR(wrench.power, exact.power, 0.05 * exact.power);
  // S1002 and its flange before the axle
  config.wheel = config.rail = sized<wrc_profile>();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  config.track = test_config().track;
  wheel = wrc_wheel_input_default().wheel;
  wheel.y = 6e-3;
  wheel.yaw = 0.01;
  roll_at(20.0);
  create();
  carry(80e3);
  const wrc_wrench flange = exactly(4e-4);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(wrench.force[k], flange.force[k], 0.04 * 24e3) << k;
}

TEST_F(Roller, ExactlyTooAGiantOneIsARail) {
  config.roller_curvature = 0.0;
  create();
  wheel.velocity[0] = 20.0;
  wheel.velocity[1] = 0.02;
  input.roller_rate = 0.0;
  wheel.z = 100e-6;
  const wrc_wrench rail_only = exactly(4e-4);
  config.roller_curvature = 1e-9;
  create();
  wheel.velocity[0] = 0.0;
  input.roller_rate = 20.0 * 1e-9;
  const wrc_wrench giant = exactly(4e-4);
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(giant.force[k], rail_only.force[k], 1e-4 * rail_only.normal_force) << k;
}

/// With flexibilities over k tractions are those of k times the slips, which here are the same everywhere;
/// they dissipate 1 / k as much.
TEST_F(Roller, ExactlyALayerIsAsSmallerSlips) {
  config.roller_curvature = 0.0;
  create();
  input.roller_rate = 0.0;
  wheel.z = 100e-6;
  wheel.velocity[0] = 20.0;
  constexpr double layer = 0.4;
  const auto slide = [&](double by) {
    wheel.velocity[1] = by * 0.02;
    wheel.angular_velocity[1] = -20.0 * (1.0 + by * 1e-3) / config.wheelset.wheel_radius;
  };
  slide(1.0);
  const wrc_wrench clean = exactly(4e-4);
  friction.slope_reduction = layer;
  const wrc_wrench soft = exactly(4e-4);
  ASSERT_EQ(step(), WRC_OK) << error();
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(wrench.force[k], soft.force[k], 0.02 * 0.3 * soft.normal_force) << k;
  friction.slope_reduction = 1.0;
  slide(layer);
  const wrc_wrench slower = exactly(4e-4);
  for (int k = 0; k < 2; ++k)
    EXPECT_NEAR(soft.force[k], slower.force[k], 5e-3 * 0.3 * slower.normal_force) << k;
  EXPECT_NEAR(layer * soft.power, slower.power, 0.02 * slower.power);
  EXPECT_LT(std::abs(soft.force[1]), 0.7 * std::abs(clean.force[1]));
}

TEST_F(Roller, WhatDoesNotBelongToItIsRefused) {
  const auto refused = [&](int32_t status, const char* word) {
    EXPECT_EQ(step(), status);
    EXPECT_NE(error().find(word), std::string::npos) << error();
  };
  const auto no_model = [&](const char* word) {
    char text[256] = "";
    EXPECT_EQ(wrc_config_check(&config, text, sizeof text), WRC_ERROR_UNSUPPORTED);
    EXPECT_NE(std::string(text).find(word), std::string::npos) << text;
  };
  create();
  input.distance = 0.3;
  refused(WRC_ERROR_RANGE, "above its axle");
  input.distance = 0.0;
  config.roller_curvature = 0.0;
  create();
  refused(WRC_ERROR_UNSUPPORTED, "input.roller_rate");
  config.roller_curvature = 2.0;
  config.normal = test_config().normal;
  config.normal.method = WRC_NORMAL_EKP;
  no_model("config.roller_curvature = 2 1/m");
  config.normal.method = WRC_NORMAL_STRIP_HALFSPACE;
  wrc_rail_section section[2] = {};
  for (wrc_rail_section& each : section) each.profile = config.rail;
  section[1].distance = 1.0;
  config.rail_sections = section;
  config.rail_section_size = sizeof section[0];
  config.rail_section_count = 2;
  no_model("no sections");
}

}  // namespace
