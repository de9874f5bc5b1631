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
/// section of a face they are zero, as beyond them nothing changes.
///
/// A rail may have several faces (stock rail and blade, wing rail and nose), each an outline with sections of
/// its own. Faces do not press on each other: their strips are an arc length apart that no influence reaches.
#pragma once

#include <cstdint>

#include "base/dual.hpp"
#include "base/fault.hpp"
#include "geometry/profile.hpp"
#include "surface/rail_strips.hpp"

namespace wrc {

/// One cross section, as given: right-hand, from its own origin, not canted.
struct RailSection {
  double distance = 0.0;    ///< along the track [m]
  double y = 0.0, z = 0.0;  ///< where its origin lies, from that of the rail [m]
  std::int32_t face = 0;
  std::int32_t marks = 0;
  const double* mark = nullptr;  ///< y on its profile [m], increasing
  Profile profile;
};

struct RailFace {
  std::int32_t first = 0, strips = 0;            ///< of the rail's strips
  std::int32_t first_section = 0, sections = 0;  ///< of all sections
};

struct VaryingRail {
  std::int32_t faces = 0;             ///< 0: the rail is the same everywhere
  std::int32_t strips = 0, room = 0;  ///< room: elements from one list of `outline` to the next
  RailFace face[most_rail_faces];
  double begin = 0.0, end = 0.0;     ///< of the sections [m]
  double steepest = 0.0;             ///< largest displacement of a strip per distance [-]
  const double* distance = nullptr;  ///< of each section [m]
  const double* outline = nullptr;   ///< of each section eight lists over the strips: y, z, dy/du, dz/du, and
                                     ///< how they change along the track
  const double* step = nullptr;      ///< of u, across each strip [m]
};

/// Doubles of memory for so many sections, of which the longest profile has so many nodes.
std::int64_t varying_rail_doubles(std::int32_t sections, std::int32_t nodes, std::int32_t most_strips);

/// Cuts and pairs the sections, whose distances and faces the caller has put in order. WRC_ERROR_PROFILE,
/// with the section's index, if they cannot be paired.
Fault make_varying_rail(const RailSection* sections, std::int32_t count, double inclination,
                        std::int32_t most_strips, double* memory, VaryingRail& rail);

/// Where a distance lies in a face's sections: `at` and the next, and what their values and slopes count for
/// the outline and its derivatives by the distance, up to the third.
struct SectionBlend {
  std::int32_t left, right;
  double weight[4][4];
};
SectionBlend blend_at(const VaryingRail& rail, const RailFace& face, double distance);

/// Cuts the strips of a rail at a distance, into `memory` of rail_strip_doubles(most) doubles: those of faces
/// that are there.
void place_strips(const VaryingRail& rail, double distance, double* memory, std::int32_t most,
                  RailStrips& strips);

/// The face a strip belongs to.
inline const RailFace& face_of(const VaryingRail& rail, std::int32_t strip) {
  std::int32_t f = 0;
  while (f + 1 < rail.faces && strip >= rail.face[f + 1].first) ++f;
  return rail.face[f];
}

/// A strip's middle and how it moves along the track.
template <class Number>
struct StripAlongTrack {
  Number y, z, ty, tz;              ///< place [m], unit tangent
  Number slope_y, slope_z;          ///< by the distance [-]
  Number curvature_y, curvature_z;  ///< second derivatives [1/m]
};

inline double with_slope(double, double value, double) { return value; }
template <std::size_t n>
Dual<n> with_slope(const Dual<n>& x, double value, double slope) {
  return x.chain(value, slope);
}

template <class Number>
StripAlongTrack<Number> strip_at(const VaryingRail& rail, const RailFace& face, std::int32_t strip,
                                 const Number& distance) {
  const SectionBlend b = blend_at(rail, face, value_of(distance));
  const auto lists = [&](std::int32_t section) {
    return rail.outline + static_cast<std::int64_t>(section) * 8 * rail.room + strip;
  };
  const double *const left = lists(b.left), *const right = lists(b.right);
  double f[4][4];  // list, derivative
  for (std::int32_t q = 0; q < 4; ++q) {
    const std::int64_t value = static_cast<std::int64_t>(q) * rail.room,
                       slope = static_cast<std::int64_t>(q + 4) * rail.room;
    for (int d = 0; d < 4; ++d)
      f[q][d] = b.weight[d][0] * left[value] + b.weight[d][1] * right[value] + b.weight[d][2] * left[slope] +
                b.weight[d][3] * right[slope];
  }
  const auto number = [&](int q, int d) { return with_slope(distance, f[q][d], f[q][d + 1]); };
  StripAlongTrack<Number> s;
  s.y = number(0, 0);
  s.z = number(1, 0);
  const Number dy = number(2, 0), dz = number(3, 0), per_length = Number(1.0) / root(dy * dy + dz * dz);
  s.ty = dy * per_length;
  s.tz = dz * per_length;
  s.slope_y = number(0, 1);
  s.slope_z = number(1, 1);
  s.curvature_y = number(0, 2);
  s.curvature_z = number(1, 2);
  return s;
}

}  // namespace wrc
