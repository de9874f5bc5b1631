/// Places along the track where strips of a rail that varies overlap a wheel most, one strip per lane: a
/// first look by parabolas, and rays far from the axle (surface/geometry/along_track.hpp).
#pragma once

#include "surface/geometry/strip_gain.hpp"
#include "surface/simd/follow_rail_kernel.hpp"
#include "surface/simd/strips_in_sections.hpp"

namespace wrc::simd {
namespace {

/// The best of the places on a face, and overlaps there and at the places beside it.
struct BestPlace {
  bool any_on_face;
  Pack x, depth, ahead, behind;  ///< [m]
  Pack inner;                    ///< 1: there are places to both sides, else 0

  BestPlace(const surface::PlaceWeights* place, const Pack* depths, double low, double high)
      : any_on_face(false), x(0.0), depth(0.0), ahead(0.0), behind(0.0), inner(0.0) {
    constexpr std::int32_t last = surface::track_places - 1;
    for (std::int32_t k = 0; k <= last; ++k) {
      if (!(place[k].x >= low && place[k].x <= high)) continue;
      const bool between = k > 0 && k < last;
      const Mask more = any_on_face ? depths[k] > depth : Pack(0.0) < 1.0;
      any_on_face = true;
      x = select(more, place[k].x, x);
      depth = select(more, depths[k], depth);
      behind = select(more, depths[between ? k - 1 : k], behind);
      ahead = select(more, depths[between ? k + 1 : k], ahead);
      inner = select(more, between ? 1.0 : 0.0, inner);
    }
  }
};

/// The place where the overlap is largest of those along a face, or between these.
inline void find_first_look(const surface::PlacedRail& placed, std::int32_t face, const Pack* depths,
                            const Pack* at_end, Pack& x, Pack& depth) {
  const double low = placed.low[face], high = placed.high[face];
  const BestPlace best(placed.place[face], depths, low, high);
  const double end[2] = {placed.end[face][0].x, placed.end[face][1].x};
  const bool ends[2] = {wrc::magnitude(end[0]) < surface::farthest_along,
                        wrc::magnitude(end[1]) < surface::farthest_along};
  if (!best.any_on_face) {
    // the face is there farther away alone
    const bool behind = ends[0] || (!ends[1] && wrc::magnitude(low) < wrc::magnitude(high));
    x = end[behind ? 0 : 1];
    depth = at_end[behind ? 0 : 1];
    return;
  }
  // top of the parabola through the best place and those beside it
  const Pack rise = 0.5 * (best.ahead - best.behind), bend = 2.0 * best.depth - best.ahead - best.behind;
  const Mask round = bend > magnitude(rise);
  const Pack top = select(round, rise / select(round, bend, 1.0), select(rise > 0.0, 1.0, -1.0));
  const Pack between = smaller(larger(best.x + surface::place_apart * top, low), high),
             share = (between - best.x) / surface::place_apart;
  const Mask inner = best.inner > 0.0;
  x = select(inner, between, best.x);
  depth = select(inner, best.depth + share * (rise - 0.5 * bend * share), best.depth);
  // the face may end between two of these places
  for (int k = 1; k >= 0; --k) {
    if (!ends[k]) continue;
    const Mask more = at_end[k] > best.depth;
    x = select(more, end[k], x);
    depth = select(more, at_end[k], depth);
  }
}

/// SurfaceKernels::look_along.
inline void look_along_kernel(const LookAlongTask& task, surface::FirstLooks& looks) {
  const surface::PlacedRail& placed = *task.placed;
  const surface::Overlaps& o = *task.overlaps;
  for (std::int32_t base = 0; base < task.count; base += lanes) {
    const std::int32_t count = task.count - base < lanes ? task.count - base : lanes,
                       first = task.first + base;
    std::int32_t strip[lanes];
    for (std::int32_t i = 0; i < lanes; ++i) strip[i] = o.strip[first + (i < count ? i : count - 1)];
    // the strips below the axle, and their overlaps there
    StripsInSections sections{*task.rail, strip};
    const Pack y = sections.read(placed.y), z = sections.read(placed.z);
    const Pack depth = load(o.depth, first, count, 0.0), centre = load(o.centre, first, count, 0.0),
               curvature = load(o.curvature, first, count, 0.0), ny = load(o.ny, first, count, 0.0),
               nz = load(o.nz, first, count, 0.0);
    // d - kappa/2 (x - W_x)^2 - n.(P(X + x) - P(X)), n.P as PlaceWeights::weight has it
    const Pack below_axle = depth + ny * y + nz * z;
    Pack fall[4] = {};
    const auto depth_at = [&](const surface::PlaceWeights& place) {
      if (sections.go_to(place))
        for (std::int32_t k = 0; k < 4; ++k) fall[k] = ny * sections.list[0][k] + nz * sections.list[1][k];
      const Pack off = place.x - centre;
      const Pack there = place.weight[0] * fall[0] + place.weight[1] * fall[1] + place.weight[2] * fall[2] +
                         place.weight[3] * fall[3];
      return below_axle - 0.5 * curvature * off * off - there;
    };
    // at the places, and where the face ends
    Pack depths[surface::track_places], at_end[2], x, most;
    for (std::int32_t k = 0; k < surface::track_places; ++k) depths[k] = depth_at(placed.place[task.face][k]);
    for (std::int32_t k = 0; k < 2; ++k) at_end[k] = depth_at(placed.end[task.face][k]);
    find_first_look(placed, task.face, depths, at_end, x, most);
    store(x, looks.x + base, count);
    store(most, looks.depth + base, count);
  }
}

/// The overlap at x by rays from the ends of those nearby, which become the ends of these: by so many steps
/// of Newton's method.
inline Pack depth_along(StripsOverX& strips, Pack x, RayEnds& ends, Mask goes, int steps) {
  const surface::RayStart<Pack> from = strips.start(x);
  for (int n = 0; n < steps; ++n) step_ends(strips, from, goes, ends);
  return ends.depth;
}

/// Places of the largest overlap found so far, and the rays' ends there.
struct FoundAlong {
  Pack x;
  RayEnds ends;

  void take(Mask larger, Pack at, const RayEnds& there) {
    // place, end and overlap in lanes of larger ones; pieces of the wheel's curve with their coefficients
    x = select(larger, at, x);
    ends.u = select(larger, there.u, ends.u);
    ends.depth = select(larger, there.depth, ends.depth);
    double taken[lanes];
    store_pack(taken, select(larger, 1.0, 0.0));
    for (std::int32_t i = 0; i < lanes; ++i)
      if (taken[i] > 0.0) ends.piece[i] = there.piece[i];
    for (int d = 0; d < 4; ++d) {
      ends.on.y[d] = select(larger, there.on.y[d], ends.on.y[d]);
      ends.on.z[d] = select(larger, there.on.z[d], ends.on.z[d]);
    }
    ends.on.length = select(larger, there.on.length, ends.on.length);
  }
};

/// The strips of so many lanes from `first` on.
inline void climb_strips(const FollowRailTask& task, std::int32_t first, FollowedStrips& s) {
  constexpr int most_places = static_cast<int>(2.0 * surface::farthest_along / surface::place_apart) + 1;
  StripsOverX strips{task, s.strip + first, load_pack(s.ny + first), load_pack(s.nz + first)};
  // the rays below the axle, whose ends are known
  FoundAlong found;
  RayEnds ends;
  for (std::int32_t i = 0; i < lanes; ++i) ends.piece[i] = s.piece[first + i];
  ends.on = pieces_of(*task.wheel, ends.piece);
  ends.u = load_pack(s.u + first);
  ends.depth = load_pack(s.depth + first);
  const Pack from = load_pack(s.x + first), way = select(from < 0.0, -1.0, 1.0), distance = magnitude(from);
  const auto on_face = [&](Pack x) { return (x >= task.low) & (x <= task.high); };

  // from below the axle to there
  Pack before = surface::near_axle;
  for (Mask goes = before < distance; any(goes); goes = before < distance) {
    depth_along(strips, way * before, ends, goes, surface::ray_steps);
    before = before + surface::near_axle;
  }
  found.x = from;
  found.ends = ends;
  depth_along(strips, from, found.ends, Pack(0.0) < 1.0, surface::ray_steps);

  // on, as long as the overlap grows, else back: one step finds ends of rays a centimetre on to micrometres.
  // Between the places of a first look overlaps that are not deep enough are left as they are.
  Mask moves = (found.ends.depth > task.deep_enough) | (distance > surface::last_place);
  constexpr double both_ways[] = {1.0, -1.0}, parts[] = {0.5, 0.25};
  for (const double direction : both_ways) {
    const Pack step = direction * way * surface::place_apart;
    Pack x = from + step;
    ends = found.ends;
    Mask goes = moves & on_face(x);
    for (int n = 0; n < most_places && any(goes); ++n) {
      const Mask grows = goes & (depth_along(strips, x, ends, goes, 1) > found.ends.depth);
      found.take(grows, x, ends);
      x = x + step;
      goes = grows & on_face(x);
    }
    moves = moves & !((found.x > from) | (found.x < from));
    if (!any(moves)) break;
  }
  // then between the places
  const Mask worth = found.ends.depth > task.deep_enough;
  for (const double part : parts) {
    if (!any(worth)) break;
    const FoundAlong middle = found;
    for (const double direction : both_ways) {
      const Pack x = middle.x + direction * part * surface::place_apart;
      const Mask goes = worth & on_face(x);
      if (!any(goes)) continue;
      ends = middle.ends;
      found.take(goes & (depth_along(strips, x, ends, goes, 1) > found.ends.depth), x, ends);
    }
  }
  // the largest
  for (std::int32_t i = 0; i < lanes; ++i) s.piece[first + i] = found.ends.piece[i];
  store_pack(s.x + first, found.x);
  store_pack(s.u + first, found.ends.u);
  store_pack(s.depth + first, found.ends.depth);
}

/// SurfaceKernels::climb_along.
inline void climb_along_kernel(const FollowRailTask& task, FollowedStrips& s) {
  repeat_last(s);
  for (std::int32_t first = 0; first < s.count; first += lanes) climb_strips(task, first, s);
}

}  // namespace
}  // namespace wrc::simd
