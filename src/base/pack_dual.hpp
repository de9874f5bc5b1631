/// Numbers with derivatives (base/dual.hpp) in the registers of the instruction set that this unit is
/// compiled for. Each element has the operations of Dual, so the bits are the same.
#pragma once

#include "base/dual.hpp"
#include "base/pack.hpp"

namespace wrc::simd {
namespace {

template <std::size_t n>
struct PackDual : DualOperators<PackDual<n>> {
  static constexpr std::size_t inputs = n, vectors = n / abreast, rest = n % abreast;
  template <std::size_t m>
  using Few = PackDual<m>;

  double value;
  Columns wide[vectors > 0 ? vectors : 1];
  double single[rest > 0 ? rest : 1];  ///< the derivatives behind those in vectors

  PackDual() = default;
  // Copies go vector by vector, onto themselves, too. gcc 12 copies structs in pieces of 16 bytes, for which
  // a load of 32 waits.
  PackDual(const PackDual& x) : DualOperators<PackDual>() { *this = x; }
  PackDual& operator=(const PackDual& x) {  // NOLINT(bugprone-unhandled-self-assignment)
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
  /// Reads a Dual in memory: the value, then the derivatives.
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

  template <std::size_t m>
  void add_derivatives(double factor, const PackDual<m>& x) {
    const auto add = [factor](auto own, auto other) { return own + factor * other; };
    if constexpr (m == n)
      *this = made(value, add, *this, x);
    else
      *this = made_with_few(
          value, add, [](auto own) { return own; }, *this, x);
  }

  template <class F, class... Duals>
  static PackDual made(double value, const F& f, const Duals&... of) {
    PackDual r;
    r.value = value;
    for (std::size_t k = 0; k < vectors; ++k) r.wide[k] = f(of.wide[k]...);
    for (std::size_t k = 0; k < rest; ++k) r.single[k] = f(of.single[k]...);
    return r;
  }
  template <class F, class G, std::size_t m>
  static PackDual made_with_few(double value, const F& both, const G& alone, const PackDual& all,
                                const PackDual<m>& few) {
    static_assert(m % abreast == 0 && n % abreast == 0 && m < n);
    PackDual r;
    r.value = value;
    for (std::size_t k = 0; k < m / abreast; ++k) r.wide[k] = both(all.wide[k], few.wide[k]);
    for (std::size_t k = m / abreast; k < vectors; ++k) r.wide[k] = alone(all.wide[k]);
    return r;
  }
};

}  // namespace
}  // namespace wrc::simd
