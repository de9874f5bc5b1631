/// The floating-point environment during a call: the host's is saved, ours is set, the host's is restored.
///
/// Hosts trap floating-point exceptions, set flush-to-zero or another rounding mode; the library's results
/// must not depend on that and its speculative lanes must not fire the host's traps. Only the control
/// register of the vector unit matters: no x87 arithmetic is compiled for x86-64.
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
  FloatingPointScope() : saved_(_mm_getcsr()) { _mm_setcsr(0x1f80U); }
  ~FloatingPointScope() { _mm_setcsr(saved_); }

 private:
  std::uint32_t saved_;
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
#else
#error "name this processor's floating-point control register here"
#endif

 public:
  FloatingPointScope(const FloatingPointScope&) = delete;
  FloatingPointScope& operator=(const FloatingPointScope&) = delete;
};

}  // namespace wrc::abi
