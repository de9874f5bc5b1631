/// Newton's method for steady rolling with Coulomb friction, as far as one cell of a grid goes: what the
/// coarse method in real time (coarse_rolling.hpp) and the exact solver (halfspace/tangential.hpp) share.
///
/// Where |p| < g the surfaces stick, s = 0; elsewhere p = -g s / |s|. Both say p = P(p - rho s) for any rho >
/// 0, P the projection onto the disk of radius g. A Newton step moves the adhesion area and solves a linear
/// system for the change of traction: two unknowns in a cell that sticks, one along the circle |p| = g in a
/// cell that slides.
#pragma once

#include <algorithm>
#include <cmath>

namespace wrc {

/// A cell in contact, and how its traction may change in one Newton step.
struct NewtonCell {
  int at = 0;                             ///< index into the grid's arrays, rows along x
  int i = 0;                              ///< along the row
  double wx = 0.0, wy = 0.0;              ///< rigid slip [-]
  int first = 0, count = 0;               ///< its unknowns: 2 where it sticks, 1 where it slides
  double tx = 0.0, ty = 0.0;              ///< where it slides: direction of the unknown, along the circle
  double stiffening = 0.0;                ///< where it slides: |s| / g, resistance to turning [1/Pa]
  double radial_x = 0.0, radial_y = 0.0;  ///< change that brings the traction onto the circle [Pa]
};

/// |p - P(p - rho s)| / |min(g, max(|p|, rho |w|))|, 2-norms over the cells: small creepages ask for
/// tractions far below the bound, and these are what the error is compared with.
struct NewtonResidual {
  double error_squared = 0.0, norm_squared = 0.0;

  double value() const {
    if (norm_squared > 0.0) return std::sqrt(error_squared / norm_squared);
    return error_squared > 0.0 ? 1.0 : 0.0;
  }
};

/// Sets up a cell's part of the Newton system at its traction p and slip s; rhs: its right-hand sides. True
/// where it slides.
///
/// With z = p - rho s: |z| <= g sticks, and the change d of traction is to make s + C d = 0. Otherwise the
/// cell slides; with e = z / |z| and t across it, the derivative of p = g z / |z| demands e.(p + d) = g, and
/// along t
///     (|z| - g) / (rho g) d_t + (C d)_t = -|z| / (rho g) p_t,
/// where (|z| - g) / (rho g) tends to |s| / g. Sticking tractions may exceed g on the way: cut back to the
/// circle they would hide from the next step how far the adhesion area is from carrying itself, and the
/// border would creep by one cell per step.
inline bool linearise(double g, double rho, double px, double py, double sx, double sy, int first,
                      NewtonCell& cell, double (&rhs)[2], NewtonResidual& residual) {
  const double zx = px - rho * sx, zy = py - rho * sy;
  const double z = std::sqrt(zx * zx + zy * zy);
  const bool slides = z > g;
  cell.first = first;
  if (slides) {
    const double ex = zx / z, ey = zy / z;
    cell.count = 1;
    cell.tx = -ey;
    cell.ty = ex;
    cell.stiffening = (z - g) / (rho * g);
    const double radial = g - px * ex - py * ey;
    cell.radial_x = radial * ex;
    cell.radial_y = radial * ey;
    rhs[0] = -(px * cell.tx + py * cell.ty) * z / (rho * g);
    const double dx = px - g * ex, dy = py - g * ey;
    residual.error_squared += dx * dx + dy * dy;
  } else {
    cell.count = 2;
    cell.radial_x = cell.radial_y = 0.0;
    rhs[0] = -sx;
    rhs[1] = -sy;
    residual.error_squared += rho * rho * (sx * sx + sy * sy);
  }
  return slides;
}

/// What the cell adds to the norm of the residual.
inline double asked_squared(double g, double rho, double px, double py, const NewtonCell& cell) {
  return std::min(g * g, std::max(px * px + py * py, rho * rho * (cell.wx * cell.wx + cell.wy * cell.wy)));
}

/// The cell's change of traction, from the unknowns [Pa].
inline void traction_of(const NewtonCell& cell, const double* unknowns, double& x, double& y) {
  x = cell.count == 2 ? unknowns[cell.first] : unknowns[cell.first] * cell.tx;
  y = cell.count == 2 ? unknowns[cell.first + 1] : unknowns[cell.first] * cell.ty;
}

/// Its left-hand sides, from the slip that the changes of traction cause in it (C d).
inline void equations_of(const NewtonCell& cell, double x, double y, double* left) {
  if (cell.count == 2) {
    left[cell.first] = x;
    left[cell.first + 1] = y;
  } else {
    left[cell.first] = cell.tx * x + cell.ty * y;
  }
}

/// Elements of the matrix that give the left-hand sides of a cell from the unknowns of another (or itself) in
/// the same row, set(row, column, value). Within a row the slip in x does not depend on p_y (the coefficient
/// is odd in y). xx, yy: slip in x from p_x, in y from p_y.
template <class Number, class Set>
void couple(const NewtonCell& to, const NewtonCell& from, Number xx, Number yy, const Set& set) {
  const auto to_x = static_cast<Number>(to.tx), to_y = static_cast<Number>(to.ty);
  const auto from_x = static_cast<Number>(from.tx), from_y = static_cast<Number>(from.ty);
  if (to.count == 2 && from.count == 2) {
    set(0, 0, xx);
    set(0, 1, Number(0));
    set(1, 0, Number(0));
    set(1, 1, yy);
  } else if (to.count == 2) {
    set(0, 0, xx * from_x);
    set(1, 0, yy * from_y);
  } else if (from.count == 2) {
    set(0, 0, to_x * xx);
    set(0, 1, to_y * yy);
  } else {
    set(0, 0, to_x * xx * from_x + to_y * yy * from_y);
  }
}

/// A full step converges in a few iterations; where a few cells keep changing between adhesion and slip
/// (about one problem in 400, near a spin pole) shorter steps break the cycle.
inline double share_of_step(int iterations) {
  constexpr int full_steps = 12;
  return iterations < full_steps || iterations % 4 == 3 ? 1.0 : 0.5;
}

/// Moves the cell's traction by a share of the step, and from the tangent back onto the circle.
inline void advance(const NewtonCell& cell, double g, const double* change, double share, double& px,
                    double& py) {
  double dx = 0.0, dy = 0.0;
  traction_of(cell, change, dx, dy);
  const double x = px + share * (cell.radial_x + dx), y = py + share * (cell.radial_y + dy);
  const double length = std::sqrt(x * x + y * y);
  const double cut = cell.count == 1 && length > 0.0 ? g / length : 1.0;
  px = cut * x;
  py = cut * y;
}

}  // namespace wrc
