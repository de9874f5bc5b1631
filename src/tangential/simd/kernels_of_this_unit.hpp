/// Body of the units kernels_*.cpp: the kernels for whatever instruction set the unit is compiled for.
#pragma once

#include "tangential/simd/cells_kernel.hpp"
#include "tangential/simd/march_kernel.hpp"
#include "tangential/simd/strip_fastsim_kernel.hpp"

namespace wrc::simd {
namespace {

constexpr Kernels kernels_of(InstructionSet set) {
  return {set,
          march_kernel<false>,
          march_kernel<true>,
          strip_fastsim_kernel<false>,
          strip_fastsim_kernel<true>,
          place_cells_kernel};
}

}  // namespace
}  // namespace wrc::simd
