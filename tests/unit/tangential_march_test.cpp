#include <gtest/gtest.h>

#include "tangential/march/march.hpp"
#include "tangential/march/stick_zone.hpp"
#include "tangential_patches.hpp"

namespace wrc::tangential {
namespace {

using test::OwnedGrid;
using test::OwnedStrips;
using test::RandomCase;
using test::sdec_strips;

constexpr TractionBound bounds[] = {TractionBound::parabolic, TractionBound::elliptic,
                                    TractionBound::ellipsoidal};

TEST(March, FullAdhesionGivesTheForcesOfLinearTheory) {
  const double a = 4e-3, b = 6e-3, psi = 0.4, G = 80e9;
  const theory::SdecTable table(0.28);
  Fault fault;
  const theory::SdecCoefficients s = table.at(a / b, psi, fault);
  const OwnedStrips strips = sdec_strips(a, b, psi, 80e3, 64);
  const OwnedGrid grid(32);
  const double c = std::sqrt(a * b);
  const Creepage creep{1e-4, -2e-4, 0.03};
  for (TractionBound bound : bounds) {
    const TangentialForces f = march(
        {strips.get(), creep, theory::sdec_flexibility(a, b, psi, G, table, fault), 1e4, bound}, grid.get());
    const double unit = G * c * c * 1e-4;
    // What is left is the error of 64 strips across the patch.
    EXPECT_NEAR(f.fx, -G * c * c * (s.c11 * creep.longitudinal + c * s.c13 * creep.spin), 1e-3 * unit);
    EXPECT_NEAR(f.fy, -G * c * c * (s.c22 * creep.lateral + c * s.c23 * creep.spin), 1e-3 * unit);
    EXPECT_EQ(f.power_per_speed, 0.0);
    EXPECT_EQ(f.adhesion_fraction, 1.0);
  }
}

TEST(March, FullSlipGivesCoulombsForceAgainstTheCreepage) {
  const OwnedStrips strips = sdec_strips(4e-3, 6e-3, -0.3, 80e3, 32);
  const OwnedGrid grid(20);
  const double N = patch::totals(strips.get()).normal_force;
  Fault fault;
  const theory::Flexibility L =
      theory::sdec_flexibility(4e-3, 6e-3, -0.3, 80e9, theory::SdecTable(0.28), fault);
  const theory::Flexibility isotropic{L.l11, L.l11, L.l11, L.l11};
  for (TractionBound bound : bounds) {
    const TangentialForces f = march({strips.get(), {0.3, 0.4, 0.0}, isotropic, 0.3, bound}, grid.get());
    EXPECT_NEAR(f.fx, -0.6 * 0.3 * N, 1e-9 * N);
    EXPECT_NEAR(f.fy, -0.8 * 0.3 * N, 1e-9 * N);
    EXPECT_LT(f.adhesion_fraction, 0.002);  // the elliptic bound is infinitely steep at the leading edge
    // All of it dissipates: P / V = mu N |creepage|.
    EXPECT_NEAR(f.power_per_speed, 0.3 * N * 0.5, 1e-4 * 0.3 * N * 0.5);
  }
}

TEST(March, PureLongitudinalCreepageIsThePiecewiseParabolaOfTheory) {
  // Without spin and lateral creepage a strip sticks for u > gx/B and slips beyond: its force is
  // gx (2a - u)^2 / 2 + B (a u^2 - u^3 / 3).
  const double a = 4e-3, b = 5e-3, mu = 0.3;
  const OwnedStrips strips = sdec_strips(a, b, 0.2, 80e3, 40);
  const OwnedGrid grid(64);
  const double l = 1.5e-14;
  const double nu = 1.2e-3, gx = nu / l;
  double integral = 0.0;
  for (int j = 0; j < 40; ++j)
    integral += 4.0 / 3.0 * std::pow(strips.get().half_length[j], 3) * strips.get().width[j];
  const double B = mu * patch::totals(strips.get()).normal_force / integral;
  double expected = 0.0, dissipated = 0.0;
  for (int j = 0; j < 40; ++j) {
    const double aj = strips.get().half_length[j], u = std::min(2.0 * aj, gx / B);
    const double force = gx * (2.0 * aj - u) * (2.0 * aj - u) / 2.0 + B * (aj * u * u - u * u * u / 3.0);
    expected -= force * strips.get().width[j];
    dissipated += nu * force * strips.get().width[j];
  }
  const TangentialForces f =
      march({strips.get(), {nu, 0.0, 0.0}, {l, l, l, l}, mu, TractionBound::parabolic}, grid.get());
  EXPECT_NEAR(f.fx, expected, 3e-4 * std::fabs(expected));
  EXPECT_NEAR(f.power_per_speed, dissipated, 1e-3 * dissipated);
  EXPECT_NEAR(f.fy, 0.0, 1e-9);
}

TEST(March, ConvergesToWhatTextbookFastsimConvergesTo) {
  std::mt19937 random(7);
  const OwnedGrid grid(48);
  for (int n = 0; n < 12; ++n) {
    const RandomCase c = test::random_case(random);
    const OwnedStrips strips = sdec_strips(c.a, c.b, c.psi, c.normal_force, 40);
    for (TractionBound bound : bounds) {
      const TangentialProblem problem = test::problem_of(c, strips.get(), bound);
      const TangentialForces f = march(problem, grid.get());
      const TangentialForces reference = test::textbook_fastsim(problem, 2000);
      const double unit = c.friction * c.normal_force;
      EXPECT_NEAR(f.fx, reference.fx, 2e-3 * unit);
      EXPECT_NEAR(f.fy, reference.fy, 2e-3 * unit);
      EXPECT_NEAR(f.mz, reference.mz, 2e-3 * unit * std::sqrt(c.a * c.b));
      // The textbook march loses dissipation in first order of the cell size, up to 1 % with these cells.
      if (f.adhesion_fraction < 0.9) {
        EXPECT_NEAR(f.power_per_speed, reference.power_per_speed, 0.012 * reference.power_per_speed);
      }
      EXPECT_NEAR(f.adhesion_fraction, reference.adhesion_fraction, 0.01);
    }
  }
}

TEST(March, DissipatesWhatTheCreepagesPutIn) {
  // IInt -s.p dA = -(Fx nu_x + Fy nu_y + Mz phi) for one flexibility, second order in the cells: four times
  // less from 32 to 64 (asserted: three times over the sum of the cases).
  std::mt19937 random(11);
  double error[2] = {};
  for (int n = 0; n < 20; ++n) {
    RandomCase c = test::random_case(random);
    const OwnedStrips strips = sdec_strips(c.a, c.b, c.psi, c.normal_force, 40);
    for (TractionBound bound : bounds) {
      TangentialProblem problem = test::problem_of(c, strips.get(), bound);
      const double l = problem.flexibility.l11;
      problem.flexibility = {l, l, l, l};
      for (int refine = 0; refine < 2; ++refine) {
        const OwnedGrid grid(refine ? 64 : 32);
        const TangentialForces f = march(problem, grid.get());
        const double input =
            -(f.fx * c.creepage.longitudinal + f.fy * c.creepage.lateral + f.mz * c.creepage.spin);
        const double off = std::fabs(f.power_per_speed - input) / input;
        if (f.adhesion_fraction < 0.9) {
          EXPECT_LT(off, refine ? 0.01 : 0.03) << n;
          error[refine] += off;
        }
      }
    }
  }
  EXPECT_LT(error[1], error[0] / 3.0);
}

TEST(March, IsMirrorSymmetricToTheLastBit) {
  std::mt19937 random(3);
  const OwnedGrid grid(24);
  for (int n = 0; n < 10; ++n) {
    const RandomCase c = test::random_case(random);
    const OwnedStrips strips = sdec_strips(c.a, c.b, c.psi, c.normal_force, 24);
    const OwnedStrips mirror = sdec_strips(c.a, c.b, -c.psi, c.normal_force, 24);
    const TangentialForces f = march(test::problem_of(c, strips.get(), TractionBound::elliptic), grid.get());
    RandomCase m = c;
    m.psi = -c.psi;
    m.creepage.lateral = -c.creepage.lateral;
    m.creepage.spin = -c.creepage.spin;
    const TangentialForces g = march(test::problem_of(m, mirror.get(), TractionBound::elliptic), grid.get());
    const double unit = c.friction * c.normal_force;
    EXPECT_NEAR(f.fx, g.fx, 1e-12 * unit);
    EXPECT_NEAR(f.fy, -g.fy, 1e-12 * unit);
    EXPECT_NEAR(f.mz, -g.mz, 1e-12 * unit);
    EXPECT_NEAR(f.power_per_speed, g.power_per_speed, 1e-12 * unit);
  }
}

TEST(March, FieldsStayWithinTheBoundAndAddUpToTheForces) {
  std::mt19937 random(5);
  constexpr int strips_count = 21, cells = 30;  // a count that does not fill the kernel's groups
  const OwnedGrid grid(cells);
  std::vector<double> px(static_cast<std::size_t>(strips_count * cells)), py(px), sx(px), sy(px);
  for (int n = 0; n < 20; ++n) {
    const RandomCase c = test::random_case(random);
    const OwnedStrips strips = sdec_strips(c.a, c.b, c.psi, c.normal_force, strips_count);
    const patch::Strips& s = strips.get();
    const TangentialProblem problem = test::problem_of(c, s, TractionBound::elliptic);
    const TangentialForces f = march(problem, grid.get(), {px.data(), py.data(), sx.data(), sy.data()});
    const TangentialForces without = march(problem, grid.get());
    EXPECT_EQ(f.fx, without.fx);
    TangentialForces sum;
    for (int i = 0; i < cells; ++i) {
      for (int j = 0; j < strips_count; ++j) {
        const auto at = static_cast<std::size_t>(i * strips_count + j);
        const double t = 1.0 - (2.0 * i + 1.0) / cells;
        const double cell = 2.0 * s.half_length[j] / cells * s.width[j];
        EXPECT_LE(std::hypot(px[at], py[at]), c.friction * s.peak[j] * std::sqrt(1.0 - t * t) * 1.0000001);
        EXPECT_LE(sx[at] * px[at], 0.0);
        EXPECT_LE(sy[at] * py[at], 0.0);
        sum.fx += px[at] * cell;
        sum.fy += py[at] * cell;
        sum.mz += (s.half_length[j] * t * py[at] - s.y[j] * px[at]) * cell;
        sum.power_per_speed -= (sx[at] * px[at] + sy[at] * py[at]) * cell;
      }
    }
    const double unit = c.friction * c.normal_force;
    EXPECT_NEAR(f.fx, sum.fx, 1e-11 * unit);
    EXPECT_NEAR(f.fy, sum.fy, 1e-11 * unit);
    EXPECT_NEAR(f.mz, sum.mz, 1e-11 * unit);
    EXPECT_NEAR(f.power_per_speed, sum.power_per_speed, 1e-11 * unit);
  }
}

TEST(March, ForcesStayWithinFrictionWhereverSlipSetsInWithinACell) {
  const OwnedStrips strips = sdec_strips(4e-3, 5e-3, 0.2, 80e3, 9);
  const double limit = 0.3 * patch::totals(strips.get()).normal_force, l = 1.5e-14;
  for (int cells : {1, 2, 4, 5}) {
    const OwnedGrid grid(cells);
    for (TractionBound bound : bounds) {
      for (int n = 1; n <= 400; ++n) {
        const TangentialForces f =
            march({strips.get(), {1e-5 * n, 0.0, 0.0}, {l, l, l, l}, 0.3, bound}, grid.get());
        EXPECT_LE(-f.fx, limit * (1.0 + 1e-14)) << cells << " cells, creepage " << 1e-5 * n;
      }
    }
  }
}

TEST(March, SticksAgainNearTheSpinPole) {
  // Pure spin with the pole inside the patch: strips through it stick again behind a first slip zone.
  const double a = 8e-3, b = 4e-3, mu = 0.3;
  const OwnedStrips strips = sdec_strips(a, b, 0.0, 82e3, 40);
  Fault fault;
  const TangentialProblem problem{strips.get(),
                                  {0.0, 0.0, 2.0},
                                  theory::ellipse_flexibility(a, b, 82e9, theory::KalkerTable(0.28), fault),
                                  mu,
                                  TractionBound::parabolic};
  const OwnedGrid grid(64);
  constexpr int cells = 64, count = 40;
  std::vector<double> sx(cells * count), sy(sx);
  const TangentialForces f = march(problem, grid.get(), {nullptr, nullptr, sx.data(), sy.data()});
  int sticks_again = 0;
  for (int j = 0; j < count; ++j) {
    bool slid = false, again = false;
    for (int i = 0; i < cells; ++i) {
      const auto at = static_cast<std::size_t>(i * count + j);
      const bool slips = sx[at] != 0.0 || sy[at] != 0.0;
      again = again || (slid && !slips);
      slid = slid || slips;
    }
    sticks_again += again;
  }
  EXPECT_GT(sticks_again, 0);
  const TangentialForces reference = test::textbook_fastsim(problem, 3000);
  EXPECT_NEAR(f.adhesion_fraction, reference.adhesion_fraction, 0.01);
  EXPECT_NEAR(f.fy, reference.fy, 2e-3 * mu * 82e3);
}

TEST(March, SkewedStripsFeelTheSpinOfTheirTrueDistance) {
  // Moving the whole patch forward by d is the same as moving the creepages' origin back: nu_y + phi d, and
  // the moment about the old origin gains d Fy. One flexibility, so that both parts of spin agree.
  const double a = 5e-3, b = 4e-3, d = 2e-3, l = 1.5e-14;
  const OwnedStrips strips = sdec_strips(a, b, 0.3, 80e3, 24);
  const OwnedStrips moved = sdec_strips(a, b, 0.3, 80e3, 24);
  for (int j = 0; j < 24; ++j) moved.get().centre[j] = d;
  const OwnedGrid grid(32);
  const Creepage creep{4e-4, -3e-4, 0.4};
  for (TractionBound bound : bounds) {
    const TangentialForces f = march({moved.get(), creep, {l, l, l, l}, 0.3, bound}, grid.get());
    const TangentialForces g = march({strips.get(),
                                      {creep.longitudinal, creep.lateral + creep.spin * d, creep.spin},
                                      {l, l, l, l},
                                      0.3,
                                      bound},
                                     grid.get());
    EXPECT_NEAR(f.fx, g.fx, 1e-9 * 80e3);
    EXPECT_NEAR(f.fy, g.fy, 1e-9 * 80e3);
    EXPECT_NEAR(f.mz, g.mz + d * g.fy, 1e-9 * 80e3);
  }
}

TEST(March, DegenerateInputGivesFiniteForces) {
  const OwnedStrips strips = sdec_strips(5e-3, 4e-3, 0.3, 80e3, 24);
  const OwnedGrid grid(32);
  const theory::Flexibility L{1.5e-14, 2e-14, 1.6e-14, 2.2e-14};
  for (TractionBound bound : bounds) {
    const TangentialForces none = march({strips.get(), {}, L, 0.3, bound}, grid.get());
    EXPECT_EQ(none.fx, 0.0);
    EXPECT_EQ(none.fy, 0.0);
    EXPECT_EQ(none.adhesion_fraction, 1.0);
    const TangentialForces frictionless = march({strips.get(), {1e-3, 1e-3, 0.5}, L, 0.0, bound}, grid.get());
    EXPECT_EQ(frictionless.fx, 0.0);
    EXPECT_EQ(frictionless.power_per_speed, 0.0);
    for (double size : {1e-300, 1e-12, 1e3}) {
      for (const Creepage& c :
           {Creepage{size, 0, 0}, Creepage{0, -size, 0}, Creepage{0, 0, size}, Creepage{size, size, -size}}) {
        const TangentialForces f = march({strips.get(), c, L, 0.3, bound}, grid.get());
        EXPECT_TRUE(std::isfinite(f.fx) && std::isfinite(f.fy) && std::isfinite(f.mz) &&
                    std::isfinite(f.power_per_speed));
        EXPECT_LE(std::hypot(f.fx, f.fy), 0.3 * 80e3 * 1.001);
      }
    }
    patch::Strips empty = strips.get();
    empty.count = 0;
    EXPECT_EQ(march({empty, {1e-3, 0, 0}, L, 0.3, bound}, grid.get()).fx, 0.0);
  }
}

TEST(StickZone, OnsetIsTheFirstPointWhereAdhesionExceedsTheBound) {
  std::mt19937 random(1);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
  };
  const double a = 1.0;
  for (int n = 0; n < 3000; ++n) {
    const double size = std::pow(10.0, uniform(-2.0, 2.0));
    const AdhesionGrowth<double> g{size * uniform(-1, 1), size * uniform(-2, 2), size * uniform(-1, 1)};
    for (TractionBound bound : bounds) {
      const double v =
          bound == TractionBound::parabolic ? onset_parabolic(g, 1.0, a) : onset_elliptic(g, 1.0, a);
      const auto margin = [&](double at) {  // bound^2 - traction^2, relative
        const double u = 2.0 * a - at;
        const double tau2 = bound == TractionBound::parabolic ? at * at * u * u : at * u;
        const double gy = g.gy - g.curvature * at;
        return (tau2 - at * at * (g.gx * g.gx + gy * gy)) / tau2;
      };
      ASSERT_GE(v, 0.0);
      ASSERT_LE(v, 2.0 * a);
      for (int i = 1; v > 0.0 && i < 200; ++i) {  // sticks everywhere before
        ASSERT_GE(margin(v * i / 200.0), -1e-6) << n;
      }
      if (v > 1e-9 && v < 2.0 * a) {
        EXPECT_NEAR(margin(v), 0.0, 1e-4) << n << " " << v;
      }
      if (v == 0.0) {
        EXPECT_LE(margin(1e-9), 1e-7) << n;
      }
    }
  }
}

}  // namespace
}  // namespace wrc::tangential
