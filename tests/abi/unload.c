/* Loads a library, uses it and unloads it, over and over: no memory may be left.
 *
 *   unload LIBRARY...     exit status 1 if the C library's heap grows from one time to the next
 */
#include <dlfcn.h>
#include <malloc.h>
#include <stdio.h>
#include <string.h>

#include "wrc/wrc_api.h"

/* Makes and destroys a model, where the library has the C interface; an FMU's has not. 0 if that fails. */
static int use(void* library) {
  const wrc_api* (*get)(uint32_t);
  void* found = dlsym(library, "wrc_get_api");
  if (!found) return dlsym(library, "fmi3GetVersion") != NULL;
  memcpy(&get, &found, sizeof get);
  const wrc_api* api = get(WRC_ABI_VERSION);
  if (!api) return 0;
  wrc_config config = {.struct_size = sizeof config};
  api->config_init(&config);
  config.wheel.kind = WRC_PROFILE_S1002;
  config.rail.kind = WRC_PROFILE_60E1;
  wrc_model* model = NULL;
  if (api->model_create(&config, NULL, &model, NULL, 0) < 0) return 0;
  api->model_destroy(model);
  return 1;
}

int main(int count, char** words) {
  int wrong = count < 2;
  for (int i = 1; i < count; ++i) {
    enum { times = 6 };
    size_t held[times];
    for (int n = 0; n < times; ++n) {
      void* library = dlopen(words[i], RTLD_NOW | RTLD_LOCAL);
      if (!library || !use(library) || dlclose(library) != 0) {
        fprintf(stderr, "%s cannot be loaded, used and unloaded\n", words[i]);
        return 2;
      }
      held[n] = mallinfo2().uordblks;
    }
    /* The first time the loader keeps something for itself. */
    const size_t lost = held[times - 1] - held[1];
    printf("%s: %zu bytes lost in %d times\n", words[i], lost, times - 2);
    wrong |= lost != 0;
  }
  return wrong;
}
