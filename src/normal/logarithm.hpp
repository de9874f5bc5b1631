/// Natural logarithm and exponential with the same bits everywhere.
#pragma once

#include <cmath>

namespace wrc {

/// ln(x) for normal x > 0, to about 2 units in the last place. The C library's log picks code by instruction
/// set, and its last bit with it; the library promises equal bits on all of them.
inline double natural_log(double x) noexcept {
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent);  // exact; mantissa in [0.5, 1)
  constexpr double sqrt_half = 0.70710678118654752440;
  if (mantissa < sqrt_half) {
    mantissa *= 2.0;
    --exponent;
  }
  // ln m = 2 artanh((m - 1) / (m + 1)), argument at most 0.172
  const double s = (mantissa - 1.0) / (mantissa + 1.0);
  const double s2 = s * s;
  double series = 0.0;
  for (int n = 21; n >= 1; n -= 2) series = series * s2 + 1.0 / n;
  constexpr double ln2 = 0.69314718055994530942;
  return 2.0 * s * series + exponent * ln2;
}

/// e^x for |x| < 700, to about 4 units in the last place.
inline double natural_exp(double x) noexcept {
  constexpr double ln2 = 0.69314718055994530942;
  const double octaves = std::floor(x / ln2 + 0.5);
  const double rest = x - octaves * ln2;  // |rest| <= 0.347
  double series = 1.0;
  for (int n = 14; n >= 1; --n) series = 1.0 + series * (rest * (1.0 / n));
  return std::ldexp(series, static_cast<int>(octaves));
}

}  // namespace wrc
