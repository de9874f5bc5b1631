/// A row of the influence matrix of strips on each other.
#pragma once

#include "normal/simd/line_tables.hpp"

namespace wrc::simd {
namespace {

/// 0, 1, 2, ...: number of a lane.
constexpr double lane_numbers[most_lanes] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

/// NormalKernels::influence_row.
void influence_row_kernel(const InfluenceTask& task, std::int32_t j, double* row) {
  static_assert(lanes <= most_lanes);
  constexpr std::int32_t near = 8;  // strips away: beyond, the correction is below 2e-3 of an entry
  const Pack y_j = task.y[j], centre_j = task.centre[j];
  for (std::int32_t first = 0; first < task.count; first += lanes) {
    const Pack inverse = load_pack(task.inverse_length + first), width = load_pack(task.width + first);
    // J(tau, xi) of each strip, tau and xi over its half length.
    const Pack distance = magnitude(load_pack(task.y + first) - y_j) * inverse;
    const Pack tau = select(distance > 0.0, distance, 1.0);  // the strip itself is the caller's
    const MiddlePlane<Pack> middle = read_middle_plane(task.tables, tau);
    Pack seen = middle.potential;
    if (task.skewed)
      seen = line_potential_near(task.tables, middle,
                                 magnitude(load_pack(task.centre + first) - centre_j) * inverse,
                                 [&] { return line_rows(tau); });
    // The width of near strips.
    if (first - near <= j && j < first + lanes + near) {
      const Pack correction = width_correction(0.5 * width * inverse / tau, middle.inverse_to_end);
      const Pack apart = magnitude(load_pack(lane_numbers) + (1.0 * first - 1.0 * j));
      seen += select(apart <= Pack(1.0 * near), correction, 0.0);
    }
    store_pack(row + first, width * seen);
  }
}

}  // namespace
}  // namespace wrc::simd
