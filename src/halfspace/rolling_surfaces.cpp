#include "halfspace/rolling_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace wrc::halfspace {
namespace {

using Vector3 = Vec3<double>;

Vector3 operator*(double f, const Vector3& a) { return {f * a.x, f * a.y, f * a.z}; }
Vector3 unit(const Vector3& a) { return 1.0 / std::sqrt(dot(a, a)) * a; }

Vector3 to_wheel(const double (&r)[3][3], const Vector3& t) {
  return {r[0][0] * t.x + r[1][0] * t.y + r[2][0] * t.z, r[0][1] * t.x + r[1][1] * t.y + r[2][1] * t.z,
          r[0][2] * t.x + r[1][2] * t.y + r[2][2] * t.z};
}

Vector3 to_track(const double (&r)[3][3], const Vector3& w) {
  return {r[0][0] * w.x + r[0][1] * w.y + r[0][2] * w.z, r[1][0] * w.x + r[1][1] * w.y + r[1][2] * w.z,
          r[2][0] * w.x + r[2][1] * w.y + r[2][2] * w.z};
}

Vector3 normal_of(const SurfaceRow& row) {
  const SineCosine turned = sine_cosine(row.angle);
  return {0.0, -turned.sine, turned.cosine};
}

}  // namespace

// In the plane across the axle, the wheel's place is (distance, -height) along x and the rail's z; turned, it
// is (0, -root of the squares).
TurnedAboveAxle::TurnedAboveAxle(const WheelAndRail& bodies, surface::WheelOnRail& state) {
  if (bodies.roller_curvature == 0.0 || state.distance == 0.0) return;
  surface::WheelMotion& wheel = state.wheel;
  surface::RailMotion& rail = state.rail;
  const SineCosine rolled = sine_cosine(rail.roll);
  down_y_ = -rolled.sine;
  down_z_ = rolled.cosine;
  // wheel from the origin of the rail's profile; height above the roller's axle along the rail's own vertical
  const double y = wheel.position[1] - (bodies.rail_y + rail.y),
               z = wheel.position[2] - (bodies.rail_z + rail.z);
  // the turn that brings (distance, -height) to (0, -apart)
  const double height = 1.0 / bodies.roller_curvature - (y * down_y_ + z * down_z_);
  const double apart = std::sqrt(height * height + state.distance * state.distance);
  sine_ = state.distance / apart;
  cosine_ = height / apart;
  // Only the wheel's motion relative to the rail matters.
  wheel.velocity[1] -= rail.velocity_y - rail.velocity_roll * z;
  wheel.velocity[2] -= rail.velocity_z + rail.velocity_roll * y;
  wheel.angular_velocity[0] -= rail.velocity_roll;
  rail.velocity_y = rail.velocity_z = rail.velocity_roll = 0.0;
  wheel.position[1] -= (apart - height) * down_y_;
  wheel.position[2] -= (apart - height) * down_z_;
  state.distance = 0.0;
  // place, velocities and axes of the wheel, turned with it
  turn(sine_, wheel.velocity);
  turn(sine_, wheel.angular_velocity);
  for (int k = 0; k < 3; ++k) {
    double axis[3] = {wheel.rotation[0][k], wheel.rotation[1][k], wheel.rotation[2][k]};
    turn(sine_, axis);
    for (int i = 0; i < 3; ++i) wheel.rotation[i][k] = axis[i];
  }
}

void TurnedAboveAxle::turn(double sine, double (&v)[3]) const {
  // v' = v turned in the plane of x and the rail's vertical; components across it stay
  const double x = v[0], down = v[1] * down_y_ + v[2] * down_z_;
  const double more = (cosine_ - 1.0) * down - sine * x;
  v[0] = cosine_ * x + sine * down;
  v[1] += more * down_y_;
  v[2] += more * down_z_;
}

void TurnedAboveAxle::turn_back(double (&v)[3]) const { turn(-sine_, v); }

SeenAlongRail::SeenAlongRail(const WheelAndRail& bodies, surface::WheelOnRail& state) {
  surface::WheelMotion& wheel = state.wheel;
  surface::RailMotion& rail = state.rail;
  aslant_ = rail.slope_y != 0.0 || rail.slope_z != 0.0;
  if (!aslant_) return;
  direction_ = surface::direction_of(rail.slope_y, rail.slope_z);
  rail.slope_y = rail.slope_z = 0.0;
  // place about the displaced origin of the rail's profile; vectors as they are
  const double origin[3] = {0.0, bodies.rail_y + rail.y, bodies.rail_z + rail.z};
  // Only the wheel's motion relative to the rail matters.
  wheel.velocity[1] -= rail.velocity_y;
  wheel.velocity[2] -= rail.velocity_z;
  rail.velocity_y = rail.velocity_z = 0.0;
  for (int i = 0; i < 3; ++i) wheel.position[i] -= origin[i];
  for (double* const v : {wheel.position, wheel.velocity, wheel.angular_velocity})
    surface::turn_along_rail(direction_, v);
  for (int i = 0; i < 3; ++i) wheel.position[i] += origin[i];
  for (int k = 0; k < 3; ++k) {
    double axis[3] = {wheel.rotation[0][k], wheel.rotation[1][k], wheel.rotation[2][k]};
    surface::turn_along_rail(direction_, axis);
    for (int i = 0; i < 3; ++i) wheel.rotation[i][k] = axis[i];
  }
}

void SeenAlongRail::turn_back(double (&v)[3]) const {
  if (aslant_) surface::turn_into_track(direction_, v);
}

RollingSurfaces::RollingSurfaces(const WheelAndRail& bodies, const RailSurface& surface,
                                 const surface::WheelOnRail& state)
    : bodies_(bodies),
      surface_(surface),
      wheel_(state.wheel),
      rail_(state.rail),
      roll_(sine_cosine(state.rail.roll)) {
  if (bodies.out_of_round != nullptr) deviation_.emplace(*bodies.out_of_round, state.angle);
}

RailFall RollingSurfaces::fall(const SurfaceRow& row, double x) const {
  // a roller: a circle about its axle, down = R - root(R^2 - x^2)
  if (row.radius > 0.0) {
    const double above = std::sqrt(row.radius * row.radius - x * x), down = row.radius - above,
                 slope = x / above;
    return {-roll_.sine * down, roll_.cosine * down, -roll_.sine * slope, roll_.cosine * slope};
  }
  if (surface_.varying == nullptr) return {};
  const surface::VaryingRail& varying = *surface_.varying;
  const surface::RailFace& face = varying.face[surface::face_of(varying, row.strip)];
  // a rail that varies: displacement of the four strips beside the row from the wheel's section to that at
  // x, by the row's weights, turned by the rail's roll
  const double from = surface_.distance, to = from + x;
  const surface::SectionBlend at_from = surface::blend_at(varying, face, from),
                              at_to = surface::blend_at(varying, face, to, at_from);
  double y = 0.0, z = 0.0, slope_y = 0.0, slope_z = 0.0;
  for (std::int32_t k = 0; k < 4; ++k) {
    const auto here = surface::strip_at(varying, at_from, row.strip + k, from);
    const auto there = surface::strip_at(varying, at_to, row.strip + k, to);
    y += row.weight[k] * (there.y - here.y);
    z += row.weight[k] * (there.z - here.z);
    slope_y += row.weight[k] * there.slope_y;
    slope_z += row.weight[k] * there.slope_z;
  }
  return {roll_.cosine * y - roll_.sine * z, roll_.sine * y + roll_.cosine * z,
          roll_.cosine * slope_y - roll_.sine * slope_z, roll_.sine * slope_y + roll_.cosine * slope_z};
}

double RollingSurfaces::rail_angle(const SurfaceRow& row, double s, double x) const {
  if (surface_.varying == nullptr) {
    const SectionCurve::Point p = surface_.section.at(s);
    return arctangent2(p.dz, p.dy) + rail_.roll;
  }
  const surface::VaryingRail& varying = *surface_.varying;
  // mean tangent of the four strips beside the row
  const double distance = surface_.distance + x;
  const surface::SectionBlend blend =
      surface::blend_at(varying, varying.face[surface::face_of(varying, row.strip)], distance);
  double along_y = 0.0, along_z = 0.0;
  for (std::int32_t k = 0; k < 4; ++k) {
    double ty, tz;
    surface::tangent_at(varying, blend, row.strip + k, distance, ty, tz);
    along_y += row.weight[k] * ty;
    along_z += row.weight[k] * tz;
  }
  return arctangent2(along_z, along_y) + rail_.roll;
}

// The ray q(t) = P - t n in wheel axes meets the surface of revolution where
//     q_y - Y(s) = 0,  sqrt(q_x^2 + q_z^2) - (r0 + Z(s) + d) = 0:
// Newton's method over t and s, in steps of at most a millimetre; the deviation d of a wheel that is not
// round hardly changes along the ray.
SurfacePoint RollingSurfaces::point(const SurfaceRow& row, double x, double wheel_s) const {
  constexpr int cap = 100;
  constexpr double longest_step = 1e-3, tolerance = 1e-13;
  constexpr double farthest = 0.02;     // beyond it a ray meets another face of the wheel [m]
  constexpr double least_cosine = 0.1;  // cosine of the angle between the ray and the wheel's normal
  // start of the ray on the rail's surface, and its direction up the normal, in wheel axes
  const Vector3 n = normal_of(row);
  SurfacePoint found{.wheel_s = std::clamp(wheel_s, 0.0, bodies_.wheel.length()), .fall = fall(row, x)};
  const Vector3 start = to_wheel(wheel_.rotation, Vector3{x, row.y + found.fall.y - wheel_.position[1],
                                                          row.z + found.fall.z - wheel_.position[2]});
  const Vector3 ray = to_wheel(wheel_.rotation, -1.0 * n);
  for (int k = 0; k < cap; ++k) {
    // residuals e1 = q_y - Y, e2 = r - (r0 + Z + d) at the present gap and s
    const SectionCurve::Point p = bodies_.wheel.at(found.wheel_s);
    const Vector3 q = start + found.gap * ray;
    const double radius = std::sqrt(q.x * q.x + q.z * q.z);
    const WheelDeviation::Value more =
        deviation_ ? deviation_->at(p.y, arctangent2(q.x, q.z)) : WheelDeviation::Value{};
    const double e1 = q.y - p.y, e2 = radius - (bodies_.nominal_radius + p.z + more.depth);
    const double ray_r = (q.x * ray.x + q.z * ray.z) / radius;
    // Outward normal of the profile (-dz, dy) in (y, radius); cosine < 0 where the ray goes into the wheel.
    const double cosine = -p.dz * ray.y + p.dy * ray_r;
    // outward normal of the surface of revolution; a radius that changes with the angle leans it along the
    // circumference by d' / r
    Vector3 outwards{p.dy * q.x / radius, -p.dz, p.dy * q.z / radius};
    if (deviation_) {
      const double turn = more.slope / radius;
      outwards = unit(outwards - p.dy * turn / radius * Vector3{q.z, 0.0, -q.x});
    }
    const Vector3 normal = to_track(wheel_.rotation, outwards);
    found.normal[0] = normal.x;
    found.normal[1] = normal.y;
    found.normal[2] = normal.z;
    if (cosine > -least_cosine) return found;
    // Newton's step of gap and s; both shortened where s would go further than a millimetre
    const double gap_step = (p.dz * e1 - p.dy * e2) / cosine;
    const double s_step = (e1 + gap_step * ray.y) * p.dy + (e2 + gap_step * ray_r) * p.dz;
    // shorter where s would move too far
    const double factor = longest_step / std::max(longest_step, std::abs(s_step));
    // off the profile's ends there is no wheel to meet
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
  // the ray in wheel axes, and its direction into the wheel
  constexpr double spacing = 2e-4;
  const Vector3 n = normal_of(row);
  const RailFall fallen = fall(row, x);
  const Vector3 start = to_wheel(wheel_.rotation, Vector3{x, row.y + fallen.y - wheel_.position[1],
                                                          row.z + fallen.z - wheel_.position[2]});
  const Vector3 normal = to_wheel(wheel_.rotation, n);
  // In the plane of the axle through the point: the profile's point nearest to the ray among those that face
  // it.
  // squared distance from the ray, and a hundredth of that along it, so that of two crossings the nearer wins
  double nearest = -1.0, best = 0.0;
  const auto places = static_cast<int>(bodies_.wheel.length() / spacing);
  for (int k = 0; k <= places; ++k) {
    const double s = spacing * k;
    const SectionCurve::Point p = bodies_.wheel.at(s);
    if (-p.dz * normal.y + p.dy * normal.z < 0.2) continue;
    const double r = bodies_.nominal_radius + p.z;
    // from the ray's start to the profile's point, in the plane of the axle through the start
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

double RollingSurfaces::gap_slope(const SurfaceRow& row, const SurfacePoint& at) const {
  // dh/dx = (n_x + n . dr/dx) / (n . e_n) of the wheel's normal n, where the rail falls by dr/dx
  const Vector3 n = normal_of(row);
  const double facing = at.normal[1] * n.y + at.normal[2] * n.z;
  return (at.normal[0] + (at.normal[1] * at.fall.slope_y + at.normal[2] * at.fall.slope_z)) / facing;
}

// The wheel is nearest below its axle, unless the rail changes along the track or the wheel's profile ends
// there: then in one of the gap's valleys, of which a ramp ahead makes one beside that below the axle.
SurfacePoint RollingSurfaces::nearest_place(SurfaceRow& row) const {
  constexpr int side = 24, whole_search = 4;  // places a side; each fourth is searched on the whole profile
  constexpr double apart = 5e-3;              // [m]
  SurfacePoint middle = there(0.0) ? point(row, 0.0) : SurfacePoint{};
  if (middle.found && !varies()) return middle;
  // the wheel at places along the row, outwards, as neighbours start each other's search
  SurfacePoint places[2 * side + 1];
  places[side] = middle;
  for (const int direction : {1, -1}) {
    for (int k = 1; k <= side; ++k) {
      const double x = direction * k * apart;
      const SurfacePoint& before = places[side + direction * (k - 1)];
      SurfacePoint& here = places[side + direction * k];
      if (!there(x)) continue;
      if (before.found) here = point(row, x, before.wheel_s);
      if (!here.found && k % whole_search == 0) here = point(row, x);
    }
  }
  // the deepest of the valleys between them; of two alike, that behind
  SurfacePoint nearest;
  const SurfaceRow as_it_is = row;
  const auto gap = [&](int k) { return k >= 0 && k <= 2 * side && places[k].found ? places[k].gap : 1.0; };
  for (int k = 0; k <= 2 * side; ++k) {
    if (!places[k].found || gap(k - 1) < gap(k) || gap(k + 1) <= gap(k)) continue;
    SurfaceRow valley = as_it_is;
    SurfacePoint at = places[k];
    valley.middle = (k - side) * apart;
    find_middle(valley, at);
    if (!at.found || (nearest.found && at.gap >= nearest.gap)) continue;
    row = valley;
    nearest = at;
  }
  return nearest;
}

void RollingSurfaces::find_middle(SurfaceRow& row, SurfacePoint& at) const {
  // the slope of the gap jumps on a flat and at a rail's corner, which secants do not survive
  if (deviation_ || varies()) {
    halve_to_middle(row, at);
  } else {
    roll_to_middle(row, at);
  }
}

// The gap is smallest where the wheel's normal has no part along the rail: Newton's method with the wheel's
// radius as first guess of the curvature, secants after.
void RollingSurfaces::roll_to_middle(SurfaceRow& row, SurfacePoint& at) const {
  constexpr int steps = 8;
  double before = 0.0, slope_before = 0.0;
  for (int k = 0; k < steps && at.found; ++k) {
    const Vector3 n = normal_of(row);
    const double facing = at.normal[1] * n.y + at.normal[2] * n.z;
    // 1 / curvature of the gap along x: the wheel's radius over its facing part, and the roller's
    const double slope = gap_slope(row, at);
    const double by_roller = row.radius > 0.0 ? bodies_.nominal_radius / row.radius : 0.0;
    const double by_radius = bodies_.nominal_radius * facing / (1.0 + by_roller);
    // secant where it is near that, the guess otherwise
    const double change = slope - slope_before;
    const double secant = change != 0.0 ? (row.middle - before) / change : 0.0;
    const double radius = k > 0 && secant > 0.2 * by_radius && secant < 5.0 * by_radius ? secant : by_radius;
    before = row.middle;
    slope_before = slope;
    // to where the slope vanishes, by 5 mm at most, or to the face's end
    row.middle = on_face(row.middle + std::clamp(-slope * radius, -5e-3, 5e-3));
    at = point(row, row.middle, at.wheel_s);
    if (std::abs(row.middle - before) < 1e-7) break;
  }
}

void RollingSurfaces::halve_to_middle(SurfaceRow& row, SurfacePoint& at) const {
  constexpr double farthest = 0.1, near_enough = 1e-7;  // [m]
  const double direction = gap_slope(row, at) > 0.0 ? -1.0 : 1.0;
  // doubled steps downhill until the slope changes its sign, then halves
  double known = row.middle, step = 1e-3;  // the middle lies beyond `known`, by a step at most at last
  for (; at.found && direction * gap_slope(row, at) < 0.0 && step < farthest; step *= 2.0) {
    known = row.middle;
    row.middle = on_face(row.middle + direction * step);
    at = point(row, row.middle, at.wheel_s);
  }
  double beyond = row.middle;
  while (at.found && std::abs(beyond - known) > near_enough) {
    row.middle = 0.5 * (known + beyond);
    at = point(row, row.middle, at.wheel_s);
    (direction * gap_slope(row, at) < 0.0 ? known : beyond) = row.middle;
  }
}

SurfaceRow RollingSurfaces::row(double s, RowNormals normals, bool& found) const {
  const SectionCurve::Point p = surface_.section.at(s);
  // place of the section's point under the rail's displacement and roll
  SurfaceRow row{.y = bodies_.rail_y + rail_.y + roll_.cosine * p.y - roll_.sine * p.z,
                 .z = bodies_.rail_z + rail_.z + roll_.sine * p.y + roll_.cosine * p.z};
  if (bodies_.roller_curvature != 0.0) {
    constexpr double least_radius = 0.02;  // [m]: of faces that no wheel reaches
    row.radius = std::max(1.0 / bodies_.roller_curvature - p.z, least_radius);
  }
  if (surface_.varying != nullptr) {  // Lagrange's cubic through the strips beside it
    // the four knots around s and their weights, L_k = prod over l != k of (s - s_l) / (s_k - s_l)
    const std::vector<double>& places = surface_.section.places();
    const auto above = std::upper_bound(places.begin(), places.end(), s) - places.begin();
    const auto first =
        std::clamp<std::ptrdiff_t>(above - 2, 0, static_cast<std::ptrdiff_t>(places.size()) - 4);
    row.strip = surface_.first + static_cast<std::int32_t>(first);
    const double* const place = places.data() + first;
    for (int k = 0; k < 4; ++k) {
      row.weight[k] = 1.0;
      for (int l = 0; l < 4; ++l)
        if (l != k) row.weight[k] *= (s - place[l]) / (place[k] - place[l]);
    }
  }
  // the rail's own normal first; where the wheel is nearest along it is the row's middle
  double on_rail = rail_angle(row, s, 0.0);
  row.angle = on_rail;
  SurfacePoint at = nearest_place(row);
  constexpr int rounds = 4;
  for (int round = 0; round < rounds && at.found; ++round) {
    find_middle(row, at);
    if (normals == RowNormals::rail || !at.found) break;
    if (surface_.varying != nullptr) on_rail = rail_angle(row, s, row.middle);
    // Where the surfaces part at a large angle they do not touch: there the rail's normal will do.
    // halfway between the wheel's normal angle and the rail's, whose middle moves with it: four rounds, or
    // until it rests
    constexpr double largest_turn = 0.25;
    const double wheel_angle = arctangent2(-at.normal[1], at.normal[2]);
    const double turn = std::clamp(0.5 * (wheel_angle - on_rail), -largest_turn, largest_turn);
    const bool settled = std::abs(on_rail + turn - row.angle) < 1e-9;
    row.angle = on_rail + turn;
    if (settled) break;
    at = point(row, row.middle, at.wheel_s);
  }
  found = at.found;
  const Vector3 n = normal_of(row);
  row.grade = n.y * at.fall.slope_y + n.z * at.fall.slope_z;
  // at the end of a face and on a corner along the track the wheel's lean: it rolls over an edge that rests
  if (varies() && found) row.grade -= gap_slope(row, at);
  return row;
}

RollingSurfaces::Motion RollingSurfaces::motion(const SurfaceRow& row, double x,
                                                const SurfacePoint& at) const {
  const Vector3 n = normal_of(row);
  // velocity of the wheel's surface point: v + omega x arm
  const Vector3 rail_point{x, row.y + at.fall.y, row.z + at.fall.z};
  const Vector3 wheel_point = rail_point - at.gap * n;
  const Vector3 arm = wheel_point - Vector3{0.0, wheel_.position[1], wheel_.position[2]};
  const Vector3 turning{wheel_.angular_velocity[0], wheel_.angular_velocity[1], wheel_.angular_velocity[2]};
  const Vector3 wheel_velocity =
      Vector3{wheel_.velocity[0], wheel_.velocity[1], wheel_.velocity[2]} + cross(turning, arm);
  // velocity of the rail's: of its origin, its roll, and a roller's turning
  const double rail_arm_y = rail_point.y - (bodies_.rail_y + rail_.y),
               rail_arm_z = rail_point.z - (bodies_.rail_z + rail_.z);
  Vector3 rail_velocity{0.0, rail_.velocity_y - rail_.velocity_roll * rail_arm_z,
                        rail_.velocity_z + rail_.velocity_roll * rail_arm_y};
  if (row.radius > 0.0) {  // about the axle, which lies at x = 0
    // v = omega x r of the roller's surface
    const double from_axle = std::sqrt(row.radius * row.radius - x * x);
    rail_velocity = rail_velocity + rail_.turning * Vector3{-from_axle, x * roll_.sine, -x * roll_.cosine};
  }
  const Vector3 velocity = wheel_velocity - rail_velocity;
  // Row's normal n is (at the row's middle) the mean of both already; along x the wheel's share is half its
  // own.
  const Vector3 wheel_normal{at.normal[0], at.normal[1], at.normal[2]};
  const double rail_x = -(at.fall.slope_y * n.y + at.fall.slope_z * n.z);
  const Vector3 across = unit(n + Vector3{0.5 * (wheel_normal.x / dot(wheel_normal, n) + rail_x), 0.0, 0.0});
  return {velocity, across};
}

double RollingSurfaces::approach(const SurfaceRow& row, double x, const SurfacePoint& at) const {
  const auto [velocity, across] = motion(row, x, at);
  return dot(velocity, across);
}

void RollingSurfaces::sliding(const SurfaceRow& row, double x, const SurfacePoint& at, double& along_x,
                              double& along_row) const {
  const auto [velocity, across] = motion(row, x, at);
  // axes of the plane across the mean normal: x's projection, and the row's tangent
  const Vector3 e_x = unit(Vector3{1.0, 0.0, 0.0} - across.x * across);
  along_x = dot(velocity, e_x);
  along_row = dot(velocity, cross(across, e_x));
}

}  // namespace wrc::halfspace
