// make_curve() and cut_rail() on shapes whose curves and strips are known in closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/elementary.hpp"
#include "cut_into.hpp"
#include "surface/geometry/rail_strips.hpp"

namespace wrc::surface {
namespace {

/// A curve through given points, with its memory.
struct MadeCurve {
  std::vector<double> y, z, memory;
  Curve curve;
  Fault fault;

  void make() {
    const auto points = static_cast<std::int32_t>(y.size());
    const CurveArrays arrays = cut_into(memory, [&](Arena& arena) { return cut_curve(arena, points); });
    fault = make_curve(points, y.data(), z.data(), arrays, curve);
  }
};

/// An arc of a circle about (0, radius), seen from above, `spacing` from point to point.
MadeCurve arc(double radius, double half_length, double spacing) {
  MadeCurve c;
  const int n = static_cast<int>(std::lround(half_length / spacing));
  for (int i = -n; i <= n; ++i) {
    const double angle = i * spacing / radius;
    c.y.push_back(radius * std::sin(angle));
    c.z.push_back(radius * (1.0 - std::cos(angle)));
  }
  c.make();
  return c;
}

TEST(Curve, ALineIsItselfAndCutIntoPiecesOfHalfAMillimetre) {
  MadeCurve c;
  for (int i = 0; i < 12; ++i) {
    c.y.push_back(0.54e-3 * i);
    c.z.push_back(0.72e-3 * i);
  }
  c.make();
  ASSERT_FALSE(c.fault.failed());
  EXPECT_EQ(c.curve.pieces, 22);
  EXPECT_NEAR(c.curve.s[c.curve.pieces], 9.9e-3, 1e-17);
  for (int i = 0; i <= 100; ++i) {
    const double s = 9.9e-3 * i / 100;
    const std::int32_t k = piece_of(c.curve, s);
    const CurvePoint p = evaluate(c.curve, k, s - c.curve.s[k]);
    EXPECT_NEAR(p.y, 0.6 * s, 1e-16);
    EXPECT_NEAR(p.z, 0.8 * s, 1e-16);
    EXPECT_NEAR(p.dy, 0.6, 1e-13);
    EXPECT_NEAR(p.dz, 0.8, 1e-13);
    EXPECT_NEAR(p.ddy, 0.0, 1e-9);
    EXPECT_NEAR(p.ddz, 0.0, 1e-9);
  }
}

// The spline's error is of fourth order in the spacing, and natural ends are forgotten after some points.
TEST(Curve, AnArcKeepsItsRadiusAndCurvature) {
  constexpr double radius = 13e-3, half = 8e-3;
  double before = 0.0;
  for (const double spacing : {0.8e-3, 0.4e-3, 0.2e-3}) {
    const MadeCurve c = arc(radius, half, spacing);
    ASSERT_FALSE(c.fault.failed());
    double worst = 0.0, worst_curvature = 0.0;
    for (int i = -100; i <= 100; ++i) {
      const double s = 0.5 * c.curve.s[c.curve.pieces] + 2e-3 * i / 100;
      const std::int32_t k = piece_of(c.curve, s);
      const CurvePoint p = evaluate(c.curve, k, s - c.curve.s[k]);
      worst = std::max(worst, std::abs(std::hypot(p.y, p.z - radius) - radius));
      const double speed = std::hypot(p.dy, p.dz);
      const double curvature = (p.dy * p.ddz - p.dz * p.ddy) / (speed * speed * speed);
      worst_curvature = std::max(worst_curvature, std::abs(curvature * radius - 1.0));
    }
    EXPECT_LT(worst, 0.02 * std::pow(spacing, 4) / std::pow(radius, 3)) << spacing;
    EXPECT_LT(worst_curvature, 0.2 * spacing * spacing / (radius * radius)) << spacing;
    if (before > 0.0) {
      EXPECT_LT(worst, before / 12.0) << spacing;
    }
    before = worst;
  }
}

TEST(Curve, PiecesJoinWithBothDerivatives) {
  MadeCurve c;
  for (int i = 0; i < 30; ++i) {
    c.y.push_back(1.1e-3 * i);
    c.z.push_back(2e-3 * std::sin(0.2 * i) * std::sin(0.31 * i));
  }
  c.make();
  ASSERT_FALSE(c.fault.failed());
  for (std::int32_t k = 0; k + 1 < c.curve.pieces; ++k) {
    const double length = c.curve.s[k + 1] - c.curve.s[k];
    ASSERT_GT(length, 0.0);
    ASSERT_LE(length, 0.5e-3 * (1.0 + 1e-12));
    const CurvePoint a = evaluate(c.curve, k, length), b = evaluate(c.curve, k + 1, 0.0);
    EXPECT_NEAR(a.y, b.y, 1e-16);
    EXPECT_NEAR(a.z, b.z, 1e-16);
    EXPECT_NEAR(a.dy, b.dy, 1e-12);
    EXPECT_NEAR(a.dz, b.dz, 1e-12);
    EXPECT_NEAR(a.ddz, b.ddz, 1e-8);
  }
  // outside, the first and the last piece go on
  EXPECT_EQ(piece_of(c.curve, -1.0), 0);
  EXPECT_EQ(piece_of(c.curve, 1.0), c.curve.pieces - 1);
}

TEST(Curve, PointsNearerThanFiftyMicrometresAreLeftOut) {
  const MadeCurve plain = arc(0.05, 5e-3, 1e-3);
  MadeCurve crowded;
  for (std::size_t i = 0; i < plain.y.size(); ++i) {
    crowded.y.push_back(plain.y[i]);
    crowded.z.push_back(plain.z[i]);
    crowded.y.push_back(plain.y[i] + 40e-6);
    crowded.z.push_back(plain.z[i] + 20e-6);
  }
  crowded.make();
  ASSERT_EQ(crowded.curve.pieces, plain.curve.pieces);
  for (std::int32_t k = 0; k < plain.curve.pieces; ++k)
    for (int d = 0; d < 4; ++d) {
      ASSERT_EQ(crowded.curve.y[d][k], plain.curve.y[d][k]);
      ASSERT_EQ(crowded.curve.z[d][k], plain.curve.z[d][k]);
    }
  MadeCurve few;
  few.y = {0.0, 1e-3, 1.04e-3, 2e-3};
  few.z = {0.0, 0.0, 0.0, 0.0};
  few.make();
  EXPECT_EQ(few.fault.status, WRC_ERROR_PROFILE);
}

/// A curve cut into at most so many strips.
struct CutRail {
  std::vector<double> memory;
  RailStrips strips;

  CutRail(const Curve& curve, std::int32_t most, const StripWidths& widths = {}) {
    strips = cut_rail(curve, widths, most,
                      cut_into(memory, [&](Arena& arena) { return cut_strips(arena, most); }));
  }
};

void expect_side_by_side(const RailStrips& strips, double end) {
  double at = 0.0;
  for (std::int32_t j = 0; j < strips.count; ++j) {
    EXPECT_NEAR(strips.s[j] - 0.5 * strips.width[j], at, 1e-15);
    at = strips.s[j] + 0.5 * strips.width[j];
  }
  EXPECT_NEAR(at, end, 1e-15);
}

// Widths by the radius: 0.25 mm up to 20 mm, 0.5 mm from 60 mm on, linear between.
TEST(RailStrips, WidthsFollowTheRadius) {
  for (const double radius : {0.013, 0.019, 0.030, 0.040, 0.059, 0.3}) {
    // the radius seen over 6 mm of arc, whose ends differ in direction by 6 mm / radius
    const double seen = 6e-3 / std::sin(6e-3 / radius);
    const double width = 0.25e-3 * (1.0 + std::clamp((seen - 0.020) / 0.040, 0.0, 1.0));
    const MadeCurve c = arc(radius, 10e-3, 0.25e-3);
    const CutRail cut(c.curve, 256);
    expect_side_by_side(cut.strips, c.curve.s[c.curve.pieces]);
    // within 3 mm of the ends the mean radius is that of half the arc only
    std::int32_t middles = 0;
    for (std::int32_t j = 0; j < cut.strips.count; ++j) {
      if (std::abs(cut.strips.y[j]) > 5e-3) continue;
      ++middles;
      EXPECT_NEAR(cut.strips.width[j], width, 2e-3 * width) << radius << " " << j;
    }
    EXPECT_GT(middles, 15);
  }
}

TEST(RailStrips, MiddlesLieOnTheCurveWithItsTangents) {
  constexpr double radius = 0.03;
  const MadeCurve c = arc(radius, 15e-3, 0.25e-3);
  const CutRail cut(c.curve, 256);
  const RailStrips& r = cut.strips;
  ASSERT_EQ(r.ranges, 1);
  EXPECT_EQ(r.range[0].first, 0);
  EXPECT_EQ(r.range[0].count, r.count);
  double top = 1.0, left = 1.0, right = -1.0;
  for (std::int32_t j = 0; j < r.count; ++j) {
    const bool inside = std::abs(r.y[j]) < 10e-3;  // at its ends the spline is straight
    EXPECT_NEAR(std::hypot(r.y[j], r.z[j] - radius), radius, inside ? 1e-10 : 5e-8);
    EXPECT_NEAR(r.ty[j] * r.ty[j] + r.tz[j] * r.tz[j], 1.0, 1e-15);
    const double square = std::abs(r.ty[j] * r.y[j] + r.tz[j] * (r.z[j] - radius)) / radius;
    EXPECT_LT(square, inside ? 1e-8 : 2e-3);
    EXPECT_NEAR(strip_angle(r, j), std::atan2(r.tz[j], r.ty[j]), 1e-14);
    top = std::min(top, r.z[j]);
    left = std::min(left, r.y[j]);
    right = std::max(right, r.y[j]);
  }
  EXPECT_EQ(r.range[0].top, top);
  EXPECT_EQ(r.range[0].leftmost, left);
  EXPECT_EQ(r.range[0].rightmost, right);
}

// With fewer strips than the widths ask for, all are wider alike and end where the rail ends.
TEST(RailStrips, FewStripsCoverTheWholeRail) {
  const MadeCurve c = arc(0.3, 20e-3, 0.5e-3);
  for (const std::int32_t most : {7, 20, 40, 79, 200}) {
    const CutRail cut(c.curve, most);
    EXPECT_LE(cut.strips.count, most);
    EXPECT_GE(cut.strips.count, std::min(most, 80) * 8 / 10);
    expect_side_by_side(cut.strips, c.curve.s[c.curve.pieces]);
    for (std::int32_t j = 0; j + 2 < cut.strips.count; ++j)
      EXPECT_NEAR(cut.strips.width[j], cut.strips.width[j + 1], 1e-12) << most;
  }
}

TEST(RailStrips, FacesThatGuideAreCutFiner) {
  MadeCurve wall;  // falls to the field side, 84 degrees steep
  for (int i = 0; i < 40; ++i) {
    wall.y.push_back(0.1e-3 * i);
    wall.z.push_back(0.95e-3 * i);
  }
  wall.make();
  EXPECT_NEAR(CutRail(wall.curve, 512).strips.width[20], 0.5e-3, 1e-12);
  EXPECT_NEAR(CutRail(wall.curve, 512, {.guiding = guiding_width}).strips.width[50], 0.2e-3, 1e-12);
}

}  // namespace
}  // namespace wrc::surface
