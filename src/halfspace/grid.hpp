/// The rectangular grid of the half-space solvers, and how fields lie on it.
#pragma once

#include <cstddef>
#include <vector>

namespace wrc::halfspace {

/// nx x ny equal cells. Fields are one double per cell, x fastest: element (i, j) is at j * nx + i. Contact
/// frame: x rolling direction, so that particles enter a row at large i.
struct Grid {
  int nx = 0, ny = 0;
  double dx = 0.0, dy = 0.0;  ///< size of a cell [m]
  double x0 = 0.0, y0 = 0.0;  ///< centre of cell (0, 0) [m]

  std::size_t cells() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(i);
  }
  double x(int i) const { return x0 + i * dx; }
  double y(int j) const { return y0 + j * dy; }
  double cell_area() const { return dx * dy; }
};

using Field = std::vector<double>;

/// nx x ny cells that exactly fill the box [x_min, x_max] x [y_min, y_max].
inline Grid grid_over_box(double x_min, double x_max, double y_min, double y_max, int nx, int ny) {
  const double dx = (x_max - x_min) / nx;
  const double dy = (y_max - y_min) / ny;
  return {.nx = nx, .ny = ny, .dx = dx, .dy = dy, .x0 = x_min + 0.5 * dx, .y0 = y_min + 0.5 * dy};
}

}  // namespace wrc::halfspace
