/// FASTSIM-EQ.E: FASTSIM on the equivalent ellipse, which is centred at the middle of the patch's width.
///
/// The ellipse's centre lies at y_c = psi b from the initial contact point, so the longitudinal creepage
/// there is nu_x - phi y_c (rigid kinematics), and the moment about the initial contact point is M_z(y_c) -
/// y_c F_x.
#pragma once

#include "tangential/rolling_contact.hpp"

namespace wrc {

/// contact.region: the strips of the equivalent ellipse about ITS OWN centre, which is also the origin of the
/// fields. Creepages and forces are at the initial contact point.
TangentialForces fastsim_eqe(const RollingContact& contact, const TangentialFields& fields, Fault& fault,
                             TangentialSensitivities* sensitivities = nullptr);

}  // namespace wrc
