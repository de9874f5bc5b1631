/// Changes of a strip's overlap (overlap.hpp) by a rail that varies along the track and by a wheel that is
/// not round. The overlap is found as if neither were so: the rail as it is below the wheel's reference
/// point.
///
/// The overlap over x is then d - kappa/2 (x - W_x)^2 less the fall of the rail's surface along its normal,
/// n.(P(X + x) - P(X)). Its largest value gives depth, place and curvature; the grade there is n.P'. The
/// wheel's reach (out_of_round.hpp) at the angle that lies there is added.
/// Number is double, or one that carries derivatives.
#pragma once

#include "base/number.hpp"
#include "surface/geometry/out_of_round.hpp"
#include "surface/geometry/outline.hpp"
#include "surface/geometry/overlap.hpp"
#include "surface/geometry/varying_rail.hpp"

namespace wrc::surface {

/// A concave rail is curved less than the wheel by this at least, else both would touch twice along x.
inline constexpr double least_curvature_left = 0.2;

/// Where the ray of a strip starts, from the wheel's reference point, rail axes [m].
template <class Number>
struct RayPlace {
  Number x, y, z;
};

/// The same, and how that place moves along the track.
template <class Number>
struct RayStart : RayPlace<Number> {
  Number slope_y, slope_z;          ///< by x [-]
  Number curvature_y, curvature_z;  ///< [1/m]
};

/// The end of a ray on the wheel's surface of revolution, as it is known: the piece of the profile, the
/// length on it [m], and the overlap along the ray [m].
template <class Number>
struct RayEnd {
  std::int32_t piece;
  Number u, depth;
};

/// Steps of Newton's method for the end of a ray, from that of one nearby.
inline constexpr int ray_steps = 2;

/// A piece of the wheel's profile.
inline PieceOf<double> piece_at(const Curve& wheel, std::int32_t piece) {
  PieceOf<double> coefficients;
  for (int d = 0; d < 4; ++d) {
    coefficients.y[d] = wheel.y[d][piece];
    coefficients.z[d] = wheel.z[d][piece];
  }
  return coefficients;
}

/// A ray beside the wheel: where its end lies on the profile and round the wheel, and the end by a step of
/// Newton's method nearer to where both meet.
template <class Number>
struct RayBeside {
  OnProfile<Number> profile;
  Number sine, cosine,
      per_radius;   ///< angle round the axle before the lowest point; 1 / distance from the axle
  Number u, depth;  ///< as RayEnd
};

/// With q = R^T (P + d n) a ray meets the wheel where q_y = Y(u) and root(q_x^2 + q_z^2) = r(u). `u`,
/// `depth`: of its end on a piece of the profile.
template <class Number, class OfPose, class Coefficient>
WRC_IN_LOOP RayBeside<Number> step_along(const PieceOf<Coefficient>& piece,
                                         const RelativePoseOf<OfPose>& pose, const RayPlace<Number>& from,
                                         const Number& ny, const Number& nz, const Number& u,
                                         const Number& depth) {
  const auto& R = pose.rotation;
  // the ray and its end in wheel axes
  Number ray[3], q[3];
  for (int k = 0; k < 3; ++k) {
    ray[k] = R[1][k] * ny + R[2][k] * nz;
    q[k] = R[0][k] * from.x + R[1][k] * from.y + R[2][k] * from.z + depth * ray[k];
  }
  const OnProfile<Number> p = on_profile(piece, u);
  const Number radius = root(q[0] * q[0] + q[2] * q[2]), per_radius = Number(1.0) / radius;
  const Number sine = q[0] * per_radius, cosine = q[2] * per_radius;
  // residuals of both conditions, and the step of depth and length that removes them
  const Number beside = q[1] - p.y, below = radius - p.radius;
  const Number outwards = sine * ray[0] + cosine * ray[2];
  const Number per = Number(1.0) / (p.dy * outwards - p.dz * ray[1]);
  return {p,
          sine,
          cosine,
          per_radius,
          u + (outwards * beside - ray[1] * below) * per,
          depth + (p.dz * beside - p.dy * below) * per};
}

/// The overlap over x at the end of a ray, and the wheel there.
template <class Number>
struct OverlapAlong {
  Number u, depth;     ///< The ray's end, nearer by a step of Newton's method.
  Number slope, bend;  ///< First and second derivative of the overlap by x [-], [1/m].
  Number ny, nz;       ///< The wheel's normal across the track, of length one.
  Number own;          ///< curvature of the wheel's circle along its normal [1/m]
  Number profile_y;    ///< on the wheel's profile [m]
};

/// With N the wheel's outward normal at the ray's end and T = (1, P') the way of the ray's start, the overlap
/// changes as
///     d' = -N.T / N.n,      d'' = (II(v, v) - N.P'') / N.n,      v = T + d' n,
/// II(v, v) = (Y' r'' - r' Y'') / |(Y', r')|^3 v_s^2 - Y' / (|(Y', r')| r) v_t^2: of the wheel's surface, v_s
/// along its profile and v_t round it.
template <class Number, class OfPose, class Coefficient>
WRC_IN_LOOP OverlapAlong<Number> overlap_along(const PieceOf<Coefficient>& piece,
                                               const RelativePoseOf<OfPose>& pose,
                                               const RayStart<Number>& from, const Number& ny,
                                               const Number& nz, const Number& u, const Number& depth) {
  const auto& R = pose.rotation;
  const RayBeside<Number> at = step_along<Number>(piece, pose, from, ny, nz, u, depth);
  const OnProfile<Number>& p = at.profile;
  // slope of the overlap, from the wheel's normal N
  const Number nx = p.uy * at.sine, normal_z = p.uy * at.cosine;
  const Number N[3] = {R[0][0] * nx - R[0][1] * p.uz + R[0][2] * normal_z,
                       R[1][0] * nx - R[1][1] * p.uz + R[1][2] * normal_z,
                       R[2][0] * nx - R[2][1] * p.uz + R[2][2] * normal_z};
  const Number per_facing = Number(1.0) / (N[1] * ny + N[2] * nz);
  OverlapAlong<Number> o;
  o.u = at.u;
  o.depth = at.depth;
  o.own = p.uy * at.per_radius;
  o.profile_y = p.y;
  o.slope = -(N[0] + N[1] * from.slope_y + N[2] * from.slope_z) * per_facing;
  // the way v on the wheel's surface: parts round it and along its profile, and the curvature of both
  const Number way_y = from.slope_y + o.slope * ny, way_z = from.slope_z + o.slope * nz;
  const auto way = [&](int k) { return R[0][k] + R[1][k] * way_y + R[2][k] * way_z; };
  const Number vx = way(0), vy = way(1), vz = way(2);
  const Number round = at.cosine * vx - at.sine * vz;
  const Number along = p.uy * vy + p.uz * (at.sine * vx + at.cosine * vz);
  const Number bent = (p.dy * p.ddz - p.dz * p.ddy) * p.per_speed * p.per_speed * p.per_speed;
  const Number second = bent * along * along - o.own * round * round;
  o.bend = (second - N[1] * from.curvature_y - N[2] * from.curvature_z) * per_facing;
  const Number per_across = Number(1.0) / root(N[1] * N[1] + N[2] * N[2]);
  o.ny = N[1] * per_across;
  o.nz = N[2] * per_across;
  return o;
}

/// Moves the end of a ray on to the piece that holds its length.
WRC_IN_LOOP void settle(const Curve& wheel, RayEnd<double>& end) {
  while (end.u < 0.0 && end.piece > 0) {
    --end.piece;
    end.u += wheel.s[end.piece + 1] - wheel.s[end.piece];
  }
  while (end.piece + 1 < wheel.pieces && end.u > wheel.s[end.piece + 1] - wheel.s[end.piece]) {
    end.u -= wheel.s[end.piece + 1] - wheel.s[end.piece];
    ++end.piece;
  }
}

/// Turns rays into the mean of both surfaces' normals, that of the rail from its unit tangent.
template <class Number>
WRC_IN_LOOP void turn_rays(const OverlapAlong<Number>& o, const Number& ty, const Number& tz, Number& ny,
                           Number& nz) {
  const Number y = o.ny - tz, z = o.nz + ty, per = Number(1.0) / root(y * y + z * z);
  ny = y * per;
  nz = z * per;
}

/// One strip of a rail that varies, seen along x: rays from its places along the track, all in one direction,
/// to the wheel.
template <class Number>
struct StripOverX {
  const VaryingRail& rail;
  const Curve& wheel;
  const RelativePoseOf<Number>& pose;
  std::int32_t strip;
  Number distance;     ///< place of the wheel's reference point [m]
  SectionBlend blend;  ///< sections at the place looked at last
  Number ny, nz;       ///< direction of the rays, into the rail

  RayStart<Number> start(const Number& x, int derivatives = 3) {
    const Number there = distance + x;
    blend = blend_at(rail, rail.face[face_of(rail, strip)], value_of(there), blend, derivatives);
    const StripAlongTrack<Number> s = strip_at(rail, blend, strip, there);
    return {{x, s.y - pose.y, s.z - pose.z}, s.slope_y, s.slope_z, s.curvature_y, s.curvature_z};
  }
};

/// The largest overlap of a strip over x, in plain numbers.
struct LargestOverlap {
  double x;
  RayEnd<double> end;
};

/// The overlap at x by rays in the strip's direction, from the end of one nearby; leaves the end of this one.
inline double depth_at(StripOverX<double>& strip, double x, RayEnd<double>& end) {
  const RayStart<double> from = strip.start(x, 0);  // a ray needs no slopes of the rail
  for (int n = 0; n < ray_steps; ++n) {
    const RayBeside<double> at = step_along<double>(piece_at(strip.wheel, end.piece), strip.pose, from,
                                                    strip.ny, strip.nz, end.u, end.depth);
    end.u = at.u;
    end.depth = at.depth;
    settle(strip.wheel, end);
  }
  return end.depth;
}

/// How far to both sides of its middle a parabola follows an overlap d, about a contact's half length [m]. A
/// strip of overlap d and curvature kappa touches over root(d / kappa) to each side in a round contact.
/// Shorter chords follow kinks of flats better, longer ones the curvature of crossings (accuracy_method.md).
inline constexpr double contact_share = 0.75, least_contact_depth = 2e-6, longest_half = 12e-3;  // [-], [m]
template <class Number>
Number half_contact(const Number& depth, const Number& curvature) {
  return smaller(root(contact_share * (larger(depth, Number(0.0)) + least_contact_depth)) / root(curvature),
                 Number(longest_half));
}

/// The overlap of a strip as a parabola: through the largest, and those half a contact to both sides of it.
template <class Number>
void fit_parabola(const Number& largest, const Number& ahead, const Number& behind, const Number& half,
                  const Number& own, StripOverlap<Number>& o) {
  const Number per = Number(1.0) / (half * half);
  const Number curvature = larger((2.0 * largest - ahead - behind) * per, least_curvature_left * own);
  const Number limit = 0.5 * half;
  const Number off = smaller(larger((ahead - behind) / (2.0 * half * curvature), -limit), limit);
  o.depth = largest + 0.5 * curvature * off * off;
  o.centre += off;
  o.curvature = curvature;
}

/// Overlap of a strip whose surface ends under the contact: d0 - s t - k/2 t^2 at the distance t from the
/// end into the surface [m].
template <class Number>
struct OverlapAtEnd {
  Number depth, slope, curvature;  ///< d0 [m], s [-], k [1/m]
};

/// The whole strip with the load and centre of a strip that the end of its surface cuts off. Plane contact of
/// a length a from a sharp end has the pressure E*/2 root((a - t) / t) (s + k (a/2 + t)). The whole strip has
///     t_c = a/4 (s + k a) / (s + 3/4 k a),      curvature 4 s / a + 3 k,      half length a/2.
/// Contact that ends with the surface has s = -k a/2. The length a is that of half_contact() for the overlap
/// d0 - s a/4 at t_c.
template <class Number>
struct CutStrip {
  Number middle, curvature;  ///< t_c [m], [1/m]
  Number mean_slope;         ///< s + k a/2 [-]: not above 0, the contact ends before the surface does
};
template <class Number>
CutStrip<Number> cut_strip(const OverlapAtEnd<Number>& o) {
  const Number steep = (1.0 + 0.25 * contact_share) * o.slope, bent = 0.75 * o.curvature;
  const Number deep = contact_share * (larger(o.depth, Number(0.0)) + least_contact_depth);
  const Number length = 2.0 * deep / (steep + root(steep * steep + 4.0 * bent * deep));
  const Number end = o.slope + o.curvature * length, load = o.slope + bent * length;
  return {0.25 * length * end / load, 4.0 * load / length, o.slope + 0.5 * o.curvature * length};
}

/// Cuts a strip's parabola off at the end of its surface, where that is near. `room`: from the parabola's top
/// to the end [m]. `way`: 1 ahead, -1 behind. `steep`: slope by which the overlap falls from the end into the
/// surface, where it is largest at the end, else 0 [-]. The parabola then is that of the mirror image,
/// through the overlap at `half` [m]. `least`: smallest curvature [1/m].
template <class Number, class Yes>
void cut_at_end(Yes near, const Number& way, const Number& room, const Number& steep, const Number& half,
                const Number& least, StripOverlap<Number>& o) {
  const Number curvature = larger(o.curvature - 2.0 * steep / half, least);
  const OverlapAtEnd<Number> at_end{o.depth - 0.5 * curvature * room * room, steep - curvature * room,
                                    curvature};
  const CutStrip<Number> strip = cut_strip(at_end);
  const Number t = strip.middle;
  const auto cut = value_of(select(near, strip.mean_slope, Number(0.0))) > 0.0;
  const auto put = [&](const Number& value, Number& to) { to = select(cut, value, to); };
  put(o.centre + way * (room - t), o.centre);
  put(at_end.depth - t * (at_end.slope + 0.5 * curvature * t), o.depth);
  put(strip.curvature, o.curvature);
  // slope by which the overlap falls as the wheel moves on: the end rests, and the wheel rolls over it
  put(o.grade + way * (at_end.slope + curvature * t), o.grade);
}

/// How far the contact about a top of an overlap may reach ahead and behind: to the valley before another
/// top. Without another top it is `unbounded`.
template <class Number>
struct TopBounds {
  Number ahead, behind;  ///< from the wheel's reference point [m]
};
inline constexpr TopBounds<double> unbounded{1e9, -1e9};
/// The bounds of a place of contact that has one at most: `bound` lies ahead of the place or behind it [m].
inline TopBounds<double> bounds_of(double bound, double place) {
  return bound > place ? TopBounds<double>{bound, unbounded.behind}
                       : TopBounds<double>{unbounded.ahead, bound};
}

/// A strip at its largest overlap along x.
template <class Number>
struct AtLargest {
  Number x, depth;       ///< its place, and the overlap along the ray there [m]
  Number bend, own;      ///< as in OverlapAlong [1/m]
  Number end_slope;      ///< Slope of the overlap where it is largest at an end of the face, else 0 [-].
  Number high, low;      ///< where the face ends, ahead and behind [m]
  Number ahead, behind;  ///< TopBounds
};

/// A strip in the middle of its contact.
template <class Number>
struct AtMiddle {
  RayStart<Number> from;
  Number ny, nz, depth, own;  ///< mean normal; overlap [m]; of OverlapAlong [1/m]
};

/// Rays that a contact is followed by: ahead, behind, and in its middle.
enum AlongRay : std::int32_t { ray_ahead, ray_behind, ray_middle, along_rays };

/// Share of a reach that lies on the face, which ends `room` away.
template <class Number>
Number share_on_face(const Number& room, const Number& reach) {
  return smaller(larger(room / reach, Number(0.0)), Number(1.0));
}

/// A number of one side, by the share of it that is on the face; for the rest that of the other side.
template <class Number>
Number on_face(const Number& own, const Number& other, const Number& share) {
  return other + share * (own - other);
}

/// A contact's length along a strip: middle and half of it, and the overlap at its ends ahead and behind [m].
template <class Number>
struct ContactChord {
  Number middle, half, depth[2];
};

/// The chord between the places ahead and behind where the overlap has fallen, from that in the middle, as a
/// parabola's falls over half a contact: by Newton's method from the largest overlap. It does not jump where
/// one of two tops within the contact becomes the larger one, as rays are turned with the middle. `rays`:
/// overlap and slope at a place by one of AlongRay, each from its own end, in lanes that still go.
template <class Number, class Rays>
ContactChord<Number> find_chord(const AtLargest<Number>& at, Rays& rays) {
  constexpr int most_rounds = 16;
  // [m]: a step from where both bodies are round is followed by a far shorter one, others by half at most
  constexpr double near_first = 1e-6, near = 1e-8, farthest = 24e-3;
  const Number least = least_curvature_left * at.own,
               first = half_contact(at.depth, larger(-at.bend, at.own));
  ContactChord<Number> chord{at.x, first, {at.depth, at.depth}};
  // before another top's contact; tops on the valley itself do not count, but must not divide by 0
  constexpr double least_room = 1e-6;  // [m]
  const Number room[2] = {larger(at.ahead - at.x, Number(least_room)),
                          larger(at.x - at.behind, Number(least_room))};
  Number reach[2] = {smaller(first, room[0]), smaller(first, room[1])};
  Number moves = 0.0;  // by how much the middle follows both ends: not where the face ends at the top
  auto goes = value_of(first) > 0.0;  // all
  for (int n = 0; n < most_rounds; ++n) {
    // overlaps in the middle, first that known, and on both sides, which fall outwards
    Number top = at.depth, top_slope = 0.0;
    if (n > 0) {
      const OverlapAlong<Number> middle = rays.look(ray_middle, chord.middle, goes);
      top = middle.depth;
      top_slope = middle.slope;
      rays.turn_as(middle, chord.middle, goes);
    }
    const OverlapAlong<Number> ahead = rays.look(ray_ahead, at.x + reach[0], goes),
                               behind = rays.look(ray_behind, at.x - reach[1], goes);
    const Number depth[2] = {ahead.depth, behind.depth};
    const Number slope[2] = {smaller(ahead.slope, -least * reach[0]),
                             smaller(-behind.slope, -least * reach[1])};
    // the depth wanted at both ends, as it is and once they and so the middle have moved
    const Number fallen = top - 0.5 * contact_share * (larger(top, Number(0.0)) + least_contact_depth);
    const Number by_middle = 0.5 * (1.0 - 0.5 * contact_share) * moves * top_slope;
    Number per[2] = {1.0 / slope[0], 1.0 / slope[1]};
    // an end in the valley before another top stays there
    for (int k = 0; k < 2; ++k) {
      const auto in_valley = value_of(reach[k]) >= value_of(room[k]),
                 above = value_of(depth[k]) > value_of(fallen);
      per[k] = select(in_valley, select(above, Number(0.0), per[k]), per[k]);
    }
    const Number widens = ((fallen - depth[0]) * per[0] - (fallen - depth[1]) * per[1]) /
                          larger(1.0 - by_middle * (per[0] - per[1]), Number(0.5));
    const Number wanted = fallen + by_middle * widens;
    // the ends' next places, a quarter to twice as far, and the overlaps there
    auto far = goes;
    for (int k = 0; k < 2; ++k) {
      const Number there = reach[k] + (wanted - depth[k]) * per[k];
      const Number next = smaller(smaller(larger(there, 0.25 * reach[k]), 2.0 * reach[k]),
                                  smaller(Number(farthest), room[k]));
      const Number step = next - reach[k];
      chord.depth[k] = select(goes, depth[k] + slope[k] * step, chord.depth[k]);
      reach[k] = select(goes, next, reach[k]);
      const auto is_far = value_of(magnitude(step)) > (n > 0 ? near : near_first);
      far = k == 0 ? is_far : far | is_far;
    }
    // the middle lies where both ends are on the face
    const Number share[2] = {share_on_face<Number>(at.high - at.x, reach[0]),
                             share_on_face<Number>(at.x - at.low, reach[1])};
    const Number to_ahead = on_face(reach[0], reach[1], share[0]),
                 to_behind = on_face(reach[1], reach[0], share[1]);
    moves = share[0] + share[1] - 1.0;
    chord.half = smaller(0.5 * (to_ahead + to_behind), Number(longest_half));
    chord.middle = at.x + 0.5 * (to_ahead - to_behind);
    goes = goes & far;
    if (!any(goes)) break;
  }
  // the overlaps at ends that were not reached, or of a contact that is cut short
  const auto too_long = value_of(chord.half) >= longest_half,
             ahead_of_face = value_of(chord.middle + chord.half) > value_of(at.high),
             behind_face = value_of(chord.middle - chord.half) < value_of(at.low);
  const auto cut = goes | too_long | ahead_of_face | behind_face;
  if (any(cut)) {
    const Number ahead = rays.look(ray_ahead, chord.middle + chord.half, cut).depth,
                 behind = rays.look(ray_behind, chord.middle - chord.half, cut).depth;
    chord.depth[0] =
        select(cut, on_face(ahead, behind, share_on_face<Number>(at.high - chord.middle, chord.half)),
               chord.depth[0]);
    chord.depth[1] =
        select(cut, on_face(behind, ahead, share_on_face<Number>(chord.middle - at.low, chord.half)),
               chord.depth[1]);
  }
  return chord;
}

/// The overlap of a strip: the parabola through that in the middle of its chord and at both ends.
template <class Number, class Rays>
void fit_along(const AtLargest<Number>& at, Rays& rays, StripOverlap<Number>& o) {
  const ContactChord<Number> chord = find_chord(at, rays);
  // place, normal and grade are those in the middle
  const AtMiddle<Number> m = rays.at_middle(chord.middle);
  o.centre = chord.middle;
  o.ny = m.ny;
  o.nz = m.nz;
  o.wy = m.from.y + m.depth * m.ny;
  o.wz = m.from.z + m.depth * m.nz;
  o.grade = m.ny * m.from.slope_y + m.nz * m.from.slope_z;
  const Number& half = chord.half;
  fit_parabola(m.depth, chord.depth[0], chord.depth[1], half, m.own, o);
  // the nearer end of the face, where it lies under the contact
  const Number to_end[2] = {at.high - at.x, at.x - at.low};
  const auto is_ahead = value_of(to_end[0]) < value_of(to_end[1]);
  const Number room = select(is_ahead, to_end[0], to_end[1]),
               way = select(is_ahead, Number(1.0), Number(-1.0));
  const auto near = value_of(room) < value_of(half);
  if (any(near))
    cut_at_end(near, way, room - way * (o.centre - at.x), way * at.end_slope, half,
               least_curvature_left * m.own, o);
}

/// Strips of one face on their way along the track, as many as the widest instruction set has lanes.
struct FollowedStrips {
  static constexpr std::int32_t most = 16;
  using Each = double[most];

  std::int32_t count;
  std::int32_t strip[most];
  /// A place near the largest overlap, the direction of the ray and its end there (RayEnd), then those of the
  /// largest.
  Each x, ny, nz;
  std::int32_t piece[most];
  Each u, depth;
  TopBounds<Each> bounds;
  StripOverlap<Each> overlap;  ///< found
};

/// Adds a strip, with this direction of its rays.
inline void put_largest(std::int32_t strip, const LargestOverlap& near, double ny, double nz,
                        FollowedStrips& s, const TopBounds<double>& bounds = unbounded) {
  const std::int32_t i = s.count++;
  s.strip[i] = strip;
  s.x[i] = near.x;
  s.piece[i] = near.end.piece;
  s.u[i] = near.end.u;
  s.depth[i] = near.end.depth;
  s.bounds.ahead[i] = bounds.ahead;
  s.bounds.behind[i] = bounds.behind;
  s.ny[i] = ny;
  s.nz[i] = nz;
}
inline StripOverlap<double> overlap_of(const FollowedStrips& s, std::int32_t i) {
  const StripOverlap<FollowedStrips::Each>& o = s.overlap;
  return {o.depth[i], o.centre[i], o.curvature[i], o.ny[i], o.nz[i], o.wy[i], o.wz[i], o.grade[i]};
}

/// A place to begin at, and the overlap there [m].
struct FirstLook {
  double x, depth;
};

/// Distance from the axle up to which the parabola of the overlap below the axle holds [m]: there a flange
/// has risen by less than half a millimetre.
inline constexpr double near_axle = 20e-3;

/// First looks of strips, by the parabolas below the axle: places where overlaps are largest along the track,
/// and the overlaps there [m].
struct FirstLooks {
  FollowedStrips::Each x, depth;
};

/// Is the overlap of a strip so near its largest that Newton's method needs no better place?
inline bool hardly_gains(double gain, const PlacedRail& placed, std::int32_t face, double centre) {
  constexpr double hardly = 50e-6;  // [m]
  return gain < hardly && centre >= placed.low[face] && centre <= placed.high[face];
}

/// Adds the fall of a roller whose radius is 1 / curvature at the profile's origin, to a strip at the height
/// z below that. `distance`: of the wheel's reference point from above its axle [m]. Its surface falls like
/// x^2 / (2 radius).
template <class Number>
void follow_roller(double curvature, double z, const Number& distance, StripOverlap<Number>& o) {
  constexpr double least_radius = 0.02;  // [m]: of faces that no wheel reaches
  const double radius = larger(1.0 / curvature - z, least_radius);
  // d - kappa/2 (x - W_x)^2 - bend/2 (x + X)^2, largest at x = W_x - off
  const Number bend = larger(o.nz, Number(0.0)) * (1.0 / radius);  // along the normal
  const Number sum = o.curvature + bend;
  const Number off = bend * (o.centre + distance) / sum;  // from the wheel's own middle, backwards
  const Number at = o.centre - off, from_axle = at + distance;
  const Number rounded = 0.5 * o.curvature * off * off;
  o.depth = o.depth - rounded - 0.5 * bend * from_axle * from_axle;
  o.wy = o.wy - o.ny * rounded;
  o.wz = o.wz - o.nz * rounded;
  o.grade = bend * from_axle;
  o.curvature = sum;
  o.centre = at;
}

/// Adds the wheel's deviation from round. `y`: on its profile [m]; `angle`: about its axle [rad].
template <class Number>
void follow_wheel(const OutOfRound& wheel, const RelativePoseOf<Number>& pose, const Number& y,
                  const Number& angle, StripOverlap<Number>& o) {
  const auto& R = pose.rotation;
  // the radius to the place, in the rail's axes
  const Number along = R[0][1] * o.centre + R[1][1] * o.wy + R[2][1] * o.wz;
  const Number ry = o.wy - along * R[1][1], rz = o.wz - along * R[2][1];
  // angle of the place before the lowest point: its sine to the third order, less the wheel's angle
  const Number before = R[0][0] * o.centre + R[1][0] * o.wy + R[2][0] * o.wz;  // along the body's x
  const Number below = R[0][2] * o.centre + R[1][2] * o.wy + R[2][2] * o.wz;
  const Number per_radius = Number(1.0) / root(before * before + below * below);
  const Number sine = before * per_radius;
  const Number turned = sine * (1.0 + sine * sine / 6.0) - angle;
  const Number outwards = (ry * o.ny + rz * o.nz) * per_radius;
  // the reach acts along the radius: its part along the strip's normal deepens the overlap
  const Reach<Number> here = reach_at(wheel, y, turned);
  const Number deeper = outwards * here.depth, round = o.curvature;
  o.depth = o.depth + deeper;
  o.wy = o.wy + o.ny * deeper;
  o.wz = o.wz + o.nz * deeper;
  o.centre = o.centre + R[0][0] * here.slope;
  // The overlap falls from there like the circle's and by the surface's deviation: to both sides of the
  // place, where the edges of the contact will be.
  const Number touched = turned + here.slope * (1.0 / wheel.radius);
  const Number middle = surface_at(wheel, y, touched).depth;
  const auto side = [&](const Number& off) {
    const Number deviation = surface_at(wheel, y, touched + off * (1.0 / wheel.radius)).depth;
    return o.depth - round * off * (0.5 * off + here.slope) + outwards * (deviation - middle);
  };
  const Number half = half_contact(o.depth, round);
  constexpr double least_of_round = 0.5;  // share of the curvature that least_curvature_left is a part of
  fit_parabola(o.depth, side(half), side(-half), half, least_of_round * round, o);
}

}  // namespace wrc::surface
