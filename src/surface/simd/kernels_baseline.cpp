#include "surface/simd/influence_kernel.hpp"

namespace wrc::simd {

extern const SurfaceKernels baseline_surface_kernels;
constexpr SurfaceKernels baseline_surface_kernels = {InstructionSet::baseline, surface_influence_row, surface_edge_displacement};

}  // namespace wrc::simd
