/* The FMU wrc_wheelset beside an independent integration: the classical Runge-Kutta scheme with steps far
 * below its limit, over the C interface. From 0.1 to 100 m/s, 60 to 1500 kg m^2.
 *
 *   fmi_wheelset_motion wrc_fmu.so [CASE]     exit status 1 if the motion, forces or power differ
 */
#include <math.h>

#include "model.h"
#include "wheelset_fmu.h"

enum { places = 4, rates = 5, states = places + rates };

typedef struct trial {
  const char* name;
  double speed, load, mass, axle, radius; /* m/s, N, kg, kg m^2, m */
  double y, yaw, time;                    /* at the beginning [m, rad]; how long [s] */
  double rail_slope;                      /* of the right rail, dy/dx [-] */
  double allowed; /* difference of y and z [m]; blows of flanges make much of little */
} trial;

static const trial trials[] = {
    {"default", 5.0, 120e3, 1500.0, 110.0, 0.46, 1e-3, 0.0, 0.5, 0.0, 2e-7},
    {"2 m/s", 2.0, 120e3, 1500.0, 110.0, 0.46, 1e-3, 0.0, 0.5, 0.0, 2e-7},
    {"0.5 m/s", 0.5, 120e3, 1500.0, 110.0, 0.46, 1e-3, 4e-3, 0.1, 0.0, 1e-6},
    {"0.1 m/s, light", 0.1, 120e3, 1000.0, 60.0, 0.46, 1e-3, 4e-3, 0.02, 1e-3, 1e-6},
    {"160 kN, 60 kg m2", 5.0, 160e3, 1500.0, 60.0, 0.46, 1e-3, 0.0, 0.6, 0.0, 2e-7},
    {"220 kN, 0.5 m", 5.0, 220e3, 1800.0, 110.0, 0.5, 1e-3, 0.0, 0.4, 0.0, 2e-7},
    {"20 m/s, flanges", 20.0, 120e3, 1500.0, 110.0, 0.46, 5e-3, 4e-3, 0.3, 0.0, 2e-5},
    {"50 m/s, driven axle", 50.0, 200e3, 2500.0, 1500.0, 0.46, 1e-3, 0.0, 0.3, 0.0, 2e-6},
    {"100 m/s", 100.0, 120e3, 1500.0, 110.0, 0.46, 1e-3, 0.0, 0.1, 0.0, 2e-6},
    {"100 m/s, driven axle, a rail leads aside", 100.0, 120e3, 2500.0, 1500.0, 0.46, 1e-3, 1e-3, 0.1, -1e-3,
     2e-5},
};

/* -------------------------------------------------------------------------------------- independent
 * integration */

typedef struct reference {
  const trial* of;
  wrc_contact* contact[2];
  wrc_wheel_input input;
  double fy[2], power;
} reference;

static void give(reference* set, const double u[states]) {
  wrc_wheel_state* wheel = &set->input.wheel;
  wheel->y = u[0], wheel->z = u[1], wheel->roll = u[2], wheel->yaw = u[3];
  wheel->velocity[0] = set->of->speed, wheel->velocity[1] = u[4], wheel->velocity[2] = u[5];
  wheel->roll_rate = u[6], wheel->yaw_rate = u[7], wheel->pitch_rate = u[8];
}

static void motion(reference* set, const double u[states], double f[states]) {
  const trial* of = set->of;
  const double across = 900.0;
  double force[3] = {0.0, 0.0, of->load}, moment[3] = {0.0, 0.0, 0.0};
  set->power = 0.0;
  give(set, u);
  for (int side = 0; side < 2; ++side) {
    wrc_wrench wrench = {.struct_size = sizeof wrench};
    set->input.rail.y_slope = side == WRC_SIDE_RIGHT ? of->rail_slope : 0.0;
    if (wrc_contact_wrench(set->contact[side], &set->input, &wrench) < 0)
      stop("a wrench of the reference failed");
    for (int i = 0; i < 3; ++i) {
      force[i] += wrench.force[i];
      moment[i] += wrench.moment[i];
    }
    set->fy[side] = wrench.force[1];
    set->power += wrench.power;
  }
  for (int i = 0; i < places; ++i) f[i] = u[places + i];
  f[4] = force[1] / of->mass;
  f[5] = force[2] / of->mass;
  f[6] = (moment[0] + of->axle * u[8] * u[7]) / across;
  f[7] = (moment[2] - of->axle * u[8] * u[6]) / across;
  f[8] = moment[1] / of->axle;
}

/* The damping rate of pitch [1/s], the fastest there is: f r^2 / (V I) of both wheels. */
static double fastest(reference* set, const double u[states]) {
  static wrc_wrench_derivatives slopes = {.struct_size = sizeof slopes};
  double rate = 0.0;
  give(set, u);
  for (int side = 0; side < 2; ++side) {
    wrc_wrench wrench = {.struct_size = sizeof wrench};
    if (wrc_contact_wrench_derivatives(set->contact[side], &set->input, &wrench, &slopes) < 0)
      stop("no derivatives");
    rate -= slopes.wrench[4][WRC_BY_ANGULAR_VELOCITY_Y] / set->of->axle;
  }
  return rate;
}

static void integrate(reference* set, double u[states]) {
  const double limit = fmin(1.0 / fastest(set, u), 5e-5);
  const long count = (long)ceil(set->of->time / limit);
  const double step = set->of->time / (double)count;
  for (long n = 0; n < count; ++n) {
    static const double ahead[4] = {0.0, 0.5, 0.5, 1.0}, weight[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    double f[states] = {0.0}, sum[states] = {0.0};
    for (int stage = 0; stage < 4; ++stage) {
      double at[states];
      for (int i = 0; i < states; ++i) at[i] = u[i] + ahead[stage] * step * f[i];
      motion(set, at, f);
      for (int i = 0; i < states; ++i) sum[i] += weight[stage] * f[i];
    }
    for (int i = 0; i < states; ++i) u[i] += step * sum[i];
  }
  double f[states];
  motion(set, u, f);
}

/* ------------------------------------------------------------------------------------------------------ FMU
 */

static void run_fmu(const functions* fmu, const trial* of, double u[states], double result[3],
                    double start[states]) {
  fmi3Instance set = new_wheelset(fmu);
  const uint32_t numbers[] = {SET_speed,        SET_load,    SET_mass,      SET_inertia_about_axle,
                              SET_wheel_radius, SET_start_y, SET_start_yaw, SET_right_rail_y_slope};
  const double values[] = {of->speed,  of->load, of->mass, of->axle,
                           of->radius, of->y,    of->yaw,  of->rail_slope};
  if (!set || fmu->set(set, numbers, 8, values, 8) != fmi3OK ||
      fmu->enter(set, false, 0.0, 0.0, false, 0.0) != fmi3OK || fmu->leave(set) != fmi3OK)
    stop("the FMU does not start");
  uint32_t state_numbers[states];
  for (uint32_t i = 0; i < states; ++i) state_numbers[i] = SET_y + i;
  fmu->get(set, state_numbers, states, start, states);
  const int count = (int)ceil(of->time / 1e-3 - 1e-9);
  for (int n = 0; n < count; ++n) {
    bool event, end, early;
    double last;
    if (fmu->step(set, n * of->time / count, of->time / count, true, &event, &end, &early, &last) != fmi3OK)
      stop("a step of the FMU failed");
  }
  const uint32_t result_numbers[] = {SET_right_fy, SET_left_fy, SET_power};
  if (fmu->get(set, state_numbers, states, u, states) != fmi3OK ||
      fmu->get(set, result_numbers, 3, result, 3) != fmi3OK)
    stop("outputs cannot be read");
  fmu->release(set);
}

/* 1 if a number of the FMU is farther from the reference than `allowed`. */
static int differs(const char* name, double scale, double fmu, double fine, double allowed) {
  const int far = !(fabs(fmu - fine) <= allowed);
  printf("  %s %.5g (%.5g)%s", name, scale * fmu, scale * fine, far ? " WRONG" : "");
  return far;
}

int main(int count, char** words) {
  if (count < 2) return 2;
  const functions fmu = functions_of(load(words[1]));
  int wrong = 0;
  const int all = (int)(sizeof trials / sizeof *trials), only = count > 2 ? atoi(words[2]) : -1;
  for (int i = 0; i < all; ++i) {
    if (only >= 0 && i != only) continue;
    const trial* of = &trials[i];
    wrc_config config = wrc_config_default();
    config.wheel.kind = WRC_PROFILE_S1002;
    config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
    config.wheelset.wheel_radius = of->radius;
    wrc_model* model = NULL;
    reference set = {.of = of, .input = wrc_wheel_input_default()};
    set.input.damping = 0.3;
    if (wrc_model_create(&config, NULL, &model, NULL, 0) < 0) stop("no model");
    for (int side = 0; side < 2; ++side)
      if (wrc_contact_create(model, side, NULL, &set.contact[side], NULL, 0) < 0) stop("no contact");
    double u[states], fine[states], result[3];
    run_fmu(&fmu, of, u, result, fine);
    integrate(&set, fine);
    const double forces = of->load; /* in whose parts forces are compared */
    printf("%s, %g s:", of->name, of->time);
    wrong += differs("y mm", 1e3, u[0], fine[0], of->allowed);
    wrong += differs("z mm", 1e3, u[1], fine[1], of->allowed);
    wrong += differs("yaw mrad", 1e3, u[3], fine[3], 1e-5);
    wrong += differs("pitch rate rad/s", 1.0, u[8], fine[8], 1e-5 * fabs(fine[8]));
    wrong += differs("right fy kN", 1e-3, result[0], set.fy[0], 5e-3 * forces);
    wrong += differs("left fy kN", 1e-3, result[1], set.fy[1], 5e-3 * forces);
    wrong += differs("power W", 1.0, result[2], set.power, 0.02 * set.power + 0.1);
    printf("\n");
    fflush(stdout);
    for (int side = 0; side < 2; ++side) wrc_contact_destroy(set.contact[side]);
    wrc_model_destroy(model);
  }
  printf("%d numbers differ\n", wrong);
  return wrong != 0;
}
