#include "geometry/simd/rows_kernel.hpp"

namespace wrc::simd {

extern const GeometryKernels avx2_geometry_kernels;
constexpr GeometryKernels avx2_geometry_kernels = {InstructionSet::avx2, fill_rows_kernel};

}  // namespace wrc::simd
