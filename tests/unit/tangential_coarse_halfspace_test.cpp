#include <gtest/gtest.h>

#include <memory>

#include "halfspace/tangential.hpp"
#include "sdec_pressure.hpp"
#include "tangential/coarse_halfspace/coarse_halfspace.hpp"
#include "tangential/coarse_halfspace/coarse_rolling.hpp"
#include "tangential_patches.hpp"

namespace wrc {
namespace {

using test::OwnedGrid;
using test::OwnedStrips;
using test::RandomCase;
using test::sdec_strips;

constexpr int strips_of_a_patch = 60, cells_of_a_strip = 32;

/// The method with memory of its own.
class Solver {
 public:
  TangentialForces operator()(const RandomCase& c, const Strips& region,
                              const TangentialFields& fields = {}) {
    RollingContact contact;
    contact.region = region;
    contact.shear_modulus = c.shear_modulus;
    const SdecTable table(c.poisson);
    contact.linear_theory = &table;
    contact.grid = &grid_.get();
    contact.creepage = c.creepage;
    contact.friction = c.friction;
    fault = {};
    return coarse_halfspace(contact, memory_.data(), fields, fault);
  }

  Fault fault;

 private:
  OwnedGrid grid_{cells_of_a_strip};
  std::vector<double> memory_ =
      std::vector<double>(static_cast<std::size_t>(coarse_halfspace_workspace()) / sizeof(double) + 1);
};

OwnedStrips strips_of(const RandomCase& c) {
  return sdec_strips(c.a, c.b, c.psi, c.normal_force, strips_of_a_patch);
}

/// The offline solver on n x n cells.
halfspace::RollingSolution exact(const RandomCase& c, int n) {
  const halfspace::SdecPatch patch{.a = c.a, .b = c.b, .psi = c.psi};
  const halfspace::Grid grid = halfspace::grid_over(patch, n, n);
  halfspace::RollingProblem problem;
  problem.pressure = halfspace::sdec_pressure(patch, 1.5 * c.normal_force / (pi * c.a * c.b), grid,
                                              halfspace::CellPressure::mean);
  problem.friction = {c.friction};
  problem.creepage = c.creepage;
  return halfspace::RollingSolver(grid, {c.shear_modulus, c.poisson}).solve(problem);
}

TEST(CoarseHalfspace, IsTheExactTheoryWithinTwoPercentOnRandomPatches) {
  std::mt19937 random(20);
  Solver solve;
  double sum = 0.0;
  constexpr int cases = 40;
  for (int k = 0; k < cases; ++k) {
    const RandomCase c = test::random_case(random);
    const OwnedStrips strips = strips_of(c);
    const TangentialForces f = solve(c, strips.get());
    ASSERT_EQ(solve.fault.status, WRC_OK);
    const TangentialForces fine = exact(c, 48).forces, coarse = exact(c, 24).forces;
    const double limit = c.friction * c.normal_force;
    const double error = std::hypot(f.fx - (2.0 * fine.fx - coarse.fx), f.fy - (2.0 * fine.fy - coarse.fy));
    EXPECT_LE(error, 0.02 * limit) << "case " << k;
    EXPECT_NEAR(f.mz, 2.0 * fine.mz - coarse.mz, 0.02 * limit * std::sqrt(c.a * c.b)) << "case " << k;
    sum += error / limit;
  }
  EXPECT_LE(sum / cases, 0.006);
}

TEST(CoarseHalfspace, OneGridSolvesTheSameEquationsAsTheOfflineSolver) {
  constexpr int n = 12;
  std::mt19937 random(3);
  const auto rolling = std::make_unique<CoarseRolling<n>>();
  for (int k = 0; k < 10; ++k) {
    const RandomCase c = test::random_case(random);
    const halfspace::SdecPatch patch{.a = c.a, .b = c.b, .psi = c.psi};
    const halfspace::Grid grid = halfspace::grid_over(patch, n, n);
    const halfspace::Field pressure = halfspace::sdec_pressure(patch, 1.5 * c.normal_force / (pi * c.a * c.b),
                                                               grid, halfspace::CellPressure::mean);
    rolling->grid.dx = grid.dx;
    rolling->grid.dy = grid.dy;
    rolling->grid.first_x = grid.x0;
    rolling->grid.first_y = grid.y0;
    fill_coefficients({c.shear_modulus, c.poisson}, rolling->grid);
    std::fill_n(rolling->border_compliance, n * n, 0.0);
    for (std::size_t at = 0; at < n * n; ++at) rolling->bound[at] = c.friction * pressure[at];
    std::fill_n(rolling->px, n * n, 0.0);
    std::fill_n(rolling->py, n * n, 0.0);
    ASSERT_TRUE(rolling->solve(c.creepage, 1e-4, 40));
    const TangentialForces ours = rolling->forces(c.creepage), theirs = exact(c, n).forces;
    const double limit = c.friction * c.normal_force;
    EXPECT_NEAR(ours.fx, theirs.fx, 1e-4 * limit);
    EXPECT_NEAR(ours.fy, theirs.fy, 1e-4 * limit);
    EXPECT_NEAR(ours.mz, theirs.mz, 1e-4 * limit * std::sqrt(c.a * c.b));
  }
}

TEST(CoarseHalfspace, SmallCreepagesGiveKalkersLinearForces) {
  // Kalker's printed coefficients, nu = 0.25, a/b = 1: C11 4.12, C22 3.67, C23 1.47. An extrapolated grid of
  // 16 cells has 1 % left in full adhesion, whose tractions are singular at the trailing edge.
  Solver solve;
  const double a = 5e-3, N = 80e3, e = 1e-7;
  const OwnedStrips strips = sdec_strips(a, a, 0.0, N, strips_of_a_patch);
  const auto force = [&](const Creepage& creep) {
    return solve({a, a, 0.0, N, 0.3, 80e9, 0.25, creep}, strips.get());
  };
  const double unit = 80e9 * a * a * e;
  EXPECT_NEAR(force({e, 0, 0}).fx / unit, -4.12, 0.015 * 4.12);
  EXPECT_NEAR(force({0, e, 0}).fy / unit, -3.67, 0.015 * 3.67);
  EXPECT_NEAR(force({0, 0, e / a}).fy / unit, -1.47, 0.015 * 1.47);
}

TEST(CoarseHalfspace, LargeCreepagesGiveCoulombsForceAgainstThem) {
  Solver solve;
  const RandomCase c{4e-3, 6e-3, -0.3, 80e3, 0.3, 80e9, 0.28, {0.3, 0.4, 0.0}};
  const OwnedStrips strips = strips_of(c);
  const double limit = c.friction * totals(strips.get()).normal_force;
  const TangentialForces f = solve(c, strips.get());
  EXPECT_NEAR(f.fx, -0.6 * limit, 1e-3 * limit);
  EXPECT_NEAR(f.fy, -0.8 * limit, 1e-3 * limit);
  EXPECT_NEAR(f.power_per_speed, 0.5 * limit, 1e-3 * limit);
  EXPECT_EQ(f.adhesion_fraction, 0.0);
}

TEST(CoarseHalfspace, TheMirroredPatchHasMirroredForces) {
  Solver solve;
  std::mt19937 random(5);
  for (int k = 0; k < 10; ++k) {
    RandomCase c = test::random_case(random);
    const OwnedStrips strips = strips_of(c);
    const TangentialForces f = solve(c, strips.get());
    c.psi = -c.psi;
    c.creepage.lateral = -c.creepage.lateral;
    c.creepage.spin = -c.creepage.spin;
    const OwnedStrips mirrored = strips_of(c);
    const TangentialForces g = solve(c, mirrored.get());
    const double limit = c.friction * c.normal_force;
    EXPECT_NEAR(f.fx, g.fx, 1e-3 * limit);  // the iteration stops at 1e-3
    EXPECT_NEAR(f.fy, -g.fy, 1e-3 * limit);
    EXPECT_NEAR(f.mz, -g.mz, 1e-3 * limit * std::sqrt(c.a * c.b));
  }
}

TEST(CoarseHalfspace, FieldsKeepTheBoundAndMakeThePowerOfTheForces) {
  Solver solve;
  std::mt19937 random(7);
  constexpr std::size_t values = static_cast<std::size_t>(strips_of_a_patch) * cells_of_a_strip;
  std::vector<double> px(values), py(values), sx(values), sy(values);
  const OwnedGrid grid(cells_of_a_strip);
  for (int k = 0; k < 20; ++k) {
    const RandomCase c = test::random_case(random);
    const OwnedStrips strips = strips_of(c);
    const Strips& s = strips.get();
    const TangentialForces f = solve(c, s, {px.data(), py.data(), sx.data(), sy.data()});
    double fx = 0.0, fy = 0.0, power = 0.0;
    for (int i = 0; i < cells_of_a_strip; ++i) {
      for (int j = 0; j < s.count; ++j) {
        const auto at = static_cast<std::size_t>(i * s.count + j);
        const double bound = c.friction * s.peak[j] * grid.get().elliptic.mean[i];
        ASSERT_LE(std::hypot(px[at], py[at]), bound * (1.0 + 1e-12));
        ASSERT_LE(sx[at] * px[at] + sy[at] * py[at], 0.0);
        const double cell = 2.0 * s.half_length[j] / cells_of_a_strip * s.width[j];
        fx += px[at] * cell;
        fy += py[at] * cell;
        power -= (sx[at] * px[at] + sy[at] * py[at]) * cell;
      }
    }
    const double limit = c.friction * c.normal_force;
    EXPECT_LE(std::hypot(fx - f.fx, fy - f.fy), 0.02 * limit);
    EXPECT_NEAR(power, f.power_per_speed, 1e-9 * f.power_per_speed);
  }
}

TEST(CoarseHalfspace, ForcesFollowTheCreepagesContinuously) {
  Solver solve;
  RandomCase c{5e-3, 4e-3, 0.4, 80e3, 0.3, 80e9, 0.28, {}};
  const OwnedStrips strips = strips_of(c);
  const double limit = c.friction * c.normal_force;
  TangentialForces before;
  double largest = 0.0;
  constexpr int steps = 400;
  for (int k = 0; k <= steps; ++k) {
    const double level = 4e-3 * k / steps;
    c.creepage = {0.5 * level, level, 150.0 * level};
    const TangentialForces f = solve(c, strips.get());
    if (k > 0) largest = std::max(largest, std::hypot(f.fx - before.fx, f.fy - before.fy) / limit);
    before = f;
  }
  // The steepest slope of linear theory makes 1.5 % a step here; a jump would stand out.
  EXPECT_LE(largest, 0.02);
}

TEST(CoarseHalfspace, WithoutStripsOrFrictionThereIsNoForce) {
  Solver solve;
  RandomCase c{5e-3, 4e-3, 0.4, 80e3, 0.0, 80e9, 0.28, {1e-3, 1e-3, 0.1}};
  const OwnedStrips strips = strips_of(c), none(0);
  const TangentialForces f = solve(c, strips.get());
  EXPECT_EQ(f.fx, 0.0);
  EXPECT_EQ(f.fy, 0.0);
  EXPECT_EQ(solve(c, none.get()).fx, 0.0);
  EXPECT_EQ(solve.fault.status, WRC_OK);
}

}  // namespace
}  // namespace wrc
