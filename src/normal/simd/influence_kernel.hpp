/// A row of the influence matrix of strips on each other.
#pragma once

#include "normal/simd/line_tables.hpp"

namespace wrc::simd {
namespace {

/// 0, 1, 2, ...: which element of a pack a lane holds.
constexpr double lane_numbers[most_lanes] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

/// Kernels::influence_row.
void influence_row_kernel(const InfluenceTask& task, std::int32_t j, double* row) {
  static_assert(lanes <= most_lanes);
  constexpr std::int32_t near = 8;  // strips away: beyond, the correction is below 2e-3 of an entry
  const Pack y_j = task.y[j], centre_j = task.centre[j];
  for (std::int32_t first = 0; first < task.count; first += lanes) {
    const Pack inverse = load_pack(task.inverse_length + first), width = load_pack(task.width + first);
    const Pack distance = magnitude(load_pack(task.y + first) - y_j) * inverse;
    const Pack tau = select(distance > 0.0, distance, 1.0);  // the strip itself is the caller's
    const Pack tau2 = tau * tau;
    Pack seen = read(task.tables.on_middle_plane, tau);
    const bool has_near = first - near <= j && j < first + lanes + near;
    if (has_near || task.skewed) {
      const Pack to_end = root(1.0 + tau2);
      const Pack inverse_cube = 1.0 / (tau2 * to_end);
      if (task.skewed) {
        // J(tau, xi) for xi mostly near 0: the middle plane's with the leading effect of xi, which is right
        // both near the line, sqrt(1 - xi^2), and far from it, 1 / sqrt(tau^2 + xi^2); to 8e-4 up to where
        // the table takes over.
        const Pack xi = magnitude(load_pack(task.centre + first) - centre_j) * inverse;
        const Pack xi2 = xi * xi;
        const Pack inverse_to_end = inverse_cube * tau2;
        const Mask far = xi2 > 0.09 + 0.03 * tau2;
        seen = seen * (1.0 - 0.5 * xi2 * (inverse_to_end * inverse_to_end));
        if (any(far)) seen = select(far, line_potential_at(task.tables, tau, xi), seen);
      }
      if (has_near) {
        // Midpoint error of the logarithm over the strip's width: see strip_displacement
        // (contact_condition.cpp), with t^2 = (width / (2 distance))^2.
        const Pack half_width = 0.5 * width * inverse;
        const Pack square = half_width * half_width;
        const Pack t2 = square * (inverse_cube * to_end);
        const Pack correction =
            2.0 * square * inverse_cube * (1.0 / 6.0 + t2 * (1.0 / 20.0 + t2 * (1.0 / 42.0)));
        const Pack apart = magnitude(load_pack(lane_numbers) + (1.0 * first - 1.0 * j));
        seen += select(apart <= Pack(1.0 * near), correction, 0.0);
      }
    }
    store_pack(row + first, width * seen);
  }
}

}  // namespace
}  // namespace wrc::simd
