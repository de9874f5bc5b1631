/// Friction that falls with the sliding speed and with the temperature it makes, both at once: of the planar
/// stages and of a wheel on a rail.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "field_values.hpp"
#include "loaded_ellipse.hpp"
#include "presets.hpp"
#include "test_config.hpp"
#include "wheel_on_rail.hpp"

namespace {

using Numbers = std::vector<double>;

constexpr int32_t speed_laws[] = {WRC_SPEED_LAW_EXPONENTIAL, WRC_SPEED_LAW_HYPERBOLIC};

/// The factor of the sliding speed w [m/s], by the formulas of the header.
double factor_of_speed(const wrc_friction& law, double w) {
  const double A = law.kinetic_ratio;
  return law.speed_law == WRC_SPEED_LAW_EXPONENTIAL ? (1.0 - A) * std::exp(-law.fall_rate * w) + A
                                                    : A + (1.0 - A) / (1.0 + w / law.half_speed);
}

/// The factor of the temperature of strip j: the mean over its semi-elliptic load.
double factor_of_temperature(const wrc_friction& law, double at_entry, const FieldValues& rise,
                             std::size_t j) {
  const std::size_t cells = rise.cells;
  double sum = 0.0, weights = 0.0;
  for (std::size_t i = 0; i < cells; ++i) {
    const double xi = (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(cells) - 1.0;
    const double weight = std::sqrt(1.0 - xi * xi), hot = at_entry + rise.at(i, j);
    const double share = (hot - law.cold_temperature) / (law.hot_temperature - law.cold_temperature);
    sum += weight * (1.0 - (1.0 - law.hot_ratio) * std::clamp(share, 0.0, 1.0));
    weights += weight;
  }
  return sum / weights;
}

/// Largest second difference of equally spaced numbers.
double bend(const Numbers& f) {
  double largest = 0.0;
  for (std::size_t k = 1; k + 1 < f.size(); ++k)
    largest = std::max(largest, std::abs(f[k + 1] - 2.0 * f[k] + f[k - 1]));
  return largest;
}

/// Coefficients under both laws lie above the product of what either alone makes of 0.4, and below either.
/// `solved(speed law, temperature law)`: the coefficients of strips.
template <class Solved>
void expect_between(int32_t law, Solved&& solved) {
  const Numbers by_speed = solved(law, WRC_TEMPERATURE_LAW_NONE),
                by_heat = solved(WRC_SPEED_LAW_NONE, WRC_TEMPERATURE_LAW_LINEAR),
                by_both = solved(law, WRC_TEMPERATURE_LAW_LINEAR);
  double over_product = 0.0;
  for (std::size_t j = 0; j < by_both.size(); ++j) {
    const double product = by_speed[j] * by_heat[j] / 0.4;
    EXPECT_GT(by_both[j], product) << j;
    EXPECT_LT(by_both[j], 0.95 * by_speed[j]) << j;
    EXPECT_LT(by_both[j], 0.95 * by_heat[j]) << j;
    over_product = std::max(over_product, by_both[j] / product);
  }
  EXPECT_GT(over_product, 1.02);
}

/// force(speed) falls from 1 to 11 m/s without jumps: its second differences go with the square of the step.
template <class Force>
void expect_smooth_fall(Force&& force) {
  double bends[2];
  for (const int finer : {1, 5}) {
    Numbers found;
    for (int k = 0; k <= 100 * finer; ++k) found.push_back(force(1.0 + 0.1 / finer * k));
    for (std::size_t k = 1; k < found.size(); ++k) EXPECT_LT(found[k], found[k - 1]) << k;
    EXPECT_LT(found.back(), 0.95 * found.front());
    bends[finer == 1 ? 0 : 1] = bend(found);
  }
  EXPECT_LT(bends[1], 0.1 * bends[0]);
}

double lowest(const Numbers& all) { return *std::min_element(all.begin(), all.end()); }

// ------------------------------------------------------------------------------------------ planar stages

class FrictionFactors : public LoadedEllipse {
 protected:
  void SetUp() override {
    creepage.longitudinal = 0.03;
    creepage.spin = 0.4;
    creepage.speed = 20.0;
    friction.coefficient = 0.4;
    friction.bulk.wheel = 60.0;
    make();
  }
  void choose(int32_t speed_law, int32_t temperature_law) {
    friction.speed_law = speed_law;
    friction.temperature_law = temperature_law;
  }
  FieldValues cells_of(int32_t id) {
    FieldValues found = field_values(contact, 0, id);
    EXPECT_EQ(found.status, WRC_OK);
    return found;
  }
  Numbers field(int32_t id) { return cells_of(id).values; }
  double at_entry() {
    wrc_temperature found = sized<wrc_temperature>();
    EXPECT_EQ(wrc_contact_temperature(contact, WRC_ALL_REGIONS, &friction.bulk, &found), WRC_OK);
    return found.at_entry;
  }
};

// Each strip's coefficient is the coefficient at rest times the factor of the root mean square of its rigid
// slip times that of the temperatures which the contact's own tractions make. Of modified FASTSIM the slip is
// that of the patch.
TEST_F(FrictionFactors, CoefficientsAreTheProductOfTheirFactors) {
  for (const bool modified : {false, true}) {
    if (modified) config.tangential.method = WRC_TANGENTIAL_FASTSIM;
    friction.slope_fall = modified ? 0.6 : 0.0;
    make();
    for (const int32_t law : speed_laws) {
      choose(law, WRC_TEMPERATURE_LAW_LINEAR);
      double least_by_speed = 1.0, least_by_heat = 1.0;
      for (const double slip : {0.002, 0.01, 0.1}) {
        SCOPED_TRACE(testing::Message() << modified << ' ' << law << ' ' << slip);
        creepage.longitudinal = slip;
        creepage.lateral = -0.3 * slip;
        ASSERT_EQ(solve(), WRC_OK);
        const double entry = at_entry();
        const FieldValues rise = cells_of(WRC_FIELD_TEMPERATURE_RISE);
        const Numbers found = field(WRC_FIELD_STRIP_FRICTION), y = field(WRC_FIELD_STRIP_Y),
                      x = field(WRC_FIELD_STRIP_CENTRE), half = field(WRC_FIELD_STRIP_HALF_LENGTH);
        for (std::size_t j = 0; j < found.size(); ++j) {
          const double along = modified ? slip : slip - creepage.spin * y[j];
          const double across = creepage.lateral + (modified ? 0.0 : creepage.spin * x[j]);
          const double turning = modified ? 0.0 : creepage.spin * half[j] / std::sqrt(3.0);
          const double w = creepage.speed * std::sqrt(along * along + across * across + turning * turning);
          const double by_speed = factor_of_speed(friction, w);
          const double by_heat = factor_of_temperature(friction, entry, rise, j);
          EXPECT_NEAR(found[j], 0.4 * by_speed * by_heat, 0.4e-3) << j;
          least_by_speed = std::min(least_by_speed, by_speed);
          least_by_heat = std::min(least_by_heat, by_heat);
        }
      }
      EXPECT_LT(least_by_speed, 0.7);
      EXPECT_LT(least_by_heat, 0.85);
    }
  }
}

// A factor that is 1 leaves the other's numbers: temperature's bit for bit, speed's but for rounding, since
// means of friction over the patch are taken anew.
TEST_F(FrictionFactors, AFactorOfOneLeavesTheOther) {
  for (const int32_t method :
       {WRC_TANGENTIAL_STRIP_FASTSIM, WRC_TANGENTIAL_FASTSIM, WRC_TANGENTIAL_FASTRIP}) {
    config.tangential.method = method;
    make();
    for (const int32_t law : speed_laws) {
      SCOPED_TRACE(testing::Message() << method << ' ' << law);
      friction.kinetic_ratio = 1.0;
      choose(law, WRC_TEMPERATURE_LAW_LINEAR);
      ASSERT_GE(solve(), WRC_OK);
      const wrc_planar_forces both = forces;
      choose(WRC_SPEED_LAW_NONE, WRC_TEMPERATURE_LAW_LINEAR);
      ASSERT_GE(solve(), WRC_OK);
      EXPECT_EQ(std::memcmp(&forces, &both, sizeof both), 0);

      friction.kinetic_ratio = 0.4;
      choose(law, WRC_TEMPERATURE_LAW_NONE);
      ASSERT_GE(solve(), WRC_OK);
      const wrc_planar_forces by_speed = forces;
      choose(WRC_SPEED_LAW_NONE, WRC_TEMPERATURE_LAW_NONE);
      ASSERT_GE(solve(), WRC_OK);
      for (const wrc_planar_forces& each : {both, by_speed})
        EXPECT_LT(std::abs(each.fx), 0.9 * std::abs(forces.fx));
      friction.hot_ratio = 1.0;
      choose(law, WRC_TEMPERATURE_LAW_LINEAR);
      ASSERT_GE(solve(), WRC_OK);
      EXPECT_NEAR(forces.fx, by_speed.fx, 1e-9 * std::abs(by_speed.fx));
      EXPECT_NEAR(forces.mz, by_speed.mz, 1e-9 * std::abs(by_speed.mz));
      friction.hot_ratio = 0.5;
    }
  }
}

// Where all slides less friction makes less heat: each strip keeps more than the product of what either law
// alone leaves it, and less than either.
TEST_F(FrictionFactors, LieBetweenTheirProductAndEither) {
  creepage.longitudinal = 0.05;
  for (const int32_t method :
       {WRC_TANGENTIAL_STRIP_FASTSIM, WRC_TANGENTIAL_FASTSIM, WRC_TANGENTIAL_FASTRIP}) {
    config.tangential.method = method;
    make();
    for (const int32_t law : speed_laws) {
      const auto solved = [&](int32_t speed_law, int32_t temperature_law) {
        choose(speed_law, temperature_law);
        EXPECT_GE(solve(), WRC_OK);
        return field(WRC_FIELD_STRIP_FRICTION);
      };
      SCOPED_TRACE(testing::Message() << method << ' ' << law);
      expect_between(law, solved);
    }
  }
}

TEST_F(FrictionFactors, FallWithTheSpeedWithoutJumps) {
  for (const int32_t law : speed_laws) {
    SCOPED_TRACE(law);
    choose(law, WRC_TEMPERATURE_LAW_LINEAR);
    expect_smooth_fall([&](double speed) {
      creepage.speed = speed;
      EXPECT_EQ(solve(), WRC_OK);
      return -forces.fx / ellipse.normal_force;
    });
  }
}

TEST_F(FrictionFactors, SensitivitiesAreThoseOfTheForces) {
  for (const int32_t law : speed_laws) {
    SCOPED_TRACE(law);
    choose(law, WRC_TEMPERATURE_LAW_LINEAR);
    ASSERT_EQ(solve(), WRC_OK);
    const double limit = friction.coefficient * ellipse.normal_force;
    wrc_planar_derivatives found = sized<wrc_planar_derivatives>();
    ASSERT_EQ(wrc_planar_tangential_derivatives(contact, &found), WRC_OK);
    double* const inputs[] = {&creepage.longitudinal, &creepage.lateral, &creepage.spin};
    const double steps[] = {2e-4, 2e-4, 2e-2};
    for (int k = 0; k < 3; ++k) {
      const double at = *inputs[k];
      *inputs[k] = at + steps[k];
      ASSERT_EQ(solve(), WRC_OK);
      const wrc_planar_forces above = forces;
      *inputs[k] = at - steps[k];
      ASSERT_EQ(solve(), WRC_OK);
      *inputs[k] = at;
      EXPECT_NEAR(2.0 * steps[k] * found.forces[0][k], above.fx - forces.fx, 2e-4 * limit) << k;
      EXPECT_NEAR(2.0 * steps[k] * found.forces[1][k], above.fy - forces.fy, 2e-4 * limit) << k;
    }
    // at this slip the force falls in size as the sliding speed grows
    EXPECT_GT(2.0 * steps[0] * found.forces[0][0], 1e-3 * limit);
  }
}

// -------------------------------------------------------------------------------------- a wheel on a rail

class WheelFrictionFactors : public testing::Test, protected PlacedWheel {
 protected:
  WheelFrictionFactors() {
    wheel.y = 2e-3;
    wheel.z = 0.2e-3;
    wheel.velocity[0] = 40.0;
    friction.coefficient = 0.4;
    friction.bulk.wheel = 90.0;
    slide(0.02);
  }
  /// Longitudinal creepage, nearly.
  void slide(double share) { wheel.angular_velocity[1] = -wheel.velocity[0] / 0.46 * (1.0 + share); }
  void solve(int32_t speed_law, int32_t temperature_law) {
    friction.speed_law = speed_law;
    friction.temperature_law = temperature_law;
    ASSERT_GE(step(), WRC_OK) << error();
  }
  FieldValues cells_of(int32_t index, int32_t which) {
    FieldValues found = field_values(contact, index, which);
    EXPECT_EQ(found.status, WRC_OK);
    return found;
  }
  Numbers field(int32_t index, int32_t which) { return cells_of(index, which).values; }
  /// Coefficients of the strips of all regions.
  Numbers coefficients() {
    Numbers all;
    for (int32_t r = 0; r < wrench.region_count; ++r) {
      const Numbers own = field(r, WRC_FIELD_STRIP_FRICTION);
      all.insert(all.end(), own.begin(), own.end());
    }
    return all;
  }
};

// At a given height the strips and their slips are those of the speed law alone, whose coefficients hold the
// coefficient at rest and the factor of speed; to them comes the factor of the temperatures that tractions
// make.
TEST_F(WheelFrictionFactors, CoefficientsAreTheProductOfTheirFactors) {
  create();
  for (const int32_t law : speed_laws) {
    for (const double slip : {0.002, 0.01, -0.1}) {
      for (const double y : {2e-3, 6.6e-3}) {
        SCOPED_TRACE(testing::Message() << law << ' ' << slip << ' ' << y);
        wheel.y = y;
        wheel.z = y > 5e-3 ? -0.3e-3 : 0.2e-3;
        slide(slip);
        solve(law, WRC_TEMPERATURE_LAW_NONE);
        std::vector<Numbers> cold;
        for (int32_t r = 0; r < wrench.region_count; ++r) cold.push_back(field(r, WRC_FIELD_STRIP_FRICTION));
        solve(law, WRC_TEMPERATURE_LAW_LINEAR);
        ASSERT_EQ(static_cast<std::size_t>(wrench.region_count), cold.size());
        for (int32_t r = 0; r < wrench.region_count; ++r) {
          const Numbers& by_speed = cold[static_cast<std::size_t>(r)];
          wrc_temperature temperature = sized<wrc_temperature>();
          ASSERT_EQ(wrc_contact_temperature(contact, r, &friction.bulk, &temperature), WRC_OK);
          const FieldValues rise = cells_of(r, WRC_FIELD_TEMPERATURE_RISE);
          const Numbers found = field(r, WRC_FIELD_STRIP_FRICTION);
          ASSERT_EQ(found.size(), by_speed.size());
          for (std::size_t j = 0; j < found.size(); ++j) {
            const double by_heat = factor_of_temperature(friction, temperature.at_entry, rise, j);
            EXPECT_NEAR(found[j], by_speed[j] * by_heat, 0.4e-3) << r << ' ' << j;
          }
          EXPECT_LT(lowest(by_speed), 0.4 * 0.95);
          EXPECT_LT(lowest(found), 0.93 * lowest(by_speed));  // 55 degrees at entry alone
        }
      }
    }
  }
  // on the tread nothing turns much: the sliding speed is that of all, a tenth of 40 m/s
  wheel.y = 0.0;
  wheel.z = 0.2e-3;
  slide(-0.1);
  solve(WRC_SPEED_LAW_HYPERBOLIC, WRC_TEMPERATURE_LAW_NONE);
  const Numbers by_speed = coefficients();
  for (const double each : by_speed) EXPECT_NEAR(each, 0.4 * factor_of_speed(friction, 4.0), 2e-3);
}

// A factor that is 1 leaves the other's numbers, bit for bit: with and without regions of their own, and near
// standstill, where both ways have a share.
TEST_F(WheelFrictionFactors, AFactorOfOneLeavesTheOther) {
  for (const int32_t method :
       {WRC_TANGENTIAL_STRIP_FASTSIM, WRC_TANGENTIAL_FASTRIP, WRC_TANGENTIAL_FASTSIM}) {
    config.tangential.method = method;
    if (method == WRC_TANGENTIAL_FASTSIM) config.tangential.patch_model = WRC_PATCH_MODEL_PATCH_ELLIPSE;
    create();
    for (const double speed : {40.0, -0.02}) {
      for (const int32_t law : speed_laws) {
        SCOPED_TRACE(testing::Message() << method << ' ' << speed << ' ' << law);
        wheel.velocity[0] = speed;
        slide(4e-3);
        friction.kinetic_ratio = 1.0;
        solve(law, WRC_TEMPERATURE_LAW_LINEAR);
        const wrc_wrench both = wrench;
        solve(WRC_SPEED_LAW_NONE, WRC_TEMPERATURE_LAW_LINEAR);
        EXPECT_EQ(std::memcmp(&wrench, &both, sizeof both), 0);

        friction.kinetic_ratio = 0.4;
        friction.hot_ratio = 1.0;
        solve(law, WRC_TEMPERATURE_LAW_LINEAR);
        const wrc_wrench other = wrench;
        solve(law, WRC_TEMPERATURE_LAW_NONE);
        if (method == WRC_TANGENTIAL_FASTSIM) {  // whose patches have means of friction, in rounding
          EXPECT_NEAR(wrench.force[0], other.force[0], 1e-9 * std::abs(other.force[0]));
        } else {
          EXPECT_EQ(std::memcmp(&wrench, &other, sizeof other), 0);
        }
        solve(WRC_SPEED_LAW_NONE, WRC_TEMPERATURE_LAW_NONE);
        for (const wrc_wrench& each : {both, other})
          EXPECT_LT(std::abs(each.force[0]), (speed > 1.0 ? 0.99 : 1.01) * std::abs(wrench.force[0]));
        friction.hot_ratio = 0.5;
      }
    }
  }
}

// As of the planar stages, with every way to roll on a surface.
TEST_F(WheelFrictionFactors, LieBetweenTheirProductAndEither) {
  wheel.y = 0.0;
  slide(0.05);
  for (const int32_t method :
       {WRC_TANGENTIAL_STRIP_FASTSIM, WRC_TANGENTIAL_FASTSIM, WRC_TANGENTIAL_FASTRIP}) {
    config.tangential.method = method;
    create();
    for (const int32_t law : speed_laws) {
      const auto solved = [&](int32_t speed_law, int32_t temperature_law) {
        solve(speed_law, temperature_law);
        return coefficients();
      };
      SCOPED_TRACE(testing::Message() << method << ' ' << law);
      expect_between(law, solved);
    }
  }
}

// A wheel that slides by a fixed share of its speed, on the tread and on two regions.
TEST_F(WheelFrictionFactors, FallWithTheSpeedWithoutJumps) {
  create();
  for (const int32_t law : speed_laws) {
    for (const double y : {2e-3, 6.6e-3}) {
      SCOPED_TRACE(testing::Message() << law << ' ' << y);
      wheel.y = y;
      wheel.z = y > 5e-3 ? -0.3e-3 : 0.2e-3;
      expect_smooth_fall([&](double speed) {
        wheel.velocity[0] = speed;
        slide(0.02);
        solve(law, WRC_TEMPERATURE_LAW_LINEAR);
        return wrench.force[0] / wrench.normal_force;
      });
    }
  }
}

TEST_F(WheelFrictionFactors, BackwardsAndLeftAreMirrorImages) {
  create();
  wheel.velocity[1] = 0.05;
  solve(WRC_SPEED_LAW_EXPONENTIAL, WRC_TEMPERATURE_LAW_LINEAR);
  const wrc_wrench right = wrench;
  wheel.velocity[0] = -wheel.velocity[0];
  wheel.angular_velocity[1] = -wheel.angular_velocity[1];
  solve(WRC_SPEED_LAW_EXPONENTIAL, WRC_TEMPERATURE_LAW_LINEAR);
  EXPECT_NEAR(wrench.force[0], -right.force[0], 1e-9 * std::abs(right.force[0]));
  wheel.velocity[0] = -wheel.velocity[0];
  wheel.angular_velocity[1] = -wheel.angular_velocity[1];
  take(WRC_SIDE_LEFT);
  wheel.y = -wheel.y;
  wheel.velocity[1] = -wheel.velocity[1];
  solve(WRC_SPEED_LAW_EXPONENTIAL, WRC_TEMPERATURE_LAW_LINEAR);
  EXPECT_EQ(wrench.force[0], right.force[0]);
  EXPECT_EQ(wrench.force[1], -right.force[1]);
}

}  // namespace
