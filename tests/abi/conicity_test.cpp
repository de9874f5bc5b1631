/// Contact functions and equivalent conicity against cones, circles on circles, closed solutions of the
/// kinematic motion and its integration step by step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "offline_helpers.hpp"
#include "test_config.hpp"
#include "wrc/wrc_profiles.h"

namespace {

using offline_helpers::pi;

std::vector<double> steps(double from, double to, int count) {
  std::vector<double> values(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) values[static_cast<std::size_t>(i)] = from + (to - from) * i / (count - 1);
  return values;
}

/// Points of a profile.
struct Points {
  std::vector<double> y, z;
  Points(double from, double to, int count, const std::function<double(double)>& height)
      : y(steps(from, to, count)), z(y) {
    for (double& value : z) value = height(value);
  }
  wrc_profile profile() const {
    wrc_profile p = sized<wrc_profile>();
    p.kind = WRC_PROFILE_POINTS;
    p.count = static_cast<uint32_t>(y.size());
    p.y = y.data();
    p.z = z.data();
    return p;
  }
};

/// A rail's head as one arc, origin on its top.
Points arc_rail(double radius) {
  return Points(-0.030, 0.030, 481, [=](double y) { return radius - std::sqrt(radius * radius - y * y); });
}

class Model {
 public:
  explicit Model(const wrc_config& config) {
    char text[256] = "";
    EXPECT_EQ(wrc_config_check(&config, text, sizeof text), WRC_OK) << text;
    EXPECT_EQ(wrc_model_create(&config, nullptr, &model, nullptr, 0), WRC_OK);
  }
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;
  ~Model() { wrc_model_destroy(model); }
  wrc_model* model = nullptr;
};

/// All contact functions over some displacements.
struct Functions {
  std::vector<double> y, vertical, roll, dr, radius[2], angle[2], y_wheel[2], y_rail[2];

  Functions(const wrc_model* model, std::vector<double> lateral, double load = 0.0) : y(std::move(lateral)) {
    wrc_wheelset_geometry_problem problem = sized<wrc_wheelset_geometry_problem>();
    problem.count = static_cast<uint32_t>(y.size());
    problem.lateral = y.data();
    problem.wheel_load = load;
    wrc_wheelset_geometry functions = sized<wrc_wheelset_geometry>();
    const auto take = [&](std::vector<double>& values) {
      values.resize(y.size());
      return values.data();
    };
    functions.vertical = take(vertical);
    functions.roll = take(roll);
    functions.radius_difference = take(dr);
    functions.radius_right = take(radius[0]);
    functions.radius_left = take(radius[1]);
    functions.angle_right = take(angle[0]);
    functions.angle_left = take(angle[1]);
    functions.y_wheel_right = take(y_wheel[0]);
    functions.y_wheel_left = take(y_wheel[1]);
    functions.y_rail_right = take(y_rail[0]);
    functions.y_rail_left = take(y_rail[1]);
    char text[256] = "";
    EXPECT_EQ(wrc_profile_wheelset_geometry(model, &problem, &functions, text, sizeof text), WRC_OK) << text;
  }
};

struct Conicities {
  std::vector<double> conicity, wavelength, centre;
  int32_t status;
  std::string text;

  Conicities(const std::vector<double>& y, const std::vector<double>& dr, std::vector<double> amplitude,
             int32_t method, double e = 1.5, double r0 = 0.46)
      : conicity(amplitude.size(), -1.0), wavelength(conicity), centre(conicity) {
    wrc_conicity_problem problem = wrc_conicity_problem_default();
    problem.method = method;
    problem.count = static_cast<uint32_t>(y.size());
    problem.lateral = y.data();
    problem.radius_difference = dr.data();
    problem.amplitude_count = static_cast<uint32_t>(amplitude.size());
    problem.amplitudes = amplitude.data();
    problem.contact_distance = e;
    problem.radius = r0;
    wrc_conicity result = sized<wrc_conicity>();
    result.conicity = conicity.data();
    result.wavelength = wavelength.data();
    result.centre = centre.data();
    char sentence[256] = "";
    status = wrc_equivalent_conicity(&problem, &result, sentence, sizeof sentence);
    text = sentence;
  }
};

std::vector<double> of(const std::vector<double>& y, const std::function<double(double)>& function) {
  std::vector<double> values(y);
  for (double& value : values) value = function(value);
  return values;
}

constexpr int32_t both_methods[] = {WRC_CONICITY_WAVELENGTH, WRC_CONICITY_REGRESSION};

wrc_config new_profiles() {
  wrc_config config = test_config();
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_60E1;
  config.track.rail_inclination = 1.0 / 40.0;
  return config;
}

TEST(Conicity, OfAStraightDifferenceIsHalfItsSlope) {
  const std::vector<double> y = steps(-0.010, 0.012, 45);  // its middle is no point
  for (const double gamma : {0.01, 0.05, 0.4}) {
    const auto dr = of(y, [&](double at) { return 2.0 * gamma * (at - 0.0003); });
    for (const int32_t method : both_methods) {
      const Conicities found(y, dr, {1e-5, 0.001, 0.003, 0.0102}, method);
      ASSERT_EQ(found.status, WRC_OK) << found.text;
      for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(found.conicity[i], gamma, 1e-11 * gamma) << method << " " << i;
        EXPECT_NEAR(found.wavelength[i], 2.0 * pi * std::sqrt(1.5 * 0.46 / (2.0 * gamma)), 1e-9);
        EXPECT_NEAR(found.centre[i], 0.0003, 1e-12);
      }
    }
  }
}

/// Play in which nothing steers, then cones: a quarter of the motion is a straight line and a quarter swing
/// of the rest.
TEST(Conicity, WithPlayHasItsClosedSolution) {
  const double play = 0.002, gamma = 0.1, w = std::sqrt(2.0 * gamma / (1.5 * 0.46));
  const std::vector<double> y = steps(-0.010, 0.010, 41);
  const auto dr = of(y, [&](double at) {
    return std::abs(at) > play ? 2.0 * gamma * std::copysign(std::abs(at) - play, at) : 0.0;
  });
  const Conicities found(y, dr, {0.0025, 0.004, 0.0093}, WRC_CONICITY_WAVELENGTH);
  const double amplitudes[] = {0.0025, 0.004, 0.0093};
  for (std::size_t i = 0; i < 3; ++i) {
    const double swing = amplitudes[i] - play, u = w * swing;
    const double wavelength = 4.0 * (play / u + 0.5 * pi / w);
    EXPECT_NEAR(found.wavelength[i], wavelength, 1e-10 * wavelength);
  }
  // within the play nothing swings
  const Conicities none(y, dr, {0.001}, WRC_CONICITY_WAVELENGTH);
  EXPECT_EQ(none.status, WRC_OK);
  EXPECT_EQ(none.conicity[0], 0.0);
  EXPECT_EQ(none.wavelength[0], 0.0);
}

/// Wavelength by integration of y'' + dr / (e r0) = 0 from the end at rest, classical Runge-Kutta.
double wavelength_by_steps(const std::vector<double>& y, const std::vector<double>& dr, double start) {
  const auto force = [&](double at) {
    auto k = static_cast<std::size_t>(std::upper_bound(y.begin() + 1, y.end() - 1, at) - y.begin()) - 1;
    return -(dr[k] + (dr[k + 1] - dr[k]) / (y[k + 1] - y[k]) * (at - y[k])) / (1.5 * 0.46);
  };
  const double h = 2e-3;
  double at = start, u = 0.0, x = 0.0, before = 0.0;
  do {
    const double k1 = u, l1 = force(at), k2 = u + 0.5 * h * l1, l2 = force(at + 0.5 * h * k1),
                 k3 = u + 0.5 * h * l2, l3 = force(at + 0.5 * h * k2), k4 = u + h * l3,
                 l4 = force(at + h * k3);
    before = u;
    at += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    u += h / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
    x += h;
  } while (u > 0.0 && x < 1e3);
  return 2.0 * (x - h * u / (u - before));
}

TEST(Conicity, OfRealProfilesAgreesWithIntegrationStepByStep) {
  const Model model(new_profiles());
  const Functions rigid(model.model, steps(-0.008, 0.008, 161));
  const std::vector<double> amplitudes = {0.0005, 0.001, 0.002, 0.003, 0.004, 0.005, 0.006, 0.007};
  const Conicities found(rigid.y, rigid.dr, amplitudes, WRC_CONICITY_WAVELENGTH);
  ASSERT_EQ(found.status, WRC_OK) << found.text;
  double worst = 0.0;
  for (std::size_t i = 0; i < amplitudes.size(); ++i) {
    const double reference = wavelength_by_steps(rigid.y, rigid.dr, found.centre[i] - amplitudes[i]);
    worst = std::max(worst, std::abs(found.wavelength[i] / reference - 1.0));
    EXPECT_NEAR(found.centre[i], 0.0, 1e-9);
    std::printf("  amplitude %.1f mm: conicity %.5f\n", 1e3 * amplitudes[i], found.conicity[i]);
  }
  std::printf("  wavelength against integration step by step: %.1e\n", worst);
  EXPECT_LT(worst, 1e-5);
}

TEST(Conicity, RefusesWhatItCannotUse) {
  const std::vector<double> y = steps(-0.005, 0.005, 11), dr = of(y, [](double at) { return 0.1 * at; });
  EXPECT_EQ(Conicities(y, dr, {0.0051}, WRC_CONICITY_WAVELENGTH).status, WRC_ERROR_RANGE);
  EXPECT_EQ(Conicities(y, dr, {0.005}, WRC_CONICITY_WAVELENGTH).status, WRC_OK);
  EXPECT_EQ(Conicities(y, dr, {0.001}, 7).status, WRC_ERROR_UNSUPPORTED);
  auto folded = y;
  folded[3] = folded[2];
  EXPECT_EQ(Conicities(folded, dr, {0.001}, WRC_CONICITY_WAVELENGTH).status, WRC_ERROR_RANGE);
  EXPECT_EQ(wrc_equivalent_conicity(nullptr, nullptr, nullptr, 0), WRC_ERROR_NULL);
  EXPECT_EQ(wrc_profile_wheelset_geometry(nullptr, nullptr, nullptr, nullptr, 0), WRC_ERROR_NULL);
}

/// Cones on round heads: every place from the tangent's angle alone, the roll by bisection.
TEST(ContactFunctions, OfConesOnRoundRails) {
  const double gamma = 0.05, R = 0.2, s = 0.75, r0 = 0.46, top = 0.755;
  const double angle = std::atan(gamma);
  const Points wheel(-0.040, 0.060, 101, [&](double y) { return -gamma * y; }), rail = arc_rail(R);
  wrc_config config = test_config();
  config.wheel = wheel.profile();
  config.rail = rail.profile();
  config.track.placement = WRC_PLACEMENT_ORIGIN;
  config.track.rail_origin = top;
  config.wheelset.wheel_radius = r0;
  const Model model(config);
  const Functions found(model.model, steps(-0.008, 0.008, 9));
  /// Of the right wheel at a roll: where its line touches the arc, and the height of the wheelset's middle;
  /// the left wheel is the mirror image.
  struct Touch {
    double height, radius, y_wheel, y_rail;
  };
  const auto touch = [&](double lateral, double roll) {
    const double tilt = angle - roll;  // rises towards the flange, against the track
    const double on_rail = -R * std::sin(tilt), z = R - R * std::cos(tilt);
    // the wheel's line in the wheelset's frame: (s + y, r0 - gamma y), turned by the roll about the middle
    const double Y = top + on_rail - lateral;
    // Y = cos (s + y) - sin (r0 - gamma y)
    const double y =
        (Y - std::cos(roll) * s + std::sin(roll) * r0) / (std::cos(roll) + std::sin(roll) * gamma);
    const double Z = std::sin(roll) * (s + y) + std::cos(roll) * (r0 - gamma * y);
    return Touch{z - Z + r0, r0 - gamma * y, y, on_rail};
  };
  for (std::size_t i = 0; i < found.y.size(); ++i) {
    double low = -0.05, high = 0.05;
    for (int n = 0; n < 100; ++n) {
      const double roll = 0.5 * (low + high);
      (touch(found.y[i], roll).height > touch(-found.y[i], -roll).height ? low : high) = roll;
    }
    const Touch right = touch(found.y[i], low), left = touch(-found.y[i], -low);
    EXPECT_NEAR(found.roll[i], low, 1e-9);
    EXPECT_NEAR(found.vertical[i], right.height, 1e-9);
    EXPECT_NEAR(found.radius[0][i], right.radius, 1e-9);
    EXPECT_NEAR(found.radius[1][i], left.radius, 1e-9);
    EXPECT_NEAR(found.dr[i], right.radius - left.radius, 2e-9);
    EXPECT_NEAR(found.angle[0][i], angle - low, 1e-8);
    EXPECT_NEAR(found.angle[1][i], angle + low, 1e-8);
    EXPECT_NEAR(found.y_wheel[0][i], right.y_wheel, 1e-8);
    EXPECT_NEAR(found.y_wheel[1][i], left.y_wheel, 1e-8);
    EXPECT_NEAR(found.y_rail[0][i], right.y_rail, 1e-8);
    EXPECT_NEAR(found.y_rail[1][i], left.y_rail, 1e-8);
  }
}

/// A hollow wheel of one arc on a round rail: Joly's conicity of small displacements,
/// gamma0 Rw / (Rw - Rr) (s + Rr gamma0) / (s - r0 gamma0), s half the distance of the contacts.
TEST(ContactFunctions, OfArcsOnArcsHaveTheClosedConicity) {
  const double gamma0 = 0.05, Rw = 0.5, Rr = 0.3, s = 0.75, r0 = 0.46;
  const double depth = std::cos(std::atan(gamma0)), lean = std::sin(std::atan(gamma0));
  // wheel: arc through the origin with the slope -gamma0, hollow
  const Points wheel(-0.050, 0.060, 881, [&](double y) {
    const double from_centre = y - lean * Rw;
    return -std::sqrt(Rw * Rw - from_centre * from_centre) + depth * Rw;
  });
  const Points rail = arc_rail(Rr);
  wrc_config config = test_config();
  config.wheel = wheel.profile();
  config.rail = rail.profile();
  config.track.placement = WRC_PLACEMENT_ORIGIN;
  config.wheelset.wheel_radius = r0;
  config.track.rail_origin = s + lean * Rr;  // so that the wheel's origin touches
  const Model model(config);
  const double expected = gamma0 * Rw / (Rw - Rr) * (s + Rr * gamma0) / (s - r0 * gamma0);
  const Functions rigid(model.model, steps(-0.0005, 0.0005, 21));
  const Functions loaded(model.model, steps(-0.0005, 0.0005, 5), 60e3);
  EXPECT_NEAR(rigid.y_wheel[0][10], 0.0, 1e-7);
  for (const int32_t method : both_methods) {
    const Conicities found(rigid.y, rigid.dr, {0.0005}, method);
    std::printf("  arcs: %.6f, closed form %.6f\n", found.conicity[0], expected);
    EXPECT_NEAR(found.conicity[0], expected, 2e-4 * expected);
    // the middle of the elastic contact moves as the point does
    const Conicities elastic(loaded.y, loaded.dr, {0.0005}, method);
    std::printf("  under load: %.6f\n", elastic.conicity[0]);
    EXPECT_NEAR(elastic.conicity[0], expected, 2e-3 * expected);
  }
}

TEST(ContactFunctions, AreThoseOfTheMirrorImage) {
  const Model model(new_profiles());
  for (const double load : {0.0, 80e3}) {
    const Functions found(model.model, steps(-0.006, 0.006, 7), load);
    for (std::size_t i = 0; i < 7; ++i) {
      const std::size_t k = 6 - i;
      EXPECT_NEAR(found.dr[i], -found.dr[k], 1e-9);
      EXPECT_NEAR(found.roll[i], -found.roll[k], 1e-9);
      EXPECT_NEAR(found.vertical[i], found.vertical[k], 1e-9);
      EXPECT_NEAR(found.angle[0][i], found.angle[1][k], 1e-6);
      EXPECT_NEAR(found.y_rail[0][i], found.y_rail[1][k], 1e-6);
      EXPECT_NEAR(found.y_wheel[0][i], found.y_wheel[1][k], 1e-6);
    }
  }
}

/// Rigid bodies jump from one contact point to another; under load nothing does.
TEST(ContactFunctions, UnderLoadAreContinuous) {
  const Model model(new_profiles());
  const auto y = steps(-0.0065, -0.0045, 41);
  const auto largest_step = [](const std::vector<double>& values) {
    double largest = 0.0;
    for (std::size_t i = 1; i < values.size(); ++i)
      largest = std::max(largest, std::abs(values[i] - values[i - 1]));
    return largest;
  };
  const double rigid = largest_step(Functions(model.model, y).y_wheel[1]);
  const double loaded = largest_step(Functions(model.model, y, 80e3).y_wheel[1]);
  std::printf("  contact on the wheel moves by at most %.2f mm, under load %.2f mm, per 0.05 mm\n",
              1e3 * rigid, 1e3 * loaded);
  EXPECT_GT(rigid, 2e-3);
  EXPECT_LT(loaded, 0.5 * rigid);
}

TEST(ContactFunctions, SayWhereTheyFail) {
  const Model model(new_profiles());
  const std::vector<double> y = {0.0, 0.09};
  std::vector<double> dr(2, 1.0);
  wrc_wheelset_geometry_problem problem = sized<wrc_wheelset_geometry_problem>();
  problem.count = 2;
  problem.lateral = y.data();
  wrc_wheelset_geometry functions = sized<wrc_wheelset_geometry>();
  functions.radius_difference = dr.data();
  char text[256] = "";
  for (const double load : {0.0, 80e3}) {
    problem.wheel_load = load;
    const int32_t status =
        wrc_profile_wheelset_geometry(model.model, &problem, &functions, text, sizeof text);
    EXPECT_LT(status, 0) << text;
    EXPECT_NE(std::string(text), "");
    EXPECT_EQ(dr[0], 0.0);
  }
}

}  // namespace
