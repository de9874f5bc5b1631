/// Steps, single stages, refused input, fields and messages with inputs that vary from call to call: what the
/// tests of real-time behaviour run.
#pragma once

#include <cmath>

#include "made.hpp"
#include "wrc/wrc.h"

struct VariedRun {
  wrc_pose pose = made<wrc_pose>(wrc_pose_init);
  wrc_load load = made<wrc_load>(wrc_load_init);
  wrc_creepage creepage = made<wrc_creepage>(wrc_creepage_init);
  wrc_friction friction = made<wrc_friction>(wrc_friction_init);
  wrc_motion motion = made<wrc_motion>(wrc_motion_init);
  wrc_wear_laws laws = made<wrc_wear_laws>(wrc_wear_laws_init);
  wrc_contact_point point = made<wrc_contact_point>(wrc_contact_point_init);
  wrc_patch patch = made<wrc_patch>(wrc_patch_init);
  wrc_forces forces = made<wrc_forces>(wrc_forces_init);
  wrc_damage damage = made<wrc_damage>(wrc_damage_init);
  wrc_wear wear = made<wrc_wear>(wrc_wear_init);
  wrc_creepage rigid = made<wrc_creepage>(wrc_creepage_init);
  wrc_sensitivity sensitivity = made<wrc_sensitivity>(wrc_sensitivity_init);
  wrc_step_sensitivity step_sensitivity = made<wrc_step_sensitivity>(wrc_step_sensitivity_init);
  wrc_view view = made<wrc_view>(wrc_view_init);
  bool fields = true;  ///< the tangential method gives tractions
  int failures = 0;    ///< calls that failed and should not have, or the other way round

  /// In turn: constant, falling, and falling friction with zones.
  void vary_friction(int i) {
    static constexpr double zone_y[] = {-4e-3, 0.0, 0.0, 5e-3}, zone_coefficient[] = {0.1, 0.3, 0.0, 0.4};
    friction.kind = i % 3;
    friction.slope_fall = 0.6;
    friction.zones = i % 3 == 2 ? 4 : 0;
    friction.zone_y = zone_y;
    friction.zone_coefficient = zone_coefficient;
    friction.zone_frame = i % 2;
  }

  void vary(double t, int i) {
    vary_friction(i);
    pose.lateral = 3e-3 * std::sin(7.0 * t);
    pose.yaw = 5e-3 * std::sin(3.0 * t);
    load.prescribed = i % 4 == 3 ? WRC_PRESCRIBE_APPROACH : WRC_PRESCRIBE_LOAD;
    load.normal_force = 80e3 + 40e3 * std::sin(11.0 * t);
    load.approach = 60e-6 + 61e-6 * std::sin(5.0 * t);  // now and then apart
    load.damping = 0.2 * (i % 3);
    load.approach_velocity = 4.0 * std::sin(23.0 * t);  // now and then damped to nothing
    motion.speed = 20.0;
    motion.pitch_rate = -43.5;
    motion.vertical_velocity = load.approach_velocity;
    creepage.longitudinal = 2e-3 * std::sin(13.0 * t);
    creepage.lateral = 2e-3 * std::cos(17.0 * t);
    creepage.spin = 0.6 * std::sin(19.0 * t);
  }

  void step(wrc_contact* contact) {
    const wrc_input input = {sizeof input, 0, &pose, nullptr, &load, &creepage, &friction};
    wrc_output output = {sizeof output, 0, &point, &patch, &forces, &damage};
    failures += wrc_step(contact, &input, &output) < 0;
  }

  void stages(const wrc_model* model, wrc_contact* contact) {
    failures += wrc_geometry(contact, &pose, &point) < 0;
    failures += wrc_creepages(contact, &motion, &rigid) < 0;
    failures += wrc_normal(contact, nullptr, &load, &patch) < 0;
    failures += wrc_regularise(contact, nullptr, &patch) < 0;
    failures += wrc_tangential(contact, nullptr, &creepage, &friction, &forces) < 0;
    failures += wrc_damage_numbers(contact, &damage) < 0;
    failures += wrc_sensitivities(contact, &sensitivity) < 0;
    failures += wrc_step_sensitivities(contact, &step_sensitivity) < 0;
    if (fields) failures += wrc_wear_numbers(contact, &laws, &wear) < 0;
    failures += wrc_model_profile(model, WRC_BODY_WHEEL, &view, nullptr, nullptr) < 0;
    if (forces.fn > 0.0) {
      failures += wrc_field(contact, 0, fields ? WRC_FIELD_TRACTION_X : WRC_FIELD_STRIP_PEAK, &view) < 0;
      failures += wrc_contact_patch(contact, 0, &patch, &forces) < 0;
    }
    wrc_creepage wrong = creepage;
    wrong.spin = NAN;  // an error is reported by the same rules
    char text[256];
    failures += wrc_tangential(contact, nullptr, &wrong, &friction, &forces) != WRC_ERROR_NOT_FINITE;
    failures += wrc_last_error(contact, text, sizeof text) < 0;
  }
};
