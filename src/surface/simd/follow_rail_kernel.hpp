/// Overlaps of strips on a rail that varies along the track, one strip per lane
/// (surface/geometry/along_track.hpp).
#pragma once

#include "surface/geometry/along_track.hpp"
#include "surface/simd/outline_kernel.hpp"

namespace wrc::simd {
namespace {

using surface::FollowedStrips;

using BetweenSections = surface::BetweenSections<Pack>;

/// The two sections of each lane about the distances of a ray's starts.
struct SectionsAbout {
  static constexpr std::int32_t lists = 4;  ///< y, z, dy/du, dz/du

  /// Each lane's two sections hold for distances begin <= X < end [m]; `per`: 1 over their distance,
  /// beyond all sections 0.
  Pack begin = 1.0, end = 0.0, per = {};
  BetweenSections list[lists] = {};
  Pack t = {}, t2 = {};  ///< share of the way, at the place looked at last

  /// Looks up the sections for distances, where those at hand do not hold.
  void go_to(const FollowRailTask& task, const std::int32_t* strip, Pack there) {
    if (!any(!((there >= begin) & (there < end)))) return;
    constexpr double far = 1e300;
    const surface::VaryingRail& rail = *task.rail;
    const double* const at = rail.distance;
    const std::int32_t first = task.face->first_section, behind = first + task.face->sections;
    double wanted[lanes], from[lanes], to[lanes], between[lanes];
    const double* numbers[2][lanes];  // those of a strip in both sections
    store_pack(wanted, there);
    // Lane by lane: neighbouring strips may look at different sections, most look at the same ones.
    for (std::int32_t i = 0; i < lanes; ++i) {
      if (i > 0 && wanted[i] >= from[i - 1] && wanted[i] < to[i - 1]) {
        from[i] = from[i - 1];
        to[i] = to[i - 1];
        between[i] = between[i - 1];
        for (auto& of : numbers) of[i] = of[i - 1] + (strip[i] - strip[i - 1]);
        continue;
      }
      // The first section ahead, by halving.
      std::int32_t low = first, high = behind;
      while (low < high) {
        const std::int32_t middle = (low + high) / 2;
        if (at[middle] > wanted[i])
          high = middle;
        else
          low = middle + 1;
      }
      // beyond all sections the nearest one goes on unchanged
      const bool within = low > first && low < behind;
      const std::int32_t one = low > first ? low - 1 : first, other = within ? low : one;
      from[i] = low > first ? at[one] : -far;
      to[i] = low < behind ? at[low] : far;
      between[i] = within ? to[i] - from[i] : 0.0;
      numbers[0][i] = rail.outline + static_cast<std::int64_t>(one) * 8 * rail.stride + strip[i];
      numbers[1][i] = rail.outline + static_cast<std::int64_t>(other) * 8 * rail.stride + strip[i];
    }
    begin = load_pack(from);
    end = load_pack(to);
    const Pack apart = load_pack(between);
    const Mask within = apart > 0.0;
    per = select(within, 1.0 / select(within, apart, 1.0), 0.0);
    const auto gather = [&](int section, std::int32_t q) {
      double value[lanes];
      for (std::int32_t i = 0; i < lanes; ++i) value[i] = numbers[section][i][q * rail.stride];
      return load_pack(value);
    };
    for (std::int32_t q = 0; q < lists; ++q)
      list[q] = BetweenSections::of(gather(0, q), gather(1, q), apart * gather(0, q + lists),
                                    apart * gather(1, q + lists));
  }
};

/// Strips of one face, seen along x: rays in the directions ny, nz. Rays of different ends (AlongRay) start
/// between sections of their own.
struct StripsOverX {
  const FollowRailTask& task;
  const std::int32_t* strip;
  Pack ny, nz;
  SectionsAbout about[surface::along_rays] = {};
  surface::AlongRay last = surface::ray_middle;  ///< the ray looked at last

  surface::RayStart<Pack> start(Pack x, surface::AlongRay ray = surface::ray_middle) {
    SectionsAbout& sections = about[ray];
    last = ray;
    const Pack there = task.distance + x;
    sections.go_to(task, strip, there);
    const Pack per = sections.per;
    const Pack t = sections.t = (there - sections.begin) * per, t2 = sections.t2 = t * t;
    const BetweenSections &y = sections.list[0], &z = sections.list[1];
    const Pack per2 = per * per;
    return {{x, y.value(t, t2) - task.pose->y, z.value(t, t2) - task.pose->z},
            per * y.slope(t, t2),
            per * z.slope(t, t2),
            per2 * y.curvature(t),
            per2 * z.curvature(t)};
  }
  /// Turns rays into the mean of both surfaces' normals at the place looked at last.
  void turn(const surface::OverlapAlong<Pack>& o, Pack& to_y, Pack& to_z) const {
    const SectionsAbout& at = about[last];
    const Pack dy = at.list[2].value(at.t, at.t2), dz = at.list[3].value(at.t, at.t2),
               per_length = 1.0 / root(dy * dy + dz * dz);
    surface::turn_rays<Pack>(o, dy * per_length, dz * per_length, to_y, to_z);
  }
};

/// The ends of rays on the wheel.
struct RayEnds {
  std::int32_t piece[lanes];
  Pieces on;
  Pack u, depth;

  /// Moves them on to the pieces that hold their lengths.
  void settle(const surface::Curve& wheel) {
    // most rays end on the piece where they began
    if (!any((u < 0.0) | (u > on.length))) return;
    double length[lanes];
    store_pack(length, u);
    for (std::int32_t i = 0; i < lanes; ++i) {
      surface::RayEnd<double> end{piece[i], length[i], 0.0};
      surface::settle(wheel, end);
      piece[i] = end.piece;
      length[i] = end.u;
    }
    u = load_pack(length);
    on = pieces_of(wheel, piece);
  }
  /// Takes an end nearer to the wheel in the lanes that go.
  template <class Nearer>
  void take(const Nearer& nearer, Mask goes, const surface::Curve& wheel) {
    u = select(goes, nearer.u, u);
    depth = select(goes, nearer.depth, depth);
    settle(wheel);
  }
};

/// A step of the ends of rays from there, in lanes that go.
WRC_IN_LOOP void step_ends(const StripsOverX& strips, const surface::RayStart<Pack>& from, Mask goes,
                           RayEnds& ends) {
  const FollowRailTask& task = strips.task;
  ends.take(surface::step_along<Pack>(ends.on, *task.pose, from, strips.ny, strips.nz, ends.u, ends.depth),
            goes, *task.wheel);
}

/// The overlap of rays from there by their ends.
WRC_IN_LOOP surface::OverlapAlong<Pack> overlap_of(const StripsOverX& strips,
                                                   const surface::RayStart<Pack>& from, const RayEnds& ends) {
  return surface::overlap_along<Pack>(ends.on, *strips.task.pose, from, strips.ny, strips.nz, ends.u,
                                      ends.depth);
}

/// Turns the rays of lanes that go, as the normals are at the place looked at last.
WRC_IN_LOOP void turn_where(StripsOverX& strips, const surface::OverlapAlong<Pack>& o, Mask goes) {
  Pack ny = strips.ny, nz = strips.nz;
  strips.turn(o, ny, nz);
  strips.ny = select(goes, ny, strips.ny);
  strips.nz = select(goes, nz, strips.nz);
}

/// Slope, bend and the circle's curvature at the places of the largest overlaps, as in OverlapAlong.
struct BesideLargest {
  Pack slope, bend, own;
  void take(const surface::OverlapAlong<Pack>& o, Mask lanes_that_go) {
    slope = select(lanes_that_go, o.slope, slope);
    bend = select(lanes_that_go, o.bend, bend);
    own = select(lanes_that_go, o.own, own);
  }
};

/// Newton's method for the largest overlaps within low..high, from x; the rays are turned with it. Lanes that
/// are there rest. Where it does not settle soon, as on a wheel whose curvature changes within millimetres,
/// it keeps between places from which the overlap grows towards each other. Rays that do not meet the wheel
/// properly, as on the sides of faces far from it, are left as they were.
inline BesideLargest find_largest(StripsOverX& strips, Pack& x, RayEnds& ends) {
  constexpr int most_steps = 24, soon = 4;
  constexpr double longest = 10e-3, close = 1e-8, far = 1e300;  // [m]
  const FollowRailTask& task = strips.task;
  const RayEnds first_ends = ends;
  const Pack first_x = x, first_ny = strips.ny, first_nz = strips.nz;
  Pack behind = -far, ahead = far, last = far;  // bounds of the place, and the last step [m]
  Mask goes = Pack(0.0) < 1.0;                  // all lanes
  BesideLargest largest = {};
  for (int n = 0; n < most_steps; ++n) {
    const surface::RayStart<Pack> from = strips.start(x);
    // slopes that bound the place are those at the ray's end itself
    for (int k = 0; n >= soon && k < surface::ray_steps; ++k) step_ends(strips, from, goes, ends);
    const surface::OverlapAlong<Pack> o = overlap_of(strips, from, ends);
    // the ray's end, by a step of its own
    const Pack moved = o.depth - ends.depth;
    ends.take(o, goes, *task.wheel);
    largest.take(o, goes);
    // concave where it is to be largest; a step at most `longest`
    const Pack step = o.slope / larger(-o.bend, surface::least_curvature_left * o.own);
    Pack next = x + smaller(larger(step, -longest), longest);
    if (n >= soon) {
      const Mask grows = o.slope > 0.0;
      behind = select(grows, x, behind);
      ahead = select(grows, ahead, x);
      // a step that is not half of the last one goes back and forth between them: halve instead
      const Mask bounded = far > ahead - behind, slow = 2.0 * magnitude(next - x) > last;
      const Mask between = (next >= behind) & (next <= ahead) & !(bounded & slow);
      next = select(between, next, 0.5 * (x + select(grows, ahead, behind)));
    }
    const Pack to = smaller(larger(next, task.low), task.high) - x;
    last = magnitude(to);
    x = select(goes, x + to, x);
    // both steps square the residual, once the rays have been turned
    if (n > 0) goes = goes & !((magnitude(to) < close) & (magnitude(moved) < close));
    if (!any(goes)) return largest;
    // rays along the mean of the normals there
    turn_where(strips, o, goes);
  }
  // those that are not there
  double lost[lanes];
  store_pack(lost, select(goes, 1.0, 0.0));
  for (std::int32_t i = 0; i < lanes; ++i)
    if (lost[i] > 0.0) ends.piece[i] = first_ends.piece[i];
  ends.u = select(goes, first_ends.u, ends.u);
  ends.depth = select(goes, first_ends.depth, ends.depth);
  ends.on = pieces_of(*task.wheel, ends.piece);
  x = select(goes, first_x, x);
  strips.ny = select(goes, first_ny, strips.ny);
  strips.nz = select(goes, first_nz, strips.nz);
  largest.take(overlap_of(strips, strips.start(x), ends), goes);
  return largest;
}

/// The rays that fit_along() follows contacts by, from the ends of those at the largest overlaps.
struct RaysAlong {
  StripsOverX& strips;
  RayEnds end[surface::along_rays];
  bool first[surface::along_rays] = {true, true, true};

  surface::OverlapAlong<Pack> look(surface::AlongRay ray, Pack x, Mask goes) {
    RayEnds& at = end[ray];
    // most contacts lie between the sections of their middle
    if (first[ray] && ray != surface::ray_middle) strips.about[ray] = strips.about[surface::ray_middle];
    const surface::RayStart<Pack> from = strips.start(x, ray);
    if (first[ray]) step_ends(strips, from, goes, at);
    first[ray] = false;
    surface::OverlapAlong<Pack> o = overlap_of(strips, from, at);
    at.take(o, goes, *strips.task.wheel);
    return o;
  }

  void turn_as(const surface::OverlapAlong<Pack>& o, Pack, Mask goes) { turn_where(strips, o, goes); }

  surface::AtMiddle<Pack> at_middle(Pack x) {
    RayEnds& at = end[surface::ray_middle];
    const Mask all = Pack(0.0) < 1.0;
    const surface::RayStart<Pack> from = strips.start(x);
    step_ends(strips, from, all, at);
    const surface::OverlapAlong<Pack> o = overlap_of(strips, from, at);
    Pack ny = strips.ny, nz = strips.nz;
    strips.turn(o, ny, nz);
    return {from, ny, nz, o.depth, o.own};
  }
};

/// Largest overlaps of strips along the track.
struct TopsAlong {
  Pack x;
  RayEnds ends;
  BesideLargest beside;
};

/// Overlaps of contacts about their tops, in the lanes given.
inline void take_contact(StripsOverX& strips, const surface::TopBounds<FollowedStrips::Each>& bounds,
                         std::int32_t first, const TopsAlong& top, Mask lanes_taken,
                         surface::StripOverlap<Pack>& o) {
  // the parabola of the contact
  const FollowRailTask& task = strips.task;
  const Mask inside = (top.x > task.low) & (top.x < task.high),
             at_end = (!inside) & (magnitude(top.x) < surface::farthest_along);
  const surface::AtLargest<Pack> at{top.x,
                                    top.ends.depth,
                                    top.beside.bend,
                                    top.beside.own,
                                    select(at_end, top.beside.slope, 0.0),
                                    task.high,
                                    task.low,
                                    load_pack(bounds.ahead + first),
                                    load_pack(bounds.behind + first)};
  RaysAlong rays{strips, {top.ends, top.ends, top.ends}};
  surface::StripOverlap<Pack> contact;
  surface::fit_along<Pack>(at, rays, contact);
  o.depth = select(lanes_taken, contact.depth, o.depth);
  o.centre = select(lanes_taken, contact.centre, o.centre);
  o.curvature = select(lanes_taken, contact.curvature, o.curvature);
  o.ny = select(lanes_taken, contact.ny, o.ny);
  o.nz = select(lanes_taken, contact.nz, o.nz);
  o.wy = select(lanes_taken, contact.wy, o.wy);
  o.wz = select(lanes_taken, contact.wz, o.wz);
  o.grade = select(lanes_taken, contact.grade, o.grade);
}

/// The strips of so many lanes from `first` on.
inline void follow_strips(const FollowRailTask& task, std::int32_t first, FollowedStrips& s) {
  // the rays from near the largest overlap, and their ends on the wheel
  StripsOverX strips{task, s.strip + first, load_pack(s.ny + first), load_pack(s.nz + first)};
  RayEnds ends;
  for (std::int32_t i = 0; i < lanes; ++i) ends.piece[i] = s.piece[first + i];
  ends.on = pieces_of(*task.wheel, ends.piece);
  ends.u = load_pack(s.u + first);
  ends.depth = load_pack(s.depth + first);
  Pack x = load_pack(s.x + first);

  // the largest overlap
  const BesideLargest beside = find_largest(strips, x, ends);
  for (std::int32_t i = 0; i < lanes; ++i) s.piece[first + i] = ends.piece[i];
  store_pack(s.x + first, x);
  store_pack(s.u + first, ends.u);
  store_pack(s.depth + first, ends.depth);
  store_pack(s.ny + first, strips.ny);
  store_pack(s.nz + first, strips.nz);

  // the circle at the top, without the contact's chord
  const surface::RayStart<Pack> from = strips.start(x);
  surface::StripOverlap<Pack> o;
  o.depth = ends.depth;
  o.centre = x;
  o.curvature = larger(-beside.bend, surface::least_curvature_left * beside.own);
  o.ny = strips.ny;
  o.nz = strips.nz;
  o.wy = from.y + ends.depth * strips.ny;
  o.wz = from.z + ends.depth * strips.nz;
  o.grade = 0.0;
  // a strip's overlap depends on no other strip of its vector
  const Mask deep = ends.depth > task.deep_enough;
  if (any(deep)) take_contact(strips, s.bounds, first, {x, ends, beside}, deep, o);
  store_pack(s.overlap.depth + first, o.depth);
  store_pack(s.overlap.centre + first, o.centre);
  store_pack(s.overlap.curvature + first, o.curvature);
  store_pack(s.overlap.ny + first, o.ny);
  store_pack(s.overlap.nz + first, o.nz);
  store_pack(s.overlap.wy + first, o.wy);
  store_pack(s.overlap.wz + first, o.wz);
  store_pack(s.overlap.grade + first, o.grade);
}

/// Fills the lanes behind the last strip with it.
inline void repeat_last(FollowedStrips& s) {
  for (std::int32_t i = s.count; i < FollowedStrips::most; ++i) {
    const std::int32_t last = s.count - 1;
    s.strip[i] = s.strip[last];
    s.piece[i] = s.piece[last];
    s.x[i] = s.x[last];
    s.u[i] = s.u[last];
    s.depth[i] = s.depth[last];
    s.bounds.ahead[i] = s.bounds.ahead[last];
    s.bounds.behind[i] = s.bounds.behind[last];
    s.ny[i] = s.ny[last];
    s.nz[i] = s.nz[last];
  }
}

/// SurfaceKernels::follow_rail.
inline void follow_rail_kernel(const FollowRailTask& task, FollowedStrips& s) {
  repeat_last(s);
  for (std::int32_t first = 0; first < s.count; first += lanes) follow_strips(task, first, s);
}

}  // namespace
}  // namespace wrc::simd
