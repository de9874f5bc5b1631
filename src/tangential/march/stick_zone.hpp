/// The stick zone at the leading edge of a strip, in closed form: how far the tractions of full adhesion stay
/// below the traction bound.
///
/// v = x_l - x is the distance from the leading edge, u = 2a - v from the trailing edge of a strip of half
/// length a. The tractions of full adhesion are p = -v (gx, gy - k v), so with u in place of v
///     |p|^2 = v^2 (gx^2 + (beta + k u)^2),   beta = gy - 2 k a.
///
/// Number is double, or a pack of them: one strip per lane.
#pragma once

#include "base/number.hpp"

namespace wrc::tangential {

/// Growth of the adhesion tractions along a strip.
template <class Number>
struct AdhesionGrowth {
  Number gx;         ///< -dp_x/dv [Pa/m]
  Number gy;         ///< -dp_y/dv at the leading edge [Pa/m]
  Number curvature;  ///< k = phi / (2 L23) [Pa/m^2]
};

/// Distance u from the trailing edge up to which there is slip, 0 (nowhere) to 2a (everywhere), under the
/// parabolic bound tau = B u v: gx^2 + (beta + k u)^2 = B^2 u^2, the largest root u in (0, 2a).
template <class Number>
Number slip_end_parabolic(const AdhesionGrowth<Number>& g, const Number& B, const Number& a) {
  const Number zero = 0.0, length = 2.0 * a;
  const Number beta = g.gy - length * g.curvature;
  const Number c = g.gx * g.gx + beta * beta;
  const Number A = B * B - g.curvature * g.curvature;
  const Number H = -(beta * g.curvature);
  const auto slips_at_edge = g.gx * g.gx + g.gy * g.gy >= B * B * (length * length);
  // A u^2 + 2 H u - c = 0. It is negative at u = 0 and, with stick at the leading edge, positive at 2a: one
  // root lies between, given by whichever form has no cancellation (H < 0 implies A > 0 then).
  const Number S = root(larger(zero, H * H + A * c));
  const auto cancels = H < zero;
  const Number numerator = select(cancels, S - H, c);
  const Number denominator = select(cancels, A, H + S);
  const auto crosses = denominator > zero;
  const Number u = select(crosses, numerator / select(crosses, denominator, Number(1.0)), zero);
  return select(slips_at_edge, length, smaller(larger(u, zero), length));
}

/// Distance v from the leading edge at which slip sets in, 0 (at once) to 2a (never).
template <class Number>
Number onset_parabolic(const AdhesionGrowth<Number>& g, const Number& B, const Number& a) {
  return 2.0 * a - slip_end_parabolic(g, B, a);
}

/// The same under the elliptic bound tau = E sqrt(u v): v (gx^2 + (beta + k u)^2) = E^2 u. In s = u / 2a this
/// cubic has at least one root in [0, 1); the largest is found by Laguerre's method, started on the side of
/// it that is free of other roots. Six steps leave the traction within 1e-5 of the bound over four decades of
/// creepages (checked by the unit test), in a fixed amount of work.
template <class Number>
Number onset_elliptic(const AdhesionGrowth<Number>& g, const Number& E, const Number& a) {
  const Number zero = 0.0, one = 1.0;
  const Number least_bound = 1e-6;  // [Pa]: frictionless strips slip at once without a division by zero
  const Number per_bound = one / larger(E, least_bound), length = 2.0 * a;
  const Number A = g.gx * per_bound, b = (g.gy - length * g.curvature) * per_bound;
  const Number k = length * g.curvature * per_bound;
  // f(s) = s - (1 - s) (A^2 + (b + k s)^2) = c3 s^3 + c2 s^2 + c1 s + c0;  f(0) <= 0 < f(1) = 1
  const Number c3 = k * k, c2 = 2.0 * b * k - c3, c0 = -(A * A + b * b), c1 = one - c0 - 2.0 * b * k;
  const auto f = [&](const Number& s) { return c0 + s * (c1 + s * (c2 + s * c3)); };
  const auto within = [&](const Number& s) { return smaller(larger(s, zero), one); };

  // If f is negative at its local minimum (at its inflection, if it has none), the largest root lies to the
  // right of that point: start from s = 1. If not, the only root lies to the left: start from s = 0.
  const Number discriminant = c2 * c2 - 3.0 * c3 * c1;
  const Number turn = root(larger(zero, discriminant)) - c2;
  const auto bends = c3 > zero;
  const Number bend = select(bends, turn / select(bends, 3.0 * c3, one), zero);
  Number s = select(bend <= zero, one, select(f(within(bend)) < zero, one, zero));
  // Laguerre for a cubic: s - 3 f / (f' + sqrt(4 f'^2 - 6 f f''))
  for (int i = 0; i < 6; ++i) {
    const Number value = f(s), slope = c1 + s * (2.0 * c2 + s * 3.0 * c3);
    const Number bending = 2.0 * c2 + 6.0 * c3 * s;
    const Number denominator = slope + root(larger(zero, 4.0 * slope * slope - 6.0 * value * bending));
    const auto moves = denominator > zero;
    const Number step = 3.0 * value / select(moves, denominator, one);
    s = select(moves, within(s - step), s);
  }
  return length * (one - s);
}

}  // namespace wrc::tangential
