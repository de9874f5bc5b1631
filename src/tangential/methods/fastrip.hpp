/// FaStrip (Sichani, Enblom, Berg, VSD 54(6) 2016): strip theory where a strip sticks, FASTSIM's directions
/// where it slips, and friction times pressure for the size.
///
/// Strip theory treats every strip as rolling of long cylinders; Kalker's coefficients in it give the forces
/// of linear theory. With l the strip's half length, its pressure (p_j / l) sqrt(l^2 - x^2), t' = mu p_j / l,
/// and
///
///     q = -(2 G C11 nu_x / pi^2 - k13 phi y) / t',   r = -(2 G C22 nu_y / pi^2) / t' + psi x_centre   [m],
///     psi = -3 G c C23 phi / (2 pi a t'),
///
/// the trailing 2 d of the strip slip, d = (r psi + sqrt(r^2 + (1 - psi^2) q^2)) / (1 - psi^2). Where it
/// sticks, with (kappa, lambda) the direction of (w q, w r + psi d), S = sqrt(l^2 - x^2) and
/// S* = sqrt((l - d)^2 - (x - d)^2),
///
///     p = t' ( (kappa, lambda) S - (kappa, lambda - psi) S* ).
///
/// A strip with d >= l slips as a whole, and so does one whose stick zone would exceed the bound, which takes
/// |psi| > 1. In the slip zone p = mu p_n e, e the direction of FASTSIM's traction in the same cell: with
/// separate flexibilities, and with the common one of large creepages (flexibility_form.hpp) in strips that
/// slip as a whole; Kalker's single one, up to sqrt(3) too soft, makes twice the error there.
///
/// Published for ellipses, where k13 = 3 G c C23 / (2 pi a (1 - nu)). By the patch model:
///  - the equivalent ellipse, at the contact point or at mid-width: FASTSIM has the parabolic bound, of a
///    load larger by the factor 1 + (1 - a/b)^4 for a < b.
///  - the patch with the ellipse's coefficients (modified FaStrip): FASTSIM has friction times pressure for
///    its bound.
///  - the patch with the double ellipse's coefficients (FaStrip-SDEC, own): the same, and from its linear
///    theory k13 = 3 G c^3 K13 / (4 pi a b^2).
///
/// The weight w is 1 - nu as in the reference program's source, where the formulas come from; the strip part
/// is confirmed against its results. d belongs to w = 1 alone, for which (q, r + psi d) / d is a unit vector
/// and the stick zone moves as a rigid body; FaStrip-SDEC takes that. Where the program's variants differ
/// from ours: theory manual, section 5. Not published, or not read: the numbers cells see (here means over
/// them), and the slip: power is the balance -(Fx nu_x + Fy nu_y + Mz phi), and the slip, in the form of
/// Carter's solution, is scaled to dissipate that.
#pragma once

#include <cstdint>

#include "tangential/rolling_contact.hpp"

namespace wrc::tangential {

/// Memory the method works in [bytes], aligned as doubles.
std::int64_t fastrip_workspace(std::int32_t strips, std::int32_t cells);

/// contact.region: the strips contact.model asks for, about the origin of contact.creepage;
/// contact.workspace: fastrip_workspace(). All four fields must be given. contact.bound and contact.form are
/// not used.
TangentialForces fastrip(const RollingContact& contact, const TangentialFields& fields, Fault& fault);

}  // namespace wrc::tangential
