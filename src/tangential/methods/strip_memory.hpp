/// Strip FASTSIM of rolling that is not steady: strips that remember their tractions.
///
/// Simplified theory along a particle's path, q the distance rolled: dp/dq = -g while it sticks, g made of
/// the creepages and flexibilities of the moment, |p| <= B u v. A particle brings along the traction it had
/// where it was a step before, at x + dq: the memory is transported with the bodies (semi-Lagrangian,
/// parabolas through three cells), whatever became of the patch meanwhile.
///
///  - Tractions are kept in the two parts steady strip FASTSIM has (strip_fastsim.hpp): one that grows evenly
///    over the strip, and k u v of spin. Over the bound of the march these are c and psi; in steady rolling
///    |c / t + psi| = 1 at the share t at which slip sets in, and the traction over mu p_n is
///         psi + c / (1 + sqrt(1 - t)).
///    Any c and psi define t by that, and so the traction of a cell that is not steady.
///  - An effect that simplified theory leaves out matters here: the half-spaces yield as a whole, U = S F,
///    beside the displacement of each place by its own traction. In steady rolling U is constant and without
///    effect; while forces change the bodies creep by dU/dq more, and forces come later: from rest exact theory
///    has 95 % of them after 0.7 to 1.7 lengths of the patch, simplified theory after 0.8. S follows from the
///    difference of the two mean lags in full adhesion; it was fitted to random sequences solved exactly
///    (tools/transient_report.cpp), as one number along and one across and a power of a / b.
///  - Coarse cells do: the force is that of steady strip FASTSIM at the creepages of the moment, dU/dq included,
///    plus the force of the memory's cells less that of the same cells in steady rolling. So conditions that
///    stay end in the steady method, and a step over six lengths of the patch is the steady method; over the
///    four before, it fades in. Power is made up in the same way, and the slips are scaled to it.
///
/// Tractions over cells are those of steady rolling at the creepages of the moment.
#pragma once

#include <cstddef>
#include <cstdint>

#include "tangential/rolling_contact.hpp"

namespace wrc::tangential {

/// Bytes of the memory of a contact with so many strips.
std::size_t strip_memory_bytes(std::int32_t strips);

/// Makes the memory of bodies without tractions in zeroed bytes.
void make_strip_memory(std::int32_t strips, void* memory);

/// A step of one patch, contact.memory.rolled onwards from what end_step() left. Real-time: work proportional
/// to strips times at most 17 passes over 16 cells.
TangentialForces roll_with_memory(const RollingContact& contact, const TangentialFields& fields,
                                  Fault& fault);

/// The patches rolled between begin_step() and end_step() become the memory.
void begin_step(void* memory);
void end_step(void* memory);

}  // namespace wrc::tangential
