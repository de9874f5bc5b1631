/// Turns a Fault into the sentence an engineer reads.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/fault.hpp"

namespace wrc::abi {

/// Name ("WRC_ERROR_RANGE") and one-line meaning of a status; never nullptr.
const char* status_name(std::int32_t status);
const char* status_text(std::int32_t status);

/// Writes the sentence to `text` (`size` > 0 bytes, always terminated, cut if too long). Empty for WRC_OK.
/// Uses neither locale nor heap. `file`: the one it is about, which it ends with; nullptr: about none.
void write_sentence(const Fault& fault, char* text, std::size_t size, const char* file = nullptr);

/// The outcome of a call that is no contact's: its sentence into the caller's text. `file`: as
/// write_sentence().
inline std::int32_t finish(const char* function, Fault outcome, char* text, std::uint64_t size,
                           const char* file = nullptr) {
  outcome.call = function;
  if (text != nullptr && size > 0) write_sentence(outcome, text, size, file);
  return outcome.status;
}

}  // namespace wrc::abi
