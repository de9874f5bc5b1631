/// The stick zone at the leading edge of a strip, in closed form: how far the tractions of full adhesion stay
/// below the traction bound.
///
/// v = x_l - x is the distance from the leading edge, u = 2a - v from the trailing edge of a strip of half
/// length a. The tractions of full adhesion are p = -v (gx, gy - k v), so with u in place of v
///     |p|^2 = v^2 (gx^2 + (beta + k u)^2),   beta = gy - 2 k a.
#pragma once

#include <algorithm>
#include <cmath>

namespace wrc {

/// Growth of the adhesion tractions along a strip.
struct AdhesionGrowth {
  double gx = 0.0;         ///< -dp_x/dv [Pa/m]
  double gy = 0.0;         ///< -dp_y/dv at the leading edge [Pa/m]
  double curvature = 0.0;  ///< k = phi / (2 L23) [Pa/m^2]
};

/// Distance v from the leading edge at which slip sets in, 0 (at once) to 2a (never), under the parabolic
/// bound tau = B u v: gx^2 + (beta + k u)^2 = B^2 u^2, the largest root u in (0, 2a).
inline double onset_parabolic(const AdhesionGrowth& g, double B, double a) {
  const double beta = g.gy - 2.0 * g.curvature * a;
  const double c = g.gx * g.gx + beta * beta;
  const double A = B * B - g.curvature * g.curvature;
  const double H = -beta * g.curvature;
  const bool slips_at_edge = g.gx * g.gx + g.gy * g.gy >= 4.0 * B * B * a * a;
  // A u^2 + 2 H u - c = 0. It is negative at u = 0 and, with stick at the leading edge, positive at 2a: one
  // root lies between, given by whichever form has no cancellation (H < 0 implies A > 0 then).
  const double S = std::sqrt(std::max(0.0, H * H + A * c));
  const double numerator = H < 0.0 ? S - H : c;
  const double denominator = H < 0.0 ? A : H + S;
  const double u = denominator > 0.0 ? numerator / denominator : 0.0;
  return slips_at_edge ? 0.0 : std::clamp(2.0 * a - u, 0.0, 2.0 * a);
}

/// The same under the elliptic bound tau = E sqrt(u v): v (gx^2 + (beta + k u)^2) = E^2 u. In s = u / 2a this
/// cubic has at least one root in [0, 1); the largest is found by Laguerre's method, started on the side of
/// it that is free of other roots. Six steps leave the traction within 1e-5 of the bound over four decades of
/// creepages (checked by the unit test), in a fixed amount of work.
inline double onset_elliptic(const AdhesionGrowth& g, double E, double a) {
  constexpr double least_bound = 1e-6;  // [Pa]: frictionless strips slip at once without a division by zero
  const double e = std::max(E, least_bound);
  const double A = g.gx / e, b = (g.gy - 2.0 * g.curvature * a) / e, k = 2.0 * g.curvature * a / e;
  // f(s) = s - (1 - s) (A^2 + (b + k s)^2) = c3 s^3 + c2 s^2 + c1 s + c0;  f(0) <= 0 < f(1) = 1
  const double c3 = k * k, c2 = 2.0 * b * k - c3, c0 = -(A * A + b * b), c1 = 1.0 - c0 - 2.0 * b * k;
  const auto f = [&](double s) { return c0 + s * (c1 + s * (c2 + s * c3)); };

  // If f is negative at its local minimum (at its inflection, if it has none), the largest root lies to the
  // right of that point: start from s = 1. If not, the only root lies to the left: start from s = 0.
  const double discriminant = c2 * c2 - 3.0 * c3 * c1;
  const double turn = -c2 + std::sqrt(std::max(0.0, discriminant));
  const double bend = c3 > 0.0 ? turn / (3.0 * c3) : 0.0;
  double s = f(std::clamp(bend, 0.0, 1.0)) < 0.0 || bend <= 0.0 ? 1.0 : 0.0;
  for (int i = 0; i < 6; ++i) {
    const double value = f(s), slope = c1 + s * (2.0 * c2 + s * 3.0 * c3), bending = 2.0 * c2 + 6.0 * c3 * s;
    const double root = std::sqrt(std::max(0.0, 4.0 * slope * slope - 6.0 * value * bending));
    const double denominator = slope + root;
    s = denominator > 0.0 ? std::clamp(s - 3.0 * value / denominator, 0.0, 1.0) : s;
  }
  return 2.0 * a * (1.0 - s);
}

}  // namespace wrc
