#include "surface/wrench/wrench_slopes.hpp"

#include <algorithm>
#include <cmath>

#include "base/cutter.hpp"
#include "base/number.hpp"
#include "geometry/creepages.hpp"
#include "kernels/kernels.hpp"
#include "surface/geometry/along_track.hpp"
#include "surface/pressure/pressure_jacobian.hpp"
#include "surface/rolling/strip_numbers.hpp"
#include "surface/surface_model.hpp"
#include "surface/wrench/wheel_work.hpp"
#include "surface/wrench/wrench_at_height.hpp"
#include "tangential/simd/tasks.hpp"

namespace wrc {
namespace {

using Number = SeenDual;

Number seen_number(const PlaceDual& a) {
  Number n = a.value;
  for (std::size_t k = 0; k < place_inputs; ++k) n.d[k] = a.d[k];
  return n;
}

/// Numbers of the strips that carry load; one element per strip.
struct LoadedStrips {
  std::int32_t count = 0;
  Number friction_factor = 1.0;  ///< on the friction of all
  std::int32_t* pressed;         ///< number among the strips in contact
  double *place, *width;
  Number *normal, *half_length, *peak, *curvature, *slip_x, *slip_y, *spin, *friction;
  Number *fx, *fy, *mz, *other_fx, *other_fy, *other_mz;
};

struct Scratch {
  PressedStrips pressed;
  double* normal;
  // over the memory of that, which is done with by then:
  LoadedStrips loaded;
  Number* numbers;  ///< of strip_numbers.hpp
  double* values;   ///< for the kernel: its numbers without derivatives
  double* slopes;   ///< from the kernel
};

constexpr std::int64_t kernel_numbers = 2 + simd::strip_inputs + 3;  // size, bound and results

std::int64_t cut(double* memory, std::int32_t most, Scratch& w) {
  Cutter take{memory};
  const auto numbers = [&]<class Each>(Each*& array, std::int64_t each) {
    static_assert(sizeof(Each) % sizeof(double) == 0);
    array =
        reinterpret_cast<Each*>(take(most * each * static_cast<std::int64_t>(sizeof(Each) / sizeof(double))));
  };
  PressedStrips& p = w.pressed;
  for (double** a : {&p.place, &p.width, &p.line_load, &p.length_squared, &p.centre}) *a = take(most);
  for (PlaceDual** a : {&p.line_load_dual, &p.length_squared_dual, &p.centre_dual}) numbers(*a, 1);
  numbers(p.overlap, 1);
  double* const shared = take.at;
  w.normal = take(pressure_jacobian_doubles(most));
  double* const end = take.at;
  take.at = shared;
  LoadedStrips& s = w.loaded;
  s.pressed = reinterpret_cast<std::int32_t*>(take((most + 1) / 2));
  s.place = take(most);
  s.width = take(most);
  for (Number** a : {&s.normal, &s.half_length, &s.peak, &s.curvature, &s.slip_x, &s.slip_y, &s.spin,
                     &s.friction, &s.fx, &s.fy, &s.mz, &s.other_fx, &s.other_fy, &s.other_mz})
    numbers(*a, 1);
  w.numbers = reinterpret_cast<Number*>(take(rolling_doubles<Number>(most)));
  w.values = take(most * kernel_numbers);
  w.slopes = take(most * 3 * simd::strip_inputs);
  return std::max(take.at, end) - memory;
}

/// Where a strip that carries load lies on the wheel's profile [m].
Number y_on_wheel(const Scratch& w, std::int32_t k) {
  return seen_number(w.pressed.overlap[w.loaded.pressed[k]].y_wheel);
}

/// Coefficients of the law at the strips' sliding speeds: find_friction() of wheel_on_rail.cpp.
void find_friction(const SurfaceModel& model, const WheelOnRail& in, const Number& speed,
                   const WheelWork& work, const Scratch& w) {
  const FrictionLaw& law = *in.law;
  const LoadedStrips& s = w.loaded;
  for (std::int32_t k = 0; k < s.count; ++k) {
    const auto at_rest = friction_at_rest(model, in, work, work.overlaps.strip[work.candidate[k]]);
    const Number turning = s.spin[k] * s.half_length[k];
    const Number slip2 = s.slip_x[k] * s.slip_x[k] + s.slip_y[k] * s.slip_y[k] + turning * turning / 3.0;
    const Number sliding = speed * root(slip2);
    const double falls = speed_factor(law, sliding.value);
    s.friction[k] =
        s.friction_factor * (at_rest.value * sliding.chain(falls, speed_factor_slope(law, sliding.value)));
    if (in.zones_on_wheel) s.friction[k] += y_on_wheel(w, k).chain(0.0, at_rest.by_wheel_y * falls);
  }
}

/// Tractions of the strips: from what the kernel is told and how its results change with each number of that.
void roll(const SurfaceModel& model, const WheelOnRail& in, bool backwards, const Scratch& w, Number* fx,
          Number* fy, Number* mz) {
  const LoadedStrips& s = w.loaded;
  const std::int32_t n = s.count;
  const auto mirror = [n](Number* a) {
    for (std::int32_t k = 0; k < n; ++k) a[k] = -a[k];
  };
  const auto rolls = rolling_input<Number>(model, in, n, s);
  if (backwards) {
    mirror(s.slip_x);
    mirror(s.spin);
  }
  Arena scratch(w.numbers);
  const RollingArraysOf<Number> a = cut_rolling_arrays<Number>(scratch, n);
  using Each = strip_numbers::OneStrip<Number>;
  const strip_numbers::Shared shared = strip_numbers::shared(rolls);
  strip_numbers::link<Each>(rolls, a);
  strip_numbers::linear_theory<Each>(rolls, shared, a);
  strip_numbers::fill_arrays<Each>(rolls, shared, a);

  // What the kernel is told, by SurfaceStripInput: but for the spin, which it multiplies by the half length.
  const Number* const told[simd::strip_inputs] = {a.growth_x, a.growth_y, a.curvature, a.slip_x, a.slip_y,
                                                  s.spin,     a.elastic,  a.turn_x,    a.turn_y};
  double* value = w.values;
  const auto values_of = [&](const Number* numbers) {
    double* const values = value;
    for (std::int32_t k = 0; k < n; ++k) values[k] = numbers[k].value;
    value += n;
    return values;
  };
  const auto room = [&] {
    double* const here = value;
    value += n;
    return here;
  };
  simd::SurfaceStripsSlopesTask task{};
  task.strips = n;
  task.cells = model.grid->cells;
  task.shape = &model.grid->elliptic;
  task.inverse_weight = model.grid->inverse_weight;
  task.width = s.width;
  task.half_length = values_of(s.half_length);
  task.bound = values_of(a.bound);
  task.growth_x = values_of(told[simd::strip_growth_x]);
  task.growth_y = values_of(told[simd::strip_growth_y]);
  task.curvature = values_of(told[simd::strip_curvature]);
  task.slip_x = values_of(told[simd::strip_slip_x]);
  task.slip_y = values_of(told[simd::strip_slip_y]);
  task.spin = values_of(told[simd::strip_spin]);
  task.elastic = values_of(told[simd::strip_elastic]);
  task.turn_x = values_of(told[simd::strip_turn_x]);
  task.turn_y = values_of(told[simd::strip_turn_y]);
  task.fx = room();
  task.fy = room();
  task.mz = room();
  task.slopes = w.slopes;
  model.grid->kernels->tangential.surface_strips_slopes(task);

  for (std::int32_t k = 0; k < n; ++k) {
    const double found[3] = {task.fx[k], task.fy[k], task.mz[k]};
    Number* const forces[3] = {&fx[k], &fy[k], &mz[k]};
    const Number turned = s.spin[k] * s.half_length[k];
    // Forces go with bound and half length, the moment with its square.
    const double per_bound = a.bound[k].value > 0.0 ? 1.0 / a.bound[k].value : 0.0;
    const double per_length = 1.0 / s.half_length[k].value;
    for (int r = 0; r < 3; ++r) {
      Number& f = *forces[r];
      f = found[r];
      const auto add = [&](double slope, const Number& x) {
        pairwise::add<seen_inputs>(slope, x.d.data(), f.d.data());
      };
      add(found[r] * per_bound, a.bound[k]);
      add((r == 2 ? 2.0 : 1.0) * found[r] * per_length, s.half_length[k]);
      for (std::int32_t input = 0; input < simd::strip_inputs; ++input)
        add(w.slopes[(3 * input + r) * n + k], input == simd::strip_spin ? turned : told[input][k]);
    }
  }
  if (backwards)
    for (Number* numbers : {s.slip_x, s.spin, fx, mz}) mirror(numbers);
}

/// Tractions under friction over temperature, at a speed: by one difference of their solution along what each
/// input changes of the strips. The arrays of the solved strips serve as work space.
void difference_heated(const SurfaceModel& model, const WheelOnRail& in, const WheelWork& solved,
                       const Number& speed, bool backwards, const Scratch& w, Number* fx, Number* fy,
                       Number* mz) {
  const LoadedStrips& s = w.loaded;
  constexpr double relative_step = 3e-7, least_slip = 1e-4;
  WheelWork work = solved;
  const Number* const from[] = {s.half_length, s.peak, s.curvature, s.slip_x, s.slip_y, s.spin};
  double* const to[] = {work.half_length, work.peak, work.curvature, work.slip_x, work.slip_y, work.spin};
  Number* const forces[] = {fx, fy, mz};
  const double* const found[] = {work.fx, work.fy, work.mz};
  constexpr int more_solutions = 3;  // from friction found
  constexpr int numbers = 6, results = 3, lengths = 0, slips = 3, spins = 5;
  double size[numbers] = {};
  for (int a = 0; a < numbers; ++a)
    for (std::int32_t k = 0; k < s.count; ++k) size[a] = larger(size[a], magnitude(from[a][k].value));
  const double slip =
      larger(larger(size[slips], size[slips + 1]), larger(size[spins] * size[lengths], least_slip));
  size[slips] = size[slips + 1] = slip;
  size[spins] = slip / size[lengths];
  double share[most_differentiated_strips];
  const auto solve = [&](std::size_t input, double step, int again) {
    if (again > 0) std::copy_n(share, s.count, work.heat_share);
    for (std::int32_t k = 0; k < s.count; ++k)
      for (int a = 0; a < numbers; ++a) to[a][k] = from[a][k].value + step * from[a][k].d[input];
    const double slips_over = speed.value + step * speed.d[input];
    for (std::int32_t k = 0; k < s.count; ++k) {
      to[lengths][k] = larger(to[lengths][k], 0.0);
      const auto cold = friction_at_rest(model, in, work, work.overlaps.strip[work.candidate[k]]);
      work.cold_friction[k] = cold.value;
      if (in.zones_on_wheel)
        work.cold_friction[k] = larger(cold.value + step * cold.by_wheel_y * y_on_wheel(w, k).d[input], 0.0);
      work.cold_friction[k] *=
          strip_speed_factor(*in.law, work, k, slips_over) * (1.0 + step * s.friction_factor.d[input]);
    }
    roll_heated(model, in, s.count, backwards, slips_over, work, {work.fx, work.fy, work.mz}, again);
  };
  solve(0, 0.0, 0);
  for (int r = 0; r < results; ++r)
    for (std::int32_t k = 0; k < s.count; ++k) forces[r][k] = found[r][k];
  std::copy_n(work.heat_share, s.count, share);
  double base[results][most_differentiated_strips];
  solve(0, 0.0, more_solutions);
  for (int r = 0; r < results; ++r) std::copy_n(found[r], s.count, base[r]);
  for (std::size_t input = 0; input < seen_inputs; ++input) {
    double change = larger(magnitude(speed.d[input]) / speed.value, magnitude(s.friction_factor.d[input]));
    for (int a = 0; a < numbers; ++a)
      for (std::int32_t k = 0; k < s.count; ++k)
        change = larger(change, magnitude(from[a][k].d[input]) / size[a]);
    if (!(change > 0.0)) continue;
    const double step = relative_step / change;
    solve(input, step, more_solutions);
    for (int r = 0; r < results; ++r)
      for (std::int32_t k = 0; k < s.count; ++k) forces[r][k].d[input] = (found[r][k] - base[r][k]) / step;
  }
}

/// Makes slips of the strips' velocities and finds their tractions: roll_strips() of wheel_on_rail.cpp.
void roll_strips(const SurfaceModel& model, const WheelOnRail& in, const WheelWork& work,
                 const Number& rolling_speed, const Scratch& w) {
  const LoadedStrips& s = w.loaded;
  const RollingReferenceOf<Number> reference = rolling_reference(rolling_speed);
  const Number per_speed = Number(1.0) / reference.divisor;
  for (std::int32_t k = 0; k < s.count; ++k)
    for (Number* const slip : {s.slip_x, s.slip_y, s.spin}) slip[k] = slip[k] * per_speed;
  if (in.law) find_friction(model, in, reference.divisor, work, w);
  const bool heated = in.law && in.law->heated();
  const auto roll_one_way = [&](bool backwards, Number* fx, Number* fy, Number* mz) {
    if (heated) {
      difference_heated(model, in, work, reference.divisor, backwards, w, fx, fy, mz);
    } else {
      roll(model, in, backwards, w, fx, fy, mz);
    }
  };
  const bool backwards = rolling_speed.value < 0.0;
  roll_one_way(backwards, s.fx, s.fy, s.mz);
  const Number& other = reference.reverse_share;
  if (!(other.value > 0.0)) return;
  roll_one_way(!backwards, s.other_fx, s.other_fy, s.other_mz);
  for (std::int32_t k = 0; k < s.count; ++k) {
    s.fx[k] += other * (s.other_fx[k] - s.fx[k]);
    s.fy[k] += other * (s.other_fy[k] - s.fy[k]);
    s.mz[k] += other * (s.other_mz[k] - s.mz[k]);
  }
}

RelativePoseOf<PlaceDual> resting_pose(const RelativePose& pose) {
  RelativePoseOf<PlaceDual> resting;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) resting.rotation[i][k] = pose.rotation[i][k];
  resting.y = pose.y;
  resting.z = pose.z;
  return resting;
}

/// A strip's overlap with what the track and the wheel's shape add: find() of wheel_on_rail.cpp.
OverlapSlopes strip_overlap(const SurfaceModel& model, const WheelOnRail& in, const WheelWork& work,
                            SlopesBy by, const RelativePoseOf<PlaceDual>& pose,
                            const OutlineAttitudeOf<PlaceDual>& attitude, std::int32_t j) {
  const RailStrips& rail = work.rail;
  StripPlace place{rail.y[j], rail.z[j], rail.ty[j], rail.tz[j]};
  if (!varies(model)) return overlap_slopes(place, model.wheel, pose, attitude, work.scratch, j);
  PlaceDual distance = work.distance, angle = in.angle;
  if (by == SlopesBy::track) {
    if (work.distance == in.distance) distance.d[track_distance] = 1.0;
    angle.d[track_angle] = 1.0;
  }
  if (model.varying.faces > 0 && by == SlopesBy::track) {
    const SectionBlend& blend = work.blend[face_of(model.varying, j)];
    const auto moved = strip_at(model.varying, blend, j, distance);
    place.y = moved.y;
    place.z = moved.z;
    tangent_at(model.varying, blend, j, distance, place.ty, place.tz);
  }
  OverlapSlopes s = overlap_slopes(place, model.wheel, pose, attitude, work.scratch, j);
  StripOverlap<PlaceDual> o{s.depth, s.centre, s.curvature, s.ny, s.nz, s.wy, s.wz, 0.0};
  if (model.varying.faces > 0) follow_rail(model.varying, j, distance, work.blend, o);
  if (model.roller_curvature != 0.0) follow_roller(model.roller_curvature, rail.z[j], distance, o);
  if (model.out_of_round.rows > 0) follow_wheel(model.out_of_round, pose, s.y_wheel, angle, o);
  s.depth = o.depth;
  s.centre = o.centre;
  s.curvature = o.curvature;
  s.ny = o.ny;
  s.nz = o.nz;
  s.wy = o.wy;
  s.wz = o.wz;
  s.lean = o.lean;
  return s;
}

}  // namespace

std::int64_t wrench_slopes_doubles(std::int32_t most) {
  Scratch w;
  double nothing = 0.0;
  return cut(&nothing, most, w);
}

Fault differentiate_wrench(const SurfaceModel& model, const WheelOnRail& in, const WheelWork& work,
                           SlopesBy by, RailFrameJacobian& out) noexcept {
  out = {};
  const RelativeMotion& seen = work.seen;
  Scratch w;
  cut(work.slopes, most_differentiated_strips, w);
  const Overlaps& o = work.overlaps;
  const StripPressure& p = work.pressure;
  PressedStrips& s = w.pressed;
  s.count = 0;
  const RelativePoseOf<PlaceDual> pose =
      by == SlopesBy::place ? moving_pose(seen.pose) : resting_pose(seen.pose);
  const OutlineAttitudeOf<PlaceDual> attitude = attitude_of(pose);
  for (std::int32_t i = 0; i < o.count; ++i) {
    if (!(p.length_squared[i] > 0.0 && p.line_load[i] > 0.0)) continue;
    if (s.count == most_differentiated_strips) {
      return Fault::more_patches("strips in contact",
                                 {1.0 + most_differentiated_strips, "", 0.0, most_differentiated_strips},
                                 "there is no room for the derivatives of so many");
    }
    const std::int32_t k = s.count++, j = o.strip[i];
    s.place[k] = work.rail.s[j];
    s.width[k] = work.rail.width[j];
    s.line_load[k] = p.line_load[i];
    s.length_squared[k] = p.length_squared[i];
    s.centre[k] = p.centre[i];
    s.overlap[k] = strip_overlap(model, in, work, by, pose, attitude, j);
  }
  differentiate_pressures(pressure_model(model), w.normal, s);

  Number velocity[3], turning[3];
  for (std::size_t i = 0; i < 3; ++i) {
    velocity[i] = seen.velocity[i];
    turning[i] = seen.angular_velocity[i];
    if (by == SlopesBy::track) continue;
    velocity[i].d[seen_velocity + i] = 1.0;
    turning[i].d[seen_turning + i] = 1.0;
  }
  const bool on_roller = model.roller_curvature != 0.0;
  Number roller = seen.rail_turning;
  if (by == SlopesBy::track) velocity[2].d[track_distance] = seen.rail_turning;
  if (by == SlopesBy::place) roller.d[seen_roller] = 1.0;
  LoadedStrips& loaded = w.loaded;
  loaded.count = 0;
  loaded.friction_factor = 1.0;
  if (by == SlopesBy::place) loaded.friction_factor.d[seen_friction] = 1.0;
  Number load = 0.0, sliding = 0.0, below = 0.0;
  for (std::int32_t k = 0; k < s.count; ++k) {
    const OverlapSlopes& overlap = s.overlap[k];
    const Number x = seen_number(s.centre_dual[k]), y = seen_number(overlap.wy), z = seen_number(overlap.wz),
                 ny = seen_number(overlap.ny), nz = seen_number(overlap.nz);
    Number vx = velocity[0] + turning[1] * z - turning[2] * y;
    if (on_roller) vx += roller * (seen_number(overlap.depth) * nz);
    const Number vy = velocity[1] + turning[2] * x - turning[0] * z;
    const Number vz = velocity[2] + turning[0] * y - turning[1] * x;
    Number approach = vy * ny + vz * nz;
    if (work.overlaps.lean) {
      const Number lean = seen_number(overlap.lean), along = vx + lean * approach;
      approach = approach - lean * vx;
      vx = along;
    }
    const Number damped = larger(Number(0.0), 1.0 + 1.5 * in.damping * approach);
    const Number strength = damped * seen_number(s.line_load_dual[k]);
    const Number N = (0.5 * pi * s.width[k]) * strength;
    if (!(N.value > 0.0)) continue;
    const std::int32_t i = loaded.count++;
    loaded.pressed[i] = k;
    loaded.place[i] = s.place[k];
    loaded.width[i] = s.width[k];
    loaded.normal[i] = N;
    loaded.half_length[i] = root(seen_number(s.length_squared_dual[k]));
    loaded.peak[i] = strength / loaded.half_length[i];
    loaded.curvature[i] = damped * seen_number(overlap.curvature);  // as in wrench_at_height.cpp
    loaded.slip_x[i] = vx;
    loaded.slip_y[i] = vy * nz - vz * ny;
    loaded.spin[i] = turning[1] * ny + turning[2] * nz;
    loaded.friction[i] = in.friction * loaded.friction_factor;
    loaded.fx[i] = loaded.fy[i] = loaded.mz[i] = 0.0;
    load += N;
    sliding += N * vx;
    below += N * z;
  }
  if (loaded.count == 0) return {};
  if (in.friction > 0.0) {
    Number rolling_speed = velocity[0] - 0.5 * (sliding / load);
    if (on_roller) rolling_speed = rolling_speed - roller * (below / load);
    roll_strips(model, in, work, rolling_speed, w);
  }

  for (std::int32_t i = 0; i < loaded.count; ++i) {
    const std::int32_t k = loaded.pressed[i];
    const OverlapSlopes& overlap = s.overlap[k];
    const Number x = seen_number(s.centre_dual[k]), y = seen_number(overlap.wy), z = seen_number(overlap.wz),
                 ny = seen_number(overlap.ny), nz = seen_number(overlap.nz);
    const Number &N = loaded.normal[i], &mz = loaded.mz[i];
    Number fx = loaded.fx[i], fy = loaded.fy[i] * nz - N * ny, fz = -(loaded.fy[i] * ny) - N * nz;
    if (work.overlaps.lean) {
      const Number lean = seen_number(overlap.lean);
      fy += lean * fx * ny;
      fz += lean * fx * nz;
      fx += lean * N;
    }
    out.force[0] += fx;
    out.force[1] += fy;
    out.force[2] += fz;
    out.moment[0] += y * fz - z * fy;
    out.moment[1] += z * fx - x * fz + mz * ny;
    out.moment[2] += x * fy - y * fx + mz * nz;
  }
  return {};
}

}  // namespace wrc
