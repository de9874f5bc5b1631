/// Where a wheel in a pose overlaps the strips of a rail: one ray along each strip's normal.
///
/// The rail is a cylinder along x, so only the outline of the wheel seen along x matters: with the wheel's
/// surface of revolution p(sigma, theta) = (r sin(theta), Y, r cos(theta)) over its profile (Y, r)(sigma),
/// the points whose normal (Y' sin(theta), -r', Y' cos(theta)) is perpendicular to x, in closed form with
/// e = R^T x_track:
///     e1 sin(theta) + e3 cos(theta) = e2 r' / Y'.
/// The ray of strip j meets the outline W(sigma) where (W - P_j) . t_j = 0. Its overlap is (W - P_j) . n_j,
/// turned to the mean of the rail's and the wheel's normal; along x it falls like kappa/2 (x - W_x)^2.
#pragma once

#include <cstdint>

#include "kernels/kernels.hpp"
#include "surface/geometry/curve.hpp"
#include "surface/geometry/rail_strips.hpp"

namespace wrc {

/// A wheel's profile: curve.y from the tape circle, curve.z below the axle: the radius [m]. Its knots, where
/// pieces meet, in whole packs.
struct WheelCurve {
  Curve curve;
  std::int32_t knots = 0;
  const double *knot_y = nullptr, *knot_radius = nullptr;  ///< [m]
  const double* knot_slope = nullptr;  ///< dr/dy; beyond `steepest` where the face turns back
};

/// Doubles of memory for the knots of a curve with so many pieces.
std::int64_t wheel_knot_doubles(std::int32_t pieces);

/// Fills the knots of wheel.curve.
void find_knots(double* memory, WheelCurve& wheel);

/// A wheel as seen from a rail: rail axes, origin of the rail's profile; x from the wheel's reference point.
template <class Number>
struct RelativePoseOf {
  Number rotation[3][3];  ///< rail = rotation * wheel axes
  Number y, z;            ///< of the wheel's reference point [m]
};
using RelativePose = RelativePoseOf<double>;

/// Strips that may be in contact, by increasing arc length, each in its own frame.
struct Overlaps {
  std::int32_t capacity = 0, count = 0;
  bool full = false;                    ///< there may be more strips than room
  std::int32_t* strip = nullptr;        ///< number of the rail's strip
  double* depth = nullptr;              ///< largest overlap, along the mean normal [m]
  double* centre = nullptr;             ///< x where it is largest, from the wheel's reference point [m]
  double* curvature = nullptr;          ///< kappa [1/m]
  double *ny = nullptr, *nz = nullptr;  ///< mean normal, into the rail, rail axes
  double *wy = nullptr, *wz = nullptr;  ///< the wheel's point, from its reference point, rail axes [m]
  double* lean = nullptr;  ///< how much the rail falls along its normal per distance; nullptr: nowhere [-]
};

/// The overlap of one strip, by the names of Overlaps. Number is double, or one that carries derivatives.
template <class Number>
struct StripOverlap {
  Number depth, centre, curvature, ny, nz, wy, wz, lean;
};

inline StripOverlap<double> strip_of(const Overlaps& o, std::int32_t i) {
  return {o.depth[i], o.centre[i], o.curvature[i], o.ny[i],
          o.nz[i],    o.wy[i],     o.wz[i],        o.lean ? o.lean[i] : 0.0};
}

/// Scratch of a search.
struct OverlapScratch {
  double *y, *z;        ///< of the outline at the wheel's knots, rail axes [m]; whole packs
  double* seen;         ///< 1 where it exists
  double* overlap;      ///< first estimate for each strip of the rail [m]
  std::int32_t* piece;  ///< of the wheel's curve, for each strip
  double* part;         ///< of the piece
  double* along;        ///< where on the piece the ray of each strip that is followed ends [m]
  std::int32_t* strip;  ///< strips whose rays are followed, in whole packs
};

/// Finds all strips with depth > -margin.
void find_overlaps(const Kernels& kernels, const RailStrips& rail, const WheelCurve& wheel,
                   const RelativePose& pose, double margin, const OverlapScratch& scratch,
                   Overlaps& overlaps) noexcept;

}  // namespace wrc
