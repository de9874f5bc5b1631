/// Modified FASTSIM (Spiryagin, Polach, Cole, VSD 51(11) 2013): FASTSIM with the slope of measured creep
/// curves, which a layer between the bodies makes smaller than that of clean surfaces, the more so the more
/// they slip.
///
///     k = k0 (alpha_inf + (1 - alpha_inf) / (1 + beta eps)),   every flexibility divided by k, blended
///     before, eps = G pi a b k0 C11 s / (4 mu N),   s = sqrt(nu_x^2 + s_y^2), s_y = nu_y + phi a, or nu_y
///     where that is larger in magnitude.
///
/// k0 is in contact.shear_modulus already, as for every method; alpha_inf and beta are contact.slope. Carried
/// from ellipses to any patch as the field's reference program does: strips of the actual patch,
/// flexibilities of its equivalent ellipse, the bound of choice. From the formulas in that program's public
/// source, and confirmed against its results.
#pragma once

#include "tangential/rolling_contact.hpp"

namespace wrc {

/// contact.region: the strips of the actual patch; contact.a, contact.b: its equivalent ellipse.
TangentialForces modified_fastsim(const RollingContact& contact, const TangentialFields& fields,
                                  Fault& fault);

}  // namespace wrc
