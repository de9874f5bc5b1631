#include <gtest/gtest.h>

#include <cmath>

#include "normal/damping.hpp"

namespace wrc::normal {
namespace {

TEST(NormalDamping, NeverPulls) {
  EXPECT_EQ(damping_factor(-100.0, 0.1), 0.0);
  EXPECT_EQ(damping_factor(0.3, 0.0), 1.0);
  EXPECT_NEAR(damping_factor(0.3, 0.1), 1.045, 1e-15);
}

TEST(NormalDamping, GivesTheCoefficientOfRestitutionItNames) {
  // A mass of 500 kg strikes a Hertzian contact at 0.2 m/s with alpha v = 0.04; leapfrog, 1 us.
  constexpr double mass = 500.0, speed = 0.2, alpha = 0.2, stiffness = 1.5e11, step = 1e-6;
  double approach = 0.0, rate = speed;
  do {
    const double force = stiffness * std::pow(approach, 1.5) * damping_factor(rate, alpha);
    rate -= step * force / mass;
    approach += step * rate;
  } while (approach > 0.0);
  EXPECT_NEAR(-rate / speed, 1.0 - alpha * speed, 0.003);
}

}  // namespace
}  // namespace wrc::normal
