/* exact_check.c - how far off was that step? Solves a step in real time, then the same contact by Kalker's
 * exact theory.
 *
 *   cc exact_check.c -lwrc -o exact_check && ./exact_check
 *
 * The exact solver takes milliseconds to seconds and allocates: it belongs beside the simulation, not into
 * its loop.
 */
#include <stdio.h>
#include <stdlib.h>

#include "wrc/wrc_offline.h"

/* Long work says how far it is. Returning 1 instead would cancel it. */
static int32_t show_progress(double fraction, void* user) {
  (void)user;
  fprintf(stderr, "\rexact solution %3.0f %%", 100.0 * fraction);
  return 0;
}

int main(void) {
  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  wrc_model* model = NULL;
  wrc_contact* contact = NULL;
  char text[300];
  if (wrc_model_create(&config, NULL, &model, text, sizeof text) < 0 ||
      wrc_contact_create(model, WRC_SIDE_RIGHT, NULL, &contact, text, sizeof text) < 0) {
    fprintf(stderr, "%s\n", text);
    return EXIT_FAILURE;
  }

  /* The step: 80 kN, a wheelset that pulls, drifts and spins a little, 40 m/s. */
  wrc_planar_input input = wrc_planar_input_default();
  wrc_planar_output output = {.struct_size = sizeof output};
  input.pose.lateral = 2e-3;
  input.load.normal_force = 80e3;
  input.creepage.longitudinal = 0.8e-3;
  input.creepage.lateral = 0.3e-3;
  input.creepage.spin = 0.15;
  input.creepage.speed = 40.0;
  int32_t status = wrc_planar_step(contact, &input, &output);

  /* The same contact exactly, on its own pressure, with its creepages and friction. */
  wrc_exact_check_options options = wrc_exact_check_options_default(); /* 64 x 64 */
  options.progress = show_progress;
  wrc_exact_check_result exact = {.struct_size = sizeof exact};
  if (status >= 0) {
    status = wrc_exact_check(contact, &options, &exact);
    fprintf(stderr, "\n");
  }
  if (status < 0) {
    wrc_contact_last_error(contact, text, sizeof text);
    fprintf(stderr, "%s: %s\n", wrc_status_name(status), text);
  } else {
    const wrc_planar_forces* forces = &output.forces;
    printf("            %10s %10s %10s %10s %10s\n", "Fx [N]", "Fy [N]", "Mz [N m]", "power [W]", "adhesion");
    printf("real time   %10.0f %10.0f %10.2f %10.1f %10.3f\n", forces->fx, forces->fy, forces->mz,
           forces->power, forces->adhesion_fraction);
    printf("exact       %10.0f %10.0f %10.2f %10.1f %10.3f\n", exact.fx, exact.fy, exact.mz, exact.power,
           exact.adhesion_fraction);
    printf("error       force %.2f %% of friction x load, power %+.2f %%\n", 100.0 * exact.force_error,
           100.0 * exact.power_error);
  }
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
  return status < 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}
