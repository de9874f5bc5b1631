/// Derivatives of the pressures (pressure.hpp) by the pose: the equations of a solution, differentiated where
/// it stands.
///
/// With M, E+, E- the displacement at a strip's middle and edges per unit of q = lambda L, the unknowns q, L
/// and c of the strips in contact obey
///
///     sum_b M_ab q_b = d_a,            d_a = depth_a - kappa_a/2 (c_a - W_a)^2
///     L_a lambda_a - q_a = 0,           lambda_a = mean of q_b kappa_b / (2 (d_b - (E+ q + E- q)_b / 2))
///     c_a - shift_a = W_a,              shift_a on the line of ((E- - E+) q)_b / (2 l_b kappa_b)
///
/// with the mean and the line of smoothing.hpp, weighted by q. Their derivatives give the changes of all
/// three for all four ways in which a wheel moves (PlaceInput), q by the first rows, then L and c:
///
///     rows       unknowns  q_1 .. q_n   L_1 .. L_n   c_1 .. c_n  |  right-hand sides, one for each PlaceInput
///     contact               M            dM/dL q      dM/dc q        d depth - ...
///     lambda               - 1/lambda    1 + ...      ...
///     shift                 ...          ...          1 + ...        d W
#pragma once

#include <cstdint>

#include "kernels/kernels.hpp"
#include "normal/elasticity/influence_tables.hpp"
#include "surface/geometry/overlap_slopes.hpp"
#include "surface/pressure/pressure.hpp"

namespace wrc::surface {

/// Most strips in contact that are differentiated, where `overlapping` strips may overlap. Memory goes with
/// the square. Contacts of 150 kN have a fourth of `overlapping`, conformal ones up to 46 on wide strips.
inline std::int32_t most_differentiated(std::int32_t overlapping) {
  const std::int32_t most = 16 + 5 * overlapping / 16;
  return most < overlapping ? most : overlapping;
}

/// Strips in contact, by increasing place; one element per strip.
struct PressedStrips {
  std::int32_t count = 0, behind = 0;                           ///< from `behind` on strips are second places
  double *place, *width, *line_load, *length_squared, *centre;  ///< as the solution has them
  OverlapSlopes* overlap;
  PlaceDual *line_load_dual, *length_squared_dual, *centre_dual;  ///< results
};

std::int64_t pressure_jacobian_doubles(std::int32_t most);

/// Differentiates the solution. `workspace` has `doubles`, pressure_jacobian_doubles(strips.count) or more.
void differentiate_pressures(const PressureModel& model, double* workspace, std::int64_t doubles,
                             const PressedStrips& strips) noexcept;

}  // namespace wrc::surface
