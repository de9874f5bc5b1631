#include "normal/simd/kernels_of_this_unit.hpp"

namespace wrc::simd {

extern const NormalKernels baseline_normal_kernels;
constexpr NormalKernels baseline_normal_kernels = normal_kernels_of(InstructionSet::baseline);

}  // namespace wrc::simd
