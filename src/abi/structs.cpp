#include "abi/structs.hpp"

#include "damage/wear.hpp"

namespace wrc::abi {

WRC_EMPTY_BY_DEFAULT(wrc_profile)
WRC_EMPTY_BY_DEFAULT(wrc_pose)
WRC_EMPTY_BY_DEFAULT(wrc_contact_point)
WRC_EMPTY_BY_DEFAULT(wrc_gap)
WRC_EMPTY_BY_DEFAULT(wrc_load)
WRC_EMPTY_BY_DEFAULT(wrc_patch)
WRC_EMPTY_BY_DEFAULT(wrc_strips)
WRC_EMPTY_BY_DEFAULT(wrc_forces)
WRC_EMPTY_BY_DEFAULT(wrc_motion)
WRC_EMPTY_BY_DEFAULT(wrc_damage)
WRC_EMPTY_BY_DEFAULT(wrc_wear)
WRC_EMPTY_BY_DEFAULT(wrc_coefficients)
WRC_EMPTY_BY_DEFAULT(wrc_sensitivity)
WRC_EMPTY_BY_DEFAULT(wrc_step_sensitivity)
WRC_EMPTY_BY_DEFAULT(wrc_input)
WRC_EMPTY_BY_DEFAULT(wrc_output)
WRC_EMPTY_BY_DEFAULT(wrc_view)
WRC_EMPTY_BY_DEFAULT(wrc_allocator)
WRC_EMPTY_BY_DEFAULT(wrc_wheel_state)
WRC_EMPTY_BY_DEFAULT(wrc_rail_state)
WRC_EMPTY_BY_DEFAULT(wrc_wheel_input)
WRC_EMPTY_BY_DEFAULT(wrc_wrench)
WRC_EMPTY_BY_DEFAULT(wrc_region)

template <>
wrc_creepage defaults<wrc_creepage>() {
  wrc_creepage value = empty<wrc_creepage>();
  value.speed = 1.0;
  return value;
}

template <>
wrc_friction defaults<wrc_friction>() {
  wrc_friction value = empty<wrc_friction>();
  value.coefficient = 0.3;
  value.kinetic_ratio = 0.4;
  value.fall_rate = 0.6;
  value.half_speed = 1.0;
  value.slope_reduction = 1.0;
  value.slope_limit = 0.02;
  return value;
}

template <>
wrc_wear_laws defaults<wrc_wear_laws>() {
  const TGammaWearLaw t_gamma;
  const SheffieldWearLaw sheffield;
  const ArchardWearLaw archard;
  wrc_wear_laws value = empty<wrc_wear_laws>();
  value.t_gamma_mild_end = t_gamma.t1;
  value.t_gamma_severe_start = t_gamma.t2;
  value.t_gamma_mild_slope = t_gamma.slope_mild;
  value.t_gamma_plateau = t_gamma.plateau;
  value.t_gamma_severe_slope = t_gamma.slope_severe;
  value.t_gamma_severe_offset = t_gamma.offset_severe;
  value.sheffield_mild_end = sheffield.x1;
  value.sheffield_severe_end = sheffield.x2;
  value.sheffield_mild_slope = sheffield.slope_mild;
  value.sheffield_catastrophic_slope = sheffield.slope_catastrophic;
  value.density = sheffield.density;
  value.hardness = archard.hardness;
  value.archard_slow = archard.mild_low_speed;
  value.archard_severe = archard.severe;
  value.archard_fast = archard.mild_high_speed;
  value.archard_seizure = archard.seizure;
  value.archard_severe_start = archard.v1;
  value.archard_severe_end = archard.v2;
  value.seizure_pressure = archard.seizure_pressure;
  return value;
}

template <>
wrc_config defaults<wrc_config>() {
  wrc_config value = empty<wrc_config>();
  value.side = WRC_SIDE_RIGHT;
  value.normal_method = WRC_NORMAL_STRIP_HALFSPACE;
  value.regularisation = WRC_REGULARISE_KEEP_WIDTH;
  value.tangential_method = WRC_TANGENTIAL_STRIP_FASTSIM;
  value.traction_bound = WRC_BOUND_PARABOLIC;
  value.strips = 60;
  value.cells = 32;
  value.gap_rows = 256;
  value.max_patches = 4;
  value.warm_start = 0;
  value.shear_modulus = 80e9;
  value.poisson = 0.25;
  value.load_tolerance = 1e-10;
  value.gap_limit = 1e-3;
  value.shear_yield = 250e6;
  value.wheel_radius = 0.46;
  value.flange_back_distance = 1.360;
  value.track_gauge = 1.435;
  value.gauge_depth = 0.014;
  value.rail_inclination = 0.0;
  return value;
}

}  // namespace wrc::abi

using wrc::abi::init;

extern "C" {
int32_t wrc_profile_init(wrc_profile* profile) { return init(profile); }
int32_t wrc_config_init(wrc_config* config) { return init(config); }
int32_t wrc_pose_init(wrc_pose* pose) { return init(pose); }
int32_t wrc_contact_point_init(wrc_contact_point* point) { return init(point); }
int32_t wrc_gap_init(wrc_gap* gap) { return init(gap); }
int32_t wrc_load_init(wrc_load* load) { return init(load); }
int32_t wrc_creepage_init(wrc_creepage* creepage) { return init(creepage); }
int32_t wrc_friction_init(wrc_friction* friction) { return init(friction); }
int32_t wrc_patch_init(wrc_patch* patch) { return init(patch); }
int32_t wrc_strips_init(wrc_strips* strips) { return init(strips); }
int32_t wrc_forces_init(wrc_forces* forces) { return init(forces); }
int32_t wrc_motion_init(wrc_motion* motion) { return init(motion); }
int32_t wrc_damage_init(wrc_damage* damage) { return init(damage); }
int32_t wrc_wear_laws_init(wrc_wear_laws* laws) { return init(laws); }
int32_t wrc_wear_init(wrc_wear* wear) { return init(wear); }
int32_t wrc_coefficients_init(wrc_coefficients* coefficients) { return init(coefficients); }
int32_t wrc_sensitivity_init(wrc_sensitivity* sensitivity) { return init(sensitivity); }
int32_t wrc_step_sensitivity_init(wrc_step_sensitivity* sensitivity) { return init(sensitivity); }
int32_t wrc_input_init(wrc_input* input) { return init(input); }
int32_t wrc_output_init(wrc_output* output) { return init(output); }
int32_t wrc_view_init(wrc_view* view) { return init(view); }
int32_t wrc_allocator_init(wrc_allocator* allocator) { return init(allocator); }
int32_t wrc_wheel_state_init(wrc_wheel_state* wheel) { return init(wheel); }
int32_t wrc_rail_state_init(wrc_rail_state* rail) { return init(rail); }
int32_t wrc_wheel_input_init(wrc_wheel_input* input) { return init(input); }
int32_t wrc_wrench_init(wrc_wrench* wrench) { return init(wrench); }
int32_t wrc_region_init(wrc_region* region) { return init(region); }
}
