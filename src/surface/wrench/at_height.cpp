#include "surface/wrench/at_height.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "base/number.hpp"
#include "geometry/creepages.hpp"
#include "normal/damping.hpp"
#include "surface/pressure/planar_pressure.hpp"
#include "surface/wrench/first_touch.hpp"
#include "surface/wrench/regions.hpp"
#include "surface/wrench/strip_mechanics.hpp"
#include "surface/wrench/strip_rolling.hpp"

namespace wrc::surface {
namespace {

/// Is a strip the first or the last of its surface?
bool at_end(const RailStrips& rail, std::int32_t strip) {
  for (std::int32_t r = 0; r < rail.ranges; ++r)
    if (strip == rail.range[r].first || strip == rail.range[r].first + rail.range[r].count - 1) return true;
  return false;
}

constexpr Fault on_the_back =
    Fault::patch_at_edge("contact behind the flange's tip",
                         "the flange's back is against the rail's field side: is the wheel beside "
                         "its rail (input.wheel.y, config.wheelset.tape_circle_distance)?");

/// No overlap of faces that face each other: the bodies are apart, or the wheel is far inside the rail.
Fault apart_or_inside(const WheelProblem& problem, const WheelSolution& s) {
  const SurfaceModel& model = problem.model;
  const OverlapScratch& outline = s.overlaps.outline;
  find_outline(*model.kernels, problem.rail, model.wheel, s.motion.pose, outline);
  constexpr double most = 4e-3;  // [m]: overlaps that rays are crossed for (outline_kernel.hpp)
  const RailStrips& rail = problem.rail;

  // the knot of the wheel's outline that is deepest below the rail's profile, beyond that
  double deepest = most;
  std::int32_t knot = -1;
  for (std::int32_t r = 0; r < rail.ranges; ++r) {
    const FaceStrips& range = rail.range[r];
    for (std::int32_t k = 0; k < model.wheel.knots; ++k) {
      const double y = outline.y[k], z = outline.z[k];
      if (!(outline.seen[k] > 0.0 && z > range.top + deepest)) continue;
      const double *const begin = rail.y + range.first, *const end = begin + range.count;
      const double* const above = std::upper_bound(begin, end, y);
      if (above == begin || above == end) continue;
      const double depth = z - rail.z[above - rail.y];
      if (!(depth > deepest)) continue;
      deepest = depth;
      knot = k;
    }
  }
  if (knot < 0) return Fault::no_contact();
  const WheelCurve& wheel = model.wheel;
  const double middle_of_flange = 0.5 * (model.wheel_radius + wheel.knot_radius[wheel.flange_tip]);
  const char* likely =
      "the flange is inside the rail's side, where no contact is looked for: did you pass mm for "
      "input.wheel.y, or another gauge?";
  if (knot < wheel.flange_tip)
    likely =
        "the flange's back is inside the rail, where no contact is looked for: is the wheel beside its rail "
        "(input.wheel.y)?";
  else if (wheel.knot_radius[knot] < middle_of_flange)
    likely =
        "the tread is inside the rail, deeper than contact is looked for: is the wheel too low "
        "(input.wheel.z)?";
  return Fault::no_contact("depth of the wheel inside the rail", {deepest, "m", 0.0, most}, likely);
}

/// Flags contact at the farthest place along the track that is looked at.
Fault beyond_search(const Overlaps& o) {
  bool beyond = false;
  for (std::int32_t i = 0; i < o.count; ++i) beyond = beyond || magnitude(o.centre[i]) >= farthest_along;
  if (!beyond) return {};
  return Fault::patch_at_edge("place of contact along the track",
                              "a surface that moves aside nears the wheel's flange more than 160 mm ahead or "
                              "behind, where contact is not looked for");
}

/// Flags a solution that reaches the end of a surface along the track, where strips are cut off
/// (cut_at_end()).
Fault ends_along(const WheelProblem& problem, const WheelSolution& s) {
  const VaryingRail& varying = problem.model.varying;
  for (std::int32_t k = 0; k < s.strips.count; ++k) {
    const std::int32_t j = on_rail(s.overlaps.strip[s.strips.candidate[k]]), f = face_of(varying, j);
    const FaceExtent extent = extent_of(varying, varying.face[f], problem.rail.distance);
    const double behind = s.strips.x[k] - s.strips.half_length[k],
                 ahead = s.strips.x[k] + s.strips.half_length[k];
    if (!extent.holds(behind) || !extent.holds(ahead))
      return Fault::patch_at_edge(
          {"config.rail_sections: contact at the end of surface", f},
          {extent.holds(behind) ? ahead : behind, "m", problem.rail.low[f], problem.rail.high[f]},
          "the peak of its pressure, which has no bound at a sharp end, is not solved: let surfaces begin "
          "and end where no wheel touches them");
  }
  return {};
}

/// Flags of a rail that changes along the track.
Fault limits_along(const WheelProblem& problem, const WheelSolution& s) {
  if (!changes(problem.model.varying)) return {};
  Fault fault = beyond_search(s.overlaps);
  keep_worst(fault, ends_along(problem, s));
  return fault;
}

/// Flags of a solution that reaches beyond the profiles or the deepest overlap, or is of more strips than
/// fit.
Fault extrapolated(const WheelProblem& problem, const WheelSolution& s) {
  const Overlaps& o = s.overlaps;
  if (o.full)
    return Fault::more_patches("strips that overlap", {1.0 + o.capacity, "", 0.0, 1.0 * o.capacity},
                               "those beyond, on the field side, carry nothing");
  const RailStrips& rail = problem.rail;
  const SurfaceModel& model = problem.model;
  const Curve& wheel = model.wheel.curve;
  const bool alone = model.varying.faces < 2;  // another face may be there for the flange's back

  // strips in contact from the gauge side on: the first that is flagged counts
  for (std::int32_t k = 0; k < s.strips.count; ++k) {
    constexpr double rounding = 1e-9;  // [m]
    const std::int32_t i = s.strips.candidate[k], j = on_rail(o.strip[i]);
    const double depth = o.depth[i];
    if (depth > deepest_overlap + rounding)
      return Fault::beyond_gap("overlap", {depth, "m", 0.0, deepest_overlap},
                               "the load is far beyond what steel carries there");

    // the back of the flange, where rays of the rail's field side meet the wheel behind its tip
    constexpr double falling = 0.5;  // to the field side
    if (alone && rail.tz[j] > falling && o.piece[i] < model.wheel.flange_tip) return on_the_back;

    // The first and the last strip of a face, and ends of the wheel's profile, beyond which rays meet
    // nothing.
    const bool rail_ends = at_end(rail, j);
    const double at = wheel.s[o.piece[i]] + o.u[i], near = rail.width[j];
    const bool wheel_ends = at < near || at > wheel.s[wheel.pieces] - near;
    if (rail_ends || wheel_ends) return Fault::patch_at_edge(rail_ends ? "config.rail" : "config.wheel");
  }
  return {};
}

/// Pressures at the overlaps, by the model's method.
Fault solve_pressures(const HeightSolver& solver, double tolerance) {
  const SurfaceModel& model = solver.problem.model;
  const RailStrips& rail = solver.problem.rail;
  const Overlaps& overlaps = solver.solution.overlaps;
  const StripPressure& pressure = solver.solution.pressure;
  Arena scratch = solver.scratch;
  if (model.methods.planar.solve) {
    const PlanarMethod& method = model.methods.planar;
    double* const work = scratch.take(planar_pressure_doubles(overlaps.capacity, method));
    const PlanarResult planar =
        solve_planar_pressure(rail, overlaps, method, model.material, *model.kernels, work, pressure);
    solver.out.iterations += planar.iterations;
    Fault fault = planar.fault;
    if (planar.jumps) keep_worst(fault, Fault::force_jumps("config.normal.method"));
    return fault;
  }
  double* const work = scratch.take(pressure_doubles(overlaps.capacity));
  // all heights of a call together have the work that the model allows
  PressureOptions options = model.pressure;
  options.tolerance = tolerance;
  options.max_work -= solver.out.work;
  HeightStart& start = solver.start;
  const PressureResult normal = solve_pressure(pressure_model(model), rail, overlaps, options, work,
                                               start.solution, start.from, pressure);
  start.from = StartFrom::solution;
  solver.out.iterations += normal.iterations;
  solver.out.work += normal.work;
  solver.out.residual = normal.residual;
  if (normal.converged) return {};
  return Fault::iteration_cap("sweeps", {normal.iterations});
}

/// Sums over the strips in contact.
struct LoadSums {
  double load = 0.0;     ///< [N]
  double sliding = 0.0;  ///< load times sliding velocity along the rail [N m/s]
  double below = 0.0;    ///< load times how far below the wheel's reference point it acts [N m]
};

/// Takes the strips that carry load from the overlaps and their pressures, with damping; slips as velocities
/// [m/s], [rad/s].
LoadSums take_loaded_strips(const WheelProblem& problem, WheelSolution& s) {
  LoadSums sums;
  const RailStrips& rail = problem.rail;
  const Overlaps& o = s.overlaps;
  const StripPressure& p = s.pressure;
  ContactStrips& strips = s.strips;
  for (std::int32_t i = 0; i < o.count; ++i) {
    if (!(p.length_squared[i] > 0.0 && p.line_load[i] > 0.0)) continue;
    const std::int32_t j = on_rail(o.strip[i]);
    const double l = std::sqrt(p.length_squared[i]), x = p.centre[i];
    const StripMotion<double> m = motion_at(s.motion.velocity, strip_of(o, i), x, o.grade != nullptr);

    // p0 = lambda l = q / l and N = pi/2 w l p0, both times the damping factor
    const double damped = normal::damping_factor(m.approach, problem.in.damping);
    const double peak = damped * p.line_load[i] / l, N = 0.5 * pi * rail.width[j] * l * peak;
    if (!(N > 0.0)) continue;  // a region damped to nothing would have no middle

    const std::int32_t k = strips.count++;
    strips.candidate[k] = i;
    strips.x[k] = x;
    strips.place[k] = row_place(rail, o.strip[i]);
    strips.width[k] = rail.width[j];
    strips.half_length[k] = l;
    strips.solved_peak[k] = peak;
    strips.curvature[k] = damped * o.curvature[i];  // over lambda: damping makes nothing stiffer along
    strips.slip_x[k] = m.along;
    strips.slip_y[k] = m.across;
    strips.spin[k] = m.spin;
    strips.friction[k] = problem.in.friction;
    strips.fx[k] = strips.fy[k] = strips.mz[k] = strips.power[k] = 0.0;

    // for the speed of rolling, which all slips refer to
    sums.load += N;
    sums.sliding += N * m.along;
    sums.below += N * o.wz[i];
  }
  return sums;
}

/// The speed at which wheel and rail material pass through the contact, the mean of both:
/// V = v_x - <v_slip> / 2, v_x the wheel's velocity; a roller's material passes omega z slower.
double rolling_speed_of(const RelativeMotion& motion, const LoadSums& sums) {
  double speed = motion.velocity.linear[0] - 0.5 * sums.sliding / sums.load;
  if (motion.velocity.on_roller) speed -= motion.velocity.roller * sums.below / sums.load;
  return speed;
}

/// Flags a wheel that turns against its travel: both materials pass through the contact at nearly the same
/// speed in opposite directions. No vehicle does that; an angular velocity of the wrong sign does.
Fault turns_against_travel(const LoadSums& sums, double rolling_speed) {
  const double sliding = magnitude(sums.sliding / sums.load);
  const double most = geometry::largest_creepage * larger(magnitude(rolling_speed), geometry::floor_speed);
  if (!(sliding > most)) return {};
  return Fault::creepages_limited("sliding along the rail", {sliding, "m/s", 0.0, most},
                                  "the wheel turns against its travel: has its angular velocity the wrong "
                                  "sign? input.wheel.pitch_rate is -v / r0 rolling forwards");
}

/// All forces times a factor.
void scale(double factor, Wrench& out) {
  const auto by = [factor](double& x) { x *= factor; };
  for (double& x : out.force) by(x);
  for (double& x : out.moment) by(x);
  for (double* const x : {&out.normal_force, &out.peak_pressure, &out.power}) by(*x);
  for (std::int32_t i = 0; i < out.regions; ++i) {
    SurfaceRegion& r = out.region[i];
    for (double& x : r.force) by(x);
    for (double& x : r.moment) by(x);
    for (double* const x : {&r.normal_force, &r.peak_pressure, &r.power}) by(*x);
  }
}

/// Pressures, slips, tractions and sums of the overlaps that the solution holds, which are those at `height`.
Fault solve_overlaps(const HeightSolver& solver, double height, double tolerance) {
  const WheelOnRail& in = solver.problem.in;
  WheelSolution& s = solver.solution;
  Wrench& out = solver.out;
  // a wrench of zeros, but for iterations and work of earlier heights
  const std::int32_t iterations_before = out.iterations;
  const double work_before = out.work;
  out = {};
  out.iterations = iterations_before;
  out.work = work_before;
  out.height = height;
  s.sums = {};
  s.strips.count = 0;
  if (solver.problem.memory) solver.problem.memory->written = 0;

  // pressures, and of the strips that carry load the velocities over the rail
  Fault fault = solve_pressures(solver, tolerance);
  if (fault.failed()) return fault;
  const LoadSums sums = take_loaded_strips(solver.problem, s);
  // converged or not: there is no force
  if (s.strips.count == 0) {
    fault = apart_or_inside(solver.problem, s);
    keep_worst(fault, limits_along(solver.problem, s));
    return fault;
  }

  // slips are velocities over the speed of rolling, bounded below near standstill
  s.sums.rolling_speed = rolling_speed_of(s.motion, sums);
  const geometry::RollingReference reference = geometry::rolling_reference(s.sums.rolling_speed);
  s.sums.backwards = s.sums.rolling_speed < 0.0 ? 1.0 : 0.0;
  s.sums.speed = reference.divisor;
  for (std::int32_t k = 0; k < s.strips.count; ++k) {
    s.strips.slip_x[k] /= reference.divisor;
    s.strips.slip_y[k] /= reference.divisor;
    s.strips.spin[k] /= reference.divisor;
  }
  if (in.friction > 0.0)
    keep_worst(fault, roll_strips(solver.problem, s.overlaps, s.strips, s.sums.rolling_speed, reference,
                                  solver.scratch));

  // sums, and flags that say how far they hold
  keep_worst(fault, sum_regions(in, s, out));
  keep_worst(fault, extrapolated(solver.problem, s));
  keep_worst(fault, limits_along(solver.problem, s));
  // with memory rest, reversal and all speeds are steps like others
  if (in.friction > 0.0 && !solver.problem.memory) {
    keep_worst(fault, turns_against_travel(sums, s.sums.rolling_speed));
    if (reference.reverse_share > 0.0) keep_worst(fault, Fault::creepages_limited("rolling speed"));
  }
  // methods of whole patches share forces among strips by load: their slips may make the sum negative
  if (solver.problem.model.methods.region.solve) out.power = larger(out.power, 0.0);
  return fault;
}

}  // namespace

bool is_apart(const Fault& fault) { return fault.status == WRC_FLAG_NO_CONTACT && fault.field == nullptr; }

Fault solve_at_height(const HeightSolver& solver, double height, double tolerance) {
  const WheelProblem& problem = solver.problem;
  WheelSolution& s = solver.solution;
  s.motion = motion_at_height(problem.model, problem.in, height);
  const double margin = candidate_margin(problem.model);
  if (!move_wheel_overlaps(problem, s.motion, margin, s.overlaps))
    find_wheel_overlaps(problem, s.motion, margin, s.overlaps);
  return solve_overlaps(solver, height, tolerance);
}

Fault solve_given_height(const HeightSolver& solver) {
  constexpr double step = 2e-6;  // [m]
  const WheelProblem& problem = solver.problem;
  WheelSolution& s = solver.solution;
  Wrench& out = solver.out;
  const double asked = problem.in.wheel.position[2], tolerance = problem.model.pressure.tolerance;
  // the usual wheel is not that deep: the search for the border has left its overlaps already
  const double border = height_at_border(problem, asked, s.motion, s.overlaps);
  if (asked == border) return solve_overlaps(solver, asked, tolerance);
  if (!(asked > border)) return solve_at_height(solver, asked, tolerance);

  // two heights at the border give the stiffness there
  solve_at_height(solver, border - step, tolerance);
  const double before = out.normal_force;
  Fault fault = solve_at_height(solver, border, tolerance);
  if (fault.status == WRC_FLAG_NO_CONTACT) {  // raised until faces that are far inside each other are apart
    s.motion = motion_at_height(problem.model, problem.in, asked);
    s.overlaps.count = 0;  // they have no pressures
    out.height = asked;
    return apart_or_inside(problem, s);
  }

  // N (1 + stiffness (asked - border) / N): all forces by the same factor
  if (out.normal_force > 0.0) {
    const double stiffness = larger(out.normal_force - before, 0.0) / step;
    s.sums.factor = 1.0 + stiffness * (asked - border) / out.normal_force;
    scale(s.sums.factor, out);
  }
  out.height = asked;
  keep_worst(fault,
             Fault::beyond_gap("overlap", {deepest_overlap + asked - border, "m", 0.0, deepest_overlap},
                               "did you pass millimetres?"));
  return fault;
}

}  // namespace wrc::surface
