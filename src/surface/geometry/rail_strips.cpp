#include "surface/geometry/rail_strips.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "base/number.hpp"

namespace wrc::surface {
namespace {

/// Curvature is looked at over this length to both sides: roughness of measured points must not show in the
/// widths.
constexpr double looked_over = 3e-3;

/// Unit tangent at a length, held at the curve's ends.
void tangent_at(const Curve& rail, double s, double& ty, double& tz) {
  const double inside = std::clamp(s, rail.s[0], rail.s[rail.pieces]);
  const std::int32_t k = piece_of(rail, inside);
  const CurvePoint p = evaluate(rail, k, inside - rail.s[k]);
  const double inverse = 1.0 / std::sqrt(p.dy * p.dy + p.dz * p.dz);
  ty = p.dy * inverse;
  tz = p.dz * inverse;
}

}  // namespace

double wanted_width(const Curve& rail, const StripWidths& widths, double s) {
  // mean radius over 6 mm of arc, from the angle the tangent turns by; the width is linear in it
  double ay, az, by, bz;
  tangent_at(rail, s - looked_over, ay, az);
  tangent_at(rail, s + looked_over, by, bz);
  const double turned = std::abs(ay * bz - az * by) + 1e-9;
  const double radius = 2.0 * looked_over / turned;
  const double t = std::clamp((radius - widths.sharp) / (widths.flat - widths.sharp), 0.0, 1.0);
  const double width = widths.narrowest + t * (widths.widest - widths.narrowest);
  if (!(widths.guiding < widths.widest)) return width;
  // on faces that guide, narrower from a slope of 64 degrees on
  double ty, tz;
  tangent_at(rail, s, ty, tz);
  constexpr double begins = 0.90, holds = 0.97;  // sines
  const double steep = std::clamp((tz - begins) / (holds - begins), 0.0, 1.0);
  return smaller(width, widths.widest + steep * (widths.guiding - widths.widest));
}

double strip_angle(const RailStrips& strips, std::int32_t strip) {
  if (strips.angle) return strips.angle[strip];
  // the half angle's tangent: right for faces beyond the vertical too
  const double ty = strips.ty[strip], tz = strips.tz[strip];
  return 2.0 * arctangent(tz / (1.0 + ty + 1e-300));
}

FaceStrips range_of(const RailStrips& strips, std::int32_t first, std::int32_t count) {
  FaceStrips range{first, count, strips.z[first], strips.y[first], strips.y[first]};
  for (std::int32_t j = first + 1; j < first + count; ++j) {
    range.top = smaller(range.top, strips.z[j]);
    range.leftmost = smaller(range.leftmost, strips.y[j]);
    range.rightmost = larger(range.rightmost, strips.y[j]);
  }
  return range;
}

StripArrays cut_strips(Arena& arena, std::int32_t most) {
  StripArrays a;
  arena.each(most, a.s, a.width, a.y, a.z, a.ty, a.tz, a.angle);
  return a;
}

StripArrays cut_varying_strips(Arena& arena, std::int32_t most) {
  StripArrays a;
  arena.each(most, a.s, a.width, a.y, a.z, a.ty, a.tz);
  a.angle = nullptr;
  return a;
}

CandidatesAlong cut_candidates(Arena& arena, std::int32_t most) {
  CandidatesAlong candidates;
  candidates.capacity = most;
  candidates.top = arena.take<CandidateAlong>(most);
  return candidates;
}

RailStrips cut_rail(const Curve& rail, const StripWidths& widths, std::int32_t most, const StripArrays& a) {
  const double begin = rail.s[0], end = rail.s[rail.pieces];
  const std::int32_t n = cut_length(
      begin, end, [&](double at) { return wanted_width(rail, widths, at); }, most, a.s, a.width);
  // place and unit tangent in the middle of each strip
  for (std::int32_t j = 0; j < n; ++j) {
    const std::int32_t k = piece_of(rail, a.s[j]);
    const CurvePoint p = evaluate(rail, k, a.s[j] - rail.s[k]);
    a.y[j] = p.y;
    a.z[j] = p.z;
    tangent_at(rail, a.s[j], a.ty[j], a.tz[j]);
  }
  RailStrips strips{n, a.s, a.width, a.y, a.z, a.ty, a.tz, nullptr, 1, {}};
  for (std::int32_t j = 0; j < n; ++j) a.angle[j] = strip_angle(strips, j);
  strips.angle = a.angle;
  strips.range[0] = range_of(strips, 0, n);
  return strips;
}

}  // namespace wrc::surface
