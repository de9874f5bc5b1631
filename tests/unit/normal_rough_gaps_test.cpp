// Gaps no profile should give, but a vendor's will: every method answers with a status and finite numbers, in
// bounded time.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <random>

#include "normal/methods/analyn.hpp"
#include "normal/methods/ekp.hpp"
#include "normal/methods/hertz.hpp"
#include "normal/methods/kik_piotrowski.hpp"
#include "normal/methods/stripes.hpp"
#include "normal/strip_halfspace/strip_halfspace.hpp"
#include "normal_gaps.hpp"

namespace wrc::normal {
namespace {

using test::OwnedGap;

class RoughGaps : public testing::Test {
 protected:
  static constexpr std::int32_t count = 40;
  RoughGaps()
      : influence(std::make_unique<InfluenceTables>()),
        scratch(static_cast<std::size_t>(strip_halfspace_workspace(count))),
        start_memory(4 * count),
        owned(count) {
    tabulate(*influence);
    workspace = {scratch.data(), static_cast<std::int64_t>(scratch.size())};
    double* const block = start_memory.data();
    start = {count, 0, block, block + count, block + 2 * count, block + 3 * count};
  }

  void expect_an_answer(const OwnedGap& gap, double load) {
    const auto solve_half_space = [&](const NormalProblem& p, patch::Strips& s, NormalSolution& r) {
      return solve_strip_halfspace(p, {}, *influence, workspace, start, s, r);
    };
    const std::function<Fault(const NormalProblem&, patch::Strips&, NormalSolution&)> methods[] = {
        solve_half_space,
        solve_hertz,
        solve_analyn,
        solve_stripes,
        [](const NormalProblem& p, patch::Strips& s, NormalSolution& r) { return solve_ekp(p, {}, s, r); },
        [](const NormalProblem& p, patch::Strips& s, NormalSolution& r) {
          return solve_ekp(p, {EkpScale::ellipse}, s, r);
        },
        [](const NormalProblem& p, patch::Strips& s, NormalSolution& r) {
          return solve_kik_piotrowski(p, {}, s, r);
        },
    };
    for (std::size_t m = 0; m < std::size(methods); ++m) {
      SCOPED_TRACE(m);
      NormalProblem problem = test::under_load(gap, load, count);
      problem.force_tolerance = 1e-6;
      NormalSolution solution;
      const Fault fault = methods[m](problem, owned.strips, solution);
      EXPECT_LE(solution.iterations, 60);
      if (fault.failed()) {
        EXPECT_EQ(owned.strips.count, 0);
        continue;
      }
      EXPECT_TRUE(std::isfinite(solution.approach) && std::isfinite(solution.stiffness));
      EXPECT_GT(solution.approach, 0.0);
      for (std::int32_t j = 0; j < owned.strips.count; ++j) {
        EXPECT_TRUE(std::isfinite(owned.strips.y[j]) && std::isfinite(owned.strips.centre[j]));
        EXPECT_GT(owned.strips.width[j], 0.0);
        EXPECT_GE(owned.strips.half_length[j], 0.0);
        EXPECT_LT(owned.strips.half_length[j], 1.0);
        EXPECT_GE(owned.strips.peak[j], 0.0);
        EXPECT_TRUE(std::isfinite(owned.strips.peak[j]));
      }
      if (fault.status != WRC_FLAG_ITERATION_CAP) {
        EXPECT_NEAR(patch::totals(owned.strips).normal_force, load, 1e-5 * load);
      }
    }
  }

  std::unique_ptr<InfluenceTables> influence;
  std::vector<std::byte> scratch;
  std::vector<double> start_memory;
  NormalWorkspace workspace;
  StripHalfspaceStart start;
  test::StripMemory owned;
};

TEST_F(RoughGaps, Noise) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(-1.0, 1.0);
  for (int n = 0; n < 300; ++n) {
    OwnedGap gap;
    const double amplitude = 30e-6 * (n % 10) / 10.0;
    const int rows = 4 + n % 120;
    for (int j = 0; j < rows; ++j) {
      const double y = 40e-3 * (j / (rows - 1.0) - 0.5);
      gap.add(y, 0.5 * y * y + amplitude * noise(random), 2.0 + noise(random), 2e-3 * noise(random));
    }
    SCOPED_TRACE(n);
    expect_an_answer(gap, 80e3 * std::pow(10.0, noise(random)));
  }
}

TEST_F(RoughGaps, FlatConcaveKinkedAndTilted) {
  OwnedGap flat, concave, kinked, tilted, step, everywhere_negative;
  for (int j = 0; j <= 100; ++j) {
    const double y = 0.4e-3 * (j - 50);
    flat.add(y, 0.0, 2.0);
    concave.add(y, -0.3 * y * y, 2.0);
    kinked.add(y, std::abs(y) * 0.02, 2.0);
    tilted.add(y, 0.01 * y, 2.0);
    step.add(y, y < 1e-3 ? 0.0 : 1e-3, 2.0);
    everywhere_negative.add(y, y * y - 1.0, 2.0);
  }
  for (const OwnedGap* gap : {&flat, &concave, &kinked, &tilted, &step, &everywhere_negative})
    for (const double load : {1e-3, 1.0, 1e3, 80e3, 1e6}) {
      SCOPED_TRACE(load);
      expect_an_answer(*gap, load);
    }
}

// A wall between rows that stand apart: the surface through the rows dips half a millimetre below the lowest,
// and the strips carry the load at an approach below zero. Where contact also reached the grid's end, the
// solver went on from there, on a grid widened to lengths that are no numbers.
TEST_F(RoughGaps, ADipBetweenRowsBesideAWallIsRefusedWithNumbers) {
  constexpr double micrometres[] = {12187, 11736, 493, 0,   188, 568, 961, 1221, 1297, 1224, 1073, 938, 874,
                                    860,   873,   891, 895, 883, 860, 831, 801,  775,  753,  733,  717, 702,
                                    692,   686,   687, 696, 713, 739, 773, 814,  862,  916,  977,  1045};
  OwnedGap wall;
  for (const double height : micrometres)
    wall.add(0.2714e-3 * static_cast<double>(wall.y.size()) - 0.818e-3, 1e-6 * height, 2.156);
  const OwnedGap smooth = test::elliptic_gap(1.1, 1.67, 10e-3, 8);
  for (const std::int32_t strips : {4, 5, 6, 7, 8, 10, 14, 20, 40})
    for (const double load : {1e3, 10e3, 40e3, 60e3, 70e3, 80e3, 90e3, 120e3}) {
      SCOPED_TRACE(testing::Message() << strips << " strips under " << load << " N");
      start.count = 0;
      NormalSolution solution;
      const auto solve = [&](const OwnedGap& gap) {
        return solve_strip_halfspace(test::under_load(gap, load, strips), {}, *influence, workspace, start,
                                     owned.strips, solution);
      };
      EXPECT_EQ(solve(smooth).status, WRC_OK);
      const Fault fault = solve(wall);  // from the smooth gap's solution
      EXPECT_TRUE(std::isfinite(fault.value)) << fault.field;
    }
}

}  // namespace
}  // namespace wrc::normal
