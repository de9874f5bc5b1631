/// A contact's state for another process: equal bits there, and what is not its state refused.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "test_config.hpp"
#include "wheel_on_rail.hpp"

namespace {

using Bytes = std::vector<char>;

class PortableState : public testing::Test, protected PlacedWheel {
 protected:
  PortableState() {
    config.planar.start = WRC_START_WARM;
    wheel.y = 4e-3;
    wheel.z = 0.1e-3;
    wheel.yaw = 5e-3;
  }
  /// Wheel on a rail and step from a pose, both with the warm start of the calls before.
  void go_on(int calls, Bytes* results = nullptr) {
    wrc_planar_input planar = wrc_planar_input_default();
    planar.load.normal_force = 80e3;
    planar.creepage.longitudinal = 1e-3;
    wrc_planar_output output = sized<wrc_planar_output>();
    for (int i = 0; i < calls; ++i) {
      wheel.y += 13e-6;
      planar.pose.lateral = wheel.y;
      ASSERT_EQ(step(), WRC_OK) << error();
      ASSERT_EQ(wrc_planar_step(contact, &planar, &output), WRC_OK);
      if (results == nullptr) continue;
      const auto* const of_wrench = reinterpret_cast<const char*>(&wrench);
      const auto* const of_output = reinterpret_cast<const char*>(&output);
      results->insert(results->end(), of_wrench, of_wrench + sizeof wrench);
      results->insert(results->end(), of_output, of_output + sizeof output);
    }
  }
  Bytes save() {
    uint64_t bytes = 0;
    EXPECT_EQ(wrc_contact_portable_size(model, &bytes), WRC_OK);
    Bytes state(bytes);
    EXPECT_EQ(wrc_contact_save_portable(contact, state.data(), bytes), WRC_OK);
    return state;
  }
  int32_t restore(const Bytes& state) {
    return wrc_contact_restore_portable(contact, state.data(), state.size());
  }
  void expect_refused(const Bytes& state, int32_t status, const char* word) {
    const Bytes before = save();
    EXPECT_EQ(restore(state), status);
    EXPECT_NE(error().find(word), std::string::npos) << error();
    const Bytes after = save();
    EXPECT_EQ(std::memcmp(before.data() + 64 + 64 + 64, after.data() + 64 + 64 + 64, before.size() - 192), 0);
  }
};

constexpr const char* files = "WRC_PORTABLE_STATE_FILES";

int set_environment(const char* name, const char* value) {
#ifdef _WIN32
  return _putenv_s(name, value);
#else
  return setenv(name, value, 1);
#endif
}

Bytes read_file(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}
void write_file(const std::string& name, const Bytes& bytes) {
  std::ofstream(name, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// The other process: run by the test below.
TEST_F(PortableState, DISABLED_TheOtherProcess) {
  const char* const name = std::getenv(files);
  ASSERT_NE(name, nullptr);
  config.instruction_set = WRC_INSTRUCTIONS_BASELINE;
  create();
  ASSERT_EQ(restore(read_file(std::string(name) + ".state")), WRC_OK) << error();
  wrc_region region = sized<wrc_region>();
  EXPECT_EQ(wrc_contact_region(contact, 0, &region), WRC_OK);
  wheel.y += 5 * 13e-6;
  Bytes results;
  go_on(4, &results);
  write_file(std::string(name) + ".results", results);
}

TEST_F(PortableState, AnotherProcessGoesOnWithTheSameBits) {
  create();
  go_on(5);
  const std::string name =
      testing::TempDir() + "wrc_portable_" + std::to_string(std::random_device{}());  // beside other runs
  write_file(name + ".state", save());
  wheel.y = 4e-3;
  for (int i = 0; i < 5; ++i) wheel.y += 13e-6;
  Bytes results;
  const double y = wheel.y;
  go_on(4, &results);
  ASSERT_EQ(set_environment(files, name.c_str()), 0);
  ASSERT_EQ(set_environment("GTEST_TOTAL_SHARDS", "1"), 0);  // this process may run a part of the tests
  ASSERT_EQ(set_environment("GTEST_SHARD_INDEX", "0"), 0);
  const std::string command =
      testing::internal::GetArgvs()[0] +
      " --gtest_filter=PortableState.DISABLED_TheOtherProcess --gtest_also_run_disabled_tests > " + name +
      ".log";
  const int status = std::system(command.c_str());
  const Bytes log = read_file(name + ".log");
  EXPECT_EQ(status, 0) << std::string(log.begin(), log.end());
  const Bytes there = read_file(name + ".results");
  ASSERT_EQ(there.size(), results.size());
  EXPECT_EQ(there, results);
  // a cold contact would not have had them
  create();
  wheel.y = y;
  Bytes cold;
  go_on(4, &cold);
  EXPECT_NE(cold, results);
  for (const char* end : {".state", ".results", ".log"}) std::remove((name + end).c_str());
}

TEST_F(PortableState, EqualStatesHaveEqualBytes) {
  create();
  go_on(3);
  const Bytes state = save();
  EXPECT_EQ(std::memcmp(state.data(), "wrcstate", 8), 0);
  wrc_contact* const first = contact;
  contact = nullptr;
  take(WRC_SIDE_RIGHT);
  ASSERT_EQ(restore(state), WRC_OK);
  EXPECT_EQ(save(), state);
  wrc_contact_destroy(first);
}

TEST_F(PortableState, TheLastStatusSurvivesWithoutItsSentence) {
  create();
  wheel.y = 1.0;
  ASSERT_EQ(step(), WRC_ERROR_RANGE);
  const Bytes state = save();
  wheel.y = 4e-3;
  ASSERT_EQ(step(), WRC_OK);
  ASSERT_EQ(restore(state), WRC_OK);
  EXPECT_EQ(error(), wrc_status_text(WRC_ERROR_RANGE));
}

TEST_F(PortableState, OtherConfigurationsAreRefused) {
  create();
  const Bytes state = save();
  const wrc_config ours = config;
  const auto refused = [&] {
    create();
    expect_refused(state, WRC_ERROR_SEQUENCE, "configuration or profiles");
    config = ours;
  };
  config.wheel_material.shear_modulus *= 1.0 + 1e-15;
  refused();
  config.wheelset.wheel_radius = 0.4600001;
  refused();
  config.rail.kind = WRC_PROFILE_60E1;
  refused();
  config.planar.max_sweeps = 17;
  refused();
  config.planar.cells = 33;
  refused();
  config.planar.regularisation = WRC_REGULARISE_KEEP_RATIO;
  refused();
  create(WRC_SIDE_LEFT);
  expect_refused(state, WRC_ERROR_SEQUENCE, "other side");
  create();
  EXPECT_EQ(restore(state), WRC_OK);
}

TEST_F(PortableState, PointsOfAProfileBelongToTheConfiguration) {
  std::vector<double> y, z;
  for (int i = -60; i <= 60; ++i) {
    y.push_back(1e-3 * i);
    z.push_back(-0.025 * y.back());
  }
  config.wheel = sized<wrc_profile>();
  config.wheel.kind = WRC_PROFILE_POINTS;
  config.wheel.count = static_cast<uint32_t>(y.size());
  config.wheel.y = y.data();
  config.wheel.z = z.data();
  create();
  const Bytes state = save();
  z[70] += 1e-9;
  create();
  expect_refused(state, WRC_ERROR_SEQUENCE, "profiles");
  z[70] -= 1e-9;
  z[70] = -0.025 * y[70];
  create();
  EXPECT_EQ(restore(state), WRC_OK) << error();
}

TEST_F(PortableState, WhatIsDamagedIsRefused) {
  create();
  go_on(2);
  const Bytes state = save();
  for (const std::size_t left : {std::size_t{0}, std::size_t{10}, std::size_t{64}, state.size() - 1}) {
    Bytes cut(state.begin(), state.begin() + static_cast<std::ptrdiff_t>(left));
    cut.reserve(1);
    expect_refused(cut, WRC_ERROR_FILE, "end is missing");
  }
  // any byte: of the mark, the header, the state
  for (std::size_t at = 0; at < state.size(); at += at < 64 ? 1 : 397) {
    for (const char flip : {'\x01', '\x80'}) {
      Bytes changed = state;
      changed[at] = static_cast<char>(changed[at] ^ flip);
      EXPECT_LT(restore(changed), 0) << at;
    }
  }
  Bytes changed = state;
  changed[state.size() / 2] = static_cast<char>(changed[state.size() / 2] ^ 4);
  expect_refused(changed, WRC_ERROR_FILE, "bytes of it have changed");
  changed = state;
  changed[0] = 'W';
  expect_refused(changed, WRC_ERROR_FILE, "does not begin");
  changed = state;
  std::swap(changed[8], changed[11]);
  std::swap(changed[9], changed[10]);
  expect_refused(changed, WRC_ERROR_UNSUPPORTED, "byte order");
  changed = state;
  changed[16] = static_cast<char>(changed[16] + 1);  // the library's patch number
  expect_refused(changed, WRC_ERROR_UNSUPPORTED, "version");
  EXPECT_EQ(restore(state), WRC_OK);
  EXPECT_EQ(wrc_contact_restore_portable(contact, nullptr, 0), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_contact_restore_portable(nullptr, state.data(), state.size()), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_contact_save_portable(contact, changed.data(), changed.size() - 1), WRC_ERROR_BUFFER);
  EXPECT_EQ(wrc_contact_save_portable(contact, nullptr, changed.size()), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_contact_portable_size(model, nullptr), WRC_ERROR_NULL);
}

}  // namespace
