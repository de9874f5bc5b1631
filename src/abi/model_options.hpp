/// From the C configuration to the options a model is made of: every value checked against its documented
/// range.
#pragma once

#include "base/fault.hpp"
#include "contact/model.hpp"
#include "wrc/wrc.h"

namespace wrc::abi {

/// Translates and checks `config`. Profile points are checked for NULL and count here, for their shape by the
/// model.
Fault read_options(const wrc_config* config, contact::ModelOptions& options);

}  // namespace wrc::abi
