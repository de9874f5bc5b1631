/// What docs/realtime.md says, proven on the shared library as shipped:
///     realtime_proof [STEPS]           everything that can fail; STEPS (1000000) for the quiet steps
///     realtime_proof quiet [STEPS]     no heap, system call, page fault, floating-point trap
///     realtime_proof traps | stack | allocations | restore | bytes | denormals
///     realtime_proof time [STEPS]      percentiles of the step's time, what the machine adds, what
///                                      denormals cost
/// One malloc for the whole program counts what the library asks for (heap.cpp).
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "proof/proofs.hpp"

namespace {

struct Proof {
  const char* command;
  const char* title;
  bool (*prove)(int steps);
};

constexpr Proof proofs[] = {
    {"quiet", "steps without heap, system calls, page faults and traps", prove_quiet},
    {"traps", "a host that traps floating-point exceptions", prove_no_traps},
    {"stack", "use of the stack", prove_stack_bound},
    {"allocations", "creation without memory", [](int) { return prove_failed_allocations(); }},
    {"restore", "save and restore", [](int) { return prove_restore(); }},
    {"bytes", "bytes of saved states", prove_equal_bytes},
    {"denormals", "creepages that fade out", [](int) { return prove_no_denormal_creepages(); }},
};

}  // namespace

int main(int count, char** arguments) {
  std::setvbuf(stdout, nullptr, _IOLBF, 4096);
  std::string command = count > 1 ? arguments[1] : "all";
  int steps = 1000000;
  if (count > 2) steps = std::atoi(arguments[2]);
  if (count == 2 && std::atoi(arguments[1]) > 0) {
    steps = std::atoi(arguments[1]);
    command = "all";
  }
  try {
    if (command == "time") {
      print_latency(steps);
      std::printf("\n");
      print_denormals();
      return 0;
    }
    int passed = 0, failed = 0;
    for (const Proof& proof : proofs) {
      if (command != "all" && command != proof.command) continue;
      std::printf("== %s\n", proof.title);
      const bool good = proof.prove(steps);
      ++(good ? passed : failed);
      std::printf("%s\n\n", good ? "proven" : "NOT PROVEN");
    }
    std::printf("%d passed, %d failed\n", passed, failed);
    return failed == 0 && passed > 0 ? 0 : 1;
  } catch (const std::exception& failure) {
    std::printf("%s\n", failure.what());
    return 1;
  }
}
