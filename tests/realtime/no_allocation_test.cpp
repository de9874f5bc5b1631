/// No heap allocation in any step or stage call of the shared library, for every method.
///
/// This program defines malloc and its family itself, so every call from libwrc arrives here and is counted.
/// The library carries its own copy of operator new (libstdc++ is linked into it), which ends in malloc too.
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>

#include "realtime/varied_run.hpp"
#include "wrc/wrc.h"

extern "C" {
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);
void __libc_free(void*);
}

namespace {
long heap_calls = 0;
}

extern "C" {
void* malloc(size_t size) { return ++heap_calls, __libc_malloc(size); }
void* calloc(size_t count, size_t size) { return ++heap_calls, __libc_calloc(count, size); }
void* realloc(void* memory, size_t size) { return ++heap_calls, __libc_realloc(memory, size); }
void free(void* memory) { ++heap_calls, __libc_free(memory); }
void* memalign(size_t alignment, size_t size) { return ++heap_calls, __libc_memalign(alignment, size); }
void* aligned_alloc(size_t alignment, size_t size) { return ++heap_calls, __libc_memalign(alignment, size); }
int posix_memalign(void** memory, size_t alignment, size_t size) {
  ++heap_calls;
  *memory = __libc_memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}
}
void* operator new(size_t size) { return malloc(size); }
void operator delete(void* memory) noexcept { free(memory); }
void operator delete(void* memory, size_t) noexcept { free(memory); }

namespace {

constexpr int steps_per_combination = 10000;

struct Choice {
  const char* name;
  int32_t value;
};
constexpr Choice normals[] = {{"hertz", WRC_NORMAL_HERTZ},
                              {"kik_piotrowski", WRC_NORMAL_KIK_PIOTROWSKI},
                              {"ekp", WRC_NORMAL_EKP},
                              {"ekp_ellipse", WRC_NORMAL_EKP_ELLIPSE},
                              {"analyn", WRC_NORMAL_ANALYN},
                              {"stripes", WRC_NORMAL_STRIPES},
                              {"strip_halfspace", WRC_NORMAL_STRIP_HALFSPACE}};
constexpr Choice tangentials[] = {{"fastsim", WRC_TANGENTIAL_FASTSIM},
                                  {"fastsim_eqe", WRC_TANGENTIAL_FASTSIM_EQE},
                                  {"fastsim_eql", WRC_TANGENTIAL_FASTSIM_EQL},
                                  {"fastsim_sdec", WRC_TANGENTIAL_FASTSIM_SDEC},
                                  {"strip_fastsim", WRC_TANGENTIAL_STRIP_FASTSIM},
                                  {"modified_fastsim", WRC_TANGENTIAL_MODIFIED_FASTSIM},
                                  {"fastrip", WRC_TANGENTIAL_FASTRIP},
                                  {"fastrip_modified", WRC_TANGENTIAL_FASTRIP_MODIFIED},
                                  {"fastrip_sdec", WRC_TANGENTIAL_FASTRIP_SDEC},
                                  {"coarse_halfspace", WRC_TANGENTIAL_COARSE_HALFSPACE},
                                  {"table", WRC_TANGENTIAL_TABLE}};

}  // namespace

int main() {
  std::setvbuf(stdout, nullptr, _IONBF, 0);  // no buffer from the heap at the first print
  int passed = 0, failed = 0;
  wrc_profile wheel = made<wrc_profile>(wrc_profile_init), rail = made<wrc_profile>(wrc_profile_init);
  wheel.kind = WRC_PROFILE_S1002;
  rail.kind = WRC_PROFILE_UIC60_BENCHMARK;
  for (const Choice& normal : normals) {
    for (const Choice& tangential : tangentials) {
      for (int32_t bound : {WRC_BOUND_PARABOLIC, WRC_BOUND_ELLIPTIC}) {
        // Every normal method with the default tangential one, and every tangential method after EKP.
        const bool usual = tangential.value == WRC_TANGENTIAL_FASTSIM_SDEC && bound == WRC_BOUND_PARABOLIC;
        if (!usual && normal.value != WRC_NORMAL_EKP) continue;
        wrc_config config = made<wrc_config>(wrc_config_init);
        config.warm_start = 1;
        config.normal_method = normal.value;
        config.tangential_method = tangential.value;
        config.traction_bound = bound;
        config.flexibility =
            bound == WRC_BOUND_PARABOLIC ? WRC_FLEXIBILITY_SEPARATE : WRC_FLEXIBILITY_BLENDED;
        config.force_table = WRC_FORCE_TABLE;
        config.strips = 32;
        config.cells = 32;
        config.gap_rows = 128;
        config.wheel = &wheel;
        config.rail = &rail;
        wrc_model* model = nullptr;
        wrc_contact* contact = nullptr;
        const long before_create = heap_calls;
        if (wrc_model_create(&config, nullptr, &model) < 0 ||
            wrc_contact_create(model, nullptr, &contact) < 0) {
          std::printf("cannot create\n");
          return 1;
        }
        const bool counts = heap_calls > before_create;  // the interposition itself works
        VariedRun run;
        run.fields = tangential.value != WRC_TANGENTIAL_TABLE;
        // A method that takes most of a millisecond gets a tenth of the steps.
        const bool slow = tangential.value == WRC_TANGENTIAL_COARSE_HALFSPACE;
        const int steps = slow ? steps_per_combination / 10 : steps_per_combination;
        const long before = heap_calls;
        for (int i = 0; i < steps; ++i) {
          run.vary(0.001 * i, i);
          if (i % 8 == 0) {
            run.stages(model, contact);
          } else {
            run.step(contact);
          }
        }
        const long during = heap_calls - before;
        const bool good = counts && during == 0 && run.failures == 0;
        ++(good ? passed : failed);
        std::printf("%-15s %-16s %-9s %d steps: %ld heap calls, %d failed calls%s\n", normal.name,
                    tangential.name, bound == WRC_BOUND_PARABOLIC ? "parabolic" : "elliptic", steps, during,
                    run.failures, counts ? "" : " (INTERPOSITION DOES NOT WORK)");
        wrc_contact_destroy(contact);
        wrc_model_destroy(model);
      }
    }
  }
  std::printf("%d passed, %d failed\n", passed, failed);
  return failed == 0 ? 0 : 1;
}
