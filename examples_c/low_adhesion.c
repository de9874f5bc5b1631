/* low_adhesion.c - wheels that change the rail: four stories of films on rail and wheel, at 1 ms steps.
 *
 *   low_adhesion stop FILE [km/h [cars]] [sand]   cars of four axles stop on wet leaves with slide protection; from
 *                                          160, four cars
 *   low_adhesion traction FILE             a locomotive of four axles looks for the slip with most adhesion
 *   low_adhesion start FILE [sand]         a freight locomotive of six axles starts 1100 t on damp, oxidised rails
 *   low_adhesion curve FILE                creep curve on a roller rig, slip up and down twice
 *
 * FILE gets a table of lines for draw_low_adhesion.py; totals are printed. Left and right are alike: one
 * wheel of each axle is computed, on one rail. Sanders stand 0.3 m before their axles. Where wheels spin at a
 * crawl they clean the length of their contact: bins of the start are 5 mm long. Constants are those of the
 * set "low adhesion", which is unconfirmed. Brakes, sanders and controls are simple stand-ins. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "wrc/wrc_surface.h"

enum { AXLES = 16, WHEEL_BINS = 24 };

static const double dt = 1e-3, radius = 0.46, gravity = 9.81, pi = 3.14159265358979;
static const double sander = 0.3; /* before its axle [m] */

typedef struct axle {
  wrc_contact* contact;
  wrc_surface tread;
  wrc_surface_bin bins[WHEEL_BINS];
  double behind;  /* the front of the train [m] */
  double turning; /* speed of the tread, radius times angular velocity [m/s] */
  double arc;     /* rolled round the wheel [m] */
  double force;   /* of one wheel, forwards [N] */
  double energy;  /* frictional, of one wheel [J] */
  double moved;   /* force times way, of one wheel [J] */
  double torque;  /* share of the full one that brake or motor gives, 0..1 */
} axle;

typedef struct train {
  wrc_model* model;
  wrc_surface_laws laws;
  wrc_surface rail;
  wrc_friction dry;
  wrc_wheel_input input;
  axle axles[AXLES];
  int count;
  double mass, inertia;      /* of all [kg]; of a wheelset about its axle [kg m^2] */
  double full_torque;        /* of an axle; < 0 brakes [N m] */
  double speed, place, time; /* [m/s, m, s] */
} train;

static char why[400];

static void check(int32_t status, const char* call) {
  if (status >= 0) return;
  fprintf(stderr, "%s: %s %s\n", call, wrc_status_name(status), why);
  exit(EXIT_FAILURE);
}

static void contact_done(const wrc_contact* contact, int32_t status, const char* call) {
  if (status < 0) wrc_contact_last_error(contact, why, sizeof why);
  check(status, call);
}

/* Clean bins so long [m] on the rail from one place to another [m]. */
static void make_rail(train* of, double length, double from, double to) {
  of->rail = wrc_surface_default();
  of->rail.count = (uint32_t)ceil((to - from) / length);
  of->rail.length = length;
  of->rail.first = from;
  of->rail.bins = calloc(of->rail.count, sizeof of->rail.bins[0]);
  of->rail.bin_size = sizeof of->rail.bins[0];
  check(of->rail.bins ? WRC_OK : WRC_ERROR_MEMORY, "bins of the rail");
}

/* S1002 on 60E1 at "real time", a contact and a clean tread for each axle, and the height that carries the
 * load. */
static void make_train(train* of, int count, double axle_load) {
  wrc_config config = wrc_config_default();
  memset(of, 0, sizeof *of);
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_60E1;
  config.track.rail_inclination = 1.0 / 40.0;
  check(wrc_config_use(&config, "real time", why, sizeof why), "wrc_config_use");
  check(wrc_model_create(&config, NULL, &of->model, why, sizeof why), "wrc_model_create");
  of->count = count;
  for (int i = 0; i < count; ++i) {
    axle* one = &of->axles[i];
    check(wrc_contact_create(of->model, WRC_SIDE_RIGHT, NULL, &one->contact, why, sizeof why),
          "wrc_contact_create");
    one->tread = wrc_surface_default();
    one->tread.count = WHEEL_BINS;
    one->tread.length = 2.0 * pi * radius / WHEEL_BINS;
    one->tread.closed = 1;
    one->tread.bins = one->bins;
    one->tread.bin_size = sizeof one->bins[0];
  }
  of->laws = wrc_surface_laws_default();
  check(wrc_surface_laws_use(&of->laws, "low adhesion", why, sizeof why), "wrc_surface_laws_use");
  of->dry = wrc_friction_default();
  of->dry.coefficient = 0.4;
  of->input = wrc_wheel_input_default();
  of->input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  of->input.vertical_load = 0.5 * axle_load;
  wrc_wrench wrench = {.struct_size = sizeof wrench};
  contact_done(of->axles[0].contact, wrc_contact_wrench(of->axles[0].contact, &of->input, &wrench),
               "wrc_contact_wrench");
  of->input.prescribed = WRC_PRESCRIBE_HEIGHT;
  of->input.vertical_load = 0.0;
  of->input.wheel.z = wrench.z;
  of->input.start = WRC_START_WARM;
}

static void free_train(train* of) {
  for (int i = 0; i < of->count; ++i) wrc_contact_destroy(of->axles[i].contact);
  wrc_model_destroy(of->model);
  free(of->rail.bins);
}

/* A substance along the whole rail. */
static void lay(train* of, int32_t quantity, double amount) {
  check(wrc_surface_add(&of->rail, quantity, amount, of->rail.first,
                        of->rail.first + of->rail.count * of->rail.length, why, sizeof why),
        "wrc_surface_add");
}

/* Puts sand in front of a wheel: kg/s on one rail, over the way of a step. */
static void strew(train* of, const axle* one, double rate) {
  const double at = of->place - one->behind + sander, way = of->speed * dt;
  check(wrc_surface_add(&of->rail, WRC_SURFACE_SAND, rate * dt / (of->rail.width * way), at, at + way, why,
                        sizeof why),
        "wrc_surface_add");
}

/* Force and moment about the axle of a wheel that turns so fast. */
static wrc_wrench solve(train* of, const axle* one, double turning) {
  wrc_wrench wrench = {.struct_size = sizeof wrench};
  of->input.wheel.velocity[0] = of->speed;
  of->input.wheel.pitch_rate = -turning / radius;
  contact_done(one->contact, wrc_contact_wrench(one->contact, &of->input, &wrench), "wrc_contact_wrench");
  return wrench;
}

/* One axle over a step: friction of the films, wrench, a step of the rotation, and the passage. Where the
 * wheel hardly slips the rotation is stiff: a difference gives the slope of a linearly implicit step. */
static void step_axle(train* of, axle* one) {
  const double from = of->place - one->behind, little = 1e-4 * of->speed;
  wrc_surface_passage passage = {.struct_size = sizeof passage,
                                 .rail_from = from,
                                 .rail_to = from + of->speed * dt,
                                 .wheel_from = one->arc,
                                 .wheel_to = one->arc + one->turning * dt};
  check(wrc_surface_friction(&of->rail, &one->tread, &of->laws, &passage, &of->dry, &of->input.friction, why,
                             sizeof why),
        "wrc_surface_friction");
  const wrc_wrench wrench = solve(of, one, one->turning);
  double by_force = 0.0, by_moment = 0.0;
  if (fabs(one->turning - of->speed) < 0.03 * of->speed) {
    const wrc_wrench faster = solve(of, one, one->turning + little);
    by_force = (faster.force[0] - wrench.force[0]) / little;
    by_moment = fmax(0.0, (faster.moment[1] - wrench.moment[1]) / little);
  }
  /* moments about y of both wheels, and of brake or motor: positive ones slow the wheel down */
  const double moment = 2.0 * wrench.moment[1] - of->full_torque * one->torque;
  double change = -dt * radius * moment / (of->inertia + dt * radius * 2.0 * by_moment);
  if (of->full_torque < 0.0) change = fmax(change, -one->turning); /* a brake does not turn it back */
  one->force = wrench.force[0] + by_force * change;
  passage.energy = wrench.power * dt;
  check(wrc_surface_pass(&of->rail, &one->tread, &of->laws, &passage, NULL, why, sizeof why),
        "wrc_surface_pass");
  check(wrc_surface_rest(&one->tread, &of->laws, dt, why, sizeof why), "wrc_surface_rest");
  one->arc = passage.wheel_to;
  one->turning += change;
  one->energy += passage.energy;
  one->moved += fabs(one->force) * of->speed * dt;
}

/* All axles in the order in which they pass, then the train: its speed by their forces and a resistance [N].
 */
static void step_train(train* of, double resistance) {
  double force = -resistance;
  for (int i = 0; i < of->count; ++i) step_axle(of, &of->axles[i]);
  for (int i = 0; i < of->count; ++i) force += 2.0 * of->axles[i].force;
  of->place += of->speed * dt;
  of->speed += dt * force / of->mass;
  of->time += dt;
  if (of->time - floor(of->time) < dt)
    check(wrc_surface_rest(&of->rail, &of->laws, 1.0, why, sizeof why), "wrc_surface_rest");
}

static double slip_of(const train* of, const axle* one) { return one->turning / of->speed - 1.0; }

static void set_speed(train* of, double speed) {
  of->speed = speed;
  for (int i = 0; i < of->count; ++i) of->axles[i].turning = speed;
}

static void write_line(FILE* file, const train* of, double wheel_load) {
  fprintf(file, "%.2f,%.4f,%.3f", of->time, of->speed, of->place);
  for (int i = 0; i < of->count; ++i)
    fprintf(file, ",%.5f,%.5f", slip_of(of, &of->axles[i]), of->axles[i].force / wheel_load);
  fprintf(file, "\n");
}

/* The books of the rail and all treads: what was put on, less what is gone and what is there, over what was
 * put on. */
static double imbalance(const train* of) {
  double worst = 0.0, heat = 0.0, energy = 0.0;
  for (int32_t q = 0; q < WRC_SURFACE_QUANTITIES; ++q) {
    double put_on = 0.0, rest = 0.0;
    for (int i = -1; i < of->count; ++i) {
      const wrc_surface* surface = i < 0 ? &of->rail : &of->axles[i].tread;
      for (int32_t book = 0; book < WRC_SURFACE_CARRIED; ++book) {
        double total;
        check(wrc_surface_values(surface, q, book, NULL, &total, why, sizeof why), "wrc_surface_values");
        if (book == WRC_SURFACE_PUT_ON) put_on += total;
        rest += book == WRC_SURFACE_PUT_ON ? total : -total;
      }
    }
    if (q == WRC_SURFACE_HEAT) heat = put_on;
    if (put_on > 0.0) worst = fmax(worst, fabs(rest) / put_on);
  }
  for (int i = 0; i < of->count; ++i) energy += of->axles[i].energy;
  return fmax(worst, fabs(heat - energy) / energy);
}

/* Slide protection of an axle: lets the brake go above 15 % slip, holds it between, builds it up below 5 %.
 */
static void protect(const train* of, axle* one) {
  const double slide = -slip_of(of, one);
  if (slide > 0.15) one->torque = fmax(0.0, one->torque - 4.0 * dt);
  if (slide < 0.05) one->torque = fmin(1.0, one->torque + 1.0 * dt);
}

static void stop(FILE* file, double from, int cars_of_it, int sand) {
  static train cars;
  const double axle_load = 11.5e3 * gravity, demand = 1.0; /* of braking [m/s^2] */
  const int axles = 4 * cars_of_it;
  make_train(&cars, axles, axle_load);
  make_rail(&cars, 0.1, -110.0, 1500.0);
  cars.mass = axles * 11.5e3;
  cars.inertia = 110.0;
  cars.full_torque = -11.5e3 * demand * radius;
  for (int i = 0; i < axles; ++i) cars.axles[i].behind = 26.4 * (i / 4) + 19.0 * (i / 2 % 2) + 2.5 * (i % 2);
  lay(&cars, WRC_SURFACE_FILM, 0.009);
  lay(&cars, WRC_SURFACE_WATER, 0.020);
  set_speed(&cars, from / 3.6);
  double sliding = 0.0; /* time since the third axle slid; a sander stands before it [s] */
  for (long step = 0; cars.speed > 0.5; ++step) {
    for (int i = 0; i < axles; ++i) protect(&cars, &cars.axles[i]);
    sliding = slip_of(&cars, &cars.axles[2]) < -0.05 ? 0.0 : sliding + dt;
    if (sand && sliding < 2.0 && cars.speed > 3.0) strew(&cars, &cars.axles[2], 2.0 / 60.0);
    step_train(&cars, 0.0);
    if (step % 10 == 0) write_line(file, &cars, 0.5 * axle_load);
  }
  printf("stop from %.0f km/h on wet leaves, %s sand: %.0f m, %.1f s\n", from, sand ? "with" : "without",
         cars.place, cars.time);
  printf("  axle       adhesion   energy of both wheels\n");
  for (int i = 0; i < axles; i += i == 0 ? 1 : 2) {
    const axle* one = &cars.axles[i];
    printf("  %2d         %.3f      %.0f kJ\n", i + 1, one->moved / cars.place / (0.5 * axle_load),
           2e-3 * one->energy);
  }
  printf("  books balance to 1e-12: %s\n", imbalance(&cars) < 1e-12 ? "yes" : "no");
  free_train(&cars);
}

/* Every axle is turned to a wished slip by its motor; the wish climbs to where the locomotive pulls most. */
static void traction(FILE* file) {
  static train engine;
  const double axle_load = 21e3 * gravity;
  make_train(&engine, 4, axle_load);
  make_rail(&engine, 0.1, -20.0, 500.0);
  engine.dry.speed_law = WRC_SPEED_LAW_EXPONENTIAL; /* more slip cleans more, and slides faster */
  engine.dry.fall_rate = 0.2;                       /* Polach, wet */
  engine.mass = 1e30;                               /* the train holds its speed */
  engine.inertia = 250.0;
  engine.full_torque = 0.4 * axle_load * radius;
  for (int i = 0; i < 4; ++i) engine.axles[i].behind = 9.9 * (i / 2) + 2.6 * (i % 2);
  lay(&engine, WRC_SURFACE_FILM, 0.006);
  lay(&engine, WRC_SURFACE_WATER, 0.020);
  set_speed(&engine, 8.0);
  double wish = 0.04, change = 0.01, before = 0.0, pulled = 0.0;
  double first[2] = {0.0}, last[2] = {0.0}; /* slip aimed at, mean pull: second second, last */
  for (long step = 0; step < 60000; ++step) {
    for (int i = 0; i < 4; ++i) { /* motor: proportional to what is missing of the slip */
      axle* one = &engine.axles[i];
      one->torque = fmax(0.0, fmin(1.0, 0.3 + 20.0 * (wish - slip_of(&engine, one))));
      pulled += 2.0 * one->force * 1e-3; /* mean over a second */
    }
    step_train(&engine, 0.0);
    if (step % 10 == 0) write_line(file, &engine, 0.5 * axle_load);
    if (step % 1000 != 999) continue;
    last[0] = wish;
    last[1] = pulled;
    if (step == 1999) memcpy(first, last, sizeof first); /* by then the motors have reached their torque */
    if (pulled < before) change = -change;
    before = pulled;
    wish = fmin(0.5, fmax(0.005, wish + change));
    pulled = 0.0;
  }
  printf("traction on wet leaves: %.0f kN at %.0f %% slip, %.0f kN at the %.0f %% found\n", 1e-3 * first[1],
         100.0 * first[0], 1e-3 * last[1], 100.0 * last[0]);
  printf("  axle       adhesion at the end\n");
  for (int i = 0; i < 4; ++i)
    printf("  %2d         %.3f\n", i + 1, engine.axles[i].force / (0.5 * axle_load));
  free_train(&engine);
}

static void start(FILE* file, int sand) {
  static train engine;
  const double axle_load = 22e3 * gravity;
  make_train(&engine, 6, axle_load);
  make_rail(&engine, 0.005, -20.0, 120.0);
  engine.mass = 6 * 22e3 + 1100e3;
  engine.inertia = 300.0;
  engine.full_torque = 0.33 * axle_load * radius;
  for (int i = 0; i < 6; ++i) engine.axles[i].behind = 12.0 * (i / 3) + 2.0 * (i % 3);
  lay(&engine, WRC_SURFACE_OXIDE, 0.006);
  lay(&engine, WRC_SURFACE_WATER, 0.006);
  set_speed(&engine, 0.1);
  const double slope = 0.010 * engine.mass * gravity; /* 10 per mille */
  for (long step = 0; step < 30000 && engine.speed > 0.02; ++step) {
    for (int i = 0; i < 6; ++i) { /* creep control: a tread that runs 0.3 m/s too fast loses torque */
      axle* one = &engine.axles[i];
      const double creep = one->turning - engine.speed;
      one->torque += dt * (creep > 0.3 ? -4.0 : creep < 0.15 ? 0.5 : 0.0);
      one->torque = fmax(0.0, fmin(1.0, one->torque));
      if (sand && i % 3 == 0) strew(&engine, one, 0.4 / 60.0);
    }
    /* the train hangs on its brakes until the locomotive pulls */
    step_train(&engine, engine.time > 3.0 ? slope : 0.0);
    if (engine.time <= 3.0) engine.speed = 0.1;
    if (step % 10 == 0) write_line(file, &engine, 0.5 * axle_load);
  }
  printf("start of 1232 t on 10 per mille, damp oxide, %s sand: ", sand ? "with" : "without");
  if (engine.speed > 0.02)
    printf("%.1f km/h after %.0f s\n", 3.6 * engine.speed, engine.time);
  else
    printf("it comes to a stand after %.1f s\n", engine.time);
  printf("  axle       adhesion, mean over the way\n");
  for (int i = 0; i < 6; ++i)
    printf("  %2d         %.3f\n", i + 1, engine.axles[i].moved / engine.place / (0.5 * axle_load));
  free_train(&engine);
}

/* A wheel on a roller whose band is closed and sprayed with water: slip up to 10 % and down in 8 s, twice. */
static void curve(FILE* file) {
  static train rig;
  const double axle_load = 11.5e3 * gravity;
  double at_half[4] = {0.0}; /* of the largest slip, on each branch */
  make_train(&rig, 1, axle_load);
  make_rail(&rig, 0.1, 0.0, 3.0);
  rig.rail.closed = 1;
  lay(&rig, WRC_SURFACE_FILM, 0.009);
  lay(&rig, WRC_SURFACE_WATER, 0.020);
  rig.mass = rig.inertia = 1e30; /* both are driven */
  set_speed(&rig, 10.0);
  axle* one = &rig.axles[0];
  for (int step = 0; step < 16000; ++step) {
    const double phase = fmod(step * dt, 8.0) / 4.0;
    one->turning = rig.speed * (1.0 - 0.1 * (phase < 1.0 ? phase : 2.0 - phase));
    if (step % 100 == 0) lay(&rig, WRC_SURFACE_WATER, 2e-3);
    step_axle(&rig, one);
    rig.place += rig.speed * dt;
    rig.time += dt;
    const double adhesion = -one->force / (0.5 * axle_load);
    if (step % 4000 == 2000) at_half[step / 4000] = adhesion;
    if (step % 10 == 0) fprintf(file, "%.3f,%.5f,%.5f\n", rig.time, -slip_of(&rig, one), adhesion);
  }
  printf("adhesion at 5 %% slip: up %.3f, down %.3f, up again %.3f, down again %.3f\n", at_half[0],
         at_half[1], at_half[2], at_half[3]);
  free_train(&rig);
}

int main(int count, char** arguments) {
  const char* story = count > 2 ? arguments[1] : "";
  const int sand = count > 3 && strcmp(arguments[count - 1], "sand") == 0;
  const double from = count > 3 + sand ? atof(arguments[3]) : 160.0;
  const int cars = count > 4 + sand ? atoi(arguments[4]) : 4;
  FILE* file = count > 2 && cars > 0 && 4 * cars <= AXLES ? fopen(arguments[2], "w") : NULL;
  if (!file) {
    fprintf(stderr, "low_adhesion stop|traction|start|curve FILE [km/h [cars, 1..4]] [sand]\n");
    return EXIT_FAILURE;
  }
  if (strcmp(story, "stop") == 0) stop(file, from, cars, sand);
  if (strcmp(story, "traction") == 0) traction(file);
  if (strcmp(story, "start") == 0) start(file, sand);
  if (strcmp(story, "curve") == 0) curve(file);
  return fclose(file) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
