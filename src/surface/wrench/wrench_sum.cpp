#include "surface/wrench/wrench_sum.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "base/number.hpp"

namespace wrc {

void into_track(const RelativeMotion& s, double (&v)[3]) {
  const double y = v[1], z = v[2];
  v[1] = s.cosine * y - s.sine * z;
  v[2] = s.sine * y + s.cosine * z;
  if (s.aslant) turn_into_track(s.direction, v);
}

double power_of(const WheelWork& w, std::int32_t k, double speed) {
  return -speed * (w.fx[k] * w.slip_x[k] + w.fy[k] * w.slip_y[k] + w.mz[k] * w.spin[k]);
}

namespace {

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

/// The region that strips are being added to: in rail axes, moments about the wheel's reference point, places
/// and creepages times load, until it is closed.
struct OpenRegion {
  SurfaceRegion* region = nullptr;
  double normal[2] = {};  ///< resultant of the pressure, along y and z [N]
  double load = 0.0;      ///< sum of the strips' normal forces [N]
};

/// Completes a region and adds it to the sums over all; nothing if none is open.
void close(const WheelOnRail& in, const RelativeMotion& seen, OpenRegion& open, Wrench& out) {
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

/// Adds the k-th strip in contact to the region it belongs to.
void add_strip(const WheelWork& w, std::int32_t k, double speed, OpenRegion& open, Wrench& out) {
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

}  // namespace

Fault sum_up(const WheelOnRail& in, const RelativeMotion& seen, std::int32_t count, double speed,
             const WheelWork& w, Wrench& out) {
  Fault fault;
  OpenRegion open;
  std::int32_t last_strip = -2;
  for (std::int32_t k = 0; k < count; ++k) {
    const std::int32_t strip = w.overlaps.strip[w.candidate[k]];
    if (open.region == nullptr || strip != last_strip + 1) {
      if (out.regions < most_surface_regions) {
        close(in, seen, open, out);
        open.region = &out.region[out.regions++];
        *open.region = {};
        open.region->first = strip;
      } else {
        keep_worst(fault, Fault::more_patches());
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

}  // namespace wrc
