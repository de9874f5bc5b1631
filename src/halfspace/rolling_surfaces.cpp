#include "halfspace/rolling_surfaces.hpp"

#include <algorithm>
#include <cmath>

namespace wrc::halfspace {
namespace {

struct Vector3 {
  double x = 0.0, y = 0.0, z = 0.0;
};

Vector3 operator+(const Vector3& a, const Vector3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector3 operator-(const Vector3& a, const Vector3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector3 operator*(double f, const Vector3& a) { return {f * a.x, f * a.y, f * a.z}; }
double dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vector3 unit(const Vector3& a) { return 1.0 / std::sqrt(dot(a, a)) * a; }

Vector3 to_wheel(const double (&r)[3][3], const Vector3& t) {
  return {r[0][0] * t.x + r[1][0] * t.y + r[2][0] * t.z, r[0][1] * t.x + r[1][1] * t.y + r[2][1] * t.z,
          r[0][2] * t.x + r[1][2] * t.y + r[2][2] * t.z};
}

Vector3 to_track(const double (&r)[3][3], const Vector3& w) {
  return {r[0][0] * w.x + r[0][1] * w.y + r[0][2] * w.z, r[1][0] * w.x + r[1][1] * w.y + r[1][2] * w.z,
          r[2][0] * w.x + r[2][1] * w.y + r[2][2] * w.z};
}

Vector3 normal_of(const SurfaceRow& row) { return {0.0, -std::sin(row.angle), std::cos(row.angle)}; }

}  // namespace

// In the plane across the axle, the wheel's place is (distance, -height) along x and the rail's z; turned, it
// is (0, -root of the squares).
TurnedAboveAxle::TurnedAboveAxle(const WheelAndRail& bodies, WheelOnRail& state) {
  if (bodies.roller_curvature == 0.0 || state.distance == 0.0) return;
  WheelMotion& wheel = state.wheel;
  RailMotion& rail = state.rail;
  down_y_ = -std::sin(rail.roll);
  down_z_ = std::cos(rail.roll);
  const double y = wheel.position[1] - (bodies.rail_y + rail.y),
               z = wheel.position[2] - (bodies.rail_z + rail.z);
  const double height = 1.0 / bodies.roller_curvature - (y * down_y_ + z * down_z_);
  const double apart = std::sqrt(height * height + state.distance * state.distance);
  sine_ = state.distance / apart;
  cosine_ = height / apart;
  // Only what the wheel does beside the rail matters.
  wheel.velocity[1] -= rail.velocity_y - rail.velocity_roll * z;
  wheel.velocity[2] -= rail.velocity_z + rail.velocity_roll * y;
  wheel.angular_velocity[0] -= rail.velocity_roll;
  rail.velocity_y = rail.velocity_z = rail.velocity_roll = 0.0;
  wheel.position[1] -= (apart - height) * down_y_;
  wheel.position[2] -= (apart - height) * down_z_;
  state.distance = 0.0;
  turn(sine_, wheel.velocity);
  turn(sine_, wheel.angular_velocity);
  for (int k = 0; k < 3; ++k) {
    double axis[3] = {wheel.rotation[0][k], wheel.rotation[1][k], wheel.rotation[2][k]};
    turn(sine_, axis);
    for (int i = 0; i < 3; ++i) wheel.rotation[i][k] = axis[i];
  }
}

void TurnedAboveAxle::turn(double sine, double (&v)[3]) const {
  const double x = v[0], down = v[1] * down_y_ + v[2] * down_z_;
  const double more = (cosine_ - 1.0) * down - sine * x;
  v[0] = cosine_ * x + sine * down;
  v[1] += more * down_y_;
  v[2] += more * down_z_;
}

void TurnedAboveAxle::turn_back(double (&v)[3]) const { turn(-sine_, v); }

RollingSurfaces::RollingSurfaces(const WheelAndRail& bodies, const WheelMotion& wheel, const RailMotion& rail)
    : bodies_(bodies), wheel_(wheel), rail_(rail) {}

// The ray q(t) = P - t n in wheel axes meets the surface of revolution where
//     q_y - Y(s) = 0,  sqrt(q_x^2 + q_z^2) - (r0 + Z(s)) = 0:
// Newton's method over t and s, in steps of at most a millimetre.
SurfacePoint RollingSurfaces::point(const SurfaceRow& row, double x, double wheel_s) const {
  constexpr int cap = 100;
  constexpr double longest_step = 1e-3, tolerance = 1e-13;
  constexpr double farthest = 0.02;     // beyond it a ray meets another face of the wheel [m]
  constexpr double least_cosine = 0.1;  // of the angle between the ray and the wheel's normal
  const Vector3 n = normal_of(row);
  const double fall = row.fall(x);
  const Vector3 start = to_wheel(wheel_.rotation, Vector3{x, row.y + fall * down_y() - wheel_.position[1],
                                                          row.z + fall * down_z() - wheel_.position[2]});
  const Vector3 ray = to_wheel(wheel_.rotation, -1.0 * n);
  SurfacePoint found{.wheel_s = std::clamp(wheel_s, 0.0, bodies_.wheel.length())};
  for (int k = 0; k < cap; ++k) {
    const SectionCurve::Point p = bodies_.wheel.at(found.wheel_s);
    const Vector3 q = start + found.gap * ray;
    const double radius = std::sqrt(q.x * q.x + q.z * q.z);
    const double e1 = q.y - p.y, e2 = radius - (bodies_.nominal_radius + p.z);
    const double ray_r = (q.x * ray.x + q.z * ray.z) / radius;
    // Outward normal of the profile (-dz, dy) in (y, radius); cosine < 0 where the ray goes into the wheel.
    const double cosine = -p.dz * ray.y + p.dy * ray_r;
    const Vector3 normal = to_track(wheel_.rotation, {p.dy * q.x / radius, -p.dz, p.dy * q.z / radius});
    found.normal[0] = normal.x;
    found.normal[1] = normal.y;
    found.normal[2] = normal.z;
    if (cosine > -least_cosine) return found;
    const double gap_step = (p.dz * e1 - p.dy * e2) / cosine;
    const double s_step = (e1 + gap_step * ray.y) * p.dy + (e2 + gap_step * ray_r) * p.dz;
    const double factor = longest_step / std::max(longest_step, std::abs(s_step));
    found.gap += factor * gap_step;
    found.wheel_s += factor * s_step;
    if (found.wheel_s < 0.0 || found.wheel_s > bodies_.wheel.length()) return found;
    if (std::abs(gap_step) + std::abs(s_step) <= tolerance) {
      found.found = std::abs(found.gap) < farthest;
      return found;
    }
  }
  // On a corner of the profile two steps may alternate: as near as the tolerance of a gap.
  return found;
}

SurfacePoint RollingSurfaces::point(const SurfaceRow& row, double x) const {
  constexpr double spacing = 2e-4;
  const Vector3 n = normal_of(row);
  const double fall = row.fall(x);
  const Vector3 start = to_wheel(wheel_.rotation, Vector3{x, row.y + fall * down_y() - wheel_.position[1],
                                                          row.z + fall * down_z() - wheel_.position[2]});
  const Vector3 normal = to_wheel(wheel_.rotation, n);
  // In the plane of the axle through the point: the profile's point nearest to the ray among those that face
  // it.
  double nearest = -1.0, best = 0.0;
  const auto places = static_cast<int>(bodies_.wheel.length() / spacing);
  for (int k = 0; k <= places; ++k) {
    const double s = spacing * k;
    const SectionCurve::Point p = bodies_.wheel.at(s);
    if (-p.dz * normal.y + p.dy * normal.z < 0.2) continue;
    const double r = bodies_.nominal_radius + p.z;
    const Vector3 to{0.0, p.y - start.y, std::sqrt(std::max(r * r - start.x * start.x, 0.0)) - start.z};
    const double along = dot(to, normal);
    const Vector3 off = to - along * normal;
    const double distance = dot(off, off) + 1e-2 * along * along;
    if (nearest < 0.0 || distance < best) {
      nearest = s;
      best = distance;
    }
  }
  if (nearest < 0.0) return {};
  return point(row, x, nearest);
}

SurfaceRow RollingSurfaces::row(double s, RowNormals normals, bool& found) const {
  const SectionCurve::Point p = bodies_.rail.at(s);
  const double c = std::cos(rail_.roll), sn = std::sin(rail_.roll);
  SurfaceRow row{.y = bodies_.rail_y + rail_.y + c * p.y - sn * p.z,
                 .z = bodies_.rail_z + rail_.z + sn * p.y + c * p.z};
  if (bodies_.roller_curvature != 0.0) {
    constexpr double least_radius = 0.02;  // [m]: of faces that no wheel reaches
    row.radius = std::max(1.0 / bodies_.roller_curvature - p.z, least_radius);
  }
  const double rail_angle = std::atan2(p.dz, p.dy) + rail_.roll;
  row.angle = rail_angle;
  SurfacePoint at = point(row, 0.0);
  // The gap is smallest where the wheel's normal has no part along x: Newton's method with the wheel's radius
  // as first guess of the curvature, secants after.
  constexpr int rounds = 4, steps = 8;
  for (int round = 0; round < rounds && at.found; ++round) {
    double before = 0.0, slope_before = 0.0;
    for (int k = 0; k < steps && at.found; ++k) {
      const Vector3 n = normal_of(row);
      const double facing = at.normal[1] * n.y + at.normal[2] * n.z;
      const double falling = row.fall_slope(row.middle);
      const double slope = (at.normal[0] + falling * (at.normal[1] * down_y() + at.normal[2] * down_z())) /
                           facing;  // d gap / dx
      const double by_roller = row.radius > 0.0 ? bodies_.nominal_radius / row.radius : 0.0;
      const double by_radius = bodies_.nominal_radius * facing / (1.0 + by_roller);
      const double change = slope - slope_before;
      const double secant = change != 0.0 ? (row.middle - before) / change : 0.0;
      const double radius =
          k > 0 && secant > 0.2 * by_radius && secant < 5.0 * by_radius ? secant : by_radius;
      before = row.middle;
      slope_before = slope;
      const double step = std::clamp(-slope * radius, -5e-3, 5e-3);
      row.middle += step;
      at = point(row, row.middle, at.wheel_s);
      if (std::abs(step) < 1e-7) break;
    }
    if (normals == RowNormals::rail || !at.found) break;
    // Where the surfaces part at a large angle they do not touch: there the rail's normal will do.
    constexpr double largest_turn = 0.25;
    const double wheel_angle = std::atan2(-at.normal[1], at.normal[2]);
    const double turn = std::clamp(0.5 * (wheel_angle - rail_angle), -largest_turn, largest_turn);
    const bool settled = std::abs(rail_angle + turn - row.angle) < 1e-9;
    row.angle = rail_angle + turn;
    if (settled) break;
    at = point(row, row.middle, at.wheel_s);
  }
  found = at.found;
  const Vector3 n = normal_of(row);
  row.lean = row.fall_slope(row.middle) * (n.y * down_y() + n.z * down_z());
  return row;
}

void RollingSurfaces::motion(const SurfaceRow& row, double x, const SurfacePoint& at, double (&moving)[3],
                             double (&normal)[3]) const {
  const Vector3 n = normal_of(row);
  const double fall = row.fall(x);
  const Vector3 rail_point{x, row.y + fall * down_y(), row.z + fall * down_z()};
  const Vector3 wheel_point = rail_point - at.gap * n;
  const Vector3 arm = wheel_point - Vector3{0.0, wheel_.position[1], wheel_.position[2]};
  const Vector3 turning{wheel_.angular_velocity[0], wheel_.angular_velocity[1], wheel_.angular_velocity[2]};
  const Vector3 wheel_velocity =
      Vector3{wheel_.velocity[0], wheel_.velocity[1], wheel_.velocity[2]} + cross(turning, arm);
  const double rail_arm_y = rail_point.y - (bodies_.rail_y + rail_.y),
               rail_arm_z = rail_point.z - (bodies_.rail_z + rail_.z);
  Vector3 rail_velocity{0.0, rail_.velocity_y - rail_.velocity_roll * rail_arm_z,
                        rail_.velocity_z + rail_.velocity_roll * rail_arm_y};
  if (row.radius > 0.0) {  // about the axle, which lies at x = 0
    const double from_axle = row.radius - fall;
    rail_velocity = rail_velocity + rail_.turning * Vector3{-from_axle, -x * down_y(), -x * down_z()};
  }
  const Vector3 velocity = wheel_velocity - rail_velocity;
  // Row's normal n is (at the row's middle) the mean of both already; along x the wheel's share is half its
  // own.
  const Vector3 wheel_normal{at.normal[0], at.normal[1], at.normal[2]};
  const double rail_x = -row.fall_slope(x) * (n.y * down_y() + n.z * down_z());
  const Vector3 across = unit(n + Vector3{0.5 * (wheel_normal.x / dot(wheel_normal, n) + rail_x), 0.0, 0.0});
  const Vector3* const from[] = {&velocity, &across};
  double* const to[] = {moving, normal};
  for (int k = 0; k < 2; ++k) {
    to[k][0] = from[k]->x;
    to[k][1] = from[k]->y;
    to[k][2] = from[k]->z;
  }
}

double RollingSurfaces::approach(const SurfaceRow& row, double x, const SurfacePoint& at) const {
  double v[3], n[3];
  motion(row, x, at, v, n);
  return v[0] * n[0] + v[1] * n[1] + v[2] * n[2];
}

void RollingSurfaces::sliding(const SurfaceRow& row, double x, const SurfacePoint& at, double& along_x,
                              double& along_row) const {
  double v[3], n[3];
  motion(row, x, at, v, n);
  const Vector3 velocity{v[0], v[1], v[2]}, across{n[0], n[1], n[2]};
  const Vector3 e_x = unit(Vector3{1.0, 0.0, 0.0} - across.x * across);
  along_x = dot(velocity, e_x);
  along_row = dot(velocity, cross(across, e_x));
}

}  // namespace wrc::halfspace
