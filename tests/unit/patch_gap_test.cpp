#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "patch/gap.hpp"

namespace wrc::patch {
namespace {

/// Rows of the elliptic gap A x^2 + B (y - y0)^2 with the rows' minimum moving along x = c y, as yaw makes
/// it.
struct EllipticRows {
  std::vector<double> y, height, centre, curvature;
  EllipticRows(double a_curvature, double b_curvature, double y0, double c, int rows) {
    for (int j = 0; j < rows; ++j) {
      const double at = -0.02 + 0.04 * j / (rows - 1);
      y.push_back(at);
      height.push_back(b_curvature * (at - y0) * (at - y0));
      centre.push_back(c * at);
      curvature.push_back(2.0 * a_curvature);
    }
  }
  GapRows rows() const {
    return {static_cast<std::int32_t>(y.size()), y.data(), height.data(), centre.data(), curvature.data()};
  }
};

TEST(Gap, InterpolationIsExactForParabolasBetweenUnevenRows) {
  EllipticRows gap(1.0, 3.0, 0.0017, 0.1, 41);
  gap.y[7] += 3e-4;  // one row out of step
  gap.height[7] = 3.0 * std::pow(gap.y[7] - 0.0017, 2);
  gap.centre[7] = 0.1 * gap.y[7];
  for (double y : {-0.0199, -0.01333, 0.0, 0.00171, 0.0188}) {
    const GapRow row = interpolate(gap.rows(), y);
    EXPECT_NEAR(row.height, 3.0 * (y - 0.0017) * (y - 0.0017), 1e-15);
    EXPECT_NEAR(row.slope, 6.0 * (y - 0.0017), 1e-12);
    EXPECT_NEAR(row.centre, 0.1 * y, 1e-15);
  }
}

TEST(Gap, ReaderGivesTheSameBitsInAnyOrder) {
  EllipticRows gap(1.0, 3.0, 0.0017, 0.1, 41);
  for (std::size_t j = 0; j < gap.y.size(); ++j) gap.height[j] += 1e-6 * std::sin(3e3 * gap.y[j]);
  GapReader reader(gap.rows());
  double y = 0.0;
  for (int n = 0; n < 400; ++n) {
    y = n < 200 ? -0.021 + 2.1e-4 * n : -0.022 + std::fmod(y + 0.0271, 0.044);  // along, then anywhere
    const GapRow there = interpolate(gap.rows(), y), read = reader.at(y);
    EXPECT_EQ(read.height, there.height) << y;
    EXPECT_EQ(read.slope, there.slope) << y;
    EXPECT_EQ(read.centre, there.centre) << y;
    EXPECT_EQ(read.curvature, there.curvature) << y;
    EXPECT_EQ(reader.height(y), there.height) << y;
  }
}

TEST(Gap, MinimumLiesBetweenRows) {
  const EllipticRows gap(1.0, 3.0, 0.00171, 0.0, 41);
  const GapMinimum lowest = minimum(gap.rows());
  EXPECT_NEAR(lowest.y, 0.00171, 1e-9);
  EXPECT_NEAR(lowest.height, 0.0, 1e-15);
}

TEST(Gap, MinimumAtTheEdgeIsTheEdge) {
  const EllipticRows gap(1.0, 3.0, 0.05, 0.0, 41);
  EXPECT_DOUBLE_EQ(minimum(gap.rows()).y, 0.02);
}

TEST(Gap, MinimumIsNoHigherThanAnyRow) {
  EllipticRows gap(1.0, 0.0, 0.0, 0.0, 25);
  for (const double waves : {0.0, 1.0, 5.5, 11.0, 11.5, 12.0, 23.0}) {
    for (const double slope : {-1e-6, 0.0, 1e-7, 1e-5}) {
      for (int j = 0; j < 25; ++j)
        gap.height[j] = 4e-8 * std::cos(waves * 6.283185307 * j / 24.0) + slope * gap.y[j];
      const GapRows rows = gap.rows();
      for (int first = 0; first < 24; ++first) {
        for (int last = first; last < 25; ++last) {
          const GapMinimum least = minimum(rows, rows.y[first], rows.y[last]);
          EXPECT_EQ(least.height, interpolate(rows, least.y).height);
          EXPECT_GE(least.y, rows.y[first]);
          EXPECT_LE(least.y, rows.y[last]);
          for (int j = first; j <= last; ++j)
            ASSERT_LE(least.height, rows.height[j] + 1e-22) << waves << " " << slope << " " << j;
        }
      }
    }
  }
}

TEST(Gap, GridOfASkewedParaboloidGivesItsRows) {
  std::vector<double> x, y, h;
  for (int i = 0; i < 31; ++i) x.push_back(-0.015 + 0.001 * i);
  for (int j = 0; j < 21; ++j) y.push_back(-0.01 + 0.001 * j);
  for (double yj : y)
    for (double xi : x) h.push_back(1.1 * (xi - 0.2 * yj) * (xi - 0.2 * yj) + 4.0 * yj * yj - 1e-5);
  std::vector<double> height(y.size()), centre(y.size()), curvature(y.size());
  const GapGrid grid{21, 31, x.data(), y.data(), h.data(), 31};
  ASSERT_EQ(rows_from_grid(grid, 1e-4, height.data(), centre.data(), curvature.data()).status, WRC_OK);
  for (std::size_t j = 0; j < y.size(); ++j) {
    EXPECT_NEAR(height[j], 4.0 * y[j] * y[j] - 1e-5, 1e-15);
    EXPECT_NEAR(centre[j], 0.2 * y[j], 1e-12);
    EXPECT_NEAR(curvature[j], 2.2, 1e-9);
  }
}

TEST(Gap, GridRowWithoutMinimumIsNamed) {
  const std::vector<double> x{-1e-3, 0.0, 1e-3}, y{0.0, 1e-3, 2e-3, 3e-3};
  const std::vector<double> h{1, 0, 1, 1, 0, 1, -1, 0, -1, 1, 0, 1};
  std::vector<double> out(12);
  const Fault fault =
      rows_from_grid({4, 3, x.data(), y.data(), h.data(), 3}, 1e-4, &out[0], &out[4], &out[8]);
  EXPECT_EQ(fault.status, WRC_ERROR_GAP);
  EXPECT_EQ(fault.index, 2);
}

}  // namespace
}  // namespace wrc::patch
