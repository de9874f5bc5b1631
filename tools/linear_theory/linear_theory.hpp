/// Linear theory (full adhesion) of SDEC patches: Kalker's creepage coefficients and their shape-number
/// dependence, computed from the half-space equations, with an error estimate for each.
///
/// Ellipses are solved without a grid (ellipse_linear_theory.hpp). What the shape number adds is computed on
/// strips along x, each divided into cells: collocation of the displacements at the cells' middles,
/// differences from one to the next give the slips at their borders, the trailing edge left out (singular)
/// and the leading edge kept (no traction); a dense system, unknowns 2 strips cells. Strips and cells shorten
/// towards the edges as equal angles on a circle do, which suits tractions with square-root edges and patches
/// of any slenderness.
#pragma once

#include <array>

#include "linear_theory/linear_coefficients.hpp"

namespace wrc::halfspace {

/// On the strips, of the patch with a/b = axis_ratio; `strips` divisible by 8. Memory: 32 (strips cells)^2
/// bytes, 34 MB for 32 x 32.
LinearCoefficients strip_linear_coefficients(double axis_ratio, double psi, double poisson, int strips,
                                             int cells);

struct EstimatedCoefficients {
  LinearCoefficients value;
  LinearCoefficients error;  ///< estimate of the absolute error
};

/// The double ellipses of one axis ratio and Poisson ratio.
///
/// On the strips C11, C22, C23, and C33 about the middle of the width are wrong by nearly the same factor for
/// every shape: they are those of the ellipse, exact, times the ratio of both on the same strips,
/// extrapolated linearly in 1/n from n = 3/4 finest and finest. C13 about the middle, zero for the ellipse,
/// is extrapolated itself; moving the point to the joint then adds psi b C11.
class LinearTheory {
 public:
  /// finest: strips and cells of the finest of three divisions (1/2, 3/4 and 1 times it), divisible by 32.
  LinearTheory(double axis_ratio, double poisson, int finest);

  /// |psi| < 1. The error estimate is the larger of what extrapolation adds to the finest division and how
  /// far extrapolation from the coarser two is off; of an ellipse, what halving the degree changes.
  EstimatedCoefficients at(double psi) const;

 private:
  using Divisions = std::array<LinearCoefficients, 3>;  ///< coarse to fine; c13, c31, c33 about the middle
  Divisions divisions(double psi) const;

  double axis_ratio_, poisson_;
  int finest_;
  EstimatedCoefficients ellipse_;
  Divisions ellipse_on_strips_;
};

}  // namespace wrc::halfspace
