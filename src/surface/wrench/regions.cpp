#include "surface/wrench/regions.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "base/number.hpp"
#include "surface/wrench/strip_mechanics.hpp"

namespace wrc::surface {

namespace {

/// The region that strips are being added to: in rail axes, moments about the wheel's reference point, places
/// and creepages times load, until it is closed.
struct OpenRegion {
  SurfaceRegion* region = nullptr;
  double normal[2] = {};  ///< resultant of the pressure, along y and z [N]
  double load = 0.0;      ///< sum of the strips' normal forces [N]
};

/// Completes a region and adds it to the sums over all; nothing if none is open.
void close(const WheelOnRail& in, const RelativeMotion& motion, OpenRegion& open, Wrench& out) {
  if (!open.region) return;
  SurfaceRegion& r = *open.region;
  // means weighted by load
  for (double& c : r.point) c /= open.load;
  for (double& c : r.creepage) c /= open.load;

  // angle of the resultant (n_y, n_z) of length n: atan2(-n_y, n_z) = 2 atan(-n_y / (n_z + n))
  r.normal_force = std::sqrt(open.normal[0] * open.normal[0] + open.normal[1] * open.normal[1]);
  double direction[3] = {0.0, open.normal[0], open.normal[1]};
  into_track(motion, direction);
  r.angle = 2.0 * arctangent(-direction[1] / (direction[2] + r.normal_force + 1e-300));

  out.normal_force += r.normal_force;
  for (int c = 0; c < 3; ++c) {
    out.force[c] += r.force[c];
    out.moment[c] += r.moment[c];
  }
  // from the wheel's reference point to the region's own: M - r x F
  r.moment[0] -= r.point[1] * r.force[2] - r.point[2] * r.force[1];
  r.moment[1] -= r.point[2] * r.force[0] - r.point[0] * r.force[2];
  r.moment[2] -= r.point[0] * r.force[1] - r.point[1] * r.force[0];
  into_track(motion, r.force);
  into_track(motion, r.moment);
  into_track(motion, r.point);
  r.point[0] += in.wheel.position[0];
  r.point[1] += in.wheel.position[1];
  r.point[2] += out.height;
  open = {};
}

/// Adds the k-th strip in contact to the region it belongs to.
void add_strip(const WheelSolution& s, std::int32_t k, OpenRegion& open, Wrench& out) {
  SurfaceRegion& r = *open.region;
  const Overlaps& o = s.overlaps;
  const ContactStrips& strips = s.strips;
  const std::int32_t i = strips.candidate[k];
  r.count = o.strip[i] + 1 - r.first;

  // N = pi/2 w l p0, the area of a semi-ellipse times the width
  const double l = strips.half_length[k], x = strips.x[k];
  const double N = 0.5 * pi * strips.width[k] * l * strips.solved_peak[k];
  add_force(strip_of(o, i), x, o.grade != nullptr, {N, strips.fx[k], strips.fy[k], strips.mz[k]}, r.force,
            r.moment);

  // the resultant of the pressure alone has no part along x: a grade does not count in the region's angle
  open.normal[0] += N * o.ny[i];
  open.normal[1] += N * o.nz[i];
  open.load += N;
  r.point[0] += N * x;
  r.point[1] += N * o.wy[i];
  r.point[2] += N * o.wz[i];
  r.creepage[0] += N * strips.slip_x[k];
  r.creepage[1] += N * strips.slip_y[k];
  r.creepage[2] += N * strips.spin[k];

  // area and frictional power are sums, the peak pressure is the largest
  const double area = 2.0 * l * strips.width[k], power = strips.power[k];
  r.area += area;
  out.area += area;
  r.peak_pressure = std::max(r.peak_pressure, strips.solved_peak[k]);
  out.peak_pressure = std::max(out.peak_pressure, strips.solved_peak[k]);
  r.power += power;
  out.power += power;
}

}  // namespace

Fault sum_regions(const WheelOnRail& in, const WheelSolution& s, Wrench& out) {
  Fault fault;
  OpenRegion open;
  out.regions = 0;
  std::int32_t last_strip = -2;
  for (std::int32_t k = 0; k < s.strips.count; ++k) {
    const std::int32_t strip = s.overlaps.strip[s.strips.candidate[k]];
    // a gap between strips begins a region, while there are any left
    if (open.region == nullptr || strip != last_strip + 1) {
      if (out.regions < most_surface_regions) {
        close(in, s.motion, open, out);
        open.region = &out.region[out.regions++];
        *open.region = {};
        open.region->first = strip;
      } else {
        keep_worst(fault, Fault::more_patches());
      }
    }
    last_strip = strip;
    add_strip(s, k, open, out);
  }
  close(in, s.motion, open, out);
  into_track(s.motion, out.force);
  into_track(s.motion, out.moment);
  return fault;
}

}  // namespace wrc::surface
