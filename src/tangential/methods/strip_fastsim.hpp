/// FASTSIM in the shape of strip theory: the library's own default for non-elliptic patches.
///
/// FASTSIM with the parabolic bound B u v (u, v: distances from the trailing and the leading edge of a strip)
/// and two-dimensional half-space theory share the same stick zone. Both have slip at u < u_s, u_s the root
/// of gx^2 + (beta + k u)^2 = B^2 u^2; with t = u_s / u, (kappa, lambda) the direction at u_s and
/// psi = -k / B,
///
///     FASTSIM        p / tau = (kappa, lambda) t                 + (0, psi) (1 - t),
///     strip theory   p / tau = (kappa, lambda) (1 - sqrt(1 - t)) + (0, psi) sqrt(1 - t),
///
/// tau being the parabolic bound there and mu p_n here (Carter's solution without spin; FaStrip's, Sichani,
/// Enblom, Berg 2016, with it). So the march stays FASTSIM's, at its cost, and the traction is read off with
/// the second line. Then |p| <= mu p_n, the leading edge has the square-root rise of the exact theory, and
/// the force is Coulomb's for large creepages.
///
///  - Strips of a real patch: how stiffly each strip is held by its neighbours follows from the normal
///    problem. A wheel has nearly one curvature along x. So the peak pressure over the length, p_j / l_j, is
///    the answer of the half-spaces to the same displacement in every strip. Full-adhesion tractions, the
///    answer to a displacement linear in x, follow it closely: on S1002 and UIC60 it goes from 120 to 200
///    MPa/mm across a patch with two lobes, tractions in proportion. Hence adhesion tractions go with
///    p_j / l_j. As the bound does too, p_j / l_j drops out of the march, and B is one number per patch.
///    The double ellipse whose linear theory scales all this has the patch's area and the half length
///    3 N / (4 IInt peak dy), by which a double ellipse is itself, and is centred midway between the
///    centroids of area and of stiffness.
///  - Flexibilities: the adhesion tractions go like sqrt(v/u) for creepages and sqrt(u v) for spin instead
///    of v and u v; factors from integrating both over an SDEC restore the forces of linear theory.
///  - Spin stretches the surfaces along x by -phi y. Neighbouring strips resist each other's differences:
///    the longitudinal adhesion tractions vanish not on the x axis but at the neutral line, y_n towards the
///    patch's centre, and grow faster from there. Two numbers, slope and y_n, give C13 and C33 of linear
///    theory, and so the power of spin. As the patch saturates the line moves to the axis.
///  - Slip opposes the true rigid slip w plus the elastic slip, not the creepages each over its own
///    flexibility: with those the force of large creepages is up to 7 degrees off its direction. Under the
///    semi-elliptic traction of a slipping strip du/dx is linear, 2 B L x; its part that differs between x
///    and y is kept.
///  - Calibration (strip_calibration.hpp): deviations of a patch of finite width from strip theory, smooth
///    functions of slenderness and saturation which vanish with the creepages, except for the turning of
///    slip, which is not part of linear theory. Fitted to random patches solved with src/halfspace, double
///    ellipses and wheels on rails; never to results of another program.
///
/// Power is the balance -(Fx nu_x + Fy nu_y + Mz phi), an identity of the exact theory; the local slip
/// follows Carter's distribution and is scaled by one factor so that the fields dissipate exactly that.
#pragma once

#include "tangential/methods/strip_calibration.hpp"
#include "tangential/rolling_contact.hpp"

namespace wrc::tangential {

/// contact.region: the strips of the actual patch. contact.bound is not used, the bound is mu p_n; nor, but
/// for a patch without pressure, are a, b and shape_number. With sensitivities no fields are written.
TangentialForces strip_fastsim(const RollingContact& contact, const TangentialFields& fields, Fault& fault,
                               TangentialSensitivities* sensitivities = nullptr);

/// The same with other constants than the fitted ones, for the calibration itself.
TangentialForces calibrated_strip_fastsim(const RollingContact& contact, const TangentialFields& fields,
                                          Fault& fault, TangentialSensitivities* sensitivities,
                                          const StripCalibration& calibration);

/// chi, the neutral line of spin in linear theory over psi b: with it and C13 the model has the C33 of an
/// SDEC. u = (a - b) / (a + b). Fitted to the coefficients of tools/linear_theory/linear_theory.hpp for a/b
/// 0.2 to 5, Poisson ratios 0.25 and 0.3, |psi| <= 0.7, within 0.018 (tools/calibration/neutral_line.cpp).
template <class Number>
Number neutral_line(const Number& u, double poisson, double shape_number) {
  return 0.164 + 0.284 * u + 0.140 * u * u - (0.627 + 0.500 * u) * (poisson - 0.27) -
         0.077 * shape_number * shape_number;
}

/// The double ellipse that stands for the patch in linear theory: see above.
struct StripEllipse {
  double a = 0.0, b = 0.0, shape_number = 0.0;  ///< semi-axes [m], psi [-]
  double y_stiff = 0.0;                         ///< lateral centre of the strips' stiffness [m]
  double pressure_per_length = 0.0;             ///< mean of peak / half length over the area [Pa/m]
  double normal_force = 0.0;                    ///< [N]
};

StripEllipse strip_ellipse(const RollingContact& contact);

}  // namespace wrc::tangential
