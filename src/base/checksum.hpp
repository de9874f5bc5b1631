/// A number that stands for bytes: to tell configurations apart, and saved bytes that have changed. Not
/// against forgers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace wrc {

/// Eight bytes at a time; each step is a bijection of the words before it and of its own word, so that a
/// change within one word is always seen. The same on every machine for the same numbers.
class Checksum {
 public:
  void add(std::uint64_t word) {
    sum_ = (sum_ ^ word) * 0x9e3779b97f4a7c15;
    sum_ ^= sum_ >> 29;
  }
  void add(double number) {
    std::uint64_t bits = 0;
    number += 0.0;  // -0 and 0 are the same configuration
    std::memcpy(&bits, &number, sizeof bits);
    add(bits);
  }
  /// Bytes in words of eight; the last word is filled up with zeros.
  void add(const void* bytes, std::size_t count) {
    const auto* at = static_cast<const unsigned char*>(bytes);
    for (; count > 0;) {
      const std::size_t now = count < 8 ? count : 8;
      std::uint64_t word = 0;
      std::memcpy(&word, at, now);
      add(word);
      at += now;
      count -= now;
    }
  }
  std::uint64_t value() const { return sum_; }

 private:
  std::uint64_t sum_ = 0x6a09e667f3bcc908;
};

}  // namespace wrc
