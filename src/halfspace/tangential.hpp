/// Rolling with Coulomb friction between two half-spaces, steady or step by step: Kalker's exact theory.
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

#include "base/fault.hpp"
#include "base/progress.hpp"
#include "halfspace/grid.hpp"
#include "halfspace/turned_convolution.hpp"
#include "tangential/exact/rolling_newton.hpp"
#include "tangential/problem.hpp"

namespace wrc::halfspace {

/// Where on a cell the discrete slip and traction are taken to be. The equation of one cell,
///     s_i = w - (u(x_i + dx) - u(x_i)) / dx,
/// contains the displacements one cell apart, with p constant per cell. The matrix is the same for both.
enum class Collocation {
  /// w at x_i + dx/4, p at x_i - dx/4. The difference quotient belongs to x_i + dx/2. A piecewise constant
  /// solution of this singular equation is nearest to the exact one a quarter of a cell behind its nominal
  /// place, and meets the equation best a quarter ahead. That is the quarter-chord, three-quarter-chord rule
  /// of the vortex lattice (our leading edge is the airfoil's trailing edge).
  quarter_point,
  /// w at x_i + dx/6, p at x_i: reproduces the reference program CONTACT 25.2 on its own grid to 1e-5 of mu
  /// N. The offset dx/6 was found by that comparison.
  reference_program
};

/// How far ahead of a cell's centre the rigid slip is taken, in cells.
constexpr double rigid_slip_ahead(Collocation collocation) {
  return collocation == Collocation::reference_program ? 1.0 / 6.0 : 0.25;
}

/// How far behind it the traction lies, in cells.
constexpr double traction_behind(Collocation collocation) {
  return collocation == Collocation::reference_program ? 0.0 : 0.25;
}

enum class Adhesion {
  coulomb,  ///< |p| <= mu p_n
  full      ///< s = 0 everywhere: linear theory
};

struct RollingSolution;

struct RollingProblem {
  Field pressure;                 ///< p_n of each cell [Pa]; cells with p_n > 0 are the contact area
  Field friction;                 ///< mu of each cell, or a single value for all; unused in full adhesion
  tangential::Creepage creepage;  ///< about the origin of the grid's coordinates
  /// Rigid slip w of each cell in place of the creepages', taken where `collocation` says; both or none.
  Field rigid_slip_x, rigid_slip_y;
  tangential::Layer layer{};  ///< between the bodies; of steady rolling alone
  Adhesion adhesion = Adhesion::coulomb;
  Collocation collocation = Collocation::quarter_point;
  /// |p - P(p - rho s)| <= tolerance |min(g, max(|p|, rho |w|))| (2-norms over the cells; g is
  /// infinite in full adhesion), rho = 1 / largest coefficient, about 1.3 G.
  double tolerance = 1e-4;
  int max_iterations = 60;  ///< Newton iterations on one grid
  /// Solution of a problem near this one to start from; without it the start is made on coarser grids.
  const RollingSolution* start = nullptr;
  ProgressCallback progress;
};

struct RollingSolution {
  Field traction_x, traction_y;  ///< on the wheel [Pa]
  Field slip_x, slip_y;          ///< sliding velocity / rolling speed [-]; zero outside the contact
  std::vector<tangential::CellState> state;
  tangential::TangentialForces forces;  ///< mz about the origin; power is the sum of -p . s over the cells
  /// -(Fx nu_x + Fy nu_y + Mz phi) [N], the dissipation by the energy balance of steady rolling: the limit of
  /// forces.power_per_speed for fine grids. It has the error of the forces alone. The sum over the cells also
  /// misses the difference quotient's dissipation in steep gradients: of first order, up to half where only a
  /// few cells at the trailing edge slip.
  double power_by_balance = 0.0;
  int iterations = 0;     ///< Newton iterations on the given grid
  int products = 0;       ///< convolutions on the given grid
  double residual = 0.0;  ///< value of the convergence test [-]
  Fault fault;            ///< WRC_FLAG_ITERATION_CAP: residual stayed above the tolerance
};

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

/// How far the bodies roll in a step of TransientSolver: a cell along x, a cell against it, or not at all.
enum class Rolled { forwards = 1, backwards = -1, at_rest = 0 };

/// Non-steady rolling in the contact frame, from bodies without tractions. In a step the bodies advance by
/// r = 1, 0 or -1 cells: particles at x were at x + r dx before, with the displacements of then:
///     s(x) = w + (u(x) - u_before(x + r dx)) / dx
/// (Kalker 1990, 1.3; CONTACT's T = 2 with dq = dx, and with r = 0 its T = 1). w dx is the rigid displacement
/// of the wheel over the rail in the step, whichever way it rolls. Everything else is as in steady rolling,
/// in which a long time under equal conditions ends, to the tolerance. Not to be shared by threads.
class TransientSolver {
 public:
  /// `coupling`: Kalker's K.
  TransientSolver(const Grid& grid, const patch::Material& material, double coupling = 0.0);

  const Grid& grid() const { return grid_; }

  /// One step: pressure and friction as they are at its end, creepages those of its middle. A failed or
  /// cancelled step leaves the state where it was. `start` is not used, the tractions before are the start.
  /// power_by_balance is the work of the creepages: dissipation plus the gain of elastic energy. Powers are
  /// per dx, so that times dx they are the step's work.
  RollingSolution step(const RollingProblem& problem, Rolled rolled = Rolled::forwards);

 private:
  Grid grid_;
  TurnedConvolution displacement_, steady_;
  std::unique_ptr<TurnedConvolution> pressed_, pressed_steady_;  // under pressure; none of like bodies
  Field traction_x_, traction_y_, pressure_;                     // at the end of the last step
};

}  // namespace wrc::halfspace
