#include "base/instruction_set.hpp"

#if defined(__x86_64__) && !defined(WRC_BASELINE_ALONE)
#include <cpuid.h>
#endif

namespace wrc {

#if defined(__x86_64__) && !defined(WRC_BASELINE_ALONE)

namespace {

/// The registers the operating system saves at a task switch (XCR0); only where cpuid says OSXSAVE.
unsigned saved_registers() {
  unsigned low = 0, high = 0;
  __asm__("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
  return low;
}

}  // namespace

// Intel's manual, volume 1, chapters 14.3 and 15.2. Not __builtin_cpu_supports, which keeps a static that a
// constructor fills when the library is loaded.
InstructionSet best_instruction_set() {
  unsigned a = 0, b = 0, c = 0, d = 0;
  constexpr unsigned osxsave = 1u << 27, avx = 1u << 28;
  if (!__get_cpuid(1, &a, &b, &c, &d) || (c & osxsave) == 0 || (c & avx) == 0)
    return InstructionSet::baseline;
  const unsigned saved = saved_registers();
  [[maybe_unused]] constexpr unsigned zmm = 0xe6, avx512 = 1u << 16 | 1u << 17 | 1u << 31;  // F, DQ, VL
  constexpr unsigned ymm = 0x06, avx2 = 1u << 5;
  if (!__get_cpuid_count(7, 0, &a, &b, &c, &d) || (b & avx2) == 0 || (saved & ymm) != ymm)
    return InstructionSet::baseline;
#if !defined(WRC_WITHOUT_AVX512)
  if ((b & avx512) == avx512 && (saved & zmm) == zmm) return InstructionSet::avx512;
#endif
  return InstructionSet::avx2;
}

#else

InstructionSet best_instruction_set() { return InstructionSet::baseline; }

#endif

}  // namespace wrc
