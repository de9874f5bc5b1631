#include "surface/geometry/overlap_slopes.hpp"

#include "surface/geometry/second_place.hpp"

namespace wrc::surface {
namespace {

RelativePose plain_pose(const RelativePoseOf<PlaceDual>& pose) {
  RelativePose plain;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) plain.rotation[i][k] = pose.rotation[i][k].value;
  plain.y = pose.y.value;
  plain.z = pose.z.value;
  return plain;
}

/// A ray beside the wheel, with derivatives; its end is on the piece of `end`.
struct RayWithSlopes {
  const PieceOf<double> piece;
  PlaceDual u, depth;

  RayWithSlopes(const Curve& wheel, const RayEnd<double>& end)
      : piece(piece_at(wheel, end.piece)), u(end.u), depth(end.depth) {}

  /// The end by Newton's method, from the plain one.
  void carry(const StripOverX<PlaceDual>& strip, const RayPlace<PlaceDual>& from) {
    for (int n = 0; n < ray_steps; ++n) {
      const RayBeside<PlaceDual> at =
          step_along<PlaceDual>(piece, strip.pose, from, strip.ny, strip.nz, u, depth);
      u = at.u;
      depth = at.depth;
    }
  }
  OverlapAlong<PlaceDual> overlap(const StripOverX<PlaceDual>& strip, const RayStart<PlaceDual>& from) const {
    return overlap_along<PlaceDual>(piece, strip.pose, from, strip.ny, strip.nz, u, depth);
  }
};

/// The rays that fit_along() follows a contact by: in plain numbers, then with derivatives.
struct RaysAlong {
  StripOverX<double> plain;
  StripOverX<PlaceDual> strip;
  RayEnd<double> end[along_rays];
  PlaceDual y_wheel;  ///< as in OverlapAlong, in the middle [m]

  /// `from`: where the ray starts.
  OverlapAlong<PlaceDual> overlap(AlongRay ray, const PlaceDual& x, RayStart<PlaceDual>& from) {
    depth_at(plain, x.value, end[ray]);
    from = strip.start(x);
    RayWithSlopes carried(strip.wheel, end[ray]);
    carried.carry(strip, from);
    return carried.overlap(strip, from);
  }
  OverlapAlong<PlaceDual> look(AlongRay ray, const PlaceDual& x, bool) {
    RayStart<PlaceDual> from;
    return overlap(ray, x, from);
  }
  void turn_as(const OverlapAlong<PlaceDual>& o, const PlaceDual& x, bool) {
    turn(o, x, strip.ny, strip.nz);
    plain.ny = strip.ny.value;
    plain.nz = strip.nz.value;
  }
  AtMiddle<PlaceDual> at_middle(const PlaceDual& x) {
    AtMiddle<PlaceDual> m;
    const OverlapAlong<PlaceDual> o = overlap(ray_middle, x, m.from);
    m.ny = strip.ny;
    m.nz = strip.nz;
    turn(o, x, m.ny, m.nz);
    m.depth = o.depth;
    m.own = o.own;
    y_wheel = o.profile_y;
    return m;
  }
  /// Turns rays into the mean of both surfaces' normals at the place looked at last.
  void turn(const OverlapAlong<PlaceDual>& o, const PlaceDual& x, PlaceDual& ny, PlaceDual& nz) const {
    PlaceDual ty, tz;
    tangent_at(strip.rail, strip.blend, strip.strip, strip.distance + x, ty, tz);
    turn_rays(o, ty, tz, ny, nz);
  }
};

/// The parts of both tops of a strip and the bounds of their contacts (share_tops()), from plain places of
/// the tops: as the overlaps there and in the valley change, and its place. `first`, `other`: the tops.
TwoTops<PlaceDual> two_tops(const StripOverX<double>& plain, const StripOverX<PlaceDual>& strip,
                            const LargestOverlap& first, const LargestOverlap& other) {
  StripOverX<double> over = plain;
  const LargestOverlap at[3] = {first, other, find_valley(over, first, other.x)};
  // overlaps by rays whose ends carry derivatives; places move as the slope of the overlap does
  PlaceDual x[3], depth[3];
  for (int k = 0; k < 3; ++k) {
    StripOverX<PlaceDual> rays = strip;
    const RayStart<PlaceDual> from = rays.start(at[k].x);
    RayWithSlopes ray(strip.wheel, at[k].end);
    ray.carry(rays, from);
    // tops are bent down, the valley up
    const OverlapAlong<PlaceDual> o = ray.overlap(rays, from);
    const double down = k < 2 ? 1.0 : -1.0,
                 bent = larger(-down * o.bend.value, least_curvature_left * o.own.value);
    x[k] = at[k].x + (o.slope - o.slope.value) * (down / bent);
    depth[k] = ray.depth;
  }
  return share_tops<PlaceDual>(x, depth);
}

}  // namespace

RelativePoseOf<PlaceDual> moving_pose(const RelativePose& pose) {
  RelativePoseOf<PlaceDual> moving;
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) moving.rotation[i][k] = pose.rotation[i][k];
    // a turn by dw changes a column c of the rotation by dw x c
    moving.rotation[1][k].d[turn_x] = -pose.rotation[2][k];
    moving.rotation[2][k].d[turn_x] = pose.rotation[1][k];
    moving.rotation[0][k].d[turn_z] = -pose.rotation[1][k];
    moving.rotation[1][k].d[turn_z] = pose.rotation[0][k];
  }
  moving.y = PlaceDual::input(pose.y, place_y);
  moving.z = PlaceDual::input(pose.z, place_z);
  return moving;
}

OverlapSlopes overlap_slopes(const SurfaceGeometry& surfaces, const PlacedRail& placed,
                             const RelativePoseOf<PlaceDual>& pose, const PlaceDual& distance,
                             FollowedStrips& near) {
  const VaryingRail& rail = surfaces.varying;
  const Curve& wheel = surfaces.wheel.curve;
  const std::int32_t strip = near.strip[0], face = face_of(rail, strip);
  const double low = placed.low[face], high = placed.high[face];
  const RelativePose rest = plain_pose(pose);
  // the largest overlap in plain numbers, and the other top
  follow_rail(surfaces, placed, rest, near);
  const RayEnd<double> end{near.piece[0], near.u[0], near.depth[0]};
  const double ny = near.overlap.ny[0], nz = near.overlap.nz[0];
  RaysAlong rays{{rail, wheel, rest, strip, distance.value, placed.blend[face], ny, nz},
                 {rail, wheel, pose, strip, distance, placed.blend[face], ny, nz},
                 {end, end, end},
                 {}};

  // bounds and part of a strip with two tops
  const PlaceDual moved = distance.value - distance;  // 0; its derivative moves the ends against the wheel
  TopBounds<PlaceDual> bounds{near.bounds.ahead[0] + moved, near.bounds.behind[0] + moved};
  PlaceDual part = 1.0;
  if (near.count > 1) {
    const TwoTops<PlaceDual> tops = two_tops(rays.plain, rays.strip, {near.x[0], end},
                                             {near.x[1], {near.piece[1], near.u[1], near.depth[1]}});
    part = tops.part[0];
    bounds = tops.bounds[0];
  }

  // x moves as the slope there does, at the end of a face with that; the rays turn as the normals do
  StripOverX<PlaceDual>& s = rays.strip;
  PlaceDual x = near.x[0];
  const bool inside = x.value > low && x.value < high,
             at_end = !inside && magnitude(x.value) < farthest_along;
  RayStart<PlaceDual> from = s.start(x);
  RayWithSlopes ray(wheel, end);
  ray.carry(s, from);
  OverlapAlong<PlaceDual> over = ray.overlap(s, from);
  if (inside)
    x = x + over.slope * (1.0 / larger(-over.bend.value, least_curvature_left * over.own.value));
  else if (at_end)
    x = x + moved;
  from = s.start(x);
  const auto step = [&] {
    over = ray.overlap(s, from);
    ray.u = over.u;
    ray.depth = over.depth;
  };
  step();
  rays.turn(ray.overlap(s, from), x, s.ny, s.nz);
  step();
  over = ray.overlap(s, from);
  const AtLargest<PlaceDual> at{
      x,           ray.depth,    over.bend,    over.own, at_end ? over.slope : PlaceDual(0.0), high + moved,
      low + moved, bounds.ahead, bounds.behind};
  OverlapSlopes o;
  fit_along(at, rays, o);
  if (o.depth.value > 0.0) o.depth = part * o.depth;
  o.y_wheel = rays.y_wheel;
  return o;
}

}  // namespace wrc::surface
