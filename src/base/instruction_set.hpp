/// Which instruction sets the kernels are compiled for, and which of them this processor has.
#pragma once

namespace wrc {

/// Ordered: each includes those before it.
enum class InstructionSet {
  baseline,  ///< present on every processor of the architecture: SSE2 on x86-64, NEON on AArch64
  avx2,      ///< x86-64 with AVX2
  avx512,    ///< x86-64 with AVX-512 F, DQ, VL
};

/// The widest that is compiled and that this processor and its operating system have. Asks the processor anew
/// each time; at init.
InstructionSet best_instruction_set();

}  // namespace wrc
