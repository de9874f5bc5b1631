#include "patch/gap.hpp"

#include <algorithm>

namespace wrc {
namespace {

/// Slope of the height at row j from the parabola through the row and its neighbours (one-sided at the ends).
double row_slope(const GapRows& rows, std::int32_t j) {
  const std::int32_t middle = std::clamp(j, 1, rows.count - 2);
  const double left = rows.y[middle] - rows.y[middle - 1];
  const double right = rows.y[middle + 1] - rows.y[middle];
  const double slope_left = (rows.height[middle] - rows.height[middle - 1]) / left;
  const double slope_right = (rows.height[middle + 1] - rows.height[middle]) / right;
  const double slope = (slope_left * right + slope_right * left) / (left + right);
  const double second = 2.0 * (slope_right - slope_left) / (left + right);
  return slope + second * (rows.y[j] - rows.y[middle]);
}

}  // namespace

GapRow interpolate(const GapRows& rows, double y) {
  const std::int32_t last = rows.count - 1;
  y = std::clamp(y, rows.y[0], rows.y[last]);
  const double* above = std::upper_bound(rows.y, rows.y + rows.count, y);
  const std::int32_t j = std::clamp(static_cast<std::int32_t>(above - rows.y) - 1, 0, last - 1);

  const double dy = rows.y[j + 1] - rows.y[j];
  const double t = (y - rows.y[j]) / dy;
  const double rise = rows.height[j + 1] - rows.height[j];
  const double m0 = row_slope(rows, j) * dy;
  const double m1 = row_slope(rows, j + 1) * dy;
  // Hermite cubic: height = h0 + t (m0 + t (c2 + t c3))
  const double c2 = 3.0 * rise - 2.0 * m0 - m1;
  const double c3 = m0 + m1 - 2.0 * rise;
  GapRow row;
  row.height = rows.height[j] + t * (m0 + t * (c2 + t * c3));
  row.slope = (m0 + t * (2.0 * c2 + 3.0 * t * c3)) / dy;
  row.centre = rows.centre[j] + t * (rows.centre[j + 1] - rows.centre[j]);
  row.curvature = rows.curvature[j] + t * (rows.curvature[j + 1] - rows.curvature[j]);
  return row;
}

std::int32_t lowest_row(const GapRows& rows) {
  return static_cast<std::int32_t>(std::min_element(rows.height, rows.height + rows.count) - rows.height);
}

GapMinimum minimum(const GapRows& rows) {
  // The interpolant is C1 and, around its lowest node, unimodal: bisect the slope over the two adjoining
  // pieces.
  const std::int32_t j = lowest_row(rows);
  double low = rows.y[std::max(j - 1, 0)];
  double high = rows.y[std::min(j + 1, rows.count - 1)];
  if (interpolate(rows, low).slope >= 0.0) return {low, rows.height[std::max(j - 1, 0)]};
  if (interpolate(rows, high).slope <= 0.0) return {high, rows.height[std::min(j + 1, rows.count - 1)]};
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (interpolate(rows, middle).slope < 0.0 ? low : high) = middle;
  }
  const double y = 0.5 * (low + high);
  return {y, interpolate(rows, y).height};
}

}  // namespace wrc
