/// Arrays cut from one block of memory, one behind the other, each on a cache line. Without memory it counts
/// the bytes of the same cuts, so that a size and its cut are one text.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace wrc {

/// A plain value: a copy is a mark, from which a later stage cuts the same memory anew.
class Arena {
 public:
  Arena() = default;
  /// `memory`: aligned to a cache line, or nullptr to count.
  explicit Arena(void* memory) : memory_(static_cast<std::byte*>(memory)) {}

  /// An array of `count` elements; while it counts, the address of nothing_, which nobody may use.
  template <class T = double>
  T* take(std::int64_t count) {
    const std::int64_t begin = bytes_;
    constexpr std::int64_t size = sizeof(T);  // NOLINT(bugprone-sizeof-expression): of pointers, too
    bytes_ += (count * size + line - 1) / line * line;
    return reinterpret_cast<T*>(memory_ ? memory_ + begin : const_cast<std::byte*>(&nothing_));
  }

  /// An array of `count` elements for each of the pointers, in their order.
  template <class... T>
  void each(std::int64_t count, T*&... arrays) {
    ((arrays = take<T>(count)), ...);
  }

  /// Goes on behind another cut of the same memory, where that reaches further.
  void go_behind(const Arena& other) { bytes_ = std::max(bytes_, other.bytes_); }

  /// Bytes cut so far.
  std::int64_t bytes() const { return bytes_; }
  std::int64_t doubles() const { return bytes_ / static_cast<std::int64_t>(sizeof(double)); }

 private:
  static constexpr std::int64_t line = 64;  // bytes of a cache line
  alignas(64) static constexpr std::byte nothing_{};

  std::byte* memory_ = nullptr;
  std::int64_t bytes_ = 0;
};

}  // namespace wrc
