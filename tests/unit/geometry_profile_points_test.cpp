#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "geometry/profile_points.hpp"
#include "geometry_test_bodies.hpp"

namespace wrc::geometry {
namespace {

struct Points {
  std::vector<double> y, z;
};

Points sampled(const std::function<ProfilePoint(double)>& curve, double low, double high, int count) {
  Points points;
  for (int i = 0; i < count; ++i) {
    const double y = low + (high - low) * i / (count - 1);
    points.y.push_back(y);
    points.z.push_back(curve(y).z);
  }
  return points;
}
Points wheel_points() { return sampled(s1002, -0.069, 0.060, 259); }
Points rail_points() {
  return sampled([](double y) { return rail_head(rail_60e1, y); }, -0.0355, 0.0355, 143);
}

Fault check(ProfileBody body, const Points& points) {
  return check_points(body, static_cast<std::int32_t>(points.y.size()), points.y.data(), points.z.data());
}
void expect_fault(const Fault& fault, std::int32_t status, const std::string& cause,
                  std::int32_t index = -1) {
  EXPECT_EQ(fault.status, status);
  ASSERT_NE(fault.cause, nullptr);
  EXPECT_NE(std::string(fault.cause).find(cause), std::string::npos) << fault.cause;
  if (index >= 0) {
    EXPECT_EQ(fault.index, index);
  }
}

/// Largest deviation of the spline through `count` points of the curve, over the inner part of [low, high].
double spline_error(const std::function<ProfilePoint(double)>& curve, double low, double high, int count) {
  const Points points = sampled(curve, low, high, count);
  std::vector<double> scratch(points.y.size());
  ProfileStore store;
  Profile profile;
  const Fault fault = spline_through(ProfileBody::wheel, count, points.y.data(), points.z.data(),
                                     scratch.data(), store.memory(), profile);
  EXPECT_EQ(fault.status, WRC_OK);
  double worst = 0.0;
  const double margin = 0.25 * (high - low);
  for (double y = low + margin; y < high - margin; y += 1e-5) {
    worst = std::max(worst, std::abs(evaluate(profile, y).z - curve(y).z));
  }
  return worst;
}

TEST(ProfilePoints, SplineConvergesWithTheFourthPower) {
  const auto tread = [](double y) { return s1002(y); };
  const double coarse = spline_error(tread, -0.020, 0.030, 51),
               fine = spline_error(tread, -0.020, 0.030, 101);
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.5);
  EXPECT_LT(fine, 1e-10);
}

TEST(ProfilePoints, SplineIsTwiceContinuouslyDifferentiableAndStraightAtItsEnds) {
  const Points points = wheel_points();
  const auto count = static_cast<std::int32_t>(points.y.size());
  std::vector<double> scratch(points.y.size());
  ProfileStore store;
  Profile profile;
  ASSERT_EQ(spline_through(ProfileBody::wheel, count, points.y.data(), points.z.data(), scratch.data(),
                           store.memory(), profile)
                .status,
            WRC_OK);
  for (std::size_t i = 1; i + 1 < points.y.size(); ++i) {
    const double below = evaluate(profile, points.y[i] - 1e-12).second;
    const double above = evaluate(profile, points.y[i] + 1e-12).second;
    EXPECT_NEAR(above, below, 1e-6 * (1.0 + std::abs(below))) << i;
  }
  EXPECT_NEAR(evaluate(profile, points.y.front()).second, 0.0, 1e-8);
  EXPECT_NEAR(evaluate(profile, points.y.back()).second, 0.0, 1e-8);
}

TEST(ProfilePoints, HalfMillimetrePointsKeepTreadAndFlangeRoot) {
  const ReferenceBodies exact;
  const Points points = wheel_points();
  std::vector<double> scratch(points.y.size());
  ProfileStore store, placed;
  Profile profile;
  Wheel wheel;
  spline_through(ProfileBody::wheel, static_cast<std::int32_t>(points.y.size()), points.y.data(),
                 points.z.data(), scratch.data(), store.memory(), profile);
  place_wheel(profile, usual_wheelset(), Side::right, placed.memory(), wheel);
  for (double y = 0.716; y < 0.80; y += 1e-4) {  // to -34 mm of the wheel's profile
    EXPECT_NEAR(evaluate(wheel.profile, y).z, evaluate(exact.wheel.profile, y).z, 0.1e-6) << y;
  }
}

TEST(ProfilePoints, AProfileTooSteepAlmostEverywhereIsTold) {
  const Points points = wheel_points();
  const std::size_t count = points.y.size();
  std::vector<double> scratch(count);
  ProfileStore store, placed;
  Profile profile;
  spline_through(ProfileBody::wheel, static_cast<std::int32_t>(count), points.y.data(), points.z.data(),
                 scratch.data(), store.memory(), profile);
  std::fill_n(store.memory().slope, count - 10, 200.0);
  Wheel wheel;
  expect_fault(place_wheel(profile, usual_wheelset(), Side::right, placed.memory(), wheel), WRC_ERROR_PROFILE,
               "steeper than 89.4 degrees");
}

TEST(ProfilePoints, GoodPointsPass) {
  EXPECT_EQ(check(ProfileBody::wheel, wheel_points()).status, WRC_OK);
  EXPECT_EQ(check(ProfileBody::rail, rail_points()).status, WRC_OK);
}

TEST(ProfilePoints, NotANumberIsNamedWithItsIndex) {
  Points points = wheel_points();
  points.z[17] = std::numeric_limits<double>::quiet_NaN();
  expect_fault(check(ProfileBody::wheel, points), WRC_ERROR_NOT_FINITE, "NaN", 17);
  points.z[17] = 0.0;
  points.y[5] = std::numeric_limits<double>::infinity();
  expect_fault(check(ProfileBody::wheel, points), WRC_ERROR_NOT_FINITE, "infinite", 5);
}

TEST(ProfilePoints, MillimetresAreRecognised) {
  Points points = rail_points();
  for (double& value : points.y) value *= 1e3;
  for (double& value : points.z) value *= 1e3;
  expect_fault(check(ProfileBody::rail, points), WRC_ERROR_PROFILE, "millimetres", 0);
}

TEST(ProfilePoints, FoldsRepeatsAndReversedOrderAreNamed) {
  Points points = rail_points();
  std::swap(points.y[40], points.y[41]);
  expect_fault(check(ProfileBody::rail, points), WRC_ERROR_PROFILE, "folds back", 41);
  points = rail_points();
  points.y[40] = points.y[39];
  expect_fault(check(ProfileBody::rail, points), WRC_ERROR_PROFILE, "same y", 40);
  points = rail_points();
  std::reverse(points.y.begin(), points.y.end());
  std::reverse(points.z.begin(), points.z.end());
  expect_fault(check(ProfileBody::rail, points), WRC_ERROR_PROFILE, "reverse their order");
}

TEST(ProfilePoints, PointsCloserThanRoundingAllowsAreTold) {
  for (double close : {1e-15, 9e-13}) {
    Points points = rail_points();
    points.y[40] = points.y[39] + close;
    expect_fault(check(ProfileBody::rail, points), WRC_ERROR_PROFILE, "leave out one", 40);
  }
  Points points = rail_points();
  points.y[40] = points.y[39] + 1.1e-12;
  points.z[40] = points.z[39];
  EXPECT_EQ(check(ProfileBody::rail, points).status, WRC_OK);
}

TEST(ProfilePoints, AStepIsCalledAStep) {
  // Up or down, anywhere across the head or the tread, on coarse and fine points.
  const auto head = [](double y) { return rail_head(rail_60e1, y); };
  struct Body {
    ProfileBody body;
    Points points;
    double least;  ///< [m]
  };
  for (const Body& each : {Body{ProfileBody::rail, rail_points(), 1.5e-3},
                           Body{ProfileBody::rail, sampled(head, -0.0355, 0.0355, 49), 5e-3},
                           Body{ProfileBody::rail, sampled(head, -0.0355, 0.0355, 1421), 1.5e-3},
                           Body{ProfileBody::wheel, wheel_points(), 5e-3}}) {
    for (const double step : {5e-3, -5e-3, 1.5e-3, -1.5e-3}) {
      for (const double share : {0.15, 0.4, 0.5, 0.7}) {
        if (std::fabs(step) < each.least) continue;
        Points points = each.points;
        const auto from = static_cast<std::size_t>(share * static_cast<double>(points.y.size()));
        for (std::size_t i = from; i < points.y.size(); ++i) points.z[i] += step;
        expect_fault(check(each.body, points), WRC_ERROR_PROFILE, "jumps", static_cast<std::int32_t>(from));
      }
    }
  }
}

TEST(ProfilePoints, SteepFlangesAndGaugeFacesAreNoSteps) {
  // A gauge face of four points, nearly vertical, and a flange of 75 degrees between two arcs, every 1.5 mm.
  Points rail = rail_points();
  const double y = rail.y.front(), z = rail.z.front();
  for (int i = 1; i <= 4; ++i) {
    rail.y.insert(rail.y.begin(), y - 1e-4 * i);
    rail.z.insert(rail.z.begin(), z + 6e-3 * i);
  }
  EXPECT_EQ(check(ProfileBody::rail, rail).status, WRC_OK);
  Points wheel;
  for (double s = -0.060; s <= 0.060; s += 1.5e-3) {
    wheel.y.push_back(s);
    wheel.z.push_back(s < -0.0412 ? 0.027 : s < -0.034 ? 0.027 - 3.7 * (s + 0.0412) : 0.0);
  }
  EXPECT_EQ(check(ProfileBody::wheel, wheel).status, WRC_OK);
}

TEST(ProfilePoints, PointsToBeSmoothedMayStepBackByTheirNoise) {
  Points points = rail_points();
  const auto count = static_cast<std::int32_t>(points.y.size());
  const auto checked = [&] {
    return check_points(ProfileBody::rail, count, points.y.data(), points.z.data(), profile_noise_most);
  };
  points.y[2] = points.y[1] - 3e-6;
  expect_fault(check(ProfileBody::rail, points), WRC_ERROR_PROFILE, "folds back", 2);
  EXPECT_EQ(checked().status, WRC_OK);
  points.y[2] = points.y[1];
  EXPECT_EQ(checked().status, WRC_OK);
  points.z[2] = points.z[1];
  expect_fault(checked(), WRC_ERROR_PROFILE, "same y", 2);
  points.y[2] = points.y[1] - 2.0 * profile_noise_most;
  expect_fault(checked(), WRC_ERROR_PROFILE, "folds back", 2);
}

TEST(ProfilePoints, UpsideDownAndMirroredBodiesAreTold) {
  Points rail = rail_points(), wheel = wheel_points();
  for (double& z : rail.z) z = -z;
  expect_fault(check(ProfileBody::rail, rail), WRC_ERROR_PROFILE, "upside down");
  for (double& z : wheel.z) z = -z;
  expect_fault(check(ProfileBody::wheel, wheel), WRC_ERROR_PROFILE, "flange points up");
  wheel = wheel_points();
  for (double& y : wheel.y) y = -y;
  std::reverse(wheel.y.begin(), wheel.y.end());
  std::reverse(wheel.z.begin(), wheel.z.end());
  expect_fault(check(ProfileBody::wheel, wheel), WRC_ERROR_PROFILE, "mirrored");
}

TEST(ProfilePoints, APointOfReferenceElsewhereIsTold) {
  Points rail = rail_points(), wheel = wheel_points();
  for (double& z : rail.z) z += 0.172;  // from the foot instead of the head
  expect_fault(check(ProfileBody::rail, rail), WRC_ERROR_PROFILE, "0 at the top");
  for (double& y : wheel.y) y += 0.070;  // from the inner face instead of the running circle
  expect_fault(check(ProfileBody::wheel, wheel), WRC_ERROR_PROFILE, "running circle");
  wheel = wheel_points();
  for (double& z : wheel.z) z += 0.46;  // from the axle
  expect_fault(check(ProfileBody::wheel, wheel), WRC_ERROR_PROFILE, "running circle");
}

TEST(ProfilePoints, TooFewTooShortAndMissingPointsAreTold) {
  Points points = rail_points();
  Points three{{points.y.begin(), points.y.begin() + 3}, {points.z.begin(), points.z.begin() + 3}};
  expect_fault(check(ProfileBody::rail, three), WRC_ERROR_PROFILE, "at least four");
  Points piece{{points.y.begin(), points.y.begin() + 20}, {points.z.begin(), points.z.begin() + 20}};
  expect_fault(check(ProfileBody::rail, piece), WRC_ERROR_PROFILE, "too short");
  Points slope{{points.y.begin(), points.y.begin() + 60}, {points.z.begin(), points.z.begin() + 60}};
  expect_fault(check(ProfileBody::rail, slope), WRC_ERROR_PROFILE, "highest point");
  points.y.erase(points.y.begin() + 30, points.y.begin() + 110);
  points.z.erase(points.z.begin() + 30, points.z.begin() + 110);
  expect_fault(check(ProfileBody::rail, points), WRC_ERROR_PROFILE, "missing", 30);
}

TEST(ProfilePoints, TooLittleMemoryIsAnExactError) {
  const Points points = rail_points();
  const auto count = static_cast<std::int32_t>(points.y.size());
  std::vector<double> scratch(points.y.size());
  ProfileStore store;
  ProfileMemory memory = store.memory();
  Profile profile;
  memory.capacity = count - 1;
  EXPECT_EQ(spline_through(ProfileBody::rail, count, points.y.data(), points.z.data(), scratch.data(), memory,
                           profile)
                .status,
            WRC_ERROR_BUFFER);
  memory.capacity = count;
  EXPECT_EQ(spline_through(ProfileBody::rail, count, points.y.data(), points.z.data(), scratch.data(), memory,
                           profile)
                .status,
            WRC_OK);
}

}  // namespace
}  // namespace wrc::geometry
