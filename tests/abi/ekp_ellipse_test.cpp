/// EKP_ELLIPSE against the program whose method it is (CONTACT 25.2, bound 5, on the same gap rows, 0.1 mm
/// grid), and its load over the approach, where regions come in.
#include <gtest/gtest.h>

#include <cmath>

#include "reference_contact.hpp"

namespace {

ReferenceWheel& ellipse(ReferenceWheel& wheel) {
  wheel.config.normal.method = WRC_NORMAL_EKP_ELLIPSE;
  return wheel;
}

TEST(EkpEllipse, HasTheReferenceProgramsNumbers) {
  ReferenceWheel wheel;
  wrc_config& config = ellipse(wheel).config;
  config.wheel_material.shear_modulus = config.rail_material.shear_modulus = 82e9;
  config.wheel_material.poisson = config.rail_material.poisson = 0.28;
  wheel.config.planar.strips = 200;
  // Of 80 kN. At 5.5 mm the reference's grid is felt; at 5 mm the overlap has two regions.
  const struct {
    double lateral, yaw, approach, peak, area;
  } rows[] = {{-6.0, 0.00, 90.00, 1126.9, 106.56}, {-3.0, 0.00, 84.16, 979.3, 123.03},
              {-2.0, 0.02, 81.56, 923.7, 130.91},  {0.0, 0.00, 63.29, 645.9, 179.26},
              {1.0, 0.00, 80.70, 1067.2, 136.51},  {2.0, 0.00, 95.86, 1327.3, 94.66},
              {3.0, 0.00, 98.33, 1402.7, 86.46},   {3.0, 0.02, 98.26, 1400.5, 86.78},
              {4.0, 0.00, 96.55, 1340.0, 89.68},   {5.0, 0.00, 80.19, 1024.8, 122.72},
              {5.5, 0.00, 118.78, 2753.2, 44.35}};
  for (const auto& row : rows) {
    SCOPED_TRACE(row.lateral);
    wheel.pose.lateral = 1e-3 * row.lateral;
    wheel.pose.yaw = row.yaw;
    ASSERT_EQ(wheel.step(), WRC_OK);
    const double coarse = row.lateral == 5.5 ? 8.0 : 1.0;
    EXPECT_NEAR(1e6 * wheel.normal.approach, row.approach, coarse * 2e-4 * row.approach);
    EXPECT_NEAR(1e-6 * wheel.normal.peak_pressure, row.peak, coarse * 3e-4 * row.peak);
    EXPECT_NEAR(1e6 * wheel.normal.area, row.area, (coarse > 1.0 ? 2e-3 : 1e-3) * row.area);
    EXPECT_EQ(wheel.normal.patch_count, row.lateral == 5.0 ? 2 : 1);
  }
}

TEST(EkpEllipse, LoadRisesWithTheApproachWhereRegionsComeInAndJoin) {
  // At 5 mm a second region comes in at 11.2 um and joins at 85 um; the chord of the region round the contact
  // point alone leaps at 80.2 um.
  ReferenceWheel wheel;
  ellipse(wheel).pose.lateral = 5e-3;
  wheel.load.prescribed = WRC_PRESCRIBE_APPROACH;
  int32_t patches = 0;
  int changes = 0;
  const auto scan = [&](double from, double to, double step) {
    double before = 0.0;
    for (double approach = from; approach < to; approach += step) {
      wheel.load.approach = approach;
      ASSERT_EQ(wheel.step(), WRC_OK);
      EXPECT_GT(wheel.normal.normal_force, before) << approach;
      if (before > 0.0) {
        EXPECT_LT(wheel.normal.normal_force, before * (1.0 + 10.0 * step / approach)) << approach;
      }
      before = wheel.normal.normal_force;
      changes += patches != 0 && wheel.normal.patch_count != patches;
      patches = wheel.normal.patch_count;
    }
  };
  scan(2e-6, 150e-6, 50e-9);
  EXPECT_GE(changes, 2);
  scan(10.8e-6, 11.8e-6, 2e-9);
  scan(79e-6, 86e-6, 5e-9);
}

}  // namespace
