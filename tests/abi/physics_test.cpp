/// Physics that any correct library must show at its interface, whatever its methods: mirror images, reversed
/// motion, equilibrium, limits, continuity. Links the shared library and nothing of its inside.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "field_values.hpp"
#include "presets.hpp"
#include "reference_contact.hpp"
#include "test_config.hpp"

namespace {

/// Where a wheelset is and how it creeps.
struct Motion {
  double lateral = 0.0, yaw = 0.0, roll = 0.0;
  double longitudinal = 0.0, side = 0.0, spin = 0.0;
};

/// One wheel of a wheelset on its rail.
class Wheel : public ReferenceWheel {
 public:
  Wheel() {
    config.track.rail_inclination = 0.025;
    rail.kind = WRC_PROFILE_60E1;
    friction.coefficient = 0.3;
    creepage.speed = 20.0;
  }

  int32_t roll(const Motion& motion) {
    pose = {motion.lateral, motion.roll, motion.yaw, {}};
    creep(motion);
    return step();
  }
  /// On a gap h = y^2 / (2 R) that is the same on both sides of y = 0.
  int32_t roll_on_symmetric_gap(const Motion& motion) {
    constexpr uint32_t rows = 101;
    double y[rows], height[rows], curvature[rows];
    for (uint32_t j = 0; j < rows; ++j) {
      y[j] = 2e-4 * (static_cast<double>(j) - 50.0);
      height[j] = 0.5 * y[j] * y[j] / 0.3;
      curvature[j] = 1.0 / 0.46;
    }
    wrc_planar_gap gap = sized<wrc_planar_gap>();
    gap.row_count = rows;
    gap.y = y;
    gap.height = height;
    gap.curvature = curvature;
    creep(motion);
    input.gap = &gap;
    const int32_t status = step();
    input.gap = nullptr;
    return status;
  }
  int32_t roll_on(const wrc_ellipse& own, const Motion& motion) {
    if (model == nullptr) create();
    creep(motion);
    return wrc_planar_tangential(contact, &own, &creepage, &friction, &forces);
  }
  FieldValues field(int32_t id, int32_t of_patch = 0) const {
    FieldValues found = field_values(contact, of_patch, id);
    EXPECT_EQ(found.status, WRC_OK) << id;
    return found;
  }
  /// Integral of a field of cells over all patches.
  double integral(int32_t id) const {
    double sum = 0.0;
    for (int32_t k = 0; k < normal.patch_count; ++k) {
      const FieldValues values = field(id, k), width = field(WRC_FIELD_STRIP_WIDTH, k),
                        half = field(WRC_FIELD_STRIP_HALF_LENGTH, k);
      for (std::size_t j = 0; j < values.strips; ++j)
        for (std::size_t i = 0; i < values.cells; ++i)
          sum += values.at(i, j) * width[j] * 2.0 * half[j] / static_cast<double>(values.cells);
    }
    return sum;
  }
  double creep_force() const { return std::hypot(forces.fx, forces.fy); }

 private:
  void creep(const Motion& motion) {
    creepage.longitudinal = motion.longitudinal;
    creepage.lateral = motion.side;
    creepage.spin = motion.spin;
  }
};

struct Methods {
  int32_t normal, tangential;  ///< a value of the interface, and the number of a published method
};
class Physics : public testing::TestWithParam<Methods> {
 protected:
  void choose(Wheel& wheel) const {
    wheel.config.normal.method = GetParam().normal;
    choose_tangential(wheel.config, GetParam().tangential);
  }
};

std::vector<Methods> all_methods() {
  std::vector<Methods> all;
  for (int32_t normal = 0; normal < normal_methods; ++normal) {
    const bool usual = normal == WRC_NORMAL_EKP || normal == WRC_NORMAL_STRIP_HALFSPACE;
    for (int32_t tangential = 0; tangential < tangential_methods; ++tangential) {
      const int32_t method = presets[tangential].method;
      if (!gives_tractions(tangential)) continue;  // has tests of its own
      if (usual || method == WRC_TANGENTIAL_FASTSIM || method == WRC_TANGENTIAL_STRIP_FASTSIM)
        all.push_back({normal, tangential});
    }
  }
  return all;
}
INSTANTIATE_TEST_SUITE_P(Methods, Physics, testing::ValuesIn(all_methods()), [](const auto& each) {
  return std::string(normal_names[each.param.normal]) + "_" + presets[each.param.tangential].identifier;
});

// ---------------------------------------------------------------------------------------------- symmetries

TEST_P(Physics, LeftWheelIsTheMirrorImageOfTheRight) {
  Wheel right, left;
  choose(right);
  choose(left);
  left.side = WRC_SIDE_LEFT;
  for (const Motion& m :
       {Motion{}, Motion{0.003, 0.004, 0.0, 5e-4, -1e-3, 0.3}, Motion{-0.004, -0.01, 2e-4, -2e-3, 1e-4, -0.2},
        Motion{0.0055, 0.02, 0.0, 1e-4, 4e-4, 2.0}}) {
    // Mirrored in the plane y = 0: lateral quantities and rotations about x and z change sign.
    const Motion mirrored{-m.lateral, -m.yaw, -m.roll, m.longitudinal, -m.side, -m.spin};
    const int32_t status = right.roll(m);
    ASSERT_EQ(status, left.roll(mirrored));
    ASSERT_GE(status, 0);
    if (status == WRC_FLAG_ITERATION_CAP) continue;  // the last iterate is not promised to be symmetric
    // The half-space method ends when its strips move little, and joins far strips in pairs from one side:
    // how far is left depends on its path, 5e-4 of the peak at most.
    const bool iterated = GetParam().normal == WRC_NORMAL_STRIP_HALFSPACE;
    const double share = iterated ? 5e-4 : 1e-7;
    const double force = share * right.forces.fn, moment = force * right.normal.length;
    EXPECT_NEAR(right.forces.fx, left.forces.fx, force);
    EXPECT_NEAR(right.forces.fy, -left.forces.fy, force);
    EXPECT_NEAR(right.forces.mz, -left.forces.mz, moment);
    // Strong spin multiplies what is left of the borders' asymmetry.
    EXPECT_NEAR(right.forces.power, left.forces.power, 4.0 * share * right.forces.power + 1e-9);
    EXPECT_NEAR(right.normal.y_min, -left.normal.y_max, iterated ? 1e-6 : 1e-9);
    EXPECT_NEAR(right.normal.ellipse.psi, -left.normal.ellipse.psi, iterated ? 5e-4 : 1e-6);
    EXPECT_NEAR(right.normal.peak_pressure, left.normal.peak_pressure,
                10.0 * share * left.normal.peak_pressure);
    EXPECT_NEAR(right.point.y, -left.point.y, 1e-9);
    EXPECT_NEAR(right.point.angle, -left.point.angle, 1e-9);
    EXPECT_NEAR(right.point.x, left.point.x, 1e-9);
  }
}

TEST_P(Physics, ReversedCreepageReversesTheForces) {
  Wheel wheel;
  choose(wheel);
  for (double size : {0.01, 1.0, 100.0}) {
    const Motion m{0.002, 0.0, 0.0, 5e-4 * size, -1e-3 * size, 0.3 * size};
    ASSERT_GE(wheel.roll(m), 0);
    const wrc_planar_forces forward = wheel.forces;
    ASSERT_GE(wheel.roll({m.lateral, m.yaw, m.roll, -m.longitudinal, -m.side, -m.spin}), 0);
    EXPECT_EQ(wheel.forces.fx, -forward.fx);
    EXPECT_EQ(wheel.forces.fy, -forward.fy);
    EXPECT_EQ(wheel.forces.mz, -forward.mz);
    EXPECT_EQ(wheel.forces.power, forward.power);
  }
}

TEST_P(Physics, ASymmetricGapGivesASymmetricFieldUnderPureLongitudinalCreepage) {
  Wheel wheel;
  choose(wheel);
  ASSERT_GE(wheel.roll_on_symmetric_gap({0.0, 0.0, 0.0, 8e-4, 0.0, 0.0}), 0);
  EXPECT_NEAR(wheel.forces.fy, 0.0, 1e-6 * std::fabs(wheel.forces.fx));
  EXPECT_NEAR(wheel.forces.mz, 0.0, 1e-6 * std::fabs(wheel.forces.fx) * wheel.normal.width);
  EXPECT_NEAR(wheel.normal.ellipse.psi, 0.0, 1e-6);
  const FieldValues traction = wheel.field(WRC_FIELD_TRACTION_X), pressure = wheel.field(WRC_FIELD_PRESSURE);
  const std::size_t strips = traction.strips;
  for (std::size_t i = 0; i < traction.cells; ++i) {
    for (std::size_t j = 0; j < strips / 2; ++j) {
      const std::size_t there = strips - 1 - j;
      ASSERT_NEAR(traction.at(i, j), traction.at(i, there), 1e-5 * 0.3 * wheel.normal.peak_pressure);
      ASSERT_NEAR(pressure.at(i, j), pressure.at(i, there), 1e-5 * wheel.normal.peak_pressure);
    }
  }
}

// --------------------------------------------------------------------------------------------- equilibrium

TEST_P(Physics, LoadFromApproachFromLoadIsTheSame) {
  Wheel wheel;
  choose(wheel);
  for (double load : {1e3, 80e3, 200e3}) {
    wheel.load.prescribed = WRC_PRESCRIBE_NORMAL_FORCE;
    wheel.load.normal_force = load;
    ASSERT_GE(wheel.roll({}), 0);
    const double peak = wheel.normal.peak_pressure;
    wheel.load.approach = wheel.normal.approach;
    wheel.load.prescribed = WRC_PRESCRIBE_APPROACH;
    ASSERT_GE(wheel.roll({}), 0);
    // The half-space method ends when a sweep moves less than 0.5 % of its area.
    const bool iterated = GetParam().normal == WRC_NORMAL_STRIP_HALFSPACE;
    EXPECT_NEAR(wheel.forces.fn, load, (iterated ? 5e-3 : 1e-6) * load);
    EXPECT_NEAR(wheel.normal.peak_pressure, peak, (iterated ? 1e-2 : 1e-6) * peak);
  }
}

TEST_P(Physics, ThePressureFieldCarriesTheLoad) {
  Wheel wheel;
  choose(wheel);
  wheel.config.planar.cells = 200;
  ASSERT_GE(wheel.roll({0.001, 0.0, 0.0, 1e-3, 0.0, 0.1}), 0);
  EXPECT_NEAR(wheel.integral(WRC_FIELD_PRESSURE), wheel.forces.fn,
              3e-4 * wheel.forces.fn);  // midpoint rule at the edge of an ellipse: 200^-1.5
}

TEST_P(Physics, PowerIsTheIntegralOfItsField) {
  Wheel wheel;
  choose(wheel);
  for (double spin : {0.0, 0.5, 5.0}) {
    ASSERT_GE(wheel.roll({0.002, 0.0, 0.0, 1e-3, -2e-3, spin}), 0);
    EXPECT_NEAR(wheel.integral(WRC_FIELD_POWER_DENSITY), wheel.forces.power, 1e-9 * wheel.forces.power);
    EXPECT_NEAR(wheel.damage.power, wheel.forces.power, 1e-9 * wheel.forces.power);
    EXPECT_NEAR(wheel.damage.t_gamma, wheel.forces.power / wheel.creepage.speed, 1e-9 * wheel.damage.t_gamma);
  }
}

/// What forces and creepages spend is what friction dissipates: V (-Fx nu_x - Fy nu_y - Mz phi). Exactly so
/// on fine grids without spin; under spin only nearly, because the flexibilities of spin are not those by
/// which slip follows from tractions.
TEST_P(Physics, PowerIsForceTimesCreepage) {
  Wheel wheel;
  choose(wheel);
  wheel.config.planar.cells = 256;
  for (const Motion& m :
       {Motion{0.001, 0.0, 0.0, 2e-3, 0.0, 0.0}, Motion{0.001, 0.0, 0.0, 0.0, -2e-3, 0.0},
        Motion{0.001, 0.0, 0.0, 1e-3, -2e-3, 0.0}, Motion{0.001, 0.0, 0.0, 1e-3, -2e-3, 0.2},
        Motion{0.001, 0.0, 0.0, 0.03, 0.02, 1.0}}) {
    ASSERT_GE(wheel.roll(m), 0);
    const wrc_planar_forces& f = wheel.forces;
    const double spent = -wheel.creepage.speed * (f.fx * m.longitudinal + f.fy * m.side + f.mz * m.spin);
    EXPECT_NEAR(f.power, spent, (m.spin == 0.0 ? 0.01 : 0.1) * spent) << m.longitudinal << " " << m.side;
  }
}

// -------------------------------------------------------------------------------------------------- limits

/// Along the axes exactly. Between them the simplified theory turns the force towards the axis of the smaller
/// flexibility, tan = (nu_y / L2) / (nu_x / L1): up to 6 degrees, a known property of FASTSIM and no fault
/// here.
TEST_P(Physics, FullSlidingOpposesTheCreepageWithAllTheFriction) {
  Wheel wheel;
  choose(wheel);
  for (int degrees = 0; degrees < 360; degrees += 15) {
    const double angle = degrees * std::acos(-1.0) / 180.0;
    ASSERT_GE(wheel.roll({0.0, 0.0, 0.0, 0.5 * std::cos(angle), 0.5 * std::sin(angle), 0.0}), 0);
    const double limit = wheel.friction.coefficient * wheel.forces.fn;
    EXPECT_NEAR(wheel.creep_force(), limit, 1e-3 * limit) << degrees;
    const double across = wheel.forces.fx * std::sin(angle) - wheel.forces.fy * std::cos(angle);
    EXPECT_NEAR(across, 0.0, (degrees % 90 == 0 ? 1e-9 : 0.11) * limit) << degrees;
    EXPECT_LT(wheel.forces.fx * std::cos(angle) + wheel.forces.fy * std::sin(angle), 0.0) << degrees;
  }
}

TEST_P(Physics, MoreCreepageNeverMeansLessForce) {
  Wheel wheel;
  choose(wheel);
  double before = 0.0;
  for (double creepage = 1e-6; creepage < 0.1; creepage *= 1.3) {
    ASSERT_GE(wheel.roll({0.0, 0.0, 0.0, creepage, 0.0, 0.0}), 0);
    EXPECT_GE(wheel.creep_force(), before * (1.0 - 1e-3)) << creepage;
    before = wheel.creep_force();
  }
}

/// Forces scale: G and p by a factor, lengths kept, forces by the same factor.
TEST_P(Physics, StifferBodiesUnderMoreLoadAreTheSameProblem) {
  Wheel soft, stiff;
  choose(soft);
  choose(stiff);
  stiff.config.wheel_material.shear_modulus = stiff.config.rail_material.shear_modulus =
      2.0 * soft.config.wheel_material.shear_modulus;
  stiff.load.normal_force = 2.0 * soft.load.normal_force;
  const Motion m{0.002, 0.0, 0.0, 1e-3, -5e-4, 0.2};
  ASSERT_GE(soft.roll(m), 0);
  ASSERT_GE(stiff.roll(m), 0);
  EXPECT_NEAR(stiff.normal.area, soft.normal.area, 1e-8 * soft.normal.area);
  EXPECT_NEAR(stiff.forces.fx, 2.0 * soft.forces.fx, 1e-7 * std::fabs(soft.forces.fx));
  EXPECT_NEAR(stiff.forces.fy, 2.0 * soft.forces.fy, 1e-7 * std::fabs(soft.forces.fy));
  EXPECT_NEAR(stiff.forces.mz, 2.0 * soft.forces.mz, 1e-7 * std::fabs(soft.forces.mz));
}

TEST(LinearLimit, SmallCreepageFollowsTheCoefficientsOfTheDoubleEllipse) {
  Wheel wheel;
  wheel.config.tangential.method = WRC_TANGENTIAL_FASTSIM;
  wheel.config.planar.strips = 200;
  wheel.config.planar.cells = 200;
  wheel.friction.coefficient = 2.0;
  for (double psi : {0.0, 0.3, -0.5}) {
    wrc_ellipse own = sized<wrc_ellipse>();
    own.a = 6e-3;
    own.b = 4e-3;
    own.psi = psi;
    own.normal_force = 100e3;
    wrc_coefficients c{};
    ASSERT_EQ(wrc_linear_coefficients(own.a / own.b, psi, wheel.config.wheel_material.poisson, &c), WRC_OK);
    const double stiffness = wheel.config.wheel_material.shear_modulus * own.a * own.b,
                 length = std::sqrt(own.a * own.b);
    const double small = 1e-8;
    ASSERT_GE(wheel.roll_on(own, {0.0, 0.0, 0.0, small, 0.0, 0.0}), 0);
    EXPECT_NEAR(-wheel.forces.fx / small, stiffness * c.c11s, 2e-3 * stiffness * c.c11s) << psi;
    ASSERT_GE(wheel.roll_on(own, {0.0, 0.0, 0.0, 0.0, small, 0.0}), 0);
    EXPECT_NEAR(-wheel.forces.fy / small, stiffness * c.c22s, 2e-3 * stiffness * c.c22s) << psi;
    ASSERT_GE(wheel.roll_on(own, {0.0, 0.0, 0.0, 0.0, 0.0, small / length}), 0);
    EXPECT_NEAR(std::fabs(wheel.forces.fy) / small, stiffness * std::fabs(c.c23s), 5e-3 * stiffness * c.c22s)
        << psi;
    EXPECT_NEAR(std::fabs(wheel.forces.fx) / small, stiffness * std::fabs(c.c13s), 5e-3 * stiffness * c.c11s)
        << psi;
  }
}

// ---------------------------------------------------------------------------------------------- continuity

/// A wheelset wandering from one rail to the other: every step works, for both wheels and all normal methods.
TEST(Continuity, NoStepOfALateralScanFails) {
  for (int32_t method = WRC_NORMAL_HERTZ; method <= WRC_NORMAL_STRIP_HALFSPACE; ++method) {
    for (int32_t side : {WRC_SIDE_RIGHT, WRC_SIDE_LEFT}) {
      Wheel wheel;
      wheel.side = side;
      wheel.config.normal.method = method;
      double area_before = 0.0, fy_before = 0.0, largest_area = 0.0, largest_fy = 0.0, at_area = 0.0,
             at_fy = 0.0;
      int capped = 0;
      for (int i = -120; i <= 140; ++i) {
        const double lateral = 0.05e-3 * i;
        const int32_t status = wheel.roll({lateral, 0.0, 0.0, 5e-4, -1e-3, 0.2});
        ASSERT_GE(status, 0) << "method " << method << " side " << side << " at " << 1e3 * lateral << " mm";
        capped += status == WRC_FLAG_ITERATION_CAP;
        EXPECT_NEAR(wheel.forces.fn, 80e3, 1e-3) << "method " << method << " at " << 1e3 * lateral << " mm";
        if (i > -120) {
          const double area = std::fabs(wheel.normal.area - area_before) / area_before;
          const double fy =
              std::fabs(wheel.forces.fy - fy_before) / (wheel.friction.coefficient * wheel.forces.fn);
          if (area > largest_area) largest_area = area, at_area = lateral;
          if (fy > largest_fy) largest_fy = fy, at_fy = lateral;
        }
        area_before = wheel.normal.area;
        fy_before = wheel.forces.fy;
      }
      std::printf(
          "normal method %d, %s wheel: largest jumps over 0.05 mm: area %.0f %% at %.2f mm, Fy %.0f %% of "
          "mu N at %.2f mm; %d flagged\n",
          method, side == WRC_SIDE_RIGHT ? "right" : "left", 100.0 * largest_area, 1e3 * at_area,
          100.0 * largest_fy, 1e3 * at_fy, capped);
    }
  }
}

/// A start that stays in the frame of the contact point lies beside the patch when the point leaps.
TEST(WarmStart, FollowsThePatchWhereTheFirstTouchLeapsAcrossTheTread) {
  Wheel warm, cold;
  for (Wheel* const wheel : {&warm, &cold}) wheel->config.normal.method = WRC_NORMAL_STRIP_HALFSPACE;
  warm.config.planar.start = WRC_START_WARM;
  int leaps = 0;
  double before = 0.0;
  for (int i = 0; i <= 160; ++i) {
    const Motion motion{.lateral = 0.05e-3 * (i - 80)};
    ASSERT_GE(warm.roll(motion), 0);
    const bool leapt = i > 0 && std::abs(warm.point.y_rail - before) > 5e-3;
    before = warm.point.y_rail;
    if (!leapt) continue;
    ++leaps;
    ASSERT_GE(cold.roll(motion), 0);
    std::printf("leap at %.2f mm: %d sweeps warm, %d cold\n", 1e3 * motion.lateral,
                static_cast<int>(warm.normal.iterations), static_cast<int>(cold.normal.iterations));
    EXPECT_LE(warm.normal.iterations, 3) << motion.lateral;
    EXPECT_NEAR(warm.normal.approach, cold.normal.approach, 2e-3 * cold.normal.approach) << motion.lateral;
    EXPECT_NEAR(warm.normal.area, cold.normal.area, 1e-2 * cold.normal.area) << motion.lateral;
  }
  EXPECT_GT(leaps, 0);
}

}  // namespace
