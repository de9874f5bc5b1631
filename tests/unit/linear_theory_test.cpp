#include <gtest/gtest.h>

#include <cmath>

#include "linear_theory/flexibility.hpp"
#include "patch/material.hpp"

namespace wrc {
namespace {

KalkerCoefficients kalker(double ratio, double poisson) {
  Fault fault;
  return KalkerTable(poisson).at(ratio, fault);
}

TEST(Kalker, ReproducesThePrintedTable) {
  EXPECT_NEAR(kalker(0.5, 0.25).c11, 3.62, 1e-12);
  EXPECT_NEAR(kalker(1.0, 0.0).c22, 3.40, 1e-12);
  EXPECT_NEAR(kalker(1.0, 0.5).c23, 1.63, 1e-12);
  EXPECT_NEAR(kalker(5.0, 0.25).c23, 6.63, 1e-12);
  EXPECT_NEAR(kalker(10.0, 0.5).c11, 12.9, 1e-12);
}

TEST(Kalker, RisesWithTheAxisRatioAtAUsualPoissonRatio) {
  for (double ratio : {0.15, 0.25, 0.65, 0.95, 1.2, 1.8, 2.9, 4.0, 7.0}) {
    const KalkerCoefficients low = kalker(ratio * 0.9, 0.28), mid = kalker(ratio, 0.28),
                             high = kalker(ratio * 1.1, 0.28);
    EXPECT_LT(low.c11, mid.c11);
    EXPECT_LT(mid.c11, high.c11);
    EXPECT_LT(low.c22, mid.c22);
    EXPECT_LT(mid.c22, high.c22);
    EXPECT_LT(low.c23, mid.c23);
    EXPECT_LT(mid.c23, high.c23);
  }
}

TEST(Kalker, IsSmoothAcrossTheWholeRange) {
  // No jump of value or slope anywhere, the ends of the table (0.1 and 10) included: one-sided slopes in
  // log(a/b) agree, for coarse and extreme Poisson ratios alike.
  for (double poisson : {0.0, 0.1, 0.28, 0.4, 0.5}) {
    for (double ratio : {0.1, 0.3, 1.0, 2.5, 10.0}) {
      const double step = 1e-5;
      const auto slope = [&](auto member, double from, double to) {
        return (kalker(ratio * std::exp(to), poisson).*member -
                kalker(ratio * std::exp(from), poisson).*member) /
               (to - from);
      };
      for (auto member : {&KalkerCoefficients::c11, &KalkerCoefficients::c22, &KalkerCoefficients::c23}) {
        const double before = slope(member, -step, 0.0), after = slope(member, 0.0, step);
        EXPECT_NEAR(before, after, 1e-3 * kalker(ratio, poisson).*member) << poisson << " " << ratio;
      }
    }
  }
}

TEST(Kalker, ApproachesTheAsymptotesOfSlenderEllipses) {
  const double g = 1e-4, nu = 0.28;
  const KalkerCoefficients narrow = kalker(g, nu);
  EXPECT_NEAR(narrow.c11, pi * pi / (4.0 * (1.0 - nu)), 2e-3 * narrow.c11);
  EXPECT_NEAR(narrow.c22, pi * pi / 4.0, 2e-3 * narrow.c22);
  const double L = std::log(16.0 / (g * g));
  const double c23 = 2.0 * pi / (3.0 * std::pow(g, 1.5) * ((1.0 - nu) * L - 2.0 + 4.0 * nu));
  EXPECT_NEAR(kalker(1.0 / g, nu).c23, c23, 2e-3 * c23);
}

TEST(Kalker, StaysPositiveAndMonotoneInTheSlenderLimits) {
  for (double poisson : {0.0, 0.25, 0.5}) {
    for (double ratio = 1e-6; ratio < 1e6; ratio *= 1.05) {
      const KalkerCoefficients here = kalker(ratio, poisson), next = kalker(ratio * 1.05, poisson);
      EXPECT_GT(here.c22, 0.0);
      EXPECT_GT(here.c23, 0.0);
      // C11 falls slightly as a/b grows from 0 to about 0.3 for nu > 0.4 (so does Kalker's table).
      EXPECT_GT(next.c11, here.c11 * (poisson > 0.4 ? 0.99 : 0.9999)) << poisson << " " << ratio;
      EXPECT_GT(next.c22, here.c22 * 0.9999) << poisson << " " << ratio;
      EXPECT_GT(next.c23, here.c23) << poisson << " " << ratio;
    }
  }
}

TEST(Sdec, CoefficientsOfTheTableAndItsSymmetry) {
  Fault fault;
  const SdecTable table(0.25);
  const SdecCoefficients s = table.at(2.0 / 3.0, 0.4, fault);
  EXPECT_EQ(fault.status, WRC_OK);
  EXPECT_NEAR(s.c11, kalker(2.0 / 3.0, 0.25).c11 + 0.118 * 0.16, 2e-4);
  EXPECT_NEAR(s.c13, -3.679 * 0.4, 0.002 * 3.679);
  const SdecCoefficients mirrored = table.at(2.0 / 3.0, -0.4, fault);
  EXPECT_EQ(mirrored.c13, -s.c13);
  EXPECT_EQ(mirrored.c11, s.c11);
}

TEST(Sdec, CouplingFollowsTheFittedFormula) {
  // K13 = 0.75 C11 sqrt(b/a) (1.028 - 0.0715 ln(a/b) - 0.011 ln^2(a/b)) within 1 %, fitted to exact
  // solutions.
  for (double poisson : {0.25, 0.28, 0.30}) {
    const SdecTable table(poisson);
    for (double ratio : {0.2, 0.28, 0.4, 0.8, 1.2, 2.5, 4.0, 5.0}) {
      Fault fault;
      const SdecCoefficients s = table.at(ratio, 0.0, fault);
      const double t = std::log(ratio);
      const double fit = 0.75 * s.c11 / std::sqrt(ratio) * (1.028 - 0.0715 * t - 0.011 * t * t);
      EXPECT_NEAR(s.k13, fit, 0.015 * fit) << poisson << " " << ratio;
    }
  }
}

TEST(Sdec, ExtendsSmoothlyAndSaysSo) {
  Fault fault;
  const SdecTable table(0.28);
  const SdecCoefficients below = table.at(4.9999, 0.5, fault);
  EXPECT_EQ(fault.status, WRC_OK);
  const SdecCoefficients above = table.at(5.0001, 0.5, fault);
  EXPECT_EQ(fault.status, WRC_FLAG_TABLE_RANGE);
  EXPECT_NEAR(below.c13, above.c13, 1e-3);
  Fault poisson;
  const SdecCoefficients zero = SdecTable(0.0).at(1.0, 0.5, poisson),
                         half = SdecTable(0.5).at(1.0, 0.5, poisson);
  EXPECT_EQ(poisson.status, WRC_FLAG_TABLE_RANGE);
  EXPECT_LT(zero.c11, half.c11);
  EXPECT_GT(zero.c11, 3.40);
}

TEST(Flexibility, FullAdhesionForcesAreThoseOfLinearTheory) {
  // Integrals of the adhesion tractions over an SDEC: IInt (x - x_l) = -8/3 a^2 b, IInt y (x - x_l) = -2 a^2
  // b^2 psi, IInt (x^2 - x_l^2) = -pi/2 a^3 b.
  const double a = 4e-3, b = 6e-3, psi = 0.4, G = 80e9, nu = 0.25;
  Fault fault;
  const SdecTable table(nu);
  const SdecCoefficients s = table.at(a / b, psi, fault);
  const Flexibility L = sdec_flexibility(a, b, psi, G, table, fault);
  const double c = std::sqrt(a * b);
  EXPECT_NEAR(-8.0 / 3.0 * a * a * b / L.l11, -G * c * c * s.c11, 1e-9 * G * c * c);
  EXPECT_NEAR(2.0 * a * a * b * b * psi / L.l13, -G * c * c * c * s.c13, 1e-9 * G * c * c * c);
  EXPECT_NEAR(-8.0 / 3.0 * a * a * b / L.l22, -G * c * c * s.c22, 1e-9 * G * c * c);
  EXPECT_NEAR(-pi / 4.0 * a * a * a * b / L.l23, -G * c * c * c * s.c23, 1e-9 * G * c * c * c);
}

}  // namespace
}  // namespace wrc
