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
    elastic_slip,        ///< added: what the elastic slip differs by between x and y
    quantities
  };
  double constants[quantities][terms];
};

/// Rows as Quantity, columns as Term.
// clang-format off
inline constexpr StripCalibration fitted_calibration = {{
    {0, 0, 0.05174, 0, 0, 0.114, 0, 0.1218, 0, 0.5455, 0.4398, 0, 0, 0},  // flexibility_x
    {0, 0, 0.1138, 0.06507, 0.1409, -0.2237, 0.4827, 0.149, 0, 0, 0, 0, 0, 0.2084},  // flexibility_y
    {0, 0, 0.09169, 0, 0, 0.1415, 0, 0.1715, 0, 1.062, 0.4683, 0, 0.1025, 0},  // flexibility_spin_x
    {0, 0, -0.1168, 0.2531, -0.1313, 0, 0, 0, 0, 0.1024, 0, 0, 0, 0.1685},  // flexibility_spin_y
    {0.1353, 0.1329, -0.5429, 0, -1.154, 0.1633, -0.9914, 0, 0, 0.2471, 0, 0, -0.3123, 0.3341},  // turning
    {0, 0, -0.8948, -0.426, -1.02, 0, 0, 0, 0, 0, 0, 0, 0, 0},  // neutral_line
    {0, 0, 0.09297, -0.1438, 1.067, 0, 0, 0, 0, 0, 0, 0, 0, 0},  // elastic_slip
}};
// clang-format on

}  // namespace wrc
