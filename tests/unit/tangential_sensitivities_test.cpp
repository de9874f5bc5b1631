#include <gtest/gtest.h>

#include "published_methods.hpp"
#include "tangential/methods/strip_fastsim.hpp"
#include "tangential_patches.hpp"

namespace wrc::tangential {
namespace {

using test::fastsim_ellipse;
using test::fastsim_eqe;
using test::fastsim_eql;
using test::OwnedGrid;
using test::OwnedStrips;
using test::RandomCase;

using Method = decltype(fastsim);
struct Forces {
  double of[3];
};

/// Derivatives against central differences of sixth order with two step sizes. The discrete model has kinks
/// where a cell changes between stick and slip; where one lies within the steps, the two differences disagree
/// and say nothing. Elsewhere all must agree to 1e-6 of what the forces are over the input's size.
void compare(Method& method, bool on_ellipse, TractionBound bound) {
  std::mt19937 random(21);
  const OwnedGrid grid(24);
  int compared = 0, total = 0;
  for (int n = 0; n < 60; ++n) {
    const RandomCase c = test::random_case(random);
    const OwnedStrips strips = test::sdec_strips(c.a, c.b, on_ellipse ? 0.0 : c.psi, c.normal_force, 21);
    const theory::SdecTable table(c.poisson);
    const RollingContact contact{strips.get(), c.a,         c.b,        c.psi,      c.shear_modulus,
                                 &table,       &grid.get(), c.creepage, c.friction, bound};
    Fault fault;
    TangentialSensitivities s;
    const TangentialForces f = method(contact, {}, fault, &s);
    const TangentialForces plain = method(contact, {}, fault, nullptr);
    EXPECT_EQ(f.fx, plain.fx);
    EXPECT_EQ(f.fy, plain.fy);
    EXPECT_EQ(f.mz, plain.mz);
    EXPECT_EQ(f.power_per_speed, plain.power_per_speed);

    const double unit = c.friction * c.normal_force, size = std::sqrt(c.a * c.b);
    const double level = unit / (c.shear_modulus * c.a * c.b);
    const double scale[4] = {level, level, level / size, c.friction};
    const double of_force[3] = {unit, unit, unit * size};
    const int column[4] = {0, 1, 2, 4};
    for (int k = 0; k < 4; ++k) {
      const auto at = [&](double offset) -> Forces {
        RollingContact moved = contact;
        double* input[4] = {&moved.creepage.longitudinal, &moved.creepage.lateral, &moved.creepage.spin,
                            &moved.friction.mean};
        *input[k] += offset;
        const TangentialForces g = method(moved, {}, fault, nullptr);
        return {{g.fx, g.fy, g.mz}};
      };
      const auto differences = [&](double step) {
        const Forces p1 = at(step), m1 = at(-step), p2 = at(2 * step), m2 = at(-2 * step), p3 = at(3 * step),
                     m3 = at(-3 * step);
        Forces d{};
        for (int r = 0; r < 3; ++r)
          d.of[r] = (45.0 * (p1.of[r] - m1.of[r]) - 9.0 * (p2.of[r] - m2.of[r]) + (p3.of[r] - m3.of[r])) /
                    (60.0 * step);
        return d;
      };
      const Forces coarse = differences(2e-5 * scale[k]), fine = differences(1e-5 * scale[k]);
      for (int r = 0; r < 3; ++r) {
        const double one = of_force[r] / scale[k];
        ++total;
        if (std::fabs(coarse.of[r] - fine.of[r]) > 1e-8 * one) continue;
        ++compared;
        EXPECT_NEAR(s.d[r][column[k]], fine.of[r], 1e-6 * one)
            << "case " << n << " input " << k << " force " << r;
      }
    }
    // Load and friction act through their product alone.
    EXPECT_NEAR(s.d[0][3] * patch::totals(strips.get()).normal_force, s.d[0][4] * c.friction, 1e-9 * unit);
  }
  EXPECT_GT(compared, total * 9 / 10);
}

TEST(Sensitivities, OfFastsimSdec) {
  compare(fastsim, false, TractionBound::parabolic);
  compare(fastsim, false, TractionBound::elliptic);
}
TEST(Sensitivities, OfFastsimEql) { compare(fastsim_eql, false, TractionBound::parabolic); }
TEST(Sensitivities, OfFastsimEqe) { compare(fastsim_eqe, true, TractionBound::parabolic); }
TEST(Sensitivities, OfFastsim) { compare(fastsim_ellipse, true, TractionBound::elliptic); }
TEST(Sensitivities, OfStripFastsim) { compare(strip_fastsim, false, TractionBound::elliptic); }

/// Forces from a tenth of a random case's creepages to twice them against the integral of their derivatives:
/// a jump wherever the border of the stick zone passes a cell would be missing from it, however small. Spin
/// is a quarter of the case's: strips that stick a second time do jump, cell by cell.
void integrate(Method& method, bool on_ellipse, TractionBound bound, double tolerance) {
  std::mt19937 random(23);
  const OwnedGrid grid(32);
  constexpr int steps = 1500;
  double worst = 0.0;
  for (int n = 0; n < 20; ++n) {
    const RandomCase c = test::random_case(random);
    const OwnedStrips strips =
        test::sdec_strips(c.a, c.b, on_ellipse ? 0.0 : c.psi, c.normal_force, n < 4 ? 1 : 24);
    const theory::SdecTable table(c.poisson);
    double integral[2] = {0.0, 0.0}, first[2] = {0.0, 0.0}, last[2] = {0.0, 0.0};
    for (int i = 0; i <= steps; ++i) {
      const double t = 0.1 + 1.9 * i / steps;
      const Creepage whole{c.creepage.longitudinal, c.creepage.lateral, 0.25 * c.creepage.spin};
      const RollingContact contact{
          strips.get(),    c.a,    c.b,         c.psi,
          c.shear_modulus, &table, &grid.get(), {t * whole.longitudinal, t * whole.lateral, t * whole.spin},
          c.friction,      bound};
      Fault fault;
      TangentialSensitivities s;
      const TangentialForces f = method(contact, {}, fault, &s);
      const double force[2] = {f.fx, f.fy};
      for (int r = 0; r < 2; ++r) {
        const double slope =
            s.d[r][0] * whole.longitudinal + s.d[r][1] * whole.lateral + s.d[r][2] * whole.spin;
        integral[r] += (i == 0 || i == steps ? 0.5 : 1.0) * slope * 1.9 / steps;
        if (i == 0) first[r] = force[r];
        last[r] = force[r];
      }
    }
    for (int r = 0; r < 2; ++r) {
      const double missing = std::fabs(last[r] - first[r] - integral[r]) / (c.friction * c.normal_force);
      worst = std::max(worst, missing);
      EXPECT_LT(missing, tolerance) << "case " << n << " force " << r;
    }
  }
  std::printf("largest part of a force's change that its derivatives miss: %.1e mu N\n", worst);
}

/// Where nothing creeps forces vanish, not their derivatives: those of linear theory, of which an implicit
/// integrator's first step is made.
TEST(Sensitivities, AtRestAreThoseOfLinearTheory) {
  std::mt19937 random(31);
  const OwnedGrid grid(32);
  for (Method* method : {&fastsim, &strip_fastsim}) {
    for (int n = 0; n < 10; ++n) {
      const RandomCase c = test::random_case(random);
      const OwnedStrips strips = test::sdec_strips(c.a, c.b, c.psi, c.normal_force, 24);
      const theory::SdecTable table(c.poisson);
      RollingContact contact{strips.get(), c.a,         c.b, c.psi,      c.shear_modulus,
                             &table,       &grid.get(), {},  c.friction, TractionBound::parabolic};
      const double unit = c.friction * c.normal_force, level = unit / (c.shear_modulus * c.a * c.b);
      const double size = std::sqrt(c.a * c.b), scale[3] = {level, level, level / size};
      const double of_force[3] = {unit, unit, unit * size};
      Fault fault;
      for (const double rest : {0.0, 1e-30, 1e-17, 1e-12}) {
        TangentialSensitivities s;
        contact.creepage = {rest * level, 0.0, rest * scale[2]};
        const TangentialForces f = method(contact, {}, fault, &s);
        EXPECT_EQ(f.fx, method(contact, {}, fault, nullptr).fx);
        for (int k = 0; k < 3; ++k) {
          const auto at = [&](double offset) {
            contact.creepage = {};
            (k == 0   ? contact.creepage.longitudinal
             : k == 1 ? contact.creepage.lateral
                      : contact.creepage.spin) = offset * scale[k];
            return method(contact, {}, fault, nullptr);
          };
          const TangentialForces more = at(1e-6), less = at(-1e-6);
          const double differences[3] = {more.fx - less.fx, more.fy - less.fy, more.mz - less.mz};
          for (int r = 0; r < 3; ++r)
            EXPECT_NEAR(s.d[r][k] * scale[k] / of_force[r], differences[r] / 2e-6 / of_force[r], 2e-5)
                << "case " << n << " at " << rest << " input " << k << " force " << r;
        }
      }
    }
  }
}

TEST(Sensitivities, IntegrateToTheForces) {
  integrate(fastsim, false, TractionBound::parabolic, 1e-3);
  integrate(fastsim, false, TractionBound::elliptic, 1e-3);
  integrate(strip_fastsim, false, TractionBound::elliptic, 3e-3);
}

}  // namespace
}  // namespace wrc::tangential
