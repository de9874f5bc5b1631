#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "normal/elasticity/hertz_theory.hpp"
#include "normal/strip_halfspace/strip_halfspace.hpp"
#include "normal_gaps.hpp"
#include "patch/regularise.hpp"
#include "patch/split.hpp"

namespace wrc::normal {
namespace {

using test::OwnedGap;
using test::StripMemory;

const InfluenceTables& influence() {
  static const std::unique_ptr<InfluenceTables> tables = [] {
    auto filled = std::make_unique<InfluenceTables>();
    tabulate(*filled);
    return filled;
  }();
  return *tables;
}

/// A contact's memory, and a solve with it.
struct Solver {
  explicit Solver(std::int32_t count = 60)
      : owned(count),
        scratch(static_cast<std::size_t>(strip_halfspace_workspace(count))),
        start_memory(static_cast<std::size_t>(4 * count)) {
    workspace = {scratch.data(), static_cast<std::int64_t>(scratch.size())};
    double* const block = start_memory.data();
    start = {count, 0, block, block + count, block + 2 * count, block + 3 * count};
  }
  Fault operator()(const NormalProblem& problem) {
    return solve_strip_halfspace(problem, options, influence(), workspace, start, owned.strips, solution);
  }
  Fault cold(const NormalProblem& problem) {
    start.count = 0;
    return (*this)(problem);
  }
  const patch::Strips& strips() const { return owned.strips; }

  StripMemory owned;
  std::vector<std::byte> scratch;
  std::vector<double> start_memory;
  NormalWorkspace workspace;
  StripHalfspaceStart start;
  StripHalfspaceOptions options;
  NormalSolution solution;
};

int count_patches(const patch::Strips& strips) {
  int patches = 0;
  for (std::int32_t j = 0; j < strips.count; ++patches) j = patch::patch_end(strips, j);
  return patches;
}

TEST(InfluenceTables, IsTheClosedFormOnTheMiddlePlane) {
  for (double tau = 0.004; tau < 60.0; tau *= 1.3) {
    const double k = 1.0 / std::sqrt(1.0 + tau * tau);
    const double closed = 2.0 * std::sqrt(1.0 + tau * tau) * (std::comp_ellint_1(k) - std::comp_ellint_2(k));
    EXPECT_NEAR(line_potential(tau, 0.0), closed, 1e-9 * closed) << tau;
    EXPECT_NEAR(influence().middle_plane(tau), closed, 1e-4 * closed) << tau;
    EXPECT_NEAR(influence().at(tau, 0.0), closed, 2e-3 * closed) << tau;
  }
}

TEST(InfluenceTables, TableFollowsTheQuadrature) {
  double sum = 0.0;
  int count = 0;
  for (double tau = 0.002; tau < 200.0; tau *= 1.13)
    for (double u = -0.99; u < 20.0; u += 0.1 * std::max(std::abs(u), 0.05)) {  // close to the line's end
      const double exact = line_potential(tau, 1.0 + u);
      const double error = influence().at(tau, 1.0 + u) / exact - 1.0;
      EXPECT_NEAR(error, 0.0, 1e-3) << tau << " " << 1.0 + u;
      sum += error;
      ++count;
    }
  EXPECT_NEAR(sum / count, 0.0, 1e-5);  // level: what many strips do is better than what one does
}

TEST(InfluenceTables, IsContinuous) {
  // from cell to cell and on both sides of the line's end
  for (double tau = 0.003; tau < 100.0; tau *= 2.3)
    for (double xi = 0.0; xi < 5.0; xi += 0.00917) {
      const double here = influence().at(tau, xi);
      EXPECT_NEAR(influence().at(tau, xi + 1e-9), here, 1e-7 * here) << tau << " " << xi;
    }
  for (double octave = -9.0; octave < 7.0; octave += 1.0)
    for (const double xi : {0.0, 0.3, 1.0, 1.5, 7.0}) {
      const double tau = std::exp2(octave), here = influence().at(tau, xi);
      EXPECT_NEAR(influence().at(tau * (1.0 - 1e-12), xi), here, 1e-11 * here) << tau << " " << xi;
      EXPECT_NEAR(influence().at(0.7, 1.0 + std::exp2(octave) - 0x1p-6 - 1e-12),
                  influence().at(0.7, 1.0 + std::exp2(octave) - 0x1p-6), 1e-11);
    }
}

TEST(InfluenceTables, IsThePointLoadFarAway) {
  // The line carries pi / 2.
  EXPECT_NEAR(line_potential(40.0, 30.0), pi / 2.0 / 50.0, 2e-4 * pi / 2.0 / 50.0);
}

/// Worst relative errors against Hertz for a / b = 10 .. 0.1.
struct HertzErrors {
  double peak = 0.0, area = 0.0, approach = 0.0, stiffness = 0.0;
};
HertzErrors hertz_errors(bool warm) {
  HertzErrors worst;
  Solver solve;
  for (double ratio = 0.0274; ratio < 36.6; ratio *= 1.12) {
    SCOPED_TRACE(ratio);
    const HertzEllipse hertz = hertz_ellipse(1.0, 1.0 / ratio, 60e-6, test::steel.normal_compliance());
    const OwnedGap gap = test::elliptic_gap(1.0, 1.0 / ratio, 2.5 * hertz.b, 200);  // lowest between two rows
    solve.start.count = 0;
    if (warm) {
      EXPECT_EQ(solve(test::under_load(gap, 0.95 * hertz.normal_force)).status, WRC_OK);
    }
    EXPECT_EQ(solve(test::under_load(gap, hertz.normal_force)).status, WRC_OK);
    EXPECT_NEAR(patch::totals(solve.strips()).normal_force, hertz.normal_force, 1e-9 * hertz.normal_force);
    const auto take = [](double& error, double value, double exact) {
      error = std::max(error, std::abs(value / exact - 1.0));
    };
    take(worst.peak, solve.solution.peak_pressure, hertz.peak);
    take(worst.area, solve.solution.area, pi * hertz.a * hertz.b);
    take(worst.approach, solve.solution.approach, 60e-6);
    take(worst.stiffness, solve.solution.stiffness, 1.5 * hertz.normal_force / 60e-6);
  }
  std::printf("Hertz, a / b = 10 .. 0.1, %s: worst errors peak %.3f %%, area %.3f %%, approach %.3f %%\n",
              warm ? "warm" : "cold", 100.0 * worst.peak, 100.0 * worst.area, 100.0 * worst.approach);
  return worst;
}

TEST(StripHalfspace, IsHertzOnEllipticGaps) {
  const HertzErrors cold = hertz_errors(false);
  EXPECT_LT(cold.peak, 5e-3);
  EXPECT_LT(cold.area, 5e-3);
  EXPECT_LT(cold.approach, 5e-3);
  EXPECT_LT(cold.stiffness, 0.02);
  // From a load 5 % lower the sweeps end on the other side, with half a percent of the area left to move.
  const HertzErrors warm = hertz_errors(true);
  EXPECT_LT(warm.peak, 5e-3);
  EXPECT_LT(warm.area, 1e-2);
  EXPECT_LT(warm.approach, 5e-3);
}

TEST(StripHalfspace, ConvergesWithTheStripsOnHertz) {
  const HertzEllipse hertz = hertz_ellipse(1.0, 0.5, 60e-6, test::steel.normal_compliance());
  const OwnedGap gap = test::elliptic_gap(1.0, 0.5, 2.5 * hertz.b, 401);
  double error_at_30 = 0.0;
  for (const int count : {30, 120}) {
    Solver solve(count);
    solve.options = {60, 1e-5};
    ASSERT_EQ(solve.cold(test::under_load(gap, hertz.normal_force, count)).status, WRC_OK);
    const double error = std::abs(solve.solution.approach / 60e-6 - 1.0) +
                         std::abs(solve.solution.peak_pressure / hertz.peak - 1.0);
    if (count == 30)
      error_at_30 = error;
    else
      EXPECT_LT(error, std::max(0.5 * error_at_30, 1e-3));
    EXPECT_LT(error, 1e-2);
  }
}

TEST(StripHalfspace, IsHertzOnATurnedEllipse) {
  // The same two curvatures with their axes turned: h = A x^2 + 2 C x y + B y^2. The strips' own middles lie
  // between the rows' lowest points and zero.
  const double along = 1.0, across = 3.0, approach = 60e-6;
  const HertzEllipse hertz = hertz_ellipse(along, across, approach, test::steel.normal_compliance());
  for (const double cosine : {0.995, 0.95, 0.8}) {
    SCOPED_TRACE(cosine);
    const double sine = std::sqrt(1.0 - cosine * cosine);
    const double a = along * cosine * cosine + across * sine * sine;
    const double b = along * sine * sine + across * cosine * cosine, c = (across - along) * sine * cosine;
    OwnedGap gap;
    for (int j = 0; j <= 200; ++j) {
      const double y = 2.5 * hertz.a * (0.01 * j - 1.0);
      gap.add(y, (b - c * c / a) * y * y, 2.0 * a, -c / a * y);
    }
    Solver solve;
    ASSERT_EQ(solve.cold(test::under_load(gap, hertz.normal_force)).status, WRC_OK);
    EXPECT_NEAR(solve.solution.approach, approach, 3e-3 * approach);
    EXPECT_NEAR(solve.solution.peak_pressure, hertz.peak, 1e-2 * hertz.peak);
    EXPECT_NEAR(solve.solution.area, pi * hertz.a * hertz.b, 1e-2 * pi * hertz.a * hertz.b);
    std::printf("turned, cosine %.3f: approach %+.3f %%, peak %+.3f %%, area %+.3f %%\n", cosine,
                100.0 * (solve.solution.approach / approach - 1.0),
                100.0 * (solve.solution.peak_pressure / hertz.peak - 1.0),
                100.0 * (solve.solution.area / (pi * hertz.a * hertz.b) - 1.0));
  }
}

TEST(StripHalfspace, FindsTheSecondPeakOfS1002OnUic60) {
  // CONTACT (full half-space solution, 0.1 mm cells) on this case: approach 0.06714 mm, area 175.5 mm^2, peak
  // 862 MPa on the flange side and 658 MPa on the tread, where methods of one contact condition have 600 MPa
  // in one peak.
  const OwnedGap gap = test::s1002_on_uic60();
  Solver solve;
  ASSERT_EQ(solve.cold(test::under_load(gap, 80e3)).status, WRC_OK);
  EXPECT_NEAR(solve.solution.approach, 67.14e-6, 0.005 * 67.14e-6);
  EXPECT_NEAR(solve.solution.area, 175.5e-6, 0.02 * 175.5e-6);
  EXPECT_NEAR(solve.solution.peak_pressure, 862e6, 0.02 * 862e6);
  const patch::Strips& strips = solve.strips();
  double tread = 0.0;
  for (std::int32_t j = 0; j < strips.count; ++j)
    if (strips.y[j] > -4e-3) tread = std::max(tread, strips.peak[j]);
  EXPECT_NEAR(tread, 658e6, 0.02 * 658e6);
}

TEST(StripHalfspace, GoesFromLoadToApproachAndBack) {
  const OwnedGap gap = test::s1002_on_uic60();
  Solver solve;
  solve.options = {60, 1e-5};
  for (const double load : {10e3, 80e3, 150e3}) {
    SCOPED_TRACE(load);
    ASSERT_EQ(solve.cold(test::under_load(gap, load)).status, WRC_OK);
    const double approach = solve.solution.approach, stiffness = solve.solution.stiffness;
    EXPECT_NEAR(solve.solution.normal_force, load, 1e-9 * load);
    // The strips stand a little elsewhere when the approach is given: discretisation, not convergence.
    ASSERT_EQ(solve.cold(test::under_approach(gap, approach)).status, WRC_OK);
    EXPECT_NEAR(solve.solution.normal_force, load, 3e-3 * load);
    const double before = solve.solution.normal_force;
    ASSERT_EQ(solve(test::under_approach(gap, 1.02 * approach)).status, WRC_OK);
    EXPECT_NEAR((solve.solution.normal_force - before) / (0.02 * approach), stiffness, 0.06 * stiffness);
  }
}

TEST(StripHalfspace, WarmStartAgreesWithColdInFewerSweeps) {
  const OwnedGap gap = test::s1002_on_uic60();
  Solver warm, cold;
  ASSERT_EQ(cold.cold(test::under_load(gap, 80e3)).status, WRC_OK);
  ASSERT_EQ(warm.cold(test::under_load(gap, 79e3)).status, WRC_OK);
  ASSERT_EQ(warm(test::under_load(gap, 80e3)).status, WRC_OK);
  EXPECT_LT(warm.solution.iterations, cold.solution.iterations);
  EXPECT_NEAR(warm.solution.approach, cold.solution.approach, 2e-3 * cold.solution.approach);
  EXPECT_NEAR(warm.solution.area, cold.solution.area, 1e-2 * cold.solution.area);
}

TEST(StripHalfspace, StaysPutWhenSolvedAgainAndAgain) {
  OwnedGap gap = test::s1002_on_uic60();
  for (std::size_t j = 0; j < gap.y.size(); ++j) gap.centre[j] = -0.05 * gap.y[j];
  Solver solve;
  ASSERT_EQ(solve.cold(test::under_load(gap, 80e3)).status, WRC_OK);
  const NormalSolution first = solve.solution;
  for (int n = 0; n < 300; ++n) ASSERT_EQ(solve(test::under_load(gap, 80e3)).status, WRC_OK);
  EXPECT_NEAR(solve.solution.peak_pressure, first.peak_pressure, 0.02 * first.peak_pressure);
  EXPECT_NEAR(solve.solution.area, first.area, 0.01 * first.area);
}

/// Two equal paraboloids side by side, 2 * apart from crest to crest.
OwnedGap twin_gap(double apart) {
  OwnedGap gap;
  for (int j = 0; j <= 240; ++j) {
    const double y = -30e-3 + 0.25e-3 * j;
    const double from_crest = std::abs(y) - apart;
    gap.add(y, 1.0 * from_crest * from_crest, 2.0);
  }
  return gap;
}

TEST(StripHalfspace, SpotsPushEachOtherApart) {
  // Far apart, each spot of radius a is Hertz's under half the load, lowered by the other's far field c (N/2)
  // / (2 apart).
  const double apart = 16e-3;
  const OwnedGap gap = twin_gap(apart);
  const double approach_alone = 60e-6;
  const HertzEllipse hertz = hertz_ellipse(1.0, 1.0, approach_alone, test::steel.normal_compliance());
  Solver solve(80);
  ASSERT_EQ(solve.cold(test::under_load(gap, 2.0 * hertz.normal_force, 80)).status, WRC_OK);
  EXPECT_EQ(count_patches(solve.strips()), 2);
  const double push = test::steel.normal_compliance() * hertz.normal_force / (2.0 * apart);
  EXPECT_NEAR(solve.solution.approach, approach_alone + push, 0.01 * (approach_alone + push));
  EXPECT_NEAR(solve.solution.peak_pressure, hertz.peak, 0.02 * hertz.peak);
  EXPECT_NEAR(solve.solution.area, 2.0 * pi * hertz.a * hertz.b, 0.02 * solve.solution.area);
  // A slice is a patch of its own, with half of the load.
  const patch::Strips& both = solve.strips();
  const std::int32_t border = patch::patch_end(both, 0);
  EXPECT_NEAR(patch::totals(patch::slice(both, 0, border)).normal_force, hertz.normal_force,
              1e-3 * hertz.normal_force);
}

TEST(StripHalfspace, ASpotHigherThanTheMarginIsSeen) {
  // A second spot far off, higher than the first by 0.8 to 1.05 of its approach: far from the load the
  // surface sinks by less than a tenth of that, so it touches from about 0.9 down. Both are Hertz's under
  // their shares of the approach, each lowered by the other's far field.
  const double apart = 20e-3, alone = 60e-6, compliance = test::steel.normal_compliance();
  Solver solve;
  double before = 0.0;
  for (double share = 1.05; share > 0.8; share -= 0.0025) {
    SCOPED_TRACE(share);
    OwnedGap gap;
    for (int j = 0; j <= 320; ++j) {
      const double y = (j - 80) * 0.1e-3;
      const double first = y * y, second = share * alone + (y - apart) * (y - apart);
      gap.add(y, std::min(first, second), 2.0);
    }
    NormalProblem problem = test::under_load(gap, 0.0);
    problem.prescribed = Prescribed::approach;
    problem.approach = alone;
    ASSERT_GE(solve.cold(problem).status, WRC_OK);
    double one = alone, other = 0.0;
    for (int i = 0; i < 20; ++i) {
      const double by_one = compliance * hertz_ellipse(1.0, 1.0, one, compliance).normal_force / apart;
      other = std::max(alone * (1.0 - share) - by_one, 0.0);
      one = alone - compliance * hertz_ellipse(1.0, 1.0, other, compliance).normal_force / apart;
    }
    const double expected = hertz_ellipse(1.0, 1.0, one, compliance).normal_force +
                            hertz_ellipse(1.0, 1.0, other, compliance).normal_force;
    EXPECT_NEAR(solve.solution.normal_force, expected, 5e-3 * expected);
    if (before > 0.0) {
      EXPECT_NEAR(solve.solution.normal_force, before, 5e-3 * before);
    }
    before = solve.solution.normal_force;
  }
}

TEST(StripHalfspace, SpotsMergeAndPartWithoutAJump) {
  Solver solve;
  double area = 0.0, approach = 0.0;
  int fewest = 9, most = 0;
  for (double apart = 10e-3; apart > 2e-3; apart -= 0.05e-3) {
    const OwnedGap gap = twin_gap(apart);
    ASSERT_EQ(solve(test::under_load(gap, 60e3)).status, WRC_OK) << apart;
    if (area > 0.0) {
      EXPECT_NEAR(solve.solution.area, area, 0.02 * area) << apart;
      EXPECT_NEAR(solve.solution.approach, approach, 0.02 * approach) << apart;
    }
    area = solve.solution.area;
    approach = solve.solution.approach;
    fewest = std::min(fewest, count_patches(solve.strips()));
    most = std::max(most, count_patches(solve.strips()));
  }
  EXPECT_EQ(fewest, 1);
  EXPECT_EQ(most, 2);
}

TEST(StripHalfspace, MirrorsWithTheGap) {
  for (const double skew : {0.0, -0.05}) {
    SCOPED_TRACE(skew);
    OwnedGap gap = test::s1002_on_uic60();
    for (std::size_t j = 0; j < gap.y.size(); ++j) gap.centre[j] = skew * gap.y[j];
    const OwnedGap mirror = test::mirrored(gap);
    Solver right, left;
    ASSERT_EQ(right.cold(test::under_load(gap, 80e3)).status, WRC_OK);
    ASSERT_EQ(left.cold(test::under_load(mirror, 80e3)).status, WRC_OK);
    for (int warm = 0; warm < 3; ++warm) {
      EXPECT_EQ(right.solution.iterations, left.solution.iterations);
      EXPECT_NEAR(right.solution.approach, left.solution.approach, 1e-9 * right.solution.approach);
      EXPECT_NEAR(right.solution.area, left.solution.area, 1e-9 * right.solution.area);
      for (int j = 0; j < 60; ++j) {
        EXPECT_NEAR(right.strips().peak[j], left.strips().peak[59 - j], 1e-9 * right.solution.peak_pressure);
        EXPECT_NEAR(right.strips().half_length[j], left.strips().half_length[59 - j], 1e-11);
        EXPECT_NEAR(right.strips().centre[j], left.strips().centre[59 - j], 1e-11);
        EXPECT_NEAR(right.strips().y[j], -left.strips().y[59 - j], 1e-11);
      }
      ASSERT_EQ(right(test::under_load(gap, 82e3)).status, WRC_OK);
      ASSERT_EQ(left(test::under_load(mirror, 82e3)).status, WRC_OK);
    }
  }
}

TEST(StripHalfspace, GivesABluntPatchNoSpikes) {
  // The patch ends where the gap rises like a wall: the last strips are as long as those before them. Their
  // loads once ended up on a fiftieth of their length.
  Solver solve;
  for (double wall = 3e-3; wall < 5e-3; wall += 0.02e-3) {
    OwnedGap gap;
    for (int j = 0; j <= 240; ++j) {
      const double y = -18e-3 + 0.1e-3 * j;
      gap.add(y, 0.6 * y * y + (y > wall ? 40.0 * (y - wall) * (y - wall) : 0.0), 2.0);
    }
    ASSERT_EQ(solve.cold(test::under_load(gap, 80e3)).status, WRC_OK) << wall;
    const patch::Strips& strips = solve.strips();
    for (std::int32_t j = 1; j < strips.count; ++j)
      ASSERT_LT(strips.peak[j], 1.25 * strips.peak[j - 1] + 0.2 * solve.solution.peak_pressure) << wall;
  }
}

TEST(StripHalfspace, MovesSmoothlyWithTheLoad) {
  const OwnedGap gap = test::s1002_on_uic60();
  Solver solve;
  double area = 0.0, border = 0.0;
  for (double load = 60e3; load < 100e3; load *= 1.002) {
    ASSERT_EQ(solve(test::under_load(gap, load)).status, WRC_OK) << load;
    const patch::StripTotals sum = patch::totals(solve.strips());
    if (area > 0.0) {
      EXPECT_NEAR(sum.area, area, 0.006 * area) << load;
      EXPECT_NEAR(sum.y_min, border, 0.1e-3) << load;
    }
    area = sum.area;
    border = sum.y_min;
  }
}

TEST(StripHalfspace, FollowsTheContactDownToItsLastNanometres) {
  // A heavy patch is no start for a contact about to part; the patch may lie between two rows of the gap.
  OwnedGap gap;
  for (int j = 0; j <= 80; ++j) {
    const double y = -20.2e-3 + 0.5e-3 * j;
    gap.add(y, 0.5 * y * y, 2.0);
  }
  Solver solve;
  for (const double approach : {10e-9, 100e-9, 1e-6}) {
    SCOPED_TRACE(approach);
    ASSERT_EQ(solve(test::under_load(gap, 120e3)).status, WRC_OK);
    const Fault fault = solve(test::under_approach(gap, approach));
    ASSERT_EQ(fault.status, WRC_OK);
    const HertzEllipse hertz = hertz_ellipse(1.0, 0.5, approach, test::steel.normal_compliance());
    EXPECT_NEAR(solve.solution.normal_force, hertz.normal_force, 0.02 * hertz.normal_force);
    EXPECT_NEAR(solve.solution.area, pi * hertz.a * hertz.b, 0.02 * pi * hertz.a * hertz.b);
  }
}

TEST(StripHalfspace, NamesWhatIsWrong) {
  const OwnedGap good = test::s1002_on_uic60();
  Solver solve;
  EXPECT_EQ(solve.cold(test::under_load(good, 0.0)).status, WRC_FLAG_NO_CONTACT);
  EXPECT_EQ(solve.strips().count, 0);
  EXPECT_EQ(solve.cold(test::under_load(good, -1.0)).status, WRC_ERROR_RANGE);
  EXPECT_EQ(solve.cold(test::under_load(good, NAN)).status, WRC_ERROR_NOT_FINITE);
  EXPECT_EQ(solve.cold(test::under_load(good, 1e9)).status, WRC_ERROR_LOAD);
  EXPECT_EQ(solve.cold(test::under_approach(good, 1.0)).status, WRC_ERROR_LOAD);
  EXPECT_EQ(solve.cold(test::under_load(good, 80e3, 61)).status, WRC_ERROR_BUFFER);
  solve.workspace.bytes -= 1;
  EXPECT_EQ(solve.cold(test::under_load(good, 80e3)).status, WRC_ERROR_BUFFER);
  solve.workspace.bytes += 1;

  solve.options.max_sweeps = 1;
  EXPECT_EQ(solve.cold(test::under_load(good, 80e3)).status, WRC_FLAG_ITERATION_CAP);
  EXPECT_NEAR(patch::totals(solve.strips()).normal_force, 80e3, 1e-3);
  solve.options = {};

  OwnedGap cut;
  for (std::size_t j = 30; j < good.y.size(); ++j) cut.add(good.y[j], good.height[j], good.curvature[j]);
  EXPECT_EQ(solve.cold(test::under_load(cut, 80e3)).status, WRC_FLAG_PATCH_AT_EDGE);
  EXPECT_NEAR(solve.solution.normal_force, 80e3, 1e-3);

  EXPECT_EQ(solve.cold(test::under_load(good, 80e3)).status, WRC_OK);
}

}  // namespace
}  // namespace wrc::normal
