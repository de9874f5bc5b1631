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

#include "fault.hpp"

namespace wrc {

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
  double height = 0.0;
  double slope = 0.0;  ///< d height / dy [-]
  double centre = 0.0;
  double curvature = 0.0;
};

/// Interpolates the rows at y: cubic Hermite with three-point slopes in height (C1, so that patch borders
/// move smoothly), linear in centre and curvature. y outside the rows is clamped to the first or last row.
GapRow interpolate(const GapRows& rows, double y);

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

/// Where two bodies first touch: minimum of the interpolated height around the lowest row.
struct GapMinimum {
  double y = 0.0;
  double height = 0.0;
};
GapMinimum minimum(const GapRows& rows);

/// The same within low <= y <= high: the contact point of one of several patches.
GapMinimum minimum(const GapRows& rows, double low, double high);

}  // namespace wrc
