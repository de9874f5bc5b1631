/// A hash of results in which every bit counts: 0 and -0 differ, and so do two numbers one ulp apart.
#pragma once

#include <bit>
#include <cstdint>

class Hash {
 public:
  void add(std::uint64_t word) {
    // The finaliser of MurmurHash3 over state and word: integer arithmetic, the same everywhere.
    state_ = (state_ ^ word) * 0xff51afd7ed558ccdU;
    state_ ^= state_ >> 33;
    state_ *= 0xc4ceb9fe1a85ec53U;
    state_ ^= state_ >> 29;
  }
  void add(std::int32_t number) { add(static_cast<std::uint64_t>(static_cast<std::uint32_t>(number))); }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }

  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0x9e3779b97f4a7c15U;
};
