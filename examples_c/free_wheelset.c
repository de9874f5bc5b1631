/* free_wheelset.c - a wheelset on its own runs along a straight track, off centre at first.
 *
 *   free_wheelset [METRES]     16 m; prints its lateral motion and the length of its waves
 *
 * What a multibody code does with wrc: in every evaluation, one call per wheel with the wheelset's pose and
 * velocities, and the two wrenches added up about the middle of the axle. Forward speed is held; lateral,
 * vertical, roll, yaw and pitch motion are integrated (semi-implicit Euler).
 */
#include <stdio.h>
#include <stdlib.h>

#include "wrc/wrc.h"

static const double speed = 5.0, load = 120e3; /* m/s; N on the axle, its own weight included */
static const double mass = 1500.0, across = 900.0, about_axle = 110.0; /* kg, kg m^2 */
static const double radius = 0.46, step = 2e-4;                        /* m, s */

enum { right = WRC_SIDE_RIGHT, left = WRC_SIDE_LEFT };

static int failed(const wrc_contact* contact, int32_t status) {
  char text[300] = "";
  wrc_contact_last_error(contact, text, sizeof text);
  fprintf(stderr, "%s: %s\n", wrc_status_name(status), text);
  return EXIT_FAILURE;
}

int main(int argc, char** argv) {
  const double distance = argc > 1 ? strtod(argv[1], NULL) : 16.0;

  /* One model for both wheels, one contact each. */
  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  config.wheelset.wheel_radius = radius;
  wrc_model* model = NULL;
  wrc_contact* contact[2] = {NULL, NULL};
  char why[300];
  int32_t status = wrc_model_create(&config, NULL, &model, why, sizeof why);
  for (int side = 0; side < 2 && status >= 0; ++side)
    status = wrc_contact_create(model, side, NULL, &contact[side], why, sizeof why);
  if (status < 0) {
    fprintf(stderr, "%s\n", why);
    return EXIT_FAILURE;
  }

  wrc_wheel_input input = wrc_wheel_input_default();
  wrc_wheel_state* wheel = &input.wheel;
  wrc_wrench wrench = {.struct_size = sizeof wrench};

  /* The height at which the centred wheelset stands. */
  wheel->velocity[0] = speed;
  wheel->pitch_rate = -speed / radius;
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 0.5 * load;
  status = wrc_contact_wrench(contact[right], &input, &wrench);
  if (status < 0) return failed(contact[right], status);
  input.prescribed = WRC_PRESCRIBE_HEIGHT;
  input.vertical_load = 0.0;
  input.damping = 0.3;

  double y = 1e-3, z = wrench.z, roll = 0.0, yaw = 0.0; /* of the wheelset */
  double dy = 0.0, dz = 0.0, roll_rate = 0.0, yaw_rate = 0.0, pitch_rate = -speed / radius;
  double crossed = -1.0, wave = 0.0;
  int waves = 0;
  printf("%8s %9s %9s %9s\n", "x [m]", "y [mm]", "yaw [mrad]", "Fy [N]");
  const long steps = (long)(distance / (speed * step));
  for (long n = 0; n <= steps; ++n) {
    wheel->y = y;
    wheel->z = z;
    wheel->roll = roll;
    wheel->yaw = yaw;
    wheel->velocity[1] = dy;
    wheel->velocity[2] = dz;
    wheel->roll_rate = roll_rate;
    wheel->pitch_rate = pitch_rate;
    wheel->yaw_rate = yaw_rate;
    double force[3] = {0.0, 0.0, load}, moment[3] = {0.0, 0.0, 0.0};
    for (int side = 0; side < 2; ++side) {
      status = wrc_contact_wrench(contact[side], &input, &wrench);
      if (status < 0) return failed(contact[side], status);
      for (int i = 0; i < 3; ++i) {
        force[i] += wrench.force[i];
        moment[i] += wrench.moment[i];
      }
    }
    const double x = speed * step * (double)n;
    if (n % (steps / 25 + 1) == 0) printf("%8.2f %9.4f %9.4f %9.0f\n", x, 1e3 * y, 1e3 * yaw, force[1]);

    dy += step * force[1] / mass;
    dz += step * force[2] / mass;
    roll_rate += step * (moment[0] + about_axle * pitch_rate * yaw_rate) / across;
    yaw_rate += step * (moment[2] - about_axle * pitch_rate * roll_rate) / across;
    pitch_rate += step * moment[1] / about_axle;
    const double before = y;
    y += step * dy;
    z += step * dz;
    roll += step * roll_rate;
    yaw += step * yaw_rate;
    if (before < 0.0 && y >= 0.0) { /* upwards through the middle */
      const double at = x + speed * step * before / (before - y);
      if (crossed >= 0.0) {
        wave += at - crossed;
        ++waves;
      }
      crossed = at;
    }
  }
  if (waves > 0) printf("waves of %.2f m\n", wave / waves);
  for (int side = 0; side < 2; ++side) wrc_contact_destroy(contact[side]);
  wrc_model_destroy(model);
  return EXIT_SUCCESS;
}
