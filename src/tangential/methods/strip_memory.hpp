/// Strip FASTSIM of rolling that is not steady: what its strips remember of the tractions they had.
///
/// Simplified theory along a particle's path, q the distance rolled: dp/dq = -g while it sticks, g made of
/// the creepages and flexibilities of the moment, |p| <= B u v. What a particle brings along is what it had
/// where it was a step before, at x + dq: the memory is transported with the bodies (semi-Lagrangian,
/// parabolas through three cells), whatever became of the patch meanwhile.
///
///  - Tractions are kept in the two parts steady strip FASTSIM has (strip_fastsim.hpp): one that grows evenly over
///    the strip, and k u v of spin. Over the bound of the march these are c and psi; in steady rolling
///    |c / t + psi| = 1 at the share t at which slip sets in, and the traction over mu p_n is
///         psi + c / (1 + sqrt(1 - t)).
///    Of any c and psi that defines t, and with it the traction of a cell that is not steady.
///  - What simplified theory leaves out matters here: the half-spaces give way as a whole, U = S F, beside what
///    each place gives way by itself. In steady rolling U is constant and nobody sees it; while forces change the
///    bodies creep by dU/dq more, and forces come later: from rest exact theory has 95 % of them after 0.7 to 1.7
///    lengths of the patch, simplified theory after 0.8. S falls out of the difference of the two mean lags in full
///    adhesion; it was fitted to random sequences solved exactly (tools/transient_report.cpp), as one number along
///    and one across and a power of a / b.
///  - Coarse cells do: the force is that of steady strip FASTSIM at the creepages of the moment, dU/dq included,
///    plus the difference between what the memory's cells and the same cells in steady rolling come to. So
///    conditions that stay end in the steady method, and a step over six lengths of the patch is the steady
///    method; over the four before, it fades in.
///
/// Fields and power are those of steady rolling at the creepages of the moment.
#pragma once

#include <cstddef>
#include <cstdint>

#include "tangential/rolling_contact.hpp"

namespace wrc {

/// Bytes of the memory of a contact with so many strips.
std::size_t strip_memory_bytes(std::int32_t strips);

/// Makes the memory of bodies without tractions in zeroed bytes.
void make_strip_memory(std::int32_t strips, void* memory);

/// A step of one patch, contact.memory.rolled onwards from what end_step() left. Real-time: work proportional
/// to strips times at most 17 passes over 16 cells.
TangentialForces roll_with_memory(const RollingContact& contact, const TangentialFields& fields,
                                  Fault& fault);

/// What the patches were since begin_step() becomes what is remembered.
void begin_step(void* memory);
void end_step(void* memory);

}  // namespace wrc
