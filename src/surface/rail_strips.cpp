#include "surface/rail_strips.hpp"

#include <algorithm>
#include <cmath>

#include "elementary.hpp"

namespace wrc {
namespace {

/// The level is smoothed over arc length by a Gaussian of this half width [m]; the tail leads a lone strip to what is
/// next to it.
constexpr double smoothing_length = 0.3e-3, tail_length = 2e-3, tail = 1e-7;
constexpr double smoothing_reach = 6.0;  // smoothing lengths

}  // namespace

std::int32_t most_rail_strips(const Curve& rail, const StripWidths& widths) {
  return static_cast<std::int32_t>((rail.s[rail.pieces] - rail.s[0]) / widths.narrowest) + 2;
}

std::int64_t rail_strip_doubles(std::int32_t strips) {
  const auto reach = static_cast<std::int64_t>(smoothing_reach * smoothing_length / 0.1e-3) + 1;
  return static_cast<std::int64_t>(strips) * (6 + 2 * reach + 1);
}

Fault cut_rail(const Curve& rail, const StripWidths& widths, double* memory, RailStrips& strips) {
  strips = {};
  const std::int32_t most = most_rail_strips(rail, widths);
  double *const s = memory, *const width = s + most, *const y = width + most, *const z = y + most,
                *const ty = z + most, *const tz = ty + most, *const smoothing = tz + most;
  const double length = rail.s[rail.pieces] - rail.s[0];
  const std::int32_t n = std::max(1, static_cast<std::int32_t>(length / widths.narrowest));
  const double w = length / n;
  for (std::int32_t j = 0; j < n; ++j) {
    s[j] = rail.s[0] + (j + 0.5) * w;
    width[j] = w;
    const std::int32_t k = piece_of(rail, s[j]);
    const CurvePoint p = evaluate(rail, k, s[j] - rail.s[k]);
    const double inverse = 1.0 / std::sqrt(p.dy * p.dy + p.dz * p.dz);
    y[j] = p.y;
    z[j] = p.z;
    ty[j] = p.dy * inverse;
    tz[j] = p.dz * inverse;
  }
  const auto reach = static_cast<std::int32_t>(smoothing_reach * smoothing_length / w) + 1;
  for (std::int32_t j = 0; j < n; ++j)
    for (std::int32_t k = -reach; k <= reach; ++k) {
      double weight = 0.0;
      if (j + k >= 0 && j + k < n) {
        const double apart = std::abs(s[j + k] - s[j]);
        const double q = apart / smoothing_length;
        weight = natural_exp(-0.5 * q * q) + tail * natural_exp(-apart / tail_length);
      }
      smoothing[j * (2 * reach + 1) + reach + k] = weight;
    }
  strips = {n, s, width, y, z, ty, tz, reach, smoothing};
  return {};
}

}  // namespace wrc
