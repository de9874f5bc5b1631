/// A rail whose cross section changes along the track: sections at stated distances, blended between them.
///
/// An outline is cut into strips once, by a length u: that along the first section's outline. Where marks
/// pair the outlines of two sections, u runs through the marks of both alike, by a monotone cubic; between
/// the ends else. So each section is a list of points and tangents P(u), P'(u), and a distance between two
/// sections has
///
///     P(u, X) = h0(t) A + h1(t) B + h2(t) A_X + h3(t) B_X,      t = (X - X_A) / (X_B - X_A),
///
/// with the quintic Hermite functions whose second derivatives vanish at both ends: twice continuously
/// differentiable along the track, from two neighbours alone. The slopes A_X, B_X at a section are the mean
/// of the secants a, b to its neighbours times 2 a.b / (a.a + b.b) (0 where that is negative), sums over the
/// whole outline: a ramp that goes on is straight, where one begins nothing overshoots. At the first and last
/// section of a face they are those of the secant there, at those of the whole rail zero, as it goes on
/// unchanged.
///
/// A rail may have several faces (stock rail and blade, wing rail and nose), each an outline with sections of
/// its own. Faces do not press on each other: their strips are an arc length apart that no influence reaches.
#pragma once

#include <cstdint>

#include "base/dual.hpp"
#include "base/fault.hpp"
#include "base/number.hpp"
#include "geometry/profile.hpp"
#include "kernels/kernels.hpp"
#include "surface/geometry/rail_strips.hpp"

namespace wrc::surface {

/// One cross section, as given: right-hand, from its own origin, not canted.
struct RailSection {
  double distance = 0.0;    ///< along the track [m]
  double y = 0.0, z = 0.0;  ///< where its origin lies, from that of the rail [m]
  std::int32_t face = 0;
  std::int32_t marks = 0;
  const double* mark = nullptr;  ///< y on its profile [m], increasing
  geometry::Profile profile;
};

struct RailFace {
  std::int32_t first = 0, strips = 0;            ///< among the rail's strips
  std::int32_t first_section = 0, sections = 0;  ///< among all sections
  bool changes = false;  ///< do its sections differ, or does it begin or end within the rail?
};

struct VaryingRail {
  std::int32_t faces = 0;               ///< 0: the rail is the same everywhere
  std::int32_t strips = 0, stride = 0;  ///< stride: elements from one list of `outline` to the next
  RailFace face[most_rail_faces];
  double begin = 0.0, end = 0.0;     ///< first and last distance of a section [m]
  const double* distance = nullptr;  ///< distance of each section [m]
  const double* outline = nullptr;  ///< eight lists over the strips for each section: y, z, dy/du, dz/du, and
                                    ///< their slopes along the track
  const double* step = nullptr;     ///< range of u across each strip [m]
  /// Sharpest valley between each section and the next one of its face, of each eight strips and of all. It
  /// is the largest curvature along the track by which a strip rises out of its tangent, against its normal
  /// [1/m].
  const double* valley = nullptr;
};

/// Arrays of a rail that varies, and of its making.
struct VaryingRailArrays {
  double *distance, *outline, *step;  ///< as VaryingRail
  double* valley;                     ///< as VaryingRail
  double* middle;                     ///< u in the middle of the strips of a face [m]
  double* wanted;                     ///< samples of the widths wanted [m]
  double *before, *behind;            ///< secants between sections, four lists each
  double *y, *z;                      ///< points of a section, rail axes [m]
  CurveArrays curve;                  ///< through them
};
/// For so many sections, of which the longest profile has so many nodes.
VaryingRailArrays cut_varying_rail(Arena& arena, std::int32_t sections, std::int32_t nodes,
                                   std::int32_t most_strips);

/// Cuts and pairs the sections, whose distances and faces the caller has put in order. WRC_ERROR_PROFILE,
/// with the section's index, if they cannot be paired. `widths`: of the strips; those of faces beside the
/// running rail, which guide, are guiding_width at most.
Fault make_varying_rail(const RailSection* sections, std::int32_t count, double inclination,
                        const StripWidths& widths, std::int32_t most_strips, const VaryingRailArrays& arrays,
                        VaryingRail& rail);

/// Weights at a place between two sections: on the right value, and on the slopes left and right. That on the
/// left value is 1 less the first, in derivatives 0 less it.
template <class Number>
struct SectionWeights {
  Number up, leaving, reaching;
};

/// The quintic Hermite functions of the header, and their first two derivatives by the distance. `t`: from 0
/// to 1; `apart`: of the sections [m]; `per`: 1 over that.
template <class Number>
WRC_IN_LOOP SectionWeights<Number> value_weights(const Number& t, const Number& apart) {
  const Number t2 = t * t;
  return {t2 * t * (10.0 + t * (6.0 * t - 15.0)), t * (1.0 + t2 * (t * (8.0 - 3.0 * t) - 6.0)) * apart,
          t2 * t * (t * (7.0 - 3.0 * t) - 4.0) * apart};
}
template <class Number>
WRC_IN_LOOP SectionWeights<Number> slope_weights(const Number& t, const Number& per) {
  const Number t2 = t * t;
  return {30.0 * t2 * (1.0 + t * (t - 2.0)) * per, 1.0 + t2 * (t * (32.0 - 15.0 * t) - 18.0),
          t2 * (t * (28.0 - 15.0 * t) - 12.0)};
}
template <class Number>
WRC_IN_LOOP SectionWeights<Number> curvature_weights(const Number& t, const Number& per) {
  return {60.0 * t * (1.0 + t * (2.0 * t - 3.0)) * per * per, t * (t * (96.0 - 60.0 * t) - 36.0) * per,
          t * (t * (84.0 - 60.0 * t) - 24.0) * per};
}

/// A number of a strip between two sections, by powers of the share t of the way: value_weights() and its
/// derivatives, multiplied out.
template <class Number>
struct BetweenSections {
  Number whole, once, cubed, fourth, fifth;

  /// From the values in both sections, and their slopes by t.
  WRC_IN_LOOP static BetweenSections of(const Number& left, const Number& right, const Number& leaving,
                                        const Number& reaching) {
    const Number rise = right - left;
    return {left, leaving, 10.0 * rise - 6.0 * leaving - 4.0 * reaching,
            8.0 * leaving + 7.0 * reaching - 15.0 * rise, 6.0 * rise - 3.0 * (leaving + reaching)};
  }
  WRC_IN_LOOP Number value(const Number& t, const Number& t2) const {
    return whole + t * (once + t2 * (cubed + t * (fourth + t * fifth)));
  }
  /// The first two derivatives by t.
  WRC_IN_LOOP Number slope(const Number& t, const Number& t2) const {
    return once + t2 * (3.0 * cubed + t * (4.0 * fourth + t * (5.0 * fifth)));
  }
  WRC_IN_LOOP Number curvature(const Number& t) const {
    return t * (6.0 * cubed + t * (12.0 * fourth + t * (20.0 * fifth)));
  }
};

/// Place of a distance in a face's sections: between `left` and `right`, or at one that is both; weights of
/// their values and slopes in the outline and its derivatives by the distance, up to the number asked for.
struct SectionBlend {
  std::int32_t left, right;
  double weight[4][4];
};
SectionBlend blend_at(const VaryingRail& rail, const RailFace& face, double distance, int derivatives = 3);
/// The same, looked for first where `near` is.
SectionBlend blend_at(const VaryingRail& rail, const RailFace& face, double distance,
                      const SectionBlend& near, int derivatives = 3);

/// Places along the track from the wheel's reference point, at which a strip's overlap is looked at first,
/// and their distance [m]: to 60 mm either side. Overlaps that grow beyond are followed to 160 mm, as at a
/// high edge, or where a rail nears the flange. A flange is below the rail's top up to there.
inline constexpr std::int32_t places_to_a_side = 6, track_places = 2 * places_to_a_side + 1;
inline constexpr double place_apart = 10e-3, farthest_along = 160e-3;

/// A place along the track: weights of values and slopes of two sections there (SectionBlend).
struct PlaceWeights {
  double x;  ///< [m]
  std::int32_t left, right;
  double weight[4];
};

/// The place at x of a face, the wheel's reference point at `distance`.
PlaceWeights place_at(const VaryingRail& rail, const RailFace& face, double distance, double x);

/// One of a strip's lists there: 0 for y, 1 for z [m].
inline double place_of(const VaryingRail& rail, const PlaceWeights& place, std::int32_t strip,
                       std::int32_t list) {
  const auto at = [&](std::int32_t section, std::int32_t q) {
    return rail.outline[(static_cast<std::int64_t>(section) * 8 + q) * rail.stride + strip];
  };
  return place.weight[0] * at(place.left, list) + place.weight[1] * at(place.right, list) +
         place.weight[2] * at(place.left, list + 4) + place.weight[3] * at(place.right, list + 4);
}

/// A rail at one distance along the track.
struct PlacedRail : RailStrips {
  double distance = 0.0;                ///< within the sections [m]
  SectionBlend blend[most_rail_faces];  ///< blend of each face there
  /// How far each face reaches along the track from there [m], at most farthest_along.
  double low[most_rail_faces], high[most_rail_faces];
  PlaceWeights place[most_rail_faces][track_places];
  PlaceWeights end[most_rail_faces][2];  ///< at low and high
  double valley[most_rail_faces];        ///< sharpest valley of each face there (VaryingRail) [1/m]
  mutable CandidatesAlong candidates;    ///< the call's, in memory that its caller gives
};

/// The rail at a distance: strips of the faces that are there or within farthest_along.
PlacedRail place_strips(const Kernels& kernels, const VaryingRail& rail, double distance,
                        const StripArrays& arrays);

/// The most that overlaps of strips grow along the track, of faces that change [m]. `wheel_radius` [m].
void find_gains(const Kernels& kernels, const VaryingRail& rail, double wheel_radius,
                const PlacedRail& placed, double* gain);

/// Where a face begins and ends along the track, from a distance [m]. Where the whole rail does, its last
/// section goes on.
struct FaceExtent {
  double begin, end;
  bool holds(double x) const { return x >= begin && x <= end; }
};
inline FaceExtent extent_of(const VaryingRail& rail, const RailFace& face, double distance) {
  constexpr double everywhere = 1e9;  // [m]
  const double first = rail.distance[face.first_section],
               last = rail.distance[face.first_section + face.sections - 1];
  return {first > rail.begin ? first - distance : -everywhere,
          last < rail.end ? last - distance : everywhere};
}

/// Is the first of two faces a check rail? Both are there everywhere then, at this distance to either side
/// (model_options.cpp).
inline bool has_check_rail(const VaryingRail& rail) {
  constexpr double everywhere = 1e6;  // [m]
  return rail.faces == 2 && rail.begin == -everywhere && rail.end == everywhere;
}

/// Does any face of a rail change along the track? A check rail and its rail do not.
inline bool changes(const VaryingRail& rail) {
  for (std::int32_t f = 0; f < rail.faces; ++f)
    if (rail.face[f].changes) return true;
  return false;
}

/// The number of the face a strip belongs to.
inline std::int32_t face_of(const VaryingRail& rail, std::int32_t strip) {
  std::int32_t f = 0;
  while (f + 1 < rail.faces && strip >= rail.face[f + 1].first) ++f;
  return f;
}

/// Strips by eights: how many there are of so many, and the one that holds a strip.
inline std::int32_t eights(std::int32_t strips) { return (strips + 7) / 8; }
inline std::int32_t eight_of(std::int32_t strip) { return strip / 8; }

/// Numbers of a section in VaryingRail::valley: those of the eights, then the sharpest of all.
inline std::int32_t valleys_of_section(std::int32_t stride) { return eights(stride) + 1; }
inline std::int32_t sharpest_of_face(const VaryingRail& rail) { return eights(rail.stride); }

/// The sharpest valley of a face between two distances along the track: that of an eight, or the sharpest of
/// the face [1/m].
inline double valley_between(const VaryingRail& rail, const RailFace& face, std::int32_t eight, double from,
                             double to) {
  double sharpest = 0.0;
  for (std::int32_t k = face.first_section; k + 1 < face.first_section + face.sections; ++k) {
    if (!(rail.distance[k + 1] > from && rail.distance[k] < to)) continue;
    const std::int64_t section = static_cast<std::int64_t>(k) * valleys_of_section(rail.stride);
    sharpest = larger(sharpest, rail.valley[section + eight]);
  }
  return sharpest;
}

inline double with_slope(double, double value, double) { return value; }
template <std::size_t n>
Dual<n> with_slope(const Dual<n>& x, double value, double slope) {
  return x.chain(value, slope);
}

/// A strip's middle and how it moves along the track.
template <class Number>
struct StripAlongTrack {
  Number y, z;                      ///< place [m]
  Number slope_y, slope_z;          ///< by the distance [-]
  Number curvature_y, curvature_z;  ///< second derivatives [1/m]
};

/// One of a strip's lists and its derivatives by the distance, up to the third.
struct BlendedList {
  double f[4];
  template <class Number>
  Number at(const Number& distance, int derivative) const {
    return with_slope(distance, f[derivative], f[derivative + 1]);
  }
};
inline BlendedList blended(const VaryingRail& rail, const SectionBlend& b, std::int32_t strip,
                           std::int32_t list) {
  const auto at = [&](std::int32_t section, std::int32_t q) {
    return rail.outline[(static_cast<std::int64_t>(section) * 8 + q) * rail.stride + strip];
  };
  const double values[4] = {at(b.left, list), at(b.right, list), at(b.left, list + 4), at(b.right, list + 4)};
  BlendedList l;
  for (int d = 0; d < 4; ++d)
    l.f[d] = b.weight[d][0] * values[0] + b.weight[d][1] * values[1] + b.weight[d][2] * values[2] +
             b.weight[d][3] * values[3];
  return l;
}

/// `b`: of the strip's face at the distance.
template <class Number>
StripAlongTrack<Number> strip_at(const VaryingRail& rail, const SectionBlend& b, std::int32_t strip,
                                 const Number& distance) {
  const BlendedList y = blended(rail, b, strip, 0), z = blended(rail, b, strip, 1);
  return {y.at(distance, 0), z.at(distance, 0), y.at(distance, 1),
          z.at(distance, 1), y.at(distance, 2), z.at(distance, 2)};
}

/// A strip's unit tangent.
template <class Number>
void tangent_at(const VaryingRail& rail, const SectionBlend& b, std::int32_t strip, const Number& distance,
                Number& ty, Number& tz) {
  const Number dy = blended(rail, b, strip, 2).at(distance, 0),
               dz = blended(rail, b, strip, 3).at(distance, 0);
  const Number per_length = Number(1.0) / root(dy * dy + dz * dz);
  ty = dy * per_length;
  tz = dz * per_length;
}

}  // namespace wrc::surface
