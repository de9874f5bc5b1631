/// The march of simplified rolling contact: the one kernel under every FASTSIM variant.
///
/// Along a strip, from the leading to the trailing edge, with v the distance marched, the simplified theory
/// (surface displacement = flexibility times traction) reads
///
///     dp/dv = -g + r,   g = (nu_x / L11 - phi y / L13,  nu_y / L22 + phi x / L23),
///
/// where the excess r vanishes where the surfaces stick, and where they slip it holds the traction on the
/// bound, p = tau e, by r = -lambda e, lambda >= 0. Sliding per unit rolled length is the excess times the
/// flexibility, s = (L11 r_x, L22 r_y), so that the power density -s.p = lambda tau (L11 e_x^2 + L22 e_y^2)
/// is the power the model dissipates: elastic energy integrates to zero over a strip, and
///
///     IInt -s.p dA = -Fx nu_x - Fy nu_y - phi ((L22/L23) IInt x p_y dA - (L11/L13) IInt y p_x dA),
///
/// which for one flexibility is -(Fx nu_x + Fy nu_y + Mz phi). It holds up to the discretisation, second
/// order in the cell size.
///
/// How it is solved:
///  1. The first stick zone, from the leading edge to the onset of slip, in closed form (stick_zone.hpp).
///  2. Slip from the onset on: over a step the direction e turns towards -g by
///     tan(d/2) -> tan(d/2) / (1 + z + z^2/2), d the angle between them and z = Int |g| / tau dv. This is the
///     exact solution of the slip equation for constant g with the L-stable second-order Pade form of
///     exp(-z), so neither the vanishing bound at the edges nor large creepages make it overshoot.
///  3. Every slipping cell is tested for sticking again, by Kalker's criterion |p - step g| <= tau.
///
/// Things that look like errors and are not: the adhesion tractions of a cell are means over the cell, cut to
/// the mean of the bound where slip sets in within the cell; the slip of the cell after the onset stands for
/// everything slid since then, half a cell to one and a half.
#pragma once

#include "tangential/march/march_grid.hpp"
#include "tangential/problem.hpp"

namespace wrc::tangential {

/// Solves the problem on the grid. Fields are written where their pointers are set. Any finite creepages,
/// friction >= 0 and flexibilities > 0 give finite results; an empty region gives zeros. Real-time: no
/// memory, work proportional to strips times cells. `sensitivities`: nullptr, not wanted; with them, the
/// flexibilities are held and no fields written.
TangentialForces march(const TangentialProblem& problem, const MarchGrid& grid,
                       const TangentialFields& fields = {}, TangentialSensitivities* sensitivities = nullptr);

}  // namespace wrc::tangential
