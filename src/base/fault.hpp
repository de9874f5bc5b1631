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

  bool failed() const { return status < 0; }
};

// A contact's saved state holds its last fault: with padding here, equal states could differ in their bytes.
static_assert(sizeof(Fault) == 2 * sizeof(std::int32_t) + 4 * sizeof(const char*) + 3 * sizeof(double));

/// Keeps the gravest: a failure over a flag, a flag over nothing; of equals the first.
inline void keep_worst(Fault& kept, const Fault& next) {
  if (kept.failed() || next.status == WRC_OK) return;
  if (next.failed() || kept.status == WRC_OK) kept = next;
}

}  // namespace wrc
