/* load_at_run_time.c - how a host that is not linked to wrc uses it: dlopen, one dlsym, then the function
 * table. On Windows LoadLibrary, one GetProcAddress, then the same table.
 *
 *   ./load_at_run_time path/to/libwrc.so.0.2
 *   load_at_run_time.exe path\to\wrc.dll
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
static const char* const usual_name = "wrc.dll";
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
static const char* const usual_name = "libwrc.so.0.2";
static void* open_library(const char* path) {
  void* library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (library == NULL) fprintf(stderr, "%s\n", dlerror());
  return library;
}
static void* find(void* library, const char* name) { return dlsym(library, name); }
static void close_library(void* library) { dlclose(library); }
#endif

int main(int argc, char** argv) {
  const char* path = argc > 1 ? argv[1] : usual_name;
  void* library = open_library(path);
  if (library == NULL) return EXIT_FAILURE;

  /* ISO C has no cast from an object pointer to a function pointer; POSIX says that copying it works. */
  const wrc_api* (*get_api)(uint32_t) = NULL;
  void* symbol = find(library, "wrc_get_api");
  if (symbol == NULL) {
    fprintf(stderr, "%s has no wrc_get_api: is it libwrc?\n", path);
    return EXIT_FAILURE;
  }
  memcpy(&get_api, &symbol, sizeof get_api);
  const wrc_api* wrc = get_api(WRC_ABI_VERSION);
  if (wrc == NULL || wrc->struct_size < sizeof(wrc_api)) {
    fprintf(stderr, "%s does not serve interface %d; its wrc_version_text() says more\n", path,
            WRC_ABI_VERSION);
    return EXIT_FAILURE;
  }

  /* A contact whose normal problem the host solves itself: 100 kN on a 12 x 8 mm ellipse. */
  wrc_config config;
  config.struct_size = sizeof config;
  wrc->config_init(&config);
  wrc_model* model = NULL;
  wrc_contact* contact = NULL;
  if (wrc->model_create(&config, NULL, &model, NULL, 0) < 0 ||
      wrc->contact_create(model, WRC_SIDE_RIGHT, NULL, &contact, NULL, 0) < 0) {
    fprintf(stderr, "out of memory\n");
    return EXIT_FAILURE;
  }
  wrc_ellipse ellipse;
  wrc_creepage creepage;
  wrc_friction friction;
  wrc_planar_forces forces;
  wrc->ellipse_init(&ellipse);
  wrc->creepage_init(&creepage);
  wrc->friction_init(&friction);
  ellipse.a = 6e-3;
  ellipse.b = 4e-3;
  ellipse.normal_force = 100e3;
  creepage.longitudinal = 1e-3;

  const int32_t status = wrc->contact_tangential(contact, &ellipse, &creepage, &friction, &forces);
  char text[256] = "";
  wrc->contact_last_error(contact, text, sizeof text);
  printf("wrc %u.%u through %s: %s%s, Fx = %.0f N of at most %.0f N\n", wrc->version() >> 16,
         wrc->version() >> 8 & 255U, path, wrc->status_name(status), text, forces.fx,
         friction.coefficient * ellipse.normal_force);

  wrc->contact_destroy(contact);
  wrc->model_destroy(model);
  close_library(library);
  return status < 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}
