/// Steady rolling with Coulomb friction between two half-spaces: Kalker's exact theory.
///
/// Slip of the wheel over the rail per unit rolled length, particles travelling towards -x:
///     s(x, y) = w(x, y) - du/dx,    w = (nu_x - phi y, nu_y + phi x),
/// u the displacement difference wheel minus rail from tractions p on the wheel
/// (tangential/exact/cell_influence.hpp). Where |p| < g, g = mu p_n, the cell sticks, s = 0; elsewhere p = -g
/// s / |s|. That is solved by Newton's method with a moving adhesion area
/// (tangential/exact/rolling_newton.hpp) with FFT convolutions as products, started from the solution on a
/// grid of half as many cells each way.
///
/// Between unlike bodies the pressure moves the surfaces along each other, too, which is part of w
/// (tangential/exact/cell_influence.hpp, Kalker's K), and the energy balance is that of all of w.
///
///     p    traction_x, traction_y on the wheel  [Pa]     s    slip_x, slip_y              [-]
///     p_n  pressure                             [Pa]     w    rigid_slip_x, rigid_slip_y  [-]
///     mu   friction                             [-]      g    bound = mu p_n              [Pa]
///     u    displacement difference              [m]      rho  1 / largest coefficient     [Pa]
///
/// A layer (tangential/layer/layer.hpp) is a spring, s = w - d(u + F p)/dx, and lowers the bound to g =
/// min(mu p_n, tau). Then s is the motion that slides or flows. tau follows from the flow along each row, and
/// is found with s by fixed-point steps.
///
/// On a curved surface (rows with angles, turned_convolution.hpp) x and y are each row's own tangents, and
/// the rigid slip is given cell by cell.
#pragma once

#include <memory>
#include <vector>

#include "halfspace/grid.hpp"
#include "halfspace/rolling_problem.hpp"
#include "halfspace/turned_convolution.hpp"

namespace wrc::halfspace {

/// Solves any number of problems on one grid; the spectra and coarser grids are prepared once. Not to be
/// shared by threads. Memory: four thirds of Convolution's plus at most 240 doubles and 4 nx floats (the
/// rows' factors) per cell.
class RollingSolver {
 public:
  /// `coupling`: Kalker's K.
  RollingSolver(const Grid& grid, const patch::Material& material, const Field& angles = {},
                double coupling = 0.0);

  const Grid& grid() const { return levels_.front().grid; }

  RollingSolution solve(const RollingProblem& problem);

 private:
  RollingSolution solve_uncoupled(const RollingProblem& problem);
  struct Level {
    Grid grid;
    TurnedConvolution convolution;
  };
  std::vector<Level> levels_;                   // finest first
  std::unique_ptr<TurnedConvolution> pressed_;  // slip under pressure; none of like bodies
};

}  // namespace wrc::halfspace
