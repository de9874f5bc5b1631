/// Friction that falls with the temperature it makes: full slip in closed form, limits of the law, what is
/// continuous, what is refused.
#include <algorithm>
#include <cmath>
#include <vector>

#include "field_values.hpp"
#include "loaded_ellipse.hpp"
#include "test_config.hpp"

namespace {

class HeatedFriction : public LoadedEllipse {
 protected:
  void SetUp() override {
    creepage.longitudinal = 0.05;
    creepage.speed = 20.0;
    friction.coefficient = 0.4;
    friction.temperature_law = WRC_TEMPERATURE_LAW_LINEAR;
    make();
  }
  FieldValues field(int32_t id) {
    FieldValues found = field_values(contact, 0, id);
    EXPECT_EQ(found.status, WRC_OK);
    return found;
  }
};

// What was found is consistent: each strip's coefficient is the law's mean over the load at the temperatures
// that the contact's own tractions make.
TEST_F(HeatedFriction, CoefficientsGoWithTheTemperaturesTheyMake) {
  for (const double slip : {0.002, 0.01, 0.3}) {
    creepage.longitudinal = slip;
    creepage.spin = 0.4;
    ASSERT_EQ(solve(), WRC_OK) << slip;
    wrc_temperature temperature = sized<wrc_temperature>();
    ASSERT_EQ(wrc_contact_temperature(contact, WRC_ALL_REGIONS, &friction.bulk, &temperature), WRC_OK);
    const FieldValues rise = field(WRC_FIELD_TEMPERATURE_RISE);
    const std::vector<double> coefficient = field(WRC_FIELD_STRIP_FRICTION).values;
    const std::size_t strips = coefficient.size(), cells = rise.cells;
    for (std::size_t j = 0; j < strips; ++j) {
      double sum = 0.0, weights = 0.0;
      for (std::size_t i = 0; i < cells; ++i) {
        const double xi = (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(cells) - 1.0;
        const double weight = std::sqrt(1.0 - xi * xi);
        const double hot = temperature.at_entry + rise.at(i, j);
        sum += weight * (1.0 - 0.5 * std::clamp(hot / 400.0, 0.0, 1.0));
        weights += weight;
      }
      EXPECT_NEAR(coefficient[j], 0.4 * sum / weights, 0.4e-3) << slip;
    }
    EXPECT_LT(*std::min_element(coefficient.begin(), coefficient.end()), 0.4 * 0.975);  // 20 degrees alone
  }
}

// All slides: heat is proportional to friction, so that f = 1 - c (T_0 + f R), R the mean rise with f = 1.
TEST_F(HeatedFriction, FullSlipIsLinear) {
  config.planar.strips = 200;
  make();
  creepage.longitudinal = 0.5;
  creepage.speed = 2.0;
  friction.hot_temperature = 2000.0;
  friction.hot_ratio = 0.0;
  wrc_friction constant = wrc_friction_default();
  constant.coefficient = friction.coefficient;
  ASSERT_EQ(wrc_planar_tangential(contact, &ellipse, &creepage, &constant, &forces), WRC_OK);
  wrc_temperature temperature = sized<wrc_temperature>();
  ASSERT_EQ(wrc_contact_temperature(contact, WRC_ALL_REGIONS, nullptr, &temperature), WRC_OK);
  const FieldValues rise = field(WRC_FIELD_TEMPERATURE_RISE);
  ASSERT_EQ(solve(), WRC_OK);
  const std::vector<double> coefficient = field(WRC_FIELD_STRIP_FRICTION).values;
  const std::size_t cells = rise.cells, middle = coefficient.size() / 2;
  double sum = 0.0, weights = 0.0;
  for (std::size_t i = 0; i < cells; ++i) {
    const double xi = (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(cells) - 1.0;
    sum += std::sqrt(1.0 - xi * xi) * rise.at(i, middle);
    weights += std::sqrt(1.0 - xi * xi);
  }
  const double expected = (1.0 - 20.0 / 2000.0) / (1.0 + sum / weights / 2000.0);
  EXPECT_LT(expected, 0.9);
  EXPECT_NEAR(coefficient[middle] / 0.4, expected, 2e-3);
}

TEST_F(HeatedFriction, ColdAndHotSurfacesHaveTheEndsOfTheLaw) {
  friction.cold_temperature = 1900.0;
  friction.hot_temperature = 2900.0;
  ASSERT_EQ(solve(), WRC_OK);
  const double whole = forces.fx;
  friction.bulk.wheel = friction.bulk.rail = 2000.0;
  friction.cold_temperature = 0.0;
  friction.hot_temperature = 100.0;
  friction.hot_ratio = 0.3;
  ASSERT_EQ(solve(), WRC_OK);
  const double hot = forces.fx;
  wrc_friction constant = wrc_friction_default();
  constant.coefficient = 0.4;
  ASSERT_EQ(wrc_planar_tangential(contact, &ellipse, &creepage, &constant, &forces), WRC_OK);
  EXPECT_NEAR(whole, forces.fx, 1e-9 * std::fabs(whole));
  constant.coefficient = 0.12;
  ASSERT_EQ(wrc_planar_tangential(contact, &ellipse, &creepage, &constant, &forces), WRC_OK);
  EXPECT_NEAR(hot, forces.fx, 1e-9 * std::fabs(hot));
}

// Force over creepage rises, then falls as the contact heats, and has no jumps.
TEST_F(HeatedFriction, FallsWithoutJumps) {
  const double step = 6e-5;
  std::vector<double> force;
  for (int k = 1; k < 500; ++k) {
    creepage.longitudinal = k * step;
    ASSERT_EQ(solve(), WRC_OK) << k;
    force.push_back(-forces.fx / ellipse.normal_force);
  }
  const auto largest = std::max_element(force.begin(), force.end());
  EXPECT_GT(largest - force.begin(), 16);
  EXPECT_LT(force.back(), 0.95 * *largest);
  for (std::size_t k = 1; k + 1 < force.size(); ++k)
    EXPECT_LT(std::fabs(force[k + 1] - 2.0 * force[k] + force[k - 1]), 4e-3) << k;
}

TEST_F(HeatedFriction, SlowerOrWiderBodiesStayCold) {
  ASSERT_EQ(solve(), WRC_OK);
  const double fast = -forces.fx;
  creepage.speed = 1.0;
  ASSERT_EQ(solve(), WRC_OK);
  EXPECT_GT(-forces.fx, 1.02 * fast);
  creepage.speed = 20.0;
  config.wheel_heat.conductivity = config.rail_heat.conductivity = 500.0;
  make();
  ASSERT_EQ(solve(), WRC_OK);
  EXPECT_GT(-forces.fx, 1.02 * fast);
}

TEST_F(HeatedFriction, SensitivitiesAreThoseOfTheForces) {
  ASSERT_EQ(solve(), WRC_OK);
  wrc_planar_derivatives sensitivity = sized<wrc_planar_derivatives>();
  ASSERT_EQ(wrc_planar_tangential_derivatives(contact, &sensitivity), WRC_OK);
  const double h = 2e-4;
  creepage.longitudinal += h;
  ASSERT_EQ(solve(), WRC_OK);
  const double above = forces.fx;
  creepage.longitudinal -= 2.0 * h;
  ASSERT_EQ(solve(), WRC_OK);
  EXPECT_NEAR(sensitivity.forces[0][0], (above - forces.fx) / (2.0 * h),
              0.05 * std::fabs(sensitivity.forces[0][0]) + 1e3);
  EXPECT_GT(sensitivity.forces[0][0], 0.0);  // the force falls in size as the contact heats
}

TEST_F(HeatedFriction, RefusesWhatItCannot) {
  const auto refused = [&](int32_t status, const std::vector<std::string>& words) {
    EXPECT_EQ(solve(), status);
    char text[256];
    wrc_contact_last_error(contact, text, sizeof text);
    ReferenceWheel::expect_words(text, words);
  };
  friction.hot_temperature = 0.5;
  refused(WRC_ERROR_RANGE, {"friction.hot_temperature = 0.5", "at least 1 degC above"});
  friction.hot_temperature = nan_value;
  refused(WRC_ERROR_NOT_FINITE, {"hot_temperature"});
  friction = wrc_friction_default();
  friction.temperature_law = 2;
  refused(WRC_ERROR_UNSUPPORTED,
          {"friction.temperature_law = 2", "WRC_TEMPERATURE_LAW_NONE (0), _LINEAR (1)"});
  friction.temperature_law = WRC_TEMPERATURE_LAW_LINEAR;
  config.tangential.method = WRC_TANGENTIAL_FORCE_TABLE;
  config.tangential.force_table = WRC_FORCE_TABLE;
  make();
  refused(WRC_ERROR_UNSUPPORTED, {"friction.temperature_law = 1", "no tractions"});
}

TEST_F(HeatedFriction, IsForEveryMethodWithTractions) {
  for (int32_t method : {WRC_TANGENTIAL_FASTSIM, WRC_TANGENTIAL_FASTRIP}) {
    config.tangential.method = method;
    make();
    const int32_t status = solve();
    EXPECT_GE(status, WRC_OK) << method;
    EXPECT_LT(-forces.fx, 0.39 * ellipse.normal_force) << method;
    EXPECT_GT(-forces.fx, 0.15 * ellipse.normal_force) << method;
  }
}

}  // namespace
