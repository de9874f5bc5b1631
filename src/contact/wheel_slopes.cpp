/// Derivatives of a wheel on a rail: what the host's place and motion change of what the rail sees of the
/// wheel, and of the wrench's axes and reference point, in numbers that carry it.
#include "base/dual.hpp"
#include "base/elementary.hpp"
#include "contact/wheel.hpp"
#include "surface/geometry/rail_direction.hpp"

namespace wrc {
namespace {

/// Inputs whose derivatives are carried from the host to what the rail sees: those before the load, and
/// these.
enum Carried : std::size_t { slope_y = by_load, slope_z, roller_turning, friction, carried };
constexpr std::size_t column_of(std::size_t k) {
  constexpr std::size_t behind[] = {by_rail_slope_y, by_rail_slope_z, by_roller_velocity, by_friction};
  return k < by_load ? k : behind[k - by_load];
}

using Number = Dual<carried>;

/// a + b x c
void add_cross(Number* a, const Number* b, const Number* c) {
  a[0] += b[1] * c[2] - b[2] * c[1];
  a[1] += b[2] * c[0] - b[0] * c[2];
  a[2] += b[0] * c[1] - b[1] * c[0];
}

/// Change of a vector with an angle about an axis, of which it has the part `at` that turns.
void turn(Number* v, std::size_t input, const double (&axis)[3], const double* at) {
  v[0].d[input] += axis[1] * at[2] - axis[2] * at[1];
  v[1].d[input] += axis[2] * at[0] - axis[0] * at[2];
  v[2].d[input] += axis[0] * at[1] - axis[1] * at[0];
}

/// A vector turned about x from track into rail axes.
void into_rail(const Number& cosine, const Number& sine, const Number (&v)[3], Number (&turned)[3]) {
  turned[0] = v[0];
  turned[1] = cosine * v[1] + sine * v[2];
  turned[2] = cosine * v[2] - sine * v[1];
}

/// The host's numbers as src/surface has them: right-hand bodies.
struct Moving {
  Number arm[3];  ///< of the host, not mirrored
  Number position[3], axle[3], velocity[3], turning[3];
  Number rail_y, rail_z, rail_roll, rail_velocity_y, rail_velocity_z, rail_velocity_roll;
  RailDirection<Number> direction;
};

Moving moving(const HostWheel& hosted, const PlacedWheel& placed) {
  Moving m;
  const auto input = [](double value, std::size_t k) { return Number::input(value, k); };
  const auto& R = hosted.rotation;
  const double roll_axis[3] = {1.0, 0.0, 0.0}, yaw_axis[3] = {R[0][2], R[1][2], R[2][2]};
  for (int i = 0; i < 3; ++i) {
    m.axle[i] = R[i][1];
    m.arm[i] = placed.arm[i];
    m.turning[i] = hosted.angular_velocity[i];
    for (std::size_t k = 0; k < 3; ++k) m.turning[i].d[by_angular_velocity + k] = hosted.axes[i][k];
    m.velocity[i] = input(hosted.velocity[i], by_velocity + static_cast<std::size_t>(i));
  }
  const double axle[3] = {R[0][1], R[1][1], R[2][1]};
  const struct {
    Number* v;
    const double* turns;
  } with_body[] = {{m.axle, axle}, {m.arm, placed.arm}, {m.turning, hosted.turning_with_body}};
  for (const auto& [v, turns] : with_body) {
    turn(v, by_roll, roll_axis, turns);
    turn(v, by_yaw, yaw_axis, turns);
  }
  if (hosted.frame_speed != 0.0) {
    // at the reference point: where its height is not given, at the nominal one
    Number point[3];
    point[1] = input(placed.reference[1], by_y);
    point[2] =
        placed.problem.load_prescribed ? Number(placed.reference[2]) : input(placed.reference[2], by_z);
    Number frame[3];
    for (int i = 0; i < 3; ++i) frame[i] = hosted.frame_turning[i];
    m.velocity[0] += hosted.frame_speed;
    add_cross(m.velocity, frame, point);
    for (int i = 0; i < 3; ++i) m.turning[i] += frame[i];
  }
  add_cross(m.velocity, m.turning, m.arm);
  const double outward = placed.left ? -1.0 : 1.0;
  m.position[0] = m.arm[0];
  m.position[1] = m.arm[1] + input(placed.reference[1], by_y);
  m.position[2] = m.arm[2] + input(placed.problem.wheel.position[2] - placed.arm[2], by_z);
  m.rail_y = input(hosted.rail.y, by_rail_y);
  m.rail_z = input(hosted.rail.z, by_rail_z);
  m.rail_roll = input(hosted.rail.roll, by_rail_roll);
  m.rail_velocity_y = input(hosted.rail.velocity_y, by_rail_velocity_y);
  m.rail_velocity_z = input(hosted.rail.velocity_z, by_rail_velocity_z);
  m.rail_velocity_roll = input(hosted.rail.velocity_roll, by_rail_velocity_roll);
  Number along_y = input(hosted.rail.slope_y, slope_y);
  for (Number* const n :
       {&m.position[1], &m.velocity[1], &m.turning[0], &m.turning[2], &m.axle[0], &m.axle[2], &m.rail_y,
        &m.rail_roll, &m.rail_velocity_y, &m.rail_velocity_roll, &along_y})
    *n = outward * *n;
  m.direction = direction_of(along_y, input(hosted.rail.slope_z, slope_z));
  return m;
}

/// What the rail sees, by SeenInput: only the derivatives are of interest.
void see(const SurfaceModel& surface, const Moving& m, const WheelOnRail& problem, const Number& cosine,
         const Number& sine, Number (&seen)[seen_inputs]) {
  const auto along_rail = [&](Number(&v)[3]) { turn_along_rail(m.direction, v); };
  Number place[3] = {m.position[0], m.position[1] - surface.rail_origin_y - m.rail_y,
                     m.position[2] - surface.rail_origin_z - m.rail_z};
  along_rail(place);
  const Number &dy = place[1], &dz = place[2];
  seen[place_y] = cosine * dy + sine * dz;
  seen[place_z] = cosine * dz - sine * dy;
  Number axle[3], turned[3] = {m.axle[0], m.axle[1], m.axle[2]};
  along_rail(turned);
  into_rail(cosine, sine, turned, axle);
  // the turning that has no part about rail y and moves the axle like that
  seen[turn_x] = axle[2].chain(0.0, 1.0 / axle[1].value);
  seen[turn_z] = axle[0].chain(0.0, -1.0 / axle[1].value);
  Number velocity[3] = {m.velocity[0], m.velocity[1] - m.rail_velocity_y, m.velocity[2] - m.rail_velocity_z};
  along_rail(velocity);
  velocity[1] += m.rail_velocity_roll * dz;
  velocity[2] = velocity[2] - m.rail_velocity_roll * dy;
  into_rail(cosine, sine, velocity, turned);
  Number turning[3] = {m.turning[0], m.turning[1], m.turning[2]}, turning_in_rail[3];
  along_rail(turning);
  turning[0] = turning[0] - m.rail_velocity_roll;
  into_rail(cosine, sine, turning, turning_in_rail);
  if (surface.roller_curvature != 0.0) {
    const Number roller = Number::input(problem.rail.turning, roller_turning);
    turned[0] = turned[0] - roller * (seen[place_z] - 1.0 / surface.roller_curvature);
    turned[2] += roller * problem.distance;
    turning_in_rail[1] = turning_in_rail[1] - roller;
    seen[seen_roller] = roller;
  }
  for (int i = 0; i < 3; ++i) {
    seen[seen_velocity + i] = turned[i];
    seen[seen_turning + i] = turning_in_rail[i];
  }
  seen[seen_friction] = Number::input(1.0, friction);
}

/// A vector of rail axes turned into those of the track.
template <class Each>
void into_track(const RailDirection<Each>& direction, const Each& cosine, const Each& sine, Each* v) {
  const Each y = v[1], z = v[2];
  v[1] = cosine * y - sine * z;
  v[2] = sine * y + cosine * z;
  turn_into_track(direction, v);
}

/// Adds the columns of what changes along the track and round the wheel; turning moves the wheel along it.
void add_track(const Moving& m, double cosine, double sine, bool left, const RailFrameJacobian& found,
               HostJacobian& slopes) {
  const RailDirection<double> direction{m.direction.x.value, m.direction.y.value, m.direction.z.value};
  const std::size_t columns[] = {by_distance, by_angle};
  for (std::size_t c = 0; c < 2; ++c) {
    double part[2][3];  // of force, moment
    for (int i = 0; i < 3; ++i) {
      part[0][i] = found.force[i].d[c];
      part[1][i] = found.moment[i].d[c];
    }
    for (auto& v : part) into_track(direction, cosine, sine, v);
    if (left)
      for (double* const n : {&part[0][1], &part[1][0], &part[1][2]}) *n = -*n;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      slopes.wrench[i][columns[c]] = part[0][i];
      slopes.wrench[3 + i][columns[c]] =
          part[1][i] + m.arm[j].value * part[0][k] - m.arm[k].value * part[0][j];
    }
  }
  for (auto& row : slopes.wrench)
    for (std::size_t k = 0; k < by_load; ++k) row[k] += row[by_distance] * m.arm[0].d[k];
}

}  // namespace

void hand_back(const Model& model, const HostWheel& hosted, const PlacedWheel& placed,
               const RailFrameJacobian& found, const RailFrameJacobian& by_track, HostJacobian& slopes) {
  const Moving m = moving(hosted, placed);
  const SineCosine roll = sine_cosine(m.rail_roll.value);
  const Number cosine = m.rail_roll.chain(roll.cosine, -roll.sine);
  const Number sine = m.rail_roll.chain(roll.sine, roll.cosine);
  Number seen[seen_inputs];
  see(*model.surface, m, placed.problem, cosine, sine, seen);

  Number wrench[2][3];  // force, moment
  for (int part = 0; part < 2; ++part) {
    for (int i = 0; i < 3; ++i) {
      const SeenDual& in_rail = part == 0 ? found.force[i] : found.moment[i];
      Number& n = wrench[part][i];
      n = in_rail.value;
      for (std::size_t j = 0; j < seen_inputs; ++j)
        for (std::size_t k = 0; k < carried; ++k) n.d[k] += in_rail.d[j] * seen[j].d[k];
    }
    into_track(m.direction, cosine, sine, wrench[part]);
  }
  if (placed.left)
    for (Number* const n : {&wrench[0][1], &wrench[1][0], &wrench[1][2]}) *n = -*n;
  add_cross(wrench[1], m.arm, wrench[0]);

  slopes = {};
  for (std::size_t row = 0; row < 6; ++row)
    for (std::size_t k = 0; k < carried; ++k)
      slopes.wrench[row][column_of(k)] = wrench[row / 3][row % 3].d[k];
  add_track(m, cosine.value, sine.value, placed.left, by_track, slopes);
  slopes.z[by_z] = 1.0;
  if (!placed.problem.load_prescribed) return;
  // The height follows: the vertical force stays what the load is.
  constexpr std::size_t vertical = 2;
  const double stiffness = -slopes.wrench[vertical][by_z];
  const double per_stiffness = stiffness != 0.0 ? 1.0 / stiffness : 0.0;
  for (std::size_t k = 0; k < hosted_inputs; ++k) slopes.z[k] = slopes.wrench[vertical][k] * per_stiffness;
  slopes.z[by_z] = 0.0;
  slopes.z[by_load] = per_stiffness;
  for (auto& row : slopes.wrench) {
    const double by_height = row[by_z];
    row[by_z] = 0.0;
    for (std::size_t k = 0; k < hosted_inputs; ++k) row[k] += by_height * slopes.z[k];
  }
}

}  // namespace wrc
