#include "proof/heap.hpp"

#include <atomic>
#include <cerrno>
#include <cstddef>

extern "C" {
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);
void __libc_free(void*);
}

namespace {
std::atomic<long> calls{0}, living{0}, until_failure{0};
std::atomic<bool> failed{false};

/// Counts an allocation; is it the one that fails?
bool refused() {
  ++calls;
  if (until_failure.load() == 0 || --until_failure != 0) return false;
  failed = true;
  return true;
}

void* counted(void* memory) {
  if (memory != nullptr) ++living;
  return memory;
}
}  // namespace

long heap_calls() { return calls; }
long living_blocks() { return living; }
void fail_allocation(long n) {
  failed = false;
  until_failure = n;
}
bool allocation_failed() { return failed; }

extern "C" {
void* malloc(size_t size) { return refused() ? nullptr : counted(__libc_malloc(size)); }
void* calloc(size_t count, size_t size) { return refused() ? nullptr : counted(__libc_calloc(count, size)); }
void* realloc(void* memory, size_t size) {
  if (refused()) return nullptr;
  void* const moved = __libc_realloc(memory, size);
  if (memory == nullptr) counted(moved);
  return moved;
}
void free(void* memory) {
  ++calls;
  if (memory != nullptr) --living;
  __libc_free(memory);
}
void* memalign(size_t alignment, size_t size) {
  return refused() ? nullptr : counted(__libc_memalign(alignment, size));
}
void* aligned_alloc(size_t alignment, size_t size) {
  return refused() ? nullptr : counted(__libc_memalign(alignment, size));
}
int posix_memalign(void** memory, size_t alignment, size_t size) {
  void* const block = refused() ? nullptr : counted(__libc_memalign(alignment, size));
  if (block == nullptr) return ENOMEM;
  *memory = block;
  return 0;
}
}
