/// Contact that remembers its tractions: strips at rest, rolling either way, and between them.
///
/// Simplified theory with displacements u = L p of the bodies' particles. In a step the wheel is displaced
/// over the rail by D = creepages times the length of the step, and rolls by that length, or rests. A
/// particle that is at x now was where the bodies carried it from, with the traction p' of then; it has
///     p = the point of the disk |p| <= bound nearest to p' - (D - U) / L,
/// one implicit step of friction, which dissipates. Particles enter without tractions.
///
///  - The half-spaces yield as a whole, U = S (F - F'), beside the displacement of each place by its own traction.
///    Local flexibilities give the forces of linear rolling (Kalker), both together the stiffness of a patch that
///    sticks at rest (Mindlin): S is the difference, no fitted number. U is a translation and a rotation.
///  - The bound has the friction limit of the patch and the form (1 - r^2)^m. m follows from the share of U in the
///    whole yield such that shifts at rest are Cattaneo's, 1 - (1 - d)^1.5; hysteresis then is Mindlin's (Masing),
///    as each cell sticks and slips by itself. Under m = 1 and half of the yield they differ by 0.01 of mu N.
///  - Arms of spin are longer than the cells' by a factor, for the forces and the displacements alike: the bound is
///    nearer to the centre than pressure is.
///  - Rolling steadily this is FASTSIM. The difference of steady strip FASTSIM to the same cells in steady rolling
///    is added and follows over the length rolled; at rest it stays. It is taken ahead by the yield of the moment.
///    Conditions that stay end in strip FASTSIM, and a step over four lengths of the patch is strip FASTSIM.
///  - Passivity: the contact counts the energy that it could give back. It is at most the energy stored in cells and
///    in U, and at most its value before and the step's work -F.D. Where less were left than a quarter of
///    the stored energy, tractions and forces are lowered to that. So the work over any path is never below zero,
///    however patches change.
///
/// Constants are fitted to random sequences solved exactly (src/halfspace, 84 of all kinds, by the forces and
/// moments of all steps). Tractions over cells are those of steady rolling at the creepages of the moment.
#pragma once

#include <cstddef>
#include <cstdint>

#include "tangential/rolling_contact.hpp"

namespace wrc::tangential {

/// Bytes of the memory of a contact with so many strips.
std::size_t strip_memory_bytes(std::int32_t strips);

/// Makes the memory of bodies without tractions in zeroed bytes.
void make_strip_memory(std::int32_t strips, void* memory);

/// A step of one patch from the strips end_step() left, contact.memory saying how it moves. Real-time: work
/// proportional to strips times at most 34 passes over 16 cells.
TangentialForces roll_with_memory(const RollingContact& contact, const TangentialFields& fields,
                                  Fault& fault);

/// The patches rolled between begin_step() and end_step() become the memory.
void begin_step(void* memory);
void end_step(void* memory);

}  // namespace wrc::tangential
