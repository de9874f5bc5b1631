/// Two cones on round rails, as a wheelset and as wheels that turn by themselves: Klingel's wave and none,
/// the gravitational stiffness of cones, rolling radii; closed forms all.
#include <cmath>
#include <vector>

#include "wheel_on_rail.hpp"

namespace {

constexpr double pi = 3.14159265358979;

class IndependentWheels : public testing::Test, protected PlacedWheel {
 protected:
  static constexpr double cone = 0.05, half = 0.75, radius = 0.46, crown = radius, speed = 1.0;

  /// Straight lines on circles whose middles stand still: the wheels' lines, moved by a crown, turn about two
  /// points, and their apex runs on a circle (the angle in it stays). rho its radius, `apex` how far the apex
  /// is below the axle.
  const double angle = std::atan(cone), rho = half / std::sin(2.0 * angle),
               apex = radius + crown / std::cos(angle) + half * cone;
  const double roll_over_y = -1.0 / (2.0 * rho - apex);  ///< the left wheel sinks where the right one climbs
  const double conicity = -half * roll_over_y;           ///< change of each rolling radius over y
  const double base = half - crown * std::sin(angle);    ///< of where they touch [m]
  const double rolling = radius + cone * crown * std::sin(angle);  ///< their radius there [m]

  IndependentWheels() {
    for (int i = -200; i <= 200; ++i) {
      y_.push_back(2e-4 * i);
      round_.push_back(crown - std::sqrt(crown * crown - y_.back() * y_.back()));
      straight_.push_back(-cone * y_.back());
    }
    config.wheel.kind = config.rail.kind = WRC_PROFILE_POINTS;
    for (wrc_profile* profile : {&config.wheel, &config.rail}) {
      profile->count = static_cast<uint32_t>(y_.size());
      profile->y = y_.data();
      profile->z = profile == &config.rail ? round_.data() : straight_.data();
    }
    config.track.placement = WRC_PLACEMENT_ORIGIN;
    config.track.rail_origin = half;
    config.wheelset.tape_circle_distance = 2.0 * half;
    wrc_model_create(&config, nullptr, &model, nullptr, 0);
    for (const int32_t which : {WRC_SIDE_RIGHT, WRC_SIDE_LEFT})
      wrc_contact_create(model, which, nullptr, &wheels_[which == WRC_SIDE_RIGHT ? 0 : 1], nullptr, 0);
    friction.coefficient = 1.0;  // slips stay small
  }
  ~IndependentWheels() override {
    for (wrc_contact* each : wheels_) wrc_contact_destroy(each);
  }

  const double feet = 1.0 - rolling * roll_over_y;  ///< movement of the wheels' feet over y

  /// What a quasi-static wheelset has to settle: its height, roll, lateral and yaw rate, and the speed of its
  /// wheels; so that nothing is left of the forces but `load`.
  enum { Z, ROLL, RATE_Y, RATE_YAW, RIGHT, LEFT, UNKNOWNS };
  using Unknowns = double[UNKNOWNS];
  double load = 160e3;
  bool independent = false;

  /// Six sums that are to vanish, Fz, Mx, Fy, Mz and the two axle moments (of one axle: the sum, and the
  /// difference of speeds; of independent wheels the yaw rate instead of Mz), at a place; their derivatives
  /// by (y, yaw) and by the unknowns.
  void sums(double y, double yaw, const Unknowns& u, double (&sum)[6], double (&by)[6][2 + UNKNOWNS]) {
    for (int i = 0; i < 6; ++i) {
      sum[i] = 0.0;
      for (double& each : by[i]) each = 0.0;
    }
    sum[0] = load;
    for (int k = 0; k < 2; ++k) {
      wheel.angular_axes = WRC_AXES_BODY;
      wheel.y = y, wheel.yaw = yaw, wheel.z = u[Z], wheel.roll = u[ROLL];
      wheel.velocity[0] = speed, wheel.velocity[1] = u[RATE_Y];
      wheel.velocity[2] = following_[0], wheel.angular_velocity[0] = following_[1];
      wheel.angular_velocity[1] = u[RIGHT + k], wheel.angular_velocity[2] = u[RATE_YAW];
      auto slope = sized<wrc_wrench_derivatives>();
      const int32_t status = wrc_contact_wrench_derivatives(wheels_[k], &input, &wrench, &slope);
      ASSERT_EQ(status, WRC_OK);
      const double all[6] = {wrench.force[0],  wrench.force[1],  wrench.force[2],
                             wrench.moment[0], wrench.moment[1], wrench.moment[2]};
      const int row[6] = {2, 3, 1, 5, 4, 4};
      const int column[2 + UNKNOWNS] = {WRC_BY_Y,
                                        WRC_BY_YAW,
                                        WRC_BY_Z,
                                        WRC_BY_ROLL,
                                        WRC_BY_VELOCITY_Y,
                                        WRC_BY_ANGULAR_VELOCITY_Z,
                                        WRC_BY_ANGULAR_VELOCITY_Y,
                                        WRC_BY_ANGULAR_VELOCITY_Y};
      for (int i = 0; i < 6; ++i) {
        if (i == 5 && !independent) continue;
        if (independent && i >= 4 && i != 4 + k) continue;
        sum[i] += all[row[i]];
        for (int j = 0; j < 2 + UNKNOWNS; ++j)
          if (j < 2 + RIGHT || j == 2 + RIGHT + k) by[i][j] += slope.wrench[row[i]][column[j]];
        for (int j = 0; j < 2; ++j)  // height and roll follow y and yaw
          by[i][2 + RATE_Y + j] += slope.wrench[row[i]][WRC_BY_VELOCITY_Z] * follows_[0][j] +
                                   slope.wrench[row[i]][WRC_BY_ANGULAR_VELOCITY_X] * follows_[1][j];
      }
    }
    if (independent) {
      couple = sum[3];
      sum[3] = u[RATE_YAW];
      for (double& each : by[3]) each = 0.0;
      by[3][2 + RATE_YAW] = 1.0;
    } else {
      sum[5] = u[RIGHT] - u[LEFT];
      by[5][2 + RIGHT] = 1.0, by[5][2 + LEFT] = -1.0;
    }
  }
  /// Solves the six; `rates`: d(y, yaw)/dt by (y, yaw) where they are solved.
  void settle(double y, double yaw, Unknowns& u, double (&rates)[2][2]) {
    double sum[6], by[6][2 + UNKNOWNS];
    for (int turn = 0; turn < 8; ++turn) {
      sums(y, yaw, u, sum, by);
      double a[6][UNKNOWNS + 3];
      for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < UNKNOWNS; ++j) a[i][j] = by[i][2 + j];
        a[i][UNKNOWNS] = -sum[i], a[i][UNKNOWNS + 1] = -by[i][0], a[i][UNKNOWNS + 2] = -by[i][1];
      }
      for (int k = 0; k < 6; ++k) {
        int pivot = k;
        for (int i = k; i < 6; ++i)
          if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
        std::swap(a[k], a[pivot]);
        for (int i = 0; i < 6; ++i) {
          const double f = a[i][k] / a[k][k];
          for (int j = 0; i != k && j < UNKNOWNS + 3; ++j) a[i][j] -= f * a[k][j];
        }
      }
      for (int k = 0; k < 6; ++k) u[k] += a[k][UNKNOWNS] / a[k][k];
      for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j) {
          rates[k][j] = a[RATE_Y + k][UNKNOWNS + 1 + j] / a[RATE_Y + k][RATE_Y + k];
          follows_[k][j] = a[Z + k][UNKNOWNS + 1 + j] / a[Z + k][Z + k];
        }
      for (int k = 0; k < 2; ++k) following_[k] = follows_[k][0] * u[RATE_Y] + follows_[k][1] * u[RATE_YAW];
    }
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(sum[i], 0.0, 1e-4) << i;
  }
  /// Where both wheels touch under the load.
  void start(Unknowns& u, double y = 0.0) const {
    for (double& each : u) each = 0.0;
    u[ROLL] = roll_over_y * y;
    u[Z] = crown * (1.0 - 1.0 / std::cos(angle)) + 0.1e-3;
    u[RIGHT] = u[LEFT] = -speed / radius;
  }

  /// Radius of the patch, Hertz's circle.
  double circle() const {
    const double G = config.wheel_material.shear_modulus, nu = config.wheel_material.poisson;
    return std::cbrt(1.5 * 0.5 * load * rolling * (1.0 - nu) / (2.0 * G));
  }
  /// Over y: longitudinal forces of C11 = 4.12 (Kalker) by the creepage of the rolling radii.
  double couple_of_one_axle() const {
    return 2.0 * base * config.wheel_material.shear_modulus * circle() * circle() * 4.12 * conicity / rolling;
  }

  double couple = 0.0;  ///< Mz of independent wheels, which nothing but their yaw rate answers to

 private:
  std::vector<double> y_, round_, straight_;
  wrc_contact* wheels_[2] = {};
  double follows_[2][2] = {}, following_[2] = {};  ///< height and roll: by y and yaw, and their rates
};

/// On one axle: Klingel's wave, L = 2 pi sqrt(b r / conicity), of the wheels' feet: what rolls about x
/// carries them aside, y - r roll.
TEST_F(IndependentWheels, OnOneAxleRunInKlingelsWave) {
  Unknowns u;
  double rates[2][2];
  start(u);
  settle(0.0, 0.0, u, rates);
  const double trace = rates[0][0] + rates[1][1], det = rates[0][0] * rates[1][1] - rates[0][1] * rates[1][0];
  ASSERT_LT(0.25 * trace * trace, det);
  const double wave = 2.0 * pi * speed / std::sqrt(det - 0.25 * trace * trace);
  EXPECT_NEAR(wave, 2.0 * pi * std::sqrt(feet * base * rolling / conicity), 0.005 * wave);
}

/// Each rolls at the speed of its own radius and nothing turns them about z, so that there is no wave: what
/// is beside the middle creeps back by its weight alone (and out by the spin of the cones), a yawed pair runs
/// aside.
TEST_F(IndependentWheels, HaveNoWave) {
  Unknowns u;
  double rates[2][2];
  independent = true;
  const double y = 4e-3;
  start(u, y);
  settle(y, 0.0, u, rates);
  EXPECT_NEAR(-speed / u[RIGHT] + speed / u[LEFT], 2.0 * conicity * y, 0.02 * 2.0 * conicity * y);
  EXPECT_NEAR(couple, 0.0, 0.01 * couple_of_one_axle() * y);
  EXPECT_NEAR(rates[0][1], speed / feet, 0.01 * speed);
  // Kalker's table of a circle: C22 = 3.67, C23 = 1.47
  const double place = crown * roll_over_y;     // by which the places of contact move, over y
  const double shifted = (1.0 - place) / base;  // of the load to the right wheel, over y
  const double stiffness = 2.0 * config.wheel_material.shear_modulus * circle() * circle();
  const double weight = load * (-roll_over_y + cone * shifted);
  const double spin = stiffness * circle() * 1.47 * std::sin(angle) / rolling * shifted;
  const double back = (weight - spin) / (stiffness * 3.67 * feet) * speed;
  EXPECT_NEAR(u[RATE_Y], -back * y, 0.05 * weight / (stiffness * 3.67 * feet) * speed * y);  // a difference
}

/// What turns a wheelset on one axle that is kept from yawing: C11 = 4.12.
TEST_F(IndependentWheels, OnOneAxleAreTurnedByALongitudinalCouple) {
  const double y = 0.1e-3;
  Unknowns u;
  double rates[2][2], sum[6], by[6][2 + UNKNOWNS];
  start(u, y);
  settle(y, 0.0, u, rates);
  u[RATE_YAW] = 0.0;
  for (int turn = 0; turn < 5; ++turn) {  // the axle at the speed it takes then
    sums(y, 0.0, u, sum, by);
    const double change = sum[4] / (by[4][2 + RIGHT] + by[4][2 + LEFT]);
    u[RIGHT] -= change, u[LEFT] -= change;
  }
  sums(y, 0.0, u, sum, by);
  EXPECT_NEAR(sum[3], -couple_of_one_axle() * y, 0.05 * couple_of_one_axle() * y);
}

/// Without friction a wheelset is drawn back by its weight: the slope of its height, which rigid bodies on
/// circles have in closed form.
TEST_F(IndependentWheels, AreDrawnBackByTheirWeight) {
  friction.coefficient = 0.0;
  load = 20e3;
  for (const double y : {0.5e-3, 3e-3}) {
    // y = -rho sin(2 roll) + apex sin(roll)
    double roll = roll_over_y * y;
    for (int i = 0; i < 4; ++i)
      roll -= (-rho * std::sin(2.0 * roll) + apex * std::sin(roll) - y) /
              (-2.0 * rho * std::cos(2.0 * roll) + apex * std::cos(roll));
    const double expected = load * (-2.0 * rho * std::sin(2.0 * roll) + apex * std::sin(roll)) /
                            (-2.0 * rho * std::cos(2.0 * roll) + apex * std::cos(roll));
    Unknowns u;
    double sum[6], by[6][2 + UNKNOWNS];
    start(u, y);
    for (int turn = 0; turn < 12; ++turn) {
      sums(y, 0.0, u, sum, by);
      const double det = by[0][2 + Z] * by[1][2 + ROLL] - by[0][2 + ROLL] * by[1][2 + Z];
      u[Z] -= (sum[0] * by[1][2 + ROLL] - sum[1] * by[0][2 + ROLL]) / det;
      u[ROLL] -= (sum[1] * by[0][2 + Z] - sum[0] * by[1][2 + Z]) / det;
    }
    sums(y, 0.0, u, sum, by);
    EXPECT_NEAR(sum[0], 0.0, 1e-5 * load);
    EXPECT_NEAR(u[ROLL], roll, 0.01 * std::abs(roll));
    EXPECT_NEAR(sum[2], expected, 0.01 * std::abs(expected));
  }
}

}  // namespace
