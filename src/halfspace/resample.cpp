#include "halfspace/resample.hpp"

#include <algorithm>
#include <cmath>

namespace wrc::halfspace {
namespace {

// Fraction of fine cell i that lies in coarse cell k; both number the same length from 0, n and m cells.
double overlap(int i, int n, int k, int m) {
  const double ratio = static_cast<double>(n) / m;  // fine cells per coarse cell
  const double low = std::max<double>(i, k * ratio), high = std::min<double>(i + 1, (k + 1) * ratio);
  return std::max(0.0, high - low);
}

int first_overlapping(int k, int n, int m) { return static_cast<int>(static_cast<long long>(k) * n / m); }

}  // namespace

Grid coarsened(const Grid& fine) {
  const double x = fine.x0 - 0.5 * fine.dx, y = fine.y0 - 0.5 * fine.dy;
  return grid_over_box(x, x + fine.nx * fine.dx, y, y + fine.ny * fine.dy, (fine.nx + 1) / 2,
                       (fine.ny + 1) / 2);
}

Field average(const Grid& fine, const Field& field, const Grid& coarse) {
  Field out(coarse.cells(), 0.0);
  const double per_cell = fine.cell_area() / coarse.cell_area();
  for (int k = 0; k < coarse.ny; ++k) {
    for (int j = first_overlapping(k, fine.ny, coarse.ny); j < fine.ny; ++j) {
      // conserves the integral: each fine cell counts by the parts of its area
      const double share_y = overlap(j, fine.ny, k, coarse.ny);
      if (share_y <= 0.0) break;
      for (int l = 0; l < coarse.nx; ++l) {
        for (int i = first_overlapping(l, fine.nx, coarse.nx); i < fine.nx; ++i) {
          const double share_x = overlap(i, fine.nx, l, coarse.nx);
          if (share_x <= 0.0) break;
          out[coarse.index(l, k)] += per_cell * share_x * share_y * field[fine.index(i, j)];
        }
      }
    }
  }
  return out;
}

Field row_values(const Grid& fine, const Field& rows, const Grid& coarse) {
  if (rows.empty()) return {};
  Field out(static_cast<std::size_t>(coarse.ny));
  for (int k = 0; k < coarse.ny; ++k) {
    // row position between fine rows j and j + 1
    const double v = std::clamp((coarse.y(k) - fine.y0) / fine.dy, 0.0, fine.ny - 1.0);
    const int j = std::min(static_cast<int>(v), fine.ny - 2);
    out[k] = fine.ny == 1 ? rows[0] : rows[j] + (v - j) * (rows[j + 1] - rows[j]);
  }
  return out;
}

Field interpolate(const Grid& coarse, const Field& field, const Field& weight, const Grid& fine) {
  Field out(fine.cells(), 0.0);
  for (int j = 0; j < fine.ny; ++j) {
    // place among the coarse cells' centres, in cells; k0 and l0 may lie beyond the border
    const double v = (fine.y(j) - coarse.y0) / coarse.dy;
    const int k0 = static_cast<int>(std::floor(v));
    for (int i = 0; i < fine.nx; ++i) {
      const double u = (fine.x(i) - coarse.x0) / coarse.dx;
      const int l0 = static_cast<int>(std::floor(u));
      // bilinear weights of the four neighbours that count; they are made to add up to 1
      double sum = 0.0, total = 0.0;
      for (int k = std::max(k0, 0); k <= std::min(k0 + 1, coarse.ny - 1); ++k) {
        for (int l = std::max(l0, 0); l <= std::min(l0 + 1, coarse.nx - 1); ++l) {
          const std::size_t at = coarse.index(l, k);
          if (weight[at] <= 0.0) continue;
          const double w = (1.0 - std::abs(u - l)) * (1.0 - std::abs(v - k));
          sum += w * field[at];
          total += w;
        }
      }
      if (total > 0.0) out[fine.index(i, j)] = sum / total;
    }
  }
  return out;
}

}  // namespace wrc::halfspace
