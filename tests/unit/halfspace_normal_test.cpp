#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "halfspace/normal.hpp"
#include "unit/halfspace_closed_forms.hpp"

namespace wrc::halfspace {
namespace {

using closed_forms::Hertz;
constexpr patch::Material steel{.shear_modulus = 82e9, .poisson = 0.28};

GapSolution solve(double a, double b, double p0, int cells, normal::Prescribed prescribed) {
  const Hertz exact = closed_forms::hertz(steel, a, b, p0);
  const Grid grid = grid_over_box(-1.25 * a, 1.25 * a, -1.25 * b, 1.25 * b, cells, cells);
  GapProblem problem{.gap = Field(grid.cells()), .prescribed = prescribed, .progress = {}};
  problem.normal_force = exact.load;
  problem.approach = exact.approach;
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      problem.gap[grid.index(i, j)] =
          0.5 * (exact.curvature_x * grid.x(i) * grid.x(i) + exact.curvature_y * grid.y(j) * grid.y(j));
    }
  }
  return NormalSolver(grid, steel).solve(problem);
}

class HalfspaceHertz : public testing::TestWithParam<double> {};

// Issue's figure: 0.5 % at 64 x 64. The area is counted in whole cells, hence its wider band (the axes follow
// from load and peak, which are inside 0.5 %).
TEST_P(HalfspaceHertz, PeakApproachAndLoadAtSixtyFourCells) {
  const double a = 4e-3, b = a * GetParam(), p0 = 1e9;
  const Hertz exact = closed_forms::hertz(steel, a, b, p0);
  for (const normal::Prescribed prescribed : {normal::Prescribed::load, normal::Prescribed::approach}) {
    const GapSolution s = solve(a, b, p0, 64, prescribed);
    EXPECT_EQ(s.fault.status, WRC_OK);
    EXPECT_NEAR(s.peak_pressure / p0, 1.0, 5e-3);
    EXPECT_NEAR(s.approach / exact.approach, 1.0, 5e-3);
    EXPECT_NEAR(s.normal_force / exact.load, 1.0, 5e-3);
    EXPECT_NEAR(s.area / (pi * a * b), 1.0, 2e-2);
  }
}

INSTANTIATE_TEST_SUITE_P(AxisRatio, HalfspaceHertz, testing::Values(1.0, 2.0, 5.0));

TEST(HalfspaceNormal, ApproachConvergesFasterThanFirstOrder) {
  const Hertz exact = closed_forms::hertz(steel, 4e-3, 8e-3, 1e9);
  double before = 0.0;
  for (const int cells : {24, 48, 96}) {
    const GapSolution s = solve(4e-3, 8e-3, 1e9, cells, normal::Prescribed::load);
    const double error = std::abs(s.approach / exact.approach - 1.0);
    std::printf("  %3d cells: approach %.2e, peak %.2e, %d iterations\n", cells, error,
                s.peak_pressure / 1e9 - 1.0, s.iterations);
    if (before > 0.0) {
      EXPECT_LT(error, 0.5 * before);
    }
    before = error;
  }
}

TEST(HalfspaceNormal, NoOverlapIsNoContactAndBorderIsFlagged) {
  const Grid grid = grid_over_box(-1e-3, 1e-3, -1e-3, 1e-3, 8, 8);
  GapProblem problem{
      .gap = Field(grid.cells(), 1e-6), .prescribed = normal::Prescribed::approach, .progress = {}};
  NormalSolver solver(grid, steel);
  EXPECT_EQ(solver.solve(problem).fault.status, WRC_FLAG_NO_CONTACT);
  problem.approach = 2e-6;
  EXPECT_EQ(solver.solve(problem).fault.status, WRC_FLAG_PATCH_AT_EDGE);
}

TEST(HalfspaceNormal, CanBeCancelled) {
  const Grid grid = grid_over_box(-1e-3, 1e-3, -1e-3, 1e-3, 8, 8);
  GapProblem problem{
      .gap = Field(grid.cells(), 1e-6), .prescribed = normal::Prescribed::approach, .progress = {}};
  problem.approach = 2e-6;
  problem.progress.report = [](double, void*) { return false; };
  EXPECT_EQ(NormalSolver(grid, steel).solve(problem).fault.status, WRC_ERROR_CANCELLED);
}

}  // namespace
}  // namespace wrc::halfspace
