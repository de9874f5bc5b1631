/* wheel_wear.c - a wheelset over a network of curves: what wears where, and what becomes of the profile.
 *
 *   wheel_wear FOLDER [distance in km] [curves] [processes]     100000 km, 1000 curves, 2 processes
 *
 * Writes into FOLDER, which exists: wheel_wear.csv, a line for every update of the profile (distance, largest
 * depth, flange height, thickness, qR, equivalent conicity at 3 mm), profile_NNNNNN.csv every 10 000 km, and
 * state.bin, from which the next call goes on where this one ended, or was ended. draw_wheel_wear.py draws
 * them.
 *
 * A wheelset that its bogie steers stands radially in each curve, without an angle of attack, and is free to
 * roll and to move sideways: its rotation and its place are those at which no moment turns the axle and its
 * lateral forces carry the cant deficiency. Every curve is run through both ways; tangent track
 * lies between. Depth is worn by Archard's law. The profile is renewed whenever some place of it has lost 0.1
 * mm. Needs POSIX: curves are dealt out to processes. */
#define _DEFAULT_SOURCE
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "wrc/wrc_damage.h"
#include "wrc/wrc_profiles.h"

enum { BINS = 280, POINTS = 400, MOST_CURVES = 4000, MOST_PROCESSES = 64, TOGETHER = 25 };

/* dry coefficients of the KTH map times this: rails are wet and greasy for most of a year */
static const double natural_lubrication = 0.05;

static const double wheel_load = 70e3, friction = 0.3, radius = 0.46, base = 1.5, gravity = 9.81;

typedef struct curve {
  double curvature;  /* 1/m; > 0: to the right */
  double length;     /* m */
  double deficiency; /* of the cant, over the gauge: lateral acceleration over gravity, outwards */
  double speed;      /* m/s */
} curve;

typedef struct place { /* where a wheelset ran through a curve, from which the next round begins */
  int32_t known, reserved;
  double y, rotation;
  double by_force[2], by_moment[2]; /* how far these two move by unit lateral force and moment */
} place;

typedef struct state { /* all that a later call needs */
  double distance;     /* km */
  uint32_t points;
  uint32_t updates;
  double y[POINTS], z[POINTS];
  place places[MOST_CURVES];
} state;

static curve network[MOST_CURVES];

static void check(int32_t status, const char* what, const char* text) {
  if (status >= 0) return;
  fprintf(stderr, "%s: %s %s\n", what, wrc_status_name(status), text);
  exit(EXIT_FAILURE);
}

/* The same numbers everywhere: 0..1. */
static double random_number(uint32_t* seed) {
  *seed = 1664525u * *seed + 1013904223u;
  return *seed / 4294967296.0;
}

/* Half of the length tangent, radii from 400 m with a tail to 6 km, sorted so that neighbours are alike,
 * speeds for up to 100 mm of deficiency.
 */
static void make_network(int curves) {
  uint32_t seed = 2026;
  for (int i = 0; i < curves; ++i) {
    const double pick = random_number(&seed), side = i % 2 == 0 ? 1.0 : -1.0;
    const double r = pick < 0.5 ? 0.0 : 400.0 / (1.0 - 0.94 * (pick - 0.5) / 0.5);
    network[i].curvature = r > 0.0 ? side / r : 0.0;
    network[i].length = 200.0 + 600.0 * random_number(&seed);
    network[i].deficiency = r > 0.0 ? (-0.02 + 0.12 * random_number(&seed)) / base : 0.0;
    network[i].speed = r > 0.0 ? sqrt(gravity * r * (0.08 + network[i].deficiency)) : 40.0;
    if (network[i].speed > 45.0) network[i].speed = 45.0;
  }
}

static int by_curvature(const void* a, const void* b) {
  const double one = ((const curve*)a)->curvature, other = ((const curve*)b)->curvature;
  return one < other ? -1 : one > other;
}

typedef struct wheelset {
  wrc_contact* contact[2];
  double y, rotation; /* where the last curve left it: the next begins there */
} wheelset;

/* Lateral force on the wheelset [N] and moment about the axle [N m] at a place, rotating. */
static int32_t forces(wheelset* set, const curve* c, double y, double rotation, double* lateral,
                      double* moment) {
  wrc_wheel_input input = wrc_wheel_input_default();
  *lateral = *moment = 0.0;
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.start = WRC_START_WARM;
  input.friction.coefficient = friction;
  input.wheel.y = y;
  input.wheel.velocity[0] = c->speed;
  input.wheel.pitch_rate = -c->speed / radius * (1.0 + rotation);
  input.wheel.yaw_rate = c->speed * c->curvature;
  for (int side = 0; side < 2; ++side) {
    wrc_wrench wrench = {.struct_size = sizeof wrench};
    const double outer = side == 0 ? -1.0 : 1.0; /* a curve to the right loads the left wheel */
    input.vertical_load = wheel_load * (1.0 + outer * (c->curvature > 0.0 ? 1.2 : -1.2) * c->deficiency);
    const int32_t status = wrc_contact_wrench(set->contact[side], &input, &wrench);
    if (status < 0 || (wrench.flags & WRC_FLAG_BIT(WRC_FLAG_CLIMBING))) return -1;
    *lateral += wrench.force[1];
    *moment += wrench.moment[1];
  }
  /* outwards is to the left of a curve to the right */
  *lateral += (c->curvature > 0.0 ? -1.0 : c->curvature < 0.0 ? 1.0 : 0.0) * 2.0 * wheel_load * c->deficiency;
  return 0;
}

/* The rotation at which nothing turns the axle: secants. Returns the lateral force there. */
static int32_t spin_free(wheelset* set, const curve* c, double y, double* lateral) {
  double a = set->rotation, b = a + 1e-4, fa, fb;
  if (forces(set, c, y, a, lateral, &fa) < 0) return -1;
  for (int n = 0; n < 8; ++n) {
    if (forces(set, c, y, b, lateral, &fb) < 0) return -1;
    if (fabs(fb) < 20.0 || fb == fa) break;
    double step = -fb * (b - a) / (fb - fa);
    if (fabs(step) > 3e-3) step = copysign(3e-3, step);
    a = b, fa = fb, b += step;
  }
  set->rotation = b;
  return 0;
}

/* The place at which the lateral forces balance, which lies between the two flanges: steps that double until
 * the force changes its sign, then secants between the two places, of which one that stays loses weight
 * (Illinois). */
static int32_t settle(wheelset* set, const curve* c) {
  struct {
    double y, force;
    int known, last;
  } left = {-0.0085, 0.0, 0, 0}, right = {0.0085, 0.0, 0, 0}; /* pushed to the right; to the left */
  double y = set->y, force = 0.0, step = 0.1e-3;
  for (int n = 0; n < 24 && right.y - left.y > 1e-5; ++n) {
    if (spin_free(set, c, y, &force) < 0) return -1;
    if (fabs(force) < 300.0) break;
    if (force > 0.0) {
      if (left.last) right.force *= 0.5;
      left.y = y, left.force = force, left.known = left.last = 1, right.last = 0;
    } else {
      if (right.last) left.force *= 0.5;
      right.y = y, right.force = force, right.known = right.last = 1, left.last = 0;
    }
    if (left.known && right.known) {
      y = left.y + (right.y - left.y) * left.force / (left.force - right.force);
    } else {
      y += copysign(step, force);
      step *= 3.0;
      if (y >= right.y || y <= left.y) y = 0.5 * (left.y + right.y);
    }
  }
  set->y = y;
  return 0;
}

/* What the place moves by unit force and moment, by two differences. */
static int32_t find_slopes(wheelset* set, const curve* c, place* at) {
  const double dy = 2e-6, dr = 2e-5;
  double f, m, fy, my, fr, mr;
  if (forces(set, c, at->y, at->rotation, &f, &m) < 0 ||
      forces(set, c, at->y + dy, at->rotation, &fy, &my) < 0 ||
      forces(set, c, at->y, at->rotation + dr, &fr, &mr) < 0)
    return -1;
  fy = (fy - f) / dy, my = (my - m) / dy, fr = (fr - f) / dr, mr = (mr - m) / dr;
  const double determinant = fy * mr - fr * my;
  if (determinant == 0.0) return -1;
  at->by_force[0] = mr / determinant, at->by_moment[0] = -fr / determinant;
  at->by_force[1] = -my / determinant, at->by_moment[1] = fy / determinant;
  return 0;
}

/* From where the curve was run through last, when the profile was hardly another one: Newton's steps with
 * slopes that Broyden's rule keeps. */
static int32_t settle_again(wheelset* set, const curve* c, place* at) {
  double f, m;
  if (forces(set, c, at->y, at->rotation, &f, &m) < 0) return -1;
  for (int n = 0; n < 7; ++n) {
    if (fabs(f) < 300.0 && fabs(m) < 20.0) {
      set->y = at->y, set->rotation = at->rotation;
      return 0;
    }
    double dy = -at->by_force[0] * f - at->by_moment[0] * m, dr = -at->by_force[1] * f - at->by_moment[1] * m;
    const double size = fmax(fabs(dy) / 0.3e-3, fabs(dr) / 1e-3);
    if (size > 1.0) dy /= size, dr /= size;
    double f_next, m_next;
    if (forces(set, c, at->y + dy, at->rotation + dr, &f_next, &m_next) < 0) return -1;
    const double df = f_next - f, dm = m_next - m;
    /* H += (s - H t) s'H / (s'H t), s the step, t what force and moment changed by */
    const double moved_y = at->by_force[0] * df + at->by_moment[0] * dm,
                 moved_r = at->by_force[1] * df + at->by_moment[1] * dm;
    /* in one unit: a rotation of 1e-3 counts as 0.3 mm */
    const double wy = dy / (0.3e-3 * 0.3e-3), wr = dr / (1e-3 * 1e-3), scale = wy * moved_y + wr * moved_r;
    if (scale == 0.0) return -1;
    const double row_f = (wy * at->by_force[0] + wr * at->by_force[1]) / scale,
                 row_m = (wy * at->by_moment[0] + wr * at->by_moment[1]) / scale;
    at->by_force[0] += (dy - moved_y) * row_f, at->by_moment[0] += (dy - moved_y) * row_m;
    at->by_force[1] += (dr - moved_r) * row_f, at->by_moment[1] += (dr - moved_r) * row_m;
    at->y += dy, at->rotation += dr, f = f_next, m = m_next;
  }
  return -1;
}

/* Adds what neighbouring curves do to the bins, in seconds of one passage each. They begin alike whoever runs
 * them, so that the number of processes does not matter. */
static int run_together(const wrc_model* model, wrc_damage_bins* bins, place* places, int first, int end) {
  wheelset set = {{NULL, NULL}, 0.0, 0.0};
  int lost = 0;
  wrc_wear_laws laws = wrc_wear_laws_default();
  laws.archard_slow *= natural_lubrication;
  laws.archard_severe *= natural_lubrication;
  laws.archard_fast *= natural_lubrication;
  laws.archard_seizure *= natural_lubrication;
  char text[300] = "";
  for (int side = 0; side < 2; ++side)
    check(wrc_contact_create(model, side, NULL, &set.contact[side], text, sizeof text), "contact", text);
  for (int i = first; i < end; ++i) {
    wrc_accumulation step = {.struct_size = sizeof step};
    step.wear = &laws;
    step.duration = network[i].length / network[i].speed;
    if (!places[i].known || settle_again(&set, &network[i], &places[i]) < 0) {
      if (i > first && network[i].curvature * network[i - 1].curvature <= 0.0) set.y = set.rotation = 0.0;
      places[i].known = 0;
      if (settle(&set, &network[i]) < 0) {
        ++lost;
        set.y = set.rotation = 0.0;
        continue;
      }
      places[i].y = set.y, places[i].rotation = set.rotation;
      places[i].known = find_slopes(&set, &network[i], &places[i]) == 0;
      double lateral, moment;
      if (forces(&set, &network[i], set.y, set.rotation, &lateral, &moment) < 0) continue;
    }
    /* both ways: the wheel is the outer as often as the inner one */
    for (int side = 0; side < 2; ++side)
      if (wrc_contact_accumulate(set.contact[side], &step, bins, NULL, NULL) < 0) ++lost;
  }
  for (int side = 0; side < 2; ++side) wrc_contact_destroy(set.contact[side]);
  return lost;
}

/* Every `processes`-th lot of neighbours. */
static int run(const wrc_model* model, wrc_damage_bins* bins, place* places, int curves, int process,
               int processes) {
  int lost = 0;
  for (int first = TOGETHER * process; first < curves; first += TOGETHER * processes)
    lost += run_together(model, bins, places, first, first + TOGETHER < curves ? first + TOGETHER : curves);
  return lost;
}

static wrc_model* make_model(const state* now) {
  wrc_config config = wrc_config_default();
  config.rail.kind = WRC_PROFILE_60E1;
  config.track.rail_inclination = 1.0 / 40.0;
  config.wheelset.wheel_radius = radius;
  config.wheel.kind = WRC_PROFILE_S1002;
  if (now->points > 0) {
    config.wheel.kind = WRC_PROFILE_POINTS;
    config.wheel.count = now->points;
    config.wheel.y = now->y;
    config.wheel.z = now->z;
  }
  char text[300] = "";
  wrc_model* model = NULL;
  check(wrc_model_create(&config, NULL, &model, text, sizeof text), "model", text);
  return model;
}

/* The new profile: points of the model's, every half millimetre. */
static void take_points(const wrc_model* model, state* now) {
  double arc[POINTS];
  for (int i = 0; i < 262; ++i) arc[i] = -0.0795 + 0.5e-3 * i;
  now->points = 262;
  check(wrc_model_arc_places(model, WRC_BODY_WHEEL, now->points, arc, now->y, now->z), "points", "");
  uint32_t kept = 0;
  for (uint32_t i = 0; i < now->points; ++i)
    if (kept == 0 || now->y[i] > now->y[kept - 1] + 1e-5)
      now->y[kept] = now->y[i], now->z[kept] = now->z[i], ++kept;
  now->points = kept;
}

static double conicity(const wrc_model* model) {
  double y[81], dr[81], amplitude = 3e-3, found = 0.0;
  for (int i = 0; i < 81; ++i) y[i] = 0.1e-3 * (i - 40);
  wrc_wheelset_geometry_problem where = {.struct_size = sizeof where};
  where.count = 81;
  where.lateral = y;
  wrc_wheelset_geometry functions = {.struct_size = sizeof functions};
  functions.radius_difference = dr;
  if (wrc_profile_wheelset_geometry(model, &where, &functions, NULL, 0) < 0) return 0.0;
  wrc_conicity_problem problem = wrc_conicity_problem_default();
  problem.count = 81;
  problem.lateral = y;
  problem.radius_difference = dr;
  problem.amplitude_count = 1;
  problem.amplitudes = &amplitude;
  problem.radius = radius;
  wrc_conicity result = {.struct_size = sizeof result};
  result.conicity = &found;
  return wrc_equivalent_conicity(&problem, &result, NULL, 0) < 0 ? 0.0 : found;
}

static FILE* open_in(const char* folder, const char* name, const char* mode) {
  char path[4096];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  return fopen(path, mode);
}

static void write_profile(const char* folder, const state* now) {
  char name[64];
  snprintf(name, sizeof name, "profile_%06.0f.csv", now->distance);
  FILE* file = open_in(folder, name, "w");
  if (file == NULL) check(-1, name, "cannot be written");
  fprintf(file, "y_mm,z_mm\n");
  for (uint32_t i = 0; i < now->points; ++i) fprintf(file, "%.6f,%.6f\n", 1e3 * now->y[i], 1e3 * now->z[i]);
  fclose(file);
}

static void write_line(const char* folder, const state* now, const wrc_model* model, double depth, int lost) {
  wrc_flange flange = {0};
  char text[256] = "";
  check(wrc_flange_dimensions(now->points, now->y, now->z, 0.070, &flange, text, sizeof text), "flange",
        text);
  FILE* file = open_in(folder, "wheel_wear.csv", now->updates == 0 ? "w" : "a");
  if (file == NULL) check(-1, "wheel_wear.csv", "cannot be written");
  if (now->updates == 0)
    fprintf(file,
            "distance_km,depth_mm,flange_height_mm,flange_thickness_mm,qR_mm,conicity,curves_left_out\n");
  fprintf(file, "%.1f,%.4f,%.4f,%.4f,%.4f,%.5f,%d\n", now->distance, 1e3 * depth, 1e3 * flange.height,
          1e3 * flange.thickness, 1e3 * flange.slope, conicity(model), lost);
  fclose(file);
  printf("%8.0f km  flange %6.3f x %6.3f mm, qR %6.3f mm%s\n", now->distance, 1e3 * flange.height,
         1e3 * flange.thickness, 1e3 * flange.slope, lost > 0 ? ", curves left out" : "");
  fflush(stdout);
}

static void write_state(const char* folder, const state* now) {
  char path[4096], next[4096];
  snprintf(path, sizeof path, "%s/state.bin", folder);
  snprintf(next, sizeof next, "%s/state.new", folder);
  FILE* file = fopen(next, "wb");
  if (file == NULL || fwrite(now, sizeof *now, 1, file) != 1 || fclose(file) != 0 || rename(next, path) != 0)
    check(-1, path, "cannot be written");
}

/* The state in the folder, or that of a new wheel, with the model of it. */
static wrc_model* begin(const char* folder, state* now) {
  FILE* old = open_in(folder, "state.bin", "rb");
  if (old != NULL) {
    if (fread(now, sizeof *now, 1, old) != 1) check(-1, "state.bin", "is of another program");
    fclose(old);
    printf("going on from %.0f km\n", now->distance);
  }
  wrc_model* model = make_model(now);
  if (now->points > 0) return model;
  take_points(model, now);
  wrc_model_destroy(model);
  model = make_model(now); /* of the points, as it is when a later call goes on from here */
  write_profile(folder, now);
  write_line(folder, now, model, 0.0, 0);
  write_state(folder, now);
  return model;
}

/* Memory that the processes share: bins of each, the number of curves that it could not run, starts. */
typedef struct {
  char* memory;
  size_t cleared; /* bytes that each round begins with as zeros */
  wrc_damage_bins bins[MOST_PROCESSES];
  int* lost;
  place* places;
} shared_round;

static const size_t of_places = MOST_CURVES * sizeof(place);

static shared_round share(const state* now, int processes) {
  shared_round r;
  const size_t bytes = (BINS + 1) * sizeof(wrc_damage_bin);
  r.cleared = processes * (bytes + 64);
  r.memory = mmap(NULL, r.cleared + of_places, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (r.memory == MAP_FAILED) check(-1, "memory", "cannot be shared");
  r.lost = (int*)(r.memory + processes * bytes);
  r.places = (place*)(r.memory + r.cleared);
  memcpy(r.places, now->places, of_places);
  for (int k = 0; k < processes; ++k) {
    r.bins[k] = wrc_damage_bins_default();
    r.bins[k].count = BINS;
    r.bins[k].first = -0.080;
    r.bins[k].width = 0.5e-3;
    r.bins[k].bins = (wrc_damage_bin*)(r.memory + k * bytes);
    r.bins[k].bin_size = sizeof(wrc_damage_bin);
  }
  return r;
}

/* Depth that one time through the network takes off, bin by bin [m]; lost[0]: curves left out. */
static void run_network(shared_round* r, const wrc_model* model, int curves, int processes, double* depth) {
  memset(r->memory, 0, r->cleared);
  for (int k = 0; k < processes; ++k) {
    if (fork() != 0) continue;
    r->lost[k] = run(model, &r->bins[k], r->places, curves, k, processes);
    _exit(0);
  }
  for (int k = 0; k < processes; ++k) {
    int outcome = 0;
    if (wait(&outcome) < 0 || outcome != 0) check(-1, "process", "ended early");
  }
  for (int k = 1; k < processes; ++k)
    check(wrc_damage_merge(&r->bins[0], &r->bins[k]), "merge", ""), r->lost[0] += r->lost[k];
  double volume[BINS + 1];
  check(wrc_damage_values(&r->bins[0], WRC_DAMAGE_WEAR_ARCHARD, volume), "values", "");
  /* both wheels' volumes are in there, of which a wheel has half */
  for (int i = 0; i < BINS; ++i) depth[i] = 0.5 * volume[i] / (0.5e-3 * 2.0 * 3.14159265358979 * radius);
}

/* Takes so many passages off the profile, or as many as wear it by 0.2 mm. */
static wrc_worn_profile wear_off(state* now, const double* depth, double passages) {
  wrc_profile_wear wear = wrc_profile_wear_default();
  wear.count = now->points;
  wear.y = now->y;
  wear.z = now->z;
  wear.bin_count = BINS;
  wear.depth = depth;
  wear.first = -0.080;
  wear.width = 0.5e-3;
  wear.passages = passages;
  wear.largest_depth = 0.2e-3;
  double y[POINTS] = {0}, z[POINTS] = {0};
  wrc_worn_profile worn = {.struct_size = sizeof worn};
  worn.capacity = POINTS;
  worn.y = y;
  worn.z = z;
  char text[256] = "";
  check(wrc_profile_remove_wear(&wear, &worn, text, sizeof text), "wear", text);
  now->points = worn.count;
  memcpy(now->y, y, sizeof y);
  memcpy(now->z, z, sizeof z);
  worn.y = now->y;
  worn.z = now->z;
  return worn;
}

int main(int argc, char** argv) {
  if (argc < 2) {
    fprintf(stderr, "wheel_wear FOLDER [distance in km] [curves] [processes]\n");
    return EXIT_FAILURE;
  }
  const char* folder = argv[1];
  const double distance = argc > 2 ? atof(argv[2]) : 100e3;
  const int curves = argc > 3 ? atoi(argv[3]) : 1000, processes = argc > 4 ? atoi(argv[4]) : 2;
  if (!(curves >= 1 && curves <= MOST_CURVES && processes >= 1 && processes <= MOST_PROCESSES))
    return EXIT_FAILURE;
  make_network(curves);
  qsort(network, (size_t)curves, sizeof network[0], by_curvature);
  double length = 0.0; /* of the network [km] */
  for (int i = 0; i < curves; ++i) length += 1e-3 * network[i].length;

  static state now;
  wrc_model* model = begin(folder, &now);
  shared_round work = share(&now, processes);
  while (now.distance < distance) {
    double depth[BINS];
    run_network(&work, model, curves, processes, depth);
    const double mark = 10e3 * (floor(now.distance / 10e3 + 1e-9) + 1.0); /* the next profile to be written */
    const double until = mark < distance ? mark : distance, before = now.distance;
    const wrc_worn_profile worn = wear_off(&now, depth, (until - now.distance) / length);
    memcpy(now.places, work.places, of_places);
    now.distance += worn.passages * length;
    if (now.distance > until - 1e-6) now.distance = until;
    ++now.updates;
    wrc_model_destroy(model);
    model = make_model(&now);
    if (now.distance == until) write_profile(folder, &now);
    write_line(folder, &now, model, worn.depth, work.lost[0]);
    write_state(folder, &now);
    if (now.distance <= before) check(-1, "wear", "takes off no whole passage");
  }
  wrc_model_destroy(model);
  return EXIT_SUCCESS;
}
