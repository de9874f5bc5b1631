/// Overlaps of a wheel in a pose with the strips of a rail: one ray along each strip's normal.
///
/// The rail is a cylinder along x, so only the outline of the wheel seen along x matters: with the wheel's
/// surface of revolution p(sigma, theta) = (r sin(theta), Y, r cos(theta)) over its profile (Y, r)(sigma),
/// the points whose normal (Y' sin(theta), -r', Y' cos(theta)) is perpendicular to x, in closed form with
/// e = R^T x_track:
///     e1 sin(theta) + e3 cos(theta) = e2 r' / Y'.
/// The ray of strip j meets the outline W(sigma) where (W - P_j) . t_j = 0. Its overlap is (W - P_j) . n_j,
/// turned to the mean of the rail's and the wheel's normal; along x it falls like kappa/2 (x - W_x)^2.
///
/// | symbol  | array      | unit | quantity                                                     |
/// |---------|------------|------|--------------------------------------------------------------|
/// | d       | depth      | m    | largest overlap of the strip, along the mean normal          |
/// | W_x     | centre     | m    | x of that place, from the wheel's reference point            |
/// | kappa   | curvature  | 1/m  | of the overlap along x                                       |
/// | n       | ny, nz     | -    | mean normal, into the rail                                   |
/// | W       | wy, wz     | m    | point of the wheel, from its reference point, rail axes      |
/// | n . P'  | grade      | -    | fall of the rail along its normal per distance along track   |
/// | sigma   | piece, u   | -, m | end of the ray on the wheel's curve: piece, length on it     |
#pragma once

#include <cstdint>

#include "base/arena.hpp"
#include "kernels/kernels.hpp"
#include "surface/geometry/curve.hpp"
#include "surface/geometry/rail_strips.hpp"

namespace wrc::surface {

/// A wheel's profile: curve.y from the tape circle, curve.z below the axle: the radius [m]. Its knots, where
/// pieces meet, in whole packs.
struct WheelCurve {
  Curve curve;
  std::int32_t knots = 0;
  std::int32_t flange_tip = 0;                             ///< knot of the largest radius
  const double *knot_y = nullptr, *knot_radius = nullptr;  ///< [m]
  const double* knot_slope = nullptr;                      ///< dr/dy; 1e300 where the face turns back [-]
};

/// Arrays of the knots of a wheel.
struct KnotArrays {
  double *y, *radius, *slope;
};
KnotArrays cut_knots(Arena& arena, std::int32_t most_pieces);

/// The wheel with this profile.
WheelCurve make_wheel_curve(const Curve& curve, const KnotArrays& arrays);

/// A wheel as seen from a rail: rail axes, origin of the rail's profile; x from the wheel's reference point.
template <class Number>
struct RelativePoseOf {
  Number rotation[3][3];  ///< rail = rotation * wheel axes
  Number y, z;            ///< the wheel's reference point [m]
};
using RelativePose = RelativePoseOf<double>;

/// Strips that may be in contact, by increasing arc length, each in its own frame: the table above.
struct Overlaps {
  std::int32_t capacity = 0, count = 0;
  std::int32_t next = 0, end = 0;  ///< strips of the rail that are still to be looked at
  bool full = false;               ///< one of those may overlap, too, for which there was no room
  std::int32_t* strip = nullptr;   ///< number of the rail's strip
  double *depth = nullptr, *centre = nullptr, *curvature = nullptr;
  double *ny = nullptr, *nz = nullptr, *wy = nullptr, *wz = nullptr;
  double* grade = nullptr;  ///< nullptr: zero everywhere
  /// With grades, for derivatives and flags: where along the track the overlap is largest [m]; of a strip
  /// with two tops, where its contact must end, far off for others [m].
  float *top = nullptr, *bound = nullptr;
  std::int32_t* piece = nullptr;  ///< piece of the wheel's curve where the ray ends
  double* u = nullptr;            ///< length on that piece [m]
};

/// Empty overlaps for at most `capacity` strips; `graded`: the rail changes along the track.
Overlaps cut_overlaps(Arena& arena, std::int32_t capacity, bool graded);

/// The overlap of one strip, by the names of Overlaps. Number is double, a pack, or one that carries
/// derivatives.
template <class Number>
struct StripOverlap {
  Number depth, centre, curvature, ny, nz, wy, wz, grade;
};

inline StripOverlap<double> strip_of(const Overlaps& o, std::int32_t i) {
  return {o.depth[i], o.centre[i], o.curvature[i], o.ny[i],
          o.nz[i],    o.wy[i],     o.wz[i],        o.grade ? o.grade[i] : 0.0};
}

inline void put_strip(const StripOverlap<double>& s, std::int32_t i, const Overlaps& o) {
  o.depth[i] = s.depth;
  o.centre[i] = s.centre;
  o.curvature[i] = s.curvature;
  o.ny[i] = s.ny;
  o.nz[i] = s.nz;
  o.wy[i] = s.wy;
  o.wz[i] = s.wz;
  if (o.grade) o.grade[i] = s.grade;
}

/// Outline of the wheel in the last pose, and work arrays of the search.
struct OverlapScratch {
  double *y, *z;        ///< outline at the wheel's knots, rail axes [m]; whole packs
  double* seen;         ///< 1 where the outline exists, else 0
  double* overlap;      ///< first estimate for each strip of the rail [m]
  std::int32_t* piece;  ///< piece of the wheel's curve that each strip's ray crosses
  double* part;         ///< place of the crossing on its chord, 0 to 1
  double* gain;         ///< the most that each strip's overlap grows along the track (find_gains()) [m]
};

/// Scratch for a wheel of so many pieces and a rail of so many strips.
OverlapScratch cut_overlap_scratch(Arena& arena, std::int32_t wheel_pieces, std::int32_t rail_strips);

/// The overlaps from this one on.
Overlaps overlaps_from(const Overlaps& overlaps, std::int32_t first);

/// The outline of the wheel in a pose.
void find_outline(const Kernels& kernels, const RailStrips& rail, const WheelCurve& wheel,
                  const RelativePose& pose, const OverlapScratch& scratch) noexcept;

/// All strips with depth > -margin of a round wheel and a rail that is the same all along, in the arrays of
/// `memory`, whose grade is left alone. `gain`: widens each strip's margin [m]; nullptr: by nothing.
Overlaps find_overlaps(const Kernels& kernels, const RailStrips& rail, const WheelCurve& wheel,
                       const RelativePose& pose, double margin, const double* gain,
                       const OverlapScratch& scratch, const Overlaps& memory) noexcept;

/// Adds strips for which there was no room, to overlaps of which some were left out since. All else as given
/// to find_overlaps() before.
void find_more_overlaps(const Kernels& kernels, const RailStrips& rail, const WheelCurve& wheel,
                        const RelativePose& pose, double margin, const double* gain,
                        const OverlapScratch& scratch, Overlaps& overlaps) noexcept;

}  // namespace wrc::surface
