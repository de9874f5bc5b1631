/// Overlaps of strips on a rail that varies along the track, one strip per lane
/// (surface/geometry/along_track.hpp).
#pragma once

#include "surface/geometry/along_track.hpp"
#include "surface/simd/outline_kernel.hpp"

namespace wrc::simd {
namespace {

using surface::FollowedStrips;

/// Strips of one face, seen along x: rays in the directions ny, nz.
struct StripsOverX {
  static constexpr std::int32_t lists = 4;  ///< y, z, dy/du, dz/du

  const FollowRailTask& task;
  const std::int32_t* strip;
  Pack ny, nz;
  /// Each lane's two sections hold for distances begin <= X < end [m]; `apart`, `per`: as of their weights.
  Pack begin = 1.0, end = 0.0, per = {}, apart = {};
  Pack left[lists] = {}, right[lists] = {}, left_slope[lists] = {}, right_slope[lists] = {};
  surface::SectionWeights<Pack> weights = {};  ///< at the place looked at last

  /// Looks up the sections for distances, where those at hand do not hold.
  void go_to(Pack there) {
    if (!any(!((there >= begin) & (there < end)))) return;
    constexpr double far = 1e300;
    const surface::VaryingRail& rail = *task.rail;
    const double* const at = rail.distance;
    const std::int32_t first = task.face->first_section, behind = first + task.face->sections;
    double wanted[lanes], from[lanes], to[lanes], between[lanes];
    double value[4][lists][lanes];
    store_pack(wanted, there);
    // Lane by lane: neighbouring strips may look at different sections.
    for (std::int32_t i = 0; i < lanes; ++i) {
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
      for (std::int32_t q = 0; q < lists; ++q) {
        const auto of = [&](std::int32_t section, std::int32_t list) {
          return rail.outline[(static_cast<std::int64_t>(section) * 8 + list) * rail.stride + strip[i]];
        };
        value[0][q][i] = of(one, q);
        value[1][q][i] = of(other, q);
        value[2][q][i] = within ? of(one, q + lists) : 0.0;
        value[3][q][i] = within ? of(other, q + lists) : 0.0;
      }
    }
    // 0 for both beyond the sections: there the weights are those at the nearest one
    begin = load_pack(from);
    end = load_pack(to);
    apart = load_pack(between);
    const Mask within = apart > 0.0;
    per = select(within, 1.0 / select(within, apart, 1.0), 0.0);
    for (std::int32_t q = 0; q < lists; ++q) {
      left[q] = load_pack(value[0][q]);
      right[q] = load_pack(value[1][q]);
      left_slope[q] = load_pack(value[2][q]);
      right_slope[q] = load_pack(value[3][q]);
    }
  }

  /// One of the lists there, or its derivative by the distance, where `whole` is 0.
  Pack blended(const surface::SectionWeights<Pack>& w, double whole, std::int32_t q) const {
    return (whole - w.up) * left[q] + w.up * right[q] + w.leaving * left_slope[q] +
           w.reaching * right_slope[q];
  }

  Pack share(Pack x) {
    const Pack there = task.distance + x;
    go_to(there);
    return (there - begin) * per;
  }
  surface::RayPlace<Pack> place(Pack x, Pack t) {
    weights = surface::value_weights(t, apart);
    return {x, blended(weights, 1.0, 0) - task.pose->y, blended(weights, 1.0, 1) - task.pose->z};
  }
  surface::RayPlace<Pack> place(Pack x) { return place(x, share(x)); }
  surface::RayStart<Pack> start(Pack x) {
    const Pack t = share(x);
    // the place, its slope and its curvature by the distance
    const surface::SectionWeights<Pack> first = surface::slope_weights(t, per),
                                        second = surface::curvature_weights(t, per);
    return {place(x, t), blended(first, 0.0, 0), blended(first, 0.0, 1), blended(second, 0.0, 0),
            blended(second, 0.0, 1)};
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
};

/// Newton's method for the largest overlaps within low..high, from x; the rays are turned with it. Lanes that
/// are there rest. Returns those that do not get there.
inline Mask find_largest(StripsOverX& strips, Pack& x, RayEnds& ends) {
  constexpr int most_steps = 12;
  constexpr double longest = 10e-3, close = 1e-8;  // [m]
  const FollowRailTask& task = strips.task;
  Mask goes = Pack(0.0) < 1.0;  // all lanes
  for (int n = 0; n < most_steps; ++n) {
    const surface::RayStart<Pack> from = strips.start(x);
    const surface::OverlapAlong<Pack> o =
        surface::overlap_along<Pack>(ends.on, *task.pose, from, strips.ny, strips.nz, ends.u, ends.depth);
    // the ray's end, by a step of its own
    const Pack moved = o.depth - ends.depth;
    ends.depth = select(goes, o.depth, ends.depth);
    ends.u = select(goes, o.u, ends.u);
    ends.settle(*task.wheel);
    // concave where it is to be largest; a step at most `longest`
    const Pack step = o.slope / larger(-o.bend, surface::least_curvature_left * o.own);
    const Pack next = x + smaller(larger(step, -longest), longest);
    const Pack to = smaller(larger(next, task.low), task.high) - x;
    x = select(goes, x + to, x);
    // both steps square the residual
    goes = goes & !((magnitude(to) < close) & (magnitude(moved) < close));
    if (!any(goes)) break;
    // rays along the mean of the normals there
    const Pack dy = strips.blended(strips.weights, 1.0, 2), dz = strips.blended(strips.weights, 1.0, 3),
               per = 1.0 / root(dy * dy + dz * dz);
    Pack ny = strips.ny, nz = strips.nz;
    surface::turn_rays<Pack>(o, dy * per, dz * per, ny, nz);
    strips.ny = select(goes, ny, strips.ny);
    strips.nz = select(goes, nz, strips.nz);
  }
  return goes;
}

/// The strips of so many lanes from `first` on.
inline void follow_strips(const FollowRailTask& task, std::int32_t first, FollowedStrips& s) {
  // the rays from near the largest overlap, and their ends on the wheel
  StripsOverX strips{task, s.strip + first, load_pack(s.overlap.ny + first), load_pack(s.overlap.nz + first)};
  RayEnds ends;
  for (std::int32_t i = 0; i < lanes; ++i) ends.piece[i] = s.piece[first + i];
  ends.on = pieces_of(*task.wheel, ends.piece);
  ends.u = load_pack(s.u + first);
  ends.depth = load_pack(s.depth + first);
  Pack x = load_pack(s.x + first);

  // the largest overlap; where it was not found, all is left as it was but the rays
  if (!task.at_largest) {
    const Mask lost = find_largest(strips, x, ends);
    double settled[lanes];
    store_pack(settled, select(lost, 0.0, 1.0));
    for (std::int32_t i = 0; i < lanes; ++i)
      if (settled[i] > 0.0) s.piece[first + i] = ends.piece[i];
    store_pack(s.settled + first, select(lost, 0.0, 1.0));
    store_pack(s.x + first, select(lost, load_pack(s.x + first), x));
    store_pack(s.u + first, select(lost, load_pack(s.u + first), ends.u));
    store_pack(s.depth + first, select(lost, load_pack(s.depth + first), ends.depth));
  }

  // the overlap there, and the parabola through places about it
  surface::AtLargest<Pack> at;
  at.from = strips.start(x);
  at.ny = strips.ny;
  at.nz = strips.nz;
  at.depth = ends.depth;
  at.over =
      surface::overlap_along<Pack>(ends.on, *task.pose, at.from, strips.ny, strips.nz, ends.u, ends.depth);
  const Mask inside = (x > task.low) & (x < task.high),
             at_end = (!inside) & (magnitude(x) < surface::farthest_along);
  at.end_slope = select(at_end, at.over.slope, 0.0);
  at.high = task.high;
  at.low = task.low;
  const auto depth_at = [&](Pack place) {  // along a ray in the same direction, from the largest one's end
    const surface::RayPlace<Pack> from = strips.place(place);
    RayEnds end = ends;
    for (int n = 0; n < surface::ray_steps; ++n) {
      const surface::RayBeside<Pack> beside =
          surface::step_along<Pack>(end.on, *task.pose, from, strips.ny, strips.nz, end.u, end.depth);
      end.u = beside.u;
      end.depth = beside.depth;
      end.settle(*task.wheel);
    }
    return end.depth;
  };
  surface::StripOverlap<Pack> o;
  surface::fit_along<Pack>(at, depth_at, o);
  store_pack(s.overlap.depth + first, o.depth);
  store_pack(s.overlap.centre + first, o.centre);
  store_pack(s.overlap.curvature + first, o.curvature);
  store_pack(s.overlap.ny + first, o.ny);
  store_pack(s.overlap.nz + first, o.nz);
  store_pack(s.overlap.wy + first, o.wy);
  store_pack(s.overlap.wz + first, o.wz);
  store_pack(s.overlap.grade + first, o.grade);
}

/// SurfaceKernels::follow_rail.
inline void follow_rail_kernel(const FollowRailTask& task, FollowedStrips& s) {
  // lanes behind the last repeat it
  for (std::int32_t i = s.count; i < FollowedStrips::most; ++i) {
    const std::int32_t last = s.count - 1;
    s.strip[i] = s.strip[last];
    s.piece[i] = s.piece[last];
    s.x[i] = s.x[last];
    s.u[i] = s.u[last];
    s.depth[i] = s.depth[last];
    s.overlap.ny[i] = s.overlap.ny[last];
    s.overlap.nz[i] = s.overlap.nz[last];
  }
  for (std::int32_t first = 0; first < s.count; first += lanes) follow_strips(task, first, s);
}

}  // namespace
}  // namespace wrc::simd
