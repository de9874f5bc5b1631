#include "normal/simd/kernels_of_this_unit.hpp"

namespace wrc::simd {

extern const NormalKernels avx512_normal_kernels;
constexpr NormalKernels avx512_normal_kernels = normal_kernels_of(InstructionSet::avx512);

}  // namespace wrc::simd
