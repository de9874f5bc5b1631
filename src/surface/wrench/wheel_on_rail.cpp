#include "surface/wrench/wheel_on_rail.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "surface/pressure/pressure_jacobian.hpp"
#include "surface/wrench/given_load.hpp"
#include "surface/wrench/wrench_at_height.hpp"
#include "surface/wrench/wrench_sum.hpp"

namespace wrc {
namespace {

using Work = WheelWork;

constexpr std::int32_t most = most_overlapping_strips;

/// Cuts the workspace; returns the bytes it takes.
std::int64_t cut(void* memory, std::int32_t wheel_pieces, const SurfaceMethods& methods, std::int32_t cells,
                 bool varying, Work& w) {
  auto* const begin = static_cast<double*>(memory);
  double* at = begin;
  const auto doubles = [&at](std::int64_t n) {
    double* const here = at;
    at += (n + 7) / 8 * 8;
    return here;
  };
  const auto integers = [&doubles](std::int64_t n) {
    return reinterpret_cast<std::int32_t*>(doubles((n + 1) / 2));
  };
  Overlaps& o = w.overlaps;
  o.capacity = most;
  o.strip = integers(most);
  for (double** a : {&o.depth, &o.centre, &o.curvature, &o.ny, &o.nz, &o.wy, &o.wz}) *a = doubles(most);
  for (double** a : {&w.scratch.y, &w.scratch.z, &w.scratch.seen})
    *a = doubles(simd::whole_packs(wheel_pieces + 1));
  w.scratch.strip = integers(most);
  w.scratch.overlap = doubles(most_strips_of_a_rail);
  w.scratch.part = doubles(most_strips_of_a_rail);
  w.scratch.along = doubles(most_strips_of_a_rail);
  w.scratch.piece = integers(most_strips_of_a_rail);
  StripPressure& p = w.pressure;
  for (double** a : {&p.length_squared, &p.peak_per_length, &p.centre, &p.line_load}) *a = doubles(most);
  w.normal = doubles(std::max(pressure_doubles(most), wrench_slopes_doubles(most_differentiated_strips)));
  w.slopes = w.normal;  // which is done with by then
  w.rolling = doubles(static_cast<std::int64_t>(surface_rolling_workspace(most)));
  for (double** a :
       {&w.place, &w.width, &w.half_length, &w.peak, &w.curvature, &w.slip_x, &w.slip_y, &w.spin, &w.friction,
        &w.fx, &w.fy, &w.mz, &w.other_fx, &w.other_fy, &w.other_mz, &w.cold_friction, &w.heat_share})
    *a = doubles(most);
  w.candidate = integers(most);
  for (double** a : {&w.fields.traction_x, &w.fields.traction_y, &w.fields.slip_x, &w.fields.slip_y})
    *a = doubles(static_cast<std::int64_t>(most) * cells);
  w.loaded = 0;
  if (varying) {
    o.lean = doubles(most);
    w.rail_strips = doubles(rail_strip_doubles(most_strips_of_a_rail));
  }
  w.along = w.planar = w.region = nullptr;
  if (methods.planar.solve) w.planar = doubles(planar_pressure_doubles(most, methods.planar));
  if (methods.region.solve) {
    w.along = doubles(most);
    w.region = doubles(region_rolling_doubles(most, methods.region));
  }
  return (at - begin) * static_cast<std::int64_t>(sizeof(double));
}

/// The strips of the rail where the wheel is; flagged where there is no section.
Fault place_rail(const SurfaceModel& model, const WheelOnRail& in, Work& w) {
  w.rail = model.rail;
  w.distance = in.distance;
  w.steepest = 0.0;
  if (model.varying.faces == 0) return {};
  return place_strips(*model.kernels, model.varying, w.rail_strips, most_strips_of_a_rail, w.distance, w.rail,
                      w.blend, w.steepest);
}

/// What the last solve left in `w`, for later.
void keep_strips(const SurfaceModel& model, const WheelOnRail& in, const Work& w, StripResults& kept) {
  const std::int32_t n = w.loaded;
  kept.count = n;
  kept.speed = n > 0 ? w.speed : 0.0;
  kept.rolling_speed = n > 0 ? w.rolling_speed : 0.0;
  kept.backwards = n > 0 && w.backwards ? 1.0 : 0.0;
  kept.rolls = in.friction > 0.0 ? 1.0 : 0.0;
  kept.by_region = rolls_by_region(model, in) ? 1.0 : 0.0;
  kept.slope_reduction = in.slope_reduction;
  kept.factor = w.factor;
  const Overlaps& o = w.overlaps;
  const auto& r = w.seen.pose.rotation;
  for (std::int32_t k = 0; k < n; ++k) {
    const std::int32_t i = w.candidate[k], j = o.strip[i];
    kept.strip[k] = j;
    kept.y[k] = w.rail.y[j];
    kept.z[k] = w.rail.z[j];
    kept.angle[k] = strip_angle(w.rail, j);
    double middle[3] = {w.pressure.centre[i], o.wy[i], o.wz[i]};
    if (w.seen.aslant) into_track(w.seen, middle);
    kept.centre[k] = in.wheel.position[0] + middle[0];
    kept.peak[k] = w.factor * w.peak[k];
    kept.power[k] = power_of(w, k, w.speed);
    kept.y_wheel[k] = r[0][1] * o.centre[i] + r[1][1] * o.wy[i] + r[2][1] * o.wz[i];
  }
  const struct {
    const double* from;
    double* to;
  } each[] = {{w.place, kept.place},
              {w.width, kept.width},
              {w.half_length, kept.half_length},
              {w.peak, kept.solved_peak},
              {w.curvature, kept.curvature},
              {w.slip_x, kept.slip_x},
              {w.slip_y, kept.slip_y},
              {w.spin, kept.spin},
              {w.friction, kept.friction},
              {w.fx, kept.fx},
              {w.fy, kept.fy},
              {w.mz, kept.mz}};
  for (const auto& [from, to] : each) std::copy_n(from, n, to);
}

}  // namespace

std::int64_t surface_workspace_bytes(std::int32_t wheel_nodes, const SurfaceMethods& methods,
                                     std::int32_t cells, bool varying) {
  Work w;
  alignas(64) static double nothing[1];
  return cut(nothing, most_curve_pieces(wheel_nodes), methods, cells, varying, w);
}

Fault solve_wheel_on_rail(const SurfaceModel& model, const WheelOnRail& in, bool warm, SurfaceState& state,
                          void* workspace, Wrench& out, RailFrameJacobian* slopes,
                          RailFrameJacobian* by_track) noexcept {
  Work w;
  cut(workspace, model.wheel.curve.pieces, model.methods, model.grid->cells, varies(model), w);
  const Fault outside = place_rail(model, in, w);
  warm = warm && state.set > 0.0;
  PressureStart start{state.length_squared, state.shift, state.depth, warm};
  out = {};
  Fault fault;
  if (in.load_prescribed) {
    if (!warm) state.height = first_touch(model, in, w) + usual_approach(in.vertical_load);
    fault = solve_given_load(model, in, w, start, state.height, out);
  } else {
    fault = solve_given_height(model, in, w, start, out);
    state.height = in.wheel.position[2];
  }
  const bool apart = !in.load_prescribed && is_apart(fault);
  state.set = start.set ? 1.0 : 0.0;
  keep_strips(model, in, w, state.kept);
  if (slopes) keep_worst(fault, differentiate_wrench(model, in, w, SlopesBy::place, *slopes));
  if (by_track && varies(model))
    keep_worst(fault, differentiate_wrench(model, in, w, SlopesBy::track, *by_track));
  for (std::int32_t k = 0; k < w.loaded; ++k)
    out.steepest_angle = std::max(out.steepest_angle, std::abs(state.kept.angle[k] + in.rail.roll));
  if (apart) out.clearance = clearance(model, in, w);
  keep_worst(fault, outside);
  return fault;
}

StripFields roll_kept(const SurfaceModel& model, const StripResults& kept, std::int32_t first,
                      std::int32_t count, void* workspace) noexcept {
  Work w;
  cut(workspace, model.wheel.curve.pieces, model.methods, model.grid->cells, varies(model), w);
  const struct {
    const double* from;
    double* to;
  } each[] = {{kept.half_length, w.half_length}, {kept.solved_peak, w.peak}, {kept.curvature, w.curvature},
              {kept.slip_x, w.slip_x},           {kept.slip_y, w.slip_y},    {kept.spin, w.spin},
              {kept.friction, w.friction}};
  for (const auto& [from, to] : each) std::copy_n(from + first, count, to);
  for (std::int32_t k = 0; k < count; ++k) {
    w.place[k] = kept.place[first + k];
    w.width[k] = kept.width[first + k];
  }
  const TangentialFields& f = w.fields;
  const std::int32_t cells = model.grid->cells;
  const bool backwards = kept.backwards > 0.0;
  if (kept.rolls > 0.0) {
    WheelOnRail in;
    in.slope_reduction = kept.slope_reduction;
    roll(model, in, count, backwards, w, f, {w.fx, w.fy, w.mz});
    if (backwards)
      for (double* const a : {f.traction_x, f.slip_x})
        for (std::int32_t at = 0; at < count * cells; ++at) a[at] = -a[at];
  } else {
    // nothing holds the rigid slip back
    const double way = backwards ? -1.0 : 1.0;
    for (std::int32_t i = 0; i < cells; ++i)
      for (std::int32_t k = 0; k < count; ++k) {
        const std::int32_t at = i * count + k;
        f.traction_x[at] = f.traction_y[at] = 0.0;
        f.slip_x[at] = w.slip_x[k];
        f.slip_y[at] = w.slip_y[k] + w.spin[k] * (way * w.half_length[k] * model.grid->middles.place[i]);
      }
  }
  return {count, cells, f.traction_x, f.traction_y, f.slip_x, f.slip_y, w.fx};
}

}  // namespace wrc
