#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"

namespace wrc {
namespace {

/// Distance of `value` from the extended-precision `exact` in units in the last place of the latter.
double ulps(double value, long double exact) {
  int exponent = 0;
  std::frexp(static_cast<double>(exact), &exponent);
  return static_cast<double>(std::fabs(static_cast<long double>(value) - exact)) *
         std::ldexp(1.0, 53 - exponent);
}

/// Largest error over [from, to], at points whose bits have no pattern.
template <typename Function, typename Exact>
double worst(double from, double to, Function&& function, Exact&& exact) {
  double most = 0.0;
  for (int i = 0; i <= 200000; ++i) {
    const double x = from + (to - from) * std::fmod(i * 0.6180339887498949, 1.0);
    most = std::max(most, ulps(function(x), exact(static_cast<long double>(x))));
  }
  return most;
}

TEST(Elementary, AgreesWithExtendedPrecision) {
  const auto sine = [](double x) { return sine_cosine(x).sine; };
  const auto cosine = [](double x) { return sine_cosine(x).cosine; };
  const auto exact_sine = [](long double x) { return std::sin(x); };
  const auto exact_cosine = [](long double x) { return std::cos(x); };
  EXPECT_LT(worst(-0.3, 0.3, sine, exact_sine), 1.0);
  EXPECT_LT(worst(-0.3, 0.3, cosine, exact_cosine), 1.0);
  EXPECT_LT(worst(-0.25 * pi, 0.25 * pi, sine, exact_sine), 2.0);
  EXPECT_LT(worst(-0.25 * pi, 0.25 * pi, cosine, exact_cosine), 2.0);
  EXPECT_LT(worst(-0.5 * pi, 0.5 * pi, sine, exact_sine), 2.0);
  for (int i = 7000; i < 15707; ++i) EXPECT_NEAR(cosine(1e-4 * i), std::cos(1e-4 * i), 3e-16);

  const auto exact_atan = [](long double x) { return std::atan(x); };
  EXPECT_LT(worst(-0.5, 0.5, arctangent, exact_atan), 2.0);
  EXPECT_LT(worst(-3.0, 3.0, arctangent, exact_atan), 2.0);
  EXPECT_LT(worst(2.0, 1e4, arctangent, exact_atan), 2.0);
  EXPECT_LT(worst(-1.0, 1.0, arcsine, [](long double x) { return std::asin(x); }), 2.5);

  const auto exact_log = [](long double x) { return std::log(x); };
  EXPECT_LT(worst(0.3, 3.0, natural_log, exact_log), 2.0);
  EXPECT_LT(worst(1e-9, 1.0, natural_log, exact_log), 2.0);
  EXPECT_LT(worst(2.0, 1e9, natural_log, exact_log), 2.0);
  const auto exact_exp = [](long double x) { return std::exp(x); };
  EXPECT_LT(worst(-1.0, 1.0, natural_exp, exact_exp), 2.0);
  EXPECT_LT(worst(-600.0, 600.0, natural_exp, exact_exp), 2.0);
}

TEST(Elementary, MeetsTheEndsExactly) {
  EXPECT_EQ(sine_cosine(0.0).sine, 0.0);
  EXPECT_EQ(sine_cosine(0.0).cosine, 1.0);
  EXPECT_EQ(arctangent(0.0), 0.0);
  EXPECT_TRUE(std::signbit(arctangent(-0.0)));
  EXPECT_EQ(arctangent(1.0), 0.25 * pi);
  EXPECT_EQ(arctangent(HUGE_VAL), 0.5 * pi);
  EXPECT_EQ(arctangent(-HUGE_VAL), -0.5 * pi);
  EXPECT_EQ(arcsine(1.0), 0.5 * pi);
  EXPECT_EQ(arcsine(-1.0), -0.5 * pi);
  EXPECT_EQ(arcsine(0.0), 0.0);
  EXPECT_EQ(natural_log(1.0), 0.0);
  EXPECT_EQ(natural_exp(0.0), 1.0);
}

TEST(Elementary, AnglesOfPointsAreTheirOwnInAllQuarters) {
  for (int i = -314; i <= 314; ++i) {
    const double angle = 1e-2 * i;
    for (double distance : {1e-9, 1.0, 3e7})
      EXPECT_NEAR(arctangent2(distance * std::sin(angle), distance * std::cos(angle)), angle, 1e-15);
  }
  EXPECT_EQ(arctangent2(0.0, 2.0), 0.0);
  EXPECT_EQ(arctangent2(2.0, 0.0), 0.5 * pi);
  EXPECT_EQ(arctangent2(-2.0, 0.0), -0.5 * pi);
  EXPECT_EQ(arctangent2(0.0, -2.0), pi);
}

/// Beside the places where a range begins, neighbouring numbers give neighbouring values.
TEST(Elementary, RangesMeetWithoutAStep) {
  for (double join : {0.41421356237309504880, 2.41421356237309504880}) {
    double x = join, before = arctangent(join);
    for (int towards : {10, -10}) {  // up, and down past the join
      for (int i = 0; i < (towards > 0 ? 1000 : 2000); ++i) {
        x = std::nextafter(x, towards);
        EXPECT_NEAR(arctangent(x), before, 4e-16);
        before = arctangent(x);
      }
    }
  }
}

}  // namespace
}  // namespace wrc
