/// Kernels of normal contact, for the instruction set WRC_SET that this unit is compiled for.
#include "kernels/kernels.hpp"

#include "normal/simd/edge_kernel.hpp"
#include "normal/simd/elimination_kernel.hpp"
#include "normal/simd/influence_kernel.hpp"
#include "normal/simd/penetration_kernel.hpp"

namespace wrc::simd::WRC_SET {

extern const NormalKernels normal_kernels;
constexpr NormalKernels normal_kernels = {
    .influence_row = influence_row_kernel,
    .edge_displacements = edge_displacements_kernel,
    .eliminate = eliminate_kernel,
    .divide_span = divide_span_kernel,
    .displacements_at = displacements_at_kernel,
};

}  // namespace wrc::simd::WRC_SET
