/// Prescribed normal pressure on a grid, that of strips, so that tangential methods can be judged alone.
#pragma once

#include "halfspace/grid.hpp"
#include "patch/strips.hpp"

namespace wrc::halfspace {

/// Adds to row j of the field the x-means of peak sqrt(1 - ((x - centre) / l)^2), times weight.
void add_semi_ellipse(const Grid& grid, int j, double peak, double centre, double l, double weight,
                      Field& field);

/// Cell means of the pressure of a strip patch: strips keep their width and place, so the load is that of the
/// strips inside the grid.
Field strip_pressure(const patch::Strips& strips, const Grid& grid);

/// nx x ny cells over the bounding box of the strips.
Grid grid_over(const patch::Strips& strips, int nx, int ny);

}  // namespace wrc::halfspace
