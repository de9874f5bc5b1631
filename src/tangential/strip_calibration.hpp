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
    {0, 0, 0.05223, 0, 0, 0, 0, 0.07838, 0.1654, 0.5296, 0.496, 0, 0, 0.1658},  // flexibility_x
    {0, 0, 0.1142, 0.07908, 0.2538, -0.3683, 0, 0, 0.07636, 0, 0, 0, 0, 0.3021},  // flexibility_y
    {0, 0, 0.1081, 0, -0.05609, 0, 0, 0.1248, 0.2686, 0.7975, 0.523, 0, 0.06769, 0.2292},  // flexibility_spin_x
    {0, 0, -0.07258, 0.3765, -0.1508, 0, 0, -0.1157, 0, 0.2232, 0, 0, 0, 0.1093},  // flexibility_spin_y
    {-0.04898, 0.1348, -0.4374, 0, -2.467, -0.6542, 0.614, 0, 0, 0.7498, 0, 0, -0.3836, 0.2103},  // turning
    {0, 0, -0.8088, -0.4408, -0.6974, 0, 0, 0, 0, 0, 0, 0, 0, 0},  // neutral_line
    {0.1264, 0.1273, 0.2917, 0, 0.5958, 0, 0, 0, 0, 0, 0, 0, 0, 0},  // torsion
}};
// clang-format on

}  // namespace wrc
