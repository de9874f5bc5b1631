#include "geometry/simd/rows_kernel.hpp"

namespace wrc::simd {

extern const GeometryKernels baseline_geometry_kernels;
constexpr GeometryKernels baseline_geometry_kernels = {InstructionSet::baseline, fill_rows_kernel};

}  // namespace wrc::simd
