#include <gtest/gtest.h>

#include <cmath>

#include "patch/material.hpp"
#include "theory/flexibility.hpp"

namespace wrc::theory {
namespace {

KalkerCoefficients kalker(double ratio, double poisson) {
  Fault fault;
  return KalkerTable(poisson).at(ratio, fault);
}

// More of the table: generated_tables_test.cpp.
TEST(Kalker, CoefficientsOfTheCircle) {
  // ellipse_linear_coefficients(1, nu, 80); the print has 4.12 and 5.20, 3.67 and 3.98, 1.47 and 1.63.
  EXPECT_NEAR(kalker(1.0, 0.25).c11, 4.11282, 1e-5);
  EXPECT_NEAR(kalker(1.0, 0.25).c22, 3.66830, 1e-5);
  EXPECT_NEAR(kalker(1.0, 0.25).c23, 1.46611, 1e-5);
  EXPECT_NEAR(kalker(1.0, 0.5).c11, 5.20418, 1e-5);
  EXPECT_NEAR(kalker(1.0, 0.5).c22, 3.98114, 1e-5);
  EXPECT_NEAR(kalker(1.0, 0.5).c23, 1.63096, 1e-5);
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
  // No jump of value or slope anywhere, the ends of the table (0.05 and 20) included: one-sided slopes in
  // log(a/b) agree, for coarse and extreme Poisson ratios alike.
  for (double poisson : {0.0, 0.1, 0.28, 0.4, 0.5}) {
    for (double ratio : {0.05, 0.1, 0.3, 1.0, 2.5, 10.0, 20.0}) {
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

TEST(Sdec, AgreesWithTheReferenceProgramAndIsSymmetric) {
  // CONTACT on exact double ellipses in full adhesion, nu = 0.25, fitted over psi: C11s = C11 + b11 psi^2 and
  // so on, C13s = -k13 psi about the joint. Its C23s is about the middle of the width; moving it takes
  // C12s = c12 psi, which the model leaves out. On grids of 29 to 41 cells a side it is good for 0.2 % of
  // C11, C22, twice that of C23 and 1 % of C13.
  struct Row {
    double ratio, b11, b22, b23, k13, c12;
  };
  const SdecTable table(0.25);
  for (const Row& r :
       {Row{0.2, .053, .062, .0108, 6.298, .0035}, Row{0.5, .104, .095, .0346, 4.139, .0052},
        Row{2.0 / 3.0, .118, .100, .0424, 3.679, .0054}, Row{1.0, .132, .101, .0522, 3.177, .0052},
        Row{2.0, .130, .084, .0593, 2.608, .0046}, Row{5.0, .089, .044, .0454, 2.307, .0032}}) {
    for (double psi : {0.2, 0.4, 0.6, 0.8}) {
      Fault fault;
      const SdecCoefficients s = table.at(r.ratio, psi, fault);
      const KalkerCoefficients ellipse = kalker(r.ratio, 0.25);
      const double c23 = ellipse.c23 + (r.b23 + r.c12 / std::sqrt(r.ratio)) * psi * psi;
      EXPECT_EQ(fault.status, WRC_OK);
      EXPECT_NEAR(s.c11, ellipse.c11 + r.b11 * psi * psi, 0.002 * ellipse.c11) << r.ratio << " " << psi;
      EXPECT_NEAR(s.c22, ellipse.c22 + r.b22 * psi * psi, 0.002 * ellipse.c22) << r.ratio << " " << psi;
      EXPECT_NEAR(s.c23, c23, 0.004 * c23) << r.ratio << " " << psi;
      EXPECT_NEAR(s.c13, -r.k13 * psi, 0.015 * r.k13 * psi) << r.ratio << " " << psi;
      const SdecCoefficients mirrored = table.at(r.ratio, -psi, fault);
      EXPECT_EQ(mirrored.c13, -s.c13);
      EXPECT_EQ(mirrored.c11, s.c11);
    }
  }
}

TEST(Sdec, ExtendsSmoothlyAndSaysSo) {
  const SdecTable table(0.28);
  Fault inside, wide, narrow, asymmetric;
  const SdecCoefficients below = table.at(19.9999, 0.5, inside), above = table.at(20.0001, 0.5, wide);
  EXPECT_EQ(inside.status, WRC_OK);
  EXPECT_EQ(wide.status, WRC_FLAG_TABLE_RANGE);
  EXPECT_NEAR(below.c13, above.c13, 1e-4);
  EXPECT_NEAR(below.c23, above.c23, 1e-2);
  table.at(0.0499, 0.5, narrow);
  EXPECT_EQ(narrow.status, WRC_FLAG_TABLE_RANGE);
  table.at(1.0, 0.96, asymmetric);
  EXPECT_EQ(asymmetric.status, WRC_FLAG_TABLE_RANGE);
}

TEST(Sdec, CoversAllPoissonRatios) {
  double last = 0.0;
  for (double poisson = 0.0; poisson <= 0.5; poisson += 0.05) {
    Fault fault;
    const double c11 = SdecTable(poisson).at(1.0, 0.5, fault).c11;
    EXPECT_EQ(fault.status, WRC_OK);
    EXPECT_GT(c11, last);
    last = c11;
  }
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
}  // namespace wrc::theory
