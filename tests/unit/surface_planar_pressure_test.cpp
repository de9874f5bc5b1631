/// Methods for planes and patches on a rail's surface: lobes, planar normal methods laid over the rail's
/// strips, rolling patch by patch.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "normal/elasticity/hertz_theory.hpp"
#include "normal/methods/analyn.hpp"
#include "normal/methods/ekp.hpp"
#include "normal/methods/hertz.hpp"
#include "normal/methods/kik_piotrowski.hpp"
#include "normal/methods/stripes.hpp"
#include "normal_gaps.hpp"
#include "surface/pressure/lobes.hpp"
#include "surface/pressure/planar_pressure.hpp"
#include "surface/rolling/region_rolling.hpp"
#include "tangential/methods/fastsim.hpp"
#include "tangential_patches.hpp"

namespace wrc::surface {
namespace {

TEST(Lobes, SharesOfThePartsOfEveryPlaceAddUpToOne) {
  // three humps, the valleys half and a third filled
  std::vector<double> place, value;
  for (int j = 0; j < 121; ++j) {
    const double u = 0.05 * j;  // 0 .. 6
    place.push_back(1e-3 * u);
    value.push_back(1e-5 * (0.62 + 0.38 * std::cos(pi * (u - 1.0)) - 0.05 * u));
  }
  const LobeCuts cuts = find_lobes(place.data(), value.data(), 0, 121);
  ASSERT_EQ(cuts.count, 2);
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(cuts.of[i].place, 2e-3 * (i + 1), 0.03e-3);
  LobeCuts between = cuts;
  between.of[0].joined = 0.3;
  between.of[1].joined = 0.8;
  int parts = 0;
  std::vector<double> sum(121, 0.0);
  for_each_part(between, [&](double share, const LobeCut* low, const LobeCut* high) {
    ++parts;
    for (int j = 0; j < 121; ++j)
      if ((!low || place[j] > low->place) && (!high || place[j] <= high->place)) sum[j] += share;
  });
  EXPECT_EQ(parts, 6);
  for (double each : sum) EXPECT_NEAR(each, 1.0, 1e-15);
}

/// Two humps of heights 1 and `second` with a valley of `level` between.
double joined(double level, double second) {
  const double place[] = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
  const double value[] = {0.0, 1.0, level + 0.01, level, level + 0.01, second, 0.0};
  const LobeCuts cuts = find_lobes(place, value, 0, 7);
  return cuts.count == 0 ? 1.0 : cuts.of[0].joined;
}

TEST(Lobes, PartDeepValleysAndJoinShallowOnesAndShoulders) {
  EXPECT_EQ(joined(0.2, 0.9), 0.0);
  EXPECT_EQ(joined(0.45, 0.9), 0.0);
  EXPECT_EQ(joined(0.91, 0.95), 1.0);
  EXPECT_EQ(joined(-0.1, 0.5), 0.0);
  EXPECT_NEAR(joined(0.7, 1.0), 0.5, 1e-12);
  EXPECT_GT(joined(0.3, 0.32), 0.1);  // hardly a hump, however low
  double before = 0.0;
  for (double level = 0.3; level < 0.98; level += 1e-3) {
    const double here = joined(level, 0.99);
    EXPECT_GE(here, before);
    EXPECT_LT(here, before + 0.01) << level;
    before = here;
  }
  EXPECT_EQ(before, 1.0);
}

TEST(Lobes, CutsMoveContinuouslyFromStripToStrip) {
  double before = 0.0;
  for (double middle = 4.0; middle < 6.0; middle += 0.01) {
    double place[11], value[11];
    for (int j = 0; j < 11; ++j) {
      place[j] = j;
      value[j] = 0.1 + 0.04 * (j - middle) * (j - middle);
    }
    value[0] = value[10] = 0.0;
    const LobeCuts cuts = find_lobes(place, value, 0, 11);
    ASSERT_EQ(cuts.count, 1);
    EXPECT_NEAR(cuts.of[0].place, middle, 1e-9);
    EXPECT_NEAR(cuts.of[0].value, 0.1, 1e-12);
    EXPECT_GT(cuts.of[0].place, before);
    before = cuts.of[0].place;
  }
}

/// A flat rail of strips `width` wide under wheels: overlap = largest over the wheels of
/// depth - y^2 / (2 radius) - x^2 / (2 rolling radius), y from each.
struct FlatRail {
  struct Wheel {
    double y, depth, radius;
  };
  std::vector<double> s, width, y, z, ty, tz;
  std::vector<std::int32_t> strip;
  std::vector<double> depth, centre, curvature, normal, along;
  std::vector<double> length_squared, peak_per_length, middle, line_load, workspace;
  RailStrips rail;
  Overlaps overlaps;
  StripPressure pressure;

  explicit FlatRail(double strip_width) {
    for (double at = -30e-3; at < 30e-3; at += strip_width) {
      s.push_back(at);
      width.push_back(strip_width);
    }
    rail.count = static_cast<std::int32_t>(s.size());
    rail.s = s.data();
    rail.width = width.data();
    rail.ranges = 1;
    rail.range[0] = {0, rail.count, 0.0, 0.0, 0.0};
  }
  PlanarResult press(const PlanarMethod& method, const std::vector<Wheel>& wheels) {
    strip.clear();
    depth.clear();
    for (std::size_t j = 0; j < s.size(); ++j) {
      double most = -1.0;
      for (const Wheel& wheel : wheels) {
        const double away = s[j] - wheel.y;
        most = std::max(most, wheel.depth - 0.5 * away * away / wheel.radius);
      }
      if (most < -planar_margin) continue;
      strip.push_back(static_cast<std::int32_t>(j));
      depth.push_back(most);
    }
    const std::size_t n = strip.size();
    centre.assign(n, 1e-3);
    curvature.assign(n, 1.0 / 0.46);
    for (auto* each : {&length_squared, &peak_per_length, &middle, &line_load}) each->assign(n, 0.0);
    overlaps.capacity = overlaps.count = static_cast<std::int32_t>(n);
    overlaps.strip = strip.data();
    overlaps.depth = depth.data();
    overlaps.centre = centre.data();
    overlaps.curvature = curvature.data();
    pressure = {length_squared.data(), peak_per_length.data(), middle.data(), line_load.data()};
    workspace.assign(static_cast<std::size_t>(planar_pressure_doubles(overlaps.capacity, method)), 0.0);
    return solve_planar_pressure(rail, overlaps, method, test::steel, kernels_for(InstructionSet::baseline),
                                 workspace.data(), pressure);
  }
  double load() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < strip.size(); ++i) sum += 0.5 * pi * width[0] * line_load[i];
    return sum;
  }
};

Fault kik_piotrowski(const normal::NormalProblem& problem, patch::Strips& strips,
                     normal::NormalSolution& solution) {
  return normal::solve_kik_piotrowski(problem, {}, strips, solution);
}
Fault ekp(const normal::NormalProblem& problem, patch::Strips& strips, normal::NormalSolution& solution) {
  return normal::solve_ekp(problem, {normal::EkpScale::area}, strips, solution);
}
Fault ekp_ellipse(const normal::NormalProblem& problem, patch::Strips& strips,
                  normal::NormalSolution& solution) {
  return normal::solve_ekp(problem, {normal::EkpScale::ellipse}, strips, solution);
}

struct Named {
  const char* name;
  decltype(PlanarMethod::solve) solve;
  double error;  ///< of the load of an ellipse
};
constexpr Named methods[] = {{"hertz", normal::solve_hertz, 2e-3},
                             {"kik_piotrowski", kik_piotrowski, 0.15},
                             {"ekp", ekp, 0.02},
                             {"ekp_ellipse", ekp_ellipse, 5e-3},
                             {"analyn", normal::solve_analyn, 5e-3},
                             {"stripes", normal::solve_stripes, 5e-3}};

PlanarMethod planar(const Named& method) { return {method.solve, 60, 40, 1e-9}; }

TEST(PlanarMethodsOnASurface, GiveTheEllipseOfAnEllipticOverlap) {
  for (const Named& method : methods) {
    FlatRail flat(0.2e-3);
    const PlanarResult result = flat.press(planar(method), {{0.03e-3, 60e-6, 0.3}});
    EXPECT_EQ(result.fault.status, WRC_OK) << method.name;
    EXPECT_FALSE(result.jumps);
    const normal::HertzEllipse hertz =
        normal::hertz_ellipse(0.5 / 0.46, 0.5 / 0.3, 60e-6, test::steel.normal_compliance());
    EXPECT_NEAR(flat.load(), hertz.normal_force, method.error * hertz.normal_force) << method.name;
    double moment = 0.0, longest = 0.0;
    for (std::size_t i = 0; i < flat.strip.size(); ++i) {
      const double N = 0.5 * pi * flat.width[0] * flat.line_load[i];
      moment += N * flat.s[static_cast<std::size_t>(flat.strip[i])];
      longest = std::max(longest, std::sqrt(flat.length_squared[i]));
      EXPECT_NEAR(flat.middle[i], flat.line_load[i] > 0.0 ? 1e-3 : 0.0, 1e-9);
    }
    EXPECT_NEAR(moment / flat.load(), 0.03e-3, 1e-6) << method.name;
    EXPECT_NEAR(longest, hertz.a, 0.12 * hertz.a) << method.name;
  }
}

TEST(PlanarMethodsOnASurface, TakeRegionsApartOneByOne) {
  for (const Named& method : methods) {
    FlatRail flat(0.25e-3);
    flat.press(planar(method), {{-15e-3, 50e-6, 0.25}});
    const double left = flat.load();
    flat.press(planar(method), {{15e-3, 20e-6, 0.05}});
    const double right = flat.load();
    flat.press(planar(method), {{-15e-3, 50e-6, 0.25}, {15e-3, 20e-6, 0.05}});
    EXPECT_NEAR(flat.load(), left + right, 1e-9 * left) << method.name;
    EXPECT_GT(right, 0.0);
  }
}

/// Two wheels come together, from apart to one patch, and the lower one gets the deeper one: where a lone
/// lowest point leaps.
TEST(PlanarMethodsOnASurface, DoNotLeapWhereRegionsJoinOrDeepestPointsChange) {
  for (const Named& method : methods) {
    double jump = 0.0;
    for (const bool together : {true, false}) {
      std::vector<double> loads;
      FlatRail flat(0.25e-3);
      for (int i = 0; i <= 4000; ++i) {
        const double t = i / 4000.0;
        const double apart = together ? 20e-3 * (1.0 - t) : 7.5e-3;
        const double deeper = together ? 0.0 : 10e-6 * (2.0 * t - 1.0);
        flat.press(planar(method), {{0.0, 60e-6, 0.3}, {apart, 60e-6 + deeper, 0.2}});
        loads.push_back(flat.load());
        if (i > 1) {
          const double here = std::abs(loads[i] - 2.0 * loads[i - 1] + loads[i - 2]) / loads[i];
          jump = std::max(jump, here);
        }
      }
    }
    std::printf("%s: largest second difference of the load %.1e\n", method.name, jump);
    EXPECT_LT(jump, 6e-3) << method.name;
  }
}

TEST(PlanarMethodsOnASurface, StartAtZeroAsTheOverlapDoes) {
  for (const Named& method : methods) {
    FlatRail flat(0.25e-3);
    double before = 0.0;
    for (double depth = -1e-6; depth < 3e-6; depth += 1e-8) {
      flat.press(planar(method), {{0.11e-3, depth, 0.02}});
      EXPECT_LT(flat.load(), depth > 0.0 ? 1e5 : 1.0) << method.name;
      EXPECT_LT(flat.load() - before, 3.0) << method.name << depth;
      EXPECT_GE(flat.load() - before, -1e-9) << method.name << depth;
      before = flat.load();
    }
    EXPECT_GT(before, 10.0);
  }
}

TEST(RegionRolling, ShapeOfALoadIsThatOfTheDoubleEllipseThatHasIt) {
  for (const double psi : {0.0, 0.3, -0.6, 0.9}) {
    const double a = 5e-3, b = 3e-3;
    const test::OwnedStrips owned = test::sdec_strips(a, b, psi, 80e3, 4000);
    const patch::Strips& s = owned.get();
    double load = 0.0, mean = 0.0, squares = 0.0, variance = 0.0, third = 0.0;
    const auto N = [&](int j) { return 0.5 * pi * s.half_length[j] * s.peak[j] * s.width[j]; };
    for (int j = 0; j < s.count; ++j) {
      load += N(j);
      mean += N(j) * s.y[j];
    }
    mean /= load;
    EXPECT_NEAR(mean, 0.75 * psi * b, 1e-6 * b);
    for (int j = 0; j < s.count; ++j) {
      const double y = s.y[j] - mean;
      squares += N(j) * s.half_length[j] * s.half_length[j] / load;
      variance += N(j) * y * y / load;
      third += N(j) * y * y * y / load;
    }
    const patch::Sdec found = sdec_of_load(squares, variance, third);
    EXPECT_NEAR(found.a, a, 1e-4 * a);
    EXPECT_NEAR(found.b, b, 1e-4 * b);
    EXPECT_NEAR(found.psi, psi, 1e-3);
  }
}

/// Strips side by side as roll_by_region() takes them.
struct Patches {
  std::vector<double> place, width, half_length, peak, curvature, slip_x, slip_y, spin, friction, along;
  std::vector<double> fx, fy, mz;
  double load = 0.0;

  void add(const patch::Strips& s, double at, const tangential::Creepage& c, double mu) {
    for (int j = 0; j < s.count; ++j) {
      place.push_back(at + s.y[j]);
      width.push_back(s.width[j]);
      half_length.push_back(s.half_length[j]);
      peak.push_back(s.peak[j]);
      curvature.push_back(2.0);
      slip_x.push_back(c.longitudinal - c.spin * s.y[j]);
      slip_y.push_back(c.lateral);
      spin.push_back(c.spin);
      friction.push_back(mu);
      along.push_back(s.centre[j]);
    }
  }
  /// Sums of the forces and of the moment about `at`, of strips from `from` on.
  tangential::TangentialForces roll(const RegionRolling& method, const tangential::MarchGrid& grid, double at,
                                    std::size_t from = 0) {
    SurfaceRollingInput in;
    in.count = static_cast<std::int32_t>(place.size());
    in.place = place.data();
    in.width = width.data();
    in.half_length = half_length.data();
    in.peak = peak.data();
    in.curvature = curvature.data();
    in.slip_x = slip_x.data();
    in.slip_y = slip_y.data();
    in.spin = spin.data();
    in.friction = friction.data();
    in.shear_modulus = in.normal_shear_modulus = 82e9;
    in.grid = &grid;
    for (auto* each : {&fx, &fy, &mz}) each->assign(place.size(), 0.0);
    std::vector<double> workspace(static_cast<std::size_t>(region_rolling_doubles(in.count, method)));
    const Fault fault =
        roll_by_region({in, along.data()}, method, workspace.data(), {}, {fx.data(), fy.data(), mz.data()});
    EXPECT_EQ(fault.status, WRC_OK);
    tangential::TangentialForces sum;
    for (std::size_t j = from; j < place.size(); ++j) {
      sum.fx += fx[j];
      sum.fy += fy[j];
      sum.mz += mz[j] - (place[j] - at) * fx[j] + along[j] * fy[j];
    }
    return sum;
  }
};

TEST(RegionRolling, OfADoubleEllipseIsTheMethodOnIt) {
  const theory::SdecTable table(0.28);
  const test::OwnedGrid grid(32);
  const double a = 5e-3, b = 4e-3, N = 80e3, mu = 0.3;
  for (const double psi : {0.0, 0.4}) {
    const test::OwnedStrips owned = test::sdec_strips(a, b, psi, N, 200);
    for (const tangential::PatchModel& model :
         {tangential::patch_with_sdec, tangential::patch_with_ellipse, tangential::ellipse_at_point}) {
      if (model.on_ellipse && psi != 0.0) continue;
      const tangential::Creepage creepage{8e-4, -5e-4, 0.25};
      tangential::RollingContact contact;
      contact.region = owned.get();
      contact.a = a;
      contact.b = b;
      contact.shape_number = psi;
      contact.shear_modulus = 82e9;
      contact.linear_theory = &table;
      contact.grid = &grid.get();
      contact.creepage = creepage;
      contact.friction = {mu};
      contact.model = model;
      contact.normal_force = N;
      Fault fault;
      const tangential::TangentialForces exact = tangential::fastsim(contact, {}, fault);
      Patches patches;
      patches.add(owned.get(), 10e-3, creepage, mu);
      const RegionRolling method{.solve = tangential::fastsim, .model = model, .linear_theory = &table};
      const tangential::TangentialForces found = patches.roll(method, grid.get(), 10e-3);
      EXPECT_NEAR(found.fx, exact.fx, 2e-3 * mu * N);
      EXPECT_NEAR(found.fy, exact.fy, 2e-3 * mu * N);
      EXPECT_NEAR(found.mz, exact.mz, 2e-3 * mu * N * b);
      // another patch beside it changes nothing
      Patches both;
      both.add(owned.get(), -10e-3, {-1e-3, 2e-3, 0.0}, mu);
      both.add(owned.get(), 10e-3, creepage, mu);
      const tangential::TangentialForces beside = both.roll(method, grid.get(), 10e-3, 200);
      EXPECT_NEAR(beside.fx, found.fx, 1e-9 * mu * N);
      EXPECT_NEAR(beside.fy, found.fy, 1e-9 * mu * N);
      EXPECT_NEAR(beside.mz, found.mz, 1e-9 * mu * N * b);
    }
  }
}

/// Two ellipses grow together.
TEST(RegionRolling, DoesNotLeapWherePatchesJoin) {
  const theory::SdecTable table(0.28);
  const test::OwnedGrid grid(16);
  const RegionRolling method{.solve = tangential::fastsim, .linear_theory = &table};
  double jump = 0.0;
  std::vector<double> fx, fy;
  for (int i = 0; i <= 1000; ++i) {
    const double apart = 9e-3 - 6e-6 * i;
    Patches patches;
    double load = 0.0;
    for (double y = -10e-3; y < 10e-3; y += 0.25e-3) {
      double squared = 0.0;
      for (const double middle : {-0.5 * apart, 0.5 * apart}) {
        const double t = (y - middle) / 3.5e-3;
        squared = std::max(squared, 25e-6 * (1.0 - t * t));
      }
      if (!(squared > 0.0)) continue;
      const double l = std::sqrt(squared);
      double strip[] = {0.0, 0.25e-3, 0.0, l, 2e11 * l};
      patches.add({1, 1, strip, strip + 1, strip + 2, strip + 3, strip + 4}, y, {1e-3 - 0.3 * y, 5e-4, 0.3},
                  0.3);
      load += 0.5 * pi * l * l * 2e11 * 0.25e-3;
    }
    const tangential::TangentialForces found = patches.roll(method, grid.get(), 0.0);
    fx.push_back(found.fx / load);
    fy.push_back(found.fy / load);
    for (const auto* each : {&fx, &fy}) {
      const std::size_t n = each->size();
      if (n > 2) jump = std::max(jump, std::abs((*each)[n - 1] - 2.0 * (*each)[n - 2] + (*each)[n - 3]));
    }
  }
  std::printf("largest second difference of force over load %.1e\n", jump);
  EXPECT_LT(jump, 5e-4);
}

}  // namespace
}  // namespace wrc::surface
