#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "abi/structs.hpp"
#include "abi/wear.hpp"
#include "damage/cells.hpp"
#include "damage/fatigue.hpp"
#include "damage/frictional_power.hpp"
#include "damage/wear.hpp"
#include "kernels/kernels.hpp"
#include "tangential/methods/fastsim.hpp"
#include "tangential_patches.hpp"

namespace wrc::damage {
namespace {

TEST(FrictionalPower, DensityAddsUpToThePowerOfTheMarch) {
  const double a = 4.25e-3, b = 6.375e-3, N = 2.0 / 3.0 * pi * a * b * 300e6, V = 20.0;
  const test::OwnedStrips strips = test::sdec_strips(a, b, 0.4, N, 30);
  const test::OwnedGrid grid(40);
  const theory::SdecTable table(0.25);
  Fault fault;
  std::vector<double> px(1200), py(px), sx(px), sy(px), density(px), index(px), per_width(30);
  const tangential::TangentialFields fields{px.data(), py.data(), sx.data(), sy.data()};
  const tangential::RollingContact contact{strips.get(),
                                           a,
                                           b,
                                           0.4,
                                           80e9,
                                           &table,
                                           &grid.get(),
                                           {-0.49e-3, -0.22e-3, 0.29},
                                           0.35,
                                           tangential::TractionBound::parabolic};
  const tangential::TangentialForces forces = tangential::fastsim(contact, fields, fault);
  const patch::Strips region = strips.get();
  const CellDamage found = assess_cells(
      {&region, &fields, &grid.get().middles, 40, V, 250e6, density.data(), index.data(), per_width.data()},
      kernels_for(InstructionSet::baseline));
  EXPECT_GE(*std::min_element(density.begin(), density.end()), 0.0);
  EXPECT_EQ(*std::max_element(density.begin(), density.end()), found.peak_power_density);
  EXPECT_EQ(*std::max_element(index.begin(), index.end()), found.fatigue_index);
  EXPECT_NEAR(found.power, V * t_gamma(forces), 1e-9 * V * t_gamma(forces));
}

TEST(Fatigue, IndexIsZeroWhereTractionReachesTheYieldStress) {
  const tangential::TangentialForces forces{.fx = 3e4, .fy = 4e4};
  const ShakedownPoint point = shakedown_point(forces, 1e5, 500e6, 250e6);
  EXPECT_DOUBLE_EQ(point.utilised_friction, 0.5);
  EXPECT_DOUBLE_EQ(point.load_factor, 2.0);
  EXPECT_DOUBLE_EQ(fatigue_index(point), 0.0);
  EXPECT_LT(fatigue_index(shakedown_point(forces, 0.0, 0.0, 250e6)), -1.0);
}

TEST(Fatigue, LocalIndexComparesTractionWithYieldRelativeToPressure) {
  // Two strips, of which one carries no pressure; one cell.
  const test::OwnedStrips strips = test::sdec_strips(4e-3, 4e-3, 0.0, 60e3, 2);
  const test::OwnedGrid grid(1);
  const patch::Strips region = strips.get();
  region.peak[1] = 0.0;
  double px[] = {300e6, 300e6}, py[] = {400e6, 400e6}, none[] = {0.0, 0.0}, density[2], index[2],
         per_width[2];
  const tangential::TangentialFields fields{px, py, none, none};
  const CellDamage found =
      assess_cells({&region, &fields, &grid.get().middles, 1, 20.0, 250e6, density, index, per_width},
                   kernels_for(InstructionSet::baseline));
  EXPECT_DOUBLE_EQ(index[0], 250e6 / region.peak[0]);
  EXPECT_EQ(index[1], no_fatigue_index);
  EXPECT_EQ(found.fatigue_index, index[0]);
  EXPECT_EQ(found.power, 0.0);
}

/// Largest |tau_xz| / p0 under a line contact of half-width 1 that slides with friction mu: the closed-form
/// stresses of elliptic pressure and of a proportional traction superposed (Johnson, Contact Mechanics, 1985,
/// eq. 4.49 and section 8.1: the shear stress under traction mu p is mu times sigma_x under pressure).
double largest_shear(double mu) {
  double largest = mu;  // at the surface
  for (double y = 0.0005; y < 2.0; y *= 1.01) {
    for (double x = -2.0; x <= 2.0; x += 0.002) {
      // McEwen's m, n (Johnson 4.49)
      const double s = 1.0 - x * x + y * y;
      const double r = std::sqrt(s * s + 4.0 * x * x * y * y);
      const double m = std::sqrt(0.5 * (r + s));
      const double n = std::copysign(std::sqrt(std::max(0.0, 0.5 * (r - s))), x);
      const double mm_nn = m * m + n * n;
      // shear under pressure: -n (m^2 - y^2) / (m^2 + n^2); under traction q0 = mu p0: sigma_x of pressure
      const double pressure_shear = -n * (m * m - y * y) / mm_nn;
      const double pressure_sigma_x = -(m * (1.0 + (y * y + n * n) / mm_nn) - 2.0 * y);
      largest = std::max(largest, std::fabs(pressure_shear + mu * pressure_sigma_x));
    }
  }
  return largest;
}

TEST(Fatigue, ShakedownCurveFollowsFromTheStressesOfALineContact) {
  for (double mu : {0.0, 0.1, 0.2, 0.3, 0.35, 0.4, 0.5, 0.6}) {
    EXPECT_NEAR(shakedown_limit(mu), 1.0 / largest_shear(mu), 2e-3 / largest_shear(mu)) << mu;
  }
  EXPECT_NEAR(shakedown_limit(0.0), 4.0, 1e-12);
}

WearLaws published_wear_laws() {
  WearLaws laws;
  EXPECT_EQ(abi::read_wear_laws(nullptr, "laws", laws).status, WRC_OK);
  return laws;
}

TEST(Wear, TGammaLawHasItsPublishedBranches) {
  const TGammaWearLaw law = published_wear_laws().t_gamma;
  EXPECT_NEAR(worn_area_rate(law, 50.0, 0.92), 0.25 * 50.0 / 920.0 * 1e-9, 1e-18);  // mm^2/km = 1e-9 m^2/m
  EXPECT_NEAR(worn_area_rate(law, 150.0, 0.92), 25.0 / 920.0 * 1e-9, 1e-18);
  EXPECT_NEAR(worn_area_rate(law, 300.0, 0.92), (1.19 * 300.0 - 154.0) / 920.0 * 1e-9, 1e-18);
}

TEST(Wear, SheffieldLawIsContinuous) {
  const SheffieldWearLaw law = published_wear_laws().sheffield;
  for (double x : {law.x1, law.x2}) {
    EXPECT_NEAR(wear_depth_rate(law, x * 1e6 * (1.0 - 1e-9)), wear_depth_rate(law, x * 1e6 * (1.0 + 1e-9)),
                1e-12);
  }
  // 1 N/mm^2: 5.3 microgram per m and mm^2 of 7850 kg/m^3
  EXPECT_NEAR(wear_depth_rate(law, 1e6), 5.3e-9 / 7850.0 / 1e-6, 1e-15);
}

TEST(Wear, ArchardFollowsTheMap) {
  const ArchardWearLaw law = published_wear_laws().archard;
  EXPECT_DOUBLE_EQ(wear_depth_velocity(law, 1e9, 0.1), law.mild_low_speed * 1e9 * 0.1 / law.hardness);
  EXPECT_DOUBLE_EQ(wear_depth_velocity(law, 1e9, 0.5), law.severe * 1e9 * 0.5 / law.hardness);
  EXPECT_DOUBLE_EQ(wear_depth_velocity(law, 2.5e9, 0.5), law.seizure * 2.5e9 * 0.5 / law.hardness);
}

TEST(Wear, PowerLawIsProportionalUnlessAskedOtherwise) {
  PowerWearLaw law = published_wear_laws().power;
  EXPECT_NEAR(wear_depth_velocity(law, 1e6), 7e-10 * 1e6 / 7850.0, 1e-22);
  law.exponent = 2.5;
  EXPECT_NEAR(wear_depth_velocity(law, 4e6), 7e-10 * 4e6 / 7850.0, 1e-20);
  EXPECT_NEAR(wear_depth_velocity(law, 16e6) / wear_depth_velocity(law, 4e6), 32.0, 1e-12);
  law.exponent = 0.25;
  EXPECT_EQ(wear_depth_velocity(law, 0.0), 0.0);
  EXPECT_LT(wear_depth_velocity(law, 1e-200), 1e-20);
}

}  // namespace
}  // namespace wrc::damage
