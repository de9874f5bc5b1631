/// Where no approach of a normal method carries the load, it says so; elsewhere load and approach agree
/// (normal_report trips looks at all methods and poses).
#include <gtest/gtest.h>

#include "reference_contact.hpp"

namespace {

TEST(LoadLeap, IsFlaggedAndBesideItTheLoadComesBack) {
  ReferenceWheel wheel;
  wheel.rail.kind = WRC_PROFILE_60E1;
  wheel.config.track.rail_inclination = 0.025;
  wheel.config.normal.method = WRC_NORMAL_EKP;
  wheel.pose.lateral = 0.25e-3;
  int flagged = 0;
  for (double load = 1000.0; load < 12e3; load *= 1.01) {
    wheel.load.prescribed = WRC_PRESCRIBE_NORMAL_FORCE;
    wheel.load.normal_force = load;
    const int32_t status = wheel.step();
    ASSERT_TRUE(status == WRC_OK || status == WRC_FLAG_LOAD_JUMPS);
    EXPECT_NEAR(wheel.normal.normal_force, load, 1e-9 * load);
    wheel.load.prescribed = WRC_PRESCRIBE_APPROACH;
    wheel.load.approach = wheel.normal.approach;
    ASSERT_EQ(wheel.step(), WRC_OK);
    flagged += status == WRC_FLAG_LOAD_JUMPS;
    // Within the leap the approach is that of the load after it.
    if (status == WRC_OK) {
      EXPECT_NEAR(wheel.normal.normal_force, load, 1e-10 * load);
    }
    if (status == WRC_FLAG_LOAD_JUMPS) {
      EXPECT_GT(wheel.normal.normal_force, load);
    }
  }
  EXPECT_GT(flagged, 50);  // from 2.4 to 6.2 kN
}

}  // namespace
