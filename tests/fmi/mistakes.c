/* Answers of the FMUs to mistakes, and after them.
 *
 *   mistakes wrc_fmu.so     exit status 1 if an answer is not as it should be
 */
#include <math.h>

#include "fmi3FunctionTypes.h"
#include "load.h"
#include "model.h"

static fmi3InstantiateCoSimulationTYPE* instantiate_set;
static fmi3InstantiateModelExchangeTYPE* instantiate_wheel;
static fmi3EnterInitializationModeTYPE* enter;
static fmi3ExitInitializationModeTYPE* leave;
static fmi3SetFloat64TYPE* set_many;
static fmi3GetFloat64TYPE* get_many;
static fmi3GetInt32TYPE* get_integers;
static fmi3DoStepTYPE* do_step;
static fmi3GetFMUStateTYPE* get_state;
static fmi3SerializeFMUStateTYPE* serialise;
static fmi3DeserializeFMUStateTYPE* deserialise;
static fmi3FreeFMUStateTYPE* free_state;
static fmi3FreeInstanceTYPE* release;

static char last[1024];
static int wrong;

static void told(fmi3InstanceEnvironment of, fmi3Status status, fmi3String category, fmi3String sentence) {
  (void)of, (void)status, (void)category;
  snprintf(last, sizeof last, "%s", sentence);
}

static void check(int holds, const char* claim) {
  if (holds) return;
  printf("WRONG: %s. Told last: %s\n", claim, last);
  ++wrong;
}

static fmi3Status set(fmi3Instance of, uint32_t number, double value) {
  return set_many(of, &number, 1, &value, 1);
}
static double get(fmi3Instance of, uint32_t number) {
  double value = -777.0;
  return get_many(of, &number, 1, &value, 1) == fmi3OK ? value : -777.0;
}
static fmi3Status step(fmi3Instance of, double time, double length) {
  bool event, end, early;
  double reached;
  return do_step(of, time, length, true, &event, &end, &early, &reached);
}
static fmi3Instance new_set(void) {
  return instantiate_set("set", "wrc_wheelset 6", "", false, true, false, false, NULL, 0, NULL, told, NULL);
}
static fmi3Instance new_wheel(void) {
  return instantiate_wheel("wheel", "wrc_wheel 3", "", false, true, NULL, told);
}
static fmi3Status start(fmi3Instance of) {
  const fmi3Status entered = enter(of, false, 0.0, 0.0, false, 0.0), left = leave(of);
  return entered > left ? entered : left;
}

/* Numbers that are no input, parameters out of their ranges, outputs that are set. */
static void values(void) {
  fmi3Instance of = new_set();
  check(set(of, SET_mass, -1.0) == fmi3Error && strstr(last, "mass = -1: allowed are 1 to"),
        "a negative mass is an error");
  check(start(of) == fmi3OK, "it starts after a refused value");
  check(set(of, SET_force_y, NAN) == fmi3Error && strstr(last, "force_y"), "NaN as an input is an error");
  check(get(of, SET_force_y) == 0.0, "a refused value is not taken");
  check(set(of, SET_friction, -1.0) == fmi3Error, "a negative friction is an error");
  check(set(of, SET_y, 1e-3) == fmi3Error && strstr(last, "computed"), "an output cannot be set");
  check(set(of, SET_mass, 1600.0) == fmi3Error, "a fixed parameter cannot be changed later");
  check(step(of, 7.0, 1e-3) == fmi3Error && strstr(last, "7 s"), "a step elsewhere in time is an error");
  check(step(of, 0.0, NAN) == fmi3Error && step(of, 0.0, 0.0) == fmi3Error,
        "a step without a length is an error");
  check(set(of, SET_right_rail_y, 5.0) == fmi3OK && step(of, 0.0, 1e-3) == fmi3Error,
        "a rail 5 m aside is an error");
  check(set(of, SET_right_rail_y, 0.0) == fmi3OK && step(of, 0.0, 1e-3) == fmi3OK,
        "it goes on after all that");
  release(of);
}

/* A step that cannot be done leaves all as it was; a shorter one may be done. */
static void discarded(void) {
  fmi3Instance of = new_set();
  check(start(of) == fmi3OK && step(of, 0.0, 1e-3) == fmi3OK, "a first step");
  const double y = get(of, SET_y), fz = get(of, SET_right_fz), power = get(of, SET_power);
  set(of, SET_force_y, 3e6); /* lifts it over the flange and off the track */
  check(step(of, 1e-3, 0.5) == fmi3Discard && strlen(last) > 20,
        "off the track is a discarded step with a sentence");
  check(get(of, SET_y) == y && get(of, SET_right_fz) == fz && get(of, SET_power) == power,
        "outputs are those before it");
  const uint32_t flags = FIRST_INTEGER + SET_flags;
  int32_t value = -1;
  check(get_integers(of, &flags, 1, &value, 1) == fmi3OK && value >= 0, "flags can be read after it");
  check(step(of, 1e-3, 1e-4) == fmi3OK && get(of, SET_y) > y, "a shorter step can be done");
  release(of);
}

/* Bytes that hold no state. */
static void states(void) {
  fmi3Instance of = new_set();
  check(start(of) == fmi3OK, "start");
  fmi3FMUState state = NULL, other = NULL;
  saved bytes;
  get_state(of, &state);
  check(serialise(of, state, (fmi3Byte*)&bytes, sizeof bytes) == fmi3OK, "a state is serialised");
  check(deserialise(of, (const fmi3Byte*)&bytes, sizeof bytes, &other) == fmi3OK, "and read");
  free_state(of, &other);
  const saved good = bytes;
  bytes.now.real[SET_yaw_rate] = NAN;
  check(deserialise(of, (const fmi3Byte*)&bytes, sizeof bytes, &other) == fmi3Error && strstr(last, "state"),
        "NaN is none");
  bytes = good;
  bytes.now.real[SET_mass] = 0.0;
  check(deserialise(of, (const fmi3Byte*)&bytes, sizeof bytes, &other) == fmi3Error, "nor is a mass of 0");
  bytes = good;
  bytes.mark[4] = 'x';
  check(deserialise(of, (const fmi3Byte*)&bytes, sizeof bytes, &other) == fmi3Error,
        "nor one of another FMU");
  free_state(of, &state);
  release(of);
}

/* A host that ignores a failed start sees NaN. */
static void failed_start(void) {
  fmi3Instance of = new_set();
  set(of, SET_gauge, 17.0);
  check(start(of) == fmi3Error && strstr(last, "gauge"), "a gauge of 17 m is an error with a sentence");
  check(isnan(get(of, SET_y)) && isnan(get(of, SET_right_fz)), "outputs are NaN");
  check(step(of, 0.0, 1e-3) == fmi3Error, "it makes no step");
  release(of);
}

/* A wheel: the height under a load, and what is an attempt of an integrator. */
static void wheel(void) {
  fmi3Instance of = new_wheel();
  set(of, WHEEL_load, 80e3);
  check(start(of) == fmi3OK, "a wheel starts");
  const double z = get(of, WHEEL_standing_z);
  set(of, WHEEL_z, z);
  set(of, WHEEL_vx, 20.0);
  set(of, WHEEL_pitch_rate, -20.0 / 0.46);
  check(fabs(get(of, WHEEL_fz) + 80e3) < 1.0, "it carries the load at standing_z");
  set(of, WHEEL_y, 1.0);
  double value;
  const uint32_t fz = WHEEL_fz;
  check(get_many(of, &fz, 1, &value, 1) == fmi3Discard, "1 m to the side is an attempt");
  check(set(of, WHEEL_y, NAN) == fmi3Error && set(of, WHEEL_friction, -1.0) == fmi3Error,
        "NaN and friction < 0 are errors");
  set(of, WHEEL_y, 0.0);
  check(fabs(get(of, WHEEL_fz) + 80e3) < 1.0, "it goes on after all that");
  release(of);
}

int main(int count, char** words) {
  if (count < 2) return 2;
  void* library = load(words[1]);
  find(library, "fmi3InstantiateCoSimulation", &instantiate_set);
  find(library, "fmi3InstantiateModelExchange", &instantiate_wheel);
  find(library, "fmi3EnterInitializationMode", &enter);
  find(library, "fmi3ExitInitializationMode", &leave);
  find(library, "fmi3SetFloat64", &set_many);
  find(library, "fmi3GetFloat64", &get_many);
  find(library, "fmi3GetInt32", &get_integers);
  find(library, "fmi3DoStep", &do_step);
  find(library, "fmi3GetFMUState", &get_state);
  find(library, "fmi3SerializeFMUState", &serialise);
  find(library, "fmi3DeserializeFMUState", &deserialise);
  find(library, "fmi3FreeFMUState", &free_state);
  find(library, "fmi3FreeInstance", &release);
  values();
  discarded();
  states();
  failed_start();
  wheel();
  printf("%d answers are not as they should be\n", wrong);
  return wrong != 0;
}
