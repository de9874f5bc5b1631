/// The fitted constants of strip FASTSIM: how a patch of finite width deviates from strip theory as it
/// saturates.
///
/// Each quantity is a sum of constants times terms. x, e, s are the longitudinal force (with the part spin has
/// in it), the lateral force of lateral creepage and that of spin in linear theory, over the friction limit mu
/// N; with Q = 1 + x^2 + e^2 + s^2 every term lies between -1 and 1, vanishes with the creepages (but for the
/// first two) and tends to a constant for large ones. u = (a - b) / (a + b) is the slenderness. All terms stay
/// the same when the patch is mirrored and when all creepages change sign.
///
/// tests/calibration makes the constants; its README has the commands. Zeros are terms the fit did not need.
#pragma once

namespace wrc {

struct StripCalibration {
  enum Term {
    constant,
    slender,          ///< u
    longitudinal,     ///< x^2 / Q
    lateral,          ///< e^2 / Q
    spin,             ///< s^2 / Q
    pull,             ///< e s / Q: lateral creepage pulls with spin (> 0) or against it
    pull_squared,     ///< its square
    longitudinal_u,   ///< u x^2 / Q
    lateral_u,        ///< u e^2 / Q
    spin_u,           ///< u s^2 / Q
    pull_u,           ///< u e s / Q
    pull_squared_u,   ///< u times the square
    unison,           ///< 1 where s^2 = 1, where strip theory lets all strips slip at once; falls off to both sides
    lopsided,         ///< psi x s / Q: the wider half pulls with the longitudinal force or against it
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

/// clang-format off: a table
inline constexpr StripCalibration fitted_calibration = {{
    {0, 0, 0.05026, 0.02485, 0, 0.09688, -0.7822, 0.0873, 0.1473, 0.4581, 0.3696, 0, 0.07049, 0.1843},  // flexibility_x
    {0, 0, 0.1207, 0.06482, 0.1491, -0.148, 0.5701, 0.1153, 0.05469, 0.1826, -0.158, 0, 0, 0.276},  // flexibility_y
    {0, 0, 0.1144, 0, 0.05793, 0.2044, -0.6319, 0.1525, 0.2216, 0.9856, 0.5678, 0, 0.1517, 0.2083},  // flexibility_spin_x
    {0, 0, -0.1117, 0.2111, -0.1595, 0, 0, -0.0419, 0.1439, 0.09807, -0.1483, 0, 0.02984, 0.2132},  // flexibility_spin_y
    {0.1465, 0.1748, -0.5473, 0, -1.195, 0.2016, -1.082, 0, 0, 0.3517, 0, -0.7218, -0.3226, 0.3273},  // turning
    {0, 0, -0.79, -0.5911, -1.163, -0.4834, 0, 0, 0, 0, 0, 0, 0, 0},  // neutral_line
    {0, 0, 0.08276, -0.1421, 1.156, 0, 0, -0.07575, 0, -0.2709, 0, 0, 0, 0},  // elastic_slip
}};

}  // namespace wrc
