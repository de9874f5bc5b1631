#include "surface/wrench/wheel_overlaps.hpp"

#include "surface/pressure/planar_pressure.hpp"

namespace wrc {

RelativeMotion motion_at_height(const SurfaceModel& model, const WheelOnRail& in, double height) {
  WheelMotion wheel = in.wheel;
  wheel.position[2] = height;
  return relative_motion(model, wheel, in.rail, in.distance);
}

void find_wheel_overlaps(const WheelProblem& problem, const RelativeMotion& motion, double margin,
                         WheelOverlaps& overlaps) {
  static_cast<Overlaps&>(overlaps) = overlap_surfaces(problem.model, problem.rail, motion.pose,
                                                      problem.in.angle, margin, overlaps.outline, overlaps);
}

double candidate_margin(const SurfaceModel& model) {
  return model.methods.planar.solve ? planar_margin : 0.0;
}

}  // namespace wrc
