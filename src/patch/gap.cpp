#include "patch/gap.hpp"

#include <algorithm>
#include <cmath>

namespace wrc::patch {
namespace {

/// Slope of the height at row j from the parabola through the row and its neighbours (one-sided at the ends).
double row_slope(const GapRows& rows, std::int32_t j) {
  const std::int32_t middle = std::clamp(j, 1, rows.count - 2);
  // Slope and second derivative of the parabola through three rows at unequal distances.
  const double left = rows.y[middle] - rows.y[middle - 1];
  const double right = rows.y[middle + 1] - rows.y[middle];
  const double drop = rows.height[middle] - rows.height[middle - 1];
  const double rise = rows.height[middle + 1] - rows.height[middle];
  const double inverse = 1.0 / (left * right * (left + right));
  const double slope = (drop * right * right + rise * left * left) * inverse;
  if (j == middle) return slope;
  const double second = 2.0 * (rise * left - drop * right) * inverse;
  return slope + second * (rows.y[j] - rows.y[middle]);
}

}  // namespace

double GapReader::move(double y) noexcept {
  const std::int32_t last = rows_.count - 1;
  y = std::clamp(y, rows_.y[0], rows_.y[last]);
  std::int32_t j = interval_;
  if (j < 0) {
    // Rows are spread nearly evenly: the proportional guess is right or next to it.
    j = static_cast<std::int32_t>((y - rows_.y[0]) / (rows_.y[last] - rows_.y[0]) * last);
    j = std::clamp(j, 0, last - 1);
  }
  while (j > 0 && y < rows_.y[j]) --j;
  while (j < last - 1 && y >= rows_.y[j + 1]) ++j;
  if (j == interval_) return y - from_;  // outside the rows, or the last row itself
  // The cubic of the new interval; its first slope is known if it follows the last one read.
  const bool next = interval_ >= 0 && j == interval_ + 1;
  interval_ = j;
  from_ = rows_.y[j];
  to_ = rows_.y[j + 1];
  const double inverse = 1.0 / (to_ - from_);
  const double chord = (rows_.height[j + 1] - rows_.height[j]) * inverse;
  c0_ = rows_.height[j];
  c1_ = next ? slope_to_ : row_slope(rows_, j);
  slope_to_ = row_slope(rows_, j + 1);
  c2_ = (3.0 * chord - 2.0 * c1_ - slope_to_) * inverse;
  c3_ = (c1_ + slope_to_ - 2.0 * chord) * (inverse * inverse);
  centre_ = rows_.centre[j];
  centre_slope_ = (rows_.centre[j + 1] - centre_) * inverse;
  curvature_ = rows_.curvature[j];
  curvature_slope_ = (rows_.curvature[j + 1] - curvature_) * inverse;
  return y - from_;
}

double GapReader::lowest_between(double low, double high) noexcept {
  enter(0.5 * (low + high));
  // slope = c1 + 2 c2 d + 3 c3 d^2: its root with rising slope, in the form that does not cancel.
  const double root = std::sqrt(std::max(0.0, c2_ * c2_ - 3.0 * c3_ * c1_));
  const double above = c2_ >= 0.0 ? -c1_ : root - c2_;
  const double below = c2_ >= 0.0 ? c2_ + root : 3.0 * c3_;
  return below > 0.0 ? std::clamp(from_ + above / below, low, high) : high;
}

GapRow interpolate(const GapRows& rows, double y) { return GapReader(rows).at(y); }

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
  // t = (x - mean) / span; sums of t^k and h t^k over the points.
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
    // The run of points around the lowest that lie less than `depth` above it, three at least.
    const auto lowest = static_cast<std::int32_t>(std::min_element(h, h + grid.columns) - h);
    std::int32_t first = std::clamp(lowest - 1, 0, grid.columns - 3);
    std::int32_t last = first + 2;
    while (first > 0 && h[first - 1] - h[lowest] < depth) --first;
    while (last < grid.columns - 1 && h[last + 1] - h[lowest] < depth) ++last;
    const Parabola fit = fit_parabola(grid.x, h, first, last);
    // Heights of an absurd size overflow in the fit.
    if (!(fit.curvature > 0.0) || !std::isfinite(fit.curvature) || !std::isfinite(fit.at) ||
        !std::isfinite(fit.lowest)) {
      return Fault::gap(
          {"gap.h row", j},
          "the row has no minimum along x: is the gap convex there, and x the rolling direction?");
    }
    height[j] = fit.lowest;
    centre[j] = fit.at;
    curvature[j] = fit.curvature;
  }
  return {};
}

GapMinimum minimum(const GapRows& rows) { return minimum(rows, rows.y[0], rows.y[rows.count - 1]); }

GapMinimum minimum(const GapRows& rows, double low, double high) {
  // The interpolant is C1: the root of the slope in one of the two pieces that adjoin its lowest node. An end
  // of these is the minimum only if it is no higher: in rows that go up and down, a ridge has slope zero too.
  const double* const y_end = rows.y + rows.count;
  const auto first = static_cast<std::int32_t>(std::lower_bound(rows.y, y_end, low) - rows.y);
  const auto end = static_cast<std::int32_t>(std::upper_bound(rows.y, y_end, high) - rows.y);
  // The lowest row within the limits; without one the limits lie in one interval.
  std::int32_t lowest = -1;
  if (first < end)
    lowest =
        static_cast<std::int32_t>(std::min_element(rows.height + first, rows.height + end) - rows.height);
  GapReader gap(rows);
  if (lowest >= 0) {
    low = std::max(low, rows.y[std::max(lowest - 1, 0)]);
    high = std::min(high, rows.y[std::min(lowest + 1, rows.count - 1)]);
  }
  // The minimum at a limit, else at the root of the slope on the side of the lowest row that falls.
  const auto may_be_lowest = [&](const GapRow& row) {
    return lowest < 0 || row.height <= rows.height[lowest];
  };
  if (const GapRow row = gap.at(low); row.slope >= 0.0 && may_be_lowest(row)) return {low, row.height};
  if (const GapRow row = gap.at(high); row.slope <= 0.0 && may_be_lowest(row)) return {high, row.height};
  if (lowest >= 0) (gap.at(rows.y[lowest]).slope < 0.0 ? low : high) = rows.y[lowest];
  const double y = gap.lowest_between(low, high);
  return {y, gap.height(y)};
}

}  // namespace wrc::patch
