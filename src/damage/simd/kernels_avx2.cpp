#include "damage/simd/cells_kernel.hpp"

namespace wrc::simd {

extern const DamageKernels avx2_damage_kernels;
constexpr DamageKernels avx2_damage_kernels = {InstructionSet::avx2, assess_cells_kernel};

}  // namespace wrc::simd
