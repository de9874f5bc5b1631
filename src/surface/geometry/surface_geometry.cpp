#include "surface/geometry/surface_geometry.hpp"

#include "base/number.hpp"

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

namespace {

/// The overlap of a strip, and the end of its ray.
struct FollowedStrip : StripOverlap<double> {
  RayEnd<double> end;
};

/// Adds all that varies to the overlap of one strip. Returns whether it is deeper than -margin then.
bool follow_track(const SurfaceGeometry& surfaces, const PlacedRail& rail, const RelativePose& pose,
                  std::int32_t strip, double angle, double margin, FollowedStrip& o) {
  const Curve& wheel = surfaces.wheel.curve;
  const bool round = surfaces.out_of_round.rows == 0;
  double y = 0.0;
  if (changes_along(surfaces, strip)) {
    // strips that stay clear of the margin by a first look are no candidates
    constexpr double looks_within = 0.2e-3;  // [m]
    const FirstLook look = look_along(rail, surfaces.varying, strip, o);
    LargestOverlap found{look.x, {o.end.piece, o.end.u, look.depth}};
    if (magnitude(look.x) > near_axle) {
      const std::int32_t face = face_of(surfaces.varying, strip);
      StripOverX<double> s{surfaces.varying, wheel, pose, strip, rail.distance, rail.blend[face], o.ny, o.nz};
      found = climb_along(s, rail.low[face], rail.high[face], look.x, o.end);
    }
    if (!(found.end.depth > -margin - looks_within - surfaces.out_of_round.largest)) return false;
    y = follow_rail<double>(rail, surfaces.varying, wheel, pose, strip, rail.distance, found, o);
    o.end = found.end;
  } else if (!round) {
    y = evaluate(wheel, o.end.piece, o.end.u).y;
  }
  follow_others<double>(surfaces, rail, pose, strip, y, rail.distance, angle, o);
  return o.depth > -margin;
}

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
  std::int32_t kept = 0;
  for (;;) {
    for (std::int32_t i = kept; i < o.count; ++i) {
      FollowedStrip s{strip_of(o, i), {o.piece[i], o.u[i], o.depth[i]}};
      s.grade = 0.0;
      if (!follow_track(surfaces, rail, pose, o.strip[i], angle, margin, s)) continue;
      o.strip[kept] = o.strip[i];
      o.piece[kept] = s.end.piece;
      o.u[kept] = s.end.u;
      put_strip(s, kept, o);
      ++kept;
    }
    o.count = kept;
    if (!o.full || kept == o.capacity) return o;
    find_more_overlaps(kernels, strips, surfaces.wheel, pose, margin + more, rail.gain, scratch, o);
  }
}

}  // namespace wrc::surface
