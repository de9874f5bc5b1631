/// What went wrong, in an engineer's terms: every room of the library reports through a Fault.
///
/// A Fault is a handful of pointers to string literals and numbers, so that raising one on the hot path costs
/// nothing; the sentence is only written when the host asks for it (wrc_contact_last_error, abi/message.cpp).
#pragma once

#include <cstdint>

#include "wrc/wrc_status.h"

namespace wrc {

struct Fault {
  std::int32_t status = WRC_OK;  ///< a value of wrc_status: < 0 failed, > 0 usable but flagged
  std::int32_t index = -1;       ///< element of an array the fault is about, -1 if none
  const char* of = nullptr;      ///< the struct whose member `field` is, as the caller knows it
  const char* field = nullptr;   ///< what is wrong, by the name the caller knows ("load.normal_force")
  double value = 0.0;            ///< its value, in `unit`
  const char* unit = nullptr;    ///< nullptr: the fault is not about a number
  double low = 0.0, high = 0.0;  ///< allowed range, or the one allowed value; 0, 0: none to name
  const char* cause = nullptr;   ///< likely cause or remedy, a short clause ("did you pass kN?")
  const char* call = nullptr;    ///< the function that was called; nullptr: none of the interface's
  std::uint64_t flags = 0;       ///< bit 1 << flag of those met beside `status`

  bool failed() const { return status < 0; }

  /// Bit 1 << flag of every flag met; 0 of a failure.
  std::uint32_t all_flags() const {
    if (failed()) return 0;
    return static_cast<std::uint32_t>(flags) | (status > 0 ? std::uint32_t{1} << status : 0);
  }
  bool has(std::int32_t flag) const { return (all_flags() >> flag & 1U) != 0; }
};

// A contact's saved state holds its last fault: with padding here, equal states could differ in their bytes.
static_assert(sizeof(Fault) == 2 * sizeof(std::int32_t) + 5 * sizeof(const char*) + 3 * sizeof(double) +
                                   sizeof(std::uint64_t));

/// Which of two statuses says more about whether a result can be used: failures, then flags from the gravest
/// to the least grave, then WRC_OK. Larger is graver.
constexpr std::int32_t gravity(std::int32_t status) {
  if (status <= 0) return status < 0 ? 100 : 0;
  constexpr std::int32_t gravest_first[] = {WRC_FLAG_NO_CONTACT,
                                            WRC_FLAG_ITERATION_CAP,
                                            WRC_FLAG_SUM_OVERFLOW,
                                            WRC_FLAG_BEYOND_GAP,
                                            WRC_FLAG_PATCH_AT_EDGE,
                                            WRC_FLAG_MORE_PATCHES,
                                            WRC_FLAG_CLIMBING,
                                            WRC_FLAG_LOAD_JUMPS,
                                            WRC_FLAG_FORCE_JUMPS,
                                            WRC_FLAG_BEYOND_SECTIONS,
                                            WRC_FLAG_TABLE_RANGE,
                                            WRC_FLAG_CREEPAGES_LIMITED,
                                            WRC_FLAG_DISSIMILAR_MATERIALS,
                                            WRC_FLAG_ROTATION_TRANSPOSED};
  std::int32_t rank = 99;
  for (const std::int32_t flag : gravest_first) {
    if (flag == status) return rank;
    --rank;
  }
  return 1;
}

/// Keeps the gravest, of equals the first, and the flags of both.
inline void keep_worst(Fault& kept, const Fault& next) {
  if (kept.failed() || next.status == WRC_OK) return;
  const std::uint32_t flags = kept.all_flags() | next.all_flags();
  if (gravity(next.status) > gravity(kept.status)) kept = next;
  if (!kept.failed()) kept.flags = flags;
}

}  // namespace wrc
