#include "surface/wheel_on_rail.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "base/number.hpp"
#include "geometry/creepages.hpp"
#include "surface/surface_model.hpp"

namespace wrc {
namespace {

constexpr std::int32_t most = most_overlapping_strips;

/// Prescribed loads are met to this part; the normal problem is solved that much finer for them.
constexpr double load_tolerance = 1e-8, tolerance_for_load = 1e-8;
constexpr std::int32_t most_load_steps = 30;

/// Overlaps are solved up to this deep [m]: several meganewtons, beyond any steel.
constexpr double deepest_overlap = 2e-3;

struct Work {
  Overlaps overlaps;
  OverlapScratch scratch;
  SurfacePressure pressure;
  double* normal;   ///< scratch of the normal problem
  double* rolling;  ///< scratch of rolling
  // over the strips in contact
  double *place, *width, *half_length, *peak, *curvature, *slip_x, *slip_y, *spin, *friction, *fx, *fy, *mz,
      *other_fx, *other_fy, *other_mz;
  std::int32_t* candidate;  ///< of a strip in contact
};

/// Cuts the workspace; returns the bytes it takes.
std::int64_t cut(void* memory, std::int32_t wheel_pieces, Work& w) {
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
  w.scratch.piece = integers(most_strips_of_a_rail);
  SurfacePressure& p = w.pressure;
  for (double** a : {&p.length_squared, &p.level, &p.centre, &p.strength}) *a = doubles(most);
  w.normal = doubles(surface_normal_doubles(most));
  w.rolling = doubles(static_cast<std::int64_t>(surface_rolling_workspace(most)));
  for (double** a : {&w.place, &w.width, &w.half_length, &w.peak, &w.curvature, &w.slip_x, &w.slip_y, &w.spin,
                     &w.friction, &w.fx, &w.fy, &w.mz, &w.other_fx, &w.other_fy, &w.other_mz})
    *a = doubles(most);
  w.candidate = integers(most);
  return (at - begin) * static_cast<std::int64_t>(sizeof(double));
}

/// The wheel as the rail sees it: rail axes, origin of its profile.
struct Seen {
  RelativePose pose;
  double velocity[3];          ///< of the wheel's reference point less that of rail material there
  double angular_velocity[3];  ///< of the wheel less that of the rail
  double cosine, sine;         ///< of the rail's roll
};

/// (x, y, z) of track axes turned into rail axes.
void into_rail(double cosine, double sine, const double (&v)[3], double (&turned)[3]) {
  turned[0] = v[0];
  turned[1] = cosine * v[1] + sine * v[2];
  turned[2] = cosine * v[2] - sine * v[1];
}

Seen see(const SurfaceModel& model, const WheelOnRail& in, double height) {
  Seen s;
  const SineCosine roll = sine_cosine(in.rail.roll);
  s.cosine = roll.cosine;
  s.sine = roll.sine;
  for (int k = 0; k < 3; ++k) {
    double turned[3];
    into_rail(s.cosine, s.sine, {in.wheel.rotation[0][k], in.wheel.rotation[1][k], in.wheel.rotation[2][k]},
              turned);
    for (int i = 0; i < 3; ++i) s.pose.rotation[i][k] = turned[i];
  }
  const double dy = in.wheel.position[1] - model.rail_origin_y - in.rail.y;
  const double dz = height - model.rail_origin_z - in.rail.z;
  s.pose.y = s.cosine * dy + s.sine * dz;
  s.pose.z = s.cosine * dz - s.sine * dy;
  // rail material moves with the rail, not along the track
  const double relative[3] = {in.wheel.velocity[0],
                              in.wheel.velocity[1] - in.rail.velocity_y + in.rail.velocity_roll * dz,
                              in.wheel.velocity[2] - in.rail.velocity_z - in.rail.velocity_roll * dy};
  into_rail(s.cosine, s.sine, relative, s.velocity);
  const double turning[3] = {in.wheel.angular_velocity[0] - in.rail.velocity_roll,
                             in.wheel.angular_velocity[1], in.wheel.angular_velocity[2]};
  into_rail(s.cosine, s.sine, turning, s.angular_velocity);
  return s;
}

/// Velocity of the wheel's point less the rail's, rail axes; r from the wheel's reference point.
void sliding_at(const Seen& s, double x, double y, double z, double (&v)[3]) {
  const auto& o = s.angular_velocity;
  v[0] = s.velocity[0] + o[1] * z - o[2] * y;
  v[1] = s.velocity[1] + o[2] * x - o[0] * z;
  v[2] = s.velocity[2] + o[0] * y - o[1] * x;
}

void add(const Seen& s, double x, double y, double z, double fx, double fy, double fz, double mz_y,
         double mz_z, double (&force)[3], double (&moment)[3]) {
  (void)s;
  force[0] += fx;
  force[1] += fy;
  force[2] += fz;
  moment[0] += y * fz - z * fy;
  moment[1] += z * fx - x * fz + mz_y;
  moment[2] += x * fy - y * fx + mz_z;
}

/// Back into track axes.
void into_track(const Seen& s, double (&v)[3]) {
  const double y = v[1], z = v[2];
  v[1] = s.cosine * y - s.sine * z;
  v[2] = s.sine * y + s.cosine * z;
}

/// The law's coefficient of each strip: over its width on the rail, at the root mean square of its rigid slip
/// times `speed` (tangential/friction/friction.hpp).
void find_friction(const SurfaceModel& model, const FrictionLaw& law, double speed, std::int32_t count,
                   Work& w) {
  for (std::int32_t k = 0; k < count; ++k) {
    const std::int32_t j = w.overlaps.strip[w.candidate[k]];
    const double half = 0.5 * model.rail.width[j] * magnitude(model.rail.ty[j]) + 1e-9;
    const double at_rest = law.zones.count > 0
                               ? mean_friction(law.zones, model.rail.y[j] - half, model.rail.y[j] + half)
                               : law.coefficient;
    const double turning = w.spin[k] * w.half_length[k];
    const double slip2 = w.slip_x[k] * w.slip_x[k] + w.slip_y[k] * w.slip_y[k] + turning * turning / 3.0;
    w.friction[k] = at_rest * friction_fall(law, speed * std::sqrt(slip2));
  }
}

/// Tractions of the strips in contact. Backwards is forwards seen in a mirror across the axle: x, and with it
/// slip along x and spin, change sign, and so do their forces.
void roll(const SurfaceModel& model, const WheelOnRail& in, std::int32_t count, bool backwards, Work& w,
          SurfaceRollingForces forces) {
  const auto mirror = [&](double* a) {
    for (std::int32_t k = 0; k < count; ++k) a[k] = -a[k];
  };
  SurfaceRollingInput rolls;
  rolls.count = count;
  rolls.place = w.place;
  rolls.width = w.width;
  rolls.half_length = w.half_length;
  rolls.peak = w.peak;
  rolls.curvature = w.curvature;
  rolls.slip_x = w.slip_x;
  rolls.slip_y = w.slip_y;
  rolls.spin = w.spin;
  rolls.friction = w.friction;
  rolls.normal_shear_modulus = model.material.shear_modulus;
  rolls.shear_modulus = model.material.shear_modulus * in.slope_reduction;
  rolls.coefficients = &model.coefficients;
  rolls.grid = model.grid;
  if (backwards) {
    mirror(w.slip_x);
    mirror(w.spin);
  }
  roll_on_surface(rolls, w.rolling, {}, forces);
  if (backwards)
    for (double* a : {w.slip_x, w.spin, forces.fx, forces.mz}) mirror(a);
}

/// Solves at a height; the wrench is complete but for `height` and the sums over earlier sweeps. `found`: the
/// overlaps at this height stand in w.overlaps already.
Fault solve_at(const SurfaceModel& model, const WheelOnRail& in, double height, bool found, Work& w,
               SurfaceStart& start, const SurfaceNormalOptions& options, Wrench& out) {
  Fault fault;
  const std::int32_t sweeps_before = out.sweeps;
  out = {};
  out.sweeps = sweeps_before;
  out.height = height;
  const Seen seen = see(model, in, height);
  Overlaps& o = w.overlaps;
  if (!found) find_overlaps(*model.kernels, model.rail, model.wheel, seen.pose, 0.0, w.scratch, o);
  const SurfaceNormalResult normal =
      solve_surface_normal(model.rail, o, *model.influence, *model.kernels,
                           model.material.normal_compliance(), options, w.normal, start, w.pressure);
  out.sweeps += normal.sweeps;
  if (!normal.converged)
    fault = {.status = WRC_FLAG_ITERATION_CAP, .field = "sweeps", .value = 1.0 * normal.sweeps};

  // strips in contact, damped
  std::int32_t count = 0;
  const SurfacePressure& p = w.pressure;
  double load = 0.0, sliding = 0.0;
  for (std::int32_t i = 0; i < o.count; ++i) {
    if (!(p.length_squared[i] > 0.0 && p.strength[i] > 0.0)) continue;
    const std::int32_t j = o.strip[i];
    const double l = std::sqrt(p.length_squared[i]);
    double v[3];
    sliding_at(seen, p.centre[i], o.wy[i], o.wz[i], v);
    const double approach_velocity = v[1] * o.ny[i] + v[2] * o.nz[i];
    const double damped = std::max(0.0, 1.0 + 1.5 * in.damping * approach_velocity);
    const double peak = damped * p.strength[i] / l, N = 0.5 * pi * model.rail.width[j] * l * peak;
    if (!(N > 0.0)) continue;  // a region damped to nothing would have no middle
    const std::int32_t k = count++;
    w.candidate[k] = i;
    w.place[k] = model.rail.s[j];
    w.width[k] = model.rail.width[j];
    w.half_length[k] = l;
    w.peak[k] = peak;
    w.curvature[k] = o.curvature[i];
    w.slip_x[k] = v[0];
    w.slip_y[k] = v[1] * o.nz[i] - v[2] * o.ny[i];
    w.spin[k] = seen.angular_velocity[1] * o.ny[i] + seen.angular_velocity[2] * o.nz[i];
    w.friction[k] = in.friction;
    w.fx[k] = w.fy[k] = w.mz[k] = 0.0;
    load += N;
    sliding += N * v[0];
  }
  if (count == 0) {
    return {.status = WRC_FLAG_NO_CONTACT};  // whatever the sweeps came to: there is no force
  }
  // the mean of the speeds at which wheel and rail material pass through the contact
  const double rolling_speed = seen.velocity[0] - 0.5 * sliding / load;
  const RollingReference reference = rolling_reference(rolling_speed);
  const double speed = reference.divisor;
  for (std::int32_t k = 0; k < count; ++k) {
    w.slip_x[k] /= speed;
    w.slip_y[k] /= speed;
    w.spin[k] /= speed;
  }
  if (in.friction > 0.0) {
    if (in.law) find_friction(model, *in.law, speed, count, w);
    const bool backwards = rolling_speed < 0.0;
    roll(model, in, count, backwards, w, {w.fx, w.fy, w.mz});
    if (reference.other_way > 0.0) {
      roll(model, in, count, !backwards, w, {w.other_fx, w.other_fy, w.other_mz});
      const double other = reference.other_way;
      for (std::int32_t k = 0; k < count; ++k) {
        w.fx[k] += other * (w.other_fx[k] - w.fx[k]);
        w.fy[k] += other * (w.other_fy[k] - w.fy[k]);
        w.mz[k] += other * (w.other_mz[k] - w.mz[k]);
      }
    }
  }

  // sums, strip by strip, and region by region: strips side by side
  SurfaceRegion* region = nullptr;
  double region_n[2] = {}, region_weight = 0.0;
  const auto close = [&] {
    if (!region) return;
    SurfaceRegion& r = *region;
    for (double& c : r.point) c /= region_weight;
    for (double& c : r.creepage) c /= region_weight;
    r.normal_force = std::sqrt(region_n[0] * region_n[0] + region_n[1] * region_n[1]);
    double direction[3] = {0.0, region_n[0], region_n[1]};
    into_track(seen, direction);
    r.angle = 2.0 * arctangent(-direction[1] / (direction[2] + r.normal_force + 1e-300));
    out.normal_force += r.normal_force;
    for (int c = 0; c < 3; ++c) {
      out.force[c] += r.force[c];
      out.moment[c] += r.moment[c];
    }
    // moments about the point
    r.moment[0] -= r.point[1] * r.force[2] - r.point[2] * r.force[1];
    r.moment[1] -= r.point[2] * r.force[0] - r.point[0] * r.force[2];
    r.moment[2] -= r.point[0] * r.force[1] - r.point[1] * r.force[0];
    into_track(seen, r.force);
    into_track(seen, r.moment);
    into_track(seen, r.point);
    r.point[0] += in.wheel.position[0];
    r.point[1] += in.wheel.position[1];
    r.point[2] += height;
    region = nullptr;
  };
  std::int32_t last_strip = -2;
  for (std::int32_t k = 0; k < count; ++k) {
    const std::int32_t i = w.candidate[k], j = o.strip[i];
    if (j != last_strip + 1) {
      close();
      if (out.regions < most_surface_regions) {
        region = &out.region[out.regions++];
        *region = {};
        region->first = j;
        region_n[0] = region_n[1] = region_weight = 0.0;
      } else {
        region = &out.region[most_surface_regions - 1];  // beyond what is listed: counted with the last
        keep_worst(fault, {.status = WRC_FLAG_MORE_PATCHES});
      }
    }
    last_strip = j;
    SurfaceRegion& r = *region;
    r.count = j + 1 - r.first;
    const double l = w.half_length[k], N = 0.5 * pi * w.width[k] * l * w.peak[k];
    const double ny = o.ny[i], nz = o.nz[i];
    const double fy = w.fy[k] * nz - N * ny, fz = -w.fy[k] * ny - N * nz;
    add(seen, p.centre[i], o.wy[i], o.wz[i], w.fx[k], fy, fz, w.mz[k] * ny, w.mz[k] * nz, r.force, r.moment);
    region_n[0] += N * ny;
    region_n[1] += N * nz;
    region_weight += N;
    r.point[0] += N * p.centre[i];
    r.point[1] += N * o.wy[i];
    r.point[2] += N * o.wz[i];
    r.creepage[0] += N * w.slip_x[k];
    r.creepage[1] += N * w.slip_y[k];
    r.creepage[2] += N * w.spin[k];
    const double area = 2.0 * l * w.width[k];
    r.area += area;
    out.area += area;
    r.peak_pressure = std::max(r.peak_pressure, w.peak[k]);
    out.peak_pressure = std::max(out.peak_pressure, w.peak[k]);
    const double power = -speed * (w.fx[k] * w.slip_x[k] + w.fy[k] * w.slip_y[k] + w.mz[k] * w.spin[k]);
    r.power += power;
    out.power += power;
  }
  close();
  into_track(seen, out.force);
  into_track(seen, out.moment);
  return fault;
}

/// The greatest height, no greater than that asked for, at which no overlap is deeper than `deepest_overlap`
/// [m]. Leaves the overlaps at the height asked for where that is the one.
double height_at_border(const SurfaceModel& model, const WheelOnRail& in, Work& w) {
  double height = in.wheel.position[2];
  constexpr int most_steps = 12;
  for (int n = 0; n < most_steps; ++n) {
    const Seen seen = see(model, in, height);
    Overlaps& o = w.overlaps;
    find_overlaps(*model.kernels, model.rail, model.wheel, seen.pose, 0.0, w.scratch, o);
    double rise = 0.0;
    for (std::int32_t i = 0; i < o.count; ++i) {
      const double down = larger(seen.cosine * o.nz[i] + seen.sine * o.ny[i], 0.1);
      rise = larger(rise, (o.depth[i] - deepest_overlap) / down);
    }
    height -= rise;
    if (rise < 1e-12) break;
  }
  return height;
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

}  // namespace

std::int64_t surface_workspace_bytes(std::int32_t wheel_nodes) {
  Work w;
  alignas(64) static double nothing[1];
  return cut(nothing, most_curve_pieces(wheel_nodes), w);
}

Fault solve_wheel_on_rail(const SurfaceModel& model, const WheelOnRail& in, bool warm, SurfaceState& state,
                          void* workspace, Wrench& out) noexcept {
  Work w;
  cut(workspace, model.wheel.curve.pieces, w);
  SurfaceStart start{state.length_squared, state.shift, warm && state.set > 0.0};
  out = {};
  Fault fault;
  if (!in.load_prescribed) {
    const double asked = in.wheel.position[2], border = height_at_border(model, in, w);
    if (asked > border) {
      // Beyond, the load goes on with the stiffness it had, in the directions it had.
      constexpr double step = 2e-6;  // [m]
      solve_at(model, in, border - step, false, w, start, {}, out);
      const double before = out.normal_force;
      fault = solve_at(model, in, border, false, w, start, {}, out);
      if (out.normal_force > 0.0) {
        const double stiffness = larger(out.normal_force - before, 0.0) / step;
        scale(1.0 + stiffness * (asked - border) / out.normal_force, out);
      }
      out.height = asked;
      keep_worst(fault, {.status = WRC_FLAG_BEYOND_GAP,
                         .field = "overlap",
                         .value = deepest_overlap + asked - border,
                         .unit = "m",
                         .high = deepest_overlap,
                         .cause = "did you pass millimetres?"});
    } else {
      fault = solve_at(model, in, asked, asked == border, w, start, {}, out);
    }
    state.height = in.wheel.position[2];
    state.set = start.set ? 1.0 : 0.0;
    return fault;
  }

  // The load: heights between one that carries too little and one that carries too much, by secants of the
  // load's power 2/3, which is nearly straight.
  const double asked = in.vertical_load;
  const auto shape = [](double load) {
    return load > 0.0 ? natural_exp(natural_log(load) * (2.0 / 3.0)) : 0.0;
  };
  const double target = shape(asked);
  double low = -1.0, high = 1.0, low_value = 0.0,
         high_value = 0.0;  // [m], of the height less the first guess
  bool has_low = false, has_high = false;
  double base = in.wheel.position[2];
  double z = warm && state.set > 0.0 ? state.height : base;
  if (!(warm && state.set > 0.0)) {
    // the wheel is lowered, or raised, until it touches
    constexpr double margin = 50e-3;
    for (int n = 0; n < 12; ++n) {
      const Seen seen = see(model, in, z);
      Overlaps& o = w.overlaps;
      find_overlaps(*model.kernels, model.rail, model.wheel, seen.pose, margin, w.scratch, o);
      double fall = margin;
      for (std::int32_t i = 0; i < o.count; ++i) {
        const double down = seen.cosine * o.nz[i] + seen.sine * o.ny[i];
        if (down > 0.2) fall = std::min(fall, -o.depth[i] / down);
      }
      z += fall;
      if (std::abs(fall) < 1e-7) break;
    }
    z += 60e-6;
  }
  const SurfaceNormalOptions options{.tolerance = tolerance_for_load};
  bool met = false;
  for (std::int32_t step = 0; step < most_load_steps; ++step) {
    Fault here = solve_at(model, in, z, false, w, start, options, out);
    const double load = -out.force[2];
    fault = here.status == WRC_FLAG_NO_CONTACT ? Fault{} : here;
    if (std::abs(load - asked) <= load_tolerance * asked) {
      met = true;
      break;
    }
    const double value = shape(load) - target;
    if (value < 0.0) {
      low = z;
      low_value = value;
      has_low = true;
    } else {
      high = z;
      high_value = value;
      has_high = true;
    }
    double next;
    if (has_low && has_high) {
      next = low - low_value * (high - low) / (high_value - low_value);
      const double inside = 1e-3 * (high - low);
      if (step % 6 == 5) next = 0.5 * (low + high);
      next = smaller(larger(next, smaller(low, high) + inside), larger(low, high) - inside);
      if (std::abs(high - low) < 1e-16) break;
    } else {
      // one side only: by the slope of a sphere, F ~ depth^(3/2), with twice the step
      const double depth_step = 20e-6 * static_cast<double>(1 << std::min(step, 12));
      next = has_low ? z + depth_step : z - depth_step;
    }
    z = next;
  }
  if (!met)
    keep_worst(fault,
               {.status = WRC_FLAG_ITERATION_CAP, .field = "vertical_load", .value = asked, .unit = "N"});
  state.height = z;
  state.set = start.set ? 1.0 : 0.0;
  return fault;
}

}  // namespace wrc
