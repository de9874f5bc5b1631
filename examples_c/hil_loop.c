/* hil_loop.c - hardware in the loop: eight wheels with two contact patches each, every millisecond.
 *
 *   hil_loop [SECONDS [FILE.csv]]      2 seconds; the file gets one row per cycle, for draw_hil_loop.py
 *
 * Before the loop: models and contacts are made, memory is locked, the thread asks for a real-time priority.
 * In the loop: sleep until an absolute time, one wrc_planar_step for each wheel, no other
 * call. Every second cycle
 * the wheels are left out: what those cycles show is the machine's and this loop's own, and belongs to the
 * others too.
 *
 * The wheelsets stand 5.0 to 5.3 mm off centre, where tread and flange root both touch: the dearest position
 * there is.
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

#include "wrc/wrc_planar.h"

enum { wheels = 8, period = 1000000 /* ns */ };

/* One cycle's times in microseconds, counted from the moment the cycle was due. */
typedef struct cycle {
  double woken;  /* the thread runs */
  double solved; /* the forces are there */
} cycle;

static wrc_contact* contacts[wheels];
static wrc_planar_input inputs[wheels];
static wrc_planar_output outputs[wheels];

/* One model for all; even wheels are right ones. */
static int make_wheels(wrc_model** model) {
  wrc_config config = wrc_config_default();
  config.planar.start = WRC_START_WARM;
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  if (wrc_model_create(&config, NULL, model, NULL, 0) < 0) return 0;
  for (int k = 0; k < wheels; ++k) {
    if (wrc_contact_create(*model, k % 2 == 0 ? WRC_SIDE_RIGHT : WRC_SIDE_LEFT, NULL, &contacts[k], NULL, 0) < 0)
      return 0;
    inputs[k] = wrc_planar_input_default();
    inputs[k].creepage.speed = 40.0;
    outputs[k] = wrc_planar_output_default();
  }
  return 1;
}

/* In place of a vehicle model: what it would hand over at time t [s]. */
static void move_vehicle(double t) {
  for (int k = 0; k < wheels; ++k) {
    const double phase = 0.8 * k, side = k % 2 == 0 ? 1.0 : -1.0;
    inputs[k].pose.lateral = side * (5.15e-3 + 0.15e-3 * sin(9.0 * t + phase));
    inputs[k].pose.yaw = 1e-3 * sin(7.0 * t + phase);
    inputs[k].load.normal_force = 70e3 + 10e3 * sin(23.0 * t + phase);
    inputs[k].creepage.longitudinal = 1e-3 * sin(5.0 * t + phase);
    inputs[k].creepage.lateral = 2e-3 * sin(7.0 * t + phase);
    inputs[k].creepage.spin = 0.3 * side;
  }
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
  printf("share of the cycle used by the wheels: %.1f %% (p50), %.1f %% (p99)\n", 100e3 * work_p50 / period,
         100e3 * work_p99 / period);
  print_histogram(cycles, count);
}

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? atof(argv[1]) : 2.0;
  const long count = (long)(seconds * 1e9 / period);
  if (count < 2 || count > 100000000L) stop("hil_loop [SECONDS [FILE.csv]]");
  wrc_model* model = NULL;
  cycle* const cycles = calloc((size_t)count, sizeof *cycles);
  double* const room = calloc((size_t)count, sizeof *room);
  if (cycles == NULL || room == NULL || !make_wheels(&model)) stop("out of memory");
  ask_for_real_time();
  for (int i = 0; i < 20; ++i) { /* first steps: caches, and the warm start */
    move_vehicle(1e-3 * i);
    for (int k = 0; k < wheels; ++k) wrc_planar_step(contacts[k], &inputs[k], &outputs[k]);
  }

  struct timespec due;
  clock_gettime(CLOCK_MONOTONIC, &due);
  long skipped = 0, failed = 0, two_patches = 0;
  for (long i = 0; i < count; ++i) {
    later(&due, period);
    while (microseconds_since(&due) > 0.0) { /* the last cycle ran over: on with the next one of the grid */
      later(&due, period);
      ++skipped;
    }
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, NULL) == EINTR) continue;
    cycles[i].woken = microseconds_since(&due);
    move_vehicle(1e-9 * period * (double)i);
    if (i % 2 == 0) {
      for (int k = 0; k < wheels; ++k) {
        failed += wrc_planar_step(contacts[k], &inputs[k], &outputs[k]) < 0;
        two_patches += outputs[k].normal.patch_count == 2;
      }
    }
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
  const double on_two = 100.0 * (double)two_patches / (wheels * (double)((count + 1) / 2));
  printf("\n%ld cycles of %d us, every second with %d wheels, %.0f %% of them on two patches\n", count,
         period / 1000, wheels, on_two);
  printf("%ld periods skipped because the cycle before ran over, %ld calls failed\n", skipped, failed);

  for (int k = 0; k < wheels; ++k) wrc_contact_destroy(contacts[k]);
  wrc_model_destroy(model);
  free(room);
  free(cycles);
  return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
