/* own_case.c - your own profiles, load and creepages from the command line; ./run.sh --help lists the
 * options. */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "wrc/wrc_planar.h"

enum { MOST_POINTS = 20000 };

/* ----------------------------------------------------------------------------------------------------
 * profile files */

/* Leaves blanks alone between the numbers of a line, and cuts its comment. A comma between digits is decimal
 * where something else parts the numbers. */
static void part_numbers(char* line) {
  line[strcspn(line, "#!%\r\n")] = '\0';
  const size_t begin = strspn(line, " \t");
  size_t end = strlen(line);
  while (end > begin && (line[end - 1] == ' ' || line[end - 1] == '\t')) line[--end] = '\0';
  const int others = strpbrk(line + begin, "; \t") != NULL;
  for (size_t k = begin; k < end; ++k) {
    const int decimal = others && line[k] == ',' && k > begin && isdigit((unsigned char)line[k - 1]) &&
                        isdigit((unsigned char)line[k + 1]);
    if (line[k] == ',') line[k] = decimal ? '.' : ' ';
  }
  for (size_t k = begin; k < end; ++k)
    if (line[k] == ';' || line[k] == '\t') line[k] = ' ';
}

/* Reads "y z" lines into arrays that live as long as the program; returns the number of points. */
static uint32_t read_points(const char* path, double scale, double* y, double* z) {
  FILE* file = fopen(path, "r");
  if (file == NULL) {
    fprintf(stderr, "cannot open profile file '%s'; built in are S1002 and the rails 60E1 and UIC60\n", path);
    exit(EXIT_FAILURE);
  }
  char line[256];
  uint32_t count = 0;
  unsigned number_of_line = 0;
  while (fgets(line, sizeof line, file) != NULL) {
    ++number_of_line;
    if (number_of_line == 1 && strncmp(line, "\xef\xbb\xbf", 3) == 0) {
      memmove(line, line + 3, strlen(line) - 2); /* a byte order mark is no part of the first number */
    }
    if (strchr(line, '\n') ==
        NULL) { /* too long for a point: a comment; the rest of it is not a line of its own */
      for (int c = fgetc(file); c != '\n' && c != EOF;) c = fgetc(file);
    }
    part_numbers(line);
    double a = 0.0, b = 0.0, more = 0.0;
    const int found = sscanf(line, "%lf %lf %lf", &a, &b, &more);
    if (found > 2) {
      fprintf(
          stderr,
          "%s, line %u: more than two numbers; give y and z, parted by blanks or ; if commas are decimal\n",
          path, number_of_line);
      exit(EXIT_FAILURE);
    }
    const char first = line[strspn(line, " ")];
    const int comment = first == '\0' || first == '/';
    if (found == 1 || (found <= 0 && count > 0 && !comment)) {
      fprintf(stderr, "%s, line %u: not a point; give y and z, comments behind #\n", path, number_of_line);
      exit(EXIT_FAILURE);
    }
    if (found != 2) continue; /* a heading above the points, a comment, an empty line */
    if (count == MOST_POINTS) {
      fprintf(stderr, "%s has more than %d points\n", path, MOST_POINTS);
      exit(EXIT_FAILURE);
    }
    y[count] = scale * a;
    z[count] = scale * b;
    ++count;
  }
  fclose(file);
  if (count == 0) {
    fprintf(stderr, "%s has no points: a profile file has one per line, y and z\n", path);
    exit(EXIT_FAILURE);
  }
  if (count < 4) {
    fprintf(stderr, "%s has %u points; a profile has at least 4, one y and z per line\n", path,
            (unsigned)count);
    exit(EXIT_FAILURE);
  }
  return count;
}

/* Warns of points that leave the line between their neighbours by 0.3 mm and by half of the neighbours'
 * distance. */
static void warn_of_spikes(const char* path, uint32_t count, const double* y, const double* z) {
  for (uint32_t k = 1; k + 1 < count; ++k) {
    const double width = y[k + 1] - y[k - 1], rise = z[k + 1] - z[k - 1];
    const double off = z[k] - z[k - 1] - rise * (y[k] - y[k - 1]) / width,
                 chord2 = width * width + rise * rise;
    if (chord2 < 25e-6 && off * off > 0.09e-6 && off * off > 0.25 * chord2) {
      fprintf(stderr, "warning: %s: z leaves its neighbours by %.2f mm at y = %.3f mm: a spike?\n", path,
              1e3 * off, 1e3 * y[k]);
    }
  }
}

/* Says so where the width fits no profile, or the other unit. The library takes profiles of 20 to 500 mm. */
static void warn_of_unit(const char* path, uint32_t count, const double* y, int metres) {
  const double width = y[count - 1] - y[0], other = metres ? 1e-3 * width : 1e3 * width;
  if (width <= 0.0 || (width >= 0.02 && width <= 0.5)) return; /* the library says how points run */
  fprintf(stderr, "warning: %s is %g %s wide, a profile 20 to 500 mm: ", path, metres ? width : 1e3 * width,
          metres ? "m" : "mm");
  if (other >= 0.02 && other <= 0.5)
    fprintf(stderr, "are its points in %s? pass --unit %s\n", metres ? "mm" : "m", metres ? "mm" : "m");
  else
    fputs("in which unit are its points? --unit is mm or m\n", stderr);
}

/* -----------------------------------------------------------------------------------------------------
 * command line */

typedef struct options {
  const char *wheel, *rail, *csv;
  double scale, load;
  double smoothing, inclination, radius, gauge, tape_circles, lateral, yaw, friction, speed, shear_modulus,
      poisson;
  double creepage[3];
} options;

static double number(const char* option, const char* text) {
  char* end = NULL;
  const double value = text != NULL ? strtod(text, &end) : 0.0;
  if (text == NULL || end == text || *end != '\0') {
    fprintf(stderr, "%s needs a number, not '%s'; see ./run.sh --help\n", option, text != NULL ? text : "");
    exit(EXIT_FAILURE);
  }
  return value;
}

static options parse(int argc, char** argv) {
  options given = {"S1002",         "UIC60", NULL, 1e-3, 80e3, 0.0, 0.0,  0.46,
                   1.435,           1.5,     0.0,  0.0,  0.35, 1.0, 82e9, 0.28,
                   {1e-3, 0.0, 0.0}};
  const struct {
    const char* name;
    double* value;
  } numbers[] = {{"--load", &given.load},
                 {"--smoothing", &given.smoothing},
                 {"--inclination", &given.inclination},
                 {"--radius", &given.radius},
                 {"--gauge", &given.gauge},
                 {"--tape-circles", &given.tape_circles},
                 {"--lateral", &given.lateral},
                 {"--yaw", &given.yaw},
                 {"--friction", &given.friction},
                 {"--speed", &given.speed},
                 {"--poisson", &given.poisson},
                 {"--shear-modulus", &given.shear_modulus}};
  for (int i = 1; i < argc; ++i) {
    const char* option = argv[i];
    const char* value = i + 1 < argc ? argv[i + 1] : NULL;
    int known = 0;
    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; ++k) {
      if (strcmp(option, numbers[k].name) == 0) {
        *numbers[k].value = number(option, value);
        known = 1;
      }
    }
    if (known) {
      ++i;
    } else if (strcmp(option, "--creepage") == 0) {
      if (i + 3 >= argc) {
        fputs("--creepage needs three numbers: longitudinal, lateral [-], spin [1/m]; see ./run.sh --help\n",
              stderr);
        exit(EXIT_FAILURE);
      }
      for (int k = 0; k < 3; ++k) given.creepage[k] = number(option, argv[i + 1 + k]);
      i += 3;
    } else if (value != NULL && strcmp(option, "--wheel") == 0) {
      given.wheel = argv[++i];
    } else if (value != NULL && strcmp(option, "--rail") == 0) {
      given.rail = argv[++i];
    } else if (value != NULL && strcmp(option, "--csv") == 0) {
      given.csv = argv[++i];
    } else if (value != NULL && strcmp(option, "--unit") == 0) {
      if (strcmp(value, "mm") != 0 && strcmp(value, "m") != 0) {
        fprintf(stderr, "--unit is mm or m, not '%s'\n", value);
        exit(EXIT_FAILURE);
      }
      given.scale = strcmp(value, "mm") == 0 ? 1e-3 : 1.0;
      ++i;
    } else {
      fprintf(stderr, value != NULL ? "unknown option: %s" : "%s has no value behind it, or is no option",
              option);
      fputs("; see ./run.sh --help\n", stderr);
      exit(EXIT_FAILURE);
    }
  }
  return given;
}

/* ----------------------------------------------------------------------------------------------------------
 * the job */

/* A built-in shape by name, or points from a file. */
static wrc_profile profile_from(const char* source, const options* given, double* y, double* z) {
  wrc_profile profile = {.kind = WRC_PROFILE_NONE};
  if (strcmp(source, "S1002") == 0) {
    profile.kind = WRC_PROFILE_S1002;
  } else if (strcmp(source, "60E1") == 0) {
    profile.kind = WRC_PROFILE_60E1;
  } else if (strcmp(source, "UIC60") == 0) {
    profile.kind = WRC_PROFILE_UIC60_BENCHMARK;
  } else {
    profile.kind = WRC_PROFILE_POINTS;
    profile.count = read_points(source, given->scale, y, z);
    profile.y = y;
    profile.z = z;
    profile.smoothing = given->smoothing;
    warn_of_unit(source, profile.count, y, given->scale == 1.0);
    warn_of_spikes(source, profile.count, y, z);
  }
  return profile;
}

/* A field of the first patch, counts of cells and strips; to be freed. */
static double* field_of(wrc_contact* contact, int32_t field, uint64_t counts[2]) {
  if (wrc_contact_field(contact, 0, field, NULL, 0, counts) != WRC_OK) return NULL;
  const size_t size = (size_t)(counts[0] * counts[1]);
  double* values = malloc(size * sizeof *values);
  if (values == NULL || wrc_contact_field(contact, 0, field, values, size, NULL) != WRC_OK) {
    free(values);
    return NULL;
  }
  return values;
}

static void write_csv(wrc_contact* contact, const char* path) {
  static const int32_t fields[] = {
      WRC_FIELD_X,      WRC_FIELD_PRESSURE, WRC_FIELD_TRACTION_X,    WRC_FIELD_TRACTION_Y,
      WRC_FIELD_SLIP_X, WRC_FIELD_SLIP_Y,   WRC_FIELD_POWER_DENSITY, WRC_FIELD_FATIGUE_INDEX};
  enum { FIELDS = 8 };
  uint64_t counts[2] = {0, 0};
  double* const y = field_of(contact, WRC_FIELD_STRIP_Y, counts);
  double* values[FIELDS];
  int all = y != NULL;
  for (int k = 0; k < FIELDS; ++k) {
    values[k] = field_of(contact, fields[k], counts);
    all = all && values[k] != NULL;
  }
  FILE* file = fopen(path, "w");
  if (file == NULL) {
    fprintf(stderr, "cannot write '%s'\n", path);
    exit(EXIT_FAILURE);
  }
  fprintf(file,
          "y_m,x_m,pressure_Pa,traction_x_Pa,traction_y_Pa,slip_x,slip_y,power_W_per_m2,fatigue_index\n");
  for (uint64_t j = 0; all && j < counts[1]; ++j) {
    for (uint64_t i = 0; i < counts[0]; ++i) {
      fprintf(file, "%.9g", y[j]);
      for (int k = 0; k < FIELDS; ++k) fprintf(file, ",%.9g", values[k][j * counts[0] + i]);
      fprintf(file, "\n");
    }
  }
  fclose(file);
  free(y);
  for (int k = 0; k < FIELDS; ++k) free(values[k]);
  printf("fields written to %s\n", path);
}

int main(int argc, char** argv) {
  static double points[4][MOST_POINTS];
  const options given = parse(argc, argv);
  wrc_config config = wrc_config_default();
  config.wheel = profile_from(given.wheel, &given, points[0], points[1]);
  config.rail = profile_from(given.rail, &given, points[2], points[3]);
  config.wheelset.wheel_radius = given.radius;
  config.track.gauge = given.gauge;
  config.wheelset.tape_circle_distance = given.tape_circles;
  config.track.rail_inclination = given.inclination;
  config.wheel_material.shear_modulus = config.rail_material.shear_modulus = given.shear_modulus;
  config.wheel_material.poisson = config.rail_material.poisson = given.poisson;
  char text[300];
  wrc_model* model = NULL;
  wrc_contact* contact = NULL;
  if (wrc_model_create(&config, NULL, &model, text, sizeof text) < 0 ||
      wrc_contact_create(model, WRC_SIDE_RIGHT, NULL, &contact, text, sizeof text) < 0) {
    fprintf(stderr, "%s\n", text);
    return EXIT_FAILURE;
  }

  wrc_planar_input input = wrc_planar_input_default();
  input.pose.lateral = given.lateral;
  input.pose.yaw = given.yaw;
  input.load.normal_force = given.load;
  input.creepage.longitudinal = given.creepage[0];
  input.creepage.lateral = given.creepage[1];
  input.creepage.spin = given.creepage[2];
  input.creepage.speed = given.speed;
  input.friction.coefficient = given.friction;
  wrc_planar_output output = {.struct_size = sizeof output};
  const int32_t status = wrc_planar_step(contact, &input, &output);
  if (status != WRC_OK) {
    wrc_contact_last_error(contact, text, sizeof text);
    fprintf(stderr, "%s: %s\n", wrc_status_name(status), text);
  }
  if (status >= 0) {
    const wrc_planar_point point = output.point;
    const wrc_planar_normal_solution normal = output.normal;
    const wrc_planar_forces forces = output.forces;
    const wrc_damage damage = output.damage;
    printf("contact point   wheel y = %.2f mm, rail y = %.2f mm, angle %.2f mrad, rolling radius %.2f mm\n",
           1e3 * point.y_wheel, 1e3 * point.y_rail, 1e3 * point.angle, 1e3 * point.rolling_radius);
    printf("patch           length %.2f mm, width %.2f mm (y %.2f .. %.2f mm), area %.1f mm2\n",
           1e3 * normal.length, 1e3 * normal.width, 1e3 * normal.y_min, 1e3 * normal.y_max,
           1e6 * normal.area);
    printf("double ellipse  a = %.2f mm, b = %.2f mm, psi = %.3f\n", 1e3 * normal.ellipse.a,
           1e3 * normal.ellipse.b, normal.ellipse.psi);
    printf("normal          N = %.0f N, approach %.2f um, stiffness %.3g N/m, peak pressure %.0f MPa\n",
           normal.normal_force, 1e6 * normal.approach, normal.stiffness, 1e-6 * normal.peak_pressure);
    printf(
        "on the wheel    Fx = %.1f N, Fy = %.1f N, Mz = %.2f N m (%.0f %% of friction * load, %.0f %% of the "
        "area sticks)\n",
        forces.fx, forces.fy, forces.mz, 100.0 * damage.utilisation / given.friction,
        100.0 * forces.adhesion_fraction);
    printf(
        "wear            power %.3g W, T-gamma %.3g N (without spin %.3g N), largest power density %.3g "
        "W/m2\n",
        damage.power, damage.t_gamma, damage.t_gamma_no_spin, damage.peak_power_density);
    printf("fatigue         index %.3f, largest local index %.3f; load factor %.2f, shakedown limit %.2f\n",
           damage.fatigue_index, damage.local_fatigue_index, damage.load_factor, damage.shakedown_limit);
    if (given.csv != NULL) write_csv(contact, given.csv);
  }
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
  return status < 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}
