#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "cut_into.hpp"
#include "surface/geometry/out_of_round.hpp"
#include "surface/geometry/varying_rail.hpp"

namespace wrc::surface {
namespace {

/// A rail of circular arcs that become sharper along the track and wander aside.
struct SectionsOfArcs {
  static constexpr std::int32_t sections = 4, nodes = 41, most = 128;
  std::vector<double> y[sections], z[sections], memory;
  VaryingRail rail;

  SectionsOfArcs() {
    RailSection section[sections];
    for (std::int32_t k = 0; k < sections; ++k) {
      const double radius = 0.3 - 0.02 * k;
      for (std::int32_t i = 0; i < nodes; ++i) {
        y[k].push_back(1e-3 * (i - nodes / 2));
        z[k].push_back(radius - std::sqrt(radius * radius - y[k].back() * y[k].back()));
      }
      section[k] = {.distance = 1.0 + 0.7 * k,
                    .y = 1e-3 * k * k,
                    .z = -2e-3 * k,
                    .profile = {nodes, y[k].data(), z[k].data()}};
    }
    const VaryingRailArrays arrays =
        cut_into(memory, [](Arena& arena) { return cut_varying_rail(arena, sections, nodes, most); });
    EXPECT_FALSE(make_varying_rail(section, sections, 0.025, {}, most, arrays, rail).failed());
  }
};

// Strips placed by the kernels of each instruction set: the same bits, and those of the formulas of one
// strip.
TEST(VaryingRail, StripsArePlacedAsTheirFormulasSay) {
  constexpr double wheel_radius = 0.46;
  const SectionsOfArcs arcs;
  for (int n = 0; n < 40; ++n) {
    const double distance = 1.0 + 2.09 * n / 39;
    std::vector<double> baseline;
    for (InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
      if (set > best_instruction_set()) continue;
      std::vector<double> placed;
      const StripArrays arrays =
          cut_into(placed, [](Arena& arena) { return cut_varying_strips(arena, SectionsOfArcs::most); });
      const PlacedRail strips = place_strips(kernels_for(set), arcs.rail, distance, arrays);
      std::vector<double> gain(static_cast<std::size_t>(strips.count));
      find_gains(kernels_for(set), arcs.rail, wheel_radius, strips, gain.data());
      ASSERT_GT(strips.count, 20);
      std::vector<double> all = placed;
      all.insert(all.end(), gain.begin(), gain.end());
      if (baseline.empty()) baseline = all;
      ASSERT_EQ(std::memcmp(baseline.data(), all.data(), all.size() * sizeof(double)), 0) << distance;
      for (std::int32_t j = 0; j < strips.count; ++j) {
        const auto here = strip_at(arcs.rail, strips.blend[0], j, distance);
        double ty = 0.0, tz = 0.0;
        tangent_at(arcs.rail, strips.blend[0], j, distance, ty, tz);
        ASSERT_EQ(strips.y[j], here.y);
        ASSERT_EQ(strips.z[j], here.z);
        ASSERT_NEAR(strips.ty[j], ty, 1e-15);
        ASSERT_NEAR(strips.tz[j], tz, 1e-15);
        // places along the track are those of the formulas, and no overlap gains more there than is said
        for (const PlaceWeights& place : strips.place[0]) {
          const double x = distance + place.x;
          const auto there = strip_at(arcs.rail, blend_at(arcs.rail, arcs.rail.face[0], x), j, x);
          ASSERT_NEAR(place_of(arcs.rail, place, j, 0), there.y, 1e-15);
          ASSERT_NEAR(place_of(arcs.rail, place, j, 1), there.z, 1e-15);
          const double rise = tz * (there.y - here.y) - ty * (there.z - here.z);
          ASSERT_GE(gain[static_cast<std::size_t>(j)] + 1e-9,
                    rise - 0.5 * ty * place.x * place.x / wheel_radius);
        }
      }
    }
  }
}

TEST(VaryingRail, BlendsNearAnotherAreTheSameBits) {
  const SectionsOfArcs arcs;
  const RailFace& face = arcs.rail.face[0];
  for (int n = -5; n < 50; ++n)
    for (int m = -5; m < 50; ++m) {
      const double distance = 1.0 + 2.1 * n / 42, near = 1.0 + 2.1 * m / 42;
      const SectionBlend plain = blend_at(arcs.rail, face, distance),
                         hinted = blend_at(arcs.rail, face, distance, blend_at(arcs.rail, face, near));
      ASSERT_EQ(plain.left, hinted.left) << distance << " " << near;
      ASSERT_EQ(plain.right, hinted.right);
      ASSERT_EQ(std::memcmp(plain.weight, hinted.weight, sizeof plain.weight), 0);
    }
}

// A chord of 0.5 mm, its ends given: the wheel stands on one of them, r (1 - cos) lower, and goes over from
// one to the other in the middle, wherever that lies between the angles tabulated.
TEST(OutOfRound, ReachOfAChordIsThatOfItsEnds) {
  constexpr double radius = 0.46, deep = 0.5e-3, turn = 2.0 * pi;
  constexpr std::int32_t count = 19999;
  const double half = std::acos(1.0 - deep / radius);
  for (const double middle :
       {0.0, 1.0 + 0.25 * turn / OutOfRound::nodes, 1.0 + 0.5 * turn / OutOfRound::nodes}) {
    std::vector<double> angle, deviation;
    for (std::int32_t i = 0; i <= count; ++i) angle.push_back(turn * i / count);
    for (const double side : {-half, half}) {
      const double edge = middle + side;
      angle[static_cast<std::size_t>(std::lround((edge < 0.0 ? edge + turn : edge) / turn * count))] =
          edge < 0.0 ? edge + turn : edge;
    }
    for (const double at : angle) {
      const double from = at - middle - turn * std::round((at - middle) / turn);
      deviation.push_back(std::abs(from) < half ? radius * (std::cos(half) / std::cos(from) - 1.0) : 0.0);
    }
    const RadiusTable table{count + 1, 1, angle.data(), nullptr, deviation.data()};
    std::vector<double> memory;
    const OutOfRound wheel = make_out_of_round(
        table, radius, cut_into(memory, [&](Arena& arena) { return cut_out_of_round(arena, table); }));
    for (int i = -6000; i <= 6000; ++i) {
      const double from = 1e-5 * i, beside = std::abs(from);
      const double exact = beside < half ? radius * (std::cos(half - beside) - 1.0) : 0.0;
      ASSERT_NEAR(reach_at(wheel, 0.0, middle + from).depth, exact, 2e-6) << middle << " " << from;
    }
  }
}

// Rows of an eccentric wheel that is eccentric by more from row to row: between rows on a line the deviation
// lies on it, and at a row where the line bends it is continuously differentiable.
TEST(OutOfRound, RowsOnALineStayOneAndNothingIsKinked) {
  constexpr std::int32_t count = 720, rows = 5;
  const double y[rows] = {-0.02, -0.015, -0.008, 0.0, 0.01};
  const double size[rows] = {1e-4, 1.5e-4, 2.2e-4, 3e-4, 3e-4};
  std::vector<double> angle, deviation;
  for (std::int32_t i = 0; i <= count; ++i) angle.push_back(2.0 * pi * i / count);
  for (const double each : size)
    for (std::int32_t i = 0; i <= count; ++i) deviation.push_back(each * std::cos(angle[i % count]));
  const RadiusTable table{count + 1, rows, angle.data(), y, deviation.data()};
  std::vector<double> memory;
  const OutOfRound wheel = make_out_of_round(
      table, 0.46, cut_into(memory, [&](Arena& arena) { return cut_out_of_round(arena, table); }));
  const double turned = 0.4;
  const auto at = [&](double where) { return reach_at(wheel, where, turned); };
  for (double where = -0.02; where < -0.008; where += 0.3e-3)
    EXPECT_NEAR(at(where).depth, (1e-4 + 0.01 * (where + 0.02)) * std::cos(turned), 2e-8) << where;
  constexpr double h = 1e-7;
  for (const double row : {-0.015, -0.008, 0.0}) {
    const double left = (at(row).depth - at(row - h).depth) / h,
                 right = (at(row + h).depth - at(row).depth) / h;
    EXPECT_NEAR(left, right, 1e-6) << row;
  }
  for (double where = 0.0; where < 0.01; where += 0.3e-3)
    EXPECT_LE(at(where).depth, at(0.01).depth + 1e-12) << where;
  for (const double where : {-0.0175, -0.01, -0.004, 0.003})
    EXPECT_NEAR(
        (reach_at(wheel, where, turned + h).depth - reach_at(wheel, where, turned - h).depth) / (2.0 * h),
        at(where).slope, 1e-8);
}

}  // namespace
}  // namespace wrc::surface
