/// A host that traps every floating-point exception, the inexact one too, sees none from any entry.
#include <cfenv>
#include <csetjmp>
#include <csignal>
#include <cstdio>
#include <limits>

#include "proof/entries.hpp"
#include "proof/proofs.hpp"
#include "test_config.hpp"

namespace {

sigjmp_buf after_trap;

void on_trap(int) { siglongjmp(after_trap, 1); }

/// Does a trap fire during the call? Sticky flags must not appear either: a host may poll them instead.
template <typename Call>
bool disturbs(Call&& call) {
  std::feclearexcept(FE_ALL_EXCEPT);
  if (sigsetjmp(after_trap, 1) != 0) {
    fedisableexcept(FE_ALL_EXCEPT);
    return true;
  }
  feenableexcept(FE_ALL_EXCEPT);
  call();
  fedisableexcept(FE_ALL_EXCEPT);
  return std::fetestexcept(FE_ALL_EXCEPT) != 0;
}

void refuse_configuration() {
  wrc_config config = test_config();
  char text[256];
  for (double wrong : {std::numeric_limits<double>::signaling_NaN(), 1.0 / 3.0, 1e300}) {
    config.wheel_material.shear_modulus = config.rail_material.shear_modulus = wrong;
    wrc_config_check(&config, text, sizeof text);
  }
}

}  // namespace

bool prove_no_traps(int steps) {
  struct sigaction action {};
  struct sigaction before {};
  action.sa_handler = on_trap;
  sigaction(SIGFPE, &action, &before);
  volatile double three = 3.0, third = 0.0;
  const bool notices = disturbs([&] { third = 1.0 / three; });
  std::printf("deliberate inexact division: %s\n", notices ? "noticed" : "NOT NOTICED");
  int calls = 0, disturbing = 0;
  const int stride = stride_of(steps, 4);
  int first = 0;
  for (const Methods& methods : on_every_instruction_set(all_methods())) {
    Wheel wheel(methods);
    for (int i = first++ % stride; i < 12; i += stride) {
      wheel.vary(2043 * i);
      wheel.vary_laws(i);
      for (const Entry& entry : all_entries()) {
        ++calls;
        if (!disturbs([&] { entry.call(wheel); })) continue;
        if (++disturbing > 20) continue;
        std::printf("%s with %s: A TRAP FIRED OR A FLAG STAYED\n", entry.name, names_of(methods).c_str());
      }
    }
  }
  // Creation is not for real time, but no less for hosts that trap.
  for (const Methods& methods : all_methods()) {
    ++calls;
    if (!disturbs([&] { Wheel another(methods); })) continue;
    ++disturbing;
    std::printf("creation with %s: A TRAP FIRED OR A FLAG STAYED\n", names_of(methods).c_str());
  }
  ++calls;
  if (disturbs(refuse_configuration)) {
    ++disturbing;
    std::printf("a refused configuration: A TRAP FIRED OR A FLAG STAYED\n");
  }
  sigaction(SIGFPE, &before, nullptr);
  std::printf("%d calls with all floating-point traps on, inexact included: %d disturbed the host\n", calls,
              disturbing);
  return notices && disturbing == 0;
}
