#include "surface/geometry/surface_geometry.hpp"

#include "base/number.hpp"

namespace wrc::surface {

Fault place_rail(const SurfaceGeometry& surfaces, double distance, const StripArrays& arrays,
                 PlacedRail& rail) {
  const VaryingRail& varying = surfaces.varying;
  if (varying.faces == 0) {
    rail = {surfaces.rail, distance, 0.0, {}};
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

Overlaps overlap_surfaces(const SurfaceGeometry& surfaces, const PlacedRail& rail, const RelativePose& pose,
                          double angle, double margin, const OverlapScratch& scratch,
                          const Overlaps& memory) noexcept {
  // The search, of a round wheel on a rail that is the same all along, is wider by the most that
  // follow_track() adds: on a slope a, a^2 r / 2, and more where the rail is concave; at most 2 mm, and the
  // wheel's largest reach.
  const bool varying = varies(surfaces);
  constexpr double concave = 1.5;
  const double more =
      varying ? smaller(0.5 * concave * rail.steepest * rail.steepest * surfaces.wheel_radius, 2e-3) +
                    surfaces.out_of_round.largest
              : 0.0;
  Overlaps o = find_overlaps(*surfaces.kernels, strips_before(surfaces, pose, rail), surfaces.wheel, pose,
                             margin + more, scratch, memory);
  if (!varying) return o;
  // Those deeper than the margin stay once all that varies is added.
  std::int32_t kept = 0;
  for (std::int32_t i = 0; i < o.count; ++i) {
    StripOverlap<double> s = strip_of(o, i);
    s.grade = 0.0;
    const bool round = surfaces.out_of_round.rows == 0;
    const double y = round ? 0.0 : evaluate(surfaces.wheel.curve, o.piece[i], o.u[i]).y;
    follow_track(surfaces, rail, pose, o.strip[i], y, rail.distance, angle, s);
    if (!(s.depth > -margin)) continue;
    o.strip[kept] = o.strip[i];
    o.piece[kept] = o.piece[i];
    o.u[kept] = o.u[i];
    put_strip(s, kept, o);
    ++kept;
  }
  o.count = kept;
  return o;
}

}  // namespace wrc::surface
