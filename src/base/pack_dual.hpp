/// Numbers with derivatives (base/dual.hpp) in the registers of the instruction set that this unit is
/// compiled for: the same operations on every element, so that the bits are those of Dual.
#pragma once

#include "base/dual.hpp"
#include "base/pack.hpp"

namespace wrc::simd {
namespace {

template <std::size_t n>
struct PackDual {
  static constexpr std::size_t inputs = n, vectors = n / abreast, rest = n % abreast;
  template <std::size_t m>
  using Few = PackDual<m>;

  double value;
  Columns wide[vectors > 0 ? vectors : 1];
  double single[rest > 0 ? rest : 1];  ///< the derivatives behind those in vectors

  PackDual() = default;
  // Vector by vector: gcc 12 copies structs in pieces of 16 bytes, which a load of 32 must wait for.
  PackDual(const PackDual& x) { *this = x; }
  PackDual& operator=(const PackDual& x) {
    value = x.value;
    for (std::size_t k = 0; k < vectors; ++k) wide[k] = x.wide[k];
    for (std::size_t k = 0; k < rest; ++k) single[k] = x.single[k];
    return *this;
  }
  PackDual(double constant) : value(constant) {  // NOLINT: constants mix freely
    for (std::size_t k = 0; k < vectors; ++k) wide[k] = in_all_columns(0.0);
    for (std::size_t k = 0; k < rest; ++k) single[k] = 0.0;
  }

  static PackDual input(double v, std::size_t k) {
    double of[n + 1] = {};
    of[0] = v;
    of[k + 1] = 1.0;
    return load(of);
  }
  /// The value, then the derivatives: a Dual in memory.
  static PackDual load(const double* from) {
    PackDual x;
    x.value = from[0];
    for (std::size_t k = 0; k < vectors; ++k) x.wide[k] = load_columns(from + 1 + k * abreast);
    for (std::size_t k = 0; k < rest; ++k) x.single[k] = from[1 + vectors * abreast + k];
    return x;
  }
  void store(double* to) const {
    to[0] = value;
    for (std::size_t k = 0; k < vectors; ++k) store_columns(to + 1 + k * abreast, wide[k]);
    for (std::size_t k = 0; k < rest; ++k) to[1 + vectors * abreast + k] = single[k];
  }
  double derivative(std::size_t k) const {
    return k < vectors * abreast ? wide[k / abreast][k % abreast] : single[k - vectors * abreast];
  }

  PackDual chain(double f, double slope) const {
    return made(
        f, [slope](auto x) { return slope * x; }, *this);
  }
  void add_derivatives(double factor, const PackDual& x) {
    *this = made(
        value, [factor](auto own, auto other) { return own + factor * other; }, *this, x);
  }

  friend PackDual operator+(const PackDual& a, const PackDual& b) {
    return made(
        a.value + b.value, [](auto x, auto y) { return x + y; }, a, b);
  }
  friend PackDual operator-(const PackDual& a, const PackDual& b) {
    return made(
        a.value - b.value, [](auto x, auto y) { return x - y; }, a, b);
  }
  friend PackDual operator*(const PackDual& a, const PackDual& b) {
    return made(
        a.value * b.value, [v = a.value, w = b.value](auto x, auto y) { return x * w + v * y; }, a, b);
  }
  friend PackDual operator/(const PackDual& a, const PackDual& b) {
    const double inverse = 1.0 / b.value, q = a.value / b.value;
    return made(
        q, [q, inverse](auto x, auto y) { return (x - q * y) * inverse; }, a, b);
  }
  PackDual& operator+=(const PackDual& b) { return *this = *this + b; }

  friend PackDual operator+(double a, const PackDual& b) { return b.chain(a + b.value, 1.0); }
  friend PackDual operator-(double a, const PackDual& b) { return b.chain(a - b.value, -1.0); }
  friend PackDual operator*(double a, const PackDual& b) { return b.chain(a * b.value, a); }
  friend PackDual operator-(const PackDual& a, double b) { return a.chain(a.value - b, 1.0); }
  friend PackDual operator*(const PackDual& a, double b) { return a.chain(a.value * b, b); }
  friend PackDual operator/(const PackDual& a, double b) { return a.chain(a.value / b, 1.0 / b); }

 private:
  template <class F, class... Duals>
  static PackDual made(double value, const F& f, const Duals&... of) {
    PackDual r;
    r.value = value;
    for (std::size_t k = 0; k < vectors; ++k) r.wide[k] = f(of.wide[k]...);
    for (std::size_t k = 0; k < rest; ++k) r.single[k] = f(of.single[k]...);
    return r;
  }
};

template <std::size_t n>
double value_of(const PackDual<n>& a) {
  return a.value;
}
template <std::size_t n>
PackDual<n> root(const PackDual<n>& a) {
  const double r = __builtin_sqrt(a.value);
  return a.chain(r, r > 0.0 ? 0.5 / r : 0.0);
}
template <std::size_t n>
PackDual<n> magnitude(const PackDual<n>& a) {
  return a.value < 0.0 ? a.chain(-a.value, -1.0) : a;
}
template <std::size_t n>
PackDual<n> larger(const PackDual<n>& a, const PackDual<n>& b) {
  return a.value > b.value ? a : b;
}
template <std::size_t n>
PackDual<n> smaller(const PackDual<n>& a, const PackDual<n>& b) {
  return a.value < b.value ? a : b;
}
template <std::size_t n>
PackDual<n> select(bool which, const PackDual<n>& yes, const PackDual<n>& no) {
  return which ? yes : no;
}

}  // namespace
}  // namespace wrc::simd
