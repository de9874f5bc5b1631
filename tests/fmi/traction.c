/* The FMU wrc_wheelset as the axles of a locomotive that pulls on wet leaves, the story of
 * examples_c/low_adhesion.c with its controls. Amounts behind an axle are those ahead of the next.
 *
 *   fmi_traction wrc_fmu.so FILE    FILE: table of low_adhesion traction; exit status 1 if the mean adhesion of
 *                                   an axle differs by more than 1 % */
#include <math.h>

#include "model.h"
#include "wheelset_fmu.h"

enum { most_axles = 4, substances = 5, cells = 4000, columns = 3 + 2 * most_axles };

static const double dt = 1e-3, cell = 0.01, radius = 0.46;

/* Amounts ahead of each axle along its way, means that the axle before it wrote [kg/m^2], and that way [m].
 */
static double rail[most_axles + 1][cells][substances], written[most_axles + 1][cells];

typedef struct story {
  int axles;
  double load, inertia, full, speed, behind[most_axles], leaves[substances], fall_rate;
  double from, to; /* time over which adhesion is compared [s] */
} story;

static const story traction = {
    4, 21e3 * 9.81, 250.0, 0.4, 8.0, {0.0, 2.6, 9.9, 12.5}, {0.02, 0.0, 0.006, 0.0, 0.0}, 0.2, 2.0, 4.0};

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

/* A step of an axle under a moment; numbers: time [s], x [m], speed [m/s]. Gives the force of both wheels
 * [N]. */
static double step(const functions* fmu, fmi3Instance set, int axle, const double number[3], double moment) {
  const double time = number[0], x = number[1], speed = number[2], way = speed * dt;
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
  given[substances + 1] = speed;
  const uint32_t pulls = SET_fx;
  bool event, end, early;
  if (fmu->set(set, ahead, substances + 2, given, substances + 2) != fmi3OK ||
      fmu->step(set, time, dt, true, &event, &end, &early, &last) != fmi3OK ||
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

/* Mean adhesion of each axle by the FMUs [-]. */
static void run(const functions* fmu, const story* of, double adhesion[most_axles]) {
  fmi3Instance set[most_axles];
  double torque[most_axles] = {0.0}, place = 20.0, wish = 0.04, change = 0.01;
  double pulled = 0.0, before = 0.0;
  for (int i = 0; i <= of->axles; ++i)
    for (int k = 0; k < cells; ++k) memcpy(rail[i][k], of->leaves, sizeof rail[i][k]);
  for (int i = 0; i < of->axles; ++i) set[i] = start(fmu, of);
  for (int n = 0; n * dt < of->to; ++n) {
    double force = 0.0;
    for (int i = 0; i < of->axles; ++i) {
      const double tread = turning(fmu, set[i]), number[3] = {n * dt, place - of->behind[i], of->speed};
      torque[i] = 0.3 + 20.0 * (wish - (tread / of->speed - 1.0));
      torque[i] = fmax(0.0, fmin(1.0, torque[i]));
      const double fx = step(fmu, set[i], i, number, -of->full * of->load * radius * torque[i]);
      force += fx;
      if (n * dt >= of->from) adhesion[i] += fx / of->load * dt / (of->to - of->from);
    }
    place += of->speed * dt;
    pulled += force * dt;
    if (n % 1000 != 999) continue;
    if (pulled < before) change = -change;
    before = pulled;
    wish = fmin(0.5, fmax(0.005, wish + change));
    pulled = 0.0;
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
  if (count < 3) return 2;
  const functions fmu = functions_of(load(words[1]));
  const story* of = &traction;
  double found[most_axles] = {0.0}, expected[most_axles] = {0.0};
  run(&fmu, of, found);
  read(words[2], of, expected);
  int good = 1;
  for (int i = 0; i < of->axles; ++i) {
    printf("axle %d: adhesion %.4f, of the C program %.4f\n", i + 1, found[i], expected[i]);
    good = good && fabs(found[i] - expected[i]) <= 0.01 * expected[i];
  }
  return !good;
}
