/// How structs cross the boundary: read the caller's version into today's struct and check every member by
/// its description, write today's result into the caller's version.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <iterator>
#include <type_traits>
#include <utility>

#include "abi/generated/members.hpp"
#include "base/fault.hpp"

namespace wrc::abi {

/// All zero but for struct_size.
template <typename Struct>
constexpr Struct empty() {
  Struct value{};
  if constexpr (Description<Struct>::versioned) value.struct_size = sizeof(Struct);
  return value;
}

/// Today's defaults of a struct, struct_size included.
template <typename Struct>
constexpr Struct defaults() {
  return Description<Struct>::defaults;
}

/// Most bytes by which a caller's struct may be larger than ours: a newer header than this library.
inline constexpr std::uint32_t most_newer_bytes = 1024;

/// Is the caller's struct_size one that can be? Smaller is an older header, larger a newer one.
template <typename Struct>
Fault check_size(const Struct& theirs) {
  if constexpr (Description<Struct>::versioned) {
    if (theirs.struct_size < Description<Struct>::first ||
        theirs.struct_size > sizeof(Struct) + most_newer_bytes)
      return Fault::struct_size(
          {Description<Struct>::name, "struct_size"},
          {theirs.struct_size, "bytes", Description<Struct>::first, sizeof(Struct) + most_newer_bytes},
          "set it to sizeof the struct; structs that are read have a _default() that does");
  }
  return {};
}

/// Refuses bytes that a caller with a newer header set beyond those known to this library. `size`: theirs.
Fault check_tail(const void* theirs, std::size_t size, std::size_t ours, const char* name);

/// Why `value` of that member is refused. `of`: the caller's name of the struct.
Fault refuse(const Member& member, const char* of, double value, std::int32_t index = -1);

/// One number against a member's range. `high`: where less than the member's own is allowed.
inline bool within(const Member& member, double value) {
  return (value >= member.low && value <= member.high) || (member.or_zero && value == 0.0);
}
inline Fault check(const Member& member, const char* of, double value) {
  return within(member, value) ? Fault{} : refuse(member, of, value);
}
inline Fault check(const Member& member, const char* of, double value, double high) {
  Member narrower = member;
  narrower.high = high;
  return check(narrower, of, value);
}

/// Numbers behind a pointer, each against the range; the fault names the first that is outside.
inline Fault check_all(const Member& member, const char* of, const double* values, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (!within(member, values[i])) return refuse(member, of, values[i], static_cast<std::int32_t>(i));
  }
  return {};
}

namespace detail {

template <typename Value>
Value load(const char* bytes, std::size_t offset) {
  Value value;
  std::memcpy(&value, bytes + offset, sizeof value);
  return value;
}

/// Value of a member that is a number.
inline double number(const char* bytes, const Member& member) {
  switch (member.type) {
    case Type::int32:
      return load<std::int32_t>(bytes, member.offset);
    case Type::uint32:
      return load<std::uint32_t>(bytes, member.offset);
    case Type::uint64:
      return static_cast<double>(load<std::uint64_t>(bytes, member.offset));
    default:
      return load<double>(bytes, member.offset);
  }
}

/// Is a member read at all?
template <typename Struct, std::size_t i>
bool is_read(const char* bytes) {
  constexpr const Member& member = Description<Struct>::members[i];
  if constexpr (member.asked == nowhere) {
    return true;
  } else if constexpr (member.state == State::value) {
    return load<std::int32_t>(bytes, member.asked) == member.asked_for;
  } else if constexpr (member.state == State::null) {
    return load<const void*>(bytes, member.asked) == nullptr;
  } else {
    return (load<std::uint32_t>(bytes, member.asked) == 0) == (member.state == State::zero);
  }
}

/// Does one member conform? Everything but the values is known at compile time.
template <typename Struct, std::size_t i, bool behind_pointers>
bool conforms(const char* bytes, const char* of, Fault& fault) {
  constexpr const Member& member = Description<Struct>::members[i];
  if constexpr (((member.by_caller || member.rule == Rule::none) && !member.required) ||
                (member.type == Type::pointer) != behind_pointers) {
    return true;
  } else if constexpr (member.type == Type::pointer) {
    if (!is_read<Struct, i>(bytes)) return true;
    const auto* numbers = load<const double*>(bytes, member.offset);
    if (numbers == nullptr) {
      if constexpr (member.required) fault = refuse(member, of, 0.0);
      return !member.required;
    }
    if constexpr (member.rule == Rule::range && !member.by_caller)
      fault = check_all(member, of, numbers, load<std::uint32_t>(bytes, member.counted_by));
    return !fault.failed();
  } else {
    using Value = std::conditional_t<
        member.type == Type::real, double,
        std::conditional_t<member.type == Type::int32, std::int32_t,
                           std::conditional_t<member.type == Type::uint32, std::uint32_t, std::uint64_t>>>;
    const bool read = is_read<Struct, i>(bytes);
    if constexpr (member.otherwise == nullptr)
      if (!read) return true;
    for (std::int32_t k = 0; k < member.elements; ++k) {
      const auto value = load<Value>(bytes, member.offset + static_cast<std::size_t>(k) * sizeof(Value));
      bool fine = value == Value{};  // for members kept for later, or not read
      if constexpr (member.rule == Rule::range)
        fine = read ? within(member, static_cast<double>(value)) : fine;
      else if constexpr (member.rule == Rule::one_of)
        fine = member.enumeration->has(value);
      if (fine) continue;
      fault = refuse(member, of, static_cast<double>(value), member.elements > 1 ? k : -1);
      if (!read && fault.status == WRC_ERROR_RANGE) {
        fault.low = fault.high = 0.0;
        fault.cause = member.otherwise;
      }
      return false;
    }
    return true;
  }
}

template <typename Struct, std::size_t... i>
Fault check_members(const Struct& ours, const char* of, std::index_sequence<i...>) {
  Fault fault;
  const auto* bytes = reinterpret_cast<const char*>(&ours);
  // Numbers behind pointers last: by then their count is known to be one.
  if ((conforms<Struct, i, false>(bytes, of, fault) && ...))
    (void)(conforms<Struct, i, true>(bytes, of, fault) && ...);
  return fault;
}

}  // namespace detail

/// A number of a struct by its description.
template <typename Struct>
double number_in(const Struct& of, const Member& member) {
  return detail::number(reinterpret_cast<const char*>(&of), member);
}

/// Reads the caller's struct, of whatever version, over today's defaults, and checks each of its members by
/// its description. `name`: its name in messages.
template <typename Struct>
Fault read(const Struct* theirs, const char* name, Struct& ours) {
  ours = defaults<Struct>();
  if (theirs == nullptr) return Fault::null(name);
  if constexpr (Description<Struct>::versioned) {
    Fault fault = check_size(*theirs);
    if (!fault.failed()) fault = check_tail(theirs, theirs->struct_size, sizeof(Struct), name);
    if (fault.failed()) return fault;
    std::memcpy(&ours, theirs, std::min<std::size_t>(theirs->struct_size, sizeof(Struct)));
    ours.struct_size = sizeof(Struct);
  } else {
    ours = *theirs;
  }
  return detail::check_members(ours, name,
                               std::make_index_sequence<std::size(Description<Struct>::members)>());
}

/// The same where NULL means the defaults.
template <typename Struct>
Fault read_or_defaults(const Struct* theirs, const char* name, Struct& ours) {
  if (theirs != nullptr) return read(theirs, name, ours);
  ours = defaults<Struct>();
  return {};
}

/// One of an array of the caller's structs, `size` bytes of it; else as read().
template <typename Struct>
Fault read_element(const void* theirs, std::size_t size, const char* name, Struct& ours) {
  ours = defaults<Struct>();
  RETURN_IF_FAILED(check_tail(theirs, size, sizeof(Struct), name));
  std::memcpy(&ours, theirs, std::min(size, sizeof(Struct)));
  return detail::check_members(ours, name,
                               std::make_index_sequence<std::size(Description<Struct>::members)>());
}

/// Writes as much of `ours` as the caller's version holds, and zeros beyond; NULL means not wanted.
template <typename Struct>
void write(const Struct& ours, Struct* theirs) {
  if (theirs == nullptr || check_size(*theirs).failed()) return;
  if constexpr (Description<Struct>::versioned) {
    const std::uint32_t size = theirs->struct_size;
    std::memcpy(theirs, &ours, std::min<std::size_t>(size, sizeof(Struct)));
    if (size > sizeof(Struct))
      std::memset(reinterpret_cast<char*>(theirs) + sizeof(Struct), 0, size - sizeof(Struct));
    theirs->struct_size = size;
  } else {
    *theirs = ours;
  }
}

/// Output of a call about to run: zeroed now, so that a failure leaves no old numbers behind. NULL is fine.
template <typename Struct>
Fault clear(Struct* theirs) {
  if (theirs == nullptr) return {};
  RETURN_IF_FAILED(check_size(*theirs));
  write(empty<Struct>(), theirs);
  return {};
}

/// The wrc_..._init of a struct: its defaults over as much of it as the caller's version has.
template <typename Struct>
std::int32_t init(Struct* theirs) {
  if (theirs == nullptr) return WRC_ERROR_NULL;
  const Fault fault = check_size(*theirs);
  if (fault.failed()) return fault.status;
  write(defaults<Struct>(), theirs);
  return WRC_OK;
}

/// An array of bins of the caller in `ours`, whose size is that of the caller's header. `size`: its member.
template <typename Bin, typename Struct>
Fault check_bins(const Struct& ours, const char* name, const Member& size, const char* remedy) {
  if (ours.bins == nullptr) return Fault::null({name, "bins"});
  if (ours.bin_size >= sizeof(Bin) && ours.bin_size % alignof(Bin) == 0) return {};
  return Fault::struct_size({name, "bin_size"}, {ours.bin_size, "bytes", sizeof(Bin), size.high}, remedy);
}

/// The first that failed, or none. All are evaluated: outputs beside one that cannot be cleared are cleared.
inline Fault first_of(std::initializer_list<Fault> faults) {
  for (const Fault& each : faults) {
    if (each.failed()) return each;
  }
  return {};
}

/// One number against its range [low, high]; NaN and infinity are told apart from a range error. For
/// arguments and ranges that other members set; a member's own range is in its description.
inline Fault check(double value, const char* field, const char* unit, double low, double high,
                   const char* too_low = nullptr, const char* too_high = nullptr) {
  if (!std::isfinite(value)) {
    return Fault::not_finite(field, {value, unit, low, high});
  }
  if (value >= low && value <= high) return {};
  return Fault::range(field, {value, unit, low, high}, value < low ? too_low : too_high);
}

/// An array of numbers, each against the range; the fault names the first that is outside.
inline Fault check_all(const double* values, std::size_t count, const char* field, const char* unit,
                       double low, double high, const char* too_low, const char* too_high) {
  for (std::size_t i = 0; i < count; ++i) {
    Fault fault = check(values[i], field, unit, low, high, too_low, too_high);
    fault.index = static_cast<std::int32_t>(i);
    if (fault.failed()) return fault;
  }
  return {};
}

/// Has an enumerator of the inside the value of the interface's? Then the one may be cast to the other.
template <auto theirs, class Enum>
constexpr bool same(Enum ours) {
  return static_cast<std::int64_t>(theirs) == static_cast<std::int64_t>(ours);
}

}  // namespace wrc::abi
