/// Wear laws across the boundary.
#pragma once

#include "contact/contact.hpp"
#include "wrc/wrc.h"

namespace wrc::abi {

/// The caller's parameters, whose members have been checked.
WearLaws laws_of(const wrc_wear_laws& checked);

}  // namespace wrc::abi
