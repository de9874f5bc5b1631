/// Body of the units kernels_*.cpp: the kernels for whatever instruction set the unit is compiled for.
#pragma once

#include "tangential/simd/cells_kernel.hpp"
#include "tangential/simd/march_kernel.hpp"
#include "tangential/simd/strip_fastsim_kernel.hpp"

namespace wrc::simd {
namespace {

constexpr Kernels kernels_of(InstructionSet set) {
  return {set,
          march_kernel<Output::forces, MarchTask>,
          march_kernel<Output::fields, MarchTask>,
          march_kernel<Output::sensitivities, MarchTask>,
          strip_fastsim_kernel<Output::forces, StripFastsimTask>,
          strip_fastsim_kernel<Output::fields, StripFastsimTask>,
          strip_fastsim_kernel<Output::sensitivities, StripFastsimTask>,
          march_kernel<Output::forces, SurfaceMarchTask>,
          march_kernel<Output::fields, SurfaceMarchTask>,
          strip_fastsim_kernel<Output::forces, SurfaceStripsTask>,
          strip_fastsim_kernel<Output::fields, SurfaceStripsTask>,
          place_cells_kernel};
}

}  // namespace
}  // namespace wrc::simd
