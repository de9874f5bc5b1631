/// Whole numbers of 128 bits, and the shares of bins.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "damage/bins.hpp"

namespace wrc::damage {
namespace {

TEST(WholeNumbers, HoldDoublesToTheUnit) {
  for (const double x : {0.0, 1.0, -1.0, 0.1, -0.1, 1e-18, -1e-18, 1e-300, -1e-300, 3.7e15, -3.7e15, 0x1p61,
                         -0x1p61, 0.9999999999999999, -0.9999999999999999})
    EXPECT_NEAR(number(whole(x)), x, 0x1p-62 + 2e-16 * std::abs(x)) << x;
  const WholeNumber a = whole(0.3), b = whole(-7.25e9);
  const WholeNumber back = minus(plus(a, b), b);
  EXPECT_EQ(back.low, a.low);
  EXPECT_EQ(back.high, a.high);
  EXPECT_EQ(number(plus(whole(0.75), whole(-0.75))), 0.0);
  const WholeNumber big = whole(0x1.8p61);
  EXPECT_FALSE(left_range(big, big, plus(big, big)));
  const WholeNumber twice = plus(big, big);
  EXPECT_TRUE(left_range(twice, big, plus(twice, big)));
}

struct Set {
  std::vector<DamageBin> bin;
  DamageBins bins;
  Set(Axis across, Axis along)
      : bin(static_cast<std::size_t>(across.count * along.count + 1)), bins{across, along, bin.data()} {}
  double at(std::size_t k) const { return number(bin[k].sum[0]) / damage_scale[0]; }
};

Contribution work(double joule) {
  Contribution c;
  c.sum[0] = joule;
  c.pressure = joule;
  return c;
}

/// One contribution as a step of its own.
bool add(const Contribution& contribution, double place, double width, double from, double to,
         const DamageBins& bins) {
  BinAdder adder(bins, from, to);
  adder.take(contribution, place, width);
  return adder.finish();
}

TEST(DamageBins, ShareByOverlap) {
  Set set({0.0, 1.0, 3}, {10.0, 2.0, 2});
  // 0.5 .. 2.5 across, 11 .. 15 along: the last quarter lies beside
  ASSERT_TRUE(add(work(16.0), 1.5, 2.0, 11.0, 15.0, set.bins));
  const double expected[] = {1.0, 2.0, 1.0, 2.0, 4.0, 2.0, 4.0};
  for (std::size_t k = 0; k < 7; ++k) EXPECT_EQ(set.at(k), expected[k]) << k;
  EXPECT_EQ(set.bin[4].largest_pressure, 16.0);
}

TEST(DamageBins, TakeWhatLiesBesideAndWhatHasNoLength) {
  Set set({0.0, 1.0, 3}, {0.0, 0.0, 1});
  ASSERT_TRUE(add(work(1.0), -5.0, 1.0, 3.0, 4.0, set.bins));
  ASSERT_TRUE(add(work(2.0), 50.0, 1.0, 3.0, 4.0, set.bins));
  ASSERT_TRUE(add(work(4.0), 0.0, 1.0, 3.0, 4.0, set.bins));
  ASSERT_TRUE(add(work(8.0), 3.0, 1.0, 3.0, 4.0, set.bins));
  EXPECT_EQ(set.at(0), 2.0);
  EXPECT_EQ(set.at(1), 0.0);
  EXPECT_EQ(set.at(2), 4.0);
  EXPECT_EQ(set.at(3), 3.0 + 2.0 + 4.0);
  Set rows({0.0, 1.0, 1}, {0.0, 1.0, 3});
  ASSERT_TRUE(add(work(1.0), 0.5, 0.5, 1.5, 1.5, rows.bins));  // a wheel that stands
  EXPECT_EQ(rows.at(1), 1.0);
  ASSERT_TRUE(add(work(1.0), 0.5, 0.5, 7.0, 7.0, rows.bins));
  EXPECT_EQ(rows.at(3), 1.0);
}

/// Shares of odd widths add up to the contributions.
TEST(DamageBins, LoseNothing) {
  Set set({-0.07, 0.37e-3, 300}, {0.0, 0.013, 40});
  WholeNumber given;
  for (int i = 0; i < 500; ++i) {
    const double joule = std::sin(1.0 + i) / 3.0;
    ASSERT_TRUE(
        add(work(joule), -0.07 + 0.2e-3 * i, 0.4e-3 + 1e-6 * i, 1e-3 * i, 1e-3 * i + 0.0217, set.bins));
    given = plus(given, whole(joule * damage_scale[0]));
  }
  WholeNumber held;
  for (const DamageBin& bin : set.bin) held = plus(held, bin.sum[0]);
  EXPECT_NEAR(number(held) / number(given), 1.0, 1e-13);
}

TEST(DamageBins, SayWhenASumIsFull) {
  Set set({0.0, 1.0, 1}, {0.0, 0.0, 1}), other({0.0, 1.0, 1}, {0.0, 0.0, 1});
  ASSERT_TRUE(add(work(0x1.8p41), 0.5, 0.1, 0.0, 0.0, set.bins));
  ASSERT_TRUE(add(work(0x1.8p41), 0.5, 0.1, 0.0, 0.0, set.bins));
  EXPECT_EQ(set.bin[0].overflow, 0U);
  EXPECT_FALSE(add(work(0x1.8p41), 0.5, 0.1, 0.0, 0.0, set.bins));
  EXPECT_EQ(set.bin[0].overflow, 1U);
  EXPECT_FALSE(add(work(0x1p42), 0.5, 0.1, 0.0, 0.0, other.bins));
  EXPECT_EQ(other.bin[0].overflow, 1U);
  Set into({0.0, 1.0, 1}, {0.0, 0.0, 1});
  EXPECT_FALSE(merge(into.bins, other.bins));
  EXPECT_EQ(into.bin[0].overflow, 1U);
}

}  // namespace
}  // namespace wrc::damage
