/* A host as it was compiled against the baseline's headers: caller_x86_64.s is what became of it, with the
 * sizes and places of then. Prints the bits of what the library gives it. */
#include <stdio.h>
#include <stdlib.h>

#include "wrc/wrc_api.h"

static void bits(const char* name, double value) { printf("%s %.17g\n", name, value); }

int main(void) {
  const wrc_api* api = wrc_get_api(WRC_ABI_VERSION);
  if (!api || api->struct_size < sizeof(wrc_api)) return 2;
  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  config.planar.strips = 40;
  config.tangential.method = WRC_TANGENTIAL_STRIP_FASTSIM;
  wrc_model* model = NULL;
  wrc_contact* contact = NULL;
  if (wrc_model_create(&config, NULL, &model, NULL, 0) < 0 ||
      api->contact_create(model, WRC_SIDE_LEFT, NULL, &contact, NULL, 0) < 0)
    return 3;

  wrc_planar_input input = wrc_planar_input_default();
  wrc_planar_output output = wrc_planar_output_default();
  input.pose.lateral = 2e-3;
  input.load.normal_force = 80e3;
  input.creepage.lateral = 0.4e-3;
  input.friction.coefficient = 0.35;
  if (wrc_planar_step(contact, &input, &output) != WRC_OK) return 4;
  bits("y", output.point.y);
  bits("peak pressure", output.normal.peak_pressure);
  bits("fy", output.forces.fy);
  bits("t_gamma", output.damage.t_gamma);
  wrc_patch patch = wrc_patch_default();
  wrc_view view;
  if (wrc_contact_patch(contact, 0, &patch) != WRC_OK) return 5;
  if (wrc_contact_field(contact, 0, WRC_FIELD_TRACTION_Y, &view) != WRC_OK) return 6;
  bits("patch", patch.ellipse.b);
  bits("traction", view.data[view.stride[0] * 3 + view.stride[1] * (view.count[1] / 2)]);

  wrc_wheel_input wheel = wrc_wheel_input_default();
  wrc_wrench wrench = wrc_wrench_default();
  wrc_wrench_derivatives slopes;
  wheel.wheel.z = 0.3e-3;
  wheel.wheel.yaw = 2e-3;
  wheel.wheel.velocity[0] = 20.0;
  wheel.wheel.angular_velocity[1] = -20.0 / 0.46;
  wheel.damping = 0.1;
  if (wrc_contact_wrench_derivatives(contact, &wheel, &wrench, &slopes) != WRC_OK) return 7;
  bits("force", wrench.force[2]);
  bits("steepest", wrench.steepest_angle);
  bits("stiffness", slopes.wrench[2][WRC_BY_Z]);
  wrc_region region = wrc_region_default();
  if (wrc_contact_region(contact, 0, &region) != WRC_OK) return 8;
  bits("spin", region.creepage[2]);

  /* an option of which this host does not know is as it was: the default */
  input.load.normal_force = 80.0;
  char sentence[300];
  if (wrc_planar_step(contact, &input, &output) != WRC_ERROR_RANGE) return 9;
  if (wrc_contact_last_error(contact, sentence, sizeof sentence) != WRC_OK) return 10;
  printf("%s\n", sentence);
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
  return 0;
}
