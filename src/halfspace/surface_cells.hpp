/// Cells over which a wheel and one face of a rail may touch: a rectangle cut out of a lattice that is fixed
/// on the rail, cell_x by cell_s, with the gap of every cell along its row's own normal.
#pragma once

#include <vector>

#include "halfspace/grid.hpp"
#include "halfspace/rolling_surfaces.hpp"

namespace wrc::halfspace {

constexpr double gap_apart = 1e-2;  ///< gap of cells that face no wheel [m]

/// The nearest integer, halves upwards.
int nearest_integer(double x);

struct SurfaceOptions;

struct SurfaceCells {
  Grid grid;
  std::vector<SurfaceRow> rows;
  std::vector<SurfacePoint> points;  ///< over the grid
  double deepest = 0.0;              ///< overlap [m]; negative: distance
  bool too_many = false;             ///< more than options.max_cells; points are not laid
};

/// Lays rows in the middles of the lattice's strips, and cells wherever the gap is below a twentieth of the
/// deepest overlap: cells that do not overlap may touch, as tractions lift the surfaces.
SurfaceCells lay_cells(const RollingSurfaces& surfaces, double rail_length, const SurfaceOptions& options);

}  // namespace wrc::halfspace
