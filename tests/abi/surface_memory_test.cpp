/// config.surface.memory, wrc_contact_commit() and input.time_step: a wheel on a rail that remembers its
/// tractions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
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
  const auto steady = [&] {
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
  };
  for (const double y : {4e-3, 0.0, -1e-3}) {
    stand(y);
    roll(2.0);
    const wrc_wrench end = steady();
    for (int i = 0; i < 50; ++i) go(4e-4);  // 40 mm, 3.5 lengths
    EXPECT_LT(apart(wrench, end), 2e-3) << y;
    for (int i = 0; i < 50; ++i) go(4e-4);
    EXPECT_LT(apart(wrench, end), 1e-4) << y;
    // in one step over many lengths
    stand(y);
    roll(2.0);
    go(0.1);
    EXPECT_EQ(std::memcmp(wrench.force, end.force, sizeof end.force), 0) << y;
  }
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
