/// A row of the differentiated equations of the pressures (surface/pressure/pressure_jacobian.hpp): one
/// source per lane.
#pragma once

#include "base/eight_parts.hpp"
#include "base/pack.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// SurfaceKernels::slopes_row.
inline void slopes_row_kernel(const SlopesRowTask& task) {
  constexpr std::int32_t inputs = SlopesRowTask::inputs;
  const std::int32_t n = task.count;
  const Native ny = broadcast(task.ny), nz = broadcast(task.nz);
  EightParts value = no_parts(), by_x = no_parts(), by_own = no_parts(), turned[inputs];
  for (EightParts& each : turned) each = no_parts();
  // Derivatives of u = sum of J q cos: by q, by L through l, and by the centre, the opposite of that by x. A
  // source that turns by an angle changes cos by it times the sine between the directions, the point by the
  // opposite.
  for_eight_parts(n, [&](std::int32_t k, std::int32_t at, auto some) {
    const Native y = load_lanes(task.source_ny + at), z = load_lanes(task.source_nz + at);
    const Native q = load_lanes(task.line_load + at), J = load_lanes(task.seen.value + at);
    const Native cosine = ny * y + nz * z, sine = nz * y - ny * z;
    const Native by_q = J * cosine, x = load_lanes(task.seen.by_x + at) * cosine * q;
    const Native by_L = load_lanes(task.seen.by_length + at) * cosine * load_lanes(task.q_dl_dL + at);
    some.store(task.row + at, by_q);
    some.store(task.row + n + at, by_L);
    some.store(task.row + 2 * n + at, -x);
    value.of[k] = value.of[k] + by_q * q;
    by_x.of[k] = by_x.of[k] + x;
    const Native turning = J * q * sine;
    by_own.of[k] = by_own.of[k] - turning;
    for (std::int32_t input = 0; input < inputs; ++input)
      turned[input].of[k] = turned[input].of[k] + turning * load_lanes(task.turned[input] + at);
  });
  // sums over all sources
  SlopesRowTask::Sums& sums = *task.sums;
  sums.value = value.sum();
  sums.by_x = by_x.sum();
  sums.by_own = by_own.sum();
  for (std::int32_t input = 0; input < inputs; ++input) sums.turned[input] = turned[input].sum();
}

}  // namespace
}  // namespace wrc::simd
