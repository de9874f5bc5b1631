#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "halfspace/tangential.hpp"
#include "sdec_pressure.hpp"

namespace wrc::halfspace {
namespace {

constexpr patch::Material steel{.shear_modulus = 82e9, .poisson = 0.25};
constexpr double peak = 1e9;

struct Case {
  SdecPatch patch;
  double friction = 0.3;
  int n = 32;
  double load() const { return 2.0 / 3.0 * pi * patch.a * patch.b * peak; }
};

RollingProblem rolling(const Case& contact, const Grid& grid, const tangential::Creepage& creepage) {
  RollingProblem problem;
  problem.pressure = sdec_pressure(contact.patch, peak, grid, CellPressure::mean);
  problem.friction = {contact.friction};
  problem.creepage = creepage;
  return problem;
}

RollingSolution solve(const Case& contact, const tangential::Creepage& creepage) {
  const Grid grid = grid_over(contact.patch, contact.n, contact.n);
  return RollingSolver(grid, steel).solve(rolling(contact, grid, creepage));
}

TEST(HalfspaceRolling, LargeCreepageGivesCoulombsForceAndItsDissipation) {
  const Case contact{.patch = {.a = 5e-3, .b = 4e-3, .psi = 0.0}};
  const RollingSolution s = solve(contact, {.longitudinal = 0.03, .lateral = -0.04});
  const double full = contact.friction * contact.load();
  EXPECT_EQ(s.fault.status, WRC_OK);
  EXPECT_NEAR(s.forces.fx / full, -0.6, 2e-3);
  EXPECT_NEAR(s.forces.fy / full, 0.8, 2e-3);
  EXPECT_EQ(s.forces.adhesion_fraction, 0.0);
  EXPECT_NEAR(s.power_by_balance / (full * 0.05), 1.0, 2e-3);
}

TEST(HalfspaceRolling, TractionsObeyCoulomb) {
  const Case contact{.patch = {.a = 4e-3, .b = 6e-3, .psi = -0.4}};
  const Grid grid = grid_over(contact.patch, contact.n, contact.n);
  const RollingProblem problem =
      rolling(contact, grid, {.longitudinal = 1e-3, .lateral = -5e-4, .spin = 0.3});
  const RollingSolution s = RollingSolver(grid, steel).solve(problem);
  ASSERT_EQ(s.fault.status, WRC_OK);
  EXPECT_GT(s.forces.adhesion_fraction, 0.05);
  EXPECT_LT(s.forces.adhesion_fraction, 0.95);
  for (std::size_t k = 0; k < grid.cells(); ++k) {
    const double g = contact.friction * problem.pressure[k];
    const double p = std::hypot(s.traction_x[k], s.traction_y[k]),
                 slip = std::hypot(s.slip_x[k], s.slip_y[k]);
    EXPECT_LE(p, g + 1e-2 * contact.friction * peak);
    if (s.state[k] == tangential::CellState::slip) {
      const double power = -(s.traction_x[k] * s.slip_x[k] + s.traction_y[k] * s.slip_y[k]);
      EXPECT_NEAR(power, p * slip, 1e-4 * contact.friction * peak * 1e-3);
    }
  }
}

// y -> -y turns (psi, nu_y, phi) into their opposites, and with them F_y and M_z.
TEST(HalfspaceRolling, MirrorImage) {
  const Case left{.patch = {.a = 4e-3, .b = 6e-3, .psi = 0.4}},
      right{.patch = {.a = 4e-3, .b = 6e-3, .psi = -0.4}};
  const RollingSolution l = solve(left, {.longitudinal = 1e-3, .lateral = 7e-4, .spin = 0.3});
  const RollingSolution r = solve(right, {.longitudinal = 1e-3, .lateral = -7e-4, .spin = -0.3});
  const double full = left.friction * left.load();
  EXPECT_NEAR(l.forces.fx, r.forces.fx, 2e-4 * full);
  EXPECT_NEAR(l.forces.fy, -r.forces.fy, 2e-4 * full);
  EXPECT_NEAR(l.forces.mz, -r.forces.mz, 2e-4 * full * left.patch.b);
}

// The dissipation summed over the cells approaches the energy balance as the grid is refined.
TEST(HalfspaceRolling, DissipationApproachesTheEnergyBalance) {
  double before = 1.0;
  for (const int n : {16, 32, 64}) {
    const RollingSolution s =
        solve({.patch = {.a = 4e-3, .b = 6e-3, .psi = 0.2}, .n = n}, {.longitudinal = 1.5e-3, .spin = 0.2});
    const double difference = 1.0 - s.forces.power_per_speed / s.power_by_balance;
    EXPECT_GT(difference, 0.0);
    EXPECT_LT(difference, 0.7 * before);
    before = difference;
  }
}

// Forces converge at first order without scatter, so two grids extrapolate: cells on the border carry their
// share.
TEST(HalfspaceRolling, ForceConvergesCleanlyWithTheGrid) {
  double fx[3];
  int k = 0;
  for (const int n : {20, 40, 80}) {
    fx[k++] =
        solve({.patch = {.a = 4e-3, .b = 6e-3, .psi = 0.2}, .n = n}, {.longitudinal = 1.2e-3, .spin = 0.3})
            .forces.fx;
  }
  const double coarse = 2.0 * fx[1] - fx[0], fine = 2.0 * fx[2] - fx[1];
  EXPECT_NEAR(coarse / fine, 1.0, 2e-3);
  EXPECT_GT((fx[0] - fx[1]) / (fx[1] - fx[2]), 1.5);
}

TEST(HalfspaceRolling, FrictionFieldOfEqualValuesIsTheScalar) {
  const Case contact{.patch = {.a = 4e-3, .b = 6e-3, .psi = 0.2}};
  const Grid grid = grid_over(contact.patch, contact.n, contact.n);
  RollingProblem problem = rolling(contact, grid, {.longitudinal = 1e-3});
  RollingSolver solver(grid, steel);
  const double scalar = solver.solve(problem).forces.fx;
  problem.friction.assign(grid.cells(), contact.friction);
  EXPECT_NEAR(solver.solve(problem).forces.fx / scalar, 1.0, 1e-6);
  problem.friction.assign(grid.cells(), 0.0);
  EXPECT_EQ(solver.solve(problem).forces.fx, 0.0);
}

TEST(HalfspaceRolling, CanBeCancelledAndRejectsNonsense) {
  const Case contact{.patch = {.a = 4e-3, .b = 6e-3, .psi = 0.2}};
  const Grid grid = grid_over(contact.patch, contact.n, contact.n);
  RollingProblem problem = rolling(contact, grid, {.longitudinal = 1e-3});
  problem.progress.report = [](double, void*) { return false; };
  RollingSolver solver(grid, steel);
  EXPECT_EQ(solver.solve(problem).fault.status, WRC_ERROR_CANCELLED);
  problem.pressure.pop_back();
  EXPECT_EQ(solver.solve(problem).fault.status, WRC_ERROR_RANGE);
}

}  // namespace
}  // namespace wrc::halfspace
