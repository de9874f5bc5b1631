/* creep_curves.c - creep curves of every tangential method against Kalker's exact theory, and of every
 * friction law.
 *
 *   cc creep_curves.c -lwrc -lm -o creep_curves && ./creep_curves [directory]
 *
 * The patch is the double ellipse of S1002 on UIC60 at 80 kN: a = 5.8 mm, b = 10.3 mm, psi = -0.3. Prints the
 * largest deviation of each method from the exact forces, writes creep_curves.csv and friction_laws.csv,
 * which draw_creep_curves.py turns into pictures.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "wrc/wrc_offline.h"

#define POINTS 40     /* of a curve */
#define EXACT_EVERY 2 /* one in so many of them is solved exactly */
#define GRID 40       /* cells of the exact solver along x and y */

static const double pi = 3.14159265358979323846;
static const double mu = 0.35;
static const double shear_modulus = 80e9, poisson = 0.25; /* Pa, -: the source paper's steel */

typedef struct {
  const char *name, *method; /* ours, and the published one */
  int32_t bound, flexibility;
} variant;

/* Methods with a bound of their own leave the default. */
static const variant variants[] = {
    {"strip FASTSIM", "strip FASTSIM", WRC_BOUND_PARABOLIC, WRC_FLEXIBILITY_SEPARATE},
    {"FASTSIM-SDEC, parabolic", "FASTSIM-SDEC", WRC_BOUND_PARABOLIC, WRC_FLEXIBILITY_SEPARATE},
    {"FASTSIM-SDEC, elliptic", "FASTSIM-SDEC", WRC_BOUND_ELLIPTIC, WRC_FLEXIBILITY_SEPARATE},
    {"FASTSIM-SDEC, blended", "FASTSIM-SDEC", WRC_BOUND_ELLIPTIC, WRC_FLEXIBILITY_BLENDED},
    {"FASTSIM-SDEC, single", "FASTSIM-SDEC", WRC_BOUND_ELLIPTIC, WRC_FLEXIBILITY_SINGLE},
    {"FASTSIM-EQ.L", "FASTSIM-EQ.L", WRC_BOUND_PARABOLIC, WRC_FLEXIBILITY_SEPARATE},
    {"FASTSIM-EQ.E", "FASTSIM-EQ.E", WRC_BOUND_PARABOLIC, WRC_FLEXIBILITY_SEPARATE},
    {"FASTSIM", "FASTSIM", WRC_BOUND_PARABOLIC, WRC_FLEXIBILITY_SEPARATE},
    {"FaStrip", "FaStrip", WRC_BOUND_PARABOLIC, WRC_FLEXIBILITY_SEPARATE},
    {"FaStrip, modified", "modified FaStrip", WRC_BOUND_PARABOLIC, WRC_FLEXIBILITY_SEPARATE},
    {"FaStrip-SDEC", "FaStrip-SDEC", WRC_BOUND_PARABOLIC, WRC_FLEXIBILITY_SEPARATE}};
#define VARIANTS ((int)(sizeof variants / sizeof *variants))

/* Creepages in units of what saturates the patch in linear theory, from `from` to 4 times `slope`. */
typedef struct {
  const char* name;
  double from[3], slope[3];
} sweep;

static const sweep sweeps[] = {{"longitudinal", {0, 0, 0}, {4, 0, 0}},
                               {"lateral", {0, 0, 0}, {0, 4, 0}},
                               {"spin", {0, 0, 0}, {0, 0, 4}},
                               {"lateral with spin", {0, -3, 1}, {0, 6, 0}}};
#define SWEEPS ((int)(sizeof sweeps / sizeof *sweeps))

static wrc_ellipse ellipse;
static double unit[3]; /* mu N / (G c^2 C11), mu N / (G c^2 C22), mu N / (G c^3 C23) */

static void fail(const char* what, const char* text) {
  fprintf(stderr, "%s: %s\n", what, text);
  exit(EXIT_FAILURE);
}

static FILE* open_csv(const char* directory, const char* name) {
  char path[1024];
  snprintf(path, sizeof path, "%s/%s", directory, name);
  FILE* file = fopen(path, "w");
  if (file == NULL) fail("cannot write", path);
  return file;
}

static wrc_creepage creepage_at(const sweep* s, int point) {
  const double t = (double)point / POINTS;
  wrc_creepage c = wrc_creepage_default();
  c.longitudinal = (s->from[0] + t * s->slope[0]) * unit[0];
  c.lateral = (s->from[1] + t * s->slope[1]) * unit[1];
  c.spin = (s->from[2] + t * s->slope[2]) * unit[2];
  return c;
}

/* What changes along a sweep, for the axis of the picture. */
static double position(const sweep* s, int point) {
  for (int k = 0; k < 3; ++k)
    if (s->slope[k] != 0.0) return s->from[k] + s->slope[k] * point / POINTS;
  return 0.0;
}

static wrc_material steel(void) {
  wrc_material material = wrc_material_default();
  material.shear_modulus = shear_modulus;
  material.poisson = poisson;
  return material;
}

static wrc_exact_rolling_solution solve_exactly(const wrc_creepage* creepage) {
  static double pressure[GRID * GRID];
  wrc_grid grid = {.nx = GRID, .ny = GRID};
  grid.dx = 2.0 * ellipse.a / GRID;
  grid.dy = 2.0 * ellipse.b / GRID;
  grid.x0 = -ellipse.a + 0.5 * grid.dx;
  grid.y0 = ellipse.b * (ellipse.psi - 1.0) + 0.5 * grid.dy;
  const double peak = 1.5 * ellipse.normal_force / (pi * ellipse.a * ellipse.b);
  double load = 0.0;
  for (int j = 0; j < GRID; ++j) {
    for (int i = 0; i < GRID; ++i) {
      const double x = (grid.x0 + i * grid.dx) / ellipse.a, y = grid.y0 + j * grid.dy;
      const double s = y / (ellipse.b * (y > 0.0 ? 1.0 + ellipse.psi : 1.0 - ellipse.psi));
      pressure[j * GRID + i] = peak * sqrt(fmax(0.0, 1.0 - x * x - s * s));
      load += pressure[j * GRID + i] * grid.dx * grid.dy;
    }
  }
  for (int k = 0; k < GRID * GRID; ++k) pressure[k] *= ellipse.normal_force / load;

  wrc_exact_rolling_problem problem = wrc_exact_rolling_problem_default();
  wrc_exact_rolling_solution solution = {.struct_size = sizeof solution};
  problem.wheel_material = problem.rail_material = steel();
  problem.grid = grid;
  problem.pressure = pressure;
  problem.coefficient = mu;
  problem.creepage = *creepage;
  char text[256];
  if (wrc_exact_rolling(&problem, &solution, text, sizeof text) < 0) fail("exact solver", text);
  return solution;
}

static wrc_contact* make_contact(const variant* v, wrc_model** model) {
  wrc_config config = wrc_config_default();
  char text[512];
  if (wrc_config_use(&config, v->method, text, sizeof text) < 0) fail(v->name, text);
  config.wheel_material = config.rail_material = steel();
  config.tangential.bound = v->bound;
  config.tangential.flexibility = v->flexibility;
  wrc_contact* contact = NULL;
  if (wrc_model_create(&config, NULL, model, text, sizeof text) < 0 ||
      wrc_contact_create(*model, WRC_SIDE_RIGHT, NULL, &contact, text, sizeof text) < 0)
    fail(v->name, text);
  return contact;
}

static wrc_planar_forces roll(wrc_contact* contact, const wrc_creepage* creepage,
                              const wrc_friction* friction) {
  wrc_planar_forces forces;
  if (wrc_planar_tangential(contact, &ellipse, creepage, friction, &forces) < 0) {
    char text[256];
    wrc_contact_last_error(contact, text, sizeof text);
    fail("wrc_planar_tangential", text);
  }
  return forces;
}

static wrc_friction friction_of(double coefficient) {
  wrc_friction friction = wrc_friction_default();
  friction.coefficient = coefficient;
  return friction;
}

/* The curves of all methods; forces over friction times load, power over that times the creepage of
 * saturation. */
static void write_creep_curves(const char* directory) {
  FILE* csv = open_csv(directory, "creep_curves.csv");
  fprintf(csv, "sweep,variant,creepage,fx,fy,mz,power\n");
  const wrc_friction friction = friction_of(mu);
  const double limit = mu * ellipse.normal_force, arm = sqrt(ellipse.a * ellipse.b);
  static double exact_fx[SWEEPS][POINTS + 1], exact_fy[SWEEPS][POINTS + 1];
  for (int s = 0; s < SWEEPS; ++s) {
    for (int i = 0; i <= POINTS; i += EXACT_EVERY) {
      const wrc_creepage creepage = creepage_at(&sweeps[s], i);
      const wrc_exact_rolling_solution exact = solve_exactly(&creepage);
      exact_fx[s][i] = exact.fx / limit;
      exact_fy[s][i] = exact.fy / limit;
      fprintf(csv, "%s,exact,%.6g,%.6g,%.6g,%.6g,%.6g\n", sweeps[s].name, position(&sweeps[s], i),
              exact_fx[s][i], exact_fy[s][i], exact.mz / (limit * arm),
              exact.power_by_balance / (limit * unit[0]));
    }
  }
  printf(
      "\nCreep curves of a double ellipse a = 5.8 mm, b = 10.3 mm, psi = -0.3, 80 kN\n"
      "Largest deviation of (Fx, Fy) from exact theory, in %% of friction x load:\n%-26s",
      "");
  for (int s = 0; s < SWEEPS; ++s) printf(" %18s", sweeps[s].name);
  printf("\n");
  for (int v = 0; v < VARIANTS; ++v) {
    wrc_model* model = NULL;
    wrc_contact* contact = make_contact(&variants[v], &model);
    printf("%-26s", variants[v].name);
    for (int s = 0; s < SWEEPS; ++s) {
      double worst = 0.0;
      for (int i = 0; i <= POINTS; ++i) {
        const wrc_creepage creepage = creepage_at(&sweeps[s], i);
        const wrc_planar_forces f = roll(contact, &creepage, &friction);
        const double fx = f.fx / limit, fy = f.fy / limit;
        fprintf(csv, "%s,\"%s\",%.6g,%.6g,%.6g,%.6g,%.6g\n", sweeps[s].name, variants[v].name,
                position(&sweeps[s], i), fx, fy, f.mz / (limit * arm), f.power / (limit * unit[0]));
        if (i % EXACT_EVERY == 0) worst = fmax(worst, hypot(fx - exact_fx[s][i], fy - exact_fy[s][i]));
      }
      printf(" %18.2f", 100.0 * worst);
    }
    printf("\n");
    wrc_contact_destroy(contact);
    wrc_model_destroy(model);
  }
  fclose(csv);
}

/* One traction curve: longitudinal creepage, 20 m/s. */
static void write_law(FILE* csv, const char* name, const char* method, int32_t bound,
                      const wrc_friction* friction) {
  const variant v = {name, method, bound, WRC_FLEXIBILITY_SEPARATE};
  wrc_model* model = NULL;
  wrc_contact* contact = make_contact(&v, &model);
  for (int i = 0; i <= 120; ++i) {
    wrc_creepage creepage = wrc_creepage_default();
    creepage.longitudinal = 0.15 * (i / 120.0) * (i / 120.0); /* dense where the curve is steep */
    creepage.speed = 20.0;
    const wrc_planar_forces f = roll(contact, &creepage, friction);
    fprintf(csv, "\"%s\",%.6g,%.6g\n", name, creepage.longitudinal, -f.fx / f.fn);
  }
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
}

static void write_friction_laws(const char* directory) {
  FILE* csv = open_csv(directory, "friction_laws.csv");
  fprintf(csv, "law,creepage,adhesion\n");
  wrc_friction friction = friction_of(0.36);
  write_law(csv, "constant", "strip FASTSIM", WRC_BOUND_PARABOLIC, &friction);
  friction.speed_law = WRC_SPEED_LAW_EXPONENTIAL;
  friction.kinetic_ratio = 0.38;
  friction.fall_rate = 0.7;
  write_law(csv, "falling", "strip FASTSIM", WRC_BOUND_PARABOLIC, &friction);
  friction.slope_reduction = 0.54;
  write_law(csv, "falling, slope reduced to 0.54", "strip FASTSIM", WRC_BOUND_PARABOLIC, &friction);
  friction.slope_fall = 0.62;
  write_law(csv, "the same, modified FASTSIM", "modified FASTSIM", WRC_BOUND_ELLIPTIC, &friction);
  friction = friction_of(0.36);
  friction.speed_law = WRC_SPEED_LAW_HYPERBOLIC;
  friction.kinetic_ratio = 0.38;
  friction.half_speed = 0.3;
  write_law(csv, "static and kinetic", "strip FASTSIM", WRC_BOUND_PARABOLIC, &friction);
  /* Greased on the flange side of y = 0. */
  static const double zone_y[] = {0.0, 0.0}, zone_coefficient[] = {0.08, 0.36};
  friction = friction_of(0.36);
  friction.zone_count = 2;
  friction.zone_y = zone_y;
  friction.zone_coefficients = zone_coefficient;
  write_law(csv, "greased for y < 0", "strip FASTSIM", WRC_BOUND_PARABOLIC, &friction);
  fclose(csv);
}

int main(int argc, char** argv) {
  const char* directory = argc > 1 ? argv[1] : ".";
  ellipse.a = 5.8e-3;
  ellipse.b = 10.3e-3;
  ellipse.psi = -0.3;
  ellipse.normal_force = 80e3;
  wrc_coefficients c;
  if (wrc_linear_coefficients(ellipse.a / ellipse.b, ellipse.psi, poisson, &c) < 0)
    fail("coefficients", "refused");
  const double area = ellipse.a * ellipse.b, stiffness = shear_modulus * area;
  unit[0] = mu * ellipse.normal_force / (stiffness * c.c11s);
  unit[1] = mu * ellipse.normal_force / (stiffness * c.c22s);
  unit[2] = mu * ellipse.normal_force / (stiffness * sqrt(area) * c.c23s);
  write_creep_curves(directory);
  write_friction_laws(directory);
  return EXIT_SUCCESS;
}
