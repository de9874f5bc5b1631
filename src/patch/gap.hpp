/// The undeformed gap between the bodies around the initial contact point, as rows along the rolling
/// direction.
///
///     h(x, y_j) = height[j] + 1/2 curvature[j] (x - centre[j])^2      [m]
///
/// measured along the contact normal, in the contact frame (x rolling, y lateral, origin at the initial
/// contact point). A wheel's section at fixed y is this parabola to 1e-4 relative over any contact patch (|x|
/// << radius); yaw enters as centre[j] != 0: the lowest points of the rows move along the contact locus.
#pragma once

#include <cstdint>

#include "base/fault.hpp"

namespace wrc::patch {

/// Rows, and the elements of a row, lie at least this far apart [m]. Slopes are read off neighbouring rows:
/// an error of 1 nm in a height is a slope of 1e-3 over a micrometre, which moves results by less than 1e-3
/// (of ANALYN by 9 %), and of 0.1 over 10 nm, which triples the peak pressure; at 1e-15 m rounding alone
/// lifts the surface by metres between two rows.
inline constexpr double row_spacing_least = 1e-6;

/// Rows ordered by strictly increasing y, at least four of them; memory is the owner's.
struct GapRows {
  std::int32_t count = 0;
  const double* y = nullptr;          ///< [m]
  const double* height = nullptr;     ///< smallest gap of the row [m]; may be negative
  const double* centre = nullptr;     ///< x of that smallest gap [m]
  const double* curvature = nullptr;  ///< d2h/dx2 > 0 [1/m]
};

/// The gap of the row at one y, between the given rows.
struct GapRow {
  double height = 0.0;     ///< [m]
  double slope = 0.0;      ///< d height / dy [-]
  double centre = 0.0;     ///< x of the least gap [m]
  double curvature = 0.0;  ///< d2h/dx2 [1/m]
};

/// Interpolates the rows at y: cubic Hermite with three-point slopes in height (C1, so that patch borders
/// move smoothly), linear in centre and curvature. y outside the rows is clamped to the first or last row.
GapRow interpolate(const GapRows& rows, double y);

/// The same at many places: keeps the cubic of the interval it read last, so that places close together, or
/// one row after the other, cost neither a search nor divisions over again. Same bits as interpolate().
class GapReader {
 public:
  explicit GapReader(const GapRows& rows) noexcept : rows_(rows) {}

  GapRow at(double y) noexcept {
    const double d = enter(y);
    return {.height = c0_ + d * (c1_ + d * (c2_ + d * c3_)),
            .slope = c1_ + d * (2.0 * c2_ + 3.0 * d * c3_),
            .centre = centre_ + d * centre_slope_,
            .curvature = curvature_ + d * curvature_slope_};
  }
  /// at(y).height [m]
  double height(double y) noexcept {
    const double d = enter(y);
    return c0_ + d * (c1_ + d * (c2_ + d * c3_));
  }

  /// y of the least height between low and high, which lie in one interval: the slope is negative at
  /// `low` and not at `high` [m].
  double lowest_between(double low, double high) noexcept;

 private:
  /// Goes to the interval that holds y; returns the distance d of y from its beginning.
  double enter(double y) noexcept { return y >= from_ && y < to_ ? y - from_ : move(y); }
  double move(double y) noexcept;

  GapRows rows_;
  std::int32_t interval_ = -1;
  double from_ = 0.0, to_ = 0.0;                      ///< ends of the interval [m]
  double slope_to_ = 0.0;                             ///< d height / dy at its end
  double c0_ = 0.0, c1_ = 0.0, c2_ = 0.0, c3_ = 0.0;  ///< height = c0 + d (c1 + d (c2 + d c3))
  double centre_ = 0.0, centre_slope_ = 0.0;
  double curvature_ = 0.0, curvature_slope_ = 0.0;
};

/// Index of the row with the smallest height.
std::int32_t lowest_row(const GapRows& rows);

/// An element-wise gap h[j * row_stride + i] at (x[i], y[j]), as a host measures or computes it.
struct GapGrid {
  std::int32_t rows = 0, columns = 0;
  const double* x = nullptr;  ///< [m], increasing
  const double* y = nullptr;  ///< [m], increasing
  const double* h = nullptr;  ///< [m]
  std::int64_t row_stride = 0;
};

/// Represents each row of the grid by the parabola fitted (least squares) to its lowest part: the run of
/// points around the row's minimum that lie less than `depth` [m] above it, at least three. Writes grid.rows
/// values each. WRC_ERROR_GAP names the first row that is not convex there.
Fault rows_from_grid(const GapGrid& grid, double depth, double* height, double* centre, double* curvature);

/// First touch of two bodies: minimum of the interpolated height around the lowest row.
struct GapMinimum {
  double y = 0.0;       ///< [m]
  double height = 0.0;  ///< [m]
};
GapMinimum minimum(const GapRows& rows);

/// The same within low <= y <= high: the contact point of one of several patches.
GapMinimum minimum(const GapRows& rows, double low, double high);

}  // namespace wrc::patch
