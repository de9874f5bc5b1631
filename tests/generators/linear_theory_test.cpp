#include "linear_theory/linear_theory.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "halfspace/tangential.hpp"
#include "linear_theory/ellipse_linear_theory.hpp"
#include "patch/material.hpp"
#include "sdec_pressure.hpp"

namespace wrc::halfspace {
namespace {

// Kalker's asymptotes (1967), which know nothing of either method here.
TEST(EllipseLinearTheory, TendsToTheAsymptotesOfNarrowEllipses) {
  for (const double nu : {0.0, 0.25, 0.5}) {
    const double g = 0.01;
    const LinearCoefficients c = ellipse_linear_coefficients(g, nu, 40);
    EXPECT_NEAR(c.c11 / (pi * pi / (4.0 * (1.0 - nu))), 1.0, 1e-3) << nu;
    EXPECT_NEAR(c.c22 / (pi * pi / 4.0), 1.0, 1e-3) << nu;
    const double c23 = pi * std::sqrt(g) / (3.0 * (1.0 - nu)) * (1.0 + nu * (std::log(16.0 / g) - 5.0));
    EXPECT_NEAR(c.c23 / c23, 1.0, 2e-3) << nu;
  }
}

TEST(EllipseLinearTheory, TendsToTheAsymptotesOfWideEllipses) {
  // C23's error falls with (b/a)^2 and a logarithm. Those of C11 and C22 lack terms in 1 / ln^3(16 a^2/b^2):
  // 5 % at a/b = 10, 2 % at 100.
  for (const double nu : {0.0, 0.25, 0.5}) {
    const double g = 0.01, L = std::log(16.0 / (g * g)), D = (1.0 - nu) * L + 2.0 * nu,
                 k = 3.0 - std::log(4.0);
    const LinearCoefficients c = ellipse_linear_coefficients(1.0 / g, nu, 60);
    EXPECT_NEAR(c.c11 / (2.0 * pi / (g * (L - 2.0 * nu)) * (1.0 + k / (L - 2.0 * nu))), 1.0, 0.025) << nu;
    EXPECT_NEAR(c.c22 / (2.0 * pi / (g * D) * (1.0 + (1.0 - nu) * k / D)), 1.0, 0.025) << nu;
    EXPECT_NEAR(c.c23 / (2.0 * pi / (3.0 * std::pow(g, 1.5) * ((1.0 - nu) * L - 2.0 + 4.0 * nu))), 1.0, 3e-4)
        << nu;
  }
}

TEST(EllipseLinearTheory, ConvergesAndIsReciprocal) {
  for (const double ratio : {0.05, 1.0, 20.0}) {
    for (const double nu : {0.0, 0.25, 0.5}) {
      const LinearCoefficients c = ellipse_linear_coefficients(ratio, nu, 40),
                               half = ellipse_linear_coefficients(ratio, nu, 20);
      EXPECT_NEAR(half.c11 / c.c11, 1.0, 4e-4);
      EXPECT_NEAR(half.c22 / c.c22, 1.0, 4e-4);
      EXPECT_NEAR(half.c23 / c.c23, 1.0, 4e-4);
      EXPECT_NEAR(half.c33 / c.c33, 1.0, 4e-4);
      EXPECT_NEAR(-c.c32 / c.c23, 1.0, 1e-4);
    }
  }
}

TEST(EllipseLinearTheory, LongitudinalAndLateralAreTheSameWithoutPoissonCoupling) {
  const LinearCoefficients c = ellipse_linear_coefficients(1.7, 0.0, 20);
  EXPECT_NEAR(c.c11, c.c22, 1e-9);
}

// Two methods that share the half-space and nothing else.
TEST(StripLinearTheory, AgreesWithTheEllipseWithoutGrid) {
  for (const double ratio : {0.1, 1.0, 10.0}) {
    const LinearCoefficients exact = ellipse_linear_coefficients(ratio, 0.28, 40),
                             strips = strip_linear_coefficients(ratio, 0.0, 0.28, 16, 16);
    EXPECT_NEAR(strips.c11 / exact.c11, 1.0, 0.01) << ratio;
    EXPECT_NEAR(strips.c22 / exact.c22, 1.0, 0.01) << ratio;
    EXPECT_NEAR(0.5 * (strips.c23 - strips.c32) / exact.c23, 1.0, 0.01) << ratio;
    EXPECT_NEAR(strips.c33 / exact.c33, 1.0, 0.025) << ratio;
  }
}

TEST(StripLinearTheory, IsReciprocalAndMirrored) {
  // F_x from spin equals M_z from nu_x, F_y from spin is opposite to M_z from nu_y (Kalker 1967).
  const LinearCoefficients c = strip_linear_coefficients(0.7, 0.5, 0.28, 16, 16),
                           mirrored = strip_linear_coefficients(0.7, -0.5, 0.28, 16, 16);
  EXPECT_NEAR(c.c13 / c.c31, 1.0, 2e-3);
  EXPECT_NEAR(-c.c23 / c.c32, 1.0, 1e-2);
  EXPECT_NEAR(mirrored.c11, c.c11, 1e-9);
  EXPECT_NEAR(mirrored.c33, c.c33, 1e-9);
  EXPECT_NEAR(mirrored.c13, -c.c13, 1e-9);
}

// Two independent discretisations: Coulomb friction on a common rectangular grid, extrapolated from two
// grids, and full adhesion on strips with cells of their own.
TEST(StripLinearTheory, IsTheExactSolversAtTinyCreepage) {
  constexpr patch::Material steel{.shear_modulus = 82e9, .poisson = 0.25};
  constexpr double peak = 1e9, friction = 0.3, area = 24e-6;  // area: c^2 = a b
  const SdecPatch patch{.a = 4e-3, .b = 6e-3, .psi = 0.3};
  const double load = 2.0 / 3.0 * pi * area * peak,
               nu = 1e-3 * friction * load / (steel.shear_modulus * area);
  const auto force = [&](int n) {
    const Grid grid = grid_over(patch, n, n);
    RollingProblem problem;
    problem.pressure = sdec_pressure(patch, peak, grid, CellPressure::mean);
    problem.friction = {friction};
    problem.creepage = {.longitudinal = nu};
    return RollingSolver(grid, steel).solve(problem).forces.fx;
  };
  const LinearCoefficients c = strip_linear_coefficients(4.0 / 6.0, 0.3, steel.poisson, 16, 16);
  const double fx = 2.0 * force(48) - force(24);
  EXPECT_NEAR(fx / (-steel.shear_modulus * area * c.c11 * nu), 1.0, 0.01);
}

}  // namespace
}  // namespace wrc::halfspace
