// The friction law: falling, zones, the coefficient of each strip.
#include <gtest/gtest.h>

#include "tangential/friction/friction.hpp"
#include "tangential_patches.hpp"

namespace wrc::tangential {
namespace {

using test::OwnedStrips;
using test::sdec_strips;

TEST(FrictionLaw, FallsAsPolachHasIt) {
  // mu_0 = 0.36, A = 0.38, B = 0.7 s/m (Polach): at 1 m/s 0.36 (0.62 exp(-0.7) + 0.38) = 0.2476378
  FrictionLaw law{
      .coefficient = 0.36, .speed_law = SpeedLaw::exponential, .kinetic_ratio = 0.38, .fall_rate = 0.7};
  EXPECT_EQ(speed_factor(law, 0.0), 1.0);
  EXPECT_NEAR(0.36 * speed_factor(law, 1.0), 0.2476378, 1e-6);
  EXPECT_NEAR(speed_factor(law, 1e9), 0.38, 1e-15);
  law.speed_law = SpeedLaw::hyperbolic;
  law.half_speed = 0.5;
  EXPECT_EQ(speed_factor(law, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(speed_factor(law, 0.5), 0.69);  // half way from 1 to 0.38
  EXPECT_NEAR(speed_factor(law, 1e9), 0.38, 1e-8);
  law.speed_law = SpeedLaw::none;
  EXPECT_EQ(speed_factor(law, 3.0), 1.0);
}

TEST(FrictionLaw, ZonesAreIntegratedExactly) {
  const double y[] = {-2.0, -1.0, -1.0, 1.0}, c[] = {0.4, 0.4, 0.1, 0.3};  // a step at -1, a ramp to 1
  const FrictionZones zones{4, y, c};
  EXPECT_DOUBLE_EQ(mean_friction(zones, -9.0, -3.0), 0.4);
  EXPECT_DOUBLE_EQ(mean_friction(zones, 4.0, 5.0), 0.3);
  EXPECT_DOUBLE_EQ(mean_friction(zones, -2.0, -1.0), 0.4);
  EXPECT_DOUBLE_EQ(mean_friction(zones, -1.0, 1.0), 0.2);
  EXPECT_DOUBLE_EQ(mean_friction(zones, 0.0, 0.5), 0.225);
  EXPECT_DOUBLE_EQ(mean_friction(zones, -1.5, -0.5), 0.5 * 0.4 + 0.5 * 0.125);
  EXPECT_NEAR(mean_friction(zones, -3.0, 3.0), (2.0 * 0.4 + 2.0 * 0.2 + 2.0 * 0.3) / 6.0, 1e-15);
  const FrictionZones one{1, y, c};
  EXPECT_DOUBLE_EQ(mean_friction(one, -5.0, 5.0), 0.4);
}

class StripLaw : public ::testing::Test {
 protected:
  static constexpr int count = 20;
  OwnedStrips strips = sdec_strips(5e-3, 4e-3, 0.3, 80e3, count);
  std::vector<double> shares = std::vector<double>(count);
  const double y[2] = {-1e-3, 1e-3}, c[2] = {0.1, 0.5};

  StripFriction find(const FrictionLaw& law, const FrictionFrame& frame, const Creepage& creepage,
                     double speed, SlidingSpeed sliding = SlidingSpeed::of_strip) {
    return evaluate(law, strips.get(), frame, creepage, speed, sliding, shares.data());
  }
};

TEST_F(StripLaw, ConstantFrictionIsOneNumber) {
  const StripFriction f = find({.coefficient = 0.37}, {}, {1e-3, 0.0, 0.3}, 30.0);
  EXPECT_EQ(f.mean, 0.37);
  EXPECT_EQ(f.shares, nullptr);
  EXPECT_EQ(shares[7], 1.0);
}

TEST_F(StripLaw, MeanIsWeightedByTheLoad) {
  const StripFriction f = find({.zones = {2, y, c}}, {}, {}, 0.0);
  const patch::Strips& s = strips.get();
  double limit = 0.0;
  for (int j = 0; j < count; ++j) {
    EXPECT_NEAR(f[j], mean_friction({2, y, c}, s.y[j] - 0.5 * s.width[j], s.y[j] + 0.5 * s.width[j]), 1e-15);
    limit += f[j] * 0.5 * pi * s.half_length[j] * s.peak[j] * s.width[j];
  }
  EXPECT_NEAR(f.mean * patch::totals(s).normal_force, limit, 1e-9 * limit);
}

TEST_F(StripLaw, ZonesStayWhereTheFrameSays) {
  // A frame shifted by 0.5 mm and turned round sees the zones mirrored.
  const StripFriction f = find({.zones = {2, y, c}}, {0.2e-3, 0.5e-3, -1.0}, {}, 0.0);
  const patch::Strips& s = strips.get();
  for (int j = 0; j < count; ++j) {
    const double middle = 0.5e-3 - (0.2e-3 + s.y[j]), half = 0.5 * s.width[j];
    EXPECT_NEAR(f[j], mean_friction({2, y, c}, middle - half, middle + half), 1e-15);
  }
}

TEST_F(StripLaw, SlidingSpeedIsTheMeanSquareOfTheRigidSlip) {
  const FrictionLaw law{
      .coefficient = 0.4, .speed_law = SpeedLaw::hyperbolic, .kinetic_ratio = 0.25, .half_speed = 0.03};
  const Creepage creep{2e-3, -1e-3, 0.7};
  const double V = 25.0, origin = 1e-3;
  const StripFriction f = find(law, {.origin = origin}, creep, V);
  const patch::Strips& s = strips.get();
  for (int j = 0; j < count; ++j) {
    double square = 0.0;
    constexpr int points = 2000;
    for (int i = 0; i < points; ++i) {
      const double x = s.half_length[j] * (2.0 * (i + 0.5) / points - 1.0);
      square += std::pow(creep.longitudinal - creep.spin * (origin + s.y[j]), 2) +
                std::pow(creep.lateral + creep.spin * x, 2);
    }
    const double w = V * std::sqrt(square / points);
    EXPECT_NEAR(f[j], 0.4 * (0.25 + 0.75 / (1.0 + w / 0.03)), 1e-7);
  }
  const StripFriction one = find(law, {.origin = origin}, creep, V, SlidingSpeed::of_patch);
  const double w = V * std::hypot(creep.longitudinal - creep.spin * origin, creep.lateral);
  EXPECT_NEAR(one.mean, 0.4 * (0.25 + 0.75 / (1.0 + w / 0.03)), 1e-15);
  EXPECT_NEAR(one[3], one.mean, 1e-15);
}

TEST_F(StripLaw, NoFrictionAnywhereIsNone) {
  const double zero[2] = {0.0, 0.0};
  const StripFriction f = find({.zones = {2, y, zero}}, {}, {}, 0.0);
  EXPECT_EQ(f.mean, 0.0);
  EXPECT_EQ(f[5], 0.0);
}

}  // namespace
}  // namespace wrc::tangential
