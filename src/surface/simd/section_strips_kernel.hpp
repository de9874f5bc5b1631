/// Strips of a rail between two sections (surface/geometry/varying_rail.hpp).
#pragma once

#include "base/pack.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::simd {
namespace {

/// SurfaceKernels::section_strips.
inline void section_strips_kernel(const SectionStripsTask& task) {
  for (std::int32_t first = 0; first < task.count; first += lanes) {
    const std::int32_t count = task.count - first < lanes ? task.count - first : lanes;
    struct List {
      Pack left, right, left_slope, right_slope;
    };
    const auto list = [&](std::int32_t q) {  // lanes behind the last: ones, that do not change
      const std::int64_t at = q * task.stride, slope = (q + 4) * task.stride;
      return List{load(task.left + at, first, count, 1.0), load(task.right + at, first, count, 1.0),
                  load(task.left + slope, first, count, 0.0), load(task.right + slope, first, count, 0.0)};
    };
    const auto blend = [&](const List& l, std::int32_t derivative) {
      const double* const w = task.weight[derivative];
      return w[0] * l.left + w[1] * l.right + w[2] * l.left_slope + w[3] * l.right_slope;
    };
    // P(u, X), and the unit tangent and stretch from P'(u, X)
    const List y = list(0), z = list(1);
    const Pack dy = blend(list(2), 0), dz = blend(list(3), 0);
    const Pack length = root(dy * dy + dz * dz), per = 1.0 / length;
    const Pack ty = dy * per, tz = dz * per;
    store(blend(y, 0), task.y + first, count);
    store(blend(z, 0), task.z + first, count);
    store(ty, task.ty + first, count);
    store(tz, task.tz + first, count);
    store(length * load(task.step, first, count, 1.0), task.width + first, count);
  }
}

}  // namespace
}  // namespace wrc::simd
