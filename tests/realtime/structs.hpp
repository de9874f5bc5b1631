/// What every program in this folder does with the C interface first: structs get their size, then their
/// defaults.
#pragma once

#include <cstdint>

#include "made.hpp"
#include "presets.hpp"
#include "wrc/wrc.h"

/// Has this processor, and this build, the instruction set?
inline bool available(int32_t instruction_set) {
  wrc_config config = made<wrc_config>(wrc_config_init);
  config.instruction_set = instruction_set;
  return wrc_config_check(&config, nullptr, 0) == WRC_OK;
}
