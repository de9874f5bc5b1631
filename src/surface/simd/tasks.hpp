/// Numbers that cross between contact on the rail's surface and the kernels of an instruction set: plain
/// data, no constructors.
#pragma once

#include <cstdint>

#include "base/dual.hpp"
#include "normal/simd/tasks.hpp"
#include "surface/geometry/outline.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc::surface {

struct PlacedRail;
struct RailFace;
struct VaryingRail;
template <class Number>
struct SurfaceRollingInputOf;
template <class Number>
struct RollingArraysOf;
namespace strip_numbers {
struct Shared;
}

}  // namespace wrc::surface

namespace wrc::simd {

/// Strips that press, seen by points of the surface. Arrays have whole packs of elements, those behind the
/// last with factor 0 and inverse_length 0, in `faces` 0.
struct SurfaceSources {
  std::int32_t count;
  const double* place;           ///< arc length of the middle [m]
  const double* centre;          ///< x of the middle [m]
  const double* inverse_length;  ///< 1 / l [1/m]
  const double* half_width;      ///< half the width over l [-]
  const double* factor;          ///< on the influence J: C w / l [1/Pa], or times q [m]
};

/// How the strips of the sources lie on the surface.
struct SurfaceFaces {
  const double* width;    ///< [m]
  const double *ny, *nz;  ///< directions
};

/// Tables of the influence function (normal/elasticity/influence_tables.hpp).
struct SurfaceTables {
  StripTables line;
  const double* own_middle;
};

/// A point of the surface that sees the sources.
struct SurfacePoint {
  double place, x;
};

/// Middles of several strips, and their directions: an even number of elements, also if `count` is odd.
struct SurfacePoints {
  std::int32_t count;
  const double *place, *x, *ny, *nz;
};

/// Edges of the sources themselves, x = centre +- half length, and the displacements there. Whole packs.
struct SurfaceEdges {
  const double* half_length;   ///< [m]
  double *leading, *trailing;  ///< results [m]; trailing nullptr: not wanted
};

/// Displacement of a point by each source of unit q, without the cosine between their directions [1/Pa], and
/// its derivatives by the source's half length, factor included, and by the point's x. Whole packs.
struct SurfaceSlopes {
  double *value, *by_length, *by_x;
};

/// Derivatives of a point's displacement u = sum of J q (n . n_source) by the sources' q, L and centres, and
/// sums over the sources, whose directions turn as the inputs change. Arrays of sources have whole packs.
struct SlopesRowTask {
  static constexpr std::int32_t inputs = 4;

  std::int32_t count;
  SurfaceSlopes seen;
  double ny, nz;  ///< the point's direction
  const double *source_ny, *source_nz;
  const double *line_load, *q_dl_dL;  ///< each source: q [N/m], q dl/dL [Pa]
  const double* turned[inputs];       ///< angle by which each source turns, by each input
  double* row;                        ///< by q, by L and by centre, `count` of each
  struct Sums {
    double value, by_x;     ///< u [m], and its derivative by the point's x [-]
    double by_own;          ///< by the angle by which the point's direction turns [m]
    double turned[inputs];  ///< by the inputs, as the sources turn
  } * sums;
};

/// to = sum of share_i row_i; columns: whole groups of eight.
struct BlendRowsTask {
  std::int32_t count;
  std::int64_t columns;
  const double* share;
  const double* const* row;
  double* to;
};

/// Values at strips, of the line through those of the sources within reach: least squares with weights (1 -
/// y^2)^3 times the sources' own, y the distance over the reach. 0 where none is within reach. Whole packs.
struct NearLinesTask {
  std::int32_t count;
  const double *place, *inverse_reach;  ///< [m], [1/m]
  double least_spread;                  ///< added to the variance of y
  std::int32_t sources;
  const double *source_place, *weight, *value;
  double* at;
};

/// The mean of values at strips near one of them, or the line of least squares through them at its place,
/// with the weights (1 - y^2)^3 width q, y the distance over the reach. All strips are within reach.
struct SmoothedSlopesTask {
  std::int32_t count;
  bool line;
  double place, inverse_reach;         ///< [m], [1/m]
  double least_spread;                 ///< added to the variance of y
  const double *source_place, *width;  ///< [m]
  const double *line_load, *value;
  double *by_value, *by_load;  ///< results: derivatives by the strips' values and line loads
};

/// Strips of a rail between two sections (surface/geometry/varying_rail.hpp).
struct SectionStripsTask {
  std::int32_t count;
  const double *left, *right;  ///< the sections' lists: y, z, dy/du, dz/du, and their slopes along the track
  std::int64_t stride;         ///< elements from one list to the next
  const double (*weight)[4];  ///< on left, right, slope on the left, on the right: for values, then for first
                              ///< and second derivatives by the distance
  const double* step;         ///< range of u across each strip [m]
  double *y, *z, *ty, *tz, *width;  ///< as RailStrips
};

/// A rail that varies, of one face of which strips may gain overlap along the track
/// (surface/geometry/strip_gain.hpp).
struct StripGainsTask {
  const surface::VaryingRail* rail;
  const surface::PlacedRail* placed;
  std::int32_t face;
  double wheel_radius;  ///< [m]
};

/// Strips of one face of a rail that varies, whose overlaps a wheel's rays follow along the track
/// (surface/geometry/along_track.hpp).
struct FollowRailTask {
  const surface::VaryingRail* rail;
  const surface::RailFace* face;
  const surface::Curve* wheel;
  const surface::RelativePose* pose;
  double distance, low, high;  ///< as PlacedRail [m]
  double deep_enough;  ///< overlaps that are less deep are those of the circles at the tops, not of whole
                       ///< contacts [m]
};

/// Overlaps of strips of one face, of which places along the track are looked at.
struct LookAlongTask {
  const surface::VaryingRail* rail;
  const surface::PlacedRail* placed;
  std::int32_t face;
  const surface::Overlaps* overlaps;
  std::int32_t first, count;
};

/// A wheel's outline, and the strips whose rays it may cross.
struct OutlineTask {
  const surface::RailStrips* rail;
  const surface::WheelCurve* wheel;
  const surface::RelativePose* pose;
  surface::OutlineAttitude attitude;
  const surface::OverlapScratch* scratch;
};

/// A strip of a rail that is the same everywhere, whose ray ends at length `u` on a piece of the wheel's
/// curve (Overlaps).
struct OverlapSlopesTask {
  double y, z, ty, tz;  ///< the strip's middle [m] and unit tangent, rail axes
  const surface::Curve* wheel;
  const surface::RelativePoseOf<Dual<4>>* pose;  ///< numbers by PlaceInput
  const surface::OutlineAttitudeOf<Dual<4>>* attitude;
  std::int32_t piece;
  double u;  ///< [m]
};

/// The numbers of strips that roll (surface/rolling/strip_numbers.hpp).
struct StripNumbersTask {
  const surface::SurfaceRollingInputOf<double>* in;
  const surface::strip_numbers::Shared* shared;
  const surface::RollingArraysOf<double>* arrays;
  bool for_strip_fastsim;  ///< its arrays, too
};

/// Numbers of strips with derivatives by the wrench's inputs in the rail's axes
/// (surface/wrench/wrench_jacobian.hpp).
struct StripNumbersSlopesTask {
  static constexpr std::size_t inputs = 12, still_inputs = 4;
  using Number = Dual<inputs>;

  const surface::SurfaceRollingInputOf<Number>* in;
  const surface::strip_numbers::Shared* shared;
  const surface::RollingArraysOf<Number>* arrays;
  bool still_loads;  ///< loads and lengths change with the first still_inputs alone
};

/// Forces of strips, from derivatives by their own numbers to those by the wrench's inputs.
struct StripForcesSlopesTask {
  using Number = StripNumbersSlopesTask::Number;

  std::int32_t count;
  const Number *bound, *half_length;
  const Number* inputs[strip_inputs];  ///< by SurfaceStripInput; the spin not yet times the half length
  const double* found[3];              ///< forces and moment
  const double* slopes;                ///< as SurfaceStripsSlopesTask has them
  Number* to[3];
};

}  // namespace wrc::simd
