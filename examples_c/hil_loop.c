/* hil_loop.c - hardware in the loop: a wheelset on an irregular track, two wheels every millisecond.
 *
 *   hil_loop [SECONDS [FILE.csv]]      2 seconds; the file gets one row per cycle, for draw_hil_loop.py
 *
 * Before the loop: model and contacts are made, the height at which the wheelset stands is found, memory is
 * locked, the thread asks for a real-time priority.
 * In the loop: sleep until an absolute time, the wrench of both wheels, one step of the wheelset's motion, no
 * other call. Half a millisecond after each such cycle an empty one follows: what it shows is the machine's
 * and this loop's own, and belongs to the others too.
 *
 * The wheelset runs at 40 m/s, S1002 on 60E1, held by springs to a frame that moves straight on. The rails
 * wander by up to 8 mm to the right. One semi-implicit Euler step of 1 ms is stable for these masses and
 * loads.
 */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <math.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <time.h>

#include "wrc/wrc.h"

enum { wheels = 2, period = 500000 /* ns, between cycles; those with wheels come every second time */ };

/* One cycle's times in microseconds, counted from the moment the cycle was due. */
typedef struct cycle {
  double woken;  /* the thread runs */
  double solved; /* the forces are there, and the motion */
} cycle;

static const double speed = 40.0, load = 80e3;                   /* m/s; N on each wheel */
static const double mass = 1500.0, across = 800.0, axle = 100.0; /* kg, kg m^2, kg m^2 about the axle */
static const double sideways = 4e6, upwards = 2e6,
                    turning = 8e6; /* springs to the frame: N/m, N/m, N m/rad */

/* The wheelset's middle and its rates, and what came of it. */
typedef struct wheelset {
  wrc_contact* contact[wheels];        /* by enum wrc_side */
  wrc_wheel_input input;               /* pose and motion are kept here */
  double standing;                     /* its height under load [m] */
  double largest_shift, largest_force; /* against the rails [m], of a wheel to the side [N] */
  long failed, flagged;                /* calls */
} wheelset;

/* Model, contacts and the standing height; 0 where that fails. */
static int make_wheelset(wrc_model** model, wheelset* set) {
  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_60E1;
  config.track.rail_inclination = 1.0 / 40.0;
  if (wrc_model_create(&config, NULL, model, NULL, 0) < 0) return 0;
  for (int side = 0; side < wheels; ++side)
    if (wrc_contact_create(*model, side, NULL, &set->contact[side], NULL, 0) < 0) return 0;

  set->input = wrc_wheel_input_default();
  set->input.wheel.velocity[0] = speed;
  set->input.wheel.pitch_rate = -speed / config.wheelset.wheel_radius;
  set->input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  set->input.vertical_load = load;
  wrc_wrench wrench = {.struct_size = sizeof wrench};
  if (wrc_contact_wrench(set->contact[WRC_SIDE_RIGHT], &set->input, &wrench) < 0) return 0;
  set->input.prescribed = WRC_PRESCRIBE_HEIGHT;
  set->input.vertical_load = 0.0;
  set->input.start = WRC_START_WARM; /* for a fixed step that takes every result */
  set->input.wheel.z = set->standing = wrench.z;
  return 1;
}

/* The rails at the distance x: three waves to the side, and their slope. A rail at rest has no velocity. */
static void lay_track(double x, wrc_rail_state* rail) {
  static const double waves[] = {9.0, 17.0, 31.0}, amplitudes[] = {0.5e-3, 1.0e-3, 2.5e-3}; /* m */
  rail->y = rail->y_slope = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double k = 6.283185307179586 / waves[i];
    rail->y += amplitudes[i] * (1.0 - cos(k * x));
    rail->y_slope += amplitudes[i] * k * sin(k * x);
  }
}

/* One step: the wrenches of both wheels, the springs, the motion. x is the distance run [m], step in s. */
static void move_wheelset(wheelset* set, double x, double step) {
  wrc_wheel_state* const at = &set->input.wheel;
  lay_track(x, &set->input.rail);
  double force[3] = {0.0, -sideways * at->y, 2.0 * load - upwards * (at->z - set->standing)};
  double moment[3] = {-upwards * at->roll, 0.0, -turning * at->yaw};
  for (int side = 0; side < wheels; ++side) {
    wrc_wrench wrench = {.struct_size = sizeof wrench};
    const int32_t status = wrc_contact_wrench(set->contact[side], &set->input, &wrench);
    set->failed += status < 0;
    set->flagged += status > 0;
    for (int i = 0; i < 3; ++i) {
      force[i] += wrench.force[i];
      moment[i] += wrench.moment[i];
    }
    set->largest_force = fmax(set->largest_force, fabs(wrench.force[1]));
  }
  set->largest_shift = fmax(set->largest_shift, fabs(at->y - set->input.rail.y));

  /* Velocities from forces and the turning axle's gyroscopic moments, then places from the new velocities. */
  const double roll_rate = at->roll_rate;
  at->velocity[1] += step * force[1] / mass;
  at->velocity[2] += step * force[2] / mass;
  at->roll_rate += step * (moment[0] + axle * at->pitch_rate * at->yaw_rate) / across;
  at->yaw_rate += step * (moment[2] - axle * at->pitch_rate * roll_rate) / across;
  at->pitch_rate += step * moment[1] / axle;
  at->y += step * at->velocity[1];
  at->z += step * at->velocity[2];
  at->roll += step * at->roll_rate;
  at->yaw += step * at->yaw_rate;
}

static void stop(const char* why) {
  fprintf(stderr, "%s\n", why);
  exit(EXIT_FAILURE);
}

static double microseconds_since(const struct timespec* due) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return 1e6 * (double)(now.tv_sec - due->tv_sec) + 1e-3 * (double)(now.tv_nsec - due->tv_nsec);
}

static void later(struct timespec* time, long nanoseconds) {
  time->tv_nsec += nanoseconds;
  while (time->tv_nsec >= 1000000000L) {
    time->tv_nsec -= 1000000000L;
    ++time->tv_sec;
  }
}

static void ask_for_real_time(void) {
  struct sched_param priority;
  memset(&priority, 0, sizeof priority);
  priority.sched_priority = 80;
  if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0)
    printf("memory is not locked (%s): a page fault may cost a cycle\n", strerror(errno));
  if (sched_setscheduler(0, SCHED_FIFO, &priority) != 0)
    printf("no real-time priority (%s): other programs will interrupt the loop\n", strerror(errno));
}

static int ascending(const void* left, const void* right) {
  const double difference = *(const double*)left - *(const double*)right;
  return (difference > 0.0) - (difference < 0.0);
}

/* Percentiles of what is left in `numbers`, sorted here. */
static void print_row(const char* name, double* numbers, long count) {
  static const double shares[] = {0.5, 0.99, 0.9999, 1.0};
  qsort(numbers, (size_t)count, sizeof *numbers, ascending);
  printf("%-28s", name);
  for (int i = 0; i < 4; ++i) printf(" %9.1f", numbers[(long)(shares[i] * (double)(count - 1))]);
  printf("\n");
}

/* How many cycles ended in each tenth of the period: with the wheels and without. */
static void print_histogram(const cycle* cycles, long count) {
  long in_bin[2][11] = {{0}};
  for (long i = 0; i < count; ++i) {
    const int bin = (int)(cycles[i].solved * 10e3 / period);
    ++in_bin[i % 2][bin < 10 ? bin : 10];
  }
  printf("\nend of the cycle's work [us]   wheels   empty\n");
  for (int bin = 0; bin < 10; ++bin)
    printf("%5d .. %5d %24ld %7ld\n", bin * period / 10000, (bin + 1) * period / 10000, in_bin[0][bin],
           in_bin[1][bin]);
  printf("later: missed %23ld %7ld\n", in_bin[0][10], in_bin[1][10]);
}

static void report(const cycle* cycles, long count, double* room) {
  static const char* const names[2][3] = {
      {"wheels: woken after", "wheels: solved after", "wheels: work itself"},
      {"empty:  woken after", "empty:  done after", "empty:  work itself"}};
  printf("%-28s %9s %9s %9s %9s\n", "[us]", "p50", "p99", "p99.99", "max");
  double work_p50 = 0.0, work_p99 = 0.0;
  for (int empty = 0; empty < 2; ++empty) {
    for (int what = 0; what < 3; ++what) {
      long n = 0;
      for (long i = empty; i < count; i += 2)
        room[n++] = what == 0   ? cycles[i].woken
                    : what == 1 ? cycles[i].solved
                                : cycles[i].solved - cycles[i].woken;
      print_row(names[empty][what], room, n);
      if (empty == 0 && what == 2) {
        work_p50 = room[n / 2];
        work_p99 = room[(long)(0.99 * (double)(n - 1))];
      }
    }
  }
  printf("share of the 1 ms used by the wheels: %.1f %% (p50), %.1f %% (p99)\n", 50e3 * work_p50 / period,
         50e3 * work_p99 / period);
  print_histogram(cycles, count);
}

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? atof(argv[1]) : 2.0;
  const double step = 2e-9 * period; /* s */
  const long count = (long)(seconds * 1e9 / period);
  if (count < 2 || count > 100000000L) stop("hil_loop [SECONDS [FILE.csv]]");
  wrc_model* model = NULL;
  static wheelset set;
  cycle* const cycles = calloc((size_t)count, sizeof *cycles);
  double* const room = calloc((size_t)count, sizeof *room);
  if (cycles == NULL || room == NULL || !make_wheelset(&model, &set)) stop("out of memory");
  ask_for_real_time();
  const wheelset at_start = set;
  for (int i = 0; i < 20; ++i) move_wheelset(&set, 0.0, step); /* first steps: caches, and the warm start */
  set = at_start;

  struct timespec due;
  clock_gettime(CLOCK_MONOTONIC, &due);
  long skipped = 0;
  for (long i = 0; i < count; ++i) {
    later(&due, period);
    while (microseconds_since(&due) > 0.0) { /* the last cycle ran over: on with the next one of the grid */
      later(&due, period);
      ++skipped;
    }
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, NULL) == EINTR) continue;
    cycles[i].woken = microseconds_since(&due);
    if (i % 2 == 0) move_wheelset(&set, speed * step * (double)(i / 2), step);
    cycles[i].solved = microseconds_since(&due);
  }

  if (argc > 2) {
    FILE* const file = fopen(argv[2], "w");
    if (file == NULL) stop("cannot write the file");
    fprintf(file, "wheels,woken_us,solved_us\n");
    for (long i = 0; i < count; ++i)
      fprintf(file, "%d,%.3f,%.3f\n", i % 2 == 0 ? wheels : 0, cycles[i].woken, cycles[i].solved);
    fclose(file);
  }
  report(cycles, count, room);
  printf("\n%ld cycles, one every %d us, every second with the wheelset's step of 1 ms\n", count,
         period / 1000);
  printf("%ld periods skipped because the cycle before ran over, %ld calls failed, %ld flagged\n", skipped,
         set.failed, set.flagged);
  printf("the wheelset ran %.0f m, at most %.2f mm off the rails' middle, %.1f kN to the side of a wheel\n",
         speed * step * (double)((count + 1) / 2), 1e3 * set.largest_shift, 1e-3 * set.largest_force);

  for (int side = 0; side < wheels; ++side) wrc_contact_destroy(set.contact[side]);
  wrc_model_destroy(model);
  free(room);
  free(cycles);
  return set.failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
