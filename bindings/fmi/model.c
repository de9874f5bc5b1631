#include "model.h"

#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------------------------------------ variables
 */

enum causality { input, output, parameter, calculatedParameter, local };
enum variability { continuous, discrete, tunable, fixed };
/* A row of a .def file. */
typedef struct variable {
  const char* name;
  enum causality causality;
  enum variability variability;
  double start, least, most;
} variable;

#define TOKEN(text)
#define ANY -HUGE_VAL, HUGE_VAL
#define RANGE(least, most) least, most
#define REAL(name, unit, causality, variability, start, range, description) \
  {#name, causality, variability, start, range},
#define INTEGER(name, causality, variability, start, range, description)
static const variable wheel_reals[] = {
#include "wheel.def"
};
static const variable wheelset_reals[] = {
#include "wheelset.def"
};
#undef REAL
#undef INTEGER
#define REAL(name, unit, causality, variability, start, range, description)
#define INTEGER(name, causality, variability, start, range, description) \
  {#name, causality, variability, start, range},
static const variable wheel_integers[] = {
#include "wheel.def"
};
static const variable wheelset_integers[] = {
#include "wheelset.def"
};
#undef INTEGER
#undef TOKEN
#define INTEGER(name, causality, variability, start, range, description)
#define TOKEN(text) text
static const char wheel_token[] =
#include "wheel.def"
    ;
static const char wheelset_token[] =
#include "wheelset.def"
    ;

/* The parameters of bodies.def, wherever they stand in the variables of a kind. */
#define OF_KIND(of, name) ((of)->now.real[(of)->kind == WHEEL ? WHEEL_##name : SET_##name])
#define INTEGER_OF_KIND(of, name) ((of)->now.integer[(of)->kind == WHEEL ? WHEEL_##name : SET_##name])

static const variable* reals(const instance* of) { return of->kind == WHEEL ? wheel_reals : wheelset_reals; }
static const variable* integers(const instance* of) {
  return of->kind == WHEEL ? wheel_integers : wheelset_integers;
}
static uint32_t real_count(const instance* of) { return of->kind == WHEEL ? WHEEL_REALS : SET_REALS; }
static uint32_t integer_count(const instance* of) {
  return of->kind == WHEEL ? WHEEL_INTEGERS : SET_INTEGERS;
}

outcome model_say(instance* of, outcome severity, const char* sentence) {
  if (of->say) of->say(of, (int)severity, sentence);
  return severity;
}
static outcome wrong(instance* of, const char* sentence) { return model_say(of, WRONG, sentence); }

/* Is a number finite and in its variable's range? If not, the host is told. */
static int in_range(instance* of, const variable* which, double value) {
  char sentence[256];
  if (value >= which->least && value <= which->most && value - value == 0.0) return 1;
  if (value - value != 0.0)
    snprintf(sentence, sizeof sentence, "%s = %g: a finite number is asked for", which->name, value);
  else
    snprintf(sentence, sizeof sentence, "%s = %g: allowed are %g to %g", which->name, value, which->least,
             which->most);
  return wrong(of, sentence), 0;
}

/* Does the FMU compute it, from what the host gives? */
static int computed(const variable* which) {
  return which->causality == output || which->causality == local || which->causality == calculatedParameter;
}

/* ------------------------------------------------------------------------------------------------- profiles
 */

static FILE* open_points(const instance* of, const char* name, char* path, size_t size) {
  snprintf(path, size, "%s/%s", of->resources, name);
  return fopen(path, "r");
}

/* Is there such a file? Then it is the default: make_fmu.py writes so into the description. */
static int has_points(const instance* of, const char* name) {
  char path[2048];
  FILE* file = open_points(of, name, path, sizeof path);
  if (file) fclose(file);
  return file != NULL;
}

/* Points of a file: y and z in mm in each line, # begins a comment. Written to *y and *z, in metres, to be
 * freed. */
static int read_points(instance* of, const char* name, double** y, double** z, uint32_t* count) {
  enum { most = 20000 };
  char path[2048], line[512], sentence[2600];
  FILE* file = open_points(of, name, path, sizeof path);
  if (!file) {
    snprintf(sentence, sizeof sentence,
             "%s cannot be read: put the profile's points there, or choose a built-in profile", path);
    return wrong(of, sentence), 0;
  }
  const char point = *localeconv()->decimal_point; /* of the host: strtod follows it */
  *y = malloc(most * sizeof **y);
  *z = malloc(most * sizeof **z);
  *count = 0;
  int good = *y && *z;
  for (unsigned number = 1; good && fgets(line, sizeof line, file); ++number) {
    line[strcspn(line, "#\r\n")] = 0;
    if (line[strspn(line, " \t")] == 0) continue;
    for (char* each = line; *each; ++each)
      if (*each == '.') *each = point;
    char *behind_y, *behind_z;
    const double value = strtod(line, &behind_y), height = strtod(behind_y, &behind_z);
    good =
        behind_y != line && behind_z != behind_y && behind_z[strspn(behind_z, " \t")] == 0 && *count < most;
    if (good) {
      (*y)[*count] = 1e-3 * value;
      (*z)[(*count)++] = 1e-3 * height;
    } else {
      snprintf(sentence, sizeof sentence,
               "%s, line %u: two numbers, y and z in mm, are asked for, in %d lines at most", path, number,
               most);
      wrong(of, sentence);
    }
  }
  fclose(file);
  return good;
}

static int read_profile(instance* of, wrc_profile* profile, int32_t kind, double smoothing, const char* file,
                        double** y, double** z) {
  profile->kind = kind;
  if (kind != WRC_PROFILE_POINTS) return 1;
  profile->smoothing = smoothing;
  if (!read_points(of, file, y, z, &profile->count)) return 0;
  profile->y = *y;
  profile->z = *z;
  return 1;
}

/* ---------------------------------------------------------------------------------------------- instance */

/* The path of a file URI, %20 and the like decoded; a path as it is. To be freed. */
static char* folder_of(const char* location) {
  const char* from = location ? location : "";
  const int uri = strncmp(from, "file:", 5) == 0;
  if (uri) {
    from += 5;
    if (strncmp(from, "//", 2) == 0) from = from + 2 + strcspn(from + 2, "/"); /* file://host/path */
    if (from[0] == '/' && from[1] && from[2] == ':') ++from;                   /* /C:/path */
  }
  char* made = malloc(strlen(from) + 1);
  if (!made) return NULL;
  char* to = made;
  for (; *from; ++from) {
    char digits[3] = {0, 0, 0};
    char* end = digits;
    if (uri && *from == '%' && from[1] && from[2]) {
      digits[0] = from[1];
      digits[1] = from[2];
    }
    const long code = strtol(digits, &end, 16);
    if (end == digits + 2) from += 2;
    *to++ = end == digits + 2 ? (char)code : *from;
  }
  while (to > made && (to[-1] == '/' || to[-1] == '\\')) --to;
  *to = 0;
  return made;
}

/* Both contacts, then what they are made of. */
static void drop_model(instance* of) {
  for (int side = 0; side < 2; ++side) {
    wrc_contact_destroy(of->contact[side]);
    of->contact[side] = NULL;
  }
  wrc_model_destroy(of->model);
  of->model = NULL;
}

void model_reset(instance* of) {
  drop_model(of);
  memset(&of->now, 0, sizeof of->now);
  for (uint32_t i = 0; i < real_count(of); ++i) of->now.real[i] = reals(of)[i].start;
  for (uint32_t i = 0; i < integer_count(of); ++i) of->now.integer[i] = (int32_t)integers(of)[i].start;
  if (has_points(of, "wheel.txt")) INTEGER_OF_KIND(of, wheel_profile) = WRC_PROFILE_POINTS;
  if (has_points(of, "rail.txt")) INTEGER_OF_KIND(of, rail_profile) = WRC_PROFILE_POINTS;
  of->slopes_known = 0;
}

instance* model_new(const char* token, const char* resources) {
  const int wheel = token && strcmp(token, wheel_token) == 0,
            set = token && strcmp(token, wheelset_token) == 0;
  instance* of = wheel || set ? calloc(1, sizeof *of) : NULL;
  if (!of) return NULL;
  of->kind = wheel ? WHEEL : WHEELSET;
  of->resources = folder_of(resources);
  if (!of->resources) {
    free(of);
    return NULL;
  }
  model_reset(of);
  return of;
}

void model_free(instance* of) {
  if (!of) return;
  drop_model(of);
  free(of->resources);
  free(of);
}

/* A status of the library as FMI's: a failure is told to the host with the library's sentence. A wheel's pose
 * out of range is an integrator's attempt as often as a mistake: it may be tried again with a smaller step.
 */
static outcome answer(instance* of, const wrc_contact* contact, int32_t status) {
  if (status >= 0) return FINE;
  char sentence[512] = "";
  wrc_contact_last_error(contact, sentence, sizeof sentence);
  const int attempt = of->kind == WHEEL && status == WRC_ERROR_RANGE;
  return model_say(of, attempt ? DISCARDED : WRONG, *sentence ? sentence : wrc_status_text(status));
}

/* Height of a centred wheel that rolls straight on under a load [N]. */
static outcome standing(instance* of, wrc_contact* contact, double load, double* z) {
  wrc_wheel_input given = wrc_wheel_input_default();
  wrc_wrench wrench = {.struct_size = sizeof wrench};
  const double speed = of->kind == WHEELSET && of->now.real[SET_speed] != 0.0 ? of->now.real[SET_speed] : 1.0;
  given.wheel.velocity[0] = speed;
  given.wheel.pitch_rate = -speed / OF_KIND(of, wheel_radius);
  given.friction.coefficient = OF_KIND(of, friction);
  given.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  given.vertical_load = load;
  const int32_t status = wrc_contact_wrench(contact, &given, &wrench);
  *z = wrench.z;
  return answer(of, contact, status);
}

/* Sets all that is computed to NaN, so that a host which ignores a failed start sees that nothing was
 * computed. */
static void have_nothing(instance* of) {
  for (uint32_t i = 0; i < real_count(of); ++i)
    if (computed(&reals(of)[i])) of->now.real[i] = NAN;
  for (uint32_t i = 0; i < integer_count(of); ++i)
    if (computed(&integers(of)[i])) of->now.integer[i] = 0;
}

/* Model and contacts of the parameters. */
static outcome make_model(instance* of) {
  wrc_config config = wrc_config_default();
  config.wheelset.wheel_radius = OF_KIND(of, wheel_radius);
  config.wheelset.tape_circle_distance = OF_KIND(of, tape_circle_distance);
  config.track.gauge = OF_KIND(of, gauge);
  config.track.rail_inclination = OF_KIND(of, rail_inclination);
  config.wheel_material.shear_modulus = config.rail_material.shear_modulus = OF_KIND(of, shear_modulus);
  config.wheel_material.poisson = config.rail_material.poisson = OF_KIND(of, poisson);
  double* points[4] = {NULL, NULL, NULL, NULL};
  outcome how = WRONG;
  if (read_profile(of, &config.wheel, INTEGER_OF_KIND(of, wheel_profile), OF_KIND(of, wheel_smoothing),
                   "wheel.txt", &points[0], &points[1]) &&
      read_profile(of, &config.rail, INTEGER_OF_KIND(of, rail_profile), OF_KIND(of, rail_smoothing),
                   "rail.txt", &points[2], &points[3])) {
    char sentence[512] = "";
    int32_t status = wrc_model_create(&config, NULL, &of->model, sentence, sizeof sentence);
    const int first = of->kind == WHEEL ? of->now.integer[WHEEL_side] : WRC_SIDE_RIGHT;
    const int last = of->kind == WHEEL ? first : WRC_SIDE_LEFT;
    for (int side = first; side <= last && status >= 0; ++side)
      status = wrc_contact_create(of->model, side, NULL, &of->contact[side], sentence, sizeof sentence);
    how = status < 0 ? wrong(of, sentence) : FINE;
  }
  for (int i = 0; i < 4; ++i) free(points[i]);
  return how;
}

outcome model_start(instance* of) {
  drop_model(of);
  of->input = wrc_wheel_input_default();
  of->now.solved = of->slopes_known = 0;
  double* now = of->now.real;
  outcome how = make_model(of);
  if (of->kind == WHEEL) {
    if (how == FINE)
      how = standing(of, of->contact[of->now.integer[WHEEL_side]], now[WHEEL_load], &now[WHEEL_standing_z]);
  } else {
    for (int i = SET_y; i <= SET_pitch_rate; ++i) now[i] = 0.0;
    for (int i = SET_water_behind; i <= SET_heat_on_wheel; ++i) now[i] = 0.0;
    now[SET_y] = now[SET_start_y];
    now[SET_yaw] = now[SET_start_yaw];
    now[SET_pitch_rate] = -now[SET_speed] / now[SET_wheel_radius];
    if (how == FINE) how = standing(of, of->contact[WRC_SIDE_RIGHT], 0.5 * now[SET_load], &now[SET_z]);
  }
  if (how == FINE) return FINE;
  drop_model(of);
  have_nothing(of);
  return WRONG;
}

/* ------------------------------------------------------------------------------------------------- wrenches
 */

static wrc_contact* of_wheel(instance* of) { return of->contact[of->now.integer[WHEEL_side]]; }

/* What the inputs, friction and damping are to the library. */
static void give_wheel(instance* of) {
  const double* from = of->now.real;
  wrc_wheel_state* wheel = &of->input.wheel;
  wrc_rail_state* rail = &of->input.rail;
  wheel->reference = of->now.integer[WHEEL_reference];
  wheel->y = from[WHEEL_y];
  wheel->z = from[WHEEL_z];
  wheel->roll = from[WHEEL_roll];
  wheel->yaw = from[WHEEL_yaw];
  for (int i = 0; i < 3; ++i) wheel->velocity[i] = from[WHEEL_vx + i];
  wheel->roll_rate = from[WHEEL_roll_rate];
  wheel->pitch_rate = from[WHEEL_pitch_rate];
  wheel->yaw_rate = from[WHEEL_yaw_rate];
  rail->y = from[WHEEL_rail_y];
  rail->z = from[WHEEL_rail_z];
  rail->roll = from[WHEEL_rail_roll];
  rail->y_velocity = from[WHEEL_rail_y_velocity];
  rail->z_velocity = from[WHEEL_rail_z_velocity];
  rail->roll_rate = from[WHEEL_rail_roll_rate];
  rail->y_slope = from[WHEEL_rail_y_slope];
  rail->z_slope = from[WHEEL_rail_z_slope];
  of->input.friction.coefficient = from[WHEEL_friction];
  of->input.damping = from[WHEEL_damping];
}

/* Outputs of a wrench, where there is one. */
static outcome take_wheel(instance* of, int32_t status, const wrc_wrench* wrench) {
  double* to = of->now.real;
  of->now.integer[WHEEL_flags] = (int32_t)wrench->flags;
  if (status < 0) return answer(of, of_wheel(of), status);
  for (int i = 0; i < 3; ++i) {
    to[WHEEL_fx + i] = wrench->force[i];
    to[WHEEL_mx + i] = wrench->moment[i];
  }
  to[WHEEL_normal_force] = wrench->normal_force;
  to[WHEEL_area] = wrench->area;
  to[WHEEL_peak_pressure] = wrench->peak_pressure;
  to[WHEEL_power] = wrench->power;
  of->now.integer[WHEEL_regions] = wrench->region_count;
  of->now.solved = 1;
  return FINE;
}

/* Brings the outputs up to date. */
static outcome solve(instance* of) {
  if (!of->model && of->initialising) { /* outputs may be asked for before initialisation ends */
    const outcome made = model_start(of);
    if (made != FINE) return made;
  }
  if (of->now.solved || !of->model) return FINE;
  if (of->kind == WHEELSET) {
    const wrc_contact* failed = NULL;
    return answer(of, failed, wheelset_solve(of, &failed));
  }
  wrc_wrench wrench = {.struct_size = sizeof wrench};
  give_wheel(of);
  return take_wheel(of, wrc_contact_wrench(of_wheel(of), &of->input, &wrench), &wrench);
}

/* The column of an input's derivatives. */
static uint32_t column_of(uint32_t number) {
  return number == WHEEL_rail_y_slope   ? WRC_BY_RAIL_Y_SLOPE
         : number == WHEEL_rail_z_slope ? WRC_BY_RAIL_Z_SLOPE
                                        : number;
}

/* Rows of the wrench, columns of the inputs. */
outcome model_derivatives(instance* of, int transposed, const uint32_t* unknowns, size_t unknown_count,
                          const uint32_t* knowns, size_t known_count, const double* seed, double* result) {
  if (of->kind != WHEEL || !of->model) return wrong(of, "no derivatives: of an initialised wheel alone");
  for (size_t i = 0; i < unknown_count; ++i)
    if (unknowns[i] < WHEEL_fx || unknowns[i] > WHEEL_mz) return wrong(of, "derivatives are of fx .. mz");
  for (size_t j = 0; j < known_count; ++j)
    if (knowns[j] > WHEEL_rail_z_slope) return wrong(of, "derivatives are by the inputs");
  if (!of->slopes_known) {
    wrc_wrench wrench = {.struct_size = sizeof wrench};
    give_wheel(of);
    of->slopes.struct_size = sizeof of->slopes;
    const int32_t status = wrc_contact_wrench_derivatives(of_wheel(of), &of->input, &wrench, &of->slopes);
    const outcome how = take_wheel(of, status, &wrench);
    if (how != FINE) return how;
    of->slopes_known = 1;
  }
  const size_t results = transposed ? known_count : unknown_count;
  for (size_t i = 0; i < results; ++i) result[i] = 0.0;
  for (size_t i = 0; i < unknown_count; ++i)
    for (size_t j = 0; j < known_count; ++j) {
      const double slope = of->slopes.wrench[unknowns[i] - WHEEL_fx][column_of(knowns[j])];
      if (transposed)
        result[j] += slope * seed[i];
      else
        result[i] += slope * seed[j];
    }
  return FINE;
}

/* ------------------------------------------------------------------------------------------------- variables
 */

outcome model_get_real(instance* of, const uint32_t* numbers, size_t count, double* values) {
  for (size_t i = 0; i < count; ++i) {
    if (numbers[i] == TIME) {
      values[i] = of->now.time;
      continue;
    }
    if (numbers[i] >= real_count(of)) return wrong(of, "no such real variable");
    if (computed(&reals(of)[numbers[i]])) {
      const outcome how = solve(of);
      if (how != FINE) return how;
    }
    values[i] = of->now.real[numbers[i]];
  }
  return FINE;
}

/* May it be set, now and to this value? A fixed parameter is what models are made of. */
static outcome may_change(instance* of, const variable* which, double value) {
  char sentence[160];
  if (computed(which)) {
    snprintf(sentence, sizeof sentence, "%s cannot be set: it is computed", which->name);
    return wrong(of, sentence);
  }
  if (!in_range(of, which, value)) return WRONG;
  if (which->variability != fixed) return FINE;
  if (of->model && !of->initialising) return wrong(of, "a fixed parameter cannot be changed any more");
  drop_model(of);
  return FINE;
}

outcome model_set_real(instance* of, const uint32_t* numbers, size_t count, const double* values) {
  for (size_t i = 0; i < count; ++i) {
    if (numbers[i] >= real_count(of)) return wrong(of, "no such real variable");
    double* to = &of->now.real[numbers[i]];
    if (memcmp(to, &values[i], sizeof *to) == 0) continue;
    if (may_change(of, &reals(of)[numbers[i]], values[i]) != FINE) return WRONG;
    *to = values[i];
    of->now.solved = of->slopes_known = 0;
  }
  return FINE;
}

outcome model_get_integer(instance* of, const uint32_t* numbers, size_t count, int32_t* values) {
  for (size_t i = 0; i < count; ++i) {
    const uint32_t number = numbers[i] - FIRST_INTEGER;
    if (number >= integer_count(of)) return wrong(of, "no such integer variable");
    if (computed(&integers(of)[number])) {
      const outcome how = solve(of);
      if (how != FINE) return how;
    }
    values[i] = of->now.integer[number];
  }
  return FINE;
}

outcome model_set_integer(instance* of, const uint32_t* numbers, size_t count, const int32_t* values) {
  for (size_t i = 0; i < count; ++i) {
    const uint32_t number = numbers[i] - FIRST_INTEGER;
    if (number >= integer_count(of)) return wrong(of, "no such integer variable");
    if (of->now.integer[number] == values[i]) continue;
    if (may_change(of, &integers(of)[number], values[i]) != FINE) return WRONG;
    of->now.integer[number] = values[i];
    of->now.solved = of->slopes_known = 0;
  }
  return FINE;
}

/* ----------------------------------------------------------------------------------------------------- state
 */

void model_save(const instance* of, saved* into) {
  memset(into, 0, sizeof *into);
  strncpy(into->mark, of->kind == WHEEL ? wheel_token : wheelset_token, sizeof into->mark - 1);
  into->now = of->now;
}

outcome model_valid(instance* of, const saved* from) {
  saved own;
  model_save(of, &own);
  if (memcmp(own.mark, from->mark, sizeof own.mark) != 0)
    return wrong(of, "not a state of this FMU in this version");
  int good = (from->now.solved == 0 || from->now.solved == 1) && from->now.time - from->now.time == 0.0;
  for (uint32_t i = 0; good && i < real_count(of); ++i) good = in_range(of, &reals(of)[i], from->now.real[i]);
  for (uint32_t i = 0; good && i < integer_count(of); ++i)
    good = in_range(of, &integers(of)[i], from->now.integer[i]);
  return good ? FINE : wrong(of, "not a state that can be gone on from");
}

outcome model_restore(instance* of, const saved* from) {
  if (model_valid(of, from) != FINE) return WRONG;
  /* another instance's parameters may be others */
  int same = of->model != NULL;
  for (uint32_t i = 0; i < real_count(of); ++i)
    if (reals(of)[i].variability == fixed) same &= of->now.real[i] == from->now.real[i];
  for (uint32_t i = 0; i < integer_count(of); ++i)
    if (integers(of)[i].variability == fixed) same &= of->now.integer[i] == from->now.integer[i];
  of->now = from->now;
  of->slopes_known = 0;
  if (same) return FINE;
  const outcome how = model_start(of);
  of->now = from->now;
  return how;
}
