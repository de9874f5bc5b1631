/* each_call.c - the calls that the other examples do without, a line or two for each, in the order of the
 * headers.
 *
 *   each_call      prints what each came to; exit status 1 if one fails
 */
#include <stdio.h>
#include <stdlib.h>

#include "wrc/wrc_offline.h"
#include "wrc/wrc_profiles.h"
#include "wrc/wrc_surface.h"

static const wrc_contact* asked; /* whose sentence explains a failure */

static void done(const char* call, int32_t status) {
  char text[300] = "";
  if (status >= 0) return;
  if (asked) wrc_contact_last_error(asked, text, sizeof text);
  fprintf(stderr, "%s: %s: %s %s\n", call, wrc_status_name(status), wrc_status_text(status), text);
  exit(EXIT_FAILURE);
}
#define DO(call) done(#call, call)

static void* of_malloc[2]; /* where the memory below began */

static void* aligned(int which, uint64_t bytes, uint64_t alignment) {
  char* memory = of_malloc[which] = malloc((size_t)(bytes + alignment));
  if (!memory) exit(EXIT_FAILURE);
  return memory + (alignment - (uintptr_t)memory % alignment) % alignment;
}

static void stages(wrc_contact* contact) {
  wrc_planar_pose pose = {.lateral = 2e-3};
  wrc_planar_motion motion = {.speed = 20.0, .pitch_rate = -20.0 / 0.46 * 1.001};
  wrc_planar_load load = wrc_planar_load_default();
  wrc_friction friction = wrc_friction_default();
  wrc_planar_point point;
  wrc_creepage creepage;
  wrc_planar_normal_solution normal;
  wrc_planar_forces forces;
  wrc_planar_derivatives by = {.struct_size = sizeof by};
  wrc_region patch = {.struct_size = sizeof patch};
  load.normal_force = 80e3;
  DO(wrc_planar_geometry(contact, &pose, &point));
  DO(wrc_planar_creepages(contact, &motion, &creepage));
  DO(wrc_planar_normal(contact, NULL, &load, &normal)); /* NULL: the gap wrc_planar_geometry() found */
  DO(wrc_planar_tangential(contact, NULL, &creepage, &friction, &forces));
  DO(wrc_planar_tangential_derivatives(contact, &by));
  DO(wrc_contact_region(contact, 0, &patch));
  printf("stages: y %.2f mm, %.0f MPa, Fx %.0f N, dFx / d longitudinal %.3g N, patch 0 a %.2f mm\n",
         1e3 * point.y_rail, 1e-6 * normal.peak_pressure, forces.fx, by.forces[0][0], 1e3 * patch.ellipse.a);

  /* strips of one's own in place of the normal stage */
  const double y[3] = {-1e-3, 0.0, 1e-3}, width[3] = {1e-3, 1e-3, 1e-3}, half[3] = {4e-3, 5e-3, 4e-3};
  const double peak[3] = {0.8e9, 1e9, 0.8e9};
  wrc_planar_strips strips = {.count = 3, .y = y, .width = width, .half_length = half, .peak = peak};
  DO(wrc_planar_regularise(contact, &strips, &normal));
  printf("        strips of one's own: N %.0f N\n", normal.normal_force);
}

static void remembered(void) {
  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  config.planar.non_steady = 1; /* of the stages */
  config.surface.memory = 1;    /* of a wheel on a rail */
  wrc_model* model = NULL;
  wrc_contact* contact = NULL;
  wrc_planar_input input = wrc_planar_input_default();
  wrc_planar_output output = {.struct_size = sizeof output};
  input.load.normal_force = 80e3;
  input.creepage.longitudinal = 1e-3;
  DO(wrc_model_create(&config, NULL, &model, NULL, 0)); /* NULL: no sentence wanted */
  DO(wrc_contact_create(model, WRC_SIDE_RIGHT, NULL, &contact, NULL, 0));
  for (int step = 0; step < 3; ++step) {
    DO(wrc_planar_roll(contact, 1e-3)); /* a millimetre further each */
    DO(wrc_planar_step(contact, &input, &output));
  }
  printf("memory: Fx %.0f N after 3 mm", output.forces.fx);
  wrc_wheel_input wheel = wrc_wheel_input_default();
  wrc_wrench wrench = {.struct_size = sizeof wrench};
  wheel.wheel.z = 0.3e-3;
  wheel.time_step = 1e-3;
  for (int step = 0; step < 3; ++step) {
    wheel.wheel.velocity[0] = step == 0 ? 0.0 : 1e-3; /* slides, and does not turn */
    DO(wrc_contact_wrench(contact, &wheel, &wrench)); /* a trial */
    DO(wrc_contact_commit(contact));                  /* accepted: later calls begin with its tractions */
  }
  printf("; of a wheel %.0f N after 2 um\n", wrench.force[0]);
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
}

static void states(const wrc_model* model, wrc_contact* contact) {
  uint64_t bytes, portable_bytes;
  DO(wrc_contact_state_size(model, &bytes));
  DO(wrc_contact_portable_size(model, &portable_bytes));
  void *state = malloc((size_t)bytes), *portable = malloc((size_t)portable_bytes);
  if (!state || !portable) exit(EXIT_FAILURE);
  DO(wrc_contact_save(contact, state, bytes)); /* for this process */
  DO(wrc_contact_restore(contact, state, bytes));
  DO(wrc_contact_save_portable(contact, portable, portable_bytes)); /* for a file */
  DO(wrc_contact_restore_portable(contact, portable, portable_bytes));
  printf("states: portable are %d bytes longer\n", (int)(portable_bytes - bytes));
  free(state);
  free(portable);
}

static void wheel_on_rail(wrc_contact* contact) {
  wrc_wheel_input input = wrc_wheel_input_default();
  wrc_wrench wrench = {.struct_size = sizeof wrench};
  wrc_region region = {.struct_size = sizeof region};
  static wrc_wrench_derivatives by = {.struct_size = sizeof by};
  static double peak[512];
  uint64_t counts[2];
  input.wheel.z = 0.3e-3;
  input.wheel.velocity[0] = 20.0;
  input.wheel.pitch_rate = -20.0 / 0.46;
  DO(wrc_contact_wrench_derivatives(contact, &input, &wrench, &by));
  DO(wrc_contact_mark(contact)); /* accepted: calls with WRC_START_MARK start from it */
  DO(wrc_contact_region(contact, 0, &region));
  DO(wrc_contact_field(contact, 0, WRC_FIELD_STRIP_PEAK, peak, 512, counts));
  printf("wheel:  Fz %.0f N, dFz/dz %.3g N/m, area %.0f mm^2, b %.1f mm, first of %d strips %.0f MPa\n",
         wrench.force[2], by.wrench[2][WRC_BY_Z], 1e6 * region.area, 1e3 * region.ellipse.b, (int)counts[1],
         1e-6 * peak[0]);

  /* what the region does to the bodies */
  wrc_damage damage;
  wrc_wear wear;
  wrc_temperature temperature = {.struct_size = sizeof temperature};
  wrc_stresses stresses = {.struct_size = sizeof stresses};
  wrc_stress_peaks levels[2];
  const double depths[2] = {1e-3, 3e-3};
  DO(wrc_contact_damage(contact, 0, &damage));
  DO(wrc_contact_wear(contact, 0, NULL, &wear)); /* NULL: the published laws */
  DO(wrc_contact_temperature(contact, 0, NULL, &temperature));
  DO(wrc_contact_stresses(contact, 0, WRC_BODY_RAIL, depths, 2, levels, &stresses));
  printf("        T-gamma %.1f N, worn %.3g mm^2/km, %.0f K warmer\n", damage.t_gamma,
         1e9 * wear.worn_area_rate, temperature.rise);
  printf("        von Mises %.0f MPa at most, %.0f MPa 3 mm below\n",
         1e-6 * stresses.largest.von_mises.stress, 1e-6 * levels[1].von_mises.stress);

  const double force = wrench.force[2];
  DO(wrc_contact_wrench_batch(&contact, 1, &input, 0, &wrench, sizeof wrench, NULL));
  wrc_exact_wrench_options options = wrc_exact_wrench_options_default();
  options.cell_x = options.cell_s = 8e-4; /* coarse: quick */
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 80e3;
  input.wheel.z = 0.0;
  wrc_wrench exact = {.struct_size = sizeof exact};
  DO(wrc_exact_wrench(contact, &input, &options, &exact));
  printf("        batch alike: %s; exactly, 80 kN lie %.3f mm deep\n",
         wrench.force[2] == force ? "yes" : "no", 1e3 * exact.z);
}

/* What wear and fatigue add up to along the line, bin by bin over a profile's arc length. After
 * wheel_on_rail(). */
static void line(const wrc_model* model, wrc_contact* contact) {
  enum { bins = 80 };
  static wrc_damage_bin of_wheel[bins + 1], of_train[bins + 1];
  static double values[bins + 1];
  wrc_damage_bins wheel = wrc_damage_bins_default();
  wheel.count = bins;
  wheel.first = -0.04;
  wheel.bins = of_wheel;
  wheel.bin_size = sizeof of_wheel[0];
  wrc_damage_bins train = wheel;
  train.bins = of_train;
  wrc_accumulation what = {.struct_size = sizeof what, .duration = 0.01};
  wrc_damage_totals totals;
  DO(wrc_contact_accumulate(contact, &what, &wheel, NULL, &totals));
  DO(wrc_damage_merge(&train, &wheel)); /* another wheel's, another machine's */
  DO(wrc_damage_values(&train, WRC_DAMAGE_WORK, values));
  int most = 0;
  for (int i = 0; i < bins; ++i)
    if (values[i] > values[most]) most = i;
  const double arc = wheel.first + (most + 0.5) * wheel.width;
  double y, z, crack, limit;
  DO(wrc_model_arc_places(model, WRC_BODY_WHEEL, 1, &arc, &y, &z));
  DO(wrc_whole_life_damage(NULL, 100.0, &crack)); /* NULL: the published parameters */
  DO(wrc_shakedown_limit_point(0.1, &limit));
  printf("line:   most at y %.1f mm; %.3g cracks a passage at 100 N; shakedown of a point at %.2f k\n",
         1e3 * y, crack, limit);
}

static void exact_bodies(void) {
  enum { n = 12 };
  static double pressure[n * n], traction[n * n];
  wrc_exact_rolling_problem problem = wrc_exact_rolling_problem_default();
  wrc_exact_rolling_solution solution = {.struct_size = sizeof solution};
  problem.grid.nx = problem.grid.ny = n;
  problem.grid.dx = problem.grid.dy = 1e-3;
  problem.grid.x0 = problem.grid.y0 = -0.5e-3 * (n - 1);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const double x = (i - 5.5) / 5.0, y = (j - 5.5) / 5.0, inside = 1.0 - x * x - y * y;
      pressure[j * n + i] = inside > 0.0 ? 1e9 * inside : 0.0;
    }
  problem.pressure = pressure;
  problem.creepage.longitudinal = 1e-3;
  solution.traction_x = traction;
  char text[300];
  wrc_exact_transient* bodies = NULL;
  DO(wrc_exact_transient_create(&problem.grid, &problem.wheel_material, &problem.rail_material, &bodies, text,
                                sizeof text));
  for (int step = 0; step < 3; ++step)
    DO(wrc_exact_transient_step(bodies, &problem, &solution, text, sizeof text)); /* a cell further each */
  wrc_exact_transient_destroy(bodies);
  wrc_exact_loads loads = wrc_exact_loads_default();
  wrc_stresses stresses = {.struct_size = sizeof stresses};
  const double point[3] = {0.0, 0.0, 3e-3};
  double stress[6];
  loads.grid = problem.grid;
  loads.pressure = pressure;
  loads.traction_x = traction;
  DO(wrc_exact_stress(&loads, point, 1, stress, text, sizeof text));
  DO(wrc_exact_largest_stresses(&loads, NULL, 0, NULL, &stresses, NULL, NULL, text, sizeof text));
  printf("exact:  Fx %.0f N after 3 mm, zz %.0f MPa 3 mm below, von Mises %.0f MPa at most\n", solution.fx,
         1e-6 * stress[2], 1e-6 * stresses.largest.von_mises.stress);
  const double power[4] = {5e8, 5e8, 5e8, 5e8}; /* W/m^2 along a strip */
  double rise[4];
  DO(wrc_flash_temperature(4, 1e-3, power, 20.0, NULL, NULL, rise)); /* NULL: steel */
  printf("        %.0f K at the end of a strip\n", rise[3]);
}

/* Rain on a stretch by one thread, leaves by another, put together. */
static void films(void) {
  static wrc_surface_bin wet[20], leaves[20];
  wrc_surface rain = wrc_surface_default();
  rain.count = 20;
  rain.length = 1.0;
  rain.bins = wet;
  rain.bin_size = sizeof wet[0];
  wrc_surface rail = rain;
  rail.bins = leaves;
  double water;
  DO(wrc_surface_add(&rain, WRC_SURFACE_WATER, 0.02, 0.0, 20.0, NULL, 0));
  DO(wrc_surface_add(&rail, WRC_SURFACE_FILM, 0.01, 5.0, 15.0, NULL, 0));
  DO(wrc_surface_merge(&rail, &rain, NULL, 0));
  DO(wrc_surface_values(&rail, WRC_SURFACE_WATER, WRC_SURFACE_AMOUNT, NULL, &water, NULL, 0));
  printf("films:  %.0f g of water on a band of 20 m\n", 1e3 * water);
}

/* Measured sections of a rail, written to a file, read again, parted into faces. */
static void sections(void) {
  enum { count = 3, points = 40 };
  static double y[count][points], z[count][points];
  wrc_section_line measured[count] = {{0}}, read;
  for (int k = 0; k < count; ++k) {
    for (int i = 0; i < points; ++i) {
      y[k][i] = 1.8e-3 * (i - points / 2);
      z[k][i] = 2.0 * y[k][i] * y[k][i] + 1e-4 * k;
    }
    measured[k] = (wrc_section_line){.distance = 0.5 * k, .count = points, .y = y[k], .z = z[k]};
  }
  const char* path = "each_call_sections.txt";
  wrc_section_file* file;
  DO(wrc_section_file_write(path, measured, count, NULL, 0));
  DO(wrc_section_file_read(path, 1.0, 0, 0, &file, NULL, 0)); /* 1.0: metres */
  remove(path);
  DO(wrc_section_file_line(file, 1, &read));
  wrc_rail_faces_problem problem = wrc_rail_faces_problem_default();
  problem.section_count = count;
  problem.sections = measured;
  wrc_rail_faces* faces;
  wrc_face_outline outline = {.struct_size = sizeof outline};
  DO(wrc_rail_faces_create(&problem, &faces, NULL, 0));
  DO(wrc_rail_faces_outline(faces, 1, &outline));
  printf("rails:  %u points at %.1f m; the face there has %u points from y %.1f mm\n", read.count,
         read.distance, outline.count, 1e3 * outline.y[0]);
  wrc_rail_faces_destroy(faces);
  wrc_section_file_destroy(file);
}

int main(void) {
  if (wrc_abi_version() != WRC_ABI_VERSION || wrc_version() >> 16 != WRC_VERSION_MAJOR ||
      wrc_get_experimental_api(WRC_EXPERIMENTAL_VERSION) == NULL) {
    fprintf(stderr, "another interface: %s\n", wrc_build_info());
    return EXIT_FAILURE;
  }
  /* In memory of one's own: there is nothing to destroy, and the memory goes last. */
  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  uint64_t bytes, alignment;
  wrc_model* model = NULL;
  wrc_contact* contact = NULL;
  char why[300];
  DO(wrc_config_check(&config, why, sizeof why)); /* what a dialog asks before there is a model */
  DO(wrc_model_size(&config, &bytes, &alignment));
  DO(wrc_model_init(&config, aligned(0, bytes, alignment), bytes, &model, NULL, 0));
  DO(wrc_contact_size(model, &bytes, &alignment));
  DO(wrc_contact_init(model, WRC_SIDE_RIGHT, aligned(1, bytes, alignment), bytes, &contact, NULL, 0));
  asked = contact;
  wrc_view y, z;
  DO(wrc_model_profile(model, WRC_SIDE_RIGHT, WRC_BODY_RAIL, &y, &z, NULL));
  printf("rail:   from %.1f to %.1f mm of the track's middle\n", 1e3 * y.data[0], 1e3 * y.data[y.count - 1]);
  stages(contact);
  remembered();
  states(model, contact);
  wheel_on_rail(contact);
  line(model, contact);
  exact_bodies();
  for (int i = 0; i < 2; ++i) free(of_malloc[i]);
  films();
  sections();
  return EXIT_SUCCESS;
}
