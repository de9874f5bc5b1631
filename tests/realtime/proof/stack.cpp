/// How deep into the stack the entries reach: a painted stack, and the deepest byte whose paint is gone.
#include <pthread.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>

#include "proof/entries.hpp"
#include "proof/proofs.hpp"

namespace {

constexpr std::size_t stack_size = 256 * 1024;
constexpr unsigned char paint = 0xa5;
constexpr std::size_t own_frame = 512;  ///< room below the measuring frame for what it calls while painting

struct Measurement {
  unsigned char* lowest = nullptr;
  void (*call)(void*) = nullptr;
  void* context = nullptr;
  std::size_t depth = 0;
};

/// Paints from the bottom of the stack to just below this frame, calls, looks where the paint is gone.
void* measure(void* argument) {
  auto& m = *static_cast<Measurement*>(argument);
  auto* const here = static_cast<unsigned char*>(__builtin_frame_address(0));
  // volatile: as plain loops these would become calls of memset and memchr, with frames of their own.
  for (volatile unsigned char* p = m.lowest; p < here - own_frame; ++p) *p = paint;
  m.call(m.context);
  const volatile unsigned char* deepest = m.lowest;
  while (deepest < here && *deepest == paint) ++deepest;
  m.depth = static_cast<std::size_t>(here - deepest);
  return nullptr;
}

std::size_t depth_of(void (*call)(void*), void* context) {
  void* const memory =
      mmap(nullptr, stack_size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_STACK, -1, 0);
  Measurement m{static_cast<unsigned char*>(memory), call, context, 0};
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstack(&attributes, memory, stack_size);
  pthread_t thread;
  const bool started = pthread_create(&thread, &attributes, measure, &m) == 0;
  if (started) pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
  munmap(memory, stack_size);
  return started ? m.depth : stack_size;
}

struct Round {
  Wheel* wheel = nullptr;
  const Entry* entry = nullptr;
};

/// One entry with input that varies; the other entries before it put what it needs into the contact.
void run_entry(void* context) {
  const auto& round = *static_cast<Round*>(context);
  round.entry->call(*round.wheel);
}

void use_ten_thousand_bytes(void*) {
  volatile unsigned char room[10000];
  for (volatile unsigned char& byte : room) byte = 1;
}

}  // namespace

bool prove_stack_bound(int steps) {
  const std::size_t nothing = depth_of([](void*) {}, nullptr);
  const std::size_t known = depth_of(use_ten_thousand_bytes, nullptr);
  const bool notices = known >= 10000 && known < 10000 + own_frame + 256;
  std::printf("a call that does nothing: %zu bytes; one with an array of 10000 bytes: %zu%s\n", nothing,
              known, notices ? "" : " (THE MEASUREMENT IS WRONG)");
  struct Deepest {
    std::size_t bytes = 0;
    std::string methods;
  };
  std::map<std::string, Deepest> by_entry;
  std::size_t deepest = 0;
  const int stride = stride_of(steps, 3);
  int first = 0;
  for (const Methods& small : all_methods()) {
    Methods methods = small;
    methods.strips = 60;
    Wheel wheel(methods);
    for (int i = first++ % stride; i < 6; i += stride) {
      wheel.vary(1531 * i);
      wheel.vary_laws(i);
      for (const Entry& entry : all_entries()) {
        Round round{&wheel, &entry};
        const std::size_t depth = depth_of(run_entry, &round);
        Deepest& known_depth = by_entry[entry.name];
        if (depth > known_depth.bytes) known_depth = {depth, names_of(methods)};
        deepest = std::max(deepest, depth);
      }
    }
  }
  for (const auto& [name, depth] : by_entry)
    std::printf("%-34s %7zu bytes  %s\n", name.c_str(), depth.bytes, depth.methods.c_str());
  std::printf("deepest use of the stack: %zu bytes, promised: %zu\n", deepest, stack_bound);
  return notices && deepest <= stack_bound;
}
