#include "surface/geometry/surface_geometry.hpp"

#include <algorithm>
#include <utility>

#include "base/number.hpp"
#include "surface/geometry/second_place.hpp"
#include "surface/simd/tasks.hpp"

namespace wrc::surface {

Fault place_rail(const SurfaceGeometry& surfaces, double distance, const StripArrays& arrays,
                 PlacedRail& rail) {
  const VaryingRail& varying = surfaces.varying;
  if (varying.faces == 0) {
    static_cast<RailStrips&>(rail) = surfaces.rail;
    rail.distance = distance;
    return {};
  }
  // sections end somewhere: beyond, the nearest one stands for the rail
  const double inside = smaller(larger(distance, varying.begin), varying.end);
  rail = place_strips(*surfaces.kernels, varying, inside, surfaces.wheel_radius, arrays);
  if (has_check_rail(varying)) {
    // it guides with the side that faces the rail; rays of the other side meet the wheel through its body
    FaceStrips& check = rail.range[0];
    while (check.count > 1 && rail.tz[check.first] < 0.0) {
      ++check.first;
      --check.count;
    }
  }
  if (inside == distance) return {};
  return Fault::beyond_sections("input.distance", {distance, "m", varying.begin, varying.end},
                                "the nearest section is used");
}

// The front of the flange touches only surfaces on its own side of its tip; rays from the other side would
// meet it through its body. Overlaps that are solved are less deep than 3 mm.
RailStrips strips_before(const SurfaceGeometry& surfaces, const RelativePose& pose,
                         const RailStrips& strips) {
  RailStrips rail = strips;
  if (rail.ranges < 2 || has_check_rail(surfaces.varying)) return rail;
  // y of the tip as the rail sees it; faces that fall to the other side (tz < 0) and lie before it are left
  // out
  constexpr double deepest = 3e-3;  // [m]
  const WheelCurve& wheel = surfaces.wheel;
  const double y = pose.y + pose.rotation[1][1] * wheel.knot_y[wheel.flange_tip] +
                   pose.rotation[1][2] * wheel.knot_radius[wheel.flange_tip];
  for (std::int32_t r = 0; r < rail.ranges; ++r) {
    FaceStrips& face = rail.range[r];
    while (face.count > 1 && rail.tz[face.first] < 0.0 && rail.y[face.first] < y - deepest) {
      ++face.first;
      --face.count;
    }
  }
  return rail;
}

void follow_rail(const SurfaceGeometry& surfaces, const PlacedRail& rail, const RelativePose& pose,
                 FollowedStrips& s) {
  const VaryingRail& varying = surfaces.varying;
  const std::int32_t face = face_of(varying, s.strip[0]);
  surfaces.kernels->surface.follow_rail({&varying, &varying.face[face], &surfaces.wheel.curve, &pose,
                                         rail.distance, rail.low[face], rail.high[face]},
                                        s);
}

namespace {

/// A place of contact of a strip: a top of its overlap and the ray's end there, and the contact's overlap.
struct PlaceOfContact {
  double x;
  RayEnd<double> end;
  StripOverlap<double> overlap;
  TopBounds<double> bounds;
  double part;  ///< part of the overlap that counts [-]
};
PlaceOfContact place_of(const FollowedStrips& s, std::int32_t i) {
  return {s.x[i], {s.piece[i], s.u[i], s.depth[i]}, overlap_of(s, i), unbounded, 1.0};
}

/// Puts a strip's place of contact among the overlaps.
void put_place(std::int32_t strip, const PlaceOfContact& place, std::int32_t i, const Overlaps& o) {
  o.strip[i] = strip;
  o.piece[i] = place.end.piece;
  o.u[i] = place.end.u;
  // a place has one bound, on the side of the strip's other top
  const bool none_ahead = place.bounds.ahead == unbounded.ahead;
  o.bound[i] = static_cast<float>(none_ahead ? place.bounds.behind : place.bounds.ahead);
  o.part[i] = static_cast<float>(place.part);
  put_strip(place.overlap, i, o);
}

PlaceOfContact kept_place(std::int32_t i, const Overlaps& o) {
  return {o.centre[i],
          {o.piece[i], o.u[i], o.depth[i]},
          strip_of(o, i),
          bounds_of(o.bound[i], o.centre[i]),
          o.part[i]};
}

/// Second places of contact along the track, until they are put behind the first ones.
struct SecondRow {
  static constexpr std::int32_t most = 64;

  std::int32_t count = 0;
  bool full = false;
  std::int32_t strip[most];
  PlaceOfContact place[most];

  SecondRow() {}  // NOLINT: its arrays are not filled, as most rails have no second places

  void take(std::int32_t of, const PlaceOfContact& at) {
    full = count == most;
    if (full) return;
    strip[count] = of + second_places;
    place[count++] = at;
  }
  void append_to(Overlaps& o) const {
    o.full = o.full || full;
    for (std::int32_t i = 0; i < count; ++i) {
      if (o.count == o.capacity) {
        o.full = true;
        return;
      }
      put_place(strip[i], place[i], o.count++, o);
    }
  }
};

/// The two rows of places of contact along the track: a place is in that row in which the strip before has
/// its own nearer to it.
struct RowsAlong {
  bool known[2] = {false, false};
  double x[2] = {0.0, 0.0};  ///< place of the strip that was last in each row [m]
  double ahead = 0.0;        ///< sum of how far second places are ahead of first ones [m]

  double off(std::int32_t row, double at) const {
    constexpr double of_none = 5e-3;  // [m]: a place farther from the strip before begins the other row
    return known[row] ? magnitude(at - x[row]) : of_none;
  }
  void put(std::int32_t row, double at) {
    known[row] = true;
    x[row] = at;
  }
  /// The row of a strip's only place.
  std::int32_t row_of(double at) {
    const std::int32_t row = known[0] && off(1, at) < off(0, at) ? 1 : 0;
    put(row, at);
    return row;
  }
  /// The row of the first of a strip's two places; the other is in the other row.
  std::int32_t row_of(double first, double other) {
    const double straight = off(0, first) + off(1, other), crossed = off(1, first) + off(0, other);
    const std::int32_t row = straight == crossed ? (first < other ? 0 : 1) : (straight < crossed ? 0 : 1);
    put(row, first);
    put(1 - row, other);
    ahead += x[1] - x[0];
    return row;
  }
};

/// Strips on their way to overlaps with all that varies. Those of a face that changes gather until there are
/// as many as a kernel follows; all stay in their order.
struct FollowedOverlaps {
  const SurfaceGeometry& surfaces;
  const PlacedRail& rail;
  const RelativePose& pose;
  double angle, margin;
  Overlaps& o;
  SecondRow& second;
  std::int32_t kept = 0;  ///< those deeper than -margin, at the beginning of `o`
  std::int32_t face = 0;  ///< that the strips gathered belong to
  FollowedStrips gathered = {};
  double own[FollowedStrips::most] = {};  ///< curvature of the wheel at those [1/m]
  RowsAlong rows = {};
  std::int32_t first_kept = 0, first_second = 0;  ///< where the face begins in both rows

  /// Ends a face: places ahead are the second ones, so that a row's numbers do not depend on where it begins.
  void end_face() {
    // strips in both rows, which change places
    const std::int32_t before = kept - first_kept, behind = second.count - first_second;
    if (rows.ahead < 0.0 && first_second + before <= SecondRow::most) {
      PlaceOfContact* const to = second.place + first_second;
      for (std::int32_t i = 0; i < std::max(before, behind); ++i) {
        const std::int32_t k = first_kept + i;
        const PlaceOfContact place = i < before ? kept_place(k, o) : PlaceOfContact{};
        const std::int32_t strip = i < before ? o.strip[k] + second_places : 0;
        if (i < behind) put_place(second.strip[first_second + i] - second_places, to[i], k, o);
        to[i] = place;
        second.strip[first_second + i] = strip;
      }
      kept = first_kept + behind;
      second.count = first_second + before;
    }
    first_kept = kept;
    first_second = second.count;
    rows = {};
  }

  /// Adds the other variations of the overlap, and keeps the strip if it is deeper than the margin then.
  void keep(std::int32_t strip, PlaceOfContact&& place, std::int32_t row) {
    const double y =
        surfaces.out_of_round.rows > 0 ? evaluate(surfaces.wheel.curve, place.end.piece, place.end.u).y : 0.0;
    follow_others<double>(surfaces, rail, pose, strip, y, rail.distance, angle, place.overlap);
    if (!(place.overlap.depth > -margin)) return;
    if (row > 0) return second.take(strip, place);
    put_place(strip, place, kept, o);
    ++kept;
  }

  /// Follows those that have gathered.
  void finish() {
    FollowedStrips& g = gathered;
    if (g.count == 0) return;
    follow_rail(surfaces, rail, pose, g);
    // those with another top follow that, too
    bool twice = false;
    for (std::int32_t i = 0; i < g.count; ++i) twice = twice || may_touch_twice(rail, face, own[i]);
    if (!twice) {
      for (std::int32_t i = 0; i < g.count; ++i) keep(g.strip[i], place_of(g, i), 0);
      g.count = 0;
      return;
    }
    FollowedStrips others;
    others.count = 0;
    std::int32_t number[FollowedStrips::most];
    for (std::int32_t i = 0; i < g.count; ++i)
      if (may_touch_twice(rail, face, own[i]) && look_for_second(i, others)) number[others.count - 1] = i;
    if (others.count > 0) follow_rail(surfaces, rail, pose, others);
    // kept strip by strip, as rows go on from one to the next
    for (std::int32_t i = 0, k = 0; i < g.count; ++i) {
      if (k < others.count && number[k] == i)
        keep_both(g.strip[i], place_of(g, i), place_of(others, k++));
      else
        keep(g.strip[i], place_of(g, i), may_touch_twice(rail, face, own[i]) ? rows.row_of(g.x[i]) : 0);
    }
    g.count = 0;
  }

  /// Takes overlap i, of a round wheel and a rail that is the same all along.
  void take(std::int32_t i) {
    const std::int32_t strip = o.strip[i], of_face = face_of(surfaces.varying, strip);
    StripOverlap<double> s = strip_of(o, i);
    s.grade = 0.0;
    // those gathered before come first
    if (gathered.count == FollowedStrips::most || of_face != face) finish();
    if (of_face != face) end_face();
    face = of_face;
    if (!changes_along(surfaces, strip))
      return keep(strip, {s.centre, {o.piece[i], o.u[i], s.depth}, s, unbounded, 1.0}, 0);

    // strips that stay clear of the margin by a first look are no candidates
    const double looks_within = may_touch_twice(rail, face, s.curvature) ? second_looked : first_looked;
    const FirstLook look = look_along(rail, surfaces.varying, strip, s);
    LargestOverlap found{look.x, {o.piece[i], o.u[i], look.depth}};
    // far from the axle the parabola does not hold: rays look for the place
    if (magnitude(look.x) > near_axle) {
      StripOverX<double> over = seen(strip, s);
      found = climb_along(over, rail.low[face], rail.high[face], look.x, {o.piece[i], o.u[i], s.depth});
    }
    if (!(found.end.depth > -margin - looks_within - surfaces.out_of_round.largest)) return;
    own[gathered.count] = s.curvature;
    put_largest(strip, found, s, gathered);
  }

 private:
  static constexpr double first_looked = 0.2e-3, second_looked = 1e-3;  // [m]

  StripOverX<double> seen(std::int32_t strip, const StripOverlap<double>& at) const {
    return {surfaces.varying, surfaces.wheel.curve, pose,  strip,
            rail.distance,    rail.blend[face],     at.ny, at.nz};
  }

  /// Adds the other top of strip i of those gathered, if it has one.
  bool look_for_second(std::int32_t i, FollowedStrips& others) const {
    // by the rail's fall first, then by rays
    const PlaceOfContact first = place_of(gathered, i);
    const std::int32_t strip = gathered.strip[i];
    const LargestOverlap top{first.x, first.end};
    const FirstLook look =
        look_beyond_valley(rail, surfaces.varying, strip, {top, first.overlap.ny, first.overlap.nz, own[i]});
    if (!(look.depth > -margin - second_looked)) return false;
    StripOverX<double> over = seen(strip, first.overlap);
    put_largest(strip, climb_second(over, rail.low[face], rail.high[face], look.x, top), first.overlap,
                others);
    return true;
  }

  /// Keeps both places of a strip, each of the part and within the bounds that the other leaves it.
  void keep_both(std::int32_t strip, const PlaceOfContact& first, const PlaceOfContact& other) {
    constexpr double same = 0.1e-3;  // [m]: both are one top
    if (!(magnitude(other.x - first.x) > same))
      return keep(strip, PlaceOfContact(first), rows.row_of(first.x));
    StripOverX<double> over = seen(strip, first.overlap);
    const LargestOverlap valley = find_valley(over, {first.x, first.end}, other.x);
    const TwoTops tops = share_tops({first.x, other.x}, {first.end.depth, other.end.depth}, valley);
    // bounds are within the contacts' chords where the valley is not deep
    constexpr double reached = 0.5;
    PlaceOfContact both[2] = {first, other};
    if (valley.end.depth > reached * smaller(first.end.depth, other.end.depth)) {
      FollowedStrips again;
      again.count = 0;
      for (int k = 0; k < 2; ++k)
        put_largest(strip, {both[k].x, both[k].end}, both[k].overlap, again, tops.bounds[k]);
      follow_rail(surfaces, rail, pose, again);
      for (int k = 0; k < 2; ++k) both[k] = place_of(again, k);
    }
    // both in their rows, each with its part of the overlap
    const std::int32_t row = rows.row_of(first.x, other.x);
    for (int k = 0; k < 2; ++k) {
      both[k].bounds = tops.bounds[k];
      both[k].part = tops.part[k];
      double& depth = both[k].overlap.depth;
      if (depth > 0.0) depth *= tops.part[k];
      keep(strip, std::move(both[k]), k == 0 ? row : 1 - row);
    }
  }
};

}  // namespace

Overlaps overlap_surfaces(const SurfaceGeometry& surfaces, const PlacedRail& rail, const RelativePose& pose,
                          double angle, double margin, const OverlapScratch& scratch,
                          const Overlaps& memory) noexcept {
  // The search, of a round wheel on a rail that is the same all along, is wider by the wheel's largest reach
  // and the overlap that each strip may gain along the track.
  const bool varying = varies(surfaces);
  const double more = varying ? surfaces.out_of_round.largest : 0.0;
  const Kernels& kernels = *surfaces.kernels;
  const RailStrips strips = strips_before(surfaces, pose, rail);
  Overlaps o =
      find_overlaps(kernels, strips, surfaces.wheel, pose, margin + more, rail.gain, scratch, memory);
  if (!varying) return o;
  // Those deeper than the margin stay once all that varies is added. They make room for others, which can be
  // no more often than the rail has strips.
  SecondRow second;
  FollowedOverlaps followed{surfaces, rail, pose, angle, margin, o, second};
  for (;;) {
    for (std::int32_t i = followed.kept; i < o.count; ++i) followed.take(i);
    followed.finish();
    o.count = followed.kept;
    if (!o.full || o.count == o.capacity) break;
    find_more_overlaps(kernels, strips, surfaces.wheel, pose, margin + more, rail.gain, scratch, o);
  }
  followed.end_face();
  o.count = followed.kept;
  second.append_to(o);
  return o;
}

}  // namespace wrc::surface
