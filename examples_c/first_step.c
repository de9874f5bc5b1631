/* first_step.c - the smallest complete use of wrc: a wheelset, S1002 on 60E1, 80 kN on each wheel.
 *
 *   cc first_step.c -lwrc -o first_step && ./first_step
 *
 * First the height at which the wheelset stands, then the wrench on both wheels while it rolls at 20 m/s, in
 * the middle of the track, the nose turned to the right by 2 mrad.
 */
#include <stdio.h>
#include <stdlib.h>

#include "wrc/wrc.h"

static const double speed = 20.0; /* m/s */

/* The wrench, or the end of the program and the library's sentence. A flag, > 0, is no failure. */
static int32_t solve(wrc_contact* contact, const wrc_wheel_input* input, wrc_wrench* wrench) {
  const int32_t status = wrc_contact_wrench(contact, input, wrench);
  if (status < 0) {
    char text[300] = "";
    wrc_contact_last_error(contact, text, sizeof text);
    fprintf(stderr, "%s: %s\n", wrc_status_name(status), text);
    exit(EXIT_FAILURE);
  }
  return status;
}

int main(void) {
  /* The model: what does not change. It serves both sides. */
  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_60E1;
  config.track.rail_inclination = 1.0 / 40.0;

  char why[300];
  wrc_model* model = NULL;
  wrc_contact* contact[2] = {NULL, NULL}; /* of WRC_SIDE_RIGHT, WRC_SIDE_LEFT */
  int32_t status = wrc_model_create(&config, NULL, &model, why, sizeof why);
  for (int side = 0; side < 2 && status >= 0; ++side)
    status = wrc_contact_create(model, side, NULL, &contact[side], why, sizeof why);
  if (status < 0) {
    fprintf(stderr, "%s: %s\n", wrc_status_name(status), why);
    return EXIT_FAILURE;
  }

  /* The height under load: found once, at rest, which is flagged and does not matter here. */
  wrc_wheel_input input = wrc_wheel_input_default();
  wrc_wrench wrench = {.struct_size = sizeof wrench};
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 80e3; /* N */
  solve(contact[WRC_SIDE_RIGHT], &input, &wrench);
  printf("stands %.1f um below its nominal height\n", 1e6 * wrench.z);

  /* What a multibody code hands over in every evaluation: pose and motion of the wheelset's middle. From here
   * on nothing allocates. Fx drives the wheel, Fy > 0 pushes it to the right, Fz < 0 carries it. */
  input.prescribed = WRC_PRESCRIBE_HEIGHT;
  input.vertical_load = 0.0;
  wrc_wheel_state* wheel = &input.wheel;
  wheel->z = wrench.z; /* m */
  wheel->yaw = 2e-3;   /* rad */
  wheel->velocity[0] = speed;
  wheel->pitch_rate = -speed / config.wheelset.wheel_radius; /* rad/s, about the axle */
  double force[3] = {0.0, 0.0, 0.0}, moment[3] = {0.0, 0.0, 0.0};
  for (int side = 0; side < 2; ++side) {
    const char* const name = side == WRC_SIDE_RIGHT ? "right" : "left";
    status = solve(contact[side], &input, &wrench);
    printf("%-6s Fx %6.0f N, Fy %6.0f N, Fz %6.0f N, peak pressure %.0f MPa, frictional power %.0f W, %s\n",
           name, wrench.force[0], wrench.force[1], wrench.force[2], 1e-6 * wrench.peak_pressure, wrench.power,
           wrc_status_name(status));
    for (int i = 0; i < 3; ++i) {
      force[i] += wrench.force[i];
      moment[i] += wrench.moment[i];
    }
  }
  printf("both   Fx %6.0f N, Fy %6.0f N, Fz %6.0f N, moment about z %.0f N m\n", force[0], force[1], force[2],
         moment[2]);

  for (int side = 0; side < 2; ++side) wrc_contact_destroy(contact[side]);
  wrc_model_destroy(model);
  return EXIT_SUCCESS;
}
