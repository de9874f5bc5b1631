#include "surface/geometry/surface_geometry.hpp"

#include "base/number.hpp"
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

/// Strips on their way to overlaps with all that varies. Those of a face that changes gather until there are
/// as many as a kernel follows; all stay in their order.
struct FollowedOverlaps {
  const SurfaceGeometry& surfaces;
  const PlacedRail& rail;
  const RelativePose& pose;
  double angle, margin;
  Overlaps& o;
  std::int32_t kept;  ///< those deeper than -margin, at the beginning of `o`
  std::int32_t face;  ///< that the strips gathered belong to
  FollowedStrips gathered;

  /// Adds the other variations of the overlap, and keeps the strip if it is deeper than the margin then.
  void keep(std::int32_t strip, std::int32_t piece, double u, StripOverlap<double> s) {
    const double y = surfaces.out_of_round.rows > 0 ? evaluate(surfaces.wheel.curve, piece, u).y : 0.0;
    follow_others<double>(surfaces, rail, pose, strip, y, rail.distance, angle, s);
    if (!(s.depth > -margin)) return;
    o.strip[kept] = strip;
    o.piece[kept] = piece;
    o.u[kept] = u;
    put_strip(s, kept, o);
    ++kept;
  }

  /// Follows those that have gathered.
  void finish() {
    FollowedStrips& g = gathered;
    if (g.count == 0) return;
    follow_rail(surfaces, rail, pose, g);
    for (std::int32_t i = 0; i < g.count; ++i) keep(g.strip[i], g.piece[i], g.u[i], overlap_of(g, i));
    g.count = 0;
  }

  /// Takes overlap i, of a round wheel and a rail that is the same all along.
  void take(std::int32_t i) {
    const std::int32_t strip = o.strip[i], of_face = face_of(surfaces.varying, strip);
    StripOverlap<double> s = strip_of(o, i);
    s.grade = 0.0;
    // those gathered before come first
    if (gathered.count == FollowedStrips::most || of_face != face) finish();
    face = of_face;
    if (!changes_along(surfaces, strip)) return keep(strip, o.piece[i], o.u[i], s);

    // strips that stay clear of the margin by a first look are no candidates
    constexpr double looks_within = 0.2e-3;  // [m]
    const FirstLook look = look_along(rail, surfaces.varying, strip, s);
    LargestOverlap found{look.x, {o.piece[i], o.u[i], look.depth}};
    // far from the axle the parabola does not hold: rays look for the place
    if (magnitude(look.x) > near_axle) {
      StripOverX<double> over{surfaces.varying, surfaces.wheel.curve, pose, strip,
                              rail.distance,    rail.blend[face],     s.ny, s.nz};
      found = climb_along(over, rail.low[face], rail.high[face], look.x, {o.piece[i], o.u[i], s.depth});
    }
    if (!(found.end.depth > -margin - looks_within - surfaces.out_of_round.largest)) return;
    put_largest(strip, found, s, gathered);
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
  FollowedOverlaps followed{surfaces, rail, pose, angle, margin, o, 0, 0, {}};
  for (;;) {
    for (std::int32_t i = followed.kept; i < o.count; ++i) followed.take(i);
    followed.finish();
    o.count = followed.kept;
    if (!o.full || o.count == o.capacity) return o;
    find_more_overlaps(kernels, strips, surfaces.wheel, pose, margin + more, rail.gain, scratch, o);
  }
}

}  // namespace wrc::surface
