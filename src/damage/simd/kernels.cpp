#include "damage/simd/kernels.hpp"

namespace wrc {
namespace simd {

extern const DamageKernels baseline_damage_kernels;
#if defined(__x86_64__)
extern const DamageKernels avx2_damage_kernels, avx512_damage_kernels;
#endif

}  // namespace simd

const DamageKernels& damage_kernels(InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::avx512) return simd::avx512_damage_kernels;
  if (set == InstructionSet::avx2) return simd::avx2_damage_kernels;
#endif
  static_cast<void>(set);
  return simd::baseline_damage_kernels;
}

}  // namespace wrc
