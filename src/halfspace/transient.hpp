/// Rolling that is not steady, step by step, between two half-spaces: Kalker's exact theory.
#pragma once

#include <memory>

#include "halfspace/grid.hpp"
#include "halfspace/rolling_problem.hpp"
#include "halfspace/turned_convolution.hpp"

namespace wrc::halfspace {

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
