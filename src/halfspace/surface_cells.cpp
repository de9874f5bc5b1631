#include "halfspace/surface_cells.hpp"

#include <algorithm>
#include <cmath>

#include "halfspace/surface_contact.hpp"

namespace wrc::halfspace {
namespace {

constexpr int border = 2;  // cells laid beyond those that may touch

// A row of the lattice and its cell where the wheel is nearest.
struct NearestCell {
  SurfaceRow row;
  SurfacePoint middle;
  bool found = false;
};

// The lattice's rows; `deepest` becomes the largest overlap of any [m].
std::vector<NearestCell> nearest_cells(const RollingSurfaces& surfaces, int lattice,
                                       const SurfaceOptions& options, double& deepest) {
  std::vector<NearestCell> nearest(static_cast<std::size_t>(lattice));
  deepest = -gap_apart;
  for (int j = 0; j < lattice; ++j) {
    NearestCell& c = nearest[static_cast<std::size_t>(j)];
    // the row's middle is where its gap is smallest; that one cell stands for it here
    c.row = surfaces.row((j + 0.5) * options.cell_s, options.normals, c.found);
    if (!c.found) continue;
    c.middle = surfaces.point(c.row, c.row.middle);
    c.found = c.middle.found;
    if (c.found) deepest = std::max(deepest, -c.middle.gap);
  }
  return nearest;
}

// Rows first..last, and low..high along x [m], within which gaps are below `margin` [m].
struct Extent {
  int first = 0, last = -1;
  double low = 1.0, high = -1.0;
  bool too_many = false;
};

Extent extent_below(double margin, const RollingSurfaces& surfaces, const std::vector<NearestCell>& nearest,
                    const SurfaceOptions& options) {
  constexpr double farthest = 0.1;  // from a row's middle along x [m]
  const auto below = [&](const NearestCell& c) { return c.found && !(c.middle.gap > margin); };
  // rows: from the first whose nearest cell is near enough to the last
  const int lattice = static_cast<int>(nearest.size());
  Extent extent{.first = lattice};
  for (int j = 0; j < lattice; ++j) {
    if (!below(nearest[static_cast<std::size_t>(j)])) continue;
    extent.first = std::min(extent.first, j);
    extent.last = j;
  }
  // along x: of each such row from its middle outwards, cell by cell, until the gap has opened, for good if
  // the rail does not change; each search on the wheel's profile starts where the one before ended
  for (int j = extent.first; j <= extent.last && !extent.too_many; ++j) {
    const NearestCell& c = nearest[static_cast<std::size_t>(j)];
    if (!below(c)) continue;
    for (const double direction : {-1.0, 1.0}) {
      SurfacePoint p = c.middle;
      double x = c.row.middle;
      double end = x;
      while (p.found && surfaces.there(x) && (p.gap < margin || surfaces.varies()) &&
             std::abs(x - c.row.middle) < farthest) {
        x += direction * options.cell_x;
        if (p.gap < margin) end = x;
        p = surfaces.point(c.row, x, p.wheel_s);
      }
      extent.low = std::min(extent.low, end);
      extent.high = std::max(extent.high, end);
    }
    extent.too_many = (extent.high - extent.low) / options.cell_x * (extent.last - extent.first + 1) >
                      static_cast<double>(options.max_cells);
  }
  return extent;
}

// The lattice's cells over the extent with a border; x = 0 is a cell's centre whatever the extent.
Grid grid_over(const Extent& extent, int lattice, const SurfaceOptions& options) {
  // rows stay on the rail; columns are counted from x = 0
  const int first = std::max(extent.first - border, 0);
  const int last = std::min(extent.last + border, lattice - 1);
  const int left = static_cast<int>(std::floor(extent.low / options.cell_x)) - border;
  const int right = static_cast<int>(-std::floor(-extent.high / options.cell_x)) + border;
  return {.nx = right - left + 1,
          .ny = last - first + 1,
          .dx = options.cell_x,
          .dy = options.cell_s,
          .x0 = left * options.cell_x,
          .y0 = (first + 0.5) * options.cell_s};
}

}  // namespace

int nearest_integer(double x) { return static_cast<int>(std::floor(x + 0.5)); }

SurfaceCells lay_cells(const RollingSurfaces& surfaces, double rail_length, const SurfaceOptions& options) {
  SurfaceCells cells;
  const int lattice = static_cast<int>(rail_length / options.cell_s);
  const std::vector<NearestCell> nearest = nearest_cells(surfaces, lattice, options, cells.deepest);
  if (cells.deepest <= 0.0) return cells;
  const Extent extent = extent_below(0.05 * cells.deepest, surfaces, nearest, options);
  cells.too_many = extent.too_many;
  const Grid& g = cells.grid = grid_over(extent, lattice, options);
  if (cells.too_many) return cells;
  // Gaps of each row from its middle outwards, as neighbours start each other's search. The first cell of
  // both directions is the same one.
  const int first = std::max(extent.first - border, 0);
  cells.points.resize(g.cells());
  for (int j = 0; j < g.ny; ++j) {
    const int row = first + j;
    const NearestCell& c = nearest[static_cast<std::size_t>(row)];
    cells.rows.push_back(c.row);
    if (!c.found) continue;
    // the cell of the row's middle, or the one beside it that lies on the face
    int middle = nearest_integer((c.row.middle - g.x0) / g.dx);
    if (!surfaces.there(g.x(middle))) middle += g.x(middle) < c.row.middle ? 1 : -1;
    middle = std::clamp(middle, 0, g.nx - 1);
    for (const int direction : {1, -1}) {
      SurfacePoint p = c.middle;
      for (int i = middle; i >= 0 && i < g.nx && p.found && surfaces.there(g.x(i)); i += direction) {
        p = surfaces.point(c.row, g.x(i), p.wheel_s);
        cells.points[g.index(i, j)] = p;
      }
    }
  }
  return cells;
}

}  // namespace wrc::halfspace
