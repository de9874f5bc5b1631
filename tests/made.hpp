/// What every test of the interface needs: its structs ready for use, and numbers that are none.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "wrc/wrc.h"

inline constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// A struct with its size and defaults. `init` is the struct's own.
template <typename Struct>
Struct made(std::int32_t (*init)(Struct*)) {
  Struct value{};
  value.struct_size = sizeof value;
  if (init(&value) != WRC_OK) {
    std::fprintf(stderr, "header and library differ in version\n");
    std::abort();
  }
  return value;
}
