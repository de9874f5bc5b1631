/// Creation when memory runs out: the n-th allocation fails, for n = 1, 2, ... until there are no more.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "proof/heap.hpp"
#include "proof/proofs.hpp"
#include "proof/wheel.hpp"
#include "test_config.hpp"

namespace {

struct Configuration {
  const char* name;
  wrc_config config;
};

/// What differs in the allocations of a creation: where the profiles come from, the tables of the half-space
/// solver.
std::vector<Configuration> configurations() {
  static std::vector<double> wheel_y, wheel_z, rail_y, rail_z;
  static wrc_profile profiles[4];
  for (int i = 0; i < 101; ++i) {
    wheel_y.push_back(-0.05 + 0.001 * i);
    wheel_z.push_back(-0.025 * wheel_y.back());
    rail_y.push_back(-0.03 + 0.0006 * i);
    rail_z.push_back(20.0 * rail_y.back() * rail_y.back());
  }
  for (wrc_profile& profile : profiles) profile = sized<wrc_profile>();
  profiles[0].kind = WRC_PROFILE_S1002;
  profiles[1].kind = WRC_PROFILE_60E1;
  for (int i : {2, 3}) {
    profiles[i].kind = WRC_PROFILE_POINTS;
    profiles[i].count = 101;
    profiles[i].smoothing = 4e-3;
    profiles[i].y = i == 2 ? wheel_y.data() : rail_y.data();
    profiles[i].z = i == 2 ? wheel_z.data() : rail_z.data();
  }
  std::vector<Configuration> all;
  for (int32_t normal : {WRC_NORMAL_STRIP_HALFSPACE, WRC_NORMAL_EKP}) {
    wrc_config config = test_config();
    config.normal.method = normal;
    all.push_back({"no profiles", config});
    config.wheel = profiles[0];
    config.rail = profiles[1];
    all.push_back({"standard profiles", config});
    config.wheel = profiles[2];
    config.rail = profiles[3];
    all.push_back({"points, smoothed", config});
  }
  return all;
}

/// The host's allocator that fails at the n-th call.
struct Counting {
  int until_failure = 0, given = 0, released = 0;
  static void* allocate(void* user, std::uint64_t bytes, std::uint64_t alignment) {
    auto& self = *static_cast<Counting*>(user);
    if (--self.until_failure == 0) return nullptr;
    ++self.given;
    return aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
  }
  static void release(void* user, void* memory) {
    ++static_cast<Counting*>(user)->released;
    std::free(memory);
  }
};

struct Outcome {
  int failures = 0;  ///< allocations that were made to fail
  int wrong = 0;     ///< creations whose status was not WRC_ERROR_MEMORY, or that left something behind
};

/// Creates and destroys; true when every status is `expected` or everything worked.
int32_t create_all(const wrc_config& config, const wrc_allocator* allocator, bool& left_a_handle) {
  wrc_model* model = nullptr;
  wrc_contact* contact = nullptr;
  int32_t status = wrc_model_create(&config, allocator, &model, nullptr, 0);
  left_a_handle = status < 0 && model != nullptr;
  if (status >= 0) {
    status = wrc_contact_create(model, WRC_SIDE_RIGHT, allocator, &contact, nullptr, 0);
    left_a_handle = status < 0 && contact != nullptr;
  }
  wrc_contact_destroy(contact);
  wrc_model_destroy(model);
  return status;
}

Outcome fail_in_allocator(const wrc_config& config) {
  Outcome outcome;
  for (int n = 1;; ++n) {
    Counting counting{n, 0, 0};
    wrc_allocator allocator = sized<wrc_allocator>();
    allocator.user = &counting;
    allocator.allocate = Counting::allocate;
    allocator.release = Counting::release;
    bool left = false;
    const int32_t status = create_all(config, &allocator, left);
    const bool came_to_it = counting.until_failure <= 0;
    const bool right =
        status == (came_to_it ? WRC_ERROR_MEMORY : WRC_OK) && !left && counting.given == counting.released;
    outcome.wrong += !right;
    if (!came_to_it) return outcome;
    ++outcome.failures;
  }
}

Outcome fail_in_malloc(const wrc_config& config) {
  Outcome outcome;
  for (int n = 1;; ++n) {
    const long living_before = living_blocks();
    bool left = false;
    fail_allocation(n);
    const int32_t status = create_all(config, nullptr, left);
    const bool came_to_it = allocation_failed();
    fail_allocation(0);
    const bool right =
        status == (came_to_it ? WRC_ERROR_MEMORY : WRC_OK) && !left && living_blocks() == living_before;
    outcome.wrong += !right;
    if (!came_to_it) return outcome;
    ++outcome.failures;
  }
}

/// wrc_config_check() allocates too, and says so when it cannot.
Outcome fail_in_check(const wrc_config& config) {
  Outcome outcome;
  for (int n = 1;; ++n) {
    const long living_before = living_blocks();
    char text[200];
    fail_allocation(n);
    const int32_t status = wrc_config_check(&config, text, sizeof text);
    const bool came_to_it = allocation_failed();
    fail_allocation(0);
    outcome.wrong += status != (came_to_it ? WRC_ERROR_MEMORY : WRC_OK) || living_blocks() != living_before;
    if (!came_to_it) return outcome;
    ++outcome.failures;
  }
}

}  // namespace

bool prove_failed_allocations() {
  int wrong = 0;
  std::printf("%-16s %-18s %10s %10s %14s\n", "normal", "profiles", "allocator", "malloc", "config check");
  for (const auto& [name, config] : configurations()) {
    const Outcome allocator = fail_in_allocator(config), heap = fail_in_malloc(config),
                  check = fail_in_check(config);
    wrong += allocator.wrong + heap.wrong + check.wrong;
    std::printf("%-16s %-18s %10d %10d %14d  %s\n", normal_names[config.normal.method], name,
                allocator.failures, heap.failures, check.failures,
                allocator.wrong + heap.wrong + check.wrong == 0 ? "reported, nothing leaked"
                                                                : "WRONG STATUS OR LEAK");
    // A creation that allocates nothing would prove nothing.
    wrong += allocator.failures != 2 || heap.failures < 2 || check.failures < 1;
  }
  return wrong == 0;
}
