/// What every tangential method is given: the patch as the normal method left it, its regularised shape, and
/// the creepages.
#pragma once

#include "linear_theory/sdec.hpp"
#include "tangential/march_grid.hpp"
#include "tangential/problem.hpp"

namespace wrc {

struct RollingContact {
  Strips region;               ///< strips the tractions live on; which ones, the method says
  double a = 0.0, b = 0.0;     ///< semi-axes of the equivalent ellipse or SDEC, a in rolling direction [m]
  double shape_number = 0.0;   ///< psi: the patch's mid-width lies at y = psi b [-]
  double shear_modulus = 0.0;  ///< G [Pa]
  const SdecTable* linear_theory = nullptr;  ///< of the bodies' Poisson ratio
  const MarchGrid* grid = nullptr;           ///< cells along each strip
  Creepage creepage;                         ///< at the initial contact point
  double friction = 0.0;                     ///< mu [-]
  TractionBound bound = TractionBound::parabolic;
  double poisson = 0.0;  ///< nu, where the half-space itself is solved [-]
};

}  // namespace wrc
