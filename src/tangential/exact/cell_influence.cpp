#include "tangential/exact/cell_influence.hpp"

#include <cmath>
#include <initializer_list>

#include "base/elementary.hpp"

namespace wrc::tangential {
namespace {

// x asinh(y / |x|), the corner function of IInt y^2/r^3; its limit at x = 0 is 0.
double corner(double x, double y, double r) {
  return x == 0.0 ? 0.0 : std::copysign(x, x * y) * natural_log((std::abs(y) + r) / std::abs(x));
}

// Integral of x/r^2 from a corner at the distances x, y, without terms that cancel between the corners.
double coupling_corner(double x, double y) {
  const double square = x * x + y * y;
  return (square > 0.0 ? 0.5 * y * natural_log(square) : 0.0) + (x == 0.0 ? 0.0 : x * arctangent(y / x));
}

}  // namespace

// With X, Y the distances from the four corners of the cell to the point,
//     IInt y^2/r^3 = [[ X ln(Y + r) ]],  IInt x^2/r^3 = [[ Y ln(X + r) ]],  IInt x y/r^3 = [[ -r ]],
// double differences over the corners; 1/r is the sum of the first two. asinh(Y/|X|) replaces ln(Y + r): the
// difference ln|X| does not depend on Y and drops out, and nothing cancels for negative Y.
CellInfluence cell_influence(const patch::Material& material, double x, double y, double dx, double dy) {
  // double differences over the corners of the cell
  const double xs[2] = {x - 0.5 * dx, x + 0.5 * dx};
  const double ys[2] = {y - 0.5 * dy, y + 0.5 * dy};
  double yy_over_r3 = 0.0, xx_over_r3 = 0.0, xy_over_r3 = 0.0;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      const double sign = i == j ? 1.0 : -1.0;
      const double r = std::sqrt(xs[i] * xs[i] + ys[j] * ys[j]);
      yy_over_r3 += sign * corner(xs[i], ys[j], r);
      xx_over_r3 += sign * corner(ys[j], xs[i], r);
      xy_over_r3 -= sign * r;
    }
  }
  // Boussinesq and Cerruti: (1 - nu) / r and nu x^2 / r^3 over pi G, with 1/r = (x^2 + y^2) / r^3
  const double scale = 1.0 / (pi * material.shear_modulus);
  const double nu = material.poisson;
  return {.zz = scale * (1.0 - nu) * (xx_over_r3 + yy_over_r3),
          .xx = scale * (xx_over_r3 + (1.0 - nu) * yy_over_r3),
          .xy = scale * nu * xy_over_r3,
          .yy = scale * ((1.0 - nu) * xx_over_r3 + yy_over_r3)};
}

CouplingInfluence coupling_influence(double x, double y, double dx, double dy) {
  CouplingInfluence sum;
  for (const double i : {-1.0, 1.0}) {
    for (const double j : {-1.0, 1.0}) {
      const double cx = x + 0.5 * i * dx, cy = y + 0.5 * j * dy;
      sum.x += i * j * coupling_corner(cx, cy);
      sum.y += i * j * coupling_corner(cy, cx);
    }
  }
  return sum;
}

}  // namespace wrc::tangential
