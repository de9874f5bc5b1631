#include "kernels/kernels.hpp"

namespace wrc {
namespace simd {

extern const Kernels baseline_kernels;
#if defined(__x86_64__)
extern const Kernels avx2_kernels, avx512_kernels;
#endif

}  // namespace simd

const Kernels& kernels_for(InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::avx512) return simd::avx512_kernels;
  if (set == InstructionSet::avx2) return simd::avx2_kernels;
#endif
  static_cast<void>(set);
  return simd::baseline_kernels;
}

}  // namespace wrc
