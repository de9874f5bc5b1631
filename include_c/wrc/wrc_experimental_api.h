/** @file wrc_experimental_api.h
 * Every function of wrc_damage.h, wrc_offline.h and wrc_profiles.h as a table, for hosts that load the library at run time: wrc_get_experimental_api().
 * Written by tools/interface/describe.py from the headers in include_c/wrc: do not edit.
 */
#ifndef WRC_EXPERIMENTAL_API_H
#define WRC_EXPERIMENTAL_API_H

#include "wrc_offline.h"
#include "wrc_profiles.h"

/** The functions, each under its name without wrc_. */
struct wrc_experimental_api {
  uint32_t struct_size; /**< sizeof this struct, of the library */
  uint32_t experimental_version; /**< WRC_EXPERIMENTAL_VERSION of the library */
  int32_t (*bulk_temperatures_init)(wrc_bulk_temperatures*); /**< wrc_bulk_temperatures_init() */
  int32_t (*wear_laws_init)(wrc_wear_laws*); /**< wrc_wear_laws_init() */
  int32_t (*damage_bins_init)(wrc_damage_bins*); /**< wrc_damage_bins_init() */
  int32_t (*fatigue_laws_init)(wrc_fatigue_laws*); /**< wrc_fatigue_laws_init() */
  int32_t (*contact_wear)(wrc_contact*, int32_t, const wrc_wear_laws*, wrc_wear*); /**< wrc_contact_wear() */
  int32_t (*contact_temperature)(wrc_contact*, int32_t, const wrc_bulk_temperatures*, wrc_temperature*);
    /**< wrc_contact_temperature() */
  int32_t (*contact_stresses)(wrc_contact*, int32_t, int32_t, const double*, uint32_t, wrc_stress_peaks*, wrc_stresses*);
    /**< wrc_contact_stresses() */
  int32_t (*flash_temperature)(uint32_t, double, const double*, double, const wrc_heat_properties*, const wrc_heat_properties*, double*);
    /**< wrc_flash_temperature() */
  int32_t (*contact_accumulate)(wrc_contact*, const wrc_accumulation*, wrc_damage_bins*, wrc_damage_bins*, wrc_damage_totals*);
    /**< wrc_contact_accumulate() */
  int32_t (*damage_merge)(wrc_damage_bins*, const wrc_damage_bins*); /**< wrc_damage_merge() */
  int32_t (*damage_values)(const wrc_damage_bins*, int32_t, double*); /**< wrc_damage_values() */
  int32_t (*whole_life_damage)(const wrc_fatigue_laws*, double, double*); /**< wrc_whole_life_damage() */
  int32_t (*model_arc_places)(const wrc_model*, int32_t, uint32_t, const double*, double*, double*);
    /**< wrc_model_arc_places() */
  int32_t (*linear_coefficients)(double, double, double, wrc_coefficients*); /**< wrc_linear_coefficients() */
  int32_t (*shakedown_limit)(double, double*); /**< wrc_shakedown_limit() */
  int32_t (*shakedown_limit_point)(double, double*); /**< wrc_shakedown_limit_point() */
  int32_t (*exact_normal_problem_init)(wrc_exact_normal_problem*); /**< wrc_exact_normal_problem_init() */
  int32_t (*exact_rolling_problem_init)(wrc_exact_rolling_problem*); /**< wrc_exact_rolling_problem_init() */
  int32_t (*exact_loads_init)(wrc_exact_loads*); /**< wrc_exact_loads_init() */
  int32_t (*exact_check_options_init)(wrc_exact_check_options*); /**< wrc_exact_check_options_init() */
  int32_t (*exact_wrench_options_init)(wrc_exact_wrench_options*); /**< wrc_exact_wrench_options_init() */
  int32_t (*exact_gap)(wrc_contact*, const wrc_grid*, double*); /**< wrc_exact_gap() */
  int32_t (*exact_normal)(const wrc_exact_normal_problem*, wrc_exact_normal_solution*, char*, uint64_t);
    /**< wrc_exact_normal() */
  int32_t (*exact_rolling)(const wrc_exact_rolling_problem*, wrc_exact_rolling_solution*, char*, uint64_t);
    /**< wrc_exact_rolling() */
  int32_t (*exact_stress)(const wrc_exact_loads*, const double*, uint32_t, double*, char*, uint64_t);
    /**< wrc_exact_stress() */
  int32_t (*exact_largest_stresses)(const wrc_exact_loads*, const double*, uint32_t, wrc_stress_peaks*, wrc_stresses*, wrc_progress, void*, char*, uint64_t);
    /**< wrc_exact_largest_stresses() */
  int32_t (*exact_transient_create)(const wrc_grid*, const wrc_material*, const wrc_material*, wrc_exact_transient**, char*, uint64_t);
    /**< wrc_exact_transient_create() */
  int32_t (*exact_transient_step)(wrc_exact_transient*, const wrc_exact_rolling_problem*, wrc_exact_rolling_solution*, char*, uint64_t);
    /**< wrc_exact_transient_step() */
  void (*exact_transient_destroy)(wrc_exact_transient*); /**< wrc_exact_transient_destroy() */
  int32_t (*exact_check)(wrc_contact*, const wrc_exact_check_options*, wrc_exact_check_result*);
    /**< wrc_exact_check() */
  int32_t (*exact_wrench)(wrc_contact*, const wrc_wheel_input*, const wrc_exact_wrench_options*, wrc_wrench*);
    /**< wrc_exact_wrench() */
  int32_t (*conicity_problem_init)(wrc_conicity_problem*); /**< wrc_conicity_problem_init() */
  int32_t (*profile_wear_init)(wrc_profile_wear*); /**< wrc_profile_wear_init() */
  int32_t (*profile_wheelset_geometry)(const wrc_model*, const wrc_wheelset_geometry_problem*, wrc_wheelset_geometry*, char*, uint64_t);
    /**< wrc_profile_wheelset_geometry() */
  int32_t (*equivalent_conicity)(const wrc_conicity_problem*, wrc_conicity*, char*, uint64_t);
    /**< wrc_equivalent_conicity() */
  int32_t (*profile_remove_wear)(const wrc_profile_wear*, wrc_worn_profile*, char*, uint64_t);
    /**< wrc_profile_remove_wear() */
  int32_t (*flange_dimensions)(uint32_t, const double*, const double*, double, wrc_flange*, char*, uint64_t);
    /**< wrc_flange_dimensions() */
  int32_t (*rail_faces_problem_init)(wrc_rail_faces_problem*); /**< wrc_rail_faces_problem_init() */
  int32_t (*rail_faces_create)(const wrc_rail_faces_problem*, wrc_rail_faces**, char*, uint64_t);
    /**< wrc_rail_faces_create() */
  int32_t (*rail_faces_found)(const wrc_rail_faces*, wrc_found_faces*); /**< wrc_rail_faces_found() */
  int32_t (*rail_faces_outline)(const wrc_rail_faces*, uint32_t, wrc_face_outline*); /**< wrc_rail_faces_outline() */
  void (*rail_faces_destroy)(wrc_rail_faces*); /**< wrc_rail_faces_destroy() */
  int32_t (*section_file_read)(const char*, double, int32_t, int32_t, wrc_section_file**, char*, uint64_t);
    /**< wrc_section_file_read() */
  int32_t (*section_file_line)(const wrc_section_file*, uint32_t, wrc_section_line*); /**< wrc_section_file_line() */
  void (*section_file_destroy)(wrc_section_file*); /**< wrc_section_file_destroy() */
  int32_t (*section_file_write)(const char*, const wrc_section_line*, uint32_t, char*, uint64_t);
    /**< wrc_section_file_write() */
};

#endif /* WRC_EXPERIMENTAL_API_H */
