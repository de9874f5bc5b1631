#include "surface/simd/influence_kernel.hpp"
#include "surface/simd/outline_kernel.hpp"

namespace wrc::simd {

extern const SurfaceKernels avx512_surface_kernels;
constexpr SurfaceKernels avx512_surface_kernels = {InstructionSet::avx512, surface_influence_row,
                                                   surface_edge_displacement, outline_kernel,
                                                   follow_rays_kernel};

}  // namespace wrc::simd
