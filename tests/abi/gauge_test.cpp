/// Gauge that varies: said of the track, of the rail, of its sections or of the wheel, it is the same.
#include <cmath>
#include <vector>

#include "wheel_on_rail.hpp"

namespace {

class Gauge : public testing::Test, protected PlacedWheel {
 protected:
  static constexpr double wider = 3e-3;  ///< each rail [m]

  Gauge() {
    config.rail.kind = WRC_PROFILE_60E1;
    config.track.rail_inclination = 1.0 / 40.0;
    wheel.z = -0.2e-3;
    wheel.velocity[1] = 0.03;
    wheel.angular_velocity[2] = 0.02;
  }
  /// Near the flange: of a wheelset moved towards the rail of that side, which has gone `wider` away.
  void place(int32_t which) {
    const double out = which == WRC_SIDE_RIGHT ? 1.0 : -1.0;
    wheel.y = 8.5e-3 * out;
    wheel.yaw = 4e-3 * out;
    rail.y = wheel.reference == WRC_REFERENCE_WHEELSET ? wider * out : 0.0;
  }
  void expect_equal(const wrc_wrench& one, const wrc_wrench& other, double within) {
    ASSERT_GT(one.normal_force, 10e3);
    EXPECT_GT(one.steepest_angle, 0.3);  // the gauge corner
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(one.force[k], other.force[k], within * one.normal_force) << k;
      EXPECT_NEAR(one.moment[k], other.moment[k], within * one.normal_force) << k;
    }
  }
};

TEST_F(Gauge, OfTheTrackIsARailMovedAside) {
  for (const int32_t which : {WRC_SIDE_RIGHT, WRC_SIDE_LEFT}) {
    config.track.gauge = 1.435;
    create(which);
    place(which);
    ASSERT_EQ(step(), WRC_OK) << error();
    const wrc_wrench moved = wrench;
    config.track.gauge = 1.435 + 2.0 * wider;
    create(which);
    rail.y = 0.0;
    ASSERT_EQ(step(), WRC_OK) << error();
    expect_equal(moved, wrench, 1e-12);
    // and sections that lie aside, of either side towards the field; their outlines are splines of their own
    config.track.gauge = 1.435;
    std::vector<wrc_rail_section> sections(3);
    for (int i = 0; i < 3; ++i) {
      sections[static_cast<std::size_t>(i)] = {};
      sections[static_cast<std::size_t>(i)].distance = i;
      sections[static_cast<std::size_t>(i)].y = wider;
      sections[static_cast<std::size_t>(i)].profile.kind = WRC_PROFILE_60E1;
    }
    config.rail_section_count = 3;
    config.rail_sections = sections.data();
    config.rail_section_size = sizeof sections[0];
    create(which);
    input.distance = 1.3;
    ASSERT_EQ(step(), WRC_OK) << error();
    expect_equal(moved, wrench, 1e-4);
    config.rail_section_count = 0;
    config.rail_sections = nullptr;
    config.rail_section_size = 0;
    input.distance = 0.0;
  }
}

/// A wheel by itself that moves the other way sees the same rail; moments are about its own point.
TEST_F(Gauge, IsTheWheelMovedTheOtherWay) {
  create();
  place(WRC_SIDE_RIGHT);
  wheel.reference = WRC_REFERENCE_WHEEL;
  rail.y = wider;
  ASSERT_EQ(step(), WRC_OK) << error();
  const wrc_wrench moved = wrench;
  rail.y = 0.0;
  wheel.y -= wider;
  ASSERT_EQ(step(), WRC_OK) << error();
  expect_equal(moved, wrench, 1e-12);
  // so do their velocities
  wheel.velocity[1] -= 0.05;
  ASSERT_EQ(step(), WRC_OK) << error();
  const wrc_wrench of_wheel = wrench;
  wheel.velocity[1] += 0.05;
  rail.y_velocity = 0.05;
  ASSERT_EQ(step(), WRC_OK) << error();
  expect_equal(of_wheel, wrench, 1e-12);
  EXPECT_GT(std::abs(wrench.force[1] - moved.force[1]), 1e3);
}

/// Gauge that widens along the track by sections: the rail is at rest and turned by the widening's slope. A
/// straight rail sees the same from a wheel turned, and moved, the other way.
TEST_F(Gauge, ThatWidensAlongTheTrackIsARailTurned) {
  constexpr double slope = 4e-3;
  wheel.reference = WRC_REFERENCE_WHEEL;
  place(WRC_SIDE_RIGHT);
  std::vector<wrc_rail_section> sections(5);
  for (int i = 0; i < 5; ++i) {
    sections[static_cast<std::size_t>(i)] = {};
    sections[static_cast<std::size_t>(i)].distance = i - 2.0;
    sections[static_cast<std::size_t>(i)].y = slope * (i - 2.0);
    sections[static_cast<std::size_t>(i)].profile.kind = WRC_PROFILE_60E1;
  }
  config.rail_section_count = 5;
  config.rail_sections = sections.data();
  config.rail_section_size = sizeof sections[0];
  create();
  wheel.y = 5.5e-3;
  ASSERT_EQ(step(), WRC_OK) << error();
  const wrc_wrench widening = wrench;
  config.rail_section_count = 0;
  config.rail_sections = nullptr;
  config.rail_section_size = 0;
  create();
  const double c = std::cos(slope), s = std::sin(slope);
  const auto into_rail = [&](double* v) {
    const double x = v[0], y = v[1];
    v[0] = c * x + s * y, v[1] = c * y - s * x;
  };
  wheel.y *= c;
  wheel.yaw -= slope;
  into_rail(wheel.velocity);
  into_rail(wheel.angular_velocity);
  ASSERT_EQ(step(), WRC_OK) << error();
  wrc_wrench turned = wrench;
  for (double* v : {turned.force, turned.moment}) {
    const double x = v[0], y = v[1];
    v[0] = c * x - s * y, v[1] = c * y + s * x;
  }
  expect_equal(widening, turned, 1e-3);
  // without the turn it is quite another creep force
  wheel.y = 5.5e-3;
  wheel.yaw = 4e-3;
  wheel.velocity[0] = 20.0, wheel.velocity[1] = 0.03;
  wheel.angular_velocity[0] = 0.0, wheel.angular_velocity[1] = -20.0 / 0.46;
  ASSERT_EQ(step(), WRC_OK) << error();
  EXPECT_GT(std::hypot(wrench.force[0] - widening.force[0], wrench.force[1] - widening.force[1]),
            5e-3 * widening.normal_force);
}

}  // namespace
