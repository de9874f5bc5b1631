#include "kernels/kernels.hpp"

namespace wrc {

// The table of a set: those that src/*/simd/kernels.cpp define when they are compiled for it.
#define WRC_KERNELS_OF(SET)                                                            \
  namespace simd::SET {                                                                \
  extern const GeometryKernels geometry_kernels;                                       \
  extern const NormalKernels normal_kernels;                                           \
  extern const TangentialKernels tangential_kernels;                                   \
  extern const SurfaceKernels surface_kernels;                                         \
  extern const DamageKernels damage_kernels;                                           \
  constexpr Kernels kernels = {InstructionSet::SET, geometry_kernels, normal_kernels,  \
                               tangential_kernels,  surface_kernels,  damage_kernels}; \
  }

WRC_KERNELS_OF(baseline)
// WRC_BASELINE_ALONE: all sources are one unit, compiled for one set (tools/amalgamate).
#if defined(__x86_64__) && !defined(WRC_BASELINE_ALONE)
WRC_KERNELS_OF(avx2)
#if !defined(WRC_WITHOUT_AVX512)
WRC_KERNELS_OF(avx512)
#endif
#endif

const Kernels& kernels_for(InstructionSet set) {
#if defined(__x86_64__) && !defined(WRC_BASELINE_ALONE)
#if !defined(WRC_WITHOUT_AVX512)
  if (set == InstructionSet::avx512) return simd::avx512::kernels;
#endif
  if (set == InstructionSet::avx2) return simd::avx2::kernels;
#endif
  static_cast<void>(set);
  return simd::baseline::kernels;
}

}  // namespace wrc
