#include "surface/geometry/overlap.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "surface/geometry/outline.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::surface {
namespace {

/// Slope of a face that turns back, steeper than the outline in any pose.
constexpr double unseen = 1e300;

}  // namespace

KnotArrays cut_knots(Arena& arena, std::int32_t most_pieces) {
  KnotArrays arrays;
  arena.each(simd::whole_packs(most_pieces + 1), arrays.y, arrays.radius, arrays.slope);
  return arrays;
}

WheelCurve make_wheel_curve(const Curve& curve, const KnotArrays& arrays) {
  const std::int32_t knots = curve.pieces + 1;
  for (std::int64_t i = 0; i < simd::whole_packs(knots); ++i) {
    // Knot i is where piece i begins. The last knot, and the lanes behind it, are the end of the last piece.
    const auto k = static_cast<std::int32_t>(std::min<std::int64_t>(i, curve.pieces - 1));
    const CurvePoint p = evaluate(curve, k, i > k ? curve.s[curve.pieces] - curve.s[k] : 0.0);
    arrays.y[i] = p.y;
    arrays.radius[i] = p.z;
    const double speed = std::sqrt(p.dy * p.dy + p.dz * p.dz);
    arrays.slope[i] = p.dy > least_advance * speed ? p.dz / p.dy : unseen;
  }
  const double* const tip = std::max_element(arrays.radius, arrays.radius + knots);
  return {curve,    knots,         static_cast<std::int32_t>(tip - arrays.radius),
          arrays.y, arrays.radius, arrays.slope};
}

Overlaps cut_overlaps(Arena& arena, std::int32_t capacity, bool graded) {
  Overlaps o;
  o.capacity = capacity;
  arena.each(capacity, o.depth, o.centre, o.curvature, o.ny, o.nz, o.wy, o.wz, o.u);
  arena.each(capacity, o.strip, o.piece);
  if (graded) {
    o.grade = arena.take(capacity);
    arena.each(capacity, o.top, o.bound);
  }
  return o;
}

OverlapScratch cut_overlap_scratch(Arena& arena, std::int32_t wheel_pieces, std::int32_t rail_strips) {
  OverlapScratch scratch;
  arena.each(simd::whole_packs(wheel_pieces + 1), scratch.y, scratch.z, scratch.seen);
  arena.each(rail_strips, scratch.overlap, scratch.part, scratch.gain);
  scratch.piece = arena.take<std::int32_t>(rail_strips);
  return scratch;
}

Overlaps overlaps_from(const Overlaps& o, std::int32_t first) {
  Overlaps rest = o;
  rest.capacity = o.capacity - first;
  for (double** const a : {&rest.depth, &rest.centre, &rest.curvature, &rest.ny, &rest.nz, &rest.wy, &rest.wz,
                           &rest.u, &rest.grade})
    if (*a) *a += first;
  // there on rails that vary alone
  if (rest.top) rest.top += first;
  if (rest.bound) rest.bound += first;
  rest.strip += first;
  rest.piece += first;
  return rest;
}

void find_more_overlaps(const Kernels& kernels, const RailStrips& rail, const WheelCurve& wheel,
                        const RelativePose& pose, double margin, const double* gain,
                        const OverlapScratch& scratch, Overlaps& overlaps) noexcept {
  // Candidates: the overlap up to the outline's chord, which lies at most its sagitta from the curve, passes
  // the margin. Each ray starts where it crosses the chord.
  Overlaps o = overlaps_from(overlaps, overlaps.count);
  std::int32_t count = 0;
  for (; o.next < o.end; ++o.next) {
    const std::int32_t j = o.next;
    const double own = gain ? margin + gain[j] : margin;
    if (!(scratch.overlap[j] >= -own - chord_sagitta)) continue;
    if (count == o.capacity) break;
    o.strip[count] = j;
    o.piece[count] = scratch.piece[j];
    o.u[count++] = scratch.part[j];
  }
  overlaps.next = o.next;
  overlaps.full = o.next < o.end;
  o.count = count;
  if (count == 0) return;
  kernels.surface.follow_rays({&rail, &wheel, &pose, attitude_of(pose), &scratch}, o);

  // Strips stay that overlap by more than -margin on the curve itself. Depth is -1 m where the surfaces do
  // not face each other.
  std::int32_t kept = 0;
  for (std::int32_t i = 0; i < count; ++i) {
    if (!(o.depth[i] > (gain ? -margin - gain[o.strip[i]] : -margin))) continue;
    o.strip[kept] = o.strip[i];
    o.piece[kept] = o.piece[i];
    for (double* const a : {o.depth, o.centre, o.curvature, o.ny, o.nz, o.wy, o.wz, o.u}) a[kept] = a[i];
    ++kept;
  }
  overlaps.count += kept;
}

void find_outline(const Kernels& kernels, const RailStrips& rail, const WheelCurve& wheel,
                  const RelativePose& pose, const OverlapScratch& scratch) noexcept {
  kernels.surface.outline({&rail, &wheel, &pose, attitude_of(pose), &scratch});
}

Overlaps find_overlaps(const Kernels& kernels, const RailStrips& rail, const WheelCurve& wheel,
                       const RelativePose& pose, double margin, const double* gain,
                       const OverlapScratch& scratch, const Overlaps& memory) noexcept {
  const simd::OutlineTask task{&rail, &wheel, &pose, attitude_of(pose), &scratch};
  kernels.surface.outline(task);
  Overlaps o = memory;
  o.count = 0;
  // rays of a range are crossed as far above it as its strips may gain
  double widest[most_rail_faces];
  for (std::int32_t r = 0; r < rail.ranges; ++r) {
    const FaceStrips& range = rail.range[r];
    widest[r] = margin;
    for (std::int32_t k = range.first; gain && k < range.first + range.count; ++k)
      widest[r] = larger(widest[r], margin + gain[k]);
  }
  kernels.surface.cross_rays(task, widest, o.next, o.end);
  find_more_overlaps(kernels, rail, wheel, pose, margin, gain, scratch, o);
  return o;
}

}  // namespace wrc::surface
