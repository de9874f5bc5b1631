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
    {0, 0, 0.05384, 0, 0, 0, 0, 0.07559, 0.164, 0.544, 0.4863, 0, 0, 0.1633},  // flexibility_x
    {0, 0, 0.114, 0.07957, 0.2582, -0.3659, 0, 0, 0.07653, 0, 0, 0, 0, 0.298},  // flexibility_y
    {0, 0, 0.1119, 0, -0.05369, 0, 0, 0.1253, 0.2763, 0.7965, 0.5255, 0, 0.06699, 0.2297},  // flexibility_spin_x
    {0, 0, -0.07149, 0.3757, -0.1517, 0, 0, -0.1098, 0, 0.2229, 0, 0, 0, 0.1047},  // flexibility_spin_y
    {-0.04782, 0.135, -0.4372, 0, -2.479, -0.6498, 0.5638, 0, 0, 0.7172, 0, 0, -0.384, 0.2214},  // turning
    {0, 0, -0.8433, -0.4512, -0.6735, 0, 0, 0, 0, 0, 0, 0, 0, 0},  // neutral_line
    {0.1265, 0.1314, 0.2926, 0, 0.5963, 0, 0, 0, 0, 0, 0, 0, 0, 0},  // torsion
}};
// clang-format on

}  // namespace wrc
