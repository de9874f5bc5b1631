/// Elementary functions with the same bits everywhere.
///
/// The C library's pick code by instruction set, and their last bit with it (FMA or not); this library
/// promises equal bits on all machines. These use + - * /, sqrt, and frexp, ldexp and floor, which are exact.
/// Sums of series run from the small terms to the large. Accuracy in units in the last place (ulp), tested
/// against extended precision.
#pragma once

#include <cmath>

namespace wrc {

inline constexpr double pi = 3.14159265358979323846264338327950288;

/// ln 2 in two parts, of which the first has 32 bits: its products with whole numbers are exact.
inline constexpr double ln2_high = 0x1.62e42feep-1, ln2_low = 0x1.a39ef35793c76p-33;

/// ln(x) for normal x > 0, to 2 ulp.
inline double natural_log(double x) noexcept {
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent);  // exact; mantissa in [0.5, 1)
  constexpr double sqrt_half = 0.70710678118654752440;
  if (mantissa < sqrt_half) {
    mantissa *= 2.0;
    --exponent;
  }
  // ln m = 2 artanh(s) = 2 s + 2 s (s^2 / 3 + s^4 / 5 + ...), s = (m - 1) / (m + 1), at most 0.172
  const double s = (mantissa - 1.0) / (mantissa + 1.0);
  const double s2 = s * s;
  double series = 0.0;
  for (int n = 21; n >= 3; n -= 2) series = s2 * (1.0 / n + series);
  return exponent * ln2_high + (2.0 * s + (2.0 * s * series + exponent * ln2_low));
}

/// e^x for |x| < 700, to 2 ulp.
inline double natural_exp(double x) noexcept {
  const double octaves = std::floor(x / (ln2_high + ln2_low) + 0.5);
  const double rest = (x - octaves * ln2_high) - octaves * ln2_low;  // |rest| <= 0.347
  double series = 1.0;
  for (int n = 14; n >= 1; --n) series = 1.0 + series * (rest * (1.0 / n));
  return std::ldexp(series, static_cast<int>(octaves));
}

struct SineCosine {
  double sine = 0.0, cosine = 1.0;
};

/// Sine and cosine of |x| <= pi/2 [rad], by their power series, to 3e-16; of |x| <= pi/4 to 2 ulp.
inline SineCosine sine_cosine(double x) noexcept {
  const double x2 = x * x;
  double sine = 0.0, cosine = 0.0;  // (sin x - x) / x and cos x - 1
  for (int n = 22; n >= 2; n -= 2) {
    sine = -x2 * ((1.0 + sine) / (n * (n + 1)));
    cosine = -x2 * ((1.0 + cosine) / (n * (n - 1)));
  }
  return {x + x * sine, 1.0 + cosine};
}

/// atan(x) [rad], any x, to 2 ulp.
inline double arctangent(double x) noexcept {
  // atan(x) = pi/4 + atan((x - 1) / (x + 1)) = pi/2 - atan(1 / x): what is left is at most tan(pi/8).
  constexpr double eighth = 0.41421356237309504880;
  const double size = std::abs(x);
  double offset = 0.0, t = size;
  if (size > 1.0 / eighth) {
    offset = 0.5 * pi;
    t = -1.0 / size;
  } else if (size > eighth) {
    offset = 0.25 * pi;
    t = (size - 1.0) / (size + 1.0);
  }
  const double t2 = t * t;
  double series = 0.0;
  for (int n = 43; n >= 3; n -= 2) series = t2 * (1.0 / n - series);
  return std::copysign(offset + (t - t * series), x);
}

/// Angle of the point (x, y), not the origin, from the x axis: -pi to pi [rad], as atan2(y, x).
inline double arctangent2(double y, double x) noexcept {
  if (std::abs(y) > std::abs(x)) return std::copysign(0.5 * pi, y) - arctangent(x / y);
  return x > 0.0 ? arctangent(y / x) : std::copysign(pi, y) + arctangent(y / x);
}

/// asin(x) [rad], |x| <= 1, to 2.5 ulp.
inline double arcsine(double x) noexcept {
  // asin(x) = pi/2 - 2 asin(sqrt((1 - x) / 2)): what is left is at most 1/2. The terms of the series have the
  // ratio (2n - 1)^2 / (2n (2n + 1)) x^2.
  const double size = std::abs(x);
  const double t = size > 0.5 ? std::sqrt(0.5 * (1.0 - size)) : size;
  const double t2 = t * t;
  double series = 0.0;
  for (int n = 26; n >= 1; --n)
    series = t2 * ((1.0 + series) * ((2.0 * n - 1.0) * (2.0 * n - 1.0) / (2.0 * n * (2.0 * n + 1.0))));
  const double small = t + t * series;
  return std::copysign(size > 0.5 ? 0.5 * pi - 2.0 * small : small, x);
}

}  // namespace wrc
