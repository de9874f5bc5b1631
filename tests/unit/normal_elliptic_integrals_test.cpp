#include <gtest/gtest.h>

#include <cmath>

#include "base/elementary.hpp"
#include "normal/elasticity/elliptic_integrals.hpp"
#include "patch/material.hpp"

namespace wrc::normal {
namespace {

TEST(EllipticIntegrals, AgreeWithTheStandardLibrary) {
  for (double k = 0.05; k < 0.99; k += 0.05) {
    const CompleteElliptic value = complete_elliptic(std::sqrt((1.0 - k) * (1.0 + k)));
    // libstdc++ stops Carlson's series at about 5e-14; Legendre's relation below is the sharper test.
    EXPECT_NEAR(value.k, std::comp_ellint_1(k), 5e-14 * value.k) << k;
    EXPECT_NEAR(value.e, std::comp_ellint_2(k), 5e-14 * value.k) << k;
    EXPECT_NEAR(value.d * k * k, value.k - value.e, 4e-15 * value.k) << k;
  }
}

TEST(EllipticIntegrals, ReachTheirLimits) {
  const CompleteElliptic circle = complete_elliptic(1.0);
  EXPECT_DOUBLE_EQ(circle.k, pi / 2.0);
  EXPECT_DOUBLE_EQ(circle.e, pi / 2.0);
  EXPECT_DOUBLE_EQ(circle.d, pi / 4.0);
  const CompleteElliptic slender = complete_elliptic(1e-12);
  EXPECT_NEAR(slender.k, std::log(4e12), 1e-13 * slender.k);
  EXPECT_NEAR(slender.e, 1.0, 1e-13);
  EXPECT_TRUE(std::isfinite(complete_elliptic(0.0).k));
}

TEST(EllipticIntegrals, ObeyLegendresRelation) {
  for (double kc = 0.02; kc < 1.0; kc += 0.07) {
    const CompleteElliptic here = complete_elliptic(kc);
    const CompleteElliptic there = complete_elliptic(std::sqrt((1.0 - kc) * (1.0 + kc)));
    EXPECT_NEAR(here.e * there.k + there.e * here.k - here.k * there.k, pi / 2.0, 1e-14) << kc;
  }
}

TEST(NaturalLog, AgreesWithTheStandardLibrary) {
  for (double x = 1e-9; x < 1e9; x *= 1.37)
    EXPECT_NEAR(natural_log(x), std::log(x), 1e-15 * (1.0 + std::abs(std::log(x))));
  EXPECT_EQ(natural_log(1.0), 0.0);
}

}  // namespace
}  // namespace wrc::normal
