#include "surface/wheel_on_rail.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "base/golden_section.hpp"
#include "base/number.hpp"
#include "geometry/creepages.hpp"
#include "surface/along_track.hpp"
#include "surface/normal_slopes.hpp"
#include "surface/surface_model.hpp"
#include "surface/wheel_work.hpp"

namespace wrc {
namespace {

using Work = WheelWork;

constexpr std::int32_t most = most_overlapping_strips;

constexpr double load_tolerance = 1e-8;  ///< prescribed loads are met to this part
constexpr std::int32_t most_load_steps = 30;

/// Overlaps are solved up to this deep [m]: several meganewtons, beyond any steel.
constexpr double deepest_overlap = 2e-3;

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
  SurfacePressure& p = w.pressure;
  for (double** a : {&p.length_squared, &p.level, &p.centre, &p.strength}) *a = doubles(most);
  w.normal =
      doubles(std::max(surface_normal_doubles(most), wrench_slopes_doubles(most_differentiated_strips)));
  w.slopes = w.normal;  // which is done with by then
  w.rolling = doubles(static_cast<std::int64_t>(surface_rolling_workspace(most)));
  for (double** a : {&w.place, &w.width, &w.half_length, &w.peak, &w.curvature, &w.slip_x, &w.slip_y, &w.spin,
                     &w.friction, &w.fx, &w.fy, &w.mz, &w.other_fx, &w.other_fy, &w.other_mz})
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
  if (methods.planar.solve) w.planar = doubles(planar_normal_doubles(most, methods.planar));
  if (methods.region.solve) {
    w.along = doubles(most);
    w.region = doubles(region_rolling_doubles(most, methods.region));
  }
  return (at - begin) * static_cast<std::int64_t>(sizeof(double));
}

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
  s.rail_turning = 0.0;
  if (model.roller_curvature != 0.0) {
    s.rail_turning = in.rail.turning;
    s.velocity[0] -= in.rail.turning * (s.pose.z - 1.0 / model.roller_curvature);
    s.velocity[2] += in.rail.turning * in.distance;
    s.angular_velocity[1] -= in.rail.turning;
  }
  return s;
}

/// What a rail that changes along the track and a wheel that is not round add to the overlaps; those within
/// the margin are kept.
void follow_track(const SurfaceModel& model, const WheelOnRail& in, const Seen& seen, double margin,
                  Work& w) {
  Overlaps& o = w.overlaps;
  const Curve& profile = model.wheel.curve;
  std::int32_t kept = 0;
  for (std::int32_t i = 0; i < o.count; ++i) {
    const std::int32_t j = o.strip[i];
    StripOverlap<double> s{o.depth[i], o.centre[i], o.curvature[i], o.ny[i], o.nz[i], o.wy[i], o.wz[i], 0.0};
    if (model.varying.faces > 0) follow_rail(model.varying, j, w.distance, s);
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

/// Finds all strips with depth > -margin.
void find(const SurfaceModel& model, const WheelOnRail& in, const Seen& seen, double margin, Work& w) {
  const bool varying = varies(model);
  // what follow_track() may add: on a slope a, a^2 r / 2, and more where the rail is concave
  constexpr double concave = 1.5;
  const double more = varying ? smaller(0.5 * concave * w.steepest * w.steepest * model.wheel_radius, 2e-3) +
                                    model.out_of_round.largest
                              : 0.0;
  find_overlaps(*model.kernels, w.rail, model.wheel, seen.pose, margin + more, w.scratch, w.overlaps);
  if (varying) follow_track(model, in, seen, margin, w);
}

/// Velocity of the wheel's point less the rail's, rail axes; r from the wheel's reference point.
void sliding_at(const Seen& s, double x, double y, double z, double (&v)[3]) {
  const auto& o = s.angular_velocity;
  v[0] = s.velocity[0] + o[1] * z - o[2] * y;
  v[1] = s.velocity[1] + o[2] * x - o[0] * z;
  v[2] = s.velocity[2] + o[0] * y - o[1] * x;
}

/// Adds a force at (x, y, z) and a moment there to force and moment about the origin.
void add(double x, double y, double z, double fx, double fy, double fz, double mz_y, double mz_z,
         double (&force)[3], double (&moment)[3]) {
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
void find_friction(const FrictionLaw& law, double speed, std::int32_t count, Work& w) {
  for (std::int32_t k = 0; k < count; ++k) {
    const double at_rest = friction_at_rest(w.rail, law, w.overlaps.strip[w.candidate[k]]);
    const double turning = w.spin[k] * w.half_length[k];
    const double slip2 = w.slip_x[k] * w.slip_x[k] + w.slip_y[k] * w.slip_y[k] + turning * turning / 3.0;
    w.friction[k] = at_rest * friction_fall(law, speed * std::sqrt(slip2));
  }
}

/// Does the whole of a patch roll at a time?
bool rolls_by_region(const SurfaceModel& model, const WheelOnRail& in) {
  return model.methods.region.solve && (model.methods.by_region || in.slope.falls());
}

/// Tractions of the strips in contact. Backwards is forwards seen in a mirror across the axle: x, and with it
/// slip along x and spin, change sign, and so do their forces.
Fault roll(const SurfaceModel& model, const WheelOnRail& in, std::int32_t count, bool backwards, Work& w,
           const TangentialFields& fields, SurfaceRollingForces forces) {
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
    fault = roll_by_region(rolls, w.along, methods.region, in.slope, in.slope_reduction, w.region, w.fields,
                           forces);
  } else {
    const bool in_fields = methods.strips == SurfaceRollingMethod::fastrip;
    roll_on_surface(rolls, w.rolling, in_fields ? w.fields : fields, forces);
  }
  if (backwards)
    for (double* a : {w.slip_x, w.spin, forces.fx, forces.mz}) mirror(a);
  return fault;
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
Loaded take_loaded_strips(const WheelOnRail& in, const Seen& seen, Work& w) {
  Loaded loaded;
  const Overlaps& o = w.overlaps;
  const SurfacePressure& p = w.pressure;
  for (std::int32_t i = 0; i < o.count; ++i) {
    if (!(p.length_squared[i] > 0.0 && p.strength[i] > 0.0)) continue;
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
    const double damped = std::max(0.0, 1.0 + 1.5 * in.damping * approach_velocity);
    const double peak = damped * p.strength[i] / l, N = 0.5 * pi * w.rail.width[j] * l * peak;
    if (!(N > 0.0)) continue;  // a region damped to nothing would have no middle
    const std::int32_t k = loaded.count++;
    w.candidate[k] = i;
    w.place[k] = w.rail.s[j];
    w.width[k] = w.rail.width[j];
    w.half_length[k] = l;
    w.peak[k] = peak;
    w.curvature[k] = o.curvature[i];
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
RollingReference roll_strips(const SurfaceModel& model, const WheelOnRail& in, const Seen& seen,
                             const Loaded& loaded, Work& w, Fault& fault) {
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
  if (in.law) find_friction(*in.law, speed, loaded.count, w);
  const bool backwards = w.backwards;
  keep_worst(fault, roll(model, in, loaded.count, backwards, w, {}, {w.fx, w.fy, w.mz}));
  const double other = reference.other_way;
  if (!(other > 0.0)) return reference;
  keep_worst(fault, roll(model, in, loaded.count, !backwards, w, {}, {w.other_fx, w.other_fy, w.other_mz}));
  for (std::int32_t k = 0; k < loaded.count; ++k) {
    w.fx[k] += other * (w.other_fx[k] - w.fx[k]);
    w.fy[k] += other * (w.other_fy[k] - w.fy[k]);
    w.mz[k] += other * (w.other_mz[k] - w.mz[k]);
  }
  return reference;
}

/// The region that strips are being added to: in rail axes, moments about the wheel's reference point, places
/// and creepages times load, until it is closed.
struct OpenRegion {
  SurfaceRegion* region = nullptr;
  double normal[2] = {};  ///< resultant of the pressure, along y and z [N]
  double load = 0.0;      ///< sum of the strips' normal forces [N]
};

/// Completes a region and adds it to the sums over all; nothing if none is open.
void close(const WheelOnRail& in, const Seen& seen, OpenRegion& open, Wrench& out) {
  if (!open.region) return;
  SurfaceRegion& r = *open.region;
  for (double& c : r.point) c /= open.load;
  for (double& c : r.creepage) c /= open.load;
  r.normal_force = std::sqrt(open.normal[0] * open.normal[0] + open.normal[1] * open.normal[1]);
  double direction[3] = {0.0, open.normal[0], open.normal[1]};
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
  r.point[2] += out.height;
  open = {};
}

/// Frictional power of the k-th strip in contact [W].
double power_of(const Work& w, std::int32_t k, double speed) {
  return -speed * (w.fx[k] * w.slip_x[k] + w.fy[k] * w.slip_y[k] + w.mz[k] * w.spin[k]);
}

/// Adds the k-th strip in contact to the region it belongs to.
void add_strip(const Work& w, std::int32_t k, double speed, OpenRegion& open, Wrench& out) {
  SurfaceRegion& r = *open.region;
  const Overlaps& o = w.overlaps;
  const std::int32_t i = w.candidate[k];
  r.count = o.strip[i] + 1 - r.first;
  const double l = w.half_length[k], N = 0.5 * pi * w.width[k] * l * w.peak[k];
  const double ny = o.ny[i], nz = o.nz[i], x = w.pressure.centre[i];
  double fx = w.fx[k], fy = w.fy[k] * nz - N * ny, fz = -w.fy[k] * ny - N * nz;
  if (o.lean) {  // tangent (1, lean n), normal (-lean, n)
    fy += o.lean[i] * fx * ny;
    fz += o.lean[i] * fx * nz;
    fx += o.lean[i] * N;
  }
  add(x, o.wy[i], o.wz[i], fx, fy, fz, w.mz[k] * ny, w.mz[k] * nz, r.force, r.moment);
  open.normal[0] += N * ny;
  open.normal[1] += N * nz;
  open.load += N;
  r.point[0] += N * x;
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
  const double power = power_of(w, k, speed);
  r.power += power;
  out.power += power;
}

/// The wrench: sums over the strips in contact, region by region. A region is strips side by side; the last
/// of those listed takes what follows.
Fault sum_up(const WheelOnRail& in, const Seen& seen, std::int32_t count, double speed, const Work& w,
             Wrench& out) {
  Fault fault;
  OpenRegion open;
  std::int32_t last_strip = -2;
  for (std::int32_t k = 0; k < count; ++k) {
    const std::int32_t strip = w.overlaps.strip[w.candidate[k]];
    if (strip != last_strip + 1) {
      if (out.regions < most_surface_regions) {
        close(in, seen, open, out);
        open.region = &out.region[out.regions++];
        *open.region = {};
        open.region->first = strip;
      } else {
        keep_worst(fault, {.status = WRC_FLAG_MORE_PATCHES});
      }
    }
    last_strip = strip;
    add_strip(w, k, speed, open, out);
  }
  close(in, seen, open, out);
  into_track(seen, out.force);
  into_track(seen, out.moment);
  return fault;
}

/// Is a strip the first or the last of its surface?
bool at_end(const RailStrips& rail, std::int32_t strip) {
  for (std::int32_t r = 0; r < rail.ranges; ++r)
    if (strip == rail.range[r].first || strip == rail.range[r].first + rail.range[r].count - 1) return true;
  return false;
}

/// What of a solution lies beyond what is known of the bodies, or has no room.
Fault extrapolated(const SurfaceModel& model, const Loaded& loaded, const Work& w) {
  const Overlaps& o = w.overlaps;
  if (o.full)
    return {.status = WRC_FLAG_MORE_PATCHES,
            .field = "strips that overlap",
            .value = 1.0 + most,
            .unit = "",
            .high = 1.0 * most,
            .cause = "those beyond, on the field side, carry nothing"};
  const Curve& wheel = model.wheel.curve;
  for (std::int32_t k = 0; k < loaded.count; ++k) {
    constexpr double rounding = 1e-9;  // [m]
    const double depth = o.depth[w.candidate[k]];
    if (depth > deepest_overlap + rounding)
      return {.status = WRC_FLAG_BEYOND_GAP,
              .field = "overlap",
              .value = depth,
              .unit = "m",
              .high = deepest_overlap,
              .cause = "the load is far beyond what steel carries there"};
    const std::int32_t j = o.strip[w.candidate[k]];
    const bool rail_ends = at_end(w.rail, j);
    // rays beyond the wheel's end meet nothing
    const double at = wheel.s[w.scratch.piece[j]] + w.scratch.along[j], near = w.rail.width[j];
    const bool wheel_ends = at < near || at > wheel.s[wheel.pieces] - near;
    if (rail_ends || wheel_ends)
      return {.status = WRC_FLAG_PATCH_AT_EDGE, .field = rail_ends ? "config.rail" : "config.wheel"};
  }
  return {};
}

/// Pressures at the overlaps, by the model's method.
Fault press(const SurfaceModel& model, Work& w, SurfaceStart& start, const SurfaceNormalOptions& options,
            Wrench& out) {
  if (model.methods.planar.solve) {
    const PlanarResult planar = solve_planar_normal(w.rail, w.overlaps, model.methods.planar, model.material,
                                                    *model.kernels, w.planar, w.pressure);
    out.sweeps += planar.iterations;
    out.leaps = planar.leaps ? 1 : 0;
    return planar.fault;
  }
  const SurfaceNormalResult normal =
      solve_surface_normal(w.rail, w.overlaps, *model.influence, *model.kernels,
                           model.material.normal_compliance(), options, w.normal, start, w.pressure);
  out.sweeps += normal.sweeps;
  if (normal.converged) return {};
  return {.status = WRC_FLAG_ITERATION_CAP, .field = "sweeps", .value = 1.0 * normal.sweeps};
}

/// Strips nearer than this to the wheel are candidates [m].
double margin_of(const SurfaceModel& model) { return model.methods.planar.solve ? planar_margin : 0.0; }

/// Solves at a height; the wrench is complete but for the sweeps of earlier calls, which stay in it. `found`:
/// the overlaps at this height stand in w.overlaps already.
Fault solve_at(const SurfaceModel& model, const WheelOnRail& in, double height, bool found, Work& w,
               SurfaceStart& start, const SurfaceNormalOptions& options, Wrench& out) {
  const std::int32_t sweeps_before = out.sweeps;
  w.factor = 1.0;
  out = {};
  out.sweeps = sweeps_before;
  out.height = height;
  const Seen seen = w.seen = see(model, in, height);
  if (!found) find(model, in, seen, margin_of(model), w);
  Fault fault = press(model, w, start, options, out);
  if (fault.failed()) return fault;
  const Loaded loaded = take_loaded_strips(in, seen, w);
  w.loaded = 0;
  if (loaded.count == 0)
    return {.status = WRC_FLAG_NO_CONTACT};  // whatever the sweeps came to: there is no force
  const RollingReference reference = roll_strips(model, in, seen, loaded, w, fault);
  w.loaded = loaded.count;
  w.speed = reference.divisor;
  keep_worst(fault, sum_up(in, seen, loaded.count, reference.divisor, w, out));
  keep_worst(fault, extrapolated(model, loaded, w));
  if (in.friction > 0.0 && reference.other_way > 0.0)
    keep_worst(fault, {.status = WRC_FLAG_CREEPAGES_LIMITED, .field = "rolling speed"});
  if (model.methods.region.solve) out.power = larger(out.power, 0.0);
  return fault;
}

/// The greatest height, no greater than `height`, at which no overlap is deeper than `deepest_overlap` [m].
/// Leaves the overlaps at that height where it is the one.
double height_at_border(const SurfaceModel& model, const WheelOnRail& in, double height, Work& w) {
  constexpr int most_steps = 12;
  for (int n = 0; n < most_steps; ++n) {
    const Seen seen = see(model, in, height);
    Overlaps& o = w.overlaps;
    find(model, in, seen, margin_of(model), w);
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

/// The wrench at the height given. Beyond the deepest overlap that is solved the load goes on with the
/// stiffness it had, in the directions it had.
Fault solve_given_height(const SurfaceModel& model, const WheelOnRail& in, Work& w, SurfaceStart& start,
                         Wrench& out) {
  constexpr double step = 2e-6;  // [m]
  const double asked = in.wheel.position[2], border = height_at_border(model, in, asked, w);
  if (!(asked > border)) return solve_at(model, in, asked, asked == border, w, start, {}, out);
  solve_at(model, in, border - step, false, w, start, {}, out);
  const double before = out.normal_force;
  Fault fault = solve_at(model, in, border, false, w, start, {}, out);
  if (out.normal_force > 0.0) {
    const double stiffness = larger(out.normal_force - before, 0.0) / step;
    w.factor = 1.0 + stiffness * (asked - border) / out.normal_force;
    scale(w.factor, out);
  }
  out.height = asked;
  keep_worst(fault, {.status = WRC_FLAG_BEYOND_GAP,
                     .field = "overlap",
                     .value = deepest_overlap + asked - border,
                     .unit = "m",
                     .high = deepest_overlap,
                     .cause = "did you pass millimetres?"});
  return fault;
}

/// The height [m] at which the wheel first touches: lowered, or raised, from the one given until it does.
double first_touch(const SurfaceModel& model, const WheelOnRail& in, Work& w) {
  constexpr double margin = 50e-3;  // [m]
  double height = in.wheel.position[2];
  for (int n = 0; n < 12; ++n) {
    const Seen seen = see(model, in, height);
    const Overlaps& o = w.overlaps;
    find(model, in, seen, margin, w);
    double fall = margin;
    for (std::int32_t i = 0; i < o.count; ++i) {
      const double down = seen.cosine * o.nz[i] + seen.sine * o.ny[i];
      if (down > 0.2) fall = std::min(fall, -o.depth[i] / down);
    }
    height += fall;
    if (std::abs(fall) < 1e-7) break;
  }
  return height;
}

/// Search of the height for a load: between one that carries too little and one that carries too much, by
/// secants of the load's power 2/3, which is nearly straight.
class HeightSearch {
 public:
  explicit HeightSearch(double load) : target_(straightened(load)) {}

  /// Notes that `height` carries `load`.
  void take(double height, double load) {
    const double value = straightened(load) - target_;
    (value < 0.0 ? low_ : high_) = {height, value, true};
  }

  /// Nothing is left between the heights.
  bool exhausted() const { return low_.known && high_.known && std::abs(high_.height - low_.height) < 1e-16; }

  /// Where to look after `height` in the search's step `step`, counted from 0.
  double next(double height, std::int32_t step) const {
    if (!(low_.known && high_.known)) {
      // one side only: by the slope of a sphere, F ~ depth^(3/2), with twice the step
      const double depth_step = 20e-6 * static_cast<double>(1 << std::min(step, 12));
      return low_.known ? height + depth_step : height - depth_step;
    }
    const double low = low_.height, high = high_.height;
    const double inside = 1e-3 * (high - low);
    const double between =
        step % 6 == 5 ? 0.5 * (low + high) : low - low_.value * (high - low) / (high_.value - low_.value);
    return smaller(larger(between, smaller(low, high) + inside), larger(low, high) - inside);
  }

 private:
  struct End {
    double height = 0.0, value = 0.0;  ///< [m], of the straightened load less the target
    bool known = false;
  };

  static double straightened(double load) {
    return load > 0.0 ? natural_exp(natural_log(load) * (2.0 / 3.0)) : 0.0;
  }

  double target_;
  End low_, high_;
};

/// The wrench at the height that carries the load given, searched from `height`, which becomes it. `search`:
/// between what it knows.
Fault search_height(const SurfaceModel& model, const WheelOnRail& in, HeightSearch search, Work& w,
                    SurfaceStart& start, double& height, Wrench& out) {
  const double asked = in.vertical_load;
  Fault fault;
  for (std::int32_t step = 0; step < most_load_steps; ++step) {
    const Fault here = solve_at(model, in, height, false, w, start, {}, out);
    const double load = -out.force[2];
    fault = here.status == WRC_FLAG_NO_CONTACT ? Fault{} : here;
    if (std::abs(load - asked) <= load_tolerance * asked) return fault;
    search.take(height, load);
    if (search.exhausted()) break;
    height = search.next(height, step);
  }
  keep_worst(fault,
             {.status = WRC_FLAG_ITERATION_CAP, .field = "input.vertical_load", .value = asked, .unit = "N"});
  return fault;
}

/// Is the first of two faces a check rail? Both are there everywhere then, at this distance to either side
/// (model_options.cpp).
bool has_check_rail(const VaryingRail& rail) {
  constexpr double everywhere = 1e6;  // [m]
  return rail.faces == 2 && rail.begin == -everywhere && rail.end == everywhere;
}

/// The strips of the rail where the wheel is; flagged where there is no section.
Fault place_rail(const SurfaceModel& model, const WheelOnRail& in, Work& w) {
  w.rail = model.rail;
  w.distance = in.distance;
  const VaryingRail& varying = model.varying;
  w.steepest = 0.0;
  if (varying.faces == 0) return {};
  w.distance = smaller(larger(in.distance, varying.begin), varying.end);
  w.steepest = place_strips(varying, w.distance, w.rail_strips, most_strips_of_a_rail, w.rail);
  if (has_check_rail(varying)) {
    // it guides with the side that faces the rail; rays of the other side meet the wheel through its body
    StripRange& check = w.rail.range[0];
    while (check.count > 1 && w.rail.tz[check.first] < 0.0) {
      ++check.first;
      --check.count;
    }
  }
  if (w.distance == in.distance) return {};
  return {.status = WRC_FLAG_BEYOND_SECTIONS,
          .field = "input.distance",
          .value = in.distance,
          .unit = "m",
          .low = varying.begin,
          .high = varying.end,
          .cause = "the nearest section is used"};
}

/// Could friction take more from the vertical force of a strip than its pressure gives it? Of the strips that
/// press at that height, and of those that would a fifth of a millimetre further. What the last solve left in
/// `w` but for overlaps and pressures stays, these are of `height` afterwards.
bool friction_outweighs_slope(const SurfaceModel& model, const WheelOnRail& in, double height, Work& w) {
  constexpr double beyond = 0.2e-3, safe = 0.9;  // [m], share of what holds the balance
  const Seen seen = see(model, in, height);
  Overlaps& o = w.overlaps;
  find(model, in, seen, beyond, w);
  for (std::int32_t i = 0; i < o.count; ++i) {
    const double friction = in.law ? friction_at_rest(w.rail, *in.law, o.strip[i]) : in.friction;
    const double down = seen.cosine * o.nz[i] + seen.sine * o.ny[i];
    const double aside = seen.cosine * o.ny[i] - seen.sine * o.nz[i];
    if (friction * magnitude(aside) > safe * down) return true;
  }
  return false;
}

/// What the vertical force does as a wheel is lowered from first touch on.
struct WayDown {
  static constexpr std::int32_t most = 13;
  std::int32_t count = 0;
  double height[most] = {}, load[most] = {};  ///< [m], [N]; the first is first touch
  std::int32_t reaches = 0;                   ///< the first that carries the load; 0: none
  std::int32_t summit = 0;                    ///< where it is largest before it falls
  bool falls = false;                         ///< before the load is reached: behind the summit
  bool falls_again = false;                   ///< below the load, after it was reached
};

/// Looks at heights each twice as far below first touch as the one before, down to the deepest overlap that
/// is solved, or until many times the load presses.
WayDown look_down(const SurfaceModel& model, const WheelOnRail& in, Work& w, SurfaceStart& start,
                  Wrench& out) {
  constexpr double first_step = 4e-6;  // [m]
  constexpr double counts = 1e-3;      // of the load: what a fall is told from rounding by
  constexpr double enough = 20.0;      // loads: where a wheel is wedged rather than carried
  const double asked = in.vertical_load;
  WayDown way;
  way.height[way.count++] = first_touch(model, in, w);
  const double touch = way.height[0];
  const double deepest = first_step * static_cast<double>(1 << (WayDown::most - 2));
  const double border = height_at_border(model, in, touch + deepest, w);
  std::int32_t highest = 0;
  double pressed = 0.0;  // [N]
  for (std::int32_t k = 1; k < WayDown::most && !way.falls_again; ++k) {
    const double height = smaller(touch + first_step * static_cast<double>(1 << (k - 1)), border);
    if (!(height > way.height[k - 1]) || pressed > enough * asked) break;
    solve_at(model, in, height, false, w, start, {}, out);
    const double load = -out.force[2];
    pressed = out.normal_force;
    way.height[k] = height;
    way.load[k] = load;
    way.count = k + 1;
    if (way.reaches > 0) {
      way.falls_again = load < asked;
    } else if (load >= asked) {
      way.reaches = k;
    } else if (way.summit == 0 && load < way.load[highest] - counts * asked) {
      way.falls = true;
      way.summit = highest;
    }
    if (load > way.load[highest]) highest = k;
  }
  return way;
}

/// The wrench where the vertical force is largest between two heights.
Fault solve_at_summit(const SurfaceModel& model, const WheelOnRail& in, double low, double high, Work& w,
                      SurfaceStart& start, double& height, Wrench& out) {
  constexpr int steps = 20;
  const auto load_at = [&](double at) {
    solve_at(model, in, at, false, w, start, {}, out);
    return -out.force[2];
  };
  narrow_to_largest(low, high, steps, load_at);
  height = 0.5 * (low + high);
  return solve_at(model, in, height, false, w, start, {}, out);
}

/// The wrench at the height that carries the load given, searched from `height`, which becomes it.
///
/// Where friction on a steep face can outweigh its slope, the vertical force may fall as the wheel goes down,
/// and the load be carried at no height or at several. Then the way down from first touch is looked at, so
/// that it does not matter where the search begins: taken is the highest that carries the load with a force
/// that grows downwards, and where none does, the first at which the force ceases to grow: the end of the
/// branch that begins at first touch, in which the former goes over without a jump as the load grows.
Fault solve_given_load(const SurfaceModel& model, const WheelOnRail& in, Work& w, SurfaceStart& start,
                       double& height, Wrench& out) {
  const double asked = in.vertical_load;
  const Fault found = search_height(model, in, HeightSearch(asked), w, start, height, out);
  if (!(in.friction > 0.0)) return found;
  const bool capped = found.status == WRC_FLAG_ITERATION_CAP;
  const double searched = out.height;
  if (!friction_outweighs_slope(model, in, capped ? first_touch(model, in, w) : searched, w)) {
    // overlaps are those of the solution again: derivatives are made of them
    find(model, in, w.seen, margin_of(model), w);
    return found;
  }

  const WayDown way = look_down(model, in, w, start, out);
  const auto climbing = [&](const char* cause, const Fault& beside) {
    Fault fault{.status = WRC_FLAG_CLIMBING,
                .field = "input.vertical_load",
                .value = asked,
                .unit = "N",
                .cause = cause};
    keep_worst(fault, beside);
    return fault;
  };
  const auto between = [&](double low, double load_at_low, double high, double load_at_high) {
    HeightSearch search(asked);
    search.take(low, load_at_low);
    search.take(high, load_at_high);
    height = !capped && searched > low && searched <= high ? searched : search.next(high, 0);
    return search_height(model, in, search, w, start, height, out);
  };
  if (way.summit > 0) {
    const std::int32_t k = way.summit;
    const Fault fault =
        solve_at_summit(model, in, way.height[k - 1], way.height[k + 1], w, start, height, out);
    const double most_carried = -out.force[2];
    if (most_carried >= asked)
      return climbing("the highest of the heights that do is returned",
                      between(way.height[k - 1], way.load[k - 1], height, most_carried));
    if (way.reaches == 0)
      return climbing("none does; returned is where the force first ceases to grow on the way down", fault);
  }
  if (way.reaches > 0) {
    const std::int32_t k = way.reaches;
    const Fault fault = between(way.height[k - 1], way.load[k - 1], way.height[k], way.load[k]);
    if (way.falls)
      return climbing("one does, but the force fell on the way down to it: it began on another branch",
                      fault);
    return way.falls_again ? climbing("the highest of the heights that do is returned", fault) : fault;
  }
  if (way.falls) {
    solve_at(model, in, height = way.height[0], false, w, start, {}, out);
    return climbing("none does; returned is first touch: from there on the force does not grow", {});
  }
  const Fault fault = solve_at(model, in, height = searched, false, w, start, {}, out);
  return found.status == WRC_OK ? fault : found;
}

/// What the last solve left in `w`, for later.
void keep_strips(const SurfaceModel& model, const WheelOnRail& in, const Work& w, KeptStrips& kept) {
  const std::int32_t n = w.loaded;
  kept.count = n;
  kept.speed = n > 0 ? w.speed : 0.0;
  kept.rolling_speed = n > 0 ? w.rolling_speed : 0.0;
  kept.backwards = n > 0 && w.backwards ? 1.0 : 0.0;
  kept.rolls = in.friction > 0.0 ? 1.0 : 0.0;
  kept.by_region = rolls_by_region(model, in) ? 1.0 : 0.0;
  kept.slope_reduction = in.slope_reduction;
  kept.factor = w.factor;
  kept.x = in.wheel.position[0];
  const Overlaps& o = w.overlaps;
  const auto& r = w.seen.pose.rotation;
  for (std::int32_t k = 0; k < n; ++k) {
    const std::int32_t i = w.candidate[k], j = o.strip[i];
    kept.strip[k] = j;
    kept.y[k] = w.rail.y[j];
    kept.z[k] = w.rail.z[j];
    kept.angle[k] = strip_angle(w.rail, j);
    kept.centre[k] = w.pressure.centre[i];
    kept.power[k] = power_of(w, k, w.speed);
    kept.y_wheel[k] = r[0][1] * o.centre[i] + r[1][1] * o.wy[i] + r[2][1] * o.wz[i];
  }
  const struct {
    const double* from;
    double* to;
  } each[] = {{w.place, kept.place},
              {w.width, kept.width},
              {w.half_length, kept.half_length},
              {w.peak, kept.peak},
              {w.curvature, kept.curvature},
              {w.slip_x, kept.slip_x},
              {w.slip_y, kept.slip_y},
              {w.spin, kept.spin},
              {w.friction, kept.friction},
              {w.fx, kept.fx},
              {w.fy, kept.fy}};
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
                          void* workspace, Wrench& out, SeenWrench* slopes, SeenWrench* by_track) noexcept {
  Work w;
  cut(workspace, model.wheel.curve.pieces, model.methods, model.grid->cells, varies(model), w);
  const Fault outside = place_rail(model, in, w);
  warm = warm && state.set > 0.0;
  SurfaceStart start{state.length_squared, state.shift, warm};
  out = {};
  Fault fault;
  if (in.load_prescribed) {
    constexpr double pressed = 60e-6;  // [m]
    if (!warm) state.height = first_touch(model, in, w) + pressed;
    fault = solve_given_load(model, in, w, start, state.height, out);
  } else {
    fault = solve_given_height(model, in, w, start, out);
    state.height = in.wheel.position[2];
  }
  state.set = start.set ? 1.0 : 0.0;
  keep_strips(model, in, w, state.kept);
  if (slopes) keep_worst(fault, differentiate_wrench(model, in, w, SlopesBy::place, *slopes));
  if (by_track && varies(model))
    keep_worst(fault, differentiate_wrench(model, in, w, SlopesBy::track, *by_track));
  for (std::int32_t k = 0; k < w.loaded; ++k)
    out.steepest_angle = std::max(out.steepest_angle, std::abs(state.kept.angle[k] + in.rail.roll));
  keep_worst(fault, outside);
  return fault;
}

KeptFields roll_kept(const SurfaceModel& model, const KeptStrips& kept, std::int32_t first,
                     std::int32_t count, void* workspace) noexcept {
  Work w;
  cut(workspace, model.wheel.curve.pieces, model.methods, model.grid->cells, varies(model), w);
  const struct {
    const double* from;
    double* to;
  } each[] = {{kept.half_length, w.half_length}, {kept.peak, w.peak},     {kept.curvature, w.curvature},
              {kept.slip_x, w.slip_x},           {kept.slip_y, w.slip_y}, {kept.spin, w.spin},
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
  return {count, cells, f.traction_x, f.traction_y, f.slip_x, f.slip_y};
}

}  // namespace wrc
