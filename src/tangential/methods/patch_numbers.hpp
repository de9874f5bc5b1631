/// A patch with memory as its outline and pressures make it, whatever it has been through: how stiff its
/// cells are, by how much the half-spaces yield as a whole, and the factors of the law (patch_memory.hpp).
#pragma once

#include "tangential/rolling_contact.hpp"

namespace wrc::tangential {

inline constexpr double least_divisor = 1e-290;  ///< keeps divisions finite

/// Factors of the law, fitted by tools/calibration.
struct MemoryFactors {
  double flexibility_x, flexibility_y;  ///< L over that of linear rolling, less 1
  double arm, arm_slender;              ///< factor on arms less 1; slender: times ((a - b) / (a + b))^2
  double torsion;                       ///< yield of rotation at rest over that of linear theory, less 1
  double share;                         ///< added to the share of S that forms the bounds
  double turns;    ///< by which tractions turn faster as cells slide, where the whole patch sticks
  double follows;  ///< length over which the difference to strip FASTSIM is added, of a
  double ahead;    ///< factor by which the displacement of cells over that of the patch is taken ahead
};
inline constexpr MemoryFactors fitted_memory{0.0105,  -0.1060, 0.2541, -0.1200, -0.0125,
                                             -0.0047, 0.1822,  0.9152, 2.3330};

/// Numbers of a patch that follow from its outline and pressures.
struct PatchNumbers {
  double length = 0.0;                    ///< that of the longest strip [m]
  double limit = 0.0;                     ///< friction limit, sum of mu_j N_j [N]
  double largest_load = 0.0;              ///< peak times half length [N/m]
  double a = 0.0, b = 0.0;                ///< semi-axes of the double ellipse that stands for it [m]
  double centre_x = 0.0, centre_y = 0.0;  ///< centre of the load [m]
  double growth_x = 0.0, growth_y = 0.0;  ///< 1 / L [Pa/m]
  double yield[3] = {};                   ///< S [m/N], [m/N], [rad/(N m)]
  double share = 0.0;                     ///< that of S in the whole yield, as it forms the bounds
  double arm = 1.0;                       ///< factor on the arms of spin
};
PatchNumbers patch_numbers(const RollingContact& contact, Fault& fault,
                           const MemoryFactors& factors = fitted_memory);

}  // namespace wrc::tangential
