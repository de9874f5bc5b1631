/// A struct as callers with other headers than the library's hand it over: larger or smaller, in memory of
/// exactly its struct_size.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>

#include "abi/generated/members.hpp"
#include "choices.hpp"

namespace hostile {

template <typename Struct>
class OfAnotherHeader {
 public:
  /// Mostly a newer header with members this library does not know, 0 or set; else sizes that none has.
  OfAnotherHeader(Choices& choices, const Struct& value) {
    constexpr std::uint32_t ours = sizeof(Struct);
    switch (choices.below(8)) {
      case 0:
        size_ = choices.below(ours);
        break;
      case 1:
        size_ = choices.below(4 * ours);
        break;
      case 2:
        size_ = ours + newest;
        break;
      case 3:
        size_ = ours + newest + 1 + choices.below(1000);
        break;
      case 4:
        size_ = ours + 1;
        break;
      default:
        size_ = ours + 8 * (1 + choices.below(newest / 8));
    }
    memory_ = std::make_unique<unsigned char[]>(std::max<std::size_t>(size_, sizeof size_));
    std::memcpy(memory_.get(), &value, std::min(size_, ours));
    std::memcpy(memory_.get(), &size_, sizeof size_);
    if (size_ <= ours || !choices.one_in(2)) return;
    memory_[ours + choices.below(size_ - ours)] = static_cast<unsigned char>(1 + choices.below(255));
    set_beyond_ = true;
  }

  Struct* get() { return reinterpret_cast<Struct*>(memory_.get()); }
  std::uint32_t size() const { return size_; }

  /// Sizes that the library honours: from the first version of the struct on, up to 1024 bytes more.
  bool has_a_size() const {
    return size_ >= wrc::abi::Description<Struct>::first && size_ <= sizeof(Struct) + newest;
  }
  /// As an input: what the library does not know must be 0.
  bool is_readable() const { return has_a_size() && !set_beyond_; }
  /// As a result: all behind struct_size is that of `value`, and what the library does not know is 0.
  bool holds(const Struct& value) const {
    const std::size_t known = std::min<std::size_t>(size_, sizeof value);
    return std::memcmp(memory_.get() + sizeof size_, reinterpret_cast<const char*>(&value) + sizeof size_,
                       known - sizeof size_) == 0 &&
           std::all_of(memory_.get() + known, memory_.get() + size_,
                       [](unsigned char byte) { return byte == 0; });
  }

 private:
  static constexpr std::uint32_t newest = 1024;
  std::uint32_t size_ = 0;
  bool set_beyond_ = false;
  std::unique_ptr<unsigned char[]> memory_;
};

}  // namespace hostile
