#include "kernels/kernels_of_this_unit.hpp"

namespace wrc::simd {

extern const Kernels baseline_kernels;
constexpr Kernels baseline_kernels = kernels_of(InstructionSet::baseline);

}  // namespace wrc::simd
