/// Rolling of whole patches on the rail's surface: methods that know one shape and one creepage.
///
/// A patch is a run of strips in contact, parted from its neighbours by the strips' loads over their widths
/// as smoothly as normal methods part theirs (lobes.hpp). It rolls unrolled, y by arc length, with the means
/// over its load of the strips' rigid slips for its creepages. Its shape is that of the double ellipse whose
/// load has the same moments,
///
///     a^2 = 5/4 <l^2>,   <(y - <y>)^2> = b^2 (1/5 + 3/80 psi^2),   <(y - <y>)^3> = b^3 psi (1/20 - psi^2/160),
///
/// with its joint at <y> - 3/4 psi b: sums over the load are continuous, and so is the shape while a patch
/// stays one. Its forces are shared among the strips by their loads and act along the strips' own directions.
#pragma once

#include <cstdint>

#include "base/fault.hpp"
#include "patch/sdec.hpp"
#include "surface/rolling/surface_rolling.hpp"
#include "tangential/friction/heated_friction.hpp"
#include "tangential/rolling_contact.hpp"

namespace wrc::surface {

struct RegionRolling {
  tangential::TangentialForces (*solve)(const tangential::RollingContact& contact,
                                        const tangential::TangentialFields& fields, Fault& fault,
                                        tangential::TangentialSensitivities* sensitivities) = nullptr;
  tangential::PatchModel model{};
  tangential::TractionBound bound = tangential::TractionBound::parabolic;
  tangential::FlexibilityForm form = tangential::FlexibilityForm::separate;
  const theory::SdecTable* linear_theory = nullptr;
  const tangential::ForceTable* force_table = nullptr;
  std::int64_t workspace_bytes = 0;  ///< the method's working memory for as many strips as there may be
};

/// Strips to be rolled patch by patch.
struct RegionRollingInput {
  const SurfaceRollingInput& strips;  ///< without its method, coefficients and curvatures
  const double* along;                ///< x of the strips' middles [m]
  tangential::SlopeFall slope{};
  double slope_reduction = 1.0;  ///< the factor that is in the shear modulus already [-]
  tangential::ReductionFactors reduction{};
  tangential::HeatedFriction* heat =
      nullptr;            ///< friction over temperature; strips.friction is then that of cold surfaces
  double* hot = nullptr;  ///< with heat, result: coefficients of friction; may be strips.friction
};

/// Doubles of working memory for at most `most` strips.
std::int64_t region_rolling_doubles(std::int32_t most, const RegionRolling& method);

/// The double ellipse of a load with these moments [m^2], [m^2], [m^3].
patch::Sdec sdec_of_load(double mean_length_squared, double variance, double third_moment) noexcept;

/// Rolls the strips forwards. `fields`: memory for as many strips, for methods that need it; not results.
Fault roll_by_region(const RegionRollingInput& in, const RegionRolling& method, void* workspace,
                     const tangential::TangentialFields& fields, const SurfaceRollingForces& forces) noexcept;

}  // namespace wrc::surface
