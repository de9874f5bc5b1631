/// Contact temperatures through the interface: full slip in closed form, where heat goes, both ways of
/// rolling, standstill, what is refused.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "field_values.hpp"
#include "loaded_ellipse.hpp"
#include "not_finite.hpp"
#include "test_config.hpp"

namespace {

constexpr double pi = 3.14159265358979323846;

/// An ellipse in full slip: q = mu p V |slip|, semi-elliptic along every strip.
class Temperature : public LoadedEllipse {
 protected:
  wrc_temperature temperature = sized<wrc_temperature>();

  void SetUp() override {
    config.planar.cells = 64;
    creepage.longitudinal = 0.5;
    creepage.speed = 10.0;
    make();
  }
  int32_t solve(const wrc_bulk_temperatures* bulk = nullptr) {
    const int32_t status = LoadedEllipse::solve();
    return status < 0 ? status : wrc_contact_temperature(contact, WRC_ALL_REGIONS, bulk, &temperature);
  }
  std::vector<double> rises() {
    const FieldValues found = field_values(contact, 0, WRC_FIELD_TEMPERATURE_RISE);
    EXPECT_EQ(found.status, WRC_OK);
    return found.values;
  }
};

// Over the longest strip s = a (1 - cos t): rise = q0 / (2 beta sqrt(pi V)) sqrt(a) g, g the largest of
// Int_0^t sin^2 u / sqrt(cos u - cos t) du = 1.6414 at x = -0.7267 a, here by a sum over midpoints.
TEST_F(Temperature, FullSlipIsAMovingSource) {
  ASSERT_EQ(solve(), WRC_OK);
  double largest = 0.0, place = 0.0;
  for (double x = -1.0; x < 1.0; x += 0.002) {
    constexpr int n = 4000;
    const double way = 1.0 - x;  // s' = way (1 - v^2): no singularity is left
    double sum = 0.0;
    for (int k = 0; k < n; ++k) {
      const double v = (k + 0.5) / n, at = 1.0 - way * (1.0 - v * v);
      sum += 2.0 * std::sqrt(way) * std::sqrt(std::fmax(0.0, 1.0 - at * at)) / n;
    }
    if (sum > largest) largest = sum, place = x;
  }
  const double peak = 1.5 * ellipse.normal_force / (pi * ellipse.a * ellipse.b);
  const double heat = friction.coefficient * peak * 0.5 * creepage.speed;
  const double beta = std::sqrt(50.0 * 7850.0 * 450.0);
  const double expected =
      heat * std::sqrt(ellipse.a) * largest / (2.0 * beta * std::sqrt(pi * creepage.speed));
  EXPECT_NEAR(temperature.rise, expected, 0.01 * expected);  // the elastic slip has a share
  EXPECT_NEAR(temperature.x, place * ellipse.a, 0.05 * ellipse.a);
  EXPECT_NEAR(temperature.y, 0.0, 0.1 * ellipse.b);
  EXPECT_EQ(temperature.at_entry, 20.0);
  EXPECT_EQ(temperature.largest, 20.0 + temperature.rise);
  const std::vector<double> field = rises();
  EXPECT_EQ(temperature.rise, *std::max_element(field.begin(), field.end()));
  EXPECT_GT(temperature.mean_rise, 0.3 * temperature.rise);
  EXPECT_LT(temperature.mean_rise, 0.7 * temperature.rise);
}

TEST_F(Temperature, HeatIsThePowerDividedByTheBodies) {
  creepage.longitudinal = 2e-3;
  creepage.spin = 0.5;
  ASSERT_EQ(solve(), WRC_OK);
  wrc_damage damage{};
  ASSERT_EQ(wrc_contact_damage(contact, WRC_ALL_REGIONS, &damage), WRC_OK);
  EXPECT_NEAR(temperature.wheel_heat + temperature.rail_heat, damage.power, 1e-12 * damage.power);
  EXPECT_EQ(temperature.wheel_heat, temperature.rail_heat);
  const double alike = temperature.rise;
  config.rail_heat.conductivity *= 9.0;  // three times the effusivity
  make();
  ASSERT_EQ(solve(), WRC_OK);
  EXPECT_NEAR(temperature.rail_heat, 3.0 * temperature.wheel_heat, 1e-9 * temperature.rail_heat);
  EXPECT_NEAR(temperature.rise, 0.5 * alike, 1e-12 * alike);
}

// Two bodies that touch: half-spaces at 100 and 0 degrees meet at 50, and heat flows as 1 / sqrt(time).
TEST_F(Temperature, BodiesOfOtherTemperaturesExchangeHeat) {
  wrc_bulk_temperatures bulk = wrc_bulk_temperatures_default();
  ASSERT_EQ(solve(&bulk), WRC_OK);
  const wrc_temperature alike = temperature;
  bulk.wheel = 0.0;
  bulk.rail = 100.0;
  ASSERT_EQ(wrc_contact_temperature(contact, WRC_ALL_REGIONS, &bulk, &temperature), WRC_OK);
  EXPECT_NEAR(temperature.at_entry, 50.0, 1e-12);
  EXPECT_EQ(temperature.rise, alike.rise);
  const double flows = temperature.wheel_heat - alike.wheel_heat;
  EXPECT_NEAR(temperature.rail_heat - alike.rail_heat, -flows, 1e-9 * flows);
  // Int over the strips of beta / 2 * 100 K * 2 sqrt(2 l V / pi), Int (1 - y^2)^(1/4) dy = 1.748038
  const double beta = std::sqrt(50.0 * 7850.0 * 450.0);
  const double exact = 100.0 * beta * std::sqrt(2.0 * ellipse.a * creepage.speed / pi) * 1.748038 * ellipse.b;
  EXPECT_NEAR(flows, exact, 2e-3 * exact);
}

TEST_F(Temperature, BackwardsIsTheMirrorImage) {
  creepage.longitudinal = 1.5e-3;
  creepage.lateral = 5e-4;
  ASSERT_EQ(solve(), WRC_OK);
  const wrc_temperature forward = temperature;
  const std::vector<double> field = rises();
  creepage.longitudinal *= -1.0;
  creepage.speed *= -1.0;
  ASSERT_EQ(solve(), WRC_OK);
  EXPECT_EQ(temperature.rise, forward.rise);
  EXPECT_EQ(temperature.x, -forward.x);
  EXPECT_LT(forward.x, 0.0);
  EXPECT_EQ(rises(), field);
}

TEST_F(Temperature, GoesWithTheRootOfTheSpeedToNothing) {
  ASSERT_EQ(solve(), WRC_OK);
  const double at_ten = temperature.rise;
  creepage.speed = 40.0;
  ASSERT_EQ(solve(), WRC_OK);
  EXPECT_NEAR(temperature.rise, 2.0 * at_ten, 1e-12 * at_ten);
  creepage.speed = 0.0;
  ASSERT_EQ(solve(), WRC_OK);
  EXPECT_EQ(temperature.rise, 0.0);
  EXPECT_EQ(temperature.wheel_heat, 0.0);
}

TEST_F(Temperature, StripOfTheCallerIsTheContacts) {
  creepage.spin = 0.3;
  ASSERT_EQ(solve(), WRC_OK);
  const FieldValues power = field_values(contact, 0, WRC_FIELD_POWER_DENSITY),
                    half = field_values(contact, 0, WRC_FIELD_STRIP_HALF_LENGTH),
                    rise = field_values(contact, 0, WRC_FIELD_TEMPERATURE_RISE);
  for (const FieldValues* each : {&power, &half, &rise}) ASSERT_EQ(each->status, WRC_OK);
  const std::size_t j = 20;
  std::vector<double> strip;
  for (std::size_t i = 0; i < power.cells; ++i) strip.push_back(power.at(i, j));
  ASSERT_EQ(wrc_flash_temperature(static_cast<uint32_t>(strip.size()), 2.0 * half[j] / 64.0, strip.data(),
                                  creepage.speed, nullptr, nullptr, strip.data()),
            WRC_OK);
  for (std::size_t i = 0; i < strip.size(); ++i)
    EXPECT_NEAR(strip[i], rise.at(i, j), 1e-10 * temperature.rise);
}

TEST_F(Temperature, RefusesWhatMakesNoSense) {
  EXPECT_EQ(wrc_contact_temperature(contact, WRC_ALL_REGIONS, nullptr, &temperature), WRC_ERROR_SEQUENCE);
  EXPECT_EQ(field_values(contact, 0, WRC_FIELD_TEMPERATURE_RISE).status, WRC_ERROR_SEQUENCE);
  EXPECT_EQ(wrc_contact_temperature(nullptr, WRC_ALL_REGIONS, nullptr, &temperature), WRC_ERROR_NULL);
  ASSERT_EQ(wrc_planar_tangential(contact, &ellipse, &creepage, &friction, &forces), WRC_OK);
  EXPECT_EQ(wrc_contact_temperature(contact, WRC_ALL_REGIONS, nullptr, nullptr), WRC_ERROR_NULL);
  EXPECT_EQ(field_values(contact, 0, WRC_FIELD_TEMPERATURE_RISE).status, WRC_OK);  // no call need come before
  EXPECT_EQ(wrc_contact_temperature(contact, 1, nullptr, &temperature), WRC_ERROR_RANGE);
  wrc_bulk_temperatures bulk = wrc_bulk_temperatures_default();
  bulk.rail = 3000.0;
  EXPECT_EQ(wrc_contact_temperature(contact, WRC_ALL_REGIONS, &bulk, &temperature), WRC_ERROR_RANGE);
  bulk.rail = nan_value;
  EXPECT_EQ(wrc_contact_temperature(contact, WRC_ALL_REGIONS, &bulk, &temperature), WRC_ERROR_NOT_FINITE);
  EXPECT_EQ(temperature.rise, 0.0);
  temperature.struct_size = 8;
  EXPECT_EQ(wrc_contact_temperature(contact, WRC_ALL_REGIONS, nullptr, &temperature), WRC_ERROR_STRUCT_SIZE);
  config.wheel_heat.specific_heat = 0.45;
  char text[256];
  EXPECT_EQ(wrc_config_check(&config, text, sizeof text), WRC_ERROR_RANGE);
  ReferenceWheel::expect_words(text, {"config.wheel_heat.specific_heat = 0.45", "did you pass kJ?"});

  std::vector<double> heat(4, 1e9);
  const auto flash = [&](uint32_t count, double cell, double speed) {
    return wrc_flash_temperature(count, cell, heat.data(), speed, nullptr, nullptr, heat.data());
  };
  EXPECT_EQ(flash(0, 1e-4, 1.0), WRC_ERROR_RANGE);
  EXPECT_EQ(flash(513, 1e-4, 1.0), WRC_ERROR_RANGE);
  EXPECT_EQ(flash(4, 1.0, 1.0), WRC_ERROR_RANGE);
  heat.assign(4, 1e9);
  EXPECT_EQ(flash(4, 1e-4, 0.0), WRC_ERROR_RANGE);
  EXPECT_EQ(heat[0], 0.0);
  heat[2] = nan_value;
  EXPECT_EQ(flash(4, 1e-4, 1.0), WRC_ERROR_NOT_FINITE);
  EXPECT_EQ(wrc_flash_temperature(4, 1e-4, nullptr, 1.0, nullptr, nullptr, heat.data()), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_flash_temperature(4, 1e-4, heat.data(), 1.0, nullptr, nullptr, nullptr), WRC_ERROR_NULL);
}

TEST_F(Temperature, NeedsTractions) {
  config.tangential.method = WRC_TANGENTIAL_FORCE_TABLE;
  config.tangential.force_table = WRC_FORCE_TABLE;
  make();
  EXPECT_EQ(solve(), WRC_ERROR_UNSUPPORTED);
}

}  // namespace
