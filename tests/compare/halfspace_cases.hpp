/// Double ellipses on the exact solver's grids.
#pragma once

#include <vector>

#include "wrc/wrc_offline.h"

namespace compare {

/// nx x ny cells that just hold a double ellipse.
wrc_grid grid_over(const wrc_ellipse& ellipse, uint32_t nx, uint32_t ny);

/// Semi-elliptic pressure of a double ellipse at the cell centres, as the reference has it.
std::vector<double> pressure_at_centres(const wrc_ellipse& ellipse, const wrc_grid& grid);

/// Of either body.
wrc_material material_of(double shear_modulus, double poisson);

}  // namespace compare
