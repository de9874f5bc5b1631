/* A wheelset that brakes to a stop, is parked on a slope, starts and rolls backwards: contact that remembers.
 *
 *     build/release/examples_c/parked_wheelset [seconds parked, 60]
 *
 * Steps of 10 ms by the implicit Euler method. Each is solved by Newton's method with a Jacobian by
 * differences, whose trial calls leave no trace; the step that is accepted is committed. The brake is a
 * torque between axle and frame with friction of its own: it slides, or holds the axle. The program prints
 * the forces and how far the wheelset has crept while it was parked, and fails where that is 1 um in an hour
 * or more, or where it chatters after the stop.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "wrc/wrc.h"

static const double mass = 10e3,
                    inertia = 120.0; /* share of a vehicle [kg], wheelset about its axle [kg m^2] */
static const double load = 50e3, radius = 0.46; /* of a wheel [N], [m] */
static const double gravity = 9.81, dt = 10e-3; /* [m/s^2], [s] */

typedef struct wheelset {
  wrc_contact* contact; /* of the right wheel; the left one is its mirror image */
  wrc_wheel_input input;
  double v, spin, x;   /* speed [m/s], about the axle [rad/s], way [m] */
  double slope, brake; /* of the track; torque of the brake where it slides [N m] */
  double force;        /* of both wheels along the track [N] */
  long calls;
} wheelset;

static void fail(const wheelset* w, const char* what) {
  char why[300] = "";
  if (w && w->contact) wrc_contact_last_error(w->contact, why, sizeof why);
  fprintf(stderr, "%s: %s\n", what, why);
  exit(1);
}

/* Force along the track and torque about the axle, of both wheels, at the end of a step with these speeds: a
 * trial. */
static void contact_forces(wheelset* w, double v, double spin, double* force, double* torque) {
  wrc_wrench wrench = {.struct_size = sizeof wrench};
  w->input.wheel.velocity[0] = v;
  w->input.wheel.pitch_rate = spin;
  w->input.time_step = dt;
  if (wrc_contact_wrench(w->contact, &w->input, &wrench) < 0) fail(w, "wrench");
  ++w->calls;
  *force = 2.0 * wrench.force[0];
  *torque = 2.0 * wrench.moment[1];
}

/* Residuals of the equations of motion of a step, over dt: m/s and rad/s. `held`: the brake holds the axle.
 */
static void residual(wheelset* w, double v, double spin, int held, double torque, double r[2]) {
  double force, moment;
  contact_forces(w, v, spin, &force, &moment);
  w->force = force;
  r[0] = v - w->v - dt / mass * (force - mass * gravity * w->slope);
  r[1] = held ? spin : spin - w->spin - dt / inertia * (moment + torque);
}

/* Solves a step for the speeds at its end; the last trial is that of the solution. */
static void solve_step(wheelset* w, int held, double torque, double* v, double* spin) {
  double r[2];
  *v = w->v;
  *spin = held ? 0.0 : w->spin;
  residual(w, *v, *spin, held, torque, r);
  for (int iteration = 0; iteration < 40; ++iteration) {
    /* Jacobian by differences of trials */
    const double small = 1e-8;
    double by_v[2], by_spin[2], next[2];
    residual(w, *v + small, *spin, held, torque, by_v);
    residual(w, *v, *spin + small / radius, held, torque, by_spin);
    for (int i = 0; i < 2; ++i) {
      by_v[i] = (by_v[i] - r[i]) / small;
      by_spin[i] = (by_spin[i] - r[i]) / (small / radius);
    }
    const double determinant = by_v[0] * by_spin[1] - by_v[1] * by_spin[0];
    const double dv = -(r[0] * by_spin[1] - r[1] * by_spin[0]) / determinant;
    const double dspin = -(by_v[0] * r[1] - by_v[1] * r[0]) / determinant;
    /* half as far where it is no better */
    const double before = hypot(r[0], radius * r[1]);
    double part = 1.0;
    for (int k = 0; k < 8; ++k, part *= 0.5) {
      residual(w, *v + part * dv, *spin + part * dspin, held, torque, next);
      if (hypot(next[0], radius * next[1]) < before) break;
    }
    *v += part * dv;
    *spin += part * dspin;
    memcpy(r, next, sizeof r);
    if (hypot(r[0], radius * r[1]) < 1e-13) break;
  }
}

static void step(wheelset* w) {
  double v, spin;
  int held = w->spin == 0.0 && w->brake > 0.0;
  if (!held) {
    const double torque = w->spin > 0.0 ? -w->brake : w->brake;
    solve_step(w, 0, torque, &v, &spin);
    held = w->brake > 0.0 && spin * w->spin <= 0.0; /* it stops within the step */
  }
  if (held) {
    double force, moment;
    solve_step(w, 1, 0.0, &v, &spin);
    contact_forces(w, v, spin, &force, &moment);
    if (fabs(moment + inertia * w->spin / dt) > w->brake)
      solve_step(w, 0, moment > 0.0 ? -w->brake : w->brake, &v, &spin);
  }
  if (wrc_contact_commit(w->contact) < 0) fail(w, "commit");
  w->x += dt * v;
  w->v = v;
  w->spin = held ? 0.0 : spin;
}

static void show(const wheelset* w, const char* what) {
  printf("%-34s v %9.6f m/s  axle %9.6f rad/s  x %12.9f m  force %9.2f N\n", what, w->v, w->spin, w->x,
         w->force);
}

static void run(wheelset* w, double seconds, double slope, double brake) {
  w->slope = slope;
  w->brake = brake;
  const long steps = (long)(seconds / dt + 0.5);
  for (long i = 0; i < steps; ++i) step(w);
}

int main(int argc, char** argv) {
  const double parked = argc > 1 ? atof(argv[1]) : 60.0;
  char why[300] = "";
  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_60E1;
  config.track.rail_inclination = 1.0 / 40.0;
  config.surface.memory = 1;
  wrc_model* model = NULL;
  wheelset w = {0};
  if (wrc_model_create(&config, NULL, &model, why, sizeof why) < 0 ||
      wrc_contact_create(model, WRC_SIDE_RIGHT, NULL, &w.contact, why, sizeof why) < 0) {
    fprintf(stderr, "%s\n", why);
    return 1;
  }
  /* the height under the load, and the contact without tractions */
  wrc_wrench wrench = {.struct_size = sizeof wrench};
  w.input = wrc_wheel_input_default();
  w.input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  w.input.vertical_load = load;
  if (wrc_contact_wrench(w.contact, &w.input, &wrench) < 0) fail(&w, "height");
  w.input.prescribed = WRC_PRESCRIBE_HEIGHT;
  w.input.vertical_load = 0.0;
  w.input.wheel.z = wrench.z;
  if (wrc_contact_wrench(w.contact, &w.input, &wrench) < 0 || wrc_contact_commit(w.contact) < 0)
    fail(&w, "start");

  w.v = 2.0;
  w.spin = -w.v / radius;
  run(&w, 2.0, 0.0, 0.0);
  show(&w, "rolls, 2 s");
  run(&w, 6.0, 0.0, 3e3);
  show(&w, "brakes to a stop, 6 s");

  /* after the stop the body swings on the contacts' elasticity and comes to rest */
  int turns = 0;
  for (int i = 0; i < 100; ++i) {
    const double before = w.v;
    run(&w, dt, 0.0, 3e3);
    turns += before * w.v < 0.0 && fabs(w.v) > 1e-9;
  }
  printf("turns of the speed in the next second: %d\n", turns);
  run(&w, 1.0, 0.02, 3e3);
  show(&w, "parked on 20 per mille, after 1 s");
  const double from = w.x;
  run(&w, parked, 0.02, 3e3);
  show(&w, "the same later");
  const double drift = fabs(w.x - from);
  printf("crept %.3g um in %g s\n", 1e6 * drift, parked);
  run(&w, 3.0, 0.02, 0.0);
  show(&w, "brake released, 3 s");
  run(&w, 8.0, 0.02, 3e3);
  show(&w, "braked again, 8 s");
  printf("%ld calls\n", w.calls);
  wrc_contact_destroy(w.contact);
  wrc_model_destroy(model);
  return drift < 1e-6 * (parked > 3600.0 ? parked / 3600.0 : 1.0) && turns < 5 ? 0 : 1;
}
