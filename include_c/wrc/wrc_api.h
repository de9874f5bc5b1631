/** @file wrc_api.h
 * Every function of wrc.h and wrc_offline.h as a table, so that one dlsym("wrc_get_api") suffices.
 * Written by tools/interface/describe.py from the headers in include_c/wrc: do not edit.
 */
#ifndef WRC_API_H
#define WRC_API_H

#include "wrc_offline.h"

/** The functions, each under its name without wrc_. struct_size grows with the library: a table at least as large as the
 * sizeof(wrc_api) you compiled with has every member you know. */
struct wrc_api {
  uint32_t struct_size; /**< sizeof this struct */
  uint32_t abi_version; /**< WRC_ABI_VERSION of the library */
  uint32_t (*version)(void); /**< wrc_version() */
  const char* (*status_name)(int32_t); /**< wrc_status_name() */
  const char* (*status_text)(int32_t); /**< wrc_status_text() */
  int32_t (*profile_init)(wrc_profile*); /**< wrc_profile_init() */
  int32_t (*config_init)(wrc_config*); /**< wrc_config_init() */
  int32_t (*pose_init)(wrc_planar_pose*); /**< wrc_planar_pose_init() */
  int32_t (*gap_init)(wrc_planar_gap*); /**< wrc_planar_gap_init() */
  int32_t (*load_init)(wrc_planar_load*); /**< wrc_planar_load_init() */
  int32_t (*creepage_init)(wrc_creepage*); /**< wrc_creepage_init() */
  int32_t (*friction_init)(wrc_friction*); /**< wrc_friction_init() */
  int32_t (*patch_init)(wrc_patch*); /**< wrc_patch_init() */
  int32_t (*strips_init)(wrc_planar_strips*); /**< wrc_planar_strips_init() */
  int32_t (*motion_init)(wrc_planar_motion*); /**< wrc_planar_motion_init() */
  int32_t (*input_init)(wrc_planar_input*); /**< wrc_planar_input_init() */
  int32_t (*output_init)(wrc_planar_output*); /**< wrc_planar_output_init() */
  int32_t (*allocator_init)(wrc_allocator*); /**< wrc_allocator_init() */
  int32_t (*config_check)(const wrc_config*, char*, uint64_t); /**< wrc_config_check() */
  int32_t (*model_size)(const wrc_config*, uint64_t*, uint64_t*); /**< wrc_model_size() */
  int32_t (*model_init)(const wrc_config*, void*, uint64_t, wrc_model**); /**< wrc_model_init() */
  int32_t (*model_create)(const wrc_config*, const wrc_allocator*, wrc_model**); /**< wrc_model_create() */
  void (*model_destroy)(wrc_model*); /**< wrc_model_destroy() */
  int32_t (*contact_size)(const wrc_model*, uint64_t*, uint64_t*); /**< wrc_contact_size() */
  int32_t (*contact_init)(const wrc_model*, int32_t, void*, uint64_t, wrc_contact**); /**< wrc_contact_init() */
  int32_t (*contact_create)(const wrc_model*, int32_t, const wrc_allocator*, wrc_contact**);
    /**< wrc_contact_create() */
  void (*contact_destroy)(wrc_contact*); /**< wrc_contact_destroy() */
  int32_t (*contact_save)(const wrc_contact*, void*, uint64_t); /**< wrc_contact_save() */
  int32_t (*contact_restore)(wrc_contact*, const void*, uint64_t); /**< wrc_contact_restore() */
  int32_t (*contact_patch)(const wrc_contact*, int32_t, wrc_patch*); /**< wrc_contact_patch() */
  int32_t (*linear_coefficients)(double, double, double, wrc_coefficients*); /**< wrc_linear_coefficients() */
  int32_t (*shakedown_limit)(double, double*); /**< wrc_shakedown_limit() */
  int32_t (*wear_laws_init)(wrc_wear_laws*); /**< wrc_wear_laws_init() */
  int32_t (*model_profile)(const wrc_model*, int32_t, int32_t, wrc_view*, wrc_view*, double*);
    /**< wrc_model_profile() */
  int32_t (*contact_state_size)(const wrc_model*, uint64_t*); /**< wrc_contact_state_size() */
  int32_t (*wheel_state_init)(wrc_wheel_state*); /**< wrc_wheel_state_init() */
  int32_t (*rail_state_init)(wrc_rail_state*); /**< wrc_rail_state_init() */
  int32_t (*wheel_input_init)(wrc_wheel_input*); /**< wrc_wheel_input_init() */
  int32_t (*wrench_init)(wrc_wrench*); /**< wrc_wrench_init() */
  int32_t (*region_init)(wrc_region*); /**< wrc_region_init() */
  int32_t (*contact_last_error)(const wrc_contact*, char*, uint64_t); /**< wrc_contact_last_error() */
  int32_t (*contact_geometry)(wrc_contact*, const wrc_planar_pose*, wrc_planar_point*); /**< wrc_planar_geometry() */
  int32_t (*contact_creepages)(wrc_contact*, const wrc_planar_motion*, wrc_creepage*); /**< wrc_planar_creepages() */
  int32_t (*contact_normal)(wrc_contact*, const wrc_planar_gap*, const wrc_planar_load*, wrc_planar_normal_solution*);
    /**< wrc_planar_normal() */
  int32_t (*contact_regularise)(wrc_contact*, const wrc_planar_strips*, wrc_planar_normal_solution*); /**< wrc_planar_regularise() */
  int32_t (*contact_tangential)(wrc_contact*, const wrc_ellipse*, const wrc_creepage*, const wrc_friction*, wrc_planar_forces*);
    /**< wrc_planar_tangential() */
  int32_t (*contact_damage)(wrc_contact*, wrc_damage*); /**< wrc_contact_damage() */
  int32_t (*contact_wear)(wrc_contact*, const wrc_wear_laws*, wrc_wear*); /**< wrc_contact_wear() */
  int32_t (*contact_sensitivities)(wrc_contact*, wrc_planar_derivatives*); /**< wrc_planar_tangential_derivatives() */
  int32_t (*contact_step_sensitivities)(wrc_contact*, wrc_step_sensitivity*); /**< wrc_contact_step_sensitivities() */
  int32_t (*contact_step)(wrc_contact*, const wrc_planar_input*, wrc_planar_output*); /**< wrc_planar_step() */
  int32_t (*contact_step_batch)(wrc_contact* const*, uint32_t, const wrc_planar_input*, uint64_t, wrc_planar_output*, uint64_t, int32_t*);
    /**< wrc_contact_step_batch() */
  int32_t (*contact_step_flat)(wrc_contact*, const double*, double*); /**< wrc_contact_step_flat() */
  int32_t (*contact_field)(const wrc_contact*, int32_t, int32_t, wrc_view*); /**< wrc_contact_field() */
  int32_t (*contact_wrench)(wrc_contact*, const wrc_wheel_input*, wrc_wrench*); /**< wrc_contact_wrench() */
  int32_t (*contact_region)(const wrc_contact*, int32_t, wrc_region*); /**< wrc_contact_region() */
  int32_t (*contact_wrench_batch)(wrc_contact* const*, uint32_t, const wrc_wheel_input*, uint64_t, wrc_wrench*, uint64_t, int32_t*);
    /**< wrc_contact_wrench_batch() */
  int32_t (*contact_wrench_flat)(wrc_contact*, const double*, double*); /**< wrc_contact_wrench_flat() */
  int32_t (*grid_init)(wrc_grid*); /**< wrc_grid_init() */
  int32_t (*materials_init)(wrc_materials*); /**< wrc_materials_init() */
  int32_t (*exact_normal_problem_init)(wrc_exact_normal_problem*); /**< wrc_exact_normal_problem_init() */
  int32_t (*exact_normal_solution_init)(wrc_exact_normal_solution*); /**< wrc_exact_normal_solution_init() */
  int32_t (*exact_rolling_problem_init)(wrc_exact_rolling_problem*); /**< wrc_exact_rolling_problem_init() */
  int32_t (*exact_rolling_solution_init)(wrc_exact_rolling_solution*); /**< wrc_exact_rolling_solution_init() */
  int32_t (*exact_wrench_options_init)(wrc_exact_wrench_options*); /**< wrc_exact_wrench_options_init() */
  int32_t (*exact_check_result_init)(wrc_exact_check_result*); /**< wrc_exact_check_result_init() */
  int32_t (*exact_gap)(wrc_contact*, const wrc_grid*, double*); /**< wrc_exact_gap() */
  int32_t (*exact_normal)(const wrc_exact_normal_problem*, wrc_exact_normal_solution*, char*, uint64_t);
    /**< wrc_exact_normal() */
  int32_t (*exact_rolling)(const wrc_exact_rolling_problem*, wrc_exact_rolling_solution*, char*, uint64_t);
    /**< wrc_exact_rolling() */
  int32_t (*exact_check)(wrc_contact*, uint32_t, uint32_t, wrc_progress, void*, wrc_exact_check_result*);
    /**< wrc_exact_check() */
  int32_t (*exact_wrench)(wrc_contact*, const wrc_wheel_input*, const wrc_exact_wrench_options*, wrc_wrench*);
    /**< wrc_exact_wrench() */
  const char* (*version_text)(uint32_t); /**< wrc_version_text() */
  const char* (*build_info)(void); /**< wrc_build_info() */
  int32_t (*config_use)(wrc_config*, const char*, char*, uint64_t); /**< wrc_config_use() */
  int32_t (*contact_wrench_sensitivities)(wrc_contact*, const wrc_wheel_input*, wrc_wrench*, wrc_wrench_derivatives*);
    /**< wrc_contact_wrench_derivatives() */
  int32_t (*ellipse_init)(wrc_ellipse*); /**< wrc_ellipse_init() */
  int32_t (*contact_functions_problem_init)(wrc_wheelset_geometry_problem*);
    /**< wrc_wheelset_geometry_problem_init() */
  int32_t (*contact_functions_init)(wrc_wheelset_geometry*); /**< wrc_wheelset_geometry_init() */
  int32_t (*conicity_problem_init)(wrc_conicity_problem*); /**< wrc_conicity_problem_init() */
  int32_t (*conicity_init)(wrc_conicity*); /**< wrc_conicity_init() */
  int32_t (*profile_contact_functions)(const wrc_model*, const wrc_wheelset_geometry_problem*, wrc_wheelset_geometry*, char*, uint64_t);
    /**< wrc_profile_wheelset_geometry() */
  int32_t (*equivalent_conicity)(const wrc_conicity_problem*, wrc_conicity*, char*, uint64_t);
    /**< wrc_equivalent_conicity() */
  int32_t (*stresses_init)(wrc_stresses*); /**< wrc_stresses_init() */
  int32_t (*exact_loads_init)(wrc_exact_loads*); /**< wrc_exact_loads_init() */
  int32_t (*exact_stress)(const wrc_exact_loads*, const double*, uint32_t, double*, char*, uint64_t);
    /**< wrc_exact_stress() */
  int32_t (*exact_largest_stresses)(const wrc_exact_loads*, const double*, uint32_t, wrc_stress_peaks*, wrc_stresses*, wrc_progress, void*, char*, uint64_t);
    /**< wrc_exact_largest_stresses() */
  int32_t (*heat_properties_init)(wrc_heat_properties*); /**< wrc_heat_properties_init() */
  int32_t (*bulk_temperatures_init)(wrc_bulk_temperatures*); /**< wrc_bulk_temperatures_init() */
  int32_t (*temperature_init)(wrc_temperature*); /**< wrc_temperature_init() */
  int32_t (*contact_temperature)(wrc_contact*, const wrc_bulk_temperatures*, wrc_temperature*);
    /**< wrc_contact_temperature() */
  int32_t (*flash_temperature)(uint32_t, double, const double*, double, const wrc_heat_properties*, const wrc_heat_properties*, double*);
    /**< wrc_flash_temperature() */
  int32_t (*exact_transient_create)(const wrc_grid*, const wrc_materials*, wrc_exact_transient**, char*, uint64_t);
    /**< wrc_exact_transient_create() */
  int32_t (*exact_transient_step)(wrc_exact_transient*, const wrc_exact_rolling_problem*, wrc_exact_rolling_solution*, char*, uint64_t);
    /**< wrc_exact_transient_step() */
  void (*exact_transient_destroy)(wrc_exact_transient*); /**< wrc_exact_transient_destroy() */
  int32_t (*contact_region_ellipse)(const wrc_contact*, int32_t, wrc_ellipse*); /**< wrc_contact_region_ellipse() */
  int32_t (*contact_region_damage)(wrc_contact*, int32_t, wrc_damage*); /**< wrc_contact_region_damage() */
  int32_t (*contact_region_field)(wrc_contact*, int32_t, int32_t, double*, uint64_t); /**< wrc_contact_region_field() */
  int32_t (*contact_portable_size)(const wrc_model*, uint64_t*); /**< wrc_contact_portable_size() */
  int32_t (*contact_save_portable)(const wrc_contact*, void*, uint64_t); /**< wrc_contact_save_portable() */
  int32_t (*contact_restore_portable)(wrc_contact*, const void*, uint64_t); /**< wrc_contact_restore_portable() */
  int32_t (*contact_stresses)(wrc_contact*, int32_t, const double*, uint32_t, wrc_stress_peaks*, wrc_stresses*);
    /**< wrc_contact_stresses() */
  int32_t (*frame_motion_init)(wrc_frame_motion*); /**< wrc_frame_motion_init() */
  int32_t (*shakedown_limit_point)(double, double*); /**< wrc_shakedown_limit_point() */
  int32_t (*damage_bins_init)(wrc_damage_bins*); /**< wrc_damage_bins_init() */
  int32_t (*fatigue_laws_init)(wrc_fatigue_laws*); /**< wrc_fatigue_laws_init() */
  int32_t (*accumulation_init)(wrc_accumulation*); /**< wrc_accumulation_init() */
  int32_t (*contact_accumulate)(wrc_contact*, const wrc_accumulation*, wrc_damage_bins*, wrc_damage_bins*, wrc_damage_totals*);
    /**< wrc_contact_accumulate() */
  int32_t (*damage_merge)(wrc_damage_bins*, const wrc_damage_bins*); /**< wrc_damage_merge() */
  int32_t (*damage_values)(const wrc_damage_bins*, int32_t, double*); /**< wrc_damage_values() */
  int32_t (*whole_life_damage)(const wrc_fatigue_laws*, double, double*); /**< wrc_whole_life_damage() */
  int32_t (*model_arc_places)(const wrc_model*, int32_t, uint32_t, const double*, double*, double*);
    /**< wrc_model_arc_places() */
  int32_t (*contact_roll)(wrc_contact*, double); /**< wrc_planar_roll() */
  int32_t (*profile_wear_init)(wrc_profile_wear*); /**< wrc_profile_wear_init() */
  int32_t (*worn_profile_init)(wrc_worn_profile*); /**< wrc_worn_profile_init() */
  int32_t (*profile_take_off)(const wrc_profile_wear*, wrc_worn_profile*, char*, uint64_t);
    /**< wrc_profile_remove_wear() */
  int32_t (*flange_dimensions)(uint32_t, const double*, const double*, double, wrc_flange*, char*, uint64_t);
    /**< wrc_flange_dimensions() */
  int32_t (*contact_region_temperature)(wrc_contact*, int32_t, const wrc_bulk_temperatures*, wrc_temperature*);
    /**< wrc_contact_region_temperature() */
};

#endif /* WRC_API_H */
