/// A square grid of a few cells over a patch, and the slip that tractions on it cause in two elastic
/// half-spaces.
///
/// Tractions are constant over each cell. With u(x, y) the displacement difference of the bodies
/// (exact/cell_influence.hpp), particles travelling towards -x, the slip of a cell is the rigid slip plus
/// (u(x_i) - u(x_i + dx)) / dx, whose coefficients depend on the distance of the two cells only.
#pragma once

#include <cstdlib>

#include "tangential/exact/cell_influence.hpp"

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
          if (qx == 0.0 && qy == 0.0) continue;  // as all outside of the contact
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

/// Fills the grid's coefficients of slip.
template <int n>
void fill_coefficients(const Material& material, CoarseGrid<n>& grid) {
  CellInfluence at[n][n + 1];  // xx and yy are even in both directions, xy is odd
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i <= n; ++i)
      at[j][i] = cell_influence(material, i * grid.dx, j * grid.dy, grid.dx, grid.dy);
  }
  for (int my = 1 - n; my < n; ++my) {
    for (int mx = 1 - n; mx < n; ++mx) {
      const CellInfluence &here = at[std::abs(my)][std::abs(mx)], &ahead = at[std::abs(my)][std::abs(mx + 1)];
      const int j = my + n - 1, i = mx + n - 1;
      grid.xx[j][i] = (here.xx - ahead.xx) / grid.dx;
      grid.yy[j][i] = (here.yy - ahead.yy) / grid.dx;
      grid.xy[j][i] =
          (((mx < 0) == (my < 0) ? here.xy : -here.xy) - ((mx + 1 < 0) == (my < 0) ? ahead.xy : -ahead.xy)) /
          grid.dx;
    }
  }
}

}  // namespace wrc
