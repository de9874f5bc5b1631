// Friction that differs from strip to strip, in the march and in strip FASTSIM; the ellipsoidal bound.
#include <gtest/gtest.h>

#include "tangential/methods/strip_fastsim.hpp"
#include "tangential_patches.hpp"

namespace wrc::tangential {
namespace {

using test::OwnedGrid;
using test::OwnedStrips;
using test::RandomCase;
using test::sdec_strips;

constexpr TractionBound bounds[] = {TractionBound::parabolic, TractionBound::elliptic,
                                    TractionBound::ellipsoidal};
constexpr int count = 40;

/// Dry on one side, wet on the other, nothing at all on two strips between them.
struct Zones {
  std::vector<double> mu = std::vector<double>(count), shares = std::vector<double>(count);
  double mean = 0.0;

  explicit Zones(const patch::Strips& s) {
    double limit = 0.0, load = 0.0;
    for (int j = 0; j < count; ++j) {
      mu[j] = j < 18 ? 0.4 : (j < 20 ? 0.0 : 0.12);
      const double carried = 0.5 * pi * s.half_length[j] * s.peak[j] * s.width[j];
      limit += mu[j] * carried;
      load += carried;
    }
    mean = limit / load;
    for (int j = 0; j < count; ++j) shares[j] = mu[j] / mean;
  }
  StripFriction friction() const { return {mean, shares.data()}; }
};

TEST(StripFriction, MarchConvergesToTheTextbooksStripByStrip) {
  std::mt19937 random(7);
  const OwnedGrid grid(48);
  for (int n = 0; n < 6; ++n) {
    const RandomCase c = test::random_case(random);
    const OwnedStrips strips = sdec_strips(c.a, c.b, c.psi, c.normal_force, count);
    const Zones zones(strips.get());
    for (TractionBound bound : bounds) {
      TangentialProblem problem = test::problem_of(c, strips.get(), bound);
      problem.friction = zones.friction();
      const TangentialForces f = march(problem, grid.get());
      const TangentialForces reference = test::textbook_fastsim(problem, 2000);
      const double unit = zones.mean * c.normal_force;
      EXPECT_NEAR(f.fx, reference.fx, 2e-3 * unit);
      EXPECT_NEAR(f.fy, reference.fy, 2e-3 * unit);
      EXPECT_NEAR(f.mz, reference.mz, 2e-3 * unit * std::sqrt(c.a * c.b));
    }
  }
}

TEST(StripFriction, FullSlipGivesTheSumOfTheStripsLimits) {
  const OwnedStrips strips = sdec_strips(4e-3, 6e-3, 0.3, 80e3, count);
  const Zones zones(strips.get());
  const OwnedGrid grid(32);
  const theory::SdecTable table(0.28);
  const double limit = zones.mean * patch::totals(strips.get()).normal_force;
  RollingContact c{
      strips.get(),           4e-3, 6e-3, 0.3, 80e9, &table, &grid.get(), {5.0, 0.0, 0.0}, zones.friction(),
      TractionBound::elliptic};
  Fault fault;
  EXPECT_NEAR(strip_fastsim(c, {}, fault).fx, -limit, 1e-6 * limit);
  const theory::Flexibility L{1.5e-14, 2e-14, 1.6e-14, 2.2e-14};
  const TangentialForces f = march({c.region, c.creepage, L, c.friction, c.bound}, grid.get());
  EXPECT_NEAR(f.fx, -limit, 1e-6 * limit);
}

TEST(StripFriction, TractionsStayWithinEachStripsBound) {
  std::mt19937 random(5);
  constexpr int cells = 30;
  const OwnedGrid grid(cells);
  const theory::SdecTable table(0.28);
  std::vector<double> px(static_cast<std::size_t>(count * cells)), py(px), sx(px), sy(px);
  for (int n = 0; n < 20; ++n) {
    const RandomCase r = test::random_case(random);
    const OwnedStrips strips = sdec_strips(r.a, r.b, r.psi, r.normal_force, count);
    const patch::Strips& s = strips.get();
    const Zones zones(s);
    const RollingContact c{s,
                           r.a,
                           r.b,
                           r.psi,
                           r.shear_modulus,
                           &table,
                           &grid.get(),
                           r.creepage,
                           zones.friction(),
                           TractionBound::elliptic};
    const TangentialFields fields{px.data(), py.data(), sx.data(), sy.data()};
    Fault fault;
    for (int method = 0; method < 2; ++method) {
      TangentialProblem problem = test::problem_of(r, s, TractionBound::elliptic);
      problem.friction = zones.friction();
      const TangentialForces f =
          method == 0 ? march(problem, grid.get(), fields) : strip_fastsim(c, fields, fault);
      double power = 0.0;
      for (int i = 0; i < cells; ++i) {
        const double t = 1.0 - (2.0 * i + 1.0) / cells;
        for (int j = 0; j < count; ++j) {
          const auto at = static_cast<std::size_t>(i * count + j);
          const double bound = zones.mu[j] * s.peak[j] * std::sqrt(1.0 - t * t);
          ASSERT_LE(std::hypot(px[at], py[at]), bound * 1.0000001);
          power -= (sx[at] * px[at] + sy[at] * py[at]) * 2.0 * s.half_length[j] / cells * s.width[j];
        }
      }
      EXPECT_NEAR(power, f.power_per_speed, 1e-9 * f.power_per_speed);
    }
  }
}

TEST(StripFriction, EllipsoidalBoundIsTheEllipticOneUnderHertzianPressure) {
  // The pressure of a double ellipse IS ellipsoidal; the two bounds differ on patches of other pressure only.
  std::mt19937 random(9);
  const OwnedGrid grid(24);
  for (int n = 0; n < 5; ++n) {
    const RandomCase c = test::random_case(random);
    const OwnedStrips strips = sdec_strips(c.a, c.b, c.psi, c.normal_force, count);
    const TangentialForces f = march(test::problem_of(c, strips.get(), TractionBound::elliptic), grid.get());
    const TangentialForces g =
        march(test::problem_of(c, strips.get(), TractionBound::ellipsoidal), grid.get());
    EXPECT_NEAR(f.fx, g.fx, 1e-9 * c.friction * c.normal_force);
    EXPECT_NEAR(f.fy, g.fy, 1e-9 * c.friction * c.normal_force);
    // Pressure gathered on one side leaves the ellipsoidal bound as it is while the load is the same.
    double before = patch::totals(strips.get()).normal_force;
    for (int j = 0; j < count; ++j) strips.get().peak[j] *= 0.5 + j / (count - 1.0);
    const double scale = before / patch::totals(strips.get()).normal_force;
    for (int j = 0; j < count; ++j) strips.get().peak[j] *= scale;
    const TangentialForces h =
        march(test::problem_of(c, strips.get(), TractionBound::ellipsoidal), grid.get());
    EXPECT_NEAR(g.fx, h.fx, 1e-9 * c.friction * c.normal_force);
  }
}

}  // namespace
}  // namespace wrc::tangential
