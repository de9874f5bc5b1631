#include "random_patch.hpp"

#include <cmath>
#include <stdexcept>

#include "field_values.hpp"
#include "patch/material.hpp"
#include "random.hpp"
#include "test_config.hpp"
#include "theory/sdec.hpp"
#include "wrc/wrc_planar.h"

namespace wrc::calibration {
namespace {

/// Fills shape, load and strips where the contact has one patch; leaves the strips empty where it has not.
void press_wheel_on_rail(double shift, double yaw, double load, Patch& p) {
  wrc_config config = test_config();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  config.wheel_material.shear_modulus = config.rail_material.shear_modulus = p.shear_modulus;
  config.wheel_material.poisson = config.rail_material.poisson = p.poisson;
  config.planar.strips = 48;
  wrc_model* model = nullptr;
  wrc_contact* contact = nullptr;
  if (wrc_model_create(&config, nullptr, &model, nullptr, 0) < 0 ||
      wrc_contact_create(model, WRC_SIDE_RIGHT, nullptr, &contact, nullptr, 0) < 0) {
    throw std::runtime_error("the wheel on the rail cannot be made");
  }
  wrc_planar_pose pose = sized<wrc_planar_pose>();
  pose.lateral = shift;
  pose.yaw = yaw;
  wrc_planar_load press = wrc_planar_load_default();
  press.normal_force = load;
  wrc_planar_normal_solution normal{};
  const bool solved = wrc_planar_geometry(contact, &pose, nullptr) == WRC_OK &&
                      wrc_planar_normal(contact, nullptr, &press, &normal) == WRC_OK;
  if (solved && normal.patch_count == 1) {
    p.a = normal.ellipse.a;
    p.b = normal.ellipse.b;
    p.psi = normal.ellipse.psi;
    p.p0 = normal.peak_pressure;
    p.normal_force = normal.normal_force;
    const auto field = [&](std::int32_t id) { return field_values(contact, 0, id); };
    const FieldValues y = field(WRC_FIELD_STRIP_Y), width = field(WRC_FIELD_STRIP_WIDTH),
                      centre = field(WRC_FIELD_STRIP_CENTRE), half = field(WRC_FIELD_STRIP_HALF_LENGTH),
                      peak = field(WRC_FIELD_STRIP_PEAK);
    for (std::size_t j = 0; j < y.strips; ++j)
      p.strips.push_back({y[j], width[j], centre[j], half[j], peak[j]});
  }
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
}

struct Direction {
  double x, y, spin;
};

Direction random_direction(Random& random) {
  const double spin = random.uniform(-1.0, 1.0), angle = random.uniform(0.0, 2.0 * pi);
  const double kind = random.uniform(0.0, 1.0);
  if (kind < 0.2) return {std::cos(angle), std::sin(angle), 0.0};
  if (kind < 0.45) return {0.0, 0.0, spin < 0.0 ? -1.0 : 1.0};
  const double rest = std::sqrt(1.0 - spin * spin);
  const Direction anywhere{rest * std::cos(angle), rest * std::sin(angle), spin};
  if (kind < 0.6 && anywhere.y * spin > 0.0) return {anywhere.x, -anywhere.y, spin};
  return anywhere;
}

/// Draws the creepages of a patch whose material, shape, friction and load are set.
void roll(Patch& p, Random& random) {
  const double ratio = p.a / p.b, c = std::sqrt(p.a * p.b);
  Fault fault;
  const theory::SdecCoefficients linear = theory::SdecTable(p.poisson).at(ratio, p.psi, fault);
  const double level = std::sqrt(random.logarithmic(0.05, 6.0) * random.logarithmic(0.05, 6.0));
  const double unit = level * p.friction * p.normal_force / (p.shear_modulus * c * c);
  const Direction to = random_direction(random);
  p.creepage = {to.x * unit / linear.c11, to.y * unit / linear.c22, to.spin * unit / (linear.c23 * c)};
}

}  // namespace

Patch random_sdec(std::uint64_t seed, std::uint64_t row) {
  Random random(seed, row);
  Patch p{};
  const double ratio = random.logarithmic(0.25, 3.0), c = random.uniform(3e-3, 8e-3);
  p.a = c * std::sqrt(ratio);
  p.b = c / std::sqrt(ratio);
  p.psi = random.uniform(-0.7, 0.7);
  p.poisson = random.uniform(0.25, 0.30);
  p.shear_modulus = 80e9;
  p.friction = random.uniform(0.1, 0.5);
  p.p0 = random.uniform(0.5e9, 1.8e9);
  p.normal_force = 2.0 / 3.0 * pi * p.a * p.b * p.p0;
  roll(p, random);
  return p;
}

Patch random_wheel_on_rail(std::uint64_t seed, std::uint64_t row) {
  Random random(seed, row);
  Patch p{};
  p.shear_modulus = 80e9;
  p.poisson = random.uniform(0.25, 0.30);
  p.friction = random.uniform(0.1, 0.5);
  while (p.strips.size() == 0) {
    const double shift = random.uniform(-6e-3, 5e-3), yaw = random.uniform(-15e-3, 15e-3);
    const double load = random.uniform(25e3, 125e3);
    press_wheel_on_rail(shift, yaw, load, p);
  }
  roll(p, random);
  return p;
}

}  // namespace wrc::calibration
