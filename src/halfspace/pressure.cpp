#include "halfspace/pressure.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"

namespace wrc::halfspace {
namespace {

// Integral of sqrt(1 - t^2) from -1 to t.
double semicircle_integral(double t) {
  const double c = std::clamp(t, -1.0, 1.0);
  return 0.5 * (c * std::sqrt((1.0 - c) * (1.0 + c)) + arcsine(c) + 0.5 * pi);
}

}  // namespace

void add_semi_ellipse(const Grid& grid, int j, double peak, double centre, double l, double weight,
                      Field& field) {
  if (l <= 0.0) return;
  // mean over each cell of peak * root(1 - ((x - c) / l)^2): differences of the integral at its borders
  double below = semicircle_integral((grid.x(0) - 0.5 * grid.dx - centre) / l);
  for (int i = 0; i < grid.nx; ++i) {
    const double above = semicircle_integral((grid.x(i) + 0.5 * grid.dx - centre) / l);
    field[grid.index(i, j)] += weight * peak * l * (above - below) / grid.dx;
    below = above;
  }
}

Field strip_pressure(const patch::Strips& strips, const Grid& grid) {
  Field field(grid.cells(), 0.0);
  for (int j = 0; j < grid.ny; ++j) {
    // strips count in a row by their common width
    const double low = grid.y(j) - 0.5 * grid.dy, high = grid.y(j) + 0.5 * grid.dy;
    for (std::int32_t k = 0; k < strips.count; ++k) {
      const double from = std::max(low, strips.y[k] - 0.5 * strips.width[k]);
      const double to = std::min(high, strips.y[k] + 0.5 * strips.width[k]);
      if (to <= from) continue;
      add_semi_ellipse(grid, j, strips.peak[k], strips.centre[k], strips.half_length[k],
                       (to - from) / grid.dy, field);
    }
  }
  return field;
}

Grid grid_over(const patch::Strips& strips, int nx, int ny) {
  // from the trailing end of any strip to the leading end of any
  double trail = 0.0, lead = 0.0;
  for (std::int32_t k = 0; k < strips.count; ++k) {
    const double from = strips.centre[k] - strips.half_length[k],
                 to = strips.centre[k] + strips.half_length[k];
    trail = k == 0 ? from : std::min(trail, from);
    lead = k == 0 ? to : std::max(lead, to);
  }
  const patch::StripTotals sum = patch::totals(strips);
  return grid_over_box(trail, lead, sum.y_min, sum.y_max, nx, ny);
}

}  // namespace wrc::halfspace
