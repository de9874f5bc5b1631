/// Damping of the approach through the C interface: an impact loses what Hunt and Crossley's law says,
/// nothing ever pulls, the static limit and older callers see no difference.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

#include "reference_contact.hpp"
#include "test_config.hpp"

namespace {

class Damping : public ReferenceContact {
 protected:
  void SetUp() override {
    ReferenceContact::SetUp();
    load.prescribed = WRC_PRESCRIBE_APPROACH;
    load.approach = 67e-6;
  }
};

TEST_F(Damping, WithoutVelocityChangesNoBit) {
  ASSERT_EQ(step(), WRC_OK) << error();
  const wrc_planar_forces still = forces;
  const wrc_planar_normal_solution still_normal = normal;
  load.damping = 0.5;
  ASSERT_EQ(step(), WRC_OK) << error();
  EXPECT_EQ(forces.fn, still.fn);
  EXPECT_EQ(forces.fx, still.fx);
  EXPECT_EQ(forces.power, still.power);
  EXPECT_EQ(normal.peak_pressure, still_normal.peak_pressure);
  EXPECT_EQ(normal.stiffness, still_normal.stiffness);
  EXPECT_EQ(normal.damping_force, 0.0);
}

TEST_F(Damping, ScalesForcePressureAndTheirConsequencesAlike) {
  ASSERT_EQ(step(), WRC_OK) << error();
  const wrc_planar_forces still = forces;
  const wrc_planar_normal_solution still_normal = normal;
  load.damping = 0.2;
  load.approach_velocity = 0.5;
  ASSERT_EQ(step(), WRC_OK) << error();
  const double factor = 1.0 + 1.5 * 0.2 * 0.5;
  EXPECT_NEAR(forces.fn, factor * still.fn, 1e-12 * forces.fn);
  EXPECT_NEAR(normal.normal_force, forces.fn, 1e-12 * forces.fn);
  EXPECT_NEAR(normal.damping_force, forces.fn - still.fn, 1e-9 * forces.fn);
  EXPECT_NEAR(normal.peak_pressure, factor * still_normal.peak_pressure, 1e-12 * normal.peak_pressure);
  EXPECT_NEAR(normal.stiffness, factor * still_normal.stiffness, 1e-12 * normal.stiffness);
  EXPECT_EQ(normal.area, still_normal.area);
  EXPECT_NEAR(forces.power, damage.power, 1e-9 * forces.power);

  // At full sliding the creep force is friction times the whole force.
  creepage.longitudinal = -0.5;
  ASSERT_EQ(step(), WRC_OK) << error();
  EXPECT_NEAR(std::hypot(forces.fx, forces.fy), 0.35 * forces.fn, 2e-3 * forces.fn);
}

TEST_F(Damping, NeverPullsAndFadesToNothing) {
  load.damping = 1.0;
  double before = 1e9;
  for (double velocity : {0.0, -0.3, -0.6, -0.666, -0.66666666}) {
    load.approach_velocity = velocity;
    EXPECT_GE(step(), WRC_OK) << error();
    EXPECT_GT(forces.fn, 0.0);
    EXPECT_LT(forces.fn, before);
    EXPECT_LE(std::hypot(forces.fx, forces.fy), 0.35 * forces.fn * (1.0 + 1e-5));
    before = forces.fn;
  }
  for (double velocity : {-2.0 / 3.0, -0.67, -20.0}) {
    load.approach_velocity = velocity;
    EXPECT_EQ(step(), WRC_FLAG_NO_CONTACT);
    EXPECT_EQ(forces.fn, 0.0);
    EXPECT_EQ(forces.fx, 0.0);
    EXPECT_EQ(normal.damping_force, 0.0);
  }
  load.approach_velocity = 20.0;
  load.damping = 10.0;
  EXPECT_GE(step(), WRC_OK) << error();
  EXPECT_TRUE(std::isfinite(forces.fx));
}

TEST_F(Damping, LeavesAPrescribedLoadAlone) {
  load.prescribed = WRC_PRESCRIBE_NORMAL_FORCE;
  load.damping = 0.2;
  load.approach_velocity = 0.5;
  expect_works();
  EXPECT_EQ(normal.damping_force, 0.0);
}

TEST_F(Damping, IsChecked) {
  load.damping = -0.1;
  expect_refused(WRC_ERROR_RANGE, {"load.damping = -0.1 s/m", "0 .. 10"});
  load.damping = 1e5;
  expect_refused(WRC_ERROR_RANGE, {"load.damping", "viscous"});
  load.damping = nan_value;
  expect_refused(WRC_ERROR_NOT_FINITE, {"load.damping"});
  load.damping = 0.1;
  load.approach_velocity = 300.0;
  expect_refused(WRC_ERROR_RANGE, {"load.approach_velocity = 300 m/s", "mm/s"});
  load.approach_velocity = infinity;
  expect_refused(WRC_ERROR_NOT_FINITE, {"load.approach_velocity"});
}

TEST_F(Damping, VelocityComesFromTheWheelsetsMotion) {
  pose.lateral = -5e-3;  // an inclined contact plane
  ASSERT_EQ(wrc_planar_geometry(contact, &pose, &point), WRC_OK) << error();
  wrc_planar_motion motion = sized<wrc_planar_motion>();
  motion.vertical_velocity = 0.3;
  motion.lateral_velocity = -0.2;
  ASSERT_EQ(wrc_planar_creepages(contact, &motion, &creepage), WRC_FLAG_CREEPAGES_LIMITED);  // at standstill
  EXPECT_NEAR(creepage.approach_velocity, 0.3 * std::cos(point.angle) + 0.2 * std::sin(point.angle), 1e-12);
  EXPECT_EQ(creepage.longitudinal, 0.0);
}

/// A mass strikes the rail and rebounds: leapfrog, so that without damping the energy comes back.
struct Rebound {
  double restitution = 0.0, dissipated = 0.0, struck = 0.0, least_force = 0.0;
};

TEST_F(Damping, TakesEnergyOutOfAnImpactAsTheLawSays) {
  constexpr double mass = 600.0, speed = 0.2, step_size = 2e-5;
  const auto strike = [&](double damping) {
    load.damping = damping;
    Rebound rebound;
    double approach = 0.0, velocity = speed;
    for (int i = 0; i < 4000; ++i) {
      load.approach = approach + 0.5 * step_size * velocity;
      load.approach_velocity = velocity;
      EXPECT_GE(wrc_planar_normal(contact, nullptr, &load, &normal), WRC_OK) << error();
      rebound.least_force = std::fmin(rebound.least_force, normal.normal_force);
      const double before = velocity;
      velocity -= step_size * normal.normal_force / mass;
      approach = load.approach + 0.5 * step_size * velocity;
      rebound.dissipated += step_size * normal.damping_force * 0.5 * (velocity + before);
      if (approach < 0.0) break;
    }
    rebound.restitution = -velocity / speed;
    rebound.struck = 0.5 * mass * (speed * speed - velocity * velocity);
    return rebound;
  };
  ASSERT_EQ(wrc_planar_geometry(contact, &pose, &point), WRC_OK);
  const Rebound elastic = strike(0.0);
  EXPECT_NEAR(elastic.restitution, 1.0, 2e-3);
  for (double damping : {0.1, 0.25, 2.0}) {
    const Rebound damped = strike(damping);
    EXPECT_EQ(damped.least_force, 0.0);
    EXPECT_GT(damped.dissipated, 0.0);
    EXPECT_NEAR(damped.dissipated, damped.struck, 0.01 * 0.5 * mass * speed * speed);
    // First order in damping * speed, for a force that grows with the power 3/2 of the approach.
    const double x = damping * speed;
    EXPECT_NEAR(damped.restitution, 1.0 - x, 0.003 + x * x);
  }
}

}  // namespace
