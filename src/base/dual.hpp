/// Forward-mode differentiation: a number and its derivatives with respect to n inputs.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "base/number.hpp"

namespace wrc {

template <std::size_t n>
struct Dual {
  double value = 0.0;
  std::array<double, n> d{};

  Dual() = default;
  Dual(double v) : value(v) {}  // NOLINT: constants mix freely with numbers that carry derivatives

  /// The k-th input itself.
  static Dual input(double v, std::size_t k) {
    Dual x(v);
    x.d[k] = 1.0;
    return x;
  }

  /// f(x) from its value and f'(x).
  Dual chain(double f, double slope) const {
    Dual r(f);
    for (std::size_t k = 0; k < n; ++k) r.d[k] = slope * d[k];
    return r;
  }

  friend Dual operator+(const Dual& a, const Dual& b) {
    Dual r(a.value + b.value);
    for (std::size_t k = 0; k < n; ++k) r.d[k] = a.d[k] + b.d[k];
    return r;
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    Dual r(a.value - b.value);
    for (std::size_t k = 0; k < n; ++k) r.d[k] = a.d[k] - b.d[k];
    return r;
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    Dual r(a.value * b.value);
    for (std::size_t k = 0; k < n; ++k) r.d[k] = a.d[k] * b.value + a.value * b.d[k];
    return r;
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double inverse = 1.0 / b.value, q = a.value / b.value;
    Dual r(q);
    for (std::size_t k = 0; k < n; ++k) r.d[k] = (a.d[k] - q * b.d[k]) * inverse;
    return r;
  }
  Dual& operator+=(const Dual& b) { return *this = *this + b; }

  // With constants, which have nothing to carry.
  friend Dual operator+(double a, const Dual& b) { return b.chain(a + b.value, 1.0); }
  friend Dual operator-(double a, const Dual& b) { return b.chain(a - b.value, -1.0); }
  friend Dual operator*(double a, const Dual& b) { return b.chain(a * b.value, a); }
  friend Dual operator+(const Dual& a, double b) { return a.chain(a.value + b, 1.0); }
  friend Dual operator-(const Dual& a, double b) { return a.chain(a.value - b, 1.0); }
  friend Dual operator*(const Dual& a, double b) { return a.chain(a.value * b, b); }
  friend Dual operator/(const Dual& a, double b) { return a.chain(a.value / b, 1.0 / b); }
  friend Dual operator-(const Dual& a) { return a.chain(-a.value, -1.0); }
};

/// The functions the kernels use, for plain numbers and for numbers with derivatives alike. A root of zero
/// has derivative zero here, as its argument is then clipped or not used.
inline double value_of(double a) { return a; }
template <std::size_t n>
double value_of(const Dual<n>& a) {
  return a.value;
}
template <std::size_t n>
Dual<n> root(const Dual<n>& a) {
  const double r = std::sqrt(a.value);
  return a.chain(r, r > 0.0 ? 0.5 / r : 0.0);
}
template <std::size_t n>
Dual<n> magnitude(const Dual<n>& a) {
  return a.value < 0.0 ? -a : a;
}
template <std::size_t n>
Dual<n> larger(const Dual<n>& a, const Dual<n>& b) {
  return a.value > b.value ? a : b;
}
template <std::size_t n>
Dual<n> smaller(const Dual<n>& a, const Dual<n>& b) {
  return a.value < b.value ? a : b;
}

}  // namespace wrc
