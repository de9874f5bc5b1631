/// The longest step of explicit schemes, by docs/user_forces.md ("Steps of fixed length"): wheelsets
/// integrated with a tenth less stay, with a tenth more they run away.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "wheel_on_rail.hpp"

namespace {

using State = std::array<double, 9>;  // y, z, roll, yaw, their rates, pitch rate

struct Masses {
  double speed, load, mass, across, axle;  // m/s, N, kg, kg m^2, kg m^2 about the axle
};

/// A centred wheelset of 0.46 m on S1002 and UIC60.
class RollingWheelset : PlacedWheel {
 public:
  explicit RollingWheelset(const Masses& of) : of_(of) {
    EXPECT_EQ(wrc_model_create(&config, nullptr, &model, nullptr, 0), WRC_OK);
    for (int32_t each = 0; each < 2; ++each)
      EXPECT_EQ(wrc_contact_create(model, each, nullptr, &wheels_[each], nullptr, 0), WRC_OK);
    wheel.angular_axes = WRC_AXES_NONE;
    wheel.angular_velocity[1] = 0.0;
    wheel.velocity[0] = of.speed;
    start_[8] = wheel.pitch_rate = -of.speed / 0.46;
    input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
    input.vertical_load = 0.5 * of.load;
    EXPECT_EQ(wrc_contact_wrench(wheels_[0], &input, &wrench), WRC_OK);
    start_[1] = wrench.z;
    input.prescribed = WRC_PRESCRIBE_HEIGHT;
    input.vertical_load = 0.0;
    input.damping = 0.3;
  }
  ~RollingWheelset() {
    for (wrc_contact* each : wheels_) wrc_contact_destroy(each);
  }
  RollingWheelset(const RollingWheelset&) = delete;
  RollingWheelset& operator=(const RollingWheelset&) = delete;

  struct Rates {
    double pitch, lateral, yaw;  ///< of the damping by creep forces [1/s]
    double vertical;             ///< angular frequency on the contacts' stiffness [1/s]
    double fastest() const { return std::max({pitch, lateral, yaw}); }
  };
  Rates rates() {
    auto slopes = sized<wrc_wrench_derivatives>();
    give(start_);
    double moment_y = 0.0, force_y = 0.0, moment_z = 0.0, force_z = 0.0;
    for (wrc_contact* each : wheels_) {
      EXPECT_EQ(wrc_contact_wrench_derivatives(each, &input, &wrench, &slopes), WRC_OK);
      moment_y -= slopes.wrench[4][WRC_BY_ANGULAR_VELOCITY_Y];
      force_y -= slopes.wrench[1][WRC_BY_VELOCITY_Y];
      moment_z -= slopes.wrench[5][WRC_BY_ANGULAR_VELOCITY_Z];
      force_z -= slopes.wrench[2][WRC_BY_Z];
    }
    return {moment_y / of_.axle, force_y * (1.0 / of_.mass + 0.46 * 0.46 / of_.across), moment_z / of_.across,
            std::sqrt(force_z / of_.mass)};
  }

  State accelerations(const State& u) {
    std::array<double, 3> force{0.0, 0.0, of_.load}, moment{};
    give(u);
    for (wrc_contact* each : wheels_) {
      EXPECT_GE(wrc_contact_wrench(each, &input, &wrench), 0);
      for (int i = 0; i < 3; ++i) {
        force[i] += wrench.force[i];
        moment[i] += wrench.moment[i];
      }
    }
    return {u[4],
            u[5],
            u[6],
            u[7],
            force[1] / of_.mass,
            force[2] / of_.mass,
            (moment[0] + of_.axle * u[8] * u[7]) / of_.across,
            (moment[2] - of_.axle * u[8] * u[6]) / of_.across,
            moment[1] / of_.axle};
  }

  void semi_implicit_euler(State& u, double step) {
    const State f = accelerations(u);
    for (int i = 4; i < 9; ++i) u[i] += step * f[i];
    for (int i = 0; i < 4; ++i) u[i] += step * u[i + 4];
  }
  void runge_kutta(State& u, double step) {
    State sum{}, f{};
    for (const auto& [ahead, weight] : {std::pair{0.0, 1.0}, {0.5, 2.0}, {0.5, 2.0}, {1.0, 1.0}}) {
      State at;
      for (int i = 0; i < 9; ++i) at[i] = u[i] + ahead * step * f[i];
      f = accelerations(at);
      for (int i = 0; i < 9; ++i) sum[i] += weight / 6.0 * f[i];
    }
    for (int i = 0; i < 9; ++i) u[i] += step * sum[i];
  }

  /// How far pitch rate and lateral velocity are, 100 steps after a small disturbance, from those that half
  /// as long steps lead to: parts of the speed, the largest of four steps. A scheme beyond its limit
  /// alternates, or settles quietly where nothing rolls freely.
  double error(void (RollingWheelset::*scheme)(State&, double), double step) {
    State settled = start_, u = start_;
    u[4] += 1e-6 * of_.speed;
    for (int n = 0; n < 200; ++n) runge_kutta(settled, 0.5 * step);
    double largest = 0.0;
    for (int n = 0; n < 104; ++n) {
      (this->*scheme)(u, step);
      if (n >= 100)
        largest = std::max(
            {largest, std::abs((u[8] - settled[8]) / start_[8]), std::abs(u[4] - settled[4]) / of_.speed});
    }
    return largest;
  }

 private:
  Masses of_;
  State start_{};
  std::array<wrc_contact*, 2> wheels_{};

  void give(const State& u) {
    wheel.y = u[0], wheel.z = u[1], wheel.roll = u[2], wheel.yaw = u[3];
    wheel.velocity[1] = u[4], wheel.velocity[2] = u[5];
    wheel.roll_rate = u[6], wheel.yaw_rate = u[7], wheel.pitch_rate = u[8];
  }
};

/// 1500 kg, 110 kg m^2, 120 kN at 5 m/s: the numbers of the page.
TEST(FixedStep, WorkedNumber) {
  const auto rates = RollingWheelset({5.0, 120e3, 1500.0, 900.0, 110.0}).rates();
  EXPECT_NEAR(rates.pitch, 8980.0, 10.0);
  EXPECT_NEAR(rates.lateral, 3890.0, 10.0);
  EXPECT_NEAR(rates.yaw, 2920.0, 10.0);
  EXPECT_NEAR(rates.vertical, 1440.0, 10.0);
}

/// Light and heavy axles, slow and fast: the fastest rate is that of pitch, of the last that of lateral
/// motion.
TEST(FixedStep, WheelsetsAreWrongBeyondTheLimitAlone) {
  for (const Masses& of :
       {Masses{2.0, 120e3, 1500.0, 900.0, 110.0}, Masses{5.0, 160e3, 1500.0, 900.0, 60.0},
        Masses{20.0, 120e3, 1500.0, 900.0, 60.0}, Masses{5.0, 120e3, 1000.0, 700.0, 1500.0}}) {
    RollingWheelset set(of);
    const double euler = 2.0 / set.rates().fastest(), runge_kutta = 2.785 / set.rates().fastest();
    EXPECT_LT(set.error(&RollingWheelset::semi_implicit_euler, 0.95 * euler), 5e-7)
        << of.speed << " m/s, " << of.axle;
    EXPECT_GT(set.error(&RollingWheelset::semi_implicit_euler, 1.05 * euler), 1e-4)
        << of.speed << " m/s, " << of.axle;
    EXPECT_LT(set.error(&RollingWheelset::runge_kutta, 0.95 * runge_kutta), 5e-7)
        << of.speed << " m/s, " << of.axle;
    EXPECT_GT(set.error(&RollingWheelset::runge_kutta, 1.05 * runge_kutta), 1e-4)
        << of.speed << " m/s, " << of.axle;
  }
}

}  // namespace
