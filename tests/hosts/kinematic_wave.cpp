// The wave length of a free wheelset that rolls slowly, amplitude 1 mm: what a host finds with
// wrc_contact_wrench at 5 m/s.
//
//   kinematic_wave [exact [CELL]]      CELL of the exact solver [3e-4 m]
//
// Slow rolling leaves no inertia: at a lateral place and a yaw the wheelset's height, roll, turning, and its
// rates of lateral motion and yaw are those at which nothing is left of the forces. Prints the wave length
//  - of that motion, integrated, with the forces of wrc_contact_wrench;
//  - of the wave fitted to three poses of it, with these forces and, on request, with those of
//  wrc_exact_wrench;
//  - of Klingel's formula, from where the regions in contact lie on the wheels alone.
// Exit status 1 if the first and the second, or the second and exact forces, differ by more than 1.5 %.
#include <Eigen/Dense>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "test_config.hpp"
#include "wrc/wrc_offline.h"

namespace {

using Vector5 = Eigen::Matrix<double, 5, 1>;
using Matrix5 = Eigen::Matrix<double, 5, 5>;
using Eigen::Vector3d;

constexpr double load = 160e3, radius = 0.46, half_distance = 0.75, speed = 5.0, friction = 0.3,
                 amplitude = 1e-3;

// Height [m], roll [rad], turning over free rolling's [-], rates over distance of lateral place [-] and yaw
// [rad/m].
struct Rolling {
  Vector5 values = Vector5::Zero();
  double height() const { return values[0]; }
  double roll() const { return values[1]; }
  double lateral_rate() const { return values[3]; }
  double yaw_rate() const { return values[4]; }
};
const Vector5 scale = (Vector5() << 1e-5, 1e-5, 1e-4, 1e-4, 1e-4).finished();  // of a small change of them

class Wheelset {
 public:
  Wheelset() {
    wrc_config config = test_config();
    config.wheel.kind = WRC_PROFILE_S1002;
    config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
    char text[300];
    if (wrc_model_create(&config, nullptr, &model_, text, sizeof text) < 0) throw std::runtime_error(text);
    for (int side = 0; side < 2; ++side)
      if (wrc_contact_create(model_, side, nullptr, &contact_[side], text, sizeof text) < 0)
        throw std::runtime_error(text);
  }
  ~Wheelset() {
    for (auto* contact : contact_) wrc_contact_destroy(contact);
    wrc_model_destroy(model_);
  }
  Wheelset(const Wheelset&) = delete;
  Wheelset& operator=(const Wheelset&) = delete;

  double roll_rate = 0.0;                                   // roll over lateral place [rad/m]
  const wrc_exact_wrench_options* exact_options = nullptr;  // of left_over(..., true)

  // Standing in the middle.
  Rolling at_rest() {
    wrc_wheel_input input = wrc_wheel_input_default();
    input.friction.coefficient = 0.0;
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = 0.5 * load;
    wrc_wrench wrench = sized<wrc_wrench>();
    const int32_t status = wrc_contact_wrench(contact_[0], &input, &wrench);
    if (status != WRC_OK) throw std::runtime_error(wrc_status_name(status));
    Rolling rolling;
    rolling.values[0] = wrench.z;
    return rolling;
  }

  // Fy, Fz, and the moments about x, the axle and z that are left, N and N m.
  Vector5 left_over(double y, double yaw, const Rolling& rolling, bool exact) {
    const double cr = std::cos(rolling.roll()), sr = std::sin(rolling.roll());
    const Vector3d axle(-std::sin(yaw), cr * std::cos(yaw), sr * std::cos(yaw));
    wrc_wheel_input input = wrc_wheel_input_default();
    wrc_wheel_state& wheel = input.wheel;
    wheel.y = y;
    wheel.z = rolling.height();
    wheel.roll = rolling.roll();
    wheel.yaw = yaw;
    wheel.velocity[0] = speed;
    wheel.velocity[1] = speed * rolling.lateral_rate();
    wheel.roll_rate = speed * roll_rate * rolling.lateral_rate();
    wheel.pitch_rate = -speed * (1.0 + rolling.values[2]) / radius;
    wheel.yaw_rate = speed * rolling.yaw_rate();
    input.friction.coefficient = friction;
    Vector3d force(0, 0, load), moment(0, 0, 0);
    for (int side = 0; side < 2; ++side) {
      wrc_wrench wrench = sized<wrc_wrench>();
      const int32_t status = exact ? wrc_exact_wrench(contact_[side], &input, exact_options, &wrench)
                                   : wrc_contact_wrench(contact_[side], &input, &wrench);
      if (status != WRC_OK) throw std::runtime_error(wrc_status_name(status));
      force += Vector3d(wrench.force[0], wrench.force[1], wrench.force[2]);
      moment += Vector3d(wrench.moment[0], wrench.moment[1], wrench.moment[2]);
    }
    return {force[1], force[2], moment[0], moment.dot(axle), moment[2]};
  }

  // Right less left rolling radius, means over the load, by the creepages of the last wrc_contact_wrench [m].
  double radius_difference(const Rolling& rolling) {
    double difference = 0.0;
    for (int side = 0; side < 2; ++side) {
      wrc_region region = sized<wrc_region>();
      if (wrc_contact_region(contact_[side], 0, &region) < 0) throw std::runtime_error("no region");
      difference -= (side == 0 ? 1.0 : -1.0) * region.creepage.longitudinal;
    }
    return radius * (difference - 2.0 * half_distance * rolling.yaw_rate());
  }

  // What leaves nothing over, from a guess. Exact forces meet the slopes of the library's.
  Rolling solve(double y, double yaw, Rolling rolling, bool exact) {
    Matrix5 slopes;
    const Vector5 tolerance = (Vector5() << 2.0, 2.0, 2.0, 1.0, 2.0).finished() * (exact ? 1.0 : 1e-3);
    for (int iteration = 0; iteration < 12; ++iteration) {
      const Vector5 left = left_over(y, yaw, rolling, exact);
      if (exact)
        std::printf("  y %.2f mm, yaw %.3f mrad: %8.1f %8.1f N %8.1f %8.1f %8.1f N m left\n", 1e3 * y,
                    1e3 * yaw, left[0], left[1], left[2], left[3], left[4]);
      std::fflush(stdout);
      if ((left.cwiseAbs().array() < tolerance.array()).all()) return rolling;
      if (!exact || iteration == 0) {
        for (int k = 0; k < 5; ++k) {
          Rolling up = rolling, down = rolling;
          up.values[k] += 0.1 * scale[k];
          down.values[k] -= 0.1 * scale[k];
          slopes.col(k) = (left_over(y, yaw, up, false) - left_over(y, yaw, down, false)) / (0.2 * scale[k]);
        }
      }
      rolling.values -= slopes.fullPivLu().solve(left);
    }
    throw std::runtime_error("the forces do not vanish");
  }

 private:
  wrc_model* model_ = nullptr;
  wrc_contact* contact_[2] = {nullptr, nullptr};
};

// Of y'' = -g (k1 y + k3 y^3) from its amplitude: four times the quarter, y = amplitude sin(angle).
double wave_length(double g, double k1, double k3) {
  double sum = 0.0;
  const int steps = 200;
  for (int i = 0; i < steps; ++i) {
    const double s = std::sin(0.5 * M_PI * (i + 0.5) / steps);
    sum += 1.0 / std::sqrt(k1 + 0.5 * k3 * amplitude * amplitude * (1.0 + s * s));
  }
  return 4.0 / std::sqrt(g) * sum * 0.5 * M_PI / steps;
}

// Yaw's rate at the amplitude and half of it, and the lateral rate at a yaw in the middle.
double fitted(double rate_full, double rate_half, double lateral_rate, double yaw) {
  const double full = -rate_full / amplitude, half = -rate_half / (0.5 * amplitude);
  const double k3 = (full - half) / (0.75 * amplitude * amplitude), k1 = full - k3 * amplitude * amplitude;
  return wave_length(lateral_rate / yaw, k1, k3);
}

double three_poses(Wheelset& wheelset, const Rolling (&guess)[3], double yaw, bool exact) {
  const Rolling full = wheelset.solve(amplitude, 0.0, guess[0], exact);
  const Rolling half = wheelset.solve(0.5 * amplitude, 0.0, guess[1], exact);
  const Rolling middle = wheelset.solve(0.0, yaw, guess[2], exact);
  return fitted(full.yaw_rate(), half.yaw_rate(), middle.lateral_rate(), yaw);
}

// Half a wave, from the amplitude to where yaw comes back to zero: midpoint rule.
double integrated(Wheelset& wheelset, const Rolling& start) {
  double y = amplitude, yaw = 0.0, along = 0.0;
  const double step = 0.05;
  Rolling rolling = start;
  while (along < 20.0) {
    rolling = wheelset.solve(y, yaw, rolling, false);
    const double half_y = y + 0.5 * step * rolling.lateral_rate(),
                 half_yaw = yaw + 0.5 * step * rolling.yaw_rate();
    rolling = wheelset.solve(half_y, half_yaw, rolling, false);
    const double next = yaw + step * rolling.yaw_rate();
    if (next >= 0.0 && along > 0.0) return 2.0 * (along + step * yaw / (yaw - next));
    y += step * rolling.lateral_rate();
    yaw = next;
    along += step;
  }
  throw std::runtime_error("the wheelset does not come back");
}

int run(bool with_exact, double cell) {
  Wheelset wheelset;
  const Rolling rest = wheelset.at_rest();
  Rolling guess[3];
  double klingel_full = 0.0, klingel_half = 0.0;
  for (int round = 0; round < 2;
       ++round) {  // the second one takes how roll changes along the way from the first
    guess[2] = wheelset.solve(0.0, 0.0, rest, false);
    guess[1] = wheelset.solve(0.5 * amplitude, 0.0, guess[2], false);
    klingel_half = wheelset.radius_difference(guess[1]);
    guess[0] = wheelset.solve(amplitude, 0.0, guess[1], false);
    klingel_full = wheelset.radius_difference(guess[0]);
    wheelset.roll_rate = guess[1].roll() / (0.5 * amplitude);
  }
  const double yaw = 0.7 * amplitude;
  guess[2] = wheelset.solve(0.0, yaw, guess[2], false);
  const double along = integrated(wheelset, guess[0]);
  const double three = three_poses(wheelset, guess, yaw, false);
  const double shape = 2.0 * half_distance * radius;
  const double klingel = fitted(-klingel_full / shape, -klingel_half / shape, yaw, yaw);
  std::printf(
      "wave length at 1 mm: %.3f m integrated, %.3f m from three poses, %.3f m by rolling radii (%+.2f %%)\n",
      along, three, klingel, 100.0 * (klingel / along - 1.0));
  bool good = std::fabs(three / along - 1.0) < 0.015;
  if (with_exact) {
    wrc_exact_wrench_options options = wrc_exact_wrench_options_default();
    options.cell_x = options.cell_s = cell;
    wheelset.exact_options = &options;
    const double exact = three_poses(wheelset, guess, yaw, true);
    std::printf(
        "wave length with exact forces, from three poses, cells of %.2f mm: %.3f m; wrc_contact_wrench %+.2f "
        "%%\n",
        1e3 * cell, exact, 100.0 * (three / exact - 1.0));
    good = good && std::fabs(three / exact - 1.0) < 0.015;
  }
  return good ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
  const bool exact = count > 1 && std::strcmp(words[1], "exact") == 0;
  if (count > 1 && !exact) {
    std::fprintf(stderr, "kinematic_wave [exact [CELL]]\n");
    return 2;
  }
  try {
    return run(exact, count > 2 ? std::atof(words[2]) : 3e-4);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
