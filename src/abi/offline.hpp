/// Parts that calls of wrc_offline.h share: the host's progress, results for a contact.
#pragma once

#include <algorithm>
#include <cstdint>

#include "abi/guarded.hpp"
#include "abi/handles.hpp"
#include "abi/structs.hpp"
#include "base/progress.hpp"
#include "wrc/wrc_offline.h"

namespace wrc::abi {

/// The host's callback behind the solver's: 0 goes on. A residual may rise on its way down; the fraction does
/// not fall.
struct Reporter {
  wrc_progress progress = nullptr;
  void* user = nullptr;
  double largest = 0.0;
  static bool report(double fraction, void* self) {
    auto* reporter = static_cast<Reporter*>(self);
    reporter->largest = std::max(reporter->largest, fraction);
    return reporter->progress(reporter->largest, reporter->user) == 0;
  }
  ProgressCallback callback() {
    return progress == nullptr ? ProgressCallback{} : ProgressCallback{report, this};
  }
};

/// A result for a contact: `solve(contact, ours)` into `result`, which is zero on failure, with its flags;
/// the outcome is the contact's last. `function`: the name of the call; `name`: that of `result`.
template <typename Result, typename Solve>
std::int32_t solve_exactly(const char* function, wrc_contact* contact, Result* result, const char* name,
                           Solve&& solve) {
  const Fault cleared = clear(result);
  if (!valid(contact)) return WRC_ERROR_NULL;
  const Fault outcome = guarded([&]() -> Fault {
    if (result == nullptr) return Fault::null(name);
    if (cleared.failed()) return cleared;
    Result ours = empty<Result>();
    const Fault fault = solve(*contact->contact, ours);
    ours.flags = fault.all_flags();
    if (!fault.failed()) write(ours, result);
    return fault;
  });
  return keep(*contact, function, outcome);
}

}  // namespace wrc::abi
