#include "damage/simd/cells_kernel.hpp"

namespace wrc::simd {

extern const DamageKernels baseline_damage_kernels;
constexpr DamageKernels baseline_damage_kernels = {InstructionSet::baseline, assess_cells_kernel};

}  // namespace wrc::simd
