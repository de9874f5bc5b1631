/// The proofs; each prints what it found and returns whether that is as promised.
#pragma once

#include <cstddef>

#ifdef NDEBUG
inline constexpr std::size_t stack_bound =
    80 * 1024;  ///< what docs/realtime.md promises of release builds [bytes]
#else
inline constexpr std::size_t stack_bound =
    512 * 1024;  ///< without optimisation every temporary has its own place
#endif

/// Every how many-th of a proof's inputs a run of so many steps has: all from a million on, else one in
/// `shorter`, with others for the next methods.
constexpr int stride_of(int steps, int shorter) { return steps < 1000000 ? shorter : 1; }

/// Heap calls, system calls, page faults and floating-point traps in `steps` steps spread over all methods,
/// none of which may be; and that each of the four would have been noticed.
bool prove_quiet(int steps);

/// Floating-point exceptions, the inexact one too, that reach a host which traps them: every entry, every
/// method.
bool prove_no_traps(int steps);

/// Deepest use of the stack by any entry with any method, below stack_bound bytes.
bool prove_stack_bound(int steps);

/// The n-th allocation of a creation fails, for all n: WRC_ERROR_MEMORY and nothing leaked.
bool prove_failed_allocations();

/// A step repeated after wrc_contact_restore(), in the same contact and in another: the same bits.
bool prove_restore();

/// The same calls on contacts in memory with different old contents: the same bytes in the saved states.
bool prove_equal_bytes(int steps);

/// Creepages so small that their products are denormal numbers give the bits, and so the time, of none at
/// all.
bool prove_no_denormal_creepages();

/// Percentiles of the step's time over `steps` steps, and what the machine adds. Prints only.
void print_latency(int steps);

/// What denormal numbers in the input cost, as ratios. Prints only.
void print_denormals();
