#include "surface/rolling/surface_rolling.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "halfspace/tangential.hpp"
#include "sdec_pressure.hpp"
#include "tangential_patches.hpp"

namespace wrc::surface {
namespace {

using test::OwnedGrid;
using test::OwnedStrips;

constexpr double G = 82e9, poisson = 0.28;

const theory::SdecTable& table() {
  static const theory::SdecTable made(poisson);
  return made;
}
const StripCoefficientTable& coefficients() {
  static const StripCoefficientTable made(table().ellipse());
  return made;
}

/// Strips with slips of their own; what rolling makes of them.
struct Rolled {
  std::vector<double> place, width, half_length, peak, curvature, slip_x, slip_y, spin, friction;
  std::vector<double> fx, fy, mz, traction_x, traction_y, sliding_x, sliding_y;
  double power = 0.0, adhesion = 0.0;

  void add(double s, double w, double l, double p, double kappa, double x, double y, double phi, double mu) {
    place.push_back(s);
    width.push_back(w);
    half_length.push_back(l);
    peak.push_back(p);
    curvature.push_back(kappa);
    slip_x.push_back(x);
    slip_y.push_back(y);
    spin.push_back(phi);
    friction.push_back(mu);
  }

  SurfaceRollingMethod method = SurfaceRollingMethod::strip_fastsim;
  const StripCoefficientTable* linear = &coefficients();

  void roll(const tangential::MarchGrid& grid, bool with_fields = false) {
    const std::size_t n = place.size();
    SurfaceRollingInput in;
    in.count = static_cast<std::int32_t>(n);
    in.place = place.data();
    in.width = width.data();
    in.half_length = half_length.data();
    in.peak = peak.data();
    in.curvature = curvature.data();
    in.slip_x = slip_x.data();
    in.slip_y = slip_y.data();
    in.spin = spin.data();
    in.friction = friction.data();
    in.shear_modulus = in.normal_shear_modulus = G;
    in.coefficients = linear;
    in.grid = &grid;
    in.method = method;
    for (auto* v : {&fx, &fy, &mz}) v->assign(n, 0.0);
    tangential::TangentialFields fields;
    if (with_fields || method == SurfaceRollingMethod::fastrip) {
      for (auto* v : {&traction_x, &traction_y, &sliding_x, &sliding_y})
        v->assign(n * static_cast<std::size_t>(grid.cells), 0.0);
      fields = {traction_x.data(), traction_y.data(), sliding_x.data(), sliding_y.data()};
    }
    std::vector<double> workspace(surface_rolling_workspace(in.count));
    const SurfaceRollingTotals totals =
        roll_on_surface(in, workspace.data(), fields, {fx.data(), fy.data(), mz.data()});
    power = totals.power_per_speed;
    adhesion = totals.adhesion_fraction;
  }

  static double sum(const std::vector<double>& v) {
    double total = 0.0;
    for (double x : v) total += x;
    return total;
  }
};

/// The strips of Hertz's ellipse, rolling as a patch does: slip (nu_x - phi y, nu_y), spin phi.
Rolled ellipse(double a, double b, double N, double mu, const tangential::Creepage& c, int count) {
  const OwnedStrips owned = test::sdec_strips(a, b, 0.0, N, count);
  const patch::Strips& s = owned.get();
  const double level = 1.5 * N / (pi * a * a * b),
               kappa = hertz_relative_curvature(a / b) * (1.0 - poisson) / G * level;
  Rolled r;
  for (int j = 0; j < count; ++j)
    r.add(s.y[j], s.width[j], s.half_length[j], s.peak[j], kappa, c.longitudinal - c.spin * s.y[j], c.lateral,
          c.spin, mu);
  return r;
}

TEST(StripCoefficients, AreKalkersOnHertzsEllipse) {
  EXPECT_NEAR(hertz_relative_curvature(1.0), 0.5 * pi, 1e-12);
  EXPECT_NEAR(hertz_relative_curvature(1e-6), 2.0, 1e-9);
  EXPECT_NEAR(hertz_relative_curvature(5.0), 0.82, 0.01);
  Fault fault;
  for (double ratio : {0.2, 0.3, 0.7, 1.0, 2.0, 5.0, 12.0}) {
    const StripCoefficients strip = coefficients_at(coefficients().nodes(), hertz_relative_curvature(ratio));
    const theory::KalkerCoefficients kalker = table().ellipse().at(ratio, fault);
    EXPECT_NEAR(strip.c11 / kalker.c11, 1.0, 1e-3) << ratio;
    EXPECT_NEAR(strip.c22 / kalker.c22, 1.0, 1e-3) << ratio;
    EXPECT_NEAR(strip.c23 * std::sqrt(ratio) / kalker.c23, 1.0, 3e-3) << ratio;
    EXPECT_NEAR(strip.slenderness, theory::slenderness(ratio), 3e-3) << ratio;
  }
  for (double m : {1e-6, 0.1, 2.5, 1e6}) {
    const StripCoefficients strip = coefficients_at(coefficients().nodes(), m);
    for (double c : {strip.c11, strip.c22, strip.c23}) EXPECT_TRUE(std::isfinite(c) && c > 0.0) << m;
  }
}

constexpr SurfaceRollingMethod methods[] = {SurfaceRollingMethod::strip_fastsim,
                                            SurfaceRollingMethod::fastsim, SurfaceRollingMethod::fastrip};

class EveryMethod : public testing::TestWithParam<SurfaceRollingMethod> {};
INSTANTIATE_TEST_SUITE_P(SurfaceRolling, EveryMethod, testing::ValuesIn(methods));

TEST_P(EveryMethod, SmallSlipGivesLinearTheoryOfHertzsEllipse) {
  const OwnedGrid grid(32);
  const double a = 5e-3, b = 4e-3, N = 80e3, tiny = 1e-8;
  Fault fault;
  const theory::KalkerCoefficients kalker = table().ellipse().at(a / b, fault);
  Rolled x = ellipse(a, b, N, 0.3, {tiny, 0.0, 0.0}, 80);
  x.method = GetParam();
  x.roll(grid.get());
  EXPECT_NEAR(Rolled::sum(x.fx) / (-G * a * b * kalker.c11 * tiny), 1.0, 0.01);
  EXPECT_NEAR(x.adhesion, 1.0, 1e-5);
  Rolled y = ellipse(a, b, N, 0.3, {0.0, tiny, 0.0}, 80);
  y.method = GetParam();
  y.roll(grid.get());
  EXPECT_NEAR(Rolled::sum(y.fy) / (-G * a * b * kalker.c22 * tiny), 1.0, 0.01);
  Rolled spin = ellipse(a, b, N, 0.3, {0.0, 0.0, 1e-6}, 80);
  spin.method = GetParam();
  spin.roll(grid.get());
  EXPECT_NEAR(Rolled::sum(spin.fy) / (-G * std::pow(a * b, 1.5) * kalker.c23 * 1e-6), 1.0, 0.02);
}

/// C33 of the exact linear theory (theory.md, section 4), for Poisson ratios far from those that strips were
/// fitted to.
TEST(SurfaceRolling, SmallSpinHasThePowerOfLinearTheory) {
  const struct {
    double ratio, c33[3];
  } ellipses[] = {{0.3, {2.501, 2.974, 3.737}},    {0.5, {1.747, 1.938, 2.229}},
                  {1.0, {1.207, 1.184, 1.159}},    {2.0, {0.9598, 0.8196, 0.6493}},
                  {5.0, {0.8338, 0.6045, 0.3420}}, {20.0, {0.7909, 0.4891, 0.1633}}};
  constexpr double ratios[] = {0.0, 0.25, 0.5}, within[] = {0.035, 0.015, 0.06}, tiny = 1e-6;
  const OwnedGrid grid(32);
  for (int k = 0; k < 3; ++k) {
    const StripCoefficientTable strips{theory::KalkerTable(ratios[k])};
    for (const auto& [ratio, c33] : ellipses) {
      const double a = 4e-3 * std::sqrt(ratio), b = 4e-3 / std::sqrt(ratio), N = 80e3;
      Rolled r = ellipse(a, b, N, 0.3, {0.0, 0.0, tiny}, 40);
      for (double& kappa : r.curvature) kappa *= (1.0 - ratios[k]) / (1.0 - poisson);
      r.linear = &strips;
      r.roll(grid.get());
      EXPECT_NEAR(r.power / (G * std::pow(a * b, 2) * c33[k] * tiny * tiny), 1.0, within[k])
          << "a/b " << ratio << ", Poisson ratio " << ratios[k];
    }
  }
}

/// Exact theory on the ellipse, from two grids: the error is of first order in the cell size.
tangential::TangentialForces exact_on_ellipse(double a, double b, double N, double mu,
                                              const tangential::Creepage& c) {
  const halfspace::SdecPatch patch{a, b, 0.0};
  tangential::TangentialForces of[2];
  for (int n = 0; n < 2; ++n) {
    const halfspace::Grid grid = halfspace::grid_over(patch, 24 << n, 24 << n);
    halfspace::RollingSolver solver(grid, {G, poisson});
    halfspace::RollingProblem problem;
    problem.pressure =
        halfspace::sdec_pressure(patch, 1.5 * N / (pi * a * b), grid, halfspace::CellPressure::mean);
    problem.friction = {mu};
    problem.creepage = c;
    of[n] = solver.solve(problem).forces;
  }
  tangential::TangentialForces f;
  f.fx = 2.0 * of[1].fx - of[0].fx;
  f.fy = 2.0 * of[1].fy - of[0].fy;
  f.mz = 2.0 * of[1].mz - of[0].mz;
  f.power_per_speed = -(f.fx * c.longitudinal + f.fy * c.lateral + f.mz * c.spin);
  return f;
}

TEST(SurfaceRolling, OnHertzsEllipseIsNearExactTheory) {
  const OwnedGrid grid(32);
  const double a = 6e-3, b = 5e-3, N = 90e3, mu = 0.35, limit = mu * N;
  for (const tangential::Creepage& c :
       {tangential::Creepage{1e-3, 0.0, 0.0}, tangential::Creepage{-5e-4, 1e-3, 0.2},
        tangential::Creepage{0.0, 5e-4, -0.6}}) {
    const tangential::TangentialForces exact = exact_on_ellipse(a, b, N, mu, c);
    Rolled r = ellipse(a, b, N, mu, c, 60);
    r.roll(grid.get());
    EXPECT_NEAR(Rolled::sum(r.fx) / limit, exact.fx / limit, 0.02) << c.longitudinal;
    EXPECT_NEAR(Rolled::sum(r.fy) / limit, exact.fy / limit, 0.02) << c.longitudinal;
    EXPECT_NEAR(r.power / exact.power_per_speed, 1.0, 0.05) << c.longitudinal;
  }
}

TEST_P(EveryMethod, FullSlipIsCoulombs) {
  const OwnedGrid grid(32);
  Rolled r = ellipse(5e-3, 4e-3, 80e3, 0.3, {0.3, 0.4, 0.0}, 40);
  r.method = GetParam();
  r.roll(grid.get(), true);
  double limit = 0.0;
  for (std::size_t j = 0; j < r.place.size(); ++j)
    limit += 0.3 * 0.5 * pi * r.width[j] * r.peak[j] * r.half_length[j];
  // FASTSIM's separate flexibilities turn the force off the slip
  const bool separate = GetParam() == SurfaceRollingMethod::fastsim;
  const double fx = Rolled::sum(r.fx) / limit, fy = Rolled::sum(r.fy) / limit;
  EXPECT_NEAR(std::hypot(fx, fy), 1.0, 1e-5);
  EXPECT_NEAR(fx, -0.6, separate ? 0.06 : 1e-5);
  EXPECT_NEAR(fy, -0.8, separate ? 0.06 : 1e-5);
  EXPECT_NEAR(r.power / limit, 0.5, separate ? 0.01 : 1e-5);
  double dissipated = 0.0;  // by the fields
  for (std::size_t k = 0; k < r.traction_x.size(); ++k) {
    const std::size_t j = k % r.place.size();
    dissipated -= (r.traction_x[k] * r.sliding_x[k] + r.traction_y[k] * r.sliding_y[k]) * r.width[j] * 2.0 *
                  r.half_length[j] / 32.0;
  }
  EXPECT_NEAR(dissipated / r.power, 1.0, 1e-9);
}

TEST_P(EveryMethod, NothingToRubOnIsNothing) {
  const OwnedGrid grid(16);
  Rolled none;
  none.method = GetParam();
  none.roll(grid.get());
  EXPECT_EQ(none.power, 0.0);
  Rolled r;
  for (int j = 0; j < 12; ++j)  // without friction, without pressure, without length
    r.add(1e-4 * j, 1e-4, j % 3 == 2 ? 0.0 : 4e-3, j % 3 == 1 ? 0.0 : 1e9, 2.0, 1e-3, 2e-3, 0.5,
          j % 3 == 0 ? 0.0 : 0.3);
  r.method = GetParam();
  r.roll(grid.get(), true);
  for (const auto* v : {&r.fx, &r.fy, &r.mz, &r.traction_x, &r.sliding_x})
    for (double f : *v) EXPECT_EQ(f, 0.0);
}

TEST(SurfaceRolling, AStripThatEntersHasNoSay) {
  const OwnedGrid grid(32);
  const tangential::Creepage c{-4e-4, 6e-4, 0.5};
  Rolled without = ellipse(5e-3, 4e-3, 80e3, 0.3, c, 40);
  Rolled with = without;
  with.add(4.1e-3, 2e-4, 1e-7, 1e4, with.curvature[0], c.longitudinal - c.spin * 4.1e-3, c.lateral, c.spin,
           0.3);
  without.roll(grid.get());
  with.roll(grid.get());
  EXPECT_NEAR(Rolled::sum(with.fx), Rolled::sum(without.fx), 1e-4);
  EXPECT_NEAR(Rolled::sum(with.fy), Rolled::sum(without.fy), 1e-4);
}

/// Two lobes l^2 = l0^2 (t + x^2 - x^4), x = s / 4 mm, that are apart for t < 0 and joined for t > 0, on
/// fixed strips with the slips of a wheel: rolling radius over the width and spin.
Rolled lobes(double t) {
  Rolled r;
  for (int j = -30; j <= 30; ++j) {
    const double s = 0.2e-3 * j, x = s / 4e-3, square = t + x * x - x * x * x * x;
    if (square <= 0.0) continue;
    const double l = 9e-3 * std::sqrt(square), level = 1.6e11 * (1.0 + 0.3 * x);
    r.add(s, 0.2e-3, l, level * l, 2.2, 4e-4 - 0.6 * s, -3e-4, 0.6, 0.3);
  }
  return r;
}

// Forces bend where a neck opens and strips enter, and do not jump: from one step to the next (of 5e-5 of the
// height of the lobes, on which forces grow by up to 5e-4 of friction) the change of a step is far less than
// a step.
TEST_P(EveryMethod, ForcesAreContinuousWhereLobesMeet) {
  const OwnedGrid grid(32);
  std::vector<std::array<double, 4>> values;
  double limit = 0.0;
  for (int n = -800; n <= 800; ++n) {
    Rolled r = lobes(5e-5 * n);
    r.method = GetParam();
    r.roll(grid.get());
    values.push_back({Rolled::sum(r.fx), Rolled::sum(r.fy), Rolled::sum(r.mz), r.power});
    limit = 0.0;
    for (std::size_t j = 0; j < r.place.size(); ++j)
      limit += 0.3 * 0.5 * pi * r.width[j] * r.peak[j] * r.half_length[j];
  }
  const char* names[] = {"Fx", "Fy", "Mz", "power"};
  const double units[] = {limit, limit, limit * 4e-3, limit * 1e-3};
  for (std::size_t k = 0; k < 4; ++k) {
    double step = 0.0, bend = 0.0;
    for (std::size_t n = 1; n + 1 < values.size(); ++n) {
      step = std::max(step, std::abs(values[n + 1][k] - values[n][k]));
      bend = std::max(bend, std::abs(values[n + 1][k] - 2.0 * values[n][k] + values[n - 1][k]));
    }
    std::printf("method %d, %s: largest step %.1e, largest change of it %.1e\n", static_cast<int>(GetParam()),
                names[k], step / units[k], bend / units[k]);
    if (GetParam() == SurfaceRollingMethod::strip_fastsim) {
      EXPECT_LT(bend / units[k], 6e-5) << names[k];
    }
  }
}

// The same where slips pass through zero, alone and with spin: steps of 2e-6, on which linear theory moves
// forces by up to 6e-4 of friction.
TEST(SurfaceRolling, ForcesAreContinuousInTheSlips) {
  const OwnedGrid grid(32);
  for (double spin : {0.0, 0.4, 1.2}) {
    std::array<double, 2> before{}, last{};
    double step = 0.0, bend = 0.0;
    for (int n = -400; n <= 400; ++n) {
      Rolled r = ellipse(5e-3, 4e-3, 80e3, 0.3, {2e-6 * n, -1e-6 * n, spin}, 40);
      r.roll(grid.get());
      const std::array<double, 2> f{Rolled::sum(r.fx) / 24e3, Rolled::sum(r.fy) / 24e3};
      for (std::size_t k = 0; k < 2; ++k) {
        if (n > -400) step = std::max(step, std::abs(f[k] - last[k]));
        if (n > -399) bend = std::max(bend, std::abs(f[k] - 2.0 * last[k] + before[k]));
      }
      before = last;
      last = f;
    }
    std::printf("spin %.1f: largest step %.1e of friction, largest change of it %.1e\n", spin, step, bend);
    EXPECT_LT(step, 1e-3);
    EXPECT_LT(bend, 5e-5);
  }
}

TEST(SurfaceRolling, InstructionSetsGiveTheSameBits) {
  std::vector<double> first;
  for (InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (set > best_instruction_set()) continue;
    const OwnedGrid grid(23, set);
    std::vector<double> all;
    for (int n = 1; n < 40; n += 7) {
      Rolled r = ellipse(5e-3, 4e-3, 80e3, 0.3, {1e-4 * n, -2e-4, 0.03 * n}, n);
      for (int k = 0; k < 6; ++k) {
        const bool fields = k % 2 == 1;
        r.method = methods[k / 2];
        r.roll(grid.get(), fields);
        for (const auto* v : {&r.fx, &r.fy, &r.mz}) all.insert(all.end(), v->begin(), v->end());
        all.push_back(r.power);
      }
      for (const auto* v : {&r.traction_x, &r.traction_y, &r.sliding_x, &r.sliding_y})
        all.insert(all.end(), v->begin(), v->end());
    }
    if (first.empty()) first = all;
    ASSERT_EQ(first.size(), all.size());
    EXPECT_EQ(std::memcmp(first.data(), all.data(), all.size() * sizeof(double)), 0);
  }
}

}  // namespace
}  // namespace wrc::surface
