/// The function table for hosts that load the library with dlopen.
#include "wrc/wrc_api.h"

extern "C" const wrc_api* wrc_get_api(uint32_t abi_version) {
  // Constant-initialised: no constructor runs when the library is loaded.
  static constexpr wrc_api table = {
      sizeof(wrc_api),
      WRC_ABI_VERSION,
#include "abi/generated/api_functions.inc"
  };
  return abi_version == WRC_ABI_VERSION ? &table : nullptr;
}
