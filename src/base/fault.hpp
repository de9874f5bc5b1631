/// Faults in an engineer's terms: every module of the library reports through a Fault.
///
/// A Fault is a handful of pointers to string literals and numbers, so that raising one on the hot path costs
/// nothing; the sentence is only written when the host asks for it (wrc_contact_last_error, abi/message.cpp).
#pragma once

#include <cstdint>
#include <limits>

#include "wrc/wrc_status.h"

namespace wrc {

/// Name of the input at fault, as the caller knows it, with the struct it is a member of, its index in an
/// array, or both.
struct FaultPlace {
  constexpr FaultPlace(const char* field_ = nullptr) : field(field_) {}
  constexpr FaultPlace(const char* of_, const char* field_) : of(of_), field(field_) {}
  template <class Index>
  constexpr FaultPlace(const char* field_, Index index_)
      : field(field_), index(static_cast<std::int32_t>(index_)) {}
  template <class Index>
  constexpr FaultPlace(const char* of_, const char* field_, Index index_)
      : of(of_), field(field_), index(static_cast<std::int32_t>(index_)) {}

  const char* of = nullptr;
  const char* field;
  std::int32_t index = -1;
};

/// Number at fault, its unit, and the range it may be in.
struct FaultNumber {
  template <class Value>
  constexpr FaultNumber(Value value_, const char* unit_ = nullptr)
      : value(static_cast<double>(value_)), unit(unit_) {}
  template <class Value, class Low, class High>
  constexpr FaultNumber(Value value_, const char* unit_, Low low_, High high_)
      : value(static_cast<double>(value_)),
        unit(unit_),
        low(static_cast<double>(low_)),
        high(static_cast<double>(high_)) {}

  double value;
  const char* unit;
  double low = 0.0, high = 0.0;
};

/// One fault, or none. Made by its kinds: Fault::range("row_length", {length, "m", 1e-3, 1e9}, "likely
/// cause").
struct Fault {
  std::int32_t status = WRC_OK;  ///< a value of wrc_status: < 0 failed, > 0 usable but flagged
  std::int32_t index = -1;       ///< element of an array the fault is about, -1 if none
  const char* of = nullptr;      ///< the struct whose member `field` is, as the caller knows it
  const char* field = nullptr;   ///< input at fault, by the name the caller knows ("load.normal_force")
  double value = 0.0;            ///< its value, in `unit`
  const char* unit = nullptr;    ///< nullptr: the fault is not about a number
  double low = 0.0, high = 0.0;  ///< allowed range, or the one allowed value; 0, 0: none to name
  const char* cause = nullptr;   ///< likely cause or remedy, a short clause ("did you pass kN?")
  const char* call = nullptr;    ///< the function that was called; nullptr: none of the interface's
  std::uint64_t flags = 0;       ///< bit 1 << flag of those met beside `status`
  /// Place along the track of the rail's section whose index is `index` [m]; NaN: about no section.
  double distance = std::numeric_limits<double>::quiet_NaN();

  bool failed() const { return status < 0; }

  /// Bit 1 << flag of every flag met; 0 of a failure.
  std::uint32_t all_flags() const {
    if (failed()) return 0;
    return static_cast<std::uint32_t>(flags) | (status > 0 ? std::uint32_t{1} << status : 0);
  }
  bool has(std::int32_t flag) const { return (all_flags() >> flag & 1U) != 0; }

  /// Makes the faults of one status: about an input, about a number, or about no more than the status says.
  struct Kind {
    std::int32_t status_;

    constexpr Fault operator()(FaultPlace at = {}, const char* why = nullptr) const {
      return {.status = status_, .index = at.index, .of = at.of, .field = at.field, .cause = why};
    }
    constexpr Fault operator()(FaultPlace at, FaultNumber number, const char* why = nullptr) const {
      return {.status = status_,
              .index = at.index,
              .of = at.of,
              .field = at.field,
              .value = number.value,
              .unit = number.unit,
              .low = number.low,
              .high = number.high,
              .cause = why};
    }
  };

  static constexpr Kind null{WRC_ERROR_NULL}, struct_size{WRC_ERROR_STRUCT_SIZE},
      not_finite{WRC_ERROR_NOT_FINITE}, range{WRC_ERROR_RANGE}, profile{WRC_ERROR_PROFILE},
      gap{WRC_ERROR_GAP}, load{WRC_ERROR_LOAD}, buffer{WRC_ERROR_BUFFER}, memory{WRC_ERROR_MEMORY},
      sequence{WRC_ERROR_SEQUENCE}, unsupported{WRC_ERROR_UNSUPPORTED}, file{WRC_ERROR_FILE},
      cancelled{WRC_ERROR_CANCELLED}, internal{WRC_ERROR_INTERNAL};
  static constexpr Kind no_contact{WRC_FLAG_NO_CONTACT}, iteration_cap{WRC_FLAG_ITERATION_CAP},
      sum_overflow{WRC_FLAG_SUM_OVERFLOW}, beyond_gap{WRC_FLAG_BEYOND_GAP},
      patch_at_edge{WRC_FLAG_PATCH_AT_EDGE}, more_patches{WRC_FLAG_MORE_PATCHES}, climbing{WRC_FLAG_CLIMBING},
      load_jumps{WRC_FLAG_LOAD_JUMPS}, force_jumps{WRC_FLAG_FORCE_JUMPS},
      beyond_sections{WRC_FLAG_BEYOND_SECTIONS}, table_range{WRC_FLAG_TABLE_RANGE},
      creepages_limited{WRC_FLAG_CREEPAGES_LIMITED}, dissimilar_materials{WRC_FLAG_DISSIMILAR_MATERIALS},
      rotation_transposed{WRC_FLAG_ROTATION_TRANSPOSED}, memory_dropped{WRC_FLAG_MEMORY_DROPPED};
};

// A contact's saved state holds its last fault: with padding here, equal states could differ in their bytes.
static_assert(sizeof(void*) != 8 || sizeof(Fault) == 2 * sizeof(std::int32_t) + 5 * sizeof(const char*) +
                                                         4 * sizeof(double) + sizeof(std::uint64_t));

/// Which of two statuses says more about whether a result can be used: failures, then flags from the gravest
/// to the least grave, then WRC_OK. Larger is graver.
constexpr std::int32_t gravity(std::int32_t status) {
  if (status <= 0) return status < 0 ? 100 : 0;
  constexpr std::int32_t gravest_first[] = {
      WRC_FLAG_NO_CONTACT,        WRC_FLAG_ITERATION_CAP,        WRC_FLAG_SUM_OVERFLOW,
      WRC_FLAG_BEYOND_GAP,        WRC_FLAG_PATCH_AT_EDGE,        WRC_FLAG_MORE_PATCHES,
      WRC_FLAG_CLIMBING,          WRC_FLAG_LOAD_JUMPS,           WRC_FLAG_FORCE_JUMPS,
      WRC_FLAG_MEMORY_DROPPED,    WRC_FLAG_BEYOND_SECTIONS,      WRC_FLAG_TABLE_RANGE,
      WRC_FLAG_CREEPAGES_LIMITED, WRC_FLAG_DISSIMILAR_MATERIALS, WRC_FLAG_ROTATION_TRANSPOSED};
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

/// Leaves the function with the fault of a call that failed; its flags are not kept.
#define RETURN_IF_FAILED(call) \
  if (const auto fault_of_call = (call); fault_of_call.failed()) return fault_of_call
