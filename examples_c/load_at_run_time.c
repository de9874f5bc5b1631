/* load_at_run_time.c - how a host that is not linked to wrc uses it: dlopen, one dlsym, then the function
 * table. On Windows LoadLibrary, one GetProcAddress, then the same table.
 *
 *   ./load_at_run_time path/to/libwrc.so.0.9
 *   load_at_run_time.exe path\to\wrc-0.9.dll
 *
 * It stands a wheelset on its rails, S1002 on 60E1, and rolls it with 1 mrad of yaw.
 */
#if defined(_WIN32)
#include <windows.h>
#else
#include <dlfcn.h>
#endif
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "wrc/wrc_api.h"

#if defined(_WIN32)
static const char* const usual_name = "wrc-0.9.dll";
static void* open_library(const char* path) {
  HMODULE library = LoadLibraryA(path);
  if (library == NULL) fprintf(stderr, "%s: Windows error %lu\n", path, GetLastError());
  return library;
}
static void* find(void* library, const char* name) {
  FARPROC function = GetProcAddress(library, name);
  void* symbol = NULL;
  memcpy(&symbol, &function, sizeof symbol);
  return symbol;
}
static void close_library(void* library) { FreeLibrary(library); }
#else
static const char* const usual_name = "libwrc.so.0.9";
static void* open_library(const char* path) {
  void* library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (library == NULL) fprintf(stderr, "%s\n", dlerror());
  return library;
}
static void* find(void* library, const char* name) { return dlsym(library, name); }
static void close_library(void* library) { dlclose(library); }
#endif

/* The table of the library, NULL where it does not serve this program. */
static const wrc_api* table_of(void* library, const char* path) {
  /* ISO C has no cast from an object pointer to a function pointer; POSIX says that copying it works. */
  const wrc_api* (*get_api)(uint32_t) = NULL;
  void* symbol = find(library, "wrc_get_api");
  if (symbol == NULL) {
    fprintf(stderr, "%s has no wrc_get_api: is it libwrc?\n", path);
    return NULL;
  }
  memcpy(&get_api, &symbol, sizeof get_api);
  const wrc_api* wrc = get_api(WRC_ABI_VERSION);
  /* A later version adds functions at the table's end: ask for those that this program calls. */
  if (wrc == NULL || !WRC_API_HAS(wrc, contact_wrench)) {
    fprintf(stderr, "%s does not serve interface %d; its wrc_version_text() says more\n", path,
            WRC_ABI_VERSION);
    return NULL;
  }
  return wrc;
}

/* Force on the wheelset; < 0 where a call failed, and `why` says so. */
static int32_t run(const wrc_api* wrc, wrc_contact* const contact[2], double force[3], char* why,
                   uint64_t size) {
  wrc_wheel_input input = {.struct_size = sizeof input};
  wrc_wrench wrench = {.struct_size = sizeof wrench};
  wrc->wheel_input_init(&input);

  /* The height at which it stands, at rest. */
  input.prescribed = WRC_PRESCRIBE_VERTICAL_LOAD;
  input.vertical_load = 80e3; /* N */
  int32_t status = wrc->contact_wrench(contact[WRC_SIDE_RIGHT], &input, &wrench);
  if (status < 0) wrc->contact_last_error(contact[WRC_SIDE_RIGHT], why, size);

  /* The forces as it rolls. */
  input.prescribed = WRC_PRESCRIBE_HEIGHT;
  input.vertical_load = 0.0;
  input.wheel.z = wrench.z;
  input.wheel.yaw = 1e-3;                /* rad */
  input.wheel.velocity[0] = 20.0;        /* m/s */
  input.wheel.pitch_rate = -20.0 / 0.46; /* rad/s */
  for (int side = 0; side < 2 && status >= 0; ++side) {
    status = wrc->contact_wrench(contact[side], &input, &wrench);
    for (int i = 0; i < 3; ++i) force[i] += wrench.force[i];
    if (status < 0) wrc->contact_last_error(contact[side], why, size);
  }
  return status;
}

int main(int argc, char** argv) {
  const char* path = argc > 1 ? argv[1] : usual_name;
  void* library = open_library(path);
  const wrc_api* wrc = library == NULL ? NULL : table_of(library, path);
  if (wrc == NULL) return EXIT_FAILURE;

  /* Defaults come by the table: wrc_config_default() of the header needs the library at link time. */
  wrc_config config = {.struct_size = sizeof config};
  wrc->config_init(&config);
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_60E1;
  config.track.rail_inclination = 1.0 / 40.0;

  char why[300] = "";
  wrc_model* model = NULL;
  wrc_contact* contact[2] = {NULL, NULL};
  int32_t status = wrc->model_create(&config, NULL, &model, why, sizeof why);
  for (int side = 0; side < 2 && status >= 0; ++side)
    status = wrc->contact_create(model, side, NULL, &contact[side], why, sizeof why);
  double force[3] = {0.0, 0.0, 0.0};
  if (status >= 0) status = run(wrc, contact, force, why, sizeof why);
  printf("wrc %u.%u through %s: %s%s, force on the wheelset %.0f, %.0f, %.0f N\n", wrc->version() >> 16,
         wrc->version() >> 8 & 255U, path, wrc->status_name(status), why, force[0], force[1], force[2]);

  for (int side = 0; side < 2; ++side) wrc->contact_destroy(contact[side]);
  wrc->model_destroy(model);
  close_library(library);
  return status < 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}
