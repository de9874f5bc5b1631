/// FASTSIM in the shape of strip theory: the library's own default for non-elliptic patches.
///
/// FASTSIM with the parabolic bound B u v (u, v: distances from the trailing and the leading edge of a strip)
/// and two-dimensional half-space theory share the same stick zone. Both have slip at u < u_s, u_s the root
/// of gx^2 + (beta + k u)^2 = B^2 u^2; with t = u_s / u, (kappa, lambda) the direction at u_s and psi = -k /
/// B,
///
///     FASTSIM        p / tau = (kappa, lambda) t             + (0, psi) (1 - t),
///     strip theory   p / tau = (kappa, lambda) (1 - sqrt(1-t)) + (0, psi) sqrt(1-t),
///
/// tau being the parabolic bound there and mu p_n here (Carter's solution without spin; FaStrip's, Sichani,
/// Enblom, Berg 2016, with it). So the march stays FASTSIM's, at its cost, and the traction is read off with
/// the second line: |p| <= mu p_n, the leading edge has the square-root rise of the exact theory, and the
/// force is Coulomb's for large creepages.
///
///  - Flexibilities: the adhesion tractions go like sqrt(v/u) for creepages and sqrt(u v) for spin instead of
///  v
///    and u v; factors from integrating both over an SDEC restore the forces of linear theory.
///  - Slip opposes the true rigid slip w plus the elastic slip, not the creepages each over its own
///  flexibility:
///    with those the force of large creepages points up to 7 degrees the wrong way. Under the semi-elliptic
///    traction of a slipping strip du/dx is linear, 2 B L x; its part that differs between x and y is kept.
///  - Calibration: deviations of a patch of finite width from strip theory, smooth functions of the
///  slenderness
///    (a - b) / (a + b), of the saturation by spin and of lateral creepage pulling with or against spin. They
///    vanish with the creepages, except for the form of the stick zone, which linear theory leaves free, and
///    the turning of slip. Fitted to 1900 random SDEC patches (a/b 0.25 to 3, |psi| <= 0.7, Poisson ratio
///    0.25 to 0.30, creepages up to six times what saturates the patch in linear theory) solved on 32 x 32
///    and 64 x 64 cells, extrapolated, with the exact half-space solver of src/halfspace.
///
/// Power is the balance -(Fx nu_x + Fy nu_y + Mz phi), an identity of the exact theory; the local slip
/// follows Carter's distribution and is scaled by one factor so that the fields dissipate exactly that.
#pragma once

#include "tangential/rolling_contact.hpp"
#include "tangential/strip_calibration.hpp"

namespace wrc {

/// contact.region: the strips of the actual patch; contact.a, contact.b, contact.shape_number: its SDEC.
/// contact.bound is not used: the bound is mu p_n.
/// Other constants than the fitted ones are for the calibration itself.
TangentialForces strip_fastsim(const RollingContact& contact, const TangentialFields& fields, Fault& fault,
                               const StripCalibration& calibration = fitted_calibration);

/// Forces with their derivatives, exact for the discrete model at a fixed patch.
struct TangentialSensitivities {
  /// Rows: Fx, Fy, Mz. Columns: nu_x, nu_y, phi, N (patch and pressure distribution kept, pressure
  /// proportional), mu.
  double d[3][5] = {};
};

TangentialForces strip_fastsim(const RollingContact& contact, TangentialSensitivities& sensitivities,
                               Fault& fault);

}  // namespace wrc
