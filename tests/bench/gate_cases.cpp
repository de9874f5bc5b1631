/// Fixed work for counting instructions (instruction_gate.py): one case, so many steps, nothing else counted.
///     gate_cases             names of the cases
///     gate_cases NAME N      N steps inside the function measured_steps
/// The kernels are those for AVX2 where the library has them: valgrind does not run AVX-512.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "along_track.hpp"
#include "proof/wheel.hpp"
#include "test_config.hpp"
#include "wrc/wrc_surface.h"

namespace {

struct Case {
  const char* name;
  Methods methods;
  enum {
    complete,
    normal,
    tangential,
    damage,
    geometry,
    wrench,
    derivatives,
    line,
    wheel_line,
    track,
    round,
    films,
    forgets,
    remembers
  } part;
};

constexpr Methods usual{WRC_NORMAL_STRIP_HALFSPACE, preset_fastsim_sdec, WRC_SIDE_RIGHT, 60, 50};
constexpr Methods defaults{};
constexpr Methods light{WRC_NORMAL_EKP, preset_fastsim_sdec, WRC_SIDE_RIGHT, 32, 32};

constexpr Case cases[] = {
    {"step_halfspace_sdec_60x50", usual, Case::complete},
    {"step_defaults_60x32", defaults, Case::complete},
    {"step_ekp_sdec_32x32", light, Case::complete},
    {"geometry", light, Case::geometry},
    {"normal_halfspace_60", usual, Case::normal},
    {"normal_ekp_32", light, Case::normal},
    {"tangential_sdec_60x50", usual, Case::tangential},
    {"tangential_strip_fastsim_60x32", defaults, Case::tangential},
    {"damage_60x50", usual, Case::damage},
    {"wheel_on_rail", defaults, Case::wrench},
    {"wheel_on_rail_derivatives", defaults, Case::derivatives},
    {"wheel_on_varying_rail", defaults, Case::track},
    {"wheel_not_round", defaults, Case::round},
    {"accumulate_60x32", defaults, Case::line},
    {"accumulate_wheel_on_rail", defaults, Case::wheel_line},
    {"wheel_on_rail_with_films", defaults, Case::films},
    {"wheel_at_real_time", defaults, Case::forgets},
    {"wheel_at_real_time_remembers", defaults, Case::remembers},
};

/// A model of S1002 on UIC 60, a contact of it, and their end.
struct OnRail {
  wrc_model* model = nullptr;
  wrc_contact* contact = nullptr;

  static wrc_config config_of(const Methods& methods) {
    wrc_config config = test_config();
    config.wheel.kind = WRC_PROFILE_S1002;
    config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
    config.instruction_set = methods.instruction_set;
    return config;
  }
  void create(const Methods& methods, const wrc_config& config) {
    wrc_model_create(&config, nullptr, &model, nullptr, 0);
    wrc_contact_create(model, methods.side, nullptr, &contact, nullptr, 0);
  }
  OnRail() = default;
  ~OnRail() {
    wrc_contact_destroy(contact);
    wrc_model_destroy(model);
  }
  OnRail(const OnRail&) = delete;
  OnRail& operator=(const OnRail&) = delete;
};

/// The same wheel on a rail of nine sections that rises and falls by 10 um, passed where it is as high as the
/// constant one, so that as many strips are in contact: what is counted beside that is the cost of following
/// it. And a wheel with a flat of 20 um.
struct AlongTrack : OnRail {
  AlongTrackBodies bodies;
  wrc_rail_section section[9];

  AlongTrack(const Methods& methods, bool rail) {
    wrc_config config = config_of(methods);
    bodies.give(config);
    for (double& each : bodies.deviation) each *= 0.05;
    for (int k = 0; k < 9; ++k) {
      section[k] = {};
      section[k].profile.kind = WRC_PROFILE_UIC60_BENCHMARK;
      section[k].distance = 0.5 * k;
      section[k].z = k % 2 == 0 ? -10e-6 : 10e-6;
    }
    config.rail_sections = section;
    config.rail_section_count = rail ? 9 : 0;
    if (rail) config.roundness = {};
    create(methods, config);
  }
};

/// A wheel at "real time", without memory or with it.
struct RealTime : OnRail {
  RealTime(const Methods& methods, bool remembers) {
    wrc_config config = config_of(methods);
    config.surface.memory = remembers;
    if (wrc_config_use(&config, "real time", nullptr, 0) < 0) std::exit(1);
    create(methods, config);
  }
};

/// Steps of 1 ms at 80 kN, from a mark, along a lateral place that moves by 12.5 um a step, there and back.
void step_in_real_time(wrc_contact* contact, bool remembers, int i) {
  wrc_wheel_input input = wrc_wheel_input_default();
  wrc_wrench wrench = sized<wrc_wrench>();
  input.start = WRC_START_MARK;
  input.wheel.y = 4e-3 + 12.5e-6 * std::abs(8 - i % 16);
  input.wheel.z = -0.03e-3;
  input.wheel.velocity[0] = 20.0;
  input.wheel.velocity[1] = 0.02;
  input.wheel.angular_axes = WRC_AXES_TRACK;
  input.wheel.angular_velocity[1] = -20.0 / 0.46;
  if (remembers) input.time_step = 1e-3;
  if (wrc_contact_wrench(contact, &input, &wrench) < 0) std::exit(1);
  if (remembers)
    wrc_contact_commit(contact);
  else
    wrc_contact_mark(contact);
}

/// Does a part go on from wrc_contact_wrench()? The others do from wrc_planar_step().
bool of_wheel_on_rail(int part) {
  return part == Case::wrench || part == Case::derivatives || part == Case::wheel_line ||
         part == Case::track || part == Case::round || part == Case::films || part == Case::forgets ||
         part == Case::remembers;
}

/// What wheel_on_rail() steps on instead of the wheel's own contact.
wrc_contact* special = nullptr;

/// Films with layers in 14 rows across both bodies: wrench, passage and the wheel's rest of each step.
struct Films {
  wrc_surface rail = wrc_surface_default(), wheel = rail;
  wrc_surface_laws laws = wrc_surface_laws_default();
  wrc_surface_bin rail_bin[14 * 20] = {}, wheel_bin[14 * 24] = {};
  double rows[WRC_FILM_NUMBERS(14, 14)] = {};
  wrc_surface_passage passage = sized<wrc_surface_passage>();

  explicit Films(wrc_contact* contact) {
    if (wrc_surface_laws_use(&laws, "low adhesion, layers", nullptr, 0) < 0) std::exit(1);
    rail.count = 20;
    rail.length = 1.0;
    rail.bins = rail_bin;
    wheel.count = 24;
    wheel.length = 2.89 / 24.0;
    wheel.closed = 1;
    wheel.bins = wheel_bin;
    for (wrc_surface* each : {&rail, &wheel}) {
      each->bin_size = sizeof(wrc_surface_bin);
      each->rows = 14;
      each->width = 5e-3;
      each->row_first = -37e-3;
    }
    // water, oxide and organic film all along the rail [kg/m^2]
    const double amounts[] = {0.01, 0.001, 0.006};
    for (int q = 0; q < 3; ++q)
      if (wrc_surface_add(&rail, q, amounts[q], 0.0, 20.0, nullptr, 0) < 0) std::exit(1);
    passage.film_rows = rows;
    passage.film_numbers = sizeof rows / sizeof rows[0];
    passage.contact = contact;
  }
  /// Friction of the next 20 mm.
  void go(int i, wrc_friction& friction) {
    const wrc_friction clean = wrc_friction_default();
    passage.rail_from = 5.0 + 0.02 * i;
    passage.rail_to = passage.rail_from + 0.02;
    passage.wheel_from = 0.02 * i;
    passage.wheel_to = passage.wheel_from + 0.02;
    if (wrc_surface_friction(&rail, &wheel, &laws, &passage, &clean, &friction, nullptr, 0) < 0) std::exit(1);
  }
  /// The step's frictional energy in 1 ms acts on the films.
  void pass(const wrc_wrench& wrench) {
    passage.energy = wrench.power * 1e-3;
    if (wrc_surface_pass(&rail, &wheel, &laws, &passage, nullptr, nullptr, 0) < 0) std::exit(1);
    if (wrc_surface_rest(&wheel, &laws, 1e-3, nullptr, 0) < 0) std::exit(1);
  }
};

/// Films of the case that has them.
Films* films = nullptr;

/// A wheel on a rail at 80 to 100 kN; with its derivatives or without.
void wheel_on_rail(Wheel& wheel, bool derivatives, int i, int part = Case::wrench) {
  wrc_wheel_input input = wrc_wheel_input_default();
  wrc_wrench wrench = sized<wrc_wrench>();
  wrc_wrench_derivatives found = sized<wrc_wrench_derivatives>();
  input.start = WRC_START_WARM;
  input.wheel.y = 2.8e-3 + 0.2e-3 * (i % 16) / 16.0;
  input.wheel.z = 0.1e-3;
  input.wheel.yaw = 3e-3;
  input.wheel.velocity[0] = 20.0;
  input.wheel.angular_axes = WRC_AXES_TRACK;
  input.wheel.angular_velocity[1] = -20.0 / 0.46;
  if (part == Case::forgets || part == Case::remembers)
    return step_in_real_time(special, part == Case::remembers, i);
  if (part == Case::track) input.distance = 1.234 + 1e-3 * i;
  if (part == Case::round) input.angle = 0.1 - 0.0125 * (i % 16);
  if (part == Case::track || part == Case::round)
    wrc_contact_wrench(special, &input, &wrench);
  else if (part == Case::films) {
    films->go(i, input.friction);
    if (wrc_contact_wrench(wheel.contact, &input, &wrench) < 0) std::exit(1);
    films->pass(wrench);
  } else if (derivatives)
    wrc_contact_wrench_derivatives(wheel.contact, &input, &wrench, &found);
  else
    wrc_contact_wrench(wheel.contact, &input, &wrench);
}

/// Damage of the last results to bins of both bodies.
void accumulate(Wheel& wheel) {
  static wrc_damage_bin bin[2][141];
  wrc_damage_bins bins[2];
  for (int body = 0; body < 2; ++body) {
    bins[body] = wrc_damage_bins_default();
    bins[body].count = 140;
    bins[body].first = -0.070;
    bins[body].bins = bin[body];
    bins[body].bin_size = sizeof bin[body][0];
  }
  wrc_accumulation step = sized<wrc_accumulation>();
  step.duration = 1e-3;
  wrc_contact_accumulate(wheel.contact, &step, &bins[0], &bins[1], nullptr);
}

int32_t instruction_set() {
  wrc_config config = test_config();
  config.instruction_set = WRC_INSTRUCTIONS_AVX2;
  return wrc_config_check(&config, nullptr, 0) == WRC_OK ? WRC_INSTRUCTIONS_AVX2 : WRC_INSTRUCTIONS_BEST;
}

}  // namespace

/// What the counting is switched on for, by this name.
extern "C" __attribute__((noinline, visibility("default"))) void measured_steps(Wheel& wheel, int part,
                                                                                int count);

extern "C" void measured_steps(Wheel& wheel, int part, int count) {
  for (int i = 0; i < count; ++i) {
    // Half a millimetre around the flange root's second patch and back, as a wheelset moves.
    wheel.pose.lateral = 4.6e-3 + 0.5e-3 * (i % 16) / 16.0;
    wheel.load.normal_force = 80e3 + 1e3 * (i % 16);
    wheel.creepage.longitudinal = 1e-3 + 1e-4 * (i % 16);
    switch (part) {
      case Case::complete:
        wheel.step();
        break;
      case Case::geometry:
        wheel.geometry();
        break;
      case Case::normal:
        wrc_planar_normal(wheel.contact, nullptr, &wheel.load, &wheel.output.normal);
        break;
      case Case::tangential:
        wrc_planar_tangential(wheel.contact, nullptr, &wheel.creepage, &wheel.friction, &wheel.output.forces);
        break;
      case Case::wrench:
      case Case::derivatives:
        wheel_on_rail(wheel, part == Case::derivatives, i);
        break;
      case Case::track:
      case Case::round:
      case Case::films:
      case Case::forgets:
      case Case::remembers:
        wheel_on_rail(wheel, false, i, part);
        break;
      case Case::line:
        accumulate(wheel);
        break;
      case Case::wheel_line:
        accumulate(wheel);
        break;
      default:
        wrc_contact_damage(wheel.contact, WRC_ALL_REGIONS, &wheel.output.damage);
        break;
    }
  }
}

int main(int count, char** arguments) {
  if (count < 3) {
    for (const Case& each : cases) std::printf("%s\n", each.name);
    return 0;
  }
  for (const Case& each : cases) {
    if (std::strcmp(each.name, arguments[1]) != 0) continue;
    Methods methods = each.methods;
    methods.instruction_set = instruction_set();
    Wheel wheel(methods);
    wheel.creepage.lateral = -1e-3;
    wheel.creepage.spin = 0.2;
    wheel.pose.lateral = 4.6e-3;
    wheel.load.normal_force = 80e3;
    const AlongTrack along_track(methods, each.part == Case::track);
    const RealTime real_time(methods, each.part == Case::remembers);
    const bool in_real_time = each.part == Case::forgets || each.part == Case::remembers;
    special = in_real_time ? real_time.contact : along_track.contact;
    Films of_case(wheel.contact);
    films = &of_case;
    // The last solution of the contact is the one that the case goes on from.
    wheel_on_rail(wheel, false, 0, each.part);
    if (!of_wheel_on_rail(each.part) && wheel.step() < 0) return 1;
    measured_steps(wheel, each.part, std::atoi(arguments[2]));
    return 0;
  }
  std::printf("no such case: %s\n", arguments[1]);
  return 2;
}
