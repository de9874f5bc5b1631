/// S1002 on the benchmark UIC60 as one call of a multibody host sees them, for tests that change one thing at
/// a time.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "test_config.hpp"
#include "wrc/wrc.h"

/// The bodies of a wheel on a rail, and one call on them. `config` counts when the model is created.
class PlacedWheel {
 protected:
  wrc_config config = test_config();
  wrc_wheel_input input = wrc_wheel_input_default();
  wrc_wheel_state& wheel = input.wheel;
  wrc_rail_state& rail = input.rail;
  wrc_friction& friction = input.friction;
  wrc_wrench wrench = sized<wrc_wrench>();
  wrc_model* model = nullptr;
  wrc_contact* contact = nullptr;
  int32_t side = WRC_SIDE_RIGHT;  ///< of that

  PlacedWheel() {
    config.wheel.kind = WRC_PROFILE_S1002;
    config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
    wheel.velocity[0] = 20.0;
    wheel.angular_axes = WRC_AXES_TRACK;
    wheel.angular_velocity[1] = -20.0 / 0.46;
  }
  ~PlacedWheel() {
    wrc_contact_destroy(contact);
    wrc_model_destroy(model);
  }
  PlacedWheel(const PlacedWheel&) = delete;
  PlacedWheel& operator=(const PlacedWheel&) = delete;

  /// As the reference results have them.
  void take_reference_bodies() {
    config.wheel_material.shear_modulus = config.rail_material.shear_modulus = 82e9;
    config.wheel_material.poisson = config.rail_material.poisson = 0.28;
    config.track.placement = WRC_PLACEMENT_ORIGIN;
    config.track.rail_origin = 0.7605325577;
  }
  /// At 20 m/s, shifted, rolled, yawed and slipping; the rail displaced and moving.
  void roll_with_a_little_of_everything() {
    wheel.y = 1e-3;
    wheel.z = 1.2e-3;
    wheel.roll = -0.7e-3;
    wheel.yaw = 2e-3;
    const double velocity[3] = {20.0, 0.03, 0.0}, turning[3] = {0.01, -20.0 / 0.46 * 1.0015, 0.02};
    std::copy_n(velocity, 3, wheel.velocity);
    std::copy_n(turning, 3, wheel.angular_velocity);
    rail.y = 0.4e-3;
    rail.z = 0.38e-3;
    rail.roll = 2e-3;
    rail.y_velocity = 0.01;
  }
  /// From the present configuration, with a contact of that side.
  void create(int32_t which = WRC_SIDE_RIGHT) {
    wrc_contact_destroy(contact);
    wrc_model_destroy(model);
    contact = nullptr;
    model = nullptr;
    ASSERT_EQ(wrc_model_create(&config, nullptr, &model, nullptr, 0), WRC_OK);
    take(which);
  }
  /// From here on the wheel of that side.
  void take(int32_t which) {
    wrc_contact_destroy(contact);
    contact = nullptr;
    side = which;
    ASSERT_EQ(wrc_contact_create(model, side, nullptr, &contact, nullptr, 0), WRC_OK);
  }
  int32_t step() { return wrc_contact_wrench(contact, &input, &wrench); }
  std::string error() const {
    char text[256];
    EXPECT_EQ(wrc_contact_last_error(contact, text, sizeof text), WRC_OK);
    return text;
  }
};
