#include "surface/rail_strips.hpp"

#include <algorithm>
#include <cmath>

#include "elementary.hpp"

namespace wrc {
namespace {

/// The level is smoothed over arc length by a Gaussian of this half width [m], cut off `reach` of it away; the tail
/// leads a lone strip to what is next to it.
constexpr double smoothing_length = 0.3e-3, tail_length = 2e-3, tail = 1e-7, smoothing_reach = 6.0;
constexpr std::int32_t most_reach = 10;  // strips

/// Curvature is looked at over this length to both sides: roughness of measured points must not show in the widths.
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

/// Width wanted at a length [m].
double width_at(const Curve& rail, const StripWidths& widths, double s) {
  double ay, az, by, bz;
  tangent_at(rail, s - looked_over, ay, az);
  tangent_at(rail, s + looked_over, by, bz);
  const double turned = std::abs(ay * bz - az * by) + 1e-9;
  const double radius = 2.0 * looked_over / turned;
  const double t = std::clamp((radius - widths.sharp) / (widths.flat - widths.sharp), 0.0, 1.0);
  return widths.narrowest + t * (widths.widest - widths.narrowest);
}

}  // namespace

std::int64_t rail_strip_doubles(std::int32_t strips) {
  return static_cast<std::int64_t>(strips) * (6 + 2 * most_reach + 1);
}

Fault cut_rail(const Curve& rail, const StripWidths& widths, std::int32_t most, double* memory, RailStrips& strips) {
  strips = {};
  double *const s = memory, *const width = s + most, *const y = width + most, *const z = y + most,
                *const ty = z + most, *const tz = ty + most, *const smoothing = tz + most;
  const double begin = rail.s[0], end = rail.s[rail.pieces];
  // The widths wanted, added up along the curve: so many strips as that gives, all scaled alike to end where it ends.
  const auto count_from = [&](double scale) {
    double at = begin;
    std::int32_t n = 0;
    while (at < end && n <= most) {
      const double w = scale * width_at(rail, widths, at);
      at += scale * width_at(rail, widths, at + 0.5 * w);
      ++n;
    }
    return n;
  };
  double scale = 1.0;
  while (count_from(scale) > most - 1) scale *= 1.1;
  double at = begin;
  std::int32_t n = 0;
  while (at < end && n < most) {
    const double guess = scale * width_at(rail, widths, at);
    double w = scale * width_at(rail, widths, at + 0.5 * guess);
    if (at + 1.5 * w > end) w = end - at;
    width[n] = w;
    s[n] = at + 0.5 * w;
    const std::int32_t k = piece_of(rail, s[n]);
    const CurvePoint p = evaluate(rail, k, s[n] - rail.s[k]);
    y[n] = p.y;
    z[n] = p.z;
    tangent_at(rail, s[n], ty[n], tz[n]);
    at += w;
    ++n;
  }
  double narrowest = width[0];
  for (std::int32_t j = 1; j < n; ++j) narrowest = std::min(narrowest, width[j]);
  const std::int32_t reach =
      std::min(most_reach, static_cast<std::int32_t>(smoothing_reach * smoothing_length / narrowest) + 1);
  for (std::int32_t j = 0; j < n; ++j)
    for (std::int32_t k = -reach; k <= reach; ++k) {
      double weight = 0.0;
      if (j + k >= 0 && j + k < n) {
        const double apart = std::abs(s[j + k] - s[j]);
        const double q = apart / smoothing_length;
        weight = width[j + k] * (natural_exp(-0.5 * q * q) + tail * natural_exp(-apart / tail_length));
      }
      smoothing[j * (2 * reach + 1) + reach + k] = weight;
    }
  strips = {n, s, width, y, z, ty, tz, reach, smoothing};
  return {};
}

}  // namespace wrc
