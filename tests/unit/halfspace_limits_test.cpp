/// The exact solver where closed solutions and symmetries leave no choice. Cattaneo and Mindlin's problem
/// (tangential load without rolling) has no counterpart in steady rolling: Carter's is its rolling form.
#include <gtest/gtest.h>

#include <cmath>

#include "halfspace/normal.hpp"
#include "halfspace/tangential.hpp"
#include "halfspace/transient.hpp"
#include "sdec_pressure.hpp"
#include "unit/halfspace_closed_forms.hpp"

namespace wrc::halfspace {
namespace {

constexpr patch::Material steel{.shear_modulus = 82e9, .poisson = 0.28};
constexpr double peak = 1e9, friction = 0.3;

class HertzLimit : public testing::TestWithParam<double> {};

// Peak, both semi-axes and approach within 0.5 % at 64 x 64 cells.
TEST_P(HertzLimit, PeakAxesAndApproachAtSixtyFourCells) {
  const double a = 4e-3, b = a * GetParam();
  const closed_forms::Hertz exact = closed_forms::hertz(steel, a, b, peak);
  const Grid grid = grid_over_box(-1.25 * a, 1.25 * a, -1.25 * b, 1.25 * b, 64, 64);
  GapProblem problem{.gap = Field(grid.cells()), .normal_force = exact.load, .progress = {}};
  for (int j = 0; j < 64; ++j) {
    for (int i = 0; i < 64; ++i) {
      problem.gap[grid.index(i, j)] =
          0.5 * (exact.curvature_x * grid.x(i) * grid.x(i) + exact.curvature_y * grid.y(j) * grid.y(j));
    }
  }
  const GapSolution s = NormalSolver(grid, steel).solve(problem);
  ASSERT_EQ(s.fault.status, WRC_OK);
  const closed_forms::Axes found = closed_forms::axes(grid, s.pressure);
  EXPECT_NEAR(s.peak_pressure / peak, 1.0, 5e-3);
  EXPECT_NEAR(s.approach / exact.approach, 1.0, 5e-3);
  EXPECT_NEAR(found.a / a, 1.0, 5e-3);
  EXPECT_NEAR(found.b / b, 1.0, 5e-3);
}
INSTANTIATE_TEST_SUITE_P(AxisRatio, HertzLimit, testing::Values(1.0, 1.5, 3.0, 8.0));

struct MiddleSection {
  double force = 0.0;     // |F| / (mu N)
  double distance = 0.0;  // mean difference of the tractions from Carter's, over mu p0
};

// The middle of a contact forty times as wide as long, rolling at a share of the creepage at which all slips.
MiddleSection middle_of_long_contact(int n, double compliance, double creepage, bool lateral) {
  constexpr int rows = 25;
  constexpr double a = 4e-3, b = 40.0 * a;
  const Grid grid = grid_over_box(-a, a, -b, b, n, rows);
  RollingProblem problem;
  const SdecPatch cylinder{.a = a, .b = 1e3 * b, .psi = 0.0};  // as far as the grid reaches
  problem.pressure = sdec_pressure(cylinder, peak, grid, CellPressure::mean);
  problem.friction = {friction};
  (lateral ? problem.creepage.lateral : problem.creepage.longitudinal) = creepage;
  const RollingSolution s = RollingSolver(grid, steel).solve(problem);
  EXPECT_EQ(s.fault.status, WRC_OK);
  const closed_forms::Carter carter(a, friction * peak, compliance, creepage);
  const Field& traction = lateral ? s.traction_y : s.traction_x;
  MiddleSection middle;
  double full = 0.0;
  for (int i = 0; i < n; ++i) {
    const std::size_t at = grid.index(i, rows / 2);
    middle.force -= traction[at];
    full += friction * problem.pressure[at];
    // A cell's traction stands for a point a quarter of a cell behind its centre (tangential.hpp).
    const double expected = carter.traction(grid.x(i) - 0.25 * grid.dx);
    middle.distance += std::abs(-traction[at] - expected) / (n * friction * peak);
  }
  middle.force /= full;
  return middle;
}

class CarterLimit : public testing::TestWithParam<double> {};

// First order in the cells along x: 1 % of mu N at 32 cells, half of that at 64, and the extrapolated force
// within what the ends of the contact add, (a/b)^2 = 6e-4.
TEST_P(CarterLimit, MiddleOfALongContactIsCarters) {
  for (const bool lateral : {false, true}) {
    const double compliance = (lateral ? 1.0 : 1.0 - steel.poisson) / steel.shear_modulus;
    const double creepage = GetParam() * 2.0 * friction * peak * compliance;
    const double exact = closed_forms::Carter(4e-3, friction * peak, compliance, creepage).force();
    const MiddleSection coarse = middle_of_long_contact(32, compliance, creepage, lateral);
    const MiddleSection fine = middle_of_long_contact(64, compliance, creepage, lateral);
    EXPECT_NEAR(coarse.force, exact, 0.012) << (lateral ? "lateral" : "longitudinal");
    EXPECT_NEAR(fine.force, exact, 0.006) << (lateral ? "lateral" : "longitudinal");
    EXPECT_NEAR(2.0 * fine.force - coarse.force, exact, 1.2e-3) << (lateral ? "lateral" : "longitudinal");
    EXPECT_LT(fine.distance, 0.01) << (lateral ? "lateral" : "longitudinal");
  }
}
INSTANTIATE_TEST_SUITE_P(ShareOfSaturation, CarterLimit, testing::Values(0.1, 0.3, 0.5, 0.8, 1.05));

// Cylinders of unlike materials that roll freely without slip: with Hertz's pressure, plane strain, the slip
// equation xi + 2 K p / G + 2 (1 - nu) / (pi G) P.V. int q / (x - s) ds = 0, q = 0 at the leading edge and
// int q = 0 have xi = -4 K p0 / (pi G) = -2 beta a / (pi R), beta = K / (1 - nu) (Bentall and Johnson 1967).
// Ends at +-b take pi a / (4 b) of that away.
TEST(HalfspaceUnlikeBodies, CylindersThatStickCreepFreely) {
  constexpr int rows = 25;
  constexpr double a = 4e-3, b = 40.0 * a, coupling = 0.2;
  double creepage[2] = {};
  for (const int fine : {0, 1}) {
    const int n = fine ? 64 : 32;
    const Grid grid = grid_over_box(-a, a, -b, b, n, rows);
    RollingProblem problem;
    problem.pressure =
        sdec_pressure(SdecPatch{.a = a, .b = 1e3 * b, .psi = 0.0}, peak, grid, CellPressure::mean);
    problem.adhesion = Adhesion::full;
    problem.tolerance = 1e-6;
    RollingSolver solver(grid, steel, {}, coupling);
    double force[2] = {};
    for (const int k : {0, 1}) {
      problem.creepage.longitudinal = 1e-3 * k;
      const RollingSolution s = solver.solve(problem);
      ASSERT_EQ(s.fault.status, WRC_OK);
      for (int i = 0; i < n; ++i) force[k] += s.traction_x[grid.index(i, rows / 2)];
    }
    creepage[fine] = -1e-3 * force[0] / (force[1] - force[0]);
  }
  const double exact = -4.0 * coupling * peak / (pi * steel.shear_modulus) * (1.0 - pi * a / (4.0 * b));
  EXPECT_NEAR(creepage[1] / exact, 1.0, 0.03);
  EXPECT_NEAR((2.0 * creepage[1] - creepage[0]) / exact, 1.0, 0.01);
}

// A flat punch bonded to a half-space before it is pressed in is stiffer than a smooth one by
// ln((1 + beta) / (1 - beta)) / (2 beta), whichever body is the stiff one (Mossakovskii; Spence 1968).
TEST(HalfspaceUnlikeBodies, BondedPunchIsStifferThanASmoothOne) {
  constexpr double a = 4e-3, delta = 1e-5, away = 1.0;
  const patch::Material soft{.shear_modulus = 2.0 * 40e9,
                             .poisson = 0.0};  // rigid on G = 40 GPa, nu = 0: beta = 1/2
  double ratio[2] = {};
  for (const int fine : {0, 1}) {
    const int n = fine ? 40 : 20;
    const Grid grid = grid_over_box(-1.1 * a, 1.1 * a, -1.1 * a, 1.1 * a, n, n);
    for (const double coupling : {0.5, -0.5}) {
      GapProblem problem;
      problem.prescribed = normal::Prescribed::approach;
      problem.approach = delta;
      problem.gap.assign(grid.cells(), away);
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          if (std::hypot(grid.x(i), grid.y(j)) < a) problem.gap[grid.index(i, j)] = 0.0;
      const Field flat = problem.gap;
      NormalSolver normal(grid, soft);
      TurnedConvolution opening(grid, soft, Convolution::Kernel::coupling, {}, coupling);
      double smooth = 0.0, bonded = 0.0;
      for (int turn = 0; turn < 12; ++turn) {
        const GapSolution pressed = normal.solve(problem);
        bonded = pressed.normal_force;
        if (turn == 0) smooth = bonded;
        RollingProblem sticks;
        sticks.pressure = pressed.pressure;
        sticks.adhesion = Adhesion::full;
        const RollingSolution held = TransientSolver(grid, soft, coupling).step(sticks);
        ASSERT_EQ(held.fault.status, WRC_OK);
        Field x = held.traction_x, y = held.traction_y;
        opening.tangential(x, y);
        for (std::size_t k = 0; k < flat.size(); ++k) problem.gap[k] = flat[k] + y[k];
      }
      if (coupling < 0.0) {
        EXPECT_NEAR(bonded / smooth, ratio[fine], 1e-4);
      }
      ratio[fine] = bonded / smooth;
    }
  }
  EXPECT_NEAR(ratio[1], std::log(3.0), 0.015);
}

RollingSolution roll(const tangential::Creepage& creepage, double psi = 0.0, int n = 33) {
  const SdecPatch patch{.a = 4e-3, .b = 6e-3, .psi = psi};
  const Grid grid = grid_over(patch, n, n);
  RollingProblem problem;
  problem.pressure = sdec_pressure(patch, peak, grid, CellPressure::mean);
  problem.friction = {friction};
  problem.creepage = creepage;
  problem.tolerance = 1e-6;
  return RollingSolver(grid, steel).solve(problem);
}
constexpr double full_force = friction * 2.0 / 3.0 * pi * 4e-3 * 6e-3 * peak;

// Pure spin on an ellipse: no longitudinal force by symmetry about the x axis, a lateral force, and a moment
// against the spin.
TEST(HalfspaceSymmetry, PureSpinMakesNoLongitudinalForce) {
  const RollingSolution s = roll({.spin = 0.5});
  ASSERT_EQ(s.fault.status, WRC_OK);
  EXPECT_NEAR(s.forces.fx, 0.0, 1e-5 * full_force);
  EXPECT_LT(s.forces.fy, -0.1 * full_force);
  EXPECT_LT(s.forces.mz, 0.0);
  const Grid grid = grid_over(SdecPatch{.a = 4e-3, .b = 6e-3, .psi = 0.0}, 33, 33);
  for (int j = 0; j < 16; ++j) {
    for (int i = 0; i < 33; ++i) {
      const std::size_t here = grid.index(i, j), mirrored = grid.index(i, 32 - j);
      EXPECT_NEAR(s.traction_x[here], -s.traction_x[mirrored], 1e-3 * friction * peak);
      EXPECT_NEAR(s.traction_y[here], s.traction_y[mirrored], 1e-3 * friction * peak);
    }
  }
}

// Turning all creepages round turns all forces round and changes nothing else: on any patch.
TEST(HalfspaceSymmetry, OppositeCreepagesMakeOppositeForces) {
  const RollingSolution there = roll({.longitudinal = 8e-4, .lateral = -5e-4, .spin = 0.3}, 0.5);
  const RollingSolution back = roll({.longitudinal = -8e-4, .lateral = 5e-4, .spin = -0.3}, 0.5);
  EXPECT_NEAR(there.forces.fx, -back.forces.fx, 1e-6 * full_force);
  EXPECT_NEAR(there.forces.fy, -back.forces.fy, 1e-6 * full_force);
  EXPECT_NEAR(there.forces.mz, -back.forces.mz, 1e-6 * full_force * 4e-3);
  EXPECT_NEAR(there.power_by_balance / back.power_by_balance, 1.0, 1e-6);
  EXPECT_EQ(there.forces.adhesion_fraction, back.forces.adhesion_fraction);
}

// The x axis of an ellipse is one of symmetry: (nu_y, phi) -> -(nu_y, phi) turns F_y and M_z and leaves F_x.
TEST(HalfspaceSymmetry, MirroredCreepagesOnAnEllipse) {
  const RollingSolution one = roll({.longitudinal = 8e-4, .lateral = -5e-4, .spin = 0.3});
  const RollingSolution two = roll({.longitudinal = 8e-4, .lateral = 5e-4, .spin = -0.3});
  EXPECT_NEAR(one.forces.fx, two.forces.fx, 1e-5 * full_force);
  EXPECT_NEAR(one.forces.fy, -two.forces.fy, 1e-5 * full_force);
  EXPECT_NEAR(one.forces.mz, -two.forces.mz, 1e-5 * full_force * 4e-3);
}

// What the cells dissipate tends to what the rigid motion supplies: twice as fine, half the difference (first
// order), so that the extrapolated sum meets the balance.
TEST(HalfspaceEnergy, ExtrapolatedDissipationIsTheEnergyBalance) {
  for (const tangential::Creepage& creepage :
       {tangential::Creepage{.longitudinal = 1e-3, .lateral = 0.0, .spin = 0.3},
        tangential::Creepage{.longitudinal = 0.0, .lateral = 1.5e-3, .spin = 0.0},
        tangential::Creepage{.longitudinal = 0.0, .lateral = 0.0, .spin = 0.8}}) {
    const RollingSolution coarse = roll(creepage, 0.3, 48), fine = roll(creepage, 0.3, 96);
    const double sum = 2.0 * fine.forces.power_per_speed - coarse.forces.power_per_speed;
    const double balance = 2.0 * fine.power_by_balance - coarse.power_by_balance;
    EXPECT_LT(fine.forces.power_per_speed, fine.power_by_balance);
    EXPECT_NEAR(sum / balance, 1.0, 0.01);
  }
}

}  // namespace
}  // namespace wrc::halfspace
