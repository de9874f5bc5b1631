/// What is asked of a region of a wheel on a rail: its ellipse, its damage, fields over its strips and cells.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "field_values.hpp"
#include "test_config.hpp"
#include "wheel_on_rail.hpp"

namespace {

using Numbers = std::vector<double>;

class RegionResults : public testing::Test, protected PlacedWheel {
 protected:
  RegionResults() {
    wheel.y = 5.5e-3;  // two regions
    wheel.z = -0.3e-3;
    wheel.velocity[1] = 0.05;
    wheel.yaw = 3e-3;
  }
  void solve() {
    ASSERT_EQ(step(), WRC_OK) << error();
    ASSERT_GT(wrench.region_count, 0);
  }
  wrc_region region(int32_t index) {
    wrc_region shown = sized<wrc_region>();
    EXPECT_EQ(wrc_contact_region(contact, index, &shown), WRC_OK);
    return shown;
  }
  /// Values of cells in rows of strips: cell i of strip j at i * strips + j.
  Numbers field(int32_t index, int32_t which) {
    const FieldValues found = field_values(contact, index, which);
    EXPECT_EQ(found.status, WRC_OK) << which;
    Numbers values;
    for (std::size_t i = 0; i < found.cells; ++i)
      for (std::size_t j = 0; j < found.strips; ++j) values.push_back(found.at(i, j));
    return values;
  }
  Numbers all_fields() {
    Numbers all;
    for (int32_t i = 0; i < wrench.region_count; ++i)
      for (int32_t which = 0; which <= WRC_FIELD_STRIP_ANGLE; ++which)
        for (const double value : field(i, which)) all.push_back(value);
    return all;
  }
  /// Over the cells of a region.
  double integral(int32_t index, const Numbers& values) {
    const Numbers width = field(index, WRC_FIELD_STRIP_WIDTH),
                  half = field(index, WRC_FIELD_STRIP_HALF_LENGTH);
    const std::size_t cells = values.size() / width.size();
    double sum = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k) {
      const std::size_t j = k % width.size();
      sum += values[k] * width[j] * 2.0 * half[j] / static_cast<double>(cells);
    }
    return sum;
  }
};

TEST_F(RegionResults, FieldsAddUpToTheRegion) {
  for (const double way : {1.0, -1.0}) {
    for (double* each : {&wheel.velocity[0], &wheel.angular_velocity[1]}) *each = way * std::abs(*each);
    wheel.angular_velocity[1] = -wheel.angular_velocity[1] * 1.002;
    create();
    solve();
    ASSERT_EQ(wrench.region_count, 2);
    for (int32_t i = 0; i < wrench.region_count; ++i) {
      const wrc_region shown = region(i);
      const Numbers pressure = field(i, WRC_FIELD_PRESSURE), peak = field(i, WRC_FIELD_STRIP_PEAK),
                    half = field(i, WRC_FIELD_STRIP_HALF_LENGTH), width = field(i, WRC_FIELD_STRIP_WIDTH),
                    angle = field(i, WRC_FIELD_STRIP_ANGLE), x = field(i, WRC_FIELD_X),
                    centre = field(i, WRC_FIELD_STRIP_CENTRE), y = field(i, WRC_FIELD_STRIP_PROFILE_Y),
                    z = field(i, WRC_FIELD_STRIP_PROFILE_Z), px = field(i, WRC_FIELD_TRACTION_X),
                    ps = field(i, WRC_FIELD_TRACTION_Y);
      double load = 0.0, area = 0.0, at_y = 0.0, at_z = 0.0, across = 0.0, down = 0.0, middle = 0.0;
      const Numbers coefficient = field(i, WRC_FIELD_STRIP_FRICTION);
      Numbers lateral = ps;
      for (std::size_t j = 0; j < half.size(); ++j) {
        const double N = 1.5707963267948966 * peak[j] * half[j] * width[j];
        load += N;
        area += 2.0 * half[j] * width[j];
        at_y += N * y[j];
        at_z += N * z[j];
        middle += N * centre[j];
        across -= N * std::sin(angle[j]);
        down += N * std::cos(angle[j]);
        EXPECT_EQ(coefficient[j], 0.3);
        for (std::size_t k = j; k < px.size(); k += half.size()) {
          EXPECT_LE(std::hypot(px[k], ps[k]), 0.3 * 1.3 * peak[j]);
          EXPECT_NEAR(x[k], centre[j], half[j]);
          lateral[k] *= std::cos(angle[j]);
        }
        EXPECT_GT(way * (x[j] - centre[j]), 0.9 * half[j]);  // cell 0 leads
      }
      EXPECT_NEAR(integral(i, pressure), load, 3e-3 * load);
      EXPECT_NEAR(area, shown.area, 1e-12 * area);
      EXPECT_NEAR(*std::max_element(peak.begin(), peak.end()), shown.peak_pressure,
                  1e-12 * shown.peak_pressure);
      EXPECT_NEAR(std::hypot(across, down), shown.normal_force, 1e-3 * shown.normal_force);
      EXPECT_NEAR(std::atan2(-across, down), shown.angle, 5e-3);
      EXPECT_NEAR(middle / load, shown.point[0], 1e-9);
      EXPECT_NEAR(at_y / load, shown.y_rail, 0.2e-3);
      EXPECT_NEAR(at_z / load, shown.z_rail, 0.2e-3);
      EXPECT_NEAR(integral(i, px), shown.force[0], 1e-9 * load);
      // what the normals of rail and mean surface differ by, times the load
      EXPECT_NEAR(integral(i, lateral) - across, shown.force[1], 5e-3 * load);

      wrc_damage damage{};
      ASSERT_EQ(wrc_contact_damage(contact, i, &damage), WRC_OK);
      const Numbers density = field(i, WRC_FIELD_POWER_DENSITY), power = field(i, WRC_FIELD_STRIP_POWER);
      double of_strips = 0.0;
      for (std::size_t j = 0; j < power.size(); ++j) of_strips += power[j] * width[j];
      EXPECT_NEAR(integral(i, density), of_strips, 1e-9 * of_strips);
      EXPECT_NEAR(of_strips, shown.power, 0.02 * shown.power);
      EXPECT_EQ(damage.power, shown.power);
      EXPECT_NEAR(damage.t_gamma, shown.power / 20.0, 1e-2 * damage.t_gamma);  // V: less half the sliding
      EXPECT_EQ(damage.peak_power_density, *std::max_element(density.begin(), density.end()));
      const double tangential = std::hypot(integral(i, px), integral(i, ps));
      EXPECT_NEAR(damage.utilisation, tangential / load, 1e-9);
      EXPECT_NEAR(damage.load_factor, shown.peak_pressure / 250e6, 1e-9);
      EXPECT_NEAR(damage.fatigue_index, damage.utilisation - 1.0 / damage.load_factor, 1e-12);
      double limit = 0.0;
      ASSERT_EQ(wrc_shakedown_limit(damage.utilisation, &limit), WRC_OK);
      EXPECT_EQ(damage.shakedown_limit, limit);
      const Numbers index = field(i, WRC_FIELD_FATIGUE_INDEX);
      EXPECT_EQ(damage.local_fatigue_index, *std::max_element(index.begin(), index.end()));
    }
  }
}

/// A wheel and a crown of the same radius: Hertz's circle, a^3 = 3 N R (1 - nu^2) / (2 E), E = 2 G (1 + nu).
TEST_F(RegionResults, TheEllipseIsHertzs) {
  constexpr double radius = 0.46;
  Numbers y, z, level;
  for (int i = -300; i <= 300; ++i) {
    y.push_back(1e-4 * i);
    z.push_back(radius - std::sqrt(radius * radius - y.back() * y.back()));
    level.push_back(0.0);
  }
  config.wheel.kind = config.rail.kind = WRC_PROFILE_POINTS;
  for (wrc_profile* profile : {&config.wheel, &config.rail}) {
    profile->count = static_cast<uint32_t>(y.size());
    profile->y = y.data();
    profile->z = profile == &config.rail ? z.data() : level.data();
  }
  config.track.placement = WRC_PLACEMENT_ORIGIN;
  config.track.rail_origin = 0.75;
  wheel.y = wheel.yaw = wheel.velocity[1] = 0.0;
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 80e3;
  wheel.z = 0.0;
  create();
  solve();
  const wrc_ellipse ellipse = region(0).ellipse;
  const double nu = config.wheel_material.poisson, E = 2.0 * config.wheel_material.shear_modulus * (1.0 + nu);
  const double a = std::cbrt(1.5 * 80e3 * radius * (1.0 - nu * nu) / E);
  EXPECT_NEAR(ellipse.normal_force, 80e3, 1.0);
  EXPECT_NEAR(std::sqrt(ellipse.a * ellipse.b), a, 5e-3 * a);
  EXPECT_NEAR(ellipse.b, a, 0.06 * a);  // half strips of 0.25 mm
  EXPECT_NEAR(ellipse.psi, 0.0, 0.02);
  const Numbers s = field(0, WRC_FIELD_STRIP_Y);
  EXPECT_NEAR(ellipse.y, 0.5 * (s.front() + s.back()), 4e-5);
  EXPECT_NEAR(region(0).peak_pressure, 1.5 * 80e3 / (3.14159265358979 * a * a),
              0.01 * region(0).peak_pressure);
}

TEST_F(RegionResults, AskingChangesNothing) {
  for (const int32_t warm : {0, 1}) {
    config.planar.start = warm;
    create();
    uint64_t bytes = 0;
    ASSERT_EQ(wrc_contact_state_size(model, &bytes), WRC_OK);
    std::vector<char> before(bytes), after(bytes);
    solve();
    const wrc_wrench first = wrench;
    ASSERT_EQ(wrc_contact_save(contact, before.data(), bytes), WRC_OK);
    const Numbers shown = all_fields();
    EXPECT_TRUE(std::all_of(shown.begin(), shown.end(), [](double v) { return std::isfinite(v); }));
    ASSERT_EQ(wrc_contact_save(contact, after.data(), bytes), WRC_OK);
    EXPECT_EQ(before, after);
    wheel.z += 20e-6;
    solve();
    const wrc_wrench asked = wrench;
    ASSERT_EQ(wrc_contact_restore(contact, before.data(), bytes), WRC_OK);
    EXPECT_EQ(all_fields(), shown);
    ASSERT_EQ(wrc_contact_restore(contact, before.data(), bytes), WRC_OK);
    solve();
    EXPECT_EQ(std::memcmp(&wrench, &asked, sizeof asked), 0);
    EXPECT_NE(std::memcmp(&wrench, &first, sizeof first), 0);
    wheel.z -= 20e-6;
  }
}

TEST_F(RegionResults, BothSidesHaveTheSameFields) {
  create();
  solve();
  const Numbers right = all_fields();
  const wrc_ellipse of_right = region(0).ellipse;
  take(WRC_SIDE_LEFT);
  for (double* each : {&wheel.y, &wheel.yaw, &wheel.velocity[1]}) *each = -*each;
  solve();
  EXPECT_EQ(all_fields(), right);
  const wrc_ellipse of_left = region(0).ellipse;
  EXPECT_EQ(std::memcmp(&of_left, &of_right, sizeof of_left), 0);
}

TEST_F(RegionResults, WithoutFrictionSlipIsRigidAndNothingIsDissipated) {
  friction.coefficient = 0.0;
  create();
  solve();
  for (const double traction : field(0, WRC_FIELD_TRACTION_X)) EXPECT_EQ(traction, 0.0);
  const Numbers slip = field(0, WRC_FIELD_SLIP_Y), load = field(0, WRC_FIELD_PRESSURE);
  double mean = 0.0, sum = 0.0;
  for (std::size_t k = 0; k < slip.size(); ++k) {
    mean += slip[k] * load[k];
    sum += load[k];
  }
  EXPECT_NEAR(mean / sum, region(0).creepage.lateral, 0.05 * std::abs(region(0).creepage.lateral));
  wrc_damage damage{};
  ASSERT_EQ(wrc_contact_damage(contact, 0, &damage), WRC_OK);
  EXPECT_EQ(damage.power, 0.0);
  EXPECT_EQ(damage.peak_power_density, 0.0);
}

TEST_F(RegionResults, WhatIsNotThereIsRefused) {
  create();
  wrc_region shown = sized<wrc_region>();
  wrc_damage damage{};
  double value = 7.0;
  damage.power = shown.ellipse.a = 7.0;
  EXPECT_EQ(wrc_contact_region(contact, 0, &shown), WRC_ERROR_SEQUENCE);
  EXPECT_EQ(wrc_contact_damage(contact, 0, &damage), WRC_ERROR_SEQUENCE);
  EXPECT_EQ(wrc_contact_field(contact, 0, WRC_FIELD_X, &value, 1, nullptr), WRC_ERROR_SEQUENCE);
  EXPECT_EQ(shown.ellipse.a, 0.0);
  EXPECT_EQ(damage.power, 0.0);
  solve();
  for (const int32_t none : {-1, wrench.region_count}) {
    EXPECT_EQ(wrc_contact_region(contact, none, &shown), WRC_ERROR_RANGE);
    EXPECT_EQ(wrc_contact_damage(contact, none, &damage), WRC_ERROR_RANGE);
    EXPECT_EQ(wrc_contact_field(contact, none, WRC_FIELD_X, &value, 1, nullptr), WRC_ERROR_RANGE);
  }
  EXPECT_EQ(wrc_contact_region(contact, 0, nullptr), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_contact_damage(contact, 0, nullptr), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_contact_field(contact, 0, WRC_FIELD_X, nullptr, 1, nullptr), WRC_ERROR_NULL);
  wrc_temperature temperature = sized<wrc_temperature>();
  wrc_bulk_temperatures bulk = wrc_bulk_temperatures_default();
  EXPECT_EQ(wrc_contact_temperature(contact, 0, &bulk, nullptr), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_contact_temperature(contact, wrench.region_count, &bulk, &temperature), WRC_ERROR_RANGE);
  bulk.rail = 5000.0;
  EXPECT_EQ(wrc_contact_temperature(contact, 0, &bulk, &temperature), WRC_ERROR_RANGE);
  for (const int32_t none : {-1, WRC_FIELD_GAP_CURVATURE + 1})
    EXPECT_EQ(wrc_contact_field(contact, 0, none, &value, 1, nullptr), WRC_ERROR_UNSUPPORTED);
  EXPECT_EQ(wrc_contact_field(contact, 0, WRC_FIELD_STRIP_Y, &value, 1, nullptr), WRC_ERROR_BUFFER);
  EXPECT_EQ(value, 7.0);
}

}  // namespace
