/// A row of the differentiated equations of the pressures (surface/pressure/pressure_jacobian.hpp): one
/// source per lane for the row, one direction per lane for the sums, which run in the order of the sources.
#pragma once

#include "base/pack.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// SurfaceKernels::slopes_row.
inline void slopes_row_kernel(const SlopesRowTask& task) {
  constexpr std::int32_t directions = SlopesRowTask::directions;
  constexpr std::int32_t vectors = (SlopesRowTask::used + native_lanes - 1) / native_lanes;
  const std::int32_t n = task.count;
  // Derivatives of u = sum of J q cos: by q, by L through l, and by the centre, the opposite of that by x.
  for (std::int32_t first = 0; first < n; first += lanes) {
    const std::int32_t count = n - first < lanes ? n - first : lanes;
    const Pack cosine =
        task.ny * load_pack(task.source_ny + first) + task.nz * load_pack(task.source_nz + first);
    const Pack q = load(task.line_load, first, count, 0.0), q_dl_dL = load(task.q_dl_dL, first, count, 0.0);
    double* const row = task.row + first;
    store(load_pack(task.seen.value + first) * cosine, row, count);
    store(load_pack(task.seen.by_length + first) * cosine * q_dl_dL, row + n, count);
    store(-(load_pack(task.seen.by_x + first) * cosine * q), row + 2 * n, count);
  }
  // sums of q J times each element of the directions and of their derivatives by the inputs; sums of q dJ/dx
  // times the directions alone, the first two numbers
  constexpr std::int32_t alone = (2 + native_lanes - 1) / native_lanes;
  Native sum[vectors], by_x[alone];
  for (Native& each : sum) each = broadcast(0.0);
  for (Native& each : by_x) each = broadcast(0.0);
  for (std::int32_t b = 0; b < n; ++b) {
    const Native weight = broadcast(task.line_load[b] * task.seen.value[b]);
    const Native slope = broadcast(task.line_load[b] * task.seen.by_x[b]);
    const double* const direction = task.direction + b * directions;
    for (std::int32_t k = 0; k < vectors; ++k) {
      const Native of_source = load_lanes(direction + k * native_lanes);
      sum[k] = sum[k] + weight * of_source;
      if (k < alone) by_x[k] = by_x[k] + slope * of_source;
    }
  }
  for (std::int32_t k = 0; k < vectors; ++k) store_lanes(task.sum + k * native_lanes, sum[k]);
  for (std::int32_t k = 0; k < alone; ++k) store_lanes(task.sum + directions + k * native_lanes, by_x[k]);
}

}  // namespace
}  // namespace wrc::simd
