#include "surface/geometry/overlap.hpp"

#include <algorithm>
#include <cmath>

#include "surface/geometry/outline.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc {
namespace {

/// A slope no pose sees.
constexpr double unseen = 1e300;

}  // namespace

std::int64_t wheel_knot_doubles(std::int32_t pieces) { return 3 * simd::whole_packs(pieces + 1); }

void find_knots(double* memory, WheelCurve& wheel) {
  const Curve& curve = wheel.curve;
  wheel.knots = curve.pieces + 1;
  const std::int64_t padded = simd::whole_packs(wheel.knots);
  double *const y = memory, *const radius = y + padded, *const slope = radius + padded;
  for (std::int64_t i = 0; i < padded; ++i) {
    const auto k = static_cast<std::int32_t>(std::min<std::int64_t>(i, curve.pieces - 1));
    const CurvePoint p = evaluate(curve, k, i > k ? curve.s[curve.pieces] - curve.s[k] : 0.0);
    y[i] = p.y;
    radius[i] = p.z;
    const double speed = std::sqrt(p.dy * p.dy + p.dz * p.dz);
    slope[i] = p.dy > least_advance * speed ? p.dz / p.dy : unseen;
  }
  wheel.knot_y = y;
  wheel.knot_radius = radius;
  wheel.knot_slope = slope;
}

void find_overlaps(const Kernels& kernels, const RailStrips& rail, const WheelCurve& wheel,
                   const RelativePose& pose, double margin, const OverlapScratch& scratch,
                   Overlaps& overlaps) noexcept {
  const simd::OutlineTask task{&rail, &wheel, &pose, attitude_of(pose), &scratch};
  kernels.surface.outline(task);
  std::int32_t count = 0, j = 0, end = 0;
  kernels.surface.cross_rays(task, margin, j, end);
  for (; j < end && count < overlaps.capacity; ++j)
    if (scratch.overlap[j] >= -margin - chord_sagitta) scratch.strip[count++] = j;
  overlaps.full = count == overlaps.capacity && j < rail.count;
  overlaps.count = count;
  if (count == 0) return;
  kernels.surface.follow_rays(task, overlaps);
  // those that overlap, and whose surfaces face each other
  std::int32_t kept = 0;
  for (std::int32_t i = 0; i < count; ++i) {
    if (!(overlaps.depth[i] > -margin)) continue;
    overlaps.strip[kept] = scratch.strip[i];
    for (double* const a : {overlaps.depth, overlaps.centre, overlaps.curvature, overlaps.ny, overlaps.nz,
                            overlaps.wy, overlaps.wz})
      a[kept] = a[i];
    ++kept;
  }
  overlaps.count = kept;
}

}  // namespace wrc
