// Linux, x86-64 and aarch64.
#include "proof/child.hpp"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <new>

namespace {
#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#endif
constexpr int thread_only = 1;  // RUSAGE_THREAD, which nothing but this file asks for
}  // namespace

bool forbid_system_calls() {
  constexpr auto number = static_cast<std::uint32_t>(offsetof(seccomp_data, nr));
  constexpr auto machine = static_cast<std::uint32_t>(offsetof(seccomp_data, arch));
  constexpr auto first_argument = static_cast<std::uint32_t>(offsetof(seccomp_data, args));
  sock_filter program[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, machine),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, architecture, 0, 6),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, number),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_write, 5, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_exit_group, 4, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_getrusage, 0, 2),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, first_argument),  // its low half on these little-endian machines
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, thread_only, 1, 0),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog filter = {sizeof program / sizeof *program, program};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

void count_faults(Record& record, int sign) {
  rusage usage;
  getrusage(static_cast<__rusage_who_t>(thread_only), &usage);
  record.minor_faults += sign * usage.ru_minflt;
  record.major_faults += sign * usage.ru_majflt;
}

End in_child(void (*work)(void*, Record&), void* context, Record& record) {
  constexpr int exit_no_filter = 3;
  void* const shared =
      mmap(nullptr, sizeof(Record), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_POPULATE, -1, 0);
  if (shared == MAP_FAILED) return End::failed;
  auto* const seen = new (shared) Record;
  const pid_t child = fork();
  if (child == 0) {
    seen->steps = 0;  // the first touch of the shared page is a page fault of its own
    work(context, *seen);
    _exit(seen->steps < 0 ? exit_no_filter : 0);
  }
  int status = 0;
  const bool waited = child > 0 && waitpid(child, &status, 0) == child;
  record = *seen;
  munmap(shared, sizeof(Record));
  if (!waited) return End::failed;
  if (WIFSIGNALED(status)) {
    return WTERMSIG(status) == SIGSYS   ? End::system_call
           : WTERMSIG(status) == SIGFPE ? End::trap
                                        : End::failed;
  }
  if (WEXITSTATUS(status) == exit_no_filter) return End::cannot_filter;
  return WEXITSTATUS(status) == 0 ? End::good : End::failed;
}
