/// FASTSIM (Kalker 1982) on an elliptic patch with Kalker's flexibilities L1, L2, L3; with blended ones
/// confirmed against the reference program within 0.001 mu N.
#pragma once

#include "tangential/rolling_contact.hpp"

namespace wrc {

/// contact.region: the strips of the ellipse about the origin of the creepages. contact.shape_number unused.
TangentialForces fastsim(const RollingContact& contact, const TangentialFields& fields, Fault& fault,
                         TangentialSensitivities* sensitivities = nullptr);

}  // namespace wrc
