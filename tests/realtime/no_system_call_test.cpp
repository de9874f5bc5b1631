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

#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>

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

template <typename Struct>
Struct made(int32_t (*init)(Struct*)) {
  Struct value{};
  value.struct_size = sizeof value;
  init(&value);
  return value;
}

/// Steps, stages, refused input, saved and restored state, fields and messages; how many calls failed that
/// should not have.
int use(wrc_contact* contact, void* saved, std::uint64_t bytes) {
  wrc_pose pose = made<wrc_pose>(wrc_pose_init);
  wrc_load load = made<wrc_load>(wrc_load_init);
  wrc_creepage creepage = made<wrc_creepage>(wrc_creepage_init);
  const wrc_friction friction = made<wrc_friction>(wrc_friction_init);
  wrc_contact_point point = made<wrc_contact_point>(wrc_contact_point_init);
  wrc_patch patch = made<wrc_patch>(wrc_patch_init);
  wrc_forces forces = made<wrc_forces>(wrc_forces_init);
  wrc_damage damage = made<wrc_damage>(wrc_damage_init);
  wrc_sensitivity sensitivity = made<wrc_sensitivity>(wrc_sensitivity_init);
  wrc_step_sensitivity step_sensitivity = made<wrc_step_sensitivity>(wrc_step_sensitivity_init);
  const wrc_input input = {sizeof input, 0, &pose, nullptr, &load, &creepage, &friction};
  wrc_output output = {sizeof output, 0, &point, &patch, &forces, &damage};
  wrc_view view = made<wrc_view>(wrc_view_init);
  char text[256];
  int failures = 0;
  for (int i = 0; i < 100; ++i) {
    const double t = 0.1 * i;
    pose.lateral = 4e-3 * std::sin(7.0 * t);
    pose.yaw = 5e-3 * std::sin(3.0 * t);
    load.prescribed = i % 4 == 3 ? WRC_PRESCRIBE_APPROACH : WRC_PRESCRIBE_LOAD;
    load.normal_force = 80e3 + 40e3 * std::sin(11.0 * t);
    load.approach = 60e-6 + 61e-6 * std::sin(5.0 * t);  // now and then apart
    creepage.longitudinal = 2e-3 * std::sin(13.0 * t);
    creepage.lateral = 2e-3 * std::cos(17.0 * t);
    creepage.spin = 0.6 * std::sin(19.0 * t);
    failures += wrc_contact_save(contact, saved, bytes) < 0;
    failures += wrc_step(contact, &input, &output) < 0;
    failures += wrc_contact_restore(contact, saved, bytes) < 0;
    failures += wrc_geometry(contact, &pose, &point) < 0;
    failures += wrc_normal(contact, nullptr, &load, &patch) < 0;
    failures += wrc_regularise(contact, nullptr, &patch) < 0;
    failures += wrc_tangential(contact, nullptr, &creepage, &friction, &forces) < 0;
    failures += wrc_damage_numbers(contact, &damage) < 0;
    failures += wrc_sensitivities(contact, &sensitivity) < 0;
    failures += wrc_step_sensitivities(contact, &step_sensitivity) < 0;
    if (forces.fn > 0.0) failures += wrc_field(contact, 0, WRC_FIELD_TRACTION_X, &view) < 0;
    creepage.spin = NAN;
    failures += wrc_step(contact, &input, &output) != WRC_ERROR_NOT_FINITE;
    failures += wrc_last_error(contact, text, sizeof text) < 0;
  }
  return failures;
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
    for (int32_t tangential = WRC_TANGENTIAL_FASTSIM; tangential <= WRC_TANGENTIAL_FASTSIM_SDEC;
         ++tangential) {
      wrc_config config = made<wrc_config>(wrc_config_init);
      config.normal_method = normal;
      config.tangential_method = tangential;
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
      const End end = in_filtered_child([&] { return use(contact, saved, bytes); });
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
