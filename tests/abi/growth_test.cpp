/// What a caller of another header meets: larger structs with and without members that this library does not
/// know, numbers kept for later, sizes of elements, the other half of an enumeration; flags and sentences.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "reference_contact.hpp"
#include "test_config.hpp"
#include "wheel_on_rail.hpp"
#include "wrc/wrc_offline.h"
#include "wrc/wrc_profiles.h"

namespace {

constexpr uint32_t most_newer_bytes = 1024;  // docs/abi.md

/// A struct as a newer header has it: `more` bytes behind those of today, and a guard behind these.
template <typename Struct>
class Newer {
 public:
  Newer(const Struct& known, uint32_t more, unsigned char tail = 0) : bytes_(sizeof known + more + 8, guard) {
    std::memcpy(bytes_.data(), &known, sizeof known);
    std::fill_n(bytes_.begin() + sizeof known, more, tail);
    if constexpr (requires { get()->struct_size; }) get()->struct_size = sizeof known + more;
  }
  Struct* get() { return reinterpret_cast<Struct*>(bytes_.data()); }
  Struct* operator->() { return get(); }
  unsigned char& tail(std::size_t at) { return bytes_[sizeof(Struct) + at]; }
  /// Today's bytes are those of `known` but for struct_size, the tail is zero, the guard as it was.
  void expect_is(const Struct& known) {
    Struct own = *get();
    EXPECT_EQ(own.struct_size, bytes_.size() - 8);
    own.struct_size = sizeof own;
    EXPECT_EQ(std::memcmp(&own, &known, sizeof own), 0);
    for (std::size_t i = sizeof own; i < bytes_.size(); ++i)
      ASSERT_EQ(bytes_[i], i < bytes_.size() - 8 ? 0 : guard) << i;
  }

 private:
  static constexpr unsigned char guard = 0xa5;
  std::vector<unsigned char> bytes_;
};

std::string sentence_of(wrc_contact* contact) {
  char text[512];
  EXPECT_EQ(wrc_contact_last_error(contact, text, sizeof text), WRC_OK);
  return text;
}

void expect_words(const std::string& sentence, const std::vector<std::string>& words) {
  ReferenceWheel::expect_words(sentence, words);
}

// ------------------------------------------------------------------------------------------- newer headers

class WheelOfANewerHeader : public testing::Test, protected PlacedWheel {
 protected:
  void SetUp() override {
    wheel.y = 2e-3;
    wheel.z = 0.2e-3;
    create();
  }
};

class PlaneOfANewerHeader : public ReferenceContact {};

TEST_F(WheelOfANewerHeader, IsSolvedAndWhatItDoesNotKnowIsZero) {
  wrc_wrench_derivatives derivatives = sized<wrc_wrench_derivatives>();
  wrc_region region = sized<wrc_region>();
  wrc_temperature temperature = sized<wrc_temperature>();
  wrc_stresses stresses = sized<wrc_stresses>();
  const double depth = 1e-3;
  ASSERT_EQ(wrc_contact_wrench_derivatives(contact, &input, &wrench, &derivatives), WRC_OK) << error();
  ASSERT_EQ(wrc_contact_region(contact, 0, &region), WRC_OK);
  ASSERT_EQ(wrc_contact_temperature(contact, 0, nullptr, &temperature), WRC_OK);
  ASSERT_EQ(wrc_contact_stresses(contact, 0, WRC_BODY_RAIL, &depth, 1, nullptr, &stresses), WRC_OK);
  for (const uint32_t more : {1U, 8U, most_newer_bytes}) {
    SCOPED_TRACE(more);
    Newer<wrc_wheel_input> their_input(input, more);
    Newer<wrc_wrench> their_wrench(sized<wrc_wrench>(), more, 0x77);
    Newer<wrc_wrench_derivatives> their_derivatives(sized<wrc_wrench_derivatives>(), more, 0x77);
    ASSERT_EQ(wrc_contact_wrench_derivatives(contact, their_input.get(), their_wrench.get(),
                                             their_derivatives.get()),
              WRC_OK)
        << error();
    their_wrench.expect_is(wrench);
    their_derivatives.expect_is(derivatives);
    Newer<wrc_region> their_region(sized<wrc_region>(), more, 0x77);
    ASSERT_EQ(wrc_contact_region(contact, 0, their_region.get()), WRC_OK);
    their_region.expect_is(region);
    Newer<wrc_temperature> their_temperature(sized<wrc_temperature>(), more, 0x77);
    ASSERT_EQ(wrc_contact_temperature(contact, 0, nullptr, their_temperature.get()), WRC_OK);
    their_temperature.expect_is(temperature);
    Newer<wrc_stresses> their_stresses(sized<wrc_stresses>(), more, 0x77);
    ASSERT_EQ(wrc_contact_stresses(contact, 0, WRC_BODY_RAIL, &depth, 1, nullptr, their_stresses.get()),
              WRC_OK);
    their_stresses.expect_is(stresses);

    // Zero they are after a failure, too.
    their_wrench.tail(0) = 0x77;
    their_input->wheel.z = 1.0;
    EXPECT_EQ(wrc_contact_wrench(contact, their_input.get(), their_wrench.get()), WRC_ERROR_RANGE);
    their_wrench.expect_is(sized<wrc_wrench>());
  }
}

TEST_F(WheelOfANewerHeader, WithAMemberThatIsNotKnownIsRefused) {
  const std::string size = std::to_string(sizeof input), larger = std::to_string(sizeof input + 16);
  for (const std::size_t at : {0, 7, 15}) {
    Newer<wrc_wheel_input> their_input(input, 16);
    their_input.tail(at) = 1;
    EXPECT_EQ(wrc_contact_wrench(contact, their_input.get(), &wrench), WRC_ERROR_STRUCT_SIZE) << at;
    expect_words(sentence_of(contact),
                 {"wrc_contact_wrench: input.struct_size = " + larger + " bytes is not " + size + " bytes",
                  "newer than the library", "Leave the member 0"});
    EXPECT_EQ(wrench.normal_force, 0.0);
    their_input.tail(at) = 0;
    EXPECT_EQ(wrc_contact_wrench(contact, their_input.get(), &wrench), WRC_OK);
    EXPECT_GT(wrench.normal_force, 0.0);
  }
}

TEST_F(WheelOfANewerHeader, OfNoHeaderIsRefused) {
  Newer<wrc_wheel_input> too_large(input, most_newer_bytes + 1);
  EXPECT_EQ(wrc_contact_wrench(contact, too_large.get(), &wrench), WRC_ERROR_STRUCT_SIZE);
  expect_words(sentence_of(contact), {"wrc_wheel_input.struct_size = 1745 bytes is outside 712 .. 1744 bytes",
                                      "set it to sizeof the struct"});
  Newer<wrc_wrench> result(sized<wrc_wrench>(), most_newer_bytes + 1, 0x77);
  EXPECT_EQ(wrc_contact_wrench(contact, &input, result.get()), WRC_ERROR_STRUCT_SIZE);
  EXPECT_EQ(result.tail(0), 0x77);  // not touched
  input.struct_size = 704;          // smaller than the first that was published
  EXPECT_EQ(step(), WRC_ERROR_STRUCT_SIZE);
}

TEST_F(PlaneOfANewerHeader, IsSolvedAndWhatItDoesNotKnowIsZero) {
  expect_works();
  wrc_planar_derivatives derivatives = sized<wrc_planar_derivatives>();
  ASSERT_EQ(wrc_planar_tangential_derivatives(contact, &derivatives), WRC_OK);
  Newer<wrc_planar_input> their_input(input, 24);
  Newer<wrc_planar_output> their_output(sized<wrc_planar_output>(), 40, 0x77);
  ASSERT_EQ(wrc_planar_step(contact, their_input.get(), their_output.get()), WRC_OK) << error();
  their_output.expect_is(output);
  Newer<wrc_planar_derivatives> their_derivatives(sized<wrc_planar_derivatives>(), 40, 0x77);
  ASSERT_EQ(wrc_planar_tangential_derivatives(contact, their_derivatives.get()), WRC_OK);
  their_derivatives.expect_is(derivatives);
  their_input.tail(23) = 0x80;
  EXPECT_EQ(wrc_planar_step(contact, their_input.get(), their_output.get()), WRC_ERROR_STRUCT_SIZE);
  expect_words(error(), {"wrc_planar_step: input.struct_size = " + std::to_string(sizeof input + 24),
                         "newer than the library"});
  their_output.expect_is(sized<wrc_planar_output>());
}

TEST_F(PlaneOfANewerHeader, OfAConfigurationMakesTheSameModel) {
  expect_works();
  const wrc_planar_forces plain = forces;
  Newer<wrc_config> theirs(config, 64);
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
  contact = nullptr;
  model = nullptr;
  char text[512];
  ASSERT_EQ(wrc_model_create(theirs.get(), nullptr, &model, text, sizeof text), WRC_OK) << text;
  ASSERT_EQ(wrc_contact_create(model, side, nullptr, &contact, nullptr, 0), WRC_OK);
  expect_works();
  EXPECT_EQ(std::memcmp(&plain, &forces, sizeof plain), 0);
  EXPECT_EQ(wrc_config_use(theirs.get(), "FASTSIM-SDEC", text, sizeof text), WRC_OK) << text;
  theirs.tail(63) = 1;
  EXPECT_EQ(wrc_config_check(theirs.get(), text, sizeof text), WRC_ERROR_STRUCT_SIZE);
  expect_words(text, {"wrc_config_check: config.struct_size = " + std::to_string(sizeof config + 64),
                      "newer than the library"});
}

TEST(DefaultsOfANewerHeader, AreZeroWhereTheLibraryKnowsNone) {
  const auto expect_defaults = [](auto known, auto init) {
    using Struct = decltype(known);
    Newer<Struct> theirs(sized<Struct>(), 32, 0x77);
    EXPECT_EQ(init(theirs.get()), WRC_OK);
    theirs.expect_is(known);
  };
  expect_defaults(wrc_config_default(), wrc_config_init);
  expect_defaults(wrc_wheel_input_default(), wrc_wheel_input_init);
  expect_defaults(wrc_planar_input_default(), wrc_planar_input_init);
  expect_defaults(wrc_wear_laws_default(), wrc_wear_laws_init);
  expect_defaults(wrc_damage_bins_default(), wrc_damage_bins_init);
  expect_defaults(wrc_exact_rolling_problem_default(), wrc_exact_rolling_problem_init);
  expect_defaults(wrc_conicity_problem_default(), wrc_conicity_problem_init);
}

// ----------------------------------------------------------------------------------- numbers kept for later

TEST_F(WheelOfANewerHeader, SetsNoNumberThatIsKeptForLater) {
  struct Kept {
    double* number;
    const char* name;
  };
  for (const Kept& each : {Kept{&wheel.reserved[5], "input.wheel.reserved[5]"},
                           Kept{&rail.reserved[0], "input.rail.reserved[0]"},
                           Kept{&input.frame.reserved[1], "input.frame.reserved[1]"},
                           Kept{&friction.reserved[3], "input.friction.reserved[3]"},
                           Kept{&friction.bulk.reserved[0], "input.friction.bulk.reserved[0]"}}) {
    for (const double value : {1.0, -5e-324}) {
      *each.number = value;
      EXPECT_EQ(step(), WRC_ERROR_RANGE) << each.name;
      expect_words(sentence_of(contact),
                   {std::string("wrc_contact_wrench: ") + each.name + " = ", "it is kept for later versions",
                    "must be 0", "newer than this library?"});
      EXPECT_EQ(wrench.normal_force, 0.0);
    }
    *each.number = 0.0;
  }
  input.reserved0 = 1;
  EXPECT_EQ(step(), WRC_ERROR_RANGE);
  expect_words(sentence_of(contact), {"input.reserved0 = 1", "it is kept for later versions"});
  input.reserved0 = 0;
  EXPECT_EQ(step(), WRC_OK) << error();
}

TEST_F(PlaneOfANewerHeader, SetsNoNumberThatIsKeptForLater) {
  for (double* const each : {&pose.reserved[2], &load.reserved[0], &creepage.reserved[3]}) {
    *each = 1e-3;
    expect_refused(WRC_ERROR_RANGE, {".reserved[", "it is kept for later versions"});
    *each = 0.0;
  }
  for (double* const each :
       {&config.wheel.reserved[0], &config.rail_material.reserved[4], &config.wheel_heat.reserved[1],
        &config.wheelset.reserved[5], &config.track.reserved[0], &config.normal.reserved[2],
        &config.tangential.reserved[3], &config.surface.reserved[8], &config.planar.reserved[7],
        &config.roundness.reserved[0], &config.check_rail.profile.reserved[5],
        &config.check_rail.reserved[1]}) {
    *each = 1.0;
    expect_config_refused(
        WRC_ERROR_RANGE, {"wrc_config_check: config.", ".reserved[", "= 1", "it is kept for later versions"});
    *each = 0.0;
  }
  wrc_allocator allocator = sized<wrc_allocator>();
  allocator.reserved[1] = 1.0;
  wrc_model* none = nullptr;
  char text[512];
  EXPECT_EQ(wrc_model_create(&config, &allocator, &none, text, sizeof text), WRC_ERROR_RANGE);
  expect_words(text, {"wrc_model_create: allocator.reserved[1] = 1", "it is kept for later versions"});
  EXPECT_EQ(none, nullptr);
}

// --------------------------------------------------------------------------------- structs that lie in
// arrays

TEST_F(WheelOfANewerHeader, HasSectionsOfTheSizeItSays) {
  wrc_rail_section section{};
  section.profile.kind = WRC_PROFILE_UIC60_BENCHMARK;
  std::vector<wrc_rail_section> sections(3, section);
  for (std::size_t k = 0; k < sections.size(); ++k) sections[k].distance = 5.0 * static_cast<double>(k) - 5.0;
  config.rail_section_count = 3;
  config.rail_sections = sections.data();
  char text[512];
  const auto check = [&] { return wrc_config_check(&config, text, sizeof text); };
  EXPECT_EQ(check(), WRC_ERROR_STRUCT_SIZE);
  expect_words(text, {"config.rail_section_size = 0 bytes is outside 168 .. 4096 bytes",
                      "set it to sizeof(wrc_rail_section)"});
  for (const uint32_t bad : {8U, static_cast<uint32_t>(sizeof section) - 8, 4097U}) {
    config.rail_section_size = bad;
    EXPECT_LT(check(), 0) << bad;
    expect_words(text, {"config.rail_section_size = " + std::to_string(bad), "sizeof(wrc_rail_section)"});
  }
  config.rail_section_size = sizeof section;
  create();
  ASSERT_EQ(step(), WRC_OK) << error();
  const wrc_wrench plain = wrench;

  constexpr std::size_t larger = sizeof section + 24;
  std::vector<double> room(3 * larger / sizeof(double));
  auto* const bytes = reinterpret_cast<unsigned char*>(room.data());
  for (std::size_t k = 0; k < 3; ++k) std::memcpy(bytes + k * larger, &sections[k], sizeof section);
  config.rail_section_size = larger;
  config.rail_sections = reinterpret_cast<const wrc_rail_section*>(bytes);
  create();
  ASSERT_EQ(step(), WRC_OK) << error();
  EXPECT_EQ(std::memcmp(&wrench, &plain, sizeof plain), 0);
  bytes[2 * larger + sizeof section + 23] = 1;
  EXPECT_EQ(check(), WRC_ERROR_STRUCT_SIZE);
  expect_words(text, {"config.rail_sections.struct_size[2] = 192 bytes", "newer than the library"});
}

TEST_F(WheelOfANewerHeader, HasBinsOfTheSizeItSays) {
  ASSERT_EQ(step(), WRC_OK) << error();
  std::vector<wrc_damage_bin> bin(141);
  wrc_damage_bins bins = wrc_damage_bins_default();
  bins.count = 140;
  bins.first = -0.07;
  bins.width = 1e-3;
  bins.bins = bin.data();
  wrc_accumulation accumulation = sized<wrc_accumulation>();
  accumulation.duration = 1.0;
  double work[141];
  for (const uint32_t bad : {0U, 8U, static_cast<uint32_t>(sizeof bin[0]) - 8, 4104U}) {
    SCOPED_TRACE(bad);
    bins.bin_size = bad;
    EXPECT_EQ(wrc_contact_accumulate(contact, &accumulation, &bins, nullptr, nullptr), WRC_ERROR_RANGE);
    expect_words(sentence_of(contact), {"wrc_contact_accumulate: wheel.bin_size = " + std::to_string(bad),
                                        "is outside 312 .. 4096"});
    EXPECT_EQ(wrc_damage_values(&bins, WRC_DAMAGE_WORK, work), WRC_ERROR_RANGE);
    EXPECT_EQ(wrc_damage_merge(&bins, &bins), WRC_ERROR_RANGE);
  }
  bins.bin_size = sizeof bin[0];
  ASSERT_EQ(wrc_contact_accumulate(contact, &accumulation, &bins, nullptr, nullptr), WRC_OK);
  ASSERT_EQ(wrc_damage_values(&bins, WRC_DAMAGE_WORK, work), WRC_OK);

  // A newer header's bins are larger; what this library does not know stays as it is.
  constexpr std::size_t larger = sizeof bin[0] + 16;
  std::vector<double> room(141 * larger / sizeof(double));
  auto* const bytes = reinterpret_cast<unsigned char*>(room.data());
  for (std::size_t k = 0; k < 141; ++k) std::fill_n(bytes + k * larger + sizeof bin[0], 16, 0x77);
  bins.bin_size = larger;
  bins.bins = reinterpret_cast<wrc_damage_bin*>(bytes);
  ASSERT_EQ(wrc_contact_accumulate(contact, &accumulation, &bins, nullptr, nullptr), WRC_OK);
  double of_larger[141];
  ASSERT_EQ(wrc_damage_values(&bins, WRC_DAMAGE_WORK, of_larger), WRC_OK);
  EXPECT_EQ(std::memcmp(work, of_larger, sizeof work), 0);
  EXPECT_GT(*std::max_element(work, work + 141), 0.0);
  for (std::size_t k = 0; k < 141; ++k) {
    EXPECT_EQ(std::memcmp(bytes + k * larger, &bin[k], sizeof bin[k]), 0) << k;
    for (std::size_t i = 0; i < 16; ++i) ASSERT_EQ(bytes[k * larger + sizeof bin[0] + i], 0x77) << k;
  }
}

// ------------------------------------------------------------------------------------------ what is
// prescribed

TEST_F(WheelOfANewerHeader, PrescribesNothingOfAContactPlane) {
  for (const int32_t wrong : {WRC_PRESCRIBE_NORMAL_FORCE, WRC_PRESCRIBE_APPROACH}) {
    input.prescribed = wrong;
    input.vertical_load = 80e3;  // not read, so it must be 0
    EXPECT_EQ(step(), WRC_ERROR_RANGE);
    expect_words(sentence_of(contact), {"input.vertical_load = 80000 N", "no vertical load is prescribed",
                                        "WRC_PRESCRIBE_VERTICAL_LOAD only"});
    input.vertical_load = 0.0;
    wrench.normal_force = 7.0;
    EXPECT_EQ(step(), WRC_ERROR_UNSUPPORTED);
    expect_words(sentence_of(contact),
                 {"wrc_contact_wrench: input.prescribed = " + std::to_string(wrong), "of a contact plane",
                  "WRC_PRESCRIBE_HEIGHT (0) or WRC_PRESCRIBE_VERTICAL_LOAD (1)"});
    EXPECT_EQ(wrench.normal_force, 0.0);
  }
  wrc_wrench exact = sized<wrc_wrench>();
  EXPECT_EQ(wrc_exact_wrench(contact, &input, nullptr, &exact), WRC_ERROR_UNSUPPORTED);
  expect_words(sentence_of(contact), {"wrc_exact_wrench: input.prescribed = 3"});
  input.prescribed = 4;
  EXPECT_EQ(step(), WRC_ERROR_UNSUPPORTED);
  expect_words(sentence_of(contact), {"input.prescribed = 4", "WRC_PRESCRIBE_HEIGHT (0)", "_APPROACH (3)"});
}

TEST_F(PlaneOfANewerHeader, PrescribesNothingOfAWheel) {
  wrc_exact_normal_problem problem = wrc_exact_normal_problem_default();
  wrc_exact_normal_solution solution = sized<wrc_exact_normal_solution>();
  std::vector<double> gap(64, 0.0);
  problem.grid.nx = problem.grid.ny = 8;
  problem.grid.dx = problem.grid.dy = 1e-3;
  problem.gap = gap.data();
  ASSERT_EQ(wrc_planar_geometry(contact, &pose, nullptr), WRC_OK);
  for (const int32_t wrong : {WRC_PRESCRIBE_HEIGHT, WRC_PRESCRIBE_VERTICAL_LOAD}) {
    const std::vector<std::string> words = {"load.prescribed = " + std::to_string(wrong), "of a wheel",
                                            "WRC_PRESCRIBE_NORMAL_FORCE (2) or WRC_PRESCRIBE_APPROACH (3)"};
    load.prescribed = wrong;
    expect_refused(WRC_ERROR_UNSUPPORTED, words);
    EXPECT_EQ(wrc_planar_normal(contact, nullptr, &load, &normal), WRC_ERROR_UNSUPPORTED);
    expect_words(error(), words);
    problem.prescribed = wrong;
    char text[512];
    EXPECT_EQ(wrc_exact_normal(&problem, &solution, text, sizeof text), WRC_ERROR_UNSUPPORTED);
    expect_words(text, {"wrc_exact_normal: problem.prescribed = " + std::to_string(wrong), "of a wheel"});
  }
}

// -------------------------------------------------------------------------------------------------------
// flags

TEST_F(WheelOfANewerHeader, HasAllFlagsAndTheGravestAsItsStatus) {
  wheel.z = 4e-3;
  wheel.velocity[0] = 0.05;
  wheel.angular_velocity[1] = -0.05 / 0.46;
  EXPECT_EQ(step(), WRC_FLAG_BEYOND_GAP);
  const uint32_t both = WRC_FLAG_BIT(WRC_FLAG_BEYOND_GAP) | WRC_FLAG_BIT(WRC_FLAG_CREEPAGES_LIMITED);
  EXPECT_EQ(wrench.flags, both);
  wheel.z = 0.2e-3;
  EXPECT_EQ(step(), WRC_FLAG_CREEPAGES_LIMITED);
  EXPECT_EQ(wrench.flags, WRC_FLAG_BIT(WRC_FLAG_CREEPAGES_LIMITED));
  wheel.z = 4e-3;
  wheel.velocity[0] = 20.0;
  wheel.angular_velocity[1] = -20.0 / 0.46;
  EXPECT_EQ(step(), WRC_FLAG_BEYOND_GAP);
  EXPECT_EQ(wrench.flags, WRC_FLAG_BIT(WRC_FLAG_BEYOND_GAP));
  wheel.z = 0.2e-3;
  EXPECT_EQ(step(), WRC_OK);
  EXPECT_EQ(wrench.flags, 0U);
}

TEST_F(PlaneOfANewerHeader, HasTheFlagsOfEachStageAndOfAll) {
  load.prescribed = WRC_PRESCRIBE_APPROACH;
  load.approach = 1.5e-3;
  creepage.reverse_share = 0.2;
  EXPECT_EQ(step(), WRC_FLAG_BEYOND_GAP);
  const uint32_t deep = WRC_FLAG_BIT(WRC_FLAG_BEYOND_GAP), slow = WRC_FLAG_BIT(WRC_FLAG_CREEPAGES_LIMITED);
  EXPECT_EQ(output.flags, deep | slow);
  EXPECT_EQ(normal.flags, deep);
  EXPECT_EQ(forces.flags, slow);
  const wrc_planar_output of_step = output;  // as the stages alone have them
  ASSERT_EQ(wrc_planar_normal(contact, nullptr, &load, &normal), WRC_FLAG_BEYOND_GAP);
  ASSERT_EQ(wrc_planar_tangential(contact, nullptr, &creepage, &friction, &forces),
            WRC_FLAG_CREEPAGES_LIMITED);
  EXPECT_EQ(std::memcmp(&of_step.normal, &normal, sizeof normal), 0);
  EXPECT_EQ(std::memcmp(&of_step.forces, &forces, sizeof forces), 0);
  load.approach = -1.0;
  EXPECT_EQ(step(), WRC_FLAG_NO_CONTACT);
  EXPECT_NE(output.flags & WRC_FLAG_BIT(WRC_FLAG_NO_CONTACT), 0U);
  EXPECT_EQ(output.flags & deep, 0U);
}

// ---------------------------------------------------------------------------------------------------
// sentences

/// A call that is refused, with the words of its sentence behind "function: ".
struct Refused {
  const char* function;
  std::function<int32_t()> call;
  const char* words;
};

TEST_F(WheelOfANewerHeader, NamesTheFunctionInEverySentence) {
  ASSERT_EQ(step(), WRC_OK) << error();
  ASSERT_LT(wrench.region_count, 7);
  wrc_region region = sized<wrc_region>();
  wrc_damage damage{};
  wrc_wear wear{};
  wrc_temperature temperature = sized<wrc_temperature>();
  wrc_wrench_derivatives derivatives = sized<wrc_wrench_derivatives>();
  wrc_planar_derivatives of_plane = sized<wrc_planar_derivatives>();
  wrc_exact_check_result check = sized<wrc_exact_check_result>();
  wrc_accumulation accumulation = sized<wrc_accumulation>();
  wrc_planar_input step_of_plane = wrc_planar_input_default();
  wrc_planar_pose pose = sized<wrc_planar_pose>();
  wrc_planar_motion motion = sized<wrc_planar_motion>();
  const wrc_planar_load load = wrc_planar_load_default();
  const wrc_creepage creepage = wrc_creepage_default();
  double value = 0.0;
  uint64_t counts[2];
  char buffer[16] = "";
  accumulation.duration = -1.0;
  pose.lateral = 3.0;
  wrc_wheel_input wrong = input;
  wrong.wheel.y = 2.0;
  const Refused calls[] = {
      {"wrc_contact_region", [&] { return wrc_contact_region(contact, 7, &region); }, "index = 7"},
      {"wrc_contact_field",
       [&] { return wrc_contact_field(contact, 7, WRC_FIELD_PRESSURE, nullptr, 0, counts); }, "index = 7"},
      {"wrc_contact_field",
       [&] { return wrc_contact_field(contact, 0, WRC_FIELD_PRESSURE, &value, 1, nullptr); }, "room = 1"},
      {"wrc_contact_damage", [&] { return wrc_contact_damage(contact, 7, &damage); }, "index = 7"},
      {"wrc_contact_damage", [&] { return wrc_contact_damage(contact, WRC_ALL_REGIONS, &damage); }, "index"},
      {"wrc_contact_wear", [&] { return wrc_contact_wear(contact, 7, nullptr, &wear); }, "index = 7"},
      {"wrc_contact_temperature", [&] { return wrc_contact_temperature(contact, 7, nullptr, &temperature); },
       "index = 7"},
      {"wrc_contact_stresses",
       [&] { return wrc_contact_stresses(contact, 7, WRC_BODY_RAIL, &value, 1, nullptr, nullptr); },
       "index = 7"},
      {"wrc_contact_accumulate",
       [&] { return wrc_contact_accumulate(contact, &accumulation, nullptr, nullptr, nullptr); },
       "accumulation.duration = -1 s"},
      {"wrc_contact_wrench", [&] { return wrc_contact_wrench(contact, &wrong, nullptr); },
       "input.wheel.y = 2 m"},
      {"wrc_contact_wrench",
       [&] {
         int32_t status = 0;
         wrc_contact_wrench_batch(&contact, 1, &wrong, 0, &wrench, sizeof wrench, &status);
         return status;
       },
       "input.wheel.y = 2 m"},
      {"wrc_contact_wrench_derivatives",
       [&] { return wrc_contact_wrench_derivatives(contact, &wrong, nullptr, &derivatives); },
       "input.wheel.y = 2 m"},
      {"wrc_contact_save", [&] { return wrc_contact_save(contact, buffer, 16); }, "bytes = 16"},
      {"wrc_contact_restore", [&] { return wrc_contact_restore(contact, buffer, 16); }, "bytes = 16"},
      {"wrc_contact_save_portable", [&] { return wrc_contact_save_portable(contact, buffer, 16); },
       "bytes = 16"},
      {"wrc_contact_restore_portable", [&] { return wrc_contact_restore_portable(contact, buffer, 16); }, ""},
      {"wrc_planar_step", [&] { return wrc_planar_step(contact, &step_of_plane, nullptr); },
       "input.load.normal_force = 0 N"},
      {"wrc_planar_geometry", [&] { return wrc_planar_geometry(contact, &pose, nullptr); },
       "pose.lateral = 3 m"},
      {"wrc_planar_creepages", [&] { return wrc_planar_creepages(contact, &motion, nullptr); }, ""},
      {"wrc_planar_normal", [&] { return wrc_planar_normal(contact, nullptr, &load, nullptr); },
       "load.normal_force = 0 N"},
      {"wrc_planar_regularise", [&] { return wrc_planar_regularise(contact, nullptr, nullptr); }, ""},
      {"wrc_planar_roll", [&] { return wrc_planar_roll(contact, 1.0); }, "non_steady"},
      {"wrc_planar_tangential",
       [&] { return wrc_planar_tangential(contact, nullptr, &creepage, nullptr, nullptr); }, "friction"},
      {"wrc_planar_tangential_derivatives",
       [&] { return wrc_planar_tangential_derivatives(contact, &of_plane); }, ""},
      {"wrc_exact_check", [&] { return wrc_exact_check(contact, nullptr, &check); }, ""},
      {"wrc_exact_gap", [&] { return wrc_exact_gap(contact, nullptr, &value); }, "grid"},
      {"wrc_exact_check", [&] { return wrc_exact_check(contact, nullptr, nullptr); }, "result"},
      {"wrc_exact_wrench", [&] { return wrc_exact_wrench(contact, &wrong, nullptr, &wrench); },
       "input.wheel.y = 2 m"},
      {"wrc_exact_wrench", [&] { return wrc_exact_wrench(contact, &input, nullptr, nullptr); }, "wrench"},
  };
  for (const Refused& each : calls) {
    ASSERT_EQ(step(), WRC_OK);  // a solution with regions, and no sentence
    ASSERT_EQ(sentence_of(contact), "");
    EXPECT_LT(each.call(), 0) << each.function;
    const std::string sentence = sentence_of(contact), begins = std::string(each.function) + ": ";
    EXPECT_EQ(sentence.rfind(begins, 0), 0U) << begins << " does not begin: " << sentence;
    EXPECT_GT(sentence.size(), begins.size()) << sentence;
    expect_words(sentence, {each.words});
  }
}

TEST_F(WheelOfANewerHeader, NamesTheFunctionInSentencesOfCallsWithoutAContact) {
  char text[512];
  wrc_config wrong = config;
  wrong.wheelset.wheel_radius = 460.0;
  wrc_model* none = nullptr;
  wrc_contact* no_contact = nullptr;
  wrc_exact_normal_solution normal = sized<wrc_exact_normal_solution>();
  wrc_exact_rolling_solution rolling = sized<wrc_exact_rolling_solution>();
  const wrc_exact_normal_problem normal_problem = wrc_exact_normal_problem_default();
  const wrc_exact_rolling_problem rolling_problem = wrc_exact_rolling_problem_default();
  const wrc_conicity_problem conicity_problem = wrc_conicity_problem_default();
  wrc_conicity conicity = sized<wrc_conicity>();
  const Refused calls[] = {
      {"wrc_config_use", [&] { return wrc_config_use(&wrong, "no such", text, sizeof text); }, "no such"},
      {"wrc_config_check", [&] { return wrc_config_check(&wrong, text, sizeof text); }, "wheel_radius"},
      {"wrc_model_init", [&] { return wrc_model_init(&wrong, text, sizeof text, &none, text, sizeof text); },
       "wheel_radius"},
      {"wrc_model_create", [&] { return wrc_model_create(&wrong, nullptr, &none, text, sizeof text); },
       "wheel_radius"},
      {"wrc_contact_init",
       [&] { return wrc_contact_init(model, 2, nullptr, 0, &no_contact, text, sizeof text); }, "side = 2"},
      {"wrc_contact_create",
       [&] { return wrc_contact_create(model, 2, nullptr, &no_contact, text, sizeof text); }, "side = 2"},
      {"wrc_exact_normal", [&] { return wrc_exact_normal(&normal_problem, &normal, text, sizeof text); },
       "problem."},
      {"wrc_exact_rolling", [&] { return wrc_exact_rolling(&rolling_problem, &rolling, text, sizeof text); },
       "problem."},
      {"wrc_equivalent_conicity",
       [&] { return wrc_equivalent_conicity(&conicity_problem, &conicity, text, sizeof text); }, "problem."},
  };
  for (const Refused& each : calls) {
    EXPECT_LT(each.call(), 0) << each.function;
    expect_words(text, {each.words});
    EXPECT_EQ(std::string(text).rfind(std::string(each.function) + ": ", 0), 0U) << text;
  }
}

}  // namespace
