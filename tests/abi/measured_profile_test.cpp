/// Measured profiles: points every 0.5 mm along the curve with 5 um of noise. A lateral sweep over them must
/// not flicker once they are smoothed, nor may the steps of curvature of standard profiles make it, and the
/// smoothed curve must stay with its points, also at the steep flange.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "test_config.hpp"
#include "wrc/wrc_planar.h"

namespace {

/// Which standard profiles, and the cant.
struct Pair {
  int32_t rail;
  double inclination;
};
constexpr Pair pairs[] = {
    {WRC_PROFILE_UIC60_BENCHMARK, 0.0}, {WRC_PROFILE_60E1, 1.0 / 40.0}, {WRC_PROFILE_60E1, 1.0 / 20.0}};

wrc_profile standard(int32_t kind) {
  wrc_profile profile = sized<wrc_profile>();
  profile.kind = kind;
  return profile;
}

/// A model with its contact.
class Bodies {
 public:
  Bodies(const wrc_profile& wheel, const wrc_profile& rail, double inclination) {
    wrc_config config = test_config();
    config.wheel = wheel;
    config.rail = rail;
    config.track.rail_inclination = inclination;
    char text[256] = "";
    EXPECT_EQ(wrc_config_check(&config, text, sizeof text), WRC_OK) << text;
    EXPECT_EQ(wrc_model_create(&config, nullptr, &model, nullptr, 0), WRC_OK);
    EXPECT_EQ(wrc_contact_create(model, WRC_SIDE_RIGHT, nullptr, &contact, nullptr, 0), WRC_OK);
  }
  ~Bodies() {
    wrc_contact_destroy(contact);
    wrc_model_destroy(model);
  }
  Bodies(const Bodies&) = delete;
  Bodies& operator=(const Bodies&) = delete;

  /// The curve as the model holds it.
  std::vector<std::vector<double>> curve(int32_t body, double* deviation = nullptr) const {
    wrc_view y{}, z = wrc_view{};
    EXPECT_EQ(wrc_model_profile(model, WRC_SIDE_RIGHT, body, &y, &z, deviation), WRC_OK);
    return {{y.data, y.data + y.count}, {z.data, z.data + z.count}};
  }

  wrc_model* model = nullptr;
  wrc_contact* contact = nullptr;
};

constexpr double running_circle = 0.750;  // of the default wheelset, from its middle [m]

/// Points along a standard profile, every `spacing` along the curve, moved by normally distributed noise.
struct Points {
  std::vector<double> y, z;

  Points(int32_t body, const Pair& pair, double spacing, double noise, uint32_t seed) {
    const bool wheel = body == WRC_BODY_WHEEL;
    const Bodies bodies(standard(WRC_PROFILE_S1002), standard(pair.rail), 0.0);
    const auto curve = bodies.curve(body);
    const std::vector<double>&from_y = curve[0], &from_z = curve[1];
    const auto top =
        static_cast<std::size_t>(std::min_element(from_z.begin(), from_z.end()) - from_z.begin());
    const double origin = wheel ? running_circle : from_y[top];
    const auto uniform = [&] {
      seed = 1664525u * seed + 1013904223u;
      return static_cast<double>(seed) / 4294967296.0;
    };
    std::size_t at = 0;
    double where = from_y.front() + 1e-9;
    while (where < from_y.back()) {
      while (at + 2 < from_y.size() && from_y[at + 1] < where) ++at;
      const double slope = (from_z[at + 1] - from_z[at]) / (from_y[at + 1] - from_y[at]);
      const double secant = std::sqrt(1.0 + slope * slope);
      double normal = -6.0;  // twelve uniform numbers make a normal one
      for (int i = 0; i < 12; ++i) normal += uniform();
      y.push_back(where - origin);
      z.push_back(from_z[at] + slope * (where - from_y[at]) + noise * normal * secant);
      where += spacing / secant;
    }
  }
  wrc_profile profile(double smoothing) const {
    wrc_profile points = sized<wrc_profile>();
    points.kind = WRC_PROFILE_POINTS;
    points.count = static_cast<uint32_t>(y.size());
    points.y = y.data();
    points.z = z.data();
    points.smoothing = smoothing;
    return points;
  }
};

/// What a sweep of the wheelset from -7 to +5 mm in steps of 20 um shows.
struct Sweep {
  std::vector<double> area;
  int changes = 0;            ///< of the number of patches
  double largest_jump = 0.0;  ///< of the area from pose to pose, relative
};

Sweep sweep(const Bodies& bodies) {
  Sweep result;
  wrc_planar_load load = wrc_planar_load_default();
  load.normal_force = 80e3;
  int32_t patches = 0;
  for (int i = 0; i <= 600; ++i) {
    wrc_planar_pose pose = sized<wrc_planar_pose>();
    pose.lateral = -7e-3 + 20e-6 * i;
    wrc_planar_normal_solution normal{};
    EXPECT_GE(wrc_planar_geometry(bodies.contact, &pose, nullptr), 0);
    EXPECT_GE(wrc_planar_normal(bodies.contact, nullptr, &load, &normal), 0);
    result.changes += i > 0 && normal.patch_count != patches;
    patches = normal.patch_count;
    if (i > 0)
      result.largest_jump = std::max(result.largest_jump, std::fabs(normal.area / result.area.back() - 1.0));
    result.area.push_back(normal.area);
  }
  return result;
}

double mean_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::fabs(a[i] / b[i] - 1.0);
  return sum / static_cast<double>(a.size());
}

TEST(StandardProfiles, StepsOfCurvatureMakeNoPatchFlicker) {
  for (const Pair& pair : pairs) {
    const Sweep steady = sweep(Bodies(standard(WRC_PROFILE_S1002), standard(pair.rail), pair.inclination));
    EXPECT_LE(steady.changes, 1);
    EXPECT_LT(steady.largest_jump, 0.02);
  }
}

TEST(MeasuredProfiles, SmoothedTheyDoNotFlicker) {
  constexpr double noise = 5e-6, spacing = 0.5e-3, smoothing = 7e-3;
  for (const Pair& pair : pairs) {
    const Sweep exact = sweep(Bodies(standard(WRC_PROFILE_S1002), standard(pair.rail), pair.inclination));
    for (uint32_t seed : {1u, 2u, 3u, 4u}) {
      const Points wheel(WRC_BODY_WHEEL, pair, spacing, noise, seed),
          rail(WRC_BODY_RAIL, pair, spacing, noise, seed + 100);
      const Sweep calm = sweep(Bodies(wheel.profile(smoothing), rail.profile(smoothing), pair.inclination));
      const double off = mean_difference(calm.area, exact.area);
      std::printf(
          "rail %d, seed %u: patch count changes %d (exact profiles %d), area off by %.1f %% (mean), largest "
          "jump %.1f %%\n",
          pair.rail, seed, calm.changes, exact.changes, 100.0 * off, 100.0 * calm.largest_jump);
      EXPECT_LE(calm.changes, exact.changes + 1);
      EXPECT_LT(off, 0.04);
      EXPECT_LT(calm.largest_jump, 0.04);
    }
  }
}

TEST(MeasuredProfiles, UnsmoothedTheyDo) {
  const Points wheel(WRC_BODY_WHEEL, pairs[0], 0.5e-3, 5e-6, 1);
  const Sweep noisy = sweep(Bodies(wheel.profile(0.0), standard(pairs[0].rail), 0.0));
  EXPECT_GT(noisy.changes, 20);
  EXPECT_GT(noisy.largest_jump, 0.3);
}

/// Largest distance between the smoothed curve and the exact profile it was taken from, by region.
TEST(MeasuredProfiles, CurveStaysWithItsPointsAlsoAtTheFlange) {
  for (double smoothing : {5e-3, 7e-3}) {
    const Points points(WRC_BODY_WHEEL, pairs[0], 0.5e-3, 0.0, 1);
    const Bodies bodies(points.profile(smoothing), standard(pairs[0].rail), 0.0);
    double reported = 0.0;
    const auto curve = bodies.curve(WRC_BODY_WHEEL, &reported);
    double tread = 0.0, flange = 0.0, all = 0.0;
    for (std::size_t i = 1; i + 1 < points.y.size(); ++i) {
      const double ty = curve[0][i + 1] - curve[0][i - 1], tz = curve[1][i + 1] - curve[1][i - 1];
      const double across =
          std::fabs((points.z[i] - curve[1][i]) * ty - (points.y[i] - (curve[0][i] - running_circle)) * tz) /
          std::hypot(ty, tz);
      all = std::max(all, across);
      if (points.y[i] > -0.025 && points.y[i] < 0.030) tread = std::max(tread, across);
      if (points.y[i] > -0.045 && points.y[i] < -0.030) flange = std::max(flange, across);
    }
    std::printf(
        "smoothing %.0f mm: within %.2f um on the tread, %.1f um at the steep flange; reported %.1f um\n",
        1e3 * smoothing, 1e6 * tread, 1e6 * flange, 1e6 * reported);
    EXPECT_LT(tread, 2e-6);
    EXPECT_LT(flange, smoothing < 6e-3 ? 9e-6 : 18e-6);  // where the arc of 13 mm becomes straight
    EXPECT_GE(reported, all);
    EXPECT_LT(reported, 60e-6);  // at the flange back's last point, whose curvature a free end does not know
  }
}

TEST(MeasuredProfiles, TooLongASmoothingIsRefusedByName) {
  // A flange with a wall that is steep for 1 mm only.
  std::vector<double> y, z;
  for (int i = 0; i < 40; ++i) y.push_back(-0.060 + 0.5e-3 * i), z.push_back(0.028);
  for (int i = 1; i < 60; ++i) y.push_back(y[39] + 1e-6 * i), z.push_back(0.028 - 0.5e-3 * i * 28.0 / 30.0);
  for (int i = 0; i < 80; ++i) y.push_back(-0.030 + 1e-3 * i), z.push_back(0.0);
  wrc_profile wheel = sized<wrc_profile>(), rail = standard(WRC_PROFILE_60E1);
  wheel.kind = WRC_PROFILE_POINTS;
  wheel.count = static_cast<uint32_t>(y.size());
  wheel.y = y.data();
  wheel.z = z.data();
  wheel.smoothing = 0.02;
  wrc_config config = test_config();
  config.wheel = wheel;
  config.rail = rail;
  char text[256];
  EXPECT_EQ(wrc_config_check(&config, text, sizeof text), WRC_ERROR_PROFILE);
  EXPECT_NE(std::string(text).find("smoothing"), std::string::npos) << text;
}

}  // namespace
