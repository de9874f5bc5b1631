/// config.surface.memory, wrc_contact_commit() and input.time_step: a wheel on a rail that remembers its
/// tractions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "reference_contact.hpp"
#include "wheel_on_rail.hpp"
#include "wrench_inputs.hpp"

namespace {

class SurfaceMemory : public testing::Test, protected PlacedWheel {
 protected:
  SurfaceMemory() {
    config.surface.memory = 1;
    stand(4e-3);
  }

  /// At rest under 80 kN at this place, its height prescribed from now on.
  void stand(double y) {
    create();
    rest();
    wheel.y = y;
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = 80e3;
    EXPECT_EQ(step(), WRC_OK) << error();
    commit();
    input.prescribed = WRC_PRESCRIBE_HEIGHT;
    input.vertical_load = 0.0;
    wheel.z = wrench.z;
    limit = friction.coefficient * wrench.normal_force;
    standing = wrench;
  }
  void rest() {
    std::fill_n(wheel.velocity, 3, 0.0);
    std::fill_n(wheel.angular_velocity, 3, 0.0);
  }
  void commit() { EXPECT_EQ(wrc_contact_commit(contact), WRC_OK) << error(); }
  /// Rolls at this speed, a little driven and yawed.
  void roll(double speed) {
    wheel.velocity[0] = speed;
    wheel.velocity[1] = 4e-4 * speed;
    wheel.angular_velocity[1] = -speed / 0.46 * 1.0006;
  }
  /// A step of this length in time; `kept`: committed.
  const wrc_wrench& go(double time, bool kept = true) {
    input.time_step = time;
    EXPECT_EQ(step(), WRC_OK) << error();
    if (kept) commit();
    return wrench;
  }
  /// Difference of horizontal forces over the friction limit.
  double apart(const wrc_wrench& a, const wrc_wrench& b) const {
    return std::hypot(a.force[0] - b.force[0], a.force[1] - b.force[1]) / limit;
  }

  /// The wrench of a contact without memory at the input of the moment.
  wrc_wrench steady() {
    wrc_contact* const remembering = contact;
    wrc_model* const of_that = model;
    contact = nullptr;
    model = nullptr;
    config.surface.memory = 0;
    input.time_step = 0.0;
    create();
    EXPECT_EQ(step(), WRC_OK) << error();
    const wrc_wrench found = wrench;
    wrc_contact_destroy(contact);
    wrc_model_destroy(model);
    contact = remembering;
    model = of_that;
    config.surface.memory = 1;
    return found;
  }

  double limit = 0.0;
  wrc_wrench standing{};
};

bool same_bits(const wrc_wrench& a, const wrc_wrench& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

TEST_F(SurfaceMemory, TrialsLeaveNoTrace) {
  roll(2.0);
  for (int i = 0; i < 3; ++i) go(1e-3);
  const wrc_wrench once = go(1e-3, false);
  wheel.velocity[1] = -0.3;
  go(5e-3, false);
  wheel.velocity[0] = -2.0;
  go(2e-4, false);
  roll(2.0);
  EXPECT_TRUE(same_bits(once, go(1e-3, false)));
  commit();
  EXPECT_GT(apart(once, go(1e-3, false)), 1e-3) << "the commit counts";
}

/// Wheels spin or lock while the vehicle goes the other way: a step like others, not an input to be flagged.
TEST_F(SurfaceMemory, ATurnAgainstTheTravelIsAStepLikeOthers) {
  for (const double speed : {2.0, -2.0, 20.0}) {
    roll(speed);
    wheel.angular_velocity[1] = -wheel.angular_velocity[1];
    go(1e-3, false);
    // All slides, and friction acts against the travel.
    EXPECT_NEAR(std::hypot(wrench.force[0] - standing.force[0], wrench.force[1] - standing.force[1]), limit,
                0.05 * limit);
    EXPECT_LT(speed * wrench.force[0], 0.0);
  }
}

TEST_F(SurfaceMemory, IsPartOfTheState) {
  roll(2.0);
  for (int i = 0; i < 3; ++i) go(1e-3);
  uint64_t bytes = 0;
  ASSERT_EQ(wrc_contact_state_size(model, &bytes), WRC_OK);
  std::vector<unsigned char> state(bytes);
  ASSERT_EQ(wrc_contact_save(contact, state.data(), bytes), WRC_OK);
  const wrc_wrench next = go(1e-3);
  for (int i = 0; i < 5; ++i) go(1e-3);
  ASSERT_EQ(wrc_contact_restore(contact, state.data(), bytes), WRC_OK) << error();
  EXPECT_TRUE(same_bits(next, go(1e-3)));
}

TEST_F(SurfaceMemory, SteadyInputsEndInTheSteadyWrench) {
  for (const double y : {4e-3, 0.0, -1e-3}) {
    stand(y);
    roll(2.0);
    const wrc_wrench end = steady();
    for (int i = 0; i < 38; ++i) go(4e-4);  // 30 mm, two lengths
    EXPECT_LT(apart(wrench, end), 5e-4) << y;
    for (int i = 0; i < 38; ++i) go(4e-4);
    EXPECT_LT(apart(wrench, end), 1e-9) << y;
    // in one step over many lengths
    stand(y);
    roll(2.0);
    go(0.1);
    EXPECT_EQ(std::memcmp(wrench.force, end.force, sizeof end.force), 0) << y;
  }
}

TEST_F(SurfaceMemory, FrictionRailsAndDampingEndInTheirSteadyWrench) {
  const double zone_y[] = {-1.0, -5e-3, 5e-3, 1.0}, zone_coefficients[] = {0.2, 0.25, 0.4, 0.45};
  const auto falling = [&] {
    friction.speed_law = WRC_SPEED_LAW_EXPONENTIAL;
    friction.kinetic_ratio = 0.4;
    friction.fall_rate = 2.0;
  };
  const auto zones = [&] {
    friction.zone_count = 4;
    friction.zone_y = zone_y;
    friction.zone_coefficients = zone_coefficients;
    friction.zone_frame = WRC_ZONES_RAIL_PROFILE;
  };
  const auto zones_of_the_wheel = [&] {
    zones();
    friction.zone_frame = WRC_ZONES_WHEEL_PROFILE;
  };
  const auto damped = [&] {
    input.damping = 0.2;
    wheel.velocity[2] = 0.02;
  };
  const auto aslant = [&] {
    rail.y_slope = 1e-3;
    rail.y_velocity = 2e-4;
  };
  const std::function<void()> cases[] = {falling, zones,  zones_of_the_wheel,
                                         damped,  aslant, [&] { friction.slope_reduction = 0.5; }};
  for (const bool roller : {false, true}) {
    config.roller_curvature = roller ? 2.0 : 0.0;
    for (std::size_t k = 0; k < (roller ? 1 : std::size(cases)); ++k) {
      friction = wrc_friction_default();
      input.damping = rail.y_slope = rail.y_velocity = input.roller_rate = 0.0;
      stand(3e-3);
      roll(2.0);
      wheel.angular_velocity[2] = 0.02;
      if (roller) {
        input.roller_rate = wheel.velocity[0] * config.roller_curvature;
        wheel.velocity[0] = 1e-3;
      } else {
        cases[k]();
      }
      const wrc_wrench end = steady();
      for (int i = 0; i < 60; ++i) go(5e-4);
      EXPECT_LT(apart(wrench, end), 1e-3) << roller << k;
      // the state has all of it
      uint64_t bytes = 0;
      ASSERT_EQ(wrc_contact_state_size(model, &bytes), WRC_OK);
      std::vector<unsigned char> state(bytes);
      ASSERT_EQ(wrc_contact_save(contact, state.data(), bytes), WRC_OK);
      wheel.velocity[1] = -3e-3;
      const wrc_wrench next = go(1e-3);
      go(2e-3);
      ASSERT_EQ(wrc_contact_restore(contact, state.data(), bytes), WRC_OK) << error();
      EXPECT_TRUE(same_bits(next, go(1e-3)));
      EXPECT_GE(next.power, 0.0);
    }
  }
}

/// Rolling in steps of 1 mm at 2 m/s along the configuration's rail. The wrench is compared with that without
/// memory.
class MemoryAlongTrack : public SurfaceMemory {
 protected:
  MemoryAlongTrack() {
    friction = wrc_friction_default();
    config.surface.memory = 1;
  }
  void add_section(double distance, double y, double z, int32_t face = 0) {
    wrc_rail_section section{};
    section.distance = distance;
    section.y = y;
    section.z = z;
    section.surface = face;
    section.profile.kind = WRC_PROFILE_UIC60_BENCHMARK;
    sections.push_back(section);
    config.rail_section_count = static_cast<uint32_t>(sections.size());
    config.rail_sections = sections.data();
    config.rail_section_size = sizeof sections[0];
  }
  /// A face that sinks 1:500 and one beside it that goes on: the wheel goes over from one to the other.
  void give_crossing() {
    for (int k = 0; k <= 12; ++k) add_section(0.5 * k, 0.0, 1e-3 * k);
    for (int k = 0; k <= 12; ++k) add_section(0.5 * k, 48e-3, 0.0, 1);
  }
  /// The same wheel without memory.
  struct Forgetful : PlacedWheel {
    using PlacedWheel::config, PlacedWheel::create, PlacedWheel::error, PlacedWheel::input, PlacedWheel::step,
        PlacedWheel::wrench;
  };
  /// Rolls from one distance to another under 80 kN. Calls takes(wrench without memory) after each step.
  template <class Take>
  void roll_along(double from, double to, Take&& take) {
    create();
    Forgetful other;
    other.config = config;
    other.config.surface.memory = 0;
    other.create();
    roll(2.0);
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = 80e3;
    input.time_step = 0.0;
    for (int k = 0; from + 1e-3 * k < to; ++k) {
      input.distance = from + 1e-3 * k;
      if (config.roundness.angle_count > 0) input.angle = input.distance / 0.46;
      ASSERT_EQ(step(), WRC_OK) << error();
      commit();
      limit = friction.coefficient * wrench.normal_force;
      other.input = input;
      other.input.time_step = 0.0;
      ASSERT_EQ(other.step(), WRC_OK) << other.error();
      take(other.wrench);
      input.time_step = 0.5e-3;
    }
  }
  /// Largest difference to the steady force a given way before, after two lengths of rolling.
  template <class Take>
  double farthest_from_steady(double from, double to, int way, Take&& take) {
    std::vector<wrc_wrench> steady;
    double worst = 0.0;
    roll_along(from, to, [&](const wrc_wrench& without) {
      steady.push_back(without);
      if (steady.size() > 40) worst = std::max(worst, apart(wrench, steady[steady.size() - 1 - way]));
      take();
    });
    return worst;
  }
  /// Rolls on at the same place, and expects the steady wrench.
  void expect_steady() {
    const wrc_wrench end = steady();
    for (int k = 0; k < 50; ++k) go(0.5e-3);
    EXPECT_LT(apart(wrench, end), 1e-3) << input.distance;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(wrench.moment[i], end.moment[i], 1e-3 * limit) << input.distance;
  }

  std::vector<wrc_rail_section> sections;
};

TEST_F(MemoryAlongTrack, EqualSectionsAreTheConstantRail) {
  wheel.y = 4e-3;
  std::vector<double> constant[2];
  for (auto& path : constant) {
    // the place along the track counts for a rail with sections alone
    create();
    roll(2.0);
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = 80e3;
    for (int k = 0; k < 30; ++k) {
      wheel.velocity[1] = k < 15 ? 1e-3 : -2e-3;
      input.time_step = k == 0 ? 0.0 : 0.5e-3;
      input.distance = sections.empty() ? 0.0 : 1e-3 * k;
      ASSERT_EQ(step(), WRC_OK) << error();
      commit();
      path.push_back(wrench.force[0]);
      path.push_back(wrench.force[1]);
    }
    for (const double at : {-20.0, -3.0, 10.0}) add_section(at, 0.0, 0.0);
  }
  for (std::size_t i = 0; i < constant[0].size(); ++i)
    EXPECT_NEAR(constant[0][i], constant[1][i], 2e-3 * 0.3 * 80e3) << i;
}

TEST_F(MemoryAlongTrack, ACrossingIsTheSteadyOneOfShortlyBefore) {
  give_crossing();
  int on_first = 0, on_second = 0, on_both = 0;
  const double worst = farthest_from_steady(0.6, 1.1, 2, [&] {
    wrc_region region = sized<wrc_region>();
    ASSERT_EQ(wrc_contact_region(contact, 0, &region), WRC_OK);
    ++(wrench.region_count > 1 ? on_both : region.surface == 0 ? on_first : on_second);
  });
  EXPECT_LT(worst, 0.03);
  EXPECT_GT(std::min({on_first, on_second, on_both}), 15);
  for (const double at : {0.6, 0.82, 0.85, 0.92, 1.1}) {
    input.distance = at;
    input.time_step = 1.0;
    ASSERT_EQ(step(), WRC_OK) << error();
    commit();
    expect_steady();
    // trial steps of 6 to 6.4 mm, 1 um apart, which begin and leave contacts
    wrc_wrench before{}, last{};
    for (int k = 0; k < 400; ++k) {
      input.distance = at + 6e-3 + 1e-6 * k;
      const wrc_wrench& now = go(3e-3 + 0.5e-6 * k, false);
      if (k > 1) {
        EXPECT_LT(std::hypot(now.force[0] - 2.0 * last.force[0] + before.force[0],
                             now.force[1] - 2.0 * last.force[1] + before.force[1]),
                  1e-3 * limit)
            << input.distance;
      }
      before = last;
      last = now;
    }
  }
}

/// The wheel touches a ramp of 1:10 and its upper end, then the end alone. Places of the end keep their
/// tractions where those on the ramp end, and nothing leaps where places begin or end.
TEST_F(MemoryAlongTrack, PlacesAtTheEndOfARampKeepTheirTractions) {
  for (int k = -10; k <= 20; ++k) add_section(0.01 * k, 0.0, 0.1 * std::max(0.0, 0.1 - 0.01 * k) - 0.01);
  wheel.y = 1e-3;
  constexpr double way = 0.2e-3;  // [m]
  for (const double direction : {1.0, -1.0}) {
    SCOPED_TRACE(direction);
    create();
    roll(2.0 * direction);
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = 60e3;
    const double begin = direction > 0.0 ? 20e-3 : 50e-3;
    wrc_wrench before{};
    int on_both = 0;
    for (int k = 0; k < 150; ++k) {
      const double distance = input.distance = begin + direction * way * k;
      go(k == 0 ? 0.0 : way / 2.0, false);
      commit();
      limit = friction.coefficient * wrench.normal_force;
      on_both += wrench.region_count > 1 ? 1 : 0;
      // after two lengths nothing is left of the first step
      if (k > 50) {
        EXPECT_LT(apart(wrench, before), 0.03) << distance;
      }
      before = wrench;
      if (k % 6 != 0) continue;
      // trial steps 2 um apart, within which places begin and end
      wrc_wrench last{}, last_but_one{};
      for (int n = 0; n < 200; ++n) {
        input.distance = distance + direction * 2e-6 * n;
        const wrc_wrench& now = go(1e-6 * n, false);
        if (n > 1) {
          EXPECT_LT(std::hypot(now.force[0] - 2.0 * last.force[0] + last_but_one.force[0],
                               now.force[1] - 2.0 * last.force[1] + last_but_one.force[1]),
                    1e-3 * limit)
              << input.distance;
        }
        last_but_one = std::exchange(last, now);
      }
    }
    EXPECT_GT(on_both, 15);
  }
}

/// A state taken between both places at the end of a ramp has the tractions of both.
TEST_F(MemoryAlongTrack, PlacesAtTheEndOfARampArePartOfTheState) {
  for (int k = -10; k <= 20; ++k) add_section(0.01 * k, 0.0, 0.1 * std::max(0.0, 0.1 - 0.01 * k) - 0.01);
  create();
  roll(2.0);
  wheel.y = 1e-3;
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 60e3;
  const auto roll_to = [&](double distance) {
    while (input.distance < distance) {
      input.distance += 0.2e-3;
      go(1e-4);
    }
  };
  input.distance = 30e-3;
  go(0.0);
  roll_to(38e-3);
  ASSERT_GT(wrench.region_count, 1);
  uint64_t bytes = 0;
  ASSERT_EQ(wrc_contact_portable_size(model, &bytes), WRC_OK);
  std::vector<char> state(bytes);
  ASSERT_EQ(wrc_contact_save_portable(contact, state.data(), bytes), WRC_OK);
  const double at = input.distance;
  roll_to(44e-3);
  const wrc_wrench once = wrench;
  take(side);
  ASSERT_EQ(wrc_contact_restore_portable(contact, state.data(), bytes), WRC_OK) << error();
  input.distance = at;
  roll_to(44e-3);
  EXPECT_TRUE(same_bits(once, wrench));
}

TEST_F(MemoryAlongTrack, AFaceThatWasLeftIsForgottenAtOnce) {
  give_crossing();
  input.distance = 0.9;
  wrc_wrench of[2];
  for (const bool was_on_other : {false, true}) {
    create();
    roll(2.0);
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = 80e3;
    if (was_on_other) {
      wheel.roll = -3e-3;  // on the first face alone
      for (int k = 0; k < 20; ++k) go(1e-3);
    }
    wheel.roll = 6e-3;  // on the second
    of[was_on_other ? 1 : 0] = go(1e-3);
    wrc_region region = sized<wrc_region>();
    ASSERT_EQ(wrc_contact_region(contact, 0, &region), WRC_OK);
    EXPECT_EQ(region.surface, 1);
  }
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(of[0].force[i], of[1].force[i]);
    EXPECT_EQ(of[0].moment[i], of[1].moment[i]);
  }
}

TEST_F(MemoryAlongTrack, AWheelPutElsewhereAlongTheTrackBeginsAnew) {
  give_crossing();
  create();
  roll(2.0);
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 80e3;
  input.distance = 0.1;
  go(1e-3);
  const auto dropped = [&] { return (wrench.flags & WRC_FLAG_BIT(WRC_FLAG_MEMORY_DROPPED)) != 0U; };
  input.distance = 0.1029;
  EXPECT_EQ(step(), WRC_OK) << error();
  input.distance = 0.2;
  EXPECT_GT(step(), WRC_OK);
  EXPECT_TRUE(dropped()) << error();
  ReferenceWheel::expect_words(error(), {"place of the wheel", "input.time_step"});
  input.time_step = 0.0;
  EXPECT_EQ(step(), WRC_ERROR_RANGE);
  ReferenceWheel::expect_words(error(), {"input.time_step", "wrc_contact_commit"});
}

TEST_F(MemoryAlongTrack, WheelsOutOfRoundAreTheSteadyOnesOfShortlyBefore) {
  std::vector<double> angles, deviations;
  for (int i = 0; i <= 720; ++i) {
    angles.push_back(6.283185307179586 * i / 720);
    deviations.push_back(5e-5 * std::cos(6.0 * angles.back()));
  }
  add_section(-1.0, 0.0, 0.0);
  add_section(2.0, 0.0, 0.0);
  config.roundness = {721, 1, angles.data(), nullptr, deviations.data(), {}};
  wheel.y = 4e-3;
  EXPECT_LT(farthest_from_steady(0.0, 0.7, 2, [] {}), 0.03);
  expect_steady();
}

TEST_F(SurfaceMemory, ZonesOfTheWheelTravelWithIt) {
  // a wheel that slides everywhere is moved aside at rest, with its zone of little friction
  const double zone_y[] = {-1.0, 0.0, 1e-3, 1.0}, zone_coefficients[] = {0.1, 0.1, 0.4, 0.4};
  friction.zone_count = 4;
  friction.zone_y = zone_y;
  friction.zone_coefficients = zone_coefficients;
  friction.zone_frame = WRC_ZONES_WHEEL_PROFILE;
  stand(3e-3);
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 80e3;
  double lowest = 1.0, highest = 0.0;
  for (int k = 0; k < 60; ++k) {
    rest();
    wheel.velocity[0] = 0.05;
    wheel.velocity[1] = -0.05;
    wheel.y -= 0.05 * 1e-3;
    const wrc_wrench& now = go(1e-3);
    wrc_region region = sized<wrc_region>();
    ASSERT_EQ(wrc_contact_region(contact, 0, &region), WRC_OK);
    std::vector<double> coefficients(static_cast<std::size_t>(region.strip_count));
    ASSERT_EQ(wrc_contact_field(contact, 0, WRC_FIELD_STRIP_FRICTION, coefficients.data(),
                                coefficients.size(), nullptr),
              WRC_OK);
    const double mean = std::hypot(region.longitudinal_force, region.lateral_force) / region.normal_force;
    if (k < 10 || now.region_count > 1) continue;
    const auto [least, most] = std::minmax_element(coefficients.begin(), coefficients.end());
    EXPECT_GE(mean, *least * 0.97) << k;
    EXPECT_LE(mean, *most * 1.001) << k << ": strips are curved, the normal force is a resultant";
    lowest = std::min(lowest, *least);
    highest = std::max(highest, *most);
  }
  EXPECT_LT(lowest, 0.11);
  EXPECT_GT(highest, 0.39);
}

TEST_F(SurfaceMemory, RestsWithoutCreep) {
  wheel.velocity[0] = 1e-3;
  go(2e-3);
  const wrc_wrench held = wrench;
  EXPECT_GT(std::abs(held.force[0]), 0.05 * limit);
  EXPECT_EQ(held.flags, 0U) << "no speed is too small";
  rest();
  for (const double time : {1e-6, 1e-2, 3600.0, 1e5}) EXPECT_LT(apart(held, go(time)), 1e-12);
  EXPECT_EQ(wrench.power, 0.0);
}

TEST_F(SurfaceMemory, ShiftsAtRestAreCattaneosAndMindlins) {
  wrc_region region = sized<wrc_region>();
  ASSERT_EQ(wrc_contact_region(contact, 0, &region), WRC_OK);
  const double a = region.ellipse.a, b = region.ellipse.b, G = config.wheel_material.shear_modulus,
               nu = config.wheel_material.poisson;
  // full slip of an ellipse, by the mean of its radius over angles
  double sum = 0.0;
  constexpr int angles = 720;
  for (int i = 0; i < angles; ++i) {
    const double t = 2.0 * 3.14159265358979 * i / angles, c = std::cos(t), s = std::sin(t);
    sum += ((1.0 - nu) + nu * c * c) / std::sqrt(c * c / (a * a) + s * s / (b * b));
  }
  const double peak = 1.5 * limit / (3.14159265358979 * a * b);
  const double slips = peak / (4.0 * G) * sum * 2.0 * 3.14159265358979 / angles;
  const auto cattaneo = [](double d) { return d >= 1.0 ? 1.0 : 1.0 - std::pow(1.0 - d, 1.5); };
  // forth to 0.8 of full slip, back to -0.8, and forth again
  double shift = 0.0, worst = 0.0;
  const auto shift_by = [&](double part) {
    wheel.velocity[0] = part * slips / 1e-3;
    go(1e-3);
    shift += part;
    return -(wrench.force[0] - standing.force[0]) / limit;
  };
  for (int i = 0; i < 20; ++i) worst = std::max(worst, std::abs(shift_by(0.04) - cattaneo(shift)));
  const double turned = shift;
  for (int i = 0; i < 40; ++i)
    worst = std::max(worst,
                     std::abs(shift_by(-0.04) - (cattaneo(turned) - 2.0 * cattaneo((turned - shift) / 2.0))));
  for (int i = 0; i < 40; ++i)
    worst = std::max(worst,
                     std::abs(shift_by(0.04) - (-cattaneo(turned) + 2.0 * cattaneo((turned + shift) / 2.0))));
  EXPECT_LT(worst, 0.03) << "of mu N: this patch is no ellipse";
}

TEST_F(SurfaceMemory, BackwardsIsTheMirrorImage) {
  stand(0.0);
  roll(2.0);
  wheel.velocity[1] = 1e-3;
  for (int i = 0; i < 4; ++i) go(1e-3);
  const wrc_wrench forwards = wrench;
  stand(0.0);
  roll(-2.0);
  wheel.velocity[1] = 1e-3;
  for (int i = 0; i < 4; ++i) go(1e-3);
  EXPECT_NEAR(wrench.force[0], -forwards.force[0], 1e-9 * limit);
  EXPECT_NEAR(wrench.force[1], forwards.force[1], 1e-9 * limit);
}

TEST_F(SurfaceMemory, RollsThroughStandstillAndTurnsWithoutAJump) {
  roll(0.5);
  for (int i = 0; i < 20; ++i) go(1e-3);
  // speeds of the next step through zero, at one sliding velocity
  wrc_wrench before{};
  for (int i = -200; i <= 200; ++i) {
    const double speed = 1e-4 * i;
    wheel.velocity[0] = speed + 5e-4;
    wheel.angular_velocity[1] = -speed / 0.46;
    go(1e-3, false);
    if (i > -200) {
      EXPECT_LT(apart(wrench, before), 2e-3) << speed;
    }
    before = wrench;
  }
  EXPECT_EQ(wrench.flags, 0U);
  // its length in time from none to some lengths of the contact
  roll(0.5);
  for (int i = 0; i <= 1000; ++i) {
    go(1e-4 * i, false);  // 50 um further
    if (i > 0) {
      EXPECT_LT(apart(wrench, before), 2e-2) << i;
    }
    before = wrench;
  }
}

TEST_F(SurfaceMemory, CellsThatBeginToSlideDoNotLeap) {
  // Newton's method of a host sees nanometres. Slips of a step grow by 1 nm: forces bend and never jump.
  roll(2.0);
  for (int i = 0; i < 3; ++i) go(1e-3);
  const double rate = wheel.angular_velocity[1];
  double last[2] = {}, worst = 0.0;
  for (int k = 0; k < 3000; ++k) {
    wheel.angular_velocity[1] = rate - k * 1e-9 / (0.46 * 1e-3);
    go(1e-3, false);
    if (k > 1) worst = std::max(worst, std::abs(wrench.force[0] - 2.0 * last[0] + last[1]) / limit);
    last[1] = last[0];
    last[0] = wrench.force[0];
  }
  EXPECT_LT(worst, 1e-6);
}

TEST_F(SurfaceMemory, RegionsJoinAndPartWithoutAJump) {
  for (const double from : {-6.2e-3, -1e-3, 3e-3}) {
    stand(from);
    roll(1.0);
    for (int i = 0; i < 5; ++i) go(1e-3);
    wrc_wrench before{}, last{};
    for (int i = 0; i < 1500; ++i) {  // 1 um further
      wheel.y = from + 1e-6 * i;
      wheel.velocity[1] = 1e-3;
      input.time_step = 4e-3;
      ASSERT_GE(step(), WRC_OK) << error();
      if (i > 1) {  // beside the slope, which is that of the normal forces
        const double x = wrench.force[0] - 2.0 * last.force[0] + before.force[0],
                     y = wrench.force[1] - 2.0 * last.force[1] + before.force[1];
        EXPECT_LT(std::hypot(x, y), 2e-3 * friction.coefficient * wrench.normal_force) << wheel.y;
      }
      before = last;
      last = wrench;
    }
  }
}

TEST_F(SurfaceMemory, StripsThatLeaveAndReturnDoNotLeap) {
  wheel.yaw = 1e-3;
  stand(4e-3);
  roll(1.0);
  wheel.velocity[1] = 3e-4;
  for (int i = 0; i < 8; ++i) go(1e-3);
  // half of the load, so that strips are without contact that had tractions
  wrc_wrench before{}, last{};
  for (int i = 0; i < 300; ++i) {
    wheel.y = 4e-3 - 600e-6 + 1e-6 * i;
    const wrc_wrench& now = go(4e-3, false);
    const double x = now.force[0] - 2.0 * last.force[0] + before.force[0],
                 y = now.force[1] - 2.0 * last.force[1] + before.force[1];
    if (i > 1) {
      EXPECT_LT(std::hypot(x, y), 1e-3 * friction.coefficient * now.normal_force) << i;
    }
    before = last;
    last = now;
  }
}

TEST_F(SurfaceMemory, RegionsThatVanishDoNotLeap) {
  // roll changes by 1 mrad within 4 mm, which takes the flange off; 1 urad of it is scanned
  wheel.roll = -4e-3;
  stand(3e-3);
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 80e3;
  roll(1.0);
  wheel.velocity[1] = 3e-4;
  for (int i = 0; i < 8; ++i) go(1e-3);
  for (const double off : {150e-6, 1000e-6}) {
    wrc_wrench before{}, last{};
    int32_t fewest = 9, most = 0;
    for (int i = 0; i < 60; ++i) {
      wheel.roll = -4e-3 + off + 1e-6 * i;
      const wrc_wrench& now = go(4e-3, false);
      fewest = std::min(fewest, now.region_count);
      most = std::max(most, now.region_count);
      const double x = now.force[0] - 2.0 * last.force[0] + before.force[0],
                   y = now.force[1] - 2.0 * last.force[1] + before.force[1];
      if (i > 1) {
        EXPECT_LT(std::hypot(x, y), 1e-3 * friction.coefficient * now.normal_force) << wheel.roll;
      }
      before = last;
      last = now;
    }
    EXPECT_EQ(fewest, 1);
    EXPECT_EQ(most, 2);
  }
}

TEST_F(SurfaceMemory, DerivativesAreThoseOfTheStep) {
  config.surface.tolerance = 1e-9;  // differences see the pressures' own
  struct Kind {
    double y, before, speed, time, across;
  };
  const Kind kinds[] = {{4e-3, 0.0, 0.0, 1e-3, 3e-3},    {4e-3, 2.0, 2.0, 1e-3, 1e-3},
                        {1e-3, 1.0, -0.7, 2e-3, -3e-4},  {4e-3, 20.0, 20.0, 5e-4, 0.5},
                        {-6.2e-3, 2.0, 2.0, 3e-3, 2e-3}, {-1e-3, 5.0, 5.0, 2e-3, 4e-3}};
  for (const Kind& kind : kinds) {
    stand(kind.y);
    roll(kind.before);
    for (int i = 0; i < 3; ++i) go(1e-3);
    roll(kind.speed);
    wheel.velocity[0] += 1e-3;
    wheel.velocity[1] += kind.across;
    wheel.angular_velocity[2] = 0.02;
    input.time_step = kind.time;
    wrc_wrench_derivatives found = sized<wrc_wrench_derivatives>();
    ASSERT_EQ(wrc_contact_wrench_derivatives(contact, &input, &wrench, &found), WRC_OK) << error();
    EXPECT_TRUE(same_bits(wrench, go(kind.time, false)));
    const auto compare = [&](double& number, double h, int column) {
      const double value = number;
      wrc_wrench ends[2];
      for (int end = 0; end < 2; ++end) {
        number = value + (end == 0 ? -h : h);
        ASSERT_EQ(step(), WRC_OK) << error();
        ends[end] = wrench;
      }
      number = value;
      for (int i = 0; i < 2; ++i) {
        const double difference = (ends[1].force[i] - ends[0].force[i]) / (2.0 * h);
        const double largest = std::max(std::abs(ends[1].force[0] - ends[0].force[0]),
                                        std::abs(ends[1].force[1] - ends[0].force[1])) /
                               (2.0 * h);
        EXPECT_NEAR(found.wrench[i][column], difference, 2e-4 * largest + 1e-9 * limit / h)
            << "row " << i << " column " << column << " at " << kind.y << " speed " << kind.speed;
      }
    };
    for (const int column : {WRC_BY_VELOCITY_X, WRC_BY_VELOCITY_Y, WRC_BY_ANGULAR_VELOCITY_Y,
                             WRC_BY_ANGULAR_VELOCITY_Z, WRC_BY_RAIL_Y_VELOCITY})
      compare(wrench_input(input, column), 1e-10 / kind.time, column);
    for (const int column : {WRC_BY_Y, WRC_BY_YAW}) compare(wrench_input(input, column), 2e-9, column);
    compare(input.time_step, 1e-6 * kind.time, WRC_BY_TIME_STEP);
    EXPECT_GT(std::abs(found.wrench[0][WRC_BY_TIME_STEP]) + std::abs(found.wrench[1][WRC_BY_TIME_STEP]), 0.0);
  }
}

TEST_F(SurfaceMemory, WhatCannotBeIsRefusedWithASentence) {
  roll(2.0);
  go(1e-3, false);
  input.time_step = -1e-3;
  EXPECT_EQ(step(), WRC_ERROR_RANGE);
  ReferenceWheel::expect_words(error(), {"input.time_step", "-0.001 s"});
  EXPECT_EQ(wrc_contact_commit(contact), WRC_ERROR_SEQUENCE) << "of a call that failed";
  go(1e-3);
  EXPECT_EQ(wrc_contact_commit(contact), WRC_ERROR_SEQUENCE);
  ReferenceWheel::expect_words(error(), {"committed", "wrc_contact_wrench"});

  // forgotten time, and a wheel that is somewhere else
  wheel.y += 1e-4;
  input.time_step = 0.0;
  EXPECT_EQ(step(), WRC_ERROR_RANGE);
  ReferenceWheel::expect_words(error(), {"input.time_step", "wrc_contact_commit"});
  wheel.y += 8e-3;
  wheel.z -= 1e-4;
  input.time_step = 1e-5;
  EXPECT_GT(step(), WRC_OK);
  EXPECT_NE(wrench.flags & WRC_FLAG_BIT(WRC_FLAG_MEMORY_DROPPED), 0U) << error();
  wheel.y -= 8.1e-3;
  wheel.z += 1e-4;

  friction.temperature_law = WRC_TEMPERATURE_LAW_LINEAR;
  EXPECT_EQ(step(), WRC_ERROR_UNSUPPORTED);
  friction.temperature_law = WRC_TEMPERATURE_LAW_NONE;
  friction.layer_yield = 1e8;
  EXPECT_EQ(step(), WRC_ERROR_UNSUPPORTED);
  ReferenceWheel::expect_words(error(), {"layer_yield", "config.surface.memory"});
  friction.layer_yield = 0.0;

  // a contact without memory
  config.surface.memory = 0;
  create();
  input.time_step = 1e-3;
  EXPECT_EQ(step(), WRC_ERROR_UNSUPPORTED);
  ReferenceWheel::expect_words(error(), {"input.time_step", "config.surface.memory"});
  input.time_step = 0.0;
  EXPECT_GE(step(), WRC_OK) << error();
  EXPECT_EQ(wrc_contact_commit(contact), WRC_ERROR_UNSUPPORTED);
  ReferenceWheel::expect_words(error(), {"config.surface.memory", "wrc_contact_mark"});

  // methods that remember nothing, and models without a rail
  char text[300];
  config.surface.memory = 1;
  config.tangential.method = WRC_TANGENTIAL_FASTSIM;
  EXPECT_EQ(wrc_config_check(&config, text, sizeof text), WRC_ERROR_UNSUPPORTED);
  ReferenceWheel::expect_words(text, {"config.surface.memory", "STRIP_FASTSIM"});
  config = test_config();
  config.surface.memory = 1;
  EXPECT_EQ(wrc_config_check(&config, text, sizeof text), WRC_ERROR_UNSUPPORTED);
  ReferenceWheel::expect_words(text, {"config.surface.memory", "profiles"});
}

TEST_F(SurfaceMemory, StripsForgetWhereTheBodiesPart) {
  roll(2.0);
  for (int i = 0; i < 5; ++i) go(1e-3);
  const double z = wheel.z;
  wheel.z -= 5e-4;
  input.time_step = 1e-3;
  EXPECT_EQ(step(), WRC_FLAG_NO_CONTACT);
  commit();
  wheel.z = z;
  rest();
  input.time_step = 1e-3;
  EXPECT_EQ(step(), WRC_OK) << error();
  EXPECT_LT(apart(wrench, standing), 1e-6);  // whose height was found to a part of the load
}

}  // namespace
