/// What every tangential method is given: the patch as the normal method left it, its regularised shape, and
/// the creepages.
#pragma once

#include "linear_theory/sdec.hpp"
#include "tangential/march_grid.hpp"
#include "tangential/problem.hpp"

namespace wrc {

/// How the flexibilities of linear theory enter (flexibility_form.hpp).
enum class FlexibilityForm { separate, single, blended };

/// How a layer between the bodies lowers the slope of the creep curve further as slip grows, in modified
/// FASTSIM; see there.
struct SlopeFall {
  double limit = 0.0;  ///< alpha_inf: share of the slope that is left at large creepages [-]
  double rate = 0.0;   ///< beta; 0: the slope does not fall [-]
};

struct RollingContact {
  Strips region;               ///< strips the tractions live on; which ones, the method says
  double a = 0.0, b = 0.0;     ///< semi-axes of the equivalent ellipse or SDEC, a in rolling direction [m]
  double shape_number = 0.0;   ///< psi: the patch's mid-width lies at y = psi b [-]
  double shear_modulus = 0.0;  ///< G, times the slope reduction of a layer between the bodies [Pa]
  const SdecTable* linear_theory = nullptr;  ///< of the bodies' Poisson ratio
  const MarchGrid* grid = nullptr;           ///< cells along each strip
  Creepage creepage;                         ///< at the initial contact point
  StripFriction friction;                    ///< mu [-]
  TractionBound bound = TractionBound::parabolic;
  FlexibilityForm form = FlexibilityForm::separate;
  SlopeFall slope{};
  double slope_reduction = 1.0;  ///< the factor that is in shear_modulus already [-]
};

}  // namespace wrc
