/// The fitted constants of strip FASTSIM on the rail's surface: how contact of finite width deviates from
/// strip theory as it saturates. Strip by strip; x, e, s are means over neighbouring strips
/// (rolling_arrays.hpp), and u is that of the ellipse whose strips are held alike.
#pragma once

#include "tangential/methods/saturation_terms.hpp"

namespace wrc::surface {

struct SurfaceCalibration {
  enum {
    unison_u = tangential::SaturationTerms::saturation_terms,  ///< u times the last of those
    spin_squared,                                              ///< s^4 / Q^2
    lateral_spin,                                              ///< e^2 s^2 / Q^2
    longitudinal_spin,                                         ///< x^2 s^2 / Q^2
    terms
  };
  enum Quantity {
    flexibility_x,       ///< factor on the flexibility of slip along x that neighbours share
    flexibility_y,       ///< factor on that of lateral slip
    flexibility_spin_x,  ///< factor on that of the local part of slip along x
    flexibility_spin_y,  ///< factor on that of spin across
    turning,             ///< factor on the flexibility with which slip turns the traction
    torsion,  ///< lateral elastic slip, in units of that of a slipping strip's edge, for s^2 / Q = 1
    twist_y,  ///< lateral elastic slip by longitudinal tractions, at the border, for x^2 / Q = 1
    twist_x,  ///< longitudinal elastic slip by lateral tractions, at the border, for (e + s)^2 / Q = 1
    quantities
  };
  double constants[quantities][terms];
};

/// Rows as Quantity, columns as Term.
// clang-format off
inline constexpr SurfaceCalibration fitted_surface_calibration = {{
    {0, 0, 0.04181, 0, 0, 0.2787, 0, 0.08463, 0.08835, 0.2099, 0, 0, 0, 0, 0.457, 0, 0},  // flexibility_x
    {0, 0, 0.1444, 0.07514, 0.5804, 0.107, 0, 0, 0.06079, 0, -0.4139, 0.8626, 0, 0, -0.3561, 0, 0.7874},  // flexibility_y
    {0, 0, 0, 0, 0.2612, 0, -0.9641, 0, 0, 0, 0, 0, 0, 0.2035, 0.6165, -0.9641, 0},  // flexibility_spin_x
    {0, 0, -0.2666, 0, -0.1625, -0.2352, 0, -0.1022, 0.4242, 0.17, 0, 0, 0, 0, 0.1217, 0, 0.7518},  // flexibility_spin_y
    {-0.5023, 0.6697, 0, 0.01425, -1.018, -0.4176, 0, -1.284, 0, 0, 0, 0, -0.2748, 0, -0.5268, 0, 0},  // turning
    {0.2136, 0.2523, 0.2544, 0, 0.3084, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},  // torsion
    {0.2869, 0, 0, 0, -0.7446, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},  // twist_y
    {-0.1698, 0, 0.4585, 0.4113, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},  // twist_x
}};
// clang-format on

}  // namespace wrc::surface
