#include "theory/generated_tables.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "linear_theory/ellipse_linear_theory.hpp"
#include "linear_theory/linear_theory.hpp"
#include "theory/sdec.hpp"
#include "unit/kalker_printed_table.hpp"

namespace wrc::theory {
namespace {

using tables::LinearTheoryEntry;

void expect_same(const LinearTheoryEntry& entry, const halfspace::LinearCoefficients& c) {
  const double computed[] = {c.c11, c.c22, c.c23, c.c13, c.c33};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(entry.value[i], computed[i], 6e-6)
        << i << " " << entry.poisson << " " << entry.ratio << " " << entry.psi;
  }
}

TEST(GeneratedTables, EllipsesAreComputedAgain) {
  for (const LinearTheoryEntry& entry : tables::linear_theory) {
    if (entry.psi != 0.0 || entry.poisson != 0.25) continue;
    // At degree 30 instead of the table's 60.
    const halfspace::LinearCoefficients c =
        halfspace::ellipse_linear_coefficients(entry.ratio, entry.poisson, 30);
    const double computed[] = {c.c11, c.c22, 0.5 * (c.c23 - c.c32), c.c13, c.c33};
    for (std::size_t i = 0; i < 5; ++i)
      EXPECT_NEAR(entry.value[i], computed[i], 1e-4 * entry.value[i]) << entry.ratio;
  }
}

TEST(GeneratedTables, ADoubleEllipseIsComputedAgain) {
#ifndef NDEBUG
  GTEST_SKIP() << "takes minutes without optimisation";
#endif
  for (const LinearTheoryEntry& entry : tables::linear_theory) {
    if (entry.poisson != 0.25 || entry.ratio != 2.0 || (entry.psi != 0.0 && entry.psi != 0.6)) continue;
    expect_same(entry, halfspace::LinearTheory(entry.ratio, entry.poisson, entry.finest).at(entry.psi).value);
  }
}

TEST(GeneratedTables, ErrorEstimatesAreSmall) {
  for (const LinearTheoryEntry& entry : tables::linear_theory) {
    const auto relative = [&](std::size_t i) { return entry.error[i] / std::fabs(entry.value[i]); };
    EXPECT_LT(relative(0), 2e-3) << entry.poisson << " " << entry.ratio << " " << entry.psi;
    EXPECT_LT(relative(1), 3e-3) << entry.poisson << " " << entry.ratio << " " << entry.psi;
    EXPECT_LT(relative(2), 5e-3) << entry.poisson << " " << entry.ratio << " " << entry.psi;
    if (entry.psi != 0.0) {
      EXPECT_LT(relative(3), entry.ratio > 5.0 ? 0.04 : 0.013) << entry.poisson << " " << entry.ratio;
    } else {
      EXPECT_EQ(entry.value[3], 0.0);
    }
  }
}

TEST(GeneratedTables, AgreeWithKalkersPrint) {
  // Within 0.7 % but for eight of 171 numbers. There the print is off, by the tests of
  // ellipse_linear_coefficients (convergence, reciprocity, strips, asymptotes).
  int outside = 0;
  for (const test::PrintedRow& row : test::kalker_printed_table) {
    for (std::size_t k = 0; k < 3; ++k) {
      Fault fault;
      const KalkerCoefficients c = KalkerTable(tables::poisson_nodes[k]).at(row.ratio, fault);
      EXPECT_EQ(fault.status, WRC_OK);
      for (const double error :
           {c.c11 / row.c11[k] - 1.0, c.c22 / row.c22[k] - 1.0, c.c23 / row.c23[k] - 1.0}) {
        outside += std::fabs(error) > 7e-3;
        EXPECT_LT(std::fabs(error), 0.012) << row.ratio << " " << tables::poisson_nodes[k];
      }
    }
  }
  EXPECT_EQ(outside, 8);
}

TEST(GeneratedTables, AreInterpolatedAsWellAsTheyAreComputed) {
  // Between the nodes in a/b at usual Poisson ratios; far from the nodes in nu the parabola costs more.
  for (const double nu : {0.0, 0.12, 0.28, 0.3, 0.4}) {
    const double tolerance = nu == 0.12 || nu == 0.4 ? 2.5e-3 : 1e-3;
    const KalkerTable table(nu);
    for (const double ratio :
         {0.06, 0.085, 0.12, 0.17, 0.25, 0.4, 0.6, 0.85, 1.2, 1.7, 2.5, 4.0, 5.8, 8.0, 12.0, 17.0}) {
      Fault fault;
      const KalkerCoefficients c = table.at(ratio, fault);
      const halfspace::LinearCoefficients exact = halfspace::ellipse_linear_coefficients(ratio, nu, 20);
      EXPECT_NEAR(c.c11 / exact.c11, 1.0, tolerance) << nu << " " << ratio;
      EXPECT_NEAR(c.c22 / exact.c22, 1.0, tolerance) << nu << " " << ratio;
      EXPECT_NEAR(c.c23 / exact.c23, 1.0, tolerance) << nu << " " << ratio;
    }
  }
}

TEST(GeneratedTables, FitsOverTheShapeNumberKeepToThem) {
  for (const LinearTheoryEntry& entry : tables::linear_theory) {
    Fault fault;
    const SdecCoefficients c = SdecTable(entry.poisson).at(entry.ratio, entry.psi, fault);
    EXPECT_EQ(fault.status, WRC_OK);
    EXPECT_NEAR(c.c11 / entry.value[0], 1.0, 3e-3) << entry.poisson << " " << entry.ratio << " " << entry.psi;
    EXPECT_NEAR(c.c22 / entry.value[1], 1.0, 3e-3) << entry.poisson << " " << entry.ratio << " " << entry.psi;
    EXPECT_NEAR(c.c23 / entry.value[2], 1.0, 3e-3) << entry.poisson << " " << entry.ratio << " " << entry.psi;
    if (entry.psi > 0.0) {
      EXPECT_NEAR(c.c13, entry.value[3], 6e-3 * std::fabs(entry.value[3]) + entry.error[3])
          << entry.poisson << " " << entry.ratio << " " << entry.psi;
    }
  }
}

}  // namespace
}  // namespace wrc::theory
