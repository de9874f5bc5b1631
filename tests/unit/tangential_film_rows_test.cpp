/// Shares of rows in a strip's mean: they add up to 1, and their slopes are those of differences, and
/// continuous.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tangential/friction/film_rows.hpp"

namespace wrc::tangential {
namespace {

constexpr RowsAcross rows{5.0, -8e-3, 4e-3};
constexpr double half = 0.7e-3;

/// Shares of all rows, or their slopes.
std::array<double, 5> all(double y, bool slopes, double half_by_y = 0.0) {
  const RowShares shares = row_shares(rows, y, half + half_by_y * y, half_by_y);
  std::array<double, 5> each{};
  for (std::int32_t i = 0; i < shares.count; ++i)
    each[static_cast<std::size_t>(shares.first + i)] = slopes ? shares.by_y[i] : shares.share[i];
  return each;
}

TEST(FilmRows, SharesAreWholeAndNotNegative) {
  for (double y = -20e-3; y < 20e-3; y += 0.137e-3) {
    double sum = 0.0;
    for (const double share : all(y, false)) {
      EXPECT_GE(share, -1e-12);
      sum += share;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12) << y;
  }
  EXPECT_EQ(all(-20e-3, false)[0], 1.0);
  EXPECT_EQ(all(20e-3, false)[4], 1.0);
}

TEST(FilmRows, SlopesAreThoseOfDifferencesAndContinuous) {
  constexpr double step = 1e-8;
  for (const double half_by_y : {0.0, 0.02}) {
    std::array<double, 5> before = all(-12e-3, true, half_by_y);
    for (double y = -12e-3; y < 12e-3; y += 1e-6) {
      const std::array<double, 5> more = all(y + step, false, half_by_y),
                                  less = all(y - step, false, half_by_y), slope = all(y, true, half_by_y);
      for (std::size_t k = 0; k < 5; ++k) {
        EXPECT_NEAR(slope[k], (more[k] - less[k]) / (2.0 * step), 1e-5 / 4e-3) << y;
        // a strip 1.4 mm wide turns from one slope to the other over its width
        EXPECT_LT(std::abs(slope[k] - before[k]), 1.2e-6 / ((half + half_by_y * y) * rows.width)) << y;
      }
      before = slope;
    }
  }
}

TEST(FilmRows, AStripHasTheMeanOfItsCells) {
  // cells that are linear in both rows: the mean is the value at the strip's middle
  std::array<FilmCell, 25> cells;
  for (int r = 0; r < 5; ++r)
    for (int w = 0; w < 5; ++w)
      cells[static_cast<std::size_t>(5 * r + w)] = {0.1 * r, 0.02 * w, 1e-15 * (r + w), 1e-9 * w, -1e12 * r};
  FilmRows films;
  films.rail = films.wheel = rows;
  films.layered = 1.0;
  films.cells = cells.data();
  const double y = 1.3e-3, on_wheel = -2.1e-3;
  const FilmOfStrip film = film_of_strip(films, row_shares(rows, y, half), row_shares(rows, on_wheel, half));
  const double r = (y - rows.middle) / rows.width, w = (on_wheel - rows.middle) / rows.width;
  EXPECT_NEAR(film.mean.share, 0.1 * r, 1e-14);
  EXPECT_NEAR(film.mean.addition, 0.02 * w, 1e-14);
  EXPECT_NEAR(film.by_wheel_y.addition, 0.02 / rows.width, 1e-9);
  EXPECT_NEAR(film.by_wheel_y.share, 0.0, 1e-12);
  Layer layer, by_y;
  layer_of_strip(film, layer, by_y);
  EXPECT_NEAR(layer.flexibility, 1e-15 * (r + w), 1e-28);
  EXPECT_NEAR(layer.yield, 1e9 / w, 1e-3);
  EXPECT_NEAR(by_y.yield, -1e9 / (w * w) / rows.width, 1.0);
}

}  // namespace
}  // namespace wrc::tangential
