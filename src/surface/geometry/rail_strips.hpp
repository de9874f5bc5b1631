/// The cross section of a rail cut into strips, once: their places never depend on a pose, so nothing about
/// them can jump.
#pragma once

#include <cstdint>

#include "surface/geometry/curve.hpp"

namespace wrc::surface {

/// A rail has at most so many faces that are cut on their own (varying_rail.hpp), and so many marks that pair
/// its sections.
inline constexpr std::int32_t most_rail_faces = 8, most_rail_marks = 64;

/// Number of a strip's second place along the track (second_place.hpp) less that of the strip itself.
inline constexpr std::int32_t second_places = 4096;

/// The rail's strip that a number belongs to, of a first or a second place.
inline std::int32_t on_rail(std::int32_t strip) { return strip & (second_places - 1); }

/// Strips side by side, and the bounds of their middles.
struct FaceStrips {
  std::int32_t first, count;
  double top, leftmost, rightmost;  ///< smallest z, smallest and largest y [m]

  bool has(std::int32_t strip) const { return strip >= first && strip < first + count; }
};

/// Strips by increasing arc length, touching each other within a range; a strip of no range is not there.
/// Rail axes: origin of the rail's profile, y to the field side, z down.
struct RailStrips {
  std::int32_t count = 0;
  const double* s = nullptr;                ///< arc length at the middle [m]
  const double* width = nullptr;            ///< along the arc [m]
  const double *y = nullptr, *z = nullptr;  ///< the middle [m]
  const double *ty = nullptr,
               *tz = nullptr;     ///< unit tangent, by increasing arc length; the normal into the rail is
                                  ///< (-tz, ty)
  const double* angle = nullptr;  ///< strip_angle(); nullptr: not kept [rad]
  std::int32_t ranges = 0;
  FaceStrips range[most_rail_faces];
};

/// Arc length of a strip, by which it displaces others [m]. A second place is put 0.1 um beside the first
/// one, so that places differ.
inline double place_on_rail(const RailStrips& rail, std::int32_t strip) {
  constexpr double apart = 1e-7;
  return strip < second_places ? rail.s[strip] : rail.s[on_rail(strip)] + apart;
}

/// Arc length of a strip, by which neighbours are found [m]. The second row is put far from the first one.
inline constexpr double rows_apart = 16.0;
inline double row_place(const RailStrips& rail, std::int32_t strip) {
  return strip < second_places ? rail.s[strip] : rail.s[on_rail(strip)] + rows_apart;
}

/// Widths of strips: the narrowest where the surface is curved as a gauge corner, the widest where it is
/// nearly flat [m].
struct StripWidths {
  double narrowest = 0.25e-3, widest = 0.5e-3;
  double sharp = 0.020, flat = 0.060;  ///< radii of curvature up to and from which they hold [m]
  double guiding = widest;  ///< at most, on faces beyond 76 degrees that fall to the field side, from 64 on
};

/// On a face beside the rail, which may be a check rail. A flange's back touches that over 1 to 8 mm of arc,
/// and under yaw contacts of strips 0.5 mm wide lie 2 to 5 mm apart along the track: peak pressures were up
/// to half off.
inline constexpr double guiding_width = 0.2e-3;  // [m]

/// Width wanted at a length of a curve [m].
double wanted_width(const Curve& rail, const StripWidths& widths, double s);

/// Divides a length into strips of the widths `wanted(at)`, all scaled alike to end where it ends and to be
/// at most `most`: their middles and widths; returns how many.
template <class Wanted>
std::int32_t cut_length(double begin, double end, const Wanted& wanted, std::int32_t most, double* s,
                        double* width) {
  // number of strips that the widths wanted, times a scale, add up to
  const auto count_from = [&](double scale) {
    double at = begin;
    std::int32_t n = 0;
    while (at < end && n <= most) {
      const double w = scale * wanted(at);
      at += scale * wanted(at + 0.5 * w);
      ++n;
    }
    return n;
  };
  // all widths scaled alike until there are few enough
  double scale = 1.0;
  while (count_from(scale) > most - 1) scale *= 1.1;
  // each strip's width is that wanted in its middle; the last takes a rest of less than half a strip
  double at = begin;
  std::int32_t n = 0;
  while (at < end && n < most) {
    const double guess = scale * wanted(at);
    double w = scale * wanted(at + 0.5 * guess);
    if (at + 1.5 * w > end) w = end - at;
    width[n] = w;
    s[n] = at + 0.5 * w;
    at += w;
    ++n;
  }
  return n;
}

/// Angle of a strip about x, from z to its normal [rad].
double strip_angle(const RailStrips& strips, std::int32_t strip);

/// The range of `count` strips from `first` on.
FaceStrips range_of(const RailStrips& strips, std::int32_t first, std::int32_t count);

/// A top of a strip's overlap along the track that may touch the wheel. Rounded numbers are where rays start.
struct CandidateAlong {
  /// Numbers of `other`: the strip has no other top, or may have one that has not been looked for.
  static constexpr std::int16_t no_other = -1, unknown = -2;

  std::int16_t strip;
  std::int16_t other;  ///< the strip's other top, by its number on the list
  std::int32_t piece;  ///< piece of the wheel's curve where the ray ends
  float x, u, ray;     ///< place, the ray's end and the overlap along it [m]
  float ny, nz;        ///< direction of the ray
  float depth;         ///< that of the strip's overlap (overlap.hpp) [m]
  float doubt;         ///< error of the depth: of a first look, then of a top that was followed [m]
  float own;           ///< curvature of the wheel below the axle [1/m]
};

/// Strips that may overlap a wheel, of surfaces that change along the track, and where along the track each
/// overlaps most: looked for at one height of a call, of use at all heights near it (surface_geometry.hpp).
/// Depths are those at that height.
struct CandidatesAlong {
  bool known = false;
  double at_y = 0.0, at_z = 0.0;  ///< the wheel's reference point there [m]
  double reach = 0.0;             ///< strips deeper than -reach are among them, all that varies added [m]
  double below = 0.0;             ///< that the reach of a search has for heights further down [m]
  std::int32_t count = 0;         ///< strips, in their order
  std::int32_t tops = 0;          ///< the same and behind them other tops of theirs
  std::int32_t capacity = 0;
  CandidateAlong* top = nullptr;

  /// By how much the overlap along a direction has grown since, with the wheel's reference point at y, z [m].
  double growth(double ny, double nz, double y, double z) const { return ny * (y - at_y) + nz * (z - at_z); }
  /// Depth of a top there, to its doubt and that of the move [m].
  double depth(const CandidateAlong& of, double y, double z) const {
    return of.depth + growth(of.ny, of.nz, y, z);
  }
};

/// Arrays of the strips of a rail.
struct StripArrays {
  double *s, *width, *y, *z, *ty, *tz;
  double* angle;  ///< as RailStrips; nullptr: of rails that vary
};
StripArrays cut_strips(Arena& arena, std::int32_t most);
StripArrays cut_varying_strips(Arena& arena, std::int32_t most);
/// An empty list of at most so many tops.
CandidatesAlong cut_candidates(Arena& arena, std::int32_t most);

/// The whole curve, cut into at most `most` strips, in arrays for as many.
RailStrips cut_rail(const Curve& rail, const StripWidths& widths, std::int32_t most,
                    const StripArrays& arrays);

}  // namespace wrc::surface
