/// A square grid of a few cells over a patch, and the slip that tractions on it cause in two elastic
/// half-spaces.
///
/// Tractions are constant over each cell. With u(x, y) the displacement difference of the bodies, particles
/// travelling towards -x, the slip of a cell is the rigid slip plus (u(x_i) - u(x_i + dx)) / dx, whose
/// coefficients depend on the distance of the two cells only.
#pragma once

#include <cmath>

#include "base/elementary.hpp"
#include "patch/material.hpp"

namespace wrc {

template <int n>
struct CoarseGrid {
  static constexpr int cells = n * n;
  static constexpr int reach = 2 * n - 1;  ///< distances between two cells of a row or column

  double dx = 0.0, dy = 0.0;            ///< [m]
  double first_x = 0.0, first_y = 0.0;  ///< middle of the first cell [m]
  /// Slip in x from p_x, in y from p_y, in x from p_y (and in y from p_x) of a cell that lies mx cells behind
  /// and my cells to the side: element [my + n - 1][mx + n - 1] [1/Pa].
  double xx[reach][reach], yy[reach][reach], xy[reach][reach];

  double x(int i) const { return first_x + i * dx; }
  double y(int j) const { return first_y + j * dy; }

  /// slip = coefficients * traction, all n x n by rows along x. Fixed order of summation.
  void slip(const double* px, const double* py, double* sx, double* sy) const {
    for (int j = 0; j < n; ++j) {
      double ux[n] = {}, uy[n] = {};
      for (int from = 0; from < n; ++from) {
        const double* const row_xx = xx[j - from + n - 1] + n - 1;
        const double* const row_yy = yy[j - from + n - 1] + n - 1;
        const double* const row_xy = xy[j - from + n - 1] + n - 1;
        for (int k = 0; k < n; ++k) {
          const double qx = px[from * n + k], qy = py[from * n + k];
          for (int i = 0; i < n; ++i) {
            ux[i] += row_xx[i - k] * qx + row_xy[i - k] * qy;
            uy[i] += row_xy[i - k] * qx + row_yy[i - k] * qy;
          }
        }
      }
      for (int i = 0; i < n; ++i) {
        sx[j * n + i] = ux[i];
        sy[j * n + i] = uy[i];
      }
    }
  }
};

/// x asinh(y / x) for y >= 0 and x > 0: the corner function of IInt y^2/r^3 over a rectangle.
inline double rectangle_corner(double x, double y, double r) { return x * natural_log((y + r) / x); }

/// Fills the grid's coefficients of slip: the difference, from one cell to the next, of Cerruti's
/// displacement of a uniformly loaded rectangle,
///     u_x = 1/(pi G) IInt [ ((1-nu)/r + nu x^2/r^3) p_x + nu x y/r^3 p_y ]      (Johnson, 3.2 and 3.6)
/// with IInt y^2/r^3 = [[X asinh(Y/X)]], IInt x^2/r^3 = [[Y asinh(X/Y)]], IInt x y/r^3 = [[-r]], double
/// differences over the corners. Corners lie at half-integer multiples of the cell's size, so that X and Y
/// never vanish; all three functions are even or odd in both.
template <int n>
void fill_coefficients(double shear_modulus, double poisson, CoarseGrid<n>& grid) {
  double along[n + 1][n + 1], across[n + 1][n + 1], radius[n + 1][n + 1];
  for (int j = 0; j <= n; ++j) {
    const double y = (j + 0.5) * grid.dy;
    for (int i = 0; i <= n; ++i) {
      const double x = (i + 0.5) * grid.dx, r = std::sqrt(x * x + y * y);
      along[j][i] = rectangle_corner(y, x, r);   // of IInt x^2/r^3, odd in y and x
      across[j][i] = rectangle_corner(x, y, r);  // of IInt y^2/r^3, odd in y and x
      radius[j][i] = r;                          // even in both
    }
  }
  // Corner m lies at (m - 1/2) cells: value at its mirror image among the positive ones, and sign.
  const auto place = [](int m) { return m > 0 ? m - 1 : -m; };
  const auto sign = [](int m) { return m > 0 ? 1.0 : -1.0; };
  const double scale = 1.0 / (pi * shear_modulus);
  struct Displacement {
    double xx, yy, xy;
  };
  const auto displacement = [&](int mx, int my) {
    double xx_over_r3 = 0.0, yy_over_r3 = 0.0, xy_over_r3 = 0.0;
    for (int cy = 0; cy < 2; ++cy) {
      for (int cx = 0; cx < 2; ++cx) {
        const double difference = cx == cy ? 1.0 : -1.0;
        const double odd = difference * sign(mx + cx) * sign(my + cy);
        const int i = place(mx + cx), j = place(my + cy);
        xx_over_r3 += odd * along[j][i];
        yy_over_r3 += odd * across[j][i];
        xy_over_r3 -= difference * radius[j][i];
      }
    }
    return Displacement{scale * (xx_over_r3 + (1.0 - poisson) * yy_over_r3),
                        scale * ((1.0 - poisson) * xx_over_r3 + yy_over_r3), scale * poisson * xy_over_r3};
  };
  for (int my = 1 - n; my < n; ++my) {
    Displacement here = displacement(1 - n, my);
    for (int mx = 1 - n; mx < n; ++mx) {
      const Displacement ahead = displacement(mx + 1, my);
      grid.xx[my + n - 1][mx + n - 1] = (here.xx - ahead.xx) / grid.dx;
      grid.yy[my + n - 1][mx + n - 1] = (here.yy - ahead.yy) / grid.dx;
      grid.xy[my + n - 1][mx + n - 1] = (here.xy - ahead.xy) / grid.dx;
      here = ahead;
    }
  }
}

}  // namespace wrc
