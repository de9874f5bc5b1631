/// Rolling forward, backwards and not at all through the C interface: backwards is the mirror image of
/// forward, and the forces of a motion go through standstill without a jump.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include "field_values.hpp"
#include "presets.hpp"
#include "reference_contact.hpp"
#include "test_config.hpp"

namespace {

class RollingWay : public testing::Test, protected ReferenceWheel {
 protected:
  void create_with(int32_t preset) {
    choose_tangential(config, preset);
    friction.slope_fall = slope_fall_for(preset);
    create();
  }
  /// Empty where the method has none.
  std::vector<double> field(int32_t id) const {
    const FieldValues found = field_values(contact, 0, id);
    return found.status == WRC_OK ? found.values : std::vector<double>();
  }

  /// A pressure without any symmetry, in the contact's frame or mirrored at x = 0.
  int32_t take_strips(double mirror) {
    std::vector<double> y, width, centre, half, peak;
    for (int j = 0; j < 12; ++j) {
      const double s = (j - 4.3) / 8.0;
      y.push_back(8e-3 * s);
      width.push_back(1e-3);
      centre.push_back(mirror * (2e-4 + 4e-4 * s - 3e-4 * s * s));
      half.push_back(5e-3 * std::sqrt(1.05 - s * s));
      peak.push_back(9e8 * std::sqrt(1.05 - s * s) * (1.0 + 0.2 * s));
    }
    wrc_planar_strips strips = sized<wrc_planar_strips>();
    strips.count = 12;
    strips.y = y.data();
    strips.width = width.data();
    strips.centre = centre.data();
    strips.half_length = half.data();
    strips.peak = peak.data();
    return wrc_planar_regularise(contact, &strips, nullptr);
  }
  int32_t roll() { return wrc_planar_tangential(contact, nullptr, &creepage, &friction, &forces); }

  wrc_planar_motion motion = sized<wrc_planar_motion>();
  wrc_creepage kinematic = wrc_creepage_default();

  /// Geometry and normal problem of the pose, once for many motions.
  void press() {
    ASSERT_EQ(wrc_planar_geometry(contact, &pose, &point), WRC_OK);
    ASSERT_EQ(wrc_planar_normal(contact, nullptr, &load, &normal), WRC_OK);
  }
  /// From the motion to the forces, as a host goes.
  int32_t move() {
    const int32_t status = wrc_planar_creepages(contact, &motion, &kinematic);
    if (status < 0) return status;
    return std::max(status, wrc_planar_tangential(contact, nullptr, &kinematic, &friction, &forces));
  }
};

TEST_F(RollingWay, BackwardsIsTheMirrorImageOfForward) {
  friction.speed_law = WRC_SPEED_LAW_EXPONENTIAL;
  for (int32_t method = 0; method < tangential_methods; ++method) {
    create_with(method);
    for (const double size : {0.2, 1.0, 30.0}) {
      creepage = wrc_creepage_default();
      creepage.longitudinal = 1e-3 * size;
      creepage.lateral = -0.6e-3 * size;
      creepage.spin = 0.3 * size;
      creepage.speed = -25.0;
      ASSERT_EQ(take_strips(1.0), WRC_OK);
      ASSERT_GE(roll(), 0) << error();
      const wrc_planar_forces backwards = forces;
      ASSERT_EQ(wrc_contact_damage(contact, WRC_ALL_REGIONS, &damage), WRC_OK);
      const wrc_damage damaged = damage;
      std::vector<std::vector<double>> fields;
      for (int32_t id = 0; id <= WRC_FIELD_TEMPERATURE_RISE; ++id) fields.push_back(field(id));

      creepage.longitudinal *= -1.0;
      creepage.spin *= -1.0;
      creepage.speed = 25.0;
      ASSERT_EQ(take_strips(-1.0), WRC_OK);
      ASSERT_GE(roll(), 0) << error();
      ASSERT_EQ(wrc_contact_damage(contact, WRC_ALL_REGIONS, &damage), WRC_OK);
      EXPECT_EQ(backwards.fx, -forces.fx) << method;
      EXPECT_EQ(backwards.fy, forces.fy) << method;
      EXPECT_EQ(backwards.fn, forces.fn) << method;
      EXPECT_EQ(backwards.mz, -forces.mz) << method;
      EXPECT_EQ(backwards.power, forces.power) << method;
      EXPECT_GT(forces.power, 0.0) << method;
      EXPECT_EQ(backwards.adhesion_fraction, forces.adhesion_fraction) << method;
      EXPECT_EQ(std::memcmp(&damaged, &damage, sizeof damage), 0) << method;
      for (int32_t id = 0; id <= WRC_FIELD_TEMPERATURE_RISE; ++id) {
        const bool along_x = id == WRC_FIELD_X || id == WRC_FIELD_TRACTION_X || id == WRC_FIELD_SLIP_X ||
                             id == WRC_FIELD_STRIP_CENTRE;
        std::vector<double> mirrored = field(id);
        if (along_x)
          for (double& value : mirrored) value = 0.0 - value;
        EXPECT_EQ(fields[static_cast<std::size_t>(id)], mirrored) << method << ", field " << id;
      }
    }
  }
}

TEST_F(RollingWay, CellsCountFromTheLeadingEdge) {
  create();
  creepage.speed = -20.0;
  ASSERT_EQ(step(), WRC_OK);
  const FieldValues x = field_values(contact, 0, WRC_FIELD_X),
                    centre = field_values(contact, 0, WRC_FIELD_STRIP_CENTRE);
  ASSERT_GT(x.strips, 0U);
  for (std::size_t j = 0; j < centre.strips; ++j) {
    EXPECT_LT(x.at(0, j), centre[j]);
    EXPECT_GT(x.at(x.cells - 1, j), centre[j]);
  }
}

TEST_F(RollingWay, ForcesOpposeSlipWhicheverWayItRolls) {
  create();
  wrc_planar_forces of_way[2];
  for (int way = 0; way < 2; ++way) {
    creepage.speed = way == 0 ? 20.0 : -20.0;
    creepage.longitudinal = 0.1e-3;
    creepage.lateral = creepage.spin = 0.0;
    ASSERT_EQ(step(), WRC_OK);
    EXPECT_LT(forces.fx, 0.0);
    of_way[way] = forces;
  }
  EXPECT_NEAR(of_way[1].fx, of_way[0].fx, 1e-9 * std::fabs(of_way[0].fx));
  EXPECT_NEAR(of_way[1].power, of_way[0].power, 1e-9 * of_way[0].power);
}

TEST_F(RollingWay, SensitivitiesAreThoseOfTheForcesEitherWayAndBetween) {
  for (const int32_t method : {preset_strip_fastsim, preset_fastsim_sdec, preset_modified_fastsim}) {
    create_with(method);
    for (const double reverse_share : {0.0, 0.3, 0.5}) {
      creepage = wrc_creepage_default();
      creepage.longitudinal = -0.49e-3;
      creepage.lateral = -0.22e-3;
      creepage.spin = 0.29;
      creepage.speed = -5.0;
      creepage.reverse_share = reverse_share;
      const wrc_creepage at = creepage;
      ASSERT_GE(step(), 0) << error();
      wrc_planar_derivatives found = sized<wrc_planar_derivatives>();
      ASSERT_GE(wrc_planar_tangential_derivatives(contact, &found), 0) << error();
      for (int of = 0; of < 3; ++of) {
        const double h = of == 2 ? 2e-4 : 1e-6;
        wrc_planar_forces ends[2];
        for (int end = 0; end < 2; ++end) {
          creepage = at;
          (of == 0 ? creepage.longitudinal : of == 1 ? creepage.lateral : creepage.spin) += end == 0 ? -h : h;
          ASSERT_GE(roll(), 0);
          ends[end] = forces;
        }
        const double slope[] = {(ends[1].fx - ends[0].fx) / (2.0 * h), (ends[1].fy - ends[0].fy) / (2.0 * h),
                                (ends[1].mz - ends[0].mz) / (2.0 * h)};
        for (int r = 0; r < 3; ++r) {
          // What the larger of the two derivatives of this input is, moments over the patch's size.
          const double scale = std::max(std::fabs(slope[0]), std::fabs(slope[1])) * (r == 2 ? 5e-3 : 1.0);
          EXPECT_NEAR(found.forces[r][of], slope[r], 0.01 * scale)
              << method << ", row " << r << ", input " << of << ", " << reverse_share;
        }
      }
    }
  }
}

TEST_F(RollingWay, TheMotionBackwardsIsTheMirrorImageToo) {
  create();
  pose.lateral = 3e-3;
  pose.yaw = 8e-3;
  motion.speed = 12.0;
  motion.lateral_velocity = 0.02;
  motion.vertical_velocity = 0.01;
  motion.roll_rate = 0.03;
  motion.yaw_rate = 0.04;
  motion.pitch_rate = -26.1;
  press();
  ASSERT_EQ(move(), WRC_OK);
  const wrc_creepage forward = kinematic;
  const wrc_planar_forces driven = forces;
  EXPECT_EQ(forward.reverse_share, 0.0);

  pose.yaw *= -1.0;
  motion.speed *= -1.0;
  motion.yaw_rate *= -1.0;
  motion.pitch_rate *= -1.0;
  press();
  ASSERT_EQ(move(), WRC_OK);
  EXPECT_NEAR(kinematic.longitudinal, -forward.longitudinal, 1e-12);
  EXPECT_NEAR(kinematic.lateral, forward.lateral, 1e-12);
  EXPECT_NEAR(kinematic.spin, -forward.spin, 1e-9);
  EXPECT_NEAR(kinematic.speed, -forward.speed, 1e-12);
  EXPECT_NEAR(kinematic.approach_velocity, forward.approach_velocity, 1e-12);
  const double limit = 0.35 * 80e3;
  EXPECT_NEAR(forces.fx, -driven.fx, 1e-6 * limit);
  EXPECT_NEAR(forces.fy, driven.fy, 1e-6 * limit);
  EXPECT_NEAR(forces.mz, -driven.mz, 1e-8 * limit);
  EXPECT_NEAR(forces.power, driven.power, 1e-6 * driven.power);
  EXPECT_GT(forces.power, 0.0);
}

TEST_F(RollingWay, ForcesGoThroughStandstillWithoutAJump) {
  create();
  pose.lateral = 4e-3;  // on the tread's cone: spin
  pose.yaw = 2e-3;
  press();
  const double limit = friction.coefficient * load.normal_force;
  struct Rates {
    double lateral, yaw, slip;  ///< [m/s], [rad/s], of the circumference ahead of `driven` [m/s]
    bool rolls;                 ///< is the wheel driven at the speed of travel, or at that of its middle, 0?
  };
  using Forces = std::array<double, 3>;
  const auto forces_at = [&](const Rates& rates, double speed) {
    motion = sized<wrc_planar_motion>();
    motion.speed = speed;
    motion.lateral_velocity = rates.lateral;
    motion.yaw_rate = rates.yaw;
    motion.pitch_rate = -((rates.rolls ? speed : 0.0) + rates.slip) / point.rolling_radius;
    EXPECT_GE(move(), 0) << error();
    EXPECT_GE(forces.power, 0.0);
    EXPECT_LE(std::hypot(forces.fx, forces.fy), limit * (1.0 + 1e-9));
    return Forces{forces.fx / limit, forces.fy / limit, forces.mz / (5e-3 * limit)};
  };
  const auto change = [](const Forces& from, const Forces& to) {
    double largest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) largest = std::max(largest, std::fabs(to[k] - from[k]));
    return largest;
  };
  double largest_second = 0.0, largest_left = 0.0;
  for (const Rates& rates :
       {Rates{0.0, 0.0, 0.0, true}, Rates{2e-4, 0.0, 0.0, true}, Rates{-1e-3, 0.0, 2e-4, true},
        Rates{0.02, 0.0, -0.01, true}, Rates{0.0, 1e-3, 0.0, true}, Rates{5e-4, -0.05, 1e-3, true},
        Rates{0.5, 0.3, 0.2, true}, Rates{0.0, 0.0, 1e-4, true}, Rates{0.0, 0.0, 0.0, false},
        Rates{1e-3, 0.0, 0.3, false}, Rates{0.0, 0.01, -0.2, false}, Rates{0.3, -0.2, 0.05, false}}) {
    // Steps of 1 mm/s; where they change the forces most, bisected.
    Forces before{}, last = forces_at(rates, -0.5);
    double steepest = 0.0, from = 0.0, second = 0.0;
    for (int i = -499; i <= 500; ++i) {
      const Forces now = forces_at(rates, 1e-3 * i);
      if (change(last, now) > steepest) {
        steepest = change(last, now);
        from = 1e-3 * (i - 1);
      }
      for (std::size_t k = 0; k < 3 && i > -499; ++k)
        second = std::max(second, std::fabs(now[k] - 2.0 * last[k] + before[k]));
      before = last;
      last = now;
    }
    // A wheel that is not driven at its speed passes from sliding one way to sliding the other within 1 mm/s.
    if (rates.rolls) largest_second = std::max(largest_second, second);
    double to = from + 1e-3, left = 0.0;
    for (int k = 0; k < 16; ++k) {
      const double middle = 0.5 * (from + to);
      const Forces low = forces_at(rates, from), half = forces_at(rates, middle), high = forces_at(rates, to);
      const bool lower = change(low, half) > change(half, high);
      left = std::max(change(low, half), change(half, high));
      (lower ? to : from) = middle;
    }
    largest_left = std::max(largest_left, left);
    EXPECT_LT(left, 1e-3) << rates.lateral << " " << rates.yaw << " " << rates.slip << " " << from;
  }
  // Of friction x load: 7e-4 and 3e-4 (in 15 nm/s).
  std::printf(
      "largest second difference over 1 mm/s of a rolling wheel %.2g, largest change left after "
      "bisection %.2g of friction x load\n",
      largest_second, largest_left);
  EXPECT_LT(largest_second, 1e-3);
}

TEST_F(RollingWay, AWheelThatSlidesAtRestIsBrakedByFriction) {
  create();
  press();
  const double limit = friction.coefficient * load.normal_force;
  for (const double velocity : {0.01, 0.3, 3.0}) {
    for (int k = 0; k < 16; ++k) {
      // The wheel's point slides by `velocity` in this direction while V = 0.
      const double angle = k * std::acos(-1.0) / 8.0;
      const double vx = velocity * std::cos(angle), vy = velocity * std::sin(angle);
      motion = sized<wrc_planar_motion>();
      motion.speed = 0.5 * vx;
      motion.pitch_rate = 0.5 * vx / point.rolling_radius;
      motion.lateral_velocity = vy / std::cos(point.angle);
      ASSERT_EQ(move(), WRC_FLAG_CREEPAGES_LIMITED);
      EXPECT_NEAR(kinematic.reverse_share, 0.5, 1e-9);
      const double force = std::hypot(forces.fx, forces.fy);
      EXPECT_NEAR(force, limit, 0.01 * limit) << velocity << " " << k;
      EXPECT_LT((forces.fx * vx + forces.fy * vy) / (force * velocity), -0.999) << velocity << " " << k;
      EXPECT_NEAR(forces.power, limit * velocity, 0.02 * limit * velocity);
    }
  }
  // Slowly it is held as by a damper: a tenth of friction at a hundredth of a millimetre per second or so.
  motion = sized<wrc_planar_motion>();
  motion.lateral_velocity = 1e-5;
  ASSERT_EQ(move(), WRC_FLAG_CREEPAGES_LIMITED);
  EXPECT_LT(forces.fy, -0.01 * limit);
  EXPECT_GT(forces.fy, -0.5 * limit);
  const double held = forces.fy;
  motion.lateral_velocity = -1e-5;
  ASSERT_EQ(move(), WRC_FLAG_CREEPAGES_LIMITED);
  EXPECT_NEAR(forces.fy, -held, 1e-3 * limit);
  motion.lateral_velocity = 0.0;
  ASSERT_EQ(move(), WRC_FLAG_CREEPAGES_LIMITED);
  EXPECT_EQ(forces.fx, 0.0);
  EXPECT_EQ(forces.fy, 0.0);
  EXPECT_EQ(forces.power, 0.0);
}

TEST_F(RollingWay, LockedAndSpinningWheelsSlideAsTheyShould) {
  create();
  press();
  const double limit = friction.coefficient * load.normal_force;
  motion.speed = -15.0;  // locked, sliding backwards
  ASSERT_EQ(move(), WRC_OK);
  EXPECT_DOUBLE_EQ(kinematic.longitudinal, -2.0);
  EXPECT_DOUBLE_EQ(kinematic.speed, -7.5);
  EXPECT_NEAR(forces.fx, limit, 1e-3 * limit);
  EXPECT_NEAR(forces.power, 15.0 * limit, 1e-2 * 15.0 * limit);
  motion.speed = 0.0;  // spinning on the spot, as if to drive forward
  motion.pitch_rate = -15.0 / point.rolling_radius;
  ASSERT_EQ(move(), WRC_OK);
  EXPECT_NEAR(kinematic.longitudinal, -2.0, 1e-9);
  EXPECT_NEAR(kinematic.speed, 7.5, 1e-9);
  EXPECT_NEAR(forces.fx, limit, 1e-3 * limit);
}

TEST_F(RollingWay, NoMotionGivesCreepagesThatAreRefused) {
  config.tangential.method = WRC_TANGENTIAL_FASTSIM;
  config.planar.strips = config.planar.cells = 8;
  create();
  std::mt19937_64 numbers(7);
  const auto between = [&](double most) {  // every order of magnitude, both signs, the ends, zero
    const double u = static_cast<double>(numbers() >> 11) * 0x1p-53;
    const double sign = numbers() % 2 == 0 ? 1.0 : -1.0;
    const auto kind = numbers() % 8;
    return kind == 0 ? 0.0 : kind == 1 ? sign * most : sign * most * std::pow(10.0, -12.0 * u);
  };
  int limited = 0;
  for (const double lateral : {0.0, -5e-3, 6.8e-3}) {
    pose.lateral = lateral;
    pose.yaw = 2.0 * lateral;
    press();
    for (int i = 0; i < 20000; ++i) {
      motion.speed = between(200.0);
      motion.lateral_velocity = between(20.0);
      motion.vertical_velocity = between(20.0);
      motion.roll_rate = between(100.0);
      motion.yaw_rate = between(100.0);
      motion.pitch_rate = between(2000.0);
      const int32_t status = move();
      ASSERT_GE(status, 0) << error();
      ASSERT_TRUE(std::isfinite(forces.fx) && std::isfinite(forces.fy) && forces.power >= 0.0);
      // Both calls say so, or none: but for creepages cut at a speed where one way is enough.
      limited += status == WRC_FLAG_CREEPAGES_LIMITED;
      ASSERT_EQ(status == WRC_FLAG_CREEPAGES_LIMITED || kinematic.reverse_share == 0.0, true);
    }
  }
  EXPECT_GT(limited, 1000);
}

TEST_F(RollingWay, SharesAndSpeedsOutsideTheirRangeAreNamed) {
  create();
  creepage.speed = -250.0;
  expect_refused(WRC_ERROR_RANGE, {"creepage.speed = -250 m/s is outside -200 .. 200 m/s"});
  creepage.speed = 1.0;
  creepage.reverse_share = 0.6;
  expect_refused(WRC_ERROR_RANGE, {"creepage.reverse_share = 0.6 is outside 0 .. 0.5"});
  creepage.reverse_share = 0.2;
  EXPECT_EQ(step(), WRC_FLAG_CREEPAGES_LIMITED);
  expect_words(error(), {"creepage.reverse_share = 0.2"});
  creepage.reverse_share = 0.0;
  motion.speed = -201.0;
  EXPECT_EQ(wrc_planar_creepages(contact, &motion, &kinematic), WRC_ERROR_RANGE);
  expect_words(error(), {"motion.speed = -201 m/s is outside -200 .. 200 m/s"});
  expect_works();
}

}  // namespace
