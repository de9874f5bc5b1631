/// No heap, no system call, no page fault, no trap: a million steps in child processes that would not survive
/// one.
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cfenv>
#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "proof/child.hpp"
#include "proof/entries.hpp"
#include "proof/heap.hpp"
#include "proof/proofs.hpp"

namespace {

constexpr int warm_up = 64;  ///< steps before the counting: they touch every page a step needs
/// Steps from one round of all entries to the next; prime, so that the rounds meet every kind of input.
constexpr int between_entries = 67;

struct Task {
  Methods methods;
  int steps = 0;
  bool filter = true;  ///< the kernel lets a process filter its system calls
};

/// Every exception an engineer would trap. Inexact results are the rule in the harness's own arithmetic, so
/// they have a proof of their own (traps.cpp).
constexpr int trapped = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW | FE_UNDERFLOW;

/// Returns how many did not do what they should.
int run_entries(Wheel& wheel) {
  int failed = 0;
  for (const Entry& entry : all_entries()) failed += entry.call(wheel) < 0;
  return failed;
}

/// Brings in the pages below the caller, as deep as a step may go: how deep the warm-up goes depends on where
/// in a page the process's stack begins.
[[gnu::noinline]] void touch_stack() {
  volatile char deep[stack_bound];
  for (char volatile& byte : deep) byte = 0;
}

void step_quietly(void* context, Record& record) {
  const Task& task = *static_cast<const Task*>(context);
  Wheel wheel(task.methods);
  for (int i = 0; i < warm_up; ++i) {
    wheel.vary(997 * i);
    wheel.vary_laws(i);
    wheel.step();
    if (i % 16 == 0) run_entries(wheel);
  }
  touch_stack();
  // As a real-time host does. Without the right to it the warm-up has to meet every page a later step needs.
  mlockall(MCL_CURRENT);
  if (task.filter && !forbid_system_calls()) {
    record.steps = -1;
    return;
  }
  feenableexcept(trapped);
  const long heap_before = heap_calls();
  count_faults(record, -1);
  for (int i = 0; i < task.steps; ++i) {
    wheel.vary(i);
    wheel.vary_laws(i);
    record.failed_calls += wheel.step() < 0;
    if (i % between_entries == 0) record.failed_calls += run_entries(wheel);
    ++record.steps;
  }
  count_faults(record, +1);
  record.heap_calls = heap_calls() - heap_before;
  fedisableexcept(trapped);
  _exit(0);  // the wheel's memory goes with the process: freeing it would be a system call
}

// ---------------------------------------------------------------------------------- what the harness must
// notice

void do_nothing(void*, Record& record) {
  if (!forbid_system_calls()) record.steps = -1;
}

void call_the_system(void*, Record&) {
  forbid_system_calls();
  syscall(SYS_getppid);
}

void use_the_heap(void*, Record& record) {
  const long before = heap_calls();
  void* volatile block = std::malloc(16);
  std::free(block);
  record.heap_calls = heap_calls() - before;
}

void touch_a_page(void*, Record& record) {
  auto* const pages = static_cast<volatile char*>(
      mmap(nullptr, 1 << 16, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
  forbid_system_calls();
  count_faults(record, -1);
  pages[1 << 15] = 1;
  count_faults(record, +1);
}

void divide_by_zero(void*, Record&) {
  feenableexcept(trapped);
  volatile double zero = 0.0;
  volatile double infinite = 1.0 / zero;
  static_cast<void>(infinite);
}

/// False when a deliberate offence goes unnoticed.
bool harness_notices(bool filter) {
  Record heap, fault, none;
  const bool system_call = !filter || in_child(call_the_system, nullptr, none) == End::system_call;
  const bool trap = in_child(divide_by_zero, nullptr, none) == End::trap;
  const bool heap_seen = in_child(use_the_heap, nullptr, heap) == End::good && heap.heap_calls == 2;
  const bool fault_seen = in_child(touch_a_page, nullptr, fault) == End::good && fault.minor_faults == 1;
  const auto seen = [](bool noticed) { return noticed ? "noticed" : "NOT NOTICED"; };
  std::printf("deliberate offences: system call %s, malloc and free %s, page fault %s, division by zero %s\n",
              seen(system_call), seen(heap_seen), seen(fault_seen), seen(trap));
  return system_call && trap && heap_seen && fault_seen;
}

const char* name_of(End end) {
  switch (end) {
    case End::good:
      return "quiet";
    case End::system_call:
      return "KILLED: SYSTEM CALL";
    case End::trap:
      return "KILLED: FLOATING-POINT TRAP";
    default:
      return "DIED";
  }
}

}  // namespace

bool prove_quiet(int steps) {
  Record record;
  const bool filter = in_child(do_nothing, nullptr, record) == End::good;
  if (!filter)
    std::printf("this kernel or container lets no process filter its system calls: THEY ARE NOT LOOKED AT\n");
  if (!harness_notices(filter)) return false;
  const std::vector<Methods> all = all_methods();
  const int each = (steps + static_cast<int>(all.size()) - 1) / static_cast<int>(all.size());
  long total = 0;
  int loud = 0;
  std::printf("%-48s %9s %6s %6s %7s\n", "methods", "steps", "heap", "faults", "failed");
  for (const Methods& methods : all) {
    Task task{methods, each, filter};
    Record seen;
    const End end = in_child(step_quietly, &task, seen);
    const long faults = seen.minor_faults + seen.major_faults;
    const bool good = end == End::good && seen.steps == each && seen.heap_calls == 0 && faults == 0 &&
                      seen.failed_calls == 0;
    total += seen.steps;
    loud += !good;
    std::printf("%-48s %9ld %6ld %6ld %7ld  %s\n", names_of(methods).c_str(), seen.steps, seen.heap_calls,
                faults, seen.failed_calls, end == End::good && !good ? "NOT QUIET" : name_of(end));
  }
  std::printf(
      "%ld steps, every %dth with every other entry: %d of %d combinations made a heap call, a system call, "
      "a "
      "page fault or a floating-point trap\n",
      total, between_entries, loud, static_cast<int>(all.size()));
  return loud == 0;
}
