#include "surface/wrench/wheel_overlaps.hpp"

#include "base/number.hpp"
#include "surface/geometry/along_track.hpp"
#include "surface/pressure/planar_pressure.hpp"

namespace wrc {
namespace {

/// Corrects overlaps for a rail that changes along the track and a wheel that is not round (along_track.hpp);
/// those within the margin stay.
void correct_along_track(const WheelProblem& problem, const RelativeMotion& motion, double margin,
                         WheelOverlaps& o) {
  const SurfaceModel& model = problem.model;
  const RailBelow& rail = problem.rail;
  std::int32_t count = 0;
  for (std::int32_t i = 0; i < o.count; ++i) {
    const std::int32_t j = o.strip[i];
    // rail, roller and wheel in turn, each to the overlap that the one before has left
    StripOverlap<double> s = strip_of(o, i);
    s.lean = 0.0;
    if (model.varying.faces > 0) follow_rail(model.varying, j, rail.distance, rail.blend, s);
    if (model.roller_curvature != 0.0)
      follow_roller(model.roller_curvature, rail.strips.z[j], rail.distance, s);
    if (model.out_of_round.rows > 0) {
      const double y = evaluate(model.wheel.curve, o.rays.piece[j], o.rays.along[j]).y;
      follow_wheel(model.out_of_round, motion.pose, y, problem.in.angle, s);
    }
    if (!(s.depth > -margin)) continue;

    // move it up to the place of those that fell out
    o.strip[count] = j;
    o.depth[count] = s.depth;
    o.centre[count] = s.centre;
    o.curvature[count] = s.curvature;
    o.ny[count] = s.ny;
    o.nz[count] = s.nz;
    o.wy[count] = s.wy;
    o.wz[count] = s.wz;
    o.lean[count] = s.lean;
    ++count;
  }
  o.count = count;
}

}  // namespace

Fault place_rail(const SurfaceModel& model, const WheelOnRail& in, double* memory, RailBelow& rail) {
  rail.strips = model.rail;
  rail.distance = in.distance;
  rail.steepest = 0.0;
  if (model.varying.faces == 0) return {};
  return place_strips(*model.kernels, model.varying, memory, most_strips_of_a_rail, rail.distance,
                      rail.strips, rail.blend, rail.steepest);
}

RelativeMotion motion_at_height(const SurfaceModel& model, const WheelOnRail& in, double height) {
  WheelMotion wheel = in.wheel;
  wheel.position[2] = height;
  return relative_motion(model, wheel, in.rail, in.distance);
}

std::int32_t flange_tip(const WheelCurve& wheel) {
  std::int32_t tip = 0;
  for (std::int32_t k = 1; k < wheel.knots; ++k)
    if (wheel.knot_radius[k] > wheel.knot_radius[tip]) tip = k;
  return tip;
}

RailStrips strips_before_wheel(const SurfaceModel& model, const RelativeMotion& motion,
                               const RailStrips& strips) {
  RailStrips rail = strips;
  if (rail.ranges < 2 || has_check_rail(model.varying)) return rail;

  // The front of the flange touches only strips on its own side of its tip, and rays from others would meet
  // it through its body. Overlaps that are solved are less deep than 3 mm.
  constexpr double deepest = 3e-3;  // [m]
  const WheelCurve& wheel = model.wheel;
  const RelativePose& pose = motion.pose;
  const std::int32_t tip = flange_tip(wheel);
  const double y =
      pose.y + pose.rotation[1][1] * wheel.knot_y[tip] + pose.rotation[1][2] * wheel.knot_radius[tip];
  for (std::int32_t r = 0; r < rail.ranges; ++r) {
    FaceStrips& face = rail.range[r];
    while (face.count > 1 && rail.tz[face.first] < 0.0 && rail.y[face.first] < y - deepest) {
      ++face.first;
      --face.count;
    }
  }
  return rail;
}

void find_wheel_overlaps(const WheelProblem& problem, const RelativeMotion& motion, double margin,
                         WheelOverlaps& overlaps) {
  const SurfaceModel& model = problem.model;
  const bool varying = varies(model);
  // The search takes the rail below the reference point for all of it. A grade a adds up to a^2 r / 2 to a
  // depth, more where the rail is concave, and the wheel's shape up to its largest reach.
  constexpr double concave = 1.5, most = 2e-3;  // [-], [m]
  const double steepest = problem.rail.steepest;
  const double more = varying ? smaller(0.5 * concave * steepest * steepest * model.wheel_radius, most) +
                                    model.out_of_round.largest
                              : 0.0;
  const RailStrips rail = strips_before_wheel(model, motion, problem.rail.strips);
  find_overlaps(*model.kernels, rail, model.wheel, motion.pose, margin + more, overlaps.rays, overlaps);
  if (varying) correct_along_track(problem, motion, margin, overlaps);
}

double candidate_margin(const SurfaceModel& model) {
  return model.methods.planar.solve ? planar_margin : 0.0;
}

}  // namespace wrc
