#include "normal/simd/kernels_of_this_unit.hpp"

namespace wrc::simd {

extern const NormalKernels avx2_normal_kernels;
constexpr NormalKernels avx2_normal_kernels = normal_kernels_of(InstructionSet::avx2);

}  // namespace wrc::simd
