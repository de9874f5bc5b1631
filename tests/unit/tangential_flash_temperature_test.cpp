/// Flash temperatures against moving sources in closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/elementary.hpp"
#include "tangential/friction/flash_temperature.hpp"

namespace wrc::tangential {
namespace {

/// Rise in one strip of length 1 at unit speed and effusivities of 1/2 each, from heat over the way s.
template <typename Heat>
std::vector<double> rise_of(std::int32_t cells, Heat&& heat) {
  const auto n = static_cast<std::size_t>(cells);
  std::vector<double> one(n, 1.0), none(n, 0.0), slip, rise(n);
  for (std::int32_t i = 0; i < cells; ++i) slip.push_back(-heat((i + 0.5) / cells));
  double half = 0.5;
  patch::Strips strip{};
  strip.count = 1;
  strip.half_length = &half;
  flash_rise(strip, {one.data(), none.data(), slip.data(), none.data()}, cells, 1.0, {0.5, 0.5},
             FlashWeights(cells), rise.data());
  return rise;
}

// q = s: 4/3 s^(3/2) / sqrt(pi), of which the rule has no error; nor has it of what begins within the strip.
TEST(FlashTemperature, IsExactForLinearHeat) {
  for (const std::int32_t cells : {1, 2, 7, 512}) {
    const std::vector<double> rise = rise_of(cells, [](double s) { return 3.0 * s; });
    for (std::int32_t i = 0; i < cells; ++i) {
      const double s = (i + 0.5) / cells;
      EXPECT_NEAR(rise[static_cast<std::size_t>(i)], 4.0 * s * std::sqrt(s / pi), 1e-11 * s) << cells;
    }
  }
  const std::vector<double> rise = rise_of(8, [](double s) { return std::fmax(0.0, s - 0.3125); });
  for (std::size_t i = 0; i < 8; ++i) {
    const double s = std::fmax(0.0, (static_cast<double>(i) + 0.5) / 8 - 0.3125);
    EXPECT_NEAR(rise[i], 4.0 / 3.0 * s * std::sqrt(s / pi), 1e-14);
  }
}

// Jaeger: constant heat gives 2 sqrt(s / pi), but for the half cell in which the rule lets it rise; parabolic
// heat s (1 - s) gives s^(3/2) (4/3 - 16/15 s) / sqrt(pi), at second order.
TEST(FlashTemperature, ConvergesToJaegersSources) {
  const std::vector<double> constant = rise_of(64, [](double) { return 1.0; });
  EXPECT_NEAR(constant[63], 2.0 * std::sqrt(63.5 / 64 / pi), 0.005);
  double before = 0.0;
  for (const std::int32_t cells : {16, 32, 64}) {
    const std::vector<double> rise = rise_of(cells, [](double s) { return s * (1.0 - s); });
    double worst = 0.0;
    for (std::int32_t i = 0; i < cells; ++i) {
      const double s = (i + 0.5) / cells;
      const double exact = s * std::sqrt(s / pi) * (4.0 / 3.0 - 16.0 / 15.0 * s);
      worst = std::max(worst, std::abs(rise[static_cast<std::size_t>(i)] - exact));
    }
    if (before > 0.0) {
      EXPECT_NEAR(before / worst, 4.0, 0.5);
    }
    before = worst;
  }
  EXPECT_LT(before, 1e-4);
}

TEST(FlashTemperature, HeatOfTheOtherSignIsNone) {
  for (const double each : rise_of(8, [](double) { return -1.0; })) EXPECT_EQ(each, 0.0);
}

// Strips are counted in blocks: each is as if it were alone.
TEST(FlashTemperature, StripsDoNotSeeEachOther) {
  constexpr std::int32_t strips = 150, cells = 5;
  std::vector<double> one(strips * cells, 1.0), none(one.size(), 0.0), slip(one.size()), rise(one.size()),
      half(strips);
  for (std::size_t k = 0; k < slip.size(); ++k) slip[k] = -std::fabs(std::sin(static_cast<double>(k)));
  for (std::size_t j = 0; j < half.size(); ++j) half[j] = 1.0 + 0.01 * static_cast<double>(j);
  patch::Strips all{};
  all.count = strips;
  all.half_length = half.data();
  const FlashWeights weights(cells);
  flash_rise(all, {one.data(), none.data(), slip.data(), none.data()}, cells, 4.0, {1.0, 2.0}, weights,
             rise.data());
  for (const std::size_t j : {0, 63, 64, 149}) {
    double own_slip[cells], own_rise[cells];
    for (std::size_t i = 0; i < cells; ++i) own_slip[i] = slip[i * strips + j];
    patch::Strips alone{};
    alone.count = 1;
    alone.half_length = &half[j];
    flash_rise(alone, {one.data(), none.data(), own_slip, none.data()}, cells, 4.0, {1.0, 2.0}, weights,
               own_rise);
    for (std::size_t i = 0; i < cells; ++i) EXPECT_EQ(own_rise[i], rise[i * strips + j]);
  }
}

}  // namespace
}  // namespace wrc::tangential
