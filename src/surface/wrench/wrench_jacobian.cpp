#include "surface/wrench/wrench_jacobian.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "geometry/creepages.hpp"
#include "kernels/kernels.hpp"
#include "surface/rolling/layered_strips.hpp"
#include "surface/rolling/strip_numbers.hpp"
#include "surface/simd/tasks.hpp"
#include "surface/wrench/strip_friction.hpp"
#include "surface/wrench/strip_mechanics.hpp"
#include "surface/wrench/strip_rolling.hpp"
#include "surface/wrench/traction_differences.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc::surface {
namespace {

using Number = RailFrameDual;

/// Without damping no velocity changes a load.
bool still_loads(const WheelOnRail& in) { return !(in.damping > 0.0); }
static_assert(simd::StripNumbersSlopesTask::still_inputs == place_inputs);

constexpr std::int32_t strips_at_a_time = 8;  ///< strips that march together: the widest vector
constexpr std::int64_t kernel_numbers = 2 + simd::strip_inputs + 3;  // size, bound and results

DifferentiationScratch cut(Arena& arena, const WorkSizes& sizes) {
  const std::int32_t most = most_differentiated(sizes.strips);
  DifferentiationScratch w;
  PressedStrips& p = w.pressed;
  p.overlap = arena.take<OverlapSlopes>(most);
  // Overlaps stay. Pressures come first: line loads q, squared lengths L and centres c with derivatives, and
  // the scratch that finds them.
  Arena pressures = arena, differences = arena;
  pressures.each(most, p.place, p.width, p.line_load, p.length_squared, p.centre);
  pressures.each(most, p.line_load_dual, p.length_squared_dual, p.centre_dual);
  const Arena results = pressures;
  w.pressures = pressures.take(pressure_jacobian_doubles(most));

  // Tractions come last, in the same memory: by the chain rule, or by differences, under friction over
  // temperature and with memory.
  w.rolling = cut_rolling_arrays<Number>(arena, most, strips_at_a_time);
  // each strip's forces of the other direction replace numbers that no later strip reads
  w.other = {w.rolling.link, w.rolling.pivot, w.rolling.own};
  w.values = arena.take(strips_at_a_time * kernel_numbers);
  w.slopes = arena.take(strips_at_a_time * 3 * simd::strip_inputs);
  WorkSizes pressed = sizes;
  pressed.strips = most;
  w.differences = cut_differences(differences, pressed);
  arena.go_behind(differences);

  // Between them the strips that carry load are taken from the pressures.
  arena.go_behind(results);
  LoadedStrips& s = w.loaded;
  s.pressed = arena.take<std::int32_t>(most);
  arena.each(most, s.place, s.width);
  arena.each(most, s.normal, s.centre, s.half_length, s.peak, s.curvature, s.slip_x, s.slip_y, s.spin,
             s.friction, s.flexibility, s.fx, s.fy, s.mz);
  arena.go_behind(pressures);
  return w;
}

RelativePoseOf<PlaceDual> resting_pose(const RelativePose& pose) {
  RelativePoseOf<PlaceDual> resting;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) resting.rotation[i][k] = pose.rotation[i][k];
  resting.y = pose.y;
  resting.z = pose.z;
  return resting;
}

/// Overlap i with all that the track and the wheel's shape add: overlap_surfaces() of surface_geometry.cpp,
/// along the ray of the solution.
OverlapSlopes differentiate_overlap(const Differentiation& d, const RelativePoseOf<PlaceDual>& pose,
                                    const OutlineAttitudeOf<PlaceDual>& attitude, std::int32_t i) {
  const SurfaceModel& model = d.problem.model;
  const PlacedRail& rail = d.problem.rail;
  const Overlaps& overlaps = d.solved.overlaps;
  const std::int32_t j = on_rail(overlaps.strip[i]);
  const auto on_the_same_rail = [&] {
    OverlapSlopes o;
    model.kernels->surface.overlap_slopes({rail.y[j], rail.z[j], rail.ty[j], rail.tz[j], &model.wheel.curve,
                                           &pose, &attitude, overlaps.piece[i], overlaps.u[i]},
                                          o);
    return o;
  };
  if (!varies(model)) return on_the_same_rail();

  // beyond the last section nothing changes with the distance
  PlaceDual distance = rail.distance, angle = d.problem.in.angle;
  if (d.by == JacobianBy::track) {
    if (rail.distance == d.problem.in.distance) distance.d[track_distance] = 1.0;
    angle.d[track_angle] = 1.0;
  }
  // the same corrections as of plain numbers, in the same order
  if (changes_along(model, j)) {
    FollowedStrips near{};
    const auto put = [&](std::int64_t k) {
      put_largest(j, {overlaps.top[k], {overlaps.piece[k], overlaps.u[k], overlaps.depth[k]}}, overlaps.ny[k],
                  overlaps.nz[k], near, bounds_of(overlaps.bound[k], overlaps.top[k]));
    };
    put(i);
    // the strip's other place along the track
    const std::int32_t other = overlaps.strip[i] ^ second_places;
    const std::int32_t *const begin = overlaps.strip, *const end = begin + overlaps.count;
    const std::int32_t* const found = std::lower_bound(begin, end, other);
    if (found != end && *found == other) put(found - begin);
    OverlapSlopes o = overlap_slopes(model, rail, pose, distance, near);
    follow_others<PlaceDual>(model, rail, pose, j, o.y_wheel, distance, angle, o);
    return o;
  }
  OverlapSlopes o = on_the_same_rail();
  follow_others<PlaceDual>(model, rail, pose, j, o.y_wheel, distance, angle, o);
  return o;
}

/// The strips that press, with their overlaps and pressures differentiated.
Fault take_pressed_strips(const Differentiation& d) {
  const RailStrips& rail = d.problem.rail;
  const Overlaps& o = d.solved.overlaps;
  const StripPressure& p = d.solved.pressure;
  const RelativePose& solved = d.solved.motion.pose;
  PressedStrips& s = d.w.pressed;
  s.count = s.behind = 0;
  const std::int32_t most = most_differentiated(d.problem.model.most_overlapping);
  // by track the wheel rests, and strips and outline move below it
  const RelativePoseOf<PlaceDual> pose =
      d.by == JacobianBy::place ? moving_pose(solved) : resting_pose(solved);
  const OutlineAttitudeOf<PlaceDual> attitude = attitude_of(pose);
  for (std::int32_t i = 0; i < o.count; ++i) {
    if (!(p.length_squared[i] > 0.0 && p.line_load[i] > 0.0)) continue;
    if (s.count == most) {
      return Fault::more_patches("strips in contact", {1.0 + most, "", 0.0, 1.0 * most},
                                 "there is no room for the derivatives of so many");
    }

    // the converged numbers, and the overlap again with its derivatives
    const std::int32_t k = s.count++, j = on_rail(o.strip[i]);
    s.behind += o.strip[i] < second_places ? 1 : 0;
    s.place[k] = place_on_rail(rail, o.strip[i]);
    s.width[k] = rail.width[j];
    s.line_load[k] = p.line_load[i];
    s.length_squared[k] = p.length_squared[i];
    s.centre[k] = p.centre[i];
    s.overlap[k] = differentiate_overlap(d, pose, attitude, i);
  }
  differentiate_pressures(pressure_model(d.problem.model), d.w.pressures, pressure_jacobian_doubles(most), s);
  return {};
}

/// The wheel's velocities, which are inputs themselves. By track v_z = turning * distance of a roller alone
/// changes.
RelativeVelocityOf<Number> differentiate_velocity(const RelativeVelocityOf<double>& solved, JacobianBy by) {
  RelativeVelocityOf<Number> v;
  v.on_roller = solved.on_roller;
  v.roller = solved.roller;
  for (std::size_t i = 0; i < 3; ++i) {
    v.linear[i] = solved.linear[i];
    v.angular[i] = solved.angular[i];
    if (by == JacobianBy::track) continue;
    v.linear[i].d[frame_velocity + i] = 1.0;
    v.angular[i].d[frame_turning + i] = 1.0;
  }
  if (by == JacobianBy::track) v.linear[2].d[track_distance] = solved.roller;
  if (by == JacobianBy::place) v.roller.d[frame_roller] = 1.0;
  return v;
}

/// The strips that carry load, slips as velocities, and their speed of rolling: take_loaded_strips() and
/// rolling_speed_of() of at_height.cpp.
Number differentiate_loaded_strips(const Differentiation& d) {
  const PressedStrips& s = d.w.pressed;
  LoadedStrips& loaded = d.w.loaded;
  const WheelOnRail& in = d.problem.in;
  const RelativeVelocityOf<Number> velocity = differentiate_velocity(d.solved.motion.velocity, d.by);
  const bool graded = d.solved.overlaps.grade != nullptr;
  // a factor of 1 on all friction, whose derivative is that by the coefficient, whatever the law
  loaded.count = 0;
  loaded.friction_factor = 1.0;
  if (d.by == JacobianBy::place) loaded.friction_factor.d[frame_friction] = 1.0;
  Number load = 0.0, sliding = 0.0, below = 0.0;
  for (std::int32_t k = 0; k < s.count; ++k) {
    const OverlapSlopes& o = s.overlap[k];
    const StripMotion<Number> m = motion_at<Number>(velocity, o, s.centre_dual[k], graded);
    const PlaceDual half_length = root(s.length_squared_dual[k]);
    // N = pi/2 w q times the damping factor, which is never below zero
    const auto take = [&](const auto& line_load, const auto& curvature) {
      const auto N = (0.5 * pi * s.width[k]) * line_load;
      if (!(N.value > 0.0)) return;
      const std::int32_t i = loaded.count++;
      loaded.pressed[i] = k;
      // neighbours are told by row_place()
      loaded.place[i] = k < s.behind ? s.place[k] : s.place[k] + rows_apart;
      loaded.width[i] = s.width[k];
      loaded.normal[i] = frame_number(N);
      loaded.centre[i] = frame_number(s.centre_dual[k]);
      loaded.half_length[i] = frame_number(half_length);
      loaded.peak[i] = frame_number(line_load / half_length);
      loaded.curvature[i] = frame_number(curvature);
      loaded.slip_x[i] = m.along;
      loaded.slip_y[i] = m.across;
      loaded.spin[i] = m.spin;
      loaded.friction[i] = in.friction * loaded.friction_factor;
      loaded.fx[i] = loaded.fy[i] = loaded.mz[i] = 0.0;
      load += N;
      sliding += N * m.along;
      below += N * o.wz;
    };
    if (still_loads(in)) {
      take(s.line_load_dual[k], o.curvature);
    } else {
      const Number damped = larger(Number(0.0), 1.0 + 1.5 * in.damping * m.approach);
      take(damped * s.line_load_dual[k], damped * o.curvature);
    }
  }
  if (loaded.count == 0) return 0.0;

  // V = v_x - <slip velocity> / 2, means weighted by load
  Number speed = velocity.linear[0] - 0.5 * (sliding / load);
  if (velocity.on_roller) speed = speed - velocity.roller * (below / load);
  return speed;
}

/// Coefficients of cold strips at their sliding speeds: set_cold_friction() of strip_friction.cpp.
void differentiate_friction(const Differentiation& d, const Number& speed) {
  const tangential::FrictionLaw& law = *d.problem.in.law;
  const Overlaps& overlaps = d.solved.overlaps;
  const LoadedStrips& s = d.w.loaded;
  for (std::int32_t k = 0; k < s.count; ++k) {
    const FrictionAtRest at_rest = friction_at_rest(d.problem, overlaps, d.solved.strips.candidate[k]);
    // mu = mu_rest(y) f(V |xi|), the root mean square of the rigid slip over the strip
    const Number turning = s.spin[k] * s.half_length[k];
    const Number slip2 = s.slip_x[k] * s.slip_x[k] + s.slip_y[k] * s.slip_y[k] + turning * turning / 3.0;
    const Number sliding = speed * root(slip2);

    // d mu = mu_rest f' d(V |xi|) + f d mu_rest/dy dy
    const double falls = tangential::speed_factor(law, sliding.value);
    s.friction[k] =
        s.friction_factor *
        (at_rest.value * sliding.chain(falls, tangential::speed_factor_slope(law, sliding.value)));
    s.flexibility[k] = at_rest.layer.flexibility;
    if (!moves_with_wheel(d.problem.in)) continue;
    s.friction[k] += d.y_on_wheel(k).chain(0.0, at_rest.by_wheel_y * falls);
    s.flexibility[k] = d.y_on_wheel(k).chain(at_rest.layer.flexibility, at_rest.layer_by_wheel_y.flexibility);
  }
}

/// Numbers of a kernel task in w.values, one array behind the other.
struct KernelArrays {
  double* next;
  std::int32_t strips;

  double* values_of(const Number* numbers) {
    double* const values = take();
    for (std::int32_t k = 0; k < strips; ++k) values[k] = numbers[k].value;
    return values;
  }
  double* take() {
    double* const here = next;
    next += strips;
    return here;
  }
};

/// Tractions of some strips by the chain rule: the kernel's Jacobian by its nine inputs times their
/// derivatives.
void differentiate_strips(const Differentiation& d, const SurfaceRollingInputOf<Number>& s,
                          const RollingArraysOf<Number>& a, const DualForces& forces) {
  const std::int32_t n = s.count;
  // The kernel's inputs, by SurfaceStripInput: but for the spin, which it multiplies by the half length.
  const Number* const inputs[simd::strip_inputs] = {a.growth_x, a.growth_y, a.curvature, a.slip_x, a.slip_y,
                                                    s.spin,     a.elastic,  a.turn_x,    a.turn_y};
  KernelArrays arrays{d.w.values, n};

  // forces and their derivatives by each input, at the values of the inputs
  simd::SurfaceStripsSlopesTask task{};
  task.strips = n;
  task.cells = s.grid->cells;
  task.shape = &s.grid->elliptic;
  task.inverse_weight = s.grid->inverse_weight;
  task.width = s.width;
  task.half_length = arrays.values_of(s.half_length);
  task.bound = arrays.values_of(a.bound);
  task.growth_x = arrays.values_of(inputs[simd::strip_growth_x]);
  task.growth_y = arrays.values_of(inputs[simd::strip_growth_y]);
  task.curvature = arrays.values_of(inputs[simd::strip_curvature]);
  task.slip_x = arrays.values_of(inputs[simd::strip_slip_x]);
  task.slip_y = arrays.values_of(inputs[simd::strip_slip_y]);
  task.spin = arrays.values_of(inputs[simd::strip_spin]);
  task.elastic = arrays.values_of(inputs[simd::strip_elastic]);
  task.turn_x = arrays.values_of(inputs[simd::strip_turn_x]);
  task.turn_y = arrays.values_of(inputs[simd::strip_turn_y]);
  task.fx = arrays.take();
  task.fy = arrays.take();
  task.mz = arrays.take();
  task.slopes = d.w.slopes;
  s.grid->kernels->tangential.surface_strips_slopes(task);

  simd::StripForcesSlopesTask sums{n,
                                   a.bound,
                                   s.half_length,
                                   {},
                                   {task.fx, task.fy, task.mz},
                                   d.w.slopes,
                                   {forces.fx, forces.fy, forces.mz}};
  std::copy_n(inputs, simd::strip_inputs, sums.inputs);
  s.grid->kernels->surface.strip_forces_slopes(sums);
}

/// The layer of the k-th strip that carries load.
tangential::LayerOf<Number> differentiate_layer(const Differentiation& d, std::int32_t k) {
  const FrictionAtRest of = friction_at_rest(d.problem, d.solved.overlaps, d.solved.strips.candidate[k]);
  const auto moved = [&](double value, double slope) {
    return moves_with_wheel(d.problem.in) ? d.y_on_wheel(k).chain(value, slope) : Number(value);
  };
  return {d.w.loaded.flexibility[k], moved(of.layer.yield, of.layer_by_wheel_y.yield),
          moved(of.layer.hardening, of.layer_by_wheel_y.hardening)};
}

/// The same with a layer: the march with derivatives by its own numbers, times the derivatives of these.
/// `first`: number of the first strip among those that carry load. A call of its own: inlined, its numbers
/// take stack of the march without a layer, which is the deepest.
[[gnu::noinline]] void differentiate_layered(const Differentiation& d,
                                             const SurfaceRollingInputOf<Number>& rolls,
                                             const RollingArraysOf<Number>& arrays, std::int32_t first,
                                             const DualForces& forces) {
  constexpr std::size_t numbers = tangential::LayeredNumbers::numbers;
  using OfStrip = Dual<numbers>;
  const tangential::MarchGrid& grid = *rolls.grid;
  for (std::int32_t k = 0; k < rolls.count; ++k) {
    const tangential::LayeredStripAt<Number> strip =
        d.problem.in.layer_of_strips ? layered_strip(rolls, arrays, differentiate_layer(d, first + k), k)
                                     : layered_strip(rolls, arrays, rolls.layer, k);
    tangential::LayeredStrip<OfStrip> varied;
    for (std::size_t i = 0; i < numbers; ++i) varied.of[i] = OfStrip::input(strip.numbers.of[i].value, i);
    const tangential::LayeredSum<OfStrip> sum = march_strip(varied, grid.elliptic, grid);
    const auto by_inputs = [&](const OfStrip& of) {
      Number all = of.value;
      for (std::size_t i = 0; i < numbers; ++i)
        pairwise::add<frame_inputs>(of.d[i], strip.numbers.of[i].d.data(), all.d.data());
      return all;
    };
    // force = bound l width times the sums
    const Number force = rolls.width[k] * (strip.bound * rolls.half_length[k]);
    forces.fx[k] = force * by_inputs(sum.x);
    forces.fy[k] = force * by_inputs(sum.y);
    forces.mz[k] = (force * rolls.half_length[k]) * by_inputs(sum.turn);
  }
}

/// Tractions of the strips: from slips and lengths to the numbers of the march, and through it.
void differentiate_tractions(const Differentiation& d, bool backwards, const DualForces& forces) {
  const SurfaceModel& model = d.problem.model;
  const LoadedStrips& s = d.w.loaded;
  const std::int32_t n = s.count;
  auto rolls = rolling_input<Number>(model, d.problem.in, s);
  rolls.peak = s.peak;
  // backwards: the mirror image across the axle, as in solve_one_way() of strip_rolling.cpp
  if (backwards) {
    reverse(n, s.slip_x);
    reverse(n, s.spin);
  }

  // means over neighbours from slips and lengths, then the march, some strips at a time
  const RollingArraysOf<Number>& all = d.w.rolling;
  const strip_numbers::Shared shared = strip_numbers::shared(rolls);
  const simd::SurfaceKernels& kernels = model.grid->kernels->surface;
  const bool still = still_loads(d.problem.in);
  kernels.strip_means_slopes({&rolls, &shared, &all, still});
  for (std::int32_t first = 0; first < n; first += strips_at_a_time) {
    SurfaceRollingInputOf<Number> some = rolls;
    some.count = std::min(n - first, strips_at_a_time);
    RollingArraysOf<Number> arrays = all;
    const auto begin_there = [first](auto&... lists) { ((lists += first), ...); };
    begin_there(some.place, some.width, some.half_length, some.peak, some.curvature, some.slip_x, some.slip_y,
                some.spin, some.friction);
    if (some.flexibility != nullptr) begin_there(some.flexibility);
    begin_there(arrays.load, arrays.c11, arrays.c22, arrays.c23, arrays.own, arrays.pressed);
    for (Number*& mean : arrays.mean) mean += first;
    kernels.strip_arrays_slopes({&some, &shared, &arrays, still});

    const DualForces found{forces.fx + first, forces.fy + first, forces.mz + first};
    if (rolls.layered()) {
      differentiate_layered(d, some, arrays, first, found);
    } else {
      differentiate_strips(d, some, arrays, found);
    }
  }
  if (backwards)
    for (Number* numbers : {s.slip_x, s.spin, forces.fx, forces.mz}) reverse(n, numbers);
}

/// Tractions from velocities of the strips: slips over the speed, and both directions of rolling near
/// standstill, as roll_strips() of strip_rolling.cpp.
void differentiate_rolling(const Differentiation& d, const Number& rolling_speed) {
  const LoadedStrips& s = d.w.loaded;
  // slips: velocities over the speed, which is bounded below near standstill
  const geometry::RollingReferenceOf<Number> reference = geometry::rolling_reference(rolling_speed);
  const Number per_speed = Number(1.0) / reference.divisor;
  for (std::int32_t k = 0; k < s.count; ++k)
    for (Number* const slip : {s.slip_x, s.slip_y, s.spin}) slip[k] = slip[k] * per_speed;

  if (d.problem.memory)
    return differentiate_remembered(d, rolling_speed, reference.divisor, {s.fx, s.fy, s.mz});

  // friction first: tractions are bounded by it; heated, its share is found with them
  const tangential::FrictionLaw* const law = d.problem.in.law;
  if (law) differentiate_friction(d, reference.divisor);
  const auto roll_one_way = [&](bool backwards, const DualForces& forces) {
    if (law && law->heated()) return differentiate_heated(d, reference.divisor, backwards, forces);
    differentiate_tractions(d, backwards, forces);
  };
  const bool backwards = rolling_speed.value < 0.0;
  roll_one_way(backwards, {s.fx, s.fy, s.mz});

  // F = F_own + share (F_other - F_own), the share with its derivatives
  const Number& other = reference.reverse_share;
  if (!(other.value > 0.0)) return;
  const DualForces& f = law && law->heated() ? d.w.differences.other : d.w.other;
  roll_one_way(!backwards, f);
  for (std::int32_t k = 0; k < s.count; ++k) {
    s.fx[k] += other * (f.fx[k] - s.fx[k]);
    s.fy[k] += other * (f.fy[k] - s.fy[k]);
    s.mz[k] += other * (f.mz[k] - s.mz[k]);
  }
}

}  // namespace

void count_wrench_jacobian(Arena& arena, const WorkSizes& sizes) { cut(arena, sizes); }

Fault differentiate_wrench(const WheelProblem& problem, const WheelSolution& solved, JacobianBy by,
                           Arena arena, RailFrameJacobian& out) noexcept {
  out = {};
  // stages as of the solution: overlaps and pressures, slips, tractions, sums
  DifferentiationScratch w = cut(arena, work_sizes(problem.model));
  const Differentiation d{problem, solved, by, w};
  const Fault fault = take_pressed_strips(d);
  if (fault.status != WRC_OK) return fault;
  const Number rolling_speed = differentiate_loaded_strips(d);
  const LoadedStrips& loaded = w.loaded;
  if (loaded.count == 0) return {};
  const bool rolls = problem.in.friction > 0.0;
  if (rolls) differentiate_rolling(d, rolling_speed);

  // force and moment about the wheel's reference point, rail axes
  const bool graded = solved.overlaps.grade != nullptr;
  for (std::int32_t i = 0; i < loaded.count; ++i) {
    const std::int32_t k = loaded.pressed[i];
    add_force<Number>(w.pressed.overlap[k], place_number(loaded.centre[i]), graded,
                      {loaded.normal[i], loaded.fx[i], loaded.fy[i], loaded.mz[i]}, out.force, out.moment);
  }
  // the time of a step changes tractions alone
  if (!problem.memory || !rolls || by == JacobianBy::track) return {};
  const DifferencesScratch& h = w.differences;
  for (std::int32_t i = 0; i < loaded.count; ++i) {
    const StripOverlap<double> o = strip_of(solved.overlaps, solved.strips.candidate[i]);
    add_force(o, loaded.centre[i].value, graded, {0.0, h.fx_by_time[i], h.fy_by_time[i], h.mz_by_time[i]},
              out.force_by_time, out.moment_by_time);
  }
  return {};
}

}  // namespace wrc::surface
