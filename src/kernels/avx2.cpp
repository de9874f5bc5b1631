#include "kernels/kernels_of_this_unit.hpp"

namespace wrc::simd {

extern const Kernels avx2_kernels;
constexpr Kernels avx2_kernels = kernels_of(InstructionSet::avx2);

}  // namespace wrc::simd
