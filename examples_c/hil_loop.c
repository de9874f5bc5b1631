/* hil_loop.c - hardware in the loop: a vehicle of eight wheels on rough track, a step every half millisecond.
 *
 *   hil_loop [SECONDS [PRESET [FILE.csv]]]     2 seconds; PRESET is a name of wrc_config_use() ["real time"]; the
 *                                              file gets one row per cycle, for draw_hil_loop.py
 *
 * Before the loop: model and contacts are made, the height at which the wheelsets stand is found, memory is
 * locked, the threads ask for a real-time priority. In the loop: sleep until an absolute time; the wrench of
 * all wheels, one step of the vehicle's motion; no other call. Cycles take turns: one thread; fixed
 * arithmetic that takes as long; two threads, each with a bogie; fixed arithmetic of that length. The
 * arithmetic takes the same number of operations every time: what it varies by is the machine's, and belongs
 * to the others too.
 *
 * The vehicle runs at 50 m/s, S1002 on 60E1: two bogies of two wheelsets below a body that moves straight on.
 * One semi-implicit Euler step of 0.5 ms is stable for these masses and loads (docs/user_forces.md).
 */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <math.h>
#include <pthread.h>
#include <sched.h>
#include <semaphore.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <time.h>

#include "wrc/wrc.h"

enum { bogies = 2, sets = 2, wheels = 2, period = 500000 /* ns */ };
enum { one_thread, as_long_as_one, two_threads, as_long_as_two, kinds };

/* One cycle's times in microseconds, counted from the moment the cycle was due. */
typedef struct cycle {
  double woken; /* the thread runs */
  double ended; /* the forces are there, and the motion */
} cycle;

static const double speed = 50.0, load = 70e3;                         /* m/s; N on each wheel */
static const double mass = 1500.0, across = 800.0, about_axle = 100.0; /* of a wheelset: kg, kg m^2 */
static const double frame_mass = 3000.0, frame_inertia = 3500.0; /* of a bogie frame: kg, kg m^2 about z */
static const double half_base = 1.25; /* between a bogie's middle and its wheelsets [m] */
/* Springs and dampers from wheelset to frame, then from frame to body: N/m, N m/rad, N s/m, N m s/rad. */
static const double sideways = 5e6, upwards = 2.4e6, upwards_damping = 4e4, turning = 1.2e7;
static const double body_sideways = 3e5, body_damping = 6e4, body_turning_damping = 8e5;

typedef struct wheelset {
  wrc_contact* contact[wheels]; /* by enum wrc_side */
  wrc_wheel_input input;        /* pose and motion are kept here */
  double x;                     /* where it begins [m] */
} wheelset;

typedef struct bogie {
  wheelset set[sets];
  double y, yaw, y_rate, yaw_rate; /* of its frame */
  double largest_shift,
      largest_force;             /* of a wheelset from the track's middle [m], of a wheel to the side [N] */
  long failed, flagged, regions; /* calls; regions in contact, all together */
} bogie;

static bogie vehicle[bogies];
static double standing; /* height of the wheelsets under load [m] */

/* Model, contacts and the standing height; 0 where that fails. */
static int make_vehicle(wrc_model** model, const char* preset) {
  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_60E1;
  config.track.rail_inclination = 1.0 / 40.0;
  char why[512] = "";
  int good = wrc_config_use(&config, preset, why, sizeof why) >= 0;
  good = good && wrc_model_create(&config, NULL, model, why, sizeof why) >= 0;
  wrc_wheel_input input = wrc_wheel_input_default();
  input.wheel.velocity[0] = speed;
  input.wheel.pitch_rate = -speed / config.wheelset.wheel_radius;
  for (int i = 0; i < bogies * sets && good; ++i) {
    wheelset* const set = &vehicle[i / sets].set[i % sets];
    for (int side = 0; side < wheels && good; ++side)
      good = wrc_contact_create(*model, side, NULL, &set->contact[side], why, sizeof why) >= 0;
    set->input = input;
    set->input.start = WRC_START_MARK; /* from the step before */
    set->x = i / sets * -15.0 + (i % sets == 0 ? half_base : -half_base);
  }
  if (!good) {
    fprintf(stderr, "%s\n", why);
    return 0;
  }
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = load;
  wrc_wrench wrench = {.struct_size = sizeof wrench};
  if (wrc_contact_wrench(vehicle[0].set[0].contact[WRC_SIDE_RIGHT], &input, &wrench) < 0) return 0;
  standing = wrench.z;
  for (int i = 0; i < bogies * sets; ++i) vehicle[i / sets].set[i % sets].input.wheel.z = standing;
  return 1;
}

/* A rail at the distance x: waves to the side and up and down, which grow over the first 30 m, and their
 * slopes. A rail at rest has no velocity. */
static void lay_track(double x, int side, wrc_rail_state* rail) {
  static const double waves[] = {2.7, 5.3, 9.1, 17.0, 31.0}; /* m */
  static const double to_the_side[] = {0.1e-3, 0.3e-3, 0.6e-3, 1.5e-3, 3.5e-3},
                      down[] = {0.03e-3, 0.1e-3, 0.3e-3, 0.8e-3, 2e-3};
  const double grown = fmin(fmax(x / 30.0, 0.0), 1.0), grows = x > 0.0 && x < 30.0 ? 1.0 / 30.0 : 0.0;
  rail->y = rail->z = rail->y_slope = rail->z_slope = 0.0;
  for (int i = 0; i < 5; ++i) {
    const double k = 6.283185307179586 / waves[i], along = k * x, of_side = along + 0.4 * side * i;
    rail->y += grown * to_the_side[i] * (sin(along) + 0.3 * sin(of_side));
    rail->y_slope += to_the_side[i] * (grown * k * (cos(along) + 0.3 * cos(of_side)) +
                                       grows * (sin(along) + 0.3 * sin(of_side)));
    rail->z += grown * down[i] * sin(of_side);
    rail->z_slope += down[i] * (grown * k * cos(of_side) + grows * sin(of_side));
  }
}

/* One step of a wheelset below its frame: the wrenches of both wheels, springs, motion. Force and moment of
 * its springs on the frame are added to push[2]. */
static void move_wheelset(bogie* under, wheelset* set, double x, double step, double push[2]) {
  wrc_wheel_state* const at = &set->input.wheel;
  const double arm = set == &under->set[0] ? half_base : -half_base;
  const double side_force = sideways * (under->y + arm * under->yaw - at->y),
               turn = turning * (under->yaw - at->yaw);
  double force[3] = {0.0, side_force,
                     2.0 * load - upwards * (at->z - standing) - upwards_damping * at->velocity[2]};
  double moment[3] = {-upwards * at->roll - upwards_damping * at->roll_rate, 0.0, turn};
  push[0] -= side_force;
  push[1] -= arm * side_force + turn;
  for (int side = 0; side < wheels; ++side) {
    wrc_wrench wrench = {.struct_size = sizeof wrench};
    lay_track(x + set->x, side, &set->input.rail);
    const int32_t status = wrc_contact_wrench(set->contact[side], &set->input, &wrench);
    wrc_contact_mark(set->contact[side]); /* a fixed step takes every result */
    under->failed += status < 0;
    under->flagged += status > WRC_FLAG_NO_CONTACT;
    under->regions += wrench.region_count;
    for (int i = 0; i < 3; ++i) {
      force[i] += wrench.force[i];
      moment[i] += wrench.moment[i];
    }
    under->largest_force = fmax(under->largest_force, fabs(wrench.force[1]));
  }
  under->largest_shift = fmax(under->largest_shift, fabs(at->y));

  /* Velocities from forces and the turning axle's gyroscopic moments, then places from the new velocities. */
  const double roll_rate = at->roll_rate;
  at->velocity[1] += step * force[1] / mass;
  at->velocity[2] += step * force[2] / mass;
  at->roll_rate += step * (moment[0] + about_axle * at->pitch_rate * at->yaw_rate) / across;
  at->yaw_rate += step * (moment[2] - about_axle * at->pitch_rate * roll_rate) / across;
  at->pitch_rate += step * moment[1] / about_axle;
  at->y += step * at->velocity[1];
  at->z += step * at->velocity[2];
  at->roll += step * at->roll_rate;
  at->yaw += step * at->yaw_rate;
}

/* One step of a bogie: its wheelsets, its frame against the body. x is the distance run [m], step in s. */
static void move_bogie(bogie* which, double x, double step) {
  double push[2] = {-body_sideways * which->y - body_damping * which->y_rate,
                    -body_turning_damping * which->yaw_rate};
  for (int i = 0; i < sets; ++i) move_wheelset(which, &which->set[i], x, step, push);
  which->y_rate += step * push[0] / frame_mass;
  which->yaw_rate += step * push[1] / frame_inertia;
  which->y += step * which->y_rate;
  which->yaw += step * which->yaw_rate;
}

/* Fixed arithmetic: so many dependent operations, whatever the number is. */
static void fixed_arithmetic(volatile double* number, long operations) {
  double value = *number;
  for (long i = 0; i < operations; ++i) value = value * 0.999999 + 1e-6;
  *number = value;
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

static void sleep_until(const struct timespec* due) {
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, due, NULL) == EINTR) continue;
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

/* The second thread. It is told of a cycle before the first thread sleeps, sleeps until the same time, moves
 * the second bogie or does its half of the arithmetic, and says so; the first waits for that without
 * sleeping. */
static struct {
  pthread_t thread;
  sem_t told;
  struct timespec due;
  double x, step; /* step 0: arithmetic; < 0: the end */
  long operations;
  volatile double number;
  int done; /* written by __atomic_store_n alone */
} second;

static void* run_second(void* unused) {
  for (;;) {
    while (sem_wait(&second.told) != 0) continue;
    if (second.step < 0.0) return unused;
    sleep_until(&second.due);
    if (second.step > 0.0)
      move_bogie(&vehicle[1], second.x, second.step);
    else
      fixed_arithmetic(&second.number, second.operations);
    __atomic_store_n(&second.done, 1, __ATOMIC_RELEASE);
  }
}

static void tell_second(const struct timespec* due, double x, double step, long operations) {
  second.due = *due;
  second.x = x;
  second.step = step;
  second.operations = operations;
  second.done = 0;
  sem_post(&second.told);
}

static void wait_for_second(void) {
  while (__atomic_load_n(&second.done, __ATOMIC_ACQUIRE) == 0) continue;
}

static int ascending(const void* left, const void* right) {
  const double difference = *(const double*)left - *(const double*)right;
  return (difference > 0.0) - (difference < 0.0);
}

/* Operations of the arithmetic that take as long as a step of the vehicle's first `parts` bogies: medians
 * of 99. */
static long operations_like(int parts, double step) {
  enum { tries = 99, some = 100000 };
  double took[2][tries];
  struct timespec start;
  volatile double number = 0.5;
  for (int i = 0; i < tries; ++i) {
    clock_gettime(CLOCK_MONOTONIC, &start);
    for (int k = 0; k < parts; ++k) move_bogie(&vehicle[k], 0.0, step);
    took[0][i] = microseconds_since(&start);
    clock_gettime(CLOCK_MONOTONIC, &start);
    fixed_arithmetic(&number, some);
    took[1][i] = microseconds_since(&start);
  }
  for (int k = 0; k < 2; ++k) qsort(took[k], tries, sizeof took[k][0], ascending);
  return (long)(took[0][tries / 2] / took[1][tries / 2] * some);
}

/* Cycle i in its kind's turn: sleep, work. */
static void run_cycle(long i, double x, double step, const long operations[2], const struct timespec* due,
                      cycle* times) {
  volatile double number = 0.5;
  const int kind = (int)(i % kinds);
  if (kind == two_threads || kind == as_long_as_two)
    tell_second(due, x, kind == two_threads ? step : 0.0, operations[1]);
  sleep_until(due);
  times->woken = microseconds_since(due);
  if (kind == one_thread)
    for (int k = 0; k < bogies; ++k) move_bogie(&vehicle[k], x, step);
  else if (kind == two_threads)
    move_bogie(&vehicle[0], x, step);
  else
    fixed_arithmetic(&number, operations[kind == as_long_as_two]);
  if (kind == two_threads || kind == as_long_as_two) wait_for_second();
  times->ended = microseconds_since(due);
}

/* Shares of the period that were over when the work ended, and without what the thread woke late. */
static void report(const cycle* cycles, long count, double* room) {
  static const char* const names[kinds] = {"eight wheels, one thread", "arithmetic as long",
                                           "eight wheels, two threads", "arithmetic as long"};
  static const double shares[] = {0.5, 0.99, 0.999, 1.0};
  printf("%-26s %35s %36s %7s\n", "", "work, share of the 0.5 ms", "end, share of the 0.5 ms", "missed");
  printf("%-26s", "");
  for (int i = 0; i < 2; ++i) printf(" %8s %8s %8s %8s ", "p50", "p99", "p99.9", "max");
  printf("\n");
  for (int kind = 0; kind < kinds; ++kind) {
    long missed = 0;
    printf("%-26s", names[kind]);
    for (int with_waking = 0; with_waking < 2; ++with_waking) {
      long n = 0;
      missed = 0;
      for (long i = kind; i < count; i += kinds) {
        room[n] = (cycles[i].ended - (with_waking ? 0.0 : cycles[i].woken)) * 1e3 / period;
        missed += room[n++] > 1.0;
      }
      qsort(room, (size_t)n, sizeof *room, ascending);
      for (int i = 0; i < 4; ++i) printf(" %8.3f", room[(long)(shares[i] * (double)(n - 1))]);
      printf(" ");
    }
    printf(" %6ld\n", missed);
  }
}

static void print_run(long count, long skipped, double metres) {
  long failed = 0, flagged = 0, regions = 0;
  double shift = 0.0, force = 0.0;
  for (int k = 0; k < bogies; ++k) {
    failed += vehicle[k].failed;
    flagged += vehicle[k].flagged;
    regions += vehicle[k].regions;
    shift = fmax(shift, vehicle[k].largest_shift);
    force = fmax(force, vehicle[k].largest_force);
  }
  const double calls = (double)(count / 2 * bogies * sets * wheels);
  printf(
      "\n%ld cycles of %d us, every second with the vehicle's step; %ld periods skipped because a cycle ran "
      "over\n",
      count, period / 1000, skipped);
  printf(
      "%.0f m, %.3f regions a wheel, at most %.2f mm off the track's middle, %.1f kN to the side of a "
      "wheel\n",
      metres, (double)regions / calls, 1e3 * shift, 1e-3 * force);
  printf("%ld calls failed, %ld flagged\n", failed, flagged);
}

static void write_cycles(const char* name, const cycle* cycles, long count) {
  FILE* const file = fopen(name, "w");
  if (file == NULL) stop("cannot write the file");
  fprintf(file, "kind,woken_us,ended_us\n");
  for (long i = 0; i < count; ++i)
    fprintf(file, "%ld,%.3f,%.3f\n", i % kinds, cycles[i].woken, cycles[i].ended);
  fclose(file);
}

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? atof(argv[1]) : 2.0;
  const double step = 1e-9 * period; /* s */
  const long count = (long)(seconds * 1e9 / period) / kinds * kinds;
  if (count < kinds || count > 100000000L) stop("hil_loop [SECONDS [PRESET [FILE.csv]]]");
  wrc_model* model = NULL;
  cycle* const cycles = calloc((size_t)count, sizeof *cycles);
  double* const room = calloc((size_t)count, sizeof *room);
  if (cycles == NULL || room == NULL) stop("out of memory");
  if (!make_vehicle(&model, argc > 2 ? argv[2] : "real time")) stop("no vehicle");
  ask_for_real_time(); /* the second thread inherits it */
  if (sem_init(&second.told, 0, 0) != 0 || pthread_create(&second.thread, NULL, run_second, NULL) != 0)
    stop("no second thread");
  bogie at_start[bogies];
  memcpy(at_start, vehicle, sizeof vehicle);
  const long operations[2] = {operations_like(bogies, step),
                              operations_like(1, step)}; /* warms caches, too */
  memcpy(vehicle, at_start, sizeof vehicle);

  struct timespec due;
  clock_gettime(CLOCK_MONOTONIC, &due);
  long skipped = 0, steps = 0;
  for (long i = 0; i < count; ++i) {
    later(&due, period);
    while (microseconds_since(&due) > 0.0) { /* the last cycle ran over: on with the next one of the grid */
      later(&due, period);
      ++skipped;
    }
    run_cycle(i, speed * step * (double)steps, step, operations, &due, &cycles[i]);
    steps += i % 2 == 0;
  }
  tell_second(&due, 0.0, -1.0, 0);
  pthread_join(second.thread, NULL);

  if (argc > 3) write_cycles(argv[3], cycles, count);
  report(cycles, count, room);
  print_run(count, skipped, speed * step * (double)steps);
  long failed = 0;
  for (int i = 0; i < bogies * sets; ++i) {
    failed += vehicle[i / sets].failed;
    for (int side = 0; side < wheels; ++side)
      wrc_contact_destroy(vehicle[i / sets].set[i % sets].contact[side]);
  }
  wrc_model_destroy(model);
  free(room);
  free(cycles);
  return failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
