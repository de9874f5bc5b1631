/// The floating-point environment during a call: the host's is saved, ours is set, the host's is restored.
///
/// Hosts trap floating-point exceptions, set flush-to-zero or another rounding mode; the library's results
/// must not depend on that and its speculative lanes must not fire the host's traps. On x86-64 no x87
/// arithmetic is compiled: the control register of the vector unit is all, but on Windows, where the C
/// library that mingw-w64 links in has x87 code for ldexp (exact) and for the offline solver's sin, cos and
/// asinh.
#pragma once

#include <cstdint>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace wrc::abi {

class FloatingPointScope {
 public:
#if defined(__x86_64__)
  // 0x1f80: every exception masked, round to nearest, denormals kept.
  FloatingPointScope() : saved_(_mm_getcsr()) {
    _mm_setcsr(0x1f80U);
#if defined(_WIN32)
    constexpr std::uint16_t all_masked_64_bits = 0x037f;
    __asm__ volatile("fnstenv %0\n\tfldcw %1" : "=m"(x87_) : "m"(all_masked_64_bits));
#endif
  }
  ~FloatingPointScope() {
#if defined(_WIN32)
    __asm__ volatile("fldenv %0" : : "m"(x87_));
#endif
    _mm_setcsr(saved_);
  }

 private:
  std::uint32_t saved_;
#if defined(_WIN32)
  struct {
    std::uint32_t registers[7];
  } x87_;
#endif
#elif defined(__aarch64__)
  // FPCR = 0: no traps, round to nearest, denormals kept. FPSR keeps the host's sticky flags.
  FloatingPointScope() {
    asm volatile("mrs %0, fpcr" : "=r"(control_));
    asm volatile("mrs %0, fpsr" : "=r"(status_));
    asm volatile("msr fpcr, %0" : : "r"(std::uint64_t{0}));
  }
  ~FloatingPointScope() {
    asm volatile("msr fpsr, %0" : : "r"(status_));
    asm volatile("msr fpcr, %0" : : "r"(control_));
  }

 private:
  std::uint64_t control_, status_;
#elif defined(__arm__) && defined(__ARM_FP)
  // FPSCR = 0: no traps, round to nearest, denormals kept. Its sticky flags are the host's again afterwards.
  FloatingPointScope() {
    asm volatile("vmrs %0, fpscr" : "=r"(control_));
    asm volatile("vmsr fpscr, %0" : : "r"(std::uint32_t{0}));
  }
  ~FloatingPointScope() { asm volatile("vmsr fpscr, %0" : : "r"(control_)); }

 private:
  std::uint32_t control_;
#else
#error "name this processor's floating-point control register here"
#endif

 public:
  FloatingPointScope(const FloatingPointScope&) = delete;
  FloatingPointScope& operator=(const FloatingPointScope&) = delete;
};

}  // namespace wrc::abi
