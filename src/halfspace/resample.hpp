/// Fields carried from one grid to another over the same box: pressure down to a coarse grid, tractions up to
/// a fine one.
#pragma once

#include "halfspace/grid.hpp"

namespace wrc::halfspace {

/// The same box with half the cells each way (rounded up).
Grid coarsened(const Grid& fine);

/// Cell averages on `coarse` of a field that is constant per cell of `fine`: conserves its integral. Both
/// grids cover the same box.
Field average(const Grid& fine, const Field& field, const Grid& coarse);

/// One value per row, interpolated linearly at the rows of `coarse`; the end rows' values continue.
Field row_values(const Grid& fine, const Field& rows, const Grid& coarse);

/// Bilinear interpolation of `field`, given on `coarse`, at the cell centres of `fine`, using only coarse
/// cells where `weight` > 0; zero where there are none.
Field interpolate(const Grid& coarse, const Field& field, const Field& weight, const Grid& fine);

}  // namespace wrc::halfspace
