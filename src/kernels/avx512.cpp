#include "kernels/kernels_of_this_unit.hpp"

namespace wrc::simd {

extern const Kernels avx512_kernels;
constexpr Kernels avx512_kernels = kernels_of(InstructionSet::avx512);

}  // namespace wrc::simd
