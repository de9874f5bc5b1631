/// wrc_offline.h through the shared library: what it refuses, how it is cancelled, and that its answers are
/// those of closed forms. Links nothing of the library's inside.
#include <gtest/gtest.h>
#if !defined(_WIN32)
#include <sys/resource.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "offline_helpers.hpp"
#include "test_config.hpp"

namespace {

using namespace offline_helpers;

std::vector<double> field(const wrc_grid& grid, const std::function<double(double, double)>& value) {
  std::vector<double> out;
  for (uint32_t j = 0; j < grid.ny; ++j) {
    for (uint32_t i = 0; i < grid.nx; ++i) out.push_back(value(grid.x0 + i * grid.dx, grid.y0 + j * grid.dy));
  }
  return out;
}

/// A struct of a newer header: a member that this library does not know.
template <typename Struct>
struct Newer {
  Struct known{};
  double beyond = 0.0;  ///< without padding before it: structs of the interface are multiples of 8 bytes
};

TEST(OfflineDefaults, AreStatedOnesAndRefuseWrongSizes) {
  const auto sizes_count = [](auto value, auto init) {
    EXPECT_EQ(init(nullptr), WRC_ERROR_NULL);
    for (const std::size_t bad : {std::size_t{0}, std::size_t{8}, sizeof value + 1032}) {
      value.struct_size = static_cast<uint32_t>(bad);
      EXPECT_EQ(init(&value), WRC_ERROR_STRUCT_SIZE) << bad;
    }
    Newer<decltype(value)> newer;
    newer.beyond = 7.0;
    newer.known.struct_size = sizeof newer;
    EXPECT_EQ(init(&newer.known), WRC_OK);
    EXPECT_EQ(newer.known.struct_size, sizeof newer);
    EXPECT_EQ(newer.beyond, 0.0);
  };
  sizes_count(wrc_exact_normal_problem{}, wrc_exact_normal_problem_init);
  sizes_count(wrc_exact_rolling_problem{}, wrc_exact_rolling_problem_init);
  sizes_count(wrc_exact_loads{}, wrc_exact_loads_init);
  sizes_count(wrc_exact_check_options{}, wrc_exact_check_options_init);
  sizes_count(wrc_exact_wrench_options{}, wrc_exact_wrench_options_init);

  const auto normal = wrc_exact_normal_problem_default();
  EXPECT_EQ(normal.wheel_material.shear_modulus, 82e9);
  EXPECT_EQ(normal.rail_material.poisson, 0.28);
  EXPECT_EQ(normal.prescribed, WRC_PRESCRIBE_NORMAL_FORCE);
  EXPECT_EQ(normal.max_iterations, 1000);
  EXPECT_EQ(normal.tolerance, 1e-6);
  const auto rolling = wrc_exact_rolling_problem_default();
  EXPECT_EQ(rolling.wheel_material.poisson, 0.28);
  EXPECT_EQ(rolling.rail_material.shear_modulus, 82e9);
  EXPECT_EQ(rolling.adhesion, WRC_ADHESION_COULOMB);
  EXPECT_EQ(rolling.collocation, WRC_COLLOCATION_QUARTER_POINT);
  EXPECT_EQ(rolling.max_iterations, 60);
  EXPECT_EQ(rolling.coefficient, 0.3);
}

// ------------------------------------------------------------------------------------------------ normal
// problem

/// A ball of radius R on a plane, both of the material, or of two.
class ExactNormal : public testing::Test {
 protected:
  static constexpr double radius = 0.5, load = 50e3;
  wrc_exact_normal_problem problem = of_the_papers_steel(wrc_exact_normal_problem_default());
  wrc_grid& grid = problem.grid = grid_over(7e-3, 7e-3, 64);
  wrc_material &of_wheel = problem.wheel_material, &of_rail = problem.rail_material;
  std::vector<double> gap = field(grid, [](double x, double y) { return (x * x + y * y) / (2.0 * radius); });
  std::vector<double> pressure = std::vector<double>(gap.size(), 7.0);
  wrc_exact_normal_solution solution = sized<wrc_exact_normal_solution>();
  char text[256] = "";

  void SetUp() override {
    problem.normal_force = load;
    problem.gap = gap.data();
    solution.pressure = pressure.data();
  }
  int32_t solve() { return wrc_exact_normal(&problem, &solution, text, sizeof text); }
  void expect_refused(int32_t status, const std::vector<std::string>& words) {
    solution.normal_force = solution.approach = solution.peak_pressure = 7.0;
    EXPECT_EQ(solve(), status) << text;
    for (const std::string& word : words)
      EXPECT_NE(std::string(text).find(word), std::string::npos) << word << " in: " << text;
    EXPECT_EQ(solution.normal_force, 0.0);
    EXPECT_EQ(solution.approach, 0.0);
    EXPECT_EQ(solution.peak_pressure, 0.0);
    EXPECT_EQ(solution.pressure, pressure.data());
    EXPECT_EQ(wrc_exact_normal(&problem, &solution, nullptr, 0), status);
  }
  /// Hertz: a^3 = 3 N R / (4 E*), approach a^2 / R, peak 1.5 N / (pi a^2).
  void expect_hertz(double contact_modulus) {
    ASSERT_EQ(solve(), WRC_OK) << text;
    EXPECT_STREQ(text, "");
    const double a = std::cbrt(0.75 * load * radius / contact_modulus);
    EXPECT_NEAR(solution.approach / (a * a / radius), 1.0, 5e-3);
    EXPECT_NEAR(solution.peak_pressure / (1.5 * load / (pi * a * a)), 1.0, 5e-3);
    EXPECT_NEAR(solution.normal_force / load, 1.0, 1e-9);
  }
};

TEST_F(ExactNormal, EqualBodiesAreHertz) { expect_hertz(80e9 / (1.0 - 0.25)); }

// 1/E* = (1-nu1)/(2 G1) + (1-nu2)/(2 G2), Johnson 4.2: a steel wheel on a body five times as stiff, and on
// rubber-like (incompressible) one. The normal problem alone has no need of K = 0 but for the neglected
// coupling.
TEST_F(ExactNormal, UnlikeBodiesAreHertzWithTheirCombinedModulus) {
  of_rail.shear_modulus = 400e9;
  of_rail.poisson = 0.1;
  expect_hertz(1.0 / ((1.0 - 0.25) / 160e9 + (1.0 - 0.1) / 800e9));
  of_rail.shear_modulus = 60e9;
  of_rail.poisson = 0.5;
  expect_hertz(1.0 / ((1.0 - 0.25) / 160e9 + (1.0 - 0.5) / 120e9));
}

// Load to approach and back.
TEST_F(ExactNormal, ApproachIsTheInverseOfLoad) {
  ASSERT_EQ(solve(), WRC_OK);
  problem.prescribed = WRC_PRESCRIBE_APPROACH;
  problem.approach = solution.approach;
  ASSERT_EQ(solve(), WRC_OK);
  EXPECT_NEAR(solution.normal_force / load, 1.0, 1e-4);
}

TEST_F(ExactNormal, FieldsThatAreNotWantedAreNotNeeded) {
  ASSERT_EQ(solve(), WRC_OK);
  const double peak = solution.peak_pressure;
  EXPECT_EQ(*std::max_element(pressure.begin(), pressure.end()), peak);
  solution.pressure = nullptr;
  ASSERT_EQ(solve(), WRC_OK);
  EXPECT_EQ(solution.peak_pressure, peak);
}

TEST_F(ExactNormal, RefusesNullAndWrongSizes) {
  EXPECT_EQ(wrc_exact_normal(nullptr, &solution, text, sizeof text), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_exact_normal(&problem, nullptr, text, sizeof text), WRC_ERROR_NULL);
  problem.gap = nullptr;
  expect_refused(WRC_ERROR_NULL, {"problem.gap"});
  problem.gap = gap.data();
  const uint32_t columns = std::exchange(grid.nx, 0U);
  expect_refused(WRC_ERROR_RANGE, {"problem.grid.nx", "was it set?"});
  grid.nx = columns;
  problem.prescribed = WRC_PRESCRIBE_HEIGHT;
  expect_refused(WRC_ERROR_UNSUPPORTED, {"problem.prescribed", "WRC_PRESCRIBE_NORMAL_FORCE (2)"});
  problem.prescribed = WRC_PRESCRIBE_NORMAL_FORCE;
  Newer<wrc_exact_normal_problem> newer{.known = problem};
  newer.known.struct_size = sizeof newer;
  EXPECT_EQ(wrc_exact_normal(&newer.known, &solution, text, sizeof text), WRC_OK) << text;
  newer.beyond = 1.0;
  EXPECT_EQ(wrc_exact_normal(&newer.known, &solution, text, sizeof text), WRC_ERROR_STRUCT_SIZE);
  EXPECT_NE(std::string(text).find("beyond what this library knows"), std::string::npos) << text;
  for (const uint32_t bad : {0U, 8U, 4096U}) {
    problem.struct_size = bad;
    expect_refused(WRC_ERROR_STRUCT_SIZE, {"struct_size", "sizeof the struct"});
  }
  problem.struct_size = sizeof problem;
  solution.struct_size = 4;
  EXPECT_EQ(solve(), WRC_ERROR_STRUCT_SIZE);
  solution.struct_size = sizeof solution;
  EXPECT_EQ(solve(), WRC_OK);
}

TEST_F(ExactNormal, NamesWhatIsNotFinite) {
  gap[70] = nan_value;
  expect_refused(WRC_ERROR_NOT_FINITE, {"problem.gap[70]"});
  EXPECT_EQ(*std::max_element(pressure.begin(), pressure.end()), 0.0);
  gap[70] = 0.0;
  grid.y0 = nan_value;
  expect_refused(WRC_ERROR_NOT_FINITE, {"grid.y0"});
  grid.y0 = 0.0;
  problem.normal_force = nan_value;
  expect_refused(WRC_ERROR_NOT_FINITE, {"problem.normal_force"});
}

TEST_F(ExactNormal, NamesTheWrongUnit) {
  grid.dx = 0.2;
  expect_refused(WRC_ERROR_RANGE, {"grid.dx = 0.2 m", "mm"});
  grid.dx = 2e-4;
  grid.nx = 2000;
  expect_refused(WRC_ERROR_RANGE, {"grid.nx = 2000", "4 .. 1024"});
  grid.nx = 64;
  of_wheel.shear_modulus = 80e3;
  expect_refused(WRC_ERROR_RANGE, {"wheel_material.shear_modulus = 80000 Pa", "MPa"});
  of_wheel.shear_modulus = 0.0;  // would divide by zero
  expect_refused(WRC_ERROR_RANGE, {"wheel_material.shear_modulus = 0 Pa"});
  of_wheel.shear_modulus = 80e9;
  problem.normal_force = -load;
  expect_refused(WRC_ERROR_RANGE, {"problem.normal_force", "compressive"});
  problem.normal_force = load;
  problem.prescribed = WRC_PRESCRIBE_APPROACH;
  problem.approach = 50.0;
  expect_refused(WRC_ERROR_RANGE, {"problem.approach = 50 m", "mm"});
  problem.prescribed = 9;
  expect_refused(WRC_ERROR_UNSUPPORTED, {"problem.prescribed"});
}

TEST_F(ExactNormal, NoContactIsAFlagWithZeros) {
  problem.prescribed = WRC_PRESCRIBE_APPROACH;
  problem.approach = -1e-6;
  EXPECT_EQ(solve(), WRC_FLAG_NO_CONTACT);
  EXPECT_EQ(solution.normal_force, 0.0);
  EXPECT_EQ(solution.area, 0.0);
  EXPECT_EQ(solution.approach, -1e-6);
}

TEST_F(ExactNormal, PatchAtTheEdgeOfTheGridIsFlagged) {
  grid.x0 += 4e-3;
  gap = field(grid, [](double x, double y) { return (x * x + y * y) / (2.0 * radius); });
  problem.gap = gap.data();
  EXPECT_EQ(solve(), WRC_FLAG_PATCH_AT_EDGE);
  EXPECT_NEAR(solution.normal_force / load, 1.0, 1e-9);
}

TEST_F(ExactNormal, IterationCapIsAFlag) {
  problem.max_iterations = 2;
  EXPECT_EQ(solve(), WRC_FLAG_ITERATION_CAP);
  EXPECT_GT(solution.residual, problem.tolerance);
  EXPECT_EQ(solution.iterations, 2);
  EXPECT_NE(std::string(text).find("solution.residual = "), std::string::npos) << text;
  EXPECT_NE(std::string(text).find("problem.max_iterations"), std::string::npos) << text;
}

TEST_F(ExactNormal, ReportsProgressAndIsCancelled) {
  Listener listener;
  problem.progress = Listener::hear;
  problem.user = &listener;
  ASSERT_EQ(solve(), WRC_OK);
  ASSERT_GT(listener.fractions.size(), 5u);
  for (const double fraction : listener.fractions) {
    EXPECT_GE(fraction, 0.0);
    EXPECT_LE(fraction, 1.0);
  }
  listener = {.allowed = 3, .fractions = {}};
  EXPECT_EQ(solve(), WRC_ERROR_CANCELLED);
  EXPECT_EQ(listener.fractions.size(), 4u);
  EXPECT_EQ(solution.normal_force, 0.0);
  EXPECT_EQ(*std::max_element(pressure.begin(), pressure.end()), 0.0);
  problem.progress = nullptr;
  EXPECT_EQ(solve(), WRC_OK);
}

// -------------------------------------------------------------------------------------------------------
// rolling

/// A semi-elliptic pressure on an ellipse, 2/3 pi a b p0 = load.
class ExactRolling : public testing::Test {
 protected:
  static constexpr double a = 5e-3, b = 4e-3, peak = 1e9, friction_coefficient = 0.3;
  static constexpr double load = 2.0 / 3.0 * pi * a * b * peak;
  wrc_exact_rolling_problem problem = of_the_papers_steel(wrc_exact_rolling_problem_default());
  wrc_grid& grid = problem.grid = grid_over(a, b, 32);
  wrc_creepage& creepage = problem.creepage;
  wrc_material &of_wheel = problem.wheel_material, &of_rail = problem.rail_material;
  std::vector<double> pressure = field(grid, [](double x, double y) {
    return peak * std::sqrt(std::max(0.0, 1.0 - x * x / (a * a) - y * y / (b * b)));
  });
  std::vector<double> friction = std::vector<double>(pressure.size(), friction_coefficient);
  std::vector<double> traction_x = std::vector<double>(pressure.size(), 7.0), traction_y = traction_x,
                      slip_x = traction_x, slip_y = traction_x;
  wrc_exact_rolling_solution solution = sized<wrc_exact_rolling_solution>();
  char text[256] = "";

  void SetUp() override {
    creepage.longitudinal = 1e-3;
    creepage.lateral = -5e-4;
    creepage.spin = 0.3;
    problem.pressure = pressure.data();
    solution.traction_x = traction_x.data();
    solution.traction_y = traction_y.data();
    solution.slip_x = slip_x.data();
    solution.slip_y = slip_y.data();
  }
  int32_t solve() { return wrc_exact_rolling(&problem, &solution, text, sizeof text); }
  void expect_zero() {
    EXPECT_EQ(solution.fx, 0.0);
    EXPECT_EQ(solution.fy, 0.0);
    EXPECT_EQ(solution.mz, 0.0);
    EXPECT_EQ(solution.power, 0.0);
    EXPECT_EQ(solution.power_by_balance, 0.0);
  }
  void expect_fields_zero() {
    for (const auto* each : {&traction_x, &traction_y, &slip_x, &slip_y}) {
      EXPECT_TRUE(std::all_of(each->begin(), each->end(), [](double v) { return v == 0.0; }));
    }
  }
  void expect_refused(int32_t status, const std::vector<std::string>& words) {
    solution.fx = solution.fy = solution.mz = solution.power = solution.power_by_balance = 7.0;
    EXPECT_EQ(solve(), status) << text;
    for (const std::string& word : words)
      EXPECT_NE(std::string(text).find(word), std::string::npos) << word << " in: " << text;
    expect_zero();
  }
};

TEST_F(ExactRolling, ForcesAreTheSumsOfTheTractionsItHandsOut) {
  creepage.speed = 40.0;
  ASSERT_EQ(solve(), WRC_OK) << text;
  double fx = 0.0, fy = 0.0, power = 0.0;
  for (std::size_t k = 0; k < pressure.size(); ++k) {
    fx += traction_x[k] * grid.dx * grid.dy;
    fy += traction_y[k] * grid.dx * grid.dy;
    power -= (traction_x[k] * slip_x[k] + traction_y[k] * slip_y[k]) * grid.dx * grid.dy * 40.0;
  }
  EXPECT_NEAR(solution.fx, fx, 1e-9 * load);
  EXPECT_NEAR(solution.fy, fy, 1e-9 * load);
  EXPECT_NEAR(solution.power / power, 1.0, 1e-9);
  EXPECT_NEAR(solution.power_by_balance,
              -40.0 * (solution.fx * 1e-3 - solution.fy * 5e-4 + solution.mz * 0.3), 1e-9 * power);
  EXPECT_LT(solution.fx, 0.0);  // opposes the slip
  EXPECT_GT(solution.adhesion_fraction, 0.0);
  EXPECT_LT(solution.adhesion_fraction, 1.0);
  EXPECT_LE(solution.residual, problem.tolerance);
}

TEST_F(ExactRolling, FieldsThatAreNotWantedAreNotNeeded) {
  ASSERT_EQ(solve(), WRC_OK);
  const double fx = solution.fx;
  solution.traction_x = solution.traction_y = solution.slip_x = solution.slip_y = nullptr;
  ASSERT_EQ(solve(), WRC_OK);
  EXPECT_EQ(solution.fx, fx);
}

// Two zones across the patch, dry and lubricated: each carries its own Coulomb bound.
TEST_F(ExactRolling, FrictionOfTwoZonesBoundsEachZone) {
  for (uint32_t j = 0; j < grid.ny; ++j)
    for (uint32_t i = 0; i < grid.nx; ++i)
      friction[j * grid.nx + i] = grid.y0 + j * grid.dy > 0.0 ? 0.4 : 0.05;
  problem.friction = friction.data();
  ASSERT_EQ(solve(), WRC_OK) << text;
  int at_bound[2] = {0, 0};
  for (std::size_t k = 0; k < pressure.size(); ++k) {
    const double bound = friction[k] * pressure[k];
    const double traction = std::hypot(traction_x[k], traction_y[k]);
    EXPECT_LE(traction, bound + 1e-3 * friction[k] * peak);
    if (pressure[k] > 0.0 && traction > 0.999 * bound) ++at_bound[friction[k] > 0.1];
  }
  EXPECT_GT(at_bound[0], 300);  // of about 400: nearly all of the lubricated half slips
  EXPECT_GT(at_bound[1], 30);
  creepage = wrc_creepage_default();
  creepage.longitudinal = 0.1;  // everything slips: the halves' forces add up
  ASSERT_EQ(solve(), WRC_OK);
  EXPECT_NEAR(solution.fx / (-0.225 * load), 1.0, 5e-3);
}

TEST_F(ExactRolling, FrictionOfOneValueIsTheCoefficient) {
  ASSERT_EQ(solve(), WRC_OK);
  const double fx = solution.fx;
  problem.friction = friction.data();
  problem.coefficient = nan_value;  // not read
  ASSERT_EQ(solve(), WRC_OK);
  EXPECT_NEAR(solution.fx / fx, 1.0, 1e-9);
}

// Linear theory: no scale of creepage. Doubling all three doubles all, and friction plays no part.
TEST_F(ExactRolling, FullAdhesionIsLinearInTheCreepages) {
  problem.adhesion = WRC_ADHESION_FULL;
  problem.tolerance = 1e-9;
  problem.coefficient = nan_value;
  ASSERT_EQ(solve(), WRC_OK) << text;
  const wrc_exact_rolling_solution once = solution;
  creepage.longitudinal *= 200.0;
  creepage.lateral *= 200.0;
  creepage.spin *= 200.0;
  ASSERT_EQ(solve(), WRC_OK);
  EXPECT_NEAR(solution.fx / once.fx, 200.0, 1e-5);
  EXPECT_NEAR(solution.fy / once.fy, 200.0, 1e-5);
  EXPECT_NEAR(solution.mz / once.mz, 200.0, 1e-5);
  EXPECT_EQ(solution.adhesion_fraction, 1.0);
}

// Kalker's C11 = 4.12 * (a/b = 1, nu = 0.25; his printed table) on an ellipse a/b = 1; grid of 32: 2 %.
TEST_F(ExactRolling, FullAdhesionIsKalkersCoefficient) {
  grid = grid_over(a, a, 32);
  pressure = field(grid, [](double x, double y) { return x * x + y * y < a * a ? 1.0 : 0.0; });
  problem.pressure = pressure.data();
  problem.adhesion = WRC_ADHESION_FULL;
  creepage = wrc_creepage_default();
  creepage.longitudinal = 1e-4;
  ASSERT_EQ(solve(), WRC_OK) << text;
  EXPECT_NEAR(solution.fx / (-80e9 * a * a * 4.12 * 1e-4), 1.0, 0.02);
}

// 2/G = 1/G1 + 1/G2: 60 and 120 GPa roll like two bodies of 80 GPa when nu/G agrees too and (1 - 2 nu)/G is
// the same for both, without which pressure moves one surface along the other (Kalker's K).
TEST_F(ExactRolling, UnlikeBodiesRollLikeTheirCombinedMaterial) {
  ASSERT_EQ(solve(), WRC_OK);
  const double fx = solution.fx;
  of_wheel.shear_modulus = 60e9;
  of_rail.shear_modulus = 120e9;
  of_wheel.poisson = 0.3125;  // (1 - 2 * 0.3125)/60 = (1 - 2 * 0.125)/120
  of_rail.poisson = 0.125;    // (0.3125/60 + 0.125/120) / 2 = 0.25/80
  ASSERT_EQ(solve(), WRC_OK);
  EXPECT_NEAR(solution.fx / fx, 1.0, 1e-9);
}

TEST_F(ExactRolling, NoPressureIsNoContact) {
  std::fill(pressure.begin(), pressure.end(), 0.0);
  EXPECT_EQ(solve(), WRC_FLAG_NO_CONTACT) << text;
  expect_zero();
  expect_fields_zero();
}

TEST_F(ExactRolling, PatchAtTheEdgeOfTheGridIsNoErrorForPrescribedPressure) {
  pressure.assign(pressure.size(), peak);  // a punch as large as the grid
  ASSERT_EQ(solve(), WRC_OK);
  creepage.longitudinal = 0.5;
  creepage.lateral = creepage.spin = 0.0;
  ASSERT_EQ(solve(), WRC_OK);
  EXPECT_NEAR(solution.fx / (-0.3 * peak * 4.0 * a * b), 1.0, 1e-3);
}

TEST_F(ExactRolling, RefusesNullAndWrongSizes) {
  EXPECT_EQ(wrc_exact_rolling(nullptr, &solution, text, sizeof text), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_exact_rolling(&problem, nullptr, text, sizeof text), WRC_ERROR_NULL);
  problem.pressure = nullptr;
  expect_refused(WRC_ERROR_NULL, {"problem.pressure"});
  problem.pressure = pressure.data();
  problem.struct_size = 336;  // shorter than the first published one
  expect_refused(WRC_ERROR_STRUCT_SIZE, {"wrc_exact_rolling_problem"});
  problem.struct_size = sizeof problem;
  solution.struct_size = 1;
  EXPECT_EQ(solve(), WRC_ERROR_STRUCT_SIZE);
  solution.struct_size = sizeof solution;
  EXPECT_EQ(solve(), WRC_OK);
}

TEST_F(ExactRolling, NamesWhatIsNotFiniteOrOutOfRange) {
  pressure[33] = nan_value;
  expect_refused(WRC_ERROR_NOT_FINITE, {"problem.pressure[33]"});
  expect_fields_zero();
  pressure[33] = 0.0;
  problem.friction = friction.data();
  friction[44] = nan_value;
  expect_refused(WRC_ERROR_NOT_FINITE, {"problem.friction[44]"});
  friction[44] = 30.0;
  expect_refused(WRC_ERROR_RANGE, {"problem.friction[44] = 30"});
  problem.friction = nullptr;
  problem.coefficient = 30.0;
  expect_refused(WRC_ERROR_RANGE, {"problem.coefficient = 30", "per cent"});
  problem.coefficient = 0.3;
  creepage.longitudinal = 40.0;
  expect_refused(WRC_ERROR_RANGE, {"creepage.longitudinal = 40"});
  creepage.longitudinal = nan_value;
  expect_refused(WRC_ERROR_NOT_FINITE, {"creepage.longitudinal"});
  creepage.longitudinal = 1e-3;
  creepage.speed = 300.0;
  expect_refused(WRC_ERROR_RANGE, {"creepage.speed = 300 m/s", "km/h"});
  creepage.speed = 1.0;
  problem.adhesion = 2;
  expect_refused(WRC_ERROR_UNSUPPORTED, {"problem.adhesion"});
  problem.adhesion = WRC_ADHESION_COULOMB;
  problem.collocation = -1;
  expect_refused(WRC_ERROR_UNSUPPORTED, {"problem.collocation"});
  problem.collocation = WRC_COLLOCATION_QUARTER_POINT;
  EXPECT_EQ(solve(), WRC_OK);
}

TEST_F(ExactRolling, IterationCapIsAFlag) {
  problem.max_iterations = 1;
  EXPECT_EQ(solve(), WRC_FLAG_ITERATION_CAP);
  EXPECT_NE(solution.fx, 0.0);
}

TEST_F(ExactRolling, ReportsProgressThatGrowsAndIsCancelledAtAnyTime) {
  Listener listener;
  problem.progress = Listener::hear;
  problem.user = &listener;
  ASSERT_EQ(solve(), WRC_OK);
  ASSERT_GT(listener.fractions.size(), 2u);
  EXPECT_TRUE(std::is_sorted(listener.fractions.begin(), listener.fractions.end()));
  EXPECT_GE(listener.fractions.front(), 0.0);
  EXPECT_LE(listener.fractions.back(), 1.0);
  const int reports = static_cast<int>(listener.fractions.size());
  for (int allowed = 0; allowed < reports; ++allowed) {
    listener = {.allowed = allowed, .fractions = {}};
    EXPECT_EQ(solve(), WRC_ERROR_CANCELLED);
    EXPECT_EQ(static_cast<int>(listener.fractions.size()), allowed + 1);
    expect_zero();
    expect_fields_zero();
  }
  problem.progress = nullptr;
  EXPECT_EQ(solve(), WRC_OK);
}

// Sanitizers reserve the address space themselves; a limit on it would end the program.
#ifndef WRC_SANITIZED

/// While it lives, this process has 200 MB left. On Windows whoever starts the test sees to that.
class ShortMemory {
 public:
#if defined(_WIN32)
  ShortMemory() {}
#else
  ShortMemory() {
    EXPECT_EQ(getrlimit(RLIMIT_AS, &before_), 0);
    std::FILE* pages = std::fopen("/proc/self/statm", "r");
    unsigned long used = 0;
    EXPECT_TRUE(pages != nullptr && std::fscanf(pages, "%lu", &used) == 1);
    if (pages != nullptr) std::fclose(pages);
    const rlimit narrow = {used * 4096 + (std::size_t{200} << 20), before_.rlim_max};
    EXPECT_EQ(setrlimit(RLIMIT_AS, &narrow), 0);
  }
  ~ShortMemory() { EXPECT_EQ(setrlimit(RLIMIT_AS, &before_), 0); }
  ShortMemory(const ShortMemory&) = delete;
  ShortMemory& operator=(const ShortMemory&) = delete;

 private:
  rlimit before_{};
#endif
};

TEST_F(ExactRolling, MemoryThatIsNotThereIsAStatus) {
  grid = grid_over(a, b, 1024);
  const std::vector<double> flat(std::size_t{1024} * 1024, 1e6);
  problem.pressure = flat.data();
  solution.traction_x = solution.traction_y = solution.slip_x = solution.slip_y = nullptr;
  int32_t status = WRC_OK;
  {
    const ShortMemory now;  // 2 GB are needed
    status = solve();
  }
  EXPECT_EQ(status, WRC_ERROR_MEMORY) << text;
  expect_zero();
  EXPECT_NE(std::string(text).find("memory"), std::string::npos) << text;
}
#endif

}  // namespace
