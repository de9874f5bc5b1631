#include <gtest/gtest.h>

#include <cmath>

#include "normal/damping.hpp"

namespace wrc {
namespace {

TEST(NormalDamping, NeverPullsAndVanishesWithTheContact) {
  EXPECT_EQ(damped_normal_force(0.0, 5.0, 0.1), 0.0);
  EXPECT_EQ(damped_normal_force(80e3, -100.0, 0.1), 0.0);
  EXPECT_EQ(damped_normal_force(80e3, 0.3, 0.0), 80e3);
  EXPECT_GT(damped_normal_force(80e3, 0.3, 0.1), 80e3);
}

TEST(NormalDamping, GivesTheCoefficientOfRestitutionItNames) {
  // A mass of 500 kg strikes a Hertzian contact at 0.2 m/s with alpha v = 0.04; leapfrog, 1 us.
  constexpr double mass = 500.0, speed = 0.2, alpha = 0.2, stiffness = 1.5e11, step = 1e-6;
  double approach = 0.0, rate = speed;
  do {
    const double force = damped_normal_force(stiffness * std::pow(approach, 1.5), rate, alpha);
    rate -= step * force / mass;
    approach += step * rate;
  } while (approach > 0.0);
  EXPECT_NEAR(-rate / speed, 1.0 - alpha * speed, 0.003);
}

}  // namespace
}  // namespace wrc
