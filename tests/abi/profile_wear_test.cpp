/// Profiles that wear: depth along the normal, nothing lost by smoothing, steps and points; what gauges
/// measure.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "offline_helpers.hpp"
#include "test_config.hpp"
#include "wrc/wrc_damage.h"
#include "wrc/wrc_profiles.h"

namespace {

struct Profile {
  std::vector<double> y, z;
};

/// Points of a standard profile, every half millimetre along the curve.
Profile standard(int32_t body) {
  wrc_config config = test_config();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_60E1;
  wrc_model* model = nullptr;
  EXPECT_EQ(wrc_model_create(&config, nullptr, &model, nullptr, 0), WRC_OK);
  std::vector<double> arc;
  for (int i = 0; i < 240; ++i) arc.push_back((body == WRC_BODY_WHEEL ? -0.078 : -0.045) + 0.5e-3 * i);
  if (body == WRC_BODY_RAIL) arc.resize(181);
  Profile p{std::vector<double>(arc.size()), std::vector<double>(arc.size())};
  EXPECT_EQ(wrc_model_arc_places(model, body, static_cast<uint32_t>(arc.size()), arc.data(), p.y.data(),
                                 p.z.data()),
            WRC_OK);
  wrc_model_destroy(model);
  return p;
}

struct Worn {
  Profile profile;
  wrc_worn_profile result = sized<wrc_worn_profile>();
  int32_t status = 0;
  std::string text;

  Worn(const Profile& given, wrc_profile_wear wear, const std::vector<double>& depth,
       uint32_t capacity = 2000)
      : profile{std::vector<double>(capacity), std::vector<double>(capacity)} {
    wear.count = static_cast<uint32_t>(given.y.size());
    wear.y = given.y.data();
    wear.z = given.z.data();
    wear.bin_count = static_cast<uint32_t>(depth.size());
    wear.depth = depth.data();
    result.capacity = capacity;
    result.y = profile.y.data();
    result.z = profile.z.data();
    char sentence[256] = "";
    status = wrc_profile_remove_wear(&wear, &result, sentence, sizeof sentence);
    text = sentence;
    profile.y.resize(result.count);
    profile.z.resize(result.count);
  }
};

wrc_profile_wear wear_of(int32_t body) {
  wrc_profile_wear wear = wrc_profile_wear_default();
  wear.body = body;
  wear.first = -0.2;
  wear.width = 1e-3;
  wear.largest_depth = 1e-2;
  return wear;
}

/// Area between two profiles over the middle of both, by fine trapezoids of their polygons.
double area_between(const Profile& upper, const Profile& lower, double from, double to) {
  const auto at = [](const Profile& p, double y) {
    const auto k =
        static_cast<std::size_t>(std::upper_bound(p.y.begin() + 1, p.y.end() - 1, y) - p.y.begin());
    return p.z[k - 1] + (p.z[k] - p.z[k - 1]) * (y - p.y[k - 1]) / (p.y[k] - p.y[k - 1]);
  };
  double area = 0.0;
  constexpr int n = 200000;
  for (int i = 0; i < n; ++i) {
    const double y = from + (to - from) * (i + 0.5) / n;
    area += (at(lower, y) - at(upper, y)) * (to - from) / n;
  }
  return area;
}

/// An arc that wears evenly stays one, of another radius.
TEST(ProfileWear, EvenWearOfAnArcIsAnArc) {
  const double R = 0.3, d = 2e-3;
  Profile arc;
  for (int i = -60; i <= 60; ++i) {
    arc.y.push_back(0.5e-3 * i);
    arc.z.push_back(R - std::sqrt(R * R - arc.y.back() * arc.y.back()));
  }
  for (const int32_t body : {WRC_BODY_RAIL, WRC_BODY_WHEEL}) {
    const Worn worn(arc, wear_of(body), std::vector<double>(400, d));
    ASSERT_EQ(worn.status, WRC_OK) << worn.text;
    EXPECT_NEAR(worn.result.depth, d, 1e-12);
    const double radius = body == WRC_BODY_RAIL ? R - d : R + d;  // steel below it, or above
    double worst = 0.0;
    for (std::size_t i = 2; i + 2 < worn.profile.y.size(); ++i)
      worst = std::max(worst, std::abs(std::hypot(worn.profile.y[i], R - worn.profile.z[i]) - radius));
    EXPECT_LT(worst, 1e-8);
  }
}

/// What is taken off is what lies between the curves, and what the bins hold.
TEST(ProfileWear, TakesOffWhatTheBinsHold) {
  for (const int32_t body : {WRC_BODY_WHEEL, WRC_BODY_RAIL}) {
    const Profile given = standard(body);
    std::vector<double> depth(400);
    double held = 0.0;
    for (std::size_t k = 0; k < depth.size(); ++k) {
      const double s = -0.2 + 1e-3 * (static_cast<double>(k) + 0.5);
      depth[k] = 1e-4 * std::exp(-s * s / (2 * 0.006 * 0.006));
      held += depth[k] * 1e-3;
    }
    const Worn worn(given, wear_of(body), depth);
    ASSERT_EQ(worn.status, WRC_OK) << worn.text;
    EXPECT_NEAR(worn.result.area, held, 1e-4 * held);
    const double between = area_between(body == WRC_BODY_WHEEL ? worn.profile : given,
                                        body == WRC_BODY_WHEEL ? given : worn.profile, -0.030, 0.028);
    EXPECT_NEAR(between, held, 5e-3 * held);
  }
}

TEST(ProfileWear, StepControlAndManyStepsAgreeWithOne) {
  const Profile given = standard(WRC_BODY_WHEEL);
  std::vector<double> depth(400);
  for (std::size_t k = 0; k < depth.size(); ++k) {
    const double s = -0.2 + 1e-3 * (static_cast<double>(k) + 0.5);
    depth[k] = 1e-9 * std::exp(-s * s / (2 * 0.01 * 0.01));
  }
  wrc_profile_wear wear = wear_of(WRC_BODY_WHEEL);
  wear.passages = 5e5;
  const Worn once(given, wear, depth);
  ASSERT_EQ(once.status, WRC_OK) << once.text;
  EXPECT_EQ(once.result.passages, 5e5);
  wear.largest_depth = 5e-5;
  Profile now = given;
  int steps = 0;
  while (wear.passages > 1e-6) {
    const Worn step(now, wear, depth);
    ASSERT_EQ(step.status, WRC_OK) << step.text;
    EXPECT_LE(step.result.depth, 5e-5 * (1.0 + 1e-12));
    wear.passages -= step.result.passages;
    now = step.profile;
    ASSERT_LT(++steps, 20);
  }
  EXPECT_GT(steps, 8);
  EXPECT_NEAR(area_between(now, once.profile, -0.02, 0.02), 0.0, 1e-3 * 0.04 * 5e-4);
  // and it is a profile that a model takes
  wrc_config config = test_config();
  config.wheel.kind = WRC_PROFILE_POINTS;
  config.wheel.count = static_cast<uint32_t>(now.y.size());
  config.wheel.y = now.y.data();
  config.wheel.z = now.z.data();
  config.rail.kind = WRC_PROFILE_60E1;
  char text[256] = "";
  EXPECT_EQ(wrc_config_check(&config, text, sizeof text), WRC_OK) << text;
}

TEST(ProfileWear, RefusesWhatCrossesItself) {
  const Profile given = standard(WRC_BODY_RAIL);
  std::vector<double> depth(400, 0.0);
  depth[200 - 34] = depth[200 - 33] = 0.02;  // into the gauge corner, deeper than its radius
  wrc_profile_wear wear = wear_of(WRC_BODY_RAIL);
  wear.largest_depth = 0.01;
  wear.smoothing = 0.0;
  const Worn worn(given, wear, depth);
  EXPECT_EQ(worn.status, WRC_ERROR_PROFILE);
  EXPECT_NE(worn.text.find("crosses itself"), std::string::npos) << worn.text;
  EXPECT_EQ(Worn(given, wear, std::vector<double>(400, 1e-5), 20).status, WRC_ERROR_BUFFER);
  depth[0] = -1.0;
  EXPECT_EQ(Worn(given, wear, depth).status, WRC_ERROR_RANGE);
  EXPECT_EQ(wrc_profile_remove_wear(nullptr, nullptr, nullptr, 0), WRC_ERROR_NULL);
}

/// EN 13715 has the S1002's flange 28 mm high and 32.5 mm thick, with qR 10.8 mm.
TEST(Flange, OfTheS1002IsThatOfTheStandard) {
  const Profile wheel = standard(WRC_BODY_WHEEL);
  wrc_flange flange{};
  char text[256] = "";
  ASSERT_EQ(wrc_flange_dimensions(static_cast<uint32_t>(wheel.y.size()), wheel.y.data(), wheel.z.data(),
                                  0.070, &flange, text, sizeof text),
            WRC_OK)
      << text;
  EXPECT_NEAR(flange.height, 0.0280, 1e-5);
  EXPECT_NEAR(flange.thickness, 0.0325, 5e-5);
  EXPECT_NEAR(flange.slope, 0.0108, 1e-4);
  const Profile rail = standard(WRC_BODY_RAIL);
  EXPECT_EQ(
      wrc_flange_dimensions(4, rail.y.data() + 80, rail.z.data() + 80, 0.070, &flange, text, sizeof text),
      WRC_ERROR_PROFILE);
  EXPECT_EQ(flange.height, 0.0);
}

}  // namespace
