#include "normal/elliptic_integrals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "patch/material.hpp"

namespace wrc {

CompleteElliptic complete_elliptic(double complementary_modulus) noexcept {
  const double kc = std::clamp(complementary_modulus, std::numeric_limits<double>::min(), 1.0);
  const double k2 = (1.0 - kc) * (1.0 + kc);

  // The mean's differences c_n obey c_0 = k, c_{n+1} = c_n^2 / (4 a_{n+1}), and K - E = (K / 2) sum 2^n
  // c_n^2. Carrying q_n = c_n^2 / k^2 instead gives D, which is finite for k -> 0.
  double a = 1.0;
  double b = kc;
  double q = 1.0;
  double weight = 1.0;
  double sum = 1.0;
  constexpr int cap = 16;  // k' = 1e-308 takes 12
  for (int n = 0; n < cap && a - b > 1e-4 * a; ++n) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
    q = k2 * q * q / (16.0 * a * a);
    weight *= 2.0;
    sum += weight * q;
  }
  // The rest without further roots: 1 / mean(a, b) = (2 / (a + b)) (1 + h^2 / 4 + 9 h^4 / 64 + ..), h = (a -
  // b) / (a + b), and one more term of the sum; what is left out is below 1e-17.
  const double last = 0.5 * (a + b);
  const double h = (a - b) / (a + b);
  sum += 2.0 * weight * (k2 * q * q / (16.0 * last * last));

  CompleteElliptic value;
  value.k = 0.5 * pi / last * (1.0 + 0.25 * h * h);
  value.d = 0.5 * value.k * sum;
  value.e = value.k - k2 * value.d;
  return value;
}

}  // namespace wrc
