/// What is asked of one region of the last solution, of a wheel on a rail or of a contact plane: where it is,
/// what it carries, what it does to the bodies, fields over its strips and cells. Clearance where there is
/// none.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "field_values.hpp"
#include "test_config.hpp"
#include "vectors.hpp"
#include "wheel_on_rail.hpp"
#include "wrc/wrc_damage.h"
#include "wrc/wrc_planar.h"

namespace {

using Numbers = std::vector<double>;

/// Everything there is of one region, or of all patches.
struct Assessed {
  wrc_damage damage{};
  wrc_wear wear = sized<wrc_wear>();
  wrc_temperature temperature = sized<wrc_temperature>();
  wrc_stress_peaks levels[2] = {};
  wrc_stresses of_wheel = sized<wrc_stresses>(), of_rail = of_wheel;
};

template <typename Struct>
void expect_same_bits(const Struct& one, const Struct& other) {
  char bytes[2][sizeof one];
  std::memcpy(bytes[0], &one, sizeof one);
  std::memcpy(bytes[1], &other, sizeof one);
  for (std::size_t i = 0; i < sizeof one; ++i) ASSERT_EQ(bytes[0][i], bytes[1][i]) << "byte " << i;
}

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
  Assessed assess(int32_t index) {
    Assessed all;
    constexpr double depths[] = {0.5e-3, 3e-3};
    EXPECT_EQ(wrc_contact_damage(contact, index, &all.damage), WRC_OK) << error();
    EXPECT_EQ(wrc_contact_wear(contact, index, nullptr, &all.wear), WRC_OK) << error();
    EXPECT_EQ(wrc_contact_temperature(contact, index, nullptr, &all.temperature), WRC_OK) << error();
    EXPECT_EQ(wrc_contact_stresses(contact, index, WRC_BODY_WHEEL, depths, 2, nullptr, &all.of_wheel), WRC_OK)
        << error();
    EXPECT_EQ(wrc_contact_stresses(contact, index, WRC_BODY_RAIL, depths, 2, all.levels, &all.of_rail),
              WRC_OK)
        << error();
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
class HertzsCircle : public RegionResults {
 protected:
  static constexpr double radius = 0.46, load = 80e3;  // [m], [N]
  double nu = config.wheel_material.poisson;
  double a = std::cbrt(1.5 * load * radius * (1.0 - nu * nu) /
                       (2.0 * config.wheel_material.shear_modulus * (1.0 + nu)));
  double p0 = 1.5 * load / (3.14159265358979 * a * a);

  HertzsCircle() {
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
    wheel.y = wheel.yaw = wheel.velocity[1] = wheel.z = 0.0;
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = load;
    create();
  }
};

TEST_F(HertzsCircle, TheEllipseIsHertzs) {
  solve();
  const wrc_ellipse ellipse = region(0).ellipse;
  EXPECT_NEAR(ellipse.normal_force, load, 1.0);
  EXPECT_NEAR(std::sqrt(ellipse.a * ellipse.b), a, 5e-3 * a);
  EXPECT_NEAR(ellipse.b, a, 0.06 * a);  // half strips of 0.25 mm
  EXPECT_NEAR(ellipse.psi, 0.0, 0.02);
  const Numbers s = field(0, WRC_FIELD_STRIP_Y);
  EXPECT_NEAR(ellipse.y, 0.5 * (s.front() + s.back()), 4e-5);
  EXPECT_NEAR(region(0).peak_pressure, p0, 0.01 * region(0).peak_pressure);
}

/// Below its middle, without friction: Johnson 1985, eq. 3.45.
TEST_F(HertzsCircle, StressesBelowIt) {
  friction.coefficient = 0.0;
  solve();
  const double depths[] = {0.3 * a, 0.48 * a, 0.8 * a};
  for (const int32_t body : {WRC_BODY_WHEEL, WRC_BODY_RAIL}) {
    wrc_stress_peaks levels[3];
    wrc_stresses stresses = sized<wrc_stresses>();
    ASSERT_EQ(wrc_contact_stresses(contact, 0, body, depths, 3, levels, &stresses), WRC_OK) << error();
    EXPECT_EQ(stresses.body, body);
    for (int k = 0; k < 3; ++k) {
      const double u = depths[k] / a, down = 1.0 / (1.0 + u * u);
      const double across = (1.0 + nu) * (1.0 - u * std::atan(1.0 / u)) - 0.5 * down;
      const double mises = p0 * std::abs(down - across);
      EXPECT_NEAR(levels[k].von_mises.stress, mises, 0.02 * mises) << k;
      EXPECT_EQ(levels[k].von_mises.depth, depths[k]);
    }
    EXPECT_NEAR(stresses.below.von_mises.depth, 0.48 * a, 0.05 * a);
    EXPECT_EQ(stresses.largest.von_mises.stress, stresses.below.von_mises.stress);
  }
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

/// Of both regions, of both wheels: the distance from the axle, and pressure without friction.
TEST_F(RegionResults, PlaceRollingRadiusAndNormalAreThoseOfTheWheel) {
  friction.coefficient = 0.0;
  wheel.roll = 2e-4;
  wheel.z -= 0.75 * wheel.roll;  // as far as it lowers the wheel
  wheel.y += 0.46 * wheel.roll;  // and moves it to the side
  create();
  for (const int32_t which : {WRC_SIDE_RIGHT, WRC_SIDE_LEFT}) {
    take(which);
    const double outward = which == WRC_SIDE_RIGHT ? 1.0 : -1.0;
    for (double* each : {&wheel.y, &wheel.yaw, &wheel.roll}) *each = outward * std::abs(*each);
    solve();
    ASSERT_EQ(wrench.region_count, 2);
    const Matrix rotation = about_x(wheel.roll) * about_z(wheel.yaw);
    const Vector middle = {0.0, wheel.y, wheel.z - 0.46};
    for (int32_t i = 0; i < 2; ++i) {
      const wrc_region shown = region(i);
      EXPECT_EQ(shown.available, uint32_t{WRC_AVAILABLE_TRACTIONS | WRC_AVAILABLE_PLACE});
      const Vector at = transposed(rotation) * (vector_of(shown.point) - middle);
      EXPECT_NEAR(std::hypot(at[0], at[2]), shown.rolling_radius, 0.15e-3);  // the overlap
      EXPECT_NEAR(outward * at[1] - 0.75, shown.y_wheel, 0.15e-3);
      EXPECT_NEAR(shown.rolling_radius, 0.46 + shown.z_wheel, 1e-12);
      EXPECT_NEAR(length(vector_of(shown.normal)), 1.0, 1e-12);
      EXPECT_NEAR(shown.normal[1], -std::sin(shown.angle), 1e-12);
      EXPECT_GT(shown.normal[2], 0.0);
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(shown.force[k], -shown.normal_force * shown.normal[k], 1e-9 * shown.normal_force) << k;
    }
    EXPECT_LT(outward * region(0).angle, -0.3);  // the flange's root, at the gauge side
    EXPECT_GT(outward * region(0).normal[1], 0.3);
    EXPECT_LT(std::abs(region(1).angle), 0.2);
    EXPECT_GT(region(0).rolling_radius, region(1).rolling_radius + 2e-3);
    EXPECT_LT(region(0).y_rail, region(1).y_rail - 5e-3);
  }
}

/// Criteria of the default regularisation: area and width kept, the joint at the longest strip.
TEST_F(RegionResults, TheEllipseHasAreaAndWidthOfItsStrips) {
  create();
  solve();
  for (int32_t i = 0; i < wrench.region_count; ++i) {
    const wrc_region shown = region(i);
    const wrc_ellipse& ellipse = shown.ellipse;
    const Numbers s = field(i, WRC_FIELD_STRIP_Y), width = field(i, WRC_FIELD_STRIP_WIDTH),
                  centre = field(i, WRC_FIELD_STRIP_CENTRE), half = field(i, WRC_FIELD_STRIP_HALF_LENGTH);
    EXPECT_EQ(shown.strip_count, static_cast<int32_t>(s.size()));
    EXPECT_NEAR(shown.y_min, s.front() - 0.5 * width.front(), 1e-12);
    EXPECT_NEAR(shown.y_max, s.back() + 0.5 * width.back(), 1e-12);
    EXPECT_NEAR(shown.width, shown.y_max - shown.y_min, 1e-12);
    double front = -1.0, rear = 1.0;
    for (std::size_t j = 0; j < s.size(); ++j) {
      front = std::max(front, centre[j] + half[j]);
      rear = std::min(rear, centre[j] - half[j]);
    }
    EXPECT_NEAR(shown.length, front - rear, 1e-12);
    EXPECT_NEAR(3.14159265358979 * ellipse.a * ellipse.b, shown.area, 1e-12 * shown.area);
    EXPECT_NEAR(ellipse.y - ellipse.b * (1.0 - ellipse.psi), shown.y_min, 1e-9);
    EXPECT_NEAR(ellipse.y + ellipse.b * (1.0 + ellipse.psi), shown.y_max, 1e-9);
    EXPECT_NEAR(ellipse.normal_force, integral(i, field(i, WRC_FIELD_PRESSURE)), 3e-3 * ellipse.normal_force);
    const std::size_t longest =
        static_cast<std::size_t>(std::max_element(half.begin(), half.end()) - half.begin());
    EXPECT_NEAR(ellipse.y, s[longest], 0.5 * width[longest] + 1e-9);
  }
  wrc_region joint = region(0);
  config.planar.regularisation = WRC_REGULARISE_KEEP_RATIO;
  create();
  solve();
  const wrc_ellipse ratio_kept = region(0).ellipse;
  EXPECT_NEAR(ratio_kept.a / ratio_kept.b, joint.length / joint.width, 1e-9 * ratio_kept.a / ratio_kept.b);
  EXPECT_NEAR(ratio_kept.a * ratio_kept.b, joint.ellipse.a * joint.ellipse.b, 1e-16);
}

/// What a region carries along the rail, against its cells. To the right is against a left rail's arc.
TEST_F(RegionResults, TangentialForcesAndSpinMomentAreThoseOfTheCells) {
  create();
  for (const int32_t which : {WRC_SIDE_RIGHT, WRC_SIDE_LEFT}) {
    take(which);
    const double outward = which == WRC_SIDE_RIGHT ? 1.0 : -1.0;
    for (double* each : {&wheel.y, &wheel.yaw}) *each = outward * std::abs(*each);
    solve();
    for (int32_t i = 0; i < wrench.region_count; ++i) {
      const wrc_region shown = region(i);
      const Numbers px = field(i, WRC_FIELD_TRACTION_X), ps = field(i, WRC_FIELD_TRACTION_Y),
                    x = field(i, WRC_FIELD_X), s = field(i, WRC_FIELD_STRIP_Y),
                    pressure = field(i, WRC_FIELD_PRESSURE);
      const double load = integral(i, pressure);
      Numbers by_x = pressure, by_s = pressure;
      for (std::size_t k = 0; k < px.size(); ++k) {
        by_x[k] *= x[k];
        by_s[k] *= s[k % s.size()];
      }
      const double middle_x = integral(i, by_x) / load, middle_s = integral(i, by_s) / load;
      Numbers turning = ps;
      for (std::size_t k = 0; k < px.size(); ++k)
        turning[k] = (x[k] - middle_x) * ps[k] - (s[k % s.size()] - middle_s) * px[k];
      EXPECT_NEAR(shown.longitudinal_force, shown.force[0], 1e-9 * load);
      EXPECT_NEAR(shown.longitudinal_force, integral(i, px), 1e-9 * load);
      EXPECT_NEAR(shown.lateral_force, outward * integral(i, ps), 1e-9 * load);
      EXPECT_GT(std::abs(shown.lateral_force), 0.02 * load);
      const double moment = outward * integral(i, turning);
      EXPECT_GT(std::abs(moment), i == 0 ? 1.0 : 1e-3);  // [N m]: little on the tread
      EXPECT_NEAR(shown.spin_moment, moment, 0.03 * std::abs(moment));
    }
  }
}

TEST_F(RegionResults, AdhesionIsTheAreaWithoutSlip) {
  wheel.y = wheel.yaw = 0.0;
  wheel.velocity[1] = 5e-3;
  wheel.z = 0.2e-3;
  create();
  solve();
  Numbers sticks = field(0, WRC_FIELD_SLIP_X);
  const Numbers to_side = field(0, WRC_FIELD_SLIP_Y);
  for (std::size_t k = 0; k < sticks.size(); ++k)
    sticks[k] = sticks[k] == 0.0 && to_side[k] == 0.0 ? 1.0 : 0.0;
  const wrc_region shown = region(0);
  EXPECT_GT(shown.adhesion_fraction, 0.2);
  EXPECT_LT(shown.adhesion_fraction, 0.9);
  EXPECT_NEAR(shown.adhesion_fraction, integral(0, sticks) / shown.area, 1e-12);
}

TEST_F(RegionResults, WearIsThatOfTheStrips) {
  create();
  solve();
  double worn[2];
  for (int32_t i = 0; i < 2; ++i) {
    const Numbers width = field(i, WRC_FIELD_STRIP_WIDTH), wear = field(i, WRC_FIELD_STRIP_WEAR);
    double of_strips = 0.0;
    for (std::size_t j = 0; j < width.size(); ++j) of_strips += width[j] * wear[j];
    const Assessed all = assess(i);
    worn[i] = all.wear.largest_depth_rate;
    // Sheffield's law, mild: the depth goes with the T-gamma of a place, its sum with that of the region
    const Numbers density = field(i, WRC_FIELD_POWER_DENSITY);
    const double most = *std::max_element(density.begin(), density.end());
    ASSERT_LT(most / region(i).creepage.speed, 10.4e6);  // [N/m^2]
    EXPECT_NEAR(all.wear.largest_depth_rate / most, of_strips / integral(i, density), 1e-9 * worn[i] / most);
    EXPECT_NEAR(all.wear.largest_depth_rate, 5.3e-9 / 7850.0 * most / region(i).creepage.speed,
                1e-9 * worn[i]);
  }
  EXPECT_GT(worn[0], 2.0 * worn[1]);  // the flange's root
}

/// Numbers of a region once more, after all that can be asked of it and of the other one.
TEST_F(RegionResults, TheOrderOfQuestionsDoesNotMatter) {
  create();
  solve();
  ASSERT_EQ(wrench.region_count, 2);
  const wrc_region second = region(1);
  const Assessed of_second = assess(1), of_first = assess(0);
  expect_same_bits(region(1), second);
  const Assessed again = assess(1);
  expect_same_bits(again.damage, of_second.damage);
  expect_same_bits(again.wear, of_second.wear);
  expect_same_bits(again.temperature, of_second.temperature);
  expect_same_bits(again.of_wheel, of_second.of_wheel);
  expect_same_bits(again.of_rail, of_second.of_rail);
  EXPECT_NE(of_first.damage.power, of_second.damage.power);
  EXPECT_NE(of_first.of_rail.largest.shear.stress, of_second.of_rail.largest.shear.stress);
}

/// Of the last call, whichever it was.
TEST_F(RegionResults, TheLastSolutionAnswers) {
  create();
  wrc_planar_input planar = wrc_planar_input_default();
  planar.load.normal_force = 80e3;
  planar.creepage.longitudinal = 1e-3;
  wrc_planar_output output = sized<wrc_planar_output>();
  solve();
  const wrc_wrench alone = wrench;
  const wrc_region of_wheel = region(0);
  ASSERT_EQ(wrc_planar_step(contact, &planar, &output), WRC_OK);
  EXPECT_EQ(region(0).longitudinal_force, output.forces.fx);
  EXPECT_EQ(region(0).creepage.longitudinal, 1e-3);
  EXPECT_EQ(region(0).strip_count, output.normal.strip_count);
  EXPECT_EQ(assess(0).damage.power, output.damage.power);
  solve();
  expect_same_bits(wrench, alone);
  expect_same_bits(region(0), of_wheel);
  EXPECT_NEAR(assess(0).damage.power, of_wheel.power, 1e-12 * of_wheel.power);
  EXPECT_NE(of_wheel.longitudinal_force, output.forces.fx);
  // a wheel that is refused, or apart, leaves nothing of the stages behind that answers for it
  ASSERT_EQ(wrc_planar_step(contact, &planar, &output), WRC_OK);
  wheel.z -= 5e-3;
  ASSERT_EQ(step(), WRC_FLAG_NO_CONTACT);
  wrc_region shown = sized<wrc_region>();
  EXPECT_EQ(wrc_contact_region(contact, 0, &shown), WRC_ERROR_RANGE);
  wheel.z = 5.0;
  ASSERT_EQ(step(), WRC_ERROR_RANGE);
  EXPECT_EQ(wrc_contact_region(contact, 0, &shown), WRC_ERROR_SEQUENCE);
  ASSERT_EQ(wrc_planar_step(contact, &planar, &output), WRC_OK);
  EXPECT_EQ(region(0).longitudinal_force, output.forces.fx);
}

// ----------------------------------------------------------------------------------------------------------
// patches of a contact plane

TEST_F(RegionResults, OnePatchIsTheWhole) {
  create();
  wrc_planar_input planar = wrc_planar_input_default();
  planar.pose.lateral = 1e-3;
  planar.load.normal_force = 80e3;
  planar.creepage.longitudinal = 1e-3;
  planar.creepage.lateral = -2e-3;
  planar.creepage.spin = 0.2;
  planar.creepage.speed = 20.0;
  wrc_planar_output output = sized<wrc_planar_output>();
  ASSERT_EQ(wrc_planar_step(contact, &planar, &output), WRC_OK);
  ASSERT_EQ(output.normal.patch_count, 1);
  const wrc_region one = region(0);
  const wrc_planar_normal_solution& normal = output.normal;
  const wrc_planar_forces& forces = output.forces;
  EXPECT_EQ(one.available, uint32_t{WRC_AVAILABLE_TRACTIONS | WRC_AVAILABLE_PLACE});
  EXPECT_EQ(one.strip_count, normal.strip_count);
  EXPECT_EQ(one.cell_count, config.planar.cells);
  EXPECT_EQ(one.normal_force, normal.normal_force);
  EXPECT_EQ(one.area, normal.area);
  EXPECT_EQ(one.length, normal.length);
  EXPECT_EQ(one.width, normal.width);
  EXPECT_EQ(one.y_min, normal.y_min);
  EXPECT_EQ(one.y_max, normal.y_max);
  EXPECT_EQ(one.peak_pressure, normal.peak_pressure);
  EXPECT_EQ(one.longitudinal_force, forces.fx);
  EXPECT_EQ(one.lateral_force, forces.fy);
  EXPECT_EQ(one.spin_moment, forces.mz);
  EXPECT_EQ(one.power, forces.power);
  EXPECT_EQ(one.adhesion_fraction, forces.adhesion_fraction);
  expect_same_bits(one.ellipse, normal.ellipse);
  expect_same_bits(one.creepage, planar.creepage);
  EXPECT_EQ(one.rolling_radius, 0.46 + one.z_wheel);
  EXPECT_NEAR(one.rolling_radius, output.point.rolling_radius, 1e-5);
  EXPECT_EQ(one.angle, output.point.angle);
  for (int k = 0; k < 3; ++k)  // both forces and the normal in the plane of the contact angle
    EXPECT_NEAR(one.force[k],
                (k == 0   ? forces.fx
                 : k == 1 ? forces.fy * std::cos(one.angle)
                          : forces.fy * std::sin(one.angle)) -
                    normal.normal_force * one.normal[k],
                1e-9 * normal.normal_force);

  const Assessed of_one = assess(0), of_all = assess(WRC_ALL_REGIONS);
  expect_same_bits(of_one.damage, output.damage);
  expect_same_bits(of_one.damage, of_all.damage);
  expect_same_bits(of_one.wear, of_all.wear);
  expect_same_bits(of_one.temperature, of_all.temperature);
  expect_same_bits(of_one.levels, of_all.levels);
  expect_same_bits(of_one.of_wheel, of_all.of_wheel);
  expect_same_bits(of_one.of_rail, of_all.of_rail);
  EXPECT_GT(of_one.wear.largest_depth_rate, 0.0);
  EXPECT_GT(of_one.temperature.rise, 1.0);
  EXPECT_GT(of_one.of_rail.largest.von_mises.stress, 0.5 * one.peak_pressure);
  // fields are those of the whole: they add up to its forces
  EXPECT_NEAR(integral(0, field(0, WRC_FIELD_TRACTION_X)), forces.fx, 1e-9 * std::abs(forces.fx));
  EXPECT_NEAR(integral(0, field(0, WRC_FIELD_TRACTION_Y)), forces.fy, 1e-9 * std::abs(forces.fy));
  const Numbers density = field(0, WRC_FIELD_POWER_DENSITY);
  EXPECT_EQ(*std::max_element(density.begin(), density.end()), output.damage.peak_power_density);
  EXPECT_EQ(field_values(contact, WRC_ALL_REGIONS, WRC_FIELD_X).status, WRC_ERROR_RANGE);
}

/// Tread and flange root.
TEST_F(RegionResults, PatchesAddUpToTheWhole) {
  create();
  wrc_planar_input planar = wrc_planar_input_default();
  planar.pose.lateral = 5.5e-3;
  planar.load.normal_force = 80e3;
  planar.creepage.longitudinal = 1e-3;
  planar.creepage.spin = 0.2;
  planar.creepage.speed = 20.0;
  wrc_planar_output output = sized<wrc_planar_output>();
  ASSERT_EQ(wrc_planar_step(contact, &planar, &output), WRC_OK) << error();
  ASSERT_EQ(output.normal.patch_count, 2);
  const wrc_region one[] = {region(0), region(1)};
  const Assessed of_one[] = {assess(0), assess(1)}, all = assess(WRC_ALL_REGIONS);
  const auto add_up = [](double first, double second, double whole) {
    EXPECT_NEAR(first + second, whole, 1e-12 * std::abs(whole));
    EXPECT_NE(first, second);
  };
  add_up(one[0].normal_force, one[1].normal_force, output.normal.normal_force);
  add_up(one[0].area, one[1].area, output.normal.area);
  add_up(one[0].longitudinal_force, one[1].longitudinal_force, output.forces.fx);
  add_up(one[0].lateral_force, one[1].lateral_force, output.forces.fy);
  add_up(one[0].spin_moment, one[1].spin_moment, output.forces.mz);
  add_up(one[0].power, one[1].power, output.forces.power);
  EXPECT_EQ(one[0].strip_count + one[1].strip_count, output.normal.strip_count);
  EXPECT_LT(one[0].y_max, one[1].y_min);
  add_up(of_one[0].damage.power, of_one[1].damage.power, all.damage.power);
  add_up(of_one[0].damage.t_gamma, of_one[1].damage.t_gamma, all.damage.t_gamma);
  add_up(of_one[0].temperature.rail_heat, of_one[1].temperature.rail_heat, all.temperature.rail_heat);
  const auto is_the_larger = [](double first, double second, double whole) {
    EXPECT_EQ(std::max(first, second), whole);
    EXPECT_NE(first, second);
  };
  is_the_larger(of_one[0].wear.largest_depth_rate, of_one[1].wear.largest_depth_rate,
                all.wear.largest_depth_rate);
  is_the_larger(of_one[0].temperature.rise, of_one[1].temperature.rise, all.temperature.rise);
  is_the_larger(of_one[0].damage.peak_power_density, of_one[1].damage.peak_power_density,
                all.damage.peak_power_density);
  // of the two a part each: stresses of the neighbour are little at a distance
  const double largest =
      std::max(of_one[0].of_rail.largest.von_mises.stress, of_one[1].of_rail.largest.von_mises.stress);
  EXPECT_NEAR(all.of_rail.largest.von_mises.stress, largest, 0.03 * largest);
}

// ----------------------------------------------------------------------------------------------------------
// options of one kind and solutions of the other

class RegionOptions : public RegionResults {
 protected:
  /// Wrench, regions and damage of a wheel.
  struct OfWheel {
    wrc_wrench wrench;
    std::vector<wrc_region> region;
    std::vector<wrc_damage> damage;
  };
  OfWheel wheel_with_these() {
    create();
    solve();
    OfWheel found{wrench, {}, {}};
    for (int32_t i = 0; i < wrench.region_count; ++i) {
      found.region.push_back(region(i));
      found.damage.push_back(assess(i).damage);
    }
    return found;
  }
};

/// Strips roll in these cells: tangential forces converge with them. Pressure, extent and place do not know
/// them.
TEST_F(RegionOptions, CellsOfTheSurfaceAreThoseOfItsFieldsAndOfRolling) {
  const OfWheel with_32 = wheel_with_these();
  EXPECT_EQ(with_32.region[0].cell_count, 32);
  config.surface.cells = 512;
  const Vector limit = vector_of(wheel_with_these().wrench.force);
  double last = 1.0;
  for (const int32_t cells : {4, 16, 64, 256}) {
    config.surface.cells = cells;
    const OfWheel other = wheel_with_these();
    const double error = length(vector_of(other.wrench.force) - limit) / with_32.wrench.normal_force;
    EXPECT_LT(error, 0.5 * last) << cells;
    last = error;
    EXPECT_EQ(other.wrench.normal_force, with_32.wrench.normal_force);
    EXPECT_EQ(other.wrench.area, with_32.wrench.area);
    EXPECT_EQ(other.wrench.peak_pressure, with_32.wrench.peak_pressure);
    for (std::size_t i = 0; i < 2; ++i) {
      const wrc_region &shown = other.region[i], &before = with_32.region[i];
      EXPECT_EQ(shown.cell_count, cells);
      EXPECT_EQ(shown.strip_count, before.strip_count);
      EXPECT_EQ(shown.normal_force, before.normal_force);
      EXPECT_EQ(shown.length, before.length);
      EXPECT_EQ(shown.rolling_radius, before.rolling_radius);
      expect_same_bits(shown.point, before.point);
      expect_same_bits(shown.ellipse, before.ellipse);
      expect_same_bits(shown.creepage, before.creepage);
      const auto index = static_cast<int32_t>(i);
      const FieldValues pressure = field_values(contact, index, WRC_FIELD_PRESSURE),
                        rise = field_values(contact, index, WRC_FIELD_TEMPERATURE_RISE);
      EXPECT_EQ(pressure.cells, static_cast<uint64_t>(cells));
      EXPECT_EQ(pressure.strips, static_cast<uint64_t>(shown.strip_count));
      EXPECT_EQ(rise.cells, static_cast<uint64_t>(cells));
    }
  }
  EXPECT_LT(last, 2e-5);
}

TEST_F(RegionOptions, OptionsOfPlanesChangeNoBitOfAWheel) {
  const OfWheel before = wheel_with_these();
  const wrc_config_planar defaults = config.planar;
  const auto expect_nothing = [&](const char* which) {
    SCOPED_TRACE(which);
    const OfWheel after = wheel_with_these();
    expect_same_bits(after.wrench, before.wrench);
    ASSERT_EQ(after.region.size(), before.region.size());
    for (std::size_t i = 0; i < before.region.size(); ++i) {
      wrc_region shown = after.region[i];
      // an ellipse is what the regularisation makes of the strips
      if (config.planar.regularisation != defaults.regularisation) shown.ellipse = before.region[i].ellipse;
      expect_same_bits(shown, before.region[i]);
      expect_same_bits(after.damage[i], before.damage[i]);
    }
    config.planar = defaults;
  };
  config.planar.strips = 81;
  expect_nothing("strips");
  config.planar.cells = 20;
  expect_nothing("cells");
  config.planar.gap_rows = 100;
  expect_nothing("gap_rows");
  config.planar.max_patches = 1;
  expect_nothing("max_patches");
  config.planar.max_sweeps = 5;
  expect_nothing("max_sweeps");
  config.planar.start = WRC_START_WARM;
  expect_nothing("start");
  config.planar.regularisation = WRC_REGULARISE_KEEP_RATIO;
  expect_nothing("regularisation");
  config.planar.gap_limit = 0.3e-3;
  expect_nothing("gap_limit");
}

TEST_F(RegionOptions, OptionsOfTheSurfaceChangeNoBitOfAPlane) {
  wrc_planar_input planar = wrc_planar_input_default();
  planar.pose.lateral = 5.5e-3;
  planar.load.normal_force = 80e3;
  planar.creepage.longitudinal = 1e-3;
  planar.creepage.lateral = 1e-3;
  planar.creepage.speed = 20.0;
  for (const int32_t method : {WRC_TANGENTIAL_STRIP_FASTSIM, WRC_TANGENTIAL_FASTSIM}) {
    config.tangential.method = method;
    wrc_planar_output first = sized<wrc_planar_output>();
    wrc_region shown = sized<wrc_region>();
    Numbers traction;
    for (const int32_t cells : {32, 4, 512}) {
      config.surface.cells = cells;
      create();
      wrc_planar_output output = sized<wrc_planar_output>();
      ASSERT_EQ(wrc_planar_step(contact, &planar, &output), WRC_OK) << error();
      if (cells == 32) {
        first = output;
        shown = region(1);
        traction = field(1, WRC_FIELD_TRACTION_X);
        EXPECT_EQ(shown.cell_count, config.planar.cells);
      }
      expect_same_bits(output, first);
      expect_same_bits(region(1), shown);
      EXPECT_EQ(field(1, WRC_FIELD_TRACTION_X), traction);
    }
    config.surface = test_config().surface;
  }
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
