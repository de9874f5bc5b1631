/// Forward-mode differentiation: a number and its derivatives with respect to n inputs.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "base/number.hpp"

namespace wrc {

/// Calculations on lists of numbers, two at a time: element by element, so that the bits are those of one at
/// a time. `f` takes as many numbers, or pairs of them, as there are lists.
namespace pairwise {

typedef double Two __attribute__((vector_size(16)));

inline Two load(const double* a) {
  Two two;
  __builtin_memcpy(&two, a, sizeof two);
  return two;
}

inline void store(Two two, double* a) { __builtin_memcpy(a, &two, sizeof two); }

template <std::size_t n, class F, class... Lists>
void each(double* result, const F& f, const Lists*... lists) {
  std::size_t k = 0;
  for (; k + 2 <= n; k += 2) store(f(load(lists + k)...), result + k);
  if constexpr (n % 2 == 1) result[k] = f(lists[k]...);
}

/// sum += factor * a.
template <std::size_t n>
void add(double factor, const double* a, double* sum) {
  each<n>(
      sum, [factor](auto x, auto y) { return x + factor * y; }, sum, a);
}

}  // namespace pairwise

/// Operators and functions of numbers with derivatives, in memory (Dual) or in the registers of an
/// instruction set (base/pack_dual.hpp). `made(value, f, of...)` is the number whose derivatives are f of
/// those of others. A root of zero has derivative zero here, as its argument is then clipped or not used.
template <class Number>
struct DualOperators {
  /// f(x) from its value and f'(x).
  Number chain(double f, double slope) const {
    return Number::made(
        f, [slope](auto x) { return slope * x; }, static_cast<const Number&>(*this));
  }

  friend Number operator+(const Number& a, const Number& b) {
    return Number::made(
        a.value + b.value, [](auto x, auto y) { return x + y; }, a, b);
  }
  friend Number operator-(const Number& a, const Number& b) {
    return Number::made(
        a.value - b.value, [](auto x, auto y) { return x - y; }, a, b);
  }
  friend Number operator*(const Number& a, const Number& b) {
    return Number::made(
        a.value * b.value, [v = a.value, w = b.value](auto x, auto y) { return x * w + v * y; }, a, b);
  }
  friend Number operator/(const Number& a, const Number& b) {
    const double inverse = 1.0 / b.value, q = a.value / b.value;
    return Number::made(
        q, [q, inverse](auto x, auto y) { return (x - q * y) * inverse; }, a, b);
  }
  friend Number& operator+=(Number& a, const Number& b) { return a = a + b; }

  // with constants, which have no derivatives
  friend Number operator+(double a, const Number& b) { return b.chain(a + b.value, 1.0); }
  friend Number operator-(double a, const Number& b) { return b.chain(a - b.value, -1.0); }
  friend Number operator*(double a, const Number& b) { return b.chain(a * b.value, a); }
  friend Number operator+(const Number& a, double b) { return a.chain(a.value + b, 1.0); }
  friend Number operator-(const Number& a, double b) { return a.chain(a.value - b, 1.0); }
  friend Number operator*(const Number& a, double b) { return a.chain(a.value * b, b); }
  friend Number operator/(const Number& a, double b) { return a.chain(a.value / b, 1.0 / b); }
  friend Number operator-(const Number& a) { return a.chain(-a.value, -1.0); }

  friend double value_of(const Number& a) { return a.value; }
  friend Number root(const Number& a) {
    const double r = wrc::root(a.value);
    return a.chain(r, r > 0.0 ? 0.5 / r : 0.0);
  }
  friend Number magnitude(const Number& a) { return a.value < 0.0 ? -a : a; }
  friend Number larger(const Number& a, const Number& b) { return a.value > b.value ? a : b; }
  friend Number smaller(const Number& a, const Number& b) { return a.value < b.value ? a : b; }
  friend Number select(bool which, const Number& yes, const Number& no) { return which ? yes : no; }
};

template <std::size_t n>
struct Dual : DualOperators<Dual<n>> {
  static constexpr std::size_t inputs = n;
  template <std::size_t m>
  using Few = Dual<m>;

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

  double derivative(std::size_t k) const { return d[k]; }

  /// Adds to the derivatives `factor` times those of x.
  template <std::size_t m>
  void add_derivatives(double factor, const Dual<m>& x) {
    static_assert(m <= n);
    pairwise::add<m>(factor, x.d.data(), d.data());
  }

  template <class F, class... Duals>
  static Dual made(double value, const F& f, const Duals&... of) {
    Dual r(value);
    pairwise::each<n>(r.d.data(), f, of.d.data()...);
    return r;
  }
  /// The same where `few` has derivatives by the first m inputs: those by the others are `alone` of this one.
  template <class F, class G, std::size_t m>
  static Dual made_with_few(double value, const F& both, const G& alone, const Dual& all,
                            const Dual<m>& few) {
    static_assert(m % 2 == 0);
    Dual r(value);
    pairwise::each<m>(r.d.data(), both, all.d.data(), few.d.data());
    pairwise::each<n - m>(r.d.data() + m, alone, all.d.data() + m);
    return r;
  }
};

/// Is F a number like N whose derivatives by all but the first inputs of N are zero?
template <class N, class F, class = void>
inline constexpr bool has_few_of = false;
template <class N, class F>
inline constexpr bool has_few_of<
    N, F,
    std::enable_if_t<(N::inputs > F::inputs) && std::is_same_v<F, typename N::template Few<F::inputs>>>> =
    true;

// numbers with derivatives by all inputs, and with few
template <class N, class F, std::enable_if_t<has_few_of<N, F>, int> = 0>
N operator+(const N& a, const F& b) {
  return N::made_with_few(
      a.value + b.value, [](auto x, auto y) { return x + y; }, [](auto x) { return x; }, a, b);
}
template <class N, class F, std::enable_if_t<has_few_of<N, F>, int> = 0>
N operator+(const F& a, const N& b) {
  return b + a;
}
template <class N, class F, std::enable_if_t<has_few_of<N, F>, int> = 0>
N& operator+=(N& a, const F& b) {
  return a = a + b;
}
template <class N, class F, std::enable_if_t<has_few_of<N, F>, int> = 0>
N operator-(const N& a, const F& b) {
  return N::made_with_few(
      a.value - b.value, [](auto x, auto y) { return x - y; }, [](auto x) { return x; }, a, b);
}
template <class N, class F, std::enable_if_t<has_few_of<N, F>, int> = 0>
N operator*(const N& a, const F& b) {
  return N::made_with_few(
      a.value * b.value, [v = a.value, w = b.value](auto x, auto y) { return x * w + v * y; },
      [w = b.value](auto x) { return x * w; }, a, b);
}
template <class N, class F, std::enable_if_t<has_few_of<N, F>, int> = 0>
N operator*(const F& a, const N& b) {
  return b * a;
}
template <class N, class F, std::enable_if_t<has_few_of<N, F>, int> = 0>
N operator/(const N& a, const F& b) {
  const double inverse = 1.0 / b.value, q = a.value / b.value;
  return N::made_with_few(
      q, [q, inverse](auto x, auto y) { return (x - q * y) * inverse; },
      [inverse](auto x) { return x * inverse; }, a, b);
}

/// Has a number derivatives by more than n inputs?
template <std::size_t n, class Number, class = void>
inline constexpr bool has_more_inputs = false;
template <std::size_t n, class Number>
inline constexpr bool has_more_inputs<n, Number, std::enable_if_t<(Number::inputs > n)>> = true;

/// The number itself, as decisions read it.
WRC_IN_LOOP double value_of(double a) { return a; }

}  // namespace wrc
