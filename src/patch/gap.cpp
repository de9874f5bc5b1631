#include "patch/gap.hpp"

#include <algorithm>
#include <cmath>

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

/// The j with y[j] <= y < y[j + 1] (the last interval includes its end): rows are spread nearly evenly, so
/// the proportional guess is right or next to it.
std::int32_t interval_of(const GapRows& rows, double y) {
  const std::int32_t last = rows.count - 1;
  const double share = (y - rows.y[0]) / (rows.y[last] - rows.y[0]);
  auto j = std::clamp(static_cast<std::int32_t>(share * last), 0, last - 1);
  while (j > 0 && y < rows.y[j]) --j;
  while (j < last - 1 && y >= rows.y[j + 1]) ++j;
  return j;
}

}  // namespace

GapRow interpolate(const GapRows& rows, double y) {
  const std::int32_t last = rows.count - 1;
  y = std::clamp(y, rows.y[0], rows.y[last]);
  const std::int32_t j = interval_of(rows, y);

  const double dy = rows.y[j + 1] - rows.y[j];
  const double t = (y - rows.y[j]) / dy;
  const double rise = rows.height[j + 1] - rows.height[j];
  double slope_0, slope_1;
  if (j > 0 && j + 1 < last) {
    // row_slope of both rows at once: they share the middle chord.
    const double before = rows.y[j] - rows.y[j - 1];
    const double after = rows.y[j + 2] - rows.y[j + 1];
    const double chord_before = (rows.height[j] - rows.height[j - 1]) / before;
    const double chord = rise / dy;
    const double chord_after = (rows.height[j + 2] - rows.height[j + 1]) / after;
    slope_0 = (chord_before * dy + chord * before) / (before + dy);
    slope_1 = (chord * after + chord_after * dy) / (dy + after);
  } else {
    slope_0 = row_slope(rows, j);
    slope_1 = row_slope(rows, j + 1);
  }
  const double m0 = slope_0 * dy;
  const double m1 = slope_1 * dy;
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

namespace {

struct Parabola {
  double lowest = 0.0, at = 0.0, curvature = 0.0;
};

/// Least-squares parabola through points [first, last]; abscissae are taken relative to their mean and scaled
/// by their span, which keeps the 3 x 3 normal equations well conditioned.
Parabola fit_parabola(const double* x, const double* h, std::int32_t first, std::int32_t last) {
  const double count = static_cast<double>(last - first + 1);
  double mean = 0.0;
  for (std::int32_t i = first; i <= last; ++i) mean += x[i] / count;
  const double scale = x[last] - x[first];
  double t1 = 0.0, t2 = 0.0, t3 = 0.0, t4 = 0.0, h0 = 0.0, h1 = 0.0, h2 = 0.0;
  for (std::int32_t i = first; i <= last; ++i) {
    const double t = (x[i] - mean) / scale;
    t1 += t;
    t2 += t * t;
    t3 += t * t * t;
    t4 += t * t * t * t;
    h0 += h[i];
    h1 += h[i] * t;
    h2 += h[i] * t * t;
  }
  // h = c0 + c1 t + c2 (t^2 - t2 / count): c2 from the 2 x 2 system left after eliminating c0; t1 is zero up
  // to rounding.
  const double s22 = t4 - t2 * t2 / count, s11 = t2 - t1 * t1 / count, s12 = t3 - t1 * t2 / count;
  const double r1 = h1 - t1 * h0 / count, r2 = h2 - t2 * h0 / count;
  const double determinant = s11 * s22 - s12 * s12;
  const double c1 = (r1 * s22 - r2 * s12) / determinant;
  const double c2 = (r2 * s11 - r1 * s12) / determinant;
  const double c0 = (h0 - c1 * t1 - c2 * t2) / count;
  if (!(c2 > 0.0)) return {};
  return {c0 - 0.25 * c1 * c1 / c2, mean - 0.5 * c1 / c2 * scale, 2.0 * c2 / (scale * scale)};
}

}  // namespace

Fault rows_from_grid(const GapGrid& grid, double depth, double* height, double* centre, double* curvature) {
  for (std::int32_t j = 0; j < grid.rows; ++j) {
    const double* h = grid.h + j * grid.row_stride;
    const auto lowest = static_cast<std::int32_t>(std::min_element(h, h + grid.columns) - h);
    std::int32_t first = std::clamp(lowest - 1, 0, grid.columns - 3);
    std::int32_t last = first + 2;
    while (first > 0 && h[first - 1] - h[lowest] < depth) --first;
    while (last < grid.columns - 1 && h[last + 1] - h[lowest] < depth) ++last;
    const Parabola fit = fit_parabola(grid.x, h, first, last);
    // Heights of an absurd size overflow in the fit.
    if (!(fit.curvature > 0.0) || !std::isfinite(fit.curvature) || !std::isfinite(fit.at) ||
        !std::isfinite(fit.lowest)) {
      return {
          .status = WRC_ERROR_GAP,
          .field = "gap.h row",
          .cause = "the row has no minimum along x: is the gap convex there, and x the rolling direction?",
          .index = j};
    }
    height[j] = fit.lowest;
    centre[j] = fit.at;
    curvature[j] = fit.curvature;
  }
  return {};
}

GapMinimum minimum(const GapRows& rows) { return minimum(rows, rows.y[0], rows.y[rows.count - 1]); }

GapMinimum minimum(const GapRows& rows, double low, double high) {
  // The interpolant is C1 and, around its lowest node, unimodal: bisect the slope over the two adjoining
  // pieces.
  std::int32_t lowest = -1;
  for (std::int32_t j = 0; j < rows.count; ++j) {
    if (rows.y[j] < low || rows.y[j] > high) continue;
    if (lowest < 0 || rows.height[j] < rows.height[lowest]) lowest = j;
  }
  if (lowest >= 0) {
    low = std::max(low, rows.y[std::max(lowest - 1, 0)]);
    high = std::min(high, rows.y[std::min(lowest + 1, rows.count - 1)]);
  }
  if (interpolate(rows, low).slope >= 0.0) return {low, interpolate(rows, low).height};
  if (interpolate(rows, high).slope <= 0.0) return {high, interpolate(rows, high).height};
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (interpolate(rows, middle).slope < 0.0 ? low : high) = middle;
  }
  const double y = 0.5 * (low + high);
  return {y, interpolate(rows, y).height};
}

}  // namespace wrc
