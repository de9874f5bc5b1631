/// Frictionless normal contact of two half-spaces: pressure and contact area for a given gap and load or
/// approach.
///
/// On every cell either p > 0 and the bodies touch, e = h + u_z(p) - delta = 0, or p = 0 and e >= 0: the
/// minimum of p A p / 2 + p (h - delta) over p >= 0, found by conjugate gradients that add and drop cells as
/// they go (Polonsky & Keer, Wear 231, 1999) with FFT convolutions as products.
///
///     h      GapProblem::gap        [m]     p      GapSolution::pressure  [Pa]
///     delta  approach               [m]     u_z    displacement           [m]
///     e      error = h + u_z - delta  [m]   A      influence: u_z = A p   [m/Pa]
#pragma once

#include "base/fault.hpp"
#include "base/progress.hpp"
#include "halfspace/grid.hpp"
#include "halfspace/turned_convolution.hpp"
#include "normal/problem.hpp"

namespace wrc::halfspace {

struct GapProblem {
  Field gap;  ///< h at the cell centres [m]; its zero is where approaches count from
  normal::Prescribed prescribed = normal::Prescribed::load;
  double normal_force = 0.0;  ///< [N], prescribed == load
  double approach = 0.0;      ///< delta [m], prescribed == approach
  /// Stops when sum p |e| <= tolerance * scale * sum p over the contact and no overlap -e elsewhere exceeds
  /// tolerance * scale, scale being the largest elastic displacement.
  double tolerance = 1e-6;
  int max_iterations = 1000;
  ProgressCallback progress;
};

struct GapSolution {
  Field pressure;         ///< [Pa]
  double approach = 0.0;  ///< [m]
  double normal_force = 0.0;
  double peak_pressure = 0.0;
  double area = 0.0;      ///< cells with pressure [m^2]
  int iterations = 0;     ///< two convolutions each
  double residual = 0.0;  ///< value of the convergence test [-]
  Fault fault;            ///< WRC_FLAG_ITERATION_CAP, WRC_FLAG_PATCH_AT_EDGE, WRC_FLAG_NO_CONTACT
};

/// Solves any number of problems on one grid, plane or, with the angles of its rows, on a curved surface
/// (turned_convolution.hpp; gaps are then along each row's own normal). Memory: that of Convolution plus 5
/// doubles per cell.
class NormalSolver {
 public:
  NormalSolver(const Grid& grid, const patch::Material& material, const Field& angles = {});
  GapSolution solve(const GapProblem& problem);

 private:
  Grid grid_;
  TurnedConvolution convolution_;
};

}  // namespace wrc::halfspace
