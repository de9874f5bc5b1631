/// Search of the height that carries a load.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "surface/wrench/height_search.hpp"

namespace wrc::surface {
namespace {

constexpr double touch = -3e-4, load = 80e3;

/// Hertz's contact: F = c d^(3/2).
double hertz(double height) {
  const double depth = std::max(height - touch, 0.0);
  return 9.3e10 * depth * std::sqrt(depth);
}

TEST(HeightSearch, ALoadOfHertzsContactNeedsTwoHeights) {
  HeightSearch search(load);
  search.take(touch, 0.0, 0.0);
  search.take(touch + 5e-5, hertz(touch + 5e-5), 0.0);
  EXPECT_NEAR(hertz(search.next(1, 0.0)) / load, 1.0, 1e-9);
}

TEST(HeightSearch, AStiffnessStandsForTheSlopeThatWasNotSeenYet) {
  HeightSearch search(load);
  const double height = touch + 8e-5, force = hertz(height), stiffness = 1.5 * force / (height - touch);
  search.take(height, force, 0.0);
  const double exact = touch + std::pow(load / 9.3e10, 2.0 / 3.0), next = search.next(0, stiffness);
  EXPECT_LT(std::abs(next - exact), 0.1 * std::abs(height - exact));
  EXPECT_EQ(search.next(0, 0.0), height + 60e-6);  // nothing known: a step on towards more load
}

TEST(HeightSearch, StaysBetweenHeightsThatCarryTooLittleAndTooMuch) {
  // stiff beyond a step in the load: secants from below lead far beyond it
  const auto stepped = [](double height) { return height < 1e-5 ? 1e3 + 1e6 * height : 2e5; };
  HeightSearch search(load);
  double low = 0.0, high = 4e-5;
  search.take(low, stepped(low), 0.0);
  search.take(high, stepped(high), 0.0);
  for (int step = 2; step < 60 && !search.exhausted(); ++step) {
    const double next = search.next(step, 0.0);
    ASSERT_GT(next, low);
    ASSERT_LT(next, high);
    (stepped(next) < load ? low : high) = next;
    search.take(next, stepped(next), 0.0);
  }
  EXPECT_LT(high - low, 1e-10);
  EXPECT_TRUE(low < 1e-5 && high >= 1e-5);
}

TEST(HeightSearch, KeepsTheSlopeWhenItForgetsHeights) {
  HeightSearch search(load);
  search.take(touch, 0.0, 0.0);
  search.take(touch + 5e-5, hertz(touch + 5e-5), 0.0);
  search.forget_heights();
  // another load at the same heights, as with friction: one height and the slope give the next
  const auto weaker = [](double height) { return 0.98 * hertz(height); };
  const double height = touch + 8e-5;
  search.take(height, weaker(height), 0.0);
  EXPECT_NEAR(weaker(search.next(0, 0.0)) / load, 1.0, 3e-3);
}

TEST(HeightSearch, RisesWithinTheDoubtOfTheLoadsSayNothingOfTheSlope) {
  HeightSearch certain(load), doubtful(load);
  for (HeightSearch* search : {&certain, &doubtful}) {
    const double doubt = search == &certain ? 0.0 : 0.1;
    search->take(touch + 9.0e-5, 79.0e3, doubt);
    search->take(touch + 9.1e-5, 79.1e3, doubt);
  }
  EXPECT_GT(certain.next(1, 0.0), touch + 9.1e-5);
  EXPECT_EQ(doubtful.next(1, 0.0), touch + 9.1e-5 + 120e-6);  // as if nothing were known
}

}  // namespace
}  // namespace wrc::surface
