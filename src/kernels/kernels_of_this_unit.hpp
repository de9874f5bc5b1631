/// Body of the units baseline.cpp, avx2.cpp and avx512.cpp: the kernels for whatever instruction set the unit
/// is compiled for.
#pragma once

#include "damage/simd/cells_kernel.hpp"
#include "damage/simd/stress_kernel.hpp"
#include "geometry/simd/rows_kernel.hpp"
#include "kernels/kernels.hpp"
#include "normal/simd/edge_kernel.hpp"
#include "normal/simd/elimination_kernel.hpp"
#include "normal/simd/influence_kernel.hpp"
#include "normal/simd/penetration_kernel.hpp"
#include "surface/simd/blend_rows_kernel.hpp"
#include "surface/simd/influence_kernel.hpp"
#include "surface/simd/influence_slopes_kernel.hpp"
#include "surface/simd/near_lines_kernel.hpp"
#include "surface/simd/outline_kernel.hpp"
#include "surface/simd/section_strips_kernel.hpp"
#include "surface/simd/slopes_row_kernel.hpp"
#include "surface/simd/strip_numbers_kernel.hpp"
#include "tangential/simd/march_kernel.hpp"
#include "tangential/simd/strip_fastsim_kernel.hpp"
#include "tangential/simd/surface_strips_slopes_kernel.hpp"

namespace wrc::simd {
namespace {

constexpr Kernels kernels_of(InstructionSet set) {
  return {
      .set = set,
      .fill_rows = fill_rows_kernel,
      .influence_row = influence_row_kernel,
      .edge_displacements = edge_displacements_kernel,
      .eliminate = eliminate_kernel,
      .divide_span = divide_span_kernel,
      .displacements_at = displacements_at_kernel,
      .march = march_kernel<Output::forces, MarchTask>,
      .march_fields = march_kernel<Output::fields, MarchTask>,
      .march_sensitivities = march_kernel<Output::sensitivities, MarchTask>,
      .strip_fastsim = strip_fastsim_kernel<Output::forces, StripFastsimTask>,
      .strip_fastsim_fields = strip_fastsim_kernel<Output::fields, StripFastsimTask>,
      .strip_fastsim_sensitivities = strip_fastsim_kernel<Output::sensitivities, StripFastsimTask>,
      .strip_numbers = strip_numbers_kernel,
      .surface_march = march_kernel<Output::forces, SurfaceMarchTask>,
      .surface_march_fields = march_kernel<Output::fields, SurfaceMarchTask>,
      .surface_strips = strip_fastsim_kernel<Output::forces, SurfaceStripsTask>,
      .surface_strips_fields = strip_fastsim_kernel<Output::fields, SurfaceStripsTask>,
      .surface_strips_slopes = surface_strips_slopes_kernel,
      .surface_pairs = surface_pairs,
      .surface_influence = surface_influence,
      .surface_own_influence = surface_own_influence,
      .surface_edges = surface_edges,
      .surface_influence_slopes = sloped::surface_influence_slopes,
      .surface_edge_slopes = sloped::surface_edge_slopes,
      .slopes_row = slopes_row_kernel,
      .blend_rows = blend_rows_kernel,
      .near_lines = near_lines_kernel,
      .section_strips = section_strips_kernel,
      .outline = outline_kernel,
      .cross_rays = cross_rays_kernel,
      .follow_rays = follow_rays_kernel,
      .assess_cells = assess_cells_kernel,
      .stress_of_points = stress_of_points_kernel,
      .stress_of_corners = stress_of_corners_kernel,
  };
}

}  // namespace
}  // namespace wrc::simd
