/// The pair of bodies of the reference case, with their memory: S1002 on the benchmark UIC60, gauge 1435 mm.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "geometry/contact_search.hpp"
#include "geometry/placement.hpp"
#include "geometry/silhouette.hpp"
#include "geometry/standard_profiles.hpp"
#include "usual_dimensions.hpp"

namespace wrc {

/// Owns the memory of one profile.
struct ProfileStore {
  static constexpr std::int32_t capacity = 512;
  std::array<double, geometry::profile_doubles(capacity)> doubles;
  geometry::ProfileMemory memory() { return geometry::profile_memory(capacity, doubles.data()); }
};

/// Not copyable: rail and wheel point into the stores.
struct ReferenceBodies {
  ProfileStore rail_nodes, wheel_nodes, rail_placed, wheel_placed;
  geometry::Rail rail;
  geometry::Wheel wheel;

  explicit ReferenceBodies(geometry::Side side = geometry::Side::right) {
    geometry::Profile profile;
    geometry::sample_uic60_benchmark(rail_nodes.memory(), profile);
    geometry::place_rail(profile, usual_track(), side, rail_placed.memory(), rail);
    geometry::sample_s1002(wheel_nodes.memory(), profile);
    geometry::place_wheel(profile, usual_wheelset(), side, wheel_placed.memory(), wheel);
  }
  ReferenceBodies(const ReferenceBodies&) = delete;
  ReferenceBodies& operator=(const ReferenceBodies&) = delete;
};

/// Separation along the contact normal at (x, y) of the contact frame, from the rotated surface of revolution
/// itself: Newton over (s, theta) with the surface's own derivatives, unguarded.
inline double separation(const ReferenceBodies& bodies, const geometry::PosedWheel& wheel,
                         const geometry::ContactPoint& contact, double x, double y) {
  const auto& rot = wheel.attitude.r;
  double s = contact.wheel_s + y * contact.cosine, theta = 0.0, z_wheel = 0.0;
  const auto to_frame = [&](const double(&p)[3], double& fx, double& fy, double& fz) {
    double t[3];
    for (int i = 0; i < 3; ++i) t[i] = rot[i][0] * p[0] + rot[i][1] * p[1] + rot[i][2] * p[2];
    fx = t[0];
    fy = contact.cosine * t[1] + contact.sine * t[2];
    fz = contact.cosine * t[2] - contact.sine * t[1];
  };
  double cx, cy, cz;  // contact point seen from the wheelset's middle, wheel brought into touch
  const double dy = contact.y - wheel.centre_y;
  const double dz = contact.z - wheel.centre_z - contact.vertical_gap;
  cx = contact.x;
  cy = contact.cosine * dy + contact.sine * dz;
  cz = contact.cosine * dz - contact.sine * dy;
  for (int i = 0; i < 30; ++i) {
    const geometry::ProfilePoint w = geometry::evaluate(bodies.wheel.profile, s);
    const double r = bodies.wheel.nominal_radius + w.z, st = std::sin(theta), ct = std::cos(theta);
    const double p[3] = {r * st, s, r * ct}, by_s[3] = {w.slope * st, 1.0, w.slope * ct};
    const double by_theta[3] = {r * ct, 0.0, -r * st};
    double px, py, pz, sx, sy, sz, tx, ty, tz;
    to_frame(p, px, py, pz);
    to_frame(by_s, sx, sy, sz);
    to_frame(by_theta, tx, ty, tz);
    const double ex = x - (px - cx), ey = y - (py - cy), det = sx * ty - sy * tx;
    s += (ex * ty - ey * tx) / det;
    theta += (sx * ey - sy * ex) / det;
    z_wheel = pz - cz;
  }
  double rail_y = contact.y, z_rail = 0.0;
  for (int i = 0; i < 30; ++i) {
    const geometry::ProfilePoint w = geometry::evaluate(bodies.rail.profile, rail_y);
    const double ry = rail_y - contact.y, rz = w.z - contact.z;
    z_rail = contact.cosine * rz - contact.sine * ry;
    rail_y += (y - contact.cosine * ry - contact.sine * rz) / (contact.cosine + contact.sine * w.slope);
  }
  return z_rail - z_wheel;
}

}  // namespace wrc
