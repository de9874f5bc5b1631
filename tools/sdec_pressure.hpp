/// Prescribed normal pressure on a grid, that of SDEC patches, so that tangential methods can be judged
/// alone.
#pragma once

#include <cmath>

#include "halfspace/pressure.hpp"

namespace wrc::halfspace {

/// Simple double-elliptical contact: two half ellipses with the same semi-axis a along x, joined on the x
/// axis, b (1 + psi) towards +y and b (1 - psi) towards -y. Origin at the joint, the initial contact point.
struct SdecPatch {
  double a = 0.0;    ///< semi-axis along rolling [m]
  double b = 0.0;    ///< half of the total width [m]
  double psi = 0.0;  ///< shape number y0 / b, |psi| < 1

  /// x_l(y), half length of the patch at y; zero outside.
  double half_length(double y) const {
    const double t = y / (y > 0.0 ? b * (1.0 + psi) : b * (1.0 - psi));
    return std::abs(t) < 1.0 ? a * std::sqrt((1.0 - t) * (1.0 + t)) : 0.0;
  }
};

/// What a cell's pressure is.
enum class CellPressure {
  mean,  ///< mean over the cell: cells on the border carry their share, the load is exact, and the traction
         ///< bound goes smoothly to zero as the grid is refined or shifted. The default for accurate answers.
  centre  ///< value at the centre, as the reference program does: the border is a staircase
};

/// nx x ny cells over the patch's bounding box.
inline Grid grid_over(const SdecPatch& patch, int nx, int ny) {
  return grid_over_box(-patch.a, patch.a, -patch.b * (1.0 - patch.psi), patch.b * (1.0 + patch.psi), nx, ny);
}

/// p = peak sqrt(x_l(y)^2 - x^2) / a on the cells of the grid [Pa].
inline Field sdec_pressure(const SdecPatch& patch, double peak, const Grid& grid, CellPressure rule) {
  Field field(grid.cells(), 0.0);
  constexpr int lines =
      16;  // midpoint rule across a cell; the integrand is smooth but at the joint and the tips
  for (int j = 0; j < grid.ny; ++j) {
    if (rule == CellPressure::mean) {
      for (int k = 0; k < lines; ++k) {
        const double l = patch.half_length(grid.y(j) + grid.dy * ((k + 0.5) / lines - 0.5));
        add_semi_ellipse(grid, j, peak * l / patch.a, 0.0, l, 1.0 / lines, field);
      }
      continue;
    }
    const double l = patch.half_length(grid.y(j));
    for (int i = 0; i < grid.nx; ++i) {
      const double x = grid.x(i);
      if (std::abs(x) < l) field[grid.index(i, j)] = peak * std::sqrt((l - x) * (l + x)) / patch.a;
    }
  }
  return field;
}

}  // namespace wrc::halfspace
