/// Rolling that is not steady: contacts with memory against the exact solver over random sequences.
///
///   transient_report SEQUENCES SEED
///
/// Double ellipses and ellipses of all slendernesses from 1/2.2 to 2.2, friction, pressure and creepages up
/// to 1.4 times what saturates; from rest under constant creepages, or harmonic longitudinal creepage,
/// lateral creepage, spin, load, or all creepages at once, wave lengths of 3.5 to 42 half lengths. Errors of
/// (Fx, Fy) over friction times the load of the moment. The
/// three constants of src/tangential/methods/patch_memory.cpp are the best of a scan over 90 other sequences
/// of these kinds.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "test_config.hpp"
#include "wrc/wrc_offline.h"

namespace {

constexpr double pi = 3.14159265358979323846, shear_modulus = 82e9;
constexpr int cells = 16;  // of the exact solver on a half length

/// Uniform numbers, the same everywhere.
class Numbers {
 public:
  explicit Numbers(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  bool chance(double share) { return between(0.0, 1.0) < share; }
  double sign() { return chance(0.5) ? -1.0 : 1.0; }

 private:
  std::mt19937 engine_;
};

enum Kind { start, longitudinal, lateral, spin, load, all, kinds };

/// What one sequence goes through.
struct Sequence {
  Kind kind;
  wrc_ellipse shape;
  double poisson, friction, wave_length, load_amplitude;  ///< no waves: 0
  double mean[3], amplitude[3];                           ///< nu_x, nu_y, phi
  int steps;

  double step() const { return shape.a / cells; }
  double wave(double s) const { return wave_length > 0.0 ? std::sin(2.0 * pi * s / wave_length) : 0.0; }
  wrc_ellipse patch(double s) const {
    wrc_ellipse patch = shape;
    patch.normal_force *= 1.0 + load_amplitude * wave(s);
    const double scale = std::cbrt(patch.normal_force / shape.normal_force);
    patch.a *= scale;
    patch.b *= scale;
    return patch;
  }
  wrc_creepage creepage(double s) const {
    wrc_creepage c = wrc_creepage_default();
    c.longitudinal = mean[0] + amplitude[0] * wave(s);
    c.lateral = mean[1] + amplitude[1] * wave(s);
    c.spin = mean[2] + amplitude[2] * wave(s);
    return c;
  }
};

Sequence random_sequence(int number, Numbers& numbers) {
  Sequence q{};
  q.kind = static_cast<Kind>(number % kinds);
  q.shape = sized<wrc_ellipse>();
  q.shape.a = numbers.between(3.5e-3, 8e-3);
  q.shape.b = q.shape.a * std::exp(numbers.between(-1.0, 1.0) * std::log(2.2));
  q.shape.psi = q.kind < load && numbers.chance(0.3) ? numbers.between(-0.6, 0.6) : 0.0;
  q.poisson = numbers.between(0.25, 0.30);
  q.friction = numbers.between(0.2, 0.5);
  const double ab = q.shape.a * q.shape.b;
  q.shape.normal_force = 2.0 / 3.0 * pi * ab * numbers.between(600e6, 1300e6);
  // Creepages that saturate by linear theory, C about 4.3 and 1.6.
  const double saturating = q.friction * q.shape.normal_force / (shear_modulus * ab);
  const double scale[3] = {saturating / 4.3, saturating / 4.3, saturating / (1.6 * std::sqrt(ab))};
  const double waves = 3.5 * std::exp(numbers.between(0.0, std::log(12.0))), size = numbers.between(0.2, 1.4);
  q.wave_length = q.kind == start ? 0.0 : waves * q.shape.a;
  if (q.kind == start || q.kind == load) {
    const double angle = numbers.between(0.0, 2.0 * pi);
    q.mean[0] = size * scale[0] * std::cos(angle);
    q.mean[1] = size * scale[1] * std::sin(angle);
    if (numbers.chance(0.5)) q.mean[2] = scale[2] * numbers.between(-1.0, 1.0);
    if (q.kind == load) q.load_amplitude = 0.3;
  } else if (q.kind == all) {
    for (int k = 0; k < 3; ++k) {
      q.mean[k] = scale[k] * numbers.between(-0.6, 0.6);
      q.amplitude[k] = scale[k] * numbers.between(-0.7, 0.7);
    }
  } else {
    const int which = q.kind - longitudinal;
    q.amplitude[which] = numbers.sign() * size * scale[which];
    const int other = static_cast<int>(numbers.between(0.0, 3.0)) % 3;
    if (numbers.chance(0.5)) q.mean[other] = scale[other] * numbers.between(-0.8, 0.8);
  }
  q.steps = q.kind == start ? 70 : static_cast<int>(std::min(110.0, std::max(2.2 * waves, 6.0) * cells));
  return q;
}

/// The exact solver on a sequence.
class Exact {
 public:
  explicit Exact(const Sequence& q) : q_(q) {
    wrc_grid& grid = problem_.grid;
    const auto count = [&](double share) {
      return static_cast<uint32_t>(std::ceil(cells * share * std::cbrt(1.0 + q.load_amplitude) - 1e-6));
    };
    const uint32_t ahead = count(1.0), right = count(1.0 - q.shape.psi), left = count(1.0 + q.shape.psi);
    grid.nx = 2 * ahead;
    grid.ny = left + right;
    grid.dx = q.shape.a / cells;
    grid.dy = q.shape.b / cells;
    grid.x0 = -(ahead - 0.5) * grid.dx;
    grid.y0 = -(right - 0.5) * grid.dy;
    problem_.wheel_material.shear_modulus = problem_.rail_material.shear_modulus = shear_modulus;
    problem_.wheel_material.poisson = problem_.rail_material.poisson = q.poisson;
    problem_.coefficient = q.friction;
    pressure_.resize(std::size_t{grid.nx} * grid.ny);
    problem_.pressure = pressure_.data();
    if (wrc_exact_transient_create(&grid, &problem_.wheel_material, &problem_.rail_material, &bodies_,
                                   nullptr, 0) < 0)
      throw std::runtime_error("the exact solver refuses");
  }
  Exact(const Exact&) = delete;
  Exact& operator=(const Exact&) = delete;
  ~Exact() { wrc_exact_transient_destroy(bodies_); }

  wrc_exact_rolling_solution step(double s) {
    press(q_.patch(s));
    problem_.creepage = q_.creepage(s - 0.5 * q_.step());
    wrc_exact_rolling_solution solution = sized<wrc_exact_rolling_solution>();
    if (wrc_exact_transient_step(bodies_, &problem_, &solution, nullptr, 0) < 0)
      throw std::runtime_error("an exact step failed");
    return solution;
  }

 private:
  void press(const wrc_ellipse& patch) {
    const wrc_grid& grid = problem_.grid;
    double sum = 0.0;
    for (uint32_t j = 0, k = 0; j < grid.ny; ++j) {
      const double y = grid.y0 + j * grid.dy;
      const double eta = y / (patch.b * (1.0 + (y > 0.0 ? patch.psi : -patch.psi)));
      for (uint32_t i = 0; i < grid.nx; ++i, ++k) {
        const double xi = (grid.x0 + i * grid.dx) / patch.a;
        pressure_[k] = std::sqrt(std::max(0.0, 1.0 - xi * xi - eta * eta));
        sum += pressure_[k] * grid.dx * grid.dy;
      }
    }
    for (double& p : pressure_) p *= patch.normal_force / sum;
  }

  const Sequence& q_;
  wrc_exact_rolling_problem problem_ = of_the_papers_steel(wrc_exact_rolling_problem_default());
  wrc_exact_transient* bodies_ = nullptr;
  std::vector<double> pressure_;
};

/// Errors by what is looked at.
using Errors = std::map<std::string, std::vector<double>>;

void run(const Sequence& q, Errors& errors) {
  Exact exact(q);
  wrc_config config = test_config();
  config.wheel_material.shear_modulus = config.rail_material.shear_modulus = shear_modulus;
  config.wheel_material.poisson = config.rail_material.poisson = q.poisson;
  config.planar.non_steady = 1;
  wrc_model* model = nullptr;
  wrc_contact* contact = nullptr;
  if (wrc_model_create(&config, nullptr, &model, nullptr, 0) < 0 ||
      wrc_contact_create(model, WRC_SIDE_RIGHT, nullptr, &contact, nullptr, 0) < 0)
    throw std::runtime_error("no contact");
  wrc_friction friction = wrc_friction_default();
  friction.coefficient = q.friction;
  const double waves = q.wave_length / q.shape.a;
  const char* const group = q.kind == start ? "from rest"
                            : waves < 9.5   ? "waves under 9.5 a"
                                            : "waves over 9.5 a";
  for (int k = 1; k <= q.steps; ++k) {
    const double s = k * q.step();
    const wrc_exact_rolling_solution wanted = exact.step(s);
    const wrc_ellipse patch = q.patch(s);
    const wrc_creepage creepage = q.creepage(s - 0.5 * q.step());
    wrc_planar_forces forces{};
    wrc_planar_roll(contact, q.step());
    if (wrc_planar_tangential(contact, &patch, &creepage, &friction, &forces) < 0)
      throw std::runtime_error("a step of the contact failed");
    errors[group].push_back(std::hypot(forces.fx - wanted.fx, forces.fy - wanted.fy) /
                            (q.friction * patch.normal_force));
  }
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::fprintf(stderr, "usage: transient_report SEQUENCES SEED\n");
    return 2;
  }
  try {
    Numbers numbers(static_cast<unsigned>(std::strtoul(arguments[2], nullptr, 10)));
    Errors errors;
    const int sequences = std::atoi(arguments[1]);
    for (int k = 0; k < sequences; ++k) run(random_sequence(k, numbers), errors);
    std::printf("force over friction x load, %%        median      p95    worst      n\n");
    for (auto& [group, values] : errors) {
      std::sort(values.begin(), values.end());
      std::printf("%-32s %9.2f %8.2f %8.2f %6zu\n", group.c_str(), 100.0 * values[values.size() / 2],
                  100.0 * values[values.size() * 95 / 100], 100.0 * values.back(), values.size());
    }
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "transient_report: %s\n", error.what());
    return 1;
  }
}
