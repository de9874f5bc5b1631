// Polach's force law: numbers of the published form, its own picture integrated, linear theory, Coulomb,
// reduction factors, continuity.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact/methods.hpp"
#include "tangential/methods/polach.hpp"
#include "wrc/wrc_methods.h"

namespace wrc::tangential {
namespace {

class PolachLaw : public ::testing::Test {
 protected:
  PolachLaw() {
    contact.a = contact.b = 5e-3;
    contact.shear_modulus = 82e9;
    contact.linear_theory = &table;
    contact.friction = 0.3;
    contact.normal_force = 80e3;
  }
  /// By way of its row.
  TangentialForces at(const Creepage& creepage) {
    contact.creepage = creepage;
    return contact::tangential_method(WRC_TANGENTIAL_POLACH)->solve(contact, {}, fault, nullptr);
  }
  double limit() const { return contact.friction.mean * contact.normal_force; }
  theory::KalkerCoefficients coefficients() { return table.ellipse().at(contact.a / contact.b, fault); }

  theory::SdecTable table{0.25};
  RollingContact contact;
  Fault fault;
};

// The published form with its cubic in delta, written down apart from the library in Python, with Kalker's
// printed C11 = 4.12, C22 = 3.67, C23 = 1.47 of the circle.
TEST_F(PolachLaw, GivesTheNumbersOfThePublishedForm) {
  const struct {
    Creepage creepage;
    ReductionFactors reduction;
    double fx, fy;  // over mu N
  } rows[] = {
      {{1e-3, 0.0, 0.0}, {1.0, 1.0}, -0.335143, 0.0},
      {{1e-3, 0.0, 0.0}, {1.0, 0.4}, -0.233569, 0.0},
      {{1e-3, 0.0, 0.0}, {0.3, 0.1}, -0.070018, 0.0},
      {{0.0, 2e-3, 0.0}, {1.0, 1.0}, 0.0, -0.543594},
      {{2e-3, -1e-3, 0.3}, {1.0, 1.0}, -0.562081, 0.197566},
      {{2e-3, -1e-3, 0.3}, {0.3, 0.1}, -0.134489, -0.016230},
      {{0.0, 0.0, 0.5}, {1.0, 0.4}, 0.0, -0.296908},
      {{-5e-3, 3e-3, -1.0}, {1.0, 1.0}, 0.794971, -0.178716},
      {{-5e-3, 3e-3, -1.0}, {0.3, 0.1}, 0.295026, 0.121251},
  };
  for (const auto& row : rows) {
    contact.reduction = row.reduction;
    const TangentialForces f = at(row.creepage);
    EXPECT_NEAR(f.fx / limit(), row.fx, 1e-3);
    EXPECT_NEAR(f.fy / limit(), row.fy, 1e-3);
    EXPECT_NEAR(f.power_per_speed,
                -(f.fx * row.creepage.longitudinal + f.fy * row.creepage.lateral + f.mz * row.creepage.spin),
                1e-12 * limit());
  }
}

// His picture: on each line along x traction grows by eps from the leading edge up to the bound, an
// ellipsoid.
TEST_F(PolachLaw, IsTheIntegralOfItsTractions) {
  const theory::KalkerCoefficients k = coefficients();
  for (const double slip : {2e-4, 1e-3, 3e-3, 1e-2}) {
    const double eps = 82e9 * pi * 25e-6 * k.c11 * slip / (4.0 * limit());
    double force = 0.0, sticking = 0.0, all = 0.0;
    constexpr int n = 2000;
    for (int j = 0; j < n; ++j) {
      const double y = (2.0 * j + 1.0) / n - 1.0, half = std::sqrt(1.0 - y * y);
      for (int i = 0; i < n; ++i) {
        const double x = half * ((2.0 * i + 1.0) / n - 1.0), cell = half * (4.0 / n / n);
        const double grown = eps * (half - x), bound = std::sqrt(half * half - x * x);
        force += 1.5 / pi * cell * std::fmin(grown, bound);
        sticking += grown < bound ? cell : 0.0;
        all += cell;
      }
    }
    const TangentialForces f = at({slip, 0.0, 0.0});
    EXPECT_NEAR(-f.fx / limit(), force, 2e-5) << slip;
    EXPECT_NEAR(f.adhesion_fraction, sticking / all, 2e-3) << slip;
  }
}

TEST_F(PolachLaw, SmallSlipFollowsLinearTheoryTimesTheMeanOfBothFactors) {
  contact.a = 7e-3;
  contact.b = 4e-3;
  const theory::KalkerCoefficients k = coefficients();
  const double stiff = 82e9 * 28e-6;
  for (const ReductionFactors reduction : {ReductionFactors{}, ReductionFactors{0.6, 0.2}}) {
    contact.reduction = reduction;
    const double share = 0.5 * (reduction.adhesion + reduction.slip);
    const TangentialForces x = at({1e-8, 0.0, 0.0}), y = at({0.0, -1e-8, 0.0}), turn = at({0.0, 0.0, 1e-6});
    EXPECT_NEAR(x.fx, -share * stiff * k.c11 * 1e-8, 1e-6 * std::fabs(x.fx));
    EXPECT_NEAR(y.fy, share * stiff * k.c22 * 1e-8, 1e-6 * y.fy);
    EXPECT_NEAR(turn.fy, -stiff * std::sqrt(28e-6) * k.c23 * 1e-6, 1e-6 * std::fabs(turn.fy));
    EXPECT_NEAR(x.adhesion_fraction, 1.0, 1e-6);
    EXPECT_NEAR(y.mz, -stiff * std::sqrt(28e-6) * k.c23 * 1e-8, 1e-6 * std::fabs(y.mz));
  }
}

TEST_F(PolachLaw, LargeSlipEndsAtFrictionAgainstTheSlip) {
  contact.reduction = {1.0, 0.4};
  const TangentialForces f = at({3.0, -4.0, 0.0});
  EXPECT_NEAR(f.fx, -0.6 * limit(), 1e-3 * limit());
  EXPECT_NEAR(f.fy, 0.8 * limit(), 1e-3 * limit());
  EXPECT_NEAR(f.power_per_speed, 5.0 * limit(), 5e-3 * limit());
  EXPECT_LT(f.adhesion_fraction, 1e-5);
  EXPECT_NEAR(at({0.0, 0.0, 900.0}).fy, 0.0, 1e-6 * limit());  // pure spin turns on the spot
}

TEST_F(PolachLaw, TheForceStaysWithinFrictionAndTakesPower) {
  std::mt19937 draw(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0), sign(-1.0, 1.0);
  int cut = 0;
  for (int i = 0; i < 20000; ++i) {
    contact.a = std::pow(10.0, -3.0 + unit(draw));
    contact.b = std::pow(10.0, -3.0 + unit(draw));
    const double unit_slip = limit() / (82e9 * contact.a * contact.b) * std::pow(30.0, sign(draw));
    contact.reduction.adhesion = 0.05 + 0.95 * unit(draw);
    contact.reduction.slip = contact.reduction.adhesion * (0.02 + 0.98 * unit(draw));
    const TangentialForces f = at({unit_slip * sign(draw), unit_slip * sign(draw),
                                   unit_slip * sign(draw) / std::sqrt(contact.a * contact.b)});
    const double size = std::hypot(f.fx, f.fy);
    ASSERT_LE(size, (1.0 + 1e-12) * limit());
    ASSERT_GE(f.power_per_speed, 0.0);
    cut += size > (1.0 - 1e-12) * limit();
  }
  EXPECT_GT(cut, 0);
}

// The larger of two slips is taken for s_yc, and the force is cut: kinks, where it must not jump.
TEST_F(PolachLaw, NothingJumpsAlongScans) {
  contact.reduction = {0.5, 0.05};
  const Creepage from = {2e-4, -6e-3, -1.0}, to = {-3e-4, 5e-3, 2.4};
  constexpr int steps = 20000;
  TangentialForces before = at(from);
  for (int i = 1; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const TangentialForces f =
        at({from.longitudinal + t * (to.longitudinal - from.longitudinal),
            from.lateral + t * (to.lateral - from.lateral), from.spin + t * (to.spin - from.spin)});
    ASSERT_LT(std::hypot(f.fx - before.fx, f.fy - before.fy), 2e-3 * limit()) << t;
    before = f;
  }
}

TEST_F(PolachLaw, WithoutFrictionOrSlipThereIsNoForce) {
  const TangentialForces rest = at({});
  EXPECT_EQ(rest.fx, 0.0);
  EXPECT_EQ(rest.fy, 0.0);
  EXPECT_EQ(rest.adhesion_fraction, 1.0);
  contact.friction = 0.0;
  const TangentialForces smooth = at({1e-3, 1e-3, 0.1});
  EXPECT_EQ(smooth.fx, 0.0);
  EXPECT_EQ(smooth.power_per_speed, 0.0);
}

}  // namespace
}  // namespace wrc::tangential
