#include "surface/geometry/surface_geometry.hpp"

#include <algorithm>

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
  rail = place_strips(*surfaces.kernels, varying, inside, arrays);
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

namespace {

simd::FollowRailTask follow_task(const SurfaceGeometry& surfaces, const PlacedRail& rail,
                                 const RelativePose& pose, std::int32_t face, double deep_enough) {
  const VaryingRail& varying = surfaces.varying;
  return {&varying,      &varying.face[face], &surfaces.wheel.curve, &pose,
          rail.distance, rail.low[face],      rail.high[face],       deep_enough};
}

}  // namespace

void follow_rail(const SurfaceGeometry& surfaces, const PlacedRail& rail, const RelativePose& pose,
                 FollowedStrips& s, double deep_enough) {
  const std::int32_t face = face_of(surfaces.varying, s.strip[0]);
  surfaces.kernels->surface.follow_rail(follow_task(surfaces, rail, pose, face, deep_enough), s);
}

namespace {

/// A place of contact of a strip: a top of its overlap and the ray's end there, and the contact's overlap.
struct PlaceOfContact {
  double x;
  RayEnd<double> end;
  StripOverlap<double> overlap;
  TopBounds<double> bounds;
};
PlaceOfContact followed_place(const FollowedStrips& s, std::int32_t i) {
  return {s.x[i], {s.piece[i], s.u[i], s.depth[i]}, overlap_of(s, i), unbounded};
}

/// Puts a strip's place of contact among the overlaps.
void put_place(std::int32_t strip, const PlaceOfContact& place, std::int32_t i, const Overlaps& o) {
  o.strip[i] = strip;
  o.piece[i] = place.end.piece;
  o.u[i] = place.end.u;
  o.top[i] = static_cast<float>(place.x);
  // a place has one bound, on the side of the strip's other top
  const bool none_ahead = place.bounds.ahead == unbounded.ahead;
  o.bound[i] = static_cast<float>(none_ahead ? place.bounds.behind : place.bounds.ahead);
  put_strip(place.overlap, i, o);
}

PlaceOfContact kept_place(std::int32_t i, const Overlaps& o) {
  return {o.top[i], {o.piece[i], o.u[i], o.depth[i]}, strip_of(o, i), bounds_of(o.bound[i], o.top[i])};
}

/// Lets two places change places in the arrays; numbers of strips grow by `number` from the first to the
/// second.
void swap_places(std::int32_t i, std::int32_t k, std::int32_t number, const Overlaps& o) {
  const PlaceOfContact first = kept_place(i, o);
  const std::int32_t strip = o.strip[i];
  put_place(o.strip[k] - number, kept_place(k, o), i, o);
  put_place(strip + number, first, k, o);
}

/// The row of second places of contact along the track, until it is put behind the first ones: in the same
/// arrays, from their end backwards.
struct SecondRow {
  std::int32_t count = 0;

  static std::int32_t index(std::int32_t i, const Overlaps& o) { return o.capacity - 1 - i; }
  bool is_full(const Overlaps& o) const { return o.count + count == o.capacity; }
  void take(std::int32_t strip, const PlaceOfContact& place, const Overlaps& o) {
    put_place(strip + second_places, place, index(count++, o), o);
  }
  void append_to(Overlaps& o) const {
    // turned round, then moved
    for (std::int32_t i = 0; i < count / 2; ++i) swap_places(index(i, o), index(count - 1 - i, o), 0, o);
    for (std::int32_t i = o.capacity - count; i < o.capacity; ++i)
      put_place(o.strip[i], kept_place(i, o), o.count++, o);
  }
};

/// The two rows of places of contact along the track. A strip's place is put into the row whose last place is
/// nearer to it.
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
  /// The row of a strip's only place. Two places of one strip begin the second row, not a place far from the
  /// strip before: neighbours along a nose may be 5 mm apart.
  std::int32_t row_of(double at) {
    const std::int32_t row = known[1] && off(1, at) < off(0, at) ? 1 : 0;
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

/// Error of a first look at the largest overlap along the track [m]. The second number is added for strips
/// that may touch twice, as the look may find their lower top.
constexpr double looks_within = 0.2e-3, second_looks_within = 1e-3;

/// The ranges of faces that change along the track.
RailStrips changing_ranges(const VaryingRail& rail, const RailStrips& strips) {
  RailStrips some = strips;
  some.ranges = 0;
  for (std::int32_t r = 0; r < strips.ranges; ++r)
    if (rail.face[face_of(rail, strips.range[r].first)].changes) some.range[some.ranges++] = strips.range[r];
  return some;
}

/// A top of a strip as a candidate, with the ray and the depth of its overlap there [m].
CandidateAlong candidate_at(std::int32_t strip, const LargestOverlap& at, double ny, double nz, double depth,
                            double doubt) {
  CandidateAlong top;
  top.strip = static_cast<std::int16_t>(strip);
  top.other = CandidateAlong::no_other;
  top.piece = at.end.piece;
  top.x = static_cast<float>(at.x);
  top.u = static_cast<float>(at.end.u);
  top.ray = static_cast<float>(at.end.depth);
  top.ny = static_cast<float>(ny);
  top.nz = static_cast<float>(nz);
  top.depth = static_cast<float>(depth);
  top.doubt = static_cast<float>(doubt);
  top.own = 0.0F;
  return top;
}

/// Adds strips of one face to the candidates, if they may be deep enough anywhere along the track. They are
/// `count` from `first` on of the overlaps of a round wheel with a rail that is the same all along. `gain`:
/// find_gains().
void look_for_some(const SurfaceGeometry& surfaces, const PlacedRail& rail, const RelativePose& pose,
                   const double* gain, const Overlaps& o, std::int32_t first, std::int32_t count) {
  const Kernels& kernels = *surfaces.kernels;
  const VaryingRail& varying = surfaces.varying;
  const std::int32_t face = face_of(varying, o.strip[first]);
  // a first look by the parabolas, at strips that gain along the track
  const auto stays = [&](std::int32_t i) {
    return hardly_gains(gain[o.strip[first + i]], rail, face, o.centre[first + i]);
  };
  std::int32_t still = 0;
  while (still < count && stays(still)) ++still;
  FirstLooks looks;
  if (still < count) kernels.surface.look_along({&varying, &rail, face, &o, first, count}, looks);
  LargestOverlap found[FollowedStrips::most];
  FollowedStrips far;
  far.count = 0;
  // far from the axle the parabola does not hold: rays look for the place
  const auto climbs = [&](std::int32_t i) { return magnitude(found[i].x) > near_axle; };
  for (std::int32_t i = 0; i < count; ++i) {
    const std::int32_t k = first + i, strip = o.strip[k];
    const FirstLook look =
        stays(i) ? FirstLook{o.centre[k], o.depth[k] + gain[strip]} : FirstLook{looks.x[i], looks.depth[i]};
    found[i] = {look.x, {o.piece[k], o.u[k], look.depth}};
    if (climbs(i)) put_largest(strip, {look.x, {o.piece[k], o.u[k], o.depth[k]}}, o.ny[k], o.nz[k], far);
  }
  // rays climb on where that may make them deep enough
  const double deep_enough = -rail.candidates.reach - surfaces.out_of_round.largest;
  constexpr double between = 1e-3;  // [m]: more than overlaps grow between the places of a first look
  const double worth_climbing = deep_enough - looks_within - second_looks_within - between;
  if (far.count > 0)
    kernels.surface.climb_along(follow_task(surfaces, rail, pose, face, worth_climbing), far);
  for (std::int32_t i = 0, k = 0; i < count && k < far.count; ++i) {
    if (!climbs(i)) continue;
    found[i] = {far.x[k], {far.piece[k], far.u[k], far.depth[k]}};
    ++k;
  }

  // those that may be deep enough, in the order of the strips
  CandidatesAlong& c = rail.candidates;
  ValleysOfFace valleys(rail, varying, face);
  for (std::int32_t i = 0; i < count; ++i) {
    const RayEnd<double>& end = found[i].end;
    if (!(end.depth > deep_enough - looks_within - second_looks_within)) continue;
    const std::int32_t strip = o.strip[first + i];
    const double own = o.curvature[first + i];
    const bool twice = valleys.may_touch_twice(strip, own);
    const double doubt = looks_within + (twice ? second_looks_within : 0.0);
    if (!(end.depth > deep_enough - doubt)) continue;
    CandidateAlong& top = c.top[c.count++];
    top = candidate_at(strip, found[i], o.ny[first + i], o.nz[first + i], end.depth, doubt);
    top.other = twice ? CandidateAlong::unknown : CandidateAlong::no_other;
    top.own = static_cast<float>(own);
  }
}

/// Strips on their way to overlaps with all that varies. Those of a face that changes gather until there are
/// as many as a kernel follows; all stay in their order.
struct FollowedOverlaps {
  const SurfaceGeometry& surfaces;
  const PlacedRail& rail;
  const RelativePose& pose;
  double angle, margin;
  const OverlapScratch& scratch;
  Overlaps& o;  ///< those deeper than -margin
  SecondRow& second;
  bool tops_alone;
  std::int32_t face = 0;  ///< that the strips gathered belong to
  FollowedStrips gathered;
  std::int32_t candidate[FollowedStrips::most];  ///< that each of those gathered is
  RowsAlong rows = {};
  std::int32_t first_kept = 0, first_second = 0;  ///< where the face begins in both rows

  /// Ends a face. The row that lies ahead becomes the second one, whichever the search found first.
  void end_face() {
    // numbers of strips in both rows, which change places
    const std::int32_t before = o.count - first_kept, behind = second.count - first_second,
                       both = std::min(before, behind), room = o.capacity - o.count - second.count;
    if (rows.ahead < 0.0 && std::max(before, behind) - both <= room) {
      // as many as both rows have change places, the rest of the longer one is moved
      for (std::int32_t i = 0; i < both; ++i)
        swap_places(first_kept + i, SecondRow::index(first_second + i, o), second_places, o);
      for (std::int32_t k = first_kept + both; k < first_kept + before; ++k)
        second.take(o.strip[k], kept_place(k, o), o);
      o.count = first_kept + both;
      for (std::int32_t i = first_second + both; i < first_second + behind; ++i) {
        const std::int32_t k = SecondRow::index(i, o);
        put_place(o.strip[k] - second_places, kept_place(k, o), o.count++, o);
      }
      second.count = first_second + before;
    }
    first_kept = o.count;
    first_second = second.count;
    rows = {};
  }

  /// Adds the other variations of the overlap, and keeps the strip if it is deeper than the margin then.
  void keep(std::int32_t strip, PlaceOfContact place, std::int32_t row) {
    const double y =
        surfaces.out_of_round.rows > 0 ? evaluate(surfaces.wheel.curve, place.end.piece, place.end.u).y : 0.0;
    follow_others<double>(surfaces, rail, pose, strip, y, rail.distance, angle, place.overlap);
    if (!(place.overlap.depth > -margin)) return;
    o.full = o.full || second.is_full(o);
    if (o.full) return;
    if (row > 0) return second.take(strip, place, o);
    put_place(strip, place, o.count++, o);
  }

  /// Takes the strips of faces that are the same all along.
  void take_still(const RailStrips& strips) {
    const Kernels& kernels = *surfaces.kernels;
    const double wider = margin + surfaces.out_of_round.largest;
    const std::int32_t before = o.count;
    Overlaps room = overlaps_from(o, before);
    room.capacity -= second.count;
    Overlaps found = find_overlaps(kernels, strips, surfaces.wheel, pose, wider, nullptr, scratch, room);
    // Those deeper than the margin stay once all that varies is added. They make room for others, which can
    // be no more often than the rail has strips.
    for (std::int32_t i = 0;;) {
      for (; i < found.count; ++i) {
        StripOverlap<double> s = strip_of(found, i);
        s.grade = 0.0;
        keep(found.strip[i], {s.centre, {found.piece[i], found.u[i], s.depth}, s, unbounded}, 0);
      }
      i = found.count = o.count - before;
      o.full = found.full;
      if (!found.full || found.count == found.capacity) return;
      find_more_overlaps(kernels, strips, surfaces.wheel, pose, wider, nullptr, scratch, found);
    }
  }

  /// Growth of overlaps and depth of a candidate in this pose [m].
  double growth(double ny, double nz) const { return rail.candidates.growth(ny, nz, pose.y, pose.z); }
  double depth_now(const CandidateAlong& top) const { return rail.candidates.depth(top, pose.y, pose.z); }

  /// Follows the strips that have gathered, their second tops too, and keeps their places.
  void finish() {
    FollowedStrips& g = gathered;
    const std::int32_t count = g.count;
    if (count == 0) return;
    follow_rail(surfaces, rail, pose, g, deep_enough());
    for (std::int32_t i = 0; i < count; ++i) note_place(g, i, rail.candidates.top[candidate[i]]);
    // tops beside those that were followed, from a first look or from where they were last
    FollowedStrips others;
    others.count = 0;
    std::int32_t number[FollowedStrips::most];  // among the others; -1: the strip has no other top
    std::int32_t top[FollowedStrips::most];     // numbers of the others on the list
    std::int32_t second_tops = 0;
    for (std::int32_t i = 0; i < count; ++i) {
      const std::int32_t other = other_top(i);
      number[i] = -1;
      if (other == CandidateAlong::no_other) continue;
      put_other(i, other, others);
      top[second_tops] = other;
      number[i] = second_tops++;
    }
    if (second_tops > 0) follow_rail(surfaces, rail, pose, others, deep_enough());
    for (std::int32_t i = 0; i < second_tops; ++i) note_place(others, i, rail.candidates.top[top[i]]);
    // kept strip by strip, as rows go on from one to the next
    for (std::int32_t i = 0; i < count; ++i) {
      if (number[i] >= 0)
        keep_both(g.strip[i], followed_place(g, i), followed_place(others, number[i]));
      else
        keep(g.strip[i], followed_place(g, i),
             may_touch_twice(rail, face, rail.candidates.top[candidate[i]].own) ? rows.row_of(g.x[i]) : 0);
    }
    g.count = 0;
  }

  /// Takes the candidates of a range that may be deep enough.
  void take_changing(const FaceStrips& range, double moved) {
    // depths at another height are linear in the move but for the turn of normals
    constexpr double least_doubt = 20e-6, turned = 0.1;  // [m], [-]
    const double doubt = least_doubt + turned * moved + surfaces.out_of_round.largest;
    const CandidatesAlong& c = rail.candidates;
    face = face_of(surfaces.varying, range.first);
    // strips whose overlap is surely less than the margin are left out before any ray
    const auto may_touch = [&](const CandidateAlong& top) {
      return depth_now(top) > -margin - doubt - top.doubt;
    };
    for (std::int32_t k = 0; k < c.count; ++k) {
      const CandidateAlong& top = c.top[k];
      if (!range.has(top.strip)) continue;
      if (!may_touch(top) && !(top.other >= 0 && may_touch(c.top[top.other]))) continue;
      if (gathered.count == FollowedStrips::most) finish();
      candidate[gathered.count] = k;
      put_largest(top.strip, known_place(top), top.ny, top.nz, gathered);
    }
    finish();
    end_face();
  }

 private:
  /// Depth of a top from which on its whole contact counts [m]: its parabola is hardly higher.
  double deep_enough() const {
    constexpr double none = 1.0, higher = 10e-6;
    return tops_alone ? none : -margin - surfaces.out_of_round.largest - higher;
  }

  /// Where a candidate is followed from.
  LargestOverlap known_place(const CandidateAlong& top) const {
    return {top.x, {top.piece, top.u, top.ray + growth(top.ny, top.nz)}};
  }

  /// Notes a largest overlap in the list of candidates, once for each: its first look is replaced. Depths are
  /// those at the height of the list. Of a strip's first top the doubt stays until another is known of.
  void note_place(const FollowedStrips& s, std::int32_t i, CandidateAlong& top) const {
    // depths are those at the height of the list, to nothing but the move
    const bool twice = top.other == CandidateAlong::unknown;
    const double doubt = twice ? second_looks_within : 0.0;
    if (!(top.doubt > static_cast<float>(doubt))) return;
    const double grown = growth(s.ny[i], s.nz[i]);
    const CandidateAlong before = top;
    top = candidate_at(s.strip[i], {s.x[i], {s.piece[i], s.u[i], s.depth[i] - grown}}, s.ny[i], s.nz[i],
                       s.overlap.depth[i] - grown, doubt);
    top.other = before.other;
    top.own = before.own;
  }

  StripOverX<double> seen(std::int32_t strip, const StripOverlap<double>& at) const {
    return {surfaces.varying, surfaces.wheel.curve, pose,  strip,
            rail.distance,    rail.blend[face],     at.ny, at.nz};
  }

  /// The other top of strip i of those gathered, by its number on the list: no_other, too, where it is far
  /// from touching. It is looked for once, by the rail's fall.
  std::int32_t other_top(std::int32_t i) {
    CandidatesAlong& c = rail.candidates;
    CandidateAlong& top = c.top[candidate[i]];
    if (top.other == CandidateAlong::unknown) {
      // the look begins at the top that was followed, and both are known from then on
      const PlaceOfContact first = followed_place(gathered, i);
      const StripOverlap<double>& at = first.overlap;
      const FirstLook look = look_beyond_valley(rail, surfaces.varying, gathered.strip[i],
                                                {{first.x, first.end}, at.ny, at.nz, top.own});
      // without room it is looked for, and flagged, at each height
      if (look.depth > -1.0 && c.tops == c.capacity) {
        o.full = true;
        return CandidateAlong::no_other;
      }
      top.doubt = 0.0F;
      top.other = CandidateAlong::no_other;
      if (look.depth > -1.0) {
        top.other = static_cast<std::int16_t>(c.tops);
        c.top[c.tops++] =
            candidate_at(gathered.strip[i], {look.x, {first.end.piece, first.end.u, look.depth}}, at.ny,
                         at.nz, look.depth - growth(at.ny, at.nz), second_looks_within);
      }
    }
    const bool near = top.other >= 0 && depth_now(c.top[top.other]) > -margin - second_looks_within;
    return near ? top.other : CandidateAlong::no_other;
  }

  /// Puts the other top of strip i of those gathered among the others to be followed: at first by rays from
  /// the strip's first one.
  void put_other(std::int32_t i, std::int32_t number, FollowedStrips& others) const {
    const CandidateAlong& top = rail.candidates.top[number];
    if (!(top.doubt > 0.0F)) return put_largest(top.strip, known_place(top), top.ny, top.nz, others);
    const PlaceOfContact first = followed_place(gathered, i);
    StripOverX<double> over = seen(top.strip, first.overlap);
    put_largest(top.strip, climb_second(over, rail.low[face], rail.high[face], top.x, {first.x, first.end}),
                first.overlap.ny, first.overlap.nz, others);
  }

  /// Keeps both places of a strip, each of the part and within the bounds that the other leaves it.
  void keep_both(std::int32_t strip, const PlaceOfContact& first, const PlaceOfContact& other) {
    constexpr double same = 0.1e-3;  // [m]: both are one top
    if (!(magnitude(other.x - first.x) > same)) return keep(strip, first, rows.row_of(first.x));
    StripOverX<double> over = seen(strip, first.overlap);
    const LargestOverlap valley = find_valley(over, {first.x, first.end}, other.x);
    // no top is where the valley is: the ray there had another end on the wheel, or the overlap only falls
    if (valley.x == first.x) return keep(strip, other, rows.row_of(other.x));
    if (valley.x == other.x) return keep(strip, first, rows.row_of(first.x));
    const TwoTops<double> tops = share_tops<double>({first.x, other.x, valley.x},
                                                    {first.end.depth, other.end.depth, valley.end.depth});
    // a top that does not count leaves the other as if it were alone
    for (int k = 0; k < 2; ++k)
      if (!(tops.part[k] > 0.0))
        return keep(strip, k == 0 ? other : first, rows.row_of(k == 0 ? other.x : first.x));
    // bounds are within the contacts' chords where the valley is not deep
    constexpr double reached = 0.5;
    PlaceOfContact both[2] = {first, other};
    if (!tops_alone && valley.end.depth > reached * smaller(first.end.depth, other.end.depth)) {
      FollowedStrips again;
      again.count = 0;
      for (int k = 0; k < 2; ++k)
        put_largest(strip, {both[k].x, both[k].end}, both[k].overlap.ny, both[k].overlap.nz, again,
                    tops.bounds[k]);
      follow_rail(surfaces, rail, pose, again);
      for (int k = 0; k < 2; ++k) both[k] = followed_place(again, k);
    }
    // both in their rows, each with its part of the overlap
    const std::int32_t row = rows.row_of(first.x, other.x);
    for (int k = 0; k < 2; ++k) {
      both[k].bounds = tops.bounds[k];
      double& depth = both[k].overlap.depth;
      if (depth > 0.0) depth *= tops.part[k];
      keep(strip, both[k], k == 0 ? row : 1 - row);
    }
  }
};

}  // namespace

bool candidates_hold(const CandidatesAlong& c, const RelativePose& pose, double margin) {
  constexpr double farthest = 0.6e-3;  // [m]
  const double aside = magnitude(pose.y - c.at_y), lowered = pose.z - c.at_z;
  return c.known && larger(aside, magnitude(lowered)) <= farthest &&
         margin + aside + larger(lowered, 0.0) <= c.reach;
}

void look_for_candidates(const SurfaceGeometry& surfaces, const PlacedRail& rail, const RelativePose& pose,
                         double reach, const OverlapScratch& scratch, const Overlaps& memory) noexcept {
  CandidatesAlong& c = rail.candidates;
  c.known = true;
  c.at_y = pose.y;
  c.at_z = pose.z;
  c.reach = reach;
  c.count = 0;
  // The search, of a round wheel on a rail that is the same all along, is wider by the wheel's largest reach
  // and the overlap that each strip may gain along the track.
  const Kernels& kernels = *surfaces.kernels;
  const RailStrips strips = changing_ranges(surfaces.varying, strips_before(surfaces, pose, rail));
  const double wider = reach + surfaces.out_of_round.largest;
  Overlaps o = find_overlaps(kernels, strips, surfaces.wheel, pose, wider, scratch.gain, scratch, memory);
  for (;;) {
    // as many strips of a face as the kernels take
    for (std::int32_t first = 0; first < o.count;) {
      const std::int32_t face = face_of(surfaces.varying, o.strip[first]);
      std::int32_t end = first + 1;
      while (end < o.count && end - first < FollowedStrips::most &&
             face_of(surfaces.varying, o.strip[end]) == face)
        ++end;
      look_for_some(surfaces, rail, pose, scratch.gain, o, first, end - first);
      first = end;
    }
    if (!o.full) break;
    o.count = 0;
    find_more_overlaps(kernels, strips, surfaces.wheel, pose, wider, scratch.gain, scratch, o);
  }
  c.tops = c.count;
}

Overlaps overlap_surfaces(const SurfaceGeometry& surfaces, const PlacedRail& rail, const RelativePose& pose,
                          double angle, double margin, const OverlapScratch& scratch, const Overlaps& memory,
                          bool tops_alone) noexcept {
  const VaryingRail& varying = surfaces.varying;
  const RailStrips strips = strips_before(surfaces, pose, rail);
  if (!varies(surfaces))
    return find_overlaps(*surfaces.kernels, strips, surfaces.wheel, pose, margin, nullptr, scratch, memory);
  Overlaps o = memory;
  o.count = 0;
  o.full = false;
  SecondRow second;
  FollowedOverlaps followed{surfaces, rail, pose, angle, margin, scratch, o, second, tops_alone, 0, {}, {}};
  followed.gathered.count = 0;
  if (!changes(varying)) {
    followed.take_still(strips);
    return o;
  }
  // candidates anew where those known are of another height
  const CandidatesAlong& c = rail.candidates;
  if (!candidates_hold(c, pose, margin)) {
    find_gains(*surfaces.kernels, varying, surfaces.wheel_radius, rail, scratch.gain);
    look_for_candidates(surfaces, rail, pose, margin + c.below, scratch, memory);
  }
  const double moved = larger(magnitude(pose.y - c.at_y), magnitude(pose.z - c.at_z));
  // face by face, in the order of the strips
  for (std::int32_t r = 0; r < strips.ranges && !o.full; ++r) {
    if (varying.face[face_of(varying, strips.range[r].first)].changes) {
      followed.take_changing(strips.range[r], moved);
    } else {
      RailStrips still = strips;
      still.range[0] = strips.range[r];
      still.ranges = 1;
      followed.take_still(still);
      followed.end_face();
    }
  }
  second.append_to(o);
  return o;
}

}  // namespace wrc::surface
