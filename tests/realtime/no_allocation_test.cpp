/// No heap allocation in any step or stage call of the shared library, for every method.
///
/// This program defines malloc and its family itself, so every call from libwrc arrives here and is counted.
/// The library carries its own copy of operator new (libstdc++ is linked into it), which ends in malloc too.
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>

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

template <typename Struct>
Struct made(int32_t (*init)(Struct*)) {
  Struct value{};
  value.struct_size = sizeof value;
  init(&value);
  return value;
}

/// Everything a step takes and gives, and the stages called alone, with inputs that vary from call to call.
struct Run {
  wrc_pose pose = made<wrc_pose>(wrc_pose_init);
  wrc_load load = made<wrc_load>(wrc_load_init);
  wrc_creepage creepage = made<wrc_creepage>(wrc_creepage_init);
  wrc_friction friction = made<wrc_friction>(wrc_friction_init);
  wrc_contact_point point = made<wrc_contact_point>(wrc_contact_point_init);
  wrc_patch patch = made<wrc_patch>(wrc_patch_init);
  wrc_forces forces = made<wrc_forces>(wrc_forces_init);
  wrc_damage damage = made<wrc_damage>(wrc_damage_init);
  wrc_sensitivity sensitivity = made<wrc_sensitivity>(wrc_sensitivity_init);
  wrc_step_sensitivity step_sensitivity = made<wrc_step_sensitivity>(wrc_step_sensitivity_init);
  int failures = 0;

  void vary(int i) {
    const double t = 0.001 * i;
    pose.lateral = 3e-3 * std::sin(7.0 * t);
    pose.yaw = 5e-3 * std::sin(3.0 * t);
    load.prescribed = i % 4 == 3 ? WRC_PRESCRIBE_APPROACH : WRC_PRESCRIBE_LOAD;
    load.normal_force = 80e3 + 40e3 * std::sin(11.0 * t);
    load.approach = 60e-6 + 61e-6 * std::sin(5.0 * t);  // now and then apart
    creepage.longitudinal = 2e-3 * std::sin(13.0 * t);
    creepage.lateral = 2e-3 * std::cos(17.0 * t);
    creepage.spin = 0.6 * std::sin(19.0 * t);
  }

  void step(wrc_contact* contact) {
    const wrc_input input = {sizeof input, 0, &pose, nullptr, &load, &creepage, &friction};
    wrc_output output = {sizeof output, 0, &point, &patch, &forces, &damage};
    failures += wrc_step(contact, &input, &output) < 0;
  }

  void stages(wrc_contact* contact) {
    wrc_view view = made<wrc_view>(wrc_view_init);
    failures += wrc_geometry(contact, &pose, &point) < 0;
    failures += wrc_normal(contact, nullptr, &load, &patch) < 0;
    failures += wrc_regularise(contact, nullptr, &patch) < 0;
    failures += wrc_tangential(contact, nullptr, &creepage, &friction, &forces) < 0;
    failures += wrc_damage_numbers(contact, &damage) < 0;
    failures += wrc_sensitivities(contact, &sensitivity) < 0;
    failures += wrc_step_sensitivities(contact, &step_sensitivity) < 0;
    if (forces.fn > 0.0) failures += wrc_field(contact, 0, WRC_FIELD_TRACTION_X, &view) < 0;
    wrc_creepage wrong = creepage;
    wrong.spin = NAN;  // an error is reported without allocating either
    char text[256];
    failures += wrc_tangential(contact, nullptr, &wrong, &friction, &forces) != WRC_ERROR_NOT_FINITE;
    failures += wrc_last_error(contact, text, sizeof text) < 0;
  }
};

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
                                  {"strip_fastsim", WRC_TANGENTIAL_STRIP_FASTSIM}};

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
        Run run;
        const long before = heap_calls;
        for (int i = 0; i < steps_per_combination; ++i) {
          run.vary(i);
          if (i % 8 == 0) {
            run.stages(contact);
          } else {
            run.step(contact);
          }
        }
        const long during = heap_calls - before;
        const bool good = counts && during == 0 && run.failures == 0;
        ++(good ? passed : failed);
        std::printf("%-15s %-13s %-9s %d steps: %ld heap calls, %d failed calls%s\n", normal.name,
                    tangential.name, bound == WRC_BOUND_PARABOLIC ? "parabolic" : "elliptic",
                    steps_per_combination, during, run.failures,
                    counts ? "" : " (INTERPOSITION DOES NOT WORK)");
        wrc_contact_destroy(contact);
        wrc_model_destroy(model);
      }
    }
  }
  std::printf("%d passed, %d failed\n", passed, failed);
  return failed == 0 ? 0 : 1;
}
