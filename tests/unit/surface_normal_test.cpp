#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "base/instruction_set.hpp"
#include "base/number.hpp"
#include "kernels/kernels.hpp"
#include "normal/elasticity/hertz_theory.hpp"
#include "normal_gaps.hpp"
#include "surface/pressure/pressure.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc {
namespace {

/// A flat rail's strips under a gap A x'^2 + B y'^2 whose axes are turned by an angle.
struct TurnedGap {
  static constexpr double width = 0.25e-3;
  std::vector<std::int32_t> strip;
  std::vector<double> place, widths, depth, curvature, middle, none, one;

  TurnedGap(double A, double B, double angle, double approach) {
    const double c = std::cos(angle), s = std::sin(angle);
    const double xx = A * c * c + B * s * s, xy = 2.0 * (A - B) * c * s, yy = A * s * s + B * c * c;
    for (int i = -120; i <= 120; ++i) {
      const double y = i * width, overlap = approach - (yy - xy * xy / (4.0 * xx)) * y * y;
      if (overlap <= 0.0) continue;
      strip.push_back(static_cast<std::int32_t>(strip.size()));
      place.push_back(y);
      widths.push_back(width);
      depth.push_back(overlap);
      curvature.push_back(2.0 * xx);
      middle.push_back(-xy * y / (2.0 * xx));
      none.push_back(0.0);
      one.push_back(1.0);
    }
  }

  std::vector<double> length_squared, peak_per_length, centre, line_load;

  PressureResult solve(double compliance) {
    start = {};
    return solve_from_start(compliance);
  }

  PressureStart start;
  std::vector<double> L, shift, deep;

  PressureResult solve_from_start(double compliance, const PressureOptions& options = {}) {
    static const auto influence = [] {
      auto made = std::make_unique<InfluenceTables>();
      tabulate(*made);
      return made;
    }();
    const std::size_t n = strip.size();
    const auto count = static_cast<std::int32_t>(n);
    RailStrips rail;
    rail.count = count;
    rail.s = place.data();
    rail.width = widths.data();
    Overlaps overlaps;
    overlaps.capacity = overlaps.count = count;
    overlaps.strip = strip.data();
    overlaps.depth = depth.data();
    overlaps.curvature = curvature.data();
    overlaps.centre = middle.data();
    overlaps.ny = none.data();
    overlaps.nz = one.data();
    for (auto* a : {&length_squared, &peak_per_length, &centre, &line_load}) a->assign(n, 0.0);
    std::vector<double> workspace(static_cast<std::size_t>(pressure_doubles(count)));
    for (auto* a : {&L, &shift, &deep}) a->resize(n);
    start = {L.data(), shift.data(), deep.data(), start.set, start.extrapolated};
    const PressureModel model{*influence, kernels_for(best_instruction_set()), compliance};
    return solve_pressure(model, rail, overlaps, options, workspace.data(), start,
                          {length_squared.data(), peak_per_length.data(), centre.data(), line_load.data()});
  }
};

// Hertz's ellipse is a semi-ellipse along whatever strips it is cut into.
TEST(SurfaceNormal, HertzsEllipseLiesAskewToTheStrips) {
  const double compliance = test::steel.normal_compliance(), approach = 60e-6;
  for (const double ratio : {0.15, 0.4, 3.0})
    for (const double degrees : {0.0, 10.0, 30.0, 60.0}) {
      SCOPED_TRACE(testing::Message() << "A / B " << ratio << ", " << degrees << " degrees");
      const double A = 1.2, B = A / ratio;
      const HertzEllipse hertz = hertz_ellipse(A, B, approach, compliance);
      TurnedGap gap(A, B, degrees * pi / 180.0, approach);
      ASSERT_TRUE(gap.solve(compliance).converged);
      double load = 0.0, moment = 0.0, peak = 0.0;
      for (std::size_t i = 0; i < gap.place.size(); ++i) {
        const double N = 0.5 * pi * TurnedGap::width * gap.line_load[i];
        load += N;
        moment += N * gap.centre[i] * gap.place[i];
        peak = std::fmax(peak, gap.peak_per_length[i] * std::sqrt(gap.length_squared[i]));
      }
      EXPECT_NEAR(load, hertz.normal_force, 2e-3 * hertz.normal_force);
      // levels are means over 0.75 mm, a quarter of the narrowest half ellipse
      EXPECT_NEAR(peak, hertz.peak, 1e-2 * hertz.peak);
      // mean of x y over its pressure
      const double a2 = hertz.a * hertz.a, b2 = hertz.b * hertz.b, angle = degrees * pi / 180.0;
      const double product = 0.2 * (a2 - b2) * std::sin(angle) * std::cos(angle);
      EXPECT_NEAR(moment / load, product, 2e-2 * std::fmax(a2, b2) / 5.0);
    }
}

// Least squares, solved as the two equations that its definition gives; 0 where nothing is within reach.
TEST(SurfaceNormal, LinesGoThroughWhatIsNear) {
  constexpr int sources = 11, strips = 37;
  constexpr double reach = 4e-3, least = 1e-3;
  double source_place[sources], weight[sources], value[sources];
  for (int b = 0; b < sources; ++b) {
    source_place[b] = 0.5e-3 * b;
    weight[b] = 1.0 + std::sin(3.0 * b);
    value[b] = 2e-3 * std::cos(2.0 * b);
  }
  std::vector<double> place(64, 0.0), inverse(64, 1.0 / reach), at(64, -1.0);
  for (int i = 0; i < strips; ++i) place[static_cast<std::size_t>(i)] = 0.4e-3 * i;
  for (const InstructionSet set : {InstructionSet::baseline, best_instruction_set()}) {
    kernels_for(set).surface.near_lines(
        {strips, place.data(), inverse.data(), least, sources, source_place, weight, value, at.data()});
    for (int i = 0; i < strips; ++i) {
      SCOPED_TRACE(i);
      const double here = place[static_cast<std::size_t>(i)];
      double w = 0.0, wy = 0.0, wyy = 0.0, wv = 0.0, wyv = 0.0;
      for (int b = 0; b < sources; ++b) {
        const double y = (source_place[b] - here) / reach;
        if (std::fabs(y) >= 1.0) continue;
        const double k = std::pow(1.0 - y * y, 3.0) * weight[b];
        w += k;
        wy += k * y;
        wyy += k * y * y;
        wv += k * value[b];
        wyv += k * y * value[b];
      }
      wyy += least * w;  // a slope costs that much
      const double wanted = w > 0.0 ? (wyy * wv - wy * wyv) / (w * wyy - wy * wy) : 0.0;
      EXPECT_NEAR(at[static_cast<std::size_t>(i)], wanted, 1e-9 * std::fabs(wanted) + 1e-15);
    }
  }
  EXPECT_EQ(at[strips - 1], 0.0);
}

// Lowered and moved along the rail at once, by what a wheel does in a millisecond or two.
TEST(SurfaceNormal, AWarmStartFollowsItsOverlaps) {
  const double compliance = test::steel.normal_compliance(), A = 1.0, B = 1.5;
  constexpr struct {
    double deeper, aside, left;  // [m], [m], of what moves otherwise: strips at the rim enter and leave
  } motions[] = {{2e-6, 0.0, 0.15}, {-2e-6, 0.0, 0.15}, {0.0, 50e-6, 0.4}, {1e-6, -50e-6, 0.25}};
  for (const auto& motion : motions) {
    SCOPED_TRACE(testing::Message() << motion.deeper << " m deeper, " << motion.aside << " m aside");
    enum { anew, as_before, followed, ways };
    double load[ways], moved[ways];
    for (const int way : {anew, as_before, followed}) {
      TurnedGap gap(A, B, 0.0, 60e-6);
      ASSERT_TRUE(gap.solve(compliance).converged);
      for (std::size_t i = 0; i < gap.depth.size(); ++i)
        gap.depth[i] += motion.deeper + 2.0 * B * motion.aside * gap.place[i];
      gap.start.set = way != anew;
      gap.start.extrapolated = way == as_before;
      const TurnedGap before = gap;
      ASSERT_TRUE(gap.solve_from_start(compliance).converged);
      load[way] = 0.0;
      for (const double q : gap.line_load) load[way] += q;
      // part of the area that the first sweep moves: the largest at which that is not the last one
      moved[way] = 1.0;
      for (TurnedGap again = before;; again = before, moved[way] *= 0.9)
        if (again.solve_from_start(compliance, {.tolerance = moved[way]}).iterations > 1) break;
    }
    std::printf("first sweep moves %.4f, without %.4f\n", moved[followed], moved[as_before]);
    EXPECT_LT(moved[followed], motion.left * moved[as_before]);
    for (const int way : {as_before, followed}) EXPECT_NEAR(load[way], load[anew], 1e-7 * load[anew]);
  }
}

}  // namespace
}  // namespace wrc
