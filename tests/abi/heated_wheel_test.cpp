/// A wheel on a rail whose friction falls with the temperature it makes.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "field_values.hpp"
#include "reference_contact.hpp"
#include "test_config.hpp"
#include "wheel_on_rail.hpp"
#include "wrc/wrc_offline.h"

namespace {

using Numbers = std::vector<double>;

class HeatedWheel : public testing::Test, protected PlacedWheel {
 protected:
  HeatedWheel() {
    wheel.y = 2e-3;
    wheel.velocity[0] = 40.0;
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = 80e3;
    friction.coefficient = 0.4;
    friction.temperature_law = WRC_TEMPERATURE_LAW_LINEAR;
    slide(0.02);
  }
  /// Longitudinal creepage, nearly.
  void slide(double share) { wheel.angular_velocity[1] = -wheel.velocity[0] / 0.46 * (1.0 + share); }
  void solve() { ASSERT_GE(step(), WRC_OK) << error(); }
  /// Values of cells in rows of strips: cell i of strip j at i * strips + j.
  Numbers field(int32_t index, int32_t which) {
    const FieldValues found = field_values(contact, index, which);
    EXPECT_EQ(found.status, WRC_OK) << which;
    Numbers values;
    for (std::size_t i = 0; i < found.cells; ++i)
      for (std::size_t j = 0; j < found.strips; ++j) values.push_back(found.at(i, j));
    return values;
  }
  wrc_temperature temperature(int32_t index) {
    wrc_temperature found = sized<wrc_temperature>();
    EXPECT_EQ(wrc_contact_temperature(contact, index, &friction.bulk, &found), WRC_OK);
    return found;
  }
};

// Each strip's coefficient is the law's mean over its load at the temperatures that its own tractions make.
TEST_F(HeatedWheel, CoefficientsGoWithTheTemperaturesTheyMake) {
  create();
  friction.bulk.wheel = 90.0;
  for (const double slip : {0.002, 0.01, -0.3}) {
    for (const double y : {2e-3, 6.6e-3}) {
      wheel.y = y;
      slide(slip);
      solve();
      for (int32_t r = 0; r < wrench.region_count; ++r) {
        const Numbers rise = field(r, WRC_FIELD_TEMPERATURE_RISE);
        const Numbers coefficient = field(r, WRC_FIELD_STRIP_FRICTION);
        const wrc_temperature found = temperature(r);
        EXPECT_EQ(found.rise, *std::max_element(rise.begin(), rise.end()));
        EXPECT_NEAR(found.at_entry, 55.0, 1e-12);  // bodies alike
        const std::size_t strips = coefficient.size(), cells = rise.size() / strips;
        for (std::size_t j = 0; j < strips; ++j) {
          double sum = 0.0, weights = 0.0;
          for (std::size_t i = 0; i < cells; ++i) {
            const double xi = (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(cells) - 1.0;
            const double weight = std::sqrt(1.0 - xi * xi), hot = found.at_entry + rise[i * strips + j];
            sum += weight * (1.0 - 0.5 * std::clamp(hot / 400.0, 0.0, 1.0));
            weights += weight;
          }
          EXPECT_NEAR(coefficient[j], 0.4 * sum / weights, 0.4e-3) << slip << ' ' << j;
        }
        EXPECT_LT(*std::min_element(coefficient.begin(), coefficient.end()), 0.4 * 0.93);  // 55 degrees alone
      }
    }
  }
}

// A law that does not fall is constant friction, bit for bit: with and without regions of their own.
TEST_F(HeatedWheel, WithoutAFallItIsConstant) {
  for (const int32_t method :
       {WRC_TANGENTIAL_STRIP_FASTSIM, WRC_TANGENTIAL_FASTRIP, WRC_TANGENTIAL_FASTSIM}) {
    config.tangential.method = method;
    const bool by_patch = method == WRC_TANGENTIAL_FASTSIM;
    if (by_patch) config.tangential.patch_model = WRC_PATCH_MODEL_PATCH_ELLIPSE;
    create();
    for (const double speed : {40.0, -0.02}) {  // the latter is both ways at once
      wheel.velocity[0] = speed;
      slide(4e-3);
      friction.temperature_law = WRC_TEMPERATURE_LAW_LINEAR;
      friction.hot_ratio = 1.0;
      const int32_t status = step();
      ASSERT_GE(status, WRC_OK) << error();
      const wrc_wrench heated = wrench;
      friction.temperature_law = WRC_TEMPERATURE_LAW_NONE;
      EXPECT_EQ(step(), status);
      if (by_patch) {  // patches have means of friction, in rounding
        EXPECT_NEAR(wrench.force[0], heated.force[0], 1e-9 * std::abs(heated.force[0]));
      } else {
        EXPECT_EQ(std::memcmp(&wrench, &heated, sizeof heated), 0) << method << ' ' << speed;
      }
    }
  }
}

TEST_F(HeatedWheel, HotSurfacesHaveTheHotRatio) {
  create();
  friction.bulk.wheel = friction.bulk.rail = 2000.0;
  friction.hot_temperature = 100.0;
  friction.hot_ratio = 0.25;
  solve();
  const double hot = wrench.force[0];
  friction = wrc_friction_default();
  friction.coefficient = 0.1;
  solve();
  EXPECT_NEAR(hot, wrench.force[0], 1e-9 * std::abs(hot));
}

// The planar step with the load and the creepages of the wheel's region: what friction loses by its heat is
// alike, within what the two patches differ by.
TEST_F(HeatedWheel, LosesWhatThePlanarStepLoses) {
  create();
  for (const double y : {2e-3, 4e-3}) {
    for (const double slip : {0.003, 0.01, 0.05}) {
      wheel.y = y;
      slide(slip);
      double on_surface[2], flat[2], rise[2] = {};  // forces by constant and heated friction
      for (const int32_t law : {WRC_TEMPERATURE_LAW_NONE, WRC_TEMPERATURE_LAW_LINEAR}) {
        friction.temperature_law = law;
        solve();
        ASSERT_EQ(wrench.region_count, 1);
        wrc_region region = sized<wrc_region>();
        ASSERT_EQ(wrc_contact_region(contact, 0, &region), WRC_OK);
        wrc_planar_input planar = wrc_planar_input_default();
        planar.pose.lateral = y;
        planar.load.normal_force = region.normal_force;
        planar.creepage.longitudinal = region.creepage.longitudinal;
        planar.creepage.lateral = region.creepage.lateral;
        planar.creepage.spin = region.creepage.spin;
        planar.creepage.speed = 40.0;
        planar.friction = friction;
        wrc_planar_output output = sized<wrc_planar_output>();
        ASSERT_EQ(wrc_planar_step(contact, &planar, &output), WRC_OK);
        wrc_temperature found = sized<wrc_temperature>();
        ASSERT_EQ(wrc_contact_temperature(contact, WRC_ALL_REGIONS, nullptr, &found), WRC_OK);
        on_surface[law] = wrench.force[0];
        flat[law] = output.forces.fx;
        rise[0] = temperature(0).rise;
        rise[1] = found.rise;
      }
      const double loses = 1.0 - flat[1] / flat[0];
      EXPECT_GT(loses, 0.03) << y << ' ' << slip;
      EXPECT_NEAR(1.0 - on_surface[1] / on_surface[0], loses, 3e-3) << y << ' ' << slip;
      EXPECT_NEAR(rise[0], rise[1], 0.05 * rise[1]) << y << ' ' << slip;
    }
  }
}

TEST_F(HeatedWheel, HeatIsThePower) {
  create();
  for (const double y : {2e-3, 6.6e-3}) {
    wheel.y = y;
    wheel.yaw = 2e-3;
    solve();
    double heat = 0.0;
    for (int32_t r = 0; r < wrench.region_count; ++r) {
      const wrc_temperature found = temperature(r);
      wrc_region region = sized<wrc_region>();
      ASSERT_EQ(wrc_contact_region(contact, r, &region), WRC_OK);
      EXPECT_EQ(found.wheel_heat, found.rail_heat);
      heat += found.wheel_heat + found.rail_heat;
    }
    EXPECT_NEAR(heat, wrench.power, 0.02 * wrench.power);
  }
}

// In steps of 1 um over the tread, to where a second region appears, and to where both join: no force jumps,
// and hardly more than under constant friction.
TEST_F(HeatedWheel, IsContinuousInThePose) {
  create();
  input.prescribed = WRC_PRESCRIBE_HEIGHT;
  input.vertical_load = 0.0;
  const struct {
    double y, z;
    int32_t fewest, most;  // regions
  } scans[] = {{2e-3, 0.2e-3, 1, 1}, {5.4e-3, -0.3e-3, 1, 2}, {5.7e-3, -0.3e-3, 1, 2}};
  constexpr int steps = 120;
  for (const double slip : {0.002, 0.02}) {
    slide(slip);
    for (const auto& scan : scans) {
      wheel.z = scan.z;
      double bend[2] = {};  // the largest second difference
      int32_t fewest = 9, most = 0;
      for (const int32_t law : {WRC_TEMPERATURE_LAW_NONE, WRC_TEMPERATURE_LAW_LINEAR}) {
        friction.temperature_law = law;
        Numbers forces[2];
        for (int k = 0; k < steps; ++k) {
          wheel.y = scan.y + k * 1e-6;
          solve();
          fewest = std::min(fewest, wrench.region_count);
          most = std::max(most, wrench.region_count);
          for (int i = 0; i < 2; ++i) forces[i].push_back(wrench.force[i] / 80e3);
        }
        double& largest = bend[law];
        for (const Numbers& f : forces)
          for (std::size_t k = 1; k + 1 < f.size(); ++k)
            largest = std::max(largest, std::abs(f[k + 1] - 2.0 * f[k] + f[k - 1]));
      }
      EXPECT_EQ(fewest, scan.fewest);
      EXPECT_EQ(most, scan.most);
      EXPECT_LT(bend[1], 2.0 * bend[0] + 2e-6) << slip << ' ' << scan.y;
      EXPECT_LT(bend[1], 4e-5) << slip << ' ' << scan.y;
    }
  }
}

TEST_F(HeatedWheel, BackwardsAndLeftAreMirrorImages) {
  create();
  wheel.velocity[1] = 0.05;
  solve();
  const wrc_wrench right = wrench;
  const wrc_temperature found = temperature(0);
  wheel.velocity[0] = -wheel.velocity[0];
  wheel.angular_velocity[1] = -wheel.angular_velocity[1];
  solve();
  EXPECT_NEAR(wrench.force[0], -right.force[0], 1e-9 * std::abs(right.force[0]));
  EXPECT_NEAR(temperature(0).rise, found.rise, 1e-9 * found.rise);
  wheel.velocity[0] = -wheel.velocity[0];
  wheel.angular_velocity[1] = -wheel.angular_velocity[1];
  take(WRC_SIDE_LEFT);
  wheel.y = -wheel.y;
  wheel.velocity[1] = -wheel.velocity[1];
  solve();
  EXPECT_EQ(wrench.force[0], right.force[0]);
  EXPECT_EQ(wrench.force[1], -right.force[1]);
}

TEST_F(HeatedWheel, EveryMethodWithTractionsHeats) {
  wheel.y = 0.0;
  Numbers forces;
  struct Way {
    int32_t method, patch_model;
  };
  for (const auto& [method, patch_model] : {Way{WRC_TANGENTIAL_STRIP_FASTSIM, WRC_PATCH_MODEL_PATCH_SDEC},
                                            Way{WRC_TANGENTIAL_FASTSIM, WRC_PATCH_MODEL_PATCH_SDEC},
                                            Way{WRC_TANGENTIAL_FASTRIP, WRC_PATCH_MODEL_PATCH_SDEC},
                                            Way{WRC_TANGENTIAL_FASTSIM, WRC_PATCH_MODEL_PATCH_ELLIPSE}}) {
    config.tangential.method = method;
    config.tangential.patch_model = patch_model;
    create();
    solve();
    forces.push_back(wrench.force[0] / wrench.normal_force);
    const Numbers coefficient = field(0, WRC_FIELD_STRIP_FRICTION);
    EXPECT_LT(*std::min_element(coefficient.begin(), coefficient.end()), 0.35) << method;
    EXPECT_GT(*std::min_element(coefficient.begin(), coefficient.end()), 0.2) << method;
    EXPECT_NEAR(forces.back(), forces.front(), 0.03 * forces.front()) << method;
  }
}

TEST_F(HeatedWheel, RefusesWhatItCannot) {
  create();
  EXPECT_EQ(wrc_exact_wrench(contact, &input, nullptr, &wrench), WRC_ERROR_UNSUPPORTED);
  friction.hot_temperature = friction.cold_temperature;
  EXPECT_EQ(step(), WRC_ERROR_RANGE);
  friction.hot_temperature = 400.0;
  config.tangential.method = WRC_TANGENTIAL_FASTSIM;  // by patches: without fields over a region
  config.tangential.patch_model = WRC_PATCH_MODEL_PATCH_ELLIPSE;
  create();
  solve();
  wrc_temperature found = sized<wrc_temperature>();
  EXPECT_EQ(wrc_contact_temperature(contact, 0, nullptr, &found), WRC_ERROR_UNSUPPORTED);
  config.tangential = test_config().tangential;
  config.tangential.method = WRC_TANGENTIAL_FORCE_TABLE;
  config.tangential.force_table = WRC_FORCE_TABLE;
  create();
  EXPECT_EQ(step(), WRC_ERROR_UNSUPPORTED);
  ReferenceWheel::expect_words(error(), {"input.friction.temperature_law = 1", "no tractions"});
}

}  // namespace
