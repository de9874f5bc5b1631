#include "abi/structs.hpp"

namespace wrc::abi {
namespace {

const char* cause_of(const Member& member, double value) {
  if (value == 0.0 && member.not_set != nullptr) return member.not_set;
  if (value < 0.0 && member.negative != nullptr) return member.negative;
  return value < member.low ? member.too_small : member.too_large;
}

}  // namespace

Fault refuse(const Member& member, const char* of, double value, std::int32_t index) {
  Fault fault = Fault::range({of, member.name, index});
  if (member.type == Type::pointer && index < 0) {
    fault.status = WRC_ERROR_NULL;
    fault.cause = member.not_set;
    return fault;
  }
  fault.value = value;
  fault.unit = member.unit;
  if (member.rule == Rule::one_of) {
    fault.status = WRC_ERROR_UNSUPPORTED;
    fault.cause = member.enumeration->names;
  } else if (member.rule == Rule::zero) {
    fault.cause =
        "it is kept for later versions and must be 0: was the struct initialised, or is the program's header "
        "newer than "
        "this library?";
  } else {
    fault.low = member.low;
    fault.high = member.high;
    if (std::isfinite(value)) {
      fault.cause = cause_of(member, value);
    } else {
      fault.status = WRC_ERROR_NOT_FINITE;
    }
  }
  return fault;
}

Fault check_tail(const void* theirs, std::size_t size, std::size_t ours, const char* name) {
  const auto* const bytes = static_cast<const unsigned char*>(theirs);
  for (std::size_t i = ours; i < size; ++i) {
    if (bytes[i] == 0) continue;
    return Fault::struct_size(
        {name, "struct_size"}, {size, "bytes", ours, ours},
        "a member beyond what this library knows is set: the program's header is newer than the "
        "library. Leave the member 0, or ship the library of that header");
  }
  return {};
}

}  // namespace wrc::abi

using wrc::abi::init;

extern "C" {
#include "abi/generated/init_functions.inc"
}
