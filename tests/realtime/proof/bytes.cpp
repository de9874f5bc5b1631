/// Equal states have equal bytes: nothing of the memory a contact is made in, and nothing that happens to lie
/// on the stack, gets into what wrc_contact_save() hands out. Hosts compare saved states and keep hashes of
/// them.
#include <cstdio>
#include <cstring>

#include "proof/entries.hpp"
#include "proof/proofs.hpp"

namespace {

constexpr unsigned char fillings[] = {0xaa, 0x55};

/// Leaves this byte all over the stack below the caller.
__attribute__((noinline)) void dirty_stack(unsigned char filling) {
  volatile unsigned char room[100 * 1024];
  for (volatile unsigned char& byte : room) byte = filling;
}

/// What the harness must notice: a struct with a hole, copied from the stack.
struct Holey {
  std::int32_t number;
  double other;
};
__attribute__((noinline)) void copy_holey(void* to) {
  Holey local;
  local.number = 1;
  local.other = 2.0;
  asm volatile("" : "+m"(local));
  std::memcpy(to, &local, sizeof local);
}

bool harness_notices() {
  alignas(Holey) unsigned char copies[2][sizeof(Holey)];
  for (int k = 0; k < 2; ++k) {
    dirty_stack(fillings[k]);
    copy_holey(copies[k]);
  }
  return std::memcmp(copies[0], copies[1], sizeof(Holey)) != 0;
}

/// Two lives of one contact with the same input: in memory, and on a stack, full of the one byte and the
/// other.
class Twins {
 public:
  explicit Twins(const Methods& methods) : wheel_(methods) {
    wrc_contact_destroy(wheel_.contact);
    for (int k = 0; k < 2; ++k) {
      memory_[k].resize(wheel_.contact_bytes + alignment);
      char* first = memory_[k].data();
      first += alignment - reinterpret_cast<std::uintptr_t>(first) % alignment;
      std::memset(first, fillings[k], wheel_.contact_bytes);
      if (wrc_contact_init(wheel_.model, wheel_.methods.side, first, wheel_.contact_bytes, &contact_[k],
                           nullptr, 0) < 0)
        contact_[k] = nullptr;
      saved_[k].resize(wheel_.state.size());
    }
    wheel_.contact = nullptr;
  }
  ~Twins() { wheel_.contact = nullptr; }
  Twins(const Twins&) = delete;
  Twins& operator=(const Twins&) = delete;

  /// Input i through this entry in both; where their saved states differ first, -1 if nowhere.
  long difference(int i, const Entry& entry) {
    for (int k = 0; k < 2; ++k) {
      wheel_.contact = contact_[k];
      wheel_.vary(i);
      wheel_.vary_laws(i);
      dirty_stack(fillings[k]);
      entry.call(wheel_);
      wheel_.contact = nullptr;
      std::memset(saved_[k].data(), 0, saved_[k].size());
      if (wrc_contact_save(contact_[k], saved_[k].data(), saved_[k].size()) < 0) return 0;
    }
    for (std::size_t at = 0; at < saved_[0].size(); ++at) {
      if (saved_[0][at] != saved_[1][at]) return static_cast<long>(at);
    }
    return -1;
  }

 private:
  static constexpr std::size_t alignment = 64;
  Wheel wheel_;
  std::vector<char> memory_[2], saved_[2];
  wrc_contact* contact_[2] = {};
};

}  // namespace

bool prove_equal_bytes(int steps) {
  const bool notices = harness_notices();
  std::printf("a deliberate hole: %s\n", notices ? "noticed" : "NOT NOTICED");
  int compared = 0, different = 0;
  const int stride = stride_of(steps, 5);
  int first = 0;
  for (const Methods& methods : all_methods()) {
    Twins twins(methods);
    for (int i = first++ % stride; i < 10; i += stride) {
      for (const Entry& entry : all_entries()) {
        const long at = twins.difference(1531 * i, entry);
        ++compared;
        if (at < 0) continue;
        if (++different <= 20)
          std::printf("%s, %s: DIFFER at byte %ld\n", names_of(methods).c_str(), entry.name, at);
      }
    }
  }
  std::printf("%d saved states after the same calls, memory and stack filled differently before: %d differ\n",
              compared, different);
  return notices && different == 0;
}
