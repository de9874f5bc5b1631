/// wrc_exact_transient_...: rolling step by step, through the shared library.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "offline_helpers.hpp"
#include "test_config.hpp"

namespace {

using namespace offline_helpers;

/// A patch under semi-elliptic pressure that rolls.
class Transient : public testing::Test {
 protected:
  wrc_exact_rolling_problem problem = of_the_papers_steel(wrc_exact_rolling_problem_default());
  wrc_exact_rolling_solution solution = sized<wrc_exact_rolling_solution>();
  std::vector<double> pressure;
  wrc_exact_transient* bodies = nullptr;
  char text[256] = "";

  ~Transient() override { wrc_exact_transient_destroy(bodies); }

  /// Half lengths a and, to both sides, b (1 -+ psi); the pressure is the reference's, that of cell centres.
  void press(double a, double b, double psi, double load, const wrc_grid& grid) {
    problem.grid = grid;
    pressure.clear();
    for (uint32_t j = 0; j < grid.ny; ++j) {
      const double y = grid.y0 + j * grid.dy, eta = y / (b * (1.0 + (y > 0.0 ? psi : -psi)));
      for (uint32_t i = 0; i < grid.nx; ++i) {
        const double xi = (grid.x0 + i * grid.dx) / a;
        pressure.push_back(1.5 * load / (pi * a * b) * std::sqrt(std::fmax(0.0, 1.0 - xi * xi - eta * eta)));
      }
    }
    problem.pressure = pressure.data();
  }

  void create() {
    ASSERT_EQ(wrc_exact_transient_create(&problem.grid, &problem.wheel_material, &problem.rail_material,
                                         &bodies, text, sizeof text),
              WRC_OK)
        << text;
  }

  int32_t step() { return wrc_exact_transient_step(bodies, &problem, &solution, text, sizeof text); }
};

TEST_F(Transient, FirstStepIsCattaneosShift) {
  // Nothing was displaced before, so the creepage of one step is a shift by delta = nu_x dx. Poisson's ratio
  // 0: slip is along x everywhere, as Cattaneo and Mindlin have it; delta_full = 3 mu N (2 / G) 2 / (16 a).
  const double a = 4e-3, load = 50e3, mu = 0.3, G = 80e9;
  press(a, a, 0.0, load, grid_over(1.02 * a, 1.02 * a, 48));
  problem.wheel_material.poisson = problem.rail_material.poisson = 0.0;
  problem.coefficient = mu;
  create();
  const double full = 3.0 * mu * load / (16.0 * a) * (4.0 / G);
  problem.creepage.longitudinal = -0.4 * full / problem.grid.dx;
  ASSERT_EQ(step(), WRC_OK) << text;
  EXPECT_NEAR(solution.fx / (mu * load), 1.0 - std::pow(0.6, 1.5), 0.006);
  EXPECT_NEAR(solution.adhesion_fraction, 0.6, 0.03);  // radius of the stuck circle: sqrt(1 - 0.4) a
}

TEST_F(Transient, ShiftsAtRestFollowMindlin) {
  // Cattaneo's first loading to 0.6 of the full shift, back to -0.2, both at rest: Q_1 - 2 mu N (1 - (1 -
  // (d_1 - d) / (2 d_full))^1.5). A step of no shift changes nothing. Poisson's ratio 0 as above.
  const double a = 4e-3, load = 50e3, mu = 0.3, G = 80e9;
  press(a, a, 0.0, load, grid_over(1.02 * a, 1.02 * a, 48));
  problem.wheel_material.poisson = problem.rail_material.poisson = 0.0;
  problem.coefficient = mu;
  problem.creepage.speed = 0.0;
  create();
  const double full = 3.0 * mu * load / (16.0 * a) * (4.0 / G);
  const double first = 1.0 - std::pow(0.4, 1.5), back = first - 2.0 * (1.0 - std::pow(0.6, 1.5));
  for (int k = 0; k < 3; ++k) {
    problem.creepage.longitudinal = -0.2 * full / problem.grid.dx;
    ASSERT_EQ(step(), WRC_OK) << text;
  }
  EXPECT_NEAR(solution.fx / (mu * load), first, 0.006);
  EXPECT_EQ(solution.power, 0.0);
  for (int k = 0; k < 4; ++k) {
    problem.creepage.longitudinal = 0.2 * full / problem.grid.dx;
    ASSERT_EQ(step(), WRC_OK) << text;
  }
  EXPECT_NEAR(solution.fx / (mu * load), back, 0.006);
  const double before = solution.fx;
  problem.creepage.longitudinal = 0.0;
  ASSERT_EQ(step(), WRC_OK) << text;
  EXPECT_NEAR(solution.fx / (mu * load), before / (mu * load), 1e-4);
}

TEST_F(Transient, BackwardsIsTheMirrorImage) {
  // x -> -x of everything: nu_x and phi change their signs, F_x and M_z too. Unlike bodies, pressed along
  // each other.
  const double a = 5e-3, b = 4e-3, load = 60e3;
  double forwards[3] = {};
  for (const double way : {1.0, -1.0}) {
    press(a, b, 0.0, load, grid_over(a, b, 20));
    problem.wheel_material.poisson = 0.2;
    problem.creepage.speed = 3.0 * way;
    problem.creepage.longitudinal = 1e-3 * way;
    problem.creepage.lateral = -5e-4;
    problem.creepage.spin = 0.2 * way;
    problem.tolerance = 1e-8;
    wrc_exact_transient_destroy(bodies);
    create();
    for (int k = 0; k < 6; ++k) {
      ASSERT_EQ(step(), WRC_OK) << text;
      EXPECT_GT(solution.power, 0.0);
    }
    if (way > 0.0) {
      forwards[0] = solution.fx;
      forwards[1] = solution.fy;
      forwards[2] = solution.mz;
    }
  }
  const double limit = 0.3 * load;
  EXPECT_LT(forwards[0], -0.1 * limit);
  EXPECT_NEAR(-solution.fx / limit, forwards[0] / limit, 1e-7);
  EXPECT_NEAR(solution.fy / limit, forwards[1] / limit, 1e-7);
  EXPECT_NEAR(-solution.mz / (limit * a), forwards[2] / (limit * a), 1e-7);
}

TEST_F(Transient, EndsInSteadyRolling) {
  const double a = 5e-3, b = 4e-3, load = 60e3;
  press(a, b, 0.0, load, grid_over(a, b, 20));
  problem.creepage.longitudinal = 1e-3;
  problem.creepage.lateral = -5e-4;
  problem.creepage.spin = 0.2;
  problem.tolerance = 1e-6;
  wrc_exact_rolling_solution steady = sized<wrc_exact_rolling_solution>();
  ASSERT_EQ(wrc_exact_rolling(&problem, &steady, text, sizeof text), WRC_OK) << text;
  create();
  double first = 0.0;
  for (int k = 0; k < 120; ++k) {
    ASSERT_EQ(step(), WRC_OK) << text;
    if (k == 0) first = solution.fx;
  }
  EXPECT_LT(first / steady.fx, 0.2);
  const double limit = 0.3 * load;
  EXPECT_NEAR(solution.fx / limit, steady.fx / limit, 2e-4);
  EXPECT_NEAR(solution.fy / limit, steady.fy / limit, 2e-4);
  EXPECT_NEAR(solution.mz / (limit * a), steady.mz / (limit * a), 2e-4);
  EXPECT_NEAR(solution.power_by_balance / steady.power_by_balance, 1.0, 1e-3);
}

TEST_F(Transient, FollowsTheReferenceFromRest) {
  // CONTACT 25.2, module 3, T = 2 on the same cells: a double ellipse, psi 0.18562, at the end of steps
  // 2, 10.
  const double a = 5.5631e-3, b = 4.6575e-3, psi = 0.18562, load = 59540.728;
  wrc_grid grid = sized<wrc_grid>();
  grid.nx = 56;
  grid.ny = 57;
  grid.dx = 0.19868214e-3;
  grid.dy = b / 28.0;
  grid.x0 = -27.5 * grid.dx;
  grid.y0 = -22.5 * grid.dy;
  press(a, b, psi, load, grid);
  problem.collocation = WRC_COLLOCATION_REFERENCE;
  problem.wheel_material = problem.rail_material = wrc_material_default();
  problem.coefficient = 0.28589;
  problem.creepage.longitudinal = 0.0028128879;
  create();
  const double limit = problem.coefficient * load;
  for (int k = 1; k <= 10; ++k) {
    ASSERT_EQ(step(), WRC_OK) << text;
    if (k == 2) {
      EXPECT_NEAR(solution.fx / limit, -1066.0614 / limit, 1e-4);
    }
  }
  EXPECT_NEAR(solution.fx / limit, -4954.6055 / limit, 1e-4);
}

TEST_F(Transient, CancelledAndRefusedStepsLeaveTheHistory) {
  const double a = 5e-3, load = 60e3;
  press(a, a, 0.0, load, grid_over(a, a, 16));
  problem.creepage.longitudinal = 1e-3;
  create();
  ASSERT_EQ(step(), WRC_OK) << text;
  Listener listener;
  listener.allowed = 1;
  problem.progress = Listener::hear;
  problem.user = &listener;
  EXPECT_EQ(step(), WRC_ERROR_CANCELLED);
  EXPECT_EQ(solution.fx, 0.0);
  problem.progress = nullptr;

  problem.grid.dx *= 1.01;
  EXPECT_EQ(step(), WRC_ERROR_RANGE);
  EXPECT_NE(std::string(text).find("problem.grid"), std::string::npos) << text;
  problem.grid.dx /= 1.01;
  problem.grid = grid_over(a, a, 16);
  problem.wheel_material.poisson = 0.3;
  EXPECT_EQ(step(), WRC_ERROR_RANGE);
  EXPECT_NE(std::string(text).find("problem.wheel_material"), std::string::npos) << text;
  problem.wheel_material.poisson = 0.25;
  EXPECT_EQ(wrc_exact_transient_step(nullptr, &problem, &solution, text, sizeof text), WRC_ERROR_NULL);

  ASSERT_EQ(step(), WRC_OK) << text;
  const double second = solution.fx;
  wrc_exact_transient* others = nullptr;
  ASSERT_EQ(wrc_exact_transient_create(&problem.grid, &problem.wheel_material, &problem.rail_material,
                                       &others, nullptr, 0),
            WRC_OK);
  for (int k = 0; k < 2; ++k) wrc_exact_transient_step(others, &problem, &solution, nullptr, 0);
  EXPECT_EQ(solution.fx, second);
  wrc_exact_transient_destroy(others);

  std::vector<double> none(pressure.size(), 0.0);
  problem.pressure = none.data();
  EXPECT_EQ(step(), WRC_FLAG_NO_CONTACT);
  problem.pressure = pressure.data();
  ASSERT_EQ(step(), WRC_OK);
  EXPECT_LT(std::fabs(solution.fx), 0.8 * std::fabs(second));  // from bodies without tractions

  const wrc_grid unset = sized<wrc_grid>();
  EXPECT_EQ(wrc_exact_transient_create(&unset, &problem.wheel_material, &problem.rail_material, &others, text,
                                       sizeof text),
            WRC_ERROR_RANGE);
  EXPECT_EQ(others, nullptr);
  EXPECT_EQ(wrc_exact_transient_create(&problem.grid, &problem.wheel_material, &problem.rail_material,
                                       nullptr, text, sizeof text),
            WRC_ERROR_NULL);
  wrc_exact_transient_destroy(nullptr);
}

}  // namespace
