#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/contact_search.hpp"
#include "geometry_test_bodies.hpp"

namespace wrc::geometry {
namespace {

constexpr double mm = 1e-3;

struct Found {
  Fault fault;
  std::int32_t count = 0;
  ContactPoint point[4];
};

Found find(const ReferenceBodies& bodies, const Pose& pose) {
  Found found;
  found.fault = find_contact(bodies.rail, posed(bodies.wheel, pose), 4, found.point, found.count);
  return found;
}

/// Smallest vertical gap by brute force over the surface of revolution: every (s, theta) of the wheel,
/// rotated.
struct BruteForce {
  double gap = 1.0, y = 0.0;
};
BruteForce brute_force(const ReferenceBodies& bodies, const Pose& pose, double around_s) {
  const PosedWheel wheel = posed(bodies.wheel, pose);
  BruteForce best;
  double s_mid = around_s, theta_mid = 0.0, s_half = 3.0 * mm, theta_half = 0.15;
  for (int zoom = 0; zoom < 30; ++zoom) {
    double s_best = s_mid, theta_best = theta_mid;
    for (int i = -40; i <= 40; ++i) {
      for (int k = -40; k <= 40; ++k) {
        const double s = s_mid + s_half * i / 40.0, theta = theta_mid + theta_half * k / 40.0;
        const double r = bodies.wheel.nominal_radius + evaluate(bodies.wheel.profile, s).z;
        const double p[3] = {r * std::sin(theta), s, r * std::cos(theta)};
        const auto& rot = wheel.attitude.r;
        const double y = rot[1][0] * p[0] + rot[1][1] * p[1] + rot[1][2] * p[2] + wheel.centre_y;
        const double z = rot[2][0] * p[0] + rot[2][1] * p[1] + rot[2][2] * p[2] + wheel.centre_z;
        const double gap = evaluate(bodies.rail.profile, y).z - z;
        if (gap < best.gap) {
          best = {gap, y};
          s_best = s;
          theta_best = theta;
        }
      }
    }
    s_mid = s_best;
    theta_mid = theta_best;
    s_half *= 0.5;
    theta_half *= 0.5;
  }
  return best;
}

TEST(ContactSearch, CentredWheelsetTouchesWhereTheReferenceSays) {
  // theory 6.3 (S1002 on the benchmark UIC60, computed by the reference program).
  const ReferenceBodies bodies;
  EXPECT_NEAR(bodies.rail.origin_y, 760.531 * mm, 2e-6);  // the reference finds its gauge point on chords
  EXPECT_NEAR(bodies.wheel.origin_y, 750.0 * mm, 1e-12);
  const Found found = find(bodies, Pose{});
  ASSERT_EQ(found.fault.status, WRC_OK);
  EXPECT_NEAR(found.point[0].y_rail, -7.28 * mm, 0.005 * mm);
  EXPECT_NEAR(found.point[0].angle, -0.0243, 0.00005);
  EXPECT_NEAR(found.point[0].vertical_gap, 0.1821 * mm, 0.00005 * mm);
}

TEST(ContactSearch, VerticalGapFollowsTheTable) {
  const ReferenceBodies bodies;
  const PosedWheel wheel = posed(bodies.wheel, Pose{});
  const ContactPoint contact = find(bodies, Pose{}).point[0];
  const std::array<std::array<double, 2>, 10> table{{{-10, .00938},
                                                     {-8, .00972},
                                                     {-6, .00751},
                                                     {-4, .00423},
                                                     {-2, .00128},
                                                     {2, .00175},
                                                     {4, .00797},
                                                     {6, .02025},
                                                     {8, .04039},
                                                     {10, .07041}}};  // theory 6.3 [mm]
  for (const auto& [dy, gap] : table) {
    std::int32_t piece = 0;
    const double y = contact.y + dy * mm;
    const OutlinePoint on_wheel = outline(wheel, y, piece);  // no roll, no yaw: s = y
    const double above = evaluate(bodies.rail.profile, y).z - on_wheel.z - contact.vertical_gap;
    EXPECT_NEAR(above, gap * mm, 0.00006 * mm) << dy;  // 1 um of gauge moves the outer rows by 0.00004 mm
  }
}

TEST(ContactSearch, TangentsAgreeAtEveryPointFound) {
  const ReferenceBodies bodies;
  for (const double yaw : {0.0, 0.01, -0.03}) {
    for (double lateral = -6.0 * mm; lateral < 9.0 * mm; lateral += 0.37 * mm) {
      const Pose pose{.lateral = lateral, .roll = 0.002, .yaw = yaw};
      const PosedWheel wheel = posed(bodies.wheel, pose);
      const Found found = find(bodies, pose);
      ASSERT_EQ(found.fault.status, WRC_OK) << lateral;
      ASSERT_GE(found.count, 1);
      for (std::int32_t i = 0; i < found.count; ++i) {
        const ContactPoint& contact = found.point[i];
        std::int32_t piece = 0;
        const OutlinePoint on_wheel = outline(wheel, contact.wheel_s, piece);
        EXPECT_NEAR(on_wheel.dz_dy(), evaluate(bodies.rail.profile, on_wheel.y).slope, 1e-7);
        EXPECT_NEAR(std::tan(contact.angle), on_wheel.dz_dy(), 1e-12);
        if (i > 0) {
          EXPECT_GE(contact.vertical_gap, found.point[i - 1].vertical_gap);
        }
      }
    }
  }
}

TEST(ContactSearch, MatchesBruteForceOverTheRotatedSurface) {
  const ReferenceBodies bodies;
  const std::array<Pose, 6> poses{{{.lateral = 1.0 * mm, .yaw = 0.02},
                                   {.lateral = -3.0 * mm, .roll = 0.004, .yaw = -0.015},
                                   {.lateral = 6.0 * mm, .yaw = 0.01},
                                   {.lateral = 6.3 * mm, .roll = -0.003, .yaw = 0.04},
                                   {.lateral = 7.5 * mm, .yaw = 0.03},
                                   {.lateral = 7.5 * mm, .roll = 0.01, .yaw = -0.03}}};
  for (const Pose& pose : poses) {
    const Found found = find(bodies, pose);
    ASSERT_EQ(found.fault.status, WRC_OK);
    const BruteForce expected = brute_force(bodies, pose, found.point[0].wheel_s);
    EXPECT_NEAR(found.point[0].vertical_gap, expected.gap, 1e-11) << pose.lateral;
    EXPECT_LE(found.point[0].vertical_gap, expected.gap + 1e-14) << pose.lateral;  // it is a minimum
    EXPECT_NEAR(found.point[0].y, expected.y, 1e-6) << pose.lateral;
  }
}

TEST(ContactSearch, NoOtherPlaceIsCloser) {
  const ReferenceBodies bodies;
  for (double lateral = -7.0 * mm; lateral < 9.0 * mm; lateral += 0.21 * mm) {
    const Pose pose{.lateral = lateral};
    const PosedWheel wheel = posed(bodies.wheel, pose);
    const double found = find(bodies, pose).point[0].vertical_gap;
    std::int32_t piece = 0;
    for (double s = 0.69; s < 0.80; s += 0.02 * mm) {
      const OutlinePoint p = outline(wheel, s, piece);
      const Profile& rail = bodies.rail.profile;
      if (p.y < rail.y[0] || p.y > rail.y[rail.count - 1]) continue;
      EXPECT_GE(evaluate(rail, p.y).z - p.z, found - 1e-13) << lateral;
    }
  }
}

TEST(ContactSearch, LeftWheelIsTheMirrorImage) {
  const ReferenceBodies right(Side::right), left(Side::left);
  for (const double lateral : {-2.0, 0.0, 4.0, 6.5}) {
    const Pose pose{.lateral = lateral * mm, .roll = 0.003, .yaw = 0.008};
    const Pose mirrored{.lateral = -lateral * mm, .roll = -0.003, .yaw = -0.008};
    const ContactPoint a = find(right, pose).point[0], b = find(left, mirrored).point[0];
    EXPECT_NEAR(b.y, -a.y, 1e-10);
    EXPECT_NEAR(b.z, a.z, 1e-12);
    EXPECT_NEAR(b.x, a.x, 1e-11);
    EXPECT_NEAR(b.angle, -a.angle, 1e-8);
    EXPECT_NEAR(b.y_rail, a.y_rail, 1e-10);
    EXPECT_NEAR(b.y_wheel, a.y_wheel, 1e-10);
    EXPECT_NEAR(b.rolling_radius, a.rolling_radius, 1e-12);
  }
}

TEST(ContactSearch, YawMovesTheContactAlongTheContactLocus) {
  // First order: x = -r r' yaw - y yaw, the second part being the wheelset's own turning (theory 1.2).
  const ReferenceBodies bodies;
  const double yaw = 1e-4;
  const ContactPoint contact = find(bodies, Pose{.lateral = 6.0 * mm, .yaw = yaw}).point[0];
  const double slope = std::tan(contact.angle);
  EXPECT_NEAR(contact.x, -contact.rolling_radius * slope * yaw - contact.wheel_s * yaw, 1e-9);
  EXPECT_GT(std::abs(contact.rolling_radius * slope * yaw), 1e-5);  // far above that tolerance
}

TEST(ContactSearch, VerticalShiftOnlyChangesTheGap) {
  const ReferenceBodies bodies;
  const ContactPoint a = find(bodies, Pose{.lateral = 2.0 * mm}).point[0];
  const ContactPoint b = find(bodies, Pose{.lateral = 2.0 * mm, .vertical = 0.3 * mm}).point[0];
  EXPECT_NEAR(b.vertical_gap, a.vertical_gap - 0.3 * mm, 1e-15);
  EXPECT_EQ(b.y, a.y);
}

TEST(ContactSearch, RoomForOnePointKeepsTheClosest) {
  const ReferenceBodies bodies;
  const Found all = find(bodies, Pose{.lateral = 5.2 * mm});
  ASSERT_GE(all.count, 2);
  ContactPoint one;
  std::int32_t count = 0;
  find_contact(bodies.rail, posed(bodies.wheel, Pose{.lateral = 5.2 * mm}), 1, &one, count);
  EXPECT_EQ(count, 1);
  EXPECT_EQ(one.y, all.point[0].y);
}

TEST(ContactSearch, WheelBesideTheRailIsAnError) {
  const ReferenceBodies bodies;
  const Found beside = find(bodies, Pose{.lateral = 0.2});
  EXPECT_EQ(beside.fault.status, WRC_ERROR_GAP);
  EXPECT_EQ(beside.count, 0);
}

TEST(ContactSearch, APoseThatIsNoNumberHasNoContact) {
  const ReferenceBodies bodies;
  for (const Pose& pose :
       {Pose{.lateral = std::nan("")}, Pose{.vertical = std::nan("")}, Pose{.roll = std::nan("")},
        Pose{.yaw = std::nan("")}, Pose{.lateral = INFINITY}}) {
    const Found found = find(bodies, pose);
    EXPECT_TRUE(found.fault.failed());
    EXPECT_EQ(found.count, 0);
  }
}

TEST(Placement, Nominal60E1CantedByOneFortiethLiesCloseToTheBenchmark) {
  ProfileStore upright, placed;
  Profile profile;
  Rail rail;
  ASSERT_EQ(sample_rail_head(rail_60e1, upright.memory(), profile).status, WRC_OK);
  ASSERT_EQ(place_rail(profile, usual_track(1.0 / 40.0), Side::right, placed.memory(), rail).status, WRC_OK);
  const ReferenceBodies bodies;
  for (double y = 0.735; y < 0.780; y += 1.0 * mm) {
    // The heads differ by a few hundredths of a millimetre at the gauge corner, which shifts them as much.
    EXPECT_NEAR(evaluate(rail.profile, y).z, evaluate(bodies.rail.profile, y).z, 0.05 * mm) << y;
  }
}

TEST(Placement, GaugeFaceStandsAtHalfTheGauge) {
  for (const double inclination : {0.0, 1.0 / 40.0, 1.0 / 20.0}) {
    ProfileStore upright, placed;
    Profile profile;
    Rail rail;
    sample_rail_head(rail_60e1, upright.memory(), profile);
    place_rail(profile, usual_track(inclination), Side::right, placed.memory(), rail);
    EXPECT_NEAR(highest_point(rail.profile).z, 0.0, 1e-15);
    EXPECT_NEAR(evaluate(rail.profile, 0.5 * usual_track().gauge).z, usual_track().gauge_depth, 1e-9)
        << inclination;
  }
}

/// Whatever was worn off: the origin of the points lies where it is told to, canting turns the profile about
/// it.
TEST(Placement, ByOriginARailStaysWhereItsPointsAre) {
  for (const Side side : {Side::right, Side::left}) {
    const double outward = side == Side::left ? -1.0 : 1.0;
    for (const double inclination : {0.0, 1.0 / 40.0}) {
      ProfileStore upright, placed;
      Profile profile;
      Rail rail;
      sample_rail_head(rail_60e1, upright.memory(), profile);
      for (std::int32_t i = 0; i < profile.count; ++i) upright.memory().z[i] += 0.8 * mm;  // worn down
      profile = profile_in(upright.memory(), profile.count);
      TrackDimensions track = usual_track(inclination);
      track.by_origin = true;
      track.rail_origin = 0.7605;
      ASSERT_EQ(place_rail(profile, track, side, placed.memory(), rail).status, WRC_OK);
      EXPECT_EQ(rail.origin_y, outward * 0.7605);
      EXPECT_EQ(rail.origin_z, 0.0);
      // the crown, 0.8 mm below the origin, moves sideways by the cant
      const double sine = inclination / std::sqrt(1.0 + inclination * inclination);
      const double y = outward * (0.7605 + 0.8 * mm * sine);
      EXPECT_NEAR(evaluate(rail.profile, y).z, 0.8 * mm * std::sqrt(1.0 - sine * sine), 1e-12);
    }
  }
}

}  // namespace
}  // namespace wrc::geometry
