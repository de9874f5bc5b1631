#include "surface/geometry/curve.hpp"

#include <algorithm>
#include <cmath>

#include "base/natural_spline.hpp"

namespace wrc::surface {
namespace {

constexpr double nearest = 50e-6;         // [m] between points
constexpr double longest_piece = 0.5e-3;  // [m]
constexpr double longest_curve = 0.6;     // [m]: longest profile that is accepted

}  // namespace

std::int32_t piece_of(const Curve& curve, double s) {
  const double* const above = std::upper_bound(curve.s, curve.s + curve.pieces + 1, s);
  return std::clamp(static_cast<std::int32_t>(above - curve.s) - 1, 0, curve.pieces - 1);
}

std::int32_t most_curve_pieces(std::int32_t points) {
  return points + static_cast<std::int32_t>(longest_curve / longest_piece);
}

CurveArrays cut_curve(Arena& arena, std::int32_t points) {
  CurveArrays a;
  a.capacity = most_curve_pieces(points) + 1;
  a.s = arena.take(a.capacity);
  for (double*& c : a.y) c = arena.take(a.capacity);
  for (double*& c : a.z) c = arena.take(a.capacity);
  arena.each(points, a.knot_s, a.knot_y, a.knot_z, a.second_y, a.second_z, a.scratch);
  return a;
}

namespace {

/// Copies the points that lie apart, with the length of chords up to them; returns how many.
std::int32_t take_points(std::int32_t points, const double* y, const double* z, const CurveArrays& a) {
  std::int32_t n = 0;
  for (std::int32_t i = 0; i < points; ++i) {
    // a point nearer than 50 um to the last one kept would make the spline wave
    double step = 0.0;
    if (n > 0) {
      const double dy = y[i] - a.knot_y[n - 1], dz = z[i] - a.knot_z[n - 1];
      step = std::sqrt(dy * dy + dz * dz);
      if (step < nearest) continue;
    }
    a.knot_y[n] = y[i];
    a.knot_z[n] = z[i];
    a.knot_s[n] = n > 0 ? a.knot_s[n - 1] + step : 0.0;
    ++n;
  }
  return n;
}

/// The cubic between knots i and i + 1 of a spline, from its values v and second derivatives m.
struct Cubic {
  double c[4];

  Cubic(const double* v, const double* m, std::int32_t i, double h)
      : c{v[i], (v[i + 1] - v[i]) / h - h * (2.0 * m[i] + m[i + 1]) / 6.0, 0.5 * m[i],
          (m[i + 1] - m[i]) / (6.0 * h)} {}

  /// Writes the coefficients of the same cubic about u as those of piece k.
  void move(double u, double* const (&to)[4], std::int32_t k) const {
    to[0][k] = c[0] + u * (c[1] + u * (c[2] + u * c[3]));
    to[1][k] = c[1] + u * (2.0 * c[2] + 3.0 * u * c[3]);
    to[2][k] = c[2] + 3.0 * u * c[3];
    to[3][k] = c[3];
  }
};

}  // namespace

Fault make_curve(std::int32_t points, const double* y, const double* z, const CurveArrays& a, Curve& curve) {
  curve = {};
  const std::int32_t n = take_points(points, y, z, a);
  if (n < 4)
    return Fault::profile("profile.count", {n, "points"},
                          "fewer than four points that lie further than 50 um apart");
  second_derivatives(n, a.knot_s, a.knot_y, a.second_y, a.scratch);
  second_derivatives(n, a.knot_s, a.knot_z, a.second_z, a.scratch);

  // Each interval between knots becomes as many equal pieces as keep them under the longest, within the
  // capacity: one piece is held back for each interval yet to come.
  std::int32_t k = 0;
  for (std::int32_t i = 0; i + 1 < n; ++i) {
    const double h = a.knot_s[i + 1] - a.knot_s[i];
    const Cubic of_y(a.knot_y, a.second_y, i, h), of_z(a.knot_z, a.second_z, i, h);
    const std::int64_t left = a.capacity - 2 - k - (n - 2 - i);
    const auto wanted = static_cast<std::int64_t>(-std::floor(-h / longest_piece));
    const std::int64_t parts = std::max<std::int64_t>(1, std::min(wanted, left));
    for (std::int64_t p = 0; p < parts; ++p, ++k) {
      const double u = h * static_cast<double>(p) / static_cast<double>(parts);
      a.s[k] = a.knot_s[i] + u;
      of_y.move(u, a.y, k);
      of_z.move(u, a.z, k);
    }
  }
  a.s[k] = a.knot_s[n - 1];
  curve.pieces = k;
  curve.s = a.s;
  std::copy_n(a.y, 4, curve.y);
  std::copy_n(a.z, 4, curve.z);
  return {};
}

}  // namespace wrc::surface
