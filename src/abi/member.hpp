/// Descriptions of the members of the interface's structs: type, range, condition. The tables themselves are
/// made of the headers (abi/generated/members.hpp, by tools/interface).
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace wrc::abi {

struct Enumerator {
  const char* name;
  std::int32_t value;
};

struct Enumeration {
  const Enumerator* values;
  std::int32_t count;
  const char* names;  ///< all of them, as a hint

  constexpr bool has(std::int32_t value) const {
    for (std::int32_t i = 0; i < count; ++i) {
      if (values[i].value == value) return true;
    }
    return false;
  }
};

enum class Type : std::uint8_t { int32, uint32, uint64, real, pointer };

/// Check of a member when its struct is read.
enum class Rule : std::uint8_t {
  none,   ///< a result, or something that has no range
  range,  ///< low .. high; of a pointer: the numbers behind it
  one_of /* an enumeration */,
  zero  ///< kept for later
};

inline constexpr std::int32_t nowhere = -1;  ///< value of an offset: there is none

/// Condition on another member under which a member is read.
enum class State : std::uint8_t {
  value,     ///< an int32 of that value
  null,      ///< a pointer that is NULL
  zero,      ///< a uint32 that is 0
  not_zero,  ///< a uint32 that is not
};

struct Member {
  const char* name = nullptr;  ///< within its struct: "lateral", "velocity[1]", "track.gauge"
  std::size_t offset = 0;      ///< [bytes]
  Type type = Type::real;
  std::int32_t elements = 1;  ///< length of an array in the struct
  Rule rule = Rule::none;
  bool required = false;                                  ///< a pointer that must not be NULL
  double low = 0.0, high = 0.0;                           ///< in `unit`, ends included
  bool or_zero = false;                                   ///< 0 is allowed beside the range
  const char* unit = "";                                  ///< "" of a pure number
  const char* negative = nullptr;                         ///< likely causes
  const char *too_small = nullptr, *too_large = nullptr;  ///< likely causes
  const char* not_set = nullptr;                          ///< cause where 0 is the default and not allowed
  const Enumeration* enumeration = nullptr;               ///< values allowed by Rule::one_of
  std::int32_t asked = nowhere;                           ///< offset of the member on which reading depends
  std::int32_t asked_for = 0;                             ///< its value, of State::value
  State state = State::value;                             ///< its state where this member is read
  const char* otherwise = nullptr;    ///< reason why it must be 0 elsewhere; nullptr: it is not looked at
  std::int32_t counted_by = nowhere;  ///< offset of the uint32 that counts the numbers behind a pointer
  bool by_caller = false;             ///< read() leaves the check to whoever knows more
};

/// Smallest size of a caller's struct, that of its first published version. Published sizes are those of
/// processors with pointers of 64 bits; elsewhere caller and library have one version.
constexpr bool pointers_of_64_bits = sizeof(void*) == 8;
template <typename Struct>
constexpr std::size_t first_size(std::size_t published) {
  return pointers_of_64_bits ? published : sizeof(Struct);
}

/// Name, first published size (that of the oldest caller), defaults and members of a struct.
template <typename Struct>
struct Description;

/// Place of the member of that name; a name that is none does not compile.
template <typename Struct>
constexpr std::size_t place_of(const char* name) {
  std::size_t place = 0;
  for (const Member& each : Description<Struct>::members) {
    const char *ours = each.name, *theirs = name;
    while (*ours != '\0' && *ours == *theirs) ++ours, ++theirs;
    if (*ours == *theirs) return place;
    ++place;
  }
  throw "no such member";
}

/// The member of that name, found by the compiler.
#define MEMBER(Struct, name) \
  (wrc::abi::Description<    \
      Struct>::members[std::integral_constant<std::size_t, wrc::abi::place_of<Struct>(name)>::value])

}  // namespace wrc::abi
