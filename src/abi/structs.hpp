/// How versioned structs cross the boundary: read the caller's version into today's struct, write today's
/// result into the caller's version, and check single values.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <initializer_list>

#include "fault.hpp"
#include "wrc/wrc.h"

namespace wrc::abi {

/// Defaults and first published size of every struct, and its name in messages. The size is pinned: it is
/// what the oldest caller passes.
template <typename Struct>
struct Version;

#define WRC_STRUCT(type, pinned_size)                   \
  template <>                                           \
  struct Version<type> {                                \
    static constexpr const char* name = #type;          \
    static constexpr std::size_t first = (pinned_size); \
  };
WRC_STRUCT(wrc_profile, 40)
WRC_STRUCT(wrc_config, 144)
WRC_STRUCT(wrc_pose, 32)
WRC_STRUCT(wrc_contact_point, 72)
WRC_STRUCT(wrc_gap, 72)
WRC_STRUCT(wrc_load, 24)
WRC_STRUCT(wrc_creepage, 40)
WRC_STRUCT(wrc_friction, 16)
WRC_STRUCT(wrc_patch, 112)
WRC_STRUCT(wrc_strips, 48)
WRC_STRUCT(wrc_forces, 56)
WRC_STRUCT(wrc_motion, 56)
WRC_STRUCT(wrc_damage, 80)
WRC_STRUCT(wrc_wear_laws, 160)
WRC_STRUCT(wrc_wear, 32)
WRC_STRUCT(wrc_coefficients, 64)
WRC_STRUCT(wrc_sensitivity, 128)
WRC_STRUCT(wrc_step_sensitivity, 72)
WRC_STRUCT(wrc_input, 48)
WRC_STRUCT(wrc_output, 40)
WRC_STRUCT(wrc_view, 48)
WRC_STRUCT(wrc_allocator, 32)
WRC_STRUCT(wrc_wheel_state, 104)
WRC_STRUCT(wrc_rail_state, 56)
WRC_STRUCT(wrc_wheel_input, 48)
WRC_STRUCT(wrc_wrench, 160)
WRC_STRUCT(wrc_region, 176)

/// All zero but for struct_size.
template <typename Struct>
Struct empty() {
  Struct value{};
  value.struct_size = sizeof(Struct);
  return value;
}

/// Today's defaults of a struct, struct_size included.
template <typename Struct>
Struct defaults();

#define WRC_EMPTY_BY_DEFAULT(type) \
  template <>                      \
  type defaults<type>() {          \
    return empty<type>();          \
  }

/// Is the caller's struct_size one we know? Larger than ours is a newer header than this library.
template <typename Struct>
Fault check_size(const Struct& theirs) {
  if (theirs.struct_size >= Version<Struct>::first && theirs.struct_size <= sizeof(Struct)) return {};
  return {
      .status = WRC_ERROR_STRUCT_SIZE,
      .field = Version<Struct>::name,
      .value = static_cast<double>(theirs.struct_size),
      .unit = "bytes",
      .low = static_cast<double>(Version<Struct>::first),
      .high = static_cast<double>(sizeof(Struct)),
      .cause = "set struct_size = sizeof the struct before its init; is the library older than the header?"};
}

/// Reads the caller's struct, of whatever version, over today's defaults.
template <typename Struct>
Fault read(const Struct* theirs, const char* name, Struct& ours) {
  ours = defaults<Struct>();
  if (theirs == nullptr) return {.status = WRC_ERROR_NULL, .field = name};
  const Fault fault = check_size(*theirs);
  if (fault.failed()) return fault;
  std::memcpy(&ours, theirs, theirs->struct_size);
  ours.struct_size = sizeof(Struct);
  return {};
}

/// Writes as much of `ours` as the caller's version holds; NULL means not wanted.
template <typename Struct>
void write(const Struct& ours, Struct* theirs) {
  if (theirs == nullptr || check_size(*theirs).failed()) return;
  const std::uint32_t size = theirs->struct_size;
  std::memcpy(theirs, &ours, size);
  theirs->struct_size = size;
}

/// Output of a call about to run: zeroed now, so that a failure leaves no old numbers behind. NULL is fine.
template <typename Struct>
Fault clear(Struct* theirs) {
  if (theirs == nullptr) return {};
  const Fault fault = check_size(*theirs);
  if (fault.failed()) return fault;
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

/// The first that failed, or none. All are evaluated: outputs beside one that cannot be cleared are cleared.
inline Fault first_of(std::initializer_list<Fault> faults) {
  for (const Fault& each : faults) {
    if (each.failed()) return each;
  }
  return {};
}

/// One number against its range [low, high]; NaN and infinity are told apart from a range error.
inline Fault check(double value, const char* field, const char* unit, double low, double high,
                   const char* too_low = nullptr, const char* too_high = nullptr) {
  if (!std::isfinite(value)) {
    return {.status = WRC_ERROR_NOT_FINITE,
            .field = field,
            .value = value,
            .unit = unit,
            .low = low,
            .high = high};
  }
  if (value >= low && value <= high) return {};
  return {.status = WRC_ERROR_RANGE,
          .field = field,
          .value = value,
          .unit = unit,
          .low = low,
          .high = high,
          .cause = value < low ? too_low : too_high};
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

}  // namespace wrc::abi
