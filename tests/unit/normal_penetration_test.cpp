// The Kik-Piotrowski family: what it must share with Hertz, and what a gap may do to it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>

#include "normal/elasticity/contact_condition.hpp"
#include "normal/elasticity/elliptic_integrals.hpp"
#include "normal/elasticity/hertz_theory.hpp"
#include "normal/methods/ekp.hpp"
#include "normal/methods/kik_piotrowski.hpp"
#include "normal/penetration/penetration.hpp"
#include "normal_gaps.hpp"
#include "patch/regularise.hpp"

namespace wrc::normal {
namespace {

using test::OwnedGap;
using test::StripMemory;

struct Method {
  const char* name;
  std::function<Fault(const NormalProblem&, patch::Strips&, NormalSolution&)> solve;
};

const Method methods[] = {
    {"Kik-Piotrowski", [](const NormalProblem& p, patch::Strips& s,
                          NormalSolution& r) { return solve_kik_piotrowski(p, {}, s, r); }},
    {"EKP, area", [](const NormalProblem& p, patch::Strips& s,
                     NormalSolution& r) { return solve_ekp(p, {EkpScale::area}, s, r); }},
    {"EKP, ellipse", [](const NormalProblem& p, patch::Strips& s,
                        NormalSolution& r) { return solve_ekp(p, {EkpScale::ellipse}, s, r); }},
};

TEST(StripDisplacement, AddsUpOverAnyDivision) {
  // One strip from -0.2 to 1 mm is the sum of its parts, however they cut the singularity. 256 parts stand
  // for the integral; a part of 0.3 mm beside a strip of 4 mm is what methods use.
  const double l = 4e-3;
  double fine = 0.0;
  for (int i = 0; i < 256; ++i)
    fine += strip_displacement(l, -0.2e-3 + 1.2e-3 / 256 * i, -0.2e-3 + 1.2e-3 / 256 * (i + 1));
  for (const int parts : {1, 2, 3, 4, 7}) {
    double sum = 0.0;
    for (int i = 0; i < parts; ++i)
      sum += strip_displacement(l, -0.2e-3 + 1.2e-3 / parts * i, -0.2e-3 + 1.2e-3 / parts * (i + 1));
    EXPECT_NEAR(sum, fine, 2.5e-3 / (parts * parts) * fine) << parts;
  }
}

TEST(LineDisplacement, TableFollowsTheClosedForm) {
  for (double tau = 1e-3; tau < 3e3; tau *= 1.07) {
    const double r = std::sqrt(1.0 + tau * tau);
    const double closed = 2.0 * complete_elliptic(tau / r).d / r;
    EXPECT_NEAR(line_displacement(1.0, tau), closed, 1e-6 * closed) << tau;
    EXPECT_EQ(line_displacement(1.0, -tau), line_displacement(1.0, tau));
  }
}

TEST(StripDisplacement, IsTheClosedFormAwayFromTheOrigin) {
  // 2 sqrt(l^2 + y^2) (K - E) / l, and pi l / (2 y) far away.
  const double l = 4e-3, y = 6e-3, width = 1e-6;
  const double k = l / std::sqrt(l * l + y * y);
  const double line = 2.0 * std::sqrt(l * l + y * y) * (std::comp_ellint_1(k) - std::comp_ellint_2(k)) / l;
  EXPECT_NEAR(strip_displacement(l, y - width / 2, y + width / 2), width * line, 1e-8 * width * line);
  EXPECT_NEAR(strip_displacement(l, 1.0, 1.0 + width), width * pi / 2.0 * l, 1e-5 * width * l);
}

TEST(Ekp, WithTheEllipseScaleIsHertzOnEllipticGaps) {
  for (const double ratio : {0.0274, 0.2, 1.0, 3.0, 36.5}) {
    SCOPED_TRACE(ratio);
    const double coefficient_x = 1.0, coefficient_y = 1.0 / ratio, approach = 60e-6;
    const HertzEllipse hertz =
        hertz_ellipse(coefficient_x, coefficient_y, approach, test::steel.normal_compliance());
    const OwnedGap gap = test::elliptic_gap(coefficient_x, coefficient_y, 3.0 * hertz.b);
    StripMemory owned(240);
    NormalSolution solution;
    ASSERT_EQ(solve_ekp(test::under_approach(gap, approach, 240), {EkpScale::ellipse}, owned.strips, solution)
                  .status,
              WRC_OK);
    EXPECT_NEAR(solution.normal_force, hertz.normal_force, 1e-3 * hertz.normal_force);
    EXPECT_NEAR(solution.peak_pressure, hertz.peak, 1e-3 * hertz.peak);
    EXPECT_NEAR(solution.area, pi * hertz.a * hertz.b, 1e-3 * pi * hertz.a * hertz.b);
    const patch::StripTotals sum = patch::totals(owned.strips);
    EXPECT_NEAR(sum.y_max, hertz.b, 1e-6 * hertz.b);
    EXPECT_NEAR(sum.length, 2.0 * hertz.a, 1e-4 * hertz.a);
  }
}

TEST(Ekp, WithTheAreaScaleKeepsHertzsAreaOnEllipticGaps) {
  for (const double ratio : {0.0274, 0.2, 1.0, 3.0, 36.5}) {
    SCOPED_TRACE(ratio);
    const double approach = 60e-6;
    const HertzEllipse hertz = hertz_ellipse(1.0, 1.0 / ratio, approach, test::steel.normal_compliance());
    const OwnedGap gap = test::elliptic_gap(1.0, 1.0 / ratio, 3.0 * hertz.b);
    StripMemory owned(240);
    NormalSolution solution;
    ASSERT_EQ(solve_ekp(test::under_approach(gap, approach, 240), {}, owned.strips, solution).status, WRC_OK);
    EXPECT_NEAR(solution.area, pi * hertz.a * hertz.b, 1e-3 * pi * hertz.a * hertz.b);
  }
}

TEST(KikPiotrowski, OnASphereWithHalfPenetrationIsHertz) {
  const double approach = 60e-6;
  const HertzEllipse hertz = hertz_ellipse(1.0, 1.0, approach, test::steel.normal_compliance());
  const OwnedGap gap = test::elliptic_gap(1.0, 1.0, 3.0 * hertz.b);
  StripMemory owned(240);
  NormalSolution solution;
  ASSERT_EQ(solve_kik_piotrowski(test::under_approach(gap, approach, 240), {.penetration_scale = 0.5},
                                 owned.strips, solution)
                .status,
            WRC_OK);
  EXPECT_NEAR(solution.normal_force, hertz.normal_force, 1e-3 * hertz.normal_force);
  EXPECT_NEAR(solution.peak_pressure, hertz.peak, 1e-3 * hertz.peak);
}

TEST(PenetrationMethods, GoFromLoadToApproachAndBack) {
  const OwnedGap gap = test::s1002_on_uic60();
  for (const Method& method : methods) {
    SCOPED_TRACE(method.name);
    for (const double load : {5e3, 40e3, 80e3, 150e3}) {
      StripMemory owned(60);
      NormalSolution loaded, pressed;
      ASSERT_EQ(method.solve(test::under_load(gap, load), owned.strips, loaded).status, WRC_OK);
      EXPECT_NEAR(loaded.normal_force, load, 1e-9 * load);
      EXPECT_NEAR(patch::totals(owned.strips).normal_force, load, 1e-8 * load);
      EXPECT_LE(loaded.iterations, 10);
      ASSERT_EQ(method.solve(test::under_approach(gap, loaded.approach), owned.strips, pressed).status,
                WRC_OK);
      EXPECT_NEAR(pressed.normal_force, load, 1e-8 * load);

      NormalSolution more;
      ASSERT_EQ(method.solve(test::under_approach(gap, 1.001 * loaded.approach), owned.strips, more).status,
                WRC_OK);
      const double stiffness = (more.normal_force - load) / (0.001 * loaded.approach);
      EXPECT_NEAR(loaded.stiffness, stiffness, 0.01 * stiffness);
    }
  }
}

TEST(PenetrationMethods, ScaleWithLengthAndStiffness) {
  // All lengths times s and all moduli times m: forces times m s^2, pressures times m.
  const double s = 0.2, m = 3.0;
  const OwnedGap gap = test::s1002_on_uic60();
  OwnedGap small;
  for (std::size_t j = 0; j < gap.y.size(); ++j)
    small.add(s * gap.y[j], s * gap.height[j], gap.curvature[j] / s, s * gap.centre[j]);
  for (const Method& method : methods) {
    SCOPED_TRACE(method.name);
    StripMemory owned(60);
    NormalSolution full, scaled;
    ASSERT_EQ(method.solve(test::under_approach(gap, 65e-6), owned.strips, full).status, WRC_OK);
    NormalProblem problem = test::under_approach(small, s * 65e-6);
    problem.material.shear_modulus *= m;
    ASSERT_EQ(method.solve(problem, owned.strips, scaled).status, WRC_OK);
    EXPECT_NEAR(scaled.normal_force, m * s * s * full.normal_force, 1e-9 * scaled.normal_force);
    EXPECT_NEAR(scaled.peak_pressure, m * full.peak_pressure, 1e-9 * scaled.peak_pressure);
    EXPECT_NEAR(scaled.area, s * s * full.area, 1e-9 * scaled.area);
  }
}

TEST(PenetrationMethods, MirrorWithTheGap) {
  const OwnedGap gap = test::s1002_on_uic60();
  const OwnedGap mirror = test::mirrored(gap);
  for (const Method& method : methods) {
    SCOPED_TRACE(method.name);
    StripMemory right(60), left(60);
    NormalSolution here, there;
    ASSERT_EQ(method.solve(test::under_load(gap, 80e3), right.strips, here).status, WRC_OK);
    ASSERT_EQ(method.solve(test::under_load(mirror, 80e3), left.strips, there).status, WRC_OK);
    EXPECT_NEAR(here.approach, there.approach, 1e-9 * here.approach);
    EXPECT_NEAR(here.area, there.area, 1e-9 * here.area);
    for (int j = 0; j < 60; ++j) {
      EXPECT_NEAR(right.strips.y[j], -left.strips.y[59 - j], 1e-10);
      EXPECT_NEAR(right.strips.peak[j], left.strips.peak[59 - j], 1e-6 * here.peak_pressure);
    }
  }
}

TEST(PenetrationMethods, ConvergeWithTheNumberOfStrips) {
  const OwnedGap gap = test::s1002_on_uic60();
  for (const Method& method : methods) {
    SCOPED_TRACE(method.name);
    StripMemory owned(960);
    NormalSolution limit;
    ASSERT_EQ(method.solve(test::under_load(gap, 80e3, 960), owned.strips, limit).status, WRC_OK);
    struct {
      int strips;
      double area, approach, peak;
    } const expected[] = {{20, 8e-3, 3e-3, 12e-3}, {60, 1.5e-3, 5e-4, 3e-3}, {120, 6e-4, 2e-4, 1e-3}};
    for (const auto& row : expected) {
      NormalSolution solution;
      ASSERT_EQ(method.solve(test::under_load(gap, 80e3, row.strips), owned.strips, solution).status, WRC_OK);
      EXPECT_NEAR(solution.area, limit.area, row.area * limit.area) << row.strips;
      EXPECT_NEAR(solution.approach, limit.approach, row.approach * limit.approach) << row.strips;
      EXPECT_NEAR(solution.peak_pressure, limit.peak_pressure, row.peak * limit.peak_pressure) << row.strips;
    }
  }
}

TEST(PenetrationMethods, MoveSmoothlyWithTheLoad) {
  // 0.1 % more load moves area and borders by about 0.1 %, never by a cell of some grid.
  const OwnedGap gap = test::s1002_on_uic60();
  for (const Method& method : methods) {
    SCOPED_TRACE(method.name);
    StripMemory owned(40);
    double area = 0.0, border = 0.0;
    for (double load = 70e3; load < 90e3; load *= 1.001) {
      NormalSolution solution;
      ASSERT_EQ(method.solve(test::under_load(gap, load, 40), owned.strips, solution).status, WRC_OK);
      const patch::StripTotals sum = patch::totals(owned.strips);
      if (area > 0.0) {
        EXPECT_GT(sum.area, area);
        EXPECT_LT(sum.area, 1.002 * area);
        EXPECT_NEAR(sum.y_min, border, 20e-6);
      }
      area = sum.area;
      border = sum.y_min;
    }
  }
}

TEST(Ekp, GivesThePatchPublishedForS1002OnUic60) {
  // Source paper: 80 kN gives a = 5.8 mm, b = 10.3 mm, psi = -0.3 (criteria (1), (2b) and (3)).
  const OwnedGap gap = test::s1002_on_uic60();
  StripMemory owned(60);
  NormalSolution solution;
  ASSERT_EQ(solve_ekp(test::under_load(gap, 80e3), {}, owned.strips, solution).status, WRC_OK);
  patch::Sdec sdec;
  ASSERT_EQ(
      patch::regularise(patch::totals(owned.strips), solution.y_contact, patch::SecondCriterion::width, sdec)
          .status,
      WRC_OK);
  EXPECT_NEAR(sdec.a, 5.8e-3, 0.05 * 5.8e-3);
  EXPECT_NEAR(sdec.b, 10.3e-3, 0.05 * 10.3e-3);
  EXPECT_NEAR(sdec.psi, -0.30, 0.02);
}

TEST(Ekp, FollowsTheLocusOfYaw) {
  OwnedGap gap = test::s1002_on_uic60();
  for (std::size_t j = 0; j < gap.y.size(); ++j) gap.centre[j] = -0.05 * gap.y[j];
  StripMemory owned(60);
  NormalSolution solution;
  ASSERT_EQ(solve_ekp(test::under_load(gap, 80e3), {}, owned.strips, solution).status, WRC_OK);
  for (int j = 0; j < 60; ++j) EXPECT_NEAR(owned.strips.centre[j], -0.05 * owned.strips.y[j], 1e-12);
  NormalSolution straight;
  const OwnedGap plain = test::s1002_on_uic60();
  ASSERT_EQ(solve_ekp(test::under_load(plain, 80e3), {}, owned.strips, straight).status, WRC_OK);
  // The skew moves material away from the contact point by (dx/dy)^2 / 2 = 0.1 %.
  EXPECT_NEAR(solution.approach, straight.approach, 2e-3 * straight.approach);
  EXPECT_LT(solution.approach, straight.approach);
}

TEST(PenetrationMethods, NameWhatIsWrong) {
  const OwnedGap good = test::s1002_on_uic60();
  for (const Method& method : methods) {
    SCOPED_TRACE(method.name);
    StripMemory owned(60);
    NormalSolution solution;
    const auto status = [&](const NormalProblem& problem) {
      return method.solve(problem, owned.strips, solution).status;
    };
    EXPECT_EQ(status(test::under_load(good, 0.0)), WRC_FLAG_NO_CONTACT);
    EXPECT_EQ(owned.strips.count, 0);
    EXPECT_EQ(status(test::under_approach(good, -1e-6)), WRC_FLAG_NO_CONTACT);
    EXPECT_EQ(status(test::under_load(good, -1.0)), WRC_ERROR_RANGE);
    EXPECT_EQ(status(test::under_load(good, NAN)), WRC_ERROR_NOT_FINITE);
    EXPECT_EQ(status(test::under_load(good, 1e9)), WRC_FLAG_BEYOND_GAP);
    EXPECT_EQ(owned.strips.count, 60);
    EXPECT_NEAR(patch::totals(owned.strips).normal_force, 1e9, 1e-3);
    EXPECT_EQ(status(test::under_approach(good, 1.0)), WRC_FLAG_BEYOND_GAP);
    EXPECT_EQ(solution.approach, 1.0);
    EXPECT_EQ(status(test::under_load(good, 80e3, 61)), WRC_ERROR_BUFFER);

    NormalProblem short_cap = test::under_load(good, 80e3);
    short_cap.max_iterations = 2;
    EXPECT_EQ(status(short_cap), WRC_FLAG_ITERATION_CAP);
    EXPECT_GT(solution.normal_force, 0.0);
    EXPECT_EQ(owned.strips.count, 60);

    OwnedGap cut;
    for (std::size_t j = 30; j < good.y.size(); ++j) cut.add(good.y[j], good.height[j], good.curvature[j]);
    EXPECT_EQ(status(test::under_load(cut, 80e3)), WRC_FLAG_PATCH_AT_EDGE);
    EXPECT_NEAR(solution.normal_force, 80e3, 1e-3);

    OwnedGap bad = good;
    bad.height[7] = NAN;
    EXPECT_EQ(status(test::under_load(bad, 80e3)), WRC_ERROR_NOT_FINITE);
    bad = good;
    bad.curvature[7] = 0.0;
    EXPECT_EQ(status(test::under_load(bad, 80e3)), WRC_ERROR_GAP);
    bad = good;
    std::swap(bad.y[3], bad.y[4]);
    EXPECT_EQ(status(test::under_load(bad, 80e3)), WRC_ERROR_GAP);
    for (const double range : {0.0, 5e-324, 1e-13}) {  // flat, as far as lengths have a meaning
      bad = good;
      std::fill(bad.height.begin(), bad.height.end(), 0.0);
      bad.height.back() = range;
      EXPECT_EQ(status(test::under_load(bad, 80e3)), WRC_ERROR_GAP);
    }

    EXPECT_EQ(status(test::under_load(good, 80e3)), WRC_OK);
  }
}

TEST(PenetrationMethods, TakeAnOffsetGapForWhatItIs) {
  // The approach counts from first touch: the level of the heights is of no consequence.
  OwnedGap raised = test::s1002_on_uic60();
  for (double& height : raised.height) height += 1e-3;
  const OwnedGap gap = test::s1002_on_uic60();
  StripMemory owned(60);
  NormalSolution here, there;
  ASSERT_EQ(solve_ekp(test::under_load(gap, 80e3), {}, owned.strips, here).status, WRC_OK);
  ASSERT_EQ(solve_ekp(test::under_load(raised, 80e3), {}, owned.strips, there).status, WRC_OK);
  EXPECT_NEAR(here.approach, there.approach, 1e-9 * here.approach);
}

TEST(PenetrationMethods, TakeInASecondRegionGradually) {
  // A valley beside the contact, which joins the patch as a whole when the ridge between them is covered: at
  // one approach the load of the methods leaps. Under a rising load, patch and pressure still move steadily.
  OwnedGap gap;
  for (int j = 0; j <= 160; ++j) {
    const double y = -12e-3 + 0.2e-3 * j;
    const double u = y / 8e-3 - 1.0;  // wells at u = -1 and 1
    gap.add(y, 30e-6 * (u * u - 1.0) * (u * u - 1.0) + 4e-6 * (u + 1.0), 2.0);
  }
  for (const Method& method : methods) {
    SCOPED_TRACE(method.name);
    // Where more than the outline's extent leaps, so does the rest: eps(y) of the ellipse hangs on the chord
    // at half the approach, and the correction moves the strips.
    const std::string_view name = method.name;
    if (name != "Kik-Piotrowski" && name != "EKP, area") continue;
    StripMemory owned(60);
    NormalSolution solution;
    double area = 0.0, peak = 0.0, approach = 0.0, leap_at = 0.0;
    double worst = 0.0, widest = 0.0, narrowest = 1.0;
    std::int64_t most_evaluations = 0, flagged = 0;
    for (double load = 10e3; load < 200e3; load *= 1.001) {
      const Fault fault = method.solve(test::under_load(gap, load), owned.strips, solution);
      if (fault.status == WRC_FLAG_PATCH_AT_EDGE) break;
      ASSERT_TRUE(fault.status == WRC_OK || fault.status == WRC_FLAG_LOAD_JUMPS) << load;
      flagged += fault.status == WRC_FLAG_LOAD_JUMPS;
      const patch::StripTotals sum = patch::totals(owned.strips);
      EXPECT_NEAR(sum.normal_force, load, 1e-9 * load);
      if (area > 0.0) {
        worst = std::max(
            {worst, std::abs(solution.area / area - 1.0), std::abs(solution.peak_pressure / peak - 1.0)});
        if (std::abs(solution.approach / approach - 1.0) < 2e-5) leap_at = load;
      }
      most_evaluations = std::max(most_evaluations, solution.iterations);
      area = solution.area;
      peak = solution.peak_pressure;
      approach = solution.approach;
      widest = std::max(widest, sum.y_max - sum.y_min);
      narrowest = std::min(narrowest, sum.y_max - sum.y_min);
    }
    EXPECT_GT(flagged, 0);
    EXPECT_GT(widest, 1.5 * narrowest);
    EXPECT_GT(leap_at, 0.0);  // the approach stands still while the second region comes in
    EXPECT_LT(worst, 0.04);   // the new region's area sets in like the root of its load; a leap has 0.5
    EXPECT_LE(most_evaluations, 10);  // also for loads just beside the leap, where bisection takes more
  }
}

// A step of the gap beside its lowest point may leave a small overlap no width that y can express.
TEST(LateralCurvature, OfAChordWithoutWidthIsANumber) {
  for (const double approach : {1e-12, 1e-6, 1e-3})
    for (const double width : {0.0, 1e-300, 1e-17}) {
      const LateralCurvature lateral = lateral_curvature({0.02, 0.02 + width, false}, approach);
      EXPECT_TRUE(std::isfinite(lateral.coefficient)) << approach << " " << width;
      EXPECT_GE(lateral.coefficient, 1e11);
    }
  const LateralCurvature wide = lateral_curvature({-1e-11, 1e-11, false}, 1e-6);
  EXPECT_DOUBLE_EQ(wide.coefficient, 0.5e-6 / 1e-22);
}

}  // namespace
}  // namespace wrc::normal
