/// Calls that may allocate: exceptions become faults, and the floating-point environment is the library's
/// own.
#pragma once

#include <cstdint>
#include <new>

#include "abi/fp_environment.hpp"
#include "abi/message.hpp"
#include "base/fault.hpp"

namespace wrc::abi {

/// Runs `work`. `of` and `cause`: sentence where memory is short; nullptr: the status alone.
template <typename Work>
Fault guarded(Work&& work, const char* of = "grid",
              const char* cause = "the grid needs more memory than there is") {
  const FloatingPointScope scope;
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return Fault::memory(of, cause);
  } catch (...) {
    return Fault::internal();
  }
}

}  // namespace wrc::abi
