#include "surface/simd/kernels.hpp"

namespace wrc {
namespace simd {

extern const SurfaceKernels baseline_surface_kernels;
#if defined(__x86_64__)
extern const SurfaceKernels avx2_surface_kernels, avx512_surface_kernels;
#endif

}  // namespace simd

const SurfaceKernels& surface_kernels(InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::avx512) return simd::avx512_surface_kernels;
  if (set == InstructionSet::avx2) return simd::avx2_surface_kernels;
#endif
  static_cast<void>(set);
  return simd::baseline_surface_kernels;
}

}  // namespace wrc
