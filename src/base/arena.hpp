/// Arrays cut from one block of memory, one behind the other, each on a cache line. Without memory it counts
/// the bytes of the same cuts, so that a size and its cut are one text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace wrc {

/// A plain value: a copy is a mark, from which a later stage cuts the same memory anew.
class Arena {
 public:
  Arena() = default;
  /// `memory`: aligned to a cache line, not null.
  [[gnu::nonnull]] explicit Arena(void* memory) : memory_(static_cast<std::byte*>(memory)) {}

  /// An array of `count` elements; nullptr while it counts.
  template <class T = double>
  T* take(std::int64_t count) {
    const std::int64_t begin = bytes_;
    bytes_ += (count * static_cast<std::int64_t>(sizeof(T)) + line - 1) / line * line;
    return memory_ ? reinterpret_cast<T*>(memory_ + begin) : nullptr;
  }

  /// An array of `count` elements for each of the pointers.
  template <class T>
  void each(std::int64_t count, std::initializer_list<T**> arrays) {
    for (T** array : arrays) *array = take<T>(count);
  }

  /// Bytes cut so far.
  std::int64_t bytes() const { return bytes_; }
  std::int64_t doubles() const { return bytes_ / static_cast<std::int64_t>(sizeof(double)); }

 private:
  static constexpr std::int64_t line = 64;  // bytes of a cache line

  std::byte* memory_ = nullptr;
  std::int64_t bytes_ = 0;
};

}  // namespace wrc
