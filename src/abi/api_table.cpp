/// The function table for hosts that load the library with dlopen.
#include "wrc/wrc.h"

extern "C" const wrc_api* wrc_get_api(uint32_t abi_version) {
  // Constant-initialised: no constructor runs when the library is loaded.
  static constexpr wrc_api table = {
      sizeof(wrc_api),        WRC_ABI_VERSION,       wrc_version,         wrc_status_name,
      wrc_status_text,        wrc_profile_init,      wrc_config_init,     wrc_pose_init,
      wrc_contact_point_init, wrc_gap_init,          wrc_load_init,       wrc_creepage_init,
      wrc_friction_init,      wrc_patch_init,        wrc_strips_init,     wrc_forces_init,
      wrc_damage_init,        wrc_coefficients_init, wrc_input_init,      wrc_output_init,
      wrc_view_init,          wrc_allocator_init,    wrc_config_check,    wrc_model_size,
      wrc_model_init,         wrc_model_create,      wrc_model_destroy,   wrc_contact_size,
      wrc_contact_init,       wrc_contact_create,    wrc_contact_destroy, wrc_contact_save,
      wrc_contact_restore,    wrc_last_error,        wrc_geometry,        wrc_normal,
      wrc_regularise,         wrc_tangential,        wrc_damage_numbers,  wrc_step,
      wrc_step_batch,         wrc_step_flat,         wrc_field,           wrc_linear_coefficients,
      wrc_shakedown_limit,
  };
  return abi_version == WRC_ABI_VERSION ? &table : nullptr;
}
