#include "surface/wrench/wheel_solution.hpp"

#include <algorithm>

#include "surface/pressure/planar_pressure.hpp"
#include "surface/rolling/region_rolling.hpp"
#include "surface/simd/tasks.hpp"
#include "surface/wrench/strip_rolling.hpp"
#include "surface/wrench/wrench_jacobian.hpp"

namespace wrc::surface {
WorkSizes work_sizes(const SurfaceModel& model) {
  const std::int32_t strips = model.rail_strips;
  return {model.wheel.curve.pieces,
          model.grid->cells,
          model.most_overlapping,
          varies(model),
          model.methods,
          strips,
          model.varying.faces > 0 ? strips : 0,
          changes(model.varying) ? strips : 0};
}

WheelOverlaps cut_wheel_overlaps(Arena& arena, const WorkSizes& sizes) {
  return {cut_overlaps(arena, sizes.strips, sizes.varying),
          cut_overlap_scratch(arena, sizes.wheel_pieces, sizes.rail_strips)};
}

bool move_wheel_overlaps(const WheelProblem& problem, const RelativeMotion& motion, double margin,
                         WheelOverlaps& o) {
  // 2 nm at the default, 20 nm at "real time": forces are then known as well as loads are met
  constexpr double near = 0.2e-3;  // [m], times the tolerance
  const RelativePose& pose = motion.pose;
  const double far = larger(magnitude(pose.y - o.found_y), magnitude(pose.z - o.found_z));
  if (o.margin != margin || !(far <= near * problem.model.pressure.tolerance)) return false;
  // depths grow by the move along the normals; places of the wheel stay on the rail [m]
  const double y = pose.y - o.moved_y, z = pose.z - o.moved_z;
  for (std::int32_t i = 0; i < o.count; ++i) {
    const double deeper = o.ny[i] * y + o.nz[i] * z;
    o.depth[i] += deeper;
    o.wy[i] += deeper * o.ny[i] - y;
    o.wz[i] += deeper * o.nz[i] - z;
  }
  o.moved_y = pose.y;
  o.moved_z = pose.z;
  return true;
}

WheelSolution cut_solution(Arena& arena, const WorkSizes& sizes, const ContactArrays& results) {
  const std::int32_t most = sizes.strips;
  WheelSolution s;
  static_cast<Overlaps&>(s.overlaps) = cut_overlaps(arena, most, sizes.varying);
  StripPressure& p = s.pressure;
  arena.each(most, p.length_squared, p.peak_per_length, p.centre, p.line_load);
  static_cast<ContactArrays&>(s.strips) = results;
  s.strips.candidate = arena.take<std::int32_t>(most);
  s.strips.x = arena.take(most);
  return s;
}

RollingScratch cut_rolling(Arena& arena, const WorkSizes& sizes) {
  const std::int32_t most = sizes.strips;
  RollingScratch r;
  // fields: of methods that need them, of friction over temperature, and results of fields_of_strips()
  const std::int64_t cells = static_cast<std::int64_t>(most) * sizes.cells;
  arena.each(cells, r.fields.traction_x, r.fields.traction_y, r.fields.slip_x, r.fields.slip_y);
  r.rolling = arena.take(static_cast<std::int64_t>(surface_rolling_workspace(most)));
  arena.each(most, r.slip_x, r.spin, r.other_fx, r.other_fy, r.other_mz, r.cold_friction, r.heat_share);
  r.x = r.region = nullptr;
  if (sizes.methods.region.solve) {
    r.x = arena.take(most);
    r.region = arena.take(region_rolling_doubles(most, sizes.methods.region));
  }
  return r;
}

WheelWorkBytes wheel_work_bytes(const WorkSizes& sizes) {
  const std::int32_t most = sizes.strips;
  // behind the results of a solve ...
  Arena results;
  cut_varying_strips(results, sizes.placed);
  cut_solution(results, sizes, {});

  // ... the stages' scratch, at heights behind the candidates
  Arena height = results;
  cut_candidates(height, sizes.candidates);
  Arena overlaps = height, pressure = height, rolling = height, remembered = height, jacobian = results;
  cut_wheel_overlaps(overlaps, sizes);
  pressure.take(sizes.methods.planar.solve ? planar_pressure_doubles(most, sizes.methods.planar)
                                           : pressure_doubles(most));
  cut_rolling(rolling, sizes);
  if (sizes.methods.remembers) count_remembered_tractions(remembered, sizes);
  if (sizes.methods.differentiable()) count_wrench_jacobian(jacobian, sizes);
  const auto behind = [&](const Arena& stage) { return stage.bytes() - results.bytes(); };
  return {results.bytes(), behind(overlaps), behind(pressure), std::max(behind(rolling), behind(remembered)),
          behind(jacobian)};
}

}  // namespace wrc::surface
