#include <gtest/gtest.h>

#include "normal/elasticity/hertz_theory.hpp"
#include "normal/methods/hertz.hpp"
#include "normal_gaps.hpp"

namespace wrc::normal {
namespace {

// A / B, eps_x and eps_y of Hertz's ellipse for given a / b; solved with mpmath-grade arithmetic outside this
// tree.
struct ShapeRow {
  double axis_ratio, curvature_ratio, eps_x;
};
constexpr ShapeRow shape_rows[] = {{0.1, 36.536, 0.2676}, {0.2, 11.827, 0.3211}, {0.3, 6.240, 0.3596},
                                   {0.5, 2.843, 0.4154},  {1.0, 1.000, 0.5000},  {2.0, 0.352, 0.5846},
                                   {5.0, 0.0846, 0.6789}, {10.0, 0.0274, 0.7324}};

TEST(HertzTheory, ReproducesTheTableOfShapes) {
  for (const ShapeRow& row : shape_rows) {
    const HertzShape shape = hertz_shape(row.curvature_ratio);
    EXPECT_NEAR(shape.axis_ratio, row.axis_ratio, 1.5e-3 * row.axis_ratio);
    EXPECT_NEAR(shape.eps_x, row.eps_x, 3e-4);
    EXPECT_DOUBLE_EQ(shape.eps_x + shape.eps_y, 1.0);
    // A a^2 / (B b^2) = eps_x / eps_y
    const double ratio = row.curvature_ratio * shape.axis_ratio * shape.axis_ratio;
    EXPECT_NEAR(shape.eps_x / shape.eps_y, ratio, 1e-12 * ratio);
  }
}

TEST(HertzTheory, SwapsWithItsAxes) {
  for (double ratio = 1e-6; ratio < 1.0; ratio *= 3.0) {
    const HertzShape wide = hertz_shape(ratio);
    const HertzShape turned = hertz_shape(1.0 / ratio);
    EXPECT_NEAR(wide.axis_ratio * turned.axis_ratio, 1.0, 1e-12);
    EXPECT_NEAR(wide.eps_x, turned.eps_y, 1e-12);
  }
}

TEST(HertzTheory, TableFollowsTheSolution) {
  for (double ratio = 1e-8; ratio < 1e8; ratio *= 1.03) {
    const HertzShape exact = hertz_shape(ratio), table = tabulated_hertz_shape(ratio);
    EXPECT_NEAR(table.axis_ratio, exact.axis_ratio, 1e-6 * exact.axis_ratio) << ratio;
    EXPECT_NEAR(table.eps_x, exact.eps_x, 1e-6 * exact.eps_x) << ratio;
    EXPECT_NEAR(table.eps_y, exact.eps_y, 1e-6 * exact.eps_y) << ratio;
    EXPECT_NEAR(table.centre, exact.centre, 1e-6 * exact.centre) << ratio;
  }
}

TEST(HertzTheory, SphereIsTheTextbookOne) {
  // Johnson 4.22 to 4.24 with E* = G / (1 - nu): a = sqrt(R delta), N = (4/3) E* sqrt(R) delta^{3/2}, p0 = 2
  // E* a / (pi R).
  const double radius = 0.3, approach = 50e-6;
  const double stiffness = test::steel.shear_modulus / (1.0 - test::steel.poisson);
  const HertzEllipse ellipse =
      hertz_ellipse(0.5 / radius, 0.5 / radius, approach, test::steel.normal_compliance());
  const double a = std::sqrt(radius * approach);
  EXPECT_NEAR(ellipse.a, a, 1e-13 * a);
  EXPECT_NEAR(ellipse.b, a, 1e-13 * a);
  const double force = 4.0 / 3.0 * stiffness * a * approach;
  EXPECT_NEAR(ellipse.normal_force, force, 1e-12 * force);
  const double peak = 2.0 * stiffness * a / (pi * radius);
  EXPECT_NEAR(ellipse.peak, peak, 1e-12 * peak);
}

TEST(Hertz, FindsTheApproachOfALoadAndBack) {
  const test::OwnedGap gap = test::elliptic_gap(1.1, 0.4, 25e-3);
  test::StripMemory owned(60);
  NormalSolution loaded, pressed;
  ASSERT_EQ(solve_hertz(test::under_load(gap, 80e3), owned.strips, loaded).status, WRC_OK);
  EXPECT_NEAR(loaded.normal_force, 80e3, 80e3 * 1e-9);
  EXPECT_LE(loaded.iterations, 7);
  EXPECT_NEAR(patch::totals(owned.strips).normal_force, 80e3, 80e3 * 1e-8);
  ASSERT_EQ(solve_hertz(test::under_approach(gap, loaded.approach), owned.strips, pressed).status, WRC_OK);
  EXPECT_NEAR(pressed.normal_force, 80e3, 80e3 * 1e-8);
  // N ~ delta^{3/2}, so dN/d(delta) = 1.5 N / delta.
  const double stiffness = 1.5 * loaded.normal_force / loaded.approach;
  EXPECT_NEAR(loaded.stiffness, stiffness, 2e-3 * stiffness);
  EXPECT_NEAR(pressed.stiffness, stiffness, 2e-3 * stiffness);
}

TEST(Hertz, DoesNotFlickerOnCurvatureSteps) {
  // Load rising in steps of 0.1 %: area must rise with it, by about (2/3) 0.1 % each time.
  const test::OwnedGap gap = test::s1002_on_uic60();
  test::StripMemory owned(60);
  double previous = 0.0;
  for (double load = 60e3; load < 100e3; load *= 1.001) {
    NormalSolution solution;
    ASSERT_EQ(solve_hertz(test::under_load(gap, load), owned.strips, solution).status, WRC_OK);
    if (previous > 0.0) {
      EXPECT_NEAR(solution.area / previous, 1.001, 0.002);
    }
    previous = solution.area;
  }
}

}  // namespace
}  // namespace wrc::normal
