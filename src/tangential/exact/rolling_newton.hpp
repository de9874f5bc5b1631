/// Newton's method for steady rolling with Coulomb friction on a grid of equal cells: Kalker's exact theory,
/// for the exact solver (halfspace/tangential.hpp).
///
/// Particles travel towards -x. The slip of a cell is its rigid slip plus that by all tractions,
///     s = w + C p;
/// where |p| < g the surfaces stick, s = 0; elsewhere p = -g s / |s|. Both say p = P(p - rho s) for any
/// rho > 0, P the projection onto the disk of radius g. A Newton step moves the adhesion area (a primal-dual
/// active set) and solves a linear system for the change of traction: two unknowns in a cell that sticks, one
/// along the circle |p| = g in a cell that slides. That is done by GMRES with every row of cells along x
/// inverted on its own as preconditioner: the difficulty of the equations lies along the rows (a cell acts on
/// the slip upstream and downstream, with opposite signs, and the solution builds up from the leading edge);
/// with the rows inverted, GMRES needs 10 to 20 products whatever the grid.
///
/// A problem over a grid has these members (arrays or vectors; fields by rows along x), which the solution
/// reads and writes, in memory of its own:
///     nx, ny                             cells
///     bound                              g, infinite: always sticks; 0: without traction [Pa]
///     rigid_x, rigid_y                   w [-]
///     px, py                             tractions on the wheel, start and result [Pa]
///     sx, sy                             slip of all cells, result [-]
///     state                              result, exterior without traction
///     x, y                               fields to work in
///     slip()                             turns tractions in x, y into the slips C p these cause
///     xx(m), yy(m)                       of C within a row: slip in x from p_x, in y from p_y of the cell m
///                                        cells behind [1/Pa]
///     cells, rows, vectors, factors      to work in: one of each cell with traction, one of each row,
///                                        newton_vectors(), and newton_factors() of all rows
/// Work is bounded by max_iterations and max_products; sums run in a fixed order.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "tangential/exact/gmres.hpp"

namespace wrc::tangential {

enum class CellState : std::uint8_t { exterior, adhesion, slip };

struct NewtonLimits {
  double tolerance = 0.0;  ///< largest residual
  double accuracy = 0.0;   ///< largest |b - A x| / |b| of a step's linear system
  int max_iterations = 0, max_products = 0;
};

enum class NewtonEnd { solved, capped, cancelled };

/// A cell with traction, and how that may change in one Newton step.
struct NewtonCell {
  int at = 0;  ///< index into the grid's fields
  int i = 0;   ///< along the row
  bool slides = false;
  int first = 0, second = 0;  ///< its unknowns: of p_x and p_y where it sticks; the same one
  double tx = 1.0, ty = 1.0;  ///< change of p_x by the first, of p_y by the second: along the circle
  double stiffening = 0.0;    ///< where it slides: |s| / g, resistance to turning [1/Pa]
  double radial_x = 0.0, radial_y = 0.0;  ///< change that brings the traction onto the circle [Pa]
};

/// The cells of a row, and their unknowns: p_x of those that stick, p_y of these, one of each that slides.
struct NewtonRow {
  int begin = 0, end = 0;  ///< cells
  int first = 0, size = 0, sticking = 0;
  std::size_t factors = 0;  ///< where its own begin
};

/// Doubles of `vectors` for `cells` cells with traction, of two unknowns each at most.
inline std::size_t newton_vectors(std::size_t cells, std::size_t max_products) {
  Arena arena;
  cut_gmres(arena, 2 * cells, max_products);
  return static_cast<std::size_t>(arena.doubles());
}

/// Floats of `factors` for a row of cells: a matrix, and a vector to work in.
constexpr std::size_t newton_factors(std::size_t cells_of_row) {
  return 2 * cells_of_row * (2 * cells_of_row + 1);
}

/// A cell's part of the norm that errors of its traction p are compared with, min(g, max(|p|, rho |w|)),
/// squared: small creepages ask for tractions far below the bound.
inline double asked_squared(double bound, double px, double py, double rho_wx, double rho_wy) {
  return std::min(bound * bound, std::max(px * px + py * py, rho_wx * rho_wx + rho_wy * rho_wy));
}

inline double relative_residual(double error_squared, double norm_squared) {
  if (norm_squared > 0.0) return std::sqrt(error_squared / norm_squared);
  return error_squared > 0.0 ? 1.0 : 0.0;
}

template <class Problem>
class RollingNewton {
 public:
  RollingNewton(Problem& problem, const NewtonLimits& limits);

  /// Iterates from the tractions present until the residual is within the tolerance; asks
  /// goes_on(residual) before every step. At the cap of the iterations the tractions are usable, on the bound
  /// or below it, but not in equilibrium.
  template <class GoesOn>
  NewtonEnd solve(const GoesOn& goes_on);

  int iterations() const { return iterations_; }
  /// |p - P(p - rho s)| / |min(g, max(|p|, rho |w|))|, 2-norms over the cells, rho = 1 / largest coefficient,
  /// about 1.3 G.
  double residual() const { return residual_; }

 private:
  void update_slip();
  void linearise();
  void step();
  void eliminate(const NewtonRow& row, float* v, int begin, int end) const;
  void factor(const NewtonRow& row);
  void precondition(const double* in, double* out);
  void multiply(const double* in, double* out);
  float* factors(const NewtonRow& row, int column) const {
    return &p_.factors[row.factors + column * row.size];
  }

  Problem& p_;
  const NewtonLimits limits_;
  const int all_;  // cells of the grid
  const double rho_;
  int cell_count_ = 0, row_count_ = 0, size_ = 0, iterations_ = 0;
  double residual_ = 0.0;
};

template <class Problem>
RollingNewton<Problem>::RollingNewton(Problem& problem, const NewtonLimits& limits)
    : p_(problem), limits_(limits), all_(problem.nx * problem.ny), rho_(1.0 / std::max(p_.xx(0), p_.yy(0))) {
  std::size_t factors = 0;
  for (int j = 0, at = 0; j < p_.ny; ++j) {
    const int begin = cell_count_;
    for (int i = 0; i < p_.nx; ++i, ++at) {
      p_.state[at] = CellState::exterior;
      if (p_.bound[at] > 0.0) {
        p_.cells[cell_count_++] = {.at = at, .i = i};
      } else {
        p_.px[at] = p_.py[at] = 0.0;
      }
    }
    if (cell_count_ == begin) continue;
    p_.rows[row_count_++] = {.begin = begin, .end = cell_count_, .factors = factors};
    factors += newton_factors(static_cast<std::size_t>(cell_count_ - begin));
  }
}

template <class Problem>
void RollingNewton<Problem>::update_slip() {
  double *const x = &p_.x[0], *const y = &p_.y[0];
  std::copy_n(&p_.px[0], all_, x);
  std::copy_n(&p_.py[0], all_, y);
  p_.slip();
  for (int at = 0; at < all_; ++at) {
    p_.sx[at] = p_.rigid_x[at] + x[at];
    p_.sy[at] = p_.rigid_y[at] + y[at];
  }
}

/// Sets up the cells for a Newton step at the present tractions and slips.
///
/// With z = p - rho s: |z| <= g sticks, and the change d of traction is to make s + C d = 0. Otherwise the
/// cell slides; with e = z / |z| and t across it, the derivative of p = g z / |z| demands e.(p + d) = g, and
/// along t
///     (|z| - g) / (rho g) d_t + (C d)_t = -|z| / (rho g) p_t,
/// where (|z| - g) / (rho g) tends to |s| / g. Sticking tractions may exceed g meanwhile: cut back to the
/// circle they would hide from the next step how far the adhesion area is from carrying itself, and the
/// border would creep by one cell per step.
template <class Problem>
void RollingNewton<Problem>::linearise() {
  double error = 0.0, norm = 0.0;
  size_ = 0;
  for (int r = 0; r < row_count_; ++r) {
    NewtonRow& row = p_.rows[r];
    row.sticking = 0;
    for (int k = row.begin; k < row.end; ++k) {
      // z = p - rho s decides; the residual is p - P(z)
      NewtonCell& c = p_.cells[k];
      const double g = p_.bound[c.at], px = p_.px[c.at], py = p_.py[c.at];
      const double sx = p_.sx[c.at], sy = p_.sy[c.at];
      const double zx = px - rho_ * sx, zy = py - rho_ * sy, z = std::sqrt(zx * zx + zy * zy);
      norm += asked_squared(g, px, py, rho_ * p_.rigid_x[c.at], rho_ * p_.rigid_y[c.at]);
      c = {.at = c.at, .i = c.i, .slides = z > g};
      p_.state[c.at] = c.slides ? CellState::slip : CellState::adhesion;
      if (c.slides) {
        const double ex = zx / z, ey = zy / z, dx = px - g * ex, dy = py - g * ey;
        error += dx * dx + dy * dy;
        const double radial = g - px * ex - py * ey;
        c.radial_x = radial * ex;
        c.radial_y = radial * ey;
        c.tx = -ey;
        c.ty = ex;
        c.stiffening = (z - g) / (rho_ * g);
      } else {
        error += rho_ * rho_ * (sx * sx + sy * sy);
        ++row.sticking;
      }
    }
    // Order of a row's unknowns: p_x of the cells that stick, p_y of these, one of each cell that slides.
    row.first = size_;
    row.size = row.end - row.begin + row.sticking;
    int sticking = size_, sliding = size_ + 2 * row.sticking;
    for (int k = row.begin; k < row.end; ++k) {
      NewtonCell& c = p_.cells[k];
      c.first = c.slides ? sliding++ : sticking++;
      c.second = c.slides ? c.first : c.first + row.sticking;
    }
    size_ += row.size;
  }
  residual_ = relative_residual(error, norm);
}

/// LU factors of the equations of one row of cells on its own, by columns. No exchange of rows is needed:
/// displacement falls and flattens with the distance, so that the symmetric part of the row's coefficients is
/// diagonally dominant, and friction adds to the diagonal. Among cells that stick p_x and p_y do not meet
/// (the coefficient is odd in y): the parts that stay 0 are neither written nor read. Single precision: it
/// only steers the iteration.
template <class Problem>
void RollingNewton<Problem>::factor(const NewtonRow& row) {
  // Coefficients rho C of the row by columns, on the directions t in which the cells' tractions may change.
  const NewtonCell* const cells = &p_.cells[0];
  const int size = row.size, a = row.sticking, first = row.first;
  for (int b = row.begin; b < row.end; ++b) {
    const NewtonCell& from = cells[b];
    float* const one = factors(row, from.first - first);
    float* const two = factors(row, from.second - first);
    const auto from_x = static_cast<float>(from.tx), from_y = static_cast<float>(from.ty);
    for (int k = row.begin; k < row.end; ++k) {
      const NewtonCell& to = cells[k];
      // Scaled: 1/Pa would underflow in products of single precision.
      const auto xx = static_cast<float>(rho_ * p_.xx(to.i - from.i));
      const auto yy = static_cast<float>(rho_ * p_.yy(to.i - from.i));
      const float x = static_cast<float>(to.tx) * xx * from_x, y = static_cast<float>(to.ty) * yy * from_y;
      if (to.slides && from.slides) {
        one[to.first - first] = x + y;
      } else {
        one[to.first - first] = x;
        two[to.second - first] = y;
      }
    }
    if (from.slides) one[from.first - first] += static_cast<float>(rho_ * from.stiffening);
  }
  // LU by columns, left-looking; the diagonal is kept inverted. Columns of p_x leave p_y out.
  for (int c = 0; c < size; ++c) {
    float* const column = factors(row, c);
    eliminate(row, column, c >= a && c < 2 * a ? a : 0, c);
    const float inverse = column[c] = 1.0F / column[c];
    const int end = c < a ? a : size;
    for (int k = c + 1; k < end; ++k) column[k] *= inverse;
    for (int k = std::max(end, 2 * a); k < size; ++k) column[k] *= inverse;
  }
}

/// Eliminates the unknowns from `begin` to before `end` from v: the forward half of a solution.
template <class Problem>
void RollingNewton<Problem>::eliminate(const NewtonRow& row, float* v, int begin, int end) const {
  const int size = row.size, a = row.sticking;
  for (int c = begin; c < end;) {
    const float* const f = factors(row, c);
    const int same = c < a ? a : size, other = std::max(same, 2 * a);
    if (c + 4 > std::min(same, end)) {
      const float v0 = v[c];
      for (int k = c + 1; k < same; ++k) v[k] -= f[k] * v0;
      for (int k = other; k < size; ++k) v[k] -= f[k] * v0;
      ++c;
    } else {  // four at once, for the sake of time
      const float *const f1 = f + size, *const f2 = f1 + size, *const f3 = f2 + size;
      const float v0 = v[c], v1 = v[c + 1] -= f[c + 1] * v0;
      const float v2 = v[c + 2] -= f[c + 2] * v0 + f1[c + 2] * v1;
      const float v3 = v[c + 3] -= f[c + 3] * v0 + f1[c + 3] * v1 + f2[c + 3] * v2;
      const auto take = [=](int k) { v[k] -= (f[k] * v0 + f1[k] * v1) + (f2[k] * v2 + f3[k] * v3); };
      c += 4;
      for (int k = c; k < same; ++k) take(k);
      for (int k = other; k < size; ++k) take(k);
    }
  }
}

/// Solves the equations of every row on its own.
template <class Problem>
void RollingNewton<Problem>::precondition(const double* in, double* out) {
  for (int r = 0; r < row_count_; ++r) {
    const NewtonRow& row = p_.rows[r];
    // forward and backward substitution in single precision, behind the row's factors
    float* const v = factors(row, row.size);
    for (int k = 0; k < row.size; ++k) v[k] = static_cast<float>(in[row.first + k]);
    eliminate(row, v, 0, row.size);
    for (int c = row.size - 1; c >= 0; --c) {
      const float* const column = factors(row, c);
      const float value = v[c] *= column[c];
      out[row.first + c] = rho_ * static_cast<double>(value);
      const int begin = c >= row.sticking && c < 2 * row.sticking ? row.sticking : 0;
      for (int k = begin; k < c; ++k) v[k] -= column[k] * value;
    }
  }
}

/// The equations' left-hand sides.
template <class Problem>
void RollingNewton<Problem>::multiply(const double* in, double* out) {
  // Change of traction d over the grid, its slip C d, and of that both components where a cell sticks, or the
  // one along the circle, plus the resistance to turning.
  double *const x = &p_.x[0], *const y = &p_.y[0];
  std::fill_n(x, all_, 0.0);
  std::fill_n(y, all_, 0.0);
  for (int k = 0; k < cell_count_; ++k) {
    const NewtonCell& c = p_.cells[k];
    x[c.at] = in[c.first] * c.tx;
    y[c.at] = in[c.second] * c.ty;
  }
  p_.slip();
  for (int k = 0; k < cell_count_; ++k) {
    const NewtonCell& c = p_.cells[k];
    if (c.slides) {
      out[c.first] = c.tx * x[c.at] + c.ty * y[c.at] + c.stiffening * in[c.first];
    } else {
      out[c.first] = x[c.at];
      out[c.second] = y[c.at];
    }
  }
}

template <class Problem>
void RollingNewton<Problem>::step() {
  double *const x = &p_.x[0], *const y = &p_.y[0];
  const auto max_products = static_cast<std::size_t>(limits_.max_products);
  Arena arena(&p_.vectors[0]);
  const Gmres system = cut_gmres(arena, static_cast<std::size_t>(size_), max_products);
  double *const rhs = system.rhs, *const change = system.x;
  // Slip by the parts of the change that are known: tractions that slide back onto the circle.
  std::fill_n(x, all_, 0.0);
  std::fill_n(y, all_, 0.0);
  for (int k = 0; k < cell_count_; ++k) {
    x[p_.cells[k].at] = p_.cells[k].radial_x;
    y[p_.cells[k].at] = p_.cells[k].radial_y;
  }
  if (size_ < 2 * cell_count_) p_.slip();  // otherwise all cells stick, and there are none
  for (int k = 0; k < cell_count_; ++k) {
    const NewtonCell& c = p_.cells[k];
    if (c.slides) {
      const double along = p_.px[c.at] * c.tx + p_.py[c.at] * c.ty;
      rhs[c.first] = -along * (c.stiffening + 1.0 / rho_) - c.tx * x[c.at] - c.ty * y[c.at];
    } else {
      rhs[c.first] = -p_.sx[c.at] - x[c.at];
      rhs[c.second] = -p_.sy[c.at] - y[c.at];
    }
  }
  // unknown changes, by GMRES with the rows' inverses
  for (int r = 0; r < row_count_; ++r) factor(p_.rows[r]);
  gmres([this](const double* in, double* out) { multiply(in, out); },
        [this](const double* in, double* out) { precondition(in, out); }, static_cast<std::size_t>(size_),
        limits_.accuracy, max_products, system);
  // A full step converges in a few iterations; where a few cells keep changing between adhesion and slip
  // (about one problem in 400, near a spin pole) shorter steps break the cycle.
  constexpr int full_steps = 12;
  const double share = iterations_ < full_steps || iterations_ % 4 == 3 ? 1.0 : 0.5;
  for (int k = 0; k < cell_count_; ++k) {
    const NewtonCell& c = p_.cells[k];
    double &px = p_.px[c.at], &py = p_.py[c.at];
    px += share * (c.radial_x + change[c.first] * c.tx);
    py += share * (c.radial_y + change[c.second] * c.ty);
    const double length = std::sqrt(px * px + py * py);
    if (!c.slides || !(length > 0.0)) continue;
    px *= p_.bound[c.at] / length;  // from the tangent back onto the circle
    py *= p_.bound[c.at] / length;
  }
}

template <class Problem>
template <class GoesOn>
NewtonEnd RollingNewton<Problem>::solve(const GoesOn& goes_on) {
  for (iterations_ = 0;; ++iterations_) {
    update_slip();
    linearise();
    if (residual_ <= limits_.tolerance) return NewtonEnd::solved;
    if (iterations_ == limits_.max_iterations) return NewtonEnd::capped;
    if (!goes_on(residual_)) return NewtonEnd::cancelled;
    step();
  }
}

}  // namespace wrc::tangential
