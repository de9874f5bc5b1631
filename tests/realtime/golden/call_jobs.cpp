/// Calls beside the step: creepages from a motion, rolling backwards and through standstill, wear, profiles
/// as placed, plain numbers, refused input.
#include <cstring>
#include <limits>
#include <utility>

#include "along_track.hpp"
#include "check_rail_points.hpp"
#include "field_values.hpp"
#include "golden/plan.hpp"
#include "wrc/wrc_surface.h"

namespace {

/// The values of a field over strips, or of the cells of its first strip.
void hash_field(wrc_contact* contact, int32_t field, Hash& hash) {
  const FieldValues found = field_values(contact, 0, field);
  hash.add(found.status);
  if (found.cells > 1)
    for (std::uint64_t i = 0; i < found.cells; ++i) hash.add(found.at(i, 0));
  else
    for (const double value : found.values) hash.add(value);
}

/// A contact with tractions in it.
int32_t roll(wrc_contact* contact, double lateral) {
  wrc_planar_input input = wrc_planar_input_default();
  input.pose.lateral = lateral;
  input.load.normal_force = 90e3;
  input.creepage.longitudinal = 1.5e-3;
  input.creepage.spin = -0.4;
  input.creepage.speed = 55.0;
  return wrc_planar_step(contact, &input, nullptr);
}

void run_motion(wrc_contact* contact, Hash& hash) {
  Numbers numbers(5);
  for (int i = 0; i < 8; ++i) {
    wrc_planar_pose pose = sized<wrc_planar_pose>();
    pose.lateral = numbers.between(-5e-3, 7e-3);
    pose.yaw = numbers.between(-0.02, 0.02);
    wrc_planar_motion motion = sized<wrc_planar_motion>();
    motion.speed = i == 0 ? 0.0 : numbers.between(1.0, 90.0);
    motion.pitch_rate = -motion.speed / numbers.between(0.455, 0.465);
    motion.lateral_velocity = numbers.between(-0.1, 0.1);
    motion.vertical_velocity = numbers.between(-0.1, 0.1);
    motion.roll_rate = numbers.between(-0.1, 0.1);
    motion.yaw_rate = numbers.between(-0.1, 0.1);
    wrc_creepage creepage = wrc_creepage_default();
    hash.add(wrc_planar_geometry(contact, &pose, nullptr));
    hash.add(wrc_planar_creepages(contact, &motion, &creepage));
    for (double number : {creepage.longitudinal, creepage.lateral, creepage.spin, creepage.speed})
      hash.add(number);
  }
}

/// From the motion to the forces, backwards and through standstill.
void run_standstill(wrc_contact* contact, Hash& hash) {
  Numbers numbers(8);
  for (int i = 0; i < 16; ++i) {
    wrc_planar_pose pose = sized<wrc_planar_pose>();
    pose.lateral = numbers.between(-4e-3, 5e-3);
    pose.yaw = numbers.between(-0.02, 0.02);
    wrc_planar_load load = wrc_planar_load_default();
    load.normal_force = 70e3;
    const double fastest = i % 4 == 0 ? 80.0 : 0.15;
    wrc_planar_motion motion = sized<wrc_planar_motion>();
    motion.speed = i == 1 ? 0.0 : numbers.between(-fastest, fastest);
    motion.pitch_rate = -motion.speed / numbers.between(0.459, 0.461);
    motion.lateral_velocity = numbers.between(-0.01, 0.01) * (i % 3);
    motion.yaw_rate = numbers.between(-0.05, 0.05);
    wrc_creepage creepage = wrc_creepage_default();
    const wrc_friction friction = wrc_friction_default();
    wrc_planar_forces forces{};
    wrc_planar_derivatives sensitivity = sized<wrc_planar_derivatives>();
    hash.add(wrc_planar_geometry(contact, &pose, nullptr));
    hash.add(wrc_planar_normal(contact, nullptr, &load, nullptr));
    hash.add(wrc_planar_creepages(contact, &motion, &creepage));
    for (double number :
         {creepage.longitudinal, creepage.lateral, creepage.spin, creepage.speed, creepage.reverse_share})
      hash.add(number);
    hash.add(wrc_planar_tangential(contact, nullptr, &creepage, &friction, &forces));
    hash_forces(forces, hash);
    hash_fields(contact, hash, true, Reached::tangential);
    hash.add(wrc_planar_tangential_derivatives(contact, &sensitivity));
    for (const auto& row : sensitivity.forces)
      for (int k = 0; k < 5; ++k) hash.add(row[k]);
  }
}

/// Many poses: an angle's sine that differs in its last bit does so for few angles only.
void run_geometry(wrc_contact* contact, Hash& hash) {
  Numbers numbers(6);
  for (int i = 0; i < 400; ++i) {
    wrc_planar_pose pose = sized<wrc_planar_pose>();
    pose.lateral = numbers.between(-6e-3, 7.5e-3);
    pose.roll = numbers.between(-5e-3, 5e-3);
    pose.yaw = numbers.between(-0.03, 0.03);
    wrc_planar_point point{};
    hash.add(wrc_planar_geometry(contact, &pose, &point));
    hash_point(point, hash);
    if (i % 8 == 0) hash_fields(contact, hash);
  }
}

void run_wear(wrc_contact* contact, Hash& hash) {
  for (double lateral : {0.0, 5.1e-3, 7e-3}) {
    hash.add(roll(contact, lateral));
    wrc_wear wear{};
    hash.add(wrc_contact_wear(contact, WRC_ALL_REGIONS, nullptr, &wear));
    for (double number : {wear.worn_area_rate, wear.largest_depth_rate, wear.largest_depth_velocity})
      hash.add(number);
    hash_field(contact, WRC_FIELD_STRIP_WEAR, hash);
  }
}

/// What the last results of a contact do, in bins of both bodies and rows.
void hash_accumulated(wrc_contact* contact, Hash& hash) {
  wrc_damage_bin wheel_bin[2][61] = {}, rail_bin[81] = {};
  wrc_damage_bins wheel[2] = {wrc_damage_bins_default(), wrc_damage_bins_default()};
  wrc_damage_bins rail = wrc_damage_bins_default();
  for (int k = 0; k < 2; ++k) {
    wheel[k].count = 60;
    wheel[k].first = -0.050;
    wheel[k].width = 1.7e-3;
    wheel[k].bins = wheel_bin[k];
    wheel[k].bin_size = sizeof wheel_bin[k][0];
  }
  rail.count = 20;
  rail.first = -0.040;
  rail.width = 4e-3;
  rail.row_count = 4;
  rail.row_first = 1.0;
  rail.row_length = 0.013;
  rail.bins = rail_bin;
  rail.bin_size = sizeof rail_bin[0];
  wrc_accumulation step = sized<wrc_accumulation>();
  step.duration = 1e-3;
  step.distance = 1.011;
  for (int k = 0; k < 2; ++k) {
    wrc_damage_totals totals{};
    hash.add(wrc_contact_accumulate(contact, &step, &wheel[k], &rail, &totals));
    for (int k2 = 0; k2 < WRC_DAMAGE_SUMS; ++k2) hash.add(totals.sum[k2]);
    hash.add(totals.largest_pressure);
    hash.add(totals.largest_traction);
  }
  hash.add(wrc_damage_merge(&wheel[0], &wheel[1]));
  double values[81];
  constexpr std::int32_t quantities = WRC_DAMAGE_SUMS + 2;
  for (std::int32_t q = 0; q < quantities; ++q) {
    const std::int32_t quantity = q < WRC_DAMAGE_SUMS ? q : WRC_DAMAGE_LARGEST_PRESSURE + q - WRC_DAMAGE_SUMS;
    hash.add(wrc_damage_values(&wheel[0], quantity, values));
    for (int k = 0; k < 61; ++k) hash.add(values[k]);
    hash.add(wrc_damage_values(&rail, quantity, values));
    for (double number : values) hash.add(number);
  }
}

void run_accumulation(wrc_contact* contact, Hash& hash) {
  for (double lateral : {0.0, 5.1e-3, 7e-3}) {
    hash.add(roll(contact, lateral));
    hash_accumulated(contact, hash);
  }
}

/// Four wheels over films of a rail, under friction that these give, with slip that turns round.
void run_films(wrc_contact* contact, Hash& hash) {
  for (const char* set : {"low adhesion", "low adhesion, layers"}) {
    wrc_surface_bin rail_bin[40] = {}, wheel_bin[24] = {};
    wrc_surface rail = wrc_surface_default(), wheel = wrc_surface_default();
    rail.count = 40;
    rail.length = 0.25;
    rail.bins = rail_bin;
    rail.bin_size = sizeof rail_bin[0];
    wheel.count = 24;
    wheel.length = 2.89 / 24;
    wheel.closed = 1;
    wheel.bins = wheel_bin;
    wheel.bin_size = sizeof wheel_bin[0];
    wrc_surface_laws laws = wrc_surface_laws_default();
    hash.add(wrc_surface_laws_use(&laws, set, nullptr, 0));
    for (int32_t quantity = 0; quantity < WRC_SURFACE_HEAT; ++quantity)
      hash.add(wrc_surface_add(&rail, quantity, 0.004, quantity, 10.0, nullptr, 0));
    for (int passing = 0; passing < 4; ++passing) {
      std::memset(wheel_bin, 0, sizeof wheel_bin);
      wrc_surface_passage passage = sized<wrc_surface_passage>();
      passage.rail_from = passage.rail_to = 0.5;
      wrc_planar_input input = wrc_planar_input_default();
      input.load.normal_force = 60e3;
      for (int k = 0; k < 20; ++k) {
        passage.rail_from = passage.rail_to;
        passage.wheel_from = passage.wheel_to;
        passage.rail_to += 0.4;
        passage.wheel_to += 0.4 - 0.02 * (k - 8);
        wrc_planar_output output = sized<wrc_planar_output>();
        hash.add(wrc_surface_friction(&rail, &wheel, &laws, &passage, nullptr, &input.friction, nullptr, 0));
        input.creepage.longitudinal = 0.05 * (k - 8);
        input.creepage.speed = 20.0;
        hash.add(wrc_planar_step(contact, &input, &output));
        passage.energy = output.forces.power * 0.02;
        hash.add(wrc_surface_pass(&rail, &wheel, &laws, &passage, nullptr, nullptr, 0));
        hash.add(wrc_surface_rest(&wheel, &laws, 0.02, nullptr, 0));
        for (double number : {input.friction.coefficient, input.friction.layer_yield,
                              input.friction.bulk.wheel, output.forces.fx})
          hash.add(number);
      }
    }
    double values[40];
    for (int32_t quantity = 0; quantity < WRC_SURFACE_QUANTITIES; ++quantity)
      for (int32_t book = 0; book < WRC_SURFACE_BOOKS; ++book) {
        hash.add(wrc_surface_values(&rail, quantity, book, values, nullptr, nullptr, 0));
        for (double number : values) hash.add(number);
      }
  }
}

void run_temperature(wrc_contact* contact, Hash& hash) {
  for (double lateral : {0.0, 5.1e-3, 7e-3}) {
    hash.add(roll(contact, lateral));
    wrc_bulk_temperatures bulk = wrc_bulk_temperatures_default();
    bulk.wheel = 80.0 + 1e3 * lateral;
    wrc_temperature found = sized<wrc_temperature>();
    hash.add(wrc_contact_temperature(contact, WRC_ALL_REGIONS, &bulk, &found));
    for (double number : {found.at_entry, found.rise, found.x, found.y, found.largest, found.mean_rise,
                          found.wheel_heat, found.rail_heat})
      hash.add(number);
    hash_field(contact, WRC_FIELD_TEMPERATURE_RISE, hash);
  }
}

void run_heated(wrc_contact* contact, Hash& hash) {
  for (double lateral : {0.0, 5.1e-3}) {
    wrc_planar_input input = wrc_planar_input_default();
    input.pose.lateral = lateral;
    input.load.normal_force = 90e3;
    input.creepage.longitudinal = 6e-3;
    input.creepage.spin = -0.4;
    input.creepage.speed = 55.0;
    input.friction.temperature_law = WRC_TEMPERATURE_LAW_LINEAR;
    input.friction.bulk.wheel = 80.0;
    wrc_planar_output output = sized<wrc_planar_output>();
    const int32_t status = wrc_planar_step(contact, &input, &output);
    hash_step(contact, status, output, true, hash);
  }
}

void run_stresses(wrc_contact* contact, Hash& hash) {
  const double depths[] = {0.0, 5e-4, 2e-3};
  for (double lateral : {0.0, 5.1e-3}) {
    hash.add(roll(contact, lateral));
    wrc_stress_peaks levels[3];
    wrc_stresses found = sized<wrc_stresses>();
    hash.add(wrc_contact_stresses(contact, WRC_ALL_REGIONS, lateral > 0.0 ? WRC_BODY_WHEEL : WRC_BODY_RAIL,
                                  depths, 3, levels, &found));
    const auto hash_peaks = [&](const wrc_stress_peaks& peaks) {
      for (const wrc_stress_peak& peak : {peaks.von_mises, peaks.shear, peaks.tension})
        for (double number : {peak.stress, peak.x, peak.y, peak.depth}) hash.add(number);
    };
    for (const wrc_stress_peaks& level : levels) hash_peaks(level);
    hash_peaks(found.surface);
    hash_peaks(found.below);
  }
}

void run_plain_numbers(wrc_contact*, Hash& hash) {
  wrc_coefficients c{};
  double ratio = 1e-3;
  for (int i = 0; i < 228; ++i, ratio *= 1.0625) {  // up to 1e3
    for (double psi : {-0.95, -0.4, 0.0, 0.1, 0.7}) {
      hash.add(wrc_linear_coefficients(ratio, psi, ratio < 1.0 ? 0.25 : 0.31, &c));
      for (double number : {c.c11, c.c22, c.c23, c.c11s, c.c13s, c.c22s, c.c23s}) hash.add(number);
    }
  }
  for (int i = 0; i <= 64; ++i) {
    double load_factor = 0.0;
    hash.add(wrc_shakedown_limit(10.0 * i / 64.0 * i / 64.0, &load_factor));
    hash.add(load_factor);
  }
}

void add_forces(const wrc_wrench& wrench, Hash& hash) {
  for (const double* each : {wrench.force, wrench.moment, wrench.rail_moment})
    for (int k = 0; k < 3; ++k) hash.add(each[k]);
}

/// Columns of derivatives that all groups have; those behind them are in a group of their own.
constexpr int by_the_first = WRC_BY_ANGLE + 1;

void add_derivatives(const wrc_wrench_derivatives& found, int columns, Hash& hash) {
  for (const auto& row : found.wrench)
    for (int k = 0; k < columns; ++k) hash.add(row[k]);
}

/// Wheels on rails, both sides of one model.
void run_wheels(wrc_contact* right, wrc_contact* left, Hash& hash) {
  Numbers numbers(7);
  for (int i = 0; i < 40; ++i) {
    const wrc_wheel_input input = wheel_on_rail(i, numbers);
    wrc_contact* const contact = i % 2 == 0 ? right : left;
    wrc_wrench wrench = sized<wrc_wrench>();
    hash.add(wrc_contact_wrench(contact, &input, &wrench));
    add_forces(wrench, hash);
    for (double number : {wrench.z, wrench.normal_force, wrench.area, wrench.peak_pressure, wrench.power,
                          wrench.steepest_angle})
      hash.add(number);
    for (int32_t k = 0; k < wrench.region_count; ++k) {
      wrc_region region = sized<wrc_region>();
      hash.add(wrc_contact_region(contact, k, &region));
      for (double number : {region.point[0], region.point[1], region.y_wheel, region.z_rail, region.angle,
                            region.force[1], region.moment[2], region.power, region.creepage.longitudinal})
        hash.add(number);
    }
  }
}

/// What is asked of their regions.
/// Fields of a wheel's region, strip by strip in a row of cells; values over strips overwrite the first of
/// those before, and the rest is added once more.
void hash_region_fields(wrc_contact* contact, int32_t index, const wrc_region& region, Hash& hash) {
  constexpr int32_t fields[] = {WRC_FIELD_X,
                                WRC_FIELD_PRESSURE,
                                WRC_FIELD_TRACTION_X,
                                WRC_FIELD_TRACTION_Y,
                                WRC_FIELD_SLIP_X,
                                WRC_FIELD_SLIP_Y,
                                WRC_FIELD_POWER_DENSITY,
                                WRC_FIELD_FATIGUE_INDEX,
                                WRC_FIELD_STRIP_Y,
                                WRC_FIELD_STRIP_WIDTH,
                                WRC_FIELD_STRIP_CENTRE,
                                WRC_FIELD_STRIP_HALF_LENGTH,
                                WRC_FIELD_STRIP_PEAK,
                                WRC_FIELD_STRIP_POWER,
                                WRC_FIELD_STRIP_FRICTION,
                                WRC_FIELD_STRIP_PROFILE_Y,
                                WRC_FIELD_STRIP_PROFILE_Z,
                                WRC_FIELD_STRIP_ANGLE};
  const auto strips = static_cast<std::size_t>(region.strip_count);
  std::vector<double> values(strips * static_cast<std::size_t>(region.cell_count));
  for (const int32_t field : fields) {
    const FieldValues found = field_values(contact, index, field);
    hash.add(found.status);
    if (found.status >= WRC_OK)
      for (std::size_t i = 0; i < found.cells; ++i)
        for (std::size_t j = 0; j < strips; ++j) values[i * strips + j] = found.at(i, j);
    for (const double value : values) hash.add(value);
  }
}

void run_wheel_regions(wrc_contact* right, wrc_contact* left, Hash& hash) {
  Numbers numbers(7);
  for (int i = 0; i < 24; ++i) {
    const wrc_wheel_input input = wheel_on_rail(i, numbers);
    wrc_contact* const contact = i % 2 == 0 ? right : left;
    wrc_wrench wrench = sized<wrc_wrench>();
    hash.add(wrc_contact_wrench(contact, &input, &wrench));
    for (int32_t k = 0; k < wrench.region_count; ++k) {
      wrc_region region = sized<wrc_region>();
      wrc_damage damage{};
      const int32_t status = wrc_contact_region(contact, k, &region);
      hash.add(WRC_OK);
      hash.add(status);  // of its ellipse
      hash.add(wrc_contact_damage(contact, k, &damage));
      const wrc_ellipse& ellipse = region.ellipse;
      for (double number : {ellipse.a, ellipse.b, ellipse.psi, ellipse.y, ellipse.normal_force})
        hash.add(number);
      hash_damage(damage, hash);
      hash_region_fields(contact, k, region, hash);
    }
  }
}

/// With a greased flange, which the zones on it follow.
void run_greased_wheels(wrc_contact* right, wrc_contact* left, Hash& hash) {
  static constexpr double zone_y[] = {-0.05, -0.03, -0.01, 0.01}, zone_coefficient[] = {0.08, 0.12, 0.4, 0.3};
  Numbers numbers(7);
  for (int i = 0; i < 24; ++i) {
    wrc_wheel_input input = wheel_on_rail(i, numbers);
    input.friction.zone_count = 4;
    input.friction.zone_y = zone_y;
    input.friction.zone_coefficients = zone_coefficient;
    input.friction.zone_frame = WRC_ZONES_WHEEL_PROFILE;
    wrc_contact* const contact = i % 2 == 0 ? right : left;
    wrc_wrench wrench = sized<wrc_wrench>();
    hash.add(wrc_contact_wrench(contact, &input, &wrench));
    add_forces(wrench, hash);
    hash.add(wrench.power);
    if (i % 3 != 0) continue;
    wrc_wrench_derivatives found = sized<wrc_wrench_derivatives>();
    hash.add(wrc_contact_wrench_derivatives(contact, &input, nullptr, &found));
    add_derivatives(found, by_the_first, hash);
  }
}

/// Wrenches over films in rows of rail and wheel, without and with layers, and the passages.
void run_film_rows(wrc_contact* right, wrc_contact* left, Hash& hash) {
  constexpr uint32_t count = 6, rows = 12;
  for (const char* set : {"low adhesion", "low adhesion, layers"}) {
    wrc_surface_bin bins[2][count * rows] = {};
    wrc_surface surface[2] = {wrc_surface_default(), wrc_surface_default()};
    double across[WRC_FILM_NUMBERS(rows, rows)], values[count * rows];
    wrc_surface_laws laws = wrc_surface_laws_default();
    hash.add(wrc_surface_laws_use(&laws, set, nullptr, 0));
    for (int body = 0; body < 2; ++body) {
      surface[body].count = count;
      surface[body].rows = rows;
      surface[body].length = surface[body].closed = 1;
      surface[body].width = 6e-3;
      surface[body].row_first = -44e-3;
      surface[body].bins = bins[body];
      surface[body].bin_size = sizeof bins[body][0];
      for (uint32_t row = 0; row < rows; ++row) {
        wrc_surface one = surface[body];
        one.rows = 0;
        one.bins += static_cast<std::size_t>(row) * count;
        hash.add(wrc_surface_add(&one, static_cast<int32_t>(row + 2) % 5, 0.004, 0.3 * row, 6.0, nullptr, 0));
      }
    }
    Numbers numbers(11);
    for (int i = 0; i < 16; ++i) {
      wrc_wheel_input input = wheel_on_rail(i, numbers);
      wrc_contact* const contact = i % 2 == 0 ? right : left;
      const wrc_friction base = input.friction;
      wrc_surface_passage passage = sized<wrc_surface_passage>();
      passage.rail_from = passage.wheel_from = 0.3 * i;
      passage.rail_to = passage.wheel_to = 0.3 * i + 0.5;
      passage.film_rows = across;
      passage.film_numbers = static_cast<uint32_t>(std::size(across));
      passage.contact = contact;
      hash.add(wrc_surface_friction(&surface[0], &surface[1], &laws, &passage, &base, &input.friction,
                                    nullptr, 0));
      wrc_wrench wrench = sized<wrc_wrench>();
      wrc_wrench_derivatives found = sized<wrc_wrench_derivatives>();
      hash.add(wrc_contact_wrench_derivatives(contact, &input, &wrench, &found));
      add_forces(wrench, hash);
      add_derivatives(found, by_the_first, hash);
      passage.energy = std::max(0.0, wrench.power) * 0.01;
      hash.add(wrc_surface_pass(&surface[0], &surface[1], &laws, &passage, nullptr, nullptr, 0));
    }
    for (const wrc_surface& each : surface)
      for (int32_t quantity = 0; quantity < WRC_SURFACE_QUANTITIES; ++quantity) {
        hash.add(wrc_surface_values(&each, quantity, WRC_SURFACE_AMOUNT, values, nullptr, nullptr, 0));
        for (double number : values) hash.add(number);
      }
  }
}

/// Whose friction falls with the temperature it makes, and by the speed laws in turn with the sliding speed.
void run_heated_wheels(bool by_speed, wrc_contact* right, wrc_contact* left, Hash& hash) {
  Numbers numbers(7);
  for (int i = 0; i < 24; ++i) {
    wrc_wheel_input input = wheel_on_rail(i, numbers);
    if (input.friction.coefficient > 0.0) input.friction.temperature_law = WRC_TEMPERATURE_LAW_LINEAR;
    if (by_speed) input.friction.speed_law = i % 4 < 2 ? WRC_SPEED_LAW_EXPONENTIAL : WRC_SPEED_LAW_HYPERBOLIC;
    wrc_contact* const contact = i % 2 == 0 ? right : left;
    wrc_wrench wrench = sized<wrc_wrench>();
    hash.add(wrc_contact_wrench(contact, &input, &wrench));
    add_forces(wrench, hash);
    hash.add(wrench.power);
    wrc_temperature temperature = sized<wrc_temperature>();
    hash.add(wrc_contact_temperature(contact, 0, nullptr, &temperature));
    for (double number : {temperature.rise, temperature.x, temperature.y, temperature.mean_rise,
                          temperature.wheel_heat, temperature.rail_heat})
      hash.add(number);
    if (i % 3 != 0) continue;
    wrc_wrench_derivatives found = sized<wrc_wrench_derivatives>();
    hash.add(wrc_contact_wrench_derivatives(contact, &input, nullptr, &found));
    add_derivatives(found, by_the_first, hash);
  }
}

/// What they do to the bodies.
void run_wheel_accumulation(wrc_contact* right, wrc_contact* left, Hash& hash) {
  Numbers numbers(7);
  for (int i = 0; i < 16; ++i) {
    const wrc_wheel_input input = wheel_on_rail(i, numbers);
    wrc_contact* const contact = i % 2 == 0 ? right : left;
    hash.add(wrc_contact_wrench(contact, &input, nullptr));
    hash_accumulated(contact, hash);
  }
}

/// Their derivatives.
void run_wheel_derivatives(wrc_contact* right, wrc_contact* left, Hash& hash) {
  Numbers numbers(7);
  for (int i = 0; i < 40; ++i) {
    const wrc_wheel_input input = wheel_on_rail(i, numbers);
    wrc_wrench_derivatives found = sized<wrc_wrench_derivatives>();
    hash.add(wrc_contact_wrench_derivatives(i % 2 == 0 ? right : left, &input, nullptr, &found));
    add_derivatives(found, by_the_first, hash);
    for (int k = 0; k < by_the_first; ++k) hash.add(found.z[k]);
  }
}

/// A wrench's forces and sums, with its derivatives where they are wanted.
void add_wrench(wrc_contact* contact, const wrc_wheel_input& input, bool derivatives, Hash& hash) {
  wrc_wrench wrench = sized<wrc_wrench>();
  wrc_wrench_derivatives found = sized<wrc_wrench_derivatives>();
  hash.add(derivatives ? wrc_contact_wrench_derivatives(contact, &input, &wrench, &found)
                       : wrc_contact_wrench(contact, &input, &wrench));
  add_forces(wrench, hash);
  for (double number : {wrench.z, wrench.normal_force, wrench.area, wrench.power, wrench.steepest_angle})
    hash.add(number);
  add_derivatives(found, by_the_first, hash);
}

/// Wheels with a flat on rails that change along the track, and derivatives by that.
void run_along_track(wrc_contact* right, wrc_contact* left, Hash& hash) {
  Numbers numbers(8);
  for (int i = 0; i < 30; ++i) {
    wrc_wheel_input input = wheel_on_rail(i, numbers);
    input.distance = numbers.between(-0.2, 4.2);
    input.angle = numbers.between(-0.3, 0.3);
    const double fallen = input.distance - 1.0;
    if (input.prescribed == WRC_PRESCRIBE_HEIGHT && fallen > 0.0)
      input.wheel.z += fallen < 2.0 ? 0.004 * fallen : 0.008;
    add_wrench(i % 2 == 0 ? right : left, input, i % 3 == 0, hash);
  }
}

/// Wheels on rollers, seen from frames that move, and derivatives.
void run_rollers(wrc_contact* right, wrc_contact* left, Hash& hash) {
  Numbers numbers(9);
  for (int i = 0; i < 30; ++i) {
    wrc_wheel_input input = wheel_on_rail(i, numbers);
    input.start = i % 4 == 0 ? WRC_START_WARM : WRC_START_COLD;
    input.distance = numbers.between(-5e-3, 5e-3);
    input.roller_rate = -input.wheel.angular_velocity[1] * numbers.between(0.99, 1.01);
    input.frame.speed = i % 2 == 0 ? 0.0 : numbers.between(-2.0, 2.0);
    input.frame.curvature = numbers.between(-0.01, 0.01);
    input.frame.vertical_curvature = numbers.between(-1e-3, 1e-3);
    input.frame.twist = numbers.between(-0.01, 0.01);
    input.wheel.velocity[0] = -input.frame.speed;
    add_wrench(i % 2 == 0 ? right : left, input, i % 3 == 0, hash);
  }
}

/// Wheels whose turning is given by rates, on rails that run aslant, and all derivatives.
void run_aslant(wrc_contact* right, wrc_contact* left, Hash& hash) {
  Numbers numbers(12);
  for (int i = 0; i < 24; ++i) {
    wrc_wheel_input input = wheel_on_rail(i, numbers);
    wrc_wheel_state& wheel = input.wheel;
    wheel.angular_axes = WRC_AXES_NONE;
    wheel.roll_rate = std::exchange(wheel.angular_velocity[0], 0.0);
    wheel.pitch_rate = std::exchange(wheel.angular_velocity[1], 0.0);
    wheel.yaw_rate = std::exchange(wheel.angular_velocity[2], 0.0);
    input.rail.y_slope = numbers.between(-0.01, 0.01);
    input.rail.z_slope = i % 2 == 0 ? 0.0 : numbers.between(-0.01, 0.01);
    add_wrench(i % 2 == 0 ? right : left, input, false, hash);
    wrc_wrench_derivatives found = sized<wrc_wrench_derivatives>();
    hash.add(wrc_contact_wrench_derivatives(i % 2 == 0 ? right : left, &input, nullptr, &found));
    add_derivatives(found, WRC_BY_TIME_STEP, hash);
  }
}

/// Wheels that remember: from rest, rolling either way, slowly and fast, trials and committed steps.
void run_remembering(wrc_contact* right, wrc_contact* left, Hash& hash) {
  Numbers numbers(13);
  for (wrc_contact* const contact : {right, left})
    for (int i = 0; i < 40; ++i) {
      wrc_wheel_input input = wrc_wheel_input_default();
      input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
      input.vertical_load = numbers.between(60e3, 80e3);
      input.wheel.y = (contact == right ? 1.0 : -1.0) * (i < 25 ? 3e-5 * i : -6.1e-3);
      input.wheel.yaw = 2e-3;
      const double speed = i < 5 ? 0.0 : numbers.between(-1.0, 1.0);
      input.wheel.velocity[0] = speed + numbers.between(-1e-3, 1e-3);
      input.wheel.velocity[1] = numbers.between(-1e-3, 1e-3);
      input.wheel.pitch_rate = -speed / 0.46;
      input.wheel.yaw_rate = numbers.between(-0.1, 0.1);
      input.time_step = numbers.between(0.0, i % 7 == 6 ? 0.1 : 5e-3);
      add_wrench(contact, input, false, hash);
      if (i % 4 == 0) {
        wrc_wrench_derivatives found = sized<wrc_wrench_derivatives>();
        hash.add(wrc_contact_wrench_derivatives(contact, &input, nullptr, &found));
        add_derivatives(found, WRC_WRENCH_INPUTS, hash);
      }
      if (i % 3 != 2) hash.add(wrc_contact_commit(contact));
    }
}

/// Wheels against check rails and beside them.
void run_check_rails(wrc_contact* right, wrc_contact* left, Hash& hash) {
  Numbers numbers(11);
  for (int i = 0; i < 24; ++i) {
    wrc_wheel_input input = wheel_on_rail(i, numbers);
    input.wheel.reference = WRC_REFERENCE_WHEELSET;
    input.wheel.y = (i % 2 == 0 ? -1.0 : 1.0) * numbers.between(2e-3, 6e-3);
    wrc_contact* const contact = i % 2 == 0 ? right : left;
    wrc_wrench wrench = sized<wrc_wrench>();
    hash.add(wrc_contact_wrench(contact, &input, &wrench));
    add_forces(wrench, hash);
    for (int32_t k = 0; k < wrench.region_count; ++k) {
      wrc_region region = sized<wrc_region>();
      hash.add(wrc_contact_region(contact, k, &region));
      hash.add(region.surface);
      hash.add(region.normal_force);
    }
  }
}

/// Statuses and zeroed outputs of what cannot be done, and that the contact works as before afterwards.
void run_refused(wrc_contact* contact, Hash& hash) {
  wrc_planar_input input = wrc_planar_input_default();
  wrc_planar_output output = sized<wrc_planar_output>();
  input.load.normal_force = 80e3;
  const auto refused = [&](double& number, double wrong) {
    const double kept = number;
    number = wrong;
    hash.add(wrc_planar_step(contact, &input, &output));
    hash_normal(output.normal, hash);
    hash_forces(output.forces, hash);
    number = kept;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (double* number : {&input.pose.lateral, &input.pose.yaw, &input.load.normal_force,
                         &input.creepage.longitudinal, &input.creepage.spin, &input.friction.coefficient}) {
    for (double wrong : {nan, inf, -inf, 1e300}) refused(*number, wrong);
  }
  refused(input.load.normal_force, 80.0);
  hash.add(roll(contact, 1e-3));
  hash_fields(contact, hash);
}

}  // namespace

wrc_wheel_input wheel_on_rail(int i, Numbers& numbers) {
  wrc_wheel_input input = wrc_wheel_input_default();
  wrc_wheel_state& wheel = input.wheel;
  wheel.reference = i % 3 == 0 ? WRC_REFERENCE_WHEEL : WRC_REFERENCE_WHEELSET;
  wheel.angular_axes = i % 5 == 0 ? WRC_AXES_TRACK : WRC_AXES_BODY;
  const double outward = i % 2 == 0 ? 1.0 : -1.0;
  wheel.y = outward * numbers.between(-6e-3, 6.9e-3);
  wheel.z = numbers.between(-0.3e-3, 0.4e-3);
  wheel.roll = numbers.between(-0.2e-3, 0.2e-3);
  wheel.yaw = numbers.between(-0.02, 0.02);
  const double speed = i % 8 == 0 ? 0.0 : numbers.between(-60.0, 60.0);
  wheel.velocity[0] = speed;
  wheel.velocity[1] = numbers.between(-0.1, 0.1);
  wheel.velocity[2] = numbers.between(-0.05, 0.05);
  wheel.angular_velocity[0] = numbers.between(-0.1, 0.1);
  wheel.angular_velocity[1] = -speed / numbers.between(0.457, 0.463);
  wheel.angular_velocity[2] = numbers.between(-0.1, 0.1);
  wrc_rail_state rail = sized<wrc_rail_state>();
  rail.y = numbers.between(-1e-3, 1e-3);
  rail.roll = numbers.between(-5e-3, 5e-3);
  rail.z_velocity = numbers.between(-0.05, 0.05);
  if (i % 4 != 0) input.rail = rail;
  if (i % 6 == 0) input.friction.coefficient = 0.0;
  if (i % 7 == 3) {
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = numbers.between(2e4, 1.2e5);
  } else {
    input.damping = numbers.between(0.0, 0.3);
  }
  return input;
}

void add_plain_calls(Plan& plan) {
  const std::size_t model = plan.models.size();
  wrc_config& config = plan.models.emplace_back(test_config());
  config.wheel = plan.profiles[0];
  config.rail = plan.profiles[1];
  plan.jobs.push_back({"geometry", model, {}, run_geometry});
  plan.jobs.push_back({"motion", model, {}, run_motion});
  plan.jobs.push_back({"wear", model, {}, run_wear});
  plan.jobs.push_back({"friction over temperature", model, {}, run_heated});
  plan.jobs.push_back({"stresses", model, {}, run_stresses});
  plan.jobs.push_back({"damage along the line", model, {}, run_accumulation});
  plan.jobs.push_back({"films on rail and wheel", model, {}, run_films});
  plan.jobs.push_back({"temperature", model, {}, run_temperature});
  plan.jobs.push_back({"plain numbers", model, {}, run_plain_numbers});
  plan.jobs.push_back({"refused input", model, {}, run_refused});
  plan.jobs.push_back({"standstill", model, {}, run_standstill});
  plan.jobs.push_back({"wheel on rail", model, {}, {}, run_wheels});
  plan.jobs.push_back({"wheel on rail, regions", model, {}, {}, run_wheel_regions});
  for (const bool by_speed : {false, true}) {
    plan.jobs.push_back({by_speed ? "friction factors" : "wheel on rail, friction over temperature",
                         model,
                         {},
                         {},
                         [by_speed](wrc_contact* right, wrc_contact* left, Hash& hash) {
                           run_heated_wheels(by_speed, right, left, hash);
                         }});
  }
  plan.jobs.push_back({"wheel on rail, zones on the wheel", model, {}, {}, run_greased_wheels});
  plan.jobs.push_back({"wheel on rail, films in rows", model, {}, {}, run_film_rows});
  plan.jobs.push_back({"wheel on rail, damage along the line", model, {}, {}, run_wheel_accumulation});
  plan.jobs.push_back({"wheel on rail, derivatives", model, {}, {}, run_wheel_derivatives});
  plan.jobs.push_back({"wheel on rail, aslant", model, {}, {}, run_aslant});

  static const AlongTrackBodies bodies;
  const std::size_t varying = plan.models.size();
  wrc_config& along = plan.models.emplace_back(test_config());
  along.wheel.kind = WRC_PROFILE_S1002;
  along.rail.kind = WRC_PROFILE_60E1;
  along.track.rail_inclination = 0.025;
  bodies.give(along);
  plan.jobs.push_back({"along the track", varying, {}, {}, run_along_track});

  const std::size_t remembering = plan.models.size();
  wrc_config& memory = plan.models.emplace_back(test_config());
  memory.wheel = plan.profiles[0];
  memory.rail = plan.profiles[1];
  memory.surface.memory = 1;
  plan.jobs.push_back({"wheel on rail, with memory", remembering, {}, {}, run_remembering});

  const std::size_t rolling = plan.models.size();
  wrc_config& rollers = plan.models.emplace_back(test_config());
  rollers.wheel = plan.profiles[0];
  rollers.rail = plan.profiles[1];
  rollers.roller_curvature = 2.0;
  plan.jobs.push_back({"rollers", rolling, {}, {}, run_rollers});
  const auto add_methods = [&plan](int32_t normal, int32_t tangential) {
    wrc_config& other = plan.models.emplace_back(test_config());
    other.wheel = plan.profiles[0];
    other.rail = plan.profiles[1];
    other.normal.method = normal;
    choose_tangential(other, tangential);
    other.planar.strips = 28;
    other.planar.cells = other.surface.cells = 16;
    const bool of_normal = tangential == preset_strip_fastsim;
    plan.jobs.push_back(
        {of_normal ? "wheel on rail, other normal methods" : "wheel on rail, other ways to roll",
         plan.models.size() - 1,
         {},
         {},
         run_wheels});
  };
  for (int32_t normal = 0; normal < WRC_NORMAL_STRIP_HALFSPACE; ++normal)
    add_methods(normal, preset_strip_fastsim);
  for (int32_t tangential = 0; tangential < tangential_methods; ++tangential)
    if (tangential != preset_strip_fastsim) add_methods(WRC_NORMAL_STRIP_HALFSPACE, tangential);

  const std::size_t guided = plan.models.size();
  wrc_config& check_rail = plan.models.emplace_back(test_config());
  check_rail.wheel = plan.profiles[0];
  check_rail.rail = plan.profiles[1];
  static const CheckRailPoints points;
  check_rail.check_rail.profile = points.profile();
  check_rail.check_rail.y = -0.0813;
  check_rail.check_rail.z = -0.02;
  plan.jobs.push_back({"check rails", guided, {}, {}, run_check_rails});
}

Plan golden_plan() {
  Plan plan;
  add_poses(plan);
  add_host_data(plan);
  add_laws(plan);
  add_plain_calls(plan);
  add_exact(plan);
  return plan;
}
