/// Kernels of the damage stage, for the instruction set WRC_SET that this unit is compiled for.
#include "kernels/kernels.hpp"

#include "damage/simd/cells_kernel.hpp"
#include "damage/simd/stress_kernel.hpp"

namespace wrc::simd::WRC_SET {

extern const DamageKernels damage_kernels;
constexpr DamageKernels damage_kernels = {
    .assess_cells = assess_cells_kernel,
    .stress_of_points = stress_of_points_kernel,
    .stress_of_corners = stress_of_corners_kernel,
};

}  // namespace wrc::simd::WRC_SET
