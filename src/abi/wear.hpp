/// Wear laws across the boundary.
#pragma once

#include "abi/structs.hpp"
#include "contact/assessments.hpp"
#include "wrc/wrc_damage.h"

namespace wrc::abi {

/// The caller's parameters, checked; NULL: the published ones.
Fault read_wear_laws(const wrc_wear_laws* theirs, const char* name, damage::WearLaws& laws);

}  // namespace wrc::abi
