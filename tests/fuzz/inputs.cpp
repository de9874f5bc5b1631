#include "inputs.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "presets.hpp"
#include "ranges.hpp"
#include "test_config.hpp"

namespace hostile {
namespace {

/// Now and then one of the values is spoilt.
void poison_one(Choices& choices, std::vector<double>& values) {
  if (!choices.one_in(24) || values.empty()) return;
  values[choices.below(static_cast<std::uint32_t>(values.size()))] = choices.poison();
}

/// A number that is larger by next to nothing, or by what is just enough.
double next_to(Choices& choices, double from) {
  const double next = from + choices.magnitude(choices.one_in(2) ? 1e-18 : 1e-7, 1e-5);
  return choices.one_in(4) || !(next > from) ? std::nextafter(from, 1.0) : next;
}

/// Simple tread with a flange [m]; no standard's shape.
double wheel_height(double y) {
  if (y < -0.058) return 0.028 - 20.0 * (y + 0.058) * (y + 0.058);
  if (y < -0.032) return std::fmin(0.028, 0.0008 + 60.0 * (y + 0.032) * (y + 0.032));
  return -0.025 * y;
}
double rail_height(double y) {
  const double over = std::fmax(0.0, std::fabs(y) - 0.025);
  return 0.5 * y * y / 0.3 + 150.0 * over * over;
}

/// Measured, worn, edited by hand or simply wrong: the ways a profile file can be.
void spoil_profile(Choices& choices, std::vector<double>& y, std::vector<double>& z) {
  const auto count = static_cast<std::uint32_t>(y.size());
  const auto somewhere = [&] { return choices.below(count); };
  const double size = choices.magnitude(1e-9, 1e-2);
  switch (choices.below(12)) {
    case 0:
    case 1:
      break;
    case 2:  // noise of a measurement
      for (double& value : z) value += choices.between(-size, size);
      break;
    case 3: {  // a step: with many points nearly vertical
      const std::uint32_t from = somewhere();
      for (std::uint32_t i = from; i < count; ++i) z[i] += size;
      break;
    }
    case 4: {  // a kink
      const std::uint32_t from = somewhere();
      const double slope = choices.between(-3.0, 3.0);
      for (std::uint32_t i = from; i < count; ++i) z[i] += slope * (y[i] - y[from]);
      break;
    }
    case 5: {  // a vertical part
      const std::uint32_t at = 1 + choices.below(count - 1);
      y[at] = y[at - 1] + choices.magnitude(1e-15, 1e-4);
      break;
    }
    case 6: {  // a hollow or a groove
      const double middle = y[somewhere()], width = choices.magnitude(1e-4, 2e-2);
      for (std::uint32_t i = 0; i < count; ++i)
        z[i] += (choices.one_in(2) ? size : -size) * std::exp(-std::pow((y[i] - middle) / width, 2));
      break;
    }
    case 7:  // a single spike
      z[somewhere()] += choices.one_in(2) ? size : -size;
      break;
    case 8:  // flat
      std::fill(z.begin(), z.end(), 0.0);
      break;
    case 9:  // the other sign of z
      for (double& value : z) value = -value;
      break;
    case 10:  // millimetres, or the wrong order
      if (choices.one_in(2)) {
        for (double& value : y) value *= 1e3;
        for (double& value : z) value *= 1e3;
      } else {
        std::reverse(y.begin(), y.end());
      }
      break;
    default:  // unevenly spaced
      for (std::uint32_t i = 1; i + 1 < count; ++i) {
        y[i] = choices.between(y[i - 1], y[i + 1]);
        z[i] = std::clamp(z[i], -1.0, 1.0);
      }
  }
}

void make_points(Choices& choices, double from, double to, double (*height)(double), ProfilePoints& made) {
  std::uint32_t count = 60;
  switch (choices.below(8)) {
    case 5:
      count = 4 + choices.below(9);
      break;
    case 6:
      count = static_cast<std::uint32_t>(choices.magnitude(100.0, 3000.0));
      break;
    case 7:
      count = choices.one_in(8) ? 20000 : 400;
      break;
    default:
      break;
  }
  made.y.resize(count);
  made.z.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    made.y[i] = from + (to - from) * i / (count - 1);
    made.z[i] = height(made.y[i]);
  }
  spoil_profile(choices, made.y, made.z);
  poison_one(choices, made.y);
  poison_one(choices, made.z);
  made.profile.kind = WRC_PROFILE_POINTS;
  made.profile.count = count;
  made.profile.y = made.y.data();
  made.profile.z = made.z.data();
  if (choices.one_in(3)) made.profile.smoothing = sized(choices, MEMBER(wrc_profile, "smoothing"), 1e-6);
  if (choices.one_in(100)) made.profile.smoothing = choices.poison();
}

}  // namespace

void make_wheel(Choices& choices, ProfilePoints& wheel) {
  wheel.profile = wrc_profile{};
  wheel.profile.kind = WRC_PROFILE_S1002;
  if (choices.one_in(2)) make_points(choices, -0.070, 0.060, wheel_height, wheel);
}

void make_rail(Choices& choices, ProfilePoints& rail) {
  rail.profile = wrc_profile{};
  rail.profile.kind = choices.one_in(2) ? WRC_PROFILE_60E1 : WRC_PROFILE_UIC60_BENCHMARK;
  if (choices.one_in(2)) make_points(choices, -0.036, 0.036, rail_height, rail);
}

/// What the methods do not read is refused: as the library's defaults have it.
static void leave_unread(wrc_config& config) {
  const wrc_config untouched = test_config();
  if (config.normal.method == WRC_NORMAL_STRIP_HALFSPACE) {
    config.normal.max_iterations = untouched.normal.max_iterations;
    config.normal.load_tolerance = untouched.normal.load_tolerance;
  } else {
    config.planar.max_sweeps = untouched.planar.max_sweeps;
    config.planar.start = untouched.planar.start;
  }
  if (config.tangential.method != WRC_TANGENTIAL_FASTSIM) {
    config.tangential.bound = untouched.tangential.bound;
    config.tangential.flexibility = untouched.tangential.flexibility;
    if (config.tangential.method != WRC_TANGENTIAL_FASTRIP)
      config.tangential.patch_model = untouched.tangential.patch_model;
  }
  if (config.wheel.kind != WRC_PROFILE_NONE) return;
  config.wheelset.tape_circle_distance = untouched.wheelset.tape_circle_distance;
  config.track.gauge = untouched.track.gauge;
  config.track.gauge_depth = untouched.track.gauge_depth;
  config.track.rail_inclination = untouched.track.rail_inclination;
  config.track.placement = untouched.track.placement;
  config.track.rail_origin = untouched.track.rail_origin;
}

wrc_config make_config(Choices& choices, std::int32_t finest, const wrc_profile& wheel,
                       const wrc_profile& rail) {
  // On a handful of strips and cells everything is at a border.
  if (choices.one_in(3)) finest = std::min(finest, 8);
  const auto count = [&](double low, double high) {
    return static_cast<std::int32_t>(choices.magnitude(low, high));
  };
  wrc_config config = test_config();
  config.normal.method = static_cast<std::int32_t>(choices.below(normal_methods));
  config.planar.regularisation = static_cast<std::int32_t>(choices.below(2));
  choose_tangential(config, static_cast<std::int32_t>(choices.below(tangential_methods)));
  if (choices.one_in(8)) config.tangential.patch_model = static_cast<std::int32_t>(choices.below(4));
  config.tangential.bound = static_cast<std::int32_t>(choices.below(3));
  config.tangential.flexibility = static_cast<std::int32_t>(choices.below(3));
  config.planar.strips = count(MEMBER(wrc_config, "planar.strips").low, finest);
  config.planar.cells = count(MEMBER(wrc_config, "planar.cells").low, finest);
  config.surface.cells = count(MEMBER(wrc_config, "surface.cells").low, finest);
  config.planar.gap_rows = count(MEMBER(wrc_config, "planar.gap_rows").low, 8.0 * finest);
  config.planar.max_patches =
      static_cast<std::int32_t>(sized(choices, MEMBER(wrc_config, "planar.max_patches")));
  config.planar.start = static_cast<std::int32_t>(choices.below(2));
  if (choices.one_in(2))
    config.normal.max_iterations = config.planar.max_sweeps =
        static_cast<std::int32_t>(sized(choices, MEMBER(wrc_config, "planar.max_sweeps")));
  for (wrc_material* each : {&config.wheel_material, &config.rail_material}) {
    if (choices.one_in(4)) each->shear_modulus = sized(choices, MEMBER(wrc_material, "shear_modulus"));
    if (choices.one_in(4)) each->poisson = anywhere(choices, MEMBER(wrc_material, "poisson"));
    if (choices.one_in(4)) each->shear_yield = sized(choices, MEMBER(wrc_material, "shear_yield"));
  }
  if (choices.one_in(2)) config.rail_material = config.wheel_material;
  for (wrc_heat_properties* each : {&config.wheel_heat, &config.rail_heat}) {
    if (!choices.one_in(4)) continue;
    each->conductivity = sized(choices, MEMBER(wrc_heat_properties, "conductivity"));
    each->density = sized(choices, MEMBER(wrc_heat_properties, "density"));
    each->specific_heat = sized(choices, MEMBER(wrc_heat_properties, "specific_heat"));
  }
  if (choices.one_in(2))
    config.normal.load_tolerance = sized(choices, MEMBER(wrc_config, "normal.load_tolerance"));
  if (choices.one_in(2)) config.planar.gap_limit = sized(choices, MEMBER(wrc_config, "planar.gap_limit"));
  if (choices.one_in(4))
    config.wheelset.wheel_radius = sized(choices, MEMBER(wrc_config, "wheelset.wheel_radius"));
  if (choices.one_in(8)) config.track.gauge = choices.between(1.0, 1.7);
  if (choices.one_in(8))
    config.wheelset.tape_circle_distance = config.track.gauge + choices.between(-0.05, 0.15);
  if (choices.one_in(8)) config.track.gauge_depth = sized(choices, MEMBER(wrc_config, "track.gauge_depth"));
  if (choices.one_in(2)) config.track.rail_inclination = 0.025;
  if (choices.one_in(8))
    config.track.rail_inclination = anywhere(choices, MEMBER(wrc_config, "track.rail_inclination"));
  // Canted twice is refused: seldom here.
  if (rail.kind == WRC_PROFILE_UIC60_BENCHMARK && !choices.one_in(16)) config.track.rail_inclination = 0.0;
  if (choices.one_in(3)) {  // those of a wheel on a rail in one call
    config.normal.method = WRC_NORMAL_STRIP_HALFSPACE;
    config.tangential.method = WRC_TANGENTIAL_STRIP_FASTSIM;
    if (choices.one_in(6)) {
      config.check_rail.profile = rail;
      config.check_rail.y = choices.between(-0.2, -0.05);
      config.check_rail.z = choices.between(-0.05, 0.02);
    } else if (choices.one_in(4))
      config.roller_curvature = sized(choices, MEMBER(wrc_config, "roller_curvature"));
  }
  if (choices.one_in(4)) {
    config.track.placement = WRC_PLACEMENT_ORIGIN;
    config.track.rail_origin =
        choices.one_in(2) ? 0.7605 : anywhere(choices, MEMBER(wrc_config, "track.rail_origin"));
  }
  if (!choices.one_in(8)) {
    config.wheel = wheel;
    config.rail = rail;
  }
  if (!choices.one_in(16)) leave_unread(config);
  return config;
}

/// The sections of a program with a newer header, now and then with a member set that ours does not know.
static void resize_sections(Choices& choices, wrc_config& config, AlongTrackArrays& made) {
  const std::size_t ours = sizeof(wrc_rail_section), count = made.sections.size();
  const std::size_t size = ours + 8 * choices.below(600);
  made.of_another_header.assign(count * size, 0);
  for (std::size_t k = 0; k < count; ++k)
    std::memcpy(made.of_another_header.data() + k * size, &made.sections[k], ours);
  if (size > ours && choices.one_in(4)) made.of_another_header.back() = 1;
  config.rail_section_size = static_cast<std::uint32_t>(size);
  config.rail_sections = reinterpret_cast<const wrc_rail_section*>(made.of_another_header.data());
}

void make_along_track(Choices& choices, wrc_config& config, AlongTrackArrays& made) {
  if (config.wheel.kind == WRC_PROFILE_NONE || !choices.one_in(4)) return;
  // Other methods and bodies are refused beside these: seldom here.
  if (!choices.one_in(16)) {
    config.normal.method = WRC_NORMAL_STRIP_HALFSPACE;
    config.roller_curvature = 0.0;
    config.check_rail = test_config().check_rail;
    leave_unread(config);
  }
  const std::uint32_t which = choices.below(3);
  if (which != 1) {
    const std::uint32_t faces = choices.one_in(3) ? 1 + choices.below(4) : 1;
    const double size = choices.magnitude(1e-6, 0.5);
    const bool marked = choices.one_in(4);
    for (std::uint32_t face = 0; face < faces; ++face) {
      const std::uint32_t count = 2 + choices.below(choices.one_in(8) ? 40 : 5);
      double distance = choices.between(-20.0, 20.0);
      for (std::uint32_t k = 0; k < count; ++k) {
        wrc_rail_section section{};
        section.distance = distance;
        section.surface = static_cast<std::int32_t>(face);
        section.y = (face > 0 ? 0.08 * face : 0.0) + choices.between(-0.2, 0.2) * (k > 0 ? size : 0.0);
        section.z = choices.between(-0.2, 0.2) * size;
        section.profile = config.rail;
        if (choices.one_in(8)) {  // of another outline
          section.profile = wrc_profile{};
          section.profile.kind = WRC_PROFILE_60E1;
        }
        made.sections.push_back(section);
        distance += choices.one_in(4) ? choices.magnitude(1e-3, 0.1) : choices.magnitude(0.1, 100.0);
      }
    }
    const auto somewhere = [&]() -> wrc_rail_section& {
      return made.sections[choices.below(static_cast<std::uint32_t>(made.sections.size()))];
    };
    if (marked) {
      made.marks = {choices.between(-0.03, -0.005), choices.between(0.0, 0.03)};
      for (wrc_rail_section& each : made.sections) {
        each.mark_count = 2;
        each.marks = made.marks.data();
      }
      if (choices.one_in(8)) somewhere().mark_count = 1;
      if (choices.one_in(8)) std::swap(made.marks[0], made.marks[1]);
    }
    if (choices.one_in(12)) somewhere().distance = choices.one_in(2) ? choices.poison() : 0.0;
    if (choices.one_in(12)) somewhere().y = choices.poison();
    if (choices.one_in(12)) somewhere().surface = static_cast<std::int32_t>(choices.below(6)) - 1;
    config.rail_section_size = sizeof(wrc_rail_section);
    config.rail_section_count = static_cast<std::uint32_t>(made.sections.size());
    config.rail_sections = made.sections.data();
    if (choices.one_in(8)) resize_sections(choices, config, made);
  }
  if (which == 0) return;
  const std::uint32_t angles = 9 + choices.below(choices.one_in(8) ? 4000 : 100), rows = 1 + choices.below(3);
  const double deep = choices.magnitude(1e-9, 5e-3), turn = 6.2831853071795862;
  const std::uint32_t waves = choices.below(30);
  for (std::uint32_t i = 0; i < angles; ++i) made.angle.push_back(turn * i / (angles - 1));
  made.angle.back() = turn;
  for (std::uint32_t row = 0; row < rows; ++row) {
    made.y.push_back(-0.03 + 0.03 * row);
    const bool noise = choices.one_in(8);
    for (std::uint32_t i = 0; i + 1 < angles; ++i)
      made.deviation.push_back(noise ? choices.between(-deep, deep) : deep * std::cos(waves * made.angle[i]));
    made.deviation.push_back(made.deviation[made.deviation.size() + 1 - angles]);
  }
  poison_one(choices, made.angle);
  poison_one(choices, made.deviation);
  if (choices.one_in(16)) made.deviation.back() += deep;
  config.roundness = {
      angles, rows, made.angle.data(), rows > 1 ? made.y.data() : nullptr, made.deviation.data(), {}};
}

wrc_planar_pose make_pose(Choices& choices) {
  wrc_planar_pose pose{};
  const bool far = choices.one_in(4);
  pose.lateral = far ? anywhere(choices, MEMBER(wrc_planar_pose, "lateral")) : choices.between(-0.008, 0.008);
  pose.roll =
      far ? sized(choices, MEMBER(wrc_planar_pose, "roll"), 1e-9) : choices.signed_magnitude(1e-9, 0.005);
  pose.yaw = sized(choices, MEMBER(wrc_planar_pose, "yaw"), 1e-9);
  if (choices.one_in(40)) pose.yaw = choices.poison();
  if (choices.one_in(40)) pose.lateral = choices.poison();
  return pose;
}

namespace {

/// The numbers of the angular velocity that a wheel's axes ask for.
std::array<double*, 3> turning_of(wrc_wheel_state& wheel) {
  if (wheel.angular_axes == WRC_AXES_NONE) return {&wheel.roll_rate, &wheel.pitch_rate, &wheel.yaw_rate};
  return {&wheel.angular_velocity[0], &wheel.angular_velocity[1], &wheel.angular_velocity[2]};
}

void make_wheel_state(Choices& choices, bool far, wrc_wheel_state& wheel) {
  wheel.reference = static_cast<std::int32_t>(choices.below(2));
  wheel.angular_axes = static_cast<std::int32_t>(choices.below(3));
  wheel.y = far ? anywhere(choices, MEMBER(wrc_wheel_state, "y")) : choices.between(-0.01, 0.01);
  wheel.z = far ? anywhere(choices, MEMBER(wrc_wheel_state, "z")) : choices.between(-2e-3, 3e-3);
  wheel.roll =
      far ? sized(choices, MEMBER(wrc_wheel_state, "roll"), 1e-9) : choices.signed_magnitude(1e-9, 0.01);
  wheel.yaw =
      far ? sized(choices, MEMBER(wrc_wheel_state, "yaw"), 1e-9) : choices.signed_magnitude(1e-9, 0.05);
  wheel.velocity[0] = sized(choices, MEMBER(wrc_wheel_state, "velocity[0]"), 1e-9);
  wheel.velocity[1] = sized(choices, MEMBER(wrc_wheel_state, "velocity[1]"), 1e-9);
  wheel.velocity[2] = sized(choices, MEMBER(wrc_wheel_state, "velocity[2]"), 1e-9);
  const std::array<double*, 3> turning = turning_of(wheel);
  *turning[0] = sized(choices, MEMBER(wrc_wheel_state, "roll_rate"), 1e-9);
  *turning[1] = sized(choices, MEMBER(wrc_wheel_state, "pitch_rate"), 1e-9);
  *turning[2] = sized(choices, MEMBER(wrc_wheel_state, "yaw_rate"), 1e-9);
  if (choices.one_in(4)) {  // a turn by the pitch alone, as good as none
    const double sine = choices.between(-1.0, 1.0), cosine = std::sqrt(1.0 - sine * sine);
    const double turn[9] = {cosine, 0.0, sine, 0.0, 1.0, 0.0, -sine, 0.0, cosine};
    std::copy(turn, turn + 9, wheel.rotation);
    wheel.orientation = choices.one_in(2) ? WRC_ORIENTATION_ROWS : WRC_ORIENTATION_COLUMNS;
    wheel.roll = wheel.yaw = 0.0;
    if (choices.one_in(8)) wheel.rotation[choices.below(9)] = choices.poison();
  }
}

void make_rail_state(Choices& choices, bool far, wrc_rail_state& rail) {
  rail.y = far ? sized(choices, MEMBER(wrc_rail_state, "y"), 1e-9) : choices.signed_magnitude(1e-9, 0.005);
  rail.z = far ? sized(choices, MEMBER(wrc_rail_state, "z"), 1e-9) : choices.signed_magnitude(1e-9, 0.005);
  rail.roll =
      far ? sized(choices, MEMBER(wrc_rail_state, "roll"), 1e-9) : choices.signed_magnitude(1e-9, 0.02);
  rail.y_velocity = sized(choices, MEMBER(wrc_rail_state, "y_velocity"), 1e-9);
  rail.z_velocity = sized(choices, MEMBER(wrc_rail_state, "z_velocity"), 1e-9);
  rail.roll_rate = sized(choices, MEMBER(wrc_rail_state, "roll_rate"), 1e-9);
  if (choices.one_in(3)) {
    rail.y_slope = choices.signed_magnitude(1e-9, 0.1);
    rail.z_slope = choices.signed_magnitude(1e-9, 0.1);
  }
}

}  // namespace

void make_wheel_on_rail(Choices& choices, const wrc_config& config, wrc_wheel_input& input) {
  input = wrc_wheel_input_default();
  wrc_wheel_state& wheel = input.wheel;
  wrc_rail_state& rail = input.rail;
  wrc_friction& friction = input.friction;
  const bool far = choices.one_in(4);
  make_wheel_state(choices, far, wheel);
  make_rail_state(choices, far, rail);
  friction.coefficient = sized(choices, MEMBER(wrc_friction, "coefficient"));
  if (choices.one_in(3)) rail = wrc_rail_state{};
  if (choices.one_in(6)) friction.coefficient = 0.0;
  if (choices.one_in(6) && friction.coefficient > 0.0) {
    friction.temperature_law = WRC_TEMPERATURE_LAW_LINEAR;
    friction.hot_ratio = choices.between(0.0, 1.0);
    friction.hot_temperature = choices.between(0.0, 1000.0);
    friction.bulk.rail = choices.between(-273.0, 2000.0);
  }
  if (choices.one_in(4)) friction.speed_law = 1 + static_cast<std::int32_t>(choices.below(2));
  input.start = static_cast<std::int32_t>(choices.below(2));
  if (choices.one_in(4)) {
    input.frame.speed = sized(choices, MEMBER(wrc_frame_motion, "speed"), 1e-9);
    input.frame.curvature = sized(choices, MEMBER(wrc_frame_motion, "curvature"), 1e-9);
    input.frame.vertical_curvature = sized(choices, MEMBER(wrc_frame_motion, "vertical_curvature"), 1e-9);
    input.frame.twist = sized(choices, MEMBER(wrc_frame_motion, "twist"), 1e-9);
  }
  if (choices.one_in(3)) {
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = sized(choices, MEMBER(wrc_wheel_input, "vertical_load"));
  } else {
    input.damping = choices.one_in(2) ? 0.0 : sized(choices, MEMBER(wrc_wheel_input, "damping"), 1e-9);
  }
  if (config.roller_curvature != 0.0 && !choices.one_in(4)) {
    input.roller_rate = choices.signed_magnitude(1e-9, 2000.0);
    input.distance = choices.signed_magnitude(1e-9, 0.25);
  }
  if (config.rail_section_count > 0) {  // near a section, somewhere, or far outside
    const std::size_t at = std::size_t{choices.below(config.rail_section_count)} * config.rail_section_size;
    wrc_rail_section near;
    std::memcpy(&near, reinterpret_cast<const char*>(config.rail_sections) + at, sizeof near);
    input.distance = near.distance + choices.signed_magnitude(1e-9, 10.0);
    if (choices.one_in(8)) input.distance = anywhere(choices, MEMBER(wrc_wheel_input, "distance"));
  }
  if (config.roundness.angle_count > 0)
    input.angle = choices.one_in(8) ? anywhere(choices, MEMBER(wrc_wheel_input, "angle"))
                                    : choices.between(-10.0, 10.0);
  if (choices.one_in(40)) input.angle = choices.poison();
  double* const numbers[] = {&wheel.y,
                             &wheel.z,
                             &wheel.yaw,
                             &wheel.velocity[0],
                             &rail.roll,
                             &rail.z_velocity,
                             &friction.coefficient,
                             &friction.layer_thickness,
                             &friction.layer_yield,
                             &input.time_step,
                             turning_of(wheel)[1],
                             &input.vertical_load,
                             &input.damping};
  if (choices.one_in(20)) *numbers[choices.below(std::size(numbers))] = choices.poison();
  const auto one_of = [&](auto& reserved) {
    return &reserved[choices.below(static_cast<std::uint32_t>(std::size(reserved)))];
  };
  double* const kept_for_later[] = {one_of(wheel.reserved), one_of(rail.reserved), one_of(friction.reserved),
                                    one_of(input.frame.reserved)};
  if (choices.one_in(60)) *kept_for_later[choices.below(std::size(kept_for_later))] = choices.poison();
}

wrc_planar_load make_load(Choices& choices) {
  wrc_planar_load load = wrc_planar_load_default();
  if (choices.one_in(3)) {
    load.prescribed = WRC_PRESCRIBE_APPROACH;
    load.approach = choices.one_in(8) ? choices.between(-1.0, 0.0)
                                      : sized(choices, MEMBER(wrc_planar_load, "approach"), 1e-15);
  } else {
    load.normal_force = sized(choices, MEMBER(wrc_planar_load, "normal_force"));
  }
  if (choices.one_in(40)) load.normal_force = load.approach = choices.poison();
  if (choices.one_in(3)) {
    load.damping = sized(choices, MEMBER(wrc_planar_load, "damping"), 1e-9);
    load.approach_velocity = sized(choices, MEMBER(wrc_planar_load, "approach_velocity"), 1e-9);
    // Damped to next to nothing: 1 + 3/2 damping * velocity of the last digits.
    if (choices.one_in(4))
      load.approach_velocity = -2.0 / 3.0 / load.damping * (1.0 - choices.magnitude(1e-16, 1e-2));
    load.approach_velocity = std::clamp(load.approach_velocity, -20.0, 20.0);
    if (choices.one_in(40)) load.damping = choices.poison();
    if (choices.one_in(40)) load.approach_velocity = choices.poison();
  }
  return load;
}

wrc_planar_motion make_motion(Choices& choices) {
  wrc_planar_motion motion{};
  motion.speed = sized(choices, MEMBER(wrc_planar_motion, "speed"), 1e-6);
  motion.lateral_velocity = sized(choices, MEMBER(wrc_planar_motion, "lateral_velocity"), 1e-9);
  motion.vertical_velocity = sized(choices, MEMBER(wrc_planar_motion, "vertical_velocity"), 1e-9);
  motion.roll_rate = sized(choices, MEMBER(wrc_planar_motion, "roll_rate"), 1e-9);
  motion.yaw_rate = sized(choices, MEMBER(wrc_planar_motion, "yaw_rate"), 1e-9);
  motion.pitch_rate = sized(choices, MEMBER(wrc_planar_motion, "pitch_rate"), 1e-9);
  if (choices.one_in(40)) motion.pitch_rate = choices.poison();
  return motion;
}

wrc_wear_laws make_wear_laws(Choices& choices) {
  wrc_wear_laws laws = wrc_wear_laws_default();
  double* const parameters = &laws.t_gamma_mild_end;
  const auto count = static_cast<std::uint32_t>(&laws.power_reference - parameters) + 1;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (choices.one_in(4)) parameters[i] *= choices.magnitude(1e-6, 1e6);
    if (choices.one_in(200)) parameters[i] = choices.poison();
  }
  return laws;
}

wrc_creepage make_creepage(Choices& choices) {
  wrc_creepage creepage = wrc_creepage_default();
  const double most = choices.one_in(4) ? 10.0 : 0.1;
  creepage.longitudinal = choices.signed_magnitude(1e-15, most);
  creepage.lateral = choices.signed_magnitude(1e-15, most);
  creepage.spin = choices.signed_magnitude(1e-12, 100.0 * most);
  creepage.speed = sized(choices, MEMBER(wrc_creepage, "speed"), 1e-6);
  if (choices.one_in(8)) creepage.reverse_share = anywhere(choices, MEMBER(wrc_creepage, "reverse_share"));
  if (choices.one_in(40)) creepage.spin = choices.poison();
  return creepage;
}

void make_friction(Choices& choices, FrictionArrays& arrays) {
  wrc_friction& friction = arrays.friction;
  friction = wrc_friction_default();
  friction.coefficient =
      choices.one_in(40) ? choices.poison() : sized(choices, MEMBER(wrc_friction, "coefficient"));
  friction.speed_law = static_cast<std::int32_t>(choices.below(3));
  friction.temperature_law = choices.one_in(4) ? WRC_TEMPERATURE_LAW_LINEAR : WRC_TEMPERATURE_LAW_NONE;
  if (choices.one_in(40)) friction.speed_law = choices.one_in(2) ? 3 : -1;
  if (choices.one_in(40)) friction.temperature_law = choices.one_in(2) ? 2 : -1;
  // with members of laws that are not chosen
  friction.kinetic_ratio =
      choices.one_in(4) ? 0.0 : sized(choices, MEMBER(wrc_friction, "kinetic_ratio"), 1e-12);
  friction.fall_rate = choices.one_in(4) ? 0.0 : sized(choices, MEMBER(wrc_friction, "fall_rate"), 1e-6);
  friction.half_speed = sized(choices, MEMBER(wrc_friction, "half_speed"));
  friction.hot_ratio = choices.one_in(4) ? 0.0 : sized(choices, MEMBER(wrc_friction, "hot_ratio"), 1e-12);
  friction.hot_temperature = choices.between(0.0, 1000.0);
  if (choices.one_in(2)) friction.bulk.rail = choices.between(-273.0, 2000.0);
  if (choices.one_in(2)) friction.slope_reduction = sized(choices, MEMBER(wrc_friction, "slope_reduction"));
  if (choices.one_in(2)) {
    friction.slope_limit =
        choices.one_in(4) ? 0.0 : sized(choices, MEMBER(wrc_friction, "slope_limit"), 1e-6);
    friction.slope_fall = choices.one_in(4) ? 0.0 : sized(choices, MEMBER(wrc_friction, "slope_fall"), 1e-6);
  }
  if (choices.one_in(2)) {
    friction.adhesion_reduction = sized(choices, MEMBER(wrc_friction, "adhesion_reduction"));
    friction.slip_reduction =
        friction.adhesion_reduction * choices.between(0.1, choices.one_in(8) ? 2.0 : 1.0);
  }
  if (choices.one_in(40)) friction.fall_rate = friction.slope_fall = choices.poison();
  if (!choices.one_in(2)) return;
  std::uint32_t count = 1 + choices.below(8);
  if (choices.one_in(16)) count = choices.one_in(2) ? 64 : 65;
  double y = choices.between(-0.05, 0.02);
  for (std::uint32_t k = 0; k < count; ++k) {
    arrays.y.push_back(y);
    arrays.coefficient.push_back(choices.one_in(4) ? 0.0 : choices.magnitude(1e-9, 2.0));
    y += choices.one_in(4) ? 0.0 : choices.magnitude(1e-12, 1e-2);
  }
  poison_one(choices, arrays.y);
  poison_one(choices, arrays.coefficient);
  if (choices.one_in(24)) std::reverse(arrays.y.begin(), arrays.y.end());
  friction.zone_count = count;
  friction.zone_y = arrays.y.data();
  friction.zone_coefficients = arrays.coefficient.data();
  friction.zone_frame = static_cast<std::int32_t>(choices.below(3));
}

double FrictionArrays::most() const {
  return friction.zone_count > 0 ? *std::max_element(coefficient.begin(), coefficient.end())
                                 : friction.coefficient;
}

wrc_ellipse make_ellipse(Choices& choices) {
  wrc_ellipse ellipse{};
  ellipse.a = sized(choices, MEMBER(wrc_ellipse, "a"));
  ellipse.b = sized(choices, MEMBER(wrc_ellipse, "b"));
  ellipse.psi = sized(choices, MEMBER(wrc_ellipse, "psi"), 1e-12);
  ellipse.normal_force = sized(choices, MEMBER(wrc_ellipse, "normal_force"));
  if (choices.one_in(40)) ellipse.a = choices.poison();
  return ellipse;
}

void make_gap(Choices& choices, std::int32_t room, GapArrays& gap) {
  std::uint32_t rows = 4 + choices.below(static_cast<std::uint32_t>(room) - 3);
  if (choices.one_in(40)) rows = choices.one_in(2) ? 3 : static_cast<std::uint32_t>(room) + 1;
  const double width = choices.magnitude(1e-5, 0.3);
  const double middle = choices.between(-0.1, 0.1) * (choices.one_in(4) ? 1.0 : 0.0);
  const double curvature = choices.one_in(4) ? choices.magnitude(1e-3, 1e6) : 1.0 / 0.46;
  const double lateral_curvature = choices.magnitude(1e-3, 1e5);
  const double size = choices.magnitude(1e-12, 1e-2);
  const std::uint32_t shape = choices.below(10);
  const std::uint32_t special = choices.below(rows);
  gap.y.resize(rows);
  gap.height.resize(rows);
  gap.centre.resize(rows);
  gap.curvature.resize(rows);
  for (std::uint32_t j = 0; j < rows; ++j) {
    const double s = 2.0 * j / (rows - 1) - 1.0;
    const double y = 0.5 * width * s;
    gap.y[j] = middle + y;
    double h = 0.5 * lateral_curvature * y * y;
    switch (shape) {
      case 0:  // several minima
        h += size * std::cos(40.0 * s);
        break;
      case 1:  // a plateau
        h = std::fmax(0.0, h - size);
        break;
      case 2:  // a step
        h += j > special ? size : 0.0;
        break;
      case 3:  // rising to one side: least at the edge
        h = size * s;
        break;
      case 4:  // noise
        h += choices.between(-size, size);
        break;
      case 5:  // concave: the ends touch
        h = -h;
        break;
      case 6:  // one row far below the others
        h -= j == special ? size : 0.0;
        break;
      case 7:  // flat
        h = 0.0;
        break;
      default:
        break;
    }
    gap.height[j] = std::clamp(shape == 8 ? h - 1e-3 : h, -0.3, 0.3);  // 8: negative everywhere
    gap.centre[j] = shape == 9 ? choices.between(-0.3, 0.3) : 0.02 * s * static_cast<double>(shape % 2);
    gap.curvature[j] = curvature * (shape == 4 ? choices.between(0.1, 10.0) : 1.0);
  }
  for (double& value : gap.curvature) value = std::clamp(value, 1e-3, 1e6);
  if (choices.one_in(24)) gap.y[special] = gap.y[0];  // rows twice, or out of order
  if (choices.one_in(12) && special > 0) gap.y[special] = next_to(choices, gap.y[special - 1]);
  gap.gap = wrc_planar_gap{};
  gap.gap.row_count = rows;
  gap.gap.y = gap.y.data();
  poison_one(choices, gap.y);
  if (!choices.one_in(3)) {
    poison_one(choices, gap.height);
    poison_one(choices, gap.curvature);
    gap.gap.height = gap.height.data();
    gap.gap.curvature = gap.curvature.data();
    if (!choices.one_in(4)) gap.gap.centre = gap.centre.data();
    return;
  }
  // The same surface, element by element; rows may stand apart in memory.
  const std::uint32_t columns = 3 + choices.below(60), stride = columns + choices.below(5);
  const double length = choices.magnitude(1e-5, 0.3);
  gap.x.resize(columns);
  gap.h.assign(static_cast<std::size_t>(rows) * stride, std::numeric_limits<double>::quiet_NaN());
  for (std::uint32_t i = 0; i < columns; ++i)
    gap.x[i] = length * (static_cast<double>(i) / (columns - 1) - 0.5);
  const double noise = choices.one_in(4) ? size : 0.0;
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      const double x = gap.x[i] - gap.centre[j];
      const double h = gap.height[j] + 0.5 * gap.curvature[j] * x * x +
                       (noise > 0.0 ? choices.between(-noise, noise) : 0.0);
      gap.h[j * stride + i] = std::clamp(h, -0.3, 0.3);
    }
  }
  if (choices.one_in(24)) gap.h[special * stride] = choices.poison();
  if (choices.one_in(24)) gap.x[1] = next_to(choices, gap.x[0]);
  poison_one(choices, gap.x);
  gap.gap.column_count = columns;
  gap.gap.x = gap.x.data();
  gap.gap.h = gap.h.data();
  gap.gap.row_stride = stride;
}

void make_strips(Choices& choices, std::int32_t room, StripArrays& strips) {
  std::uint32_t count = 1 + choices.below(static_cast<std::uint32_t>(room));
  if (choices.one_in(40)) count = choices.one_in(2) ? 0 : static_cast<std::uint32_t>(room) + 1;
  const double width = std::fmin(choices.magnitude(1e-9, 0.1), 0.5 / std::fmax(1.0, count));
  const double half = choices.magnitude(1e-9, 0.1), peak = choices.magnitude(1.0, 1e11);
  const bool even = choices.one_in(2), holes = choices.one_in(4);
  double border = -0.5 * width * count * choices.between(0.0, 1.0);
  for (auto* each : {&strips.y, &strips.width, &strips.centre, &strips.half_length, &strips.peak})
    each->resize(count);
  for (std::uint32_t j = 0; j < count; ++j) {
    const double w = even ? width : std::fmax(1e-9, width * choices.between(0.01, 1.0));
    if (holes) border += width * choices.between(0.0, 0.1);
    strips.width[j] = w;
    strips.y[j] = border + 0.5 * w;
    border += w;
    strips.half_length[j] = even ? half : std::fmax(1e-9, half * choices.between(0.0, 1.0));
    strips.centre[j] = choices.between(-0.3, 0.3) * (choices.one_in(8) ? 1.0 : 1e-3);
    strips.peak[j] = choices.one_in(8) ? 0.0 : peak * choices.between(0.0, 1.0);
  }
  poison_one(choices, strips.y);
  poison_one(choices, strips.width);
  poison_one(choices, strips.peak);
  poison_one(choices, strips.half_length);
  strips.strips = wrc_planar_strips{};
  strips.strips.count = count;
  strips.strips.y = strips.y.data();
  strips.strips.width = strips.width.data();
  strips.strips.centre = choices.one_in(2) ? nullptr : strips.centre.data();
  strips.strips.half_length = strips.half_length.data();
  strips.strips.peak = strips.peak.data();
}

}  // namespace hostile
