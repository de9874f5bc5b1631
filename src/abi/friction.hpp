/// Friction across the boundary.
#pragma once

#include "contact/contact.hpp"
#include "fault.hpp"
#include "wrc/wrc.h"

namespace wrc::abi {

/// Reads and checks the caller's friction for a tangential method. The zones of the result are the caller's
/// arrays.
Fault read_friction(const wrc_friction* theirs, TangentialMethod method, Friction& friction);

}  // namespace wrc::abi
