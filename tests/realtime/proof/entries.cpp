#include "proof/entries.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include "along_track.hpp"
#include "test_config.hpp"
#include "wrc/wrc_api.h"
#include "wrc/wrc_experimental_api.h"
#include "wrc/wrc_surface.h"

namespace {

/// Arrays of a host, made before any measurement: a gap by elements, and strips with pressure.
struct HostData {
  static constexpr int rows = 60, columns = 21, strips = 20;
  double y[rows], x[columns], h[rows * columns];
  double strip_y[strips], width[strips], half[strips], peak[strips];

  HostData() {
    for (int i = 0; i < columns; ++i) x[i] = -0.01 + 0.001 * i;
    for (int j = 0; j < rows; ++j) {
      y[j] = -0.015 + 0.03 * j / (rows - 1);
      for (int i = 0; i < columns; ++i) h[j * columns + i] = x[i] * x[i] / 0.92 + y[j] * y[j] / 0.6;
    }
    for (int j = 0; j < strips; ++j) {
      strip_y[j] = -0.005 + 0.0005 * (j + 0.5);
      width[j] = 0.0005;
      half[j] = 4e-3;
      peak[j] = 7e8;
    }
  }
};
const HostData host;

int32_t step(Wheel& wheel) { return wheel.step(); }

int32_t geometry(Wheel& wheel) { return wheel.geometry(); }

int32_t creepages(Wheel& wheel) {
  wrc_planar_motion motion = sized<wrc_planar_motion>();
  wrc_creepage creepage = wrc_creepage_default();
  motion.speed = 40.0;
  motion.pitch_rate = -87.0;
  motion.yaw_rate = 0.02;
  return wrc_planar_creepages(wheel.contact, &motion, &creepage);
}

int32_t normal(Wheel& wheel) {
  return wrc_planar_normal(wheel.contact, nullptr, &wheel.load, &wheel.output.normal);
}

int32_t normal_of_elements(Wheel& wheel) {
  wrc_planar_gap gap = sized<wrc_planar_gap>();
  gap.row_count = HostData::rows;
  gap.column_count = HostData::columns;
  gap.row_stride = HostData::columns;
  gap.y = host.y;
  gap.x = host.x;
  gap.h = host.h;
  return wrc_planar_normal(wheel.contact, &gap, &wheel.load, &wheel.output.normal);
}

int32_t regularise(Wheel& wheel) {
  return wrc_planar_regularise(wheel.contact, nullptr, &wheel.output.normal);
}

int32_t tangential(Wheel& wheel) {
  return wrc_planar_tangential(wheel.contact, nullptr, &wheel.creepage, &wheel.friction,
                               &wheel.output.forces);
}

int32_t damage_numbers(Wheel& wheel) {
  return wrc_contact_damage(wheel.contact, WRC_ALL_REGIONS, &wheel.output.damage);
}

int32_t wear_numbers(Wheel& wheel) {
  wrc_wear wear{};
  const int32_t status = wrc_contact_wear(wheel.contact, WRC_ALL_REGIONS, nullptr, &wear);
  return !gives_tractions(wheel.methods.tangential) && status == WRC_ERROR_UNSUPPORTED ? WRC_OK : status;
}

/// Damage of the last solution, to 300 bins of the wheel and rows of the rail, and what is done with bins.
int32_t accumulate(Wheel& wheel) {
  static wrc_damage_bin wheel_bin[301], other_bin[301], rail_bin[1001];
  static double values[1001];
  wrc_damage_bins bins = wrc_damage_bins_default(), rail = wrc_damage_bins_default();
  bins.count = 300;
  bins.first = -0.070;
  bins.width = 0.5e-3;
  bins.bins = wheel_bin;
  bins.bin_size = sizeof wheel_bin[0];
  wrc_damage_bins other = bins;
  other.bins = other_bin;
  rail.count = 100;
  rail.first = -0.050;
  rail.row_count = 10;
  rail.row_length = 0.01;
  rail.bins = rail_bin;
  rail.bin_size = sizeof rail_bin[0];
  wrc_accumulation step = sized<wrc_accumulation>();
  step.duration = 1e-3;
  wrc_damage_totals totals{};
  const int32_t status = wrc_contact_accumulate(wheel.contact, &step, &bins, &rail, &totals);
  const int32_t after =
      std::min(wrc_damage_merge(&other, &bins), std::min(wrc_damage_values(&rail, WRC_DAMAGE_WORK, values),
                                                         wrc_damage_values(&bins, WRC_DAMAGE_TIME, values)));
  double damage = 0.0, arc[4] = {-0.03, 0.0, 0.02, 1.0}, y[4], z[4];
  wrc_whole_life_damage(nullptr, 50.0, &damage);
  return status < 0  ? status
         : after < 0 ? after
                     : wrc_model_arc_places(wheel.model, WRC_BODY_WHEEL, 4, arc, y, z);
}

/// A wheel over films of its rail: a source, friction, the passage, time, merged bins, their values.
int32_t films(Wheel&) {
  static wrc_surface_bin rail_bin[50], other_bin[50], wheel_bin[24];
  static double values[50];
  wrc_surface rail = wrc_surface_default(), wheel = wrc_surface_default();
  rail.count = 50;
  rail.length = 1.0;
  rail.bins = rail_bin;
  rail.bin_size = sizeof rail_bin[0];
  wrc_surface other = rail;
  other.bins = other_bin;
  wheel.count = 24;
  wheel.length = 0.12;
  wheel.closed = 1;
  wheel.bins = wheel_bin;
  wheel.bin_size = sizeof wheel_bin[0];
  wrc_surface_laws laws = wrc_surface_laws_default();
  wrc_surface_passage passage = sized<wrc_surface_passage>();
  passage.rail_from = 3.0;
  passage.rail_to = 9.0;
  passage.wheel_from = 1.0;
  passage.wheel_to = 6.5;
  passage.energy = 400.0;
  wrc_surface_exchange exchange = sized<wrc_surface_exchange>();
  wrc_friction friction{};
  const int32_t statuses[] = {
      wrc_surface_laws_use(&laws, "low adhesion, layers", nullptr, 0),
      wrc_surface_add(&rail, WRC_SURFACE_WATER, 0.01, 2.0, 30.0, nullptr, 0),
      wrc_surface_add(&rail, WRC_SURFACE_FILM, 0.01, 4.0, 30.0, nullptr, 0),
      wrc_surface_friction(&rail, &wheel, &laws, &passage, nullptr, &friction, nullptr, 0),
      wrc_surface_pass(&rail, &wheel, &laws, &passage, &exchange, nullptr, 0),
      wrc_surface_rest(&rail, &laws, 10.0, nullptr, 0),
      wrc_surface_merge(&other, &rail, nullptr, 0),
      wrc_surface_values(&other, WRC_SURFACE_FILM, WRC_SURFACE_CARRIED, values, values, nullptr, 0)};
  return *std::min_element(std::begin(statuses), std::end(statuses));
}

int32_t accumulate_stages(Wheel& wheel) {
  const int32_t status = accumulate(wheel);
  // of forces alone, or of what an entry before left in the contact
  return status == WRC_ERROR_UNSUPPORTED || status == WRC_ERROR_SEQUENCE ? WRC_OK : status;
}

int32_t accumulate_wheel(Wheel& wheel) {
  const int32_t status = accumulate(wheel);
  return status == WRC_ERROR_SEQUENCE ? WRC_OK : status;
}

int32_t temperatures(Wheel& wheel) {
  wrc_temperature temperature = sized<wrc_temperature>();
  const int32_t status = wrc_contact_temperature(wheel.contact, WRC_ALL_REGIONS, nullptr, &temperature);
  return !gives_tractions(wheel.methods.tangential) && status == WRC_ERROR_UNSUPPORTED ? WRC_OK : status;
}

/// It takes its milliseconds whatever the methods: with one that has tractions, and those that have none.
int32_t stresses(Wheel& wheel) {
  if (gives_tractions(wheel.methods.tangential) && wheel.methods.tangential != preset_strip_fastsim)
    return WRC_OK;
  const double depth = 1e-3;
  wrc_stress_peaks level{};
  wrc_stresses found = sized<wrc_stresses>();
  const int32_t status =
      wrc_contact_stresses(wheel.contact, WRC_ALL_REGIONS, wheel.methods.side, &depth, 1, &level, &found);
  return !gives_tractions(wheel.methods.tangential) && status == WRC_ERROR_UNSUPPORTED ? WRC_OK : status;
}

int32_t flash_temperature(Wheel&) {
  double heat[512];
  for (double& each : heat) each = 1e10;
  return wrc_flash_temperature(512, 1e-5, heat, 30.0, nullptr, nullptr, heat);
}

int32_t sensitivities(Wheel& wheel) {
  wrc_planar_derivatives forces = sized<wrc_planar_derivatives>();
  return wrc_planar_tangential_derivatives(wheel.contact, &forces);
}

int32_t patch(Wheel& wheel) {
  wrc_region patch = sized<wrc_region>();
  const int32_t status = wrc_contact_region(wheel.contact, 0, &patch);
  const bool apart = wheel.output.damage.load_factor == 0.0;
  return apart && status == WRC_ERROR_RANGE ? WRC_OK : status;
}

/// All of them; which there are depends on the methods and on whether the bodies touch, those of the gap
/// always.
int32_t field(Wheel& wheel) {
  static double values[256 * 32];
  int32_t of_gap = WRC_OK;
  for (int32_t id = 0; id <= WRC_FIELD_GAP_CURVATURE; ++id) {
    std::uint64_t counts[2];
    const int32_t status = wrc_contact_field(wheel.contact, 0, id, values, std::size(values), counts);
    if (id >= WRC_FIELD_GAP_Y && id <= WRC_FIELD_GAP_CURVATURE && status < 0) of_gap = status;
    if (status == WRC_ERROR_BUFFER) return status;
  }
  return of_gap;
}

int32_t save_and_restore(Wheel& wheel) {
  const int32_t saved = wheel.save();
  return saved < 0 ? saved : wheel.restore();
}

int32_t portable_state(Wheel& wheel) {
  static char state[1 << 22];
  const int32_t saved = wrc_contact_save_portable(wheel.contact, state, sizeof state);
  return saved < 0 ? saved : wrc_contact_restore_portable(wheel.contact, state, sizeof state);
}

/// A contact in the wheel's spare memory.
int32_t contact_init(Wheel& wheel) {
  wrc_contact* another = nullptr;
  return wrc_contact_init(wheel.model, wheel.methods.side, wheel.spare, wheel.contact_bytes, &another,
                          nullptr, 0);
}

int32_t regularise_strips(Wheel& wheel) {
  wrc_planar_strips strips = sized<wrc_planar_strips>();
  strips.count = HostData::strips;
  strips.y = host.strip_y;
  strips.width = host.width;
  strips.half_length = host.half;
  strips.peak = host.peak;
  return wrc_planar_regularise(wheel.contact, &strips, &wheel.output.normal);
}

int32_t tangential_patch(Wheel& wheel) {
  wrc_ellipse ellipse = sized<wrc_ellipse>();
  ellipse.a = 6e-3;
  ellipse.b = 4e-3;
  ellipse.psi = -0.3;
  ellipse.normal_force = 80e3;
  wrc_friction friction = wheel.friction;
  friction.zone_frame = WRC_ZONES_CONTACT_FRAME;  // a patch of the host has no place on the rail
  return wrc_planar_tangential(wheel.contact, &ellipse, &wheel.creepage, &friction, &wheel.output.forces);
}

/// The pose of the wheel, its load as a vertical one or its approach as a depth below nominal height.
/// Steps of no length, of a part of the patch, of all of it and of many.
int32_t roll_on(Wheel& wheel) {
  wrc_ellipse ellipse = sized<wrc_ellipse>();
  ellipse.a = 6e-3;
  ellipse.b = 4e-3;
  ellipse.psi = -0.3;
  ellipse.normal_force = 80e3;
  wrc_creepage creepage = wheel.creepage;
  creepage.speed = 1.0;
  creepage.reverse_share = 0.0;
  wrc_friction friction = wrc_friction_default();
  friction.coefficient = wheel.friction.coefficient;
  wrc_planar_forces forces{};
  int32_t worst = WRC_OK;
  struct Part {
    double distance, a;
  };
  for (const Part& part : {Part{0.0, 6e-3}, Part{1e-300, 6e-3}, Part{1e-4, 5.8e-3}, Part{3e-3, 6.1e-3},
                           Part{0.012, 5e-3}, Part{0.05, 6e-3}, Part{1.0, 5.9e-3}}) {
    ellipse.a = part.a;
    worst = std::min({worst, wrc_planar_roll(wheel.remembering, part.distance),
                      wrc_planar_tangential(wheel.remembering, &ellipse, &creepage, &friction, &forces)});
  }
  return worst;
}

wrc_wheel_input wheel_input(const Wheel& wheel) {
  wrc_wheel_input input = wrc_wheel_input_default();
  input.wheel.y = wheel.pose.lateral;
  input.wheel.yaw = wheel.pose.yaw;
  input.wheel.velocity[0] = 40.0;
  input.wheel.pitch_rate = -87.0;
  input.rail.y_slope = 1e-3;
  input.rail.y_velocity = 0.01;
  input.friction.coefficient = wheel.friction.coefficient;
  if (wheel.load.prescribed == WRC_PRESCRIBE_NORMAL_FORCE) {
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = wheel.load.normal_force;
  } else {
    input.wheel.z = wheel.load.approach;
    input.damping = 0.1;
  }
  return input;
}

int32_t wheel_step(Wheel& wheel) {
  const wrc_wheel_input input = wheel_input(wheel);
  wrc_wrench wrench = sized<wrc_wrench>();
  const int32_t status = wrc_contact_wrench(wheel.contact, &input, &wrench);
  int32_t of_batch = 0;
  wrc_contact_wrench_batch(&wheel.contact, 1, &input, sizeof input, &wrench, sizeof wrench, &of_batch);
  return std::min(status, of_batch);
}

int32_t wheel_heated(Wheel& wheel) {
  wrc_wheel_input input = wheel_input(wheel);
  input.friction.speed_law = wheel.friction.speed_law;
  input.friction.temperature_law = WRC_TEMPERATURE_LAW_LINEAR;
  wrc_wrench wrench = sized<wrc_wrench>();
  wrc_wrench_derivatives found = sized<wrc_wrench_derivatives>();
  int32_t status = wrc_contact_wrench_derivatives(wheel.contact, &input, &wrench, &found);
  if (status == WRC_ERROR_UNSUPPORTED) status = wrc_contact_wrench(wheel.contact, &input, &wrench);
  // it is for methods with tractions
  return !gives_tractions(wheel.methods.tangential) && status == WRC_ERROR_UNSUPPORTED ? WRC_OK : status;
}

int32_t wheel_sensitivities(Wheel& wheel) {
  const wrc_wheel_input input = wheel_input(wheel);
  wrc_wrench wrench = sized<wrc_wrench>();
  wrc_wrench_derivatives found = sized<wrc_wrench_derivatives>();
  const int32_t status = wrc_contact_wrench_derivatives(wheel.contact, &input, &wrench, &found);
  const bool the_default =
      wheel.methods.normal == WRC_NORMAL_STRIP_HALFSPACE && wheel.methods.tangential == preset_strip_fastsim;
  return !the_default && status == WRC_ERROR_UNSUPPORTED ? WRC_OK : status;  // it is the default's alone
}

/// A contact made before any measurement.
struct MadeBefore {
  wrc_model* model = nullptr;
  wrc_contact* contact = nullptr;

  explicit MadeBefore(void (*give)(wrc_config&)) {
    wrc_config config = test_config();
    config.wheel.kind = WRC_PROFILE_S1002;
    config.rail.kind = WRC_PROFILE_60E1;
    config.track.rail_inclination = 0.025;
    give(config);
    wrc_model_create(&config, nullptr, &model, nullptr, 0);
    wrc_contact_create(model, WRC_SIDE_RIGHT, nullptr, &contact, nullptr, 0);
  }
  ~MadeBefore() {
    wrc_contact_destroy(contact);
    wrc_model_destroy(model);
  }
  MadeBefore(const MadeBefore&) = delete;
  MadeBefore& operator=(const MadeBefore&) = delete;
};

/// A wheel with a flat on a rail that changes, and one that remembers.
AlongTrackBodies along_track_bodies;
const MadeBefore along_track([](wrc_config& config) { along_track_bodies.give(config); });
const MadeBefore remembering([](wrc_config& config) { config.surface.memory = 1; });

/// Steps of no time, of a part of the contact, of its length and of many; trials and committed ones.
int32_t wheel_with_memory(Wheel& wheel) {
  wrc_wheel_input input = wheel_input(wheel);
  wrc_wrench wrench = sized<wrc_wrench>();
  int32_t worst = WRC_OK;
  for (const double time : {1e-6, 1e-5, 3e-4, 1e-3}) {
    input.time_step = time;
    int32_t status = wrc_contact_wrench(remembering.contact, &input, &wrench);
    input.time_step = 1e-9;
    if (status >= 0) status = wrc_contact_commit(remembering.contact);
    wrc_wrench_derivatives found = sized<wrc_wrench_derivatives>();
    if (status >= 0) status = wrc_contact_wrench_derivatives(remembering.contact, &input, &wrench, &found);
    worst = std::min(worst, status == WRC_ERROR_LOAD ? WRC_OK : status);
  }
  return worst;
}

int32_t wheel_along_track(Wheel& wheel) {
  wrc_wheel_input input = wheel_input(wheel);
  input.distance = wheel.pose.lateral > 0.0 ? 2.5 : 1.25;  // no arithmetic that a trap would notice
  input.angle = wheel.pose.yaw;
  wrc_wrench wrench = sized<wrc_wrench>();
  wrc_wrench_derivatives found = sized<wrc_wrench_derivatives>();
  const int32_t status = wrc_contact_wrench_derivatives(along_track.contact, &input, &wrench, &found);
  return status == WRC_ERROR_LOAD ? WRC_OK : status;
}

int32_t wheel_region(Wheel& wheel) {
  wrc_region region = sized<wrc_region>();
  const int32_t status = wrc_contact_region(wheel.contact, 0, &region);
  return status == WRC_ERROR_RANGE ? WRC_OK : status;  // apart: there is none
}

int32_t wheel_region_results(Wheel& wheel) {
  static double values[256 * 32];
  wrc_damage damage{};
  wrc_wear wear{};
  const auto of = [](int32_t status) { return status == WRC_ERROR_RANGE ? WRC_OK : status; };
  int32_t status = of(wrc_contact_damage(wheel.contact, 0, &damage));
  if (status >= 0) status = of(wrc_contact_wear(wheel.contact, 0, nullptr, &wear));
  wrc_temperature temperature = sized<wrc_temperature>();
  if (status >= 0) status = of(wrc_contact_temperature(wheel.contact, 0, nullptr, &temperature));
  for (int32_t field = 0; status >= 0 && field <= WRC_FIELD_STRIP_ANGLE; ++field)
    status = of(wrc_contact_field(wheel.contact, 0, field, values, std::size(values), nullptr));
  // Methods that give forces alone have no damage and fields over a region.
  return wheel.methods.tangential != preset_strip_fastsim && status == WRC_ERROR_UNSUPPORTED ? WRC_OK
                                                                                             : status;
}

/// Of a region of a wheel: with the default methods, whatever the others are it takes the same milliseconds.
int32_t wheel_stresses(Wheel& wheel) {
  const bool the_default =
      wheel.methods.normal == WRC_NORMAL_STRIP_HALFSPACE && wheel.methods.tangential == preset_strip_fastsim;
  if (!the_default) return WRC_OK;
  const double depth = 1e-3;
  wrc_stress_peaks level{};
  wrc_stresses found = sized<wrc_stresses>();
  const int32_t status =
      wrc_contact_stresses(wheel.contact, 0, wheel.methods.side, &depth, 1, &level, &found);
  return status == WRC_ERROR_RANGE ? WRC_OK : status;  // apart: there is none
}

/// NaN, infinity and numbers out of range in every input, each refused, and the sentence about it. The
/// failure it returns is that one was taken.
int32_t refused_input(Wheel& wheel) {
  char text[256];
  int32_t taken = WRC_OK;
  for (double* number : {&wheel.pose.lateral, &wheel.pose.roll, &wheel.pose.yaw, &wheel.load.normal_force,
                         &wheel.creepage.longitudinal, &wheel.creepage.lateral, &wheel.creepage.spin,
                         &wheel.creepage.speed, &wheel.friction.coefficient}) {
    if (number == &wheel.load.normal_force && wheel.load.prescribed == WRC_PRESCRIBE_APPROACH) continue;
    const double kept = *number;
    for (double wrong :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::signaling_NaN(),
          std::numeric_limits<double>::infinity(), 1e300, -1e300}) {
      *number = wrong;
      const bool refused = wheel.step() < 0;
      if (!refused || wrc_contact_last_error(wheel.contact, text, sizeof text) < 0)
        taken = WRC_ERROR_INTERNAL;
    }
    *number = kept;
  }
  return taken;
}

int32_t denormal_input(Wheel& wheel) {
  wrc_planar_pose& pose = wheel.pose;
  const wrc_planar_pose kept = pose;
  pose.lateral = pose.roll = pose.yaw = 5e-324;
  const int32_t status = wheel.step();
  pose = kept;
  return status;
}

int32_t model_profile(Wheel& wheel) {
  wrc_view y{}, z = wrc_view{};
  double deviation = 0.0;
  return wrc_model_profile(wheel.model, wheel.methods.side, WRC_BODY_RAIL, &y, &z, &deviation);
}

int32_t contact_sizes(Wheel& wheel) {
  std::uint64_t bytes = 0, alignment = 0;
  return std::min({wrc_contact_size(wheel.model, &bytes, &alignment),
                   wrc_contact_state_size(wheel.model, &bytes),
                   wrc_contact_portable_size(wheel.model, &bytes)});
}

int32_t plain_numbers(Wheel&) {
  wrc_coefficients coefficients{};
  double load_factor = 0.0;
  int32_t worst = WRC_OK;
  for (double ratio : {1e-3, 0.3, 2.0, 1e3}) {
    worst = std::min(worst, wrc_linear_coefficients(ratio, 0.4, 0.27, &coefficients));
    worst = std::min(worst, wrc_shakedown_limit(ratio < 10.0 ? ratio : 0.1, &load_factor));
    worst = std::min(worst, wrc_shakedown_limit_point(ratio < 10.0 ? ratio : 0.1, &load_factor));
  }
  wrc_linear_coefficients(std::numeric_limits<double>::quiet_NaN(), 0.4, 0.27, &coefficients);
  return worst;
}

int32_t defaults_and_names(Wheel&) {
  wrc_config_default();
  wrc_material_default();
  wrc_friction_default();
  wrc_wheel_input_default();
  wrc_planar_load_default();
  wrc_creepage_default();
  wrc_planar_input_default();
  wrc_bulk_temperatures_default();
  wrc_wear_laws_default();
  wrc_damage_bins_default();
  wrc_fatigue_laws_default();
  wrc_exact_normal_problem_default();
  wrc_exact_rolling_problem_default();
  wrc_exact_loads_default();
  wrc_exact_check_options_default();
  wrc_exact_wrench_options_default();
  wrc_conicity_problem_default();
  wrc_profile_wear_default();
  wrc_version();
  wrc_abi_version();
  wrc_version_text(1);
  wrc_status_name(WRC_ERROR_GAP);
  wrc_status_text(-1000);
  wrc_get_api(WRC_ABI_VERSION);
  wrc_get_experimental_api(WRC_EXPERIMENTAL_VERSION);
  return WRC_OK;
}

}  // namespace

const std::vector<Entry>& all_entries() {
  static const std::vector<Entry> entries = {
      {"wrc_planar_step", step},
      {"wrc_planar_geometry", geometry},
      {"wrc_planar_creepages", creepages},
      {"wrc_planar_normal", normal},
      {"wrc_planar_regularise", regularise},
      {"wrc_planar_tangential", tangential},
      {"wrc_contact_damage", damage_numbers},
      {"wrc_contact_wear", wear_numbers},
      {"wrc_contact_temperature", temperatures},
      {"wrc_contact_accumulate, stages", accumulate_stages},
      {"wrc_surface_add, _friction, _pass, _rest, _merge, _values", films},
      {"wrc_flash_temperature", flash_temperature},
      {"wrc_contact_stresses", stresses},
      {"wrc_planar_tangential_derivatives", sensitivities},
      {"wrc_contact_region, patch", patch},
      {"wrc_contact_field, all of them", field},
      {"wrc_contact_save, _restore", save_and_restore},
      {"wrc_contact_save_portable, _restore_portable", portable_state},
      {"wrc_contact_init", contact_init},
      {"wrc_planar_normal, gap by elements", normal_of_elements},
      {"wrc_planar_regularise, strips", regularise_strips},
      {"wrc_planar_tangential, double ellipse", tangential_patch},
      {"wrc_planar_roll, wrc_planar_tangential with memory", roll_on},
      {"wrc_contact_wrench, friction over temperature", wheel_heated},
      {"wrc_contact_wrench, _batch", wheel_step},  // whose regions the next ones read
      {"wrc_contact_region", wheel_region},
      {"wrc_contact_damage, _wear, _temperature, _field of a region", wheel_region_results},
      {"wrc_contact_stresses of a region", wheel_stresses},
      {"wrc_contact_accumulate, wheel on rail", accumulate_wheel},
      {"wrc_contact_wrench_derivatives", wheel_sensitivities},
      {"wrc_contact_wrench_derivatives, along the track", wheel_along_track},
      {"wrc_contact_wrench and _derivatives with memory, wrc_contact_commit", wheel_with_memory},
      {"wrc_planar_step refused, wrc_contact_last_error", refused_input},
      {"wrc_planar_step, denormal pose", denormal_input},
      {"wrc_model_profile", model_profile},
      {"wrc_contact_size, _state_size, _portable_size", contact_sizes},
      {"wrc_linear_coefficients, ...", plain_numbers},
      {"defaults, names, versions", defaults_and_names},
  };
  return entries;
}
