/// Memory through the C interface: the caller's own, the caller's allocator, saved and restored state.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <new>
#include <string>
#include <vector>

#include "reference_contact.hpp"
#include "test_config.hpp"
#include "wrc/wrc_api.h"

namespace {

using Memory = ReferenceContact;

TEST_F(Memory, MemoryOfTheCallerFitsExactly) {
  uint64_t bytes = 0, alignment = 0;
  ASSERT_EQ(wrc_model_size(&config, &bytes, &alignment), WRC_OK);
  std::vector<unsigned char> storage(bytes + alignment);
  auto* memory = reinterpret_cast<unsigned char*>(
      (reinterpret_cast<std::uintptr_t>(storage.data()) + alignment - 1) / alignment * alignment);
  wrc_model* own = nullptr;
  EXPECT_EQ(wrc_model_init(&config, memory, bytes - 1, &own, nullptr, 0), WRC_ERROR_BUFFER);
  EXPECT_EQ(own, nullptr);
  EXPECT_EQ(wrc_model_init(&config, memory + 8, bytes, &own, nullptr, 0), WRC_ERROR_BUFFER);
  EXPECT_EQ(wrc_model_init(&config, nullptr, bytes, &own, nullptr, 0), WRC_ERROR_NULL);
  ASSERT_EQ(wrc_model_init(&config, memory, bytes, &own, nullptr, 0), WRC_OK);

  uint64_t contact_bytes = 0;
  ASSERT_EQ(wrc_contact_size(own, &contact_bytes, &alignment), WRC_OK);
  std::vector<unsigned char> contact_storage(contact_bytes + alignment);
  auto* contact_memory = reinterpret_cast<unsigned char*>(
      (reinterpret_cast<std::uintptr_t>(contact_storage.data()) + alignment - 1) / alignment * alignment);
  wrc_contact* own_contact = nullptr;
  EXPECT_EQ(
      wrc_contact_init(own, WRC_SIDE_RIGHT, contact_memory, contact_bytes - 1, &own_contact, nullptr, 0),
      WRC_ERROR_BUFFER);
  EXPECT_EQ(own_contact, nullptr);
  ASSERT_EQ(wrc_contact_init(own, WRC_SIDE_RIGHT, contact_memory, contact_bytes, &own_contact, nullptr, 0),
            WRC_OK);
  expect_works();
  const wrc_planar_forces expected = forces;
  std::swap(contact, own_contact);
  expect_works();
  EXPECT_EQ(std::memcmp(&expected, &forces, sizeof forces), 0);
  std::swap(contact, own_contact);
  wrc_contact_destroy(own_contact);  // memory of the caller: nothing to release, and harmless
  wrc_model_destroy(own);
}

struct Counter {
  int live = 0, left = 1000;
};
void* counting_allocate(void* user, uint64_t bytes, uint64_t alignment) {
  auto* counter = static_cast<Counter*>(user);
  if (counter->left-- <= 0) return nullptr;
  ++counter->live;
  return ::operator new (bytes, std::align_val_t{alignment}, std::nothrow);
}
void counting_release(void* user, void* memory) {
  --static_cast<Counter*>(user)->live;
  ::operator delete (memory, std::align_val_t{64}, std::nothrow);
}

TEST_F(Memory, AllocatorOfTheCallerIsUsedAndEveryFailureIsAStatus) {
  wrc_allocator allocator = sized<wrc_allocator>();
  Counter counter;
  allocator.user = &counter;
  allocator.allocate = counting_allocate;
  allocator.release = counting_release;
  for (int allowed = 0; allowed <= 2; ++allowed) {
    counter = {0, allowed};
    wrc_model* own = nullptr;
    wrc_contact* own_contact = nullptr;
    EXPECT_EQ(wrc_model_create(&config, &allocator, &own, nullptr, 0),
              allowed > 0 ? WRC_OK : WRC_ERROR_MEMORY);
    EXPECT_EQ(own != nullptr, allowed > 0);
    if (own != nullptr) {
      EXPECT_EQ(wrc_contact_create(own, WRC_SIDE_RIGHT, &allocator, &own_contact, nullptr, 0),
                allowed > 1 ? WRC_OK : WRC_ERROR_MEMORY);
    }
    wrc_contact_destroy(own_contact);
    wrc_model_destroy(own);
    EXPECT_EQ(counter.live, 0);
  }
  counter = {0, 1000};
  config.wheel_material.poisson = config.rail_material.poisson = 9.0;
  wrc_model* own = nullptr;
  EXPECT_EQ(wrc_model_create(&config, &allocator, &own, nullptr, 0), WRC_ERROR_RANGE);
  EXPECT_EQ(counter.live, 0);
  config.wheel_material.poisson = config.rail_material.poisson = 0.25;
  allocator.release = nullptr;
  EXPECT_EQ(wrc_model_create(&config, &allocator, &own, nullptr, 0), WRC_ERROR_NULL);
}

TEST_F(Memory, SavedStateRestoresBitForBit) {
  expect_works();
  uint64_t bytes = 0;
  ASSERT_EQ(wrc_contact_state_size(model, &bytes), WRC_OK);
  std::vector<unsigned char> saved(bytes + 1);
  ASSERT_EQ(wrc_contact_save(contact, saved.data() + 1, bytes), WRC_OK);  // any alignment
  const wrc_planar_forces before = forces;
  pose.lateral = 2e-3;
  creepage.spin = -0.7;
  ASSERT_EQ(step(), WRC_OK);
  EXPECT_NE(forces.fx, before.fx);
  ASSERT_EQ(wrc_contact_restore(contact, saved.data() + 1, bytes), WRC_OK);
  creepage.spin = 0.29;
  ASSERT_EQ(wrc_planar_tangential(contact, nullptr, &creepage, &friction, &forces), WRC_OK);
  EXPECT_EQ(std::memcmp(&before, &forces, sizeof forces), 0);

  wrc_contact* other = nullptr;  // relocatable: into another contact of the model
  ASSERT_EQ(wrc_contact_create(model, WRC_SIDE_RIGHT, nullptr, &other, nullptr, 0), WRC_OK);
  ASSERT_EQ(wrc_contact_restore(other, saved.data() + 1, bytes), WRC_OK);
  ASSERT_EQ(wrc_planar_tangential(other, nullptr, &creepage, &friction, &forces), WRC_OK);
  EXPECT_EQ(std::memcmp(&before, &forces, sizeof forces), 0);
  wrc_contact_destroy(other);

  EXPECT_EQ(wrc_contact_create(model, 2, nullptr, &other, nullptr, 0), WRC_ERROR_UNSUPPORTED);
  EXPECT_EQ(other, nullptr);
  ASSERT_EQ(wrc_contact_create(model, WRC_SIDE_LEFT, nullptr, &other, nullptr, 0), WRC_OK);
  EXPECT_EQ(wrc_contact_restore(other, saved.data() + 1, bytes), WRC_ERROR_SEQUENCE);
  char text[200];
  wrc_contact_last_error(other, text, sizeof text);
  expect_words(text, {"other side"});
  wrc_contact_destroy(other);

  std::vector<unsigned char> rubbish(bytes, 0x5a);
  EXPECT_EQ(wrc_contact_restore(contact, rubbish.data(), bytes), WRC_ERROR_SEQUENCE);
  expect_works();
}

TEST_F(Memory, SavedStatesAreHalfAsLongAsContacts) {
  uint64_t bytes = 0, of_contact = 0, alignment = 0;
  ASSERT_EQ(wrc_contact_size(model, &of_contact, &alignment), WRC_OK);
  ASSERT_EQ(wrc_contact_state_size(model, &bytes), WRC_OK);
  EXPECT_LE(2 * bytes, of_contact);
  // Work space of the wheel step lies behind the two copies of the state. Without it there are numbers of
  // cells and strips: tractions, slips, temperature, and two that follow from them.
  wrc_config plain = config;
  plain.normal.method = WRC_NORMAL_EKP;
  plain.wheel = plain.rail = sized<wrc_profile>();
  plain.track = test_config().track;
  wrc_model* without = nullptr;
  uint64_t state = 0, whole = 0;
  ASSERT_EQ(wrc_model_create(&plain, nullptr, &without, nullptr, 0), WRC_OK);
  ASSERT_EQ(wrc_contact_size(without, &whole, &alignment), WRC_OK);
  ASSERT_EQ(wrc_contact_state_size(without, &state), WRC_OK);
  wrc_model_destroy(without);
  EXPECT_LE(2 * state, whole);
  const auto strips = static_cast<uint64_t>(plain.planar.strips),
             cells = static_cast<uint64_t>(plain.planar.cells);
  EXPECT_GE(2 * state + (7 * cells + 1) * strips * sizeof(double), whole - 256);
  EXPECT_EQ(wrc_get_api(WRC_ABI_VERSION)->contact_state_size, wrc_contact_state_size);

  // Not a byte more is written, not one less is enough.
  std::vector<unsigned char> saved(bytes + 64, 0xa5);
  ASSERT_EQ(wrc_contact_save(contact, saved.data(), bytes), WRC_OK);
  EXPECT_TRUE(std::all_of(saved.begin() + static_cast<std::ptrdiff_t>(bytes), saved.end(),
                          [](unsigned char byte) { return byte == 0xa5; }));
  EXPECT_EQ(wrc_contact_save(contact, saved.data(), bytes - 1), WRC_ERROR_BUFFER);

  EXPECT_EQ(wrc_contact_state_size(nullptr, &bytes), WRC_ERROR_NULL);
  EXPECT_EQ(bytes, 0U);
  EXPECT_EQ(wrc_contact_state_size(model, nullptr), WRC_ERROR_NULL);
}

TEST_F(Memory, SentencesBelongToTheLastRestore) {
  const auto sentence = [&] {
    char text[256];
    EXPECT_EQ(wrc_contact_last_error(contact, text, sizeof text), WRC_OK);
    return std::string(text);
  };
  uint64_t bytes = 0;
  ASSERT_EQ(wrc_contact_state_size(model, &bytes), WRC_OK);
  std::vector<unsigned char> saved(bytes), rubbish(bytes, 0x5a);
  ASSERT_EQ(step(), WRC_OK);
  ASSERT_EQ(wrc_contact_save(contact, saved.data(), bytes), WRC_OK);
  load.normal_force = 80.0;
  ASSERT_EQ(step(), WRC_ERROR_RANGE);
  const std::string of_step = sentence();
  EXPECT_NE(of_step.find("load.normal_force"), std::string::npos);
  // A call that fails has a sentence of its own; one that saves leaves the last.
  EXPECT_EQ(wrc_contact_save(contact, rubbish.data(), 16), WRC_ERROR_BUFFER);
  const std::string of_save = sentence();
  EXPECT_NE(of_save.find("wrc_contact_save: bytes = 16"), std::string::npos) << of_save;
  std::vector<unsigned char> other(bytes);
  ASSERT_EQ(wrc_contact_save(contact, other.data(), bytes), WRC_OK);
  EXPECT_EQ(sentence(), of_save);

  ASSERT_EQ(wrc_contact_restore(contact, rubbish.data(), bytes), WRC_ERROR_SEQUENCE);
  EXPECT_NE(sentence().find("of this model"), std::string::npos) << sentence();
  ASSERT_EQ(wrc_contact_restore(contact, saved.data(), bytes - 1), WRC_ERROR_BUFFER);
  EXPECT_NE(sentence().find("wrc_contact_state_size"), std::string::npos) << sentence();
  ASSERT_EQ(wrc_contact_restore(contact, nullptr, bytes), WRC_ERROR_NULL);
  EXPECT_NE(sentence().find("buffer"), std::string::npos) << sentence();
  // The state saved after a step without fault has none.
  ASSERT_EQ(wrc_contact_restore(contact, saved.data(), bytes), WRC_OK);
  EXPECT_EQ(sentence(), "");
  load.normal_force = 80e3;
  expect_works();
}

}  // namespace
