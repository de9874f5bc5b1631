/// What every program in this folder asks of the C interface.
#pragma once

#include <cstdint>

#include "presets.hpp"
#include "test_config.hpp"
#include "wrc/wrc.h"

/// Has this processor, and this build, the instruction set?
inline bool available(int32_t instruction_set) {
  wrc_config config = test_config();
  config.instruction_set = instruction_set;
  return wrc_config_check(&config, nullptr, 0) == WRC_OK;
}
