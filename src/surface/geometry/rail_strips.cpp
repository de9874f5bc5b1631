#include "surface/geometry/rail_strips.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "base/number.hpp"

namespace wrc {
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
  double ay, az, by, bz;
  tangent_at(rail, s - looked_over, ay, az);
  tangent_at(rail, s + looked_over, by, bz);
  const double turned = std::abs(ay * bz - az * by) + 1e-9;
  const double radius = 2.0 * looked_over / turned;
  const double t = std::clamp((radius - widths.sharp) / (widths.flat - widths.sharp), 0.0, 1.0);
  const double width = widths.narrowest + t * (widths.widest - widths.narrowest);
  if (!(widths.guiding < widths.widest)) return width;
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

std::int64_t rail_strip_doubles(std::int32_t strips) { return 7 * static_cast<std::int64_t>(strips); }

Fault cut_rail(const Curve& rail, const StripWidths& widths, std::int32_t most, double* memory,
               RailStrips& strips) {
  strips = {};
  double *const s = memory, *const width = s + most, *const y = width + most, *const z = y + most,
                *const ty = z + most, *const tz = ty + most, *const angle = tz + most;
  const double begin = rail.s[0], end = rail.s[rail.pieces];
  const std::int32_t n = cut_length(
      begin, end, [&](double at) { return wanted_width(rail, widths, at); }, most, s, width);
  for (std::int32_t j = 0; j < n; ++j) {
    const std::int32_t k = piece_of(rail, s[j]);
    const CurvePoint p = evaluate(rail, k, s[j] - rail.s[k]);
    y[j] = p.y;
    z[j] = p.z;
    tangent_at(rail, s[j], ty[j], tz[j]);
  }
  strips = {n, s, width, y, z, ty, tz, nullptr, 1, {}};
  for (std::int32_t j = 0; j < n; ++j) angle[j] = strip_angle(strips, j);
  strips.angle = angle;
  strips.range[0] = range_of(strips, 0, n);
  return {};
}

}  // namespace wrc
