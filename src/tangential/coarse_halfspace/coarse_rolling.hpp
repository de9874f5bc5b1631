/// Kalker's exact theory of steady rolling (exact/rolling_newton.hpp) on a grid of n x n cells, in fixed
/// memory and capped work. The slip is taken a quarter of a cell ahead of a cell's middle, its traction a
/// quarter behind.
///
/// Real-time: no memory but the object itself (about 260 KB for n = 16).
#pragma once

#include "tangential/coarse_halfspace/coarse_grid.hpp"
#include "tangential/exact/rolling_newton.hpp"
#include "tangential/problem.hpp"

namespace wrc {

/// A problem of RollingNewton.
template <int n>
class CoarseRolling {
 public:
  static constexpr int cell_count = n * n, nx = n, ny = n;

  CoarseGrid<n> grid;
  double bound[cell_count];              ///< mu p_n, mean over the cell; cells with 0 are not in contact [Pa]
  double border_compliance[cell_count];  ///< added to a cell's own coefficient [1/Pa]
  double px[cell_count], py[cell_count];  ///< tractions on the wheel; start and result [Pa]
  double sx[cell_count], sy[cell_count];  ///< slip [-]
  CellState state[cell_count];

  /// Iterates from the tractions present; false when max_iterations did not reach the tolerance.
  bool solve(const Creepage& creepage, double tolerance, int max_iterations);

  /// Forces about the origin of the creepages; power by the balance of energy.
  TangentialForces forces(const Creepage& creepage) const;

 private:
  friend class RollingNewton<CoarseRolling>;
  static constexpr int max_products = 30;

  void slip();
  double xx(int m) const { return grid.xx[n - 1][m + n - 1]; }
  double yy(int m) const { return grid.yy[n - 1][m + n - 1]; }
  double own(int at) const { return border_compliance[at]; }

  double rigid_x[cell_count], rigid_y[cell_count], x[cell_count], y[cell_count];
  NewtonCell cells[cell_count];
  NewtonRow rows[n];
  double vectors[newton_vectors(cell_count, max_products)];
  float factors[n * newton_factors(n)];
};

template <int n>
void CoarseRolling<n>::slip() {
  double of_x[cell_count], of_y[cell_count];
  std::copy_n(x, cell_count, of_x);
  std::copy_n(y, cell_count, of_y);
  grid.slip(of_x, of_y, x, y);
  for (int at = 0; at < cell_count; ++at) {
    x[at] += border_compliance[at] * of_x[at];
    y[at] += border_compliance[at] * of_y[at];
  }
}

template <int n>
bool CoarseRolling<n>::solve(const Creepage& creepage, double tolerance, int max_iterations) {
  for (int at = 0; at < cell_count; ++at) {
    rigid_x[at] = creepage.longitudinal - creepage.spin * grid.y(at / n);
    rigid_y[at] = creepage.lateral + creepage.spin * (grid.x(at % n) + 0.25 * grid.dx);
  }
  constexpr double accuracy = 1e-2;  // loosely: the next step moves the adhesion area anyway
  RollingNewton newton(*this, {tolerance, accuracy, max_iterations, max_products});
  return newton.solve([](double) { return true; }) == NewtonEnd::solved;
}

template <int n>
TangentialForces CoarseRolling<n>::forces(const Creepage& creepage) const {
  TangentialForces f;
  int contact = 0, adhesion = 0;
  for (int at = 0; at < cell_count; ++at) {
    f.fx += px[at];
    f.fy += py[at];
    f.mz += (grid.x(at % n) - 0.25 * grid.dx) * py[at] - grid.y(at / n) * px[at];
    if (state[at] != CellState::exterior) ++contact;
    if (state[at] == CellState::adhesion) ++adhesion;
  }
  const double area = grid.dx * grid.dy;
  f.fx *= area;
  f.fy *= area;
  f.mz *= area;
  f.power_per_speed = -(f.fx * creepage.longitudinal + f.fy * creepage.lateral + f.mz * creepage.spin);
  f.adhesion_fraction = contact > 0 ? static_cast<double>(adhesion) / contact : 0.0;
  return f;
}

}  // namespace wrc
