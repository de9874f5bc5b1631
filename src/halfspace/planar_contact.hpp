/// A contact of the planar stages as the exact solver sees it: its true gap, and rolling under its own
/// pressure.
#pragma once

#include "base/progress.hpp"
#include "contact/state.hpp"
#include "halfspace/grid.hpp"

namespace wrc::halfspace {

/// Gap at the centres of the grid's cells, its minimum at zero [m]: of a pose the true surfaces', of the
/// caller that of the rows' parabolas; beyond the rows the end row's slope continues.
void sample_gap(const contact::Contact& contact, const Grid& grid, double* gap);

/// Exact forces under a contact's own pressure, and the errors of its method.
struct PlanarCheck {
  double fx = 0.0, fy = 0.0;       ///< on the wheel [N]
  double mz = 0.0;                 ///< [N m]
  double power = 0.0;              ///< by the energy balance [W]
  double adhesion_fraction = 0.0;  ///< [-]
  double force_error = 0.0;        ///< |F - F_exact| / (mu N) [-]
  double power_error = 0.0;        ///< P / P_exact - 1 [-]; 0 where nothing is dissipated
};

/// Solves the rolling problem of a contact, whose tractions are there, on nx x ny cells over all its strips.
Fault check_planar_contact(contact::Contact& contact, int nx, int ny, const ProgressCallback& progress,
                           PlanarCheck& result);

}  // namespace wrc::halfspace
