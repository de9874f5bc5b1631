/// A contact of the real-time side against the exact solver: wrc_exact_check and wrc_exact_gap, through the
/// shared library.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "field_values.hpp"
#include "offline_helpers.hpp"
#include "reference_contact.hpp"
#include "test_config.hpp"

namespace {

using namespace offline_helpers;

class ExactCheck : public ReferenceContact {
 protected:
  wrc_exact_check_result result = sized<wrc_exact_check_result>();

  void SetUp() override {
    ReferenceContact::SetUp();
    creepage.speed = 20.0;
  }
  int32_t check(Listener* listener = nullptr) {
    wrc_exact_check_options options = cells(32, 48);
    options.progress = listener == nullptr ? nullptr : Listener::hear;
    options.user = listener;
    return wrc_exact_check(contact, &options, &result);
  }
  static wrc_exact_check_options cells(uint32_t nx, uint32_t ny) {
    wrc_exact_check_options options = wrc_exact_check_options_default();
    options.nx = nx;
    options.ny = ny;
    return options;
  }
};

TEST_F(ExactCheck, ErrorsAreWhatTheForcesSay) {
  ASSERT_EQ(step(), WRC_OK);
  ASSERT_EQ(check(), WRC_OK) << error();
  EXPECT_NEAR(result.force_error,
              std::hypot(forces.fx - result.fx, forces.fy - result.fy) / (0.35 * forces.fn), 1e-12);
  EXPECT_NEAR(result.power_error, forces.power / result.power - 1.0, 1e-12);
  EXPECT_NEAR(
      result.power,
      -20.0 * (result.fx * creepage.longitudinal + result.fy * creepage.lateral + result.mz * creepage.spin),
      1e-9 * result.power);
  EXPECT_GT(result.power, 0.0);
  EXPECT_LT(result.force_error, 0.05);  // a real-time method worth having
  EXPECT_LT(std::abs(result.power_error), 0.15);
}

TEST_F(ExactCheck, BackwardsIsTheMirrorImageOfForward) {
  pose.yaw = 5e-3;
  ASSERT_EQ(step(), WRC_OK);
  ASSERT_EQ(check(), WRC_OK) << error();
  const wrc_exact_check_result forward = result;
  pose.yaw *= -1.0;
  creepage.longitudinal *= -1.0;
  creepage.spin *= -1.0;
  creepage.speed *= -1.0;
  ASSERT_EQ(step(), WRC_OK);
  ASSERT_EQ(check(), WRC_OK) << error();
  const double limit = 0.35 * 80e3;
  EXPECT_NEAR(result.fx, -forward.fx, 1e-5 * limit);
  EXPECT_NEAR(result.fy, forward.fy, 1e-5 * limit);
  EXPECT_NEAR(result.power, forward.power, 1e-4 * forward.power);
  EXPECT_NEAR(result.force_error, forward.force_error, 1e-5);
  creepage.reverse_share = 0.1;
  ASSERT_EQ(step(), WRC_FLAG_CREEPAGES_LIMITED);
  EXPECT_EQ(check(), WRC_ERROR_UNSUPPORTED);
  expect_words(error(), {"creepage.reverse_share = 0.1", "both ways"});
}

/// Over half the slope a layer leaves, creepages do what half of them do without it.
TEST_F(ExactCheck, ALayerIsAsSmallerCreepages) {
  friction.slope_reduction = 0.5;
  ASSERT_EQ(step(), WRC_OK);
  ASSERT_EQ(check(), WRC_OK) << error();
  const wrc_exact_check_result layer = result;
  EXPECT_LT(layer.force_error, 0.05);
  friction.slope_reduction = 1.0;
  for (double* each : {&creepage.longitudinal, &creepage.lateral, &creepage.spin}) *each *= 0.5;
  ASSERT_EQ(step(), WRC_OK);
  ASSERT_EQ(check(), WRC_OK) << error();
  EXPECT_NEAR(result.fx, layer.fx, 1e-3 * 0.35 * 80e3);
  EXPECT_NEAR(result.fy, layer.fy, 1e-3 * 0.35 * 80e3);
  EXPECT_NEAR(result.power, 0.5 * layer.power, 2e-3 * result.power);
}

TEST_F(ExactCheck, LeavesTheContactAsItWas) {
  ASSERT_EQ(step(), WRC_OK);
  wrc_damage before{}, after = before;
  ASSERT_EQ(wrc_contact_damage(contact, WRC_ALL_REGIONS, &before), WRC_OK);
  ASSERT_EQ(check(), WRC_OK);
  ASSERT_EQ(wrc_contact_damage(contact, WRC_ALL_REGIONS, &after), WRC_OK);
  EXPECT_EQ(after.power, before.power);
  const double power = result.power;
  ASSERT_EQ(check(), WRC_OK);
  EXPECT_EQ(result.power, power);
}

TEST_F(ExactCheck, SolvesADoubleEllipseOfTheCaller) {
  wrc_ellipse own = sized<wrc_ellipse>();
  own.a = 4e-3;
  own.b = 6e-3;
  own.psi = 0.4;
  own.normal_force = 60e3;
  creepage = wrc_creepage_default();
  creepage.longitudinal = 0.02;  // all slips: Coulomb's force, and its power
  ASSERT_EQ(wrc_planar_tangential(contact, &own, &creepage, &friction, &forces), WRC_OK);
  ASSERT_EQ(check(), WRC_OK) << error();
  EXPECT_NEAR(result.fx / (-0.35 * 60e3), 1.0, 5e-3);
  EXPECT_NEAR(result.power / (0.35 * 60e3 * 0.02), 1.0, 5e-3);
  EXPECT_LT(result.force_error, 5e-3);
  EXPECT_EQ(result.adhesion_fraction, 0.0);
}

TEST_F(ExactCheck, AContactThatDoesNotTouchIsFlagged) {
  load.prescribed = WRC_PRESCRIBE_APPROACH;
  load.approach = -1e-5;
  ASSERT_EQ(step(), WRC_FLAG_NO_CONTACT);
  EXPECT_EQ(check(), WRC_FLAG_NO_CONTACT);
  EXPECT_EQ(result.fx, 0.0);
  EXPECT_EQ(result.power_error, 0.0);
}

TEST_F(ExactCheck, RefusesWhatItCannotCheck) {
  EXPECT_EQ(check(), WRC_ERROR_SEQUENCE);
  EXPECT_NE(error().find("wrc_planar_step"), std::string::npos) << error();
  ASSERT_EQ(step(), WRC_OK);
  const wrc_exact_check_options coarse = cells(4, 32), fine = cells(32, 100000);
  EXPECT_EQ(wrc_exact_check(nullptr, nullptr, &result), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_exact_check(contact, nullptr, nullptr), WRC_ERROR_NULL);
  result.fx = 7.0;
  EXPECT_EQ(wrc_exact_check(contact, &coarse, &result), WRC_ERROR_RANGE);
  EXPECT_EQ(result.fx, 0.0);
  EXPECT_NE(error().find("nx = 4"), std::string::npos) << error();
  EXPECT_EQ(wrc_exact_check(contact, &fine, &result), WRC_ERROR_RANGE);
  result.struct_size = 8;
  EXPECT_EQ(check(), WRC_ERROR_STRUCT_SIZE);
  result.struct_size = sizeof result;
  EXPECT_EQ(check(), WRC_OK);
}

TEST_F(ExactCheck, IsCancelled) {
  ASSERT_EQ(step(), WRC_OK);
  Listener listener{.allowed = 1, .fractions = {}};
  EXPECT_EQ(check(&listener), WRC_ERROR_CANCELLED);
  EXPECT_EQ(result.fx, 0.0);
  EXPECT_EQ(result.power, 0.0);
  EXPECT_EQ(check(), WRC_OK);
}

// The rows as the contact shows them, height + curvature/2 (x - centre)^2 over their smallest height: to 2e-9
// the surfaces themselves, within 2 mm of the outline on the tread.
TEST_F(ExactCheck, GapOnTheTreadIsThatOfItsRows) {
  pose.yaw = 0.01;
  ASSERT_EQ(wrc_planar_geometry(contact, &pose, &point), WRC_OK);
  const FieldValues y = field_values(contact, 0, WRC_FIELD_GAP_Y),
                    height = field_values(contact, 0, WRC_FIELD_GAP_HEIGHT),
                    centre = field_values(contact, 0, WRC_FIELD_GAP_CENTRE),
                    curvature = field_values(contact, 0, WRC_FIELD_GAP_CURVATURE);
  for (const FieldValues* each : {&y, &height, &centre, &curvature}) {
    ASSERT_EQ(each->status, WRC_OK);
    ASSERT_EQ(each->cells, 1U);
  }
  const std::size_t rows = y.strips;
  const double lowest = *std::min_element(height.values.begin(), height.values.end());
  for (const std::size_t row : {rows / 4, rows / 2, 3 * rows / 4}) {
    wrc_grid grid = sized<wrc_grid>();
    grid.nx = grid.ny = 4;
    grid.dx = 1e-3;
    grid.dy = 1e-4;
    grid.x0 = -2e-3;
    grid.y0 = y[row];  // its first row of cells lies on a row of the gap
    std::vector<double> gap(16);
    ASSERT_EQ(wrc_exact_gap(contact, &grid, gap.data()), WRC_OK) << error();
    for (uint32_t i = 0; i < 4; ++i) {
      const double x = grid.x0 + i * grid.dx - centre[row];
      EXPECT_NEAR(gap[i], height[row] - lowest + 0.5 * curvature[row] * x * x, 2e-9);
    }
  }
}

// Of a pose the gap is that of the true surfaces, of the caller that of the rows: at the flange root under
// yaw the rows' parabolas have a ridge 10 mm ahead, whose exact peak grows with the grid: on this one it is
// 17 % higher.
TEST_F(ExactCheck, GapOfAPoseIsThatOfTheSurfacesAndNotOfTheRows) {
  pose.lateral = 6.65e-3;
  pose.yaw = 0.01;
  ASSERT_EQ(wrc_planar_geometry(contact, &pose, &point), WRC_OK);
  ASSERT_EQ(wrc_planar_normal(contact, nullptr, &load, &normal), WRC_OK);
  wrc_grid grid = grid_over(17e-3, 10e-3, 80);
  grid.ny *= 2;
  grid.dy /= 2.0;
  const auto exact_peak = [&] {
    std::vector<double> gap(80 * 160);
    EXPECT_EQ(wrc_exact_gap(contact, &grid, gap.data()), WRC_OK) << error();
    wrc_exact_normal_problem problem = of_the_papers_steel(wrc_exact_normal_problem_default());
    wrc_exact_normal_solution solution = sized<wrc_exact_normal_solution>();
    problem.grid = grid;
    problem.gap = gap.data();
    problem.normal_force = load.normal_force;
    EXPECT_EQ(wrc_exact_normal(&problem, &solution, nullptr, 0), WRC_OK);
    return solution.peak_pressure;
  };
  EXPECT_NEAR(exact_peak() / normal.peak_pressure, 1.0, 0.02);

  std::vector<std::vector<double>> row;
  for (const int32_t field :
       {WRC_FIELD_GAP_Y, WRC_FIELD_GAP_HEIGHT, WRC_FIELD_GAP_CENTRE, WRC_FIELD_GAP_CURVATURE}) {
    row.push_back(field_values(contact, 0, field).values);
    ASSERT_GT(row.back().size(), 0U);
  }
  wrc_planar_gap rows = sized<wrc_planar_gap>();
  rows.row_count = static_cast<uint32_t>(row[0].size());
  rows.y = row[0].data();
  rows.height = row[1].data();
  rows.centre = row[2].data();
  rows.curvature = row[3].data();
  ASSERT_EQ(wrc_planar_normal(contact, &rows, &load, &normal), WRC_OK);
  EXPECT_GT(exact_peak() / normal.peak_pressure, 1.1);
}

TEST_F(ExactCheck, GapRefusesWhatItCannotSample) {
  wrc_grid grid = grid_over(8e-3, 8e-3, 16);
  std::vector<double> gap(256, 7.0);
  EXPECT_EQ(wrc_exact_gap(contact, &grid, gap.data()), WRC_ERROR_SEQUENCE);
  EXPECT_EQ(gap[100], 0.0);
  gap[100] = 7.0;
  EXPECT_EQ(wrc_exact_gap(nullptr, &grid, gap.data()), WRC_ERROR_NULL);
  EXPECT_EQ(gap[100], 0.0);
  EXPECT_EQ(wrc_exact_gap(contact, nullptr, gap.data()), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_exact_gap(contact, &grid, nullptr), WRC_ERROR_NULL);
  ASSERT_EQ(step(), WRC_OK);
  grid.dy = 1.0;
  EXPECT_EQ(wrc_exact_gap(contact, &grid, gap.data()), WRC_ERROR_RANGE);
  EXPECT_NE(error().find("grid.dy"), std::string::npos) << error();
  grid.dy = nan_value;
  EXPECT_EQ(wrc_exact_gap(contact, &grid, gap.data()), WRC_ERROR_NOT_FINITE);
  grid.dy = 1e-3;
  EXPECT_EQ(wrc_exact_gap(contact, &grid, gap.data()), WRC_OK);
}

// A gap of the caller with two hollows 24 mm apart: the exact solution is that of both patches together.
TEST_F(ExactCheck, CoversAllPatchesOfTheContact) {
  std::vector<double> y, height, curvature;
  for (int j = 0; j < 161; ++j) {
    y.push_back(0.25e-3 * (j - 80));
    const double from_hollow = std::abs(y.back()) - 12e-3;
    height.push_back(0.5 * 3.0 * from_hollow * from_hollow);
    curvature.push_back(1.0 / 0.46);
  }
  wrc_planar_gap gap = sized<wrc_planar_gap>();
  gap.row_count = 161;
  gap.y = y.data();
  gap.height = height.data();
  gap.curvature = curvature.data();
  creepage = wrc_creepage_default();
  creepage.longitudinal = 0.05;  // all slips
  input.gap = &gap;
  ASSERT_EQ(step(), WRC_OK) << error();
  ASSERT_EQ(normal.patch_count, 2);
  ASSERT_EQ(check(), WRC_OK) << error();
  EXPECT_NEAR(result.fx / (-0.35 * 80e3), 1.0, 5e-3);
  EXPECT_NEAR(result.mz, 0.0, 5e-3 * 0.35 * 80e3 * 12e-3);  // the patches' moments cancel
  EXPECT_LT(result.force_error, 5e-3);

  const wrc_grid grid = grid_over(8e-3, 20e-3, 32);
  std::vector<double> sampled(std::size_t{32} * 32);
  ASSERT_EQ(wrc_exact_gap(contact, &grid, sampled.data()), WRC_OK) << error();
  for (uint32_t j = 0; j < 32; ++j) {
    const double here = grid.y0 + j * grid.dy, from_hollow = std::abs(here) - 12e-3, x = grid.x0;
    if (std::abs(here) < 0.5e-3) continue;  // between the hollows the rows cut the ridge's corner
    EXPECT_NEAR(sampled[std::size_t{j} * 32], 1.5 * from_hollow * from_hollow + 0.5 * x * x / 0.46, 1e-7)
        << here;
  }
}

// The whole way: profiles, exact normal contact, exact rolling; beside the contact's own strips.
TEST_F(ExactCheck, ExactNormalOfTheProfilesCarriesTheLoad) {
  ASSERT_EQ(step(), WRC_OK);
  wrc_grid grid = grid_over(8e-3, 16e-3, 64);
  std::vector<double> gap(64 * 64);
  ASSERT_EQ(wrc_exact_gap(contact, &grid, gap.data()), WRC_OK);
  EXPECT_NEAR(*std::min_element(gap.begin(), gap.end()), 0.0, 1e-7);
  wrc_exact_normal_problem problem = of_the_papers_steel(wrc_exact_normal_problem_default());
  wrc_exact_normal_solution solution = sized<wrc_exact_normal_solution>();
  problem.grid = grid;
  problem.gap = gap.data();
  problem.normal_force = 80e3;
  char text[256];
  ASSERT_EQ(wrc_exact_normal(&problem, &solution, text, sizeof text), WRC_OK) << text;
  EXPECT_NEAR(normal.approach / solution.approach, 1.0, 0.02);
  EXPECT_NEAR(normal.peak_pressure / solution.peak_pressure, 1.0, 0.05);
}

}  // namespace
