/* A host that uses every struct and every function of the interface. caller_x86_64.s is what became of it
 * when it was compiled against the baseline's headers, with the sizes and places of then; tests/growth
 * compiles it against headers that have grown. Prints the digits of what the library gives it. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "wrc/wrc_api.h"
#include "wrc/wrc_experimental_api.h"

/* ------------------------------------------------------------------------------------------------- what is
 * printed */

static char text[400];
static wrc_contact* spoken; /* the contact of the last call, for its sentence */

static void show(const char* name, const double* values, long count) {
  printf("%s", name);
  for (long i = 0; i < count; ++i) printf(" %.17g", values[i]);
  printf("\n");
}

/* The numbers of a struct from one member to another. */
#define SHOW(shown, first, last) show(#shown "." #first, &(shown).first, &(shown).last - &(shown).first + 1)
#define SHOW_ONE(number) show(#number, &(number), 1)
#define SHOW_ALL(array) show(#array, (array), (long)(sizeof(array) / sizeof(array)[0]))

/* The status of a call; a failure ends the program. */
static void done(int32_t status, const char* call) {
  printf("%.*s %d\n", (int)strcspn(call, "("), call, (int)status);
  if (status >= 0) return;
  if (text[0] == '\0' && spoken != NULL) wrc_contact_last_error(spoken, text, sizeof text);
  fprintf(stderr, "%s: %s: %s\n", call, wrc_status_name(status), text);
  exit(1);
}
#define DO(call) done(call, #call)
/* A call on a contact. */
#define OF(contact, call) (text[0] = '\0', spoken = (contact), done(call, #call))

/* Memory that is counted: what was taken must have been given back. */
static int blocks;
static void* take(void* user, uint64_t bytes, uint64_t alignment) {
  char* const raw = malloc((size_t)(bytes + alignment) + sizeof raw);
  if (raw == NULL) return NULL;
  char* place = raw + sizeof raw;
  place += (alignment - (uintptr_t)place % alignment) % alignment;
  memcpy(place - sizeof raw, &raw, sizeof raw);
  ++*(int*)user;
  return place;
}
static void release(void* user, void* memory) {
  char* raw;
  memcpy(&raw, (char*)memory - sizeof raw, sizeof raw);
  free(raw);
  --*(int*)user;
}
static wrc_allocator counted(void) {
  wrc_allocator allocator;
  memset(&allocator, 0, sizeof allocator);
  allocator.user = &blocks;
  allocator.allocate = take;
  allocator.release = release;
  return allocator;
}

static int32_t hear(double fraction, void* user) {
  ++*(int*)user;
  return fraction > 2.0;
}

/* --------------------------------------------------------------------------------------------------- the
 * library */

static void about(void) {
  const wrc_api* const api = wrc_get_api(WRC_ABI_VERSION);
  if (api == NULL || !WRC_API_HAS(api, planar_tangential_derivatives)) exit(2);
  if (wrc_get_api(1) != NULL || api->version() != wrc_version() || wrc_abi_version() != WRC_ABI_VERSION)
    exit(2);
  printf("%s; %s\n", wrc_status_name(WRC_ERROR_RANGE), wrc_status_text(WRC_FLAG_NO_CONTACT));
  printf("%d %d\n", wrc_version_text(WRC_ABI_VERSION)[0] != '\0', wrc_build_info()[0] != '\0');
}

static wrc_config standard(void) {
  wrc_config config = wrc_config_default();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_60E1;
  config.track.rail_inclination = 1.0 / 40.0;
  wrc_material material = wrc_material_default();
  material.shear_modulus = 80e9;
  config.wheel_material = config.rail_material = material;
  wrc_heat_properties heat = config.wheel_heat;
  heat.conductivity = 45.0;
  config.rail_heat = heat;
  wrc_config_wheelset wheelset = config.wheelset;
  wheelset.wheel_radius = 0.45;
  config.wheelset = wheelset;
  wrc_config_track track = config.track;
  track.gauge = 1.434;
  config.track = track;
  wrc_config_normal normal = config.normal;
  wrc_config_tangential tangential = config.tangential;
  wrc_config_surface surface = config.surface;
  surface.cells = 24;
  config.normal = normal;
  config.tangential = tangential;
  config.surface = surface;
  return config;
}

static wrc_model* model_of(const wrc_config* config) {
  const wrc_allocator allocator = counted();
  wrc_model* model = NULL;
  DO(wrc_config_check(config, text, sizeof text));
  DO(wrc_model_create(config, &allocator, &model, text, sizeof text));
  return model;
}

static wrc_contact* contact_of(const wrc_model* model, int32_t side) {
  const wrc_allocator allocator = counted();
  wrc_contact* contact = NULL;
  DO(wrc_contact_create(model, side, &allocator, &contact, text, sizeof text));
  return contact;
}

/* The same model and contact in memory of this program. */
static void in_own_memory(const wrc_config* config, const wrc_wheel_input* input) {
  uint64_t bytes, alignment;
  int mine = 0;
  wrc_model* model = NULL;
  wrc_contact* contact = NULL;
  DO(wrc_model_size(config, &bytes, &alignment));
  void* const for_model = take(&mine, bytes, alignment);
  DO(wrc_model_init(config, for_model, bytes, &model, text, sizeof text));
  DO(wrc_contact_size(model, &bytes, &alignment));
  void* const for_contact = take(&mine, bytes, alignment);
  DO(wrc_contact_init(model, WRC_SIDE_RIGHT, for_contact, bytes, &contact, text, sizeof text));
  wrc_wrench wrench = {sizeof wrench};
  OF(contact, wrc_contact_wrench(contact, input, &wrench));
  SHOW(wrench, force[0], steepest_angle);
  release(&mine, for_contact);
  release(&mine, for_model);
}

/* ------------------------------------------------------------------------------------------------ wheel on a
 * rail */

static const double speed = 20.0;

static wrc_wheel_input rolling(void) {
  wrc_wheel_input input = wrc_wheel_input_default();
  wrc_wheel_state wheel = input.wheel;
  wheel.velocity[0] = speed;
  wheel.pitch_rate = -speed / 0.45;
  wheel.yaw = 1e-3;
  input.wheel = wheel;
  wrc_rail_state rail = input.rail;
  rail.y = 0.1e-3;
  rail.z_velocity = 1e-3;
  input.rail = rail;
  wrc_frame_motion frame = input.frame;
  frame.speed = 0.1;
  frame.curvature = 1.0 / 600.0;
  input.frame = frame;
  wrc_friction friction = wrc_friction_default();
  friction.coefficient = 0.35;
  input.friction = friction;
  return input;
}

static void show_regions(wrc_contact* contact, const wrc_wrench* wrench) {
  static double values[200 * 64];
  for (int32_t i = 0; i < wrench->region_count; ++i) {
    wrc_region region = {sizeof region};
    OF(contact, wrc_contact_region(contact, i, &region));
    printf("strips %d cells %d surface %d available %u\n", (int)region.strip_count, (int)region.cell_count,
           (int)region.surface, (unsigned)region.available);
    SHOW(region, point[0], spin_moment);
    SHOW(region, creepage.longitudinal, creepage.reverse_share);
    SHOW(region, ellipse.a, ellipse.normal_force);
    SHOW(region, area, adhesion_fraction);
    for (int32_t field = WRC_FIELD_X; field <= WRC_FIELD_STRIP_ANGLE; ++field) {
      uint64_t counts[2];
      double sum = 0.0;
      OF(contact, wrc_contact_field(contact, i, field, values, sizeof values / sizeof values[0], counts));
      for (uint64_t k = 0; k < counts[0] * counts[1]; ++k) sum += values[k];
      SHOW_ONE(sum);
    }
    wrc_damage damage;
    OF(contact, wrc_contact_damage(contact, i, &damage));
    SHOW(damage, power, local_fatigue_index);
  }
}

/* Tread and flange, a given load, derivatives, zones and laws of friction. */
static void on_the_rail(wrc_contact* contact) {
  wrc_wheel_input input = rolling();
  wrc_wrench wrench = {sizeof wrench};
  wrc_wrench_derivatives derivatives = {sizeof derivatives};
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 80e3;
  OF(contact, wrc_contact_wrench(contact, &input, &wrench));
  SHOW(wrench, force[0], steepest_angle);
  show_regions(contact, &wrench);
  input.wheel.y = -7e-3; /* the right wheel's flange */
  OF(contact, wrc_contact_wrench_derivatives(contact, &input, &wrench, &derivatives));
  SHOW(wrench, force[0], steepest_angle);
  SHOW(derivatives, wrench[0][0], z[31]);
  show_regions(contact, &wrench);

  const double zone_y[2] = {-0.01, 0.01}, zone_coefficients[2] = {0.1, 0.4};
  input.friction.zone_count = 2;
  input.friction.zone_y = zone_y;
  input.friction.zone_coefficients = zone_coefficients;
  input.friction.zone_frame = WRC_ZONES_RAIL_PROFILE;
  input.friction.speed_law = WRC_SPEED_LAW_HYPERBOLIC;
  OF(contact, wrc_contact_wrench(contact, &input, &wrench));
  SHOW(wrench, force[0], steepest_angle);
  input.friction.temperature_law = WRC_TEMPERATURE_LAW_LINEAR;
  wrc_bulk_temperatures bulk = input.friction.bulk;
  bulk.rail = 35.0;
  input.friction.bulk = bulk;
  OF(contact, wrc_contact_wrench(contact, &input, &wrench));
  SHOW(wrench, force[0], steepest_angle);
}

/* Contacts side by side, warm starts, states that are put back. */
static void repeated(wrc_contact* const contacts[2]) {
  wrc_wheel_input inputs[2];
  wrc_wrench wrenches[2];
  int32_t statuses[2];
  memset(wrenches, 0, sizeof wrenches);
  for (int i = 0; i < 2; ++i) {
    inputs[i] = rolling();
    inputs[i].wheel.z = 0.3e-3;
    inputs[i].wheel.y = 1e-3 * i;
    inputs[i].start = WRC_START_WARM;
    wrenches[i].struct_size = sizeof wrenches[i];
  }
  OF(contacts[0],
     wrc_contact_wrench_batch(contacts, 2, inputs, sizeof inputs[0], wrenches, sizeof wrenches[0], statuses));
  for (int i = 0; i < 2; ++i) SHOW(wrenches[i], force[0], steepest_angle);
  OF(contacts[1], wrc_contact_mark(contacts[1]));
  inputs[1].start = WRC_START_MARK;
  OF(contacts[1], wrc_contact_wrench(contacts[1], &inputs[1], &wrenches[1]));
  SHOW(wrenches[1], force[0], work);

  uint64_t bytes, portable_bytes;
  const wrc_config config = standard();
  wrc_model* const model = model_of(&config);
  DO(wrc_contact_state_size(model, &bytes));
  DO(wrc_contact_portable_size(model, &portable_bytes));
  wrc_model_destroy(model);
  void* const state = malloc((size_t)bytes);
  void* const portable = malloc((size_t)portable_bytes);
  OF(contacts[0], wrc_contact_save(contacts[0], state, bytes));
  OF(contacts[0], wrc_contact_save_portable(contacts[0], portable, portable_bytes));
  for (int i = 0; i < 3; ++i) {
    inputs[0].wheel.z = 0.35e-3;
    OF(contacts[0], wrc_contact_wrench(contacts[0], &inputs[0], &wrenches[0]));
    SHOW(wrenches[0], force[0], steepest_angle);
    if (i == 0) OF(contacts[0], wrc_contact_restore(contacts[0], state, bytes));
    if (i == 1) OF(contacts[0], wrc_contact_restore_portable(contacts[0], portable, portable_bytes));
  }
  free(portable);
  free(state);
}

/* Steps that are committed. */
static void remembering(void) {
  wrc_config config = standard();
  config.surface.memory = 1;
  wrc_model* const model = model_of(&config);
  wrc_contact* const contact = contact_of(model, WRC_SIDE_RIGHT);
  wrc_wheel_input input = rolling();
  input.wheel.z = 0.3e-3;
  wrc_wrench wrench = {sizeof wrench};
  for (int i = 0; i < 2; ++i) {
    OF(contact, wrc_contact_wrench(contact, &input, &wrench));
    SHOW(wrench, force[0], steepest_angle);
    OF(contact, wrc_contact_commit(contact));
    input.time_step = 1e-4;
  }
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
}

static void wheel_on_a_rail(void) {
  const wrc_config config = standard();
  wrc_model* const model = model_of(&config);
  wrc_contact* const contacts[2] = {contact_of(model, WRC_SIDE_RIGHT), contact_of(model, WRC_SIDE_LEFT)};
  wrc_view y, z;
  double deviation;
  DO(wrc_model_profile(model, WRC_SIDE_LEFT, WRC_BODY_RAIL, &y, &z, &deviation));
  SHOW_ONE(z.data[y.count / 4]);
  for (int i = 0; i < 2; ++i) on_the_rail(contacts[i]);
  repeated(contacts);
  wrc_wheel_input input = rolling();
  input.wheel.z = 0.3e-3;
  in_own_memory(&config, &input);

  /* through the table, and refused */
  const wrc_api* const api = wrc_get_api(WRC_ABI_VERSION);
  wrc_wrench wrench = {sizeof wrench};
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 80.0;
  if (api->contact_wrench(contacts[0], &input, &wrench) != WRC_ERROR_RANGE) exit(3);
  DO(wrc_contact_last_error(contacts[0], text, sizeof text));
  printf("%s\n", text);
  for (int i = 0; i < 2; ++i) wrc_contact_destroy(contacts[i]);
  wrc_model_destroy(model);
}

/* One wrench of a model. */
static void wrench_of(const wrc_config* config, const wrc_wheel_input* input) {
  wrc_model* const model = model_of(config);
  wrc_contact* const contact = contact_of(model, WRC_SIDE_RIGHT);
  wrc_wrench wrench = {sizeof wrench};
  OF(contact, wrc_contact_wrench(contact, input, &wrench));
  SHOW(wrench, force[0], steepest_angle);
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
}

/* Rails that change along the track, wheels that are not round, check rails, rollers. */
static void other_rails(void) {
  wrc_config config = standard();
  wrc_wheel_input input = rolling();
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 70e3;
  const double marks[2] = {-0.02, 0.02};
  wrc_rail_section sections[3];
  memset(sections, 0, sizeof sections);
  for (int k = 0; k < 3; ++k) {
    sections[k].distance = 2.0 * k;
    sections[k].z = 1e-3 * k;
    sections[k].mark_count = 2;
    sections[k].marks = marks;
    sections[k].profile.kind = WRC_PROFILE_60E1;
  }
  config.rail_section_count = 3;
  config.rail_section_size = sizeof sections[0];
  config.rail_sections = sections;
  double angles[33], deviations[33];
  for (int i = 0; i <= 32; ++i) {
    angles[i] = 6.283185307179586 * i / 32;
    deviations[i] = 1e-5 * (i % 32 - 16) * (i % 32 - 16) / 256.0;
  }
  wrc_config_roundness roundness = config.roundness;
  roundness.angle_count = 33;
  roundness.row_count = 1;
  roundness.angles = angles;
  roundness.deviations = deviations;
  config.roundness = roundness;
  input.distance = 1.7;
  input.angle = 0.4;
  wrench_of(&config, &input);
  in_own_memory(&config, &input);

  config = standard();
  input.distance = input.angle = 0.0;
  double y[356], z[356], height = 0.0;
  for (int i = 0; i < 356; ++i) { /* a far side that falls off, a flat top, a corner, a steep guiding face */
    y[i] = -30e-3 + 0.1e-3 * i;
    z[i] = height;
    const double at = y[i] + 0.05e-3;
    height += 0.1e-3 * (at < -25e-3   ? -1.0
                        : at < -20e-3 ? (at + 20e-3) / 5e-3
                        : at < 0.0    ? 0.0
                        : at < 1e-3   ? 9500.0 * at
                                      : 9.5);
  }
  const double top = z[200];
  for (int i = 0; i < 356; ++i) z[i] -= top;
  wrc_profile outline = config.check_rail.profile;
  outline.kind = WRC_PROFILE_POINTS;
  outline.count = 356;
  outline.y = y;
  outline.z = z;
  wrc_config_check_rail check_rail = config.check_rail;
  check_rail.y = -0.0813;
  check_rail.z = -0.020;
  check_rail.profile = outline;
  config.check_rail = check_rail;
  wrench_of(&config, &input);

  config = standard();
  config.roller_curvature = 1.0;
  input = rolling();
  input.wheel.velocity[0] = 0.0;
  input.wheel.z = 0.2e-3;
  input.roller_rate = 20.0;
  wrench_of(&config, &input);
}

/* ---------------------------------------------------------------------------------------------- contact on a
 * plane */

static void show_solution(const wrc_planar_normal_solution* solution) {
  printf("patches %d strips %d iterations %d\n", (int)solution->patch_count, (int)solution->strip_count,
         (int)solution->iterations);
  SHOW(solution->ellipse, a, normal_force);
  SHOW(*solution, normal_force, y_max);
}

static void show_forces(wrc_contact* contact) {
  wrc_planar_derivatives derivatives = {sizeof derivatives};
  OF(contact, wrc_planar_tangential_derivatives(contact, &derivatives));
  SHOW(derivatives, forces[0][0], forces[2][7]);
}

/* Stages from a pose. */
static void posed(void) {
  wrc_config config = standard();
  wrc_config_planar planar = config.planar;
  planar.strips = 40;
  config.planar = planar;
  DO(wrc_config_use(&config, "FASTSIM-SDEC", text, sizeof text));
  wrc_model* const model = model_of(&config);
  wrc_contact* const contact = contact_of(model, WRC_SIDE_LEFT);
  wrc_planar_pose pose;
  memset(&pose, 0, sizeof pose);
  pose.lateral = 2e-3;
  wrc_planar_point point;
  OF(contact, wrc_planar_geometry(contact, &pose, &point));
  SHOW(point, x, rolling_radius);
  wrc_planar_motion motion;
  memset(&motion, 0, sizeof motion);
  motion.speed = speed;
  motion.pitch_rate = -speed / 0.45;
  motion.lateral_velocity = 0.01;
  wrc_creepage creepage;
  OF(contact, wrc_planar_creepages(contact, &motion, &creepage));
  SHOW(creepage, longitudinal, reverse_share);
  wrc_planar_load load = wrc_planar_load_default();
  load.normal_force = 80e3;
  wrc_planar_normal_solution solution;
  OF(contact, wrc_planar_normal(contact, NULL, &load, &solution));
  show_solution(&solution);
  OF(contact, wrc_planar_regularise(contact, NULL, &solution));
  show_solution(&solution);
  const wrc_friction friction = wrc_friction_default();
  wrc_planar_forces forces;
  OF(contact, wrc_planar_tangential(contact, NULL, &creepage, &friction, &forces));
  SHOW(forces, fx, adhesion_fraction);
  show_forces(contact);

  wrc_planar_input input = wrc_planar_input_default();
  wrc_planar_output output = {sizeof output};
  input.pose = pose;
  input.load = load;
  input.creepage = creepage;
  input.friction = friction;
  OF(contact, wrc_planar_step(contact, &input, &output));
  SHOW(output.point, x, rolling_radius);
  show_solution(&output.normal);
  SHOW(output.forces, fx, adhesion_fraction);
  SHOW(output.damage, power, local_fatigue_index);
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
}

/* Gaps, strips and ellipses of the caller, and rolling that is not steady. */
static void given(void) {
  enum { rows = 41 };
  wrc_config config = wrc_config_default();
  config.planar.non_steady = 1;
  wrc_model* const model = model_of(&config);
  wrc_contact* const contact = contact_of(model, WRC_SIDE_RIGHT);
  double y[rows], height[rows], curvature[rows], half_length[rows], width[rows], peak[rows];
  for (int j = 0; j < rows; ++j) {
    y[j] = 1e-3 * (j - rows / 2);
    height[j] = 2.0 * y[j] * y[j];
    curvature[j] = 2.2;
    half_length[j] = 5e-3 - 10.0 * y[j] * y[j];
    width[j] = 1e-3;
    peak[j] = 2e11 * half_length[j];
  }
  wrc_planar_gap gap;
  memset(&gap, 0, sizeof gap);
  gap.row_count = rows;
  gap.y = y;
  gap.height = height;
  gap.curvature = curvature;
  wrc_planar_input input = wrc_planar_input_default();
  wrc_planar_output output = {sizeof output};
  input.gap = &gap;
  input.load.prescribed = WRC_PRESCRIBE_APPROACH;
  input.load.approach = 60e-6;
  wrc_creepage creepage = wrc_creepage_default();
  creepage.lateral = 0.5e-3;
  input.creepage = creepage;
  OF(contact, wrc_planar_roll(contact, 2e-3));
  OF(contact, wrc_planar_step(contact, &input, &output));
  show_solution(&output.normal);
  SHOW(output.forces, fx, adhesion_fraction);
  wrc_planar_normal_solution solution;
  OF(contact, wrc_planar_normal(contact, &gap, &input.load, &solution));
  show_solution(&solution);

  wrc_planar_strips strips;
  memset(&strips, 0, sizeof strips);
  strips.count = 21;
  strips.y = y + 10;
  strips.width = width + 10;
  strips.half_length = half_length + 10;
  strips.peak = peak + 10;
  OF(contact, wrc_planar_regularise(contact, &strips, &solution));
  show_solution(&solution);
  wrc_ellipse ellipse;
  memset(&ellipse, 0, sizeof ellipse);
  ellipse.a = 5e-3;
  ellipse.b = 3e-3;
  ellipse.psi = 0.2;
  ellipse.normal_force = 60e3;
  wrc_planar_forces forces;
  OF(contact, wrc_planar_roll(contact, 1.0));
  OF(contact, wrc_planar_tangential(contact, &ellipse, &creepage, &input.friction, &forces));
  SHOW(forces, fx, adhesion_fraction);
  wrc_damage damage;
  OF(contact, wrc_contact_damage(contact, WRC_ALL_REGIONS, &damage));
  SHOW(damage, power, local_fatigue_index);
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
}

/* ---------------------------------------------------------------------------------------------------------
 * damage */

static void show_peaks(const wrc_stress_peaks* peaks) {
  const wrc_stress_peak* const each[3] = {&peaks->von_mises, &peaks->shear, &peaks->tension};
  for (int i = 0; i < 3; ++i) SHOW(*each[i], stress, depth);
}

static void show_stresses(const wrc_stresses* stresses) {
  show_peaks(&stresses->largest);
  show_peaks(&stresses->surface);
  show_peaks(&stresses->below);
}

/* What one region does to the bodies. */
static void damage_of(wrc_contact* contact) {
  wrc_wear_laws laws = wrc_wear_laws_default();
  laws.hardness = 2.8e9;
  wrc_wear wear;
  OF(contact, wrc_contact_wear(contact, 0, &laws, &wear));
  SHOW(wear, worn_area_rate, largest_power_depth_velocity);
  wrc_bulk_temperatures bulk = wrc_bulk_temperatures_default();
  bulk.wheel = 60.0;
  wrc_temperature temperature = {sizeof temperature};
  OF(contact, wrc_contact_temperature(contact, 0, &bulk, &temperature));
  SHOW(temperature, at_entry, rail_heat);
  const double depths[3] = {1e-3, 2e-3, 4e-3};
  wrc_stress_peaks levels[3];
  wrc_stresses stresses = {sizeof stresses};
  OF(contact, wrc_contact_stresses(contact, 0, WRC_BODY_RAIL, depths, 3, levels, &stresses));
  for (int i = 0; i < 3; ++i) show_peaks(&levels[i]);
  show_stresses(&stresses);
}

/* Bins of a wheel and a rail, filled and put together. */
static void collected(wrc_contact* contact) {
  enum { count = 40 };
  static wrc_damage_bin bin[3][count + 1];
  wrc_damage_bins bins[3];
  wrc_fatigue_laws fatigue = wrc_fatigue_laws_default();
  const wrc_wear_laws wear = wrc_wear_laws_default();
  fatigue.whole_life_start = 14.0;
  memset(bin, 0, sizeof bin);
  for (int i = 0; i < 3; ++i) {
    bins[i] = wrc_damage_bins_default();
    bins[i].count = count;
    bins[i].first = -0.04;
    bins[i].width = 2e-3;
    bins[i].bin_size = sizeof bin[i][0];
    bins[i].bins = bin[i];
  }
  wrc_accumulation accumulation = {sizeof accumulation};
  accumulation.duration = 0.5;
  accumulation.wear = &wear;
  accumulation.fatigue = &fatigue;
  wrc_damage_totals totals;
  for (int i = 0; i < 2; ++i) {
    OF(contact, wrc_contact_accumulate(contact, &accumulation, &bins[i], i == 0 ? &bins[2] : NULL, &totals));
    SHOW(totals, sum[0], largest_traction);
  }
  DO(wrc_damage_merge(&bins[0], &bins[1]));
  double values[count + 1];
  for (int32_t quantity = WRC_DAMAGE_WORK; quantity < WRC_DAMAGE_SUMS; ++quantity) {
    DO(wrc_damage_values(&bins[0], quantity, values));
    SHOW_ALL(values);
    DO(wrc_damage_values(&bins[2], quantity, values));
    SHOW_ALL(values);
  }
  printf("largest in a bin %.17g %.17g, overflow %d\n", bin[0][count / 2].largest_pressure,
         bin[0][count / 2].largest_traction, (int)bin[0][count].overflow);
  double life;
  DO(wrc_whole_life_damage(&fatigue, 40.0, &life));
  SHOW_ONE(life);
}

/* A wheel that passes films of its rail. */
static void filmed(void) {
  enum { count = 12 };
  static wrc_surface_bin bin[3][count];
  wrc_surface surface[3];
  memset(bin, 0, sizeof bin);
  for (int i = 0; i < 3; ++i) {
    surface[i] = wrc_surface_default();
    surface[i].count = count;
    surface[i].length = i == 1 ? 0.24 : 1.0;
    surface[i].closed = i == 1;
    surface[i].bin_size = sizeof bin[i][0];
    surface[i].bins = bin[i];
  }
  wrc_surface_laws laws = wrc_surface_laws_default();
  DO(wrc_surface_laws_use(&laws, "low adhesion, layers", text, sizeof text));
  laws.ambient = 5.0;
  for (int32_t quantity = 0; quantity < WRC_SURFACE_QUANTITIES; ++quantity)
    DO(wrc_surface_add(&surface[0], quantity, 4e-3, 1.0, 11.0, text, sizeof text));
  wrc_surface_passage passage = {sizeof passage};
  passage.rail_from = 3.0;
  passage.rail_to = 9.0;
  passage.wheel_to = 5.5;
  passage.energy = 4e3;
  wrc_friction base = wrc_friction_default(), friction;
  base.coefficient = 0.35;
  wrc_surface_exchange exchange = {sizeof exchange};
  DO(wrc_surface_pass(&surface[0], &surface[1], &laws, &passage, &exchange, text, sizeof text));
  SHOW(exchange, carried[0], beside_energy);
  DO(wrc_surface_friction(&surface[0], &surface[1], &laws, &passage, &base, &friction, text, sizeof text));
  SHOW_ONE(friction.coefficient);
  SHOW_ONE(friction.layer_yield);
  DO(wrc_surface_rest(&surface[0], &laws, 20.0, text, sizeof text));
  DO(wrc_surface_merge(&surface[2], &surface[0], text, sizeof text));
  double values[count], total;
  for (int32_t book = 0; book < WRC_SURFACE_BOOKS; ++book) {
    DO(wrc_surface_values(&surface[2], WRC_SURFACE_WATER, book, values, &total, text, sizeof text));
    SHOW_ALL(values);
    SHOW_ONE(total);
  }
}

static void numbers(void) {
  wrc_coefficients coefficients;
  double limit;
  DO(wrc_linear_coefficients(1.5, 0.3, 0.27, &coefficients));
  SHOW(coefficients, c11, c23s);
  DO(wrc_shakedown_limit(0.2, &limit));
  SHOW_ONE(limit);
  DO(wrc_shakedown_limit_point(0.2, &limit));
  SHOW_ONE(limit);
  double density[16], rise[16];
  for (int i = 0; i < 16; ++i) density[i] = 1e8 * i * (16 - i);
  wrc_heat_properties wheel = wrc_config_default().wheel_heat, rail = wheel;
  rail.density = 7800.0;
  DO(wrc_flash_temperature(16, 0.5e-3, density, speed, &wheel, &rail, rise));
  SHOW_ALL(rise);
}

/* ------------------------------------------------------------------------------------------------------
 * exact theory */

enum { nx = 12, ny = 14, cells = nx * ny };

static wrc_grid small_grid(void) {
  wrc_grid grid;
  memset(&grid, 0, sizeof grid);
  grid.nx = nx;
  grid.ny = ny;
  grid.dx = 1.6e-3;
  grid.dy = 1.6e-3;
  grid.x0 = -0.5 * grid.dx * (nx - 1);
  grid.y0 = -0.5 * grid.dy * (ny - 1);
  return grid;
}

/* The exact normal problem over the gap of a contact, and rolling under its pressure. */
static void half_spaces(wrc_contact* contact) {
  static double gap[cells], pressure[cells], traction_x[cells], traction_y[cells], slip_x[cells],
      slip_y[cells];
  int calls = 0;
  const wrc_grid grid = small_grid();
  OF(contact, wrc_exact_gap(contact, &grid, gap));
  SHOW_ALL(gap);
  wrc_exact_normal_problem press = wrc_exact_normal_problem_default();
  wrc_exact_normal_solution pressed = {sizeof pressed};
  press.normal_force = 80e3;
  press.grid = grid;
  press.gap = gap;
  press.progress = hear;
  press.user = &calls;
  pressed.pressure = pressure;
  DO(wrc_exact_normal(&press, &pressed, text, sizeof text));
  SHOW(pressed, approach, residual);
  SHOW_ALL(pressure);

  wrc_exact_rolling_problem roll = wrc_exact_rolling_problem_default();
  wrc_exact_rolling_solution rolled = {sizeof rolled};
  roll.grid = grid;
  roll.pressure = pressure;
  roll.creepage.longitudinal = 1e-3;
  roll.creepage.spin = 0.1;
  rolled.traction_x = traction_x;
  rolled.traction_y = traction_y;
  rolled.slip_x = slip_x;
  rolled.slip_y = slip_y;
  DO(wrc_exact_rolling(&roll, &rolled, text, sizeof text));
  SHOW(rolled, fx, residual);
  SHOW_ALL(traction_x);
  SHOW_ALL(slip_y);

  wrc_exact_transient* bodies = NULL;
  wrc_material wheel = roll.wheel_material, rail = roll.rail_material;
  DO(wrc_exact_transient_create(&grid, &wheel, &rail, &bodies, text, sizeof text));
  for (int i = 0; i < 2; ++i) {
    DO(wrc_exact_transient_step(bodies, &roll, &rolled, text, sizeof text));
    SHOW(rolled, fx, residual);
  }
  wrc_exact_transient_destroy(bodies);

  wrc_exact_loads loads = wrc_exact_loads_default();
  loads.grid = grid;
  loads.pressure = pressure;
  loads.traction_x = traction_x;
  const double points[6] = {0.0, 0.0, 2e-3, 1e-3, 2e-3, 3e-3}, depths[2] = {1e-3, 3e-3};
  double tensors[12];
  DO(wrc_exact_stress(&loads, points, 2, tensors, text, sizeof text));
  SHOW_ALL(tensors);
  wrc_stress_peaks levels[2];
  wrc_stresses stresses = {sizeof stresses};
  DO(wrc_exact_largest_stresses(&loads, depths, 2, levels, &stresses, hear, &calls, text, sizeof text));
  for (int i = 0; i < 2; ++i) show_peaks(&levels[i]);
  show_stresses(&stresses);
}

/* The real-time results against the exact ones. */
static void exactly(wrc_contact* planar, wrc_contact* wheel) {
  wrc_exact_check_options options = wrc_exact_check_options_default();
  wrc_exact_check_result result = {sizeof result};
  options.nx = options.ny = 12;
  OF(planar, wrc_exact_check(planar, &options, &result));
  SHOW(result, fx, power_error);
  wrc_wheel_input input = rolling();
  wrc_exact_wrench_options coarse = wrc_exact_wrench_options_default();
  wrc_wrench wrench = {sizeof wrench};
  input.wheel.z = 0.2e-3;
  coarse.cell_x = coarse.cell_s = 1.5e-3;
  OF(wheel, wrc_exact_wrench(wheel, &input, &coarse, &wrench));
  SHOW(wrench, force[0], steepest_angle);
}

/* Friction by name, its coefficient from a curve. */
static void fitted(wrc_contact* planar) {
  enum { count = 8 };
  const double slip[count] = {1e-3, 2e-3, 4e-3, 8e-3, 0.02, 0.05, 0.1, 0.2};
  const double measured[count] = {0.07, 0.12, 0.2, 0.27, 0.28, 0.26, 0.23, 0.19};
  double speed[count], load[count], adhesion[count];
  wrc_creep_curve curve = wrc_creep_curve_default();
  wrc_creep_fit fit = {sizeof fit};
  for (int i = 0; i < count; ++i) {
    speed[i] = 10.0 + i % 3;
    load[i] = 80e3;
  }
  curve.count = count;
  curve.slip = slip;
  curve.adhesion = measured;
  curve.speed = speed;
  curve.load = load;
  curve.ellipse.a = 6e-3;
  curve.ellipse.b = 5e-3;
  curve.ellipse.normal_force = 80e3;
  DO(wrc_friction_use(&curve.friction, "locomotive", text, sizeof text));
  OF(planar, wrc_fit_creep_curve(planar, &curve, &fit, adhesion));
  SHOW_ONE(fit.scatter);
  SHOW_ONE(fit.value[WRC_CREEP_COEFFICIENT]);
  SHOW_ONE(fit.deviation[WRC_CREEP_COEFFICIENT]);
  SHOW_ALL(adhesion);
}

/* ----------------------------------------------------------------------------------------------------------
 * profiles */

static void profiles(const wrc_model* model) {
  enum { count = 9, points = 240, bins = 200, room = 2000 };
  double lateral[count], radius_difference[count], y_wheel[count], conicity[2], wavelength[2];
  for (int i = 0; i < count; ++i) lateral[i] = 1e-3 * (i - count / 2);
  wrc_wheelset_geometry_problem problem = {sizeof problem};
  problem.count = count;
  problem.lateral = lateral;
  wrc_wheelset_geometry functions = {sizeof functions};
  functions.radius_difference = radius_difference;
  functions.y_wheel_right = y_wheel;
  DO(wrc_profile_wheelset_geometry(model, &problem, &functions, text, sizeof text));
  SHOW_ALL(radius_difference);
  SHOW_ALL(y_wheel);
  const double amplitudes[2] = {1e-3, 2.5e-3};
  wrc_conicity_problem rolls = wrc_conicity_problem_default();
  rolls.count = count;
  rolls.lateral = lateral;
  rolls.radius_difference = radius_difference;
  rolls.amplitude_count = 2;
  rolls.amplitudes = amplitudes;
  wrc_conicity found = {sizeof found};
  found.conicity = conicity;
  found.wavelength = wavelength;
  DO(wrc_equivalent_conicity(&rolls, &found, text, sizeof text));
  SHOW_ALL(conicity);
  SHOW_ALL(wavelength);

  static double arc[points], y[points], z[points], depth[bins], worn_y[room], worn_z[room];
  for (int i = 0; i < points; ++i) arc[i] = -0.078 + 0.5e-3 * i;
  for (int i = 0; i < bins; ++i) depth[i] = i > 80 && i < 120 ? 1e-8 * (i - 80) * (120 - i) / 400.0 : 0.0;
  DO(wrc_model_arc_places(model, WRC_BODY_WHEEL, points, arc, y, z));
  SHOW_ONE(z[points / 2]);
  wrc_profile_wear wear = wrc_profile_wear_default();
  wear.count = points;
  wear.y = y;
  wear.z = z;
  wear.bin_count = bins;
  wear.depth = depth;
  wear.first = -0.1;
  wear.passages = 2000.0;
  wrc_worn_profile worn = {sizeof worn};
  worn.capacity = room;
  worn.y = worn_y;
  worn.z = worn_z;
  DO(wrc_profile_remove_wear(&wear, &worn, text, sizeof text));
  SHOW(worn, passages, area);
  SHOW_ONE(worn_z[worn.count / 2]);
  wrc_flange flange;
  DO(wrc_flange_dimensions(points, y, z, 0.07, &flange, text, sizeof text));
  SHOW(flange, height, slope);
}

/* Measured sections of a rail: written, read, parted into faces. The file lies in the working folder. */
static void faced(void) {
  enum { count = 3, points = 40 };
  static double y[count][points], z[count][points];
  wrc_section_line line[count];
  memset(line, 0, sizeof line);
  for (int k = 0; k < count; ++k) {
    for (int i = 0; i < points; ++i) {
      y[k][i] = 1.8e-3 * (i - points / 2);
      z[k][i] = 2.0 * y[k][i] * y[k][i] + 1e-4 * k;
    }
    line[k].distance = 0.5 * k;
    line[k].count = points;
    line[k].y = y[k];
    line[k].z = z[k];
  }
  const char* const path = "sections.txt";
  wrc_section_file* file;
  wrc_section_line read;
  DO(wrc_section_file_write(path, line, count, text, sizeof text));
  DO(wrc_section_file_read(path, 1.0, 0, 0, &file, text, sizeof text));
  remove(path);
  DO(wrc_section_file_line(file, 1, &read));
  SHOW_ONE(read.distance);
  SHOW_ONE(read.z[3]);
  wrc_section_file_destroy(file);

  wrc_rail_faces_problem problem = wrc_rail_faces_problem_default();
  problem.section_count = count;
  problem.sections = line;
  wrc_rail_faces* faces;
  wrc_found_faces found = {sizeof found};
  wrc_face_outline outline = {sizeof outline};
  DO(wrc_rail_faces_create(&problem, &faces, text, sizeof text));
  DO(wrc_rail_faces_found(faces, &found));
  printf("%u faces, %u outlines, %u sections\n", (unsigned)found.face_count, (unsigned)found.outline_count,
         (unsigned)found.rail_section_count);
  const wrc_rail_section* const second =
      (const wrc_rail_section*)((const char*)found.rail_sections + found.rail_section_size);
  SHOW_ONE(second->distance);
  DO(wrc_rail_faces_outline(faces, 1, &outline));
  SHOW(outline, distance, spacing_error);
  SHOW_ONE(outline.y[3]);
  wrc_rail_faces_destroy(faces);
}

/* What may change in a minor version. */
static void experimental(void) {
  const wrc_experimental_api* const api = wrc_get_experimental_api(WRC_EXPERIMENTAL_VERSION);
  if (!WRC_API_HAS(api, flange_dimensions)) exit(2);
  const wrc_config config = standard();
  wrc_model* const model = model_of(&config);
  wrc_contact* const wheel = contact_of(model, WRC_SIDE_RIGHT);
  wrc_contact* const planar = contact_of(model, WRC_SIDE_RIGHT);
  const wrc_wheel_input input = rolling();
  wrc_wrench wrench = {sizeof wrench};
  wrc_planar_input step = wrc_planar_input_default();
  step.pose.lateral = 4e-3;
  step.load.normal_force = 80e3;
  step.creepage.longitudinal = 1e-3;
  wrc_wheel_input down = input;
  down.wheel.z = 0.3e-3;
  OF(wheel, wrc_contact_wrench(wheel, &down, &wrench));
  OF(planar, wrc_planar_step(planar, &step, NULL));
  damage_of(wheel);
  collected(wheel);
  filmed();
  numbers();
  half_spaces(planar);
  OF(planar, wrc_planar_step(planar, &step, NULL));
  exactly(planar, wheel);
  fitted(planar);
  profiles(model);
  faced();
  wrc_contact_destroy(planar);
  wrc_contact_destroy(wheel);
  wrc_model_destroy(model);
}

int main(void) {
  about();
  wheel_on_a_rail();
  remembering();
  other_rails();
  posed();
  given();
  printf("blocks of memory %d\n", blocks);
  /* last: of another version of the library it has other structs */
  if (wrc_get_experimental_api(WRC_EXPERIMENTAL_VERSION) != NULL) experimental();
  return 0;
}
