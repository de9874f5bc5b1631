/// Resolution, tolerance and work of a wheel on a rail (config.surface), and marked solutions to start from.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "reference_contact.hpp"
#include "wheel_on_rail.hpp"

namespace {

class Resolution : public testing::Test, protected PlacedWheel {
 protected:
  Resolution() {
    take_reference_bodies();
    roll_with_a_little_of_everything();
  }
  void use(const char* name) { ASSERT_EQ(wrc_config_use(&config, name, nullptr, 0), WRC_OK); }
  /// The wrench of a step that works.
  wrc_wrench solved(int32_t start = WRC_START_COLD) {
    input.start = start;
    EXPECT_EQ(step(), WRC_OK) << error();
    return wrench;
  }
  std::vector<unsigned char> saved() {
    uint64_t bytes = 0;
    EXPECT_EQ(wrc_contact_state_size(model, &bytes), WRC_OK);
    std::vector<unsigned char> state(bytes);
    EXPECT_EQ(wrc_contact_save(contact, state.data(), bytes), WRC_OK);
    return state;
  }
  int32_t strips() {
    int32_t count = 0;
    for (int32_t i = 0; i < wrench.region_count; ++i) {
      wrc_region region = sized<wrc_region>();
      EXPECT_EQ(wrc_contact_region(contact, i, &region), WRC_OK);
      count += region.strip_count;
    }
    return count;
  }
};

bool same_bits(const wrc_wrench& a, const wrc_wrench& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

TEST_F(Resolution, SettingsHaveTheMembersOfTheirRow) {
  const wrc_config before = config;
#define WRC_RESOLUTION(identifier, name, tread, corner, small, work, iterations) \
  use(name);                                                                     \
  EXPECT_EQ(config.surface.tread_width, tread);                                  \
  EXPECT_EQ(config.surface.corner_width, corner);                                \
  EXPECT_EQ(config.surface.tolerance, small);                                    \
  EXPECT_EQ(config.surface.max_work, work);                                      \
  EXPECT_EQ(config.surface.max_iterations, iterations);
  WRC_RESOLUTION_LIST(WRC_RESOLUTION)
#undef WRC_RESOLUTION
  use("default");
  EXPECT_EQ(std::memcmp(&config, &before, sizeof config), 0) << "defaults are those of the setting";
}

TEST_F(Resolution, StripsAreAsWideAsAsked) {
  create();
  const wrc_wrench fine = solved();
  const int32_t many = strips();
  use("real time");
  create();
  const wrc_wrench coarse = solved();
  EXPECT_NEAR(strips(), 0.5 * many, 1.5);
  EXPECT_NEAR(coarse.normal_force, fine.normal_force, 1e-2 * fine.normal_force);
  EXPECT_LT(coarse.work, 0.25 * fine.work);
}

TEST_F(Resolution, TheToleranceBoundsTheResidual) {
  config.surface.tolerance = 1e-9;
  create();
  const wrc_wrench exact = solved();
  EXPECT_LE(exact.residual, 1e-9);
  double error = 1.0;
  for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
    config.surface.tolerance = tolerance;
    create();
    const wrc_wrench near = solved();
    EXPECT_LE(near.residual, tolerance);
    const double here = std::fabs(near.normal_force / exact.normal_force - 1.0);
    EXPECT_LT(here, 0.3 * tolerance);
    EXPECT_LT(here, error);
    error = here;
  }
}

TEST_F(Resolution, MembersThatNothingReadsAreRefused) {
  char text[512];
  config.surface.corner_width = 0.8e-3;
  EXPECT_EQ(wrc_config_check(&config, text, sizeof text), WRC_ERROR_RANGE);
  ReferenceWheel::expect_words(text, {"config.surface.corner_width", "0.0008", "tread_width"});
  config.surface = test_config().surface;
  config.normal.method = WRC_NORMAL_EKP_ELLIPSE;
  config.surface.tolerance = 1e-4;
  EXPECT_EQ(wrc_config_check(&config, text, sizeof text), WRC_ERROR_UNSUPPORTED);
  ReferenceWheel::expect_words(text, {"config.surface.tolerance"});
  config = test_config();
  config.surface.tread_width = 1e-3;
  EXPECT_EQ(wrc_config_check(&config, text, sizeof text), WRC_ERROR_UNSUPPORTED)
      << "a model without profiles";
  config = test_config();
  config.planar.start = WRC_START_MARK;
  EXPECT_EQ(wrc_config_check(&config, text, sizeof text), WRC_ERROR_UNSUPPORTED);
  ReferenceWheel::expect_words(text, {"config.planar.start", "wrc_contact_wrench"});
}

// With work for two iterations a call returns what it has, and calls from the last solution go on to the end.
TEST_F(Resolution, WorkIsBoundedAndTheNextCallGoesOn) {
  config.surface.tolerance = 1e-7;
  create();
  const wrc_wrench exact = solved();
  const double n = strips();
  config.surface.max_work = std::floor(6.0 * n * n);
  create();
  input.start = WRC_START_WARM;
  double residual = 1.0;
  int32_t calls = 0;
  for (; calls < 40 && step() == WRC_FLAG_ITERATION_CAP; ++calls) {
    EXPECT_LE(wrench.work, config.surface.max_work);
    EXPECT_GT(wrench.residual, config.surface.tolerance);
    EXPECT_LT(wrench.residual, 1.5 * residual) << calls;
    residual = wrench.residual;
    EXPECT_NEAR(wrench.force[2], exact.force[2], residual * std::fabs(exact.force[2]));
  }
  EXPECT_GE(calls, 2);
  EXPECT_LT(calls, 40);
  EXPECT_NEAR(wrench.force[2], exact.force[2], 1e-7 * std::fabs(exact.force[2]));
  // a prescribed load has the same work for all its heights
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 80e3;
  wheel.z = 0.0;
  input.start = WRC_START_COLD;
  EXPECT_EQ(step(), WRC_FLAG_ITERATION_CAP);
  EXPECT_LE(wrench.work, config.surface.max_work + 3.0 * n * n)
      << "the last height has an iteration at least";
  EXPECT_NEAR(-wrench.force[2], 80e3, 40e3);
}

/// A limit in iterations is by the strips that overlap: it cuts calls of small contacts and of large ones,
/// which go on.
TEST_F(Resolution, IterationsOfAHeightAreBounded) {
  config.surface.tolerance = 1e-7;
  create();
  const wrc_wrench exact = solved();
  config.surface.max_iterations = 2.0;
  create();
  input.start = WRC_START_WARM;
  int32_t calls = 0;
  for (; calls < 40 && step() == WRC_FLAG_ITERATION_CAP; ++calls) EXPECT_LT(wrench.work, 0.6 * exact.work);
  EXPECT_GE(calls, 2);
  EXPECT_LT(calls, 40);
  EXPECT_NEAR(wrench.force[2], exact.force[2], 1e-7 * std::fabs(exact.force[2]));
}

// Poses of an integrator: trial states, a Jacobian by differences.
TEST_F(Resolution, FromAMarkTheOrderOfCallsDoesNotCount) {
  use("real time");
  create();
  EXPECT_EQ(wrc_contact_mark(contact), WRC_ERROR_SEQUENCE);
  ReferenceWheel::expect_words(error(), {"wrc_contact_mark", "wrc_contact_wrench"});
  const double y = wheel.y, z = wheel.z, yaw = wheel.yaw;
  constexpr std::size_t count = 24;
  const auto place = [&](std::size_t k) {
    const double t = static_cast<double>(k);
    wheel.y = y + (k % 3 == 0 ? 1e-9 : 5e-6) * std::sin(1.7 * t);
    wheel.z = z + 3e-6 * std::sin(2.9 * t) + (k == 11 ? 5e-3 : 0.0) - (k == 17 ? 5e-3 : 0.0);
    wheel.yaw = yaw + 1e-5 * std::sin(t);
  };
  const auto call = [&](std::size_t k, int32_t start) {
    place(k);
    input.start = start;
    wrench = sized<wrc_wrench>();
    step();
    return wrench;
  };
  const wrc_wrench anew = solved();
  EXPECT_TRUE(same_bits(anew, solved(WRC_START_MARK))) << "before the first mark";
  ASSERT_EQ(wrc_contact_mark(contact), WRC_OK);
  const std::vector<unsigned char> marked = saved();
  // forwards; backwards with calls between that start elsewhere; after a restore; with derivatives
  std::array<wrc_wrench, count> first;
  for (std::size_t k = 0; k < count; ++k) first[k] = call(k, WRC_START_MARK);
  EXPECT_LT(first[1].iterations, anew.iterations);
  for (std::size_t k = count; k-- > 0;) {
    call((7 * k + 5) % count, k % 2 == 0 ? WRC_START_WARM : WRC_START_COLD);
    EXPECT_TRUE(same_bits(call(k, WRC_START_MARK), first[k])) << k;
  }
  take(WRC_SIDE_RIGHT);
  ASSERT_EQ(wrc_contact_restore(contact, marked.data(), marked.size()), WRC_OK);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t other = (5 * k + 3) % count;
    EXPECT_TRUE(same_bits(call(other, WRC_START_MARK), first[other])) << other;
    place(other);
    wrc_wrench_derivatives derivatives = sized<wrc_wrench_derivatives>();
    wrench = sized<wrc_wrench>();
    wrc_contact_wrench_derivatives(contact, &input, &wrench, &derivatives);
    EXPECT_TRUE(same_bits(wrench, first[other])) << other;
  }
  // a prescribed load is searched from the marked height
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 80e3;
  const auto loaded = [&](int32_t start) {
    wheel.y = y;
    wheel.z = 0.0;
    wheel.yaw = yaw;
    return solved(start);
  };
  const wrc_wrench from_mark = loaded(WRC_START_MARK);
  loaded(WRC_START_WARM);
  EXPECT_TRUE(same_bits(loaded(WRC_START_MARK), from_mark));
}

// A refused call leaves nothing to mark, and the mark as it was.
TEST_F(Resolution, ARefusedCallChangesNoMark) {
  create();
  solved();
  ASSERT_EQ(wrc_contact_mark(contact), WRC_OK);
  wheel.y += 10e-6;
  const wrc_wrench next = solved(WRC_START_MARK);
  wheel.y = NAN;
  EXPECT_EQ(step(), WRC_ERROR_NOT_FINITE);
  EXPECT_EQ(wrc_contact_mark(contact), WRC_ERROR_SEQUENCE);
  roll_with_a_little_of_everything();
  wheel.y += 10e-6;
  EXPECT_TRUE(same_bits(solved(WRC_START_MARK), next));
  EXPECT_EQ(wrc_contact_mark(nullptr), WRC_ERROR_NULL);
}

}  // namespace
