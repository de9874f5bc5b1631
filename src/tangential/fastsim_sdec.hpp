/// FASTSIM-SDEC (Liu, Bruni 2024): FASTSIM on the actual region, with the four flexibilities of the single
/// double-elliptical contact that regularises it.
#pragma once

#include "tangential/rolling_contact.hpp"

namespace wrc {

/// contact.region: the strips of the actual patch; contact.a, contact.b, contact.shape_number: its SDEC.
TangentialForces fastsim_sdec(const RollingContact& contact, const TangentialFields& fields, Fault& fault,
                              TangentialSensitivities* sensitivities = nullptr);

}  // namespace wrc
