#include "surface/wrench/wheel_on_rail.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "surface/geometry/along_track.hpp"
#include "surface/geometry/second_place.hpp"
#include "surface/wrench/first_touch.hpp"
#include "surface/wrench/given_load.hpp"
#include "surface/wrench/regions.hpp"
#include "surface/wrench/strip_rolling.hpp"

namespace wrc::surface {
namespace {

/// A strip in contact, whose overlap is looked at along the track.
struct StripInContact {
  StripOverX<double> over;
  RayEnd<double> top;  ///< its ray where it is deepest
  double at, l;        ///< middle and half length of its contact [m]
  double bends;        ///< half the curvature of its parabola [1/m]
  double edge;         ///< overlap of the parabola at the ends of contact [m]
  double low, high;    ///< ends of its face [m]

  bool is_on_face(double x) const { return !(x < low || x > high); }
};

/// Strip k in contact, of a rail that changes along the track.
StripInContact strip_in_contact(const WheelProblem& problem, const WheelSolution& s, std::int32_t k) {
  const SurfaceModel& model = problem.model;
  const PlacedRail& rail = problem.rail;
  const Overlaps& o = s.overlaps;
  const std::int32_t i = s.strips.candidate[k], strip = on_rail(o.strip[i]);
  const std::int32_t face = face_of(model.varying, strip);
  const double l = s.strips.half_length[k], bends = 0.5 * o.curvature[i];
  return {{model.varying, model.wheel.curve, s.motion.pose, strip, rail.distance, rail.blend[face], o.ny[i],
           o.nz[i]},
          {o.piece[i], o.u[i], o.depth[i]},
          s.strips.x[k],
          l,
          bends,
          larger(o.depth[i] - bends * l * l, 0.0),
          rail.low[face],
          rail.high[face]};
}

/// Flags a place along the track where a strip would carry load beside those it has. Looked at is the strip
/// of the longest contact, but for the side of its second place, if it has one. Beyond its half length l the
/// load presses the surfaces apart by at most w l / t at the distance t, w the overlap at the contact's edge.
/// A larger overlap there is pressed.
Fault another_place(const WheelProblem& problem, const WheelSolution& s) {
  const SurfaceModel& model = problem.model;
  // a wheel that is not round has its own waves there, which are not looked at
  if (s.strips.count == 0 || model.out_of_round.rows > 0) return {};
  const Overlaps& o = s.overlaps;
  std::int32_t k = 0;
  for (std::int32_t n = 1; n < s.strips.count; ++n)
    if (s.strips.half_length[n] > s.strips.half_length[k]) k = n;
  const std::int32_t i = s.strips.candidate[k];
  if (!changes_along(model, on_rail(o.strip[i]))) return {};

  // the overlap at places ahead and behind, from the edge of the contact on
  constexpr double nearest = 0.5, apart = 1.5e-3;  // [-], [m]
  constexpr int to_a_side = 10;
  StripInContact strip = strip_in_contact(problem, s, k);
  const TopBounds<double> bounds = bounds_of(o.bound[i], o.top[i]);
  for (const double way : {1.0, -1.0}) {
    // the other place carries its own load
    if (way > 0.0 ? bounds.ahead < unbounded.ahead : bounds.behind > unbounded.behind) continue;
    RayEnd<double> end = strip.top;
    double least = o.depth[i];
    for (int n = 0; n < to_a_side; ++n) {
      const double t = nearest * strip.l + n * apart, x = strip.at + way * t;
      if (!strip.is_on_face(x)) break;
      const double depth = depth_at(strip.over, x, end);
      least = smaller(least, depth);
      if (t > strip.l && depth * t > strip.edge * strip.l && depth > least)
        return Fault::more_patches("overlap at another place along the track", {depth, "m"},
                                   "a strip has another place of contact along the track, beyond a valley: "
                                   "this one carries nothing");
    }
  }
  return {};
}

/// Overlap of a strip beyond its parabola, over the length in contact [m^2].
double beyond_parabola(StripInContact strip, double depth) {
  constexpr int places = 8;
  const double apart = 2.0 * strip.l / places;
  double sum = 0.0;
  for (int n = 0; n < places; ++n) {
    const double t = (n + 0.5) * apart - strip.l;
    sum += depth_at(strip.over, strip.at + t, strip.top) - (depth - strip.bends * t * t);
  }
  return apart * sum;
}

/// Overlap of a strip that is left beside its contact, beyond the load's displacement w l / t
/// (another_place()) [m^2].
double left_beside(StripInContact strip) {
  constexpr int places = 8;
  constexpr double apart = 1.5e-3;  // [m]
  double sum = 0.0;
  for (const double way : {1.0, -1.0}) {
    RayEnd<double> end = strip.top;
    for (int n = 0; n < places; ++n) {
      const double t = strip.l + (n + 0.5) * apart, x = strip.at + way * t;
      if (!strip.is_on_face(x)) break;
      sum += larger(depth_at(strip.over, x, end) - strip.edge * strip.l / t, 0.0);
    }
  }
  return apart * sum;
}

/// Does a valley that is sharper than the wheel lie near the strip's contact? Then it may have two tops.
bool near_valley(const WheelProblem& problem, std::int32_t strip, double at, double nz) {
  constexpr double reach = 25e-3;  // [m]
  const VaryingRail& varying = problem.model.varying;
  const double here = problem.rail.distance + at;
  return valley_between(varying, varying.face[face_of(varying, strip)], eight_of(strip), here - reach,
                        here + reach) > least_valley * magnitude(nz) / problem.model.wheel_radius;
}

/// Flags a contact whose strips overlap by more than their parabolas carry: as on a gentle ramp, where a
/// strip's two tops lie nearer to each other than the contact is long, and their parts of the load do not sum
/// up to that of one contact with a saddle. Of some strips, overlaps beyond the parabolas are compared with
/// those that the contact presses away. Without a second row, those beside the contact count a tenth: the top
/// that lies there may not count.
Fault beyond_parabolas(const WheelProblem& problem, const WheelSolution& s) {
  const SurfaceModel& model = problem.model;
  // a wheel that is not round has its own waves there, which are not looked at
  if (model.out_of_round.rows > 0 || model.varying.faces == 0) return {};
  constexpr std::int32_t looked_at = 8;
  constexpr double most = 0.13;  // overlap beyond, from which the force is 5 % off [-]
  const Overlaps& o = s.overlaps;
  std::int32_t second = 0;
  for (std::int32_t k = 0; k < s.strips.count; ++k)
    second += o.strip[s.strips.candidate[k]] < second_places ? 0 : 1;
  const bool one_row = second == 0 || second == s.strips.count;

  const std::int32_t every = (s.strips.count + looked_at - 1) / looked_at;
  double pressed = 0.0, beyond = 0.0, beside = 0.0;  // [m^3]
  for (std::int32_t k = every / 2; k < s.strips.count; k += every) {
    const std::int32_t i = s.strips.candidate[k], number = on_rail(o.strip[i]);
    const double width = s.strips.width[k], l = s.strips.half_length[k];
    pressed += width * (4.0 / 3.0) * (0.5 * o.curvature[i]) * l * l * l;
    if (!changes_along(model, number) || !near_valley(problem, number, s.strips.x[k], o.nz[i])) continue;
    const StripInContact strip = strip_in_contact(problem, s, k);
    beyond += width * beyond_parabola(strip, o.depth[i]);
    if (one_row) beside += width * left_beside(strip);
  }
  const double all = larger(beyond, 0.0) + 0.1 * beside;
  if (!(all > most * pressed)) return {};
  return Fault::more_patches("overlap beyond the parabolas of strips", {all / pressed, "", 0.0, most},
                             "two places of contact along the track lie nearer to each other than a contact "
                             "is long: the force is about 5 % off or more");
}

/// Completes the results of the strips, of which a solve leaves slips, friction and forces there.
void complete_results(const WheelProblem& problem, const WheelSolution& s, const StripResults& results) {
  const WheelOnRail& in = problem.in;
  const RailStrips& rail = problem.rail;
  StripResultsHead& head = *results.head;
  // numbers of the solution as a whole, and of the problem those that fields are computed with later
  head = s.sums;
  head.count = s.strips.count;
  head.rolls = in.friction > 0.0 ? 1.0 : 0.0;
  head.by_region = rolls_by_region(problem.model, in) ? 1.0 : 0.0;
  head.slope_reduction = in.slope_reduction;
  head.layer = in.layer;
  head.layer_of_strips = in.layer_of_strips ? 1.0 : 0.0;
  const Overlaps& o = s.overlaps;
  const auto& R = s.motion.pose.rotation;
  for (std::int32_t k = 0; k < s.strips.count; ++k) {
    const std::int32_t i = s.strips.candidate[k], j = on_rail(o.strip[i]);
    // place on the rail; peak as the wrench has it, beyond the deepest overlap with its factor
    results.strip[k] = o.strip[i];
    results.y[k] = rail.y[j];
    results.z[k] = rail.z[j];
    results.angle[k] = strip_angle(rail, j);
    results.peak[k] = head.factor * results.solved_peak[k];

    // the pressure's middle along the track, and the overlap's on the wheel's axle: y of R^T r
    double middle[3] = {s.strips.x[k], o.wy[i], o.wz[i]};
    if (s.motion.aslant) into_track(s.motion, middle);
    results.centre[k] = in.wheel.position[0] + middle[0];
    results.y_wheel[k] = R[0][1] * o.centre[i] + R[1][1] * o.wy[i] + R[2][1] * o.wz[i];
  }
}

/// Slips of strips without friction: nothing holds the rigid slip (xi_x, xi_y + phi x) back.
void fill_free_slips(const tangential::MarchGrid& grid, const ContactStrips& strips, bool backwards,
                     const tangential::TangentialFields& f) {
  const double ahead = backwards ? -1.0 : 1.0;
  for (std::int32_t i = 0; i < grid.cells; ++i)
    for (std::int32_t k = 0; k < strips.count; ++k) {
      const std::int32_t at = i * strips.count + k;
      f.traction_x[at] = f.traction_y[at] = 0.0;
      f.slip_x[at] = strips.slip_x[k];
      f.slip_y[at] =
          strips.slip_y[k] + strips.spin[k] * (ahead * strips.half_length[k] * grid.middles.place[i]);
    }
}

/// Copies a kept solution.
void copy_start(const KeptStart& from, const KeptStart& to) {
  *to.head = *from.head;
  const auto count = static_cast<std::int32_t>(from.head->count);
  std::copy_n(from.strip, count, to.strip);
  std::copy_n(from.length_squared, count, to.length_squared);
  std::copy_n(from.shift, count, to.shift);
  std::copy_n(from.depth, count, to.depth);
}

/// A change by the strips of one solution, brought to those of a later one.
void move_change(const KeptChange& from, const KeptStart& of, const KeptStart& later, const KeptChange& to) {
  const auto count = static_cast<std::int32_t>(later.head->count);
  const auto earlier = static_cast<std::int32_t>(of.head->set * of.head->count);
  for (double* const each : {to.length_squared, to.shift, to.depth}) std::fill_n(each, count, 0.0);
  for_shared_strips(count, later.strip, earlier, of.strip, [&](std::int32_t i, std::int32_t b) {
    to.length_squared[i] = from.length_squared[b];
    to.shift[i] = from.shift[b];
    to.depth[i] = from.depth[b];
  });
}

/// Change of the strips whose L is known in both of two solutions.
void take_change(const KeptStart& before, const KeptStart& now, const KeptChange& change) {
  const auto count = static_cast<std::int32_t>(now.head->count);
  const auto earlier = static_cast<std::int32_t>(before.head->set * before.head->count);
  for (double* const each : {change.length_squared, change.shift, change.depth})
    std::fill_n(each, count, 0.0);
  for_shared_strips(count, now.strip, earlier, before.strip, [&](std::int32_t i, std::int32_t b) {
    if (before.length_squared[b] == 0.0 || now.length_squared[i] == 0.0) return;
    change.length_squared[i] = now.length_squared[i] - before.length_squared[b];
    change.shift[i] = now.shift[i] - before.shift[b];
    change.depth[i] = now.depth[i] - before.depth[b];
  });
}

/// Has the wheel been put elsewhere on the rail since the committed step? Its move in a direction is then
/// longer than its speeds times the time. The speed along the rail counts in all: irregularities move the
/// wheel.
Fault look_for_jump(const WheelOnRail& in, const RememberedSteps& steps) {
  constexpr double most = 1e-3, most_at_once = 1e-5;  // [m]
  if (!(steps.committed > 0.0)) return {};
  const double y = in.wheel.position[1] - in.rail.y - steps.from[0];
  const double z = in.load_prescribed ? 0.0 : in.wheel.position[2] - in.rail.z - steps.from[1];
  const double along = in.distance - steps.from[2];
  const double moved = larger(larger(magnitude(y), magnitude(z)), magnitude(along));
  if (!(in.time > 0.0) && moved > most_at_once)
    return Fault::range("input.time_step", {in.time, "s"},
                        "the wheel has moved since wrc_contact_commit: give the time since then");
  double way = magnitude(in.wheel.velocity[0]);
  for (const double speed :
       {in.wheel.velocity[1] - in.rail.velocity_y, in.wheel.velocity[2] - in.rail.velocity_z})
    way += magnitude(speed);
  const double allowed = most + in.time * way;
  if (!(moved > allowed)) return {};
  return Fault::memory_dropped(
      "place of the wheel: moved", {moved, "m", 0.0, allowed},
      "further than its velocities in input.time_step take it: it begins without tractions");
}

}  // namespace

void mark_solution(const SurfaceState& state) {
  move_change(state.change, state.mark, state.last, state.earlier);
  take_change(state.mark, state.last, state.change);
  copy_start(state.last, state.mark);
}

SurfaceState cut_surface_state(Arena& arena, std::int32_t strips, std::int32_t remembered) {
  SurfaceState s;
  for (KeptStart* const start : {&s.last, &s.mark}) {
    start->head = arena.take<KeptStartHead>(1);
    arena.each(strips, start->strip, start->length_squared, start->shift, start->depth);
  }
  for (KeptChange* const change : {&s.change, &s.earlier})
    arena.each(strips, change->length_squared, change->shift, change->depth);
  s.kept.head = arena.take<StripResultsHead>(1);
  for (double** const column : s.kept.columns()) *column = arena.take(strips);
  s.steps = arena.take<RememberedSteps>(1);
  if (remembered == 0) return s;
  // two lists of strips: the committed ones, and those of the last solution
  const auto bytes = static_cast<std::int64_t>(tangential::Memory::bytes(remembered, 2));
  s.memory = reinterpret_cast<tangential::Memory*>(arena.take<std::byte>(bytes));
  return s;
}

bool commit_solution(const SurfaceState& state) {
  RememberedSteps& steps = *state.steps;
  if (!(steps.pending > 0.0)) return false;
  mark_solution(state);
  state.memory->turn_over();
  steps.pending = 0.0;
  steps.committed = 1.0;
  std::copy_n(steps.to, 3, steps.from);
  return true;
}

std::int64_t surface_workspace_bytes(const SurfaceModel& model) {
  return wheel_work_bytes(work_sizes(model)).all();
}

Fault solve_wheel_on_rail(const SurfaceModel& model, const WheelOnRail& in, SolutionStart from,
                          const SurfaceState& state, void* workspace, Wrench& out,
                          RailFrameJacobian* jacobian, RailFrameJacobian* by_track) noexcept {
  // results of the stages first; the rest of the workspace is scratch
  Arena arena(workspace);
  const WorkSizes sizes = work_sizes(model);
  StripArrays sections{};
  if (sizes.placed > 0) sections = cut_varying_strips(arena, sizes.placed);
  WheelSolution solution = cut_solution(arena, sizes, state.kept);
  const Arena behind_results = arena;
  WheelProblem problem{model, in, {}};
  problem.memory = state.memory;
  const Fault jump = problem.memory ? look_for_jump(in, *state.steps) : Fault{};
  if (jump.failed()) return jump;
  const std::int64_t remembered = problem.memory ? problem.memory->count : 0;
  if (jump.status != WRC_OK) problem.memory->count = 0;
  const Fault outside = place_rail(model, in.distance, sections, problem.rail);
  problem.rail.candidates = cut_candidates(arena, sizes.candidates);
  // the outline lies in the scratch: nothing reads it once the overlaps are found
  Arena scratch = arena;
  solution.overlaps.outline = cut_overlap_scratch(scratch, sizes.wheel_pieces, sizes.rail_strips);
  // heights of a search lie near each other
  if (in.load_prescribed) problem.rail.candidates.below = 0.35e-3;

  // from an earlier solution where there is one: a load is searched from its height, else below first touch
  const KeptStart& last = state.last;
  if (from == SolutionStart::mark) copy_start(state.mark, last);
  const bool warm = from != SolutionStart::anew && last.head->set > 0.0;
  HeightStart start{{last.strip,
                     last.length_squared,
                     last.shift,
                     last.depth,
                     static_cast<std::int32_t>(last.head->count),
                     {}},
                    warm ? StartFrom::solution : StartFrom::overlaps,
                    warm && last.head->stiffness > 0.0 ? last.head->stiffness : 1.0};
  if (from == SolutionStart::mark) {
    start.solution.change = {state.change.length_squared, state.change.shift, state.change.depth};
    start.solution.earlier = {state.earlier.length_squared, state.earlier.shift, state.earlier.depth};
  }
  out = {};
  const HeightSolver solver{problem, start, arena, solution, out};
  Fault fault;
  if (in.load_prescribed) {
    const double guess =
        warm ? predicted_height(solver, last.head->height, last.head->load) : first_height(solver);
    fault = solve_given_load(solver, guess);
  } else {
    fault = solve_given_height(solver);
  }
  // the state is that of the wrench: height, lengths (in arrays of `start`), strips
  *last.head = {start.from == StartFrom::overlaps ? 0.0 : 1.0, out.height, -out.force[2], start.stiffness,
                1.0 * start.solution.count};
  complete_results(problem, solution, state.kept);
  keep_worst(fault, another_place(problem, solution));
  keep_worst(fault, beyond_parabolas(problem, solution));
  if (problem.memory) {
    state.steps->pending = 1.0;
    state.steps->to[0] = in.wheel.position[1] - in.rail.y;
    state.steps->to[1] = out.height - in.rail.z;
    state.steps->to[2] = in.distance;
    keep_worst(fault, jump);
  }

  if (jacobian)
    keep_worst(fault, differentiate_wrench(problem, solution, JacobianBy::place, behind_results, *jacobian));
  if (by_track && varies(model))
    keep_worst(fault, differentiate_wrench(problem, solution, JacobianBy::track, behind_results, *by_track));
  if (problem.memory) problem.memory->count = remembered;  // the committed step stays as it was

  // numbers of the wrench that no region has, and places of strips along the profile, without those of rows
  for (std::int32_t k = 0; k < solution.strips.count; ++k) {
    out.steepest_angle = std::max(out.steepest_angle, std::abs(state.kept.angle[k] + in.rail.roll));
    state.kept.place[k] = problem.rail.s[on_rail(static_cast<std::int32_t>(state.kept.strip[k]))];
  }
  if (!in.load_prescribed && is_apart(fault)) out.clearance = clearance(problem, arena);
  keep_worst(fault, outside);
  return fault;
}

StripFields fields_of_strips(const SurfaceModel& model, const StripResults& results, std::int32_t first,
                             std::int32_t count, void* workspace) noexcept {
  Arena arena(workspace);
  const RollingScratch scratch = cut_rolling(arena, work_sizes(model));
  const tangential::TangentialFields& f = scratch.fields;
  ContactStrips strips;
  static_cast<ContactArrays&>(strips) = results.from(first);
  strips.count = count;

  // near standstill, where forces of both directions are blended, fields are those of the own direction
  const bool backwards = results.head->backwards > 0.0;
  const std::int32_t cells = model.grid->cells;
  if (!(results.head->rolls > 0.0)) {
    fill_free_slips(*model.grid, strips, backwards, f);
  } else {
    // the march of the solve again, with its slips and its friction; its forces are known and go to scratch
    WheelOnRail in;
    in.slope_reduction = results.head->slope_reduction;
    in.layer = results.head->layer;
    in.layer_of_strips = results.head->layer_of_strips > 0.0;
    solve_tractions(model, in, strips, backwards, scratch, f,
                    {scratch.other_fx, scratch.other_fy, scratch.other_mz});
    if (backwards) {
      reverse(count * cells, f.traction_x);
      reverse(count * cells, f.slip_x);
    }
  }
  return {count, cells, f.traction_x, f.traction_y, f.slip_x, f.slip_y, scratch.other_fx};
}

}  // namespace wrc::surface
