/* first_step.c - the smallest complete use of wrc: S1002 wheel on a UIC60 rail, 80 kN, a little creepage.
 *
 *   cc first_step.c -lwrc -o first_step && ./first_step
 */
#include <stdio.h>
#include <stdlib.h>

#include "wrc/wrc_planar.h"

int main(void) {
  /* The model: what does not change. */
  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;

  char text[256];
  if (wrc_config_check(&config, text, sizeof text) < 0) {
    fprintf(stderr, "configuration: %s\n", text);
    return EXIT_FAILURE;
  }
  wrc_model* model = NULL;
  wrc_contact* contact = NULL;
  if (wrc_model_create(&config, NULL, &model, NULL, 0) < 0 ||
      wrc_contact_create(model, WRC_SIDE_RIGHT, NULL, &contact, NULL, 0) < 0) {
    fprintf(stderr, "out of memory\n");
    return EXIT_FAILURE;
  }

  /* One step. From here on nothing allocates. */
  wrc_planar_input input = wrc_planar_input_default();
  wrc_planar_output output = wrc_planar_output_default();
  input.load.normal_force = 80e3; /* N */
  input.creepage.longitudinal = 0.5e-3;
  input.creepage.speed = 40.0; /* m/s */
  input.friction.coefficient = 0.35;
  const int32_t status = wrc_planar_step(contact, &input, &output);
  if (status != WRC_OK) {
    wrc_contact_last_error(contact, text, sizeof text);
    fprintf(stderr, "%s: %s\n", wrc_status_name(status), text);
  }
  if (status >= 0) {
    const wrc_planar_normal_solution* normal = &output.normal;
    const wrc_planar_forces* forces = &output.forces;
    printf("patch   %.1f x %.1f mm, approach %.1f um, peak pressure %.0f MPa\n", 1e3 * normal->length,
           1e3 * normal->width, 1e6 * normal->approach, 1e-6 * normal->peak_pressure);
    printf("forces  Fx %.0f N, Fy %.0f N, Mz %.1f N m, frictional power %.0f W\n", forces->fx, forces->fy,
           forces->mz, forces->power);
  }
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
  return status < 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}
