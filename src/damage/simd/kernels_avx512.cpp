#include "damage/simd/cells_kernel.hpp"

namespace wrc::simd {

extern const DamageKernels avx512_damage_kernels;
constexpr DamageKernels avx512_damage_kernels = {InstructionSet::avx512, assess_cells_kernel};

}  // namespace wrc::simd
