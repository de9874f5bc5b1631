/// Stresses of loads on a half-space, for plain numbers and for packs of them (base/pack.hpp): the formulas
/// of damage/cell_stress.hpp, which has plain numbers only.
#pragma once

#include "base/elementary.hpp"
#include "base/number.hpp"

namespace wrc::damage {

/// Components along x, y and the depth [Pa].
template <class Number>
struct StressOf {
  Number xx, yy, zz, xy, yz, zx;
};

template <class Number>
struct CellStressOf {
  StressOf<Number> of_pressure, of_traction_x, of_traction_y;
};

/// 1 / (2 pi)
inline constexpr double stress_scale = 0.15915494309189533577;

/// One corner's share of a cell's stresses, X, Y from the corner to the point. Derivatives of F and F1 under
/// a unit load, named after the variables they differentiate by (`of_` those of F1), are by their
/// antiderivatives over x and y. With r^2 = X^2 + Y^2 + z^2, over both indefinite integrals,
///     F_xy -> ln(r + z), F_xz -> ln(Y + r), F_zz -> -atan(XY / (z r)),
///     F_xx -> atan(Y / X) - atan(z Y / (X r)), F1_xxy -> -X / (r + z),
/// and all others follow by differentiation, exchange of x and y, and F being harmonic.
template <class Number>
inline CellStressOf<Number> corner_stress_of(double nu, Number X, Number Y, Number z) {
  const Number x2 = X * X, y2 = Y * Y, z2 = z * z;
  const Number r = root(x2 + y2 + z2), rz = r + z;
  const Number none = 0.0, quarter_turn = 0.25 / stress_scale;
  const auto with_sign_of = [&](Number size, Number t) { return select(t < none, -size, size); };
  const auto angle = [&](Number over, Number under) {  // none of nothing
    const auto some = under > none;
    const Number found = arctangent(select(some, over, none) / select(some, under, Number(1.0)));
    return select(some, found, select(over < none, -quarter_turn, select(over > none, quarter_turn, none)));
  };
  const auto area_sine = [&](Number t) {  // by logarithms of numbers from 1 on
    const Number size = magnitude(t);
    return with_sign_of(natural_log(size + root(size * size + Number(1.0))), t);
  };
  const Number xx = angle(X * Y * (r - z), x2 * r + z * y2);
  const Number zz = -angle(X * Y, z * r);
  const Number yy = -xx - zz;
  const Number xy = natural_log(rz);
  const Number xz = area_sine(Y / root(x2 + z2)), yz = area_sine(X / root(y2 + z2));
  const Number xyz = Number(1.0) / r;
  const Number xxy = X / (r * rz), xyy = Y / (r * rz);
  const Number xxz = -X * Y / (r * (x2 + z2)), yyz = -X * Y / (r * (y2 + z2));
  const Number xzz = -z * Y / (r * (x2 + z2)), yzz = -z * X / (r * (y2 + z2));
  const Number zzz = -xxz - yyz;
  const Number xxx = -xyy - xzz, yyy = -xxy - yzz;
  const Number of_xxy = -X / rz, of_xyy = -Y / rz;
  const Number of_xxx = Y / rz - xz, of_yyy = X / rz - yz;

  const Number scale = stress_scale, k = 1.0 - 2.0 * nu, twice = 2.0 * nu, other = 2.0 * (1.0 + nu);
  return {{scale * (twice * zz - z * xxz - k * xx), scale * (twice * zz - z * yyz - k * yy),
           scale * (zz - z * zzz), scale * (-k * xy - z * xyz), scale * (-z * yzz), scale * (-z * xzz)},
          {scale * (other * xz + twice * of_xxx - z * xxx), scale * (twice * xz + twice * of_xyy - z * xyy),
           scale * (-z * xzz), scale * (yz + twice * of_xxy - z * xxy), scale * (-z * xyz),
           scale * (zz - z * xxz)},
          {scale * (twice * yz + twice * of_xxy - z * xxy), scale * (other * yz + twice * of_yyy - z * yyy),
           scale * (-z * yzz), scale * (xz + twice * of_xyy - z * xyy), scale * (zz - z * yyz),
           scale * (-z * xyz)}};
}

/// Stress by forces at a point. It follows from the derivatives of ln(r + z) there; in this form nothing
/// cancels right below it.
template <class Number>
inline StressOf<Number> point_force_stress_of(double nu, Number x, Number y, Number z, Number normal,
                                              Number along, Number across) {
  const Number scale = stress_scale, k = 1.0 - 2.0 * nu;
  const Number r2 = x * x + y * y + z * z, r = root(r2);
  const Number rz = r + z, both = Number(1.0) / (r * rz);
  const Number u = both * rz, u2 = u * u, u3 = u2 * u;  // 1 / r
  const Number w = both * r, w2 = w * w;                // 1 / (r + z)
  const Number x2 = x * x, y2 = y * y;
  // The part independent of nu is radial: -3 (force . r) r r / r^5.
  const Number radial = Number(-3.0) * (normal * z + along * x + across * y) * u3 * u2;
  // k-terms: A of 1 / r^3, B of 1 / (r (r + z)^2), C of the products of three coordinates.
  const Number a = k * u3, b = k * u * w2, c = k * u2 * w2 * (u + w + w), b3 = Number(3.0) * b;
  const Number d = k * u2 * w * (u + w);  // (2 r + z) / (r^3 (r + z)^2)
  const Number own = k * (z * u3 - u * w);
  return {
      scale * (radial * x2 + normal * (own + d * x2) + along * x * (a - b3 + c * x2) +
               across * y * (a - b + c * x2)),
      scale * (radial * y2 + normal * (own + d * y2) + along * x * (a - b + c * y2) +
               across * y * (a - b3 + c * y2)),
      scale * radial * z * z,
      scale * (radial * x * y + normal * d * x * y + along * y * (c * x2 - b) + across * x * (c * y2 - b)),
      scale * radial * y * z,
      scale * radial * x * z};
}

}  // namespace wrc::damage
