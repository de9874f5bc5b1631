#include "surface/geometry/curve.hpp"

#include <algorithm>
#include <cmath>

#include "base/natural_spline.hpp"

namespace wrc {
namespace {

constexpr double nearest = 50e-6;         // [m] between points
constexpr double longest_piece = 0.5e-3;  // [m]
constexpr double longest_curve = 0.6;     // [m]: of a profile's points, by what profiles may be

}  // namespace

std::int32_t piece_of(const Curve& curve, double s) {
  const double* const above = std::upper_bound(curve.s, curve.s + curve.pieces + 1, s);
  return std::clamp(static_cast<std::int32_t>(above - curve.s) - 1, 0, curve.pieces - 1);
}

std::int32_t most_curve_pieces(std::int32_t points) {
  return points + static_cast<std::int32_t>(longest_curve / longest_piece);
}

std::int64_t curve_doubles(std::int32_t points) {
  return 9 * static_cast<std::int64_t>(most_curve_pieces(points) + 1) + 6 * static_cast<std::int64_t>(points);
}

Fault make_curve(std::int32_t points, const double* y, const double* z, double* memory, Curve& curve) {
  curve = {};
  double *const ky = memory, *const kz = ky + points, *const ks = kz + points, *const my = ks + points,
                *const mz = my + points, *const scratch = mz + points;
  std::int32_t n = 0;
  for (std::int32_t i = 0; i < points; ++i) {
    double step = 0.0;
    if (n > 0) {
      const double dy = y[i] - ky[n - 1], dz = z[i] - kz[n - 1];
      step = std::sqrt(dy * dy + dz * dz);
      if (step < nearest) continue;
    }
    ky[n] = y[i];
    kz[n] = z[i];
    ks[n] = n > 0 ? ks[n - 1] + step : 0.0;
    ++n;
  }
  if (n < 4)
    return Fault::profile("profile.count", {n, "points"},
                          "fewer than four points that lie further than 50 um apart");
  second_derivatives(n, ks, ky, my, scratch);
  second_derivatives(n, ks, kz, mz, scratch);

  const std::int64_t capacity = most_curve_pieces(points) + 1;
  double* at = memory + 6 * static_cast<std::int64_t>(points);
  double* const s = at;
  double *cy[4], *cz[4];
  for (double*& c : cy) c = at += capacity;
  for (double*& c : cz) c = at += capacity;
  std::int32_t k = 0;
  for (std::int32_t i = 0; i + 1 < n; ++i) {
    const double h = ks[i + 1] - ks[i];
    const double by[4] = {ky[i], (ky[i + 1] - ky[i]) / h - h * (2.0 * my[i] + my[i + 1]) / 6.0, 0.5 * my[i],
                          (my[i + 1] - my[i]) / (6.0 * h)};
    const double bz[4] = {kz[i], (kz[i + 1] - kz[i]) / h - h * (2.0 * mz[i] + mz[i + 1]) / 6.0, 0.5 * mz[i],
                          (mz[i + 1] - mz[i]) / (6.0 * h)};
    const std::int64_t room = capacity - 2 - k - (n - 2 - i);  // one piece for each interval yet to come
    const auto wanted = static_cast<std::int64_t>(-std::floor(-h / longest_piece));
    const std::int64_t parts = std::max<std::int64_t>(1, std::min(wanted, room));
    for (std::int64_t p = 0; p < parts; ++p, ++k) {
      const double u = h * static_cast<double>(p) / static_cast<double>(parts);
      s[k] = ks[i] + u;
      const auto move = [u](const double(&b)[4], double* const(&c)[4], std::int32_t to) {
        c[0][to] = b[0] + u * (b[1] + u * (b[2] + u * b[3]));
        c[1][to] = b[1] + u * (2.0 * b[2] + 3.0 * u * b[3]);
        c[2][to] = b[2] + 3.0 * u * b[3];
        c[3][to] = b[3];
      };
      move(by, cy, k);
      move(bz, cz, k);
    }
  }
  s[k] = ks[n - 1];
  curve.pieces = k;
  curve.s = s;
  for (int d = 0; d < 4; ++d) {
    curve.y[d] = cy[d];
    curve.z[d] = cz[d];
  }
  return {};
}

}  // namespace wrc
