/// Complete elliptic integrals by the arithmetic-geometric mean.
///
/// Hertz's ellipse and the closed inner integral of the Kik-Piotrowski condition are made of K, E and D.
/// The mean needs a handful of square roots and gives the same bits on every instruction set. It yields K - E
/// without the cancellation of a difference. The compiler can evaluate it, and fills the tables of the hot
/// paths with it. std::comp_ellint_1 may throw, is absent from some standard libraries and is several times
/// slower.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/bits.hpp"
#include "patch/material.hpp"

namespace wrc::normal {

/// K, E and D of one modulus k:
///   K = Int_0^{pi/2} (1 - k^2 sin^2 t)^{-1/2} dt,  E = Int (1 - k^2 sin^2 t)^{1/2} dt,  D = (K - E) / k^2 .
struct CompleteElliptic {
  double k = 0.0;
  double e = 0.0;
  double d = 0.0;
};

/// Square roots: those of the processor, and for tables that the compiler fills, since std::sqrt is not
/// constexpr.
struct RootInSteps {
  double operator()(double x) const noexcept { return std::sqrt(x); }
};
struct RootInTables {
  /// x > 0.
  constexpr double operator()(double x) const noexcept {
    // x = 2^exponent (1 + mantissa 2^-52)
    int exponent = 0;
    double scaled = x;
    for (; scaled >= 2.0; ++exponent) scaled *= 0.5;
    for (; scaled < 1.0; --exponent) scaled *= 2.0;
    const auto mantissa = static_cast<std::int64_t>((scaled - 1.0) * power_of_two(52));
    // Halving the exponent gives a guess within 4 %; four of Newton's steps leave rounding.
    const int half = exponent >= 0 ? exponent / 2 : -((1 - exponent) / 2);
    double root = 1.0 + (exponent - 2 * half) * 0.5 + static_cast<double>(mantissa >> 1) * power_of_two(-52);
    for (int i = 0; i < half; ++i) root *= 2.0;
    for (int i = 0; i < -half; ++i) root *= 0.5;
    for (int i = 0; i < 4; ++i) root = 0.5 * (root + x / root);
    return root;
  }
};

/// All three from the complementary modulus k' = sqrt(1 - k^2), 0 < k' <= 1. The complement is the argument
/// because slender ellipses and points close to a strip have k -> 1, where k itself has lost its digits;
/// there K ~ ln(4 / k'). k' below the smallest normal number counts as that number. Abramowitz and Stegun,
/// Handbook of Mathematical Functions, 17.6.
template <class SquareRoot = RootInSteps>
constexpr CompleteElliptic complete_elliptic(double complementary_modulus) noexcept {
  const double kc = std::clamp(complementary_modulus, std::numeric_limits<double>::min(), 1.0);
  const double k2 = (1.0 - kc) * (1.0 + kc);

  // The mean's differences c_n obey c_0 = k, c_{n+1} = c_n^2 / (4 a_{n+1}), and K - E = (K / 2) sum 2^n
  // c_n^2. Carrying q_n = c_n^2 / k^2 instead gives D, which is finite for k -> 0.
  // Arithmetic and geometric mean a, b of (1, k'); they meet at pi / (2 K).
  double a = 1.0;
  double b = kc;
  double q = 1.0;
  double weight = 1.0;
  double sum = 1.0;
  constexpr int cap = 16;  // k' = 1e-308 takes 12
  for (int n = 0; n < cap && a - b > 1e-4 * a; ++n) {
    const double mean = 0.5 * (a + b);
    b = SquareRoot{}(a * b);
    a = mean;
    q = k2 * q * q / (16.0 * a * a);
    weight *= 2.0;
    sum += weight * q;
  }
  // The rest without further roots: 1 / mean(a, b) = (2 / (a + b)) (1 + h^2 / 4 + 9 h^4 / 64 + ..),
  // h = (a - b) / (a + b), and one more term of the sum; the terms left out are below 1e-17.
  const double last = 0.5 * (a + b);
  const double h = (a - b) / (a + b);
  sum += 2.0 * weight * (k2 * q * q / (16.0 * last * last));

  CompleteElliptic value;
  // K = pi / (2 mean), D = K sum / 2, E = K - k^2 D.
  value.k = 0.5 * pi / last * (1.0 + 0.25 * h * h);
  value.d = 0.5 * value.k * sum;
  value.e = value.k - k2 * value.d;
  return value;
}

/// Derivatives of K and D by the parameter m = k^2 = 1 - k'^2, from the integrals at k'.
struct EllipticDerivatives {
  double k = 0.0, d = 0.0;
};
constexpr EllipticDerivatives by_parameter(const CompleteElliptic& at,
                                           double complementary_modulus) noexcept {
  const double mc = complementary_modulus * complementary_modulus;
  const double m = (1.0 - complementary_modulus) * (1.0 + complementary_modulus);
  // dK/dm = B / (2 k'^2), dD/dm = (B - k'^2 D) / (2 m k'^2), B = K - D.
  const double b = at.k - at.d;
  // m -> 0: Int sin^4 t dt / 2
  const double d = m < 1e-9 ? 3.0 / 32.0 * pi : (b - mc * at.d) / (2.0 * m * mc);
  return {b / (2.0 * mc), d};
}

}  // namespace wrc::normal
