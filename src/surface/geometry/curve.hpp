/// A plane curve by its length: the cross section of a rail, the profile of a wheel.
///
/// A natural cubic spline for y and z over the chord length through the given points, so that vertical faces
/// are as good as level ones. y to the field side, z down.
#pragma once

#include <cstdint>

#include "base/arena.hpp"
#include "base/fault.hpp"

namespace wrc::surface {

/// View of the pieces; memory is the owner's. Piece k, from length s[k] to s[k + 1], is
///     y = y[0][k] + u (y[1][k] + u (y[2][k] + u y[3][k])),   u = s - s[k],
/// and z alike. There is one more s than pieces.
struct Curve {
  std::int32_t pieces = 0;
  const double* s = nullptr;  ///< [m]
  const double* y[4] = {};
  const double* z[4] = {};
};

/// Place and derivatives by length. The derivative has about length one.
struct CurvePoint {
  double y, z;
  double dy, dz;
  double ddy, ddz;  ///< [1/m]
};

inline CurvePoint evaluate(const Curve& c, std::int32_t k, double u) {
  return {c.y[0][k] + u * (c.y[1][k] + u * (c.y[2][k] + u * c.y[3][k])),
          c.z[0][k] + u * (c.z[1][k] + u * (c.z[2][k] + u * c.z[3][k])),
          c.y[1][k] + u * (2.0 * c.y[2][k] + 3.0 * u * c.y[3][k]),
          c.z[1][k] + u * (2.0 * c.z[2][k] + 3.0 * u * c.z[3][k]),
          2.0 * c.y[2][k] + 6.0 * u * c.y[3][k],
          2.0 * c.z[2][k] + 6.0 * u * c.z[3][k]};
}

/// Piece that holds the length s; the first or last one outside.
std::int32_t piece_of(const Curve& curve, double s);

/// Most pieces a curve through `points` points may get.
std::int32_t most_curve_pieces(std::int32_t points);

/// Arrays of a curve: its pieces, and the points kept with their second derivatives, read while it is made.
struct CurveArrays {
  std::int64_t capacity;                                             ///< elements of s, y and z
  double *s, *y[4], *z[4];                                           ///< over the pieces
  double *knot_s, *knot_y, *knot_z, *second_y, *second_z, *scratch;  ///< over the points
};
CurveArrays cut_curve(Arena& arena, std::int32_t points);

/// The curve through the points, in arrays for as many. Points nearer than 50 um to the one before are left
/// out; pieces longer than 0.5 mm are divided, which changes nothing but how finely they are searched.
/// WRC_ERROR_PROFILE if fewer than four points are left.
Fault make_curve(std::int32_t points, const double* y, const double* z, const CurveArrays& arrays,
                 Curve& curve);

}  // namespace wrc::surface
