/* The FMU wrc_wheelset as the axles of the trains of examples_c/low_adhesion.c, with their controls. The host
 * keeps the rail: amounts behind an axle are those ahead of the next, sanders put theirs on, water dries.
 *
 *   fmi_low_adhesion wrc_fmu.so stop|traction|start FILE [sand]    FILE: table of low_adhesion, which had the
 *                                     same words; exit status 1 if an axle's mean adhesion differs by over 1 % */
#include <math.h>

#include "model.h"
#include "wheelset_fmu.h"

enum { most_axles = 6, substances = 5, cells = 4000, columns = 3 + 2 * most_axles };

static const double dt = 1e-3, cell = 0.01, width = 0.02, radius = 0.46, gravity = 9.81;
static const double sander = 0.3; /* before its axle [m] */

/* Amounts ahead of each axle along its way, means that the axle before it wrote [kg/m^2], and that way [m].
 */
static double rail[most_axles + 1][cells][substances], written[most_axles + 1][cells];

/* The train while it runs. */
typedef struct state {
  double time, speed, place, pulled, before, wish, change, sliding;
  double turning[most_axles], torque[most_axles], force[most_axles]; /* [m/s], share 0..1, [N] */
} state;

typedef struct story {
  const char* name;
  int axles;
  double load, inertia, full, mass, speed; /* [N], [kg m^2], torque over load times radius, [kg], [m/s] */
  double behind[most_axles], leaves[substances], fall_rate;
  double from, to; /* time over which adhesion is compared [s] */
  double sand;     /* of a sander [kg/s] */
  void (*control)(state* now, const struct story* of, double sands[most_axles]);
} story;

static double within(double low, double value, double high) { return fmax(low, fmin(high, value)); }

static double slip_of(const state* now, int i) { return now->turning[i] / now->speed - 1.0; }

static void protect(state* now, const story* of, double sands[most_axles]) {
  for (int i = 0; i < of->axles; ++i) {
    const double slide = -slip_of(now, i), rate = slide > 0.15 ? -4.0 : slide < 0.05 ? 1.0 : 0.0;
    now->torque[i] = within(0.0, now->torque[i] + rate * dt, 1.0);
  }
  now->sliding = slip_of(now, 2) < -0.05 ? 0.0 : now->sliding + dt;
  if (now->sliding < 2.0 && now->speed > 3.0) sands[2] = of->sand;
}

static void seek(state* now, const story* of, double sands[most_axles]) {
  (void)sands;
  for (int i = 0; i < of->axles; ++i) {
    now->torque[i] = within(0.0, 0.3 + 20.0 * (now->wish - slip_of(now, i)), 1.0);
    now->pulled += now->force[i];
  }
  if ((long)(now->time / dt + 0.5) % 1000 != 0 || now->time == 0.0) return;
  if (now->pulled < now->before) now->change = -now->change;
  now->before = now->pulled;
  now->wish = within(0.005, now->wish + now->change, 0.5);
  now->pulled = 0.0;
}

static void creep(state* now, const story* of, double sands[most_axles]) {
  for (int i = 0; i < of->axles; ++i) {
    const double faster = now->turning[i] - now->speed, rate = faster > 0.3    ? -4.0
                                                               : faster < 0.15 ? 0.5
                                                                               : 0.0;
    now->torque[i] = within(0.0, now->torque[i] + rate * dt, 1.0);
    if (i % 3 == 0) sands[i] = of->sand;
  }
}

static const story stories[] = {{.name = "stop",
                                 .axles = 4,
                                 .load = 11.5e3 * 9.81,
                                 .inertia = 110.0,
                                 .full = -1.0 / 9.81,
                                 .mass = 46e3,
                                 .speed = 12.0 / 3.6,
                                 .behind = {0.0, 2.5, 19.0, 21.5},
                                 .leaves = {0.02, 0.0, 0.009},
                                 .to = 3.0,
                                 .sand = 2.0 / 60.0,
                                 .control = protect},
                                {.name = "traction",
                                 .axles = 4,
                                 .load = 21e3 * 9.81,
                                 .inertia = 250.0,
                                 .full = 0.4,
                                 .mass = 1e30,
                                 .speed = 8.0,
                                 .behind = {0.0, 2.6, 9.9, 12.5},
                                 .leaves = {0.02, 0.0, 0.006},
                                 .fall_rate = 0.2,
                                 .from = 2.0,
                                 .to = 4.0,
                                 .control = seek},
                                {.name = "start",
                                 .axles = 6,
                                 .load = 22e3 * 9.81,
                                 .inertia = 300.0,
                                 .full = 0.33,
                                 .mass = 1232e3,
                                 .speed = 0.1,
                                 .behind = {0.0, 2.0, 4.0, 12.0, 14.0, 16.0},
                                 .leaves = {0.006, 0.006},
                                 .from = 3.0,
                                 .to = 8.0,
                                 .sand = 0.4 / 60.0,
                                 .control = creep}};

static fmi3Instance start(const functions* fmu, const story* of) {
  fmi3Instance set = new_wheelset(fmu);
  const uint32_t numbers[] = {SET_speed,     SET_friction,           SET_fall_rate,       SET_load,
                              SET_tolerance, SET_inertia_about_axle, SET_rail_inclination},
                 choices[] = {FIRST_INTEGER + SET_films, FIRST_INTEGER + SET_rail_profile};
  const double values[] = {of->speed, 0.4, of->fall_rate, of->load, 1e-5, of->inertia, 0.025};
  const int32_t chosen[] = {1, 3}; /* films, 60E1 */
  if (!set || fmu->set(set, numbers, 7, values, 7) != fmi3OK ||
      fmu->set_integer(set, choices, 2, chosen, 2) != fmi3OK ||
      fmu->enter(set, false, 0.0, 0.0, false, 0.0) != fmi3OK || fmu->leave(set) != fmi3OK)
    stop("the FMU does not start");
  return set;
}

/* A step of an axle at a place of the rail, under a moment. Gives the force of both wheels [N]. */
static double step(const functions* fmu, fmi3Instance set, int axle, const state* now, double x,
                   double moment) {
  const double way = now->speed * dt;
  uint32_t ahead[substances + 2], behind[substances];
  double given[substances + 2], left[substances], fx, last;
  const long at = (long)(x / cell);
  for (uint32_t q = 0; q < substances; ++q) {
    ahead[q] = SET_water_ahead + q;
    behind[q] = SET_water_behind + q;
    given[q] = rail[axle][at][q];
  }
  ahead[substances] = SET_moment_y;
  given[substances] = moment;
  ahead[substances + 1] = SET_speed;
  given[substances + 1] = now->speed;
  const uint32_t pulls = SET_fx;
  bool event, end, early;
  if (fmu->set(set, ahead, substances + 2, given, substances + 2) != fmi3OK ||
      fmu->step(set, now->time, dt, true, &event, &end, &early, &last) != fmi3OK ||
      fmu->get(set, behind, substances, left, substances) != fmi3OK ||
      fmu->get(set, &pulls, 1, &fx, 1) != fmi3OK)
    stop("a step failed");
  /* a cell's amounts are means over the ways that the axle rolled on it */
  double* mean = rail[axle + 1][at];
  double* all = &written[axle + 1][at];
  for (int q = 0; q < substances; ++q) mean[q] = (mean[q] * *all + left[q] * way) / (*all + way);
  *all += way;
  return fx;
}

static double turning(const functions* fmu, fmi3Instance set) {
  const uint32_t number = SET_pitch_rate;
  double rate;
  fmu->get(set, &number, 1, &rate, 1);
  return -rate * radius;
}

/* Mean adhesion of each axle by the FMUs [-]. `sand`: share of the sanders' rate. */
static void run(const functions* fmu, const story* of, double sand, double adhesion[most_axles]) {
  fmi3Instance set[most_axles];
  state now = {.speed = of->speed, .place = 25.0, .wish = 0.04, .change = 0.01};
  for (int i = 0; i <= of->axles; ++i)
    for (int k = 0; k < cells; ++k) memcpy(rail[i][k], of->leaves, sizeof rail[i][k]);
  for (int i = 0; i < of->axles; ++i) set[i] = start(fmu, of);
  for (int n = 0; n * dt < of->to; ++n) {
    double force = 0.0, sands[most_axles] = {0.0};
    now.time = n * dt;
    for (int i = 0; i < of->axles; ++i) now.turning[i] = turning(fmu, set[i]);
    of->control(&now, of, sands);
    for (int i = 0; i < of->axles; ++i) {
      const double x = now.place - of->behind[i], way = now.speed * dt;
      /* sand over the way of a step becomes the mean of a cell, or of as many as the way has */
      const double spread = fmax(way, cell);
      for (double at = 0.0; sands[i] > 0.0 && at < spread; at += cell)
        rail[i][(long)((x + sander + at) / cell)][WRC_SURFACE_SAND] +=
            sand * sands[i] * dt / (width * spread);
      const int stands = of->full < 0.0 && now.turning[i] <= 0.0; /* a brake does not turn it back */
      const double moment = stands ? 0.0 : -of->full * of->load * radius * now.torque[i];
      now.force[i] = step(fmu, set[i], i, &now, x, moment);
      force += now.force[i];
      if (now.time >= of->from) adhesion[i] += now.force[i] / of->load * dt / (of->to - of->from);
    }
    now.place += now.speed * dt;
    /* the freight train hangs on its brakes for 3 s, then on 10 per mille */
    if (of->control == creep) force -= 0.010 * of->mass * gravity;
    if (of->control != creep || now.time > 3.0) now.speed += dt * force / of->mass;
    if (n % 1000 != 999) continue;
    for (int i = 0; i <= of->axles; ++i) /* over a second, of 1800 */
      for (int k = 0; k < cells; ++k) rail[i][k][WRC_SURFACE_WATER] *= exp(-1.0 / 1800.0);
  }
  for (int i = 0; i < of->axles; ++i) fmu->release(set[i]);
}

/* Mean adhesion of each axle by the C program's table: time, speed, place, then slip and adhesion of each
 * axle. */
static void read(const char* name, const story* of, double adhesion[most_axles]) {
  FILE* file = fopen(name, "r");
  double number[columns];
  int lines = 0;
  if (!file) stop("low_adhesion has left no table");
  for (;;) {
    const int wanted = 3 + 2 * of->axles;
    int k = 0;
    while (k < wanted && fscanf(file, k == 0 ? "%lf" : ",%lf", &number[k]) == 1) ++k;
    if (k < wanted || number[0] > of->to) break;
    if (number[0] <= of->from) continue;
    for (int i = 0; i < of->axles; ++i) adhesion[i] += number[4 + 2 * i];
    ++lines;
  }
  fclose(file);
  for (int i = 0; i < of->axles; ++i) adhesion[i] /= lines;
}

int main(int count, char** words) {
  if (count < 4) return 2;
  const functions fmu = functions_of(load(words[1]));
  const story* of = NULL;
  for (size_t k = 0; k < sizeof stories / sizeof stories[0]; ++k)
    if (strcmp(stories[k].name, words[2]) == 0) of = &stories[k];
  if (!of) return 2;
  double found[most_axles] = {0.0}, expected[most_axles] = {0.0};
  run(&fmu, of, count > 4 && strcmp(words[4], "sand") == 0, found);
  read(words[3], of, expected);
  int good = 1;
  for (int i = 0; i < of->axles; ++i) {
    printf("axle %d: adhesion %.4f, of the C program %.4f (%+.2f %%)\n", i + 1, found[i], expected[i],
           100.0 * (found[i] / expected[i] - 1.0));
    good = good && fabs(found[i] - expected[i]) <= 0.01 * fabs(expected[i]);
  }
  return !good;
}
