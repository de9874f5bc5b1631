#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/creepages.hpp"
#include "geometry_test_bodies.hpp"
#include "overlap_weighted_point.hpp"

namespace wrc::geometry {
namespace {

constexpr double mm = 1e-3;

struct Running {
  PosedWheel wheel;
  ContactPoint contact;

  Running(const ReferenceBodies& bodies, const Pose& pose) : wheel(posed(bodies.wheel, pose)) {
    std::int32_t count = 0;
    EXPECT_EQ(find_contact(bodies.rail, wheel, 1, &contact, count).status, WRC_OK);
  }
};

TEST(Creepages, PureRollingHasNoCreepageButSpin) {
  const ReferenceBodies bodies;
  const Running running(bodies, Pose{.lateral = 3.0 * mm});
  const double radius = running.contact.rolling_radius;
  const RigidCreepage c =
      creepage(running.wheel, running.contact, {.speed = 20.0, .pitch_rate = -20.0 / radius});
  EXPECT_NEAR(c.longitudinal, 0.0, 1e-12);
  EXPECT_NEAR(c.lateral, 0.0, 1e-12);
  // Spin of a cone: sine of the contact angle over the rolling radius.
  EXPECT_NEAR(c.spin, std::sin(running.contact.angle) / radius, 1e-9);
  EXPECT_NEAR(c.rolling_speed, 20.0, 1e-9);
}

TEST(Creepages, LargerRadiusRunsAhead) {
  // The axle turns for the tape circle: at a larger radius the wheel's point slips backwards.
  const ReferenceBodies bodies;
  const Running running(bodies, Pose{.lateral = 5.0 * mm});
  ASSERT_GT(running.contact.rolling_radius, 0.460);
  const RigidCreepage c =
      creepage(running.wheel, running.contact, {.speed = 20.0, .pitch_rate = -20.0 / 0.460});
  const double mean = 0.5 * (1.0 + running.contact.rolling_radius / 0.460);
  EXPECT_NEAR(c.longitudinal, (1.0 - running.contact.rolling_radius / 0.460) / mean, 1e-12);
  EXPECT_LT(c.longitudinal, 0.0);
}

TEST(Creepages, YawSlipsTheWheelTowardsItsHeading) {
  // Yawed to the right by psi and rolling straight ahead, the wheel's material moves against its heading:
  // -psi.
  const ReferenceBodies bodies;
  const double yaw = 1e-4;
  const Running running(bodies, Pose{.yaw = yaw});
  const RigidCreepage c = creepage(running.wheel, running.contact,
                                   {.speed = 20.0, .pitch_rate = -20.0 / running.contact.rolling_radius});
  EXPECT_NEAR(c.lateral, -yaw / running.contact.cosine, 1e-3 * yaw);
}

TEST(Creepages, LateralVelocityAndYawRateEnterDirectly) {
  const ReferenceBodies bodies;
  const Running running(bodies, Pose{});
  const double pitch = -20.0 / running.contact.rolling_radius;
  const RigidCreepage at_rest =
      creepage(running.wheel, running.contact, {.speed = 20.0, .pitch_rate = pitch});
  const RigidCreepage sliding = creepage(running.wheel, running.contact,
                                         {.speed = 20.0, .lateral_velocity = 0.01, .pitch_rate = pitch});
  EXPECT_NEAR(sliding.lateral - at_rest.lateral, 0.01 * running.contact.cosine / 20.0, 1e-12);
  const RigidCreepage turning =
      creepage(running.wheel, running.contact, {.speed = 20.0, .yaw_rate = 0.02, .pitch_rate = pitch});
  // A wheelset turning right moves its right wheel backwards and spins with the cosine of the contact angle.
  EXPECT_NEAR(turning.longitudinal * turning.rolling_speed, -0.02 * running.contact.y, 1e-9);
  EXPECT_NEAR(turning.spin * turning.rolling_speed - at_rest.spin * at_rest.rolling_speed,
              0.02 * running.contact.cosine, 1e-9);
}

TEST(Creepages, SlipFieldIsTheVelocityOfTheRigidWheelAroundTheContact) {
  // (nu_x - phi y, nu_y + phi x) against the velocity of material points on the tangent plane.
  const ReferenceBodies bodies;
  const Running running(bodies, Pose{.lateral = 4.0 * mm, .roll = 0.002, .yaw = 0.01});
  const WheelsetMotion motion{.speed = 15.0,
                              .lateral_velocity = 0.02,
                              .vertical_velocity = -0.01,
                              .roll_rate = 0.03,
                              .yaw_rate = 0.05,
                              .pitch_rate = -33.0};
  const RigidCreepage c = creepage(running.wheel, running.contact, motion);
  for (const double x : {-5.0 * mm, 5.0 * mm}) {
    for (const double y : {-5.0 * mm, 5.0 * mm}) {
      ContactPoint moved = running.contact;
      moved.x += x;
      moved.y += y * moved.cosine;
      moved.z += y * moved.sine;
      const RigidCreepage there = creepage(running.wheel, moved, motion);
      EXPECT_NEAR(there.longitudinal * there.rolling_speed, (c.longitudinal - c.spin * y) * c.rolling_speed,
                  1e-12);
      EXPECT_NEAR(there.lateral * there.rolling_speed, (c.lateral + c.spin * x) * c.rolling_speed, 1e-12);
    }
  }
}

TEST(Creepages, LeftWheelIsTheMirrorImage) {
  const ReferenceBodies right(Side::right), left(Side::left);
  const Running a(right, Pose{.lateral = 4.0 * mm, .roll = 0.002, .yaw = 0.01});
  const Running b(left, Pose{.lateral = -4.0 * mm, .roll = -0.002, .yaw = -0.01});
  const RigidCreepage ca = creepage(a.wheel, a.contact, {15.0, 0.02, 0.01, 0.03, 0.05, -33.0});
  const RigidCreepage cb = creepage(b.wheel, b.contact, {15.0, -0.02, 0.01, -0.03, -0.05, -33.0});
  EXPECT_NEAR(cb.longitudinal, ca.longitudinal, 1e-10);
  EXPECT_NEAR(cb.lateral, -ca.lateral, 1e-10);
  EXPECT_NEAR(cb.spin, -ca.spin, 1e-8);
  EXPECT_NEAR(cb.normal_velocity, ca.normal_velocity, 1e-9);
}

TEST(Creepages, VelocitiesOverTheRollingSpeedFromTheFloorOn) {
  // From the floor speed on the divisor is V itself, and nothing is limited, to the last bit.
  const ReferenceBodies bodies;
  const Running running(bodies, Pose{});
  for (const double speed : {floor_speed * (1.0 + 1e-6), 0.2, 1.0, 90.0, -0.2, -90.0}) {
    const RigidCreepage c = creepage(
        running.wheel, running.contact,
        {.speed = speed, .lateral_velocity = 0.01, .pitch_rate = -speed / running.contact.rolling_radius});
    EXPECT_FALSE(c.limited) << speed;
    EXPECT_EQ(c.reverse_share, 0.0);
    EXPECT_NEAR(c.rolling_speed, speed, 1e-12);
    EXPECT_EQ(c.lateral, 0.01 * running.contact.cosine / std::fabs(c.rolling_speed));
  }
}

TEST(Creepages, AreTwiceDifferentiableThroughStandstill) {
  // Divisor and share have the values, slopes and curvatures of their pieces at the floor and at V = 0:
  // second differences of a step of floor / 200 stay those of the polynomials.
  const ReferenceBodies bodies;
  const Running running(bodies, Pose{});
  const double step = floor_speed / 200.0;
  const auto at = [&](int i) {
    return creepage(running.wheel, running.contact,
                    {.speed = i * step, .pitch_rate = -i * step / running.contact.rolling_radius});
  };
  double previous[2] = {}, largest_change[2] = {};
  for (int i = -400; i <= 400; ++i) {
    const RigidCreepage before = at(i - 1), here = at(i), after = at(i + 1);
    const auto forward_share = [](const RigidCreepage& c) {
      return std::signbit(c.rolling_speed) ? c.reverse_share : 1.0 - c.reverse_share;
    };
    const double second[] = {std::fabs(after.rolling_speed) - 2.0 * std::fabs(here.rolling_speed) +
                                 std::fabs(before.rolling_speed),
                             forward_share(after) - 2.0 * forward_share(here) + forward_share(before)};
    for (int k = 0; k < 2; ++k) {
      const double curvature = second[k] * (k == 0 ? floor_speed : floor_speed * floor_speed) / (step * step);
      if (i > -400) largest_change[k] = std::max(largest_change[k], std::fabs(curvature - previous[k]));
      previous[k] = curvature;
    }
  }
  // Curvatures of (3 + 6 u^2 - u^4) / 8 and of the share change by no more than their slope times
  // du = 1 / 200.
  EXPECT_LT(largest_change[0], 3.0 / 200.0 * 1.1);
  EXPECT_LT(largest_change[1], 7.5 / 200.0 * 1.1);
}

TEST(Creepages, SaturateAtStandstillAndKeepTheVelocity) {
  const ReferenceBodies bodies;
  const Running running(bodies, Pose{});
  const RigidCreepage c = creepage(running.wheel, running.contact, {.lateral_velocity = 0.1});
  EXPECT_EQ(c.longitudinal, 0.0);
  EXPECT_NEAR(c.rolling_speed, 0.375 * floor_speed, 1e-15);
  EXPECT_NEAR(c.lateral * c.rolling_speed, 0.1 * running.contact.cosine, 1e-15);
  EXPECT_NEAR(c.reverse_share, 0.5, 1e-15);
  EXPECT_TRUE(c.limited);
  // All of them shrink together where one would be too large.
  const RigidCreepage fast =
      creepage(running.wheel, running.contact, {.lateral_velocity = 20.0, .yaw_rate = 0.1});
  EXPECT_NEAR(fast.lateral, largest_creepage, 1e-12);
  EXPECT_NEAR(fast.lateral * fast.rolling_speed, 20.0 * running.contact.cosine, 1e-9);
  EXPECT_NEAR(fast.spin * fast.rolling_speed, 0.1 * running.contact.cosine, 1e-9);
  const RigidCreepage none = creepage(running.wheel, running.contact, {});
  EXPECT_EQ(none.lateral, 0.0);
  EXPECT_EQ(none.spin, 0.0);
}

TEST(Creepages, RollingSpeedIsTheMeanOfBothMaterials) {
  const ReferenceBodies bodies;
  const Running running(bodies, Pose{});
  const double radius = running.contact.rolling_radius;
  struct Case {
    double speed, circumference, rolling, longitudinal;
  };
  for (const Case& k :
       {Case{10.0, 0.0, 5.0, 2.0}, Case{-10.0, 0.0, -5.0, -2.0}, Case{0.0, 10.0, 5.0, -2.0},
        Case{0.0, -10.0, -5.0, 2.0}, Case{10.0, -6.0, 2.0, 8.0}, Case{-10.0, 6.0, -2.0, -8.0}}) {
    const RigidCreepage c =
        creepage(running.wheel, running.contact, {.speed = k.speed, .pitch_rate = -k.circumference / radius});
    EXPECT_NEAR(c.rolling_speed, k.rolling, 1e-9);
    EXPECT_NEAR(c.longitudinal, k.longitudinal, 1e-9);
  }
}

TEST(OverlapWeightedPoint, TendsToTheFirstContactForSmallOverlap) {
  const ReferenceBodies bodies;
  const Running running(bodies, Pose{.lateral = -3.0 * mm});
  const ContactPoint small =
      test::overlap_weighted_point(bodies.rail, running.wheel, running.contact, 0.0005 * mm);
  EXPECT_NEAR(small.y, running.contact.y, 0.02 * mm);
  const ContactPoint none = test::overlap_weighted_point(bodies.rail, running.wheel, running.contact, 0.0);
  EXPECT_EQ(none.y, running.contact.y);
}

TEST(OverlapWeightedPoint, MovesContinuouslyWhereTheFirstContactJumps) {
  // Between 0 and 0.7 mm of lateral shift the first contact leaps from -7 to -18 mm on the rail.
  const ReferenceBodies bodies;
  double largest_first = 0.0, largest_weighted = 0.0, first = 0.0, weighted = 0.0;
  for (int k = 0; k <= 70; ++k) {
    const Running running(bodies, Pose{.lateral = k * 0.01 * mm});
    const ContactPoint point =
        test::overlap_weighted_point(bodies.rail, running.wheel, running.contact, 0.07 * mm);
    if (k > 0) {
      largest_first = std::max(largest_first, std::abs(running.contact.y - first));
      largest_weighted = std::max(largest_weighted, std::abs(point.y - weighted));
    }
    first = running.contact.y;
    weighted = point.y;
  }
  EXPECT_GT(largest_first, 8.0 * mm);
  EXPECT_LT(largest_weighted, 0.15 * mm);
}

}  // namespace
}  // namespace wrc::geometry
