/// Fit of friction and layers to creep curves through the C interface: curves of known laws come back,
/// spread, parameters that a curve does not determine, refusals. Links the shared library and nothing of its
/// inside.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "creep_adhesion.hpp"
#include "presets.hpp"
#include "reference_contact.hpp"
#include "wrc/wrc_offline.h"

namespace {

std::uint32_t bit(int32_t parameter) { return 1U << static_cast<std::uint32_t>(parameter); }

/// A contact of a planar model, and a curve measured on it.
class Measured : public testing::Test {
 protected:
  ~Measured() override {
    wrc_contact_destroy(contact);
    wrc_model_destroy(model);
  }
  void create(int32_t preset) {
    config = test_config();
    choose_tangential(config, preset);
    ASSERT_EQ(wrc_model_create(&config, nullptr, &model, nullptr, 0), WRC_OK);
    ASSERT_EQ(wrc_contact_create(model, WRC_SIDE_RIGHT, nullptr, &contact, nullptr, 0), WRC_OK);
    curve.ellipse.a = 6e-3;
    curve.ellipse.b = 5e-3;
    curve.ellipse.normal_force = 80e3;
  }
  /// Adhesion of the law at every point; `noise` times a number of zero mean, relative.
  void measure(const wrc_friction& law, int points, double noise = 0.0) {
    std::uint64_t state = 12345;
    slip.clear(), adhesion.clear(), speed.clear(), load.clear();
    for (int i = 0; i < points; ++i) {
      slip.push_back(2e-4 * std::pow(1500.0, static_cast<double>(i) / (points - 1)));
      speed.push_back(i % 3 == 0 ? 3.0 : i % 3 == 1 ? 10.0 : 30.0);
      load.push_back(i % 2 == 0 ? 80e3 : 60e3);
      const double exact =
          creep_adhesion(contact, curve.ellipse, law, slip.back(), speed.back(), load.back());
      ASSERT_TRUE(std::isfinite(exact)) << error();
      double random = -6.0;
      for (int k = 0; k < 12; ++k) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        random += static_cast<double>(state >> 11U) / 9007199254740992.0;
      }
      adhesion.push_back(exact * (1.0 + noise * random));
    }
    curve.count = static_cast<std::uint32_t>(points);
    curve.slip = slip.data();
    curve.adhesion = adhesion.data();
    curve.speed = speed.data();
    curve.load = load.data();
  }
  int32_t run(double* fitted = nullptr) { return wrc_fit_creep_curve(contact, &curve, &fit, fitted); }
  std::string error() const {
    char text[400];
    wrc_contact_last_error(contact, text, sizeof text);
    return text;
  }
  void refused(int32_t status, const char* words) {
    EXPECT_EQ(run(), status) << words;
    ReferenceWheel::expect_words(error(), {words});
    EXPECT_EQ(fit.value[WRC_CREEP_COEFFICIENT], 0.0);
    EXPECT_EQ(fit.struct_size, sizeof fit);
  }

  wrc_config config = test_config();
  wrc_model* model = nullptr;
  wrc_contact* contact = nullptr;
  wrc_creep_curve curve = wrc_creep_curve_default();
  wrc_creep_fit fit = sized<wrc_creep_fit>();
  std::vector<double> slip, adhesion, speed, load;
};

TEST_F(Measured, PolachsLawComesBack) {
  create(preset_polach);
  wrc_friction law = wrc_friction_default();
  ASSERT_EQ(wrc_friction_use(&law, "Polach wet", nullptr, 0), WRC_OK);
  measure(law, 40);
  curve.friction = law;
  curve.friction.coefficient = 0.5;
  curve.friction.kinetic_ratio = 0.6;
  curve.friction.fall_rate = 1.0;
  curve.friction.adhesion_reduction = 0.8;
  curve.friction.slip_reduction = 0.5;
  curve.parameters = bit(WRC_CREEP_COEFFICIENT) | bit(WRC_CREEP_KINETIC_RATIO) | bit(WRC_CREEP_FALL_RATE) |
                     bit(WRC_CREEP_ADHESION_REDUCTION) | bit(WRC_CREEP_SLIP_REDUCTION);
  ASSERT_EQ(run(), WRC_OK) << error();
  EXPECT_NEAR(fit.friction.coefficient, 0.3, 1e-4);
  EXPECT_NEAR(fit.friction.kinetic_ratio, 0.4, 1e-3);
  EXPECT_NEAR(fit.friction.fall_rate, 0.2, 1e-3);
  EXPECT_NEAR(fit.friction.adhesion_reduction, 0.3, 1e-3);
  EXPECT_NEAR(fit.friction.slip_reduction, 0.1, 1e-3);
  EXPECT_LT(fit.scatter, 1e-4);
  EXPECT_EQ(fit.undetermined, 0U);
  EXPECT_EQ(fit.value[WRC_CREEP_COEFFICIENT], fit.friction.coefficient);
}

TEST_F(Measured, ALayerComesBack) {
  create(preset_strip_fastsim);
  wrc_friction law = wrc_friction_default();
  law.coefficient = 0.5;
  law.layer_thickness = 50e-6;
  law.layer_modulus = 177e6;
  law.layer_yield = 150e6;
  measure(law, 24);
  curve.friction = law;
  curve.friction.coefficient = 0.8;
  curve.friction.layer_thickness = 10e-6;
  curve.friction.layer_yield = 400e6;
  curve.parameters = bit(WRC_CREEP_COEFFICIENT) | bit(WRC_CREEP_LAYER_THICKNESS) | bit(WRC_CREEP_LAYER_YIELD);
  std::vector<double> fitted(adhesion.size());
  ASSERT_EQ(run(fitted.data()), WRC_OK) << error();
  EXPECT_NEAR(fit.friction.layer_thickness, 50e-6, 0.5e-6);
  EXPECT_NEAR(fit.friction.layer_yield, 150e6, 1e6);
  for (std::size_t i = 0; i < fitted.size(); ++i) EXPECT_NEAR(fitted[i], adhesion[i], 2e-4);
}

// The deviation of the mean of n numbers that scatter is theirs over sqrt(n): full slip determines mu alone.
TEST_F(Measured, TheSpreadOfFrictionInFullSlipIsThatOfAMean) {
  create(preset_polach);
  wrc_friction law = wrc_friction_default();
  measure(law, 30, 0.05);
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 1; i < 30;
       ++i) {  // the first is where the curve rises, and hardly depends on friction
    slip[i] = 0.5;
    adhesion[i] = 0.29 + 0.005 * (static_cast<double>(i * 7 % 11) - 5.0);
    sum += adhesion[i];
    squares += adhesion[i] * adhesion[i];
  }
  curve.scatter = WRC_SCATTER_ABSOLUTE;
  ASSERT_EQ(run(), WRC_OK) << error();
  const double mean = sum / 29.0, deviation = std::sqrt((squares / 29.0 - mean * mean) / 28.0);
  EXPECT_NEAR(fit.value[0], mean, 2e-3);
  EXPECT_NEAR(fit.deviation[0], deviation, 0.15 * deviation);
  EXPECT_NEAR(fit.covariance[0][0], fit.deviation[0] * fit.deviation[0], 1e-12);
  // adhesion in full slip is linear in friction: the interval is mean +- t deviations, by the profile exactly
  EXPECT_NEAR(fit.high[0], fit.value[0] + 2.045 * fit.deviation[0], 2e-3 * fit.deviation[0]);
  EXPECT_NEAR(fit.low[0], fit.value[0] - 2.045 * fit.deviation[0], 2e-3 * fit.deviation[0]);
}

TEST_F(Measured, WhatACurveDoesNotDetermineIsSaid) {
  // at one sliding speed only the product of mu and its fall counts
  create(preset_polach);
  wrc_friction law = wrc_friction_default();
  measure(law, 30, 0.05);
  for (std::size_t i = 0; i < 30; ++i) speed[i] = 0.02 / slip[i];
  curve.friction.speed_law = WRC_SPEED_LAW_EXPONENTIAL;
  curve.parameters = bit(WRC_CREEP_COEFFICIENT) | bit(WRC_CREEP_FALL_RATE);
  ASSERT_GE(run(), 0) << error();
  EXPECT_EQ(fit.undetermined, curve.parameters);
  EXPECT_TRUE(std::isinf(fit.deviation[WRC_CREEP_FALL_RATE]));
  EXPECT_EQ(fit.high[WRC_CREEP_FALL_RATE], 1000.0);
  EXPECT_EQ(fit.covariance[0][2], 0.0);

  // three factors on one slope
  curve.friction = wrc_friction_default();
  curve.parameters = bit(WRC_CREEP_COEFFICIENT) | bit(WRC_CREEP_SLOPE_REDUCTION) |
                     bit(WRC_CREEP_ADHESION_REDUCTION) | bit(WRC_CREEP_SLIP_REDUCTION);
  ASSERT_GE(run(), 0) << error();
  EXPECT_EQ(fit.undetermined & bit(WRC_CREEP_COEFFICIENT), 0U);
  EXPECT_NE(fit.undetermined & bit(WRC_CREEP_SLOPE_REDUCTION), 0U);
}

TEST_F(Measured, TheSameCurveGivesTheSameBitsAndTheContactStays) {
  create(preset_polach);
  measure(wrc_friction_default(), 20, 0.05);
  std::uint64_t bytes = 0;
  ASSERT_EQ(wrc_contact_state_size(model, &bytes), WRC_OK);
  std::vector<char> before(bytes), after(bytes);
  ASSERT_EQ(wrc_contact_save(contact, before.data(), bytes), WRC_OK);
  ASSERT_EQ(run(), WRC_OK) << error();
  const wrc_creep_fit first = fit;
  ASSERT_EQ(wrc_contact_save(contact, after.data(), bytes), WRC_OK);
  EXPECT_EQ(before, after);
  ASSERT_EQ(run(), WRC_OK);
  EXPECT_EQ(std::memcmp(&first, &fit, sizeof fit), 0);
}

TEST_F(Measured, IsCancelledByItsCaller) {
  create(preset_polach);
  measure(wrc_friction_default(), 20, 0.05);
  curve.friction.coefficient = 0.9;
  static int calls;
  calls = 0;
  curve.progress = [](double fraction, void*) -> int32_t {
    EXPECT_GE(fraction, 0.0);
    return ++calls == 2 ? 1 : 0;
  };
  EXPECT_EQ(run(), WRC_ERROR_CANCELLED);
  EXPECT_EQ(fit.value[0], 0.0);
  curve.progress = nullptr;
  EXPECT_EQ(run(), WRC_OK) << error();
  EXPECT_EQ(wrc_fit_creep_curve(nullptr, &curve, &fit, nullptr), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_fit_creep_curve(contact, nullptr, &fit, nullptr), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_fit_creep_curve(contact, &curve, nullptr, nullptr), WRC_ERROR_NULL);
}

TEST_F(Measured, BadCurvesAreRefusedInASentence) {
  create(preset_strip_fastsim);
  measure(wrc_friction_default(), 20);
  const std::vector<double> slips = slip, adhesions = adhesion;
  const auto change = [&](std::vector<double>& values, std::size_t at, double to, int32_t status,
                          const char* words) {
    const double kept = values[at];
    values[at] = to;
    refused(status, words);
    values[at] = kept;
  };
  curve.count = 3;
  refused(WRC_ERROR_RANGE, "curve.count = 3");
  curve.count = 20;
  curve.parameters = 0;
  refused(WRC_ERROR_RANGE, "curve.parameters = 0");
  curve.parameters = 1;
  change(slip, 4, nan_value, WRC_ERROR_NOT_FINITE, "curve.slip[4]");
  change(slip, 4, -1e-3, WRC_ERROR_RANGE, "curve.slip[4] = -0.001");
  change(speed, 2, -10.0, WRC_ERROR_RANGE, "curve.speed[2] = -10 m/s");
  change(load, 0, 0.0, WRC_ERROR_RANGE, "curve.load[0] = 0 N");
  change(slip, 19, 30.0, WRC_ERROR_RANGE, "per cent");
  change(adhesion, 19, 30.0, WRC_ERROR_RANGE, "per cent");
  for (double& each : slip) each = std::min(1.0, 100.0 * each);
  refused(WRC_ERROR_RANGE, "did you pass per cent?");
  slip = slips;

  // parameters that nothing reads
  curve.parameters = bit(WRC_CREEP_FALL_RATE);
  refused(WRC_ERROR_UNSUPPORTED, "WRC_CREEP_FALL_RATE");
  curve.parameters = bit(WRC_CREEP_SLIP_REDUCTION);
  refused(WRC_ERROR_UNSUPPORTED, "WRC_CREEP_SLIP_REDUCTION");
  curve.parameters = bit(WRC_CREEP_LAYER_HARDENING);
  refused(WRC_ERROR_UNSUPPORTED, "WRC_CREEP_LAYER_HARDENING");
  curve.parameters = bit(WRC_CREEP_LAYER_THICKNESS);
  refused(WRC_ERROR_RANGE, "curve.friction.layer_thickness = 0 m");
  curve.parameters = bit(WRC_CREEP_LAYER_YIELD);
  curve.friction.layer_yield = 1e9;
  refused(WRC_ERROR_RANGE, "the layer never yields");
  curve.friction = wrc_friction_default();
  curve.parameters = 1;
  curve.friction.temperature_law = WRC_TEMPERATURE_LAW_LINEAR;
  refused(WRC_ERROR_UNSUPPORTED, "no temperatures");
  curve.friction = wrc_friction_default();
  curve.ellipse.a = 0.0;
  refused(WRC_ERROR_RANGE, "curve.ellipse.a");
  curve.ellipse.a = 6e-3;
  EXPECT_EQ(run(), WRC_OK) << error();
}

}  // namespace
