/* first_step.c - the smallest complete use of wrc: S1002 wheel on a UIC60 rail, 80 kN, a little creepage.
 *
 *   cc first_step.c -lwrc -o first_step && ./first_step
 */
#include <stdio.h>
#include <stdlib.h>

#include "wrc/wrc.h"

int main(void) {
  wrc_profile wheel = {sizeof wheel, WRC_PROFILE_S1002, 0, 0, NULL, NULL, 0.0};
  wrc_profile rail = {sizeof rail, WRC_PROFILE_UIC60_BENCHMARK, 0, 0, NULL, NULL, 0.0};

  /* The model: what does not change. Every struct gets its size first, then its defaults. */
  wrc_config config;
  config.struct_size = sizeof config;
  wrc_config_init(&config);
  config.wheel = &wheel;
  config.rail = &rail;

  char text[256];
  if (wrc_config_check(&config, text, sizeof text) < 0) {
    fprintf(stderr, "configuration: %s\n", text);
    return EXIT_FAILURE;
  }
  wrc_model* model = NULL;
  wrc_contact* contact = NULL;
  if (wrc_model_create(&config, NULL, &model) < 0 ||
      wrc_contact_create(model, WRC_SIDE_RIGHT, NULL, &contact) < 0) {
    fprintf(stderr, "out of memory\n");
    return EXIT_FAILURE;
  }

  /* One step. From here on nothing allocates. */
  wrc_pose pose;
  wrc_load load;
  wrc_creepage creepage;
  wrc_friction friction;
  wrc_patch patch;
  wrc_forces forces;
  pose.struct_size = sizeof pose;
  load.struct_size = sizeof load;
  creepage.struct_size = sizeof creepage;
  friction.struct_size = sizeof friction;
  patch.struct_size = sizeof patch;
  forces.struct_size = sizeof forces;
  wrc_pose_init(&pose);
  wrc_load_init(&load);
  wrc_creepage_init(&creepage);
  wrc_friction_init(&friction);
  load.normal_force = 80e3; /* N */
  creepage.longitudinal = 0.5e-3;
  creepage.speed = 40.0; /* m/s */
  friction.coefficient = 0.35;

  wrc_input input = {sizeof input, 0, &pose, NULL, &load, &creepage, &friction};
  wrc_output output = {sizeof output, 0, NULL, &patch, &forces, NULL};
  const int32_t status = wrc_contact_step(contact, &input, &output);
  if (status != WRC_OK) {
    wrc_contact_last_error(contact, text, sizeof text);
    fprintf(stderr, "%s: %s\n", wrc_status_name(status), text);
  }
  if (status >= 0) {
    printf("patch   %.1f x %.1f mm, approach %.1f um, peak pressure %.0f MPa\n", 1e3 * patch.length,
           1e3 * patch.width, 1e6 * patch.approach, 1e-6 * patch.peak_pressure);
    printf("forces  Fx %.0f N, Fy %.0f N, Mz %.1f N m, frictional power %.0f W\n", forces.fx, forces.fy,
           forces.mz, forces.power);
  }
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
  return status < 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}
