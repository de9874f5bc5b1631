/// The opaque handles: a small header that knows where the memory came from, then the C++ object behind it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "contact/model.hpp"
#include "contact/state.hpp"
#include "wrc/wrc.h"

/// Both handles begin with a tag, so that a stale or foreign pointer is refused as long as its memory can be
/// read.
struct alignas(wrc::contact::block_alignment) wrc_model {
  std::uint64_t tag;
  void (*release)(void* user, void* memory);  // NULL: the memory is the caller's
  void* user;
  wrc::contact::Model* model;
};

struct alignas(wrc::contact::block_alignment) wrc_contact {
  std::uint64_t tag;
  void (*release)(void* user, void* memory);
  void* user;
  wrc::contact::Contact* contact;
};

namespace wrc::abi {

inline constexpr std::uint64_t model_tag = 0x6c65646f6d637277;    // "wrcmodel"
inline constexpr std::uint64_t contact_tag = 0x7463746e6f637277;  // "wrcontct"

inline bool valid(const wrc_model* handle) { return handle != nullptr && handle->tag == model_tag; }
inline bool valid(const wrc_contact* handle) { return handle != nullptr && handle->tag == contact_tag; }

/// Keeps the outcome of a call for wrc_contact_last_error(). `function` is its name: of a call with nothing
/// to say it is not kept, so that states saved before and after a call that only reads are equal.
inline std::int32_t keep(wrc_contact& handle, const char* function, const Fault& outcome) {
  handle.contact->last = outcome;
  handle.contact->last.call = outcome.status == WRC_OK ? nullptr : function;
  return outcome.status;
}

/// Memory for create: from the caller's allocator, or aligned_alloc and free.
Fault allocate(const wrc_allocator* allocator, std::size_t bytes, void*& memory, wrc_allocator& source);

}  // namespace wrc::abi
