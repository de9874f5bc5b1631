/* One wheel on its rail as a block of plain numbers: 18 in, 6 out, and their derivatives. What the Simulink
 * and Modelica folders have in common. Inputs: y, z, roll, yaw, velocity x y z, rates of roll, pitch (about
 * the axle, -v / r rolling forwards) and yaw; rail y, z, roll, velocities y z of its material, its rate of
 * roll, its slopes dy/dx, dz/dx along the track. Outputs: force x y z, moment x y z on the wheel about the
 * middle of the wheelset, track axes. Every call starts cold: the same inputs have the same outputs. */
#ifndef WRC_BLOCK_H
#define WRC_BLOCK_H

#include <stdlib.h>
#include <string.h>

#include "wrc/wrc.h"

enum { WRC_BLOCK_INPUTS = 18, WRC_BLOCK_OUTPUTS = 6 };

typedef struct wrc_block {
  wrc_model* model;
  wrc_contact* contact;
  wrc_wheel_input input;
  wrc_wrench wrench;
  wrc_wrench_derivatives slopes;
  char sentence[400]; /* why the last call failed */
} wrc_block;

static void wrc_block_close(wrc_block* block) {
  if (!block) return;
  wrc_contact_destroy(block->contact);
  wrc_model_destroy(block->model);
  free(block);
}

/* side, profiles: enum wrc_side, enum wrc_profile_kind. NULL: no memory; else look at block->contact, NULL
 * with a sentence where there is no such block. */
static wrc_block* wrc_block_open(int side, int wheel, int rail, double inclination, double friction) {
  wrc_config config = wrc_config_default();
  wrc_block* block = (wrc_block*)calloc(1, sizeof *block);
  if (!block) return NULL;
  config.wheel.kind = wheel;
  config.rail.kind = rail;
  config.track.rail_inclination = inclination;
  block->input = wrc_wheel_input_default();
  block->input.friction.coefficient = friction;
  block->wrench.struct_size = sizeof block->wrench;
  block->slopes.struct_size = sizeof block->slopes;
  if (wrc_model_create(&config, NULL, &block->model, block->sentence, sizeof block->sentence) >= 0)
    wrc_contact_create(block->model, side, NULL, &block->contact, block->sentence, sizeof block->sentence);
  return block;
}

static void wrc_block_give(wrc_block* block, const double in[]) {
  wrc_wheel_state* wheel = &block->input.wheel;
  wrc_rail_state* rail = &block->input.rail;
  wheel->y = in[0], wheel->z = in[1], wheel->roll = in[2], wheel->yaw = in[3];
  memcpy(wheel->velocity, in + 4, sizeof wheel->velocity);
  wheel->roll_rate = in[7], wheel->pitch_rate = in[8], wheel->yaw_rate = in[9];
  rail->y = in[10], rail->z = in[11], rail->roll = in[12];
  rail->y_velocity = in[13], rail->z_velocity = in[14], rail->roll_rate = in[15];
  rail->y_slope = in[16], rail->z_slope = in[17];
}

/* Returns the status: < 0 failed, with a sentence. slopes: 6 rows of 18, or NULL. */
static int wrc_block_wrench(wrc_block* block, const double in[], double out[], double* slopes) {
  int status, i;
  wrc_block_give(block, in);
  status = slopes
               ? wrc_contact_wrench_derivatives(block->contact, &block->input, &block->wrench, &block->slopes)
               : wrc_contact_wrench(block->contact, &block->input, &block->wrench);
  if (status < 0) wrc_contact_last_error(block->contact, block->sentence, sizeof block->sentence);
  memcpy(out, block->wrench.force, sizeof block->wrench.force);
  memcpy(out + 3, block->wrench.moment, sizeof block->wrench.moment);
  for (i = 0; slopes && i < WRC_BLOCK_OUTPUTS * WRC_BLOCK_INPUTS; ++i) {
    const int row = i / WRC_BLOCK_INPUTS, column = i % WRC_BLOCK_INPUTS;
    slopes[i] = block->slopes.wrench[row][column < 16 ? column : WRC_BY_RAIL_Y_SLOPE + column - 16];
  }
  return status;
}

#endif
