/// Where a hostile case takes its decisions from: a counter-based generator with a seed, or the bytes of a
/// fuzzer.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>

namespace hostile {

class Choices {
 public:
  /// Decisions of a generator (splitmix64, Steele et al. 2014), the same on every machine.
  explicit Choices(std::uint64_t seed) : state_(seed) {}
  /// Decisions of these bytes; zeros when they are used up.
  Choices(const std::uint8_t* bytes, std::size_t size) : bytes_(bytes), size_(size) {}

  /// One of 0 .. count - 1.
  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(bits() % count); }
  bool one_in(std::uint32_t count) { return below(count) == count - 1; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// Every order of magnitude alike; both positive. Now and then exactly an end.
  double magnitude(double low, double high) {
    switch (below(16)) {
      case 14:
        return low;
      case 15:
        return high;
      default:
        return std::fmin(high, std::fmax(low, low * std::pow(high / low, unit())));
    }
  }
  double signed_magnitude(double low, double high) {
    const double sign = one_in(2) ? -1.0 : 1.0;
    return one_in(8) ? 0.0 : sign * magnitude(low, high);
  }
  /// NaN, infinities and other numbers that no vendor should hand over.
  double poison() {
    constexpr double largest = std::numeric_limits<double>::max();
    constexpr double values[] = {std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity(),
                                 largest,
                                 -largest,
                                 std::numeric_limits<double>::denorm_min(),
                                 -0.0};
    return values[below(sizeof values / sizeof *values)];
  }

 private:
  std::uint64_t bits() {
    if (bytes_ == nullptr) {
      state_ += 0x9e3779b97f4a7c15U;
      std::uint64_t z = state_;
      z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
      z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
      return z ^ (z >> 31);
    }
    std::uint64_t value = 0;
    for (int i = 0; i < 2; ++i) value = value << 8 | (at_ < size_ ? bytes_[at_++] : 0U);
    return value;
  }
  /// 0 .. 1 inclusive.
  double unit() {
    return bytes_ == nullptr ? static_cast<double>(bits() >> 11) * 0x1p-53
                             : static_cast<double>(bits()) / 65535.0;
  }

  std::uint64_t state_ = 0;
  const std::uint8_t* bytes_ = nullptr;
  std::size_t size_ = 0, at_ = 0;
};

}  // namespace hostile
