// A wheelset wandering over the rail: the half-space solver must answer at every pose, and what it answers
// must move as continuously as the contact itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "geometry/contact_search.hpp"
#include "geometry/gap_rows.hpp"
#include "geometry_test_bodies.hpp"
#include "kernels/kernels.hpp"
#include "normal/strip_halfspace/strip_halfspace.hpp"
#include "normal_gaps.hpp"
#include "overlap_weighted_point.hpp"
#include "patch/split.hpp"

namespace wrc::normal {
namespace {

/// One wheel under constant load at any pose: S1002 on UIC60, 80 kN.
class LoadedWheel {
 public:
  static constexpr std::int32_t count = 60, rows = 121;
  static constexpr double load = 80e3, typical_approach = 80e-6;

  struct Answer {
    std::int32_t status = 0;
    bool at_edge = false;
    double area = 0.0, centre = 0.0, approach = 0.0;  // centre of the load in rail coordinates [m]
    int patches = 0;
  };

  LoadedWheel()
      : influence_(std::make_unique<InfluenceTables>()),
        scratch_(static_cast<std::size_t>(strip_halfspace_workspace(count))),
        start_memory_(4 * count),
        rows_memory_(4 * rows),
        owned_(count) {
    tabulate(*influence_);
    double* const block = start_memory_.data();
    start_ = {count, 0, block, block + count, block + 2 * count, block + 3 * count};
  }
  LoadedWheel(const LoadedWheel&) = delete;
  LoadedWheel& operator=(const LoadedWheel&) = delete;

  void forget() { start_.count = 0; }

  Answer at(double lateral, double yaw) {
    geometry::ContactPoint first;
    std::int32_t found = 0;
    geometry::Pose pose{.lateral = lateral, .vertical = 0.0, .roll = 0.0, .yaw = yaw};
    if (geometry::find_contact(bodies_.rail, geometry::posed(bodies_.wheel, pose), 1, &first, found).failed())
      return {-100, false};
    pose.vertical = first.vertical_gap + typical_approach / first.cosine;
    const geometry::PosedWheel wheel = geometry::posed(bodies_.wheel, pose);
    if (geometry::find_contact(bodies_.rail, wheel, 1, &first, found).failed()) return {-101, false};
    geometry::ContactPoint contact =
        test::overlap_weighted_point(bodies_.rail, wheel, first, -first.vertical_gap);
    contact.vertical_gap = 0.0;  // the wheel stays lowered: that tilts the gap of an inclined contact
    geometry::GapLimits limits;
    limits.height = 0.25e-3;
    const geometry::GapWindow window = geometry::gap_window(bodies_.rail, wheel, contact, limits);
    double* const r = rows_memory_.data();
    NormalProblem problem = test::under_load({}, load, count);
    if (geometry::fill_gap_rows(bodies_.rail, wheel, contact, window, rows,
                                {rows, r, r + rows, r + 2 * rows, r + 3 * rows},
                                kernels_for(InstructionSet::baseline), problem.gap)
            .failed())
      return {-102, false};

    NormalWorkspace workspace{scratch_.data(), static_cast<std::int64_t>(scratch_.size())};
    NormalSolution solution;
    const Fault fault =
        solve_strip_halfspace(problem, {}, *influence_, workspace, start_, owned_.strips, solution);
    Answer answer{fault.status, fault.has(WRC_FLAG_PATCH_AT_EDGE), solution.area, 0.0, solution.approach, 0};
    const patch::Strips& strips = owned_.strips;
    for (std::int32_t j = 0; j < strips.count; ++j)
      answer.centre +=
          0.5 * pi * strips.half_length[j] * strips.peak[j] * strips.width[j] * strips.y[j] / load;
    answer.centre = contact.y_rail + contact.cosine * answer.centre;
    for (std::int32_t j = 0; j < strips.count; ++answer.patches) j = patch::patch_end(strips, j);
    return answer;
  }

 private:
  ReferenceBodies bodies_;
  std::unique_ptr<InfluenceTables> influence_;
  std::vector<std::byte> scratch_;
  std::vector<double> start_memory_, rows_memory_;
  test::StripMemory owned_;
  StripHalfspaceStart start_;
};

TEST(NormalSweep, AnswersEverywhereAndMovesWithTheContact) {
  // The measure of a jump is the second difference over three poses 0.02 mm apart: nothing for what moves
  // steadily, however fast, and the whole jump for a jump. Poses where the number of patches changes are left
  // out.
  LoadedWheel wheel;
  double worst_area = 0.0, worst_centre = 0.0, worst_approach = 0.0;
  double at_area = 0.0, at_centre = 0.0, at_approach = 0.0;
  for (int milliradians = -20; milliradians <= 20; milliradians += 5) {
    wheel.forget();
    LoadedWheel::Answer before, here;
    for (int step = 0; step <= 650; ++step) {
      const double lateral = -6e-3 + 0.02e-3 * step;
      const LoadedWheel::Answer next = wheel.at(lateral, 1e-3 * milliradians);
      ASSERT_TRUE(next.status == WRC_OK || next.at_edge)
          << "status " << next.status << " at " << lateral << " m, " << milliradians << " mrad";
      if (lateral < 6.4e-3 && step >= 2 && before.patches == next.patches && here.patches == next.patches) {
        const double area = std::abs(next.area - 2.0 * here.area + before.area) / here.area;
        const double centre = std::abs(next.centre - 2.0 * here.centre + before.centre);
        const double approach =
            std::abs(next.approach - 2.0 * here.approach + before.approach) / here.approach;
        if (area > worst_area) worst_area = area, at_area = lateral;
        if (centre > worst_centre) worst_centre = centre, at_centre = lateral;
        if (approach > worst_approach) worst_approach = approach, at_approach = lateral;
      }
      before = here;
      here = next;
    }
  }
  std::printf(
      "largest jumps: area %.2f %% at %.2f mm, centre of load %.3f mm at %.2f mm, approach %.2f %% at %.2f "
      "mm\n",
      100 * worst_area, 1e3 * at_area, 1e3 * worst_centre, 1e3 * at_centre, 100 * worst_approach,
      1e3 * at_approach);
  EXPECT_LT(worst_area, 0.05);
  EXPECT_LT(worst_centre, 0.1e-3);
  // The approach counts from first touch: it bends where another spot becomes the lowest, about 5.1 mm.
  EXPECT_LT(worst_approach, 0.06);
}

}  // namespace
}  // namespace wrc::normal
