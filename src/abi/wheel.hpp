/// The wheel on a rail at the C boundary, for the calls that solve it one way or the other.
#pragma once

#include "abi/structs.hpp"
#include "contact/wheel.hpp"

namespace wrc::abi {

/// Reads and checks the caller's wheel; `method`: the one that reads its friction. A flag where the rotation
/// may be a transpose: the least grave of a call's.
Fault read_hosted(const wrc_wheel_input* theirs, const contact::TangentialMethod& method,
                  contact::HostWheel& hosted);

/// struct_size of the result is that of today's struct; write() keeps the caller's.
wrc_wrench wrench_of(const contact::HostWrench& hosted);

}  // namespace wrc::abi
