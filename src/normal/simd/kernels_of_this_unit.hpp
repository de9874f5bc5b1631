/// Body of the units kernels_*.cpp: the kernels for whatever instruction set the unit is compiled for.
#pragma once

#include "normal/simd/edge_kernel.hpp"
#include "normal/simd/elimination_kernel.hpp"
#include "normal/simd/influence_kernel.hpp"
#include "normal/simd/penetration_kernel.hpp"

namespace wrc::simd {
namespace {

constexpr NormalKernels normal_kernels_of(InstructionSet set) {
  return {set,
          influence_row_kernel,
          edge_displacements_kernel,
          eliminate_kernel,
          divide_span_kernel,
          displacements_at_kernel};
}

}  // namespace
}  // namespace wrc::simd
