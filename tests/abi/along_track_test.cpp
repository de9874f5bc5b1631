/// A rail that changes along the track and a wheel that is not round, seen through the C interface.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "../check_rail_points.hpp"
#include "not_finite.hpp"
#include "wheel_on_rail.hpp"

namespace {

constexpr double turn = 6.283185307179586, radius = 0.46;

class AlongTrack : public testing::Test, protected PlacedWheel {
 protected:
  std::vector<wrc_rail_section> sections;
  std::vector<double> angles, deviations;

  wrc_rail_section& add(double distance, double z = 0.0, double y = 0.0) {
    wrc_rail_section section{};
    section.distance = distance;
    section.y = y;
    section.z = z;
    section.profile.kind = WRC_PROFILE_UIC60_BENCHMARK;
    sections.push_back(section);
    return sections.back();
  }
  void give() {
    config.rail_sections = static_cast<uint32_t>(sections.size());
    config.rail_section = sections.data();
  }
  template <class Deviation>
  void give_wheel(int count, Deviation&& of) {
    angles.clear();
    deviations.clear();
    for (int i = 0; i <= count; ++i) {
      angles.push_back(turn * i / count);
      deviations.push_back(of(turn * (i % count) / count));
    }
    config.roundness.angles = static_cast<uint32_t>(angles.size());
    config.roundness.rows = 1;
    config.roundness.angle = angles.data();
    config.roundness.deviation = deviations.data();
  }
  int32_t refused() {
    char text[256] = "";
    const int32_t status = wrc_config_check(&config, text, sizeof text);
    sentence = text;
    return status;
  }
  /// Level up to 2 m and from 5 m on, between them 1:50 downwards: straight from 3 to 4 m, rounded beside
  /// that.
  void give_ramp() {
    const double z[] = {0.0, 0.0, 0.0, 0.02, 0.04, 0.06, 0.06, 0.06};
    for (int k = 0; k < 8; ++k) add(1.0 * k, z[k]);
    give();
  }
  std::string sentence;
};

TEST_F(AlongTrack, EqualSectionsAreTheConstantRail) {
  friction.coefficient = 0.3;
  wheel.y = 3e-3;
  wheel.z = 100e-6;
  wheel.yaw = 5e-3;
  create();
  ASSERT_EQ(step(), WRC_OK);
  const wrc_wrench constant = wrench;
  for (double distance : {-20.0, -3.0, 10.0}) add(distance);
  give();
  create();
  for (const double at : {-12.3, -3.0, 0.0, 7.7}) {
    input.distance = at;
    ASSERT_EQ(step(), WRC_OK);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(wrench.force[i], constant.force[i], 1e-3 * constant.normal_force) << i << " at " << at;
      EXPECT_NEAR(wrench.moment[i], constant.moment[i], 1e-3 * constant.normal_force) << i << " at " << at;
    }
  }
}

TEST_F(AlongTrack, OnASlopeThePressureHasAPartAlongTheTrack) {
  give_ramp();
  friction.coefficient = 0.0;
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 80e3;
  create();
  input.distance = 0.5;
  ASSERT_EQ(step(), WRC_OK);
  EXPECT_NEAR(wrench.force[0], 0.0, 1e-6);
  const double level = wrench.z;
  input.distance = 3.5;  // within the straight part
  ASSERT_EQ(step(), WRC_OK);
  EXPECT_NEAR(wrench.force[0], 0.02 * 80e3, 1e-3 * 0.02 * 80e3);
  // the wheel touches r sin(angle) behind, where the rail is higher, by its circle: z = slope^2 r / 2 less
  EXPECT_NEAR(wrench.z - level, 0.03 - 0.5 * 0.02 * 0.02 * radius, 2e-6);
}

TEST_F(AlongTrack, OutsideItsSectionsTheNearestIsUsedAndFlagged) {
  give_ramp();
  wheel.y = 3e-3;
  wheel.z = 100e-6;
  create();
  input.distance = -0.1;
  EXPECT_EQ(step(), WRC_FLAG_BEYOND_SECTIONS);
  const double before = wrench.force[2];
  EXPECT_NE(error().find("nearest section"), std::string::npos) << error();
  input.distance = 0.0;
  EXPECT_EQ(step(), WRC_OK);
  EXPECT_EQ(wrench.force[2], before);
}

TEST_F(AlongTrack, ADistanceWithoutSectionsAndAnAngleOfARoundWheelAreRefused) {
  create();
  input.distance = 1.0;
  EXPECT_EQ(step(), WRC_ERROR_UNSUPPORTED);
  input.distance = 0.0;
  input.angle = 1.0;
  EXPECT_EQ(step(), WRC_ERROR_UNSUPPORTED);
}

TEST_F(AlongTrack, DerivativesAreThoseOfDifferences) {
  give_ramp();
  give_wheel(720, [](double a) { return 1e-4 * std::cos(7.0 * a) + 5e-5 * std::sin(3.0 * a); });
  friction.coefficient = 0.3;
  create();
  input.distance = 2.6;
  input.angle = -0.3;
  wheel.y = 2e-3;
  wheel.yaw = 4e-3;
  wheel.roll = 1e-3;
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 60e3;
  ASSERT_EQ(step(), WRC_OK);
  input.prescribed = WRC_PRESCRIBE_HEIGHT;
  input.vertical_load = 0.0;
  wheel.z = wrench.z;
  wrc_wrench_sensitivities slopes;
  ASSERT_EQ(wrc_contact_wrench_sensitivities(contact, &input, &wrench, &slopes), WRC_OK);
  const double normal = wrench.normal_force;
  ASSERT_GT(normal, 20e3);
  struct {
    double* number;
    int column;
    double step;
  } const each[] = {{&input.distance, WRC_BY_DISTANCE, 1e-6},
                    {&input.angle, WRC_BY_ANGLE, 2e-6},
                    {&wheel.y, WRC_BY_Y, 1e-7},
                    {&wheel.z, WRC_BY_Z, 1e-7},
                    {&wheel.yaw, WRC_BY_YAW, 1e-7},
                    {&wheel.roll, WRC_BY_ROLL, 1e-7},
                    {&wheel.velocity[1], WRC_BY_VELOCITY_Y, 1e-4}};
  for (const auto& [number, column, h] : each) {
    const double at = *number;
    wrc_wrench above, below;
    *number = at + h;
    ASSERT_EQ(step(), WRC_OK);
    above = wrench;
    *number = at - h;
    ASSERT_EQ(step(), WRC_OK);
    below = wrench;
    *number = at;
    double largest = 0.0;
    for (int i = 0; i < 3; ++i) largest = std::max(largest, std::abs(slopes.wrench[i][column]));
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR((above.force[i] - below.force[i]) / (2.0 * h), slopes.wrench[i][column], 0.01 * largest)
          << "force " << i << " by " << column;
      EXPECT_NEAR((above.moment[i] - below.moment[i]) / (2.0 * h), slopes.wrench[3 + i][column],
                  0.01 * largest)
          << "moment " << i << " by " << column;
    }
  }
}

TEST_F(AlongTrack, TheFlatCallKnowsDistanceAndAngle) {
  give_ramp();
  give_wheel(720, [](double a) { return 1e-4 * std::cos(7.0 * a); });
  create();
  input.distance = 2.6;
  input.angle = -0.3;
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 60e3;
  ASSERT_EQ(step(), WRC_OK) << error();
  double in[WRC_FLAT_WHEEL_INPUTS] = {}, out[WRC_FLAT_WHEEL_OUTPUTS];
  in[5] = wheel.velocity[0], in[9] = wheel.angular_velocity[1], in[17] = friction.coefficient;
  in[18] = 1.0, in[19] = 60e3, in[21] = input.distance, in[22] = input.angle;
  ASSERT_EQ(wrc_contact_wrench_flat(contact, in, out), WRC_OK) << error();
  for (int i = 0; i < 3; ++i) EXPECT_EQ(out[i], wrench.force[i]);
}

TEST_F(AlongTrack, AFlatLowersTheWheelAsItsSupportFunctionSays) {
  // a worn flat: a cosine of 0.5 mm over 90 mm, so long that it is convex
  constexpr double deep = 0.5e-3, half = 0.045 / radius;
  const auto flat = [&](double a) {
    const double from = a > 0.5 * turn ? a - turn : a;
    return std::abs(from) < half ? -0.5 * deep * (1.0 + std::cos(0.5 * turn * from / half)) : 0.0;
  };
  give_wheel(4000, flat);
  friction.coefficient = 0.0;
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 1e3;
  create();
  input.angle = 0.5 * turn;
  ASSERT_EQ(step(), WRC_OK);
  const double round = wrench.z;
  for (int i = -20; i <= 20; ++i) {
    const double at = 1.3 * half * i / 20;  // of the flat's middle from the lowest point
    double reach = -1.0;
    for (int k = -4000; k <= 4000; ++k) {
      const double from = 2.0 * half * k / 4000;
      reach = std::max(reach, (radius + flat(from < 0.0 ? from + turn : from)) * std::cos(from - at));
    }
    input.angle = -at;
    ASSERT_EQ(step(), WRC_OK);
    EXPECT_NEAR(wrench.z - round, radius - reach, 2e-6) << "at " << at / half;
  }
}

TEST_F(AlongTrack, ABladeBesideTheStockRailCarriesItsShare) {
  add(0.0);
  add(10.0);
  for (const double distance : {4.0, 6.0}) {
    wrc_rail_section& blade = add(distance, 30e-6);  // the same head, lower
    blade.face = 1;
  }
  give();
  wheel.y = 3e-3;
  wheel.z = 100e-6;
  create();
  input.distance = 1.0;
  ASSERT_EQ(step(), WRC_OK);
  const double alone = wrench.normal_force;
  input.distance = 5.0;
  ASSERT_EQ(step(), WRC_OK);
  EXPECT_EQ(wrench.regions, 2);
  wrc_region region = wrc_region_default();
  ASSERT_EQ(wrc_contact_region(contact, 0, &region), WRC_OK);
  EXPECT_NEAR(region.normal_force, alone, 0.01 * alone);
  ASSERT_EQ(wrc_contact_region(contact, 1, &region), WRC_OK);
  EXPECT_LT(region.normal_force, 0.8 * alone);
  EXPECT_GT(region.normal_force, 0.3 * alone);
}

/// A face behind the flange, higher than the rail: what of it looks away from the wheel is not met through
/// the wheel's body.
TEST_F(AlongTrack, AFaceThatTheWheelDoesNotReachChangesNothing) {
  wheel.y = 2e-3;
  wheel.z = 100e-6;
  input.distance = 0.5;
  for (const double z : {-0.02, 0.0}) {
    for (const double beside : {-0.2, -0.113, 0.113}) {
      sections.clear();
      add(0.0);
      add(1.0);
      give();
      create();
      ASSERT_EQ(step(), WRC_OK) << error();
      const wrc_wrench alone = wrench;
      for (const double distance : {0.0, 1.0}) add(distance, z, beside).face = 1;
      give();
      create();
      ASSERT_EQ(step(), WRC_OK) << error();
      EXPECT_EQ(wrench.regions, alone.regions);
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(wrench.force[i], alone.force[i], 2e-3 * alone.normal_force) << i;
    }
  }
}

/// As a face of its own a check rail is what config.check_rail makes of it.
TEST_F(AlongTrack, AFaceBehindTheFlangeIsACheckRail) {
  const CheckRailPoints points;
  wheel.z = 0.18e-3;
  config.rail.kind = WRC_PROFILE_60E1;
  config.track.placement = WRC_PLACEMENT_ORIGIN;
  config.track.rail_origin = 0.7535;
  config.check_rail.profile = points.profile();
  config.check_rail.y = -0.0813;
  config.check_rail.z = -0.020;
  double low = -12e-3, high = 0.0;  // at which it carries about 30 kN
  create();
  for (int n = 0; n < 24; ++n) {
    wheel.y = 0.5 * (low + high);
    ASSERT_GE(step(), 0) << error();
    double carried = 0.0;
    for (int32_t i = 0; i < wrench.regions; ++i) {
      wrc_region region = wrc_region_default();
      ASSERT_EQ(wrc_contact_region(contact, i, &region), WRC_OK);
      if (region.face == 0) carried += region.normal_force;
    }
    (carried > 30e3 ? low : high) = wheel.y;
  }
  const int32_t status = step();  // the end of the wheel's profile is in it
  ASSERT_GE(status, 0) << error();
  const wrc_wrench checked = wrench;
  ASSERT_GT(checked.steepest_angle, 1.0);
  for (const double distance : {0.0, 1.0}) {
    wrc_rail_section& check = add(distance, config.check_rail.z, config.check_rail.y);
    check.profile = points.profile();
  }
  for (const double distance : {0.0, 1.0}) {
    wrc_rail_section& running = add(distance);
    running.face = 1;
    running.profile = config.rail;
  }
  give();
  config.check_rail = wrc_config_default().check_rail;
  create();
  input.distance = 0.5;
  ASSERT_EQ(step(), status) << error();
  EXPECT_EQ(wrench.regions, checked.regions);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(wrench.force[i], checked.force[i], 1e-9 * checked.normal_force) << i;
}

TEST_F(AlongTrack, SectionsOutOfOrderAreNamed) {
  add(1.0);
  add(0.5);
  give();
  EXPECT_EQ(refused(), WRC_ERROR_RANGE);
  EXPECT_NE(sentence.find("in order"), std::string::npos) << sentence;
  sections[1].distance = 2.0;
  sections[1].marks = 1;
  const double mark = 0.0;
  sections[1].mark = &mark;
  EXPECT_EQ(refused(), WRC_ERROR_PROFILE) << sentence;
  sections[0].marks = 1;
  const double beside = 0.3;
  sections[0].mark = &beside;
  EXPECT_EQ(wrc_model_create(&config, nullptr, &model), WRC_ERROR_PROFILE);
  sections[0].mark = &mark;
  EXPECT_EQ(refused(), WRC_OK) << sentence;
  sections[1].face = 2;
  EXPECT_EQ(refused(), WRC_ERROR_RANGE) << sentence;
  sections[1].face = 0;
  sections[1].distance = nan_value;
  EXPECT_EQ(refused(), WRC_ERROR_NOT_FINITE) << sentence;
}

TEST_F(AlongTrack, SectionsThatOverlapAreNamed) {
  add(1.0);
  add(1.0005);
  give();
  EXPECT_EQ(refused(), WRC_ERROR_RANGE);
  EXPECT_NE(sentence.find("config.rail_section.distance"), std::string::npos) << sentence;
  sections[1].distance = 1.0;
  EXPECT_EQ(refused(), WRC_ERROR_RANGE) << sentence;
  sections[1].distance = 2.0;
  EXPECT_EQ(refused(), WRC_OK) << sentence;
  // a face that goes on behind another one's sections
  add(0.0).face = 1;
  add(3.0).face = 1;
  add(4.0);
  give();
  EXPECT_EQ(refused(), WRC_ERROR_RANGE);
  EXPECT_NE(sentence.find("config.rail_section.face"), std::string::npos) << sentence;
}

TEST_F(AlongTrack, ProfilesThatCannotBePairedAreNamed) {
  const auto cannot = [&](const char* word) {
    const int32_t status = wrc_model_create(&config, nullptr, &model);
    EXPECT_EQ(status, WRC_ERROR_PROFILE);
    EXPECT_EQ(model, nullptr);
    EXPECT_EQ(refused(), WRC_ERROR_PROFILE) << sentence;
    EXPECT_NE(sentence.find("config.rail_section"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find(word), std::string::npos) << sentence;
  };
  std::vector<double> y, z, steep;
  for (int i = -180; i <= 180; ++i) {
    y.push_back(2e-4 * i);
    z.push_back(y.back() * y.back() / 0.6);
    steep.push_back(y.back() > 0.0 ? 3.0 * y.back() : z.back());
  }
  add(0.0);
  add(1.0);
  give();
  for (wrc_rail_section& each : sections) {
    each.profile.kind = WRC_PROFILE_POINTS;
    each.profile.count = static_cast<uint32_t>(y.size());
    each.profile.y = y.data();
    each.profile.z = z.data();
  }
  EXPECT_EQ(refused(), WRC_OK) << sentence;
  // marks that make 3 mm of one outline a pair of 36 mm of the other
  const double marks[] = {-0.033, 0.0};
  for (std::size_t k : {0U, 1U}) {
    sections[k].marks = 1;
    sections[k].mark = &marks[k];
  }
  cannot("cannot be paired");
  // turned by more than 60 degrees where the other one is level
  for (wrc_rail_section& each : sections) {
    each.marks = 0;
    each.mark = nullptr;
  }
  sections[1].profile.z = steep.data();
  cannot("no pair");
}

TEST_F(AlongTrack, ARadiusThatDoesNotCloseIsNamed) {
  give_wheel(36, [](double a) { return 1e-4 * std::cos(a); });
  EXPECT_EQ(refused(), WRC_OK) << sentence;
  deviations.back() += 1e-4;
  EXPECT_EQ(refused(), WRC_ERROR_RANGE);
  EXPECT_NE(sentence.find("close"), std::string::npos) << sentence;
  deviations.back() -= 1e-4;
  angles.back() -= 0.1;
  EXPECT_EQ(refused(), WRC_ERROR_RANGE);
  angles.back() += 0.1;
  angles[5] = angles[4];
  EXPECT_EQ(refused(), WRC_ERROR_RANGE);
  config.normal.method = WRC_NORMAL_HERTZ;
  angles[5] = 0.5 * (angles[4] + angles[6]);
  EXPECT_EQ(refused(), WRC_ERROR_UNSUPPORTED);
}

}  // namespace
