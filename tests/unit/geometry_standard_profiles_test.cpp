#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry_test_bodies.hpp"

namespace wrc::geometry {
namespace {

constexpr double mm = 1e-3;

/// Largest distance in z between a sampled profile and its analytic curve [m].
template <class Curve>
double largest_deviation(const Profile& profile, const Curve& curve) {
  double worst = 0.0;
  const double low = profile.y[0], high = profile.y[profile.count - 1];
  constexpr int samples = 50000;
  for (int i = 0; i <= samples; ++i) {
    const double y = low + (high - low) * i / samples;
    worst = std::max(worst, std::abs(evaluate(profile, y).z - curve(y).z));
  }
  return worst;
}

/// Slope and second derivative belong to the value: central differences agree.
template <class Curve>
void expect_consistent_derivatives(const Curve& curve, double y) {
  constexpr double h = 1e-6;
  const double slope = (curve(y + h).z - curve(y - h).z) / (2.0 * h);
  const double second = (curve(y + h).slope - curve(y - h).slope) / (2.0 * h);
  EXPECT_NEAR(curve(y).slope, slope, 1e-6 * (1.0 + std::abs(slope))) << y;
  EXPECT_NEAR(curve(y).second, second, 1e-4 * (1.0 + std::abs(second))) << y;
}

TEST(S1002, TapeCircleIsTheOriginAndTheFlangeTipIs28MillimetresDown) {
  EXPECT_EQ(s1002(0.0).z, 0.0);
  EXPECT_NEAR(s1002(-55.0 * mm).z, 28.0 * mm, 1e-12);  // section G: centre (-55, 16), radius 12
  EXPECT_EQ(s1002(-55.0 * mm).slope, 0.0);
  EXPECT_NEAR(s1002(60.0 * mm).z, (1.364323640 - 0.066666667 * 60.0) * mm, 1e-15);
}

TEST(S1002, FlangeFaceIsInclinedBy70Degrees) {
  EXPECT_NEAR(std::atan(s1002(-39.0 * mm).slope) * 180.0 / 3.14159265358979, -70.0, 1e-6);
}

TEST(S1002, IsContinuousInValueAndSlopeAtEveryJoin) {
  for (const double join :
       {32.15796, -26.0, -35.0, -38.426669071, -39.764473993, -49.662510381, -62.764705882}) {
    const double y = join * mm, step = 1e-12;
    const ProfilePoint below = s1002(y - step), above = s1002(y + step);
    // The standard rounds its joins and centres to 1e-9..1e-5 mm; the steps that remain are below 1e-7 mm.
    EXPECT_NEAR(above.z, below.z, 1e-10) << join;
    EXPECT_NEAR(above.slope, below.slope, 2e-7) << join;
  }
}

TEST(S1002, FlangeRootCorrectionIsTheStandardsOwnStepAndNoMore) {
  // Steps of the printed formulas: 3.7e-5 mm at -26 mm, 1.2e-4 mm at -35 mm.
  const auto correction = [](double y) { return s1002(y).z - s1002_flange_root_of_standard(y).z; };
  EXPECT_NEAR(std::abs(correction(-26.0 * mm - 1e-12)), 3.7e-5 * mm, 0.05e-5 * mm);
  EXPECT_NEAR(std::abs(correction(-35.0 * mm + 1e-12)), 1.2e-4 * mm, 0.05e-4 * mm);
  for (double y = -35.0 * mm; y < -26.0 * mm; y += 0.1 * mm) EXPECT_LT(std::abs(correction(y)), 1.3e-4 * mm);
}

TEST(S1002, DerivativesBelongToTheCurve) {
  for (const double y : {-65.0, -55.5, -45.0, -39.0, -37.0, -30.0, -20.0, 0.0, 20.0, 40.0}) {
    expect_consistent_derivatives(s1002, y * mm);
  }
}

TEST(S1002, SampledCurveStaysWithinANanometre) {
  ProfileStore store;
  Profile profile;
  ASSERT_EQ(sample_s1002(store.memory(), profile).status, WRC_OK);
  EXPECT_EQ(profile.count, s1002_nodes);
  EXPECT_LT(largest_deviation(profile, s1002), 1e-9);
}

TEST(RailHead, TangencyReproducesThePublishedCentres) {
  // theory 6.2, millimetres
  EXPECT_NEAR(rail_60e1.shoulder_centre_y(), 7.50053 * mm, 1e-8);
  EXPECT_NEAR(rail_60e1.shoulder_centre_z(), 80.12790 * mm, 1e-8);
  EXPECT_NEAR(rail_60e1.corner_centre_y(), 23.01603 * mm, 1e-8);
  EXPECT_NEAR(rail_60e1.corner_centre_z(), 14.94915 * mm, 1e-8);
  EXPECT_NEAR(rail_uic60_benchmark.shoulder_centre_y(), 7.6998 * mm, 3e-7);
  EXPECT_NEAR(rail_uic60_benchmark.shoulder_centre_z(), 80.1348 * mm, 1e-7);
  EXPECT_NEAR(rail_uic60_benchmark.corner_centre_y(), 23.0162 * mm, 1e-7);
  EXPECT_NEAR(rail_uic60_benchmark.corner_centre_z(), 14.9090 * mm, 1e-7);
  EXPECT_NEAR(rail_uic60_benchmark.side_y(), 36.0000 * mm, 1e-7);
  EXPECT_NEAR(rail_uic60_benchmark.side_z(), 14.2598 * mm, 1e-7);
}

TEST(RailHead, ArcsAreTangentAtTheirJoins) {
  for (const RailHead& head : {rail_60e1, rail_uic60_benchmark}) {
    for (const double y : {head.crown_half_width, head.shoulder_half_width, head.side_y()}) {
      const ProfilePoint below = rail_head(head, y - 1e-13), above = rail_head(head, y + 1e-13);
      EXPECT_NEAR(above.z, below.z, 1e-11);
      EXPECT_NEAR(above.slope, below.slope, 1e-7);
    }
  }
}

TEST(RailHead, IsSymmetric) {
  for (double y = 0.0; y < 0.036; y += 0.0007) {
    EXPECT_EQ(rail_head(rail_60e1, y).z, rail_head(rail_60e1, -y).z);
    EXPECT_EQ(rail_head(rail_60e1, y).slope, -rail_head(rail_60e1, -y).slope);
  }
}

TEST(RailHead, BenchmarkIsNotThe60E1) {
  // Same radii, other transitions: more than 0.02 mm apart at the gauge corner, normal to the surface.
  double worst = 0.0;
  for (double y = 0.0; y < 0.0359; y += 1e-5) {
    const ProfilePoint nominal = rail_head(rail_60e1, y), benchmark = rail_head(rail_uic60_benchmark, y);
    worst =
        std::max(worst, std::abs(nominal.z - benchmark.z) / std::sqrt(1.0 + nominal.slope * nominal.slope));
  }
  EXPECT_GT(worst, 20e-6);
  EXPECT_LT(worst, 50e-6);
}

TEST(RailHead, SampledCurveStaysWithinANanometre) {
  for (const RailHead& head : {rail_60e1, rail_uic60_benchmark}) {
    ProfileStore store;
    Profile profile;
    ASSERT_EQ(sample_rail_head(head, store.memory(), profile).status, WRC_OK);
    EXPECT_EQ(profile.count, rail_head_nodes);
    EXPECT_LT(largest_deviation(profile, [&](double y) { return rail_head(head, y); }), 1e-9);
  }
}

TEST(UIC60Benchmark, IsCantedByOneFortieth) {
  ProfileStore store;
  Profile profile;
  ASSERT_EQ(sample_uic60_benchmark(store.memory(), profile).status, WRC_OK);
  // theory 6.2: rotation -0.0249948 rad, crown at (-7.4917, 0.0937) mm, origin at the highest point.
  const ProfilePoint crown = evaluate(profile, -7.4917 * mm);
  EXPECT_NEAR(crown.z, 0.0937 * mm, 1e-10);
  EXPECT_NEAR(std::atan(crown.slope), -0.0249948, 1e-7);
  EXPECT_NEAR(highest_point(profile).z, 0.0, 1e-8);
  // The 1:20 sides of the upright head now stand at 1:40 (gauge) and 3:40 (field), to first order.
  EXPECT_NEAR(profile.slope[0], -std::tan(std::atan(20.0) + std::atan(1.0 / 40.0)), 1e-9);
  EXPECT_NEAR(profile.slope[profile.count - 1], std::tan(std::atan(20.0) - std::atan(1.0 / 40.0)), 1e-9);
}

TEST(StandardProfiles, TooLittleMemoryIsAnExactError) {
  ProfileStore store;
  Profile profile;
  ProfileMemory memory = store.memory();
  memory.capacity = s1002_nodes - 1;
  EXPECT_EQ(sample_s1002(memory, profile).status, WRC_ERROR_BUFFER);
  memory.capacity = s1002_nodes;
  EXPECT_EQ(sample_s1002(memory, profile).status, WRC_OK);
  memory.capacity = rail_head_nodes - 1;
  EXPECT_EQ(sample_rail_head(rail_60e1, memory, profile).status, WRC_ERROR_BUFFER);
  EXPECT_EQ(sample_uic60_benchmark(memory, profile).status, WRC_ERROR_BUFFER);
  memory.capacity = rail_head_nodes;
  EXPECT_EQ(sample_rail_head(rail_60e1, memory, profile).status, WRC_OK);
}

}  // namespace
}  // namespace wrc::geometry
