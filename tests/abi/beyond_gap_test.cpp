/// Approaches and loads beyond what the gap carries, through the C interface: no state in the fields' range
/// fails, and at the border nothing leaps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "field_values.hpp"
#include "reference_contact.hpp"

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int32_t methods = WRC_NORMAL_STRIP_HALFSPACE + 1;

void prescribe_load(ReferenceWheel& wheel, double normal_force) {
  wheel.load.prescribed = WRC_PRESCRIBE_NORMAL_FORCE;
  wheel.load.normal_force = normal_force;
}
void prescribe_approach(ReferenceWheel& wheel, double approach) {
  wheel.load.prescribed = WRC_PRESCRIBE_APPROACH;
  wheel.load.approach = approach;
}

/// The load of all strips in the contact [N].
double load_of_strips(const ReferenceWheel& wheel) {
  double load = 0.0;
  for (int32_t k = 0; k < wheel.normal.patch_count; ++k) {
    const FieldValues width = field_values(wheel.contact, k, WRC_FIELD_STRIP_WIDTH),
                      half = field_values(wheel.contact, k, WRC_FIELD_STRIP_HALF_LENGTH),
                      peak = field_values(wheel.contact, k, WRC_FIELD_STRIP_PEAK);
    for (std::size_t j = 0; j < width.strips; ++j) load += 0.5 * pi * width[j] * half[j] * peak[j];
  }
  return load;
}

TEST(BeyondGap, NoStateOfTheFieldsRangeFails) {
  for (int32_t method = 0; method < methods; ++method)
    for (const double gap_limit : {1e-4, 1e-3}) {
      ReferenceWheel wheel;
      wheel.config.normal.method = method;
      wheel.config.planar.gap_limit = gap_limit;
      wheel.creepage.longitudinal = -10.0;  // everything slides
      for (const double lateral : {-6e-3, -0.3e-3, 0.0, 3e-3, 5e-3, 5.8e-3, 6.2e-3, 6.6e-3, 7e-3})
        for (const double yaw : {0.0, 15e-3}) {
          SCOPED_TRACE(testing::Message() << "method " << method << ", gap_limit " << gap_limit
                                          << ", lateral " << lateral << ", yaw " << yaw);
          wheel.pose.lateral = lateral;
          wheel.pose.yaw = yaw;
          const auto agrees = [&](int32_t status) {
            EXPECT_GE(status, WRC_OK);
            EXPECT_GT(wheel.forces.fn, 0.0);
            EXPECT_NEAR(wheel.forces.fn, wheel.normal.normal_force, 1e-9 * wheel.forces.fn);
            EXPECT_NEAR(load_of_strips(wheel), wheel.forces.fn, 1e-9 * wheel.forces.fn);
            EXPECT_NEAR(wheel.damage.power, wheel.forces.power, 1e-6 * wheel.forces.power);
            EXPECT_NEAR(std::hypot(wheel.forces.fx, wheel.forces.fy), 0.35 * wheel.forces.fn,
                        5e-3 * wheel.forces.fn);
          };
          for (const double approach : {1e-6, 0.1e-3, 0.3e-3, 0.9e-3, 1.1e-3, 3e-3, 10e-3}) {
            prescribe_approach(wheel, approach);
            const int32_t status = wheel.step();
            agrees(status);
            EXPECT_EQ(wheel.normal.approach, approach);
            if (approach > gap_limit) {
              EXPECT_EQ(status, WRC_FLAG_BEYOND_GAP) << approach;
            }
          }
          for (const double load : {1e2, 1e4, 1e5, 3e5, 1e6}) {
            prescribe_load(wheel, load);
            agrees(wheel.step());
            EXPECT_NEAR(wheel.forces.fn, load, 1e-9 * load);
          }
        }
    }
}

TEST(BeyondGap, LoadAndApproachGoOnInOneLineFromTheBorder) {
  constexpr double limit = 0.12e-3;
  for (int32_t method = 0; method < methods; ++method)
    for (const double lateral : {-4e-3, 0.0, 3e-3}) {
      SCOPED_TRACE(testing::Message() << "method " << method << ", lateral " << lateral);
      // The strip solver ends its sweeps at half a per cent of the area, which leaves this of the load.
      const double exact = method == WRC_NORMAL_STRIP_HALFSPACE ? 1e-3 : 1e-8;
      ReferenceWheel wheel;
      wheel.config.normal.method = method;
      wheel.config.planar.gap_limit = limit;
      wheel.pose.lateral = lateral;
      prescribe_approach(wheel, limit);
      ASSERT_GE(wheel.step(), WRC_OK);
      const double border = wheel.normal.normal_force, peak = wheel.normal.peak_pressure,
                   area = wheel.normal.area;
      prescribe_approach(wheel, 1.5 * limit);
      ASSERT_EQ(wheel.step(), WRC_FLAG_BEYOND_GAP);
      const double stiffness = wheel.normal.stiffness;
      EXPECT_GE(stiffness, border / limit);
      EXPECT_LE(stiffness, 6.0 * border / limit);

      // Across the border in steps of a hundred-thousandth.
      double before = 0.0;
      for (int i = -100; i <= 100; ++i) {
        const double share = 1.0 + 1e-5 * i;
        prescribe_approach(wheel, share * limit);
        const int32_t status = wheel.step();
        EXPECT_EQ(status == WRC_FLAG_BEYOND_GAP, i > 0) << i;
        const double load = wheel.forces.fn, line = border + stiffness * (share - 1.0) * limit;
        EXPECT_NEAR(load, line, i > 0 ? 1e-9 * border : 2e-3 * border);
        if (before > 0.0) {
          EXPECT_NEAR(load, before, 1e-4 * border + exact * border);
        }
        before = load;
        if (i <= 0) continue;
        EXPECT_NEAR(wheel.normal.peak_pressure, peak * load / border, 1e-9 * peak);
        EXPECT_NEAR(wheel.normal.area, area, 1e-12 * area);
        prescribe_load(wheel, load);
        EXPECT_GE(wheel.step(), WRC_OK);
        EXPECT_NEAR(wheel.normal.approach, share * limit, exact * limit);
      }
      double approach_before = 0.0;
      for (int i = -100; i <= 100; ++i) {
        prescribe_load(wheel, border * (1.0 + 1e-5 * i));
        ASSERT_GE(wheel.step(), WRC_OK);
        if (approach_before > 0.0) {
          EXPECT_NEAR(wheel.normal.approach, approach_before, (1e-4 + exact) * limit) << i;
        }
        approach_before = wheel.normal.approach;
      }
    }
}

TEST(BeyondGap, NothingLeapsWhereThePoseCrossesTheBorder) {
  // The rows end 30 mm from the contact point, where the gap is 0.73 mm and grows with the lateral shift.
  for (int32_t method = 0; method < methods; ++method) {
    SCOPED_TRACE(method);
    ReferenceWheel wheel;
    wheel.config.normal.method = method;
    prescribe_approach(wheel, 0.74e-3);
    int beyond = 0, within = 0;
    double before = 0.0;
    for (int i = 0; i <= 300; ++i) {
      wheel.pose.lateral = 6.205e-3 + 0.1e-6 * i;
      const int32_t status = wheel.step();
      ASSERT_GE(status, WRC_OK);
      ++(status == WRC_FLAG_BEYOND_GAP ? beyond : within);
      const double load = wheel.forces.fn;
      if (before > 0.0) {
        EXPECT_NEAR(load, before, 3e-3 * load) << i;
      }
      before = load;
    }
    EXPECT_GT(beyond, 50);
    EXPECT_GT(within, 50);
  }
}

}  // namespace
