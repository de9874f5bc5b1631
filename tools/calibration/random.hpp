/// Random numbers that are the same everywhere.
#pragma once

#include <cmath>
#include <cstdint>

namespace wrc::calibration {

/// The splitmix64 generator (Steele, Lea, Flood 2014): a counter and a scrambler, so that rows can be drawn
/// in any order and every standard library gives the same numbers.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t row) : state_(seed) { state_ = bits() ^ (row << 32); }

  double uniform(double low, double high) {
    return low + (high - low) * 0x1p-53 * static_cast<double>(bits() >> 11);
  }
  double logarithmic(double low, double high) { return low * std::pow(high / low, uniform(0.0, 1.0)); }

 private:
  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

}  // namespace wrc::calibration
