/// FASTSIM-EQ.L: FASTSIM on the actual region, with the flexibilities of the equivalent ellipse. Spin turns
/// about the contact point (on a double ellipse its joint), a choice where L1 and L3 differ: theory manual,
/// section 5.
#pragma once

#include "tangential/rolling_contact.hpp"

namespace wrc {

/// contact.region: the strips of the actual patch; contact.a, contact.b: its equivalent ellipse.
TangentialForces fastsim_eql(const RollingContact& contact, const TangentialFields& fields, Fault& fault,
                             TangentialSensitivities* sensitivities = nullptr);

}  // namespace wrc
