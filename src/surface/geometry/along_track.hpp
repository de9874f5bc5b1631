/// Changes of a strip's overlap (overlap.hpp) by a rail that varies along the track and by a wheel that is
/// not round. The overlap is found as if neither were so: the rail as it is below the wheel's reference
/// point.
///
/// The overlap over x is then d - kappa/2 (x - W_x)^2 less the fall of the rail's surface along its normal,
/// n.(P(X + x) - P(X)). Its largest value gives depth, place and curvature; the grade there is n.P'. The
/// wheel's reach (out_of_round.hpp) at the angle that lies there is added.
/// Number is double, or one that carries derivatives.
#pragma once

#include <type_traits>

#include "base/golden_section.hpp"
#include "base/number.hpp"
#include "surface/geometry/out_of_round.hpp"
#include "surface/geometry/outline.hpp"
#include "surface/geometry/overlap.hpp"
#include "surface/geometry/varying_rail.hpp"

namespace wrc::surface {

/// A concave rail is curved less than the wheel by this at least, else both would touch twice along x.
inline constexpr double least_curvature_left = 0.2;

/// Where the ray of a strip starts at a distance along the track, and how that place moves; from the wheel's
/// reference point, rail axes.
template <class Number>
struct RayStart {
  Number x, y, z;                   ///< [m]
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

/// A ray beside the wheel: where its end lies on the profile and round the wheel, and the end by a step of
/// Newton's method nearer to where both meet.
template <class Number>
struct RayBeside {
  OnProfile<Number> profile;
  Number sine, cosine,
      per_radius;  ///< angle round the axle before the lowest point; 1 / distance from the axle
  RayEnd<Number> next;
};

/// With q = R^T (P + d n) a ray meets the wheel where q_y = Y(u) and root(q_x^2 + q_z^2) = r(u).
template <class Number>
RayBeside<Number> step_along(const Curve& wheel, const RelativePoseOf<Number>& pose,
                             const RayStart<Number>& from, const Number& ny, const Number& nz,
                             const RayEnd<Number>& end) {
  const auto& R = pose.rotation;
  // the ray and its end in wheel axes
  Number ray[3], q[3];
  for (int k = 0; k < 3; ++k) {
    ray[k] = R[1][k] * ny + R[2][k] * nz;
    q[k] = R[0][k] * from.x + R[1][k] * from.y + R[2][k] * from.z + end.depth * ray[k];
  }
  PieceOf<double> piece;
  for (int d = 0; d < 4; ++d) {
    piece.y[d] = wheel.y[d][end.piece];
    piece.z[d] = wheel.z[d][end.piece];
  }
  const OnProfile<Number> p = on_profile(piece, end.u);
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
          {end.piece, end.u + (outwards * beside - ray[1] * below) * per,
           end.depth + (p.dz * beside - p.dy * below) * per}};
}

/// The overlap over x at the end of a ray, and the wheel there.
template <class Number>
struct OverlapAlong {
  RayEnd<Number> next;  ///< nearer to the ray's end by a step of Newton's method
  Number slope, bend;   ///< first and second derivative of the overlap by x [-], [1/m]
  Number ny, nz;        ///< the wheel's normal across the track, of length one
  Number own;           ///< curvature of the wheel's circle along its normal [1/m]
  Number profile_y;     ///< on the wheel's profile [m]
};

/// With N the wheel's outward normal at the ray's end and T = (1, P') the way of the ray's start, the overlap
/// changes as
///     d' = -N.T / N.n,      d'' = (II(v, v) - N.P'') / N.n,      v = T + d' n,
/// II(v, v) = (Y' r'' - r' Y'') / |(Y', r')|^3 v_s^2 - Y' / (|(Y', r')| r) v_t^2: of the wheel's surface, v_s
/// along its profile and v_t round it.
template <class Number>
OverlapAlong<Number> overlap_along(const Curve& wheel, const RelativePoseOf<Number>& pose,
                                   const RayStart<Number>& from, const Number& ny, const Number& nz,
                                   const RayEnd<Number>& end) {
  const auto& R = pose.rotation;
  const RayBeside<Number> at = step_along(wheel, pose, from, ny, nz, end);
  const OnProfile<Number>& p = at.profile;
  // slope of the overlap, from the wheel's normal N
  const Number nx = p.uy * at.sine, normal_z = p.uy * at.cosine;
  const Number N[3] = {R[0][0] * nx - R[0][1] * p.uz + R[0][2] * normal_z,
                       R[1][0] * nx - R[1][1] * p.uz + R[1][2] * normal_z,
                       R[2][0] * nx - R[2][1] * p.uz + R[2][2] * normal_z};
  const Number per_facing = Number(1.0) / (N[1] * ny + N[2] * nz);
  OverlapAlong<Number> o{at.next, {}, {}, {}, {}, p.uy * at.per_radius, p.y};
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
inline void settle(const Curve& wheel, RayEnd<double>& end) {
  while (end.u < 0.0 && end.piece > 0) {
    --end.piece;
    end.u += wheel.s[end.piece + 1] - wheel.s[end.piece];
  }
  while (end.piece + 1 < wheel.pieces && end.u > wheel.s[end.piece + 1] - wheel.s[end.piece]) {
    end.u -= wheel.s[end.piece + 1] - wheel.s[end.piece];
    ++end.piece;
  }
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

  RayStart<Number> start(const Number& x, int derivatives = std::is_same_v<Number, double> ? 2 : 3) {
    const Number there = distance + x;
    blend = blend_at(rail, rail.face[face_of(rail, strip)], value_of(there), blend, derivatives);
    const StripAlongTrack<Number> s = strip_at(rail, blend, strip, there);
    return {x, s.y - pose.y, s.z - pose.z, s.slope_y, s.slope_z, s.curvature_y, s.curvature_z};
  }
  OverlapAlong<Number> overlap(const RayStart<Number>& from, const RayEnd<Number>& end) const {
    return overlap_along(wheel, pose, from, ny, nz, end);
  }
  /// Turns the rays into the mean of both surfaces' normals at x, the place looked at last.
  void turn(const OverlapAlong<Number>& o, const Number& x) {
    Number ty, tz;
    tangent_at(rail, blend, strip, distance + x, ty, tz);
    const Number y = o.ny - tz, z = o.nz + ty, per = Number(1.0) / root(y * y + z * z);
    ny = y * per;
    nz = z * per;
  }
};

/// The largest overlap of a strip over x, in plain numbers.
struct LargestOverlap {
  double x;
  RayEnd<double> end;
};

/// The overlap at x by rays in the strip's direction, from the end of one nearby; leaves the end of this one.
inline double depth_at(StripOverX<double>& strip, double x, RayEnd<double>& end) {
  constexpr int steps = 2;
  const RayStart<double> from = strip.start(x, 0);  // a ray needs no slopes of the rail
  for (int n = 0; n < steps; ++n) {
    end = step_along(strip.wheel, strip.pose, from, strip.ny, strip.nz, end).next;
    settle(strip.wheel, end);
  }
  return end.depth;
}

/// The largest overlap near `found` where Newton's method does not settle, as on a rail that is curved back
/// and forth within millimetres: the best of places 2.5 mm apart, and a golden section about it.
inline void search_largest(StripOverX<double>& strip, double low, double high, LargestOverlap& found) {
  constexpr double apart = 2.5e-3;  // [m]
  constexpr int to_a_side = 5, steps = 18;
  RayEnd<double> end = found.end;
  double best = -1e300, at = found.x;
  for (int k = -to_a_side; k <= to_a_side; ++k) {
    const double x = smaller(larger(found.x + k * apart, low), high);
    RayEnd<double> here = end;
    const double depth = depth_at(strip, x, here);
    if (!(depth > best)) continue;
    best = depth;
    at = x;
  }
  double before = larger(at - apart, low), behind = smaller(at + apart, high);
  narrow_to_largest(before, behind, steps, [&](double x) { return depth_at(strip, x, end); });
  found.x = 0.5 * (before + behind);
  depth_at(strip, found.x, end);
  found.end = end;
}

/// Newton's method for the largest overlap within low..high, from `found`; the rays are turned with it.
inline void find_largest(StripOverX<double>& strip, double low, double high, LargestOverlap& found) {
  constexpr int most_steps = 12;
  constexpr double longest = 10e-3, close = 1e-8;  // [m]
  const LargestOverlap begin = found;
  for (int n = 0; n < most_steps; ++n) {
    const RayStart<double> from = strip.start(found.x);
    const OverlapAlong<double> o = strip.overlap(from, found.end);
    const double moved = o.next.depth - found.end.depth;
    found.end = o.next;
    settle(strip.wheel, found.end);
    // concave where it is to be largest; a step at most `longest`
    const double step = o.slope / larger(-o.bend, least_curvature_left * o.own);
    const double x = found.x + smaller(larger(step, -longest), longest);
    const double to = smaller(larger(x, low), high) - found.x;
    found.x += to;
    // both steps square the residual
    if (magnitude(to) < close && magnitude(moved) < close) return;
    strip.turn(o, from.x);
  }
  found = begin;
  search_largest(strip, low, high, found);
}

/// How far to both sides of the largest overlap d a parabola follows it, about a contact's half length [m].
/// A strip of overlap d and curvature kappa touches over root(d / kappa) to each side in a round contact.
/// Shorter chords follow kinks of flats better, longer ones the curvature of crossings (accuracy_method.md).
inline constexpr double contact_share = 0.75, least_contact_depth = 2e-6;  // [-], [m]
template <class Number>
Number half_contact(const Number& depth, const Number& curvature) {
  constexpr double longest = 12e-3;  // [m]
  return smaller(root(contact_share * (larger(depth, Number(0.0)) + least_contact_depth)) / root(curvature),
                 Number(longest));
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
  bool cut;                  ///< false: the contact ends before the surface does
};
template <class Number>
CutStrip<Number> cut_strip(const OverlapAtEnd<Number>& o) {
  const Number steep = (1.0 + 0.25 * contact_share) * o.slope, bent = 0.75 * o.curvature;
  const Number deep = contact_share * (larger(o.depth, Number(0.0)) + least_contact_depth);
  const Number length = 2.0 * deep / (steep + root(steep * steep + 4.0 * bent * deep));
  const Number end = o.slope + o.curvature * length, load = o.slope + bent * length;
  return {0.25 * length * end / load, 4.0 * load / length,
          value_of(o.slope) > -0.5 * value_of(o.curvature) * value_of(length)};
}

/// Cuts a strip's parabola off at the end of its surface. `room`: from the parabola's top to the end [m].
/// `way`: 1 ahead, -1 behind. `steep`: slope by which the overlap falls from the end into the surface, where
/// it is largest at the end, else 0 [-]. The parabola then is that of the mirror image, through the overlap
/// at `half` [m]. `least`: smallest curvature [1/m].
template <class Number>
void cut_at_end(double way, const Number& room, const Number& steep, const Number& half, const Number& least,
                StripOverlap<Number>& o) {
  const Number curvature = larger(o.curvature - 2.0 * steep / half, least);
  const OverlapAtEnd<Number> at_end{o.depth - 0.5 * curvature * room * room, steep - curvature * room,
                                    curvature};
  const CutStrip<Number> strip = cut_strip(at_end);
  if (!strip.cut) return;
  const Number t = strip.middle;
  o.centre += way * (room - t);
  o.depth = at_end.depth - t * (at_end.slope + 0.5 * curvature * t);
  o.curvature = strip.curvature;
  // slope by which the overlap falls as the wheel moves on: the end rests, and the wheel rolls over it
  o.grade = o.grade + way * (at_end.slope + curvature * t);
}

/// The end of a ray with its derivatives: two steps of Newton's method from the plain one.
template <class Number>
RayEnd<Number> carried(const StripOverX<Number>& strip, const RayStart<Number>& from,
                       const RayEnd<double>& end) {
  RayEnd<Number> carrying{end.piece, end.u, end.depth};
  for (int n = 0; n < 2; ++n)
    carrying = step_along(strip.wheel, strip.pose, from, strip.ny, strip.nz, carrying).next;
  return carrying;
}
inline RayEnd<double> carried(const StripOverX<double>&, const RayStart<double>&, const RayEnd<double>& end) {
  return end;
}

template <class Number>
RelativePose plain_pose(const RelativePoseOf<Number>& pose) {
  RelativePose plain;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) plain.rotation[i][k] = value_of(pose.rotation[i][k]);
  plain.y = value_of(pose.y);
  plain.z = value_of(pose.z);
  return plain;
}

/// The overlap of a strip on a rail that varies. `found`: a place near the largest and the ray's end, in
/// plain numbers, which become those of the largest; `o`: normal and place near those, then the strip's
/// overlap. Returns the place on the wheel's profile [m].
template <class Number>
Number follow_rail(const PlacedRail& placed, const VaryingRail& rail, const Curve& wheel,
                   const RelativePoseOf<Number>& pose, std::int32_t strip, const Number& distance,
                   LargestOverlap& found, StripOverlap<Number>& o) {
  const std::int32_t face = face_of(rail, strip);
  const RelativePose rest = plain_pose(pose);
  StripOverX<double> plain{rail,           wheel,         rest, strip, value_of(distance), placed.blend[face],
                           value_of(o.ny), value_of(o.nz)};
  const double low = placed.low[face], high = placed.high[face];
  find_largest(plain, low, high, found);
  StripOverX<Number> s{rail, wheel, pose, strip, distance, plain.blend, plain.ny, plain.nz};
  Number x = found.x;
  const bool inside = found.x > low && found.x < high,
             at_end = !inside && magnitude(found.x) < farthest_along;
  RayStart<Number> from = s.start(x);
  RayEnd<Number> end = carried(s, from, found.end);
  OverlapAlong<Number> over = s.overlap(from, end);
  if constexpr (!std::is_same_v<Number, double>) {
    // x moves as the slope there does; at the end of a face with that
    if (inside)
      x = x + over.slope * (1.0 / larger(-value_of(over.bend), least_curvature_left * value_of(over.own)));
    else if (at_end)
      x = x + (value_of(distance) - distance);
    from = s.start(x);
    end = s.overlap(from, end).next;
    s.turn(s.overlap(from, end), x);
    end = s.overlap(from, end).next;
    over = s.overlap(from, end);
  }
  o.centre = x;
  o.ny = s.ny;
  o.nz = s.nz;
  o.wy = from.y + end.depth * s.ny;
  o.wz = from.z + end.depth * s.nz;
  o.grade = s.ny * from.slope_y + s.nz * from.slope_z;
  // Parabolas through the overlap at a place and half a contact ahead and behind; beyond the end of a face
  // that on the other side. First about the largest by its curvature, then about the top of that parabola.
  const auto depth_of = [&](const Number& place) {
    RayEnd<double> there = found.end;
    depth_at(plain, value_of(place), there);
    if constexpr (std::is_same_v<Number, double>) return there.depth;
    return carried(s, s.start(place), there).depth;
  };
  const Number moved = value_of(distance) - distance;  // 0; its derivative moves the ends against the wheel
  const Number ends[2] = {high + moved, low + moved};
  Number half = half_contact(end.depth, larger(-over.bend, least_curvature_left * over.own)), top = end.depth;
  for (int pass = 0; pass < 2; ++pass) {
    if (pass > 0) {
      half = half_contact(o.depth, o.curvature);
      top = depth_of(o.centre);
    }
    const Number side[2] = {depth_of(o.centre + half), depth_of(o.centre - half)};
    const auto share = [&](const Number& room) {
      return smaller(larger(room / half, Number(0.0)), Number(1.0));
    };
    const Number ahead = side[1] + share(ends[0] - o.centre) * (side[0] - side[1]),
                 behind = side[0] + share(o.centre - ends[1]) * (side[1] - side[0]);
    fit_parabola(top, ahead, behind, half, over.own, o);
  }
  const Number to_end[2] = {ends[0] - x, x - ends[1]};
  const bool is_ahead = value_of(to_end[0]) < value_of(to_end[1]);
  const Number room = is_ahead ? to_end[0] : to_end[1];
  if (value_of(room) < value_of(half)) {
    const double way = is_ahead ? 1.0 : -1.0;
    const Number steep = at_end ? way * over.slope : Number(0.0);
    cut_at_end(way, room - way * (o.centre - x), steep, half, least_curvature_left * over.own, o);
  }
  return over.profile_y;
}

/// A place to begin at, and the overlap there [m].
struct FirstLook {
  double x, depth;
};

/// Distance from the axle up to which the parabola of the overlap below the axle holds [m]: there a flange
/// has risen by less than half a millimetre.
inline constexpr double near_axle = 20e-3;

/// The largest overlap at places along the track. Rays go from below the axle to `from` in steps of 10 mm,
/// each from the end of the one before. From there they go on as long as the overlap grows, else back.
/// Steps end at 2.5 mm about the best place, since an overlap may have two tops within 10 mm. `end`: end of
/// the ray below the axle.
inline LargestOverlap climb_along(StripOverX<double>& strip, double low, double high, double from,
                                  RayEnd<double> end) {
  const double way = from < 0.0 ? -1.0 : 1.0;
  double before = near_axle;  // distance of a place on the way to `from`
  while (before < magnitude(from)) {
    depth_at(strip, way * before, end);
    before += near_axle;
  }
  LargestOverlap found{from, end};
  depth_at(strip, from, found.end);
  for (const double step : {way * place_apart, -way * place_apart}) {
    end = found.end;
    for (double x = from + step; x >= low && x <= high; x += step) {
      if (!(depth_at(strip, x, end) > found.end.depth)) break;
      found = {x, end};
    }
    if (found.x != from) break;
  }
  for (const double apart : {0.5 * place_apart, 0.25 * place_apart}) {
    const LargestOverlap middle = found;
    for (const double x : {middle.x + apart, middle.x - apart}) {
      if (x < low || x > high) continue;
      end = middle.end;
      if (depth_at(strip, x, end) > found.end.depth) found = {x, end};
    }
  }
  return found;
}

/// The place where the overlap is largest of those along the track, or between these, by the strip's
/// parabola.
inline FirstLook look_along(const PlacedRail& placed, const VaryingRail& rail, std::int32_t strip,
                            const StripOverlap<double>& o) {
  constexpr double hardly = 50e-6;  // [m]: a gain for which Newton's method needs no better place
  const std::int32_t face = face_of(rail, strip);
  const double low = placed.low[face], high = placed.high[face];
  const double middle = smaller(larger(o.centre, low), high), most = o.depth + placed.gain[strip];
  if (placed.gain[strip] < hardly && middle == o.centre) return {middle, most};
  const auto depth_at_place = [&](const PlaceWeights& place) {
    const double off = place.x - o.centre;
    return o.depth - 0.5 * o.curvature * off * off -
           o.ny * (place_of(rail, place, strip, 0) - placed.y[strip]) -
           o.nz * (place_of(rail, place, strip, 1) - placed.z[strip]);
  };
  // the best of the places on the face, and those beside it
  double depth[track_places];
  std::int32_t best = -1;
  for (std::int32_t k = 0; k < track_places; ++k) {
    const PlaceWeights& place = placed.place[face][k];
    depth[k] = depth_at_place(place);
    if (place.x >= low && place.x <= high && (best < 0 || depth[k] > depth[best])) best = k;
  }
  // the face may end between two of these places
  for (const PlaceWeights& end : placed.end[face]) {
    if (!(magnitude(end.x) < farthest_along)) continue;
    const double here = depth_at_place(end);
    if (best < 0 || here > depth[best]) return {end.x, here};
  }
  if (best < 0) return {middle, depth_at_place(place_at(rail, rail.face[face], placed.distance, middle))};
  const double at = placed.place[face][best].x;
  if (best == 0 || best + 1 == track_places) return {at, depth[best]};
  // top of the parabola through the three
  const double rise = 0.5 * (depth[best + 1] - depth[best - 1]),
               bend = 2.0 * depth[best] - depth[best + 1] - depth[best - 1];
  const double top = bend > magnitude(rise) ? rise / bend : rise > 0.0 ? 1.0 : -1.0;
  const double x = smaller(larger(at + place_apart * top, low), high), share = (x - at) / place_apart;
  return {x, depth[best] + share * (rise - 0.5 * bend * share)};
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
