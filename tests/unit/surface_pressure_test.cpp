#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "base/instruction_set.hpp"
#include "base/number.hpp"
#include "kernels/kernels.hpp"
#include "normal/elasticity/hertz_theory.hpp"
#include "normal_gaps.hpp"
#include "surface/pressure/pressure.hpp"
#include "surface/pressure/pressure_jacobian.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::surface {
namespace {

PressureModel model_of(double compliance) {
  static const auto influence = [] {
    auto made = std::make_unique<normal::InfluenceTables>();
    normal::tabulate(*made);
    return made;
  }();
  return {*influence, kernels_for(best_instruction_set()), compliance};
}

/// A flat rail's strips under a gap A x'^2 + B y'^2 whose axes are turned by an angle.
struct TurnedGap {
  double width;
  std::vector<std::int32_t> strip;
  std::vector<double> place, widths, depth, curvature, middle, ny, nz;

  TurnedGap(double A, double B, double angle, double approach, double strip_width = 0.25e-3)
      : width(strip_width) {
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
      ny.push_back(0.0);
      nz.push_back(1.0);
    }
  }

  std::vector<double> length_squared, peak_per_length, centre, line_load;

  PressureResult solve(double compliance) {
    from = StartFrom::overlaps;
    return solve_from_start(compliance);
  }

  PressureStart start;
  StartFrom from = StartFrom::overlaps;
  bool along_track = false;
  std::vector<double> numbers, L, shift, deep;

  PressureResult solve_from_start(double compliance, const PressureOptions& options = {}) {
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
    overlaps.ny = ny.data();
    overlaps.nz = nz.data();
    for (auto* a : {&length_squared, &peak_per_length, &centre, &line_load}) a->assign(n, 0.0);
    std::vector<double> workspace(static_cast<std::size_t>(pressure_doubles(count)));
    for (auto* a : {&numbers, &L, &shift, &deep}) a->resize(n);
    start = {numbers.data(), L.data(), shift.data(), deep.data(), start.count, start.change, start.earlier};
    PressureModel model = model_of(compliance);
    model.along_track = along_track;
    return solve_pressure(model, rail, overlaps, options, workspace.data(), start, from,
                          {length_squared.data(), peak_per_length.data(), centre.data(), line_load.data()});
  }
};

// Hertz's ellipse is a semi-ellipse along whatever strips it is cut into.
TEST(SurfacePressure, HertzsEllipseLiesAskewToTheStrips) {
  const double compliance = test::steel.normal_compliance(), approach = 60e-6;
  for (const double ratio : {0.15, 0.4, 3.0})
    for (const double degrees : {0.0, 10.0, 30.0, 60.0}) {
      SCOPED_TRACE(testing::Message() << "A / B " << ratio << ", " << degrees << " degrees");
      const double A = 1.2, B = A / ratio;
      const normal::HertzEllipse hertz = normal::hertz_ellipse(A, B, approach, compliance);
      TurnedGap gap(A, B, degrees * pi / 180.0, approach);
      ASSERT_TRUE(gap.solve(compliance).converged);
      double load = 0.0, moment = 0.0, peak = 0.0;
      for (std::size_t i = 0; i < gap.place.size(); ++i) {
        const double N = 0.5 * pi * gap.width * gap.line_load[i];
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

// Along the track a solve starts from Hertz's contact of a hill of overlap. Without work it ends there.
TEST(SurfacePressure, AHillOfOverlapStartsAsHertzsContact) {
  const double compliance = test::steel.normal_compliance(), approach = 60e-6;
  for (const double ratio : {0.15, 0.4, 1.0, 3.0})
    for (const double degrees : {0.0, 10.0, 30.0, 60.0}) {
      SCOPED_TRACE(testing::Message() << "A / B " << ratio << ", " << degrees << " degrees");
      const double A = 1.2, B = A / ratio, angle = degrees * pi / 180.0;
      TurnedGap gap(A, B, angle, approach, 0.5e-3);
      gap.along_track = true;
      PressureOptions nothing;
      nothing.max_work = 1.0;
      const PressureResult result = gap.solve_from_start(compliance, nothing);
      EXPECT_EQ(result.iterations, 1);
      EXPECT_LT(result.residual, 0.06);
      // P x^2 + 2 R x y + Q y^2 = 1 of the ellipse
      const normal::HertzEllipse hertz = normal::hertz_ellipse(A, B, approach, compliance);
      const double c = std::cos(angle), s = std::sin(angle);
      const double a2 = 1.0 / (hertz.a * hertz.a), b2 = 1.0 / (hertz.b * hertz.b);
      const double P = c * c * a2 + s * s * b2, R = (a2 - b2) * c * s, Q = s * s * a2 + c * c * b2;
      for (std::size_t i = 0; i < gap.place.size(); ++i) {
        const double y = gap.place[i], L = std::fmax(1.0 - (Q - R * R / P) * y * y, 0.0) / P;
        EXPECT_NEAR(gap.length_squared[i], L, 0.05 / P) << i;
        if (L > 0.1 / P) {
          EXPECT_NEAR(gap.centre[i], -R / P * y, 0.05 / std::sqrt(P)) << i;
        }
      }
    }
}

/// Strips of a flange under yaw: where its face meets another, the place of the largest overlap moves by
/// `jump` from strip to strip, and one strip's overlap is nearly flat along x.
struct FlatStrip : TurnedGap {
  FlatStrip(double flattest, double jump, double approach) : TurnedGap(1.0, 1.0, 0.0, 0.0) {
    constexpr int strips = 48, highest = 20, flat = 22;
    for (int i = 0; i < strips; ++i) {
      const double y = (i - highest) * width, behind = 1.0 - std::exp(-(i - flat - 1) / 6.0);
      strip.push_back(i);
      place.push_back(y);
      widths.push_back(width);
      depth.push_back(approach - 6.0 * y * y);
      curvature.push_back(i < flat ? 0.72 : i == flat ? flattest : 0.37 + 0.35 * behind);
      middle_of(i < flat ? 0.0 : i == flat ? 0.4 * jump : (1.4 + 2.5 * behind) * jump);
    }
  }

 private:
  void middle_of(double x) {
    middle.push_back(x);
    ny.push_back(0.0);
    nz.push_back(1.0);
  }
};

// The map leads away from the solution there, and the iteration alone circles until its cap.
TEST(SurfacePressure, AFlatStripIsSolved) {
  const double compliance = test::steel.normal_compliance();
  int late = 0;
  for (const double flattest : {0.01, 0.05, 0.2})
    for (const double jump : {4e-3, 7e-3, 12e-3})
      for (const double approach : {100e-6, 200e-6, 300e-6, 400e-6}) {
        SCOPED_TRACE(testing::Message()
                     << "curvature " << flattest << " 1/m, " << jump << " m, " << approach << " m");
        FlatStrip gap(flattest, jump, approach);
        const PressureResult result = gap.solve_from_start(compliance, {.tolerance = 1e-5});
        ASSERT_TRUE(result.converged);
        late += result.iterations > 100 ? 1 : 0;
        // It is a solution: the map hardly moves it.
        double load = 0.0, again = 0.0;
        for (const double q : gap.line_load) load += q;
        gap.from = StartFrom::extrapolation;
        EXPECT_EQ(gap.solve_from_start(compliance, {.tolerance = 2e-5}).iterations, 1);
        for (const double q : gap.line_load) again += q;
        EXPECT_NEAR(again, load, 1e-4 * load);
      }
  EXPECT_GT(late, 3);  // or they are no such cases
}

/// Some strips under a paraboloid whose top lies beside the middle of one.
struct NarrowGap : TurnedGap {
  NarrowGap(double B, double beside, double approach) : TurnedGap(1.07, B, 0.0, approach) {
    for (std::size_t i = 0; i < place.size(); ++i) {
      const double y = place[i] - beside * width;
      depth[i] = approach - B * y * y;
    }
  }
  double load_to(double compliance, double tolerance) {
    from = StartFrom::overlaps;
    EXPECT_TRUE(solve_from_start(compliance, {.tolerance = tolerance}).converged);
    double load = 0.0;
    for (const double q : line_load) load += q;
    return load;
  }
};

// Three strips have little to accelerate: differences of their iterates are nearly parallel. Nothing comes
// behind the last step that would put a wild one right.
TEST(SurfacePressure, TheLastStepOfNarrowContactsIsNoLeap) {
  const double compliance = test::steel.normal_compliance();
  double worst = 0.0;
  for (const double B : {60.0, 90.0, 140.0})
    for (const double beside : {0.1, 0.21, 0.35})
      for (int step = 0; step < 600; ++step) {
        NarrowGap gap(B, beside, 10e-6 + 0.05e-6 * step);
        const double exact = gap.load_to(compliance, 1e-10);
        worst = std::fmax(worst, std::fabs(gap.load_to(compliance, 1e-3) / exact - 1.0));
      }
  EXPECT_LT(worst, 3e-3);
}

// At most four times the usual work of as many strips as are in contact, however many there were before.
TEST(SurfacePressure, WorkIsLimitedByTheStripsLeftInContact) {
  const double compliance = test::steel.normal_compliance();
  constexpr double iterations = 8.0;
  int ended = 0;
  for (const double flattest : {0.01, 0.05, 0.2})
    for (const double jump : {4e-3, 7e-3, 12e-3})
      for (const double approach : {50e-6, 100e-6, 200e-6, 300e-6, 400e-6}) {
        SCOPED_TRACE(testing::Message()
                     << "curvature " << flattest << " 1/m, " << jump << " m, " << approach << " m");
        FlatStrip gap(flattest, jump, approach);
        const PressureResult result =
            gap.solve_from_start(compliance, {.tolerance = 1e-3, .max_iterations = iterations});
        const auto strips = static_cast<double>(
            std::count_if(gap.line_load.begin(), gap.line_load.end(), [](double q) { return q > 0.0; }));
        // usual: four to five iterations
        EXPECT_LE(result.work, 16.0 * 2.0 * (strips + 0.5) * (strips + 0.5));
        EXPECT_EQ(result.converged, result.residual <= 1e-3);
        ended += result.converged ? 0 : 1;
      }
  EXPECT_GT(ended, 3);  // or nothing is limited
}

/// Derivatives of a solution: of a contact askew to strips that lie on an arc, by numbers that every strip
/// has its own of. Input k of the four changes one of them: depth, deepest point, curvature, direction.
struct ArcedGap : TurnedGap {
  static constexpr double radius = 12e-3;  ///< [m]
  std::vector<double> tilt;                ///< of the directions [rad]

  explicit ArcedGap(double strip_width) : TurnedGap(1.2, 3.0, 0.5, 60e-6, strip_width) {
    for (const double y : place) tilt.push_back(y / radius);
    turn();
  }
  void turn() {
    for (std::size_t i = 0; i < tilt.size(); ++i) {
      ny[i] = std::sin(tilt[i]);
      nz[i] = std::cos(tilt[i]);
    }
  }
  /// Change of that number of strip i by one unit of input k.
  double rate(int k, std::size_t i) const {
    const double wave = std::sin(900.0 * place[i] + k);
    const double rates[] = {1e-6 * (1.0 + wave), 1e-5 * wave, 0.1 * (1.0 - wave), 1e-2 * wave};
    return rates[k];
  }
  void move(int k, double step) {
    std::vector<double>* const of[] = {&depth, &middle, &curvature, &tilt};
    for (std::size_t i = 0; i < place.size(); ++i) (*of[k])[i] += step * rate(k, i);
    turn();
  }
  void solve_exactly(double compliance) {
    from = StartFrom::overlaps;
    ASSERT_TRUE(solve_from_start(compliance, {.tolerance = 1e-12}).converged);
  }
  OverlapSlopes slopes(std::size_t i) const {
    OverlapSlopes o;
    o.depth = depth[i];
    o.centre = middle[i];
    o.curvature = curvature[i];
    o.ny = ny[i];
    o.nz = nz[i];
    o.depth.d[0] = rate(0, i);
    o.centre.d[1] = rate(1, i);
    o.curvature.d[2] = rate(2, i);
    o.ny.d[3] = nz[i] * rate(3, i);
    o.nz.d[3] = -ny[i] * rate(3, i);
    return o;
  }
};

/// Numbers of the strips in contact, and their derivatives.
struct DifferentiatedGap {
  std::vector<std::size_t> number;
  std::vector<double> place, width, line_load, length_squared, centre;
  std::vector<PlaceDual> line_load_dual, length_squared_dual, centre_dual;

  template <class Gap, class Slopes>
  DifferentiatedGap(const Gap& gap, double compliance, const Slopes& slopes) {
    std::vector<OverlapSlopes> overlap;
    for (std::size_t i = 0; i < gap.place.size(); ++i) {
      if (!(gap.length_squared[i] > 0.0)) continue;
      number.push_back(i);
      place.push_back(gap.place[i]);
      width.push_back(gap.width);
      line_load.push_back(gap.line_load[i]);
      length_squared.push_back(gap.length_squared[i]);
      centre.push_back(gap.centre[i]);
      overlap.push_back(slopes(i));
    }
    const std::size_t n = number.size();
    for (auto* dual : {&line_load_dual, &length_squared_dual, &centre_dual}) dual->resize(n);
    PressedStrips s;
    s.count = s.behind = static_cast<std::int32_t>(n);
    s.place = place.data();
    s.width = width.data();
    s.line_load = line_load.data();
    s.length_squared = length_squared.data();
    s.centre = centre.data();
    s.overlap = overlap.data();
    s.line_load_dual = line_load_dual.data();
    s.length_squared_dual = length_squared_dual.data();
    s.centre_dual = centre_dual.data();
    std::vector<double> workspace(static_cast<std::size_t>(pressure_jacobian_doubles(s.count)));
    differentiate_pressures(model_of(compliance), workspace.data(),
                            static_cast<std::int64_t>(workspace.size()), s);
  }
};

// Central differences of the solver, by every number of an overlap, in every unknown. Over so small steps
// hardly a distance passes a node of the tables, where derivatives leap.
void expect_differences(double width, std::size_t fewest) {
  const double compliance = test::steel.normal_compliance(), step = 3e-6;
  ArcedGap gap(width);
  gap.solve_exactly(compliance);
  const DifferentiatedGap there(gap, compliance, [&gap](std::size_t i) { return gap.slopes(i); });
  ASSERT_GT(there.number.size(), fewest);
  for (int k = 0; k < place_inputs; ++k) {
    ArcedGap less(width), more(width);
    less.move(k, -step);
    more.move(k, step);
    less.solve_exactly(compliance);
    more.solve_exactly(compliance);
    const struct {
      const char* name;
      const std::vector<PlaceDual>& dual;
      const std::vector<double>&low, &high;
    } unknowns[] = {{"q", there.line_load_dual, less.line_load, more.line_load},
                    {"L", there.length_squared_dual, less.length_squared, more.length_squared},
                    {"c", there.centre_dual, less.centre, more.centre}};
    for (const auto& u : unknowns) {
      SCOPED_TRACE(testing::Message() << u.name << " by input " << k);
      double largest = 0.0, off = 0.0;
      for (std::size_t a = 0; a < there.number.size(); ++a) {
        const std::size_t i = there.number[a];
        const double difference = (u.high[i] - u.low[i]) / (2.0 * step);
        largest = std::fmax(largest, std::fabs(difference));
        off = std::fmax(off, std::fabs(u.dual[a].d[static_cast<std::size_t>(k)] - difference));
      }
      EXPECT_GT(largest, 0.0);
      EXPECT_LT(off, 2e-5 * largest);
    }
  }
}

TEST(SurfacePressure, DerivativesOfPressuresAreDifferencesOfSolutions) { expect_differences(0.25e-3, 20); }

// The shifts of so narrow strips lie on lines through up to 43 others on each side.
TEST(SurfacePressure, DerivativesOfManyStripsWithinReach) { expect_differences(0.12e-3, 55); }

// dN/d(approach) = 3/2 N / approach, dL/L = d(approach)/approach at the middle: Hertz.
TEST(SurfacePressure, DerivativesOfPressuresAreHertzs) {
  const double compliance = test::steel.normal_compliance(), approach = 60e-6;
  for (const double degrees : {0.0, 30.0}) {
    SCOPED_TRACE(degrees);
    TurnedGap gap(1.2, 3.0, degrees * pi / 180.0, approach);
    ASSERT_TRUE(gap.solve(compliance).converged);
    const DifferentiatedGap there(gap, compliance, [&gap](std::size_t i) {
      OverlapSlopes o;
      o.depth = PlaceDual::input(gap.depth[i], place_z);
      o.centre = gap.middle[i];
      o.curvature = gap.curvature[i];
      o.ny = 0.0;
      o.nz = 1.0;
      return o;
    });
    double load = 0.0, stiffness = 0.0, longest = 0.0, grows = 0.0;
    for (std::size_t a = 0; a < there.number.size(); ++a) {
      load += there.line_load[a];
      stiffness += there.line_load_dual[a].d[place_z];
      if (there.length_squared[a] <= longest) continue;
      longest = there.length_squared[a];
      grows = there.length_squared_dual[a].d[place_z];
    }
    EXPECT_NEAR(stiffness * approach / load, 1.5, 5e-3);
    EXPECT_NEAR(grows * approach / longest, 1.0, 2e-2);
  }
}

// Least squares, solved as the two equations that its definition gives; 0 where nothing is within reach.
TEST(SurfacePressure, LinesGoThroughWhatIsNear) {
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
TEST(SurfacePressure, AWarmStartFollowsItsOverlaps) {
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
      constexpr StartFrom from[ways] = {StartFrom::overlaps, StartFrom::extrapolation, StartFrom::solution};
      gap.from = from[way];
      const TurnedGap before = gap;
      ASSERT_TRUE(gap.solve_from_start(compliance).converged);
      load[way] = 0.0;
      for (const double q : gap.line_load) load[way] += q;
      // part of the area that the first iteration moves: the largest at which that is not the last one
      moved[way] = 1.0;
      for (TurnedGap again = before;; again = before, moved[way] *= 0.9)
        if (again.solve_from_start(compliance, {.tolerance = moved[way]}).iterations > 1) break;
    }
    std::printf("first iteration moves %.4f of the area, without %.4f\n", moved[followed], moved[as_before]);
    EXPECT_LT(moved[followed], motion.left * moved[as_before]);
    for (const int way : {as_before, followed}) EXPECT_NEAR(load[way], load[anew], 1e-7 * load[anew]);
  }
}

// A change whose forerunner is not known extrapolates as with one of nothing.
TEST(SurfacePressure, AStartNeedsOneChange) {
  const double compliance = test::steel.normal_compliance(), deeper = 2e-6;
  TurnedGap gap(1.0, 1.5, 0.0, 60e-6);
  ASSERT_TRUE(gap.solve(compliance).converged);
  const TurnedGap first = gap;
  for (double& d : gap.depth) d += deeper;
  ASSERT_TRUE(gap.solve(compliance).converged);
  const auto growth = [](const std::vector<double>& now, const std::vector<double>& before) {
    std::vector<double> by(now.size());
    std::transform(now.begin(), now.end(), before.begin(), by.begin(), std::minus<>());
    return by;
  };
  const auto longer = growth(gap.L, first.L), shifted = growth(gap.shift, first.shift),
             deep = growth(gap.deep, first.deep);
  const std::vector<double> nothing(longer.size());
  for (double& d : gap.depth) d += deeper;
  gap.from = StartFrom::solution;
  gap.start.change = {longer.data(), shifted.data(), deep.data()};
  TurnedGap with_nothing = gap, without_change = gap;
  with_nothing.start.earlier = {nothing.data(), nothing.data(), nothing.data()};
  without_change.start.change = {};
  const PressureResult one = gap.solve_from_start(compliance, {.tolerance = 1e-3});
  EXPECT_EQ(with_nothing.solve_from_start(compliance, {.tolerance = 1e-3}).residual, one.residual);
  EXPECT_EQ(with_nothing.line_load, gap.line_load);
  without_change.solve_from_start(compliance, {.tolerance = 1e-3});
  EXPECT_NE(without_change.line_load, gap.line_load);
}

}  // namespace
}  // namespace wrc::surface
