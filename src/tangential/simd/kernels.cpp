/// Kernels of rolling, for the instruction set WRC_SET that this unit is compiled for.
#include "kernels/kernels.hpp"

#include "tangential/simd/layered_march_kernel.hpp"
#include "tangential/simd/march_kernel.hpp"
#include "tangential/simd/memory_kernel.hpp"
#include "tangential/simd/strip_fastsim_kernel.hpp"
#include "tangential/simd/surface_strips_slopes_kernel.hpp"

namespace wrc::simd::WRC_SET {

extern const TangentialKernels tangential_kernels;
constexpr TangentialKernels tangential_kernels = {
    .march = march_kernel<Output::forces, MarchTask>,
    .march_fields = march_kernel<Output::fields, MarchTask>,
    .march_sensitivities = march_kernel<Output::sensitivities, MarchTask>,
    .strip_fastsim = strip_fastsim_kernel<Output::forces, StripFastsimTask>,
    .strip_fastsim_fields = strip_fastsim_kernel<Output::fields, StripFastsimTask>,
    .strip_fastsim_sensitivities = strip_fastsim_kernel<Output::sensitivities, StripFastsimTask>,
    .surface_march = march_kernel<Output::forces, SurfaceMarchTask>,
    .surface_march_fields = march_kernel<Output::fields, SurfaceMarchTask>,
    .surface_strips = strip_fastsim_kernel<Output::forces, SurfaceStripsTask>,
    .surface_strips_fields = strip_fastsim_kernel<Output::fields, SurfaceStripsTask>,
    .surface_strips_slopes = surface_strips_slopes_kernel,
    .memory_bounds = memory_bounds_kernel,
    .memory_bring = memory_bring_kernel,
    .memory_pass = memory_pass_kernel,
    .memory_pass_sums = memory_pass_sums_kernel,
    .memory_march = memory_march_kernel,
    .memory_tend = memory_tend_kernel,
    .memory_squares = memory_squares_kernel,
    .layered_march = layered_march_kernel<Output::forces>,
    .layered_march_fields = layered_march_kernel<Output::fields>,
};

}  // namespace wrc::simd::WRC_SET
