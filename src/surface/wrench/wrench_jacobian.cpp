#include "surface/wrench/wrench_jacobian.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "geometry/creepages.hpp"
#include "kernels/kernels.hpp"
#include "surface/geometry/along_track.hpp"
#include "surface/pressure/pressure_jacobian.hpp"
#include "surface/rolling/layered_strips.hpp"
#include "surface/rolling/strip_numbers.hpp"
#include "surface/simd/tasks.hpp"
#include "surface/wrench/strip_friction.hpp"
#include "surface/wrench/strip_mechanics.hpp"
#include "surface/wrench/strip_rolling.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc::surface {
namespace {

using Number = RailFrameDual;
static_assert(frame_inputs == simd::StripNumbersSlopesTask::inputs);

Number frame_number(const PlaceDual& a) {
  Number n = a.value;
  for (std::size_t k = 0; k < place_inputs; ++k) n.d[k] = a.d[k];
  return n;
}

StripOverlap<Number> frame_overlap(const OverlapSlopes& o) {
  return {frame_number(o.depth), frame_number(o.centre), frame_number(o.curvature), frame_number(o.ny),
          frame_number(o.nz),    frame_number(o.wy),     frame_number(o.wz),        frame_number(o.grade)};
}

/// Numbers of the strips that carry load; one element per strip.
struct LoadedStrips {
  std::int32_t count = 0;
  Number friction_factor = 1.0;  ///< on the friction of all
  std::int32_t* pressed;         ///< number among the strips in contact
  double *place, *width;         ///< [m]
  Number *normal, *centre, *half_length, *peak, *curvature, *slip_x, *slip_y, *spin, *friction, *flexibility;
  Number *fx, *fy, *mz, *other_fx, *other_fy, *other_mz;
};

/// Forces of one direction of rolling.
struct DualForces {
  Number *fx, *fy, *mz;
};

/// Plain numbers of differences, under friction over temperature and with memory.
struct DifferencesScratch {
  double *half_length, *peak, *curvature, *slip_x, *slip_y, *spin, *x, *friction, *fx, *fy, *mz;
  double *flexibility, *yield, *hardening;
  double* share;                        ///< hot over cold friction in the solution [-]
  double *base_fx, *base_fy, *base_mz;  ///< forces that differences are taken from
  RollingScratch rolling;               ///< friction over temperature
  tangential::PastStrip* written;       ///< strips of steps that remember
  Arena remembering;                    ///< scratch of these steps
};

struct Scratch {
  PressedStrips pressed;
  double* pressures;  ///< scratch of differentiate_pressures(), whose memory is that of all below
  LoadedStrips loaded;
  RollingArraysOf<Number> rolling;
  double* values;                  ///< for the kernel: its numbers without derivatives
  double* slopes;                  ///< from the kernel
  DifferencesScratch differences;  ///< its memory is that of the three above
};

constexpr std::int32_t strips_at_a_time = simd::most_lanes;          ///< strips that march together
constexpr std::int64_t kernel_numbers = 2 + simd::strip_inputs + 3;  // size, bound and results

Scratch cut(Arena& arena, const WorkSizes& sizes) {
  const std::int32_t most = most_differentiated(sizes.strips);
  Scratch w;
  // results of the pressures stay: overlaps, line loads q, squared lengths L and centres c with derivatives
  PressedStrips& p = w.pressed;
  arena.each(most, p.place, p.width, p.line_load, p.length_squared, p.centre);
  arena.each(most, p.line_load_dual, p.length_squared_dual, p.centre_dual);
  p.overlap = arena.take<OverlapSlopes>(most);

  // Their elimination comes before everything below, and shares its memory.
  Arena pressures = arena;
  w.pressures = pressures.take(pressure_jacobian_doubles(most));

  LoadedStrips& s = w.loaded;
  s.pressed = arena.take<std::int32_t>(most);
  arena.each(most, s.place, s.width);
  arena.each(most, s.normal, s.centre, s.half_length, s.peak, s.curvature, s.slip_x, s.slip_y, s.spin,
             s.friction, s.flexibility, s.fx, s.fy, s.mz, s.other_fx, s.other_fy, s.other_mz);
  // Tractions by the chain rule, or by differences: under friction over temperature, and with memory.
  Arena differences = arena;
  w.rolling = cut_rolling_arrays<Number>(arena, most, strips_at_a_time);
  w.values = arena.take(strips_at_a_time * kernel_numbers);
  w.slopes = arena.take(strips_at_a_time * 3 * simd::strip_inputs);
  DifferencesScratch& h = w.differences;
  differences.each(most, h.half_length, h.peak, h.curvature, h.slip_x, h.slip_y, h.spin, h.x, h.friction,
                   h.flexibility, h.yield, h.hardening, h.fx, h.fy, h.mz, h.share, h.base_fx, h.base_fy,
                   h.base_mz);
  WorkSizes rolling = sizes;
  rolling.strips = most;
  if (sizes.methods.remembers) {
    h.written = differences.take<tangential::PastStrip>(most);
    h.remembering = differences;
    count_remembered_tractions(differences, rolling);
  } else {
    h.rolling = cut_rolling(differences, rolling);
  }

  // whichever of them is largest
  const std::int64_t behind = std::max(pressures.bytes(), differences.bytes()) - arena.bytes();
  if (behind > 0) arena.take<char>(behind);
  return w;
}

/// A solution that is being differentiated.
struct Differentiation {
  const WheelProblem& problem;
  const WheelSolution& solved;
  JacobianBy by;
  Scratch& w;
};

/// Place of the k-th strip that carries load on the wheel's profile [m].
Number y_on_wheel(const Scratch& w, std::int32_t k) {
  return frame_number(w.pressed.overlap[w.loaded.pressed[k]].y_wheel);
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
  const std::int32_t j = overlaps.strip[i], piece = overlaps.piece[i];
  const double u = overlaps.u[i];
  const StripPlace place{rail.y[j], rail.z[j], rail.ty[j], rail.tz[j]};
  if (!varies(model)) return overlap_slopes(place, model.wheel.curve, pose, attitude, piece, u);

  // beyond the last section nothing changes with the distance
  PlaceDual distance = rail.distance, angle = d.problem.in.angle;
  if (d.by == JacobianBy::track) {
    if (rail.distance == d.problem.in.distance) distance.d[track_distance] = 1.0;
    angle.d[track_angle] = 1.0;
  }
  // the same corrections as of plain numbers, in the same order
  if (changes_along(model, j)) {
    OverlapSlopes o;
    static_cast<StripOverlap<PlaceDual>&>(o) = {overlaps.depth[i], overlaps.centre[i], overlaps.curvature[i],
                                                overlaps.ny[i],    overlaps.nz[i],     overlaps.wy[i],
                                                overlaps.wz[i],    overlaps.grade[i]};
    LargestOverlap found{overlaps.centre[i], {piece, u, overlaps.depth[i]}};
    o.y_wheel = follow_rail<PlaceDual>(rail, model.varying, model.wheel.curve, pose, j, distance, found, o);
    follow_others<PlaceDual>(model, rail, pose, j, o.y_wheel, distance, angle, o);
    return o;
  }
  OverlapSlopes o = overlap_slopes(place, model.wheel.curve, pose, attitude, piece, u);
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
  s.count = 0;
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
    const std::int32_t k = s.count++, j = o.strip[i];
    s.place[k] = rail.s[j];
    s.width[k] = rail.width[j];
    s.line_load[k] = p.line_load[i];
    s.length_squared[k] = p.length_squared[i];
    s.centre[k] = p.centre[i];
    s.overlap[k] = differentiate_overlap(d, pose, attitude, i);
  }
  differentiate_pressures(pressure_model(d.problem.model), d.w.pressures, s);
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
    const StripOverlap<Number> o = frame_overlap(s.overlap[k]);
    const StripMotion<Number> m = motion_at(velocity, o, frame_number(s.centre_dual[k]), graded);
    // N = pi/2 w q times the damping factor, which is never below zero
    const Number damped = larger(Number(0.0), 1.0 + 1.5 * in.damping * m.approach);
    const Number line_load = damped * frame_number(s.line_load_dual[k]);
    const Number N = (0.5 * pi * s.width[k]) * line_load;
    if (!(N.value > 0.0)) continue;

    const std::int32_t i = loaded.count++;
    loaded.pressed[i] = k;
    loaded.place[i] = s.place[k];
    loaded.width[i] = s.width[k];
    loaded.normal[i] = N;
    loaded.centre[i] = frame_number(s.centre_dual[k]);
    loaded.half_length[i] = root(frame_number(s.length_squared_dual[k]));
    loaded.peak[i] = line_load / loaded.half_length[i];
    loaded.curvature[i] = damped * o.curvature;
    loaded.slip_x[i] = m.along;
    loaded.slip_y[i] = m.across;
    loaded.spin[i] = m.spin;
    loaded.friction[i] = in.friction * loaded.friction_factor;
    loaded.fx[i] = loaded.fy[i] = loaded.mz[i] = 0.0;
    load += N;
    sliding += N * m.along;
    below += N * o.wz;
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
    s.friction[k] += y_on_wheel(d.w, k).chain(0.0, at_rest.by_wheel_y * falls);
    s.flexibility[k] =
        y_on_wheel(d.w, k).chain(at_rest.layer.flexibility, at_rest.layer_by_wheel_y.flexibility);
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

  for (std::int32_t k = 0; k < n; ++k) {
    const double found[3] = {task.fx[k], task.fy[k], task.mz[k]};
    Number* const results[3] = {&forces.fx[k], &forces.fy[k], &forces.mz[k]};
    const Number turned = s.spin[k] * s.half_length[k];
    // Forces are proportional to bound and half length, the moment to the square of that:
    // dF = F (dB / B + dl / l) + sum over the inputs of dF/dx dx.
    const double per_bound = a.bound[k].value > 0.0 ? 1.0 / a.bound[k].value : 0.0;
    const double per_length = 1.0 / s.half_length[k].value;
    for (int r = 0; r < 3; ++r) {
      Number& f = *results[r];
      f = found[r];
      const auto add = [&](double slope, const Number& x) {
        pairwise::add<frame_inputs>(slope, x.d.data(), f.d.data());
      };
      add(found[r] * per_bound, a.bound[k]);
      add((r == 2 ? 2.0 : 1.0) * found[r] * per_length, s.half_length[k]);
      for (std::int32_t input = 0; input < simd::strip_inputs; ++input)
        add(d.w.slopes[(3 * input + r) * n + k], input == simd::strip_spin ? turned : inputs[input][k]);
    }
  }
}

/// The layer of the k-th strip that carries load.
tangential::LayerOf<Number> differentiate_layer(const Differentiation& d, std::int32_t k) {
  const FrictionAtRest of = friction_at_rest(d.problem, d.solved.overlaps, d.solved.strips.candidate[k]);
  const auto moved = [&](double value, double slope) {
    return moves_with_wheel(d.problem.in) ? y_on_wheel(d.w, k).chain(value, slope) : Number(value);
  };
  return {d.w.loaded.flexibility[k], moved(of.layer.yield, of.layer_by_wheel_y.yield),
          moved(of.layer.hardening, of.layer_by_wheel_y.hardening)};
}

/// The same with a layer: the march with derivatives by its own numbers, times the derivatives of these.
/// `first`: number of the first strip among those that carry load.
void differentiate_layered(const Differentiation& d, const SurfaceRollingInputOf<Number>& rolls,
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
  kernels.strip_means_slopes({&rolls, &shared, &all});
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
    kernels.strip_arrays_slopes({&some, &shared, &arrays});

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

/// The strips moved by a step along their change by an input, for differences of tractions.
class StripsAlongInput {
 protected:
  static constexpr int results = 3, lengths = 0, slips = 3, spins = 5, places = 6;

  /// `numbers`: how many of the numbers in from_ the tractions depend on.
  StripsAlongInput(const Differentiation& d, const Number& speed, int numbers)
      : d_(d),
        s_(d.w.loaded),
        h_(d.w.differences),
        speed_(speed),
        strips_(d.solved.strips),
        numbers_(numbers) {
    // numbers that inputs change are its own; places, widths and candidates stay those of the solution
    strips_.count = s_.count;
    strips_.half_length = h_.half_length;
    strips_.solved_peak = h_.peak;
    strips_.curvature = h_.curvature;
    strips_.slip_x = h_.slip_x;
    strips_.slip_y = h_.slip_y;
    strips_.spin = h_.spin;
    strips_.x = h_.x;
    strips_.friction = h_.friction;
    strips_.flexibility = h_.flexibility;
    strips_.yield = h_.yield;
    strips_.hardening = h_.hardening;
    for (int a = 0; a < numbers; ++a)
      for (std::int32_t k = 0; k < s_.count; ++k) size_[a] = larger(size_[a], magnitude(from_[a][k].value));
    // slips and spin share a size, so that a slip of zero has one
    constexpr double least_slip = 1e-4;
    const double slip =
        larger(larger(size_[slips], size_[slips + 1]), larger(size_[spins] * size_[lengths], least_slip));
    size_[slips] = size_[slips + 1] = slip;
    size_[spins] = slip / size_[lengths];
    size_[places] = size_[lengths];
  }

  /// Largest change of any number of the strips per unit of an input, relative to the number's size.
  double largest_change(std::size_t input) const {
    double change = larger(magnitude(speed_.d[input]) / speed_.value, magnitude(s_.friction_factor.d[input]));
    for (int a = 0; a < numbers_; ++a)
      for (std::int32_t k = 0; k < s_.count; ++k)
        change = larger(change, magnitude(from_[a][k].d[input]) / size_[a]);
    return change;
  }

  /// Moves the strips by a step along an input, and fills `friction` with cold friction. Returns the speed by
  /// which slips were divided.
  double go(std::size_t input, double step, double* friction) {
    double* const to[] = {h_.half_length, h_.peak, h_.curvature, h_.slip_x, h_.slip_y, h_.spin, h_.x};
    for (std::int32_t k = 0; k < s_.count; ++k)
      for (int a = 0; a < numbers_; ++a) to[a][k] = from_[a][k].value + step * from_[a][k].d[input];
    const double speed = speed_.value + step * speed_.d[input];
    const double factor = 1.0 + step * s_.friction_factor.d[input];

    // the law at each strip's own place and sliding speed
    const WheelOnRail& in = d_.problem.in;
    for (std::int32_t k = 0; k < s_.count; ++k) {
      to[lengths][k] = larger(to[lengths][k], 0.0);
      friction[k] = in.friction * factor;
      if (in.law == nullptr) continue;
      const FrictionAtRest cold = friction_at_rest(d_.problem, d_.solved.overlaps, strips_.candidate[k]);
      const double way = moves_with_wheel(in) ? step * y_on_wheel(d_.w, k).d[input] : 0.0;
      const double mu = larger(cold.value + way * cold.by_wheel_y, 0.0);
      const tangential::Layer &layer = cold.layer, &slope = cold.layer_by_wheel_y;
      strips_.flexibility[k] = layer.flexibility + way * slope.flexibility;
      strips_.yield[k] = layer.yield + way * slope.yield;
      strips_.hardening[k] = layer.hardening + way * slope.hardening;
      friction[k] = mu * (strip_speed_factor(*in.law, strips_, k, speed) * factor);
    }
    return speed;
  }

  /// Derivatives of the forces that the scratch holds, by one difference along each input. `change_by`:
  /// largest relative change of any number per unit of an input, which a step makes `relative_step`.
  /// `solve`: fills the scratch with the forces a step along an input.
  template <class Change, class Solve>
  void take_differences(const DualForces& forces, double relative_step, const Change& change_by,
                        const Solve& solve) {
    Number* const results_of[results] = {forces.fx, forces.fy, forces.mz};
    const double* const found[results] = {h_.fx, h_.fy, h_.mz};
    double* const base[results] = {h_.base_fx, h_.base_fy, h_.base_mz};
    for (int r = 0; r < results; ++r) std::copy_n(found[r], s_.count, base[r]);
    for (std::size_t input = 0; input < frame_inputs; ++input) {
      const double change = change_by(input);
      if (!(change > 0.0)) continue;
      const double step = relative_step / change;
      solve(input, step);
      for (int r = 0; r < results; ++r)
        for (std::int32_t k = 0; k < s_.count; ++k)
          results_of[r][k].d[input] = (found[r][k] - base[r][k]) / step;
    }
  }

  const Differentiation& d_;
  const LoadedStrips& s_;
  const DifferencesScratch& h_;
  const Number& speed_;
  ContactStrips strips_;  ///< those of the solution, with numbers of their own

 private:
  const Number* from_[7] = {s_.half_length, s_.peak, s_.curvature, s_.slip_x, s_.slip_y, s_.spin, s_.centre};
  double size_[7] = {};
  int numbers_;
};

/// Tractions under friction over temperature: by one difference of their solution along the change of the
/// strips with each input.
class HeatedDifferences : StripsAlongInput {
 public:
  HeatedDifferences(const Differentiation& d, const Number& speed, bool backwards)
      : StripsAlongInput(d, speed, 6), backwards_(backwards) {}

  /// Fills the forces and their derivatives.
  void differentiate(const DualForces& forces) {
    constexpr int more_solutions = 3;  // from friction found
    Number* const results_of[results] = {forces.fx, forces.fy, forces.mz};
    const double* const found[results] = {h_.fx, h_.fy, h_.mz};
    // values: as the solution has them, from the start
    const std::int32_t n = s_.count;
    solve(0, 0.0, 0);
    for (int r = 0; r < results; ++r)
      for (std::int32_t k = 0; k < n; ++k) results_of[r][k] = found[r][k];

    // both sides of a difference iterate equally often, from the same shares
    std::copy_n(h_.rolling.heat_share, n, h_.share);
    solve(0, 0.0, more_solutions);

    constexpr double relative_step = 3e-7;
    take_differences(
        forces, relative_step, [&](std::size_t input) { return largest_change(input); },
        [&](std::size_t input, double step) { solve(input, step, more_solutions); });
  }

 private:
  /// Solves the tractions of the strips a step along an input; `more` as in solve_heated_tractions().
  void solve(std::size_t input, double step, int more) {
    if (more > 0) std::copy_n(h_.share, s_.count, h_.rolling.heat_share);
    const double speed = go(input, step, h_.rolling.cold_friction);
    solve_heated_tractions(d_.problem.model, d_.problem.in, strips_, backwards_, speed, h_.rolling,
                           {h_.fx, h_.fy, h_.mz}, more);
  }

  bool backwards_;
};

/// Tractions of strips that remember: by one difference of the step along the change of the strips with each
/// input.
class RememberedDifferences : StripsAlongInput {
 public:
  RememberedDifferences(const Differentiation& d, const Number& rolling_speed, const Number& divisor)
      : StripsAlongInput(d, divisor, 7), rolling_speed_(rolling_speed), time_(d.problem.in.time) {
    if (d.by == JacobianBy::place) time_.d[frame_time] = 1.0;
  }

  /// Fills the forces and their derivatives.
  void differentiate(const DualForces& forces) {
    const ContactStrips& solved = d_.solved.strips;
    Number* const results_of[results] = {forces.fx, forces.fy, forces.mz};
    const double* const values[results] = {solved.fx, solved.fy, solved.mz};
    for (int r = 0; r < results; ++r)
      for (std::int32_t k = 0; k < s_.count; ++k) results_of[r][k] = values[r][k];

    // the time of the step is among the numbers that an input changes
    solve(0, 0.0);
    constexpr double relative_step = 3e-8, least_time = 1e-3;  // [-], [s]
    take_differences(
        forces, relative_step,
        [&](std::size_t input) {
          return larger(largest_change(input), magnitude(time_.d[input]) / larger(time_.value, least_time));
        },
        [&](std::size_t input, double step) { solve(input, step); });
  }

 private:
  /// Solves the rolling step of strips moved by a step along an input. Its strips go to a list that no other
  /// step uses.
  void solve(std::size_t input, double step) {
    const double divisor = go(input, step, h_.friction);
    solve_remembered_tractions(d_.problem, d_.solved.overlaps, strips_,
                               {rolling_speed_.value + step * rolling_speed_.d[input], divisor,
                                time_.value + step * time_.d[input], h_.written},
                               h_.remembering, {h_.fx, h_.fy, h_.mz});
  }

  const Number& rolling_speed_;
  Number time_;
};

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
    return RememberedDifferences(d, rolling_speed, reference.divisor).differentiate({s.fx, s.fy, s.mz});

  // friction first: tractions are bounded by it; heated, its share is found with them
  const tangential::FrictionLaw* const law = d.problem.in.law;
  if (law) differentiate_friction(d, reference.divisor);
  const auto roll_one_way = [&](bool backwards, const DualForces& forces) {
    if (law && law->heated()) return HeatedDifferences(d, reference.divisor, backwards).differentiate(forces);
    differentiate_tractions(d, backwards, forces);
  };
  const bool backwards = rolling_speed.value < 0.0;
  roll_one_way(backwards, {s.fx, s.fy, s.mz});

  // F = F_own + share (F_other - F_own), the share with its derivatives
  const Number& other = reference.reverse_share;
  if (!(other.value > 0.0)) return;
  roll_one_way(!backwards, {s.other_fx, s.other_fy, s.other_mz});
  for (std::int32_t k = 0; k < s.count; ++k) {
    s.fx[k] += other * (s.other_fx[k] - s.fx[k]);
    s.fy[k] += other * (s.other_fy[k] - s.fy[k]);
    s.mz[k] += other * (s.other_mz[k] - s.mz[k]);
  }
}

}  // namespace

void count_wrench_jacobian(Arena& arena, const WorkSizes& sizes) { cut(arena, sizes); }

Fault differentiate_wrench(const WheelProblem& problem, const WheelSolution& solved, JacobianBy by,
                           Arena arena, RailFrameJacobian& out) noexcept {
  out = {};
  // stages as of the solution: overlaps and pressures, slips, tractions, sums
  Scratch w = cut(arena, work_sizes(problem.model));
  const Differentiation d{problem, solved, by, w};
  const Fault fault = take_pressed_strips(d);
  if (fault.status != WRC_OK) return fault;
  const Number rolling_speed = differentiate_loaded_strips(d);
  const LoadedStrips& loaded = w.loaded;
  if (loaded.count == 0) return {};
  if (problem.in.friction > 0.0) differentiate_rolling(d, rolling_speed);

  // force and moment about the wheel's reference point, rail axes
  const bool graded = solved.overlaps.grade != nullptr;
  for (std::int32_t i = 0; i < loaded.count; ++i) {
    const std::int32_t k = loaded.pressed[i];
    add_force(frame_overlap(w.pressed.overlap[k]), loaded.centre[i], graded,
              {loaded.normal[i], loaded.fx[i], loaded.fy[i], loaded.mz[i]}, out.force, out.moment);
  }
  return {};
}

}  // namespace wrc::surface
