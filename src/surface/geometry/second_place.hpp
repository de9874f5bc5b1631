/// Second places of contact along the track. Where a rail dips more sharply than the wheel is round, a
/// strip's overlap has two tops one behind the other, and contact may be at both.
///
/// A second place is a strip of its own: of the same part of the rail, with a place, an overlap and a length
/// of its own. Its number is second_places higher. First and second places are two rows. Both displace each
/// other as all strips do; means over neighbouring strips are taken in each row alone.
#pragma once

#include "surface/geometry/along_track.hpp"

namespace wrc::surface {

/// A strip's second top is looked for so far from the first one, in steps so long [m].
inline constexpr double second_within = 40e-3, second_apart = 2.5e-3;

/// Share of the wheel's curvature from which a valley of the rail counts [-]. Less than 1, as directions
/// differ a little along the valley.
inline constexpr double least_valley = 0.8;

/// May overlaps of a face's strips have two tops? `own`: curvature of the wheel there [1/m].
inline bool may_touch_twice(const PlacedRail& placed, std::int32_t face, double own) {
  return placed.valley[face] > least_valley * own;
}

/// Sharpest valleys of a face's strips about a place, of each eight in turn.
struct ValleysOfFace {
  const PlacedRail& placed;
  const VaryingRail& rail;
  std::int32_t face;
  std::int32_t eight = -1;  ///< that was looked at last
  double sharpest = 0.0;    ///< its valley [1/m]

  ValleysOfFace(const PlacedRail& where, const VaryingRail& of, std::int32_t number)
      : placed(where), rail(of), face(number) {}

  /// May the overlap of a strip have two tops?
  bool may_touch_twice(std::int32_t strip, double own) {
    if (!surface::may_touch_twice(placed, face, own)) return false;
    if (eight_of(strip) != eight) {
      eight = eight_of(strip);
      sharpest = valley_between(rail, rail.face[face], eight, placed.distance - farthest_along,
                                placed.distance + farthest_along);
    }
    return sharpest > least_valley * own;
  }
};

/// A strip at a top of its overlap, and the direction of its rays.
struct StripTop {
  LargestOverlap at;
  double ny, nz;
  double own;  ///< curvature of the wheel there [1/m]
};

/// How far down along a direction a strip's middle lies, between the sections looked at last.
struct StripAlong {
  const VaryingRail& rail;
  std::int32_t face, strip;
  double ny, nz;                             ///< the direction
  double begin = 1.0, end = 0.0, per = 0.0;  ///< distances of the sections, and 1 over that between them [m]
  BetweenSections<double> n = {};            ///< n.P [m]

  /// At a distance along the track [m].
  double at(double distance) {
    if (!(distance >= begin && distance < end)) go_to(distance);
    const double t = (distance - begin) * per;
    return n.value(t, t * t);
  }

 private:
  void go_to(double distance) {
    const SectionBlend b = blend_at(rail, rail.face[face], distance, 0);
    const auto number = [&](std::int32_t section, std::int32_t list) {
      const double* const of =
          rail.outline + (static_cast<std::int64_t>(section) * 8 + list) * rail.stride + strip;
      return ny * of[0] + nz * of[rail.stride];
    };
    begin = rail.distance[b.left];
    end = rail.distance[b.right];
    if (b.left == b.right) {  // beyond its sections, or at the last one
      n = {number(b.left, 0), 0.0, 0.0, 0.0, 0.0};
      per = 0.0;
      return;
    }
    // by powers of the share of the way between both sections
    const double apart = end - begin;
    per = 1.0 / apart;
    n = BetweenSections<double>::of(number(b.left, 0), number(b.right, 0), apart * number(b.left, 4),
                                    apart * number(b.right, 4));
  }
};

/// The highest other top of a strip's overlap, by the rail's fall f along the normal. From the first top,
/// here at x = 0, the overlap is
///     d(x) = d(0) + f'(0) x - own/2 x^2 - f(x).
/// A depth of -1 m says that there is none.
inline FirstLook look_beyond_valley(const PlacedRail& placed, const VaryingRail& rail, std::int32_t strip,
                                    const StripTop& first) {
  const std::int32_t f = face_of(rail, strip);
  const RailFace& face = rail.face[f];
  const double x = first.at.x, here = placed.distance + x;
  FirstLook found{x, -1.0};
  if (!(x > placed.low[f] && x < placed.high[f])) return found;
  // the rail's fall is counted from the first top on
  StripAlong along{rail, f, strip, first.ny, first.nz};
  const double top = along.at(here), t = (here - along.begin) * along.per;
  const double slope = along.per * along.n.slope(t, t * t);
  // to both sides
  for (const double way : {-1.0, 1.0}) {
    const double end = here + way * second_within;
    if (!(valley_between(rail, face, eight_of(strip), smaller(here, end), larger(here, end)) >
          least_valley * first.own))
      continue;
    // overlaps at places, by the wheel's curvature and the rail's fall, and their slopes outwards
    constexpr int steps = static_cast<int>(second_within / second_apart);
    double depth = first.at.end.depth, uphill = 0.0;
    for (int n = 1; n <= steps; ++n) {
      const double off = way * n * second_apart;
      if (x + off < placed.low[f] || x + off > placed.high[f]) break;
      const double before = depth, uphill_before = uphill;
      depth = first.at.end.depth + off * (slope - 0.5 * first.own * off) - (along.at(here + off) - top);
      const double s = (here + off - along.begin) * along.per;
      uphill = way * (slope - first.own * off - along.per * along.n.slope(s, s * s));
      // the slope between both places is a parabola, by the cubic through both
      const double mean = (depth - before) * (1.0 / second_apart);
      const double once = 6.0 * mean - 4.0 * uphill_before - 2.0 * uphill,
                   twice = 3.0 * (uphill_before + uphill) - 6.0 * mean;
      // where it comes from above 0, a top is at the end of that
      const double square = once * once - 4.0 * twice * uphill_before;
      if (!(square > 0.0)) continue;
      // the root at which it falls, without a difference of like numbers
      const double falls = once < 0.0 ? 2.0 * uphill_before / (root(square) - once)
                                      : (once + root(square)) / (-2.0 * smaller(twice, -1e-12));
      // not the top where the look begins
      constexpr double farther = 0.2;
      if (!(falls > (n == 1 ? farther : 0.0) && falls <= 1.0)) continue;
      const double there =
          before + second_apart * falls * (uphill_before + falls * (0.5 * once + falls * twice / 3.0));
      if (there > found.depth) found = {x + off + way * second_apart * (falls - 1.0), there};
    }
  }
  return found;
}

/// The other top by rays from the first one: from the place `from` uphill, in steps down to 0.6 mm.
inline LargestOverlap climb_second(StripOverX<double>& strip, double low, double high, double from,
                                   const LargestOverlap& first) {
  // rays from one end to the next, as far as the place given
  LargestOverlap found = first;
  for (const double way = from < first.x ? -1.0 : 1.0; magnitude(from - found.x) > 0.0;) {
    const double left = magnitude(from - found.x);
    found.x = left > place_apart ? found.x + way * place_apart : from;
    depth_at(strip, found.x, found.end);
  }
  for (const double apart : {0.5 * second_apart, 0.25 * second_apart}) {
    const LargestOverlap middle = found;
    for (const double x : {middle.x + apart, middle.x - apart}) {
      if (x < low || x > high) continue;
      RayEnd<double> end = middle.end;
      if (depth_at(strip, x, end) > found.end.depth) found = {x, end};
    }
  }
  return found;
}

/// Where the overlap is least between two tops. `other`: place of the second one [m].
inline LargestOverlap find_valley(StripOverX<double>& strip, const LargestOverlap& first, double other) {
  constexpr int parts = 12, newton_steps = 3;
  // the least of some overlaps between both tops
  const double apart = (other - first.x) / parts;
  LargestOverlap least{first.x + apart, first.end}, at = least;
  for (int n = 1; n < parts; ++n) {
    at.x = first.x + apart * n;
    if (depth_at(strip, at.x, at.end) < least.end.depth || n == 1) least = at;
  }
  // from the least of some on by Newton's method
  for (int n = 0; n < newton_steps; ++n) {
    const OverlapAlong<double> o =
        overlap_along<double>(piece_at(strip.wheel, least.end.piece), strip.pose, strip.start(least.x),
                              strip.ny, strip.nz, least.end.u, least.end.depth);
    if (!(o.bend > 0.0)) break;
    const double step = smaller(larger(-o.slope / o.bend, -magnitude(apart)), magnitude(apart));
    // not beyond a top, where the overlap falls from one top to the other and on
    least.x = smaller(larger(least.x + step, smaller(first.x, other)), larger(first.x, other));
    depth_at(strip, least.x, least.end);
  }
  return least;
}

/// A strip with two tops of its overlap: the part of either that counts [-], and the bounds of their
/// contacts.
template <class Number>
struct TwoTops {
  Number part[2];
  TopBounds<Number> bounds[2];
};

/// The lower top counts by how far it rises out of the valley, and by how deep the valley is. Its part is 0
/// where it arises on the other's slope, and where the other's contact reaches over the valley. `x`, `depth`:
/// of both tops, then of the valley [m].
template <class Number>
TwoTops<Number> share_tops(const Number (&x)[3], const Number (&depth)[3]) {
  // rise of a lower top that counts, and how much more as a whole
  constexpr double counts_from = 1e-6, whole = 5e-6;  // [m]
  // valley's overlap over the higher top's [-]: up to left_free chords end before the valley
  constexpr double left_free = 1.0 - 0.5 * contact_share, filled = 0.8;
  constexpr double least = 1e-6;  // [-]: keeps divisions finite
  const Number none = 0.0, all = 1.0;
  // how far both rise out of the valley, and how deep that is
  const Number rise[2] = {larger(depth[0] - depth[2], none), larger(depth[1] - depth[2], none)};
  const Number highest = larger(larger(depth[0], depth[1]), none);
  const Number rises = larger(smaller(rise[0], rise[1]) - counts_from, none);
  const Number by_rise = smaller(rises * (1.0 / whole), all);
  const Number free = larger(filled * highest - depth[2], none);
  const Number by_depth =
      smaller(free, (filled - left_free) * highest + 1e-12) / ((filled - left_free) * highest + 1e-12);
  const Number counts = by_rise * by_depth, lost = 1.0 - counts;
  // both lose where they are as high, so that neither jumps as the other becomes the lower one
  const Number squares = rise[0] * rise[0] + rise[1] * rise[1];
  TwoTops<Number> two{{all, all}, {{unbounded.ahead, unbounded.behind}, {unbounded.ahead, unbounded.behind}}};
  if (value_of(squares) > 0.0) {
    const int low = value_of(depth[1]) < value_of(depth[0]) ? 1 : 0;
    const Number shared = smaller(2.0 * counts, all) * rise[low] * rise[low] / squares;
    two.part[low] = 1.0 - lost * (1.0 - shared);
    two.part[1 - low] = 1.0 - lost * shared;
  }
  // bounds in the valley, farther off the less the other top counts
  for (int k = 0; k < 2; ++k) {
    const Number bound = x[k] + (x[2] - x[k]) / larger(two.part[1 - k], Number(least));
    (value_of(x[k]) < value_of(x[1 - k]) ? two.bounds[k].ahead : two.bounds[k].behind) = bound;
  }
  return two;
}

}  // namespace wrc::surface
