/// Rolling contact by the exact half-space theory on two coarse grids: the accurate method between FASTSIM
/// and the offline solver.
///
/// The theory is solved (coarse_rolling.hpp) on 8 x 8 and on 16 x 16 cells over the patch's bounding box. The
/// error of such a grid is of the first order in the cell size and very regular, so that twice the fine
/// result less the coarse one leaves little of it. That is done with the forces, and on the cells of the
/// strips with the traction's share of the bound, p / (mu p_n), cut to 1 where it exceeds it, so that
/// |p| <= mu p_n. The fields' sum agrees with the forces within about 1 % of mu N; the slip is scaled so that
/// the fields make the power of the energy balance.
#pragma once

#include <cstdint>

#include "tangential/rolling_contact.hpp"

namespace wrc {

/// Memory the method works in [bytes], aligned as doubles.
std::int64_t coarse_halfspace_workspace();

/// contact.region: the strips of the actual patch; its regularised shape and contact.bound are not used, of
/// contact.linear_theory the Poisson ratio. Flags WRC_FLAG_ITERATION_CAP when a grid did not reach
/// equilibrium: the result is then usable, |p| <= mu p_n, but not exact.
TangentialForces coarse_halfspace(const RollingContact& contact, void* workspace,
                                  const TangentialFields& fields, Fault& fault);

}  // namespace wrc
