/// Friction across the boundary.
#pragma once

#include "base/fault.hpp"
#include "contact/methods.hpp"
#include "contact/state.hpp"
#include "wrc/wrc.h"

namespace wrc::abi {

/// Translates friction whose members have been checked, and checks it for a tangential method. `of`: its
/// name in messages. The zones of the result are the caller's arrays.
Fault read_friction(const wrc_friction& checked, const char* of, const contact::TangentialMethod& method,
                    contact::Friction& friction);

}  // namespace wrc::abi
