#include "surface/wrench/wrench_at_height.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "base/number.hpp"
#include "geometry/creepages.hpp"
#include "normal/damping.hpp"
#include "surface/geometry/along_track.hpp"
#include "surface/wrench/wrench_sum.hpp"

namespace wrc {

namespace {

/// Overlaps are solved up to this deep [m]: several meganewtons, beyond any steel.
constexpr double deepest_overlap = 2e-3;

/// (x, y, z) of track axes turned into rail axes.
void into_rail(double cosine, double sine, const double (&v)[3], double (&turned)[3]) {
  turned[0] = v[0];
  turned[1] = cosine * v[1] + sine * v[2];
  turned[2] = cosine * v[2] - sine * v[1];
}

/// What a rail that changes along the track and a wheel that is not round add to the overlaps; those within
/// the margin are kept.
void follow_track(const SurfaceModel& model, const WheelOnRail& in, const RelativeMotion& seen, double margin,
                  WheelWork& w) {
  Overlaps& o = w.overlaps;
  const Curve& profile = model.wheel.curve;
  std::int32_t kept = 0;
  for (std::int32_t i = 0; i < o.count; ++i) {
    const std::int32_t j = o.strip[i];
    StripOverlap<double> s{o.depth[i], o.centre[i], o.curvature[i], o.ny[i], o.nz[i], o.wy[i], o.wz[i], 0.0};
    if (model.varying.faces > 0) follow_rail(model.varying, j, w.distance, w.blend, s);
    if (model.roller_curvature != 0.0) follow_roller(model.roller_curvature, w.rail.z[j], w.distance, s);
    if (model.out_of_round.rows > 0) {
      const double y = evaluate(profile, w.scratch.piece[j], w.scratch.along[j]).y;
      follow_wheel(model.out_of_round, seen.pose, y, in.angle, s);
    }
    if (!(s.depth > -margin)) continue;
    o.strip[kept] = j;
    o.depth[kept] = s.depth;
    o.centre[kept] = s.centre;
    o.curvature[kept] = s.curvature;
    o.ny[kept] = s.ny;
    o.nz[kept] = s.nz;
    o.wy[kept] = s.wy;
    o.wz[kept] = s.wz;
    o.lean[kept] = s.lean;
    ++kept;
  }
  o.count = kept;
}

}  // namespace

RelativeMotion see(const SurfaceModel& model, const WheelOnRail& in, double height) {
  RelativeMotion s;
  const SineCosine roll = sine_cosine(in.rail.roll);
  s.cosine = roll.cosine;
  s.sine = roll.sine;
  s.aslant = in.rail.slope_y != 0.0 || in.rail.slope_z != 0.0;
  if (s.aslant) s.direction = direction_of(in.rail.slope_y, in.rail.slope_z);
  const auto along_rail = [&s](double(&v)[3]) {
    if (s.aslant) turn_along_rail(s.direction, v);
  };
  for (int k = 0; k < 3; ++k) {
    double axis[3] = {in.wheel.rotation[0][k], in.wheel.rotation[1][k], in.wheel.rotation[2][k]}, turned[3];
    along_rail(axis);
    into_rail(s.cosine, s.sine, axis, turned);
    for (int i = 0; i < 3; ++i) s.pose.rotation[i][k] = turned[i];
  }
  // from the displaced origin of the rail's profile to the wheel's reference point
  double place[3] = {in.wheel.position[0], in.wheel.position[1] - model.rail_origin_y - in.rail.y,
                     height - model.rail_origin_z - in.rail.z};
  along_rail(place);
  const double dy = place[1], dz = place[2];
  s.pose.y = s.cosine * dy + s.sine * dz;
  s.pose.z = s.cosine * dz - s.sine * dy;
  // rail material moves with the rail, not along the track
  double relative[3] = {in.wheel.velocity[0], in.wheel.velocity[1] - in.rail.velocity_y,
                        in.wheel.velocity[2] - in.rail.velocity_z};
  along_rail(relative);
  relative[1] += in.rail.velocity_roll * dz;
  relative[2] -= in.rail.velocity_roll * dy;
  into_rail(s.cosine, s.sine, relative, s.velocity);
  double turning[3] = {in.wheel.angular_velocity[0], in.wheel.angular_velocity[1],
                       in.wheel.angular_velocity[2]};
  along_rail(turning);
  turning[0] -= in.rail.velocity_roll;
  into_rail(s.cosine, s.sine, turning, s.angular_velocity);
  s.rail_turning = 0.0;
  if (model.roller_curvature != 0.0) {
    s.rail_turning = in.rail.turning;
    s.velocity[0] -= in.rail.turning * (s.pose.z - 1.0 / model.roller_curvature);
    s.velocity[2] += in.rail.turning * in.distance;
    s.angular_velocity[1] -= in.rail.turning;
  }
  return s;
}

namespace {

/// The wheel's knot of the largest radius.
std::int32_t flange_tip(const WheelCurve& wheel) {
  std::int32_t tip = 0;
  for (std::int32_t k = 1; k < wheel.knots; ++k)
    if (wheel.knot_radius[k] > wheel.knot_radius[tip]) tip = k;
  return tip;
}

}  // namespace

// The front of the flange touches only what is on its own side of its tip, and rays from there would meet it
// through its body. Overlaps that are solved are less deep than 3 mm.
RailStrips strips_before(const SurfaceModel& model, const RelativeMotion& seen, const RailStrips& strips) {
  RailStrips rail = strips;
  if (rail.ranges < 2 || has_check_rail(model.varying)) return rail;
  constexpr double deepest = 3e-3;  // [m]
  const WheelCurve& wheel = model.wheel;
  const RelativePose& pose = seen.pose;
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

void find(const SurfaceModel& model, const WheelOnRail& in, const RelativeMotion& seen, double margin,
          WheelWork& w) {
  const bool varying = varies(model);
  // what follow_track() may add: on a slope a, a^2 r / 2, and more where the rail is concave
  constexpr double concave = 1.5;
  const double more = varying ? smaller(0.5 * concave * w.steepest * w.steepest * model.wheel_radius, 2e-3) +
                                    model.out_of_round.largest
                              : 0.0;
  const RailStrips rail = strips_before(model, seen, w.rail);
  find_overlaps(*model.kernels, rail, model.wheel, seen.pose, margin + more, w.scratch, w.overlaps);
  if (varying) follow_track(model, in, seen, margin, w);
}

FrictionAtRest friction_at_rest(const SurfaceModel& model, const WheelOnRail& in, const WheelWork& w,
                                std::int32_t j) {
  constexpr double rounding = 1e-9;  // [m]: of widths
  const FrictionZones& zones = in.law->zones;
  const RailStrips& rail = w.rail;
  if (zones.count == 0) return {in.law->coefficient, 0.0};
  if (!in.zones_on_wheel) {
    const double half = 0.5 * rail.width[j] * magnitude(rail.ty[j]) + rounding;
    return {mean_friction(zones, rail.y[j] - half, rail.y[j] + half), 0.0};
  }
  const CurvePoint p = evaluate(model.wheel.curve, w.scratch.piece[j], w.scratch.along[j]);
  const double speed = std::sqrt(p.dy * p.dy + p.dz * p.dz), advance = p.dy / speed;
  const double half = 0.5 * rail.width[j] * magnitude(advance) + rounding;
  const double from = p.y - half, to = p.y + half;
  const double mean = mean_friction(zones, from, to);
  if (!(advance > least_advance)) return {mean, 0.0};
  const double first = zone_friction(zones, from), last = zone_friction(zones, to);
  // the width seen along y changes as the profile turns
  const double turning = (p.ddy * p.dz - p.dy * p.ddz) * p.dz / (speed * speed * speed);
  const double half_by_y = 0.5 * rail.width[j] * turning / p.dy;
  return {mean, ((last - first) * 0.5 + (0.5 * (first + last) - mean) * half_by_y) / half};
}

double strip_speed_factor(const FrictionLaw& law, const WheelWork& w, std::int32_t k, double speed) {
  const double turning = w.spin[k] * w.half_length[k];
  const double slip2 = w.slip_x[k] * w.slip_x[k] + w.slip_y[k] * w.slip_y[k] + turning * turning / 3.0;
  return speed_factor(law, speed * std::sqrt(slip2));
}

bool rolls_by_region(const SurfaceModel& model, const WheelOnRail& in) {
  return model.methods.region.solve && (model.methods.by_region || in.slope.falls());
}

Fault roll(const SurfaceModel& model, const WheelOnRail& in, std::int32_t count, bool backwards, WheelWork& w,
           const TangentialFields& fields, SurfaceRollingForces forces, HeatedFriction* heat) {
  const auto mirror = [&](double* a) {
    for (std::int32_t k = 0; k < count; ++k) a[k] = -a[k];
  };
  const SurfaceMethods& methods = model.methods;
  auto rolls = rolling_input<double>(model, in, count, w);
  rolls.method = methods.strips;
  rolls.parabolic = methods.parabolic;
  if (backwards) {
    mirror(w.slip_x);
    mirror(w.spin);
  }
  Fault fault;
  if (rolls_by_region(model, in)) {
    for (std::int32_t k = 0; k < count; ++k) {
      const double x = w.pressure.centre[w.candidate[k]];
      w.along[k] = backwards ? -x : x;
    }
    const RegionRollingInput patches{rolls, w.along, in.slope, in.slope_reduction, heat, w.friction};
    fault = roll_by_region(patches, methods.region, w.region, w.fields, forces);
  } else {
    const bool in_fields = methods.strips == SurfaceRollingMethod::fastrip;
    roll_on_surface(rolls, w.rolling, in_fields ? w.fields : fields, forces);
  }
  if (backwards)
    for (double* a : {w.slip_x, w.spin, forces.fx, forces.mz}) mirror(a);
  return fault;
}

Fault roll_heated(const SurfaceModel& model, const WheelOnRail& in, std::int32_t count, bool backwards,
                  double speed, WheelWork& w, const SurfaceRollingForces& forces, int again) {
  HeatedFriction heat(*in.law, model.effusivities, model.grid->cells, speed);
  if (rolls_by_region(model, in)) {
    std::copy_n(w.cold_friction, count, w.friction);
    return roll(model, in, count, backwards, w, {}, forces, &heat);
  }
  Strips strips;
  strips.count = count;
  strips.half_length = w.half_length;
  Fault fault;
  const auto solve = [&] {
    for (std::int32_t k = 0; k < count; ++k) w.friction[k] = w.cold_friction[k] * w.heat_share[k];
    keep_worst(fault, roll(model, in, count, backwards, w, w.fields, forces));
  };
  const Fault unsettled = solve_heated(heat, strips, w.fields, w.fields.slip_x, w.heat_share, solve, again);
  keep_worst(fault, unsettled);
  return fault;
}

namespace {

/// Velocity of the wheel's point less the rail's, rail axes; r from the wheel's reference point.
void sliding_at(const RelativeMotion& s, double x, double y, double z, double (&v)[3]) {
  const auto& o = s.angular_velocity;
  v[0] = s.velocity[0] + o[1] * z - o[2] * y;
  v[1] = s.velocity[1] + o[2] * x - o[0] * z;
  v[2] = s.velocity[2] + o[0] * y - o[1] * x;
}

/// The law's coefficient of each strip while it is cold: over its width, at its sliding speed.
void find_friction(const SurfaceModel& model, const WheelOnRail& in, double speed, std::int32_t count,
                   WheelWork& w) {
  const FrictionLaw& law = *in.law;
  for (std::int32_t k = 0; k < count; ++k) {
    const double at_rest = friction_at_rest(model, in, w, w.overlaps.strip[w.candidate[k]]).value;
    w.friction[k] = at_rest * strip_speed_factor(law, w, k, speed);
  }
}

/// The strips in contact, and their sums.
struct Loaded {
  std::int32_t count = 0;
  double load = 0.0;     ///< [N]
  double sliding = 0.0;  ///< load times sliding velocity along the rail [N m/s]
  double below = 0.0;    ///< load times how far below the wheel's reference point it acts [N m]
};

/// Takes the strips that carry load from the overlaps and their pressure, with damping: into w's arrays,
/// slips as velocities [m/s], [rad/s].
Loaded take_loaded_strips(const WheelOnRail& in, const RelativeMotion& seen, WheelWork& w) {
  Loaded loaded;
  const Overlaps& o = w.overlaps;
  const StripPressure& p = w.pressure;
  for (std::int32_t i = 0; i < o.count; ++i) {
    if (!(p.length_squared[i] > 0.0 && p.line_load[i] > 0.0)) continue;
    const std::int32_t j = o.strip[i];
    const double l = std::sqrt(p.length_squared[i]);
    double v[3];
    sliding_at(seen, p.centre[i], o.wy[i], o.wz[i], v);
    // a roller's own point, as the wheel's, is that of the undeformed body: the overlap nearer to its axle
    if (seen.rail_turning != 0.0) v[0] += seen.rail_turning * (o.depth[i] * o.nz[i]);
    double approach_velocity = v[1] * o.ny[i] + v[2] * o.nz[i];
    if (o.lean) {  // along the slope, and against its normal
      const double along = v[0] + o.lean[i] * approach_velocity;
      approach_velocity -= o.lean[i] * v[0];
      v[0] = along;
    }
    const double damped = damping_factor(approach_velocity, in.damping);
    const double peak = damped * p.line_load[i] / l, N = 0.5 * pi * w.rail.width[j] * l * peak;
    if (!(N > 0.0)) continue;  // a region damped to nothing would have no middle
    const std::int32_t k = loaded.count++;
    w.candidate[k] = i;
    w.place[k] = w.rail.s[j];
    w.width[k] = w.rail.width[j];
    w.half_length[k] = l;
    w.peak[k] = peak;
    w.curvature[k] = damped * o.curvature[i];  // over the level: damping makes nothing stiffer along
    w.slip_x[k] = v[0];
    w.slip_y[k] = v[1] * o.nz[i] - v[2] * o.ny[i];
    w.spin[k] = seen.angular_velocity[1] * o.ny[i] + seen.angular_velocity[2] * o.nz[i];
    w.friction[k] = in.friction;
    w.fx[k] = w.fy[k] = w.mz[k] = 0.0;
    loaded.load += N;
    loaded.sliding += N * v[0];
    loaded.below += N * o.wz[i];
  }
  return loaded;
}

/// Makes slips of the strips' velocities and finds their tractions; returns the speed the slips refer to.
RollingReference roll_strips(const SurfaceModel& model, const WheelOnRail& in, const RelativeMotion& seen,
                             const Loaded& loaded, WheelWork& w, Fault& fault) {
  // the mean of the speeds at which wheel and rail material pass through the contact
  double rolling_speed = seen.velocity[0] - 0.5 * loaded.sliding / loaded.load;
  if (seen.rail_turning != 0.0) rolling_speed -= seen.rail_turning * loaded.below / loaded.load;
  const RollingReference reference = rolling_reference(rolling_speed);
  w.rolling_speed = rolling_speed;
  w.backwards = rolling_speed < 0.0;
  const double speed = reference.divisor;
  for (std::int32_t k = 0; k < loaded.count; ++k) {
    w.slip_x[k] /= speed;
    w.slip_y[k] /= speed;
    w.spin[k] /= speed;
  }
  if (!(in.friction > 0.0)) return reference;
  if (in.law) find_friction(model, in, speed, loaded.count, w);
  const bool heated = in.law && in.law->heated();
  if (heated) std::copy_n(w.friction, loaded.count, w.cold_friction);
  const auto roll_one_way = [&](bool backwards, const SurfaceRollingForces& forces) {
    return heated ? roll_heated(model, in, loaded.count, backwards, speed, w, forces)
                  : roll(model, in, loaded.count, backwards, w, {}, forces);
  };
  const double other = reference.reverse_share;
  Fault others;
  // before its own way, which leaves the strips their friction
  if (other > 0.0) others = roll_one_way(!w.backwards, {w.other_fx, w.other_fy, w.other_mz});
  keep_worst(fault, roll_one_way(w.backwards, {w.fx, w.fy, w.mz}));
  keep_worst(fault, others);
  if (!(other > 0.0)) return reference;
  for (std::int32_t k = 0; k < loaded.count; ++k) {
    w.fx[k] += other * (w.other_fx[k] - w.fx[k]);
    w.fy[k] += other * (w.other_fy[k] - w.fy[k]);
    w.mz[k] += other * (w.other_mz[k] - w.mz[k]);
  }
  return reference;
}

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

/// No overlap of faces that face each other: the bodies are apart, or the wheel is inside the rail's side.
Fault apart_or_inside(const SurfaceModel& model, const WheelWork& w) {
  constexpr double most = 4e-3;  // [m]: what rays are crossed for (outline_kernel.hpp)
  const RailStrips& rail = w.rail;
  double deepest = most;
  std::int32_t knot = -1;
  for (std::int32_t r = 0; r < rail.ranges; ++r) {
    const FaceStrips& range = rail.range[r];
    for (std::int32_t k = 0; k < model.wheel.knots; ++k) {
      const double y = w.scratch.y[k], z = w.scratch.z[k];
      if (!(w.scratch.seen[k] > 0.0 && z > range.top + deepest)) continue;
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
  return Fault::no_contact(
      "depth of the wheel inside the rail", {deepest, "m", 0.0, most},
      knot < flange_tip(model.wheel)
          ? "the flange's back is inside the rail, where no contact is looked for: is the wheel "
            "beside its rail (input.wheel.y)?"
          : "the flange is inside the rail's side, where no contact is looked for: did you pass "
            "mm for input.wheel.y, or another gauge?");
}

/// What of a solution lies beyond what is known of the bodies, or has no room.
Fault extrapolated(const SurfaceModel& model, const Loaded& loaded, const WheelWork& w) {
  const Overlaps& o = w.overlaps;
  if (o.full)
    return Fault::more_patches("strips that overlap",
                               {1.0 + most_overlapping_strips, "", 0.0, most_overlapping_strips},
                               "those beyond, on the field side, carry nothing");
  const Curve& wheel = model.wheel.curve;
  const bool alone = model.varying.faces < 2;  // another face may be there for the flange's back
  for (std::int32_t k = 0; k < loaded.count; ++k) {
    constexpr double rounding = 1e-9;  // [m]
    const double depth = o.depth[w.candidate[k]];
    if (depth > deepest_overlap + rounding)
      return Fault::beyond_gap("overlap", {depth, "m", 0.0, deepest_overlap},
                               "the load is far beyond what steel carries there");
    const std::int32_t j = o.strip[w.candidate[k]];
    constexpr double falling = 0.5;  // to the field side
    if (alone && w.rail.tz[j] > falling && w.scratch.piece[j] < flange_tip(model.wheel)) return on_the_back;
    const bool rail_ends = at_end(w.rail, j);
    // rays beyond the wheel's end meet nothing
    const double at = wheel.s[w.scratch.piece[j]] + w.scratch.along[j], near = w.rail.width[j];
    const bool wheel_ends = at < near || at > wheel.s[wheel.pieces] - near;
    if (rail_ends || wheel_ends) return Fault::patch_at_edge(rail_ends ? "config.rail" : "config.wheel");
  }
  return {};
}

/// Pressures at the overlaps, by the model's method.
Fault press(const SurfaceModel& model, WheelWork& w, PressureStart& start, const PressureOptions& options,
            Wrench& out) {
  if (model.methods.planar.solve) {
    const PlanarResult planar = solve_planar_pressure(w.rail, w.overlaps, model.methods.planar,
                                                      model.material, *model.kernels, w.planar, w.pressure);
    out.sweeps += planar.iterations;
    Fault fault = planar.fault;
    if (planar.jumps) keep_worst(fault, Fault::force_jumps("config.normal.method"));
    return fault;
  }
  const PressureResult normal =
      solve_pressure(pressure_model(model), w.rail, w.overlaps, options, w.normal, start, w.pressure);
  out.sweeps += normal.iterations;
  if (normal.converged) return {};
  return Fault::iteration_cap("sweeps", {normal.iterations});
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

double margin_of(const SurfaceModel& model) { return model.methods.planar.solve ? planar_margin : 0.0; }

Fault solve_at(const SurfaceModel& model, const WheelOnRail& in, double height, bool found, WheelWork& w,
               PressureStart& start, const PressureOptions& options, Wrench& out) {
  const std::int32_t sweeps_before = out.sweeps;
  w.factor = 1.0;
  out = {};
  out.sweeps = sweeps_before;
  out.height = height;
  const RelativeMotion seen = w.seen = see(model, in, height);
  if (!found) find(model, in, seen, margin_of(model), w);
  Fault fault = press(model, w, start, options, out);
  if (fault.failed()) return fault;
  const Loaded loaded = take_loaded_strips(in, seen, w);
  w.loaded = 0;
  if (loaded.count == 0) return apart_or_inside(model, w);  // whatever the sweeps came to: there is no force
  const RollingReference reference = roll_strips(model, in, seen, loaded, w, fault);
  w.loaded = loaded.count;
  w.speed = reference.divisor;
  keep_worst(fault, sum_up(in, seen, loaded.count, reference.divisor, w, out));
  keep_worst(fault, extrapolated(model, loaded, w));
  if (in.friction > 0.0 && reference.reverse_share > 0.0)
    keep_worst(fault, Fault::creepages_limited("rolling speed"));
  if (model.methods.region.solve) out.power = larger(out.power, 0.0);
  return fault;
}

double height_at_border(const SurfaceModel& model, const WheelOnRail& in, double height, WheelWork& w) {
  constexpr int most_steps = 12;
  for (int n = 0; n < most_steps; ++n) {
    const RelativeMotion seen = see(model, in, height);
    Overlaps& o = w.overlaps;
    find(model, in, seen, margin_of(model), w);
    double rise = 0.0;
    for (std::int32_t i = 0; i < o.count; ++i) {
      if (!(o.depth[i] > deepest_overlap)) continue;
      const double down = larger(seen.cosine * o.nz[i] + seen.sine * o.ny[i], 0.1);
      rise = larger(rise, (o.depth[i] - deepest_overlap) / down);
    }
    height -= rise;
    if (rise < 1e-12) break;
  }
  return height;
}

Fault solve_given_height(const SurfaceModel& model, const WheelOnRail& in, WheelWork& w, PressureStart& start,
                         Wrench& out) {
  constexpr double step = 2e-6;  // [m]
  const double asked = in.wheel.position[2], border = height_at_border(model, in, asked, w);
  if (!(asked > border)) return solve_at(model, in, asked, asked == border, w, start, {}, out);
  solve_at(model, in, border - step, false, w, start, {}, out);
  const double before = out.normal_force;
  Fault fault = solve_at(model, in, border, false, w, start, {}, out);
  if (fault.status == WRC_FLAG_NO_CONTACT) {  // raised until faces that are far inside each other are apart
    find(model, in, see(model, in, asked), 0.0, w);
    w.overlaps.count = 0;  // they have no pressures
    out.height = asked;
    return apart_or_inside(model, w);
  }
  if (out.normal_force > 0.0) {
    const double stiffness = larger(out.normal_force - before, 0.0) / step;
    w.factor = 1.0 + stiffness * (asked - border) / out.normal_force;
    scale(w.factor, out);
  }
  out.height = asked;
  keep_worst(fault,
             Fault::beyond_gap("overlap", {deepest_overlap + asked - border, "m", 0.0, deepest_overlap},
                               "did you pass millimetres?"));
  return fault;
}

namespace {

/// How far a wheel as seen at a height is above the strip that it touches first when it is lowered [m], by
/// the strips' tangents; at most farthest_touch. Strips count whose mean normal points down by more than
/// `least_down`. The few strips near the wheel are enough if one touches soon: others' depths are at least a
/// third of their overlaps, as their normals are less than 80 degrees off the wheel's.
double fall_to_strips(const SurfaceModel& model, const WheelOnRail& in, const RelativeMotion& seen,
                      double least_down, WheelWork& w) {
  constexpr double near = 1.5e-3;  // [m]
  const Overlaps& o = w.overlaps;
  double fall = farthest_touch;
  for (const double margin : {near, farthest_touch}) {
    find(model, in, seen, margin, w);
    for (std::int32_t i = 0; i < o.count; ++i) {
      const double down = seen.cosine * o.nz[i] + seen.sine * o.ny[i];
      if (down > least_down) fall = std::min(fall, -o.depth[i] / down);
    }
    if (fall < margin / 3.0) break;
  }
  return fall;
}

}  // namespace

bool is_apart(const Fault& fault) { return fault.status == WRC_FLAG_NO_CONTACT && fault.field == nullptr; }

double clearance(const SurfaceModel& model, const WheelOnRail& in, WheelWork& w) {
  constexpr int most_steps = 12;
  constexpr double close = 1e-10;     // [m]
  constexpr double least_down = 0.1;  // steeper than any flange
  double lowered = 0.0;
  for (int n = 0; n < most_steps; ++n) {
    const RelativeMotion seen = see(model, in, in.wheel.position[2] + lowered);
    const double fall = fall_to_strips(model, in, seen, least_down, w);
    lowered += fall;
    if (!(lowered > 0.0) || lowered >= farthest_touch || std::abs(fall) < close) break;
  }
  return smaller(larger(lowered, 0.0), farthest_touch);
}

double first_touch(const SurfaceModel& model, const WheelOnRail& in, WheelWork& w) {
  constexpr double deep =
      0.1e-3;  // [m]: from there on the wheel may be below a face that it touches from above
  constexpr double least_down = 0.2;
  double height = in.wheel.position[2];
  bool above = false;
  for (int n = 0; n < 16; ++n) {
    const RelativeMotion seen = see(model, in, height);
    double fall = fall_to_strips(model, in, seen, least_down, w);
    if (!above && fall < -deep) {  // to above all of the rail, once
      above = true;
      double lowest = -1e300, top = 1e300;
      for (std::int32_t k = 0; k < model.wheel.knots; ++k)
        if (w.scratch.seen[k] > 0.0) lowest = larger(lowest, w.scratch.z[k]);
      for (std::int32_t r = 0; r < w.rail.ranges; ++r) top = smaller(top, w.rail.range[r].top);
      fall = smaller(fall, (top - lowest) / seen.cosine);
    }
    height += fall;
    if (std::abs(fall) < 1e-7) break;
  }
  return height;
}

}  // namespace wrc
