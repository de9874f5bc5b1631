/// The bits of a double, and the double of bits. C++20's bit_cast is in no standard library before that of
/// gcc 11.
#pragma once

#include <cstdint>
#include <cstring>

#include "base/in_loop.hpp"

namespace wrc {

WRC_IN_LOOP std::uint64_t bits_of(double number) noexcept {
  std::uint64_t bits;
  std::memcpy(&bits, &number, sizeof bits);
  return bits;
}

WRC_IN_LOOP double number_of(std::uint64_t bits) noexcept {
  double number;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

/// 2^exponent, -63 < exponent < 63.
constexpr double power_of_two(int exponent) noexcept {
  return exponent >= 0 ? static_cast<double>(std::uint64_t{1} << exponent)
                       : 1.0 / static_cast<double>(std::uint64_t{1} << -exponent);
}

}  // namespace wrc
