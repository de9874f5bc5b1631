/// FASTSIM (Kalker 1982) on any patch model (patch_model.hpp), with the flexibilities of linear theory.
///
///   ellipse at the contact point   FASTSIM as published; with blended flexibilities confirmed against the
///                                  reference program within 0.001 mu N
///   ellipse at mid-width           FASTSIM-EQ.E (Liu, Bruni 2024): creepages are those of the ellipse's
///                                  centre
///   patch, ellipse's coefficients  FASTSIM-EQ.L (same): spin turns about the contact point (on a double
///                                  ellipse its joint), a choice where L1 and L3 differ: theory manual,
///                                  section 5
///   patch, SDEC's coefficients     FASTSIM-SDEC (same): four flexibilities of the double ellipse
///
/// Modified FASTSIM (Spiryagin, Polach, Cole, VSD 51(11) 2013) is a law of the layer between the bodies on
/// any of these: the slope of the creep curve, which the layer makes smaller than that of clean surfaces,
/// falls as they slip,
///
///     k = k0 (alpha_inf + (1 - alpha_inf) / (1 + beta eps)),   eps = G pi a b k0 C11 s / (4 mu N),
///     s = sqrt(nu_x^2 + s_y^2),   s_y = nu_y + phi a, or nu_y where that is larger in magnitude;
///
/// every flexibility is divided by k, and blended before.
/// k0 is in contact.shear_modulus already, as for every method; alpha_inf and beta are contact.slope. Carried
/// from ellipses to any patch as the field's reference program does, there with the ellipse's coefficients on
/// the strips of the patch. From the formulas in that program's public source, and confirmed against its
/// results.
#pragma once

#include "tangential/rolling_contact.hpp"

namespace wrc::tangential {

/// contact.region: the strips contact.model asks for, about the origin of contact.creepage.
TangentialForces fastsim(const RollingContact& contact, const TangentialFields& fields, Fault& fault,
                         TangentialSensitivities* sensitivities = nullptr);

}  // namespace wrc::tangential
