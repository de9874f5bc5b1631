/// Kalker's exact theory of steady rolling on a grid of n x n cells, in fixed memory and capped work.
///
/// The equations and the iteration are those of the exact solver (rolling_newton.hpp): Newton's method with a
/// moving adhesion area, its linear systems by GMRES with the rows along x inverted as preconditioner. The
/// slip is taken a quarter of a cell ahead of a cell's middle, its traction a quarter behind.
///
/// Real-time: no memory but the object itself (about 300 KB for n = 16), work bounded by max_iterations and
/// max_products.
#pragma once

#include <algorithm>
#include <cmath>

#include "tangential/coarse_halfspace/coarse_grid.hpp"
#include "tangential/coarse_halfspace/rolling_newton.hpp"
#include "tangential/problem.hpp"

namespace wrc {

template <int n>
class CoarseRolling {
 public:
  static constexpr int cells = n * n;
  static constexpr int unknowns = 2 * cells;

  CoarseGrid<n> grid;
  double bound[cells];              ///< mu p_n, mean over the cell; cells with 0 are not in contact [Pa]
  double border_compliance[cells];  ///< added to a cell's own coefficient [1/Pa]
  double px[cells], py[cells];      ///< tractions on the wheel; start and result [Pa]
  double sx[cells], sy[cells];      ///< slip [-]
  bool slides[cells];
  int iterations = 0;
  double residual = 0.0;  ///< |p - P(p - rho s)| / |min(g, max(|p|, rho |w|))|, 2-norms

  /// Iterates from the tractions present; false when max_iterations did not reach the tolerance: the
  /// tractions are usable, on the bound or below it, but not in equilibrium.
  bool solve(const Creepage& creepage, double tolerance, int max_iterations);

  /// Forces about the origin of the creepages; power by the balance of energy.
  TangentialForces forces(const Creepage& creepage) const;

 private:
  static constexpr int max_products = 30;

  struct Row {
    int first_cell = 0, cells = 0, first = 0, size = 0;
    double inverse[4 * n * n];  ///< LU factors by rows
    int pivot[2 * n];
  };

  void find_cells(const Creepage& creepage);
  void update_slip();
  void linearise(double rho);
  void newton_step(double share);
  void factor(Row& row) const;
  void precondition(const double* in, double* out) const;
  void spread(const double* in);
  void gather(double* out) const;
  void gmres(double accuracy);

  NewtonCell cell_[cells];
  int cell_count_ = 0, size_ = 0, row_count_ = 0;
  Row row_[n];
  double rhs_[unknowns], change_[unknowns];
  double field_x_[cells], field_y_[cells], slip_x_[cells], slip_y_[cells];
  double basis_[max_products + 1][unknowns];
  double hessenberg_[max_products][max_products + 1];
};

template <int n>
void CoarseRolling<n>::find_cells(const Creepage& creepage) {
  cell_count_ = row_count_ = 0;
  for (int j = 0; j < n; ++j) {
    const int before = cell_count_;
    for (int i = 0; i < n; ++i) {
      const int at = j * n + i;
      sx[at] = sy[at] = 0.0;
      slides[at] = false;
      if (bound[at] <= 0.0) {
        px[at] = py[at] = 0.0;
        continue;
      }
      NewtonCell& cell = cell_[cell_count_++];
      cell.at = at;
      cell.i = i;
      cell.wx = creepage.longitudinal - creepage.spin * grid.y(j);
      cell.wy = creepage.lateral + creepage.spin * (grid.x(i) + 0.25 * grid.dx);
    }
    if (cell_count_ == before) continue;
    row_[row_count_].first_cell = before;
    row_[row_count_++].cells = cell_count_ - before;
  }
}

template <int n>
void CoarseRolling<n>::update_slip() {
  grid.slip(px, py, field_x_, field_y_);
  for (int k = 0; k < cell_count_; ++k) {
    const NewtonCell& cell = cell_[k];
    sx[cell.at] = cell.wx + field_x_[cell.at] + border_compliance[cell.at] * px[cell.at];
    sy[cell.at] = cell.wy + field_y_[cell.at] + border_compliance[cell.at] * py[cell.at];
  }
}

/// Sets up the Newton system at the present tractions and slips.
template <int n>
void CoarseRolling<n>::linearise(double rho) {
  NewtonResidual sums;
  size_ = 0;
  for (int k = 0; k < cell_count_; ++k) {
    NewtonCell& cell = cell_[k];
    const int at = cell.at;
    double rhs[2];
    slides[at] = wrc::linearise(bound[at], rho, px[at], py[at], sx[at], sy[at], size_, cell, rhs, sums);
    sums.norm_squared += asked_squared(bound[at], rho, px[at], py[at], cell);
    std::copy_n(rhs, cell.count, rhs_ + size_);
    size_ += cell.count;
  }
  residual = sums.value();
}

/// Unknowns to tractions on the grid.
template <int n>
void CoarseRolling<n>::spread(const double* in) {
  std::fill_n(field_x_, cells, 0.0);
  std::fill_n(field_y_, cells, 0.0);
  for (int k = 0; k < cell_count_; ++k) {
    const int at = cell_[k].at;
    traction_of(cell_[k], in, field_x_[at], field_y_[at]);
  }
}

/// Slip on the grid to the equations' left-hand sides.
template <int n>
void CoarseRolling<n>::gather(double* out) const {
  for (int k = 0; k < cell_count_; ++k) {
    const NewtonCell& cell = cell_[k];
    equations_of(cell, slip_x_[cell.at] + border_compliance[cell.at] * field_x_[cell.at],
                 slip_y_[cell.at] + border_compliance[cell.at] * field_y_[cell.at], out);
  }
}

/// LU factors, with row exchanges, of the equations of one row of cells on its own.
template <int n>
void CoarseRolling<n>::factor(Row& row) const {
  constexpr int stride = 2 * n;
  const NewtonCell* const first = cell_ + row.first_cell;
  row.first = first->first;
  row.size = first[row.cells - 1].first + first[row.cells - 1].count - row.first;
  double* const m = row.inverse;
  for (int a = 0; a < row.cells; ++a) {
    for (int b = 0; b < row.cells; ++b) {
      const NewtonCell &to = first[a], &from = first[b];
      const double own = a == b ? border_compliance[to.at] : 0.0;
      const double x = grid.xx[n - 1][to.i - from.i + n - 1] + own,
                   y = grid.yy[n - 1][to.i - from.i + n - 1] + own;
      double* const block = m + (to.first - row.first) * stride + from.first - row.first;
      couple(to, from, x, y, [&](int r, int c, double value) { block[r * stride + c] = value; });
      if (a == b && to.count == 1) block[0] += to.stiffening;
    }
  }
  for (int k = 0; k < row.size; ++k) {
    int best = k;
    for (int r = k + 1; r < row.size; ++r) {
      if (std::abs(m[r * stride + k]) > std::abs(m[best * stride + k])) best = r;
    }
    row.pivot[k] = best;
    if (best != k) std::swap_ranges(m + k * stride, m + k * stride + row.size, m + best * stride);
    const double pivot = m[k * stride + k];
    const double inverse = pivot != 0.0 ? 1.0 / pivot : 0.0;
    for (int r = k + 1; r < row.size; ++r) {
      const double f = m[r * stride + k] * inverse;
      if (f == 0.0) continue;  // p_x and p_y of sticking cells do not meet
      m[r * stride + k] = f;
      for (int c = k + 1; c < row.size; ++c) m[r * stride + c] -= f * m[k * stride + c];
    }
    m[k * stride + k] = inverse;
  }
}

template <int n>
void CoarseRolling<n>::precondition(const double* in, double* out) const {
  constexpr int stride = 2 * n;
  for (int k = 0; k < row_count_; ++k) {
    const Row& row = row_[k];
    const double* const m = row.inverse;
    double* const v = out + row.first;
    std::copy_n(in + row.first, row.size, v);
    for (int r = 0; r < row.size; ++r) std::swap(v[r], v[row.pivot[r]]);
    for (int c = 0; c < row.size; ++c) {
      for (int r = c + 1; r < row.size; ++r) v[r] -= m[r * stride + c] * v[c];
    }
    for (int r = row.size - 1; r >= 0; --r) {
      double sum = v[r];
      for (int c = r + 1; c < row.size; ++c) sum -= m[r * stride + c] * v[c];
      v[r] = sum * m[r * stride + r];
    }
  }
}

/// Solves the Newton system for change_, to `accuracy` of the right-hand side or max_products.
template <int n>
void CoarseRolling<n>::gmres(double accuracy) {
  std::fill_n(change_, size_, 0.0);
  double norm2 = 0.0;
  for (int k = 0; k < size_; ++k) norm2 += rhs_[k] * rhs_[k];
  if (!(norm2 > 0.0)) return;
  const double norm = std::sqrt(norm2);
  double cosine[max_products], minus_sine[max_products], projected[max_products + 1];
  for (int k = 0; k < size_; ++k) basis_[0][k] = rhs_[k] / norm;
  projected[0] = norm;
  int used = 0;
  for (; used < max_products && std::abs(projected[used]) > accuracy * norm; ++used) {
    const int m = used;
    precondition(basis_[m], change_);
    spread(change_);
    grid.slip(field_x_, field_y_, slip_x_, slip_y_);
    double* const next = basis_[m + 1];
    gather(next);
    for (int k = 0; k < cell_count_; ++k) {
      if (cell_[k].count == 1) next[cell_[k].first] += cell_[k].stiffening * change_[cell_[k].first];
    }
    double* const column = hessenberg_[m];
    for (int i = 0; i <= m; ++i) {
      double product = 0.0;
      for (int k = 0; k < size_; ++k) product += basis_[i][k] * next[k];
      column[i] = product;
      for (int k = 0; k < size_; ++k) next[k] -= product * basis_[i][k];
    }
    double length2 = 0.0;
    for (int k = 0; k < size_; ++k) length2 += next[k] * next[k];
    const double length = std::sqrt(length2);
    for (int i = 0; i < m; ++i) {
      // Two sums, not a sum and a difference: gcc 12 would make fused operations of such a pair for
      // processors that have them, whatever -ffp-contract says.
      const double upper = cosine[i] * column[i] + (-minus_sine[i]) * column[i + 1];
      column[i + 1] = cosine[i] * column[i + 1] + minus_sine[i] * column[i];
      column[i] = upper;
    }
    const double radius = std::sqrt(column[m] * column[m] + length2);
    if (!(radius > 0.0)) break;
    cosine[m] = column[m] / radius;
    minus_sine[m] = -(length / radius);
    column[m] = radius;
    if (m + 1 < max_products) hessenberg_[m + 1][m + 1] = 0.0;
    projected[m + 1] = minus_sine[m] * projected[m];
    projected[m] *= cosine[m];
    if (!(length > 0.0)) {
      ++used;
      break;
    }
    for (int k = 0; k < size_; ++k) next[k] /= length;
  }
  double combination[unknowns] = {};
  for (int i = used - 1; i >= 0; --i) {
    for (int k = i + 1; k < used; ++k) projected[i] -= hessenberg_[k][i] * projected[k];
    projected[i] /= hessenberg_[i][i];
    for (int k = 0; k < size_; ++k) combination[k] += projected[i] * basis_[i][k];
  }
  precondition(combination, change_);
}

template <int n>
void CoarseRolling<n>::newton_step(double share) {
  // the slip caused by the radial changes goes to the right-hand side
  std::fill_n(field_x_, cells, 0.0);
  std::fill_n(field_y_, cells, 0.0);
  for (int k = 0; k < cell_count_; ++k) {
    field_x_[cell_[k].at] = cell_[k].radial_x;
    field_y_[cell_[k].at] = cell_[k].radial_y;
  }
  grid.slip(field_x_, field_y_, slip_x_, slip_y_);
  gather(change_);
  for (int k = 0; k < size_; ++k) rhs_[k] -= change_[k];
  for (int k = 0; k < row_count_; ++k) factor(row_[k]);
  gmres(1e-2);  // loosely: the next step moves the adhesion area anyway
  for (int k = 0; k < cell_count_; ++k) {
    const int at = cell_[k].at;
    advance(cell_[k], bound[at], change_, share, px[at], py[at]);
  }
}

template <int n>
bool CoarseRolling<n>::solve(const Creepage& creepage, double tolerance, int max_iterations) {
  find_cells(creepage);
  const double rho = 1.0 / std::max(grid.xx[n - 1][n - 1], grid.yy[n - 1][n - 1]);
  update_slip();
  for (iterations = 0;; ++iterations) {
    linearise(rho);
    if (residual <= tolerance) return true;
    if (iterations == max_iterations) return false;
    newton_step(share_of_step(iterations));
    update_slip();
  }
}

template <int n>
TangentialForces CoarseRolling<n>::forces(const Creepage& creepage) const {
  TangentialForces f;
  int sliding = 0;
  for (int k = 0; k < cell_count_; ++k) {
    const int at = cell_[k].at;
    f.fx += px[at];
    f.fy += py[at];
    f.mz += (grid.x(cell_[k].i) - 0.25 * grid.dx) * py[at] - grid.y(at / n) * px[at];
    if (slides[at]) ++sliding;
  }
  const double area = grid.dx * grid.dy;
  f.fx *= area;
  f.fy *= area;
  f.mz *= area;
  f.power_per_speed = -(f.fx * creepage.longitudinal + f.fy * creepage.lateral + f.mz * creepage.spin);
  f.adhesion_fraction = cell_count_ > 0 ? 1.0 - static_cast<double>(sliding) / cell_count_ : 0.0;
  return f;
}

}  // namespace wrc
