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

/// Follows the outline from knot to knot: each ray that is crossed less than `margin` above the rail gets an
/// estimate; the deepest crossing counts. Stretches of the outline further above the rail's top or beside it
/// than that, and than wheels are pressed into rails, are passed over. Leaves the first and the last strip
/// with an estimate in `begin` and `end`.
void cross_rays(const RailStrips& rail, std::int32_t knots, double margin, const OverlapScratch& scratch,
                std::int32_t& begin, std::int32_t& end_of_all) {
  constexpr double nowhere = -1.0;     // [m]
  constexpr double rounding = 1e-9;    // [m]
  constexpr double pressed_in = 4e-3;  // [m]: deeper than any overlap that is solved, and a piece's length
  std::fill_n(scratch.overlap, rail.count, nowhere);
  begin = rail.count;
  end_of_all = 0;
  const double least = -margin - sagitta - rounding;
  const auto along = [&](std::int32_t j, double y, double z) {
    return (y - rail.y[j]) * rail.ty[j] + (z - rail.z[j]) * rail.tz[j];
  };
  const auto below = [&](std::int32_t j, double y, double z) {
    return (z - rail.z[j]) * rail.ty[j] - (y - rail.y[j]) * rail.tz[j];
  };
  for (std::int32_t r = 0; r < rail.ranges; ++r) {
    const StripRange& range = rail.range[r];
    const std::int32_t first = range.first, end = first + range.count;
    const double top = range.top + least, beside = larger(-least, pressed_in);
    const double left = range.leftmost - beside, right = range.rightmost + beside;
    std::int32_t last = first - 1;  // strips up to this one have their rays behind the knot
    // moves on to a knot; `cross` is handed the strips whose rays are passed
    const auto go_to = [&](std::int32_t k, const auto& cross) {
      const double y = scratch.y[k], z = scratch.z[k];
      while (last + 1 < end && along(last + 1, y, z) > 0.0) cross(++last);
      while (last >= first && along(last, y, z) <= 0.0) cross(last--);
    };
    bool near_before = false, passed_over = false;
    for (std::int32_t k = 0; k < knots; ++k) {
      const double y = scratch.y[k], z = scratch.z[k];
      const bool near = z >= top && y >= left && y <= right;
      if (!near && !near_before) {
        passed_over = true;
        continue;
      }
      near_before = near;
      if (passed_over) go_to(k - 1, [](std::int32_t) {});
      passed_over = false;
      if (k == 0 || !(scratch.seen[k] > 0.0 && scratch.seen[k - 1] > 0.0)) {
        go_to(k, [](std::int32_t) {});
        continue;
      }
      const double y_before = scratch.y[k - 1], z_before = scratch.z[k - 1];
      go_to(k, [&](std::int32_t j) {
        if (larger(below(j, y_before, z_before), below(j, y, z)) < least) return;
        const double from = along(j, y_before, z_before), to = along(j, y, z);
        const double t = from == to ? 0.5 : smaller(larger(from / (from - to), 0.0), 1.0);
        const double py = y_before + t * (y - y_before) - rail.y[j],
                     pz = z_before + t * (z - z_before) - rail.z[j];
        const double overlap = pz * rail.ty[j] - py * rail.tz[j];
        if (overlap <= scratch.overlap[j]) return;
        scratch.overlap[j] = overlap;
        scratch.piece[j] = k - 1;
        scratch.part[j] = t;
        begin = std::min(begin, j);
        end_of_all = std::max(end_of_all, j + 1);
      });
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
  std::int32_t count = 0, j = 0, end = 0;
  cross_rays(rail, wheel.knots, margin, scratch, j, end);
  for (; j < end && count < overlaps.capacity; ++j)
    if (scratch.overlap[j] >= -margin - sagitta) scratch.strip[count++] = j;
  overlaps.full = count == overlaps.capacity && j < rail.count;
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
