/// Velocities within a frame that follows the track, and those against the ground: the same wrench.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "test_config.hpp"
#include "wheel_on_rail.hpp"

namespace {

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

Matrix operator*(const Matrix& a, const Matrix& b) {
  Matrix product{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t j = 0; j < 3; ++j) product[i][k] += a[i][j] * b[j][k];
  return product;
}
Vector operator*(const Matrix& a, const Vector& v) {
  Vector product{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) product[i] += a[i][j] * v[j];
  return product;
}
/// About an axis, by its length [rad]: Rodrigues.
Matrix turn(const Vector& v) {
  const double angle = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  const double s = angle > 0.0 ? std::sin(angle) / angle : 1.0;
  const double c = angle > 0.0 ? (1.0 - std::cos(angle)) / (angle * angle) : 0.5;
  const Matrix K = {{{0, -v[2], v[1]}, {v[2], 0, -v[0]}, {-v[1], v[0], 0}}}, K2 = K * K;
  Matrix R = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) R[i][k] += s * K[i][k] + c * K2[i][k];
  return R;
}

/// A wheelset in a curve with a dip and a growing cant, as a trajectory: positions and rotations over time,
/// in the axes of the frame at t = 0.
struct Trajectory {
  double speed = 22.0, curvature = 1.0 / 180.0, vertical = 1.0 / 900.0, twist = 0.02;
  double y = 3e-3, z = 0.15e-3, roll = 0.4e-3, yaw = 5e-3;  // at t = 0
  double y_rate = 0.03, z_rate = -0.002, roll_rate = 0.01, yaw_rate = -0.02, pitch_rate = -22.0 / 0.46;
  double out_of_middle = 0.0;  ///< of the reference point [m]

  Matrix frame(double t) const {
    return turn({speed * t * twist, speed * t * vertical, speed * t * curvature});
  }
  /// Of the frame's origin: its direction integrated by Simpson's rule.
  Vector origin(double t) const {
    Vector sum{};
    constexpr int steps = 20;
    for (int i = 0; i <= 2 * steps; ++i) {
      const double weight = i == 0 || i == 2 * steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
      const Matrix R = frame(t * i / (2.0 * steps));
      for (std::size_t k = 0; k < 3; ++k) sum[k] += weight * R[k][0] * speed * t / (6.0 * steps);
    }
    return sum;
  }
  Vector within(double t) const { return {0.0, out_of_middle + y + y_rate * t, -0.46 + z + z_rate * t}; }
  Matrix rotation_within(double t) const {
    return turn({roll + roll_rate * t, 0, 0}) * turn({0, 0, yaw + yaw_rate * t}) *
           turn({0, pitch_rate * t, 0});
  }
  Vector position(double t) const {
    Vector p = origin(t);
    const Vector r = frame(t) * within(t);
    for (std::size_t k = 0; k < 3; ++k) p[k] += r[k];
    return p;
  }
  Matrix rotation(double t) const { return frame(t) * rotation_within(t); }
};

constexpr double h = 1e-5;

template <class Place>
Vector rate(Place&& place) {
  const Vector before = place(-h), behind = place(h);
  return {(behind[0] - before[0]) / (2.0 * h), (behind[1] - before[1]) / (2.0 * h),
          (behind[2] - before[2]) / (2.0 * h)};
}
/// Angular velocity: of dR/dt R^T.
template <class Rotation>
Vector turning(Rotation&& rotation) {
  const Matrix before = rotation(-h), behind = rotation(h), now = rotation(0.0);
  Matrix spin{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t j = 0; j < 3; ++j) spin[i][k] += (behind[i][j] - before[i][j]) / (2.0 * h) * now[k][j];
  return {0.5 * (spin[2][1] - spin[1][2]), 0.5 * (spin[0][2] - spin[2][0]), 0.5 * (spin[1][0] - spin[0][1])};
}

class FrameMotion : public testing::Test, protected PlacedWheel {
 protected:
  void put(const Vector& velocity, const Vector& angular) {
    std::copy(velocity.begin(), velocity.end(), wheel.velocity);
    std::copy(angular.begin(), angular.end(), wheel.angular_velocity);
  }
};

TEST_F(FrameMotion, BothWaysHaveTheSameWrench) {
  for (const int32_t which : {WRC_SIDE_RIGHT, WRC_SIDE_LEFT}) {
    create(which);
    for (const int32_t reference : {WRC_REFERENCE_WHEELSET, WRC_REFERENCE_WHEEL}) {
      Trajectory path;
      const double outward = which == WRC_SIDE_LEFT ? -1.0 : 1.0;
      for (double* each : {&path.y, &path.roll, &path.yaw}) *each *= outward;
      if (reference == WRC_REFERENCE_WHEEL) path.out_of_middle = 0.75 * outward;
      wheel.reference = reference;
      wheel.y = path.y;
      wheel.z = path.z;
      wheel.roll = path.roll;
      wheel.yaw = path.yaw;
      input.frame = sized<wrc_frame_motion>();
      put(rate([&](double t) { return path.position(t); }),
          turning([&](double t) { return path.rotation(t); }));
      ASSERT_EQ(step(), WRC_OK) << error();
      const wrc_wrench against_ground = wrench;
      put(rate([&](double t) { return path.within(t); }),
          turning([&](double t) { return path.rotation_within(t); }));
      ASSERT_EQ(step(), WRC_OK) << error();  // without the frame the wheel spins on the spot
      EXPECT_GT(wrench.force[0], 0.29 * wrench.normal_force);
      input.frame.speed = path.speed;
      input.frame.curvature = path.curvature;
      input.frame.vertical_curvature = path.vertical;
      input.frame.twist = path.twist;
      ASSERT_EQ(step(), WRC_OK) << error();
      ASSERT_GT(wrench.normal_force, 1e4);
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(wrench.force[k], against_ground.force[k], 1e-6 * wrench.normal_force) << k;
        EXPECT_NEAR(wrench.moment[k], against_ground.moment[k], 1e-6 * wrench.normal_force) << k;
        EXPECT_NEAR(wrench.rail_moment[k], against_ground.rail_moment[k], 1e-6 * wrench.normal_force) << k;
      }
      EXPECT_NEAR(wrench.power, against_ground.power, 1e-5 * wrench.power);
      // the curve matters
      input.frame.curvature = 0.0;
      ASSERT_EQ(step(), WRC_OK);
      EXPECT_GT(std::abs(wrench.force[0] - against_ground.force[0]), 1e-2 * wrench.normal_force);
    }
  }
}

TEST_F(FrameMotion, StandingStillItDoesNothing) {
  create();
  wheel.z = 0.1e-3;
  wheel.y = 4e-3;
  ASSERT_EQ(step(), WRC_OK);
  const wrc_wrench without = wrench;
  input.frame.curvature = 0.01;
  ASSERT_EQ(step(), WRC_OK);
  EXPECT_EQ(std::memcmp(&wrench, &without, sizeof wrench), 0);
  input.frame.curvature = 180.0;
  EXPECT_EQ(step(), WRC_ERROR_RANGE);
  EXPECT_NE(error().find("did you pass a radius"), std::string::npos) << error();
}

}  // namespace
