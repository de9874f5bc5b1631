/* vehicle.c - a wheelset and a bogie on S1002 and 60E1, integrated implicitly with the library's derivatives.
 *
 *   vehicle [RUN [FILE.csv]]    RUN: klingel, cones, critical, curve, turnout, crossing, flat, irregular; none: all
 *                               of them
 *
 * Two wheelsets carry a frame on primary springs, the frame hangs on secondary ones below a car body that
 * runs on undisturbed. Every body has its place against the track axes where it runs; forward speed is held.
 * SUNDIALS' CVODE (backward differences, Newton with a dense Jacobian) integrates; the Jacobian is that of
 * the springs and of wrc_contact_wrench_derivatives.
 */
#include <cvode/cvode.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <time.h>

#include "wrc/wrc_profiles.h"

enum { Y, Z, ROLL, YAW, PITCH, FREEDOMS }; /* of a body; the pitch is its rate alone */
enum { FRAME = 2, BODIES = 3, N = BODIES * FREEDOMS, STATES = 2 * N };
enum { right = WRC_SIDE_RIGHT, left = WRC_SIDE_LEFT };

static const double radius = 0.46, axle_load = 140e3, half_base = 1.25; /* m, N */
static const double mass[BODIES] = {1500.0, 1500.0, 2600.0};            /* kg */
static const double across[BODIES] = {900.0, 900.0, 1500.0}, about_z[BODIES] = {900.0, 900.0, 2800.0};
static const double about_y[BODIES] = {110.0, 110.0, 1800.0}; /* kg m^2 */
static double tolerance = 1e-5;                  /* relative; of places 1e-3 m of it, of velocities 0.1 m/s */
static double primary_x = 12e6, primary_y = 5e6; /* N/m, of a box */
static double primary_z = 1.2e6;
static const double primary_damping = 8e3, box = 1.0; /* N s/m, m from the middle */
static const double secondary_y = 160e3, secondary_z = 430e3, secondary_yaw = 250e3; /* of a bogie */
static const double secondary_y_damping = 32e3, secondary_z_damping = 30e3, secondary_yaw_damping = 30e3;

/* What a run is made of. */
typedef struct {
  wrc_contact* contact[2][2]; /* of wheelset and side */
  double speed, start;        /* m/s; where the first wheelset is at time 0 [m] */
  double curvature, begins;   /* 1/m, to the right; from there on, over a transition [m] */
  double transition;
  double flat_angle;     /* of the first wheelset's right wheel, which has a flat, at time 0 [rad] */
  int sections[2], flat; /* the rail of a side has sections, the wheel a flat */
  int irregular;
  double stiffness[N][N], damping[N][N];
  double load[N];        /* static */
  int failures, flagged; /* calls; a lifted wheel is no flag */
  double by_time[N];     /* of the accelerations where derivatives were asked for: the rail below changes */
  double wheel_force[2][2][3]; /* of the last evaluation [N] */
} Vehicle;

static void must(int32_t status, const char* what) {
  if (status >= 0) return;
  fprintf(stderr, "%s: %s\n", what, wrc_status_name(status));
  exit(EXIT_FAILURE);
}

/* Adds a spring between two bodies (to < 0: the ground) along the displacements that rows a and b take of
 * them. */
static void add_spring(double matrix[N][N], const double a[N], double k) {
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) matrix[i][j] += k * a[i] * a[j];
}

static void build(Vehicle* v) {
  memset(v->stiffness, 0, sizeof v->stiffness);
  memset(v->damping, 0, sizeof v->damping);
  memset(v->load, 0, sizeof v->load);
  for (int w = 0; w < 2; ++w) {
    const double ahead = w == 0 ? half_base : -half_base;
    for (int side = 0; side < 2; ++side) {
      const double out = side == 0 ? box : -box;
      double x[N] = {0}, y[N] = {0}, z[N] = {0};
      x[FREEDOMS * w + YAW] = -out; /* forwards: -yaw * y */
      x[FREEDOMS * FRAME + YAW] = out;
      y[FREEDOMS * w + Y] = 1.0;
      y[FREEDOMS * FRAME + Y] = -1.0;
      y[FREEDOMS * FRAME + YAW] = -ahead;
      z[FREEDOMS * w + Z] = 1.0;
      z[FREEDOMS * w + ROLL] = out;
      z[FREEDOMS * FRAME + Z] = -1.0;
      z[FREEDOMS * FRAME + ROLL] = -out;
      z[FREEDOMS * FRAME + PITCH] = ahead; /* downwards: -pitch * x */
      add_spring(v->stiffness, x, primary_x);
      add_spring(v->stiffness, y, primary_y);
      add_spring(v->stiffness, z, primary_z);
      add_spring(v->damping, z, primary_damping);
    }
  }
  double y[N] = {0}, z[N] = {0}, roll[N] = {0}, yaw[N] = {0}, pitch[N] = {0};
  y[FREEDOMS * FRAME + Y] = z[FREEDOMS * FRAME + Z] = roll[FREEDOMS * FRAME + ROLL] = 1.0;
  yaw[FREEDOMS * FRAME + YAW] = pitch[FREEDOMS * FRAME + PITCH] = 1.0;
  add_spring(v->stiffness, y, secondary_y);
  add_spring(v->damping, y, secondary_y_damping);
  add_spring(v->stiffness, z, secondary_z);
  add_spring(v->damping, z, secondary_z_damping);
  add_spring(v->stiffness, roll, secondary_z);
  add_spring(v->damping, roll, secondary_z_damping);
  add_spring(v->stiffness, yaw, secondary_yaw);
  add_spring(v->damping, yaw, secondary_yaw_damping);
  add_spring(v->damping, pitch, 1e4);
  for (int w = 0; w < 2; ++w) v->load[FREEDOMS * w + Z] = axle_load;
}

static double curvature_at(const Vehicle* v, double distance) {
  const double t = (distance - v->begins) / (v->transition > 0.0 ? v->transition : 1.0);
  return v->curvature * (t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t * t * (3.0 - 2.0 * t));
}

/* Both rails' displacement to the side and its slope: 40 waves of 3 to 60 m in geometric steps, amplitudes in
 * proportion to them, 1.5 mm in the root mean square, faded in over 10 m. */
static double irregularity(const Vehicle* v, double distance, double* slope) {
  enum { waves = 40 };
  const double turn = 6.283185307179586, t = fmin(fmax(distance / 10.0, 0.0), 1.0);
  const double fade = t * t * (3.0 - 2.0 * t), fading = 0.6 * t * (1.0 - t);
  double y = 0.0, by_x = 0.0, square = 0.0;
  *slope = 0.0;
  if (!v->irregular) return 0.0;
  for (int k = 1; k <= waves; ++k) {
    const double length = 3.0 * pow(20.0, (k - 1) / (waves - 1.0));
    const double angle = turn * (distance / length + fmod(0.618034 * k, 1.0));
    y += length * cos(angle);
    by_x -= turn * sin(angle);
    square += 0.5 * length * length;
  }
  const double scale = 1.5e-3 / sqrt(square);
  *slope = scale * (fade * by_x + fading * y);
  return scale * fade * y;
}

/* What the element is given. */
static void input_of(const Vehicle* v, double t, const double* s, int w, int side, wrc_wheel_input* input) {
  const double *q = s + FREEDOMS * w, *rate = s + N + FREEDOMS * w;
  const double distance = v->start + v->speed * t - (w == 0 ? 0.0 : 2.0 * half_base);
  wrc_wheel_state* wheel = &input->wheel;
  *input = wrc_wheel_input_default();
  input->start = WRC_START_WARM;
  input->damping = 0.05;
  wheel->y = q[Y];
  wheel->z = q[Z];
  wheel->roll = q[ROLL];
  wheel->yaw = q[YAW];
  wheel->velocity[0] = v->speed;
  wheel->velocity[1] = rate[Y];
  wheel->velocity[2] = rate[Z];
  wheel->roll_rate = rate[ROLL];
  wheel->pitch_rate = -v->speed / radius + rate[PITCH];
  wheel->yaw_rate = rate[YAW] + v->speed * curvature_at(v, distance);
  input->rail.y = irregularity(v, distance, &input->rail.y_slope);
  if (v->sections[side]) input->distance = distance;
  if (side == right && w == 0 && v->flat) input->angle = v->flat_angle - v->speed / radius * t;
}

/* Accelerations, and if wanted their derivatives. */
static int motion(double t, const double* s, double* d, SUNMatrix J, Vehicle* v) {
  double force[N];
  if (J) SUNMatZero(J);
  for (int i = 0; i < N; ++i) d[i] = s[N + i];
  for (int i = 0; i < N; ++i) d[i] = i % FREEDOMS == PITCH && i < FREEDOMS * FRAME ? 0.0 : d[i];
  /* bodies stand in line with the track below them: in a curve the frame sees wheelsets turned and aside */
  double q[N];
  memcpy(q, s, sizeof q);
  const double middle = v->start + v->speed * t - half_base, bend = curvature_at(v, middle);
  q[YAW] += half_base * bend;
  q[FREEDOMS + YAW] -= half_base * bend;
  q[Y] += 0.5 * half_base * half_base * bend;
  q[FREEDOMS + Y] += 0.5 * half_base * half_base * bend;
  for (int i = 0; i < N; ++i) {
    force[i] = v->load[i];
    for (int j = 0; j < N; ++j) force[i] -= v->stiffness[i][j] * q[j] + v->damping[i][j] * s[N + j];
  }
  static const int row[FREEDOMS] = {1, 2, 3, 5, 4}; /* of the wrench: Fy, Fz, Mx, Mz, My */
  static double slope[N][STATES];
  if (J) memset(slope, 0, sizeof slope);
  if (J) memset(v->by_time, 0, sizeof v->by_time);
  for (int w = 0; w < 2; ++w) {
    for (int side = 0; side < 2; ++side) {
      wrc_wheel_input input;
      input_of(v, t, s, w, side, &input);
      wrc_wrench wrench = {.struct_size = sizeof wrench};
      wrc_wrench_derivatives by = {.struct_size = sizeof by};
      const int32_t status = J ? wrc_contact_wrench_derivatives(v->contact[w][side], &input, &wrench, &by)
                               : wrc_contact_wrench(v->contact[w][side], &input, &wrench);
      if (status < 0) {
        ++v->failures;
        return 1; /* recoverable: CVODE takes a smaller step */
      }
      v->flagged += wrench.flags != 0 && (wrench.flags >> WRC_FLAG_NO_CONTACT & 1u) == 0;
      memcpy(v->wheel_force[w][side], wrench.force, sizeof wrench.force);
      const double all[6] = {wrench.force[0],  wrench.force[1],  wrench.force[2],
                             wrench.moment[0], wrench.moment[1], wrench.moment[2]};
      static const int by_place[FREEDOMS] = {WRC_BY_Y, WRC_BY_Z, WRC_BY_ROLL, WRC_BY_YAW, -1};
      static const int by_rate[FREEDOMS] = {WRC_BY_VELOCITY_Y, WRC_BY_VELOCITY_Z, WRC_BY_ANGULAR_VELOCITY_X,
                                            WRC_BY_ANGULAR_VELOCITY_Z, WRC_BY_ANGULAR_VELOCITY_Y};
      for (int i = 0; i < FREEDOMS; ++i) {
        force[FREEDOMS * w + i] += all[row[i]];
        if (J && v->sections[side])
          v->by_time[FREEDOMS * w + i] += v->speed * by.wrench[row[i]][WRC_BY_DISTANCE];
        for (int j = 0; J && j < FREEDOMS; ++j) {
          if (by_place[j] >= 0) slope[FREEDOMS * w + i][FREEDOMS * w + j] += by.wrench[row[i]][by_place[j]];
          slope[FREEDOMS * w + i][N + FREEDOMS * w + j] += by.wrench[row[i]][by_rate[j]];
        }
      }
    }
  }
  for (int w = 0; w < 2; ++w) { /* what turns about its axle resists other turning */
    const double spin = about_y[w] * -v->speed / radius;
    force[FREEDOMS * w + ROLL] += spin * s[N + FREEDOMS * w + YAW];
    force[FREEDOMS * w + YAW] -= spin * s[N + FREEDOMS * w + ROLL];
    if (!J) continue;
    slope[FREEDOMS * w + ROLL][N + FREEDOMS * w + YAW] += spin;
    slope[FREEDOMS * w + YAW][N + FREEDOMS * w + ROLL] -= spin;
  }
  for (int i = 0; i < N; ++i) {
    const int body = i / FREEDOMS, k = i % FREEDOMS;
    const double inertia = k < ROLL    ? mass[body]
                           : k == ROLL ? across[body]
                           : k == YAW  ? about_z[body]
                                       : about_y[body];
    d[N + i] = force[i] / inertia;
    if (!J) continue;
    v->by_time[i] /= inertia;
    for (int j = 0; j < N; ++j) {
      SM_ELEMENT_D(J, N + i, j) = (slope[i][j] - v->stiffness[i][j]) / inertia;
      SM_ELEMENT_D(J, N + i, N + j) = (slope[i][N + j] - v->damping[i][j]) / inertia;
    }
    if (!(k == PITCH && body < FRAME)) SM_ELEMENT_D(J, i, N + i) = 1.0;
  }
  return 0;
}

static int right_side(realtype t, N_Vector s, N_Vector d, void* user) {
  return motion(t, N_VGetArrayPointer(s), N_VGetArrayPointer(d), NULL, (Vehicle*)user);
}

static int jacobian(realtype t, N_Vector s, N_Vector f, SUNMatrix J, void* user, N_Vector a, N_Vector b,
                    N_Vector c) {
  (void)f, (void)a, (void)b, (void)c;
  double d[STATES];
  return motion(t, N_VGetArrayPointer(s), d, J, (Vehicle*)user);
}

/* Integrates from `s` over a time, calls `look` every `every` seconds; returns the time it took over the
 * time simulated. */
typedef void (*Look)(double t, const double* s, const Vehicle* v, void* told);
static double integrate(Vehicle* v, double* s, double until, double every, Look look, void* told) {
  SUNContext context;
  if (SUNContext_Create(NULL, &context)) exit(EXIT_FAILURE);
  N_Vector state = N_VMake_Serial(STATES, s, context);
  void* solver = CVodeCreate(CV_BDF, context);
  SUNMatrix matrix = SUNDenseMatrix(STATES, STATES, context);
  SUNLinearSolver linear = SUNLinSol_Dense(state, matrix, context);
  N_Vector absolute = N_VNew_Serial(STATES, context);
  for (int i = 0; i < STATES; ++i) N_VGetArrayPointer(absolute)[i] = tolerance * (i < N ? 1e-3 : 0.1);
  CVodeInit(solver, right_side, 0.0, state);
  CVodeSVtolerances(solver, tolerance, absolute);
  CVodeSetUserData(solver, v);
  CVodeSetLinearSolver(solver, linear, matrix);
  CVodeSetJacFn(solver, jacobian);
  CVodeSetMaxNumSteps(solver, 200000);
  CVodeSetMaxOrd(solver, 2); /* A-stable: over oscillations of the contact that nobody asks for */
  CVodeSetMaxStep(solver, every);
  const clock_t began = clock();
  for (double t = 0.0, next = every; next < until + 0.5 * every; next += every) {
    if (CVode(solver, next, state, &t, CV_NORMAL) < 0) {
      fprintf(stderr, "CVODE gave up at %g s, %d calls refused\n", t, v->failures);
      break;
    }
    double d[STATES];
    motion(next, N_VGetArrayPointer(state), d, NULL, v);
    if (look) look(next, N_VGetArrayPointer(state), v, told);
  }
  const double took = (double)(clock() - began) / CLOCKS_PER_SEC;
  CVodeFree(&solver);
  SUNLinSolFree(linear);
  SUNMatDestroy(matrix);
  N_VDestroy(absolute);
  N_VDestroy(state);
  SUNContext_Free(&context);
  return took / until;
}

static wrc_config pair_of_profiles(void) {
  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_60E1;
  config.track.rail_inclination = 1.0 / 40.0;
  config.wheelset.wheel_radius = radius;
  return config;
}

/* Contacts; `plain`: NULL: the usual pair of profiles; `special`: the model of the first wheelset's wheel on
 * the side `on`, or of both wheels there. */
static wrc_model* models[2];
static void open_contacts(Vehicle* v, const wrc_config* plain, const wrc_config* special, int on, int both) {
  memset(v, 0, sizeof *v);
  const wrc_config usual = pair_of_profiles();
  char text[300] = "";
  models[1] = NULL;
  must(wrc_model_create(plain ? plain : &usual, NULL, &models[0], text, sizeof text), text);
  if (special) must(wrc_model_create(special, NULL, &models[1], text, sizeof text), text);
  for (int w = 0; w < 2; ++w)
    for (int side = 0; side < 2; ++side)
      must(wrc_contact_create(special && side == on && (both || w == 0) ? models[1] : models[0], side, NULL,
                              &v->contact[w][side], text, sizeof text),
           text);
  build(v);
}
static void close_contacts(Vehicle* v) {
  for (int w = 0; w < 2; ++w)
    for (int side = 0; side < 2; ++side) wrc_contact_destroy(v->contact[w][side]);
  for (int k = 0; k < 2; ++k) wrc_model_destroy(models[k]);
}

/* Height at which a wheel in the middle stands. */
static double standing_height(Vehicle* v, const double* s, int w, int side) {
  wrc_wheel_input input;
  input_of(v, 0.0, s, w, side, &input);
  input.damping = 0.0;
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 0.5 * axle_load;
  wrc_wrench wrench = {.struct_size = sizeof wrench};
  must(wrc_contact_wrench(v->contact[w][side], &input, &wrench), "standing");
  return wrench.z;
}

/* Standing in the middle: on two kinds of rail between the heights of both wheels. Springs are at rest. */
static void stand(Vehicle* v, double* s) {
  memset(s, 0, STATES * sizeof *s);
  const double height = standing_height(v, s, 1, left);
  for (int w = 0; w < 2; ++w)
    s[FREEDOMS * w + Z] = v->sections[0] || v->sections[1]
                              ? 0.5 * (standing_height(v, s, w, right) + standing_height(v, s, w, left))
                              : height;
  double q[N];
  memcpy(q, s, sizeof q);
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) v->load[i] += v->stiffness[i][j] * q[j];
}

/* ------------------------------------------------------------------------------------------------- looking
 */

typedef struct {
  FILE* file;
  const char* run;
  double value; /* what tells runs of one name apart */
  double at[3], y[3];
  double crossed[64];
  int crossings, peaks;
  double amplitude[4096], time[4096];
  double largest_lateral, largest_vertical, least_vertical;
} Told;

static void look(double t, const double* s, const Vehicle* v, void* user) {
  Told* told = (Told*)user;
  told->at[0] = told->at[1], told->at[1] = told->at[2], told->at[2] = t;
  told->y[0] = told->y[1], told->y[1] = told->y[2], told->y[2] = s[Y];
  if (told->at[0] > 0.0) {
    if (told->y[1] < 0.0 && told->y[2] >= 0.0 && told->crossings < 64)
      told->crossed[told->crossings++] =
          told->at[1] + (told->at[2] - told->at[1]) * told->y[1] / (told->y[1] - told->y[2]);
    const double a = fabs(told->y[0]), b = fabs(told->y[1]), c = fabs(told->y[2]);
    if (b > a && b >= c && told->peaks < 4096) {
      const double bend = a - 2.0 * b + c, step = told->at[2] - told->at[1];
      told->amplitude[told->peaks] = bend < 0.0 ? b - 0.125 * (c - a) * (c - a) / bend : b;
      told->time[told->peaks++] = told->at[1] - (bend < 0.0 ? 0.5 * step * (c - a) / bend : 0.0);
    }
  }
  const double* f = v->wheel_force[0][right];
  double slope;
  const double lateral = fmax(fabs(f[1]), fabs(v->wheel_force[0][left][1]));
  told->largest_lateral = fmax(told->largest_lateral, lateral);
  told->largest_vertical = fmax(told->largest_vertical, -f[2]);
  told->least_vertical = told->least_vertical == 0.0 ? -f[2] : fmin(told->least_vertical, -f[2]);
  if (told->file)
    fprintf(told->file, "%s,%g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", told->run, told->value,
            t, v->start + v->speed * t, s[Y], s[YAW], s[FREEDOMS + Y], f[1], f[2], v->wheel_force[0][left][1],
            v->wheel_force[0][left][2], irregularity(v, v->start + v->speed * t, &slope));
}

/* ------------------------------------------------------------------------------------------------- runs */

/* A wheelset so slow that it has no inertia: its rates along y, about z and its axle, its height and its roll
 * are those at which no force is left but the load. How fast these two follow y and yaw counts: a wheelset
 * that rolls about x carries its wheels' feet aside. */
enum { SLOW = 5 };
static void slow_rates(Vehicle* v, double y, double yaw, double u[SLOW]) {
  static const int row[SLOW] = {1, 5, 4, 2, 3};
  static const int column[SLOW + 2] = {WRC_BY_VELOCITY_Y,
                                       WRC_BY_ANGULAR_VELOCITY_Z,
                                       WRC_BY_ANGULAR_VELOCITY_Y,
                                       WRC_BY_Z,
                                       WRC_BY_ROLL,
                                       WRC_BY_Y,
                                       WRC_BY_YAW};
  double rates[2] = {0.0, 0.0}; /* of height and roll */
  for (int n = 0; n < 4; ++n) {
    double a[SLOW][SLOW + 3] = {{0}}; /* what is left, and the columns of y and yaw, behind those of u */
    a[3][SLOW] = -axle_load;
    for (int side = 0; side < 2; ++side) {
      wrc_wheel_input input = wrc_wheel_input_default();
      input.wheel.y = y, input.wheel.z = u[3], input.wheel.roll = u[4], input.wheel.yaw = yaw;
      input.wheel.velocity[0] = 1.0, input.wheel.velocity[1] = u[0], input.wheel.velocity[2] = rates[0];
      input.wheel.roll_rate = rates[1], input.wheel.pitch_rate = u[2], input.wheel.yaw_rate = u[1];
      wrc_wrench w = {.struct_size = sizeof w};
      wrc_wrench_derivatives by = {.struct_size = sizeof by};
      must(wrc_contact_wrench_derivatives(v->contact[0][side], &input, &w, &by), "slow rolling");
      const double all[6] = {w.force[0], w.force[1], w.force[2], w.moment[0], w.moment[1], w.moment[2]};
      for (int i = 0; i < SLOW; ++i) {
        a[i][SLOW] -= all[row[i]];
        for (int j = 0; j < SLOW; ++j) a[i][j] += by.wrench[row[i]][column[j]];
        for (int j = 0; j < 2; ++j) a[i][SLOW + 1 + j] -= by.wrench[row[i]][column[SLOW + j]];
      }
    }
    for (int k = 0; k < SLOW; ++k) {
      int pivot = k;
      for (int i = k + 1; i < SLOW; ++i)
        if (fabs(a[i][k]) > fabs(a[pivot][k])) pivot = i;
      for (int j = 0; j < SLOW + 3; ++j) {
        const double other = a[pivot][j];
        a[pivot][j] = a[k][j], a[k][j] = other;
      }
      for (int i = 0; i < SLOW; ++i) {
        const double f = a[i][k] / a[k][k];
        for (int j = 0; i != k && j < SLOW + 3; ++j) a[i][j] -= f * a[k][j];
      }
    }
    for (int k = 0; k < SLOW; ++k) u[k] += a[k][SLOW] / a[k][k];
    for (int k = 0; k < 2; ++k)
      rates[k] = (a[3 + k][SLOW + 1] * u[0] + a[3 + k][SLOW + 2] * u[1]) / a[3 + k][3 + k];
  }
}

/* Its wave [m], by the rule of the middle. */
static double slow_wave(Vehicle* v, double amplitude, double height) {
  const double step = 0.15;
  double at[2] = {amplitude, 0.0}, u[SLOW] = {0.0, 0.0, -1.0 / radius, height, 0.0}, first = 0.0, last = 0.0;
  int crossings = 0;
  for (int i = 1; i <= 10; ++i) slow_rates(v, 0.1 * i * amplitude, 0.0, u); /* not in one leap */
  for (double x = 0.0; x < 36.0; x += step) {
    const double before = at[0];
    slow_rates(v, at[0], at[1], u);
    slow_rates(v, at[0] + 0.5 * step * u[0], at[1] + 0.5 * step * u[1], u);
    at[0] += step * u[0], at[1] += step * u[1];
    if (before < 0.0 && at[0] >= 0.0) {
      last = x + step * before / (before - at[0]);
      if (crossings++ == 0) first = last;
    }
  }
  return crossings > 1 ? (last - first) / (crossings - 1) : 0.0;
}

/* Waves of a wheelset left to itself at 1 m/s: integrated in time, as slow rolling, and by Klingel's
 * kinematics, which know nothing but rolling radii and roll. Cones on round rails touch them in places that
 * hardly move; S1002 lies on 60E1 over a width in which the radii differ, and what steers it there are forces
 * within that width. */
static void waves(FILE* file, const char* name, const wrc_config* config, const double* amplitude,
                  int amplitudes) {
  enum { points = 161 };
  static double y[points], dr[points], roll[points];
  char text[256] = "";
  Vehicle v;
  open_contacts(&v, config, NULL, right, 0);
  wrc_wheelset_geometry_problem where = {.struct_size = sizeof where};
  for (int i = 0; i < points; ++i) y[i] = 0.05e-3 * (i - points / 2);
  where.count = points;
  where.lateral = y;
  where.wheel_load = 0.5 * axle_load;
  wrc_wheelset_geometry functions = {.struct_size = sizeof functions};
  functions.radius_difference = dr;
  functions.roll = roll;
  must(wrc_profile_wheelset_geometry(models[0], &where, &functions, text, sizeof text), text);
  for (int k = 0; k < amplitudes; ++k) {
    double s[STATES];
    v.speed = 1.0;
    build(&v);
    stand(&v, s);
    const double height = s[Z];
    wrc_region region = {.struct_size = sizeof region}; /* of the last wheel that stood, a left one */
    must(wrc_contact_region(v.contact[1][left], 0, &region), "region");
    s[Y] = amplitude[k];
    Told told = {.file = file, .run = name, .value = amplitude[k]};
    const double factor = integrate(&v, s, 36.0, 0.05, look, &told);
    double wave = 0.0, mean = 0.0, kinematic = 0.0;
    if (told.crossings > 1)
      wave = v.speed * (told.crossed[told.crossings - 1] - told.crossed[0]) / (told.crossings - 1);
    for (int i = 0; i < told.peaks; ++i) mean += told.amplitude[i] / told.peaks;
    /* y'' + dr / (e r) = 0 of what the wheels' feet do, who are aside by the roll, too */
    double feet[points];
    for (int i = 0; i < points; ++i) feet[i] = y[i] - radius * roll[i];
    const int near = points / 2 + (int)(mean / (y[1] - y[0]));
    const double swung = mean;
    mean *= feet[near] / y[near];
    wrc_conicity_problem problem = wrc_conicity_problem_default();
    problem.count = points;
    problem.lateral = feet;
    problem.radius_difference = dr;
    problem.amplitude_count = 1;
    problem.amplitudes = &mean;
    problem.contact_distance = -2.0 * region.point[1];
    problem.radius = radius;
    wrc_conicity result = {.struct_size = sizeof result};
    result.wavelength = &kinematic;
    must(wrc_equivalent_conicity(&problem, &result, text, sizeof text), text);
    const double slow = slow_wave(&v, amplitude[k], height);
    printf(
        "%s: from %.1f mm, mean amplitude %.3f mm: wave of %.3f m; slow rolling %.3f m (%+.2f %%), "
        "Klingel with the rolling radii %.3f m (%+.2f %%); real-time factor %.3f\n",
        name, 1e3 * amplitude[k], 1e3 * swung, wave, slow, 100.0 * (wave / slow - 1.0), kinematic,
        100.0 * (wave / kinematic - 1.0), factor);
    if (file) fprintf(file, "%s_wave,%g,%g,%g,%g,0,0,0,0,0,0,0\n", name, swung, wave, slow, kinematic);
    fflush(stdout);
  }
  close_contacts(&v);
}

static void left_to_itself(FILE* file, const char* name, const wrc_config* config, int amplitudes) {
  const double amplitude[3] = {1e-3, 2e-3, 3e-3}, kx = primary_x, ky = primary_y, kz = primary_z;
  primary_x = primary_y = primary_z = 0.0; /* nothing but its load */
  waves(file, name, config, amplitude, amplitudes);
  primary_x = kx, primary_y = ky, primary_z = kz;
}

static void klingel(FILE* file) {
  const wrc_config config = pair_of_profiles();
  left_to_itself(file, "klingel", &config, 3);
}

static void cones(FILE* file) {
  wrc_config config = pair_of_profiles();
  double y[] = {-60e-3, -30e-3, 0.0, 30e-3, 60e-3}, z[5];
  for (int i = 0; i < 5; ++i) z[i] = -0.05 * y[i];
  config.wheel.kind = WRC_PROFILE_POINTS;
  config.wheel.count = 5;
  config.wheel.y = y;
  config.wheel.z = z;
  config.track.rail_inclination = 1.0 / 20.0; /* so that it touches in the middle of the head */
  left_to_itself(file, "cones", &config, 1);
}

/* Largest growth rate of the linearised motion [1/s]: norm of exp(A t) over a long time, by squaring. `mode`:
 * what grows like that, 1 m at the first wheelset. */
static double growth(Vehicle* v, const double* s, double* mode) {
  SUNContext context;
  if (SUNContext_Create(NULL, &context)) exit(EXIT_FAILURE);
  SUNMatrix J = SUNDenseMatrix(STATES, STATES, context);
  double d[STATES];
  static double e[STATES][STATES], term[STATES][STATES], next[STATES][STATES];
  motion(0.0, s, d, J, v);
  const double step = 1e-5;
  for (int i = 0; i < STATES; ++i)
    for (int j = 0; j < STATES; ++j) e[i][j] = term[i][j] = i == j;
  for (int k = 1; k < 14; ++k) {
    for (int i = 0; i < STATES; ++i)
      for (int j = 0; j < STATES; ++j) {
        double sum = 0.0;
        for (int m = 0; m < STATES; ++m) sum += SM_ELEMENT_D(J, i, m) * term[m][j];
        next[i][j] = sum * step / k;
      }
    memcpy(term, next, sizeof term);
    for (int i = 0; i < STATES; ++i)
      for (int j = 0; j < STATES; ++j) e[i][j] += term[i][j];
  }
  for (int i = PITCH; i < FREEDOMS * FRAME; i += FREEDOMS) e[i][i] = 0.0; /* angles that nothing depends on */
  double logarithm = 0.0, time = step;
  const int squarings = 27; /* 1300 s */
  for (int n = 0; n < squarings; ++n) {
    double norm = 0.0;
    for (int i = 0; i < STATES; ++i)
      for (int j = 0; j < STATES; ++j) {
        double sum = 0.0;
        for (int m = 0; m < STATES; ++m) sum += e[i][m] * e[m][j];
        next[i][j] = sum;
        norm = fmax(norm, fabs(sum));
      }
    for (int i = 0; i < STATES; ++i)
      for (int j = 0; j < STATES; ++j) e[i][j] = next[i][j] / norm;
    logarithm = 2.0 * logarithm + log(norm);
    time *= 2.0;
  }
  for (int i = 0; mode && i < STATES; ++i)
    mode[i] = e[i][Y] / e[Y][Y]; /* what is left of a start with y alone */
  SUNMatDestroy(J);
  SUNContext_Free(&context);
  return logarithm / time;
}

/* Growth rate and last amplitude of a motion, from its peaks but the first quarter; 0 without peaks. */
static double rate_of(const Told* told, double* amplitude) {
  const int first = told->peaks / 4, last = told->peaks - 1;
  *amplitude = told->peaks > 2 ? 0.5 * (told->amplitude[last] + told->amplitude[last - 1]) : 0.0;
  if (last - first < 3) return 0.0;
  double t = 0.0, a = 0.0, tt = 0.0, ta = 0.0;
  const double n = last - first + 1;
  for (int i = first; i <= last; ++i) {
    t += told->time[i] / n;
    a += log(told->amplitude[i]) / n;
  }
  for (int i = first; i <= last; ++i) {
    tt += (told->time[i] - t) * (told->time[i] - t);
    ta += (told->time[i] - t) * (log(told->amplitude[i]) - a);
  }
  return ta / tt;
}

/* Moves on from `s` for a time and says how the amplitude grew. */
static double went(Vehicle* v, double* s, double time, double* amplitude, double* factor) {
  static Told told;
  memset(&told, 0, sizeof told);
  *factor = integrate(v, s, time, 4e-3, look, &told);
  return rate_of(&told, amplitude);
}

/* Rolls straight at a speed in the shape of a mode, with that amplitude of the first wheelset. */
static void swing(const double* stands, const double* mode, double amplitude, double* s) {
  for (int i = 0; i < STATES; ++i) s[i] = stands[i] + amplitude * mode[i];
}

static void critical(FILE* file) {
  Vehicle v;
  double stands[STATES], s[STATES], mode[STATES], amplitude, factor;
  open_contacts(&v, NULL, NULL, right, 0);
  double low = 10.0, high = 180.0;
  for (int n = 0; n < 20; ++n) {
    v.speed = 0.5 * (low + high);
    build(&v);
    stand(&v, stands);
    if (growth(&v, stands, mode) > 0.0)
      high = v.speed;
    else
      low = v.speed;
  }
  const double linear = 0.5 * (low + high);
  printf("critical: linearised %.2f m/s (%.0f km/h)\n", linear, 3.6 * linear);
  fflush(stdout);
  if (file) fprintf(file, "linear,%g,0,0,0,0,0,0,0,0,0,0\n", linear);
  const double usual = tolerance;
  tolerance = 1e-6;
  double rate[2]; /* of small motions on both sides of it, in time */
  const double speeds[2] = {0.97 * linear, 1.03 * linear};
  for (int k = 0; k < 2; ++k) {
    v.speed = speeds[k];
    build(&v);
    stand(&v, stands);
    const double expected = growth(&v, stands, mode);
    swing(stands, mode, 20e-6, s);
    rate[k] = went(&v, s, 1.5, &amplitude, &factor);
    printf(
        "critical: %.2f m/s, growth of 0.02 mm in time %.3f 1/s, linearised %.3f 1/s; real-time factor "
        "%.2f\n",
        v.speed, rate[k], expected, factor);
    fflush(stdout);
  }
  const double found = speeds[0] - rate[0] * (speeds[1] - speeds[0]) / (rate[1] - rate[0]);
  printf("critical: in time %.2f m/s (%+.2f %% from linearised)\n", found, 100.0 * (found / linear - 1.0));
  /* limit cycles: the stable ones followed downwards, each from the one before, until there is none */
  enum { most = 14 };
  tolerance = 1e-4; /* where flanges strike the rails, steps are short */
  static double cycle[STATES];
  double upper = 0.0;
  for (int k = 0; k < most; ++k) {
    v.speed = linear * (k < 3 ? 1.06 - 0.03 * k : 1.03 - 0.012 * k);
    build(&v);
    stand(&v, stands);
    if (k == 0) {
      growth(&v, stands, mode);
      swing(stands, mode, 3e-3, s);
    }
    double now = 0.0, r = 0.0;
    for (int part = 0; part < (k == 0 ? 8 : 4); ++part) { /* 2.4 s at most */
      r = went(&v, s, 0.6, &now, &factor);
      if (now < 0.3e-3 || fabs(r) < 0.03) break;
    }
    const int there = now > 0.3e-3 && (r > -0.15 || k == 0);
    printf("critical: %.1f m/s: %s %.2f mm, changing by %.2f 1/s; real-time factor %.2f\n", v.speed,
           there ? "limit cycle of" : "no limit cycle, left of the one before", 1e3 * now, r, factor);
    fflush(stdout);
    if (file) fprintf(file, "%s,%g,1,0,%g,0,0,0,0,0,0,0\n", there ? "cycle" : "none", v.speed, now);
    if (!there) break;
    memcpy(cycle, s, sizeof cycle);
    upper = now;
    if (v.speed > 0.99 * linear) continue;
    /* below the linear speed small motions die out: between them and the cycle is one that is left both ways
     */
    double below = 0.0, above = 1.0;
    for (int n = 0; n < 4; ++n) {
      const double part = 0.5 * (below + above);
      for (int i = 0; i < STATES; ++i) s[i] = stands[i] + part * (cycle[i] - stands[i]);
      if (went(&v, s, 0.5, &now, &factor) < 0.0)
        below = part;
      else
        above = part;
    }
    printf("critical: %.1f m/s: motions below %.2f to %.2f mm die out\n", v.speed, 1e3 * below * upper,
           1e3 * above * upper);
    fflush(stdout);
    if (file) fprintf(file, "cycle,%g,0,0,%g,0,0,0,0,0,0,0\n", v.speed, 0.5 * (below + above) * upper);
    memcpy(s, cycle, sizeof cycle);
  }
  tolerance = usual;
  close_contacts(&v);
}

/* To the right, canted so that what the bodies' way round needs in force is there. */
static void curve(FILE* file) {
  Vehicle v;
  double s[STATES];
  open_contacts(&v, NULL, NULL, right, 0);
  v.speed = 15.0;
  v.curvature = 1.0 / 300.0;
  v.begins = 10.0;
  v.transition = 30.0;
  stand(&v, s);
  Told told = {.file = file, .run = "curve", .value = 300.0};
  const double factor = integrate(&v, s, 5.0, 0.01, look, &told);
  printf(
      "curve: radius 300 m at %.0f m/s: first wheelset at %.2f mm, yaw %.2f mrad, outer wheel %.1f kN "
      "lateral; real-time factor %.3f\n",
      v.speed, 1e3 * s[Y], 1e3 * s[YAW], 1e-3 * v.wheel_force[0][left][1], factor);
  close_contacts(&v);
}

static void turnout(FILE* file) {
  /* the stock rail leaves outwards, the blade rises beside it from below */
  static wrc_rail_section section[12];
  int n = 0;
  for (int k = 0; k < 7; ++k, ++n) {
    const double t = k < 2 ? 0.0 : (k - 1) * 0.5;
    section[n].distance = k < 6 ? 10.0 * (k > 0) + 1.0 * (k > 1 ? k - 1 : 0) : 100.0;
    section[n].y = 6e-3 * t * t;
    section[n].profile.kind = WRC_PROFILE_60E1;
  }
  for (int k = 0; k < 5; ++k, ++n) {
    static const double at[5] = {10.5, 11.5, 12.5, 13.5, 100.0}, deep[5] = {6e-3, 3e-3, 0.6e-3, 0.0, 0.0};
    section[n].surface = 1;
    section[n].distance = at[k];
    section[n].z = deep[k];
    section[n].profile.kind = WRC_PROFILE_60E1;
  }
  wrc_config config = pair_of_profiles();
  config.rail_section_count = (uint32_t)n;
  config.rail_section_size = sizeof section[0];
  config.rail_sections = section;
  config.rail_section_size = sizeof *section;
  for (int k = 0; k < 2; ++k) {
    Vehicle v;
    double s[STATES];
    open_contacts(&v, NULL, &config, right, 1);
    v.sections[right] = 1;
    v.start = 4.0;
    v.speed = (k == 0 ? 40.0 : 80.0) / 3.6;
    stand(&v, s);
    Told told = {.file = file, .run = "turnout", .value = 3.6 * v.speed};
    const double factor = integrate(&v, s, 16.0 / v.speed, 0.01 / v.speed, look, &told);
    printf("turnout at %.0f km/h: vertical %.1f to %.1f kN, lateral up to %.1f kN; real-time factor %.3f\n",
           3.6 * v.speed, 1e-3 * told.least_vertical, 1e-3 * told.largest_vertical,
           1e-3 * told.largest_lateral, factor);
    close_contacts(&v);
  }
}

/* ------------------------------------------------------------------------------------------------ crossing
 */

/* A line across the track, as an instrument has it. */
enum { line_points = 900, lines_most = 64 };
typedef struct {
  uint32_t count;
  double y[line_points], z[line_points];
} Line;

static void add_point(Line* line, double y, double z) {
  if (line->count == line_points) exit(EXIT_FAILURE);
  line->y[line->count] = y;
  line->z[line->count++] = z;
}

/* Adds a rail's head between two edges, from the depth to the field depth: flanks that lean 1:20, elliptic
 * corners twice as wide as high, a crown of 300 mm radius that is canted 1:40 where it is 70 mm wide. A round
 * bottom joins it to the head before. */
static void add_head(Line* line, double gauge, double field, double top, double corner, double depth,
                     double field_depth) {
  const double spacing = 5e-4, quarter = 1.5707963267948966,
               wide = fmin(2.0 * corner, 0.45 * (field - gauge));
  static Line head;
  head.count = 0;
  const int down = (int)ceil((depth - corner) / spacing - 1e-9);
  for (int i = down - 1; i > 0; --i) add_point(&head, gauge - 0.05 * i * spacing, corner + i * spacing);
  for (int i = 0; i < 40; ++i)
    add_point(&head, gauge + wide * (1.0 - cos(quarter * i / 39)), corner * (1.0 - sin(quarter * i / 39)));
  const int level = (int)ceil((field - gauge - 2.0 * wide) / spacing - 1e-9);
  for (int i = 1; i < level; ++i) add_point(&head, gauge + wide + i * spacing, 0.0);
  for (int i = 39; i >= 0; --i)
    add_point(&head, field - wide * (1.0 - cos(quarter * i / 39)), corner * (1.0 - sin(quarter * i / 39)));
  const int outside = (int)ceil((field_depth - corner) / spacing - 1e-9);
  for (int i = 1; i < outside; ++i) add_point(&head, field + 0.05 * i * spacing, corner + i * spacing);
  double least = 1.0;
  for (uint32_t i = 0; i < head.count; ++i) {
    const double from_middle =
        fmin(fmax(head.y[i] - gauge - fmin(35e-3, 0.5 * (field - gauge)), -35e-3), 35e-3);
    const double crown =
        from_middle * from_middle / 0.6 - from_middle / 40.0 * fmin(1.0, (field - gauge) / 0.07);
    head.z[i] += crown * fmin(fmax(1.0 - head.z[i] / corner, 0.0), 1.0);
    least = fmin(least, head.z[i]);
  }
  if (line->count > 0) {
    const double y = line->y[line->count - 1], z = line->z[line->count - 1];
    for (int i = 1; i < 39; ++i)
      add_point(line, y + (head.y[0] - y) * i / 39.0,
                z + (top + head.z[0] - least - z) * i / 39.0 + 4e-3 * sin(2.0 * quarter * i / 39.0));
  }
  for (uint32_t i = 0; i < head.count; ++i) add_point(line, head.y[i], top + head.z[i] - least);
}

/* The line at a place of the crossing [m]: a wing rail that rises by 1.5 mm and leaves sideways 1:10, and a
 * nose that rises from 20 mm below within 60 mm, to level with the rail 0.48 m on. */
static void crossing_line(double x, Line* line) {
  const double groove = 45e-3, share = fmin(fmax((x + 0.45) / 0.4, 0.0), 1.0);
  line->count = 0;
  if (x >= 0.119) {
    const double rise = fmin((x - 0.12) / 0.06, 1.0),
                 top = 20e-3 * (1.0 - rise) * (1.0 - rise) +
                       3e-3 * fmin(fmax(1.0 - (x - 0.18) / 0.3, 0.0), 1.0);
    add_head(line, -37e-3 + 2e-3 * rise, -19e-3 + fmin(0.1 * (x - 0.12), 54e-3), top,
             8e-3 + 4e-3 * fmin(rise, (x - 0.12) / 0.8), groove - top, groove - top);
  }
  if (x < 1.0)
    add_head(line, -35e-3 + 0.1 * fmax(0.0, x + 0.4), 35e-3 + 0.1 * fmax(0.0, x + 0.5),
             -0.75e-3 * (1.0 - cos(3.141592653589793 * share)), 12e-3, groove, 10e-3);
}

/* Its sections, parted into faces; with 4.5 m of rail before and behind it. */
static wrc_rail_faces* crossing_faces(wrc_found_faces* found) {
  static Line line[lines_most];
  static wrc_section_line section[lines_most];
  uint32_t n = 0;
  double place[lines_most];
  place[n++] = -5.0;
  place[n++] = -1.0;
  for (int i = 0; i < 12; ++i) place[n++] = -0.5 + 0.05 * i;
  for (int i = 0; i < 28; ++i) place[n++] = 0.1 + 0.005 * i;
  for (int i = 0; i < 15; ++i) place[n++] = 0.25 + 0.05 * i;
  place[n++] = 1.2;
  place[n++] = 5.0;
  for (uint32_t k = 0; k < n; ++k) {
    crossing_line(place[k], &line[k]);
    section[k].distance = place[k];
    section[k].count = line[k].count;
    section[k].y = line[k].y;
    section[k].z = line[k].z;
  }
  wrc_rail_faces_problem problem = wrc_rail_faces_problem_default();
  problem.sections = section;
  problem.section_count = n;
  wrc_rail_faces* faces = NULL;
  char text[500] = "";
  must(wrc_rail_faces_create(&problem, &faces, text, sizeof text), text);
  must(wrc_rail_faces_found(faces, found), "faces");
  return faces;
}

/* Forces of the first wheelset. */
typedef struct {
  FILE* file;
  const char* run;
  int side;                  /* of the crossing; the check rail is on the other */
  double least, most, guide; /* vertical on the crossing; lateral at the check rail [N] */
} Passed;

static void pass(double t, const double* s, const Vehicle* v, void* user) {
  Passed* passed = (Passed*)user;
  const double(*f)[3] = v->wheel_force[0];
  const double carried = 0.0 - f[passed->side][2];
  passed->least = fmin(passed->least, carried);
  passed->most = fmax(passed->most, carried);
  passed->guide = fmax(passed->guide, fabs(f[1 - passed->side][1]));
  if (passed->file)
    fprintf(passed->file, "%s,%g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,0\n", passed->run,
            3.6 * v->speed, t, v->start + v->speed * t, s[Y], s[YAW], s[FREEDOMS + Y], f[right][1],
            f[right][2], f[left][1], f[left][2]);
}

/* Steps of one length by two linearly implicit stages (ROS2, gamma = 1 - 1/sqrt 2): second order, what is
 * fast is damped. No step is taken twice. */
static double step_through(Vehicle* v, double* s, double until, double step, Look tell, void* told) {
  const double gamma = 1.0 - 1.0 / sqrt(2.0);
  SUNContext context;
  if (SUNContext_Create(NULL, &context)) exit(EXIT_FAILURE);
  SUNMatrix matrix = SUNDenseMatrix(STATES, STATES, context);
  N_Vector stage = N_VNew_Serial(STATES, context);
  SUNLinearSolver linear = SUNLinSol_Dense(stage, matrix, context);
  double *const stages = N_VGetArrayPointer(stage), rate[STATES], ahead[STATES], first[STATES];
  const clock_t began = clock();
  for (int n = 0; n * step < until; ++n) {
    if (motion(n * step, s, rate, matrix, v)) break;
    if (tell) tell(n * step, s, v, told);
    for (int i = 0; i < STATES; ++i)
      for (int j = 0; j < STATES; ++j)
        SM_ELEMENT_D(matrix, i, j) = (i == j) - gamma * step * SM_ELEMENT_D(matrix, i, j);
    SUNLinSolSetup(linear, matrix);
    for (int i = 0; i < STATES; ++i) stages[i] = rate[i] + (i < N ? 0.0 : gamma * step * v->by_time[i - N]);
    SUNLinSolSolve(linear, matrix, stage, stage, 0.0);
    memcpy(first, stages, sizeof first);
    for (int i = 0; i < STATES; ++i) ahead[i] = s[i] + step * first[i];
    if (motion((n + 1) * step, ahead, rate, NULL, v)) break;
    for (int i = 0; i < STATES; ++i)
      stages[i] = rate[i] - 2.0 * first[i] - (i < N ? 0.0 : gamma * step * v->by_time[i - N]);
    SUNLinSolSolve(linear, matrix, stage, stage, 0.0);
    for (int i = 0; i < STATES; ++i) s[i] += step * (1.5 * first[i] + 0.5 * stages[i]);
  }
  const double took = (double)(clock() - began) / CLOCKS_PER_SEC;
  SUNLinSolFree(linear);
  N_VDestroy(stage);
  SUNMatDestroy(matrix);
  SUNContext_Free(&context);
  return took / until;
}

/* Through the crossing and past its check rail: on the main route it is in the right rail, on the diverging
 * one, a curve of 245 m, in the left rail. */
static void crossing(FILE* file) {
  static Line guide;
  guide.count = 0;
  add_head(&guide, -70e-3, 0.0, 0.0, 5e-3, 60e-3, 60e-3);
  wrc_found_faces found = {.struct_size = sizeof found};
  wrc_rail_faces* faces = crossing_faces(&found);
  wrc_config crossed = wrc_config_default(), checked = pair_of_profiles();
  crossed.wheel.kind = WRC_PROFILE_S1002;
  crossed.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  crossed.wheelset.wheel_radius = radius;
  crossed.track.placement = WRC_PLACEMENT_ORIGIN;
  crossed.track.rail_origin = 0.7525;
  crossed.rail_sections = found.rail_sections;
  crossed.rail_section_count = found.rail_section_count;
  crossed.rail_section_size = found.rail_section_size;
  checked.check_rail.y = -76e-3; /* 41 mm from the running edge, 20 mm above the rail */
  checked.check_rail.z = -20e-3;
  checked.check_rail.profile.kind = WRC_PROFILE_POINTS;
  checked.check_rail.profile.count = guide.count;
  checked.check_rail.profile.y = guide.y;
  checked.check_rail.profile.z = guide.z;
  static const double speeds[2][3] = {{40.0, 80.0, 120.0}, {40.0, 60.0, 0.0}}; /* km/h */
  for (int k = 0; k < 12; ++k) {
    const int diverging = k / 6, by_cvode = k % 2;
    Vehicle v;
    double s[STATES];
    const int side = diverging ? left : right;
    open_contacts(&v, &checked, &crossed, side, 1);
    v.sections[side] = 1;
    v.start = -1.3;
    v.speed = speeds[diverging][k % 6 / 2] / 3.6;
    if (v.speed > 0.0) {
      stand(&v, s);
      if (diverging) v.curvature = 1.0 / 245.0, v.begins = -100.0; /* it is in the curve */
      Passed passed = {
          .file = file, .run = by_cvode ? "crossing by CVODE" : "crossing", .side = side, .least = 1e9};
      v.failures = v.flagged = 0;
      const double factor = by_cvode ? integrate(&v, s, 4.4 / v.speed, 1e-3, pass, &passed)
                                     : step_through(&v, s, 4.4 / v.speed, 1e-3, pass, &passed);
      printf(
          "crossing, %s route at %.0f km/h, %s: %d failed calls, %d flagged; %.1f to %.1f kN on it, up to "
          "%.1f kN "
          "lateral at the check rail; real-time factor %.2f\n",
          diverging ? "diverging" : "main", 3.6 * v.speed, by_cvode ? "CVODE" : "steps of 1 ms", v.failures,
          v.flagged, 1e-3 * passed.least, 1e-3 * passed.most, 1e-3 * passed.guide, factor);
      fflush(stdout);
    }
    close_contacts(&v);
  }
  wrc_rail_faces_destroy(faces);
}

static void flat(FILE* file) {
  enum { angles = 2001 };
  static double angle[angles], deviation[angles];
  const double turn = 6.283185307179586, half = 0.045 / radius;
  for (int i = 0; i < angles; ++i) {
    angle[i] = turn * i / (angles - 1);
    const double from = i > angles / 2 ? angle[i] - turn : angle[i];
    deviation[i] = fabs(from) < half ? -0.25e-3 * (1.0 + cos(0.5 * turn * from / half)) : 0.0;
  }
  wrc_config config = pair_of_profiles();
  config.roundness.angle_count = angles;
  config.roundness.row_count = 1;
  config.roundness.angles = angle;
  config.roundness.deviations = deviation;
  Vehicle v;
  double s[STATES];
  open_contacts(&v, NULL, &config, right, 0);
  v.flat = 1;
  v.flat_angle = 1.0;
  v.speed = 60.0 / 3.6;
  stand(&v, s);
  Told told = {.file = file, .run = "flat", .value = 60.0};
  const double factor = integrate(&v, s, 0.12, 2e-4, look, &told);
  printf("flat of 0.5 mm at 60 km/h: vertical %.1f to %.1f kN; real-time factor %.3f\n",
         1e-3 * told.least_vertical, 1e-3 * told.largest_vertical, factor);
  close_contacts(&v);
}

static void irregular(FILE* file) {
  Vehicle v;
  double s[STATES];
  open_contacts(&v, NULL, NULL, right, 0);
  v.irregular = 1;
  v.speed = 40.0;
  stand(&v, s);
  Told told = {.file = file, .run = "irregular", .value = 40.0};
  const double factor = integrate(&v, s, 4.0, 2e-3, look, &told);
  printf(
      "irregular track at 40 m/s: vertical %.1f to %.1f kN, lateral up to %.1f kN; real-time factor %.3f\n",
      1e-3 * told.least_vertical, 1e-3 * told.largest_vertical, 1e-3 * told.largest_lateral, factor);
  close_contacts(&v);
}

int main(int argc, char** argv) {
  static const struct {
    const char* name;
    void (*run)(FILE*);
  } runs[] = {{"klingel", klingel}, {"cones", cones},       {"critical", critical}, {"curve", curve},
              {"turnout", turnout}, {"crossing", crossing}, {"flat", flat},         {"irregular", irregular}};
  FILE* file = argc > 2 ? fopen(argv[2], "w") : NULL;
  if (file)
    fprintf(file,
            "run,value,time,distance,y,yaw,y_second,lateral_right,vertical_right,lateral_left,vertical_left,"
            "rail_y\n");
  int done = 0;
  for (int k = 0; k < 8; ++k) {
    if (argc > 1 && strcmp(argv[1], "all") != 0 && strcmp(argv[1], runs[k].name) != 0) continue;
    runs[k].run(file);
    ++done;
  }
  if (file) fclose(file);
  return done > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
