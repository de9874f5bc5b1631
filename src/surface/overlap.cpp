#include "surface/overlap.hpp"

#include <algorithm>
#include <cmath>

#include "surface/outline.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc {
namespace {

/// A slope no pose sees.
constexpr double unseen = 1e300;

/// A chord of the outline between two knots lies at most this far from it [m].
constexpr double sagitta = 30e-6;

/// Follows the outline from knot to knot: each ray that is crossed gets an estimate; the deepest crossing
/// counts.
void cross_rays(const RailStrips& rail, std::int32_t knots, const OverlapScratch& scratch) {
  constexpr double nowhere = -1.0;  // [m]
  std::fill_n(scratch.overlap, rail.count, nowhere);
  const auto along = [&](std::int32_t j, double y, double z) {
    return (y - rail.y[j]) * rail.ty[j] + (z - rail.z[j]) * rail.tz[j];
  };
  for (std::int32_t r = 0; r < rail.ranges; ++r) {
    const std::int32_t first = rail.range[r].first, end = first + rail.range[r].count;
    std::int32_t last = first - 1;  // strips up to this one have their rays behind the knot
    for (std::int32_t k = 0; k < knots; ++k) {
      const double y = scratch.y[k], z = scratch.z[k];
      const bool seen = k > 0 && scratch.seen[k] > 0.0 && scratch.seen[k - 1] > 0.0;
      const auto cross = [&](std::int32_t j) {
        if (!seen) return;
        const double y_before = scratch.y[k - 1], z_before = scratch.z[k - 1];
        const double from = along(j, y_before, z_before), to = along(j, y, z);
        const double t = from == to ? 0.5 : smaller(larger(from / (from - to), 0.0), 1.0);
        const double py = y_before + t * (y - y_before) - rail.y[j],
                     pz = z_before + t * (z - z_before) - rail.z[j];
        const double overlap = pz * rail.ty[j] - py * rail.tz[j];
        if (overlap <= scratch.overlap[j]) return;
        scratch.overlap[j] = overlap;
        scratch.piece[j] = k - 1;
        scratch.part[j] = t;
      };
      while (last + 1 < end && along(last + 1, y, z) > 0.0) cross(++last);
      while (last >= first && along(last, y, z) <= 0.0) cross(last--);
    }
  }
}

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
  kernels.outline(task);
  cross_rays(rail, wheel.knots, scratch);
  std::int32_t count = 0;
  std::int32_t j = 0;
  for (; j < rail.count && count < overlaps.capacity; ++j)
    if (scratch.overlap[j] >= -margin - sagitta) scratch.strip[count++] = j;
  overlaps.full = j < rail.count;
  overlaps.count = count;
  if (count == 0) return;
  kernels.follow_rays(task, overlaps);
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
