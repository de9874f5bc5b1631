/* An FMU's library from a C importer, beside the C interface: the same bits, and what a step through FMI
 * costs.
 *
 *   importer wrc_fmu.so [ROUNDS]     prints the digits of some wrenches, then the overhead; exit status 1 if bits differ
 *                                    or a step through FMI takes over 10 % longer. ROUNDS 0: no times
 */
#define _POSIX_C_SOURCE 200809L
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "fmi2FunctionTypes.h"
#include "fmi3FunctionTypes.h"
#include "load.h"
#include "wrc/wrc.h"

enum { inputs = 18, outputs = 6, poses = 40 }; /* as in wheel.def; force and moment */

static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Pose i of a wheel that rolls at 20 m/s, in contact. */
static void pose(int i, double in[inputs]) {
  const double t = i / (double)poses;
  memset(in, 0, inputs * sizeof *in);
  in[0] = 2e-3 * (t - 0.5);
  in[1] = 0.26e-3 + 4e-5 * t;
  in[2] = 1e-4 * t;
  in[3] = 4e-3 * (0.4 - t);
  in[4] = 20.0;
  in[5] = 0.05 * (t - 0.3);
  in[6] = 0.01 * (0.5 - t);
  in[8] = -20.0 / 0.46 * (1.0 + 1e-3 * t);
  in[10] = 1e-3 * t;
  in[14] = 0.02 * t;
  in[16] = 2e-3 * (t - 0.5);
}

static wrc_wheel_input as_struct(const double in[inputs]) {
  wrc_wheel_input input = wrc_wheel_input_default();
  input.wheel.y = in[0], input.wheel.z = in[1], input.wheel.roll = in[2], input.wheel.yaw = in[3];
  memcpy(input.wheel.velocity, in + 4, 3 * sizeof *in);
  input.wheel.roll_rate = in[7], input.wheel.pitch_rate = in[8], input.wheel.yaw_rate = in[9];
  input.rail.y = in[10], input.rail.z = in[11], input.rail.roll = in[12];
  input.rail.y_velocity = in[13], input.rail.z_velocity = in[14], input.rail.roll_rate = in[15];
  input.rail.y_slope = in[16], input.rail.z_slope = in[17];
  return input;
}

static void quiet(fmi2ComponentEnvironment of, fmi2String name, fmi2Status status, fmi2String category,
                  fmi2String text, ...) {
  (void)of, (void)name, (void)status, (void)category, (void)text;
}

/* A library's functions of both standards. */
static struct {
  fmi2InstantiateTYPE* instantiate;
  fmi2SetupExperimentTYPE* setup;
  fmi2EnterInitializationModeTYPE *enter, *exit;
  fmi2FreeInstanceTYPE* free;
  fmi2SetRealTYPE* set;
  fmi2GetRealTYPE* get;
  fmi2GetDirectionalDerivativeTYPE* derivative;
} fmi2;
static struct {
  fmi3InstantiateModelExchangeTYPE* instantiate;
  fmi3EnterInitializationModeTYPE* enter;
  fmi3ExitInitializationModeTYPE* exit;
  fmi3SetFloat64TYPE* set;
  fmi3GetFloat64TYPE* get;
  fmi3FreeInstanceTYPE* free;
} fmi3;

static void find_functions(void* library) {
  find(library, "fmi2Instantiate", &fmi2.instantiate);
  find(library, "fmi2SetupExperiment", &fmi2.setup);
  find(library, "fmi2EnterInitializationMode", &fmi2.enter);
  find(library, "fmi2ExitInitializationMode", &fmi2.exit);
  find(library, "fmi2FreeInstance", &fmi2.free);
  find(library, "fmi2SetReal", &fmi2.set);
  find(library, "fmi2GetReal", &fmi2.get);
  find(library, "fmi2GetDirectionalDerivative", &fmi2.derivative);
  find(library, "fmi3InstantiateModelExchange", &fmi3.instantiate);
  find(library, "fmi3EnterInitializationMode", &fmi3.enter);
  find(library, "fmi3ExitInitializationMode", &fmi3.exit);
  find(library, "fmi3SetFloat64", &fmi3.set);
  find(library, "fmi3GetFloat64", &fmi3.get);
  find(library, "fmi3FreeInstance", &fmi3.free);
}

/* One wheel three times. */
static struct {
  wrc_model* model;
  wrc_contact* contact;
  fmi2Component two;
  fmi3Instance three;
} wheel;
static uint32_t in_number[inputs], out_number[outputs]; /* of the FMUs' variables */

/* 0, or the number of the step that failed. */
static int make_wheel(void) {
  static const fmi2CallbackFunctions callbacks = {quiet, calloc, free, NULL, NULL};
  wheel.two = fmi2.instantiate("two", fmi2ModelExchange, "wrc_wheel 3", "file:///nowhere", &callbacks,
                               fmi2False, fmi2False);
  wheel.three = fmi3.instantiate("three", "wrc_wheel 3", "/nowhere/", false, false, NULL, NULL);
  if (!wheel.two || !wheel.three) return 3;
  if (fmi2.instantiate("other", fmi2ModelExchange, "another", "", &callbacks, fmi2False, fmi2False)) return 4;
  if (fmi2.setup(wheel.two, fmi2False, 0.0, 0.0, fmi2False, 0.0) != fmi2OK ||
      fmi2.enter(wheel.two) != fmi2OK || fmi2.exit(wheel.two) != fmi2OK)
    return 5;
  if (fmi3.enter(wheel.three, false, 0.0, 0.0, false, 0.0) != fmi3OK || fmi3.exit(wheel.three) != fmi3OK)
    return 6;

  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  if (wrc_model_create(&config, NULL, &wheel.model, NULL, 0) < 0 ||
      wrc_contact_create(wheel.model, WRC_SIDE_RIGHT, NULL, &wheel.contact, NULL, 0) < 0)
    return 7;
  for (uint32_t i = 0; i < inputs; ++i) in_number[i] = i;
  for (uint32_t i = 0; i < outputs; ++i) out_number[i] = inputs + i;
  return 0;
}

/* Compares wrenches and a column of derivatives at pose i: 0, or the number of the step that failed. */
static int compare_pose(int i, int* touching, int* differ) {
  static wrc_wrench wrench = {.struct_size = sizeof wrench};
  static wrc_wrench_derivatives slopes = {.struct_size = sizeof slopes};
  double in[inputs], out2[outputs], out3[outputs], direct[outputs], column[outputs];
  pose(i, in);
  const wrc_wheel_input input = as_struct(in);
  if (wrc_contact_wrench(wheel.contact, &input, &wrench) < 0) return 8;
  if (fmi2.set(wheel.two, in_number, inputs, in) != fmi2OK ||
      fmi2.get(wheel.two, out_number, outputs, out2) != fmi2OK)
    return 9;
  if (fmi3.set(wheel.three, in_number, inputs, in, inputs) != fmi3OK ||
      fmi3.get(wheel.three, out_number, outputs, out3, outputs) != fmi3OK)
    return 10;
  memcpy(direct, wrench.force, 3 * sizeof *direct);
  memcpy(direct + 3, wrench.moment, 3 * sizeof *direct);
  *touching += direct[2] < 0.0;
  *differ += memcmp(direct, out2, sizeof direct) != 0 || memcmp(direct, out3, sizeof direct) != 0;

  if (wrc_contact_wrench_derivatives(wheel.contact, &input, &wrench, &slopes) < 0) return 11;
  const double one = 1.0;
  const uint32_t by = (uint32_t)i % inputs;
  if (fmi2.derivative(wheel.two, out_number, outputs, &by, 1, &one, column) != fmi2OK) return 12;
  const uint32_t among = by == 16 ? WRC_BY_RAIL_Y_SLOPE : by == 17 ? WRC_BY_RAIL_Z_SLOPE : by;
  for (int k = 0; k < outputs; ++k) *differ += column[k] != slopes.wrench[k][among];
  if (i % 8 == 0) printf("%.17g %.17g %.17g\n", direct[1], direct[2], direct[5]);
  return 0;
}

/* Time of a step at pose i [s] by one of three ways: C, FMI 2.0, FMI 3.0. FMI keeps what it has solved, so
 * each round moves the pose. */
static double time_of(int i, int way, int round) {
  static wrc_wrench wrench = {.struct_size = sizeof wrench};
  double in[inputs], out[outputs];
  pose(i, in);
  in[0] += 1e-12 * round;
  const double start = seconds();
  if (way == 0) {
    const wrc_wheel_input input = as_struct(in);
    wrc_contact_wrench(wheel.contact, &input, &wrench);
  } else if (way == 1) {
    fmi2.set(wheel.two, in_number, inputs, in);
    fmi2.get(wheel.two, out_number, outputs, out);
  } else {
    fmi3.set(wheel.three, in_number, inputs, in, inputs);
    fmi3.get(wheel.three, out_number, outputs, out, outputs);
  }
  return seconds() - start;
}

/* Does a step through FMI take over 10 % longer? Of each pose and way the least time of all rounds counts, so
 * that what else the machine does drops out. */
static int is_slow(int rounds) {
  double sum[3] = {0.0, 0.0, 0.0};
  for (int i = 0; i < poses; ++i) {
    double least[3] = {1e9, 1e9, 1e9};
    for (int round = 0; round < 3 * rounds; ++round) {
      const double took = time_of(i, round % 3, round);
      if (took < least[round % 3]) least[round % 3] = took;
    }
    for (int way = 0; way < 3; ++way) sum[way] += least[way];
  }
  const double over2 = sum[1] / sum[0] - 1.0, over3 = sum[2] / sum[0] - 1.0;
  printf("a step: C %.1f us, FMI 2.0 %+.1f %%, FMI 3.0 %+.1f %%\n", 1e6 * sum[0] / poses, 100.0 * over2,
         100.0 * over3);
  return over2 > 0.1 || over3 > 0.1;
}

int main(int count, char** words) {
  if (count < 2) return 2;
  find_functions(load(words[1]));
  int failed = make_wheel(), differ = 0, touching = 0;
  for (int i = 0; i < poses && !failed; ++i) failed = compare_pose(i, &touching, &differ);
  if (failed) return failed;
  double values[2] = {1.0, 1.0};
  const uint32_t lateral = 0;
  if (fmi2.set(wheel.two, &lateral, 1, values) != fmi2OK ||
      fmi2.get(wheel.two, out_number, outputs, values) != fmi2Discard) {
    printf("1 m to the side was not discarded\n");
    ++differ;
  }
  printf("%d poses, %d with contact, %d differ\n", poses, touching, differ);
  const int rounds = count > 2 ? atoi(words[2]) : 40;
  const int slow = rounds > 0 && is_slow(rounds);
  fmi2.free(wheel.two);
  fmi3.free(wheel.three);
  wrc_contact_destroy(wheel.contact);
  wrc_model_destroy(wheel.model);
  return differ || touching < poses / 2 || slow;
}
