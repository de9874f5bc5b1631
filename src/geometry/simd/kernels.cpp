#include "geometry/simd/kernels.hpp"

namespace wrc {
namespace simd {

extern const GeometryKernels baseline_geometry_kernels;
#if defined(__x86_64__)
extern const GeometryKernels avx2_geometry_kernels, avx512_geometry_kernels;
#endif

}  // namespace simd

const GeometryKernels& geometry_kernels(InstructionSet set) {
#if defined(__x86_64__)
  if (set == InstructionSet::avx512) return simd::avx512_geometry_kernels;
  if (set == InstructionSet::avx2) return simd::avx2_geometry_kernels;
#endif
  static_cast<void>(set);
  return simd::baseline_geometry_kernels;
}

}  // namespace wrc
