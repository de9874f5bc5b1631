/// How offline calls are run, whichever file they lie in.
#pragma once

#include <cstdint>
#include <new>

#include "abi/fp_environment.hpp"
#include "abi/message.hpp"
#include "base/fault.hpp"

namespace wrc::abi {

/// Everything offline: allocation may fail, and says so. `of`: what takes the memory.
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
