#include "normal/simd/kernels.hpp"

namespace wrc {
namespace simd {

extern const NormalKernels baseline_normal_kernels;
#if defined(__x86_64__)
extern const NormalKernels avx2_normal_kernels, avx512_normal_kernels;
#endif

}  // namespace simd

const NormalKernels& normal_kernels(InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::avx512) return simd::avx512_normal_kernels;
  if (set == InstructionSet::avx2) return simd::avx2_normal_kernels;
#endif
  static_cast<void>(set);
  return simd::baseline_normal_kernels;
}

}  // namespace wrc
