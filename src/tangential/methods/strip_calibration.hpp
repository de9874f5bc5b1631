/// The fitted constants of strip FASTSIM: how a patch of finite width deviates from strip theory as it
/// saturates. x is here with the part spin has in the longitudinal force, the slips are the creepages.
#pragma once

#include "tangential/methods/saturation_terms.hpp"

namespace wrc::tangential {

struct StripCalibration {
  enum {
    lopsided = SaturationTerms::saturation_terms,  ///< psi x s / Q: the wider half pulls with the
                                                   ///< longitudinal force or against it
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
    {0, 0, 0.05026, 0, 0, 0, 0, 0.07141, 0.1608, 0.5529, 0.4705, 0, 0, 0.1908},  // flexibility_x
    {0, 0, 0.1111, 0.07679, 0.2445, -0.3792, 0, 0, 0.0843, 0, 0, 0, 0, 0.2997},  // flexibility_y
    {0, 0, 0.09946, 0, -0.07262, 0, 0, 0.1074, 0.2721, 0.8001, 0.5045, 0, 0.07162, 0.2425},  // flexibility_spin_x
    {0, 0, -0.06792, 0.3795, -0.1503, 0, 0, -0.1226, 0, 0.2288, 0, 0, 0, 0.1075},  // flexibility_spin_y
    {-0.04929, 0.1312, -0.4308, 0, -2.461, -0.6685, 0.6253, 0, 0, 0.7879, 0, 0, -0.3774, 0.2196},  // turning
    {0, 0, -0.8068, -0.4469, -0.7214, 0, 0, 0, 0, 0, 0, 0, 0, 0},  // neutral_line
    {0.1266, 0.1251, 0.2941, 0, 0.5954, 0, 0, 0, 0, 0, 0, 0, 0, 0},  // torsion
}};
// clang-format on

}  // namespace wrc::tangential
