/// Stresses below the surface through the interface: bodies, frames, what is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "offline_helpers.hpp"
#include "test_config.hpp"

namespace {

using namespace offline_helpers;

class ExactStress : public testing::Test {
 protected:
  std::vector<double> pressure, along, across;
  wrc_exact_loads loads = wrc_exact_loads_default();
  wrc_stresses stresses = sized<wrc_stresses>();
  std::vector<wrc_stress_peaks> levels = std::vector<wrc_stress_peaks>(2);
  char text[256] = "";

  void SetUp() override {
    constexpr uint32_t n = 24;
    loads.grid = grid_over(6e-3, 4e-3, n);
    for (uint32_t k = 0; k < n * n; ++k) {
      const double x = (loads.grid.x0 + k % n * loads.grid.dx) / 6e-3;
      const double y = (loads.grid.y0 + k / n * loads.grid.dy) / 4e-3;
      pressure.push_back(1e9 * std::sqrt(std::fmax(0.0, 1.0 - x * x - y * y)));
      along.push_back(-0.3 * pressure.back());
      across.push_back(0.1 * pressure.back());
    }
    loads.poisson = 0.28;
    loads.pressure = pressure.data();
    loads.traction_x = along.data();
    loads.traction_y = across.data();
  }
  int32_t largest(const std::vector<double>& depths = {0.0, 2e-3}) {
    return wrc_exact_largest_stresses(&loads, depths.data(), static_cast<uint32_t>(depths.size()),
                                      levels.data(), &stresses, nullptr, nullptr, text, sizeof text);
  }
  int32_t at(const std::vector<double>& points, std::vector<double>& found) {
    found.assign(2 * points.size(), 1.0);
    return wrc_exact_stress(&loads, points.data(), static_cast<uint32_t>(points.size() / 3), found.data(),
                            text, sizeof text);
  }
};

TEST_F(ExactStress, LargestAreThoseOfTheFieldAtTheirPlaces) {
  ASSERT_EQ(largest(), WRC_OK) << text;
  EXPECT_EQ(stresses.body, WRC_BODY_RAIL);
  EXPECT_EQ(levels[0].von_mises.stress, stresses.surface.von_mises.stress);
  EXPECT_EQ(levels[1].shear.depth, 2e-3);
  const wrc_stress_peak& peak = stresses.below.shear;
  std::vector<double> s;
  ASSERT_EQ(at({peak.x, peak.y, peak.depth}, s), WRC_OK) << text;
  const double mises =
      std::sqrt(0.5 * (std::pow(s[0] - s[1], 2) + std::pow(s[1] - s[2], 2) + std::pow(s[2] - s[0], 2)) +
                3.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
  EXPECT_LT(mises, 2.0 * peak.stress);  // Mises lies between Tresca's and sqrt(3)/2 of it
  EXPECT_GT(mises, std::sqrt(3.0) * peak.stress);
  EXPECT_GE(stresses.largest.von_mises.stress, levels[1].von_mises.stress);
}

// The wheel is the rail's mirror image under tractions the other way, which turn the field by half a turn.
TEST_F(ExactStress, WheelHasTheRailsStressesTurnedByHalfATurn) {
  std::vector<double> rail, wheel;
  ASSERT_EQ(at({1e-3, 5e-4, 1e-3}, rail), WRC_OK);
  ASSERT_EQ(largest(), WRC_OK);
  const wrc_stresses of_rail = stresses;
  loads.body = WRC_BODY_WHEEL;
  ASSERT_EQ(at({-1e-3, -5e-4, 1e-3}, wheel), WRC_OK);
  ASSERT_EQ(largest(), WRC_OK);
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(wheel[k], k < 4 ? rail[k] : -rail[k], 1e-5 * 1e9) << k;
  EXPECT_EQ(stresses.body, WRC_BODY_WHEEL);
  EXPECT_NEAR(stresses.largest.von_mises.stress, of_rail.largest.von_mises.stress, 1.0);
  EXPECT_NEAR(stresses.largest.tension.x, -of_rail.largest.tension.x, 1e-9);
  // The wheel is braked by the rail: it is pulled behind, in its own direction of traction.
  EXPECT_GT(stresses.surface.tension.x, 0.0);
}

TEST_F(ExactStress, WithoutTractionsIsThatOfThePressure) {
  for (double& each : along) each = 0.0;
  for (double& each : across) each = 0.0;
  ASSERT_EQ(largest(), WRC_OK);
  const wrc_stresses zeros = stresses;
  loads.traction_x = loads.traction_y = nullptr;
  ASSERT_EQ(largest(), WRC_OK);
  EXPECT_EQ(stresses.largest.von_mises.stress, zeros.largest.von_mises.stress);
  for (double& each : pressure) each = 0.0;
  EXPECT_EQ(largest(), WRC_FLAG_NO_CONTACT);
  EXPECT_EQ(stresses.largest.von_mises.stress, 0.0);
}

TEST_F(ExactStress, RefusesWhatMakesNoSense) {
  std::vector<double> found;
  const auto says = [&](const char* words) {
    EXPECT_NE(std::string(text).find(words), std::string::npos) << text;
  };
  EXPECT_EQ(at({0.0, 0.0, -1e-3}, found), WRC_ERROR_RANGE);
  says("depths are positive");
  EXPECT_EQ(found[0], 0.0);
  EXPECT_EQ(at({5.0, 0.0, 0.0}, found), WRC_ERROR_RANGE);
  says("did you pass mm?");
  EXPECT_EQ(largest({nan_value}), WRC_ERROR_NOT_FINITE);
  EXPECT_EQ(largest({0.0, 3.0}), WRC_ERROR_RANGE);
  EXPECT_EQ(levels[0].shear.stress, 0.0);
  loads.poisson = 0.7;
  EXPECT_EQ(largest(), WRC_ERROR_RANGE);
  says("loads.poisson");
  loads.poisson = 0.3;
  pressure[5] = 1e12;
  EXPECT_EQ(largest(), WRC_ERROR_RANGE);
  says("loads.pressure[5]");
  loads.pressure = nullptr;
  EXPECT_EQ(largest(), WRC_ERROR_NULL);
  loads.pressure = pressure.data();
  loads.body = 2;
  EXPECT_EQ(largest(), WRC_ERROR_UNSUPPORTED);
  EXPECT_EQ(wrc_exact_largest_stresses(nullptr, nullptr, 0, nullptr, &stresses, nullptr, nullptr, nullptr, 0),
            WRC_ERROR_NULL);
  EXPECT_EQ(wrc_exact_stress(&loads, nullptr, 1, nullptr, nullptr, 0), WRC_ERROR_NULL);
}

TEST_F(ExactStress, IsCancelled) {
  Listener listener;
  listener.allowed = 3;
  EXPECT_EQ(wrc_exact_largest_stresses(&loads, nullptr, 0, nullptr, &stresses, Listener::hear, &listener,
                                       text, sizeof text),
            WRC_ERROR_CANCELLED);
}

/// The real-time call, on a double ellipse whose tractions it has just found.
class ContactStresses : public testing::Test {
 protected:
  wrc_config config = test_config();
  wrc_ellipse ellipse = sized<wrc_ellipse>();
  wrc_creepage creepage = wrc_creepage_default();
  wrc_friction friction = wrc_friction_default();
  wrc_stresses stresses = sized<wrc_stresses>();
  std::vector<wrc_stress_peaks> levels = std::vector<wrc_stress_peaks>(3);
  wrc_model* model = nullptr;
  wrc_contact* contact = nullptr;

  void SetUp() override {
    ellipse.a = 6e-3;
    ellipse.b = 4e-3;
    ellipse.psi = 0.2;
    ellipse.normal_force = 80e3;
    creepage.longitudinal = 2e-3;
    creepage.spin = 0.2;
  }
  void TearDown() override {
    wrc_contact_destroy(contact);
    wrc_model_destroy(model);
  }
  void roll() {
    if (model == nullptr) {
      ASSERT_GE(wrc_model_create(&config, nullptr, &model, nullptr, 0), WRC_OK);  // unlike bodies: flagged
      ASSERT_EQ(wrc_contact_create(model, WRC_SIDE_RIGHT, nullptr, &contact, nullptr, 0), WRC_OK);
    }
    ASSERT_EQ(wrc_planar_tangential(contact, &ellipse, &creepage, &friction, nullptr), WRC_OK);
  }
  int32_t find(const std::vector<double>& depths = {0.0, 1e-3, 2e-3}, int32_t body = WRC_BODY_RAIL) {
    return wrc_contact_stresses(contact, WRC_ALL_REGIONS, body, depths.data(),
                                static_cast<uint32_t>(depths.size()), levels.data(), &stresses);
  }
};

TEST_F(ContactStresses, LevelsAndLargestBelongTogether) {
  roll();
  ASSERT_EQ(find(), WRC_OK);
  EXPECT_EQ(stresses.body, WRC_BODY_RAIL);
  EXPECT_EQ(levels[0].von_mises.stress, stresses.surface.von_mises.stress);
  EXPECT_EQ(levels[0].shear.depth, 0.0);
  EXPECT_EQ(levels[2].shear.depth, 2e-3);
  for (const wrc_stress_peak wrc_stress_peaks::*each :
       {&wrc_stress_peaks::von_mises, &wrc_stress_peaks::shear, &wrc_stress_peaks::tension}) {
    EXPECT_GE((stresses.below.*each).stress, std::fmax((levels[1].*each).stress, (levels[2].*each).stress));
    EXPECT_EQ((stresses.largest.*each).stress,
              std::fmax((stresses.below.*each).stress, (stresses.surface.*each).stress));
    EXPECT_LE((stresses.below.*each).depth, 2e-3);
  }
}

TEST_F(ContactStresses, BackwardsIsTheMirrorImage) {
  creepage.lateral = 1e-3;
  roll();
  ASSERT_EQ(find(), WRC_OK);
  const wrc_stresses forward = stresses;
  creepage.longitudinal *= -1.0;
  creepage.spin *= -1.0;
  creepage.speed *= -1.0;
  roll();
  ASSERT_EQ(find(), WRC_OK);
  EXPECT_NEAR(stresses.largest.von_mises.stress, forward.largest.von_mises.stress, 1e-6 * 1e9);
  EXPECT_NEAR(stresses.surface.tension.x, -forward.surface.tension.x, 1e-9);
  EXPECT_NEAR(stresses.surface.tension.y, forward.surface.tension.y, 1e-9);
}

// In the rail, which a braked wheel pulls along, tension is behind the patch; in the wheel before it.
TEST_F(ContactStresses, TensionIsBehindInTheBodyThatIsPulledAlong) {
  creepage.longitudinal = 0.05;
  creepage.spin = 0.0;
  roll();
  ASSERT_EQ(find(), WRC_OK);
  const double rail = stresses.surface.tension.x;
  ASSERT_EQ(find({1e-3}, WRC_BODY_WHEEL), WRC_OK);
  EXPECT_EQ(stresses.body, WRC_BODY_WHEEL);
  EXPECT_LT(rail, -5e-3);
  EXPECT_GT(stresses.surface.tension.x, 5e-3);
}

// Next to no friction: tension at the edge is (1 - 2 nu) / 3 of the pressure, nu of the body's own.
TEST_F(ContactStresses, BodiesHaveTheirOwnPoissonRatio) {
  config.wheel_material.poisson = 0.3;
  config.rail_material.poisson = 0.2;
  ellipse.b = ellipse.a;
  ellipse.psi = 0.0;
  friction.coefficient = 1e-4;
  roll();
  ASSERT_EQ(find(), WRC_OK);
  const double rail = stresses.surface.tension.stress;
  ASSERT_EQ(find({0.0}, WRC_BODY_WHEEL), WRC_OK);
  EXPECT_NEAR(rail / stresses.surface.tension.stress, 0.6 / 0.4, 0.01);
}

TEST_F(ContactStresses, RefusesWhatMakesNoSense) {
  char text[256];
  ASSERT_EQ(wrc_model_create(&config, nullptr, &model, nullptr, 0), WRC_OK);
  ASSERT_EQ(wrc_contact_create(model, WRC_SIDE_RIGHT, nullptr, &contact, nullptr, 0), WRC_OK);
  EXPECT_EQ(find(), WRC_ERROR_SEQUENCE);
  roll();
  EXPECT_EQ(find({0.0, 1.0}), WRC_ERROR_RANGE);
  wrc_contact_last_error(contact, text, sizeof text);
  EXPECT_NE(std::string(text).find("did you pass mm?"), std::string::npos) << text;
  EXPECT_EQ(levels[0].shear.stress, 0.0);
  EXPECT_EQ(find({1e-3, 1e-3}), WRC_ERROR_RANGE);
  EXPECT_EQ(find({nan_value}), WRC_ERROR_NOT_FINITE);
  EXPECT_EQ(find({}), WRC_ERROR_RANGE);
  EXPECT_EQ(find({0.0}, 2), WRC_ERROR_UNSUPPORTED);
  EXPECT_EQ(wrc_contact_stresses(contact, WRC_ALL_REGIONS, WRC_BODY_RAIL, nullptr, 3, nullptr, nullptr),
            WRC_ERROR_NULL);
  EXPECT_EQ(wrc_contact_stresses(nullptr, WRC_ALL_REGIONS, WRC_BODY_RAIL, nullptr, 3, nullptr, &stresses),
            WRC_ERROR_NULL);
  const double depth = 1e-3;
  EXPECT_EQ(wrc_contact_stresses(contact, WRC_ALL_REGIONS, WRC_BODY_RAIL, &depth, 1, nullptr, nullptr),
            WRC_OK);
  EXPECT_EQ(wrc_contact_stresses(contact, WRC_ALL_REGIONS, WRC_BODY_RAIL, &depth, 65, nullptr, nullptr),
            WRC_ERROR_RANGE);
}

}  // namespace
