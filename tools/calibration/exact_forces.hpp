/// Forces of the exact half-space theory on a patch, free of the grid as far as two grids tell.
#pragma once

#include "random_patch.hpp"

namespace wrc::calibration {

struct ExactForces {
  double fx, fy, mz;   ///< on the wheel [N], [N m], extrapolated to a grid of no cell size
  double power;        ///< by the energy balance of these forces, at a speed of 1 m/s [W]
  double adhesion;     ///< area that sticks over the area, fine grid
  double force_shift;  ///< |F - F on the fine grid| / (mu N): how far the extrapolation went
  double power_shift;  ///< the same of the power, relative
  bool converged;      ///< on both grids
};

inline constexpr int coarse_cells = 32, fine_cells = 64;  ///< each way

/// Solves on both grids and extrapolates the forces, whose error is of first order in the cell size.
ExactForces exact_forces(const Patch& patch);

}  // namespace wrc::calibration
