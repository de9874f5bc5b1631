/// How far a wheel that is apart is above its rail.
#include <algorithm>

#include "test_config.hpp"
#include "wheel_on_rail.hpp"

namespace {

class Clearance : public testing::Test, protected PlacedWheel {
 protected:
  double outward = 1.0;

  void stand_at(double y, double z, double yaw = 0.0) {
    wheel.y = outward * y;
    wheel.z = z;
    wheel.yaw = outward * yaw;
  }
  double clearance() {
    EXPECT_EQ(step(), WRC_FLAG_NO_CONTACT) << wheel.y << ' ' << wheel.z << ' ' << error();
    EXPECT_EQ(wrench.region_count, 0);
    return wrench.clearance;
  }
};

TEST_F(Clearance, LoweredByItAWheelTouches) {
  constexpr struct {
    double y, yaw;
    bool on_flange;
  } poses[] = {{0.0, 0.0, false},    {-6e-3, -8e-3, false}, {-4e-3, 5e-3, false}, {4e-3, -8e-3, false},
               {5.8e-3, 5e-3, true}, {6.5e-3, 0.0, true},   {9e-3, -10e-3, true}};
  create();
  for (const int32_t which : {WRC_SIDE_RIGHT, WRC_SIDE_LEFT}) {
    take(which);
    outward = which == WRC_SIDE_RIGHT ? 1.0 : -1.0;
    for (const auto& pose : poses) {
      stand_at(pose.y, -0.035, pose.yaw);
      const double about = wheel.z + clearance();
      for (const double above : {0.1e-3, 2e-3, 12e-3, 45e-3}) {
        SCOPED_TRACE(testing::Message() << which << ' ' << pose.y << ' ' << above);
        wheel.z = about - above;
        const double touch = wheel.z + clearance();
        EXPECT_NEAR(wrench.clearance, above, 1e-9);
        wheel.z = touch - 1e-9;
        EXPECT_NEAR(clearance(), 1e-9, 1e-10);
        wheel.z = touch + 1e-9;
        ASSERT_EQ(step(), WRC_OK) << error();
        EXPECT_EQ(wrench.clearance, 0.0);
        EXPECT_LT(wrench.force[2], 0.0);
        ASSERT_EQ(wrench.region_count, 1);
        wrc_region region = sized<wrc_region>();
        ASSERT_EQ(wrc_contact_region(contact, 0, &region), WRC_OK);
        EXPECT_EQ(region.y_wheel < -25e-3, pose.on_flange) << region.y_wheel;
      }
    }
  }
}

/// From the tread over the flange's root and its face to the tip, a micrometre at a time.
TEST_F(Clearance, IsContinuousAndNoSteeperThanTheFlange) {
  constexpr double a_step = 1e-6;
  create();
  for (const int32_t which : {WRC_SIDE_RIGHT, WRC_SIDE_LEFT}) {
    take(which);
    outward = which == WRC_SIDE_RIGHT ? 1.0 : -1.0;
    double last = 0.0, steepest = 0.0;
    for (int k = 0; k <= 11000; ++k) {
      stand_at(-1e-3 + a_step * k, -0.035, 2e-3);
      const double now = clearance();
      if (k > 0) {
        const double slope = (now - last) / a_step;
        EXPECT_GT(slope, -2.9) << wheel.y;  // tan 70 degrees, and a little for the yaw
        EXPECT_LT(slope, 0.2) << wheel.y;
        steepest = std::min(steepest, slope);
      }
      last = now;
    }
    EXPECT_LT(steepest, -2.0);  // the flange's face was met
  }
}

TEST_F(Clearance, IsOfGivenHeightsAloneAndEndsAtItsBound) {
  create();
  stand_at(0.0, -0.3);
  EXPECT_EQ(clearance(), 50e-3);
  stand_at(-0.19, 0.0);  // beside the rail
  EXPECT_EQ(clearance(), 50e-3);
  stand_at(20e-3, 0.0);  // a flange inside the side of a rail
  EXPECT_EQ(clearance(), 0.0);
  EXPECT_NE(error().find("inside the rail's side"), std::string::npos) << error();
  stand_at(0.0, 0.0);
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 80e3;
  ASSERT_EQ(step(), WRC_OK) << error();
  EXPECT_EQ(wrench.clearance, 0.0);
}

}  // namespace
