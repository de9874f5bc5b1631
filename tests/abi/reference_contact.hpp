/// S1002 on the benchmark UIC60 under 80 kN in the source paper's Case 2: a contact that works, for tests
/// that break one thing at a time.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "not_finite.hpp"
#include "test_config.hpp"
#include "wrc/wrc_planar.h"

/// The wheel itself, made when it first steps: what is changed in its configuration before counts.
class ReferenceWheel {
 public:
  wrc_config config = test_config();
  wrc_profile &wheel = config.wheel, &rail = config.rail;
  wrc_planar_input input = wrc_planar_input_default();
  wrc_planar_pose& pose = input.pose;
  wrc_planar_load& load = input.load;
  wrc_creepage& creepage = input.creepage;
  wrc_friction& friction = input.friction;
  wrc_planar_output output = sized<wrc_planar_output>();
  wrc_planar_point& point = output.point;
  wrc_planar_normal_solution& normal = output.normal;
  wrc_planar_forces& forces = output.forces;
  wrc_damage& damage = output.damage;
  int32_t side = WRC_SIDE_RIGHT;
  wrc_model* model = nullptr;
  wrc_contact* contact = nullptr;

  ReferenceWheel() {
    wheel.kind = WRC_PROFILE_S1002;
    rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
    load.normal_force = 80e3;
    creepage.longitudinal = -0.49e-3;
    creepage.lateral = -0.22e-3;
    creepage.spin = 0.29;
    friction.coefficient = 0.35;
  }
  ~ReferenceWheel() {
    wrc_contact_destroy(contact);
    wrc_model_destroy(model);
  }
  ReferenceWheel(const ReferenceWheel&) = delete;
  ReferenceWheel& operator=(const ReferenceWheel&) = delete;

  /// From the present configuration; in place of the former one, if there is one.
  void create() {
    wrc_contact_destroy(contact);
    wrc_model_destroy(model);
    ASSERT_EQ(wrc_model_create(&config, nullptr, &model, nullptr, 0), WRC_OK);
    ASSERT_EQ(wrc_contact_create(model, side, nullptr, &contact, nullptr, 0), WRC_OK);
  }
  int32_t step() {
    if (model == nullptr) create();
    return wrc_planar_step(contact, &input, &output);
  }
  std::string error() const {
    char text[256];
    EXPECT_EQ(wrc_contact_last_error(contact, text, sizeof text), WRC_OK);
    return text;
  }
  /// The sentence holds all these words.
  static void expect_words(const std::string& sentence, const std::vector<std::string>& words) {
    for (const std::string& word : words)
      EXPECT_NE(sentence.find(word), std::string::npos) << word << " in: " << sentence;
  }
  /// The step fails with this status and these words, and leaves zeros.
  void expect_refused(int32_t status, const std::vector<std::string>& words) {
    EXPECT_EQ(step(), status);
    expect_words(error(), words);
    expect_zeros();
  }
  void expect_zeros() const {
    EXPECT_EQ(point.rolling_radius, 0.0);
    EXPECT_EQ(forces.fx, 0.0);
    EXPECT_EQ(forces.fn, 0.0);
    EXPECT_EQ(normal.area, 0.0);
    EXPECT_EQ(damage.power, 0.0);
    EXPECT_EQ(output.struct_size, sizeof output);
  }
  void expect_works() {
    ASSERT_EQ(step(), WRC_OK) << error();
    EXPECT_GT(forces.power, 0.0);
    EXPECT_NEAR(forces.fn, 80e3, 1.0);
    EXPECT_EQ(error(), "");
  }
  /// The configuration is refused, with these words.
  void expect_config_refused(int32_t status, const std::vector<std::string>& words) {
    char text[256];
    EXPECT_EQ(wrc_config_check(&config, text, sizeof text), status) << text;
    expect_words(text, words);
    wrc_model* none = model;
    EXPECT_EQ(wrc_model_create(&config, nullptr, &none, nullptr, 0), status);
    EXPECT_EQ(none, nullptr);
  }
};

/// The wheel as a fixture.
class ReferenceContact : public testing::Test, protected ReferenceWheel {
 protected:
  void SetUp() override { create(); }
};
