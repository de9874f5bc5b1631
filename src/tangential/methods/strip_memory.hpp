/// Strip FASTSIM that remembers, on a contact plane (patch_memory.hpp has the law). Tractions over cells are
/// those of steady rolling at the creepages of the moment.
#pragma once

#include <cstddef>
#include <cstdint>

#include "tangential/methods/patch_memory.hpp"

namespace wrc::tangential {

/// Bytes of the memory of a contact with so many strips.
std::size_t strip_memory_bytes(std::int32_t strips);

/// Makes the memory of bodies without tractions in zeroed bytes.
void make_strip_memory(std::int32_t strips, void* memory);

/// A step of one patch from the strips end_step() left, contact.memory saying how it moves. Real-time: work
/// proportional to strips times at most 34 passes over 16 cells.
TangentialForces roll_with_memory(const RollingContact& contact, const TangentialFields& fields, Fault& fault,
                                  const MemoryFactors& factors = fitted_memory);

/// The patches rolled between begin_step() and end_step() become the memory.
void begin_step(void* memory);
void end_step(void* memory);

}  // namespace wrc::tangential
