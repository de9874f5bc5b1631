/** @file wrc_api.h
 * Every function of wrc.h and wrc_planar.h as a table, for hosts that load the library at run time: wrc_get_api().
 * Written by tools/interface/describe.py from the headers in include_c/wrc: do not edit.
 */
#ifndef WRC_API_H
#define WRC_API_H

#include "wrc_planar.h"

/** Has a table this function? Of a library that is older than the header it may lack the last ones. */
#define WRC_API_HAS(api, function)                                                              \
  ((size_t)((const char*)&(api)->function - (const char*)(api)) + sizeof (api)->function <= (api)->struct_size)

/** The functions, each under its name without wrc_. New ones are added at the end alone. */
struct wrc_api {
  uint32_t struct_size; /**< sizeof this struct, of the library */
  uint32_t abi_version; /**< WRC_ABI_VERSION of the library */
  uint32_t (*version)(void); /**< wrc_version() */
  const char* (*version_text)(uint32_t); /**< wrc_version_text() */
  const char* (*build_info)(void); /**< wrc_build_info() */
  const char* (*status_name)(int32_t); /**< wrc_status_name() */
  const char* (*status_text)(int32_t); /**< wrc_status_text() */
  int32_t (*config_init)(wrc_config*); /**< wrc_config_init() */
  int32_t (*material_init)(wrc_material*); /**< wrc_material_init() */
  int32_t (*friction_init)(wrc_friction*); /**< wrc_friction_init() */
  int32_t (*wheel_input_init)(wrc_wheel_input*); /**< wrc_wheel_input_init() */
  int32_t (*config_use)(wrc_config*, const char*, char*, uint64_t); /**< wrc_config_use() */
  int32_t (*config_check)(const wrc_config*, char*, uint64_t); /**< wrc_config_check() */
  int32_t (*model_size)(const wrc_config*, uint64_t*, uint64_t*); /**< wrc_model_size() */
  int32_t (*model_init)(const wrc_config*, void*, uint64_t, wrc_model**, char*, uint64_t); /**< wrc_model_init() */
  int32_t (*model_create)(const wrc_config*, const wrc_allocator*, wrc_model**, char*, uint64_t);
    /**< wrc_model_create() */
  int32_t (*model_profile)(const wrc_model*, int32_t, int32_t, wrc_view*, wrc_view*, double*);
    /**< wrc_model_profile() */
  void (*model_destroy)(wrc_model*); /**< wrc_model_destroy() */
  int32_t (*contact_size)(const wrc_model*, uint64_t*, uint64_t*); /**< wrc_contact_size() */
  int32_t (*contact_init)(const wrc_model*, int32_t, void*, uint64_t, wrc_contact**, char*, uint64_t);
    /**< wrc_contact_init() */
  int32_t (*contact_create)(const wrc_model*, int32_t, const wrc_allocator*, wrc_contact**, char*, uint64_t);
    /**< wrc_contact_create() */
  void (*contact_destroy)(wrc_contact*); /**< wrc_contact_destroy() */
  int32_t (*contact_state_size)(const wrc_model*, uint64_t*); /**< wrc_contact_state_size() */
  int32_t (*contact_save)(wrc_contact*, void*, uint64_t); /**< wrc_contact_save() */
  int32_t (*contact_restore)(wrc_contact*, const void*, uint64_t); /**< wrc_contact_restore() */
  int32_t (*contact_portable_size)(const wrc_model*, uint64_t*); /**< wrc_contact_portable_size() */
  int32_t (*contact_save_portable)(wrc_contact*, void*, uint64_t); /**< wrc_contact_save_portable() */
  int32_t (*contact_restore_portable)(wrc_contact*, const void*, uint64_t); /**< wrc_contact_restore_portable() */
  int32_t (*contact_last_error)(const wrc_contact*, char*, uint64_t); /**< wrc_contact_last_error() */
  int32_t (*contact_wrench)(wrc_contact*, const wrc_wheel_input*, wrc_wrench*); /**< wrc_contact_wrench() */
  int32_t (*contact_wrench_derivatives)(wrc_contact*, const wrc_wheel_input*, wrc_wrench*, wrc_wrench_derivatives*);
    /**< wrc_contact_wrench_derivatives() */
  int32_t (*contact_wrench_batch)(wrc_contact* const*, uint32_t, const wrc_wheel_input*, uint64_t, wrc_wrench*, uint64_t, int32_t*);
    /**< wrc_contact_wrench_batch() */
  int32_t (*contact_region)(wrc_contact*, int32_t, wrc_region*); /**< wrc_contact_region() */
  int32_t (*contact_field)(wrc_contact*, int32_t, int32_t, double*, uint64_t, uint64_t*); /**< wrc_contact_field() */
  int32_t (*contact_damage)(wrc_contact*, int32_t, wrc_damage*); /**< wrc_contact_damage() */
  int32_t (*planar_load_init)(wrc_planar_load*); /**< wrc_planar_load_init() */
  int32_t (*creepage_init)(wrc_creepage*); /**< wrc_creepage_init() */
  int32_t (*planar_input_init)(wrc_planar_input*); /**< wrc_planar_input_init() */
  int32_t (*planar_step)(wrc_contact*, const wrc_planar_input*, wrc_planar_output*); /**< wrc_planar_step() */
  int32_t (*planar_geometry)(wrc_contact*, const wrc_planar_pose*, wrc_planar_point*); /**< wrc_planar_geometry() */
  int32_t (*planar_creepages)(wrc_contact*, const wrc_planar_motion*, wrc_creepage*); /**< wrc_planar_creepages() */
  int32_t (*planar_normal)(wrc_contact*, const wrc_planar_gap*, const wrc_planar_load*, wrc_planar_normal_solution*);
    /**< wrc_planar_normal() */
  int32_t (*planar_regularise)(wrc_contact*, const wrc_planar_strips*, wrc_planar_normal_solution*);
    /**< wrc_planar_regularise() */
  int32_t (*planar_roll)(wrc_contact*, double); /**< wrc_planar_roll() */
  int32_t (*planar_tangential)(wrc_contact*, const wrc_ellipse*, const wrc_creepage*, const wrc_friction*, wrc_planar_forces*);
    /**< wrc_planar_tangential() */
  int32_t (*planar_tangential_derivatives)(wrc_contact*, wrc_planar_derivatives*);
    /**< wrc_planar_tangential_derivatives() */
  int32_t (*contact_mark)(wrc_contact*); /**< wrc_contact_mark() */
  int32_t (*contact_commit)(wrc_contact*); /**< wrc_contact_commit() */
  int32_t (*friction_use)(wrc_friction*, const char*, char*, uint64_t); /**< wrc_friction_use() */
};

#endif /* WRC_API_H */
