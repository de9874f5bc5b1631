#include "surface/wrench_slopes.hpp"

#include "base/number.hpp"
#include "geometry/creepages.hpp"
#include "surface/normal_slopes.hpp"
#include "surface/surface_model.hpp"
#include "surface/wheel_work.hpp"

namespace wrc {
namespace {

using Number = SeenDual;

Number seen_number(const PlaceDual& a) {
  Number n = a.value;
  for (std::size_t k = 0; k < place_inputs; ++k) n.d[k] = a.d[k];
  return n;
}

/// A strip in contact.
struct StripSlopes {
  Number centre, ny, nz, wy, wz;
  Number normal;  ///< load [N]
  Number fx, fy, mz;
};

struct Scratch {
  PressedStrips pressed;
  double* normal;
};

std::int64_t cut(double* memory, std::int32_t most, Scratch& w) {
  double* at = memory;
  const auto take = [&at](std::int64_t n) {
    double* const here = at;
    at += n;
    return here;
  };
  const auto numbers = [&](std::int64_t each) {
    return reinterpret_cast<PlaceDual*>(
        take(most * each * static_cast<std::int64_t>(sizeof(PlaceDual) / sizeof(double))));
  };
  PressedStrips& p = w.pressed;
  for (double** a : {&p.place, &p.width, &p.strength, &p.length_squared, &p.centre}) *a = take(most);
  for (PlaceDual** a : {&p.changed_strength, &p.changed_length_squared, &p.changed_centre}) *a = numbers(1);
  static_assert(sizeof(OverlapSlopes) == 7 * sizeof(PlaceDual));
  p.overlap = reinterpret_cast<OverlapSlopes*>(numbers(7));
  w.normal = take(normal_slopes_doubles(most));
  return at - memory;
}

}  // namespace

std::int64_t wrench_slopes_doubles(std::int32_t most) {
  Scratch w;
  double nothing = 0.0;
  return cut(&nothing, most, w);
}

Fault differentiate_wrench(const SurfaceModel& model, const WheelOnRail& in, const WheelWork& work,
                           SeenWrench& out) noexcept {
  out = {};
  const Seen& seen = work.seen;
  Scratch w;
  cut(work.slopes, most_differentiated_strips, w);
  const Overlaps& o = work.overlaps;
  const SurfacePressure& p = work.pressure;
  PressedStrips& s = w.pressed;
  s.count = 0;
  const RelativePoseOf<PlaceDual> pose = moving_pose(seen.pose);
  const OutlineAttitudeOf<PlaceDual> attitude = attitude_of(pose);
  for (std::int32_t i = 0; i < o.count; ++i) {
    if (!(p.length_squared[i] > 0.0 && p.strength[i] > 0.0)) continue;
    if (s.count == most_differentiated_strips) {
      return {.status = WRC_FLAG_MORE_PATCHES,
              .field = "strips in contact",
              .value = 1.0 + most_differentiated_strips,
              .unit = "",
              .high = most_differentiated_strips,
              .cause = "there is no room for the derivatives of so many"};
    }
    const std::int32_t k = s.count++, j = o.strip[i];
    s.place[k] = model.rail.s[j];
    s.width[k] = model.rail.width[j];
    s.strength[k] = p.strength[i];
    s.length_squared[k] = p.length_squared[i];
    s.centre[k] = p.centre[i];
    s.overlap[k] = overlap_slopes(model.rail, model.wheel, pose, attitude, work.scratch, j);
  }
  differentiate_pressures(*model.influence, *model.kernels, model.material.normal_compliance(), w.normal, s);

  Number velocity[3], turning[3];
  for (std::size_t i = 0; i < 3; ++i) {
    velocity[i] = Number::input(seen.velocity[i], seen_velocity + i);
    turning[i] = Number::input(seen.angular_velocity[i], seen_turning + i);
  }
  for (std::int32_t k = 0; k < s.count; ++k) {
    const OverlapSlopes& overlap = s.overlap[k];
    const Number x = seen_number(s.changed_centre[k]), y = seen_number(overlap.wy),
                 z = seen_number(overlap.wz), ny = seen_number(overlap.ny), nz = seen_number(overlap.nz);
    const Number vy = velocity[1] + turning[2] * x - turning[0] * z;
    const Number vz = velocity[2] + turning[0] * y - turning[1] * x;
    const Number damped = larger(Number(0.0), 1.0 + 1.5 * in.damping * (vy * ny + vz * nz));
    const Number N = (0.5 * pi * s.width[k]) * (damped * seen_number(s.changed_strength[k]));
    if (!(N.value > 0.0)) continue;
    const Number fy = -(N * ny), fz = -(N * nz);
    out.force[1] += fy;
    out.force[2] += fz;
    out.moment[0] += y * fz - z * fy;
    out.moment[1] += -(x * fz);
    out.moment[2] += x * fy;
  }
  return {};
}

}  // namespace wrc
