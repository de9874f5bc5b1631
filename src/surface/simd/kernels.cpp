/// Kernels of contact on the rail's surface, for the instruction set WRC_SET that this unit is compiled for.
#include "kernels/kernels.hpp"

#include "surface/simd/blend_rows_kernel.hpp"
#include "surface/simd/follow_rail_kernel.hpp"
#include "surface/simd/influence_kernel.hpp"
#include "surface/simd/influence_slopes_kernel.hpp"
#include "surface/simd/look_along_kernel.hpp"
#include "surface/simd/near_lines_kernel.hpp"
#include "surface/simd/outline_kernel.hpp"
#include "surface/simd/overlap_slopes_kernel.hpp"
#include "surface/simd/section_strips_kernel.hpp"
#include "surface/simd/slopes_row_kernel.hpp"
#include "surface/simd/smoothed_slopes_kernel.hpp"
#include "surface/simd/strip_gains_kernel.hpp"
#include "surface/simd/strip_numbers_kernel.hpp"

namespace wrc::simd::WRC_SET {

extern const SurfaceKernels surface_kernels;
constexpr SurfaceKernels surface_kernels = {
    .strip_numbers = strip_numbers_kernel,
    .strip_means_slopes = strip_means_slopes_kernel,
    .strip_arrays_slopes = strip_arrays_slopes_kernel,
    .strip_forces_slopes = strip_forces_slopes_kernel,
    .influence = surface_influence,
    .own_influence = surface_own_influence,
    .edges = surface_edges,
    .influence_slopes = sloped::surface_influence_slopes,
    .edge_slopes = sloped::surface_edge_slopes,
    .slopes_row = slopes_row_kernel,
    .blend_rows = blend_rows_kernel,
    .take_known = take_known_kernel,
    .near_lines = near_lines_kernel,
    .smoothed_slopes = smoothed_slopes_kernel,
    .section_strips = section_strips_kernel,
    .strip_gains = strip_gains_kernel,
    .look_along = look_along_kernel,
    .climb_along = climb_along_kernel,
    .follow_rail = follow_rail_kernel,
    .outline = outline_kernel,
    .cross_rays = cross_rays_kernel,
    .follow_rays = follow_rays_kernel,
    .overlap_slopes = overlap_slopes_kernel,
};

}  // namespace wrc::simd::WRC_SET
