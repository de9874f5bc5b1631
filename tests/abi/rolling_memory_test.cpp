/// config.planar.non_steady and wrc_planar_roll(): forces that remember, through the shared library.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "test_config.hpp"
#include "wrc/wrc_offline.h"

namespace {

/// Of a plane that remembers, with S1002 on UIC60, for poses.
wrc_config posed_config() {
  wrc_config config = test_config();
  config.planar.non_steady = 1;
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  return config;
}

/// A contact that is given double ellipses; of a model that remembers, or not.
class Contact {
 public:
  explicit Contact(bool remembers = true, uint32_t strips = 60) {
    wrc_config config = test_config();
    config.planar.strips = static_cast<int32_t>(strips);
    config.planar.non_steady = remembers ? 1 : 0;
    config.wheel_material.shear_modulus = config.rail_material.shear_modulus = 82e9;
    config.wheel_material.poisson = config.rail_material.poisson = 0.28;
    EXPECT_EQ(wrc_model_create(&config, nullptr, &model_, nullptr, 0), WRC_OK);
    EXPECT_EQ(wrc_contact_create(model_, WRC_SIDE_RIGHT, nullptr, &contact_, nullptr, 0), WRC_OK);
    ellipse.a = 6e-3;
    ellipse.b = 5e-3;
    ellipse.normal_force = 70e3;
    creepage.longitudinal = 1.2e-3;
    creepage.lateral = -0.6e-3;
    creepage.spin = 0.15;
  }
  Contact(const Contact&) = delete;
  Contact& operator=(const Contact&) = delete;
  ~Contact() {
    wrc_contact_destroy(contact_);
    wrc_model_destroy(model_);
  }

  wrc_ellipse ellipse = sized<wrc_ellipse>();
  wrc_creepage creepage = wrc_creepage_default();
  wrc_friction friction = wrc_friction_default();

  double limit() const { return friction.coefficient * ellipse.normal_force; }

  /// Rolls on and solves; forces over friction times load.
  wrc_planar_forces roll(double distance) {
    EXPECT_EQ(wrc_planar_roll(contact_, distance), WRC_OK) << why();
    return solve();
  }
  wrc_planar_forces solve() {
    wrc_planar_forces forces{};
    EXPECT_EQ(wrc_planar_tangential(contact_, &ellipse, &creepage, &friction, &forces), WRC_OK) << why();
    forces.fx /= limit();
    forces.fy /= limit();
    forces.mz /= limit() * ellipse.a;
    return forces;
  }

  std::string why() const {
    char text[256] = "";
    wrc_contact_last_error(contact_, text, sizeof text);
    return text;
  }
  wrc_contact* handle() const { return contact_; }
  const wrc_model* model() const { return model_; }

 private:
  wrc_model* model_ = nullptr;
  wrc_contact* contact_ = nullptr;
};

double apart(const wrc_planar_forces& a, const wrc_planar_forces& b) {
  return std::hypot(a.fx - b.fx, a.fy - b.fy);
}

// What rigid creepages put in over a cycle, friction takes out: elastic energy is the same again.
TEST(RollingMemory, PowerIsTheWorkOfACycle) {
  const double pi = std::acos(-1.0), step = 0.3e-3;
  for (const double wave : {24e-3, 60e-3, 240e-3}) {
    Contact contact;
    const wrc_creepage mean = contact.creepage;
    double work = 0.0, power = 0.0, distance = 0.0;
    const double scale = contact.limit();
    for (int cycle = 0; cycle < 2; ++cycle) {
      for (int k = 0; k < std::lround(wave / step); ++k) {
        distance += step;
        const double factor = 1.0 + std::sin(2.0 * pi * (distance - 0.5 * step) / wave);
        contact.creepage.longitudinal = factor * mean.longitudinal;
        contact.creepage.lateral = factor * mean.lateral;
        contact.creepage.spin = factor * mean.spin;
        const wrc_planar_forces forces = contact.roll(step);
        EXPECT_GE(forces.power, 0.0);
        if (cycle == 0) continue;
        const wrc_creepage& c = contact.creepage;
        work -=
            scale *
            (forces.fx * c.longitudinal + forces.fy * c.lateral + forces.mz * contact.ellipse.a * c.spin) *
            c.speed;
        power += forces.power;
      }
    }
    EXPECT_NEAR(power / work, 1.0, 0.01) << wave;
  }
}

// At the start from rest nearly all sticks: work becomes elastic energy.
TEST(RollingMemory, WhatSticksTakesNoPower) {
  Contact contact, steady(false);
  contact.creepage.longitudinal *= 0.5;
  steady.creepage = contact.creepage;
  wrc_planar_forces forces{};
  for (int k = 0; k < 3; ++k) forces = contact.roll(0.2e-3);
  EXPECT_LT(forces.power, 0.05 * steady.solve().power);
  wrc_damage damage{};
  EXPECT_EQ(wrc_contact_damage(contact.handle(), WRC_ALL_REGIONS, &damage), WRC_OK);
  EXPECT_NEAR(damage.power, forces.power, 1e-9 * (1.0 + forces.power));  // fields are scaled to it
}

TEST(RollingMemory, StepsThatStayTheSameEndInSteadyRolling) {
  for (const double step : {0.2e-3, 1.5e-3, 7e-3, 20e-3}) {
    Contact contact, steady(false);
    const wrc_planar_forces end = steady.solve();
    wrc_planar_forces forces{};
    for (double rolled = 0.0; rolled < 60e-3; rolled += step) forces = contact.roll(step);
    EXPECT_LT(apart(forces, end), 1e-3) << step;
    EXPECT_NEAR(forces.mz, end.mz, 1e-3) << step;
  }
}

TEST(RollingMemory, OneLongStepIsSteadyRolling) {
  Contact contact, steady(false);
  contact.roll(1e-3);
  const wrc_planar_forces forces = contact.roll(6.0 * 2.0 * contact.ellipse.a), end = steady.solve();
  EXPECT_EQ(forces.fx, end.fx);
  EXPECT_EQ(forces.fy, end.fy);
  EXPECT_EQ(forces.mz, end.mz);
  EXPECT_EQ(forces.power, end.power);
  EXPECT_LT(apart(contact.roll(1e-3), end), 2e-3);  // and is remembered
}

TEST(RollingMemory, BeginsWithoutTractionsAndStaysWhereItIs) {
  Contact contact;
  EXPECT_LT(apart(contact.solve(), {}), 5e-3);
  contact.roll(4e-3);
  const wrc_planar_forces before = contact.solve();
  contact.creepage.longitudinal = -1e-3;
  EXPECT_LT(apart(contact.solve(), before), 5e-3);
  EXPECT_GT(apart(contact.roll(2e-3), before), 0.05);
}

TEST(RollingMemory, FollowsTheExactSolver) {
  // From rest under creepages and spin, then the other way round: beyond half of what friction allows.
  Contact contact;
  contact.creepage.longitudinal = 1.5e-3;
  constexpr uint32_t n = 24;
  wrc_exact_rolling_problem problem = wrc_exact_rolling_problem_default();
  const double a = contact.ellipse.a, b = contact.ellipse.b;
  problem.grid.nx = problem.grid.ny = n;
  problem.grid.dx = 2.0 * a / n;
  problem.grid.dy = 2.0 * b / n;
  problem.grid.x0 = -a + 0.5 * problem.grid.dx;
  problem.grid.y0 = -b + 0.5 * problem.grid.dy;
  wrc_material steel = wrc_material_default();
  steel.shear_modulus = 82e9;
  steel.poisson = 0.28;
  problem.wheel_material = problem.rail_material = steel;
  std::vector<double> pressure;
  double sum = 0.0;
  for (uint32_t k = 0; k < n * n; ++k) {
    const double x = (problem.grid.x0 + (k % n) * problem.grid.dx) / a;
    const double y = (problem.grid.y0 + (k / n) * problem.grid.dy) / b;
    pressure.push_back(std::sqrt(std::max(0.0, 1.0 - x * x - y * y)));
    sum += pressure.back() * problem.grid.dx * problem.grid.dy;
  }
  for (double& p : pressure) p *= contact.ellipse.normal_force / sum;
  problem.pressure = pressure.data();
  wrc_exact_transient* bodies = nullptr;
  ASSERT_EQ(wrc_exact_transient_create(&problem.grid, &steel, &steel, &bodies, nullptr, 0), WRC_OK);
  wrc_exact_rolling_solution exact = sized<wrc_exact_rolling_solution>();
  double worst = 0.0, largest = 0.0;
  for (int k = 0; k < 80; ++k) {
    if (k == 40) contact.creepage.longitudinal = -1.5e-3;
    problem.creepage = contact.creepage;
    ASSERT_EQ(wrc_exact_transient_step(bodies, &problem, &exact, nullptr, 0), WRC_OK);
    const wrc_planar_forces forces = contact.roll(problem.grid.dx);
    worst = std::max(
        worst, std::hypot(forces.fx - exact.fx / contact.limit(), forces.fy - exact.fy / contact.limit()));
    largest = std::max(largest, std::fabs(forces.fx));
  }
  wrc_exact_transient_destroy(bodies);
  EXPECT_LT(worst, 0.045);
  EXPECT_GT(largest, 0.5);
}

TEST(RollingMemory, DoesNotLeapAsTheStepGrowsLonger) {
  Contact contact;
  contact.roll(3e-3);
  uint64_t bytes = 0;
  ASSERT_EQ(wrc_contact_state_size(contact.model(), &bytes), WRC_OK);
  std::vector<std::byte> state(bytes);
  ASSERT_EQ(wrc_contact_save(contact.handle(), state.data(), bytes), WRC_OK);
  contact.creepage.lateral = 1e-3;
  constexpr int steps = 700;
  const double length = 2.0 * contact.ellipse.a, longest = 7.0 * length;
  std::vector<wrc_planar_forces> found;
  for (int k = 0; k <= steps; ++k) {
    ASSERT_EQ(wrc_contact_restore(contact.handle(), state.data(), bytes), WRC_OK);
    found.push_back(contact.roll(k * longest / steps));
  }
  double worst = 0.0;
  for (int k = 1; k + 1 <= steps; ++k) {
    worst = std::max(worst, 0.5 * std::hypot(found[k + 1].fx - 2.0 * found[k].fx + found[k - 1].fx,
                                             found[k + 1].fy - 2.0 * found[k].fy + found[k - 1].fy));
  }
  EXPECT_LT(worst, 2e-3);
}

TEST(RollingMemory, IsPartOfTheState) {
  Contact contact;
  contact.roll(2e-3);
  ASSERT_EQ(wrc_planar_roll(contact.handle(), 0.5e-3), WRC_OK);
  uint64_t bytes = 0;
  ASSERT_EQ(wrc_contact_state_size(contact.model(), &bytes), WRC_OK);
  std::vector<std::byte> state(bytes);
  ASSERT_EQ(wrc_contact_save(contact.handle(), state.data(), bytes), WRC_OK);
  const wrc_planar_forces once = contact.roll(0.5e-3);
  contact.roll(4e-3);
  ASSERT_EQ(wrc_contact_restore(contact.handle(), state.data(), bytes), WRC_OK);
  const wrc_planar_forces again = contact.roll(0.5e-3);
  EXPECT_EQ(once.fx, again.fx);
  EXPECT_EQ(once.fy, again.fy);
  EXPECT_EQ(once.mz, again.mz);
}

TEST(RollingMemory, PatchesThatGrowMoveAndVanishStayWithinFriction) {
  Contact contact;
  contact.creepage = wrc_creepage_default();
  for (int k = 0; k < 300; ++k) {
    const double wave = std::sin(0.7 * k), other = std::sin(0.31 * k);
    contact.ellipse.normal_force = 70e3 * (1.0 + 0.8 * wave);
    const double scale = std::cbrt(1.0 + 0.8 * wave);
    contact.ellipse.a = 6e-3 * scale;
    contact.ellipse.b = 5e-3 * scale * (1.0 + 0.3 * other);
    contact.ellipse.psi = 0.5 * other;
    contact.creepage.longitudinal = 4e-3 * std::sin(0.13 * k);
    contact.creepage.lateral = 2e-3 * std::sin(0.23 * k);
    contact.creepage.spin = std::sin(0.17 * k);
    const wrc_planar_forces forces = contact.roll(k % 7 == 0 ? 0.0 : 1e-3 * (k % 5));
    EXPECT_LT(std::hypot(forces.fx, forces.fy), 1.0 + 1e-12) << k;
    EXPECT_GE(forces.power, 0.0);
  }
}

/// Displaces the wheel at rest, by creepages over a millimetre.
wrc_planar_forces shift(Contact& contact, double x, double y, double turn) {
  contact.creepage.speed = 0.0;
  contact.creepage.longitudinal = 1e3 * x;
  contact.creepage.lateral = 1e3 * y;
  contact.creepage.spin = 1e3 * turn;
  return contact.roll(1e-3);
}

TEST(RollingMemory, ShiftsAtRestAreCattaneosAndMindlins) {
  // A circle, to 0.9 of the full shift, back to -0.9 and on to 0.3: each branch is the first one, doubled.
  const double G = 82e9, nu = 0.28;
  for (const bool along_y : {false, true}) {
    Contact contact;
    contact.ellipse.b = contact.ellipse.a;
    const double full = 3.0 * contact.limit() * (2.0 - nu) / (8.0 * contact.ellipse.a * G);
    const auto first = [](double d) { return 1.0 - std::pow(1.0 - d, 1.5); };
    const double to[] = {0.9, -0.9, 0.3};
    double at = 0.0, turned_at = 0.0, turned_force = 0.0;
    for (int branch = 0; branch < 3; ++branch) {
      const double sign = branch == 1 ? -1.0 : 1.0;
      wrc_planar_forces forces{};
      for (int k = 0; k < 12; ++k) {
        const double by = (to[branch] - (branch == 0 ? 0.0 : to[branch - 1])) / 12.0;
        at += by;
        forces = shift(contact, along_y ? 0.0 : by * full, along_y ? by * full : 0.0, 0.0);
        const double way = std::fabs(at - turned_at);
        const double force =
            branch == 0 ? first(way) : turned_force + sign * 2.0 * first(std::min(1.0, 0.5 * way));
        EXPECT_NEAR(-(along_y ? forces.fy : forces.fx), force, 0.02) << at;
        EXPECT_EQ(forces.power, 0.0);
      }
      turned_at = at;
      turned_force = branch == 0 ? first(at) : turned_force + sign * 2.0 * first(0.9);
    }
    // rest keeps what there is
    const wrc_planar_forces before = shift(contact, 0.0, 0.0, 0.0);
    for (int k = 0; k < 10; ++k) {
      const wrc_planar_forces after = shift(contact, 0.0, 0.0, 0.0);
      EXPECT_NEAR(after.fx, before.fx, 1e-12);
      EXPECT_NEAR(after.fy, before.fy, 1e-12);
    }
  }
}

TEST(RollingMemory, BackwardsIsTheMirrorImage) {
  // after a shift at rest and a metre's tenth forwards, which are mirrored as well
  wrc_planar_forces found[2];
  for (const double way : {1.0, -1.0}) {
    Contact contact;
    const wrc_creepage creepage = contact.creepage;
    shift(contact, way * 4e-6, 3e-6, way * 1e-4);
    for (const double direction : {1.0, -1.0}) {
      contact.creepage = creepage;
      contact.creepage.speed = way * direction;
      contact.creepage.longitudinal *= way;
      contact.creepage.spin *= way;
      contact.roll(2e-3);
    }
    wrc_planar_forces& forces = found[way > 0.0 ? 0 : 1];
    forces = contact.roll(1e-3);
    forces.fx *= way;
    forces.mz *= way;
  }
  EXPECT_GT(std::fabs(found[0].fx), 0.1);
  EXPECT_NEAR(found[0].fx, found[1].fx, 1e-12);
  EXPECT_NEAR(found[0].fy, found[1].fy, 1e-12);
  EXPECT_NEAR(found[0].mz, found[1].mz, 1e-12);
}

TEST(RollingMemory, GivesBackNoMoreThanWasPutIn) {
  // Random shifts, distances either way, loads, widths and friction: the work that was put in never falls
  // below zero. Steps are small and large against those that slide everywhere.
  Contact contact(true, 12);
  contact.creepage = wrc_creepage_default();
  uint32_t seed = 1;
  const auto number = [&](double low, double high) {
    seed = 1664525u * seed + 1013904223u;
    return low + (high - low) * (seed >> 8) / 16777216.0;
  };
  double work = 0.0, exchanged = 0.0, worst = 0.0;
  for (int k = 0; k < 60000; ++k) {
    if (number(0.0, 1.0) < 0.3) {
      const double scale = number(0.9, 1.1);
      contact.ellipse.normal_force = 70e3 * scale * scale * scale * number(0.8, 1.25);
      contact.ellipse.a = 6e-3 * scale;
      contact.ellipse.b = 5e-3 * scale * number(0.9, 1.1);
      contact.friction.coefficient = number(0.2, 0.4);
    }
    const double size = std::pow(10.0, number(-8.0, -4.5)), kind = number(0.0, 1.0);
    const double x = size * number(-1.0, 1.0), y = size * number(-1.0, 1.0),
                 turn = 200.0 * size * number(-1.0, 1.0);
    const double length = kind < 0.5 ? 1e-3 : std::pow(10.0, number(-5.0, -1.5));
    contact.creepage.speed = kind < 0.5 ? 0.0 : kind < 0.75 ? 1.0 : -1.0;
    contact.creepage.longitudinal = x / length;
    contact.creepage.lateral = y / length;
    contact.creepage.spin = turn / length;
    const wrc_planar_forces f = contact.roll(length);
    const double put_in = -contact.limit() * (f.fx * x + f.fy * y + f.mz * contact.ellipse.a * turn);
    work += put_in;
    exchanged += std::fabs(put_in);
    EXPECT_GE(f.power, 0.0);
    worst = std::max(worst, -work);
  }
  EXPECT_LE(worst, 1e-9 * exchanged);
}

TEST(RollingMemory, IsRefusedWhereItWouldBeIgnored) {
  Contact contact, steady(false);
  EXPECT_EQ(wrc_planar_roll(steady.handle(), 1e-3), WRC_ERROR_UNSUPPORTED);
  EXPECT_NE(steady.why().find("non_steady"), std::string::npos) << steady.why();
  EXPECT_EQ(wrc_planar_roll(nullptr, 1e-3), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_planar_roll(contact.handle(), -1e-3), WRC_ERROR_RANGE);
  EXPECT_EQ(wrc_planar_roll(contact.handle(), std::nan("")), WRC_ERROR_NOT_FINITE);
  contact.roll(1e-3);
  wrc_planar_derivatives slopes = sized<wrc_planar_derivatives>();
  EXPECT_EQ(wrc_planar_tangential_derivatives(contact.handle(), &slopes), WRC_ERROR_UNSUPPORTED);
  wrc_planar_forces forces{};
  contact.creepage.reverse_share = 0.2;
  EXPECT_EQ(wrc_planar_tangential(contact.handle(), &contact.ellipse, &contact.creepage, &contact.friction,
                                  &forces),
            WRC_ERROR_UNSUPPORTED);
  EXPECT_NE(contact.why().find("creepage.reverse_share"), std::string::npos) << contact.why();

  wrc_config config = test_config();
  config.planar.non_steady = 1;
  config.tangential.method = WRC_TANGENTIAL_FASTSIM;
  char text[256] = "";
  EXPECT_EQ(wrc_config_check(&config, text, sizeof text), WRC_ERROR_UNSUPPORTED);
  EXPECT_NE(std::string(text).find("config.planar.non_steady"), std::string::npos) << text;

  config = posed_config();
  wrc_model* model = nullptr;
  wrc_contact* posed = nullptr;
  ASSERT_EQ(wrc_model_create(&config, nullptr, &model, nullptr, 0), WRC_OK);
  ASSERT_EQ(wrc_contact_create(model, WRC_SIDE_RIGHT, nullptr, &posed, nullptr, 0), WRC_OK);
  wrc_wheel_input input = wrc_wheel_input_default();
  wrc_wrench wrench = sized<wrc_wrench>();
  EXPECT_EQ(wrc_contact_wrench(posed, &input, &wrench), WRC_ERROR_UNSUPPORTED);
  wrc_contact_destroy(posed);
  wrc_model_destroy(model);
}

/// Lateral places of a pose after steps of rolling, by trial steps: strips leave and come back.
TEST(RollingMemory, StripsThatLeaveAndReturnDoNotLeap) {
  const wrc_config config = posed_config();
  wrc_model* model = nullptr;
  wrc_contact* contact = nullptr;
  ASSERT_EQ(wrc_model_create(&config, nullptr, &model, nullptr, 0), WRC_OK);
  ASSERT_EQ(wrc_contact_create(model, WRC_SIDE_RIGHT, nullptr, &contact, nullptr, 0), WRC_OK);
  wrc_planar_input input = wrc_planar_input_default();
  wrc_planar_output output = sized<wrc_planar_output>();
  input.load.normal_force = 80e3;
  input.pose.lateral = 3.5e-3;
  input.creepage.longitudinal = 8e-4;
  input.creepage.lateral = 5e-4;
  const auto go = [&](double rolled) {
    EXPECT_EQ(wrc_planar_roll(contact, rolled), WRC_OK);
    EXPECT_EQ(wrc_planar_step(contact, &input, &output), WRC_OK);
  };
  for (int k = 0; k < 10; ++k) go(1e-3);
  uint64_t bytes = 0;
  ASSERT_EQ(wrc_contact_state_size(model, &bytes), WRC_OK);
  std::vector<std::byte> state(bytes);
  ASSERT_EQ(wrc_contact_save(contact, state.data(), bytes), WRC_OK);
  for (const double step : {1e-6, 20e-9}) {
    wrc_planar_forces before{}, last{};
    double largest = 0.0;
    for (int k = 0; k < 600; ++k) {
      ASSERT_EQ(wrc_contact_restore(contact, state.data(), bytes), WRC_OK);
      input.pose.lateral = 3.5e-3 - 300 * step + step * k;
      go(1e-3);
      const wrc_planar_forces& now = output.forces;
      if (k > 1)
        largest = std::max(
            largest, std::hypot(now.fx - 2.0 * last.fx + before.fx, now.fy - 2.0 * last.fy + before.fy));
      before = last;
      last = now;
    }
    EXPECT_LT(largest, 1e-3 * 0.3 * 80e3) << step;
  }
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
}

TEST(RollingMemory, OfAPoseStaysWithTheRail) {
  const wrc_config config = posed_config();
  wrc_model* model = nullptr;
  ASSERT_EQ(wrc_model_create(&config, nullptr, &model, nullptr, 0), WRC_OK);
  for (const int32_t side : {WRC_SIDE_RIGHT, WRC_SIDE_LEFT}) {
    wrc_contact* contact = nullptr;
    ASSERT_EQ(wrc_contact_create(model, side, nullptr, &contact, nullptr, 0), WRC_OK);
    wrc_planar_input input = wrc_planar_input_default();
    wrc_planar_output output = sized<wrc_planar_output>();
    input.load.normal_force = 80e3;
    input.creepage.longitudinal = 8e-4;
    double before = 0.0, largest_change = 0.0;
    for (int k = 0; k < 60; ++k) {
      input.pose.lateral = 1e-5 * k * (side == WRC_SIDE_RIGHT ? 1.0 : -1.0);
      ASSERT_EQ(wrc_planar_roll(contact, 0.5e-3), WRC_OK);
      ASSERT_GE(wrc_planar_step(contact, &input, &output), 0);
      const double share = output.forces.fx / (0.3 * 80e3);
      if (k > 0) largest_change = std::max(largest_change, std::fabs(share - before));
      before = share;
    }
    EXPECT_LT(before, -0.4);
    EXPECT_LT(largest_change, 0.08);
    // Apart, and in contact again: from nothing.
    input.load.prescribed = WRC_PRESCRIBE_APPROACH;
    input.load.approach = -1e-3;
    EXPECT_EQ(wrc_planar_step(contact, &input, &output), WRC_FLAG_NO_CONTACT);
    input.load.prescribed = WRC_PRESCRIBE_NORMAL_FORCE;
    ASSERT_EQ(wrc_planar_roll(contact, 0.1e-3), WRC_OK);
    ASSERT_GE(wrc_planar_step(contact, &input, &output), 0);
    EXPECT_GT(output.forces.fx / (0.3 * 80e3), 0.2 * before);
    wrc_contact_destroy(contact);
  }
  wrc_model_destroy(model);
}

}  // namespace
