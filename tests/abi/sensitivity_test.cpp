/// Sensitivities through the C interface: right, and without a trace in the contact.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "wrc/wrc.h"

namespace {

template <typename Struct>
Struct made(int32_t (*init)(Struct*)) {
  Struct value{};
  value.struct_size = sizeof value;
  EXPECT_EQ(init(&value), WRC_OK);
  return value;
}

/// S1002 on UIC60, 80 kN, the paper's Case 2, in partial slip.
class Sensitivities : public testing::Test {
 protected:
  wrc_pose pose = made<wrc_pose>(wrc_pose_init);
  wrc_load load = made<wrc_load>(wrc_load_init);
  wrc_creepage creepage = made<wrc_creepage>(wrc_creepage_init);
  wrc_friction friction = made<wrc_friction>(wrc_friction_init);
  wrc_patch patch = made<wrc_patch>(wrc_patch_init);
  wrc_forces forces = made<wrc_forces>(wrc_forces_init);
  wrc_model* model = nullptr;
  wrc_contact* contact = nullptr;

  void SetUp() override {
    wrc_profile wheel = made<wrc_profile>(wrc_profile_init), rail = made<wrc_profile>(wrc_profile_init);
    wrc_config config = made<wrc_config>(wrc_config_init);
    wheel.kind = WRC_PROFILE_S1002;
    rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
    config.wheel = &wheel;
    config.rail = &rail;
    load.normal_force = 80e3;
    creepage.longitudinal = -0.49e-3;
    creepage.lateral = -0.22e-3;
    creepage.spin = 0.29;
    friction.coefficient = 0.35;
    ASSERT_EQ(wrc_model_create(&config, nullptr, &model), WRC_OK);
    ASSERT_EQ(wrc_contact_create(model, nullptr, &contact), WRC_OK);
  }
  void TearDown() override {
    wrc_contact_destroy(contact);
    wrc_model_destroy(model);
  }

  int32_t step() {
    const wrc_input input = {sizeof input, 0, &pose, nullptr, &load, &creepage, &friction};
    wrc_output output = {sizeof output, 0, nullptr, &patch, &forces, nullptr};
    return wrc_step(contact, &input, &output);
  }
  std::string error() const {
    char text[256];
    EXPECT_EQ(wrc_last_error(contact, text, sizeof text), WRC_OK);
    return text;
  }
  /// Everything the contact holds.
  std::vector<char> state() const {
    uint64_t bytes = 0, alignment = 0;
    EXPECT_EQ(wrc_contact_size(model, &bytes, &alignment), WRC_OK);
    std::vector<char> copy(bytes);
    EXPECT_EQ(wrc_contact_save(contact, copy.data(), bytes), WRC_OK);
    return copy;
  }
};

TEST_F(Sensitivities, SensitivitiesAreThoseOfTheTangentialStage) {
  wrc_sensitivity s = made<wrc_sensitivity>(wrc_sensitivity_init);
  EXPECT_EQ(wrc_sensitivities(contact, &s), WRC_ERROR_SEQUENCE);
  ASSERT_EQ(step(), WRC_OK) << error();
  const std::vector<char> before = state();
  ASSERT_EQ(wrc_sensitivities(contact, &s), WRC_OK) << error();
  EXPECT_EQ(before, state());

  double* const inputs[] = {&creepage.longitudinal, &creepage.lateral, &creepage.spin, &friction.coefficient};
  const int columns[] = {0, 1, 2, 4};
  for (int k = 0; k < 4; ++k) {
    const double value = *inputs[k], step = 1e-5 * std::fabs(value);
    wrc_forces ends[2] = {forces, forces};
    for (int end = 0; end < 2; ++end) {
      *inputs[k] = value + (end == 0 ? -step : step);
      ASSERT_EQ(wrc_tangential(contact, nullptr, &creepage, &friction, &ends[end]), WRC_OK);
    }
    *inputs[k] = value;
    const double scale = std::fabs(forces.fx) / std::fabs(value);
    EXPECT_NEAR(s.forces[0][columns[k]], (ends[1].fx - ends[0].fx) / (2.0 * step), 1e-5 * scale) << k;
    EXPECT_NEAR(s.forces[1][columns[k]], (ends[1].fy - ends[0].fy) / (2.0 * step), 1e-5 * scale) << k;
    EXPECT_NEAR(s.forces[2][columns[k]], (ends[1].mz - ends[0].mz) / (2.0 * step), 1e-7 * scale) << k;
  }
  EXPECT_NEAR(s.forces[0][3] * forces.fn, s.forces[0][4] * friction.coefficient, 1e-9 * std::fabs(forces.fx));
}

TEST_F(Sensitivities, StepSensitivitiesAreThoseOfTheWholeStep) {
  wrc_step_sensitivity s = made<wrc_step_sensitivity>(wrc_step_sensitivity_init);
  EXPECT_EQ(wrc_step_sensitivities(contact, &s), WRC_ERROR_SEQUENCE);
  ASSERT_EQ(step(), WRC_OK) << error();
  const std::vector<char> before = state();
  ASSERT_EQ(wrc_step_sensitivities(contact, &s), WRC_OK) << error();
  EXPECT_EQ(before, state());
  EXPECT_NEAR(s.by_load[3] * patch.stiffness, 1.0, 0.01);  // the compliance, found another way

  const auto differences = [&](double& input, double width) {
    const double middle = input;
    double ends[2][4];
    for (int end = 0; end < 2; ++end) {
      input = middle + (end == 0 ? -width : width);
      EXPECT_EQ(step(), WRC_OK);
      const double values[4] = {forces.fx, forces.fy, forces.mz, patch.approach};
      for (int r = 0; r < 4; ++r) ends[end][r] = values[r];
    }
    input = middle;
    std::vector<double> d;
    for (int r = 0; r < 4; ++r) d.push_back((ends[1][r] - ends[0][r]) / (2.0 * width));
    return d;
  };
  const std::vector<double> by_load = differences(load.normal_force, 800.0);  // the documented steps
  const std::vector<double> by_lateral = differences(pose.lateral, 1e-4);
  for (int r = 0; r < 4; ++r) {
    EXPECT_NEAR(s.by_load[r], by_load[r], 1e-6 * std::fabs(by_load[r])) << r;
    EXPECT_NEAR(s.by_lateral[r], by_lateral[r], 1e-6 * std::fabs(by_lateral[r])) << r;
  }
}

TEST_F(Sensitivities, OfAPatchOfTheCallerAreOfTheTangentialStageOnly) {
  wrc_patch own = made<wrc_patch>(wrc_patch_init);
  own.a = 5e-3;
  own.b = 4e-3;
  own.normal_force = 80e3;
  ASSERT_EQ(wrc_tangential(contact, &own, &creepage, &friction, &forces), WRC_OK) << error();
  wrc_sensitivity s = made<wrc_sensitivity>(wrc_sensitivity_init);
  EXPECT_EQ(wrc_sensitivities(contact, &s), WRC_OK) << error();
  EXPECT_LT(s.forces[0][0], 0.0);
  wrc_step_sensitivity of_step = made<wrc_step_sensitivity>(wrc_step_sensitivity_init);
  EXPECT_EQ(wrc_step_sensitivities(contact, &of_step), WRC_ERROR_SEQUENCE);
  EXPECT_NE(error().find("wrc_normal"), std::string::npos) << error();
}

TEST_F(Sensitivities, WithoutContactAreZeroAndFlagged) {
  load.prescribed = WRC_PRESCRIBE_APPROACH;
  load.approach = -1e-3;
  EXPECT_EQ(step(), WRC_FLAG_NO_CONTACT);
  wrc_sensitivity s = made<wrc_sensitivity>(wrc_sensitivity_init);
  wrc_step_sensitivity of_step = made<wrc_step_sensitivity>(wrc_step_sensitivity_init);
  EXPECT_EQ(wrc_sensitivities(contact, &s), WRC_FLAG_NO_CONTACT);
  EXPECT_EQ(wrc_step_sensitivities(contact, &of_step), WRC_FLAG_NO_CONTACT);
  EXPECT_EQ(s.forces[0][0], 0.0);
  EXPECT_EQ(of_step.by_load[3], 0.0);
  EXPECT_EQ(wrc_sensitivities(nullptr, &s), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_sensitivities(contact, nullptr), WRC_FLAG_NO_CONTACT);
}

}  // namespace
