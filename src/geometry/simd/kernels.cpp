/// Kernels of the geometry stage, for the instruction set WRC_SET that this unit is compiled for.
#include "kernels/kernels.hpp"

#include "geometry/simd/rows_kernel.hpp"

namespace wrc::simd::WRC_SET {

extern const GeometryKernels geometry_kernels;
constexpr GeometryKernels geometry_kernels = {
    .fill_rows = fill_rows_kernel,
};

}  // namespace wrc::simd::WRC_SET
