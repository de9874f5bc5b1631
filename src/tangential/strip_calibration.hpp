/// The fitted constants of strip FASTSIM: how a patch of finite width deviates from strip theory as it
/// saturates.
///
/// Each quantity is a sum of constants times terms. x, e, s are the longitudinal force (with the part spin
/// has in it), the lateral force of lateral creepage and that of spin in linear theory, over the friction
/// limit mu N; with Q = 1 + x^2 + e^2 + s^2 every term lies between -1 and 1, vanishes with the creepages
/// (but for the first two) and tends to a constant for large ones. u = (a - b) / (a + b) is the slenderness.
/// All terms stay the same when the patch is mirrored and when all creepages change sign.
///
/// tests/calibration makes the constants; its README has the commands. Zeros are terms the fit did not need.
#pragma once

namespace wrc {

struct StripCalibration {
  enum Term {
    constant,
    slender,         ///< u
    longitudinal,    ///< x^2 / Q
    lateral,         ///< e^2 / Q
    spin,            ///< s^2 / Q
    pull,            ///< e s / Q: lateral creepage pulls with spin (> 0) or against it
    pull_squared,    ///< its square
    longitudinal_u,  ///< u x^2 / Q
    lateral_u,       ///< u e^2 / Q
    spin_u,          ///< u s^2 / Q
    pull_u,          ///< u e s / Q
    pull_squared_u,  ///< u times the square
    unison,    ///< 1 where s^2 = 1, where strip theory lets all strips slip at once; falls off to both sides
    lopsided,  ///< psi x s / Q: the wider half pulls with the longitudinal force or against it
    terms
  };
  enum Quantity {
    flexibility_x,       ///< factor on l11
    flexibility_y,       ///< factor on l22
    flexibility_spin_x,  ///< factor on l13
    flexibility_spin_y,  ///< factor on l23
    turning,             ///< factor on the flexibility with which slip turns the traction
    neutral_line,        ///< added to 1: how far the neutral line of spin is from where it does not stretch
    torsion,  ///< lateral elastic slip, in units of that of a slipping strip's edge, for s^2 / Q = 1
    quantities
  };
  double constants[quantities][terms];
};

/// Rows as Quantity, columns as Term.
// clang-format off
inline constexpr StripCalibration fitted_calibration = {{
    {0, 0, 0.04591, 0.006608, 0, 0.01436, -0.4932, 0.08937, 0.1801, 0.3785, 0.524, 0, 0.01103, 0.172},  // flexibility_x
    {0, 0, 0.1196, 0.074, 0.2363, -0.1601, 0.07169, 0.05931, 0.05635, 0, 0, 0, 0, 0.3122},  // flexibility_y
    {0, 0, 0.1134, 0, -0.0599, 0.02446, -0.4499, 0.1555, 0.2607, 0.6838, 0.5914, 0, 0.1025, 0.2344},  // flexibility_spin_x
    {0, 0, -0.069, 0.2258, -0.1272, 0, 0, -0.08325, 0, 0.1785, -0.05042, 0, -0.004714, 0.1406},  // flexibility_spin_y
    {-0.1237, 0.1397, -0.3638, 0, -2.244, -0.5309, 0.4595, 0, 0, 0.6902, 0, 0, -0.4787, 0.2158},  // turning
    {0, 0, -0.8315, -0.6103, -0.8158, -0.2928, 0, 0, 0, 0, 0, 0, 0, 0},  // neutral_line
    {0.1692, 0.135, 0.2348, 0.01398, 0.5213, 0, 0, 0, 0, 0, 0, 0, 0, 0},  // torsion
}};
// clang-format on

}  // namespace wrc
