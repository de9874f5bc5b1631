/// Lines of least squares through values of neighbouring strips, read at strips
/// (surface/pressure/smoothing.hpp).
#pragma once

#include "base/number.hpp"
#include "base/pack.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// SurfaceKernels::near_lines: one strip per lane, its sums in the order of the sources.
inline void near_lines_kernel(const NearLinesTask& task) {
  for (std::int32_t first = 0; first < task.count; first += lanes) {
    // Sources within reach of any of these strips, as places increase: others would add zeros.
    const std::int32_t last = (first + lanes < task.count ? first + lanes : task.count) - 1;
    double farthest = task.inverse_reach[first];  // one over the longest reach [1/m]
    for (std::int32_t i = first + 1; i <= last; ++i) farthest = wrc::smaller(farthest, task.inverse_reach[i]);
    std::int32_t from = 0;
    while (from < task.sources && (task.place[first] - task.source_place[from]) * farthest >= 1.0) ++from;
    const Pack place = load_pack(task.place + first), inverse = load_pack(task.inverse_reach + first);
    // Moments of the sources within reach; beyond it `near` is 0.
    Pack weights = 0.0, y1 = 0.0, y2 = 0.0, v = 0.0, yv = 0.0;
    for (std::int32_t b = from; b < task.sources; ++b) {
      if ((task.source_place[b] - task.place[last]) * farthest >= 1.0) break;
      const Pack y = (task.source_place[b] - place) * inverse;
      const Pack near = larger(1.0 - y * y, 0.0);
      const Pack weight = near * near * near * task.weight[b], of_y = weight * y;
      weights += weight;
      y1 += of_y;
      y2 += of_y * y;
      v += weight * task.value[b];
      yv += of_y * task.value[b];
    }
    // The line at y = 0: <v> - <y> slope. Strips with no source within reach have 0 for all moments.
    const Pack per = 1.0 / select(weights > 0.0, weights, 1.0);
    const Pack mean_y = y1 * per, mean = v * per;
    const Pack spread = y2 * per - mean_y * mean_y + task.least_spread;
    const Pack at = mean - mean_y * (yv * per - mean_y * mean) / spread;
    store_lanes(task.at + first, at.a);
    store_lanes(task.at + first + native_lanes, at.b);
  }
}

}  // namespace
}  // namespace wrc::simd
