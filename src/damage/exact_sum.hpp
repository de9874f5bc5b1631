/// Sums that do not depend on the order of additions: whole numbers of 128 bits.
#pragma once

#include <cmath>
#include <cstdint>

namespace wrc::damage {

/// A whole number of 128 bits in two's complement, in units of 2^-62: -2^63 .. 2^63, to 2e-19.
struct WholeNumber {
  std::uint64_t low = 0, high = 0;
};

inline constexpr double largest_summand = 0x1p62;

inline WholeNumber plus(const WholeNumber& a, const WholeNumber& b) {
  const std::uint64_t low = a.low + b.low;
  return {low, a.high + b.high + (low < b.low ? 1U : 0U)};
}

inline WholeNumber minus(const WholeNumber& a, const WholeNumber& b) {
  return {a.low - b.low, a.high - b.high - (a.low < b.low ? 1U : 0U)};
}

/// x to the unit below its amount, |x| < largest_summand.
inline WholeNumber whole(double x) {
  const double size = std::abs(x);
  const auto units = static_cast<std::int64_t>(size);
  const double rest = (size - static_cast<double>(units)) * 0x1p62;  // exact, below 2^62
  const WholeNumber amount{static_cast<std::uint64_t>(static_cast<std::int64_t>(rest)) << 2,
                           static_cast<std::uint64_t>(units)};
  return x < 0.0 ? minus({}, amount) : amount;
}

/// Did a + b leave the range on its way to `sum`?
inline bool left_range(const WholeNumber& a, const WholeNumber& b, const WholeNumber& sum) {
  return (((a.high ^ sum.high) & (b.high ^ sum.high)) >> 63) != 0;
}

inline double number(const WholeNumber& a) {
  if (a.high >> 63 != 0) {  // by its amount, whose digits are those that count
    const WholeNumber amount = minus({}, a);
    return -(static_cast<double>(amount.high) + static_cast<double>(amount.low) * 0x1p-64);
  }
  return static_cast<double>(a.high) + static_cast<double>(a.low) * 0x1p-64;
}

}  // namespace wrc::damage
