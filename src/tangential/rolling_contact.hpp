/// Input of every tangential method: the patch as the normal method left it, its regularised shape, and the
/// creepages.
#pragma once

#include "tangential/march/march_grid.hpp"
#include "tangential/patch_model.hpp"
#include "tangential/problem.hpp"
#include "theory/sdec.hpp"

namespace wrc::tangential {

struct ForceTable;

/// How the flexibilities of linear theory enter (flexibility_form.hpp).
enum class FlexibilityForm { separate, single, blended };

/// How a layer between the bodies lowers the slope of the creep curve further as slip grows (fastsim.hpp).
struct SlopeFall {
  double limit = 0.0;  ///< alpha_inf: share of the slope that is left at large creepages [-]
  double rate = 0.0;   ///< beta; 0: the slope does not fall [-]

  bool falls() const { return rate > 0.0; }
};

/// Factors on the gradient of traction in Polach's force law (methods/polach.hpp).
struct ReductionFactors {
  double adhesion = 1.0;  ///< k_A [-]
  double slip = 1.0;      ///< k_S <= k_A [-]
};

/// The memory of a contact whose rolling is not steady (methods/strip_memory.hpp).
struct RollingMemory {
  void* at = nullptr;      ///< nullptr: rolling is steady
  double rolled = 0.0;     ///< length over which the creepages act since the step before [m]
  bool at_rest = false;    ///< creepages times it are a shift; else it is rolled
  double direction = 1.0;  ///< -1: the contact is the mirror image of one that rolls backwards
  double origin = 0.0,
         slope = 1.0;  ///< the region's y is remembered as origin + slope y: over the rail, if known
  double below = -1e3, above = 1e3;  ///< borders of the next patches in that y; without a patch far away [m]

  double y(double of_region) const { return origin + slope * of_region; }
};

struct RollingContact {
  patch::Strips region;        ///< strips the tractions live on, about the origin of the creepages
  double a = 0.0, b = 0.0;     ///< semi-axes of the equivalent ellipse or SDEC, a in rolling direction [m]
  double shape_number = 0.0;   ///< psi: the patch's mid-width lies at y = psi b [-]
  double shear_modulus = 0.0;  ///< G, times the slope reduction of a layer between the bodies [Pa]
  const theory::SdecTable* linear_theory = nullptr;  ///< coefficients of the bodies' Poisson ratio
  const MarchGrid* grid = nullptr;                   ///< cells along each strip
  Creepage
      creepage;  ///< at the initial contact point, or at the ellipse's centre where `model` has it elsewhere
  StripFriction friction;  ///< mu [-]
  TractionBound bound = TractionBound::parabolic;
  FlexibilityForm form = FlexibilityForm::separate;
  SlopeFall slope{};
  double slope_reduction = 1.0;             ///< the factor that is in shear_modulus already [-]
  Layer layer{};                            ///< between the bodies
  ReductionFactors reduction{};             ///< those in Polach's force law
  PatchModel model{};                       ///< whose strips `region` has, and whose the coefficients are
  double normal_force = 0.0;                ///< the patch's, for methods that do not read its strips [N]
  const ForceTable* force_table = nullptr;  ///< the model's, if it has one
  RollingMemory memory{};
  void* workspace = nullptr;  ///< as many bytes as the method asks for

  /// psi of the linear theory the method follows.
  double elastic_shape_number() const { return model.of_sdec ? shape_number : 0.0; }
};

}  // namespace wrc::tangential
