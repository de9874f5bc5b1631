/* Motion of wrc_wheelset: M dv/dt = F(q, v), dq/dt = v without its last member.
 *
 *   q = y, z, roll, yaw         v = their rates and that of pitch, the impulse of the forces forwards, and the
 *                             frictional energy
 *
 * Creep forces damp v at rates like f r^2 / (V I): 1e6 1/s of a light wheelset at 0.1 m/s, so no explicit
 * scheme will do. Each step is one of ROS2 (Verwer, Spee, Blom, Hundsdorfer, SIAM J. Sci. Comput. 20, 1999):
 * second order, L-stable, one Jacobian, two linear systems:
 *
 *   (1 - gamma h A) k1 = h f(u)                        gamma = 1 - 1/sqrt(2)
 *   (1 - gamma h A) k2 = h f(u + k1) - 2 k1            u' = u + 3/2 k1 + 1/2 k2
 *
 * Its error is estimated by the embedded first-order step u + k1, filtered once more by the same matrix. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "model.h"

enum { places = 4, rates = 6, wheels = 2 };
/* Numbers of the motion; behind them both sums. */
enum { moving = places + rates - 1, sum_of_force = moving, sum_of_power, states };
enum { most_halvings = 16 };

/* q, then v without its sums: where the outputs of wheelset.def have them. */
static double* state_of(instance* of) { return of->now.real + SET_y; }

/* The columns of the wrench's derivatives by q and v, and its rows in the order of v. */
static const int column[moving] = {WRC_BY_Y,
                                   WRC_BY_Z,
                                   WRC_BY_ROLL,
                                   WRC_BY_YAW,
                                   WRC_BY_VELOCITY_Y,
                                   WRC_BY_VELOCITY_Z,
                                   WRC_BY_ANGULAR_VELOCITY_X,
                                   WRC_BY_ANGULAR_VELOCITY_Z,
                                   WRC_BY_ANGULAR_VELOCITY_Y};
static const int row[rates] = {1, 2, 3, 5, 4, 0};

/* Forces [N] and moments [N m] of a wrench by number of row. */
static double component(const wrc_wrench* wrench, int number) {
  return number < 3 ? wrench->force[number] : wrench->moment[number - 3];
}

/* A rail piece of the way's length and a tread, of one bin each, with the amounts of the variables. */
typedef struct films {
  wrc_surface_bin bin[2];
  wrc_surface band[2];
  wrc_surface_laws laws;
  wrc_surface_passage passage;
} films;

/* Lays a piece of rail, the way of a duration, and the tread, of a bin each, with the amounts ahead and on
 * the wheel. The passage has the energy of one wheel at the power of the last step. Ways, lengths and energy
 * are enlarged until the piece is 10 mm long: amounts per area do not depend on it, and shorter bins would
 * round them. Status of the library. */
static int32_t lay_films(const instance* of, double duration, films* made, char* sentence, size_t size) {
  const double* now = of->now.real;
  const double radius = now[SET_wheel_radius], way = now[SET_speed] * duration;
  const double scale = fmax(1.0, 0.01 / fmax(1e-5, fabs(way)));
  const double length[2] = {fmin(1e4, fmax(0.01, scale * fabs(way))),
                            fmin(1e4, scale * 2.0 * 3.14159265358979 * radius)};
  memset(made->bin, 0, sizeof made->bin);
  for (int body = 0; body < 2; ++body) {
    wrc_surface* band = &made->band[body];
    *band = wrc_surface_default();
    band->count = band->closed = 1;
    band->length = length[body];
    band->bins = &made->bin[body];
    band->bin_size = sizeof made->bin[body];
    for (int32_t q = 0; q < WRC_SURFACE_QUANTITIES; ++q) {
      if (body == 0 && q == WRC_SURFACE_HEAT) continue; /* a rail ahead is cold */
      const double amount = now[(body == 0 ? SET_water_ahead : SET_water_on_wheel) + q];
      const int32_t status = wrc_surface_add(band, q, amount, 0.0, length[body], sentence, size);
      if (status < 0) return status;
    }
  }
  made->passage = (wrc_surface_passage){.struct_size = sizeof made->passage,
                                        .rail_to = scale * way,
                                        .wheel_to = -scale * now[SET_pitch_rate] * radius * duration,
                                        .energy = 0.5 * scale * now[SET_mean_power] * duration};
  made->laws = wrc_surface_laws_default();
  return wrc_surface_laws_use(&made->laws, "low adhesion", sentence, size);
}

/* Lets the wheel pass a share of its way. */
static int32_t pass_films(films* made, double share, char* sentence, size_t size) {
  wrc_surface_passage part = made->passage;
  part.rail_to *= share;
  part.wheel_to *= share;
  part.energy *= share;
  return wrc_surface_pass(&made->band[0], &made->band[1], &made->laws, &part, NULL, sentence, size);
}

/* Amount of a substance in the bin of a body [kg/m^2], heat [J/m^2]. */
static double amount_of(const films* made, int body, int32_t quantity) {
  double amount = 0.0;
  wrc_surface_values(&made->band[body], quantity, WRC_SURFACE_AMOUNT, &amount, NULL, NULL, 0);
  return amount;
}

/* Friction for the library: the number, or that of the films under the wheel. Amounts on the rail are means
 * along the passage, as those between bins of wrc_surface.h, by Simpson's rule over its quarters. */
static void give_friction(instance* of) {
  const double* now = of->now.real;
  of->input.friction = wrc_friction_default();
  of->input.friction.coefficient = now[SET_friction];
  of->input.friction.fall_rate = now[SET_fall_rate];
  if (now[SET_fall_rate] > 0.0) of->input.friction.speed_law = WRC_SPEED_LAW_EXPONENTIAL;
  films made;
  const double duration = 1e-3; /* any: the energy per way is the power over the speed */
  if (of->now.integer[SET_films] == 0 || lay_films(of, duration, &made, NULL, 0) < 0) return;
  const double weight[5] = {1.0 / 12.0, 4.0 / 12.0, 2.0 / 12.0, 4.0 / 12.0, 1.0 / 12.0};
  double mean[WRC_SURFACE_QUANTITIES] = {0.0};
  for (int quarter = 0; quarter <= 4; ++quarter) {
    for (int32_t q = 0; q < WRC_SURFACE_QUANTITIES; ++q) mean[q] += weight[quarter] * amount_of(&made, 0, q);
    pass_films(&made, 0.25, NULL, 0);
  }
  wrc_surface* rail = &made.band[0];
  memset(rail->bins, 0, sizeof *rail->bins);
  for (int32_t q = 0; q < WRC_SURFACE_QUANTITIES; ++q)
    wrc_surface_add(rail, q, mean[q], 0.0, rail->length, NULL, 0);
  const wrc_surface_passage here = {.struct_size = sizeof here};
  const wrc_friction base = of->input.friction;
  wrc_surface_friction(rail, &made.band[1], &made.laws, &here, &base, &of->input.friction, NULL, 0);
}

/* The passage of a communication step. Amounts behind and on the tread become its outcome. 0: not done,
 * sentence[] says why. */
static int exchange_films(instance* of, double duration, char* sentence, size_t size) {
  films made;
  if (lay_films(of, duration, &made, sentence, size) < 0 || pass_films(&made, 1.0, sentence, size) < 0 ||
      wrc_surface_rest(&made.band[1], &made.laws, duration, sentence, size) < 0)
    return 0;
  for (int32_t q = 0; q < WRC_SURFACE_QUANTITIES; ++q) {
    if (q != WRC_SURFACE_HEAT) of->now.real[SET_water_behind + q] = amount_of(&made, 0, q);
    of->now.real[SET_water_on_wheel + q] = amount_of(&made, 1, q);
  }
  return 1;
}

/* Gives the library a state u: the motion, friction, and the rail of a side. */
static void give(instance* of, const double u[moving], int side) {
  const double* now = of->now.real;
  wrc_wheel_state* wheel = &of->input.wheel;
  wheel->y = u[0];
  wheel->z = u[1];
  wheel->roll = u[2];
  wheel->yaw = u[3];
  wheel->velocity[0] = now[SET_speed];
  wheel->velocity[1] = u[4];
  wheel->velocity[2] = u[5];
  wheel->roll_rate = u[6];
  wheel->yaw_rate = u[7];
  wheel->pitch_rate = u[8];
  of->input.damping = now[SET_damping];
  const double* rail = now + (side == WRC_SIDE_RIGHT ? SET_right_rail_y : SET_left_rail_y);
  of->input.rail.y = rail[0];
  of->input.rail.z = rail[1];
  of->input.rail.y_velocity = rail[2];
  of->input.rail.z_velocity = rail[3];
  of->input.rail.y_slope = rail[4];
  of->input.rail.z_slope = rail[5];
}

/* Masses in the order of v [kg, kg m^2]; the impulse itself is a state. */
static void masses(const instance* of, double mass[rates]) {
  const double* now = of->now.real;
  mass[0] = mass[1] = now[SET_mass];
  mass[2] = mass[3] = now[SET_inertia_across];
  mass[4] = now[SET_inertia_about_axle];
  mass[5] = 1.0;
}

/* slope = df/du of f = du/dt at u; NULL: not wanted. Status of the library; *failed is the contact that
 * knows why. */
static int32_t motion(instance* of, const double u[states], double f[states], double slope[states][states],
                      const wrc_contact** failed) {
  const double* now = of->now.real;
  double mass[rates];
  masses(of, mass);
  const double axle = mass[4], roll_rate = u[6], yaw_rate = u[7], pitch_rate = u[8];
  /* Loads of the vehicle, and the turning axle's gyroscopic moments. */
  f[4] = now[SET_force_y];
  f[5] = now[SET_load] + now[SET_force_z];
  f[6] = now[SET_moment_x] + axle * pitch_rate * yaw_rate;
  f[7] = now[SET_moment_z] - axle * pitch_rate * roll_rate;
  f[8] = now[SET_moment_y];
  f[sum_of_force] = f[sum_of_power] = 0.0;
  if (slope) {
    memset(slope, 0, states * sizeof *slope);
    slope[6][7] = axle * pitch_rate;
    slope[6][8] = axle * yaw_rate;
    slope[7][6] = -axle * pitch_rate;
    slope[7][8] = -axle * roll_rate;
  }
  /* Wrenches of both rails. */
  wrc_wrench wrench = {.struct_size = sizeof wrench};
  for (int side = 0; side < wheels; ++side) {
    give(of, u, side);
    *failed = of->contact[side];
    of->slopes.struct_size = sizeof of->slopes;
    const int32_t status =
        slope ? wrc_contact_wrench_derivatives(of->contact[side], &of->input, &wrench, &of->slopes)
              : wrc_contact_wrench(of->contact[side], &of->input, &wrench);
    if (status < 0) return status;
    f[sum_of_power] += wrench.power;
    for (int i = 0; i < rates; ++i) {
      f[places + i] += component(&wrench, row[i]);
      for (int k = 0; slope && k < moving; ++k) slope[places + i][k] += of->slopes.wrench[row[i]][column[k]];
    }
  }
  /* Accelerations of forces, and rates of the places. */
  for (int i = 0; i < rates; ++i) {
    f[places + i] /= mass[i];
    for (int k = 0; slope && k < moving; ++k) slope[places + i][k] /= mass[i];
  }
  for (int i = 0; i < places; ++i) {
    f[i] = u[places + i];
    if (slope) slope[i][places + i] = 1.0;
  }
  return WRC_OK;
}

int32_t wheelset_solve(instance* of, const wrc_contact** failed) {
  double* now = of->now.real;
  wrc_wrench wrench = {.struct_size = sizeof wrench};
  double power = 0.0;
  uint32_t flags = 0;
  give_friction(of);
  double force = 0.0;
  for (int side = 0; side < wheels; ++side) {
    give(of, state_of(of), side);
    *failed = of->contact[side];
    const int32_t status = wrc_contact_wrench(of->contact[side], &of->input, &wrench);
    if (status < 0) return status;
    double* shown = now + (side == WRC_SIDE_RIGHT ? SET_right_fy : SET_left_fy);
    shown[0] = wrench.force[1];
    shown[1] = wrench.force[2];
    force += wrench.force[0];
    power += wrench.power;
    flags |= wrench.flags;
  }
  now[SET_power] = power;
  if (of->now.integer[SET_steps] == 0) now[SET_fx] = force; /* behind a step its mean stays */
  of->now.integer[SET_flags] = (int32_t)flags;
  of->now.solved = 1;
  return WRC_OK;
}

/* Replaces a matrix by its factors L U with the largest pivots of its columns; order[] says which rows. 0:
 * singular. */
static int factorise(double a[states][states], int order[states]) {
  for (int k = 0; k < states; ++k) {
    int best = k;
    for (int i = k + 1; i < states; ++i)
      if (fabs(a[i][k]) > fabs(a[best][k])) best = i;
    if (!(fabs(a[best][k]) > 0.0)) return 0;
    order[k] = best;
    for (int j = 0; best != k && j < states; ++j) {
      const double kept = a[k][j];
      a[k][j] = a[best][j];
      a[best][j] = kept;
    }
    for (int i = k + 1; i < states; ++i) {
      const double factor = a[i][k] /= a[k][k];
      for (int j = k + 1; j < states; ++j) a[i][j] -= factor * a[k][j];
    }
  }
  return 1;
}

static void substitute(double a[states][states], const int order[states], double x[states]) {
  for (int k = 0; k < states; ++k) {
    const double kept = x[k];
    x[k] = x[order[k]];
    x[order[k]] = kept;
  }
  for (int i = 1; i < states; ++i)
    for (int j = 0; j < i; ++j) x[i] -= a[i][j] * x[j];
  for (int i = states - 1; i >= 0; --i) {
    for (int j = i + 1; j < states; ++j) x[i] -= a[i][j] * x[j];
    x[i] /= a[i][i];
  }
}

/* An error of u as a displacement at the rails [m]: angles by half the tape circles' distance, rates by the
 * radius and the time in which a contact's length, 10 mm, is rolled over: an error of creepage of 1e-5 is
 * 1e-7 m. */
static double displacement(const instance* of, const double error[states], double step) {
  const double* now = of->now.real;
  const double half = 0.5 * now[SET_tape_circle_distance], radius = now[SET_wheel_radius];
  const double time = fmax(step, 0.01 / (fabs(now[SET_speed]) + 1e-3));
  const double scale[moving] = {1.0, 1.0, half, half, time, time, time * half, time * half, time * radius};
  double largest = 0.0;
  for (int i = 0; i < moving; ++i) {
    const double size = fabs(error[i]) * scale[i];
    if (!(size <= largest)) largest = size; /* NaN stays */
  }
  return largest;
}

/* One step of ROS2 from u. Written to `after`; *error [m]. The Jacobian and f at u are given. */
static int32_t ros2(instance* of, const double u[states], const double f[states],
                    double slope[states][states], double step, double after[states], double* error,
                    const wrc_contact** failed) {
  const double gamma = 1.0 - 0.70710678118654752;
  double matrix[states][states], k1[states], k2[states], middle[states];
  int order[states];
  for (int i = 0; i < states; ++i) {
    for (int j = 0; j < states; ++j) matrix[i][j] = (i == j) - gamma * step * slope[i][j];
    k1[i] = step * f[i];
  }
  *error = HUGE_VAL;
  if (!factorise(matrix, order)) return WRC_OK;
  substitute(matrix, order, k1);
  for (int i = 0; i < states; ++i) middle[i] = u[i] + k1[i];
  const int32_t status = motion(of, middle, k2, NULL, failed);
  if (status < 0) return status;
  for (int i = 0; i < states; ++i) k2[i] = step * k2[i] - 2.0 * k1[i];
  substitute(matrix, order, k2);
  double difference[states];
  for (int i = 0; i < states; ++i) {
    after[i] = u[i] + 1.5 * k1[i] + 0.5 * k2[i];
    difference[i] = 0.5 * (k1[i] + k2[i]);
  }
  substitute(matrix, order, difference);
  *error = displacement(of, difference, step);
  return WRC_OK;
}

/* Goes on by `length` in halves, quarters ... of it, each as long as its error allows. Nothing is remembered
 * from one such part to the next. Adds to the impulse of the forces forwards [N s] and to the frictional
 * energy [J]. Returns 0 where no step is short enough; then sentence[] says why. */
static int go_on(instance* of, double length, double sums[2], char* sentence, size_t size) {
  const double tolerance = of->now.real[SET_tolerance];
  double u[states] = {0.0}, f[states], slope[states][states], after[states];
  memcpy(u, state_of(of), moving * sizeof *u);
  const uint32_t all = 1u << most_halvings;
  uint32_t done = 0, part = all;
  const wrc_contact* failed = NULL;
  while (done < all) {
    if (motion(of, u, f, slope, &failed) < 0) {
      wrc_contact_last_error(failed, sentence, size);
      return 0;
    }
    double error = HUGE_VAL;
    for (;; part /= 2) {
      const double step = length * part / all;
      const int32_t status = ros2(of, u, f, slope, step, after, &error, &failed);
      if (status >= 0 && error <= tolerance) break;
      if (part == 1) {
        char why[512] = "";
        if (status < 0) wrc_contact_last_error(failed, why, sizeof why);
        snprintf(sentence, size,
                 "no step is short enough: at y = %g m, z = %g m, pitch_rate = %g rad/s one of %g s has an "
                 "error of %g m "
                 "for a tolerance of %g m. %s",
                 u[0], u[1], u[8], step, error, tolerance, why);
        return 0;
      }
    }
    memcpy(u, after, sizeof after);
    done += part;
    ++of->now.integer[SET_steps];
    if (done % (2 * part) == 0 && error < 0.25 * tolerance && 2 * part <= all) part *= 2;
  }
  memcpy(state_of(of), u, moving * sizeof *u);
  for (int k = 0; k < 2; ++k) sums[k] += u[sum_of_force + k];
  return 1;
}

outcome model_step(instance* of, double from, double length) {
  char sentence[1024];
  if (of->kind != WHEELSET || !of->model)
    return model_say(of, WRONG, "no step: of an initialised wheelset alone");
  if (!(length > 0.0) || length > 1e9) return model_say(of, WRONG, "a step's length must be positive");
  const double time = of->now.time;
  if (!(fabs(from - time) <= 1e-9 * fabs(time) + 1e-6 * length)) {
    snprintf(sentence, sizeof sentence, "a step from %.9g s is asked for: the wheelset is at %.9g s", from,
             time);
    return model_say(of, WRONG, sentence);
  }
  /* The host's step in equal parts, not longer than `step`. */
  const double wished = length / of->now.real[SET_step], nearest = floor(wished + 0.5);
  const int whole = nearest >= 1.0 && fabs(wished - nearest) <= 1e-9 * nearest;
  const double count = whole ? nearest : ceil(wished), part = whole ? of->now.real[SET_step] : length / count;
  const contents before = of->now;
  const wrc_contact* failed = NULL;
  if (!of->now.solved &&
      wheelset_solve(of, &failed) < 0) { /* of what the host has set: no shorter step mends it */
    wrc_contact_last_error(failed, sentence, sizeof sentence);
    return model_say(of, WRONG, sentence);
  }
  of->now.integer[SET_steps] = 0;
  give_friction(of); /* held over the step */
  double sums[2] = {0.0};
  for (double n = 0.0; n < count; n += 1.0)
    if (!go_on(of, part, sums, sentence, sizeof sentence)) {
      of->now = before;
      return model_say(of, DISCARDED, sentence);
    }
  if (wheelset_solve(of, &failed) < 0) { /* the outputs could not be read */
    wrc_contact_last_error(failed, sentence, sizeof sentence);
    of->now = before;
    return model_say(of, DISCARDED, sentence);
  }
  of->now.real[SET_fx] = sums[0] / length;
  of->now.real[SET_mean_power] = sums[1] / length;
  /* Films: the passage; forces are then those of the new friction. */
  if (of->now.integer[SET_films] != 0 &&
      (!exchange_films(of, length, sentence, sizeof sentence) || wheelset_solve(of, &failed) < 0)) {
    of->now = before;
    return model_say(of, DISCARDED, sentence);
  }
  of->now.time = from + length;
  return FINE;
}
