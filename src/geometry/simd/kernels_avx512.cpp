#include "geometry/simd/rows_kernel.hpp"

namespace wrc::simd {

extern const GeometryKernels avx512_geometry_kernels;
constexpr GeometryKernels avx512_geometry_kernels = {InstructionSet::avx512, fill_rows_kernel};

}  // namespace wrc::simd
