/// Rolling on a grid of cells: the problem, its solution, and the parts that steady rolling (tangential.hpp)
/// and steps of rolling that is not steady (transient.hpp) share.
#pragma once

#include <vector>

#include "base/fault.hpp"
#include "base/progress.hpp"
#include "halfspace/grid.hpp"
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

/// How far the bodies roll in a step of TransientSolver: a cell along x, a cell against it, or not at all.
enum class Rolled { forwards = 1, backwards = -1, at_rest = 0 };

/// Fills the rigid slips of all cells, where the collocation wants them, unless they are given. At rest no
/// cell is ahead of another.
void find_rigid_slip(const Grid& grid, RollingProblem& problem, Rolled rolled = Rolled::forwards);

/// Traction bound of a cell in contact [Pa].
double traction_bound(const RollingProblem& problem, std::size_t at);

/// The pressure of the cells in contact.
Field compressive(const Field& pressure);

Fault check_rolling(const Grid& grid, const RollingProblem& problem);
Fault rolling_capped(double residual, double tolerance);

/// Fields of zeros, all cells outside the contact.
void clear_solution(const Grid& grid, RollingSolution& s);

/// Forces, moment, power and adhesion area from the fields.
void sum_forces(const Grid& grid, const RollingProblem& problem, RollingSolution& s,
                Rolled rolled = Rolled::forwards);

}  // namespace wrc::halfspace
