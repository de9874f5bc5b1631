/// No system call in any step or stage call of the shared library: a child process has the kernel kill it at
/// the first call other than write and exit, and then steps through every method.
///
/// Linux, x86-64 and aarch64. Skipped (exit status 77) where the kernel does not let a process filter itself.
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <initializer_list>

#include "realtime/varied_run.hpp"
#include "wrc/wrc.h"

namespace {

#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#endif
constexpr int skipped = 77;  // ctest's SKIP_RETURN_CODE
constexpr int exit_no_filter = 3;
constexpr int exit_failed = 4;

/// From here on the kernel allows write, exit and exit_group, and kills the process at anything else.
bool forbid_system_calls() {
  constexpr auto number = static_cast<std::uint32_t>(offsetof(seccomp_data, nr));
  constexpr auto machine = static_cast<std::uint32_t>(offsetof(seccomp_data, arch));
  sock_filter program[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, machine),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, architecture, 0, 4),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, number),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_write, 3, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_exit_group, 2, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_exit, 1, 0),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog filter = {sizeof program / sizeof *program, program};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0;
}

/// How many calls failed that should not have.
int use(const wrc_model* model, wrc_contact* contact, bool fields, void* saved, std::uint64_t bytes) {
  VariedRun run;
  run.fields = fields;
  for (int i = 0; i < 100; ++i) {
    run.vary(0.1 * i, i);
    run.failures += wrc_contact_save(contact, saved, bytes) < 0;
    run.step(contact);
    run.failures += wrc_contact_restore(contact, saved, bytes) < 0;
    run.stages(model, contact);
  }
  return run.failures;
}

enum class End { good, killed, cannot_filter, failed };

/// Runs `work` in a child under the filter.
template <typename Work>
End in_filtered_child(Work&& work) {
  const pid_t child = fork();
  if (child == 0) {
    if (!forbid_system_calls()) _exit(exit_no_filter);
    _exit(work() == 0 ? 0 : exit_failed);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) return End::failed;
  if (WIFSIGNALED(status)) return WTERMSIG(status) == SIGSYS ? End::killed : End::failed;
  if (WEXITSTATUS(status) == exit_no_filter) return End::cannot_filter;
  return WEXITSTATUS(status) == 0 ? End::good : End::failed;
}

}  // namespace

int main() {
  // The harness itself: it lets arithmetic through and catches the most harmless system call there is.
  const End idle = in_filtered_child([] { return 0; });
  if (idle == End::cannot_filter) {
    std::printf("skipped: this kernel or container lets no process filter its system calls\n");
    return skipped;
  }
  const End caught = in_filtered_child([] { return static_cast<int>(syscall(SYS_getppid) == 0); });
  if (idle != End::good || caught != End::killed) {
    std::printf("the filter does not work: idle child %d, child with a system call %d\n",
                static_cast<int>(idle), static_cast<int>(caught));
    return 1;
  }
  int passed = 0, failed = 0;
  wrc_profile wheel = made<wrc_profile>(wrc_profile_init), rail = made<wrc_profile>(wrc_profile_init);
  wheel.kind = WRC_PROFILE_S1002;
  rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  for (int32_t normal = WRC_NORMAL_HERTZ; normal <= WRC_NORMAL_STRIP_HALFSPACE; ++normal) {
    for (int32_t tangential = WRC_TANGENTIAL_FASTSIM; tangential <= WRC_TANGENTIAL_COARSE_HALFSPACE;
         ++tangential) {
      wrc_config config = made<wrc_config>(wrc_config_init);
      config.normal_method = normal;
      config.tangential_method = tangential;
      config.force_table = WRC_FORCE_TABLE;
      config.wheel = &wheel;
      config.rail = &rail;
      wrc_model* model = nullptr;
      wrc_contact* contact = nullptr;
      std::uint64_t bytes = 0, alignment = 0;
      if (wrc_model_create(&config, nullptr, &model) < 0 ||
          wrc_contact_create(model, nullptr, &contact) < 0 ||
          wrc_contact_size(model, &bytes, &alignment) < 0) {
        std::printf("cannot create\n");
        return 1;
      }
      auto* saved = new char[bytes]();
      const bool fields = tangential != WRC_TANGENTIAL_TABLE;
      const End end = in_filtered_child([&] { return use(model, contact, fields, saved, bytes); });
      ++(end == End::good ? passed : failed);
      if (end != End::good)
        std::printf("normal method %d, tangential method %d: %s\n", normal, tangential,
                    end == End::killed ? "made a system call" : "failed");
      delete[] saved;
      wrc_contact_destroy(contact);
      wrc_model_destroy(model);
    }
  }
  std::printf("%d passed, %d failed\n", passed, failed);
  return failed == 0 ? 0 : 1;
}
