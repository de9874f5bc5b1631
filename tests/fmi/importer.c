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

int main(int count, char** words) {
  if (count < 2) return 2;
  void* library = load(words[1]);
  fmi2InstantiateTYPE* instantiate2;
  fmi2SetupExperimentTYPE* setup2;
  fmi2EnterInitializationModeTYPE *enter2, *exit2, *free2;
  fmi2SetRealTYPE* set2;
  fmi2GetRealTYPE* get2;
  fmi2GetDirectionalDerivativeTYPE* derivative2;
  fmi3InstantiateModelExchangeTYPE* instantiate3;
  fmi3EnterInitializationModeTYPE* enter3;
  fmi3ExitInitializationModeTYPE* exit3;
  fmi3SetFloat64TYPE* set3;
  fmi3GetFloat64TYPE* get3;
  find(library, "fmi2Instantiate", &instantiate2);
  find(library, "fmi2SetupExperiment", &setup2);
  find(library, "fmi2EnterInitializationMode", &enter2);
  find(library, "fmi2ExitInitializationMode", &exit2);
  find(library, "fmi2FreeInstance", &free2);
  find(library, "fmi2SetReal", &set2);
  find(library, "fmi2GetReal", &get2);
  find(library, "fmi2GetDirectionalDerivative", &derivative2);
  find(library, "fmi3InstantiateModelExchange", &instantiate3);
  find(library, "fmi3EnterInitializationMode", &enter3);
  find(library, "fmi3ExitInitializationMode", &exit3);
  find(library, "fmi3SetFloat64", &set3);
  find(library, "fmi3GetFloat64", &get3);

  const fmi2CallbackFunctions callbacks = {quiet, calloc, free, NULL, NULL};
  fmi2Component two = instantiate2("two", fmi2ModelExchange, "wrc_wheel 3", "file:///nowhere", &callbacks,
                                   fmi2False, fmi2False);
  fmi3Instance three = instantiate3("three", "wrc_wheel 3", "/nowhere/", false, false, NULL, NULL);
  if (!two || !three) return 3;
  if (instantiate2("other", fmi2ModelExchange, "another", "", &callbacks, fmi2False, fmi2False)) return 4;
  if (setup2(two, fmi2False, 0.0, 0.0, fmi2False, 0.0) != fmi2OK || enter2(two) != fmi2OK ||
      exit2(two) != fmi2OK)
    return 5;
  if (enter3(three, false, 0.0, 0.0, false, 0.0) != fmi3OK || exit3(three) != fmi3OK) return 6;

  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  wrc_model* model = NULL;
  wrc_contact* contact = NULL;
  if (wrc_model_create(&config, NULL, &model, NULL, 0) < 0 ||
      wrc_contact_create(model, WRC_SIDE_RIGHT, NULL, &contact, NULL, 0) < 0)
    return 7;

  uint32_t in_number[inputs], out_number[outputs];
  for (uint32_t i = 0; i < inputs; ++i) in_number[i] = i;
  for (uint32_t i = 0; i < outputs; ++i) out_number[i] = inputs + i;
  int differ = 0, touching = 0;
  wrc_wrench wrench = {.struct_size = sizeof wrench};
  static wrc_wrench_derivatives slopes = {.struct_size = sizeof slopes};
  for (int i = 0; i < poses; ++i) {
    double in[inputs], out2[outputs], out3[outputs], column[outputs];
    pose(i, in);
    const wrc_wheel_input input = as_struct(in);
    if (wrc_contact_wrench(contact, &input, &wrench) < 0) return 8;
    if (set2(two, in_number, inputs, in) != fmi2OK || get2(two, out_number, outputs, out2) != fmi2OK)
      return 9;
    if (set3(three, in_number, inputs, in, inputs) != fmi3OK ||
        get3(three, out_number, outputs, out3, outputs) != fmi3OK)
      return 10;
    double direct[outputs];
    memcpy(direct, wrench.force, 3 * sizeof *direct);
    memcpy(direct + 3, wrench.moment, 3 * sizeof *direct);
    touching += direct[2] < 0.0;
    differ += memcmp(direct, out2, sizeof direct) != 0 || memcmp(direct, out3, sizeof direct) != 0;
    if (wrc_contact_wrench_derivatives(contact, &input, &wrench, &slopes) < 0) return 11;
    const double one = 1.0;
    const uint32_t by = (uint32_t)i % inputs;
    if (derivative2(two, out_number, outputs, &by, 1, &one, column) != fmi2OK) return 12;
    const uint32_t among = by == 16 ? WRC_BY_RAIL_Y_SLOPE : by == 17 ? WRC_BY_RAIL_Z_SLOPE : by;
    for (int k = 0; k < outputs; ++k) differ += column[k] != slopes.wrench[k][among];
    if (i % 8 == 0) printf("%.17g %.17g %.17g\n", direct[1], direct[2], direct[5]);
  }
  double values[2] = {1.0, 1.0};
  const uint32_t lateral = 0;
  if (set2(two, &lateral, 1, values) != fmi2OK || get2(two, out_number, outputs, values) != fmi2Discard) {
    printf("1 m to the side was not discarded\n");
    ++differ;
  }
  printf("%d poses, %d with contact, %d differ\n", poses, touching, differ);

  /* Times: of each pose and way the least of all rounds, so that what else the machine does drops out. */
  const int rounds = count > 2 ? atoi(words[2]) : 40;
  static double least[poses][3];
  double sum[3] = {0.0, 0.0, 0.0}, out[outputs];
  for (int i = 0; i < poses && rounds > 0; ++i) {
    for (int way = 0; way < 3; ++way) least[i][way] = 1e9;
    for (int round = 0; round < 3 * rounds; ++round) {
      const int way = round % 3;
      double in[inputs];
      pose(i, in);
      in[0] += 1e-12 * round; /* FMI keeps what it has solved */
      const double start = seconds();
      if (way == 0) {
        const wrc_wheel_input input = as_struct(in);
        wrc_contact_wrench(contact, &input, &wrench);
      } else if (way == 1) {
        set2(two, in_number, inputs, in);
        get2(two, out_number, outputs, out);
      } else {
        set3(three, in_number, inputs, in, inputs);
        get3(three, out_number, outputs, out, outputs);
      }
      const double took = seconds() - start;
      if (took < least[i][way]) least[i][way] = took;
    }
    for (int way = 0; way < 3; ++way) sum[way] += least[i][way];
  }
  int slow = 0;
  if (rounds > 0) {
    const double over2 = sum[1] / sum[0] - 1.0, over3 = sum[2] / sum[0] - 1.0;
    printf("a step: C %.1f us, FMI 2.0 %+.1f %%, FMI 3.0 %+.1f %%\n", 1e6 * sum[0] / poses, 100.0 * over2,
           100.0 * over3);
    slow = over2 > 0.1 || over3 > 0.1;
  }
  free2(two);
  free2(three);
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
  return differ || touching < poses / 2 || slow;
}
