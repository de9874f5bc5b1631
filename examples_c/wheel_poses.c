/* wheel_poses.c - independent wheels, a roller rig and a gauge that varies, all as poses of one wheel on one
 * rail.
 *
 *   wheel_poses
 *
 * S1002 on 60E1 at 1:40, 80 kN on each wheel, 20 m/s.
 */
#include <stdio.h>
#include <stdlib.h>

#include "wrc/wrc.h"

static const double load = 80e3, speed = 20.0, radius = 0.46;

static wrc_model* model_of(double gauge, double roller_curvature) {
  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_60E1;
  config.track.rail_inclination = 1.0 / 40.0;
  config.track.gauge = gauge;
  config.roller_curvature = roller_curvature;
  char why[300];
  wrc_model* model = NULL;
  if (wrc_model_create(&config, NULL, &model, why, sizeof why) < 0) {
    fprintf(stderr, "%s\n", why);
    exit(EXIT_FAILURE);
  }
  return model;
}

/* One wheel under its load; a contact for the call alone, which no program that cares for time would make. */
static wrc_wrench wrench_of(const wrc_model* model, int side, const wrc_wheel_input* input,
                            wrc_wrench_derivatives* by) {
  wrc_contact* contact = NULL;
  wrc_wrench wrench = {.struct_size = sizeof wrench};
  if (wrc_contact_create(model, side, NULL, &contact, NULL, 0) < 0) exit(EXIT_FAILURE);
  const int32_t status = wrc_contact_wrench_derivatives(contact, input, &wrench, by);
  if (status != WRC_OK) fprintf(stderr, "%s\n", wrc_status_name(status));
  wrc_contact_destroy(contact);
  if (status < 0) exit(EXIT_FAILURE);
  return wrench;
}

static wrc_wheel_input rolling(double y) {
  wrc_wheel_input input = wrc_wheel_input_default();
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = load;
  input.wheel.y = y;
  input.wheel.velocity[0] = speed;
  input.wheel.pitch_rate = -speed / radius;
  return input;
}

/* An axle that lets its wheels turn by themselves, 3 mm beside the middle: each wheel takes the speed at
 * which nothing turns it about the axle, and with the longitudinal forces goes the couple that makes a
 * wheelset steer. */
static void independent_wheels(void) {
  wrc_model* model = model_of(1.435, 0.0);
  printf("independent wheels, 3 mm to the right of the middle\n");
  printf("                    speeds of right, left [rad/s]   forces along x [N]  couple about z [N m]\n");
  for (int own = 0; own < 2; ++own) {
    wrc_wheel_input input[2] = {rolling(3e-3), rolling(3e-3)};
    wrc_wrench wrench[2];
    for (int turn = 0; turn < 6; ++turn) { /* Newton: no moment about y, of each wheel or of both together */
      double moment[2], slope[2];
      for (int side = 0; side < 2; ++side) {
        wrc_wrench_derivatives by = {.struct_size = sizeof by};
        wrench[side] = wrench_of(model, side == 0 ? WRC_SIDE_RIGHT : WRC_SIDE_LEFT, &input[side], &by);
        moment[side] = wrench[side].moment[1];
        slope[side] = by.wrench[4][WRC_BY_ANGULAR_VELOCITY_Y];
      }
      const double both = (moment[0] + moment[1]) / (slope[0] + slope[1]);
      for (int side = 0; side < 2 && turn < 5; ++side)
        input[side].wheel.pitch_rate -= own ? moment[side] / slope[side] : both;
    }
    printf("  %s %10.3f %10.3f %13.0f %9.0f %14.0f\n", own ? "each by itself" : "on one axle   ",
           input[0].wheel.pitch_rate, input[1].wheel.pitch_rate, wrench[0].force[0], wrench[1].force[0],
           wrench[0].moment[2] + wrench[1].moment[2]);
  }
  wrc_model_destroy(model);
}

/* A wheel that stays above rollers of growing radius, 0.1 % of slip: what a rig changes against a rail. */
static void roller_rig(void) {
  static const double rollers[] = {0.46, 1.0, 10.0, 1e6};
  printf("a roller rig, wheel of 0.46 m driven by 0.1 %%\n");
  printf("  roller [m]   z [um]   area [mm2]   peak [MPa]   force along x [N]\n");
  for (int k = 0; k < 5; ++k) {
    wrc_model* model = model_of(1.435, k < 4 ? 1.0 / rollers[k] : 0.0);
    wrc_wheel_input input = rolling(0.0);
    if (k < 4) {
      input.wheel.velocity[0] = 0.0;
      input.roller_rate = 0.999 * speed / rollers[k];
    } else {
      input.wheel.velocity[0] = 0.999 * speed;
    }
    const wrc_wrench w = wrench_of(model, WRC_SIDE_RIGHT, &input, NULL);
    if (k < 4)
      printf("  %10g", rollers[k]);
    else
      printf("  %10s", "rail");
    printf(" %8.2f %12.2f %12.1f %19.0f\n", 1e6 * w.z, 1e6 * w.area, 1e-6 * w.peak_pressure, w.force[0]);
    wrc_model_destroy(model);
  }
}

/* A rail that stands aside, as the track's gauge and as the rail's displacement; and its motion outwards. */
static void gauge(void) {
  printf("gauge 4 mm wider, wheel 1 mm to the right\n");
  for (int k = 0; k < 4; ++k) {
    static const char* const text[] = {"nominal", "config.track.gauge", "rail.y",
                                       "rail.y, moving at 20 mm/s"};
    wrc_model* model = model_of(k == 1 ? 1.439 : 1.435, 0.0);
    wrc_wheel_input input = rolling(1e-3);
    if (k > 1) input.rail.y = 2e-3;
    if (k == 3) input.rail.y_velocity = 0.02;
    const wrc_wrench w = wrench_of(model, WRC_SIDE_RIGHT, &input, NULL);
    printf("  %-26s z %8.2f um, force %8.1f %8.1f N\n", text[k], 1e6 * w.z, w.force[0], w.force[1]);
    wrc_model_destroy(model);
  }
}

int main(void) {
  independent_wheels();
  roller_rig();
  gauge();
  return EXIT_SUCCESS;
}
