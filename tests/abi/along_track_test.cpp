/// A rail that changes along the track and a wheel that is not round, seen through the C interface.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "../check_rail_points.hpp"
#include "field_values.hpp"
#include "not_finite.hpp"
#include "test_config.hpp"
#include "wheel_on_rail.hpp"
#include "wrc/wrc_damage.h"
#include "wrc/wrc_offline.h"

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
    config.rail_section_count = static_cast<uint32_t>(sections.size());
    config.rail_sections = sections.data();
    config.rail_section_size = sizeof sections[0];
  }
  /// All sections have these points, which stay the caller's.
  void give_points(const std::vector<double>& y, const std::vector<double>& z) {
    for (wrc_rail_section& each : sections) {
      each.profile.kind = WRC_PROFILE_POINTS;
      each.profile.count = static_cast<uint32_t>(y.size());
      each.profile.y = y.data();
      each.profile.z = z.data();
    }
  }
  template <class Deviation>
  void give_wheel(int count, Deviation&& of) {
    angles.clear();
    deviations.clear();
    for (int i = 0; i <= count; ++i) {
      angles.push_back(turn * i / count);
      deviations.push_back(of(turn * (i % count) / count));
    }
    config.roundness.angle_count = static_cast<uint32_t>(angles.size());
    config.roundness.row_count = 1;
    config.roundness.angles = angles.data();
    config.roundness.deviations = deviations.data();
  }
  int32_t refused() {
    char text[256] = "";
    const int32_t status = wrc_config_check(&config, text, sizeof text);
    sentence = text;
    return status;
  }
  /// A contact without friction, under a load [N].
  void create_under(double load) {
    friction.coefficient = 0.0;
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = load;
    create();
  }
  /// The height under the load, at a distance along the track [m].
  double height_at(double distance) {
    input.distance = distance;
    EXPECT_GE(step(), WRC_OK) << error();
    return wrench.z;
  }
  /// Level up to 2 m and from 5 m on, between them 1:50 downwards: straight from 3 to 4 m, rounded beside
  /// that.
  void give_ramp() {
    const double z[] = {0.0, 0.0, 0.0, 0.02, 0.04, 0.06, 0.06, 0.06};
    for (int k = 0; k < 8; ++k) add(1.0 * k, z[k]);
    give();
  }
  /// Derivatives at the height that carries a load against differences [N].
  void expect_differences(double load = 60e3) {
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = load;
    ASSERT_EQ(step(), WRC_OK);
    input.prescribed = WRC_PRESCRIBE_HEIGHT;
    input.vertical_load = 0.0;
    wheel.z = wrench.z;
    auto slopes = sized<wrc_wrench_derivatives>();
    ASSERT_EQ(wrc_contact_wrench_derivatives(contact, &input, &wrench, &slopes), WRC_OK);
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
      ASSERT_EQ(step(), WRC_OK) << error();
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
  create_under(80e3);
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
  expect_differences();
}

/// A rail that rises 1:10 and moves aside 1:9 under a wheel that is not round.
TEST_F(AlongTrack, DerivativesOnACrossingsNoseAreThoseOfDifferences) {
  for (int k = 0; k < 12; ++k)
    add(0.02 * k, -2e-3 * k, 20e-3 / 9.0 * k - 12e-3).profile.kind = WRC_PROFILE_60E1;
  give();
  give_wheel(720, [](double a) { return 1e-4 * std::cos(7.0 * a); });
  friction.coefficient = 0.3;
  create();
  input.distance = 0.1012;
  input.angle = -0.3;
  wheel.y = 1e-3;
  wheel.yaw = 4e-3;
  expect_differences();
}

TEST_F(AlongTrack, AFlatLowersTheWheelAsItsSupportFunctionSays) {
  // a worn flat: a cosine of 0.5 mm over 90 mm, so long that it is convex
  constexpr double deep = 0.5e-3, half = 0.045 / radius;
  const auto flat = [&](double a) {
    const double from = a > 0.5 * turn ? a - turn : a;
    return std::abs(from) < half ? -0.5 * deep * (1.0 + std::cos(0.5 * turn * from / half)) : 0.0;
  };
  give_wheel(4000, flat);
  create_under(1e3);
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
    blade.surface = 1;
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
  EXPECT_EQ(wrench.region_count, 2);
  wrc_region region = sized<wrc_region>();
  ASSERT_EQ(wrc_contact_region(contact, 0, &region), WRC_OK);
  EXPECT_NEAR(region.normal_force, alone, 0.01 * alone);
  ASSERT_EQ(wrc_contact_region(contact, 1, &region), WRC_OK);
  EXPECT_LT(region.normal_force, 0.8 * alone);
  EXPECT_GT(region.normal_force, 0.3 * alone);
}

/// A wheel that left a blade since its mark: what a contact has done besides has no part in the result.
TEST_F(AlongTrack, ABladeLeftSinceTheMarkLeavesNoTrace) {
  add(0.0);
  add(10.0, 1e-4);
  for (const double distance : {4.0, 6.0}) {
    wrc_rail_section& blade = add(distance, 7e-5 - 2e-5 * (distance - 4.0));
    blade.surface = 1;
    blade.y = 0.2e-3 * (distance - 4.0);
  }
  give();
  wheel.y = 3e-3;
  create_under(60e3);
  input.start = WRC_START_MARK;
  input.distance = 4.5;
  ASSERT_EQ(step(), WRC_OK);
  EXPECT_EQ(wrench.region_count, 2);
  ASSERT_EQ(wrc_contact_mark(contact), WRC_OK);
  uint64_t bytes = 0;
  ASSERT_EQ(wrc_contact_state_size(model, &bytes), WRC_OK);
  std::vector<char> state(bytes);
  ASSERT_EQ(wrc_contact_save(contact, state.data(), bytes), WRC_OK);
  const auto beyond = [&] {
    input.distance = 7.0;
    EXPECT_EQ(step(), WRC_OK) << error();
    return wrench;
  };
  const wrc_wrench once = beyond();
  for (const double visited : {0.0, 5.9, 2.0}) {
    take(side);  // a contact that has seen nothing, and elsewhere the blade or the rail alone
    if (visited > 0.0) {
      input.distance = visited;
      ASSERT_EQ(step(), WRC_OK);
    }
    ASSERT_EQ(wrc_contact_restore(contact, state.data(), bytes), WRC_OK) << error();
    const wrc_wrench again = beyond();
    EXPECT_EQ(std::memcmp(&once, &again, sizeof once), 0) << visited;
  }
}

/// Where a second rail begins, higher by a step, the wheel climbs it by its circle: it meets the edge from
/// root(2 r step) before it. Nothing leaps over a micrometre, and contact at the edge is flagged.
TEST_F(AlongTrack, AWheelClimbsTheEndOfASurface) {
  constexpr double step_up = 0.5e-3;
  add(0.0);
  add(1.0);
  for (const double distance : {1.0, 2.0}) add(distance, -step_up).surface = 1;
  give();
  constexpr double load = 0.5e3;
  create_under(load);
  const double level = height_at(0.5), far = std::sqrt(2.0 * radius * step_up);
  for (const double before : {0.06, 0.03, 0.02, 0.015, 0.01, 0.005}) {
    const double z = height_at(1.0 - before), share = std::min(before / far, 1.0);
    EXPECT_NEAR(level - z, step_up * (1.0 - share * share), 4e-6) << before;
    const bool on_edge = before < far;
    EXPECT_EQ((wrench.flags & WRC_FLAG_BIT(WRC_FLAG_PATCH_AT_EDGE)) != 0, on_edge) << before;
    EXPECT_EQ(error().find("end of surface[1]") != std::string::npos, on_edge) << error();
    // over a micrometre the height moves as far as the force along the track does work
    const double along = wrench.force[0], next = height_at(1.0 - before + 1e-6);
    EXPECT_NEAR((next - z) / 1e-6, along / load, 2e-3) << before;
  }
  EXPECT_NEAR(height_at(1.5), level - step_up, 1e-9);
  EXPECT_EQ(wrench.flags, 0U);
}

/// The exact solver has no cells beyond the end of a surface either.
TEST_F(AlongTrack, ExactContactEndsWithItsSurface) {
  add(0.0);
  add(1.0);
  for (const double distance : {0.4, 0.6}) add(distance, -50e-6).surface = 1;
  give();
  friction.coefficient = 0.0;
  wheel.z = 250e-6;
  create();
  auto options = wrc_exact_wrench_options_default();
  options.cell_x = options.cell_s = 0.4e-3;
  const auto load_at = [&](double distance) {
    input.distance = distance;
    EXPECT_GE(wrc_exact_wrench(contact, &input, &options, &wrench), WRC_OK) << error();
    return wrench.normal_force;
  };
  const double both = load_at(0.5), alone = load_at(0.2);
  EXPECT_NEAR(load_at(0.4 - 15e-3), alone, 1e-6 * alone);
  EXPECT_EQ(wrench.flags, 0U);
  EXPECT_NEAR(load_at(0.4 + 15e-3), both, 1e-3 * both);
  EXPECT_EQ(wrench.flags, 0U);
  // the second surface ends under the middle of the contact: strips in real time are cut there
  const double half = load_at(0.4) - alone;
  EXPECT_GT(half, 0.3 * (both - alone));
  EXPECT_LT(half, 0.9 * (both - alone));
  EXPECT_NE(wrench.flags & WRC_FLAG_BIT(WRC_FLAG_PATCH_AT_EDGE), 0U);
  EXPECT_EQ(step(), WRC_FLAG_PATCH_AT_EDGE) << error();
  EXPECT_NEAR(wrench.normal_force, half + alone, 0.08 * (half + alone));
}

/// A rail that moves sideways 1:9 into the flange is met up to 90 mm ahead, and the wheel climbs. The change
/// of height is that by which the force along the track does work.
TEST_F(AlongTrack, AFlangeMeetsARailThatMovesSidewaysFarAhead) {
  for (int k = 0; k < 40; ++k) {
    wrc_rail_section& section = add(0.02 * k, 0.0, k < 20 ? 0.0 : -(k - 20) * 20e-3 / 9.0);
    section.profile.kind = WRC_PROFILE_60E1;
  }
  give();
  config.rail.kind = WRC_PROFILE_60E1;
  config.track.rail_inclination = 0.025;
  create_under(60e3);
  wheel.y = 4e-3;
  constexpr double h = 0.1e-3;
  for (const double distance : {0.2, 0.38, 0.4, 0.42, 0.45, 0.49, 0.6}) {
    const double before = height_at(distance - h), behind = height_at(distance + h);
    height_at(distance);
    EXPECT_EQ(wrench.flags, 0U) << distance;
    EXPECT_NEAR((behind - before) / (2.0 * h), wrench.force[0] / 60e3, 0.01) << distance;
  }
}

/// A step of 8 mm is met from 86 mm before it on, and climbed without a jump of the height.
TEST_F(AlongTrack, AWheelClimbsAHighStep) {
  constexpr double step_up = 8e-3, h = 10e-6;
  add(0.0);
  add(1.0);
  for (const double distance : {1.0, 2.0}) add(distance, -step_up).surface = 1;
  give();
  create_under(60e3);
  const double z_level = height_at(0.5);
  double z[2] = {height_at(1.0 - 90e-3), height_at(1.0 - 90e-3 + h)};
  for (int k = 2; k < 1000; ++k) {
    const double now = height_at(1.0 - 90e-3 + k * h);
    ASSERT_NEAR(now - z[1], z[1] - z[0], 1e-6) << k;  // [m]
    z[0] = z[1];
    z[1] = now;
  }
  EXPECT_LT(z[1], z_level - 0.1e-3);
}

/// A dip curved more than the wheel: the wheel goes over from one side to the other, and nothing else leaps.
TEST_F(AlongTrack, AWheelRollsThroughADipShorterThanItself) {
  constexpr double deep = 0.2e-3, half = 20e-3;
  add(-0.3);
  for (int k = -10; k <= 10; ++k) {
    const double x = 0.2 * half * k;
    add(x, std::abs(x) < half ? 0.5 * deep * (1.0 + std::cos(0.5 * turn * x / half)) : 0.0);
  }
  add(0.3);
  give();
  create_under(60e3);
  input.distance = -0.2;
  ASSERT_EQ(step(), WRC_OK) << error();
  const double level = wrench.z;
  double before = level, deepest = 0.0;
  for (int k = -300; k <= 300; ++k) {
    input.distance = 1e-4 * k;
    // both sides carry it at the middle, nearer to each other than a contact is long
    if (const int32_t status = step(); std::abs(k) > 11) {
      ASSERT_EQ(status, WRC_OK) << error() << k;
    } else if (std::abs(k) <= 5) {
      ASSERT_EQ(status, WRC_FLAG_MORE_PATCHES) << k;
    }
    EXPECT_LT(std::abs(wrench.z - before), 10e-6) << input.distance;
    EXPECT_LT(wrench.peak_pressure, 2e9) << input.distance;
    before = wrench.z;
    deepest = std::max(deepest, wrench.z - level);
  }
  EXPECT_GT(deepest, 0.7 * deep);
  EXPECT_LT(deepest, deep);
}

/// A ramp that ends: the wheel touches it and its upper end at once, and goes over from one to the other.
class TwoPlaces : public AlongTrack {
 protected:
  void SetUp() override { give_ramp(0.1); }
  /// Rises by `slope` up to 0.1 m.
  void give_ramp(double slope) {
    sections.clear();
    for (int k = -10; k <= 20; ++k) add(0.01 * k, slope * (std::max(0.0, 0.1 - 0.01 * k) - 0.1));
    give();
  }
  /// Touches both, with friction, at a height of its own.
  void touch_both() {
    wheel.y = 1e-3;
    wheel.yaw = 3e-3;
    wheel.velocity[1] = 0.02;
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = 60e3;
    input.distance = 39e-3;
    create();
    ASSERT_EQ(step(), WRC_OK) << error();
    ASSERT_EQ(wrench.region_count, 2);
  }
};

TEST_F(TwoPlaces, AreNoLeapAndCarryAsMuchAsTheExactSolverHas) {
  auto options = wrc_exact_wrench_options_default();
  options.cell_x = options.cell_s = 0.3e-3;
  create_under(40e3);
  double force[2] = {}, last = 0.0;
  int touched_twice = 0;
  for (int k = 0; k <= 400; ++k) {
    input.distance = 33e-3 + 30e-6 * k;
    ASSERT_EQ(step(), WRC_OK) << error() << input.distance;
    const double now = wrench.force[0];
    const double jump = k > 1 ? std::abs(now - 2.0 * force[0] + force[1]) : 0.0;
    EXPECT_LT(jump, 5e-4 * 40e3) << input.distance;
    force[1] = std::exchange(force[0], now);
    EXPECT_LT(std::abs(wrench.z - last), k > 0 ? 10e-6 : 1.0);
    last = wrench.z;
    touched_twice += wrench.region_count > 1 ? 1 : 0;
    if (k % 80 != 0) continue;
    input.prescribed = WRC_PRESCRIBE_HEIGHT;
    input.vertical_load = 0.0;
    wheel.z = last;
    EXPECT_EQ(wrc_exact_wrench(contact, &input, &options, &wrench), WRC_OK) << error();
    EXPECT_NEAR(wrench.force[2], -40e3, 0.015 * 40e3) << input.distance;
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = 40e3;
  }
  EXPECT_GT(touched_twice, 80);
}

TEST_F(TwoPlaces, DerivativesAreDifferences) {
  give_wheel(720, [](double a) { return 1e-5 * std::cos(7.0 * a); });
  create();
  wheel.y = 1e-3;
  wheel.yaw = 3e-3;
  for (const double distance : {39e-3, 40e-3, 41e-3}) {
    input.distance = distance;
    expect_differences();
    EXPECT_GT(wrench.region_count, 1) << distance;
  }
}

/// A top that arises, and one whose valley is shallow, count in part. The part changes with the pose.
TEST_F(TwoPlaces, DerivativesAreDifferencesWhereATopCountsInPart) {
  give_wheel(720, [](double a) { return 1e-5 * std::cos(7.0 * a); });
  wheel.y = 1e-3;
  wheel.yaw = 3e-3;
  for (const auto& [slope, distance] :
       {std::pair(1.0 / 12.0, 52.25e-3), {1.0 / 12.0, 52.35e-3}, {0.05, 68e-3}}) {
    give_ramp(slope);
    create();
    input.distance = distance;
    expect_differences(150e3);
    EXPECT_GT(wrench.region_count, 1) << distance;
  }
}

/// On gentle ramps the second top rises little and is near the first one, between two places that are looked
/// at. It is found all the same: nothing is flagged there, and the force does not leap.
TEST_F(TwoPlaces, AreFoundWhereTopsAreNearEachOther) {
  constexpr struct {
    double slope, load, from, to;
  } each[] = {{0.05, 150e3, 60e-3, 61.5e-3}, {0.04, 60e3, 67e-3, 68.8e-3}};
  for (const auto& [slope, load, from, to] : each) {
    give_ramp(slope);
    create_under(load);
    double force[2] = {};
    int touched_twice = 0;
    for (int k = 0; from + 20e-6 * k < to; ++k) {
      input.distance = from + 20e-6 * k;
      ASSERT_EQ(step(), WRC_OK) << error() << input.distance;
      const double now = wrench.force[0];
      if (k > 1) {
        EXPECT_LT(std::abs(now - 2.0 * force[0] + force[1]), 5e-4 * load) << input.distance;
      }
      force[1] = std::exchange(force[0], now);
      touched_twice += wrench.region_count > 1 ? 1 : 0;
    }
    EXPECT_GT(touched_twice, 25) << slope;
  }
}

/// Where two tops are nearer to each other than the contact is long, or one beside it does not count, the
/// force is more than 5 % less than the exact solver's: flagged. Steep ramps are not.
TEST_F(TwoPlaces, OfAGentleRampAreFlaggedWhereTheForceIsTooSmall) {
  auto options = wrc_exact_wrench_options_default();
  options.cell_x = options.cell_s = 0.3e-3;
  constexpr struct {
    double slope, load, at;
    int32_t status;
  } each[] = {{0.05, 150e3, 65e-3, WRC_FLAG_MORE_PATCHES},
              {0.025, 20e3, 78e-3, WRC_FLAG_MORE_PATCHES},
              {0.04, 60e3, 70.5e-3, WRC_FLAG_MORE_PATCHES},
              {1.0 / 15.0, 60e3, 62e-3, WRC_OK},
              {0.1, 150e3, 41e-3, WRC_OK},
              {0.1, 20e3, 45e-3, WRC_OK}};
  for (const auto& [slope, load, at, status] : each) {
    give_ramp(slope);
    create_under(load);
    input.distance = at;
    ASSERT_EQ(step(), status) << error() << slope;
    input.prescribed = WRC_PRESCRIBE_HEIGHT;
    input.vertical_load = 0.0;
    wheel.z = wrench.z;
    ASSERT_EQ(wrc_exact_wrench(contact, &input, &options, &wrench), WRC_OK) << error();
    const double missing = (-wrench.force[2] - load) / load;
    if (status == WRC_OK) {
      EXPECT_LT(std::abs(missing), 0.04) << slope;
    } else {
      EXPECT_GT(missing, 0.08) << slope;
    }
  }
}

/// Where one top of a strip is deep enough for a contact and the other is not, the strips that share a vector
/// differ from one instruction set to the next. The result does not.
TEST_F(TwoPlaces, HaveTheSameBitsOnEveryInstructionSet) {
  give_ramp(0.04);
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 20e3;
  std::vector<wrc_wrench> baseline;
  for (const int32_t set : {WRC_INSTRUCTIONS_BASELINE, WRC_INSTRUCTIONS_AVX2, WRC_INSTRUCTIONS_AVX512}) {
    config.instruction_set = set;
    if (set != WRC_INSTRUCTIONS_BASELINE && refused() != WRC_OK) continue;  // not of this processor
    create();
    std::size_t call = 0;
    for (const double y : {0.0, 1e-3})
      for (int k = 0; k < 8; ++k) {
        wheel.y = y;
        input.distance = 70.2e-3 + 0.6e-3 * k;
        ASSERT_GE(step(), WRC_OK) << error();
        if (set == WRC_INSTRUCTIONS_BASELINE) baseline.push_back(wrench);
        EXPECT_EQ(std::memcmp(&baseline[call++], &wrench, sizeof wrench), 0) << set << ' ' << input.distance;
      }
  }
}

/// Regions, fields, wear and sums along the line are of both places.
TEST_F(TwoPlaces, HaveResultsOfTheirOwn) {
  touch_both();
  double power = 0.0, from[2] = {};
  for (int32_t k = 0; k < 2; ++k) {
    auto region = sized<wrc_region>();
    ASSERT_EQ(wrc_contact_region(contact, k, &region), WRC_OK);
    const FieldValues y = field_values(contact, k, WRC_FIELD_STRIP_Y),
                      width = field_values(contact, k, WRC_FIELD_STRIP_WIDTH),
                      half = field_values(contact, k, WRC_FIELD_STRIP_HALF_LENGTH),
                      p = field_values(contact, k, WRC_FIELD_PRESSURE),
                      q = field_values(contact, k, WRC_FIELD_TRACTION_X),
                      x = field_values(contact, k, WRC_FIELD_X);
    ASSERT_EQ(q.status, WRC_OK);
    // arc lengths on the rail's profile, side by side; region and cells are there, and carry its forces
    double load = 0.0, along = 0.0, middle = 0.0;
    for (std::size_t j = 0; j < y.strips; ++j) {
      EXPECT_GT(y[j], 0.0);
      EXPECT_LT(y[j], 0.2);
      if (j > 0) {
        EXPECT_NEAR(y[j] - y[j - 1], 0.5 * (width[j] + width[j - 1]), 1e-9);
      }
      for (std::size_t i = 0; i < p.cells; ++i) {
        const double area = width[j] * 2.0 * half[j] / static_cast<double>(p.cells);
        load += p.at(i, j) * area;
        along += q.at(i, j) * area;
        middle += p.at(i, j) * area * x.at(i, j);
      }
    }
    EXPECT_NEAR(load, region.normal_force, 0.01 * region.normal_force);
    EXPECT_NEAR(along, region.longitudinal_force, 0.01 * region.normal_force);
    EXPECT_NEAR(middle / load, region.point[0], 0.1e-3);
    from[k] = region.point[0];
    power += region.power;
    auto wear = sized<wrc_wear>();
    ASSERT_EQ(wrc_contact_wear(contact, k, nullptr, &wear), WRC_OK) << error();
    EXPECT_GT(wear.worn_area_rate, 0.0);
  }
  EXPECT_NEAR(from[1] - from[0], 13e-3, 0.5e-3);  // the end ahead of the ramp
  EXPECT_NEAR(power, wrench.power, 1e-12 * power);
  EXPECT_GT(power, 100.0);
}

/// A state taken between both places has both: from there on bits are equal in any contact.
TEST_F(TwoPlaces, ArePartOfTheState) {
  touch_both();
  input.start = WRC_START_WARM;
  input.distance += 0.1e-3;
  ASSERT_EQ(step(), WRC_OK);
  uint64_t bytes = 0, portable = 0;
  ASSERT_EQ(wrc_contact_state_size(model, &bytes), WRC_OK);
  ASSERT_EQ(wrc_contact_portable_size(model, &portable), WRC_OK);
  std::vector<char> state(bytes), other(portable);
  ASSERT_EQ(wrc_contact_save(contact, state.data(), bytes), WRC_OK);
  ASSERT_EQ(wrc_contact_save_portable(contact, other.data(), portable), WRC_OK);
  const auto next = [&] {
    input.distance = 39.2e-3;
    EXPECT_EQ(step(), WRC_OK) << error();
    return wrench;
  };
  const wrc_wrench once = next();
  input.distance = 60e-3;
  ASSERT_EQ(step(), WRC_OK);
  ASSERT_EQ(wrc_contact_restore(contact, state.data(), bytes), WRC_OK) << error();
  wrc_wrench again = next();
  EXPECT_EQ(std::memcmp(&once, &again, sizeof once), 0);
  take(side);
  ASSERT_EQ(wrc_contact_restore_portable(contact, other.data(), portable), WRC_OK) << error();
  again = next();
  EXPECT_EQ(std::memcmp(&once, &again, sizeof once), 0);
}

/// A surface that begins within the rail begins on its ramp: straight from its first section on.
TEST_F(AlongTrack, ARampThatBeginsWithItsSurfaceIsStraight) {
  constexpr double slope = 0.02;
  add(0.0, 10e-3);
  add(2.0, 10e-3);
  for (int k = 0; k < 4; ++k) add(0.5 + 0.1 * k, -slope * 0.1 * k).surface = 1;
  give();
  create_under(60e3);
  const double at_first = height_at(0.52);
  EXPECT_NEAR(height_at(0.56) - at_first, -0.04 * slope, 1e-7);
  EXPECT_NEAR(height_at(0.72) - at_first, -0.2 * slope, 1e-7);
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
      for (const double distance : {0.0, 1.0}) add(distance, z, beside).surface = 1;
      give();
      create();
      ASSERT_EQ(step(), WRC_OK) << error();
      EXPECT_EQ(wrench.region_count, alone.region_count);
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
    for (int32_t i = 0; i < wrench.region_count; ++i) {
      wrc_region region = sized<wrc_region>();
      ASSERT_EQ(wrc_contact_region(contact, i, &region), WRC_OK);
      if (region.surface == 0) carried += region.normal_force;
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
    running.surface = 1;
    running.profile = config.rail;
  }
  give();
  config.check_rail = test_config().check_rail;
  create();
  input.distance = 0.5;
  ASSERT_EQ(step(), status) << error();
  EXPECT_EQ(wrench.region_count, checked.region_count);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(wrench.force[i], checked.force[i], 1e-9 * checked.normal_force) << i;
}

TEST_F(AlongTrack, EightSurfacesCarryAsOneAndNineAreRefused) {
  const auto give_surfaces = [&](int count) {
    sections.clear();
    for (int face = 0; face < count; ++face)
      for (const double distance : {0.0, 1.0, 2.0})
        add(distance, face + 1 < count ? 0.05 : 1e-3 * distance).surface = face;  // all but the last lie deep
    give();
  };
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 70e3;
  input.distance = 0.7;
  wheel.yaw = 2e-3;
  wrc_wrench one{};
  for (const int count : {1, 5, 8}) {
    give_surfaces(count);
    create();
    ASSERT_EQ(step(), WRC_OK) << count << " surfaces: " << error();
    if (count == 1) one = wrench;
    // strips of a surface beside others are as fine, but for their share of all
    EXPECT_NEAR(wrench.z, one.z, 0.1e-6) << count;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(wrench.force[i], one.force[i], 1e-3 * one.normal_force) << count;
  }
  give_surfaces(9);
  EXPECT_EQ(refused(), WRC_ERROR_RANGE);
  EXPECT_NE(sentence.find("surface"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("(section 25 at 0 m)"), std::string::npos) << sentence;
}

TEST_F(AlongTrack, SectionsOutOfOrderAreNamed) {
  add(1.0);
  add(0.5);
  give();
  EXPECT_EQ(refused(), WRC_ERROR_RANGE);
  EXPECT_NE(sentence.find("in order"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("(section 2 at 0.5 m)"), std::string::npos) << sentence;
  sections[1].distance = 2.0;
  sections[1].mark_count = 1;
  const double mark = 0.0;
  sections[1].marks = &mark;
  EXPECT_EQ(refused(), WRC_ERROR_PROFILE) << sentence;
  sections[0].mark_count = 1;
  const double beside = 0.3;
  sections[0].marks = &beside;
  EXPECT_EQ(wrc_model_create(&config, nullptr, &model, nullptr, 0), WRC_ERROR_PROFILE);
  sections[0].marks = &mark;
  EXPECT_EQ(refused(), WRC_OK) << sentence;
  sections[1].surface = 2;
  EXPECT_EQ(refused(), WRC_ERROR_RANGE) << sentence;
  sections[1].surface = 0;
  sections[1].distance = nan_value;
  EXPECT_EQ(refused(), WRC_ERROR_NOT_FINITE) << sentence;
}

TEST_F(AlongTrack, SectionsThatOverlapAreNamed) {
  add(1.0);
  add(1.0005);
  give();
  EXPECT_EQ(refused(), WRC_ERROR_RANGE);
  EXPECT_NE(sentence.find("config.rail_sections.distance["), std::string::npos) << sentence;
  sections[1].distance = 1.0;
  EXPECT_EQ(refused(), WRC_ERROR_RANGE) << sentence;
  sections[1].distance = 2.0;
  EXPECT_EQ(refused(), WRC_OK) << sentence;
  // a face that goes on behind another one's sections
  add(0.0).surface = 1;
  add(3.0).surface = 1;
  add(4.0);
  give();
  EXPECT_EQ(refused(), WRC_ERROR_RANGE);
  EXPECT_NE(sentence.find("config.rail_sections.surface["), std::string::npos) << sentence;
}

TEST_F(AlongTrack, ProfilesThatCannotBePairedAreNamed) {
  const auto cannot = [&](const char* word) {
    const int32_t status = wrc_model_create(&config, nullptr, &model, nullptr, 0);
    EXPECT_EQ(status, WRC_ERROR_PROFILE);
    EXPECT_EQ(model, nullptr);
    EXPECT_EQ(refused(), WRC_ERROR_PROFILE) << sentence;
    EXPECT_NE(sentence.find("config.rail_section"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("(section 2 at 1 m)"), std::string::npos) << sentence;
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
  give_points(y, z);
  EXPECT_EQ(refused(), WRC_OK) << sentence;
  // marks that make 3 mm of one outline a pair of 36 mm of the other
  const double marks[] = {-0.033, 0.0};
  for (std::size_t k : {0U, 1U}) {
    sections[k].mark_count = 1;
    sections[k].marks = &marks[k];
  }
  cannot("cannot be paired");
  // turned by more than 60 degrees where the other one is level
  for (wrc_rail_section& each : sections) {
    each.mark_count = 0;
    each.marks = nullptr;
  }
  sections[1].profile.z = steep.data();
  cannot("no pair");
}

TEST_F(AlongTrack, ASectionThatFoldsBackOrIsInAnotherUnitIsNamed) {
  std::vector<double> y, z, folded, millimetres;
  for (int i = -180; i <= 180; ++i) {
    y.push_back(2e-4 * i);
    z.push_back(y.back() * y.back() / 0.6);
    folded.push_back(i == 20 ? y.back() - 1e-3 : y.back());
    millimetres.push_back(1e3 * y.back());
  }
  for (const double distance : {-0.25, 0.0, 0.5}) add(distance);
  give();
  give_points(y, z);
  EXPECT_EQ(refused(), WRC_OK) << sentence;
  for (const std::vector<double>* wrong : {&folded, &millimetres}) {
    sections[2].profile.y = wrong->data();
    EXPECT_EQ(refused(), WRC_ERROR_PROFILE);
    EXPECT_NE(sentence.find("(section 3 at 0.5 m)"), std::string::npos) << sentence;
  }
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

/// The same input exactly, on cells of 0.4 mm.
class ExactAlongTrack : public AlongTrack {
 protected:
  wrc_exact_wrench_options options = sized<wrc_exact_wrench_options>();
  wrc_wrench exact = sized<wrc_wrench>();

  ExactAlongTrack() { options.cell_x = options.cell_s = 4e-4; }
  int32_t solve() { return wrc_exact_wrench(contact, &input, &options, &exact); }
  /// The height at which real time carries 80 kN.
  void carry() {
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = 80e3;
    ASSERT_EQ(step(), WRC_OK) << error();
    input.prescribed = WRC_PRESCRIBE_HEIGHT;
    input.vertical_load = 0.0;
    wheel.z = wrench.z;
  }
  void expect_as_real_time(double share) {
    ASSERT_EQ(step(), WRC_OK) << error();
    ASSERT_EQ(solve(), WRC_OK) << error();
    const double size = share * wrench.normal_force;
    ASSERT_GT(wrench.normal_force, 20e3);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(exact.force[i], wrench.force[i], size) << i;
      EXPECT_NEAR(exact.moment[i], wrench.moment[i], 0.75 * size) << i;
    }
    EXPECT_NEAR(exact.power, wrench.power, 0.1 * wrench.power);
    EXPECT_EQ(exact.region_count, wrench.region_count);
  }
};

TEST_F(ExactAlongTrack, EqualSectionsAreTheConstantRail) {
  wheel.y = 3e-3;
  wheel.yaw = 5e-3;
  create();
  carry();
  ASSERT_EQ(solve(), WRC_OK) << error();
  const wrc_wrench constant = exact;
  for (double distance : {-20.0, -3.0, 10.0}) add(distance);
  give();
  create();
  input.distance = -12.3;
  ASSERT_EQ(solve(), WRC_OK) << error();
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(exact.force[i], constant.force[i], 2e-3 * constant.normal_force) << i;
    EXPECT_NEAR(exact.moment[i], constant.moment[i], 2e-3 * constant.normal_force) << i;
  }
  input.distance = 10.1;
  EXPECT_EQ(solve(), WRC_FLAG_BEYOND_SECTIONS);
}

/// On a straight ramp everything is as on the level, turned about the y axis; sections are cut upright: what
/// lies a millimetre below the top lies 0.2 um nearer on 1:50, which is 0.3 % of the load.
TEST_F(ExactAlongTrack, ARampIsTheLevelTurned) {
  give_ramp();
  wheel.y = 4e-3;
  wheel.velocity[1] = 0.04;
  create();
  const double slope = 0.02, cosine = 1.0 / std::sqrt(1.0 + slope * slope), sine = slope * cosine;
  input.distance = 0.5;
  carry();
  const double level_z = wheel.z;
  ASSERT_EQ(solve(), WRC_OK) << error();
  const wrc_wrench level = exact;
  ASSERT_GT(level.normal_force, 20e3);
  input.distance = 3.5;
  wheel.z = 0.03 + radius - (radius - level_z) / cosine;
  wheel.velocity[0] = 20.0 * cosine;
  wheel.velocity[2] = 20.0 * sine;
  ASSERT_EQ(solve(), WRC_OK) << error();
  const double f[] = {cosine * level.force[0] - sine * level.force[2], level.force[1],
                      sine * level.force[0] + cosine * level.force[2]};
  const double m[] = {cosine * level.moment[0] - sine * level.moment[2], level.moment[1],
                      sine * level.moment[0] + cosine * level.moment[2]};
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(exact.force[i], f[i], 4e-3 * level.normal_force) << i;
    EXPECT_NEAR(exact.moment[i], m[i], 4e-3 * level.normal_force) << i;
  }
  EXPECT_NEAR(exact.power, level.power, 5e-3 * level.power);
}

/// Where the rail bends, and its section changes.
TEST_F(ExactAlongTrack, ItIsNearTheRealTimeSolutionWhereTheRailChanges) {
  add(0.0);
  add(1.0, 0.0, 0.0);
  add(1.2, 1e-3, 2e-3);
  add(1.5, 3e-3, 6e-3).profile.kind = WRC_PROFILE_60E1;
  add(2.0, 4e-3, 8e-3).profile.kind = WRC_PROFILE_60E1;
  give();
  wheel.y = 6e-3;
  wheel.yaw = 8e-3;
  create();
  for (const double at : {1.05, 1.3, 1.62}) {
    input.distance = at;
    carry();
    expect_as_real_time(0.02);
  }
}

/// A nose that rises 1:10: the wheel touches it 46 mm ahead, 2.3 mm above the section below its axle; and a
/// wing that moves aside 1:9, whose contact is sheared across the strips.
TEST_F(ExactAlongTrack, ItIsNearTheRealTimeSolutionOnANoseAndOnAWing) {
  for (const bool nose : {true, false}) {
    sections.clear();
    for (int k = 0; k < 20; ++k)
      add(0.02 * k, nose ? -2e-3 * k : 0.0, nose ? 0.0 : 20e-3 / 9.0 * k - 22e-3).profile.kind =
          WRC_PROFILE_60E1;
    give();
    wheel.y = 1e-3;
    wheel.yaw = 3e-3;
    create();
    for (const double at : {0.15, 0.22}) {
      input.distance = at;
      carry();
      expect_as_real_time(0.015);
    }
  }
}

/// Level, a ramp that rises 4 mm at 1:10, level again: the wheel meets the ramp far ahead while the rail
/// below the axle is level, then turns over the ramp's corner. A round wheel without friction has no moment
/// about its axle.
TEST_F(ExactAlongTrack, ItFindsARampAheadOfALevelRailAndTurnsOverItsCorner) {
  constexpr double ramp = 40e-3;
  add(-0.3);
  for (int k = -10; k <= 20; ++k) add(5e-3 * k, -0.1 * std::clamp(5e-3 * k, 0.0, ramp));
  add(0.5);
  give();
  create_under(80e3);
  for (const double at : {-0.02, -0.01, 0.0, 0.01, 0.02}) {
    const double height = height_at(at), lean = std::min(0.1, (ramp - at) / radius);
    input.prescribed = WRC_PRESCRIBE_HEIGHT;
    input.vertical_load = 0.0;
    wheel.z = height;
    ASSERT_EQ(solve(), WRC_OK) << error();
    EXPECT_NEAR(exact.force[2], -80e3, 0.015 * 80e3) << at;
    EXPECT_NEAR(exact.force[0], -80e3 * lean, 0.1 * 80e3 * lean) << at;
    EXPECT_NEAR(exact.moment[1], 0.0, 1e-3 * radius * 80e3) << at;
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = 80e3;
  }
}

TEST_F(ExactAlongTrack, ABladeBesideTheStockRailCarriesItsShare) {
  add(0.0);
  add(10.0);
  for (const double distance : {4.0, 6.0}) add(distance, 30e-6).surface = 1;  // the same head, lower
  give();
  wheel.y = 3e-3;
  create();
  input.distance = 5.0;
  carry();
  expect_as_real_time(0.02);
  EXPECT_EQ(exact.region_count, 2);
}

/// A wheel whose radius is r + e cos(theta) is a round one whose middle lies e beside the axle.
TEST_F(ExactAlongTrack, AnEccentricWheelIsARoundOneElsewhere) {
  constexpr double off = 4e-5;
  wheel.y = 5e-3;
  wheel.velocity[1] = 0.03;
  create();
  carry();
  for (const double angle : {0.9, -1.2}) {
    config.roundness = test_config().roundness;
    const wrc_wheel_input as_it_is = input;
    // the material's angle 0 is below the axle before it has turned; +y turns the lowest point forwards
    const double x = off * std::sin(angle), z = off * std::cos(angle), w = wheel.angular_velocity[1];
    wheel.z += z;
    wheel.velocity[0] += w * z;
    wheel.velocity[2] -= w * x;
    create();
    ASSERT_EQ(solve(), WRC_OK) << error();
    const wrc_wrench round = exact;
    ASSERT_GT(round.normal_force, 1e3);
    input = as_it_is;
    give_wheel(720, [](double a) { return off * std::cos(a); });
    create();
    input.angle = angle;
    ASSERT_EQ(solve(), WRC_OK) << error();
    input = as_it_is;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(exact.force[i], round.force[i], 2e-3 * round.normal_force) << i;
    EXPECT_NEAR(exact.moment[1], round.moment[1] + z * round.force[0] - x * round.force[2],
                2e-3 * 0.46 * round.normal_force);
    EXPECT_NEAR(exact.power, round.power, 0.01 * round.power);
    friction.coefficient = 0.0;
    input.angle = angle;
    ASSERT_EQ(solve(), WRC_OK) << error();
    input = as_it_is;
    EXPECT_NEAR(exact.moment[1], -x * exact.force[2], 0.02 * off * round.normal_force);
  }
}

/// A polygon of 0.1 mm, and a flat with its edges worn: bent less and more than a round wheel.
TEST_F(ExactAlongTrack, ItIsNearTheRealTimeSolutionOfAWheelThatIsNotRound) {
  wheel.y = 4e-3;
  wheel.yaw = 2e-3;
  const auto flat = [](double a) {
    const double from = a > 0.5 * turn ? a - turn : a, half = 0.1;
    return std::abs(from) < half ? -0.25e-3 * (1.0 + std::cos(0.5 * turn * from / half)) : 0.0;
  };
  for (const bool polygon : {true, false}) {
    if (polygon) {
      give_wheel(720, [](double a) { return 1e-4 * std::cos(20.0 * a); });
    } else {
      give_wheel(4000, flat);
    }
    create();
    for (const double at : {0.0, 0.08}) {
      input.angle = at;
      carry();
      SCOPED_TRACE(at);
      expect_as_real_time(0.03);
    }
  }
}

}  // namespace
