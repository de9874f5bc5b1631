#include "halfspace/exact_wheel.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/elementary.hpp"
#include "surface/wrench/wheel_on_rail.hpp"

namespace wrc::halfspace {
namespace {

// The knots of a curve of the real-time side, as the exact solver's own curve; z from that of the profile's
// origin, which is the nominal radius in the wheel's curve.
SectionCurve section_of(const surface::Curve& curve, double z_of_origin) {
  // knots are the pieces' beginnings and the last piece's end
  std::vector<double> y, z;
  for (std::int32_t k = 0; k <= curve.pieces; ++k) {
    const std::int32_t piece = std::min(k, curve.pieces - 1);
    const surface::CurvePoint point = surface::evaluate(curve, piece, curve.s[k] - curve.s[piece]);
    y.push_back(point.y);
    z.push_back(point.z - z_of_origin);
  }
  return {y, z};
}

// The rail where the wheel is: its strips' middles, of each face that is there. Flagged beyond the sections.
Fault find_faces(const surface::SurfaceModel& surface, const surface::WheelOnRail& problem,
                 std::vector<RailSurface>& faces) {
  // the same section everywhere: the whole profile
  if (surface.varying.faces == 0) {
    faces.push_back({.section = section_of(surface.rail_curve, 0.0)});
    return {};
  }
  // otherwise sections through the strips' middles, cut off where the real-time side cuts them
  Arena count;
  surface::cut_varying_strips(count, surface.rail_strips);
  std::vector<double> memory(static_cast<std::size_t>(count.doubles()));
  Arena arena(memory.data());
  surface::PlacedRail rail;
  const Fault outside = surface::place_rail(surface, problem.distance,
                                            surface::cut_varying_strips(arena, surface.rail_strips), rail);
  const surface::RailStrips strips = surface::strips_before(
      surface, surface::motion_at_height(surface, problem, problem.wheel.position[2]).pose, rail);
  // a check rail stands beside a rail that does not vary: its faces are straight
  const bool same_everywhere = surface::has_check_rail(surface.varying);
  for (std::int32_t r = 0; r < strips.ranges; ++r) {
    const surface::FaceStrips& range = strips.range[r];
    constexpr std::int32_t fewest = 4;  // a spline has
    if (range.count < fewest) continue;
    const auto part = [&](const double* of) {
      return std::vector<double>(of + range.first, of + range.first + range.count);
    };
    faces.push_back({.section = {part(strips.y), part(strips.z), 0.0},
                     .varying = same_everywhere ? nullptr : &surface.varying,
                     .first = range.first,
                     .distance = rail.distance,
                     .extent = same_everywhere
                                   ? RailSurface{}.extent
                                   : extent_of(surface.varying,
                                               surface.varying.face[face_of(surface.varying, range.first)],
                                               rail.distance)});
  }
  return outside;
}

// Adds a region's resultant to the wrench and begins the next. Of parallel rows it is the sum of their normal
// forces, of rows that turn less.
struct Resultant {
  double along = 0.0, across = 0.0;  // components of the sum of normal forces [N]
  void close(surface::Wrench& wrench) {
    wrench.normal_force += std::sqrt(along * along + across * across);
    along = across = 0.0;
  }
};

// Regions are runs of rows in contact on one face; the normal force is the sum of their resultants. Returns
// how many there are.
std::int32_t add_regions(const std::vector<RowForces>& rows, double cell_s, surface::Wrench& wrench) {
  std::int32_t regions = 0, face = 0;
  Resultant resultant;
  double end = -1.0;  // arc length up to which a row continues the region [m]
  for (const RowForces& row : rows) {
    // a row further than the next, or on another face, begins a region
    if (row.s > end || row.face != face) {
      resultant.close(wrench);
      ++regions;
    }
    end = row.s + 1.5 * cell_s;
    face = row.face;
    // vector sum of the rows' normal forces
    const SineCosine turned = sine_cosine(row.angle);
    resultant.along += row.normal_force * cell_s * turned.cosine;
    resultant.across += row.normal_force * cell_s * turned.sine;
    wrench.steepest_angle = std::max(wrench.steepest_angle, std::abs(row.angle));
  }
  resultant.close(wrench);
  return regions;
}

}  // namespace

Fault solve_exact_wheel(const contact::Contact& contact, const contact::HostWheel& hosted,
                        const SurfaceOptions& options, const ProgressCallback& progress,
                        contact::HostWrench& result, std::int32_t& regions) {
  contact::PlacedWheel placed;
  Fault fault = contact::place_wheel(contact, hosted, placed);
  if (fault.failed()) return fault;
  if (hosted.time != 0.0)
    return Fault::unsupported("input.time_step", {hosted.time, "s"},
                              "exact wheels roll steadily and remember nothing: leave it 0");
  // The bodies of the model: sections by arc length from their profiles' origins.
  const contact::Model& model = *contact.model;
  const surface::SurfaceModel& surface = *model.surface;
  const double radius = model.options.wheelset.nominal_radius;
  WheelAndRail bodies{.wheel = section_of(surface.wheel.curve, radius),
                      .rail = {},
                      .nominal_radius = radius,
                      .rail_y = surface.rail_origin_y,
                      .rail_z = surface.rail_origin_z,
                      .material = surface.material,
                      .coupling = model.options.coupling,
                      .roller_curvature = surface.roller_curvature,
                      .out_of_round = surface.out_of_round.rows > 0 ? &surface.out_of_round : nullptr};
  const Fault outside = find_faces(surface, placed.problem, bodies.rail);
  const SurfaceContact exact(std::move(bodies), options);
  const SurfaceSolution found = exact.solve({.state = placed.problem, .progress = progress});
  if (found.fault.failed()) return found.fault;
  fault = found.fault;
  keep_worst(fault, outside);

  // Its wrench about the wheel's reference point, then back to the host's side and point. Regions have no
  // points that could be turned: hand_back_wrench() is told of none.
  surface::Wrench& wrench = result.wrench;
  for (int k = 0; k < 3; ++k) {
    wrench.force[k] = found.force[k];
    wrench.moment[k] = found.moment[k];
  }
  wrench.height = found.height;
  wrench.area = found.area;
  wrench.peak_pressure = found.peak_pressure;
  wrench.power = found.power;
  wrench.iterations = found.turns + found.heights;
  regions = add_regions(found.row_forces, options.cell_s, wrench);
  contact::hand_back_wrench(model, placed, result);
  return fault;
}

}  // namespace wrc::halfspace
