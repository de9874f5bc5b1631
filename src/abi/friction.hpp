/// Friction across the boundary.
#pragma once

#include "base/fault.hpp"
#include "contact/contact.hpp"
#include "contact/methods.hpp"
#include "wrc/wrc.h"

namespace wrc::abi {

/// Reads and checks the caller's friction for a tangential method. The zones of the result are the caller's
/// arrays.
Fault read_friction(const wrc_friction* theirs, const TangentialMethod& method, Friction& friction);

}  // namespace wrc::abi
